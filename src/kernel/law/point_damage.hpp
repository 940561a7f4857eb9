// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "base/curve.hpp"

// What makes a point of a compound law lose its stress, beside a limit of its plastic strain.
namespace nugget::kernel {

/// What results show of the damage of a point: the share of its stress that it has lost, and of GISSMO D and F, of
/// Johnson and Cook's fracture the sum of plastic strains over those at fracture; 0 to 1.
using DamageNumbers = std::array<double, 3>;

/// Damage w that grows with a plastic strain; at 1 the point has failed.
struct PlasticDamage {
  double onset = 0.0;    ///< EPPF, plastic strain at which it begins [1]
  double rupture = 0.0;  ///< EPPFR, plastic strain at which it is 1, linear in between [1]
  Curve growth{};        ///< LCDM: damage over plastic strain beyond the onset; empty: linear

  double at(double plastic_strain) const {
    const double beyond = plastic_strain - onset;
    if (!(beyond > 0.0)) return 0.0;
    if (!growth.empty()) return std::clamp(growth.clamped(beyond), 0.0, 1.0);
    return std::min(beyond / (rupture - onset), 1.0);
  }
};

/// Damage D that grows with the plastic strain p by the elastic energy that it would set free (J. Lemaitre, A Course on
/// Damage Mechanics, 1992; MAT_105): dD/dp = Y / S beyond the onset, while the largest principal stress is tension,
/// with
///   Y = s^2 / 2E (2/3 (1 + nu) + 3 (1 - 2 nu) (m / s)^2),
/// s and m the effective and the mean stress of the undamaged point. At the critical D the point has failed.
struct EnergyDamage {
  double young = 0.0, poisson = 0.0;  ///< E [stress], nu [1]
  double onset = 0.0;                 ///< EPSD, plastic strain [1]
  double resistance = 0.0;            ///< S [stress]
  double critical = 0.5;              ///< DC [1]

  /// dD/dp where the largest principal stress is tension [1]. `effective2`: the square of the effective stress.
  double growth(double effective2, double mean) const {
    return (2.0 / 3.0 * (1.0 + poisson) * effective2 + 3.0 * (1.0 - 2.0 * poisson) * mean * mean) /
           (2.0 * young * resistance);
  }
};

/// Criteria of *MAT_ADD_EROSION. Pressure is positive in compression; strains are time integrals of the strain rate in
/// axes that turn with the material; principal values are of all three axes, in a layer too.
struct Erosion {
  std::optional<double> most_pressure, least_pressure;  ///< MXPRES, MNPRES [stress]
  std::optional<double> least_strain, most_strain;      ///< MNEPS, MXEPS: principal strains [1]
  Curve most_strain_over_log_rate;                      ///< MXEPS over ln of the strain rate; empty: none
  std::optional<double> effective_strain;               ///< EFFEPS: sqrt(2/3 e:e) of the deviator [1]
  std::optional<double> most_volume_strain;             ///< VOLEPS above 0, ln of TEROD: reached [1]
  std::optional<double> least_volume_strain;            ///< VOLEPS below 0, ln of CEROD: fallen to [1]
  std::optional<double> most_stress;                    ///< SIGP1: principal stress [stress]
  std::optional<double> effective_stress;               ///< SIGVM [stress]
  Curve effective_stress_over_rate;                     ///< SIGVM < 0; empty: none
  std::optional<double> shear_strain;                   ///< EPSSH: largest tensorial shear [1]
  std::optional<double> impulse;                        ///< IMPULSE: of (s1 - SIGTH)^2 over time
  double threshold = 0.0;                               ///< SIGTH [stress]
  std::optional<double> time;                           ///< FAILTM
  std::optional<double> thinning;                       ///< EPSTHIN, of a layer [1]
  int needed = 1;                                       ///< NCS: how many must hold at once
};

/// Limits of strain in a layer (MAT_123).
struct StrainLimits {
  double plastic_thinning = 0.0;  ///< EPSTHIN [1]; 0: none
  double major = 0.0;             ///< EPSMAJ, larger principal strain in the plane; of a solid the largest [1]; 0: none
};

}  // namespace nugget::kernel
