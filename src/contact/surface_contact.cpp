// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "contact/couple.hpp"
#include "contact/surface_nodes.hpp"
#include "kernel/contact/touch_friction.hpp"

namespace nugget::contact {
namespace {

constexpr int nodes_per_block = 64;
constexpr std::size_t nodes_per_group = 4096;

double mean_edge(const std::vector<Segment>& segments, std::span<const Row> x) {
  double sum = 0.0;
  for (const Segment& s : segments) sum += std::sqrt(area(s, x));
  return segments.empty() ? 0.0 : sum / static_cast<double>(segments.size());
}

}  // namespace

SurfaceContact::SurfaceContact(SurfaceContactSetup setup, std::span<const Row> x)
    : setup_(std::move(setup)),
      around_(setup_.segments),
      forces_(surface_nodes(setup_)),
      frictions_(setup_.law.friction.any() ? forces_.nodes() : std::vector<int>{}) {
  for (const Segment& s : setup_.segments) {
    segment_stiffness_.push_back(setup_.stiffness_scale * penalty_stiffness(s, x));
    const double a = area(s, x);
    inner_.push_back(s.volume > 0.0 && a > 0.0 ? pressing_depth * s.volume / a : 0.0);
    thickest_segment_ = std::max(thickest_segment_, s.thickness);
  }
  set_kinds(setup_.nodes, around_, setup_.segments);
  stays_active_.assign(forces_.nodes().empty() ? 0 : forces_.nodes().back() + 1, 0);
  for (const TrackedNode& t : setup_.nodes) {
    const std::span<const int> around = around_.at(t.node);
    double sum = 0.0, mass = 0.0;
    for (int s : around) {
      sum += segment_stiffness_[s];
      mass += setup_.segments[s].mass;
    }
    // A node without segments of its own (of a beam, say) is as stiff as what it meets.
    node_stiffness_.push_back(around.empty() ? Box::infinity : sum / static_cast<double>(around.size()));
    node_mass_.push_back(around.empty() ? 0.0 : mass / static_cast<double>(around.size()));
    pressing_ |= t.against;
    if (t.stays_active) stays_active_[t.node] = 1;
  }
  assign_sides(forces_, around_, setup_.segments);

  // A quarter of an element: few pairs are listed in vain, and a search lasts some hundred cycles at crash speeds.
  margin_ = 0.25 * mean_edge(setup_.segments, x);

  const int tracked = static_cast<int>(setup_.nodes.size());
  for (int begin = 0; begin < tracked; begin += nodes_per_block) {
    Block block;
    block.begin = begin;
    block.end = std::min(tracked, begin + nodes_per_block);
    block.first.assign(block.end - begin + 1, 0);
    block.old_first = block.first;
    block.next_check_travel.assign(block.end - block.begin, 0.0);
    block.deep = block.next_check_travel;
    blocks_.push_back(std::move(block));
  }
}

void SurfaceContact::apply(const Step& step, std::span<Row> force) {
  next_cycle();
  const bool active = !setup_.segments.empty() && step.time >= setup_.birth && step.time < setup_.death;
  if (active) {
    if (moved_too_far(step.x) || !searched_) search(step.x, step.element_alive);
    parallel_for(active_blocks_.size(), 4, [this, &step](std::size_t begin, std::size_t end) {
      for (std::size_t b = begin; b < end; ++b) work(blocks_[active_blocks_[b]], step);
    });
    add_forces(step, force);
  }
  update_energy(step.dt, step.v);
}

std::size_t SurfaceContact::listed() const {
  std::size_t count = 0;
  for (const Block& b : blocks_) count += b.pairs.size();
  return count;
}

bool SurfaceContact::node_alive(int node, std::span<const unsigned char> element_alive) const {
  const std::span<const int> around = around_.at(node);
  if (around.empty() || stays_active_[node]) return true;
  return std::any_of(around.begin(), around.end(), [&](int s) { return alive(s, element_alive); });
}

// ---- search

/// By how much two of the active points can have approached each other if the i-th was displaced by `displacement(i)`:
/// no more than the diagonal of the box of all displacements, whatever the surface does as a whole.
template <class Displacement>
double SurfaceContact::approach(const Displacement& displacement) {
  parallel_for(moved_.size(), 1, [this, &displacement](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      Box box;
      for (std::size_t i = g * nodes_per_group; i < std::min(active_nodes_.size(), (g + 1) * nodes_per_group); ++i)
        box.add(displacement(i));
      moved_[g] = box;
    }
  });
  if (moved_.empty()) return 0.0;
  Box all;
  for (const Box& box : moved_) all.add(box);
  return norm(all.high - all.low);
}

