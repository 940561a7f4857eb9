// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/curve.hpp"

namespace nugget::kernel {

/// Linear isotropic hardening with yield stress and plastic modulus over the strain rate (MAT_019).
struct RateDependentYield {
  double E = 0.0;         ///< Young's modulus [stress]
  double nu = 0.0;        ///< Poisson's ratio [1]
  Curve yield;            ///< LC1: yield stress over effective strain rate
  Curve plastic_modulus;  ///< from ETAN, or LC3 over the rate [stress]
};

}  // namespace nugget::kernel
