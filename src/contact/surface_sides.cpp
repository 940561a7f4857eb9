// SPDX-License-Identifier: Apache-2.0
// Which of the segments near a node press it, and from which side.
#include <algorithm>
#include <cmath>

#include "contact/edge_contact.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"

namespace nugget::contact {
namespace {

constexpr double extension = 0.025;   // of a brick's face beyond its border, in sides
constexpr double level = 0.1;         // sine below which the way from an edge to a node lies in the face
constexpr double clearly_more = 0.5;  // between the cosines of two faces, or between that of one and 0
constexpr double on_the_face = 1e-6;  // of the depth down to which a brick presses: what round-off makes of 0

/// Changes the weights of the corners as little as can be so that their point moves by `way`, in the plane with
/// `normal`.
void shift(std::array<double, 4>& weight, const Facet& segment, const Vec3d& way, const Vec3d& normal,
           std::span<const Row> x) {
  const int corners = segment.corners();
  Vec3d middle;
  for (int c = 0; c < corners; ++c) middle += (1.0 / corners) * vec(x[segment.node[c]]);
  const double length = norm(way);
  if (!(length > 0.0)) return;
  const Vec3d e = (1.0 / length) * way, f = cross(normal, e);
  double ee = 0.0, ef = 0.0, ff = 0.0;
  for (int c = 0; c < corners; ++c) {
    const Vec3d r = vec(x[segment.node[c]]) - middle;
    ee += dot(r, e) * dot(r, e);
    ef += dot(r, e) * dot(r, f);
    ff += dot(r, f) * dot(r, f);
  }
  const double determinant = ee * ff - ef * ef;
  if (!(determinant > 0.0)) return;
  const Vec3d slope = (length / determinant) * (ff * e - ef * f);
  for (int c = 0; c < corners; ++c) weight[c] += dot(slope, vec(x[segment.node[c]]) - middle);
}

bool share_a_node(const Facet& a, const Facet& b) {
  return shared_corners(a, b) != 0;
}

/// Whether a node is one of the corners that `boundary` names.
bool has_boundary_at(const Facet& segment, unsigned boundary, int node) {
  for (int c = 0; c < segment.corners(); ++c)
    if ((boundary >> c & 1u) && segment.node[c] == node) return true;
  return false;
}

}  // namespace

/// A node that is pressed stays so through the whole brick, and behind the mid-surface of a sheet, as long as it is
/// over a face of that surface; one that was not is pressed down to `inner_` alone.
void SurfaceContact::stay_inside(Candidates candidates, int node, const Step& step) const {
  const Vec3d p = vec(step.x[node]);
  for (Candidate& c : candidates) {
    if (c.foot.boundary != 0 || c.gap <= 0.0) continue;
    const Candidate* from = c.before.touching ? &c : predecessor(candidates, c);
    if (from == nullptr || !from->before.pressed_inside()) continue;
    if (faces_[c.segment].inner > 0.0) {
      // Not one that was run over and came in from the side.
      if (around_.at(node).empty() || faces(node, c.foot.normal, step) < -clearly_more)
        measure_inside_brick(c, faces_[c.segment].inner / pressing_depth, p, step);
    } else if (const double beyond = -remembered_side(c, from) * dot(p - c.foot.point, c.foot.normal);
               beyond > 0.0 && beyond < std::sqrt(area(faces_[c.segment], step.x))) {
      c.gap = 0.0;
    }
  }
}

/// Nodes that were pressed inside and left the face over an edge or a corner. There the face goes on as one that is
/// round, with a centre below the edge: what the spring holds comes back as the node goes over it. Only for those that
/// were pressed: what comes from the side finds no round edge beside the brick.
void SurfaceContact::go_over_edges(Candidates candidates, int node, const Step& step) const {
  const Vec3d p = vec(step.x[node]);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    Candidate& left = candidates[i];
    if (left.foot.boundary == 0 || !left.before.pressed_inside() || !round_edge(left, left.before.side, p, step))
      continue;
    // Along the edge the next face has it.
    const Face& segment = faces_[left.segment];
    for (Candidate& next : candidates)
      if (!next.before.touching && (faces_[next.segment].inner > 0.0) == (faces_[left.segment].inner > 0.0) &&
          share_a_node(faces_[next.segment], segment) && std::abs(dot(next.foot.normal, left.foot.normal)) > 0.5)
        round_edge(next, dot(next.foot.normal, left.foot.normal) > 0.0 ? left.before.side : -left.before.side, p, step);
  }
}