bool SurfaceContact::moved_too_far(std::span<const Row> x) {
  travelled_ += approach([this, &x](std::size_t i) {
    const Vec3d step = vec(x[active_nodes_[i]]) - vec(seen_at_[i]);
    seen_at_[i] = x[active_nodes_[i]];
    return step;
  });
  // Steps added up are never less than the whole way: while they are short that need not be measured.
  if (travelled_ - searched_when_ <= margin_) return false;
  return approach([this, &x](std::size_t i) { return vec(x[active_nodes_[i]]) - vec(searched_at_[i]); }) > margin_;
}

void SurfaceContact::search(std::span<const Row> x, std::span<const unsigned char> element_alive) {
  active_nodes_.clear();
  searched_at_.clear();
  for (int n : forces_.nodes()) {
    if (!node_alive(n, element_alive) || !finite(x[n])) continue;
    active_nodes_.push_back(n);
    searched_at_.push_back(x[n]);
  }
  seen_at_ = searched_at_;
  moved_.resize((active_nodes_.size() + nodes_per_group - 1) / nodes_per_group);

  active_segments_.clear();
  boxes_.clear();
  for (std::size_t s = 0; s < setup_.segments.size(); ++s) {
    const Segment& segment = setup_.segments[s];
    const bool whole = std::all_of(segment.node.begin(), segment.node.end(), [&](int n) { return finite(x[n]); });
    if (!whole || !(segment.side & pressing_) || !alive(static_cast<int>(s), element_alive)) continue;
    Box box;
    for (const Vec3d& c : corners_of(segment, x)) box.add(c);
    active_segments_.push_back(static_cast<int>(s));
    boxes_.push_back(box.grown(0.5 * segment.thickness + inner_[s]));
  }
  tree_ = BoxTree(boxes_);

  const auto list = [this, &x, &element_alive](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) list_neighbours(blocks_[b], x, element_alive);
  };
  parallel_for(blocks_.size(), 4, list);
  active_blocks_.clear();
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (!blocks_[b].pairs.empty()) active_blocks_.push_back(static_cast<int>(b));
  searched_ = true;
  searched_when_ = travelled_;
  ++searches_;
}

