// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "contact/surface_contact.hpp"

namespace nugget::contact {

/// All nodes of segments and all tracked nodes, ascending, each once.
std::vector<int> surface_nodes(const SurfaceContactSetup& setup);

}  // namespace nugget::contact