/// Makes the gap and the way out of a node that is beyond an edge of the surface those from a round edge; whether it is
/// beyond. `side`: of the face on which the node belongs. The force on the face acts where its line meets the plane of
/// the face.
bool SurfaceContact::round_edge(Candidate& candidate, int side, const Vec3d& p, const Step& step) const {
  if ((candidate.gap < 0.0 && !candidate.extended) || candidate.foot.boundary == 0 || side == 0) return false;
  const Face& segment = faces_[candidate.segment];
  const double inner = faces_[candidate.segment].inner, size = std::sqrt(area(segment, step.x));
  const double radius = inner > 0.0 ? inner / pressing_depth : size;
  const Vec3d r = p - candidate.foot.point, out = static_cast<double>(side) * candidate.foot.normal;
  const Vec3d from_centre = r + radius * out;
  const double distance = norm(from_centre), up = dot(from_centre, out);
  if (!(up > 0.0) || !is_beyond(candidate, r, step)) return false;
  const Vec3d way = (radius / up) * (from_centre - up * out);
  const double longest = 0.5 * size, length = norm(way);
  candidate.foot.weight = kernel::shape_functions(segment.triangle(), candidate.foot.xi, candidate.foot.eta);
  shift(candidate.foot.weight, segment, (length > longest ? longest / length : 1.0) * way, candidate.foot.normal,
        step.x);
  candidate.over_an_edge = true;
  candidate.gap = distance - radius;
  candidate.away = (1.0 / distance) * from_centre;
  return true;
}

/// Whether the way `r` from the foot leads beyond the surface: in front of another face of the brick that is not much
/// the same, or off the end of a sheet.
bool SurfaceContact::is_beyond(const Candidate& candidate, const Vec3d& r, const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  const int corners = segment.corners();
  const auto in_front_of = [&](int s) {
    const Face& other = faces_[s];
    if (!has_boundary(other, segment, candidate.foot.boundary) || !alive(s, step.element_alive)) return false;
    const kernel::Corners k = corners_of(other, step.x);
    const Vec3d n = cross(k[2] - k[0], k[3] - k[1]);
    return dot(n, candidate.foot.normal) <= 0.5 * norm(n) && dot(r, n) > 0.0;
  };
  for (int c = 0; c < corners; ++c) {
    if (!(candidate.foot.boundary >> c & 1u)) continue;
    const std::span<const int> around = around_.at(segment.node[c]);
    if (segment.of_brick) {
      if (std::any_of(around.begin(), around.end(), in_front_of)) return true;
      continue;
    }
    const int next = (c + 1) % corners, last = (c + corners - 1) % corners;
    const bool corner = candidate.foot.boundary == 1u << c;
    if ((corner || candidate.foot.boundary >> next & 1u) && is_free_edge(segment, c, step)) return true;
    if (corner && is_free_edge(segment, last, step)) return true;
  }
  return false;
}

/// Whether the edge of a shell from a corner to the next is on no other one.
bool SurfaceContact::is_free_edge(const Facet& segment, int corner, const Step& step) const {
  const int end = segment.node[(corner + 1) % segment.corners()];
  const std::span<const int> around = around_.at(segment.node[corner]);
  const auto has_it = [&](int s) { return faces_[s].has(end) && alive(s, step.element_alive); };
  return std::count_if(around.begin(), around.end(), has_it) == 1;
}