void SurfaceContact::list_neighbours(Block& block, std::span<const Row> x,
                                     std::span<const unsigned char> element_alive) {
  std::swap(block.first, block.old_first);
  std::swap(block.pairs, block.old_pairs);
  block.pairs.clear();
  std::size_t longest = 0;
  for (int t = block.begin; t < block.end; ++t) {
    const std::size_t start = block.pairs.size();
    block.first[t - block.begin] = static_cast<int>(start);
    const TrackedNode& tracked = setup_.nodes[t];
    if (!finite(x[tracked.node]) || !node_alive(tracked.node, element_alive)) {
      for (int i = block.old_first[t - block.begin]; i < block.old_first[t - block.begin + 1]; ++i)
        if (block.old_pairs[i].pressed()) block.energies.deleted += block.old_pairs[i].held();
      continue;
    }
    const Vec3d p = vec(x[tracked.node]);
    Box box;
    box.add(p);
    const double around = 0.5 * tracked.thickness + margin_ + block.deep[t - block.begin];
    tree_.overlapping(box.grown(around), [&](int item) {
      Pair pair;
      pair.segment = active_segments_[item];
      const Segment& segment = setup_.segments[pair.segment];
      const double far = contact_distance(t, pair.segment) + reach(block, t, pair.segment) + margin_;
      if (!(segment.side & tracked.against) || segment.has(tracked.node)) return;
      const kernel::Corners corners = corners_of(segment, x);
      if (kernel::least_distance(corners, p) > far) return;
      const kernel::Foot foot = kernel::closest_point(corners, segment.triangle(), p);
      if (foot.distance > far) return;
      pair.xi = foot.xi;
      pair.eta = foot.eta;
      pair.next_check_travel = travelled_ + (foot.distance - (widest(t) + reach(block, t, pair.segment)));
      block.pairs.push_back(pair);
    });
    const auto by_segment = [](const Pair& a, const Pair& b) { return a.segment < b.segment; };
    std::sort(block.pairs.begin() + start, block.pairs.end(), by_segment);
    // What the pairs remember goes on.
    const auto old_begin = block.old_pairs.begin() + block.old_first[t - block.begin];
    const auto old_end = block.old_pairs.begin() + block.old_first[t - block.begin + 1];
    for (auto pair = block.pairs.begin() + start; pair != block.pairs.end(); ++pair) {
      const auto old = std::lower_bound(old_begin, old_end, *pair, by_segment);
      if (old != old_end && old->segment == pair->segment) *pair = *old;
    }
    const auto end = static_cast<std::ptrdiff_t>(block.pairs.size());
    for (auto old = old_begin; old != old_end; ++old) {
      const auto known = block.pairs.begin() + static_cast<std::ptrdiff_t>(start);
      if (!old->pressed() || std::binary_search(known, block.pairs.begin() + end, *old, by_segment)) continue;
      if (alive(old->segment, element_alive))
        block.pairs.push_back(*old);
      else
        block.energies.deleted += old->held();
    }
    if (static_cast<std::ptrdiff_t>(block.pairs.size()) > end)
      std::sort(block.pairs.begin() + static_cast<std::ptrdiff_t>(start), block.pairs.end(), by_segment);
    longest = std::max(longest, block.pairs.size() - start);
  }
  block.first.back() = static_cast<int>(block.pairs.size());
  std::fill(block.next_check_travel.begin(), block.next_check_travel.end(), 0.0);
  block.candidates.reserve(longest);
  block.hits.reserve(block.pairs.size());
}

// ---- every cycle

void SurfaceContact::work(Block& block, const Step& step) const {
  block.hits.clear();
  const auto awake = [this, &block](int t) {
    return t < block.end && block.next_check_travel[t - block.begin] <= travelled_;
  };
  for (int t = block.begin; t < block.end; ++t) {
    if (awake(t + 2)) prefetch_segments(block, t + 2);
    if (awake(t + 1)) prefetch_corners(block, t + 1, step);
    if (awake(t)) check_node(block, t, step);
  }
  block.sum_up(setup_, pressing_);
}

void SurfaceContact::Block::sum_up(const SurfaceContactSetup& setup, unsigned pressing) {
  resultant = {};
  deepest = 0.0;
  lowest = std::numeric_limits<int>::max();
  highest = -1;
  for (const Hit& hit : hits) {
    const Segment& segment = setup.segments[hit.segment];
    resultant += segment.side == 1 && pressing != 1 ? -hit.force : hit.force;
    deepest = std::max(deepest, hit.depth);
    const auto [low, high] = std::minmax_element(segment.node.begin(), segment.node.end());
    lowest = std::min({lowest, *low, setup.nodes[hit.tracked].node});
    highest = std::max({highest, *high, setup.nodes[hit.tracked].node});
  }
}

/// A body has more segments than a cache holds: those near a node, and its own, are on their way while other nodes are
/// looked at.
void SurfaceContact::prefetch_segments(const Block& block, int tracked) const {
  const auto ask_for = [this](int s) {
    const Segment& segment = setup_.segments[s];
    __builtin_prefetch(&segment.node);
    __builtin_prefetch(&segment.element);
    __builtin_prefetch(&segment.side);
  };
  for (const Pair& pair : pairs_of(block, tracked)) ask_for(pair.segment);
  for (const int own : around_.at(setup_.nodes[tracked].node)) ask_for(own);
}

/// The same of their corners, once the segments are here.
void SurfaceContact::prefetch_corners(const Block& block, int tracked, const Step& step) const {
  for (const Pair& pair : pairs_of(block, tracked)) {
    if (pair.next_check_travel > travelled_) continue;
    for (const int n : setup_.segments[pair.segment].node) {
      __builtin_prefetch(&step.x[n]);
      __builtin_prefetch(&step.v[n]);
    }
  }
}

