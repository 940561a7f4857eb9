// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "base/archive.hpp"
#include "kernel/law/discrete_spring.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// *CONSTRAINED_JOINT_STIFFNESS_...: springs, dampers, friction and stops between two rigid bodies, in each of the
/// three axes e_i of body B's coordinate system. With d_i the relative rotation (its rate is e_i . (spin B - spin A))
/// or the displacement e_i . (origin of B - origin of A), the moment or force on B is -F_i e_i,
///     F = load(d) + damper(d') + friction + stop
///     friction   a spring ES and a slider, at most FM in size
///     stop       ES (d - PSA) beyond PSA, ES (d + NSA) below -NSA
/// Both bodies take it at the origin of A's system, so that no momentum is made and the work is that of d.
/// Rotations at time 0 are the rotation vector from A's axes to B's; what is already turned or apart, is loaded at
/// once.
class JointSprings {
 public:
  explicit JointSprings(const system::System& system);

  bool empty() const { return springs_.empty(); }
  /// Adds the forces at state.time to the bodies, and books their work over the step that ends there.
  void apply(system::State& state);
  /// Stored in springs and lost in dampers and friction [energy].
  double energy() const;
  /// The longest step at which all of them are stable; infinite where there are none [time].
  double stable_step() const { return stable_step_; }

  /// One axis of a joint stiffness: d [rad or length], d', and of F the part of the damper and the rest.
  struct Reading {
    double place = 0.0, rate = 0.0, stiffness = 0.0, damping = 0.0;
  };
  std::size_t size() const { return springs_.size(); }  ///< in the order of Model::joint_stiffnesses
  const Reading& reading(std::size_t spring, std::size_t axis) const { return springs_[spring].freedom[axis].now; }
  double energy(std::size_t spring) const { return springs_[spring].energy; }

  void archive(Archive& a);

 private:
  struct Freedom {
    kernel::ForceCurve load, damper;
    double stiffness = 0.0, friction_limit = 0.0;
    double low = 0.0, high = 0.0;  ///< infinite where there is no stop
    double friction = 0.0;
    Reading now;
    double advance(double increment, double rate);
    void archive(Archive& a);
  };
  struct Spring {
    bool rotational = false;
    std::array<const system::RigidBody*, 2> body{};
    std::array<Vec3d, 2> arm;  ///< of the origins, in body axes
    Frame3d axes;              ///< e_i, in B's axes
    std::array<Freedom, 3> freedom;
    std::array<Vec3d, 2> force, moment;  ///< on the bodies' centres
    double energy = 0.0;
    void archive(Archive& a);
  };
  void find_stable_step();
  static void apply(Spring& spring, system::State& state);

  std::vector<Spring> springs_;
  double stable_step_ = 0.0;
};

}  // namespace nugget::impact
