// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include "base/row.hpp"

namespace nugget::contact {

/// Forces at `nodes` (three or four corners of a segment, the two ends of a bar) that have no resultant and the
/// moment `moment` [force length]. Of all such forces the least: f_i = theta x r_i, r_i from the middle of the nodes,
/// as rivets share out a moment. A bar takes no moment about its axis; nodes that lie in one point take none. `x`:
/// coordinates, by node. The fourth of three nodes, and so on, are 0.
std::array<Vec3d, 4> couple(std::span<const int> nodes, const Vec3d& moment, std::span<const Row> x);

}  // namespace nugget::contact
