// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "impact/conditions/acting_load.hpp"

namespace nugget::impact {

/// What each corner of a face takes of a traction of 1 that is `factor` at the corners and goes linearly between them:
/// integrals of the bilinear shape functions times it over the face [area]. A triangle repeats its third corner.
std::array<double, 4> loaded_areas(const std::array<Vec3d, 4>& x, const std::array<double, 4>& factor, bool triangle);

template <>
class ActingLoad<model::TractionLoad> {
 public:
  ActingLoad(const model::TractionLoad& load, const system::System& system)
      : load_(load), system_(system), last_(4 * load.segments.size()) {}
  void apply(system::State& state, double dt, double& work);
  void archive(Archive& a);

 private:
  const model::TractionLoad& load_;
  const system::System& system_;
  std::vector<Vec3d> last_;  ///< forces of the last cycle, corner by corner [force]
};

}  // namespace nugget::impact
