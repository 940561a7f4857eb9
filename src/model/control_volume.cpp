// SPDX-License-Identifier: Apache-2.0
#include "model/control_volume.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace nugget::model {
namespace {

/// The representative of a node's border, made shorter on the way.
Index root(std::map<Index, Index>& parent, Index n) {
  while (parent.at(n) != n) n = parent[n] = parent.at(parent.at(n));
  return n;
}

}  // namespace

SurfaceBorder surface_border(const std::vector<Segment>& segments) {
  // By edge, lower node first: how often faces run along it upwards and downwards.
  std::map<std::array<Index, 2>, std::array<int, 2>> edges;
  for (const Segment& s : segments) {
    const std::size_t corners = s[3] == s[2] ? 3 : 4;
    for (std::size_t a = 0; a < corners; ++a) {
      const Index from = s[a], to = s[(a + 1) % corners];
      if (from != to) ++edges[{std::min(from, to), std::max(from, to)}][from < to ? 0 : 1];
    }
  }
  SurfaceBorder border;
  std::vector<std::array<Index, 2>> open;
  for (const auto& [edge, count] : edges) {
    if (count[0] == count[1]) continue;
    if (count[0] + count[1] == 2) border.twisted.push_back(edge);
    const bool upwards = count[0] > count[1];
    for (int k = std::abs(count[0] - count[1]); k > 0; --k)
      open.push_back(upwards ? edge : std::array{edge[1], edge[0]});
  }
  std::map<Index, Index> parent;
  for (const auto& edge : open)
    for (const Index n : edge) parent.try_emplace(n, n);
  for (const auto& edge : open) {
    const Index a = root(parent, edge[0]), b = root(parent, edge[1]);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::map<Index, Opening> openings;
  for (const auto& edge : open) openings[root(parent, edge[0])].edges.push_back(edge);
  for (const auto& [node, up] : parent) openings[root(parent, node)].nodes.push_back(node);
  for (auto& [node, opening] : openings) border.openings.push_back(std::move(opening));
  return border;
}

}  // namespace nugget::model
