// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/brick_section.hpp"

#include <algorithm>
#include <cmath>

#include "base/axis_across.hpp"

namespace nugget::weld {
namespace {

Vec3d across(const Vec3d& r, const Vec3d& a) {
  return a - dot(a, r) * r;
}

}  // namespace

BrickSection::BrickSection(const Weld& weld, const std::vector<Vec3d>& x) {
  for (std::size_t end = 0; end < 2; ++end) {
    nodes_.insert(nodes_.end(), weld.face[end].begin(), weld.face[end].end());
    if (end == 0) of_first_face_ = nodes_.size();
    for (const Facet& facet : weld.facets[end]) {
      std::array<std::size_t, 4>& corners = facets_[end].emplace_back();
      for (std::size_t i = 0; i < 4; ++i)
        corners[i] = static_cast<std::size_t>(std::find(nodes_.begin(), nodes_.end(), facet[i]) - nodes_.begin());
    }
  }
  if (weld.kind != Weld::Kind::assembly) return;
  std::vector<Vec3d> start;
  for (Index n : nodes_) start.push_back(x[n]);
  const Frame3d edges = shape(start).axes;
  const bool given = norm(across(edges.e1, weld.orientation)) > 0.0;
  const Vec3d s = unit(across(edges.e1, given ? weld.orientation : global_axis_across(edges.e1)));
  cosine_ = dot(s, edges.e2);
  sine_ = dot(s, edges.e3);
}

Frame3d BrickSection::frame(const Vec3d& r, std::span<const Vec3d> x) const {
  Vec3d along;
  for (const auto& facets : facets_) {
    const std::array<std::size_t, 4>& c = facets.front();
    along += (x[c[1]] - x[c[0]]) + (x[c[2]] - x[c[3]]);
  }
  const Vec3d edge = unit(across(r, along)), other = cross(r, edge), s = cosine_ * edge + sine_ * other;
  return {r, s, cross(r, s)};
}

BrickSection::Shape BrickSection::shape(std::span<const Vec3d> x) const {
  Shape shape;
  std::array<Vec3d, 2> normal;
  for (std::size_t end = 0; end < 2; ++end)
    for (const auto& c : facets_[end]) normal[end] += 0.5 * cross(x[c[2]] - x[c[0]], x[c[3]] - x[c[1]]);
  const Vec3d both = normal[0] + normal[1];
  const Vec3d r = unit(both);
  shape.axes = frame(r, x);
  shape.area = 0.5 * norm(both);
  for (std::size_t end = 0; end < 2; ++end) {
    double sum = 0.0;
    Vec3d corners;
    // Cut along both diagonals, so that the centre of a warped face does not depend on where its numbering begins.
    for (const auto& c : facets_[end])
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t i = c[k], j = c[(k + 1) % 4], l = c[(k + 2) % 4];
        const double area = dot(r, cross(x[j] - x[i], x[l] - x[i]));
        shape.centre[end] += (area / 3.0) * (x[i] + x[j] + x[l]);
        sum += area;
      }
    for (const auto& c : facets_[end])
      for (const std::size_t i : c) corners += x[i];
    // A brick turned inside out may have an end without area.
    shape.centre[end] =
        sum > 0.0 ? (1.0 / sum) * shape.centre[end] : (0.25 / static_cast<double>(facets_[end].size())) * corners;
  }
  shape.length = dot(shape.centre[1] - shape.centre[0], r);
  return shape;
}

BrickSection::Load BrickSection::load(const Shape& shape, std::span<const Vec3d> x,
                                      std::span<const Vec3d> force) const {
  const Vec3d middle = 0.5 * (shape.centre[0] + shape.centre[1]);
  Vec3d through, moment;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3d f = (i < of_first_face_ ? -0.5 : 0.5) * force[i];
    through += f;
    moment += cross(x[i] - middle, f);
  }
  const Vec3d n = shape.axes.local(through), m = shape.axes.local(moment);
  const Vec3d couple{0.0, -0.5 * shape.length * n.z, 0.5 * shape.length * n.y};  // L/2 r x N
  return {{n.x, n.y, n.z, m.x, m.y, m.z}, {m + couple, m - couple}};
}

}  // namespace nugget::weld
