// SPDX-License-Identifier: Apache-2.0
#include "weld/audit/stacks.hpp"

#include <algorithm>
#include <numeric>

#include "base/bvh.hpp"
#include "base/index.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {

Stacks::Stacks(const Ties& ties, std::size_t nodes) : root_(ties.welds.size()), sheets_(ties.welds.size()) {
  std::iota(root_.begin(), root_.end(), std::size_t{0});
  std::vector<std::size_t> first_at(nodes, ties.welds.size());
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < ties.welds.size(); ++w) {
    const Weld& weld = ties.welds[w];
    for (const Projection& p : weld.ends) {
      if (first_at[p.node] == ties.welds.size()) first_at[p.node] = w;
      if (!weld.deleted) join(first_at[p.node], w);
    }
    for (int end = 0; end < 2; ++end) {
      const Vec3d c = face_centre(weld, end, ties.x);
      boxes.push_back({c, c});
    }
  }
  const BoxTree tree(boxes);
  for (std::size_t w = 0; w < ties.welds.size(); ++w)
    for (int end = 0; end < 2; ++end) {
      const Weld& weld = ties.welds[w];
      const Index sheet = weld.sheets[end];
      if (sheet == none || weld.deleted) continue;
      const Vec3d here = boxes[2 * w + end].low;
      tree.overlapping(boxes[2 * w + end].grown(0.5 * weld.diameter), [&](int item) {
        const Weld& other = ties.welds[item / 2];
        const double reach = 0.5 * std::min(weld.diameter, other.diameter);
        if (other.sheets[item % 2] == sheet && !other.deleted && norm(boxes[item].low - here) <= reach)
          join(w, at(item / 2));
      });
    }
  for (std::size_t w = 0; w < root_.size(); ++w) {
    root_[w] = root(w);
    std::vector<Index>& sheets = sheets_[root_[w]];
    for (const Index sheet : ties.welds[w].sheets) {
      const auto place = std::lower_bound(sheets.begin(), sheets.end(), sheet);
      if (sheet != none && (place == sheets.end() || *place != sheet)) sheets.insert(place, sheet);
    }
  }
}

std::size_t Stacks::root(std::size_t w) const {
  while (root_[w] != w) w = root_[w];
  return w;
}

void Stacks::join(std::size_t a, std::size_t b) {
  a = root(a);
  b = root(b);
  root_[std::max(a, b)] = std::min(a, b);
}

}  // namespace nugget::weld
