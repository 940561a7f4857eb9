// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "nvh/matrices/factorization.hpp"

namespace nugget::nvh {

/// Solves K x = f by conjugate gradients, with the factor of K + s M for a small shift s as preconditioner. What is
/// soft beside s (slender structures, whose lowest eigenvalues a shift that fits all cannot know) is as exact as the
/// rest, and what is free stays where it is, where f does no work on it. False: it did not converge, since f does.
bool solve_statically(const Matrices& matrices, const Factorization& shifted, std::span<const double> f,
                      std::span<double> x);

}  // namespace nugget::nvh
