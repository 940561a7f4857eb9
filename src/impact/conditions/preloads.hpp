// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "base/archive.hpp"
#include "system/imposed_stress.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Places of the layers of a group's shells through their thickness, -1 .. 1, from the bottom.
std::vector<double> layer_places(const model::Model& model, const system::ElementGroup& group);

/// Area of a beam's section; of a discrete beam its volume over its length.
double beam_area(const model::Model& model, model::Index beam);

/// *INITIAL_STRESS_..., *INITIAL_AXIAL_FORCE_BEAM, *INITIAL_STRESS_SECTION: stresses that the elements do not get from
/// their own deformation.
class Preloads {
 public:
  /// Elements that cannot take a stress become findings.
  Preloads(system::System& system, Findings& findings);

  /// No stresses are given.
  bool empty() const;

  /// Stresses of time 0, before the first internal forces.
  void start(const system::State& state);
  /// Before the internal forces at state.time: imposes stresses that follow a curve, as long as it lasts. It lasts to
  /// its end, or until its size falls for the first time (manual vol. I, *INITIAL_AXIAL_FORCE_BEAM, remark 2).
  void apply(const system::State& state);

  void archive(Archive& a);

 private:
  /// What one card imposes; `stress` is a share of the curve's value.
  struct Prescribed {
    std::vector<std::pair<int, system::ImposedStress>> elements;  ///< with their groups
    const Curve* curve = nullptr;
    double begin = 0.0, end = 0.0;
  };
  void start(const model::InitialStress& stress, const system::System::ElementLocation& location, bool shell,
             const system::State& state);
  /// False for elements that cannot take a stress.
  bool prescribe(Prescribed& p, const system::System::ElementLocation& location, system::ImposedStress stress) const;

  system::System& system_;
  std::vector<Prescribed> prescribed_;
  std::vector<int> groups_;  ///< of all of these elements
};

}  // namespace nugget::impact
