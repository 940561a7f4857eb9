// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/dof_map.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace nugget::nvh {

DofMap::DofMap(const Equations& equations, std::span<const int> nodes, int freedoms_a_node) {
  for (const int node : nodes)
    for (int i = 0; i < freedoms_a_node; ++i) {
      for (const Equations::Term& t : equations.terms(node, i)) {
        term_.push_back(t);
        equation_.push_back(t.equation);
      }
      end_.push_back(term_.size());
    }
  std::sort(equation_.begin(), equation_.end());
  equation_.erase(std::unique(equation_.begin(), equation_.end()), equation_.end());
  for (Equations::Term& t : term_)
    t.equation = static_cast<int>(std::lower_bound(equation_.begin(), equation_.end(), t.equation) - equation_.begin());
}

template <class Visit>
void DofMap::each_term(const Visit& visit) const {
  std::size_t t = 0;
  for (std::size_t i = 0; i < end_.size(); ++i)
    for (; t < end_[i]; ++t) visit(i, at(term_[t].equation), term_[t].factor);
}

std::vector<double> DofMap::reduced(std::span<const double> k) const {
  const std::size_t n = end_.size(), m = equation_.size();
  std::vector<double> half(n * m, 0.0), full(m * m, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    each_term([&](std::size_t j, std::size_t place, double factor) { half[i * m + place] += k[i * n + j] * factor; });
  each_term([&](std::size_t i, std::size_t place, double factor) {
    for (std::size_t j = 0; j < m; ++j) full[place * m + j] += factor * half[i * m + j];
  });
  return full;
}

}  // namespace nugget::nvh
