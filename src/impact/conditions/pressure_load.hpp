// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "impact/conditions/acting_load.hpp"

namespace nugget::impact {

/// Pressure on faces, which follows them.
class PressedFaces {
 public:
  PressedFaces(const std::vector<model::Segment>& segments, const std::vector<model::CornerShares>& shares,
               const system::System& system)
      : segments_(segments), shares_(shares), system_(system), last_(4 * segments.size()) {}
  /// Adds `pressure` [stress], positive against the faces' normals, to state.f, and its work to `work`.
  void press(double pressure, system::State& state, double dt, double& work);
  /// The same on the s-th face alone.
  void press(std::size_t s, double pressure, system::State& state, double dt, double& work);
  std::pair<Vec3d, Vec3d> middle_and_area(std::size_t s, const system::State& state) const;  ///< along the normal
  void archive(Archive& a);

 private:
  const std::vector<model::Segment>& segments_;
  const std::vector<model::CornerShares>& shares_;
  const system::System& system_;
  std::vector<Vec3d> last_;  ///< forces of the last cycle, corner by corner [force]
};

template <>
class ActingLoad<model::PressureLoad> {
 public:
  ActingLoad(const model::PressureLoad& load, const system::System& system)
      : load_(load), system_(system), faces_(load.segments, load.share, system) {}
  void apply(system::State& state, double dt, double& work);
  void archive(Archive& a);

 private:
  const model::PressureLoad& load_;
  const system::System& system_;
  PressedFaces faces_;
};

}  // namespace nugget::impact
