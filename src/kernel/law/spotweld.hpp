// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Spot weld (MAT_100), a point of it: J2 plasticity with linear isotropic hardening. What belongs to the weld as a
/// whole (strengths, times, filters) is model::WeldLaw.
struct Spotweld {
  double E = 0.0;               ///< Young's modulus [stress]
  double nu = 0.0;              ///< Poisson's ratio [1]
  double yield = 0.0;           ///< SIGY [stress]
  double hardening = 0.0;       ///< EH, slope of the yield stress over plastic strain [stress]
  double failure_strain = 0.0;  ///< EFAIL, effective plastic strain at which a point fails [1]; 0: none
  double mass_step = 0.0;       ///< DT, time step to which the weld's density is scaled [time]; 0: none
};

}  // namespace nugget::kernel
