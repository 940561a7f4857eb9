// SPDX-License-Identifier: Apache-2.0
#include "weld/audit/stacks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <utility>

#include "base/bvh.hpp"
#include "base/index.hpp"
#include "weld/tie/segment.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {

namespace {

/// Whether a weld joins two layers of one part: it stands across the sheets of both ends.
bool joins_layers(const Weld& weld, const std::vector<Vec3d>& x) {
  if (!weld.tied || weld.sheets[0] == none || weld.sheets[0] != weld.sheets[1]) return false;
  static const double steep = std::cos(30.0 * std::numbers::pi / 180.0);
  const Vec3d axis = face_centre(weld, 1, x) - face_centre(weld, 0, x);
  return std::all_of(weld.face.begin(), weld.face.end(), [&](const std::vector<Index>& face) {
    const auto end = std::find_if(weld.ends.begin(), weld.ends.end(), [&](const Projection& p) {
      return p.tied && p.projection_case != 0 && std::find(face.begin(), face.end(), p.node) != face.end();
    });
    if (end == weld.ends.end()) return false;
    const model::Segment& n = end->tie.segment;
    return std::abs(dot(normal({x[n[0]], x[n[1]], x[n[2]], x[n[3]]}), axis)) >= steep * norm(axis);
  });
}

}  // namespace

Joined::Joined(std::size_t count) : root_(count) {
  std::iota(root_.begin(), root_.end(), std::size_t{0});
}

std::size_t Joined::first(std::size_t a) const {
  while (root_[a] != a) a = root_[a];
  return a;
}

void Joined::join(std::size_t a, std::size_t b) {
  a = first(a);
  b = first(b);
  root_[std::max(a, b)] = std::min(a, b);
}

Stacks::Stacks(const Ties& ties, std::size_t nodes) : root_(ties.welds.size()), sheets_(ties.welds.size()) {
  const std::size_t welds = ties.welds.size();
  Joined joined(welds), ends(2 * welds);
  const auto end_at = [&](std::size_t w, Index node) {
    const std::vector<Index>& second = ties.welds[w].face[1];
    return 2 * w + (std::find(second.begin(), second.end(), node) != second.end());
  };
  std::vector<std::size_t> first_at(nodes, welds);
  std::vector<Box> boxes;
  for (std::size_t w = 0; w < welds; ++w) {
    const Weld& weld = ties.welds[w];
    for (const Projection& p : weld.ends) {
      if (first_at[p.node] == welds) first_at[p.node] = w;
      if (weld.deleted) continue;
      joined.join(first_at[p.node], w);
      ends.join(end_at(first_at[p.node], p.node), end_at(w, p.node));
    }
    for (int end = 0; end < 2; ++end) {
      const Vec3d c = face_centre(weld, end, ties.x);
      boxes.push_back({c, c});
    }
  }
  const BoxTree tree(boxes);
  for (std::size_t w = 0; w < welds; ++w)
    for (std::size_t end = 0; end < 2; ++end) {
      const Weld& weld = ties.welds[w];
      const Index sheet = weld.sheets[end];
      if (sheet == none || weld.deleted) continue;
      const std::size_t own = 2 * w + end;
      const Vec3d here = boxes[own].low;
      tree.overlapping(boxes[own].grown(0.5 * weld.diameter), [&](int item) {
        const Weld& other = ties.welds[item / 2];
        const double reach = 0.5 * std::min(weld.diameter, other.diameter);
        if (other.sheets[item % 2] != sheet || other.deleted || norm(boxes[item].low - here) > reach) return;
        joined.join(w, at(item / 2));
        // Of a weld between two layers of the sheet's part the other end may be closer, which is on another one then.
        const auto other_end_is_closer = [&](std::size_t end_here, std::size_t to) {
          const std::size_t twin = end_here ^ 1;
          const Vec3d& place = boxes[to].low;
          return ties.welds[twin / 2].sheets[twin % 2] == sheet &&
                 norm(boxes[twin].low - place) < norm(boxes[end_here].low - place);
        };
        if (at(item / 2) != w && !other_end_is_closer(own, at(item)) && !other_end_is_closer(at(item), own))
          ends.join(own, at(item));
      });
    }
  std::vector<std::set<std::pair<Index, std::size_t>>> places(welds);  // of each stack: part and first end there
  std::vector<std::set<Index>> layered(welds);                         // parts of which it joins several layers
  for (std::size_t w = 0; w < welds; ++w) {
    root_[w] = joined.first(w);
    const Weld& weld = ties.welds[w];
    for (std::size_t end = 0; end < 2; ++end)
      if (weld.sheets[end] != none) places[root_[w]].insert({weld.sheets[end], ends.first(2 * w + end)});
    if (joins_layers(weld, ties.x)) layered[root_[w]].insert(weld.sheets[0]);
  }
  for (std::size_t w = 0; w < welds; ++w)
    for (const auto& [part, end] : places[w])
      if (sheets_[w].empty() || sheets_[w].back() != part || layered[w].contains(part)) sheets_[w].push_back(part);
}

}  // namespace nugget::weld
