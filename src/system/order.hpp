// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"

namespace nugget::system {

/// Positions 0..n-1 of points along a Morton curve through their bounding box: neighbours in space come close in the
/// list. Equal codes keep their order, so the result depends on the points only.
std::vector<int> morton_order(const std::vector<Vec3d>& points);

}  // namespace nugget::system