void SurfaceContact::check_node(Block& block, int tracked, const Step& step) const {
  if (excluded_ != nullptr && (*excluded_)[tracked]) return;
  gather_candidates(block, tracked, step);
  const int node = setup_.nodes[tracked].node;
  if (block.deep[tracked - block.begin] > 0.0) {
    stay_inside(block, node, step);
    go_over_edges(block, node, step);
    block.deep[tracked - block.begin] = 0.0;
  }
  if (step.dt > 0.0) drop_stray_candidates(block, node, step);
  double ahead = 0.0;  // a pair that became softer reaches beyond the contact distance
  bool matters = false;
  for (const Candidate& c : block.candidates) {
    const bool pressed = c.before.pressed();
    if (pressed) ahead = std::max(ahead, -c.before.offset);
    matters = matters || pressed || c.gap < c.contact_distance;
  }
  if (!matters) return;
  const auto close = [&](const Candidate& c) {
    if (c.gap < c.contact_distance || ahead == 0.0) return c.gap < c.contact_distance;
    const Candidate* from = c.before.pressed() ? &c : predecessor(block, c);
    return from != nullptr && from->before.pressed() && c.gap < c.contact_distance - from->before.offset;
  };
  if (!node_alive(node, step.element_alive)) {
    for (const Candidate& c : block.candidates)
      if (c.before.pressed()) block.energies.deleted += c.before.held();
    return;
  }
  for (Candidate& candidate : block.candidates)
    if (close(candidate) && presses(block, candidate, node, step)) press(block, candidate, tracked, step);
  for (const Candidate& candidate : block.candidates) {
    if (!candidate.before.pressed() || candidate.pair->touching) continue;
    const double given_back =
        !close(candidate) && has_parted(block, candidate) ? part(block, candidate, tracked, step) : 0.0;
    book_drop(block, candidate, tracked, given_back, step);
  }
}

void SurfaceContact::gather_candidates(Block& block, int tracked, const Step& step) const {
  block.candidates.clear();
  const int begin = block.first[tracked - block.begin], end = block.first[tracked - block.begin + 1];
  double& first_check_travel = block.next_check_travel[tracked - block.begin];
  first_check_travel = Box::infinity;
  // A node between aligned sheets is near four segments, as many as there are lanes.
  std::array<Pair*, native_width> near{};
  std::size_t count = 0;
  for (int i = begin; i < end; ++i) {
    Pair& pair = block.pairs[i];
    if (pair.next_check_travel > travelled_) {
      first_check_travel = std::min(first_check_travel, pair.next_check_travel);
      continue;
    }
    if (!alive(pair.segment, step.element_alive)) {
      if (pair.pressed()) block.energies.deleted += pair.held();
      pair.release();
      continue;
    }
    near[count++] = &pair;
    if (count < near.size()) continue;
    add_candidates(block, near, tracked, step);
    count = 0;
  }
  if (count > 0) add_candidates(block, std::span(near).first(count), tracked, step);
}

/// Those of `near`, pairs of one node in the order of the block, that are close enough.
void SurfaceContact::add_candidates(Block& block, std::span<Pair* const> near, int tracked, const Step& step) const {
  using R = NativeBatch;
  const Vec3d p = vec(step.x[setup_.nodes[tracked].node]);
  const Vec3<R> x{R(p.x), R(p.y), R(p.z)};
  std::array<std::array<int, lanes<R>>, 4> id;
  R xi, eta;
  for (int l = 0; l < lanes<R>; ++l) {
    const Pair& pair = *near[std::min(at(l), near.size() - 1)];
    for (int c = 0; c < 4; ++c) id[c][l] = setup_.segments[pair.segment].node[c];
    set_lane(xi, l, pair.xi);
    set_lane(eta, l, pair.eta);
  }
  kernel::CornersOf<R> corners;
  for (int c = 0; c < 4; ++c) corners[c] = gather<R>(step.x.data(), id[c].data());
  const R clear = kernel::least_distance(corners, x);
  const kernel::Feet<R> feet = kernel::closest_points(corners, x, xi, eta);

  double& first_check_travel = block.next_check_travel[tracked - block.begin];
  for (std::size_t l = 0; l < near.size(); ++l) {
    Pair& pair = *near[l];
    const Segment& segment = setup_.segments[pair.segment];
    const double far = widest(tracked) + reach(block, tracked, pair.segment), least = lane(clear, static_cast<int>(l));
    if (least >= far && !pair.pressed()) {
      pair.release();
      pair.next_check_travel = travelled_ + (least - far);
      first_check_travel = std::min(first_check_travel, pair.next_check_travel);
      continue;
    }
    const kernel::Foot foot =
        segment.triangle() ? kernel::closest_point(corners_of(segment, step.x), true, p) : feet.at(static_cast<int>(l));
    const Pair before = pair;
    pair.release();
    pair.xi = foot.xi;
    pair.eta = foot.eta;
    pair.next_check_travel = travelled_ + (foot.distance - far);
    first_check_travel = std::min(first_check_travel, pair.next_check_travel);
    if (pair.next_check_travel > travelled_ && !before.pressed()) continue;
    Candidate& c = block.candidates.emplace_back();
    c.pair = &pair;
    c.before = before;
    c.foot = foot;
    c.contact_distance = contact_distance(tracked, pair.segment);
    c.gap = c.foot.distance;
    c.away = c.foot.distance > 0.0 ? (1.0 / c.foot.distance) * (p - c.foot.point) : c.foot.normal;
    if (before.touching && before.side != 0) {
      const Vec3d out = static_cast<double>(before.side) * c.foot.normal;
      if (c.foot.boundary == 0)
        c.away = out;
      else if (inner_[pair.segment] == 0.0 && dot(c.away, out) <= -side_change_cosine)
        c.away = -c.away;
    }
    if (inner_[pair.segment] > 0.0) measure_inside_brick(c, inner_[pair.segment], p, step);
  }
}

