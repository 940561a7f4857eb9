// SPDX-License-Identifier: Apache-2.0
// Nodes that touch and are not pressed: most of those in a flange, in most cycles.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"

namespace nugget::contact {

void SurfaceContact::Work::find_foot(Rest& rest, const SurfaceContact& contact, const Awake::One& one, int tracked,
                                     const Step& step) const {
  const Lane foot(*this, one.turn);
  rest.turn = one.turn;
  rest.node = one.node;
  rest.contact_distance = contact.contact_distance(tracked, rest.segment);
  rest.foot = {foot.point(), foot.normal(), foot.distance(), foot.boundary()};
  rest.r = vec(step.x[one.node]) - rest.foot.point;
  rest.side = rest.touch->side;
  rest.away = way_out(contact.faces_[rest.segment], rest.foot, rest.r, rest.side);
}

/// What press() finds of a pair that was not pressed; false where it may be pressed now, or where that has to say.
bool SurfaceContact::Work::stays(const SurfaceContact& contact, Rest& rest, const Step& step) const {
  const Touch& touch = *rest.touch;
  rest.touches = rest.foot.distance < rest.contact_distance;
  if (!rest.touches) return true;
  if ((rest.pair->near_own != 0 && rest.foot.boundary != 0) || touch.memory.stiffness > 0.0) return false;
  const auto velocity = [&] {
    return vec(step.v[rest.node]) - interpolate(contact.faces_[rest.segment], Lane(*this, rest.turn).weight(), step.v);
  };
  const Stand now = stand(contact, rest.segment, rest.foot, rest.r, rest.away, rest.side, velocity, step);
  const double height = dot(rest.r, now.direction), overlap = rest.contact_distance - height;
  if (contact.too_deep(overlap, rest.segment)) return false;
  rest.side = now.side;
  rest.inside = rest.foot.boundary == 0 && height < 0.0;
  rest.offset = offset_of(touch, overlap, velocity, step.dt);
  rest.depth = overlap - rest.offset;
  return !(rest.depth > 0.0);
}

/// Looks at a node of whose close pairs, `count`, of shells all, some touched in the cycle before (touching_count)
/// and none was pressed. Where none is pressed now either, and the others do not matter (others_matter()), they
/// remember here what press() would have them remember.
SurfaceContact::Work::Resting SurfaceContact::Work::rest(const SurfaceContact& contact, Block& block, std::size_t count,
                                                         int tracked, const Step& step) {
  if (touching_count == 0 || touching_count > most_at_rest) return Resting::unknown;
  for (std::size_t k = 0; k < touching_count; ++k) {
    at_rest[k].pair = &block.pairs[awake.pairs[touching[k]].pair];
    at_rest[k].touch = &block.touches[at_rest[k].pair->touch];
    if (at_rest[k].touch->pressed()) return Resting::unknown;
    at_rest[k].segment = static_cast<int>(at_rest[k].pair->segment);
  }
  // Of two that are one stretch of surface the one may hide the other.
  if (touching_count > 1 && shared_corners(contact.faces_[at_rest[0].segment], contact.faces_[at_rest[1].segment]) != 0)
    return Resting::unknown;
  for (std::size_t k = 0; k < touching_count; ++k)
    find_foot(at_rest[k], contact, awake.pairs[touching[k]], tracked, step);
  const std::span<const Rest> rests = std::span(std::as_const(at_rest)).first(touching_count);
  if (touching_count < count && others_matter(contact, block, rests, 0.0, count, tracked, step))
    return Resting::others_matter;
  for (std::size_t k = 0; k < touching_count; ++k)
    if (!stays(contact, at_rest[k], step)) return Resting::may_press;
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
