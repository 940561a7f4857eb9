// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Linear viscoelastic shear, elastic volume (MAT_006), a law of solids: shear modulus GI + (G0 - GI) exp(-BETA t).
struct Viscoelastic {
  double E = 0.0;           ///< Young's modulus at once, from BULK and G0 [stress]
  double nu = 0.0;          ///< Poisson's ratio at once [1]
  double bulk = 0.0;        ///< [stress]
  double at_once = 0.0;     ///< G0 [stress]
  double in_the_end = 0.0;  ///< GI [stress]
  double decay = 0.0;       ///< BETA [1/time]
};

}  // namespace nugget::kernel
