// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "base/vec3.hpp"

namespace nugget {

/// Axis times angle [rad] of the rotation that brings the axes a to b.
inline Vec3d rotation_between(const Frame3d& a, const Frame3d& b) {
  const Vec3d sine = 0.5 * (cross(a.e1, b.e1) + cross(a.e2, b.e2) + cross(a.e3, b.e3));
  const double cosine = 0.5 * (dot(a.e1, b.e1) + dot(a.e2, b.e2) + dot(a.e3, b.e3) - 1.0), size = norm(sine);
  return size > 0.0 ? (std::atan2(size, cosine) / size) * sine : Vec3d{};
}

}  // namespace nugget