/// A node inside a brick is near several of its faces. It belongs to those that it touched before, slid onto, or came
/// through in this step; the others are no business of its.
void SurfaceContact::drop_stray_candidates(Candidates candidates, int node, const Step& step) const {
  bool any = false;
  for (Candidate& candidate : candidates) {
    if (candidate.gap >= 0.0 || candidate.before.touching) continue;
    const Face& segment = faces_[candidate.segment];
    const Vec3d velocity = vec(step.v[node]) - interpolate(segment, candidate.foot.weight, step.v);
    candidate.came_from = dot(vec(step.x[node]) - candidate.foot.point - step.dt * velocity, candidate.foot.normal);
    candidate.came_through = candidate.came_from > on_the_face * faces_[candidate.segment].inner;
    any = any || candidate.came_through;
  }
  if (any) resolve_swept_nodes(candidates, node, step);
  for (Candidate& candidate : candidates) {
    if (candidate.gap >= 0.0 || candidate.before.touching) continue;
    const bool is_level = candidate.came_from >= -on_the_face * faces_[candidate.segment].inner;
    const Candidate* from = predecessor(candidates, candidate);
    // Level with a face it came through that only if no other has it.
    if (!candidate.extended && (candidate.came_through || (from == nullptr && is_level))) continue;
    if (from == nullptr || dot(from->foot.normal, candidate.foot.normal) <= 0.5) candidate.gap = Box::infinity;
  }
}

/// A body that is pressed onto another one and slides runs over its nodes: they come in through a face at its side, a
/// little above the one with which it lies on them. They belong to the latter, if their own surface faces that more, or
/// if it is so little that the sides of two bodies would catch each other where these are level.
void SurfaceContact::resolve_swept_nodes(Candidates candidates, int node, const Step& step) const {
  for (Candidate& side : candidates) {
    if (!side.came_through) continue;
    const double facing = faces(node, side.foot.normal, step);
    const auto is_below = [&](const Candidate& other) {
      const Face& segment = faces_[other.segment];
      if (other.gap >= 0.0 || !share_a_node(segment, faces_[side.segment])) return false;
      const bool shallow =
          dot(other.foot.normal, side.foot.normal) < 0.5 && -other.gap < extension * std::sqrt(area(segment, step.x));
      return faces(node, other.foot.normal, step) < (shallow ? -0.5 : facing - clearly_more);
    };
    const auto below = std::find_if(candidates.begin(), candidates.end(), is_below);
    if (below == candidates.end()) continue;
    side.came_through = false;
    side.gap = Box::infinity;
    below->came_through = !below->before.touching;
  }
}

/// How much the surface of a node faces a face with the `normal`: the least cosine between that and the normals of its
/// own faces; -1 where the two lie on each other, 1 for a node without faces.
double SurfaceContact::faces(int node, const Vec3d& normal, const Step& step) const {
  double least = 1.0;
  for (const int s : around_.at(node)) {
    if (!alive(s, step.element_alive)) continue;
    const kernel::Corners k = corners_of(faces_[s], step.x);
    const Vec3d n = cross(k[2] - k[0], k[3] - k[1]);
    const double size = norm(n), cosine = size > 0.0 ? dot(n, normal) / size : 1.0;
    least = std::min(least, faces_[s].of_brick ? cosine : -std::abs(cosine));
  }
  return least;
}

