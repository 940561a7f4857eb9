// SPDX-License-Identifier: Apache-2.0
#include "system/nodal_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "kernel/element/tetrahedron.hpp"

namespace nugget::system {

NodalPressure::NodalPressure(const std::vector<std::array<int, 4>>& corners, std::span<const Vec3d> x,
                             double bulk_modulus)
    : bulk_modulus_(bulk_modulus), corners_(corners), volume_(corners.size()), mean_(corners.size()) {
  std::vector<int> nodes;
  for (const auto& c : corners) nodes.insert(nodes.end(), c.begin(), c.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  first_.assign(nodes.size() + 1, 0);
  for (const auto& c : corners) {
    std::array<Vec3d, 4> place;
    std::array<int, 4> local;
    for (std::size_t a = 0; a < 4; ++a) {
      place[a] = x[c[a]];
      local[a] = static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), c[a]) - nodes.begin());
      ++first_[at(local[a]) + 1];
    }
    local_.push_back(local);
    at_start_.push_back(kernel::tetrahedron_volume(place));
  }
  for (std::size_t n = 0; n < nodes.size(); ++n) first_[n + 1] += first_[n];
  around_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < local_.size(); ++e)
    for (const int n : local_[e]) around_[next[n]++] = static_cast<int>(e);
  at_node_.resize(nodes.size());
}

const std::vector<double>& NodalPressure::update(const State& now, const std::function<bool(std::size_t)>& alive) {
  parallel_for(corners_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      std::array<Vec3d, 4> place;
      for (std::size_t a = 0; a < 4; ++a) place[a] = vec(now.x[corners_[e][a]]);
      // What is inside out is deleted, or ends the run: its neighbours go on without it.
      volume_[e] = alive(e) ? std::max(0.0, kernel::tetrahedron_volume(place)) : 0.0;
    }
  });
  parallel_for(at_node_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      double is = 0.0, was = 0.0;
      for (std::size_t i = first_[n]; i < first_[n + 1]; ++i) {
        const std::size_t e = at(around_[i]);
        is += volume_[e];
        if (volume_[e] != 0.0) was += at_start_[e];
      }
      at_node_[n] = was > 0.0 ? bulk_modulus_ * std::log(is / was) : 0.0;
    }
  });
  parallel_for(corners_.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      mean_[e] = 0.0;
      for (const int n : local_[e]) mean_[e] += 0.25 * at_node_[n];
    }
  });
  return mean_;
}

}  // namespace nugget::system
