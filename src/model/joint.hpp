// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_JOINT_..., _COOR_...: which relative motion two rigid bodies have. Its nodes, or points, come in pairs,
/// the first of each on body A, the second on body B, both at one place at time 0.
struct Joint {
  enum class Kind {
    spherical,
    revolute,
    cylindrical,
    planar,
    universal,
    translational,
    locking,
    // A ratio of two motions, and nothing else:
    gears,
    pulley,
    rack_and_pinion,
    screw
  };
  bool transmits() const { return kind >= Kind::gears; }
  int id = 0;
  std::string title;
  Kind kind = Kind::spherical;
  std::array<Index, 6> node{none, none, none, none, none, none};  ///< none of a _COOR joint
  std::array<Vec3d, 6> point;                                     ///< where they are at time 0
  std::array<Index, 2> body{none, none};                          ///< A and B, in Model::rigid_bodies
  double stiffness_scale = 1.0;                                   ///< RPS
  double damping = 1.0;  ///< DAMP: factor on the damping that belongs to the stiffness
  double ratio = 0.0;    ///< PARM: R2/R1 of gears and pulleys [1]; way over angle of rack and pinion, screw [length]
  double radius = 0.0;   ///< R1 of gears and pulleys, for the force that is reported [length]
  /// _FAILURE: the joint is released from `time` on, or from when its loads in the axes of `system` reach the limits.
  struct Failure {
    double time = 0.0;                        ///< TFAIL; 0: no such time
    Index system = none;                      ///< CID; none: global axes
    bool together = true;                     ///< COUPL up to 0: forces and moments in one criterion
    std::array<double, 3> force{}, moment{};  ///< at failure [force, moment]; 0: not considered
  };
  std::optional<Failure> failure;
  Index control = none;  ///< *SENSOR_CONTROL: the joint is released for good when that is off
  /// _LOCAL: results are in axes that turn with this body and are these at time 0.
  struct Output {
    Index body = none;
    Frame3d axes;
  };
  std::optional<Output> output;
  Place place;
};

/// *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED, _TRANSLATIONAL: what resists the relative rotations, or displacements, of
/// two rigid bodies about the axes of a coordinate system that goes with each of them.
struct JointStiffness {
  struct Freedom {
    Index load = none, damper = none;  ///< curves: moment (force) over rotation (displacement), over its rate
    double stiffness = 0.0;            ///< of friction and stops [moment, or force/length]
    double friction = 0.0;             ///< greatest moment (force) of friction; 0: none
    double low_stop = 0.0,
           high_stop = 0.0;  ///< sizes of rotation [rad] or displacement at which a stop begins; 0: none
  };
  int id = 0;
  bool rotational = false;
  std::array<Index, 2> body{none, none};  ///< A and B, in Model::rigid_bodies
  std::array<Vec3d, 2> origin;            ///< of their systems, at time 0
  std::array<Frame3d, 2> axes;
  std::array<Freedom, 3> freedom;
  Place place;
};

/// IGRAV as bits of x, y, z: 1 all, -1 x, -2 y, -3 z, -4 xy, -5 yz, -6 zx; 0 and others: none.
inline unsigned gravity_left_out(int flag) {
  constexpr unsigned bits[] = {0, 1, 2, 4, 3, 6, 5};
  return flag == 1 ? 7u : flag < 0 && flag >= -6 ? bits[-flag] : 0u;
}

/// *ELEMENT_SEATBELT_ACCELEROMETER: a node of a rigid body whose motion nodout gives in axes that turn with the body:
/// x from node 1 to node 2, z normal to x and to node 3, y = z x x.
struct Accelerometer {
  int id = 0;
  std::array<Index, 3> node{none, none, none};
  unsigned without_gravity = 0;  ///< IGRAV: bits of the global x, y, z acceleration of body loads that is taken out
  Index gravity_curve = none;    ///< IGRAV above 1: its values -6 to 1 over time, in place of `without_gravity`
  bool sums_local = false;       ///< INTOPT 1: velocities are sums of the accelerations in the turning axes
};

}  // namespace nugget::model
