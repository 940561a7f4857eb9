// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Bilinear elastic-plastic law with mixed kinematic and isotropic hardening and Cowper-Symonds rates (MAT_003).
/// Plastic modulus H' = E Et / (E - Et); yield stress (SIGY + beta H' ep) (1 + (rate / C)^(1/P)); back stress (1 -
/// beta) H' ep.
struct PlasticKinematic {
  double E = 0.0;                ///< Young's modulus [stress]
  double nu = 0.0;               ///< Poisson's ratio [1]
  double yield = 0.0;            ///< SIGY [stress]
  double tangent_modulus = 0.0;  ///< ETAN, slope of stress over total strain after yield, below E [stress]
  double beta = 0.0;             ///< 0 kinematic .. 1 isotropic [1]
  double rate_c = 0.0;           ///< SRC, Cowper-Symonds C [1/time]; 0: no rate effect
  double rate_p = 0.0;           ///< SRP, Cowper-Symonds P [1]
  double failure_strain = 0.0;   ///< FS, effective plastic strain at which a point fails [1]; 0: none
};

}  // namespace nugget::kernel