/// Stiffness of the pair where its foot is.
SurfaceContact::Spring SurfaceContact::spring(const Candidate& candidate, int tracked, const Step& step) const {
  const Segment& segment = setup_.segments[candidate.pair->segment];
  std::array<double, 4> corner_mass{};
  for (int c = 0; c < segment.corners(); ++c) corner_mass[c] = step.mass[segment.node[c]];
  const double inverse_mass =
      kernel::inverse_pair_mass(step.mass[setup_.nodes[tracked].node], candidate.foot.weight, corner_mass);
  const double full = penalty(candidate.pair->segment, tracked, step);
  return {inverse_mass, kernel::pair_stiffness(setup_.law, full, inverse_mass, step.stable_dt)};
}

/// Gives back what a pair that came apart still holds, along the normal of a brick's face: the way from an edge that is
/// level with the node leads anywhere. Returns how much that is [energy].
double SurfaceContact::part(Block& block, const Candidate& candidate, int tracked, const Step& step) const {
  const Segment& segment = setup_.segments[candidate.pair->segment];
  const Vec3d direction = segment.volume > 0.0 && !candidate.over_an_edge ? candidate.foot.normal : candidate.away;
  const Vec3d velocity = vec(step.v[setup_.nodes[tracked].node]) - interpolate(segment, candidate.foot.weight, step.v);
  const auto [inverse_mass, stiffness] = spring(candidate, tracked, step);
  const double way = dot(velocity, direction) * step.dt;
  const double size =
      kernel::separation_force(candidate.before.memory, stiffness, inverse_mass, -dot(velocity, direction), step.dt);
  const double given_back = 0.5 * (candidate.before.memory.force + size) * way;
  if (!(size > 0.0)) return given_back;
  Vec3d along;
  const kernel::Friction& rough = setup_.law.friction.between(segment.kind, setup_.nodes[tracked].kind);
  if (rough.any()) along = friction(rough, candidate, &candidate.before, direction, stiffness, size, step);
  const Vec3d force = size * direction + along;
  block.hits.push_back({tracked, candidate.pair->segment, candidate.foot.weight, force, along, 0.0});
  return given_back;
}

/// Books what the spring of a pair still held that came to an end while it was pressed farther than the motion of the
/// step can have undone.
void SurfaceContact::book_drop(Block& block, const Candidate& candidate, int tracked, double given_back,
                               const Step& step) const {
  const Segment& segment = setup_.segments[candidate.pair->segment];
  const int node = setup_.nodes[tracked].node;
  const Vec3d velocity = vec(step.v[node]) - interpolate(segment, candidate.foot.weight, step.v);
  const double held = candidate.before.held() - given_back;
  if (!(held > 0.0) || candidate.before.depth <= step.dt * norm(velocity) || is_handed_on(block, candidate)) return;
  block.energies.drops.add(held, node, segment.node[0], step.time);
}

