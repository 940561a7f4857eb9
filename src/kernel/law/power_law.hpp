// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Isotropic hardening k (e_y + ep)^n with Cowper-Symonds rates (MAT_018).
struct PowerLaw {
  double E = 0.0;             ///< Young's modulus [stress]
  double nu = 0.0;            ///< Poisson's ratio [1]
  double strength = 0.0;      ///< k [stress]
  double exponent = 0.0;      ///< n [1]
  double yield_strain = 0.0;  ///< e_y, elastic strain at first yield [1]
  double rate_c = 0.0;        ///< SRC, Cowper-Symonds C [1/time]; 0: no rate effect
  double rate_p = 1.0;        ///< SRP [1]
};

}  // namespace nugget::kernel