/// Where p lies behind the face of a brick, no deeper than `deepest`, its gap and the way out. If the foot is on an
/// edge or corner: behind all faces that meet there, or, once it moves, beyond them by no more than the extension that
/// segments have (MAXPAR); the depth behind that is measured along the normal, as the edge is off to the side. A node
/// that is level with the face, as those beside the flush face of another brick are, is behind it by round-off alone.
/// At the start nothing came through a face yet: a node on one or a little above it, near its edge, is not deep inside
/// from the side.
void SurfaceContact::measure_inside_brick(Candidate& candidate, double deepest, const Vec3d& p,
                                          const Step& step) const {
  // One that is pressed goes over the edge at once.
  const double allowed = step.dt > 0.0 && !candidate.before.pressed_inside() ? extension : 0.0;
  const Vec3d r = p - candidate.foot.point;
  const double height = dot(r, candidate.foot.normal), distance = candidate.foot.distance;
  if (height >= 0.0 || distance > deepest) return;
  if (!(step.dt > 0.0) && outside_adjacent_face(candidate, p, step)) return;
  const Face& segment = faces_[candidate.segment];
  double beyond = 0.0;  // in sides
  for (int c = 0; c < segment.corners(); ++c) {
    if (!(candidate.foot.boundary >> c & 1u)) continue;
    for (const int s : around_.at(segment.node[c])) {
      const Face& other = faces_[s];
      if (!has_boundary(other, segment, candidate.foot.boundary) || !alive(s, step.element_alive)) continue;
      const kernel::Corners k = corners_of(other, step.x);
      const Vec3d n = cross(k[2] - k[0], k[3] - k[1]);
      const double off = dot(r, n), size = std::sqrt(0.5 * norm(n)) * norm(n);
      const bool alike = dot(n, candidate.foot.normal) > 0.5 * norm(n);
      if (off > (alike ? 0.0 : allowed * size)) return;
      if (off > 0.0) beyond = std::max(beyond, off / size);
    }
  }
  candidate.extended = beyond > round_off;
  if (candidate.foot.boundary != 0 && !candidate.extended && height > -level * distance) return;
  const bool normal = beyond > 0.0 || candidate.foot.boundary == 0 || distance == 0.0;
  candidate.to_an_edge = !normal;
  candidate.gap = normal ? height : -distance;
  candidate.away = normal ? candidate.foot.normal : -candidate.away;
  if (beyond > 0.0)
    shift(candidate.foot.weight, segment, r - height * candidate.foot.normal, candidate.foot.normal, step.x);
}

/// Whether p lies on, or in front of, a face that forms a ridge with the candidate's.
bool SurfaceContact::outside_adjacent_face(const Candidate& candidate, const Vec3d& p, const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  for (int c = 0; c < segment.corners(); ++c)
    for (const int s : around_.at(segment.node[c])) {
      const Face& other = faces_[s];
      if (s == candidate.segment || same_side(segment, other) == 0 || !alive(s, step.element_alive)) continue;
      const kernel::Corners k = corners_of(other, step.x);
      const Vec3d n = cross(k[2] - k[0], k[3] - k[1]), centre = 0.25 * (k[0] + k[1] + k[2] + k[3]);
      const bool ridge = dot(centre - candidate.foot.point, candidate.foot.normal) < 0.0;
      if (ridge && dot(p - centre, n) >= -on_the_face * std::sqrt(0.5 * norm(n)) * norm(n)) return true;
    }
  return false;
}

bool SurfaceContact::presses(Candidates candidates, const Candidate& candidate, int node, const Step& step) const {
  // In this order: most of those that touch are hidden, and that is seen without the segments of the node.
  return std::none_of(candidates.begin(), candidates.end(),
                      [&](const Candidate& other) { return hidden_by(other, candidate); }) &&
         !is_own_neighbourhood(candidate, node, step.element_alive);
}

/// The pair pressed in the cycle before, and none that it is one stretch of surface with does now.
bool SurfaceContact::has_parted(Candidates candidates, const Candidate& candidate) const {
  const Face& segment = faces_[candidate.segment];
  return candidate.before.pressed() && std::none_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
           return other.touching() && share_a_node(faces_[other.segment], segment);
         });
}

/// Another pair, new in this cycle, has taken over what this one remembered.
bool SurfaceContact::is_handed_on(Candidates candidates, const Candidate& candidate) const {
  return std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
    return other.touching() && !other.before.touching && predecessor(candidates, other) == &candidate;
  });
}

/// The closest point lies on an edge or corner of the node's own segments: along the surface there is a way down to
/// distance 0, so this is no contact of one part of the surface with another.
bool SurfaceContact::is_own_neighbourhood(const Candidate& candidate, int node,
                                          std::span<const unsigned char> element_alive) const {
  if (candidate.foot.boundary == 0 || candidate.pair->near_own == 0) return false;
  const Face& segment = faces_[candidate.segment];
  const std::span<const int> around = around_.at(node);
  return std::any_of(around.begin(), around.end(), [&](int own) {
    return has_boundary(faces_[own], segment, candidate.foot.boundary) && alive(own, element_alive);
  });
}

