// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  double pressure(const system::State& state, double dt);

  const model::ControlVolume& source_;
  const system::System& system_;
  PressedFaces faces_;
  Gas gas_;
};

}  // namespace nugget::impact
