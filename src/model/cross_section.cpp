// SPDX-License-Identifier: Apache-2.0
#include "model/cross_section.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/index.hpp"
#include "model/model.hpp"

namespace nugget::model {
namespace {

using Corner = CrossSection::Corner;
using Facet = CrossSection::Facet;

Vec3d place(const std::vector<Vec3d>& x, const Corner& c) {
  const Vec3d &a = x[c.from], &b = x[c.to];
  return a + c.share * (b - a);
}

/// Brings the corners of a plane polygon into their order around it.
void go_around(const std::vector<Vec3d>& x, std::vector<Corner>& corners) {
  Vec3d centre{};
  for (const Corner& c : corners) centre += (1.0 / static_cast<double>(corners.size())) * place(x, c);
  const Vec3d first = place(x, corners[0]) - centre;
  Vec3d normal{};
  for (const Corner& c : corners) {
    const Vec3d n = cross(first, place(x, c) - centre);
    if (norm(n) > norm(normal)) normal = n;
  }
  const Vec3d across = cross(normal, first);
  // Both components are scaled alike up to the length of `normal`, which the angle must not depend on.
  const double scale = norm(normal) > 0.0 ? norm(normal) : 1.0;
  const auto angle = [&](const Corner& c) {
    const Vec3d arm = place(x, c) - centre;
    return std::atan2(dot(arm, across) / scale, dot(arm, first));
  };
  std::stable_sort(corners.begin(), corners.end(),
                   [&](const Corner& a, const Corner& b) { return angle(a) < angle(b); });
}

/// The two corners of a shell's section that lie farthest apart.
void keep_ends(const std::vector<Vec3d>& x, std::vector<Corner>& corners) {
  double longest = -1.0;
  std::pair<Corner, Corner> ends;
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const double length = norm(place(x, corners[j]) - place(x, corners[i]));
      if (length > longest) longest = length, ends = {corners[i], corners[j]};
    }
  corners = {ends.first, ends.second};
}

Facet facet(const std::vector<Vec3d>& x, ElementKind kind, Index element, std::vector<Corner> corners) {
  const std::size_t fewest = kind == ElementKind::solid ? 3 : kind == ElementKind::shell ? 2 : 1;
  if (corners.size() < fewest) return {kind, element, {}};
  if (kind == ElementKind::solid) go_around(x, corners);
  if (kind == ElementKind::shell && corners.size() > 2) keep_ends(x, corners);
  if (kind == ElementKind::beam) corners.resize(1);
  return {kind, element, std::move(corners)};
}

/// Nodes of an element, each once, in their order.
std::vector<Index> nodes_of(const Model& model, ElementKind kind, Index element) {
  const auto e = at(element);
  std::span<const Index> all;
  if (kind == ElementKind::shell)
    all = model.shells.node[e];
  else if (kind == ElementKind::solid)
    all = model.solids.nodes(e);
  else
    all = model.beams.node[e];
  std::vector<Index> nodes;
  for (const Index n : all)
    if (std::find(nodes.begin(), nodes.end(), n) == nodes.end()) nodes.push_back(n);
  return nodes;
}

/// Edges of an element as places in its list of corners. A tetrahedron has its own: of n1 n2 n3 n4 n4 n4 n4 n4 taken as
/// a brick, the one between n1 and n3 is missing.
std::span<const std::array<int, 2>> edges_of(ElementKind kind, std::size_t corners) {
  static constexpr std::array<int, 2> beam[] = {{0, 1}}, shell[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                                      solid[] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                                 {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}},
                                      tetrahedron[] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  if (kind == ElementKind::shell) return shell;
  if (kind == ElementKind::solid && corners == 4) return tetrahedron;
  if (kind == ElementKind::solid) return solid;
  return beam;
}

/// The nodes between which `edges_of` are: those of the card, of a tetrahedron its four corners.
std::vector<Index> edge_nodes(const Model& model, ElementKind kind, std::size_t e) {
  const auto all = [](const auto& nodes) { return std::vector<Index>(nodes.begin(), nodes.end()); };
  if (kind == ElementKind::shell) return all(model.shells.node[e]);
  if (kind == ElementKind::beam) return all(model.beams.node[e]);
  std::vector<Index> corners = model.solids.corners(e);
  return corners.size() == 4 ? corners : all(model.solids.node[e]);
}

/// Where the plane cuts the edges of an element, each edge once; `height` is by node, over the plane.
template <class Height>
std::vector<Corner> cut_edges(ElementKind kind, const std::vector<Index>& nodes, const Height& height) {
  std::vector<Corner> corners;
  for (const auto& [i, j] : edges_of(kind, nodes.size())) {
    Index a = nodes[i], b = nodes[j];
    if (a > b) std::swap(a, b);
    const double ha = height(a), hb = height(b);
    if ((ha >= 0.0) == (hb >= 0.0)) continue;
    const bool known =
        std::any_of(corners.begin(), corners.end(), [a, b](const Corner& c) { return c.from == a && c.to == b; });
    if (!known) corners.push_back({a, b, ha / (ha - hb)});
  }
  return corners;
}

bool inside(const CuttingPlane& plane, const Vec3d& x) {
  const Vec3d d = x - plane.origin;
  const double l = dot(d, plane.edge_l), m = dot(d, plane.edge_m);
  const auto within = [](double value, double length) {
    return length == 0.0 || (value >= -1e-9 * length && value <= (1.0 + 1e-9) * length);
  };
  return within(l, plane.length_l) && within(m, plane.length_m) &&
         (plane.radius == 0.0 || norm(d) <= (1.0 + 1e-9) * plane.radius);
}

}  // namespace

