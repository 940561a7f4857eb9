// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Watches *TERMINATION_NODE, _BODY and _SENSOR, with the sensors and switches that these name.
class Ends {
 public:
  explicit Ends(const system::System& system) : system_(system), since_(system.model.run_ends.switches.size(), -1.0) {}

  /// Why the run ends at the time of `state`, whose velocities are half a step older than its places; empty: it does
  /// not. To be asked once a cycle.
  std::string update(const system::State& state);

  void archive(Archive& a);

 private:
  double value(std::size_t sensor, const system::State& state) const;
  bool on(std::size_t number, const system::State& state) const;
  bool holds(const model::SensorSwitch& one, const system::State& state) const;

  const system::System& system_;
  std::vector<double> since_;  ///< by switch: from when its condition has held without a break; below 0: it does not
};

}  // namespace nugget::impact