/// Both feet are one point of a common edge or corner, but for round-off.
bool SurfaceContact::in_one_place(const Candidate& a, const Candidate& b) const {
  return are_in_one_place(a.foot.distance, a.foot.point, b.foot.distance, b.foot.point,
                          b.contact_distance + faces_[b.segment].inner) &&
         share_a_node(faces_[a.segment], faces_[b.segment]);
}

/// Of two feet in one place, outside of both segments, where round-off would decide which segment is closer and the
/// stiffness of the pair with it: the one that is pressed stays, else the one that faces the node more, else the
/// stiffer one.
bool SurfaceContact::goes_before(const Candidate& a, const Candidate& b) const {
  if (a.before.touching != b.before.touching) return a.before.touching;
  const double faces_a = std::abs(dot(a.away, a.foot.normal)), faces_b = std::abs(dot(b.away, b.foot.normal));
  if (std::abs(faces_a - faces_b) > round_off) return faces_a > faces_b;
  const double stiffness_a = faces_[a.segment].stiffness, stiffness_b = faces_[b.segment].stiffness;
  if (std::abs(stiffness_a - stiffness_b) > round_off * stiffness_b) return stiffness_a > stiffness_b;
  return a.segment < b.segment;
}

/// `other` is closer and the two are one stretch of surface: the foot lies on their common edge or corner, or they push
/// in much the same direction (a facetted hollow, where both have a foot inside).
bool SurfaceContact::hidden_by(const Candidate& other, const Candidate& candidate) const {
  if (&other == &candidate) return false;
  // Over an edge goes the node down the side of the brick, which has no say until it has left.
  if (other.over_an_edge != candidate.over_an_edge && share_a_node(faces_[other.segment], faces_[candidate.segment])) {
    if (other.over_an_edge && !candidate.before.touching) return true;
    if (candidate.over_an_edge && !other.before.touching) return false;
  }
  if (candidate.gap < 0.0 && other.gap >= 0.0) return false;  // a face that it is not behind
  if (candidate.gap < 0.0 && other.came_through != candidate.came_through && !candidate.before.touching &&
      !other.before.touching && share_a_node(faces_[other.segment], faces_[candidate.segment]))
    return other.came_through;
  if (candidate.gap >= 0.0 && other.gap >= 0.0 && in_one_place(other, candidate)) {
    if (!goes_before(other, candidate)) return false;
  } else {
    if (other.foot.distance > candidate.foot.distance) return false;
    if (other.foot.distance == candidate.foot.distance && other.segment > candidate.segment) return false;
  }
  const Face &a = faces_[other.segment], &b = faces_[candidate.segment];
  const bool alike = dot(other.away, candidate.away) > 0.5;
  if (has_boundary(a, b, candidate.foot.boundary))
    return candidate.gap >= 0.0 || alike || candidate.to_an_edge || !candidate.before.touching;
  if (candidate.gap < 0.0 && !candidate.before.touching && share_a_node(a, b)) return true;
  // Of a node that came through a sheet above an edge, the one may know it and the other not.
  const bool same_place = norm(other.foot.point - candidate.foot.point) <= round_off * candidate.contact_distance;
  return share_a_node(a, b) && (alike || same_place);
}

/// The pair from which the node comes if it did not touch `candidate` before: a neighbour that it touched.
const SurfaceContact::Candidate* SurfaceContact::predecessor(Candidates candidates, const Candidate& candidate) const {
  const Face& segment = faces_[candidate.segment];
  const Candidate* found = nullptr;
  for (const Candidate& other : candidates) {
    if (&other == &candidate || !other.before.touching) continue;
    const Face& from = faces_[other.segment];
    if (same_side(from, segment) != 0) return &other;
    if (found == nullptr && share_a_node(from, segment)) found = &other;
  }
  return found;
}

