// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "system/state.hpp"

namespace nugget::kernel {
struct WeldTrial;
}

namespace nugget::system {

/// Weld beams with joints that flow by what other welds do as well (kernel::StackJoint).
class JoinedBeams {
 public:
  /// What the joint of beam e will meet in the step that `now`, its velocities and its places before it, begins.
  virtual void joint_trial(std::size_t e, const State& now, kernel::WeldTrial& trial) const = 0;
  /// Plastic motion of its joint in that step, by its freedoms.
  virtual void set_joint_flow(std::size_t e, std::span<const double> flow) = 0;

 protected:
  ~JoinedBeams() = default;
};

}  // namespace nugget::system
