// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_nodes.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace nugget::contact {

std::vector<int> surface_nodes(const SurfaceContactSetup& setup) {
  std::vector<char> is_one;
  const auto mark = [&is_one](int n) {
    if (at(n) >= is_one.size()) is_one.resize(std::max(at(n) + 1, 2 * is_one.size()), 0);
    is_one[at(n)] = 1;
  };
  for (const Segment& s : setup.segments)
    for (const int n : s.node) mark(n);
  for (const TrackedNode& t : setup.nodes) mark(t.node);
  if (setup.whole) {
    for (std::size_t n = 0; n < setup.whole->sides.size(); ++n)
      if (setup.whole->sides[n] != 0) mark(static_cast<int>(n));
    for (const int n : setup.whole->tracked) mark(n);
  }
  std::vector<int> nodes;
  nodes.reserve(static_cast<std::size_t>(std::count(is_one.begin(), is_one.end(), 1)));
  for (std::size_t n = 0; n < is_one.size(); ++n)
    if (is_one[n] != 0) nodes.push_back(static_cast<int>(n));
  return nodes;
}

void assign_sides(NodalForces& forces, const NodeSegments& around, const SurfaceContactSetup& setup) {
  for (int n : forces.nodes()) {
    unsigned sides = 0;
    if (setup.whole)
      sides = at(n) < setup.whole->sides.size() ? setup.whole->sides[at(n)] : 0;
    else
      for (int s : around.at(n)) sides |= setup.segments[s].side;
    forces.set_side(n, sides == 2 ? 1 : 0);
  }
}

}  // namespace nugget::contact
