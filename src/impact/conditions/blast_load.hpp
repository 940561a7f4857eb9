// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "impact/conditions/pressure_load.hpp"

namespace nugget::impact {

/// The wave of each segment is that at its middle at the start; the angle is that of the segment as it stands.
template <>
class ActingLoad<model::BlastLoad> {
 public:
  ActingLoad(const model::BlastLoad& load, const system::System& system);
  void apply(system::State& state, double dt, double& work);
  void archive(Archive& a);

 private:
  const model::BlastLoad& load_;
  const system::System& system_;
  PressedFaces faces_;
  std::vector<kernel::BlastWave> waves_;  ///< by segment
};

}  // namespace nugget::impact
