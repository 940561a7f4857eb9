// SPDX-License-Identifier: Apache-2.0
// Nodes that touch and are not pressed: most of those in a flange, in most cycles.
#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"

namespace nugget::contact {

/// As fill() has it.
void SurfaceContact::Work::find_foot(Rest& rest, const SurfaceContact& contact, const Awake::One& one, int tracked,
                                     const Step& step) const {
  const Lane foot(*this, one.turn);
  rest.turn = one.turn;
  rest.node = one.node;
  rest.distance = foot.distance();
  rest.contact_distance = contact.contact_distance(tracked, rest.segment);
  rest.point = foot.point();
  rest.r = vec(step.x[one.node]) - rest.point;
  rest.normal = foot.normal();
  rest.boundary = foot.boundary();
  rest.side = rest.touch->side;
  rest.away = rest.distance > 0.0 ? (1.0 / rest.distance) * rest.r : rest.normal;
  if (rest.side == 0) return;
  const Vec3d out = static_cast<double>(rest.side) * rest.normal;
  if (rest.boundary == 0)
    rest.away = out;
  else if (dot(rest.away, out) <= -side_change_cosine)
    rest.away = -rest.away;
}

/// What press() finds of a pair that was not pressed; false where it may be pressed now, or where that has to say.
bool SurfaceContact::Work::stays(const SurfaceContact& contact, Rest& rest, const Step& step) const {
  const Touch& touch = *rest.touch;
  rest.touches = rest.distance < rest.contact_distance;
  if (!rest.touches) return true;
  if ((rest.pair->near_own != 0 && rest.boundary != 0) || touch.memory.stiffness > 0.0) return false;
  const auto velocity = [&] {
    return vec(step.v[rest.node]) - interpolate(contact.faces_[rest.segment], Lane(*this, rest.turn).weight(), step.v);
  };
  Vec3d direction = rest.away;
  if (rest.boundary == 0) {
    if (rest.side == 0) {
      rest.side = dot(rest.r - step.dt * velocity(), rest.normal) < 0.0 ? -1 : 1;
      direction = static_cast<double>(rest.side) * rest.normal;
    }
  } else {
    if (rest.side == 0)
      rest.side = contact.side_over_edge(rest.segment, rest.normal, rest.boundary, rest.r - step.dt * velocity(), step);
    const double up = rest.side * dot(direction, rest.normal);
    if (up <= -side_change_cosine)
      direction = -direction;
    else if (up < side_change_cosine)
      rest.side = 0;
  }
  const double height = dot(rest.r, direction), overlap = rest.contact_distance - height;
  if (contact.too_deep(overlap, rest.segment)) return false;
  rest.inside = rest.boundary == 0 && height < 0.0;
  rest.offset = touch.offset;
  if (overlap - touch.depth > rest.offset)
    rest.offset = std::max(rest.offset, overlap - touch.depth - step.dt * norm(velocity()));
  rest.offset = std::min(rest.offset, overlap);
  rest.depth = overlap - rest.offset;
  return !(rest.depth > 0.0);
}

/// Looks at a node of whose close pairs, `count`, of shells all, some touched in the cycle before (`touching_count`)
/// and none was pressed. Where none is pressed now either, and the others do not matter (others_matter()), they
/// remember here what press() would have them remember. No element is deleted.
SurfaceContact::Work::Resting SurfaceContact::Work::rest(const SurfaceContact& contact, Block& block, std::size_t count,
                                                         std::size_t touching_count, int tracked,
                                                         const Step& step) const {
  if (touching_count == 0 || touching_count > most_at_rest) return Resting::unknown;
  std::array<Rest, most_at_rest> all;
  for (std::size_t k = 0; k < touching_count; ++k) {
    all[k].pair = &block.pairs[awake.pairs[touching[k]].pair];
    all[k].touch = &block.touches[all[k].pair->touch];
    if (all[k].touch->pressed()) return Resting::unknown;
    all[k].segment = static_cast<int>(all[k].pair->segment);
  }
  // Of two that are one stretch of surface the one may hide the other.
  if (touching_count > 1 && shared_corners(contact.faces_[all[0].segment], contact.faces_[all[1].segment]) != 0)
    return Resting::unknown;
  for (std::size_t k = 0; k < touching_count; ++k) find_foot(all[k], contact, awake.pairs[touching[k]], tracked, step);
  const std::span<const Rest> rests = std::span(all).first(touching_count);
  for (std::size_t k = 0; touching_count < count && k < count; ++k) {
    const Awake::One& one = awake.pairs[close[k]];
    const Pair& pair = block.pairs[one.pair];
    if (pair.touch == none && matter(contact, rests, static_cast<int>(pair.segment), one, tracked, step))
      return Resting::others_matter;
  }
  for (std::size_t k = 0; k < touching_count; ++k)
    if (!stays(contact, all[k], step)) return Resting::may_press;
  for (const Rest& one : rests) {
    if (!one.touches) {
      block.release(*one.pair);
      continue;
    }
    Touch& touch = *one.touch;
    const Lane foot(*this, one.turn);
    touch.xi = foot.xi();
    touch.eta = foot.eta();
    touch.inside = one.inside;
    touch.side = static_cast<signed char>(one.side);
    touch.offset = one.offset;
    touch.depth = one.depth;
    touch.friction = {};
    touch.memory = {};
  }
  return Resting::yes;
}

}  // namespace nugget::contact
