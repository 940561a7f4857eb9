// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_part.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "base/bvh.hpp"
#include "base/index.hpp"

namespace nugget::contact {
namespace {

double along(const Row& r, int axis) {
  return std::array{r.x, r.y, r.z}[at(axis)];
}

int longest_side(const Box& box) {
  const Vec3d side = box.high - box.low;
  if (side.x >= side.y && side.x >= side.z) return 0;
  return side.y >= side.z ? 1 : 2;
}

/// Places in `nodes` of those of a part, rising: halves across the longest side of their box, and of the halves again.
std::vector<int> tracked_of_part(const std::vector<TrackedNode>& nodes, std::span<const Row> x, int part, int parts) {
  std::vector<int> own(nodes.size());
  std::iota(own.begin(), own.end(), 0);
  auto begin = own.begin(), end = own.end();
  while (parts > 1) {
    Box box;
    for (auto t = begin; t != end; ++t) box.add(vec(x[nodes[*t].node]));
    const int axis = longest_side(box), lower = parts / 2;
    const auto middle = begin + (end - begin) * lower / parts;
    std::nth_element(begin, middle, end, [&](int a, int b) {
      return std::tuple(along(x[nodes[a].node], axis), a) < std::tuple(along(x[nodes[b].node], axis), b);
    });
    if (part < lower) {
      end = middle;
      parts = lower;
    } else {
      begin = middle;
      part -= lower;
      parts -= lower;
    }
  }
  std::sort(begin, end);
  return {begin, end};
}

/// How far from its corners a segment presses, into the whole brick behind it [length].
double reach_of(const Segment& s, std::span<const Row> x) {
  const double a = area(s, x);
  return 0.5 * s.thickness + (s.volume > 0.0 && a > 0.0 ? s.volume / a : 0.0);
}

}  // namespace

SurfaceContactSetup part_of(const SurfaceContactSetup& whole, std::span<const Row> x, int part, int parts,
                            double room) {
  SurfaceContactSetup own;
  own.stiffness_scale = whole.stiffness_scale;
  own.law = whole.law;
  own.deepest = whole.deepest;
  own.edges_meet = whole.edges_meet;
  own.places = whole.places;
  own.birth = whole.birth;
  own.death = whole.death;
  own.margin = search_margin(whole, x);

  Box region;
  double thickest_node = 0.0;
  for (const int t : tracked_of_part(whole.nodes, x, part, parts)) {
    own.nodes.push_back(whole.nodes[t]);
    region.add(vec(x[own.nodes.back().node]));
    thickest_node = std::max(thickest_node, own.nodes.back().thickness);
  }
  if (own.nodes.empty()) return own;
  region = region.grown(0.5 * thickest_node + own.margin + 2.0 * room);

  std::vector<char> near;  // by node: a segment within reach has it
  const auto mark = [&near](int n) {
    if (at(n) >= near.size()) near.resize(std::max(at(n) + 1, 2 * near.size()), 0);
    near[n] = 1;
  };
  for (const TrackedNode& t : own.nodes) mark(t.node);
  for (const Segment& s : whole.segments) {
    Box box;
    for (const Vec3d& c : corners_of(s, x)) box.add(c);
    if (box.grown(reach_of(s, x)).overlaps(region)) std::ranges::for_each(s.node, mark);
  }
  const auto is_near = [&near](int n) { return at(n) < near.size() && near[n] != 0; };
  for (const Segment& s : whole.segments)
    if (std::ranges::any_of(s.node, is_near)) own.segments.push_back(s);
  return own;
}

}  // namespace nugget::contact
