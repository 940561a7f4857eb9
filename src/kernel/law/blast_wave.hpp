// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Where TNT goes off: in free air, or as a half sphere on hard ground, which throws half of the wave back.
enum class Burst { sphere, half_sphere };

/// Overpressure on a surface at one distance from a charge, in kPa and ms.
///
/// Friedlander's curve p (1 - t/T) exp(-b t/T) from the arrival on, of the wave that passes (incident) and of the one
/// thrown back by a wall across it (reflected), with the same duration T, and b such that the area up to T is the
/// impulse.
struct BlastWave {
  double arrival = 0.0, duration = 0.0;                    ///< after the burst; of the overpressure [ms]
  double incident = 0.0, reflected = 0.0;                  ///< peaks [kPa]
  double incident_decay = 0.0, reflected_decay = 0.0;      ///< b [1]
  double incident_impulse = 0.0, reflected_impulse = 0.0;  ///< areas of the positive phase [kPa ms]

  /// Overpressure `time` ms after the burst on a surface whose normal makes an angle of this cosine with the direction
  /// to the charge: reflected cos^2 + incident (1 + cos^2 - 2 cos), on surfaces that look away the incident one (G.
  /// Randers-Pehrson, K. Bannister, ARL-TR-1310, 1997). Behind the positive phase it is below zero, as Friedlander's
  /// curve goes on, or 0.
  double pressure(double time, double cosine, bool negative_phase) const;
};

/// Scaled distances [m/kg^(1/3)] for which there are data of everything: 0.147 or 0.178 to 40.
double least_scaled_distance(Burst burst);
inline constexpr double greatest_scaled_distance = 40.0;

/// The wave of `mass` kg of TNT at a distance [m] between these. Source: C. Kingery, G. Bulmash, ARBRL-TR-02555 (1984):
/// polynomials of the logarithm of the scaled distance; docs/theory/blast.md.
BlastWave blast_wave(Burst burst, double mass, double distance);

}  // namespace nugget::kernel
