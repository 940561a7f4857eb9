// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "impact/energy/energy.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// *CONSTRAINED_RIGID_BODY_STOPPERS: a body whose centre would pass a bound at the end of the step ends on it, without
/// rebound; one that would be too fast is held to the speed allowed. Likewise its angle about an axis that stays, which
/// is the sum of its turns about it; the stop is a torque about that axis. The work is booked as that of supports.
class Stoppers {
 public:
  explicit Stoppers(const system::System& system);

  /// Behind all else that changes velocities. `velocity_interval`: the time by which these were advanced.
  void apply(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies);
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
  /// The velocity along its direction that a stop allows, of `free`.
  double allowed(const Stop& stop, const system::State& state, double free) const;
  void stop_centre(Stop& stop, const system::RigidBody& body, system::State& state, double velocity_interval);
  void stop_turning(Stop& stop, system::RigidBody& body, system::State& state, double velocity_interval);

  const system::System& system_;
  std::vector<Stop> stops_;
  double work_ = 0.0, power_on_change_ = 0.0, dt_previous_ = 0.0;
};

}  // namespace nugget::impact
