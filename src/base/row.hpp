// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/vec3.hpp"

namespace nugget {

/// A nodal vector as it stands in the big arrays: padded, so that a row fills one vector register and never straddles cache lines.
struct alignas(32) Row {
  double x = 0.0, y = 0.0, z = 0.0, pad = 0.0;
};

inline Vec3d vec(const Row& r) { return {r.x, r.y, r.z}; }
inline void set(Row& r, const Vec3d& a) { r = {a.x, a.y, a.z, 0.0}; }
inline void add(Row& r, const Vec3d& a) { r = {r.x + a.x, r.y + a.y, r.z + a.z, 0.0}; }

}  // namespace nugget
