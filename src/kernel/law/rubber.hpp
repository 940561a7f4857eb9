// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace nugget::kernel {

/// Compressible rubber of Mooney and Rivlin (MAT_027), a law of solids:
///   W = A (I - 3) + B (II - 3) + C (III^-2 - 1) + D (III - 1)^2,
///   C = A / 2 + B,  D = [A (5 nu - 2) + B (11 nu - 5)] / (2 (1 - 2 nu)),
/// I, II, III invariants of the Cauchy-Green tensor.
struct MooneyRivlin {
  double E = 0.0;           ///< Young's modulus of small strains, 4 (A + B) (1 + nu) [stress]
  double nu = 0.0;          ///< Poisson's ratio of small strains [1]
  double a = 0.0, b = 0.0;  ///< [stress]
};

/// Rubber of Ogden (MAT_077_O), a law of solids:
///   W = sum_j mu_j / alpha_j (l1^alpha_j + l2^alpha_j + l3^alpha_j - 3) + K (J - 1 - ln J),
/// l_i principal stretches less the change of volume, J relative volume.
struct Ogden {
  struct Term {
    double mu = 0.0;     ///< [stress]
    double alpha = 0.0;  ///< [1]
  };
  double E = 0.0;   ///< Young's modulus of small strains, 2 (1 + nu) G, G = sum mu alpha / 2 [stress]
  double nu = 0.0;  ///< Poisson's ratio of small strains [1]
  std::vector<Term> terms;
};

}  // namespace nugget::kernel
