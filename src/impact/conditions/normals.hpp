// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "base/vec3.hpp"

namespace nugget::impact {

/// Two unit vectors a and b that complete the unit vector `d` to a right-handed triad d, a, b.
inline std::array<Vec3d, 2> normals(const Vec3d& d) {
  const Vec3d least = std::abs(d.x) <= std::abs(d.y) && std::abs(d.x) <= std::abs(d.z) ? Vec3d{1, 0, 0}
                      : std::abs(d.y) <= std::abs(d.z)                                 ? Vec3d{0, 1, 0}
                                                                                       : Vec3d{0, 0, 1};
  const Vec3d a = unit(cross(d, least));
  return {a, cross(d, a)};
}

}  // namespace nugget::impact
