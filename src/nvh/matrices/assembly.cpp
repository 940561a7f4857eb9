// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/assembly.hpp"

#include <algorithm>
#include <iterator>

#include "base/parallel.hpp"

namespace nugget::nvh {

void scatter(const DofMap& dof_map, std::span<const double> k, Symmetric& into) {
  const std::vector<double> q = dof_map.reduced(k);
  const std::vector<int>& eq = dof_map.equations();
  for (std::size_t i = 0; i < eq.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)  // mean of both triangles: kernels are symmetric to round-off only
      into.add(eq[i], eq[j], 0.5 * (q[i * eq.size() + j] + q[j * eq.size() + i]));
}

std::vector<std::vector<int>> pattern(std::size_t size, const std::vector<std::vector<int>>& lists) {
  std::vector<std::vector<int>> rows(size);
  for (std::size_t j = 0; j < size; ++j) rows[j].push_back(static_cast<int>(j));
  const auto tidy = [](std::vector<int>& r) {
    std::sort(r.begin(), r.end());
    r.erase(std::unique(r.begin(), r.end()), r.end());
  };
  for (const std::vector<int>& list : lists)
    for (std::size_t j = 0; j < list.size(); ++j) {
      std::vector<int>& r = rows[list[j]];
      r.insert(r.end(), list.begin() + static_cast<std::ptrdiff_t>(j), list.end());
      if (r.size() > 1000) tidy(r);
    }
  parallel_for(size, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) tidy(rows[j]);
  });
  return rows;
}

Symmetric sum(const Symmetric& a, const Symmetric& b) {
  std::vector<std::vector<int>> rows(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) std::ranges::set_union(a.rows(j), b.rows(j), std::back_inserter(rows[j]));
  Symmetric both(rows);
  for (const Symmetric* part : {&a, &b})
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t i = 0; i < part->rows(j).size(); ++i)
        both.add(part->rows(j)[i], static_cast<int>(j), part->values(j)[i]);
  return both;
}

}  // namespace nugget::nvh
