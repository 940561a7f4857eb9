// SPDX-License-Identifier: Apache-2.0
#include "contact/glue.hpp"

#include <algorithm>
#include <cmath>

#include "base/bvh.hpp"
#include "base/index.hpp"
#include "contact/couple.hpp"
#include "contact/surface_nodes.hpp"

namespace nugget::contact {
namespace {

constexpr double tolerance = 0.05;
constexpr double in_the_middle = 1e-6;  // of the thickness: what round-off makes of no gap
constexpr double facing = 1e-6;         // weight of what a segment looks past a node, against its distance
constexpr double steep = 0.5;           // cosine between two segments below which one does not go on as the other
constexpr double on_edge = 0.1;         // share of the surface around a node below which it stands on edge
constexpr unsigned reference = 2;       // bit of Segment::side

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

/// Distance of a segment's foot for a choice: above the edge of a fold all its segments are as close, and the one that
/// faces the node is meant.
double facing_distance(const kernel::Foot& foot, const Vec3d& p) {
  return foot.distance + facing * (foot.distance - std::abs(dot(p - foot.point, foot.normal)));
}

/// Whether the surface ends at the edge between `from` and a neighbour of it for what lies on the side `outward` of
/// its normal (0: in the middle of a sheet): a side face of a brick, or what a sheet is folded back to, goes off it.
bool falls_off(const Segment& from, const Segment& to, double outward, std::span<const Row> x) {
  const Vec3d normal = axes_of(from, x).normal;
  const double cosine = dot(normal, axes_of(to, x).normal);
  if ((to.volume > 0.0 ? cosine : std::abs(cosine)) >= steep) return false;
  const auto middle = [x](const Segment& s) {
    const kernel::Corners c = corners_of(s, x);
    return 0.25 * (c[0] + c[1] + c[2] + c[3]);
  };
  return outward * dot(middle(to) - middle(from), normal) <= 0.0;
}

double shortest_diagonal(const Segment& s, std::span<const Row> x) {
  const kernel::Corners c = corners_of(s, x);
  return std::min(norm(c[2] - c[0]), norm(c[3] - c[1]));
}

}  // namespace

Glue::Glue(const SurfaceContactSetup& setup, model::Glue card, std::span<const Row> x)
    : setup_(setup),
      card_(std::move(card)),
      around_(setup_.segments),
      around_listed_(setup_.faces_at_nodes),
      bonded_(setup.nodes.size(), card_.alone ? 1 : 0),
      was_bonded_(setup.nodes.size(), 0),
      forces_(surface_nodes(setup), setup.law.friction.any()) {
  assign_sides(forces_, around_, setup_);
  for (const Segment& s : setup_.segments)
    segment_stiffness_.push_back(setup_.stiffness_scale * penalty_stiffness(s, x));
  set_kinds(setup_.nodes, around_, setup_.segments);
  waits_ = setup_.birth > 0.0;
  if (!waits_) glue_together(x, {});
  at_start_ = static_cast<int>(bonds_.size());
}

/// How far from a segment a node may stand that is glued to it.
double Glue::limit(const TrackedNode& node, const Segment& s, std::span<const Row> x) const {
  if (card_.reach > 0.0) return card_.reach;
  if (card_.without_thickness)
    return std::max(0.6 * (node.thickness + s.thickness), tolerance * shortest_diagonal(s, x));
  const double contact_distance = 0.5 * (node.thickness + s.thickness);
  return contact_distance + tolerance * (s.volume > 0.0 ? std::sqrt(area(s, x)) : contact_distance);
}

/// Whether all elements are deleted whose faces the node has.
bool Glue::stands_free(int node, std::span<const unsigned char> element_alive) const {
  const auto own = around_.at(node);
  return !own.empty() &&
         std::none_of(own.begin(), own.end(), [&](int s) { return is_exposed(setup_.segments[s], element_alive); });
}

void Glue::glue_together(std::span<const Row> x, std::span<const unsigned char> element_alive) {
  std::vector<Box> boxes;
  for (const Segment& s : setup_.segments) {
    Box box;
    for (const Vec3d& c : corners_of(s, x)) box.add(c);
    boxes.push_back(box);
  }
  const BoxTree tree(boxes);
  for (std::size_t t = 0; t < setup_.nodes.size(); ++t) {
    const TrackedNode& node = setup_.nodes[t];
    if (!(node.against & reference) || (!element_alive.empty() && stands_free(node.node, element_alive))) continue;
    const Vec3d p = vec(x[node.node]);
    const auto distance = [&](int item) {
      const Segment& s = setup_.segments[item];
      if (!(s.side & node.against) || s.has(node.node) || !is_exposed(s, element_alive)) return Box::infinity;
      const kernel::Foot foot = kernel::closest_point(corners_of(s, x), s.triangle(), p);
      if (foot.distance > limit(node, s, x)) return Box::infinity;
      return facing_distance(foot, p);
    };
    const BoxTree::Nearest nearest = tree.nearest(p, Box::infinity, distance);
    if (nearest.item < 0 || !std::isfinite(nearest.distance)) continue;
    const Segment& s = setup_.segments[nearest.item];
    bonded_[t] = was_bonded_[t] = 1;
    bonds_.push_back(
        bond(static_cast<int>(t), nearest.item, kernel::closest_point(corners_of(s, x), s.triangle(), p), x));
  }
}

/// The area of its own surface that a node stands for, as the segment sees it: along `normal`, from the side `outward`
/// (0: either). Faces of a brick that look elsewhere are no part of the joint: those around the rim of a glued block
/// would make it half as strong again. A sheet that stands on edge shows nothing; it has all that is around the node.
/// 0: no surface of its own.
double Glue::joined_area(int node, const Vec3d& normal, double outward, std::span<const Row> x) const {
  double all = 0.0, sheets = 0.0;
  std::array<double, 2> faces{};  // of bricks that look along the normal, and against it
  const auto own_faces = around_.at(node);
  const auto& of = own_faces.empty() ? setup_.faces_at_nodes : setup_.segments;
  for (const int s : own_faces.empty() ? around_listed_.at(node) : own_faces) {
    const Segment& own = of[s];
    if (own.covered_by >= 0) continue;
    const double share = area(own, x) / own.corners(), cosine = dot(axes_of(own, x).normal, normal);
    all += share;
    (own.volume == 0.0 ? sheets : faces[cosine < 0.0 ? 1 : 0]) += std::abs(cosine) * share;
  }
  const double towards = outward == 0.0 ? std::max(faces[0], faces[1]) : faces[outward > 0.0 ? 1 : 0];
  const double seen = sheets + towards;
  return seen > on_edge * all ? seen : all;
}

/// A bond that is without stress in this place.
Glue::Bond Glue::bond(int tracked, int segment, const kernel::Foot& foot, std::span<const Row> x) const {
  const Segment& s = setup_.segments[segment];
  Bond bond;
  bond.tracked = tracked;
  bond.segment = segment;
  bond.weight = foot.weight;
  const Axes axes = axes_of(s, x);
  bond.place = axes.local(vec(x[setup_.nodes[tracked].node]) - foot.point);
  bond.outward = s.volume == 0.0 && bond.place.z < 0.0 ? -1.0 : 1.0;
  if (s.volume == 0.0 && foot.distance <= in_the_middle * (setup_.nodes[tracked].thickness + s.thickness))
    bond.outward = 0.0;
  const double whole = area(s, x);
  const double own = joined_area(setup_.nodes[tracked].node, axes.normal, bond.outward, x);
  bond.area = own > 0.0 ? own : whole;
  bond.stiffness = segment_stiffness_[segment];
  // As stiff per area everywhere, so that surfaces that part evenly are stressed evenly.
  if (whole > 0.0) bond.stiffness *= bond.area / whole;
  if (card_.law.normal_stiffness > 0.0) bond.stiffness = card_.law.normal_stiffness * bond.area;
  if (card_.by_force) bond.area = 1.0;
  return bond;
}

/// Stability limit of the bond's stiffness, by area.
kernel::CohesiveStiffness Glue::stiffness(const Bond& bond, const Step& step) const {
  const Segment& s = setup_.segments[bond.segment];
  std::array<double, 4> corner_mass{};
  for (int c = 0; c < s.corners(); ++c) corner_mass[c] = step.mass[s.node[c]];
  const double inverse_mass =
      kernel::inverse_pair_mass(step.mass[setup_.nodes[bond.tracked].node], bond.weight, corner_mass);
  // The stiffer of both directions is bounded, the other goes with it.
  const double stiffer = std::max(1.0, card_.law.shear_ratio);
  const double normal =
      kernel::pair_stiffness(setup_.law, stiffer * bond.stiffness, inverse_mass, step.stable_dt) / stiffer;
  return {normal / bond.area, card_.law.shear_ratio * normal / bond.area};
}

/// Force of the node on the segment, of glue that holds in all directions.
Vec3d Glue::pull(Bond& bond, const kernel::CohesiveStiffness& k, const Step& step) const {
  const Segment& s = setup_.segments[bond.segment];
  const int node = setup_.nodes[bond.tracked].node;
  const Axes axes = axes_of(s, step.x);
  const Vec3d stretch = axes.local(vec(step.x[node]) - interpolate(s, bond.weight, step.x)) - bond.place;
  const double outward = bond.outward != 0.0 ? bond.outward : stretch.z < 0.0 ? -1.0 : 1.0;
  double rate = 0.0;
  if (card_.law.thickness > 0.0) {
    const Vec3d v = axes.local(vec(step.v[node]) - interpolate(s, bond.weight, step.v));
    rate = std::sqrt(v.z * v.z + 0.25 * (v.x * v.x + v.y * v.y)) / card_.law.thickness;
  }
  const Vec3d stress =
      kernel::cohesive_stress(card_.law, k, {stretch.x, stretch.y, outward * stretch.z}, rate, bond.state);
  return axes.global(bond.area * Vec3d{stress.x, stress.y, outward * stress.z});
}

/// The same of glue that slides: the foot goes to where the surface is closest now.
Vec3d Glue::sliding_pull(Bond& bond, const kernel::CohesiveStiffness& k, const Step& step) const {
  const TrackedNode& node = setup_.nodes[bond.tracked];
  const Vec3d p = vec(step.x[node.node]);
  const Segment& from = setup_.segments[bond.segment];
  const Vec3d was = interpolate(from, bond.weight, step.x);
  int to = -1;
  kernel::Foot foot;
  double closest = Box::infinity;
  for (int c = 0; c < from.corners(); ++c)
    for (int item : around_.at(from.node[c])) {
      const Segment& s = setup_.segments[item];
      if (!(s.side & reference) || s.has(node.node) || !is_exposed(s, step.element_alive)) continue;
      if (item != bond.segment && falls_off(from, s, bond.outward, step.x)) continue;
      const kernel::Foot other = kernel::closest_point(corners_of(s, step.x), s.triangle(), p);
      const double distance = facing_distance(other, p);
      // Of two that are as close, over an edge that they share, the one where it is stays.
      if (to >= 0 && (distance > closest || (distance == closest && item != bond.segment))) continue;
      to = item;
      foot = other;
      closest = distance;
    }
  if (to < 0) {
    bond.state.damage = 1.0;
    return {};
  }
  const Segment& s = setup_.segments[to];
  if (to != bond.segment && same_side(from, s) < 0) {
    bond.outward = -bond.outward;
    bond.place.z = -bond.place.z;
  }
  bond.segment = to;
  bond.weight = foot.weight;
  const Vec3d r = p - foot.point;
  const double height = dot(r, foot.normal);
  if (norm(r - height * foot.normal) > limit(node, s, step.x)) {
    bond.state.damage = 1.0;
    return {};
  }
  const double stretch = height - bond.place.z;
  const double outward = bond.outward != 0.0 ? bond.outward : stretch < 0.0 ? -1.0 : 1.0;
  const double stress = kernel::cohesive_stress(card_.law, k, {0.0, 0.0, outward * stretch}, 0.0, bond.state).z;

  const auto along = [&foot](const Vec3d& a) { return a - dot(a, foot.normal) * foot.normal; };
  const Vec3d slip = along(foot.point - was);
  double bound = card_.slip_stress * bond.area;
  if (!(bound > 0.0)) {
    const kernel::Friction& law = setup_.law.friction.between(s.kind, node.kind);
    const double speed = step.dt > 0.0 ? norm(slip) / step.dt : 0.0;
    bound = law.bound(std::max(0.0, -stress) * bond.area, speed, bond.area);
  }
  bond.friction = kernel::sliding_spring(along(bond.friction), k.shear * bond.area, slip, bound);
  return bond.area * outward * stress * foot.normal - bond.friction;
}

void Glue::release(Bond& bond, double time) {
  bond.intact = false;
  if (!card_.alone) bonded_[bond.tracked] = 0;
  if (failed_ == 0) {
    first_node_ = setup_.nodes[bond.tracked].node;
    first_time_ = time;
  }
  last_time_ = time;
  ++failed_;
}

void Glue::apply(const Step& step, std::span<Row> force) {
  forces_.next_cycle();
  resultant_ = {};
  if (waits_ && step.time >= setup_.birth) {
    glue_together(step.x, step.element_alive);
    waits_ = false;
  }
  for (Bond& bond : bonds_) {
    bond.force = {};
    if (!bond.intact) continue;
    const kernel::CohesiveStiffness k = stiffness(bond, step);
    const Vec3d f = card_.slides ? sliding_pull(bond, k, step) : pull(bond, k, step);
    const bool ends = step.time >= setup_.death || !is_exposed(setup_.segments[bond.segment], step.element_alive);
    if (ends || bond.state.damage >= 1.0) {
      release(bond, step.time);
      continue;
    }
    bond.force = -f;
    spread(bond, step.x);
    resultant_ += setup_.segments[bond.segment].side == 1 ? f : -f;
  }
  forces_.add_to(force);
  forces_.book_work(step.dt, step.v);
}

/// The force on the bond's node, and back on its segment.
void Glue::spread(const Bond& bond, std::span<const Row> x) {
  const Segment& s = setup_.segments[bond.segment];
  const int node = setup_.nodes[bond.tracked].node;
  forces_.add(node, bond.force, bond.friction);
  for (int c = 0; c < s.corners(); ++c)
    forces_.add(s.node[c], -bond.weight[c] * bond.force, -bond.weight[c] * bond.friction);
  if (!card_.moments) return;
  const Vec3d lever = vec(x[node]) - interpolate(s, bond.weight, x);
  const auto back = [&](const Vec3d& force) {
    return couple({s.node.data(), at(s.corners())}, -cross(lever, force), x);
  };
  const std::array<Vec3d, 4> force = back(bond.force), friction = back(bond.friction);
  for (int c = 0; c < s.corners(); ++c) forces_.add(s.node[c], force[c], friction[c]);
}

void Glue::bond_touching(const SurfaceContact& surface, const Step& step) {
  if (!card_.bonds_later) return;
  surface.each_hit([this, &step](const SurfaceContact::Hit& hit) {
    const TrackedNode& node = setup_.nodes[hit.tracked];
    const Segment& s = setup_.segments[hit.segment];
    if (was_bonded_[hit.tracked] || !(node.against & reference) || !(s.side & reference)) return;
    kernel::Foot foot;
    foot.weight = hit.weight;
    foot.point = interpolate(s, hit.weight, step.x);
    Bond made = bond(hit.tracked, hit.segment, foot, step.x);
    // Pressed from the start with the force that presses it now.
    const double normal = made.area * stiffness(made, step).tension;
    const double pressure = dot(hit.force, made.outward * axes_of(s, step.x).normal);
    if (normal > 0.0) made.place.z += made.outward * std::max(0.0, pressure) / normal;
    bonded_[hit.tracked] = was_bonded_[hit.tracked] = 1;
    bonds_.push_back(made);
  });
}

Vec3d Glue::force_between(const TwoBodies& bodies) const {
  Vec3d sum;
  for (const Bond& bond : bonds_)
    sum += bodies.sign({&setup_.nodes[bond.tracked].node, 1}, setup_.segments[bond.segment].node) * bond.force;
  return sum;
}

void Glue::archive(Archive& a) {
  a.section("glue");
  a(bonds_, bonded_, was_bonded_, forces_, resultant_, failed_, first_node_, first_time_, last_time_, waits_);
  a.built(setup_, card_, around_, around_listed_, segment_stiffness_, at_start_);
}

}  // namespace nugget::contact
