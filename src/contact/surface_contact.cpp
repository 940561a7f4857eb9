// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/cleared.hpp"
#include "base/free_room.hpp"
#include "base/index.hpp"
#include "base/parallel.hpp"
#include "contact/surface_nodes.hpp"
#include "contact/surface_work.hpp"
#include "kernel/contact/touch_friction.hpp"

namespace nugget::contact {
namespace {

constexpr int nodes_per_block = 64;

double mean_edge(const std::vector<Segment>& segments, std::span<const Row> x) {
  double sum = 0.0;
  for (const Segment& s : segments) sum += std::sqrt(area(s, x));
  return segments.empty() ? 0.0 : sum / static_cast<double>(segments.size());
}

/// Area of a segment where friction asks for it.
double area_for(const kernel::Friction& law, const Facet& segment, const Step& step) {
  return law.shear_strength > 0.0 ? area(segment, step.x) : 0.0;
}

}  // namespace

double search_margin(const SurfaceContactSetup& setup, std::span<const Row> x) {
  return setup.margin > 0.0 ? setup.margin : 0.25 * mean_edge(setup.segments, x);
}

SurfaceContact::SurfaceContact(const SurfaceContactSetup& setup, std::span<const Row> x, SurfaceContactSetup* given)
    : law_(setup.law),
      deepest_allowed_(setup.deepest),
      birth_(setup.birth),
      death_(setup.death),
      edges_meet_(setup.edges_meet),
      places_(setup.places),
      around_(setup.segments),
      outline_(setup.whole ? std::make_unique<SurfaceOutline>(*setup.whole) : nullptr),
      forces_(surface_nodes(setup), setup.law.friction.any()),
      sources_(forces_.parts()) {
  assign_sides(forces_, around_, setup);
  margin_ = search_margin(setup, x);
  looks_everywhere_ = law_.balances_friction;  // couples look at places of all corners
  stays_active_.assign(forces_.nodes().empty() ? 0 : forces_.nodes().back() + 1, 0);
  if (outline_ != nullptr) {
    pressing_ = outline_->pressing;
    covers_ = outline_->covers;
    for (const int n : outline_->tracked)
      stays_active_[n] = !outline_->stays_active.empty() && outline_->stays_active[n];
    make_blocks(outline_->tracked.size());
    return;
  }
  constexpr std::size_t given_together = 4096;
  faces_.reserve(setup.segments.size());
  for (std::size_t i = 0; i < setup.segments.size(); ++i) {
    const Segment& s = setup.segments[i];
    faces_.push_back(face_of(s, setup.stiffness_scale, x));
    covers_ = covers_ || s.covered_by >= 0;
    // So that both take no room at a time.
    if (given != nullptr && i % given_together == 0) forget(given->segments, i - std::min(i, given_together), i);
  }
  if (given != nullptr) free_room(given->segments);

  nodes_.reserve(setup.nodes.size());
  for (std::size_t i = 0; i < setup.nodes.size(); ++i) {
    const TrackedNode& t = setup.nodes[i];
    if (given != nullptr && i % given_together == 0) forget(given->nodes, i - std::min(i, given_together), i);
    nodes_.push_back(tracked_of(t));
    pressing_ |= t.against;
    if (t.stays_active) stays_active_[t.node] = 1;
  }
  if (given != nullptr) free_room(given->nodes);
  make_blocks(nodes_.size());
  for (Block& block : blocks_) {
    block.first.assign(block.end - block.begin + 1, 0);
    block.next_check_travel.assign(block.end - block.begin, 0.0);
    block.widest.assign(block.end - block.begin, 0.0);
  }
}

SurfaceContact::Face SurfaceContact::face_of(const Segment& s, double stiffness_scale, std::span<const Row> x) const {
  const bool by_segment_masses = law_.stiffness == kernel::PenaltyStiffness::segment_masses;
  Face face{s};
  face.thickness = s.thickness;
  face.stiffness = stiffness_scale * (by_segment_masses ? s.scale : penalty_stiffness(s, x));
  face.mass = s.mass;
  const double a = area(s, x);
  face.inner = s.volume > 0.0 && a > 0.0 ? pressing_depth * s.volume / a : 0.0;
  face.element = s.element;
  face.covered_by = s.covered_by;
  face.kind = s.kind;
  face.side = static_cast<unsigned char>(s.side);
  face.of_brick = s.volume > 0.0;
  return face;
}

/// From the segments around it, which are there.
SurfaceContact::Tracked SurfaceContact::tracked_of(const TrackedNode& t) const {
  const bool by_segment_masses = law_.stiffness == kernel::PenaltyStiffness::segment_masses;
  const std::span<const int> around = around_.at(t.node);
  static thread_local std::vector<int> kinds;
  double sum = 0.0;
  kinds.clear();
  for (int s : around) {
    sum += by_segment_masses ? faces_[s].mass : faces_[s].stiffness;
    kinds.push_back(faces_[s].kind);
  }
  Tracked node;
  node.node = t.node;
  node.kind = around.empty() ? t.kind : commonest(kinds);
  node.thickness = t.thickness;
  // A node without segments of its own (of a beam, say) is as stiff as what it meets, and has no mass.
  node.stiffness = !around.empty() ? sum / static_cast<double>(around.size()) : by_segment_masses ? 0.0 : Box::infinity;
  node.against = t.against;
  return node;
}

void SurfaceContact::make_blocks(std::size_t tracked) {
  const int count = static_cast<int>(tracked);
  blocks_.reserve((tracked + nodes_per_block - 1) / nodes_per_block);
  for (int begin = 0; begin < count; begin += nodes_per_block) {
    Block block;
    block.begin = begin;
    block.end = std::min(count, begin + nodes_per_block);
    blocks_.push_back(std::move(block));
  }
}

void SurfaceContact::apply(const Step& step, std::span<Row> force) {
  acts_ = !faces_.empty() && !step.off && step.time >= birth_ && step.time < death_;
  if (acts_) {
    if (step.shared != nullptr) take_share(*step.shared);
    if (moved_too_far(step.x) || !searched_) search(step);
    if (share_ != nullptr) ghosts_.fetch(*share_, step.shared->x, step.shared->v);
    list_active_blocks();
    parallel_for(active_blocks_.size(), 4,
                 [this, &step](std::size_t begin, std::size_t end) { look_at(begin, end, work_of_thread(), step); });
    if (share_ != nullptr) exchange_hits();
  }
  add_forces(step, force);
}

void SurfaceContact::list_active_blocks() {
  active_blocks_.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (computes(b) && !blocks_[b].pairs.empty()) active_blocks_.push_back(static_cast<int>(b));
}

std::size_t SurfaceContact::listed() const {
  std::size_t count = 0;
  for (const Block& b : blocks_) count += b.pairs.size();
  return count;
}

bool SurfaceContact::node_alive(int node, std::span<const unsigned char> element_alive) const {
  if (element_alive.empty() && !covers_) return true;
  const std::span<const int> around = around_.at(node);
  if (around.empty() || stays_active_[node]) return true;
  return std::any_of(around.begin(), around.end(), [&](int s) { return alive(s, element_alive); });
}

// ---- every cycle

SurfaceContact::Work& SurfaceContact::work_of_thread() {
  static thread_local Work work;
  return work;
}

/// The pair does not touch any more.
void SurfaceContact::Block::release(Pair& pair) {
  if (pair.touch == none) return;
  free.push_back(pair.touch);
  pair.touch = none;
}

/// What the pair will remember from now on, in the place that it has or in a new one.
SurfaceContact::Touch& SurfaceContact::Block::touch(Pair& pair) {
  if (pair.touch != none) return touches[pair.touch] = {};
  if (free.empty()) {
    pair.touch = static_cast<int>(touches.size());
    make_room(touches);
    return touches.emplace_back();
  }
  pair.touch = free.back();
  free.pop_back();
  return touches[pair.touch] = {};
}

void SurfaceContact::Block::clear_hits() {
  hits.clear();
  places.clear();
  parts.clear();
  resultant = {};
  deepest = 0.0;
}

/// Works on some of the active blocks. A body has more pairs and segments than a cache holds: the pairs of the block
/// after the next, and the segments of the next, are on their way meanwhile.
void SurfaceContact::look_at(std::size_t begin, std::size_t end, Work& work, const Step& step) {
  const auto follow_and_wake = [&](std::size_t b) {
    follow(blocks_[active_blocks_[b]], step.x);
    wake(blocks_[active_blocks_[b]], work.next);
  };
  follow_and_wake(begin);
  for (std::size_t b = begin; b < end; ++b) {
    if (b + 4 < end) ask_for_lines(&blocks_[active_blocks_[b + 4]], sizeof(Block));
    if (b + 2 < end) ask_for(blocks_[active_blocks_[b + 2]]);
    std::swap(work.awake, work.next);
    if (b + 1 < end) follow_and_wake(b + 1);
    look_at(blocks_[active_blocks_[b]], work, step);
  }
}

void SurfaceContact::look_at(Block& block, Work& work, const Step& step) const {
  block.clear_hits();
  block.energies.springs = 0.0;
  if (work.awake.nodes.empty()) return;
  project(block, work, step);
  let_hidden_sleep(block, work, step);
  std::size_t first = 0;
  for (std::size_t n = 0; n < work.awake.nodes.size(); ++n) {
    const Awake::Node& node = work.awake.nodes[n];
    if (n + 1 < work.awake.nodes.size())
      ask_for_touching(block, work.awake, node.end, work.awake.nodes[n + 1].end, step);
    const Work::Alone alone = work.look_alone(*this, block, node, first, step);
    if (alone == Work::Alone::no) {
      const Candidates candidates = gather_candidates(block, work, node, first, step);
      if (!candidates.empty() || block.depth_of(node.tracked) > 0.0) check_node(block, candidates, node.tracked, step);
    }
    if (alone == Work::Alone::may_press) press_alone(block, work, node.tracked, step);
    first = node.end;
    if (node.touching > 0 && block.depth_of(node.tracked) > 0.0) wake_all(block, node.tracked);
  }
  block.asleep_until = *std::min_element(block.next_check_travel.begin(), block.next_check_travel.end());
  sum_up(block);
  share_out(block);
}

/// By how much more than the contact distance pairs of a node reach: one that became softer has an overlap with a
/// force there [length].
double SurfaceContact::reach_ahead(Candidates candidates) {
  double ahead = 0.0;
  for (const Candidate& c : candidates)
    if (c.before.pressed()) ahead = std::max(ahead, -c.before.offset);
  return ahead;
}

void SurfaceContact::check_node(Block& block, Candidates candidates, int tracked, const Step& step) const {
  const int node = nodes_[tracked].node;
  if (block.depth_of(tracked) > 0.0) {
    stay_inside(candidates, node, step);
    go_over_edges(candidates, node, step);
    block.deep[tracked - block.begin] = 0.0;
  }
  if (step.dt > 0.0 && std::ranges::any_of(candidates, [](const Candidate& c) { return c.gap < 0.0; }))
    drop_stray_candidates(candidates, node, step);
  const double ahead = reach_ahead(candidates);
  const auto may_press = [](const Candidate& c) { return c.before.pressed() || c.gap < c.contact_distance; };
  if (std::ranges::none_of(candidates, may_press)) return;
  const auto close = [&](const Candidate& c) {
    if (c.gap < c.contact_distance || ahead == 0.0) return c.gap < c.contact_distance;
    const Candidate* from = c.before.pressed() ? &c : predecessor(candidates, c);
    return from != nullptr && from->before.pressed() && c.gap < c.contact_distance - from->before.offset;
  };
  if (!node_alive(node, step.element_alive)) {
    for (const Candidate& c : candidates)
      if (c.before.pressed()) block.energies.deleted += c.before.held();
    return;
  }
  for (const Candidate& candidate : candidates)
    if (close(candidate) && presses(candidates, candidate, node, step))
      press(block, candidates, candidate, tracked, step);
  for (const Candidate& candidate : candidates) {
    if (!candidate.before.pressed() || candidate.touching()) continue;
    const double given_back =
        !close(candidate) && has_parted(candidates, candidate) ? part(block, candidate, tracked, step) : 0.0;
    book_drop(block, candidates, candidate, tracked, given_back, step);
  }
}

/// Of the pairs of a node that are awake, from the `first` on, those that are close enough; none where no pair can have
/// a force.
SurfaceContact::Candidates SurfaceContact::gather_candidates(Block& block, Work& work, const Awake::Node& node,
                                                             std::size_t first, const Step& step) const {
  const int tracked = node.tracked;
  const double widest = block.widest_of(tracked), deep = block.depth_of(tracked);
  const double thickness = nodes_[tracked].thickness;
  const bool all_exposed = step.element_alive.empty() && !covers_;
  // Closer than that a pair of shells is close, whatever else there is to know of it.
  const double close_by = deep > 0.0 ? -1.0 : Work::surely_close * widest;
  double first_check_travel = node.asleep_until;
  if (work.close.size() < node.end - first) {
    work.close.resize(node.end - first);
    work.touching.resize(node.end - first);
  }
  std::size_t count = 0, touching = 0;
  bool inside = deep > 0.0, matters = inside;  // inside: or near a brick, in which it could be
  bool uncovered = false;
  const Awake::One* const ones = work.awake.pairs.data();
  const Work::Found* const all_found = work.found.data();
  Pair* const pairs = block.pairs.data();
  const Face* const faces = faces_.data();
  int* const close = work.close.data();
  const double travelled = block.travelled;
  for (std::size_t i = first; i < node.end; ++i) {
    const Awake::One one = ones[i];
    if (one.turn < 0) {
      first_check_travel = std::min(first_check_travel, pairs[one.pair].next_check_travel);
      continue;
    }
    Pair& pair = pairs[one.pair];
    const Face& face = faces[pair.segment];
    if (!all_exposed && !is_exposed(face, step.element_alive)) {
      if (block.pressed(pair)) block.energies.deleted += block.touch_of(pair)->held();
      block.release(pair);
      pair.next_check_travel = Box::infinity;  // for good; what it may have hidden is looked at
      uncovered = true;
      continue;
    }
    const std::size_t batch = at(one.turn) / Work::width, l = at(one.turn) % Work::width;
    const Work::Found& found = all_found[batch];
    double distance = found.distance[l];
    if (distance < close_by) {
      pair.xi = found.xi[l];
      pair.eta = found.eta[l];
      first_check_travel = std::min(first_check_travel, travelled);
    } else {
      const double far = widest + (face.inner + deep);
      const bool pressed = block.pressed(pair);
      const bool triangle = face.triangle();
      kernel::Feet<NativeBatch>& feet = work.feet[batch];
      const int lane = static_cast<int>(l);
      if (!pressed && (triangle || !(kernel::stored_lane(feet.distance, lane) < Work::surely_close * far)) &&
          found.least[l] >= far) {
        block.release(pair);
        pair.next_check_travel = travelled + (found.least[l] - far);
        first_check_travel = std::min(first_check_travel, pair.next_check_travel);
        continue;
      }
      if (triangle) feet.set(lane, kernel::closest_point(corners_of(face, step.x), true, vec(step.x[one.node])));
      distance = kernel::stored_lane(feet.distance, lane);
      pair.xi = kernel::stored_lane(feet.xi, lane);
      pair.eta = kernel::stored_lane(feet.eta, lane);
      pair.next_check_travel = travelled + (distance - far);
      first_check_travel = std::min(first_check_travel, pair.next_check_travel);
      if (pair.next_check_travel > travelled && !pressed) {
        block.release(pair);
        continue;
      }
      inside = inside || face.inner > 0.0;
    }
    close[count++] = static_cast<int>(i);
    matters = matters || inside || distance < 0.5 * (thickness + face.thickness);
    if (pair.touch == none) continue;
    work.touching[touching++] = static_cast<int>(i);
    matters = matters || block.pressed(pair);
  }
  block.next_check_travel[tracked - block.begin] = first_check_travel;
  if (uncovered) wake_all(block, tracked);
  work.touching_count = touching;
  std::size_t filled = 0;
  if (matters) {
    if (work.candidates.size() < count) work.candidates.resize(count);
    const auto fill_those = [&](const std::vector<int>& list, std::size_t size) {
      for (filled = 0; filled < size; ++filled) {
        const Awake::One& one = work.awake.pairs[list[filled]];
        fill(work.candidates[filled], block, block.pairs[one.pair], work, at(one.turn), tracked, step);
      }
    };
    const auto others_matter_now = [&] {
      const Candidates known = std::span(work.candidates).first(filled);
      return work.others_matter(*this, block, known, reach_ahead(known), count, tracked, step);
    };
    using Resting = Work::Resting;
    const bool known = !inside && node_alive(nodes_[tracked].node, step.element_alive);
    const Resting rests = known ? work.rest(*this, block, count, tracked, step) : Resting::unknown;
    if (rests == Resting::yes) return {};
    if (!inside && rests != Resting::others_matter) fill_those(work.touching, touching);
    if (filled == 0 || (rests == Resting::unknown && touching < count && others_matter_now()))
      fill_those(work.close, count);
  }
  for (std::size_t k = 0; k < touching; ++k) block.release(block.pairs[work.awake.pairs[work.touching[k]].pair]);
  return std::span(work.candidates).first(filled);
}

/// Makes a candidate, in the place of one of an earlier node, of a pair and its foot. `turn`: see Awake.
void SurfaceContact::fill(Candidate& c, const Block& block, Pair& pair, const Work& work, std::size_t turn, int tracked,
                          const Step& step) const {
  const auto segment = static_cast<int>(pair.segment);
  const Face& face = faces_[segment];
  const Vec3d p = vec(step.x[nodes_[tracked].node]);
  c.pair = &pair;
  c.segment = segment;
  if (const Touch* before = block.touch_of(pair))
    c.before = *before;
  else if (c.before.touching)
    c.before = {};
  work.feet[turn / Work::width].put(static_cast<int>(turn % Work::width), c.foot);
  c.contact_distance = contact_distance(tracked, segment);
  c.gap = c.foot.distance;
  c.away = Work::way_out(face, c.foot, p - c.foot.point, c.before.side);
  c.extended = c.to_an_edge = c.over_an_edge = c.came_through = false;
  c.came_from = 0.0;
  if (face.inner > 0.0) measure_inside_brick(c, face.inner, p, step);
}

/// Presses the pairs of a node that look_alone() has found.
void SurfaceContact::press_alone(Block& block, Work& work, int tracked, const Step& step) const {
  const std::size_t count = work.touching_count;
  if (work.candidates.size() < count) work.candidates.resize(count);
  const Candidates candidates = std::span(work.candidates).first(count);
  for (std::size_t k = 0; k < count; ++k)
    fill(candidates[k], block, *work.at_rest[k].pair, work, at(work.at_rest[k].turn), tracked, step);
  for (const Candidate& candidate : candidates) press(block, candidates, candidate, tracked, step);
}

/// Stiffness of the pair where its foot is.
SurfaceContact::Spring SurfaceContact::spring(const Candidate& candidate, int tracked, const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  std::array<double, 4> corner_mass{};
  for (int c = 0; c < segment.corners(); ++c) corner_mass[c] = step.mass[segment.node[c]];
  const double inverse_mass =
      kernel::inverse_pair_mass(step.mass[nodes_[tracked].node], candidate.foot.weight, corner_mass);
  const double full = penalty(candidate.segment, tracked, step);
  return {inverse_mass, kernel::pair_stiffness(law_, full, inverse_mass, step.stable_dt)};
}

/// Gives back what a pair that came apart still holds, along the normal of a brick's face: the way from an edge that is
/// level with the node leads anywhere. Returns how much that is [energy].
double SurfaceContact::part(Block& block, const Candidate& candidate, int tracked, const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  const Vec3d direction = segment.of_brick && !candidate.over_an_edge ? candidate.foot.normal : candidate.away;
  const Vec3d velocity = vec(step.v[nodes_[tracked].node]) - interpolate(segment, candidate.foot.weight, step.v);
  const auto [inverse_mass, stiffness] = spring(candidate, tracked, step);
  const double way = dot(velocity, direction) * step.dt;
  const double size =
      kernel::separation_force(candidate.before.memory, stiffness, inverse_mass, -dot(velocity, direction), step.dt);
  const double given_back = 0.5 * (candidate.before.memory.force + size) * way;
  if (!(size > 0.0)) return given_back;
  Vec3d along;
  const kernel::Friction& rough = law_.friction.between(segment.kind, nodes_[tracked].kind);
  if (rough.any()) along = friction(rough, candidate, candidate.before, direction, stiffness, size, step);
  const Vec3d force = size * direction + along;
  make_room(block.hits);
  block.hits.push_back({tracked, candidate.segment, candidate.foot.weight, force, along, 0.0});
  return given_back;
}

/// Books what the spring of a pair still held that came to an end while it was pressed farther than the motion of the
/// step can have undone.
void SurfaceContact::book_drop(Block& block, Candidates candidates, const Candidate& candidate, int tracked,
                               double given_back, const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  const int node = nodes_[tracked].node;
  const Vec3d velocity = vec(step.v[node]) - interpolate(segment, candidate.foot.weight, step.v);
  const double held = candidate.before.held() - given_back;
  if (!(held > 0.0) || candidate.before.depth <= step.dt * norm(velocity) || is_handed_on(candidates, candidate))
    return;
  block.energies.drops.add(held, node, segment.node[0], step.time);
}

void SurfaceContact::press(Block& block, Candidates candidates, const Candidate& candidate, int tracked,
                           const Step& step) const {
  const Face& segment = faces_[candidate.segment];
  const int node = nodes_[tracked].node;
  const Vec3d r = vec(step.x[node]) - candidate.foot.point;
  // Most that rest on each other need no velocity: it is looked for where one does.
  std::optional<Vec3d> found;
  const auto velocity = [&]() -> const Vec3d& {
    return found ? *found : found.emplace(vec(step.v[node]) - interpolate(segment, candidate.foot.weight, step.v));
  };
  const Candidate* from = candidate.before.touching ? nullptr : predecessor(candidates, candidate);
  if (!candidate.before.touching && from == nullptr && handled_by_edge_contact(candidate, node, step)) return;

  Vec3d direction = candidate.away;
  int side = remembered_side(candidate, from);
  if (candidate.over_an_edge) {
    if (side == 0) side = 1;
  } else if (candidate.gap < 0.0) {
    side = 1;
  } else {
    const auto [now, its_side] =
        Work::stand(*this, candidate.segment, candidate.foot, r, candidate.away, side, velocity, step);
    direction = now;
    side = its_side;
  }
  const double overlap = candidate.contact_distance - (candidate.over_an_edge ? candidate.gap : dot(r, direction));
  if (too_deep(overlap, candidate.segment)) return;

  // An offset goes with the node over the edges of the surface.
  const Touch* before = candidate.before.touching ? &candidate.before : from != nullptr ? &from->before : nullptr;
  const bool inside =
      candidate.gap < 0.0 || candidate.over_an_edge || (candidate.foot.boundary == 0 && dot(r, direction) < 0.0);
  const double offset =
      before != nullptr
          ? Work::offset_of(*before, overlap, velocity, step.dt)
          : std::min(std::max(0.0, overlap - step.dt * std::max(0.0, -dot(velocity(), direction))), overlap);

  Touch& pair = block.touch(*candidate.pair);
  if (before != nullptr) pair.memory = before->memory;
  pair.touching = true;
  pair.segment = candidate.segment;
  pair.xi = candidate.foot.xi;
  pair.eta = candidate.foot.eta;
  pair.inside = inside;
  pair.side = static_cast<signed char>(side);
  pair.offset = offset;
  pair.depth = overlap - pair.offset;
  if (!(pair.depth > 0.0) && !(pair.memory.force > 0.0) && !(pair.memory.stiffness > 0.0)) {
    pair.memory = {};  // as pair_force() would leave it: no force was, and none is
    return;
  }
  const double approach = -dot(velocity(), direction);
  const auto [inverse_mass, stiffness] = spring(candidate, tracked, step);
  if (const double depth = kernel::depth_of_same_energy(pair.memory, pair.depth, stiffness); depth != pair.depth) {
    pair.depth = depth;
    pair.offset = overlap - depth;
  }

  const double inverse_node_mass = step.mass[node] > 0.0 ? 1.0 / step.mass[node] : 0.0;
  const double size =
      kernel::pair_force(law_, pair.memory, stiffness, inverse_mass, inverse_node_mass, pair.depth, approach, step.dt);
  if (law_.damping > 0.0) {
    const double was = before != nullptr ? before->memory.damping() : 0.0;
    block.energies.damping += 0.5 * (was + pair.memory.damping()) * approach * step.dt;
  }
  if (!(size > 0.0)) return;
  block.energies.springs += pair.held();
  double& first_check_travel = block.next_check_travel[tracked - block.begin];
  if (pair.inside) {
    if (block.deep.empty()) block.deep.assign(at(block.end - block.begin), 0.0);
    double& deep = block.deep[tracked - block.begin];
    deep = std::max(deep, overlap);
  }
  if (pair.inside || pair.offset < 0.0) {
    // It may be farther apart than those are that can touch.
    candidate.pair->next_check_travel = std::min(candidate.pair->next_check_travel, block.travelled);
    first_check_travel = std::min(first_check_travel, candidate.pair->next_check_travel);
  }
  Vec3d force = size * direction;
  const kernel::Friction& rough = law_.friction.between(segment.kind, nodes_[tracked].kind);
  if (rough.any()) {
    const kernel::Touch touch{velocity(), direction, pair.depth, stiffness, size, area_for(rough, segment, step)};
    pair.friction = before != nullptr ? friction(rough, candidate, *before, direction, stiffness, size, step)
                                      : kernel::touch_friction(rough, touch);
    force += pair.friction;
  }
  make_room(block.hits);
  block.hits.push_back({tracked, candidate.segment, candidate.foot.weight, force, pair.friction, pair.depth});
}

/// Stiffness of the pair before the step bounds it. What has no mass of its own, as a node without segments or a side
/// that is held, meets its like.
double SurfaceContact::penalty(int segment, int tracked, const Step& step) const {
  const Face& face = faces_[segment];
  const Tracked& node = nodes_[tracked];
  if (law_.stiffness != kernel::PenaltyStiffness::segment_masses) return std::min(face.stiffness, node.stiffness);
  const double own = node.stiffness > 0.0 ? node.stiffness : face.mass;
  const double other = face.mass > 0.0 ? face.mass : own;
  return face.stiffness * kernel::segment_penalty(own, other, law_.step(step.longest));
}

/// Beyond PENMAX thicknesses of the shell, or depths of the brick.
bool SurfaceContact::too_deep(double overlap, int segment) const {
  const Face& face = faces_[segment];
  return deepest_allowed_ > 0.0 &&
         overlap > deepest_allowed_ * (face.of_brick ? face.inner / pressing_depth : face.thickness);
}

/// Friction on the node; `before`: the pair that it touched a cycle ago, this one or the one from which it came.
Vec3d SurfaceContact::friction(const kernel::Friction& law, const Candidate& candidate, const Touch& before,
                               const Vec3d& direction, double stiffness, double normal_force, const Step& step) const {
  const Face& from = faces_[before.segment];
  const Vec3d was = interpolate(from, kernel::shape_functions(from.triangle(), before.xi, before.eta), step.x);
  const auto along = [&direction](const Vec3d& a) { return a - dot(a, direction) * direction; };
  const Vec3d slip = along(candidate.foot.point - was);
  const double speed = step.dt > 0.0 ? norm(slip) / step.dt : 0.0;
  const double bound = law.bound(normal_force, speed, area_for(law, faces_[candidate.segment], step));
  return kernel::sliding_spring(along(before.friction), stiffness, slip, bound);
}

void SurfaceContact::Block::archive(Archive& a) {
  a(travelled, near, seen, asleep_until, first, next_check_travel, widest, deep, pairs, touches, free, hits, resultant,
    deepest, energies);
  a.built(begin, end, places, parts);
}

/// With the search lists: a pair remembers on which side it stands, and a search at another cycle would give other
/// last digits.
void SurfaceContact::archive(Archive& a) {
  a.section("contact of surfaces");
  forces_.archive(a, giver_of_places());
  a(active_nodes_, searched_, searches_, searched_when_, travelled_, acts_);
  if (a.reading()) {
    searched_at_ = ZeroedVector<Vec3d>(active_nodes_.size());
    seen_at_ = ZeroedVector<Vec3d>(active_nodes_.size());
  }
  const Archive::Holders of_active = holders_of_active_nodes();
  a.parts(searched_at_, of_active);
  a.parts(seen_at_, of_active);
  a.each_part(blocks_.size(), 1, holders_of_blocks(), [&](std::size_t b, bool here) {
    Block of_others;
    a(here ? blocks_[b] : of_others);
  });
  if (a.reading() && share_ != nullptr) hold_what_was_read();
  a.built(law_, deepest_allowed_, birth_, death_, edges_meet_, places_, covers_, faces_, nodes_, around_, outline_,
          excluded_, stays_active_, pressing_, margin_, moved_, active_blocks_, sources_, results_need_hits_, share_,
          rank_, rank_of_block_, looks_everywhere_, others_add_, at_border_, arrived_, followed_, by_share_, held_,
          at_own_, boxed_, tracked_ghosts_, ghosts_, answered_, rank_of_part_, out_, in_, hits_for_);
}

}  // namespace nugget::contact
