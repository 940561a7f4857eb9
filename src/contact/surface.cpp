// SPDX-License-Identifier: Apache-2.0
#include "contact/surface.hpp"

#include <algorithm>

#include "kernel/contact/penalty.hpp"

namespace nugget::contact {
namespace {

int highest_node(const std::vector<Segment>& segments) {
  int highest = -1;
  for (const Segment& s : segments) highest = std::max(highest, *std::max_element(s.node.begin(), s.node.end()));
  return highest;
}

}  // namespace

NodeSegments::NodeSegments(const std::vector<Segment>& segments) : first_(highest_node(segments) + 2, 0) {
  for (const Segment& s : segments)
    for (int c = 0; c < s.corners(); ++c) ++first_[s.node[c] + 1];
  for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
  segment_.resize(first_.back());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (int c = 0; c < segments[s].corners(); ++c) segment_[next[segments[s].node[c]]++] = static_cast<int>(s);
}

std::vector<TrackedNode> nodes_of(const std::vector<Segment>& segments, unsigned side, unsigned against) {
  const NodeSegments around(segments);
  std::vector<TrackedNode> tracked;
  const int last = highest_node(segments);
  for (int n = 0; n <= last; ++n) {
    double sum = 0.0;
    int count = 0;
    for (int s : around.at(n)) {
      if (!(segments[s].side & side)) continue;
      sum += segments[s].thickness;
      ++count;
    }
    if (count > 0) tracked.push_back({n, sum / count, against});
  }
  return tracked;
}

kernel::Corners corners_of(const Facet& s, std::span<const Row> x) {
  return {vec(x[s.node[0]]), vec(x[s.node[1]]), vec(x[s.node[2]]), vec(x[s.node[3]])};
}

double area(const Facet& facet, std::span<const Row> x) {
  const kernel::Corners c = corners_of(facet, x);
  return 0.5 * norm(cross(c[2] - c[0], c[3] - c[1]));
}

int commonest(std::span<int> kinds) {
  std::sort(kinds.begin(), kinds.end());
  int best = 0;
  std::ptrdiff_t most = 0;
  for (auto first = kinds.begin(); first != kinds.end();) {
    const auto last = std::upper_bound(first, kinds.end(), *first);
    if (last - first > most) {
      most = last - first;
      best = *first;
    }
    first = last;
  }
  return best;
}

double penalty_stiffness(const Segment& segment, std::span<const Row> x) {
  const double a = area(segment, x);
  if (!(a > 0.0)) return 0.0;
  if (segment.volume > 0.0) return kernel::solid_penalty(segment.bulk_modulus, a, segment.volume);
  const kernel::Corners c = corners_of(segment, x);
  double longest = std::max(norm(c[2] - c[0]), norm(c[3] - c[1]));
  if (segment.triangle()) longest = std::max(longest, norm(c[1] - c[0]));
  return kernel::shell_penalty(segment.bulk_modulus, a, longest);
}

int same_side(const Facet& a, const Facet& b) {
  for (int i = 0; i < a.corners(); ++i) {
    const int from = a.node[i], to = a.node[(i + 1) % a.corners()];
    for (int j = 0; j < b.corners(); ++j) {
      const int other_from = b.node[j], other_to = b.node[(j + 1) % b.corners()];
      if (from == other_to && to == other_from) return 1;
      if (from == other_from && to == other_to) return -1;
    }
  }
  return 0;
}

void set_kinds(std::vector<TrackedNode>& nodes, const NodeSegments& around, const std::vector<Segment>& segments) {
  std::vector<int> kinds;
  for (TrackedNode& node : nodes) {
    kinds.clear();
    for (const int s : around.at(node.node)) kinds.push_back(segments[s].kind);
    if (!kinds.empty()) node.kind = commonest(kinds);
  }
}

}  // namespace nugget::contact
