// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "model/segments.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

/// Of two distances that differ by less than this share of the tolerance neither is the shorter one.
constexpr double equal_share = 1e-6;
/// A gap below this share of the tolerance needs no explanation by another sheet.
constexpr double negligible_share = 1e-3;

/// Moves the best candidate to the front: the one within reach by the least distance, of equal ones the first in order.
void best_first(std::vector<Candidate>::iterator begin, std::vector<Candidate>::iterator end) {
  if (begin == end) return;
  const auto nearest =
      std::min_element(begin, end, [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  const double limit = nearest->distance + equal_share * nearest->tolerance;
  auto best = nearest;
  for (auto c = begin; c != end; ++c)
    if (c->distance <= limit && c->order < best->order) best = c;
  std::iter_swap(begin, best);
}

/// The best of each part, best of all first.
std::vector<Candidate> best_of_each_part(std::vector<Candidate> all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return a.segment.part < b.segment.part; });
  std::vector<Candidate> best;
  for (auto begin = all.begin(); begin != all.end();) {
    const auto end = std::find_if(begin, all.end(),
                                  [part = begin->segment.part](const Candidate& c) { return c.segment.part != part; });
    best_first(begin, end);
    best.push_back(*begin);
    begin = end;
  }
  for (auto begin = best.begin(); begin != best.end(); ++begin) best_first(begin, best.end());
  return best;
}

/// By node: the part of the first brick there, or none.
std::vector<Index> first_brick_part_at_nodes(const model::Model& model) {
  std::vector<Index> part(model.nodes.size(), none);
  for (std::size_t e = 0; e < model.solids.size(); ++e)
    for (Index n : model.solids.nodes(e))
      if (part[n] == none) part[n] = model.solids.part[e];
  return part;
}

