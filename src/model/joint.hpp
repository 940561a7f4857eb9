// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_JOINT_...: which relative motion two rigid bodies have. Its nodes come in pairs, the first of each on
/// body A, the second on body B, both at one place at time 0.
struct Joint {
  enum class Kind { spherical, revolute, cylindrical, planar, universal, translational, locking };
  int id = 0;
  std::string title;
  Kind kind = Kind::spherical;
  std::array<Index, 6> node{none, none, none, none, none, none};
  std::array<Index, 2> body{none, none};  ///< A and B, in Model::rigid_bodies
  double stiffness_scale = 1.0;           ///< RPS
  double damping = 1.0;                   ///< DAMP: factor on the damping that belongs to the stiffness
  Place place;
};

/// *ELEMENT_SEATBELT_ACCELEROMETER: a node of a rigid body whose motion nodout gives in axes that turn with the body:
/// x from node 1 to node 2, z normal to x and to node 3, y = z x x.
struct Accelerometer {
  int id = 0;
  std::array<Index, 3> node{none, none, none};
  unsigned without_gravity = 0;  ///< IGRAV: bits of the global x, y, z acceleration of body loads that is taken out
};

}  // namespace nugget::model