void SurfaceContact::press(Block& block, Candidate& candidate, int tracked, const Step& step) const {
  Pair& pair = *candidate.pair;
  const Segment& segment = setup_.segments[pair.segment];
  const int node = setup_.nodes[tracked].node;
  const Vec3d r = vec(step.x[node]) - candidate.foot.point;
  const Vec3d velocity = vec(step.v[node]) - interpolate(segment, candidate.foot.weight, step.v);
  const Candidate* from = candidate.before.touching ? nullptr : predecessor(block, candidate);
  if (!candidate.before.touching && from == nullptr && handled_by_edge_contact(candidate, node, step)) return;

  Vec3d direction = candidate.away;
  int side = remembered_side(candidate, from);
  if (candidate.over_an_edge) {
    if (side == 0) side = 1;
  } else if (candidate.gap < 0.0) {
    side = 1;
  } else if (candidate.foot.boundary == 0) {
    const bool from_behind = dot(r - step.dt * velocity, candidate.foot.normal) < 0.0;
    if (side == 0) side = from_behind && inner_[pair.segment] == 0.0 ? -1 : 1;  // a brick holds nothing inside
    direction = static_cast<double>(side) * candidate.foot.normal;
  } else {
    if (side == 0) side = side_over_edge(candidate, r - step.dt * velocity, step);
    const double up = side * dot(direction, candidate.foot.normal);
    if (inner_[pair.segment] == 0.0 && up <= -side_change_cosine)
      direction = -direction;  // it came through
    else if (up < side_change_cosine)
      side = 0;  // beyond an edge lies the other face of a free edge, the next one of a fold
  }
  const double overlap = candidate.contact_distance - (candidate.over_an_edge ? candidate.gap : dot(r, direction));
  if (too_deep(overlap, pair.segment)) return;

  // An offset goes with the node over the edges of the surface. What the motion of this step cannot have made was there
  // before, or comes from a change of the surface, and is an offset too.
  const Pair* before = candidate.before.touching ? &candidate.before : from != nullptr ? &from->before : nullptr;
  const double approach = -dot(velocity, direction);
  const bool inside =
      candidate.gap < 0.0 || candidate.over_an_edge || (candidate.foot.boundary == 0 && dot(r, direction) < 0.0);
  double offset = 0.0;
  if (before == nullptr)
    offset = std::max(0.0, overlap - step.dt * std::max(0.0, approach));
  else if (before == &candidate.before && (inside == before->inside || inner_[pair.segment] == 0.0))
    offset = before->offset;
  else  // the way out is another one
    offset = std::max(before->offset, overlap - before->depth - step.dt * norm(velocity));

  const auto [inverse_mass, stiffness] = spring(candidate, tracked, step);
  if (before != nullptr) pair.memory = before->memory;
  pair.touching = true;
  pair.inside = inside;
  pair.side = static_cast<signed char>(side);
  pair.offset = std::min(offset, overlap);
  pair.depth = overlap - pair.offset;
  if (const double depth = kernel::depth_of_same_energy(pair.memory, pair.depth, stiffness); depth != pair.depth) {
    pair.depth = depth;
    pair.offset = overlap - depth;
  }

  const double inverse_node_mass = step.mass[node] > 0.0 ? 1.0 / step.mass[node] : 0.0;
  const double size = kernel::pair_force(setup_.law, pair.memory, stiffness, inverse_mass, inverse_node_mass,
                                         pair.depth, approach, step.dt);
  if (setup_.law.damping > 0.0) {
    const double was = before != nullptr ? before->memory.damping() : 0.0;
    block.energies.damping += 0.5 * (was + pair.memory.damping()) * approach * step.dt;
  }
  if (!(size > 0.0)) return;
  block.energies.springs += pair.held();
  double& first_check_travel = block.next_check_travel[tracked - block.begin];
  if (pair.inside) {
    double& deep = block.deep[tracked - block.begin];
    deep = std::max(deep, overlap);
  }
  if (pair.inside || pair.offset < 0.0) {
    // It may be farther apart than those are that can touch.
    pair.next_check_travel = std::min(pair.next_check_travel, travelled_);
    first_check_travel = std::min(first_check_travel, pair.next_check_travel);
  }
  Vec3d force = size * direction;
  const kernel::Friction& rough = setup_.law.friction.between(segment.kind, setup_.nodes[tracked].kind);
  if (rough.any()) {
    const kernel::Touch touch{velocity, direction, pair.depth, stiffness, size, area(segment, step.x)};
    pair.friction = before != nullptr ? friction(rough, candidate, before, direction, stiffness, size, step)
                                      : kernel::touch_friction(rough, touch);
    force += pair.friction;
  }
  block.hits.push_back({tracked, pair.segment, candidate.foot.weight, force, pair.friction, pair.depth});
}

