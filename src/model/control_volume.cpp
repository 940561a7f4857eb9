// SPDX-License-Identifier: Apache-2.0
#include "model/control_volume.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "model/segments.hpp"

namespace nugget::model {
namespace {

/// The representative of a node's border, made shorter on the way.
Index root(std::map<Index, Index>& parent, Index n) {
  while (parent.at(n) != n) n = parent[n] = parent.at(parent.at(n));
  return n;
}

/// Calls `visit(from, to)` for each edge of a face, as the face runs along it.
template <class Visit>
void each_edge(const Segment& face, const Visit& visit) {
  const std::size_t corners = face[3] == face[2] ? 3 : 4;
  for (std::size_t a = 0; a < corners; ++a) {
    const Index from = face[a], to = face[(a + 1) % corners];
    if (from != to) visit(from, to);
  }
}

}  // namespace

SurfaceBorder surface_border(const std::vector<Segment>& segments) {
  // By edge, lower node first: how often faces run along it upwards and downwards.
  std::map<std::array<Index, 2>, std::array<int, 2>> edges;
  for (const Segment& s : segments)
    each_edge(s, [&](Index from, Index to) { ++edges[{std::min(from, to), std::max(from, to)}][from < to ? 0 : 1]; });
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

std::vector<std::size_t> turn_faces_to_agree(std::vector<Segment>& segments) {
  struct Side {
    std::size_t face;
    bool upwards;  ///< along the edge, from its lower node
  };
  std::map<std::array<Index, 2>, std::vector<Side>> sides;
  for (std::size_t f = 0; f < segments.size(); ++f)
    each_edge(segments[f], [&](Index from, Index to) {
      sides[{std::min(from, to), std::max(from, to)}].push_back({f, from < to});
    });
  struct Neighbour {
    std::size_t face;
    bool agrees;
  };
  std::vector<std::vector<Neighbour>> neighbours(segments.size());
  for (const auto& [edge, both] : sides) {
    if (both.size() != 2) continue;
    const bool agree = both[0].upwards != both[1].upwards;
    neighbours[both[0].face].push_back({both[1].face, agree});
    neighbours[both[1].face].push_back({both[0].face, agree});
  }
  std::vector<char> turn(segments.size(), 0), seen(segments.size(), 0);
  for (std::size_t first = 0; first < segments.size(); ++first) {
    if (seen[first] != 0) continue;
    std::vector<std::size_t> surface{first};
    seen[first] = 1;
    std::size_t others = 0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const std::size_t f = surface[i];
      others += turn[f] != 0 ? 1 : 0;
      for (const Neighbour& n : neighbours[f]) {
        if (seen[n.face] != 0) continue;
        seen[n.face] = 1;
        turn[n.face] = n.agrees ? turn[f] : !turn[f];
        surface.push_back(n.face);
      }
    }
    if (2 * others > surface.size())
      for (const std::size_t f : surface) turn[f] = !turn[f];
  }
  std::vector<std::size_t> all;
  for (std::size_t f = 0; f < segments.size(); ++f) {
    if (turn[f] == 0) continue;
    segments[f] = turned_over(segments[f]);
    all.push_back(f);
  }
  return all;
}

}  // namespace nugget::model
