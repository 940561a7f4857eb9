// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "impact/conditions/bag.hpp"
#include "impact/conditions/pressure_load.hpp"

namespace nugget::impact {

/// The gas in a control volume, which presses its faces outwards, along their normals.
template <>
class ActingLoad<model::ControlVolume> {
 public:
  ActingLoad(const model::ControlVolume& source, const system::System& system);
  void apply(system::State& state, double dt, double& work);
  void archive(Archive& a);

  /// Asks of each node of fabric that contact covers whether one presses it: `presses` by position of the node.
  void find_covered(const std::function<bool(int)>& presses);

  /// The gas at the moment of the last `apply`.
  struct Gas {
    double at_start = 0.0, volume = 0.0;  ///< times VSCA [length^3]
    double pressure = 0.0;                ///< on the faces [stress]
    double relative_pressure = 1.0;       ///< of an adiabatic gas: absolute pressure over that at the start [1]
    double work = 0.0;                    ///< done on the faces so far [energy]
    bool preload_over = false;
    Bag bag;  ///< of a gas that flows
    void archive(Archive& a) { a(at_start, volume, pressure, relative_pressure, work, preload_over, bag); }
  };
  const Gas& gas() const { return gas_; }
  const model::ControlVolume& source() const { return source_; }

 private:
  /// Of the model's nodes.
  auto places(const system::State& state) const {
    return [this, &state](model::Index n) { return vec(state.x[system_.node_of[n]]); };
  }
  double volume(const system::State& state) const;
  void find_openings(const system::State& state);
  double pressure(const system::State& state, double dt);

  const model::ControlVolume& source_;
  const system::System& system_;
  PressedFaces faces_;
  Gas gas_;
  /// Faces of a PorousFabric: their areas at the start, and the share of each that is covered, which is empty where
  /// contact does not count.
  struct Porous {
    std::vector<double> at_start, covered;
  };
  std::vector<Porous> porous_;
  Openings openings_;
};

/// What left each gas through fabric, a line each.
std::vector<std::string> leakage_summary(const std::vector<ActingLoad<model::ControlVolume>>& gases);

}  // namespace nugget::impact
