// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_nodes.hpp"

#include <algorithm>

namespace nugget::contact {

std::vector<int> surface_nodes(const SurfaceContactSetup& setup) {
  std::vector<int> nodes;
  for (const Segment& s : setup.segments) nodes.insert(nodes.end(), s.node.begin(), s.node.end());
  for (const TrackedNode& t : setup.nodes) nodes.push_back(t.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

void assign_sides(NodalForces& forces, const NodeSegments& around, const std::vector<Segment>& segments) {
  for (int n : forces.nodes()) {
    unsigned sides = 0;
    for (int s : around.at(n)) sides |= segments[s].side;
    forces.set_side(n, sides == 2 ? 1 : 0);
  }
}

}  // namespace nugget::contact
