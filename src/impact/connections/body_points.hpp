// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "system/mobility.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Inverse mass of a point of a body with the lever `arm`: 1/m - r^ I^-1 r^. `inverse` is the body's inverse inertia.
inline system::Mobility::Matrix inverse_mass_at(const system::RigidBody& body, const system::Mobility::Matrix& inverse,
                                                const Vec3d& arm) {
  system::Mobility::Matrix g{};
  system::ConstraintMap::Block block{body.node, {}};
  for (std::size_t i = 0; i < 3; ++i) block.of[i][i] = 1.0;
  // omega x r as a matrix on omega.
  block.of[0][4] = arm.z, block.of[0][5] = -arm.y;
  block.of[1][3] = -arm.z, block.of[1][5] = arm.x;
  block.of[2][3] = arm.y, block.of[2][4] = -arm.x;
  system::add_inverse_mass(g, block, 0, body.mass > 0.0 ? 1.0 / body.mass : 0.0, inverse);
  return g;
}

inline double trace(const system::Mobility::Matrix& m) {
  return m[0][0] + m[1][1] + m[2][2];
}

}  // namespace nugget::impact
