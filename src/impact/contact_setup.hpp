// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/single_surface.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// The surface and the laws of a single-surface contact, from its card and the parts that it names. Shells contribute
/// themselves, bricks their exterior faces; weld elements never contact. Node numbers are the system's.
contact::SingleSurfaceSetup contact_setup(const system::System& system, const model::Contact& contact);

}  // namespace nugget::impact
