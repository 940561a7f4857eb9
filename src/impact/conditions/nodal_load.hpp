// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "impact/conditions/acting_load.hpp"

namespace nugget::impact {

template <>
class ActingLoad<model::NodalLoad> {
 public:
  ActingLoad(const model::NodalLoad& load, const system::System& system);
  void apply(system::State& state, double dt, double& work);
  void archive(Archive& a);

 private:
  const model::NodalLoad& load_;
  const system::System& system_;
  std::vector<int> nodes_;
  Vec3d last_;  ///< force or moment of the last cycle
};

}  // namespace nugget::impact
