// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace nugget::kernel {

/// Isotropic linear elasticity in rate form (MAT_001).
struct Elastic {
  double E = 0.0;   ///< Young's modulus [stress]
  double nu = 0.0;  ///< Poisson's ratio [1]
};

}  // namespace nugget::kernel