std::array<Index, 4> in_order(model::Segment nodes) {
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace

bool ReferenceSegment::has(Index n) const {
  return std::find(node.begin(), node.end(), n) != node.end();
}

Reference::Reference(const model::Model& model, const std::vector<Vec3d>& x, Index contact)
    : model_(model), x_(x), contact_(model.contacts[contact]), contact_index_(contact) {
  std::vector<char> wanted(model.parts.size(), contact_.b.everything);
  for (Index part : contact_.b.parts) wanted[part] = 1;
  for (Index e = 0; e < static_cast<Index>(model.shells.size()); ++e)
    if (wanted[model.shells.part[e]]) add_shell(e);
  for (Index part = 0; part < static_cast<Index>(model.parts.size()); ++part)
    if (wanted[part] && model.parts[part].kind == model::ElementKind::solid && !of_weld_material(model, part))
      add_brick_faces(part);
  if (!contact_.b.segments.empty()) add_segments(contact_.b.segments);

  std::vector<Box> boxes(segments_.size());
  for (std::size_t i = 0; i < segments_.size(); ++i) boxes[i] = neighbourhood(segments_[i]);
  tree_ = BoxTree(boxes);
}

void Reference::add_shell(Index shell) {
  ReferenceSegment s;
  s.node = model_.shells.node[shell];
  s.shell = shell;
  s.part = model_.shells.part[shell];
  const model::Part& part = model_.parts[s.part];
  if (contact_.thickness_b > 0.0)
    s.thickness = contact_.thickness_b;
  else if (part.contact_thickness > 0.0)
    s.thickness = part.contact_thickness;
  else
    s.thickness = model_.shells.thickness[shell] * part.contact_scale * contact_.thickness_scale_b;
  // Of a section that was refused: ties are as far in reach as without a thickness, so that the rest can be reported.
  if (std::isnan(s.thickness)) s.thickness = 0.0;
  add(s);
}

void Reference::add(ReferenceSegment s) {
  s.diagonal = shorter_diagonal(corners(s));
  for (const Index n : s.node) s.moved = std::max(s.moved, norm(x_[n] - model_.nodes.x[n]));
  segments_.push_back(s);
}

/// The outer faces of a part of bricks.
void Reference::add_brick_faces(Index part) {
  std::vector<Index> bricks;
  for (Index e = 0; e < static_cast<Index>(model_.solids.size()); ++e)
    if (model_.solids.part[e] == part) bricks.push_back(e);
  for (const model::Segment& face : model::exterior_faces(model_, bricks)) add_face(face, part);
}

void Reference::add_face(const model::Segment& nodes, Index part) {
  ReferenceSegment s;
  s.node = nodes;
  s.part = part;
  s.thickness = std::max(contact_.thickness_b, 0.0);
  add(s);
}

void Reference::add_segments(const std::vector<model::Segment>& segments) {
  std::map<std::array<Index, 4>, Index> shell_of;
  for (const model::Segment& nodes : segments) shell_of.emplace(in_order(nodes), none);
  for (Index e = 0; e < static_cast<Index>(model_.shells.size()); ++e) {
    const auto wanted = shell_of.find(in_order(model_.shells.node[e]));
    if (wanted != shell_of.end() && wanted->second == none) wanted->second = e;
  }
  const std::vector<Index> part_at = first_brick_part_at_nodes(model_);
  for (const model::Segment& nodes : segments) {
    const Index shell = shell_of.at(in_order(nodes));
    if (shell != none)
      add_shell(shell);
    else
      add_face(nodes, part_at[nodes[0]]);
  }
}

Corners Reference::corners(const ReferenceSegment& s) const {
  return {x_[s.node[0]], x_[s.node[1]], x_[s.node[2]], x_[s.node[3]]};
}

Corners Reference::corners_in_deck(const ReferenceSegment& s) const {
  const std::vector<Vec3d>& x = model_.nodes.x;
  return {x[s.node[0]], x[s.node[1]], x[s.node[2]], x[s.node[3]]};
}

Box Reference::neighbourhood(const ReferenceSegment& segment) const {
  Box box;
  for (const Vec3d& corner : corners(segment)) box.add(corner);
  const double beyond_border = (parametric_extension - 1.0) * norm(box.high - box.low);
  const Tracked without_thickness{};
  return box.grown(segment.moved + tolerance(segment, without_thickness) + beyond_border);
}

bool Reference::allowed(const ReferenceSegment& segment, const Tracked& tracked) const {
  return !segment.has(tracked.node) && (tracked.only_part == none || tracked.only_part == segment.part) &&
         (tracked.not_part == none || tracked.not_part != segment.part);
}

double Reference::tolerance(const ReferenceSegment& segment, const Tracked& tracked) const {
  if (contact_.thickness_a < 0.0 || contact_.thickness_b < 0.0)
    return 0.6 * (std::abs(contact_.thickness_a) + std::abs(contact_.thickness_b));
  return std::max(0.6 * (tracked.thickness + segment.thickness), 0.05 * segment.diagonal);
}

Candidate Reference::candidate(Index order, const Tracked& tracked) const {
  Candidate c;
  c.contact = contact_index_;
  c.order = order;
  c.segment = segments_[order];
  c.foot = project(corners(c.segment), c.segment.triangle(), x_[tracked.node]);
  const bool aside = !c.foot.over && tracked.aside >= 0.0;
  c.tolerance = tolerance(c.segment, aside ? Tracked{.node = tracked.node, .thickness = tracked.aside} : tracked);
  const Foot in_deck = c.segment.moved > 0.0
                           ? project(corners_in_deck(c.segment), c.segment.triangle(), model_.nodes.x[tracked.node])
                           : c.foot;
  c.gap = in_deck.gap;
  c.distance = in_deck.distance;
  return c;
}

template <class Wanted>
Candidate Reference::closest(const Tracked& tracked, double bound, Wanted&& wanted) const {
  const Vec3d& x = x_[tracked.node];
  const BoxTree::Nearest nearest = tree_.nearest(x, bound, [&](Index order) {
    const ReferenceSegment& s = segments_[order];
    return allowed(s, tracked) && wanted(s) ? project(corners(s), s.triangle(), x).distance : infinity;
  });
  return nearest.item >= 0 ? candidate(nearest.item, tracked) : Candidate{};
}

NearbySegments Reference::search(const Tracked& tracked) const {
  NearbySegments nearby;
  const Vec3d& x = x_[tracked.node];
  std::vector<Candidate> found;
  tree_.overlapping(Box{x, x}.grown(0.6 * tracked.thickness), [&](Index order) {
    if (!allowed(segments_[order], tracked)) return;
    const Candidate c = candidate(order, tracked);
    if (c.within_tolerance()) found.push_back(c);
  });
  nearby.within_tolerance = best_of_each_part(std::move(found));
  if (nearby.within_tolerance.empty()) {
    nearby.closest = closest(tracked, infinity, [](const ReferenceSegment&) { return true; });
  } else {
    nearby.closest = nearby.within_tolerance.front();
    nearby.plane_of_other_sheet = plane_of_other_sheet(tracked, nearby);
  }
  return nearby;
}

Candidate Reference::closest_elsewhere(const Tracked& tracked, Index part) const {
  return closest(tracked, infinity, [part](const ReferenceSegment& s) { return s.part != part; });
}

double Reference::plane_of_other_sheet(const Tracked& tracked, const NearbySegments& nearby) const {
  const Candidate& best = nearby.within_tolerance.front();
  if (best.foot.gap <= negligible_share * best.tolerance) return infinity;
  const auto of_other_sheet = [&](const ReferenceSegment& s) {
    return std::none_of(nearby.within_tolerance.begin(), nearby.within_tolerance.end(), [&](const Candidate& c) {
      return c.segment.part == s.part && c.foot.over;  // that sheet does reach the node
    });
  };
  const Candidate other = closest(tracked, best.segment.diagonal, of_other_sheet);
  if (other.contact == none) return infinity;
  const Corners k = corners(other.segment);
  return std::abs(dot(normal(k), x_[tracked.node] - other.foot.point));
}

}  // namespace nugget::weld
