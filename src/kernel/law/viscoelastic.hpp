// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Linear viscoelastic shear, elastic volume (MAT_006), a law of solids: shear modulus GI + (G0 - GI) exp(-BETA t).
struct Viscoelastic {
  double E = 0.0;                    ///< instantaneous Young's modulus, from BULK and G0 [stress]
  double nu = 0.0;                   ///< instantaneous Poisson's ratio [1]
  double bulk = 0.0;                 ///< [stress]
  double instantaneous_shear = 0.0;  ///< G0 [stress]
  double long_term_shear = 0.0;      ///< GI [stress]
  double decay = 0.0;                ///< BETA [1/time]
};

}  // namespace nugget::kernel
