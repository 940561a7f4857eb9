// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>

#include "nvh/matrices/factorization.hpp"

namespace nugget::nvh {

/// Some eigenpairs K x = lambda M x, x^t M x = 1, in ascending order of lambda.
struct Eigenpairs {
  std::vector<double> value;  ///< lambda = omega^2 [1/time^2]
  Columns vector;
  int solves = 0;         ///< right-hand sides that were solved for
  bool converged = true;  ///< false: fewer pairs than asked for reached the tolerance
};

/// Which pairs: the `count` nearest to the shift, and on from there until `below` of them lie between `low` and the
/// shift, and `above` beyond it.
struct NearestPairs {
  std::size_t count = 0;
  double low = -std::numeric_limits<double>::infinity();
  std::size_t below = 0, above = 0;
};

/// The eigenpairs nearest to -shift of the factorization, by block Lanczos on A^-1 M in the inner product of M
/// (shift and invert; Grimes, Lewis, Simon, SIAM J. Matrix Anal. Appl. 15 (1994) 228), with full reorthogonalization
/// and thick restarts. Each residual |A^-1 M x - theta x|_M is below 1e-7 theta, which makes the eigenvalue, of second
/// order in it, good to round-off. `M` may be singular (unknowns without mass). With several ranks each has its rows of
/// the basis, and computes with them.
Eigenpairs nearest(const Matrices& matrices, const Factorization& factorization, const NearestPairs& wanted,
                   const std::function<void(int converged)>& progress = {});

}  // namespace nugget::nvh
