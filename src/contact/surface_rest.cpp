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

/// Finds where a pair stands that is over the inside of its segment, or over an edge on the side that is known, by what
/// was found of a register full of pairs together: `depth` is its overlap, the offset not yet taken off. False where it
/// stands otherwise.
bool SurfaceContact::Work::stands_simply(Rest& rest) const {
  const int side = rest.touch->side;
  const std::size_t batch = at(rest.turn) / width, l = at(rest.turn) % width;
  const Found& here = found[batch];
  const bool over_border = kernel::stored_lane(feet[batch].boundary, static_cast<int>(l)) != 0.0;
  if (side == 0 || (over_border && !(side * here.up[l] >= side_change_cosine))) return false;
  const double height = over_border ? here.length[l] : side * here.height[l];
  rest.side = side;
  rest.inside = !over_border && height < 0.0;
  rest.depth = rest.contact_distance - height;
  return true;
}

/// What press() finds of a pair of look_alone() that was not pressed; false where it may be pressed now.
bool SurfaceContact::Work::stays_alone(const SurfaceContact& contact, Rest& rest, int tracked, const Step& step) const {
  const Touch& touch = *rest.touch;
  if (touch.pressed() || touch.memory.stiffness > 0.0) return false;
  if (!stands_simply(rest)) {
    find_foot(rest, contact, {0, rest.node, rest.turn}, tracked, step);
    return stays(contact, rest, step);
  }
  const double overlap = rest.depth;
  const auto velocity = [&] {
    return vec(step.v[rest.node]) - interpolate(contact.faces_[rest.segment], Lane(*this, rest.turn).weight(), step.v);
  };
  rest.offset = offset_of(touch, overlap, velocity, step.dt);
  rest.depth = overlap - rest.offset;
  return !(rest.depth > 0.0);
}

/// Looks at a node whose pairs that touched in the cycle before, of shells, are all that is awake and not hidden, and
/// touch still: they have nothing to do with each other. Those that are not pressed remember here what press() would
/// have them remember; the others are left in `at_rest`.
SurfaceContact::Work::Alone SurfaceContact::Work::look_alone(const SurfaceContact& contact, Block& block,
                                                             const Awake::Node& node, std::size_t first,
                                                             const Step& step) {
  if (node.touching == 0 || node.touching > most_at_rest || contact.deepest_allowed_ > 0.0) return Alone::no;
  const bool all_exposed = step.element_alive.empty() && !contact.covers_;
  std::size_t count = 0;
  for (std::size_t i = first; i < node.end; ++i) {
    const Awake::One& one = awake.pairs[i];
    if (one.turn < 0) continue;
    Pair& pair = block.pairs[one.pair];
    if (pair.touch == none || count == most_at_rest) return Alone::no;
    Rest& rest = at_rest[count++];
    rest.segment = static_cast<int>(pair.segment);
    const Face& face = contact.faces_[rest.segment];
    rest.contact_distance = 0.5 * (contact.nodes_[node.tracked].thickness + face.thickness);
    const std::size_t batch = at(one.turn) / width, l = at(one.turn) % width;
    const double distance = found[batch].distance[l];
    if (!(distance < rest.contact_distance)) return Alone::no;
    if (!all_exposed && !is_exposed(face, step.element_alive)) return Alone::no;
    if (pair.near_own != 0 && kernel::stored_lane(feet[batch].boundary, static_cast<int>(l)) != 0.0) return Alone::no;
    rest.pair = &pair;
    rest.touch = &block.touches[pair.touch];
    rest.turn = one.turn;
    rest.node = one.node;
  }
  if (count == 0 || (!all_exposed && !contact.node_alive(at_rest[0].node, step.element_alive))) return Alone::no;
  if (count > 1 && shared_corners(contact.faces_[at_rest[0].segment], contact.faces_[at_rest[1].segment]) != 0)
    return Alone::no;
  touching_count = 0;
  block.next_check_travel[node.tracked - block.begin] = block.travelled;
  for (std::size_t k = 0; k < count; ++k) {
    Rest& rest = at_rest[k];
    const std::size_t batch = at(rest.turn) / width, l = at(rest.turn) % width;
    rest.pair->xi = found[batch].xi[l];
    rest.pair->eta = found[batch].eta[l];
    if (!stays_alone(contact, rest, node.tracked, step)) {
      if (touching_count++ < k) at_rest[0] = rest;
      continue;
    }
    rest.remember(rest.pair->xi, rest.pair->eta);
  }
  return touching_count > 0 ? Alone::may_press : Alone::rests;
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
    const Lane foot(*this, one.turn);
    one.remember(foot.xi(), foot.eta());
  }
  return Resting::yes;
}

}  // namespace nugget::contact
