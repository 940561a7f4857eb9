// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/shift_invert.hpp"

#include <algorithm>
#include <vector>

#include "base/index.hpp"

namespace nugget::nvh {
SharedShiftInvert::SharedShiftInvert(MumpsPart<double>& part)
    : part_(part), mass_(part.with_ranks(), part.shares(), part.columns(1)) {}

void SharedShiftInvert::solve(Columns& x) const {
  part_.solve_rows(x);
  if (part_.error() < 0) throw Factorization::SolverError::of_solution(part_.error());
}

void SharedShiftInvert::add_up(Columns& sums) const {
  Ranks& ranks = part_.with_ranks();
  std::vector<double> all(sums.value.size() * at(ranks.count()));
  ranks.gather(std::as_bytes(std::span(sums.value)), std::as_writable_bytes(std::span(all)));
  std::ranges::fill(sums.value, 0.0);
  for (std::size_t i = 0; i < all.size(); ++i) sums.value[i % sums.value.size()] += all[i];
}

void SharedShiftInvert::agree(std::span<double> values) const {
  part_.with_ranks().broadcast(std::as_writable_bytes(values));
}

}  // namespace nugget::nvh
