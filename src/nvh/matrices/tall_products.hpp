// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nvh/matrices/sparse.hpp"

/// Products of many columns with a few, all as long as a model has equations. Memory limits them, not arithmetic: each
/// column of A is read once, on all threads. The same bits for any number of them.
namespace nugget::nvh::tall {

/// Whether the shapes are what this is for.
inline bool pays(std::size_t rows, std::size_t few) {
  return rows >= 2048 && few <= 16;
}

/// c := A^t B, with c.rows columns of A from `a_first` on.
void inner(const Columns& a, std::size_t a_first, const Columns& b, Columns& c);

/// c := beta c + alpha A b, with b.rows columns of A from `a_first` on.
void add_product(double alpha, const Columns& a, std::size_t a_first, const Columns& b, double beta, Columns& c);

}  // namespace nugget::nvh::tall