/// Stiffness of the pair before the step bounds it. What has no mass of its own, as a node without segments or a side
/// that is held, meets its like.
double SurfaceContact::penalty(int segment, int tracked, const Step& step) const {
  if (setup_.law.stiffness != kernel::PenaltyStiffness::segment_masses)
    return std::min(segment_stiffness_[segment], node_stiffness_[tracked]);
  const Segment& s = setup_.segments[segment];
  const double own = node_mass_[tracked] > 0.0 ? node_mass_[tracked] : s.mass;
  const double other = s.mass > 0.0 ? s.mass : own;
  return setup_.stiffness_scale * s.scale * kernel::segment_penalty(own, other, setup_.law.step(step.longest));
}

/// Beyond PENMAX thicknesses of the shell, or depths of the brick.
bool SurfaceContact::too_deep(double overlap, int segment) const {
  const Segment& s = setup_.segments[segment];
  return setup_.deepest > 0.0 &&
         overlap > setup_.deepest * (s.volume > 0.0 ? inner_[segment] / pressing_depth : s.thickness);
}

/// Friction on the node; `before`: the pair that it touched a cycle ago, this one or the one from which it came.
Vec3d SurfaceContact::friction(const kernel::Friction& law, const Candidate& candidate, const Pair* before,
                               const Vec3d& direction, double stiffness, double normal_force, const Step& step) const {
  const Segment& from = setup_.segments[before->segment];
  const Vec3d was = interpolate(from, kernel::shape_functions(from.triangle(), before->xi, before->eta), step.x);
  const auto along = [&direction](const Vec3d& a) { return a - dot(a, direction) * direction; };
  const Vec3d slip = along(candidate.foot.point - was);
  const double speed = step.dt > 0.0 ? norm(slip) / step.dt : 0.0;
  const double bound = law.bound(normal_force, speed, area(setup_.segments[candidate.pair->segment], step.x));
  return kernel::sliding_spring(along(before->friction), stiffness, slip, bound);
}

// ---- forces and energy

void SurfaceContact::next_cycle() {
  forces_.next_cycle();
  frictions_.next_cycle();
  resultant_ = {};
  touching_ = 0;
  deepest_ = 0.0;
}

void SurfaceContact::add_forces(const Step& step, std::span<Row> force) {
  for (const int b : active_blocks_) {
    const Block& block = blocks_[b];
    resultant_ += block.resultant;
    deepest_ = std::max(deepest_, block.deepest);
    touching_ += static_cast<int>(block.hits.size());
  }
  energies_.springs = 0.0;
  for (Block& block : blocks_) energies_.add(std::exchange(block.energies, {}));
  const auto spread = [this, &step](Vec3d Hit::*which) {
    return [this, &step, which](NodalForces::Part& part) {
      for (const int b : active_blocks_) {
        const Block& block = blocks_[b];
        if (!part.meets(block.lowest, block.highest)) continue;
        for (const Hit& hit : block.hits) {
          const Segment& segment = setup_.segments[hit.segment];
          const Vec3d& of_hit = hit.*which;
          part.add(setup_.nodes[hit.tracked].node, of_hit);
          for (int c = 0; c < segment.corners(); ++c) part.add(segment.node[c], -hit.weight[c] * of_hit);
          if (!setup_.law.balances_friction) continue;
          const Vec3d lever = vec(step.x[setup_.nodes[hit.tracked].node]) - interpolate(segment, hit.weight, step.x);
          const std::array<Vec3d, 4> back =
              couple({segment.node.data(), at(segment.corners())}, -cross(lever, of_hit), step.x);
          for (int c = 0; c < segment.corners(); ++c) part.add(segment.node[c], back[c]);
        }
      }
    };
  };
  forces_.add_by_parts(spread(&Hit::force));
  if (setup_.law.friction.any()) frictions_.add_by_parts(spread(&Hit::friction));
  forces_.add_to(force);
}

