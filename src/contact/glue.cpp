// SPDX-License-Identifier: Apache-2.0
#include "contact/glue.hpp"

#include <algorithm>
#include <cmath>

#include "base/bvh.hpp"

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

std::vector<int> nodes_of_surface(const SurfaceContactSetup& setup) {
  std::vector<int> nodes;
  for (const Segment& s : setup.segments) nodes.insert(nodes.end(), s.node.begin(), s.node.end());
  for (const TrackedNode& t : setup.nodes) nodes.push_back(t.node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace

double GlueStrength::failure(double tension, double shear_stress) const {
  double sum = 0.0;
  if (normal > 0.0 && tension > 0.0) sum += (tension / normal) * (tension / normal);
  if (shear > 0.0) sum += (shear_stress / shear) * (shear_stress / shear);
  return sum;
}

Glue::Glue(const SurfaceContactSetup& setup, GlueStrength strength, std::span<const Row> x)
    : setup_(setup), strength_(strength), glued_(setup.nodes.size(), 0), forces_(nodes_of_surface(setup)) {
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
    glued_[t] = 1;
    bonds_.push_back(bond);
  }
}

void Glue::apply(double time, double dt, std::span<const Row> x, std::span<const Row> v, std::span<const double> mass,
                 std::span<const unsigned char> element_alive, std::span<Row> force) {
  forces_.next_cycle();
  resultant_ = {};
  for (Bond& bond : bonds_) {
    if (!bond.holds) continue;
    const Segment& s = bond.segment;
    std::array<double, 4> corner_mass{};
    for (int c = 0; c < s.corners(); ++c) corner_mass[c] = mass[s.node[c]];
    const double inverse_mass = kernel::inverse_pair_mass(mass[bond.node], bond.weight, corner_mass);
    const double stiffness = kernel::pair_stiffness(setup_.law, bond.stiffness, inverse_mass, dt);
    const Axes axes = axes_of(s, x);
    const Vec3d stretch = axes.local(vec(x[bond.node]) - point_of(s, bond.weight, x)) - bond.place;
    const Vec3d pull = stiffness * stretch;  // of the node on the segment
    const double outward = bond.place.z < 0.0 ? -pull.z : pull.z;
    const double tension = outward / bond.area, shear = std::hypot(pull.x, pull.y) / bond.area;
    if (time >= setup_.death || !bare(s, element_alive) || strength_.failure(tension, shear) >= 1.0) {
      bond.holds = false;
      glued_[bond.tracked] = 0;
      ++failed_;
      continue;
    }
    const Vec3d f = axes.global(pull);
    forces_.add(bond.node, -f);
    for (int c = 0; c < s.corners(); ++c) forces_.add(s.node[c], bond.weight[c] * f);
    resultant_ += s.side == 1 ? f : -f;
  }
  forces_.add_to(force);
  const std::array<double, 2> work = forces_.work(dt, v);
  for (int side = 0; side < 2; ++side) energy_[side] -= work[side];
}

}  // namespace nugget::contact
