// SPDX-License-Identifier: Apache-2.0
#include "nvh/eigen/shifts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "base/index.hpp"

namespace nugget::nvh {

int Shifts::below(double& lambda) {
  report(fmt::format("factorization {} of {} equations", modes_.cost.factorizations + 1, m_.size()));
  for (double nudge = 1e-7;; nudge *= 10.0) {
    try {
      if (factor_)
        factor_->shift_to(-lambda);
      else
        factor_.emplace(m_, -lambda);
      ++modes_.cost.factorizations;
      modes_.cost.factor_seconds += factor_->cost().seconds;
      modes_.cost.factor_entries = factor_->cost().entries;
      modes_.cost.most_memory = factor_->cost().most_memory;
      modes_.cost.memory = factor_->cost().memory;
      return factor_->negative();
    } catch (const Factorization::SolverError&) {
      if (lambda <= 0.0 || nudge > 1e-4) throw;
      lambda *= 1.0 + nudge;
    }
  }
}

Eigenpairs Shifts::nearest(const NearestPairs& wanted, std::size_t known, std::size_t all) {
  const auto begin = std::chrono::steady_clock::now();
  Eigenpairs p = nvh::nearest(m_, *factor_, wanted, [&](int done) {
    report(fmt::format("{} of {} modes", std::min(known + at(done), all), all));
  });
  modes_.cost.lanczos_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  modes_.cost.solves += p.solves;
  return p;
}

}  // namespace nugget::nvh
