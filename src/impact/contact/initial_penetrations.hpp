// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "contact/surface_contact.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Looks for nodes that stand in the thickness of a sheet of the contact, or inside a brick, at the start. With
/// IGNORE = 0 they are moved out (`x` changes); with 1 and 2 the contact keeps the overlap. Either way a finding says
/// how many, and of the deepest which node stands how deep in which element; 2 proposes coordinates as well.
void treat_initial_penetrations(const system::System& system, const model::Contact& card,
                                const contact::SurfaceContactSetup& setup, std::span<Row> x, Findings& findings);

}  // namespace nugget::impact
