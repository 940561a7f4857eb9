// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/curve.hpp"

namespace nugget::kernel {

/// How a point of a weld loses its stress after its plastic strain has passed EFAIL (_DAMAGE-FAILURE with DMGOPT 0 to
/// 2; docs/theory/failure.md#damage-of-a-point). The damage w grows from 0 to 1; the stress is (1 - w) times that of
/// the undamaged point, or exp(-beta w) times it; at 1 the point has failed.
struct PointDamage {
  enum class Growth {
    none,
    strain,  ///< w = (plastic strain - EFAIL) / (RS - EFAIL)
    time,    ///< w = time since EFAIL was passed / RS
  };
  Growth growth = Growth::none;
  double rupture = 0.0;        ///< RS: plastic strain [1] or, from the onset on, time
  double beta = 0.0;           ///< BETA [1]; 0: linear
  bool freezes_yield = false;  ///< DMGOPT 1 and 2: no hardening beyond EFAIL
};

/// Spot weld (MAT_100), a point of it: J2 plasticity with isotropic hardening, failure and damage over plastic strain.
/// What belongs to the weld as a whole (strengths, times, filters) is model::WeldLaw.
struct Spotweld {
  double E = 0.0;               ///< Young's modulus [stress]
  double nu = 0.0;              ///< Poisson's ratio [1]
  double yield = 0.0;           ///< SIGY [stress]
  double hardening = 0.0;       ///< EH, slope of the yield stress over plastic strain [stress]
  double failure_strain = 0.0;  ///< EFAIL, effective plastic strain at which a point fails or its damage begins [1];
                                ///< 0: no failure, damage from first yield on
  double mass_step = 0.0;       ///< DT, time step to which the weld's density is scaled [time]; 0: none
  std::vector<Curve> yield_curves;  ///< SIGY < 0: yield stress over plastic strain, one a rate; empty: SIGY and EH
  std::vector<double> rates;        ///< of the plastic strain, of the curves [1/time]; empty: one curve
  bool log_rates = false;           ///< interpolate over the logarithm of the rate
  bool uniaxial = false;  ///< E < 0 or _UNIAXIAL: bricks have no other stresses than those on the weld's cross-section
  PointDamage damage;
  bool yield_can_be_frozen = false;  ///< the weld as a whole may stop hardening where it stands (DMGOPT 11, 12)
};

}  // namespace nugget::kernel
