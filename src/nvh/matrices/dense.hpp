// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <vector>

#include "nvh/matrices/sparse.hpp"

// Dense products and eigenvalues, by BLAS and LAPACK; of few long columns by tall_products.hpp.
namespace nugget::nvh {

/// Lets BLAS compute on one thread, and take the memory that it keeps for itself: it would wait for ever where there is
/// none. Throws std::bad_alloc instead. Once a process.
void prepare_blas();

/// A^t B with `a_count` columns of A from `a_first` on.
Columns inner(const Columns& a, std::size_t a_count, const Columns& b, std::size_t a_first = 0);

/// C := beta C + alpha A B with `a_count` columns of A from `a_first` on.
void add_product(double alpha, const Columns& a, std::size_t a_count, const Columns& b, double beta, Columns& c,
                 std::size_t a_first = 0);

/// b := A^-1 b for columns one after the other, A of n rows by columns, which is destroyed; not a number where A is
/// singular.
void solve(std::vector<std::complex<double>>& a, std::vector<std::complex<double>>& b, std::size_t n);

/// Eigenvalues, ascending, of a symmetric matrix, of which the lower triangle is read; vectors take its place.
std::vector<double> diagonalize(Columns& a);

}  // namespace nugget::nvh
