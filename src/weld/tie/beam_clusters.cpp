// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/beam_clusters.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>

#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

/// The tracked nodes of one end; empty if one of them is not tracked.
std::vector<Tracked*> tracked_of(std::vector<Index> nodes, std::vector<Tracked>& tracked) {
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  std::vector<Tracked*> found;
  for (const Index node : nodes) {
    const auto place = std::ranges::lower_bound(tracked, node, {}, &Tracked::node);
    if (place == tracked.end() || place->node != node) return {};
    found.push_back(&*place);
  }
  return found;
}

/// Twice the distance of the farthest node from the middle of an end.
double width(const std::vector<Tracked*>& end, const std::vector<Vec3d>& x) {
  Vec3d middle;
  for (const Tracked* t : end) middle += (1.0 / static_cast<double>(end.size())) * x[t->node];
  double farthest = 0.0;
  for (const Tracked* t : end) farthest = std::max(farthest, norm(x[t->node] - middle));
  return 2.0 * farthest;
}

/// By part in reach: the sum of the nodes' distances; `wide` for a node that the part is out of reach of.
std::map<Index, double> distances(const Reference& reference, const std::vector<Tracked*>& end, double wide) {
  std::map<Index, double> sum;
  std::map<Index, int> count;
  for (const Tracked* t : end)
    for (const Candidate& c : reference.search(*t).within_tolerance) {
      sum[c.segment.part] += c.distance;
      ++count[c.segment.part];
    }
  for (auto& [part, distance] : sum) distance += wide * static_cast<double>(static_cast<int>(end.size()) - count[part]);
  return sum;
}

}  // namespace

void aim_clusters(const model::Model& model, const Reference& reference, const std::vector<Weld>& welds,
                  const std::vector<Vec3d>& x, std::vector<Tracked>& tracked) {
  for (const Weld& weld : welds) {
    if (!weld.of_bricks() || norm(weld.orientation) == 0.0) continue;
    std::array<std::vector<Tracked*>, 2> end;
    for (std::size_t k = 0; k < 2; ++k) end[k] = tracked_of(nodes_as_numbered(model, weld, k), tracked);
    if (end[0].empty() || end[1].empty()) continue;
    std::array<std::map<Index, double>, 2> of_part;
    for (std::size_t k = 0; k < 2; ++k) {
      const double wide = width(end[k], x);
      for (Tracked* t : end[k]) {
        t->aside = t->thickness;
        t->thickness = wide;
      }
      of_part[k] = distances(reference, end[k], wide);
    }
    double least = std::numeric_limits<double>::infinity();
    std::array<Index, 2> meant{none, none};
    for (const auto& [first, d] : of_part[0])
      for (const auto& [second, e] : of_part[1])
        if (first != second && d + e < least) {
          least = d + e;
          meant = {first, second};
        }
    for (std::size_t k = 0; k < 2; ++k)
      for (Tracked* t : end[k]) t->not_part = meant[1 - k];
  }
}

}  // namespace nugget::weld
