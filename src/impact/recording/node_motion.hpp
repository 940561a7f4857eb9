// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "impact/simulation/snapshot.hpp"

namespace nugget::impact {

/// How a node moves at t(n).
struct NodeMotion {
  Vec3d velocity, acceleration;                        ///< [length/time], [length/time^2]
  Vec3d rotational_velocity, rotational_acceleration;  ///< [1/time], [1/time^2]
};

/// The motion of a node of the system. That of a rigid body's node is the body's: v = v_c + w x r,
/// a = a_c + alpha x r + w x (w x r).
NodeMotion node_motion(const Snapshot& now, std::size_t node);

}  // namespace nugget::impact
