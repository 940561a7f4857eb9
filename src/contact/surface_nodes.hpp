// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "contact/surface_contact.hpp"

namespace nugget::contact {

/// All nodes of segments and all tracked nodes, ascending, each once.
std::vector<int> surface_nodes(const SurfaceContactSetup& setup);

/// Books the work on nodes that belong to the reference side alone there; `around`: of the segments.
void assign_sides(NodalForces& forces, const NodeSegments& around, const SurfaceContactSetup& setup);

}  // namespace nugget::contact