void SurfaceContact::update_energy(double dt, std::span<const Row> v) {
  const std::array<double, 2> work = forces_.work(dt, v);
  for (int side = 0; side < 2; ++side) energy_[side] -= work[side];
  if (setup_.law.friction.any()) energies_.friction -= frictions_.work(dt, v)[0];
}

// ---- initial penetrations

std::vector<Penetration> SurfaceContact::penetrations(std::span<const Row> x) {
  search(x, {});
  std::vector<Penetration> found;
  Step step;
  step.x = x;
  for (const int b : active_blocks_) {
    Block& block = blocks_[b];
    for (int t = block.begin; t < block.end; ++t) {
      gather_candidates(block, t, step);
      const int node = setup_.nodes[t].node;
      for (const Candidate& c : block.candidates)
        if (c.gap < c.contact_distance && presses(block, c, node, step))
          found.push_back({node, c.pair->segment, c.contact_distance - c.gap, c.away});
    }
  }
  return found;
}

std::vector<Penetration> find_penetrations(const SurfaceContactSetup& setup, std::span<const Row> x) {
  return SurfaceContact(setup, x).penetrations(x);
}

std::vector<Penetration> find_nodes_out_of_reach(const SurfaceContactSetup& setup, std::span<const Row> x) {
  SurfaceContact contact(setup, x);
  const std::vector<double> reached = contact.inner_;
  if (std::none_of(reached.begin(), reached.end(), [](double inner) { return inner > 0.0; })) return {};
  for (double& inner : contact.inner_) inner /= pressing_depth;
  std::vector<Penetration> found = contact.penetrations(x);
  std::erase_if(found, [&](const Penetration& p) {
    const auto tracked =
        std::find_if(setup.nodes.begin(), setup.nodes.end(), [&p](const TrackedNode& t) { return t.node == p.node; });
    return reached[p.segment] == 0.0 || p.depth <= reached[p.segment] + 0.5 * tracked->thickness;
  });
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.depth > b.depth; });
  return found;
}

std::vector<Penetration> remove_penetrations(const SurfaceContactSetup& setup, std::span<Row> x, int passes) {
  const std::vector<Penetration> before = find_penetrations(setup, x);
  std::vector<Penetration> left = before;
  for (int pass = 0; pass < passes; ++pass) {
    bool moved = false;
    for (std::size_t i = 0; i < left.size(); ++i) {
      // Of several penetrations of a node only the first in the list is mended in a pass.
      if (i > 0 && left[i].node == left[i - 1].node) continue;
      const double thickness = setup.segments[left[i].segment].thickness;
      if (left[i].depth <= 1e-3 * thickness) continue;
      add(x[left[i].node], 0.5 * left[i].depth * left[i].direction);
      moved = true;
    }
    if (!moved) break;
    left = find_penetrations(setup, x);
  }
  return before;
}

Vec3d SurfaceContact::force_between(const TwoBodies& bodies) const {
  Vec3d sum;
  each_hit([&](const Hit& hit) {
    sum += bodies.sign({&setup_.nodes[hit.tracked].node, 1}, setup_.segments[hit.segment].node) * hit.force;
  });
  return sum;
}

void SurfaceContact::Block::archive(Archive& a) {
  a(first, next_check_travel, deep, pairs, hits);
  a.built(begin, end, old_first, old_pairs, candidates, resultant, deepest, lowest, highest, energies);
}

/// With the search lists: a pair remembers on which side it stands, and a search at another cycle would give other
/// last digits.
void SurfaceContact::archive(Archive& a) {
  a.section("contact of surfaces");
  a(forces_, active_nodes_, searched_at_, searched_, searches_, seen_at_, searched_when_, travelled_, moved_,
    active_segments_, blocks_, active_blocks_, energy_, resultant_, touching_, deepest_, frictions_, energies_);
  a.built(setup_, around_, segment_stiffness_, inner_, node_stiffness_, node_mass_, excluded_, stays_active_,
          thickest_segment_, pressing_, margin_, boxes_, tree_);
}

}  // namespace nugget::contact
