// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/archive.hpp"
#include "base/curve.hpp"
#include "model/control_volume.hpp"

namespace nugget::impact {

/// The gas of *AIRBAG_SIMPLE_AIRBAG_MODEL and _WANG_NEFSKE: one ideal gas of uniform pressure and temperature, in walls
/// that take no heat (docs/theory/gas.md#gas-that-flows).
struct Bag {
  double volume = 0.0;  ///< [length^3]
  double mass = 0.0;
  double energy = 0.0;                ///< internal, from absolute zero [force length]
  double pressure = 0.0;              ///< absolute
  double temperature = 0.0;           ///< absolute
  double inflow = 0.0;                ///< of now [mass/time]
  double outflow = 0.0;               ///< mean over the last step [mass/time]
  double vented = 0.0, leaked = 0.0;  ///< so far: by vent and leak, through fabric [mass]
  bool popped = false;                ///< the pressure has opened the vent

  void archive(Archive& a) { a(volume, mass, energy, pressure, temperature, inflow, outflow, vented, leaked, popped); }
};

/// Open areas of now [length^2].
struct Openings {
  double vent = 0.0;  ///< of the faces of the vent, where it has some
  /// Of each PorousFabric, where nothing covers it: of now and of the start.
  struct Faces {
    double now = 0.0, at_start = 0.0;
  };
  std::vector<Faces> fabric;
};

/// Mass flows out of the volume [mass/time].
struct Outflow {
  double vented = 0.0;  ///< by vent and leak
  double leaked = 0.0;  ///< through fabric
  double sum() const { return vented + leaked; }
};

/// Gas at the ambient pressure and what POVER adds to it.
Bag bag_at_start(const model::ControlVolume& source, double volume);

/// Takes the gas over a step of length `dt` to `time`, when it has `volume`. `inflow`: mass flow over time, 0
/// outside the curve; null: none. `open`: gas may leave. Implicit trapezoidal rule by a fixed number of passes, so that
/// the work on the walls is that of the central differences; what flows in is the integral of its curve, whatever the
/// steps. A volume that is not above 0 leaves the gas as it is.
void advance(Bag& bag, const model::ControlVolume& source, const std::vector<Curve>& curves, double volume,
             const Curve* inflow, bool open, double time, double dt, const Openings& openings);

/// Mass flow through vent, leak and fabric at `time` from a gas at `pressure` and `temperature`, by the isentropic
/// flow through a nozzle, which is choked below the critical ratio of pressures; or that of LOU in the place of the
/// vent, where that is `popped`; through fabric by its own formula (model::PorousFabric). None where the pressure is
/// not above the ambient one.
Outflow outflow(const model::ControlVolume& source, const std::vector<Curve>& curves, double pressure,
                double temperature, double time, bool popped, const Openings& openings);

}  // namespace nugget::impact
