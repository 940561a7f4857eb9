// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/archive.hpp"
#include "impact/conditions/supports.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// *CONSTRAINED_RIGID_BODY_STOPPERS: a body whose centre would pass a bound at the end of the step ends on it, without
/// rebound; one that would be too fast is held to the speed allowed; one that is beyond a bound already goes no
/// farther. Likewise its angle about an axis that stays, which is the sum of its turns about it; the stop is a torque
/// about that axis. All stops of a body are met at one time, beside its own constraints and, where they ask for other
/// directions, its prescribed motions (docs/decisions/0144). The work is booked as that of supports.
class Stoppers {
 public:
  /// Warns of bodies that start beyond a bound.
  Stoppers(const system::System& system, Findings& findings);

  /// With the velocities that the run begins with, before anything changes them.
  void start(const system::State& state);
  /// Behind all else that changes velocities. `velocity_interval`: the time by which these were advanced. `supports`:
  /// take what the body's motions do against the stops.
  void apply(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies, Supports& supports);
  /// Books the opening half, with the velocities that `apply` left.
  void book_opening_work(double dt);
  /// Sum of the other forces times what the last `apply` changed in the velocities [power].
  double power_on_change() const { return power_on_change_; }
  void reset_work() { work_ = 0.0; }
  void add_energy(Energy& energy) const { energy.external += work_; }

  void archive(Archive& a);

 private:
  struct Stop {
    const model::BodyStopper* card = nullptr;
    int body = 0;
    double force = 0.0, before = 0.0, velocity = 0.0;  ///< of the last `apply`; torque and spins of a rotation
    double angle = 0.0;                                ///< of a rotation [rad]
    void archive(Archive& a);
  };
  /// The stops of a body's centre, or those of its turning.
  struct Group {
    int body = 0;
    bool rotation = false;
    std::vector<std::size_t> stops;
    std::vector<std::size_t> driven;  ///< the body's motions, for Supports::axis_of; found by the first `apply`
  };
  /// Velocities along the direction of a stop that it allows in the coming step.
  struct Limits {
    double low, high;
  };
  /// Place of the centre along the stop's direction, or angle about it.
  double place(const Stop& stop, const Vec3d& center) const;
  /// Velocity of the centre along the stop's direction, or spin about it.
  double velocity(const Stop& stop, const system::State& state) const;
  /// What a bound's curve counts from.
  double origin(const Stop& stop, const model::BodyStopper::Bound& bound) const;
  Limits limits(const Stop& stop, const system::State& state) const;
  void meet(const Group& group, system::State& state, double velocity_interval, system::RigidBody& body,
            Supports& supports);

  const system::System& system_;
  std::vector<Stop> stops_;
  std::vector<Group> groups_;
  bool motions_known_ = false;
  double work_ = 0.0, power_on_change_ = 0.0, dt_previous_ = 0.0;
};

}  // namespace nugget::impact
