// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

// Rubbers, laws of solids. I, II, III: invariants of the Cauchy-Green tensor; J relative volume.
namespace nugget::kernel {

/// Compressible rubber of Mooney and Rivlin (MAT_027):
///   W = A (I - 3) + B (II - 3) + C (III^-2 - 1) + D (III - 1)^2,
///   C = A / 2 + B,  D = [A (5 nu - 2) + B (11 nu - 5)] / (2 (1 - 2 nu)).
struct MooneyRivlin {
  double E = 0.0;           ///< Young's modulus of small strains, 4 (A + B) (1 + nu) [stress]
  double nu = 0.0;          ///< Poisson's ratio of small strains [1]
  double a = 0.0, b = 0.0;  ///< [stress]
};

/// Foamed rubber of Blatz and Ko (MAT_007; Trans. Soc. Rheol. 6, 1962, with f = 1):
///   W = G / 2 [I - 3 + (J^(-2 beta) - 1) / beta],  beta = nu / (1 - 2 nu).
struct BlatzKo {
  double E = 0.0;      ///< Young's modulus of small strains, 2 G (1 + nu) [stress]
  double nu = 0.463;   ///< Poisson's ratio of small strains [1]
  double shear = 0.0;  ///< G [stress]
};

/// What a rubber has beside its energy: stresses that relax, each a spring (2 G of the deviator) and a damper in
/// series, and one that slides, a spring and a friction element in series.
struct Overstress {
  struct MaxwellBranch {
    double shear = 0.0;  ///< GI [stress]
    double decay = 0.0;  ///< BETAI [1/time]
  };
  std::vector<MaxwellBranch> maxwell_branches;
  double friction_shear = 0.0;  ///< G of the friction branch [stress]; 0: none
  double friction_limit = 0.0;  ///< SIGF, its greatest effective stress [stress]
};

/// Rubber of Ogden (MAT_077_O):
///   W = sum_j mu_j / alpha_j (l1^alpha_j + l2^alpha_j + l3^alpha_j - 3) + K (J - 1 - ln J),
/// l_i principal stretches less the change of volume.
struct Ogden {
  struct Term {
    double mu = 0.0;     ///< [stress]
    double alpha = 0.0;  ///< [1]
  };
  double E = 0.0;   ///< Young's modulus of small strains, 2 (1 + nu) G, G = sum mu alpha / 2 [stress]
  double nu = 0.0;  ///< Poisson's ratio of small strains [1]
  std::vector<Term> terms;
  Overstress overstress;
};

/// Rubber of a polynomial (MAT_077_H):
///   W = sum_pq C_pq (J1 - 3)^p (J2 - 3)^q + K (J - 1 - ln J),  J1 = I III^(-1/3),  J2 = II III^(-2/3).
struct PolynomialRubber {
  double E = 0.0;   ///< Young's modulus of small strains, 2 (1 + nu) G, G = 2 (C10 + C01) [stress]
  double nu = 0.0;  ///< Poisson's ratio of small strains [1]
  double c10 = 0.0, c01 = 0.0, c11 = 0.0, c20 = 0.0, c02 = 0.0, c30 = 0.0;  ///< [stress]
  Overstress overstress;
};

}  // namespace nugget::kernel
