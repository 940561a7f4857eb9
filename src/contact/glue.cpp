// SPDX-License-Identifier: Apache-2.0
#include "contact/glue.hpp"

#include <algorithm>
#include <cmath>

#include "base/bvh.hpp"
#include "contact/surface_nodes.hpp"

namespace nugget::contact {
namespace {

constexpr double tolerance = 0.05;
constexpr unsigned reference = 2;  // bit of Segment::side

/// Unit axes of a segment: along its first pair of edges, across, and its normal.
struct Axes {
  Vec3d e1, e2, normal;
  Vec3d local(const Vec3d& a) const { return {dot(a, e1), dot(a, e2), dot(a, normal)}; }
  Vec3d global(const Vec3d& a) const { return a.x * e1 + a.y * e2 + a.z * normal; }
};

Axes axes_of(const Segment& s, std::span<const Row> x) {
  const kernel::Corners c = corners_of(s, x);
  Axes axes;
  axes.normal = kernel::detail::unit_or_zero(cross(c[2] - c[0], c[3] - c[1]));
  const Vec3d along = c[1] + c[2] - c[0] - c[3];
  axes.e1 = kernel::detail::unit_or_zero(along - dot(along, axes.normal) * axes.normal);
  axes.e2 = cross(axes.normal, axes.e1);
  return axes;
}

Vec3d point_of(const Segment& s, const std::array<double, 4>& weight, std::span<const Row> rows) {
  Vec3d sum;
  for (int c = 0; c < s.corners(); ++c) sum += weight[c] * vec(rows[s.node[c]]);
  return sum;
}

}  // namespace

Glue::Glue(const SurfaceContactSetup& setup, kernel::Cohesion law, std::span<const Row> x)
    : setup_(setup), law_(law), glued_(setup.nodes.size(), 0), forces_(surface_nodes(setup)) {
  const NodeSegments around(setup_.segments);
  std::vector<Box> boxes;
  for (const Segment& s : setup_.segments) {
    Box box;
    for (const Vec3d& c : corners_of(s, x)) box.add(c);
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  for (std::size_t t = 0; t < setup_.nodes.size(); ++t) {
    const TrackedNode& node = setup_.nodes[t];
    if (!(node.against & reference)) continue;
    const Vec3d p = vec(x[node.node]);
    const auto limit = [&](const Segment& s) {
      const double reach = 0.5 * (node.thickness + s.thickness);
      return reach + tolerance * (s.volume > 0.0 ? std::sqrt(area(s, x)) : reach);
    };
    const auto distance = [&](int item) {
      const Segment& s = setup_.segments[item];
      if (!(s.side & node.against) || s.has(node.node) || s.covered_by >= 0) return Box::infinity;
      const double d = kernel::closest_point(corners_of(s, x), s.triangle(), p).distance;
      return d <= limit(s) ? d : Box::infinity;
    };
    const BoxTree::Nearest nearest = tree.nearest(p, Box::infinity, distance);
    if (nearest.item < 0 || !std::isfinite(nearest.distance)) continue;
    Bond bond;
    bond.tracked = static_cast<int>(t);
    bond.node = node.node;
    bond.segment = setup_.segments[nearest.item];
    const kernel::Foot foot = kernel::closest_point(corners_of(bond.segment, x), bond.segment.triangle(), p);
    bond.weight = foot.weight;
    bond.place = axes_of(bond.segment, x).local(p - foot.point);
    bond.stiffness = setup_.stiffness_scale * penalty_stiffness(bond.segment, x);
    for (int s : around.at(node.node)) {
      const Segment& own = setup_.segments[s];
      if (own.covered_by < 0) bond.area += area(own, x) / own.corners();
    }
    const double whole = area(bond.segment, x);
    if (!(bond.area > 0.0)) bond.area = whole;
    // As stiff per area everywhere, so that surfaces that part evenly are stressed evenly.
    if (whole > 0.0) bond.stiffness *= bond.area / whole;
    if (law_.normal_stiffness > 0.0) bond.stiffness = law_.normal_stiffness * bond.area;
    glued_[t] = 1;
    bonds_.push_back(bond);
  }
}

void Glue::apply(const Step& step, std::span<Row> force) {
  forces_.next_cycle();
  resultant_ = {};
  for (Bond& bond : bonds_) {
    if (!bond.holds) continue;
    const Segment& s = bond.segment;
    std::array<double, 4> corner_mass{};
    for (int c = 0; c < s.corners(); ++c) corner_mass[c] = step.mass[s.node[c]];
    const double inverse_mass = kernel::inverse_pair_mass(step.mass[bond.node], bond.weight, corner_mass);
    // The stiffer of both directions is bounded, the other goes with it.
    const double stiffer = std::max(1.0, law_.shear_ratio);
    const double normal =
        kernel::pair_stiffness(setup_.law, stiffer * bond.stiffness, inverse_mass, step.bearable) / stiffer;
    const double shear = law_.shear_ratio * normal;
    const Axes axes = axes_of(s, step.x);
    const Vec3d stretch = axes.local(vec(step.x[bond.node]) - point_of(s, bond.weight, step.x)) - bond.place;
    const double outward = bond.place.z < 0.0 ? -stretch.z : stretch.z;
    const kernel::Opening opening{std::max(0.0, outward), std::hypot(stretch.x, stretch.y)};
    bond.damage = kernel::cohesive_damage(law_, normal / bond.area, shear / bond.area, opening, bond.damage);
    if (step.time >= setup_.death || !bare(s, step.element_alive) || bond.damage >= 1.0) {
      bond.holds = false;
      glued_[bond.tracked] = 0;
      ++failed_;
      continue;
    }
    const double left = 1.0 - bond.damage;
    const Vec3d pull{left * shear * stretch.x, left * shear * stretch.y,
                     (outward > 0.0 ? left : 1.0) * normal * stretch.z};  // of the node on the segment
    const Vec3d f = axes.global(pull);
    forces_.add(bond.node, -f);
    for (int c = 0; c < s.corners(); ++c) forces_.add(s.node[c], bond.weight[c] * f);
    resultant_ += s.side == 1 ? f : -f;
  }
  forces_.add_to(force);
  const std::array<double, 2> work = forces_.work(step.dt, step.v);
  for (int side = 0; side < 2; ++side) energy_[side] -= work[side];
}

}  // namespace nugget::contact
