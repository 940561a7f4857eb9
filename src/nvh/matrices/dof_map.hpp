// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "nvh/matrices/equations.hpp"

namespace nugget::nvh {

/// The unknowns that a list of freedoms depends on, and how: u = C q.
class DofMap {
 public:
  DofMap(const Equations& equations, std::span<const int> nodes, int freedoms_a_node);
  const std::vector<int>& equations() const { return equation_; }

  /// C^t k C, row-major; `k` has as many rows as there are freedoms.
  std::vector<double> reduced(std::span<const double> k) const;

 private:
  template <class Visit>
  void each_term(const Visit& visit) const;
  std::vector<Equations::Term> term_;  ///< equations as places in `equation_`
  std::vector<std::size_t> end_;       ///< of each freedom's terms
  std::vector<int> equation_;
};

}  // namespace nugget::nvh