std::vector<CrossSection::Facet> facets_between(const Model& model, ElementKind kind,
                                                const std::vector<Index>& elements, const std::vector<char>& marked) {
  std::vector<Facet> facets;
  for (const Index element : elements) {
    std::vector<Corner> corners;
    for (const Index n : nodes_of(model, kind, element))
      if (marked[n]) corners.push_back({n, n, 0.0});
    facets.push_back(facet(model.nodes.x, kind, element, std::move(corners)));
  }
  return facets;
}

void cut(const Model& model, const std::vector<Vec3d>& x, CrossSection& section) {
  constexpr double round_off = 1e-10;  // of coordinates, once nodes have been projected
  const CuttingPlane& plane = *section.plane;
  std::vector<char> cuts(model.parts.size(), 0);
  for (const Index p : section.parts) cuts[p] = 1;
  const auto height = [&](Index n) {
    const double h = dot(x[n] - plane.origin, plane.normal);
    return std::abs(h) <= round_off * (norm(x[n]) + norm(plane.origin)) ? 0.0 : h;
  };
  section.nodes.clear();
  section.facets.clear();
  const auto go_through = [&](ElementKind kind, const auto& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (!cuts[elements.part[e]]) continue;
      std::vector<Corner> corners = cut_edges(kind, edge_nodes(model, kind, e), height);
      if (corners.empty() ||
          !std::all_of(corners.begin(), corners.end(), [&](const Corner& c) { return inside(plane, place(x, c)); }))
        continue;
      for (const Index n : elements.nodes(e))
        if (height(n) >= 0.0) section.nodes.push_back(n);
      section.facets.push_back(facet(x, kind, static_cast<Index>(e), std::move(corners)));
    }
  };
  go_through(ElementKind::shell, model.shells);
  go_through(ElementKind::solid, model.solids);
  go_through(ElementKind::beam, model.beams);
  std::sort(section.nodes.begin(), section.nodes.end());
  section.nodes.erase(std::unique(section.nodes.begin(), section.nodes.end()), section.nodes.end());
}

std::vector<Index> bricks_of(const Model& model, const CrossSection& section, const std::vector<Index>& parts) {
  std::vector<Index> bricks;
  for (const Facet& facet : section.facets) {
    if (facet.kind != ElementKind::solid) continue;
    const Index part = model.solids.part[facet.element];
    if (parts.empty() || std::find(parts.begin(), parts.end(), part) != parts.end()) bricks.push_back(facet.element);
  }
  return bricks;
}

}  // namespace nugget::model