/// The side on which the node is remembered to be; 0: none.
int SurfaceContact::remembered_side(const Candidate& candidate, const Candidate* from) const {
  if (candidate.before.touching) return candidate.before.side;
  if (from == nullptr) return 0;
  const Face &a = faces_[from->segment], &b = faces_[candidate.segment];
  int same = same_side(a, b);
  // Over a corner they have none in common but a neighbour has one with either.
  for (int c = 0; c < a.corners() && same == 0; ++c) {
    if (!b.has(a.node[c])) continue;
    for (const int s : around_.at(a.node[c]))
      if (same == 0) same = same_side(a, faces_[s]) * same_side(faces_[s], b);
  }
  return same * from->before.side;
}

/// On which side of a sheet a node came to a foot on an edge or corner, from `was_at` as seen from there; 0 where the
/// sheet has no sides there: off the end of it, at the edge of a brick, and over a fold, where what is the outer side
/// of the one segment can be the inner one of the next.
int SurfaceContact::side_over_edge(int number, const Vec3d& normal, unsigned boundary, const Vec3d& was_at,
                                   const Step& step) const {
  const Face& segment = faces_[number];
  const double distance = norm(was_at);
  if (segment.inner > 0.0 || !(distance > 0.0)) return 0;
  const double up = dot(was_at, normal) / distance;
  if (std::abs(up) < side_change_cosine) return 0;
  const int side = up < 0.0 ? -1 : 1;
  for (int c = 0; c < segment.corners(); ++c) {
    if (!(boundary >> c & 1u)) continue;
    for (const int s : around_.at(segment.node[c])) {
      const Face& other = faces_[s];
      if (s == number || !has_boundary(other, segment, boundary) || !alive(s, step.element_alive)) continue;
      const int same = same_side(segment, other);
      if (same == 0) continue;
      const kernel::Corners k = corners_of(other, step.x);
      const Vec3d n = cross(k[2] - k[0], k[3] - k[1]);
      if (same * side * dot(was_at, n) < side_change_cosine * distance * norm(n)) return 0;
    }
  }
  return side;
}

/// Whether the node lies on a free edge of its sheet and the foot on one of another, and these cross: then they press
/// each other, where they are closest, and the node on the one is as good a place as any. Side by side it is the nodes
/// that meet.
bool SurfaceContact::handled_by_edge_contact(const Candidate& candidate, int node, const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  if (!edges_meet_ || candidate.foot.boundary == 0 || segment.of_brick) return false;
  // Visits the other ends of the free edges at a node.
  const auto each_free_edge = [&](int at, const auto& visit) {
    for (const int s : around_.at(at)) {
      const Face& own = faces_[s];
      if (own.of_brick || !alive(s, step.element_alive)) continue;
      for (int c = 0; c < own.corners(); ++c) {
        const int a = own.node[c], b = own.node[(c + 1) % own.corners()];
        if (a != at && b != at) continue;
        const int end = a == at ? b : a;
        const std::span<const int> there = around_.at(at);
        const auto has_it = [&](int t) { return faces_[t].has(end) && alive(t, step.element_alive); };
        if (std::count_if(there.begin(), there.end(), has_it) == 1) visit(end);
      }
    }
  };
  bool cross_each_other = false;
  for (int c = 0; c < segment.corners(); ++c) {
    const int corner = segment.node[c];
    if (!(candidate.foot.boundary >> c & 1u)) continue;
    each_free_edge(corner, [&](int end) {
      // A foot on an edge is on this one alone.
      const bool on_it = candidate.foot.boundary == 1u << c || has_boundary_at(segment, candidate.foot.boundary, end);
      if (!on_it) return;
      each_free_edge(node, [&](int other) {
        if (other == corner || other == end) return;
        const Vec3d p = vec(step.x[end]) - vec(step.x[corner]), q = vec(step.x[other]) - vec(step.x[node]);
        if (std::abs(dot(cross(p, q), candidate.away)) >= side_by_side * norm(p) * norm(q)) cross_each_other = true;
      });
    });
  }
  return cross_each_other;
}

}  // namespace nugget::contact
