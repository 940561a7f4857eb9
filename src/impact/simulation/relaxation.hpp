// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// *CONTROL_DYNAMIC_RELAXATION: the damping of the relaxation, and the check whether the model is at rest. A
/// factor DRFCTR on all velocities before each update of the velocities; at rest when the kinetic energy has fallen to
/// DRTOL of its largest value, looked at every NRCYCK cycles. Compared is the largest value since the last look, not
/// the one of that moment: a vibration that turns around just then is not at rest.
class Relaxation {
 public:
  Relaxation() = default;
  explicit Relaxation(const model::Relaxation& control) : control_(control) {}

  void damp(system::System& system, system::State& state) const;
  void watch(const system::System& system, const system::State& state);

  bool at_rest() const { return at_rest_; }
  /// Kinetic energy over the largest so far, at the last look.
  double kinetic_energy_ratio() const { return kinetic_energy_ratio_; }
  long cycles() const { return cycles_; }
  double time() const { return time_; }

  void archive(Archive& a);

 private:
  model::Relaxation control_;
  double recent_ = 0.0, largest_ = 0.0;  ///< kinetic energies
  double kinetic_energy_ratio_ = 1.0, time_ = 0.0;
  long cycles_ = 0;
  bool at_rest_ = false;
};

}  // namespace nugget::impact
