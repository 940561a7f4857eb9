// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "impact/conditions/acting_load.hpp"

namespace nugget::impact {

template <>
class ActingLoad<model::BodyLoad> {
 public:
  ActingLoad(const model::BodyLoad& load, const system::System& system);
  void apply(system::State& state, double dt, double& work);
  /// Takes the masses that it acts on from the system, of what mass scaling added the share EMSCL.
  void update_masses();
  void archive(Archive& a);

 private:
  double motion(const system::State& state) const;
  void apply_centrifugal(system::State& state, double dt, double omega, double& work);
  std::vector<double> nodes_without_weight() const;
  void load_nodes();
  void load_everything();
  void load_parts();

  const model::BodyLoad& load_;
  const system::System& system_;
  std::vector<int> nodes_;
  std::vector<double> mass_;       ///< of `nodes_` [mass]
  double last_ = 0.0;              ///< acceleration of the last cycle [length/time^2]
  std::vector<Vec3d> last_force_;  ///< by node of the system, of a centrifugal load [force]
};

}  // namespace nugget::impact
