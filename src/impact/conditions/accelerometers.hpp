// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Axes of an *ELEMENT_SEATBELT_ACCELEROMETER at the positions of `state`; where its nodes have come to lie on a line,
/// the global ones.
Frame3d accelerometer_axes(const system::System& system, const system::State& state, const model::Accelerometer& a);

/// Velocities of accelerometers with INTOPT 1: the sums of their accelerations, each taken in the axes of its moment.
class Accelerometers {
 public:
  explicit Accelerometers(const system::System& system) : system_(system) {}

  /// The run begins with the velocities of `state`.
  void start(const system::State& state);
  /// The velocities of `state` stand at t(n+1/2), its positions at t(n).
  void add_step(const system::State& state);
  /// Velocity in its own axes at t(n-1/2), of one of Model::accelerometers.
  const Vec3d& velocity(std::size_t accelerometer) const { return sums_[accelerometer].velocity; }

  void archive(Archive& a);

 private:
  struct Sum {
    Vec3d velocity, last;  ///< in its own axes; in global ones
  };
  const system::System& system_;
  std::vector<Sum> sums_;  ///< by accelerometer
};

}  // namespace nugget::impact
