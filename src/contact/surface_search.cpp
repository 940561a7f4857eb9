// SPDX-License-Identifier: Apache-2.0
// Which segments are near a node.
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "base/bvh.hpp"
#include "base/free_room.hpp"
#include "base/parallel.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"
#include "system/share.hpp"

namespace nugget::contact {
namespace {

constexpr std::size_t nodes_per_group = 4096;
constexpr double nodes_close_together = 16.0;  // side of their box, in margins: four elements

FourReals four_of(const Vec3d& a) {
  return FourReals{a.x, a.y, a.z, 0.0};
}

/// Displacement of a point that was `seen`; it is seen where it is now.
FourReals step_of(Vec3d& seen, const Row& x) {
  const FourReals now = four(x), step = now - four_of(seen);
  seen = {now[0], now[1], now[2]};
  return step;
}

/// Around displacements.
struct DisplacementBox {
  FourReals low = FourReals{} + Box::infinity, high = FourReals{} - Box::infinity;

  void add(const FourReals& d) {
    low = d < low ? d : low;
    high = high < d ? d : high;
  }
  Box box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }
};

}  // namespace

/// By how much two of the active points can have approached each other if the i-th was displaced by `displacement(i)`:
/// no more than the diagonal of the box of all displacements, whatever the surface does as a whole.
template <class Displacement>
double SurfaceContact::approach(const Displacement& displacement) {
  if (active_nodes_.empty()) return 0.0;
  const std::size_t count = share_ != nullptr ? followed_.size() : active_nodes_.size();
  moved_.resize((count + nodes_per_group - 1) / nodes_per_group);
  parallel_for(moved_.size(), 1, [this, count, &displacement](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) {
      DisplacementBox box;
      for (std::size_t i = g * nodes_per_group; i < std::min(count, (g + 1) * nodes_per_group); ++i)
        box.add(displacement(share_ != nullptr ? at(followed_[i]) : i));
      moved_[g] = box.box();
    }
  });
  Box all;
  for (const Box& box : moved_) all.add(box);
  if (share_ != nullptr) all = over_all_ranks(all);
  return norm(all.high - all.low);
}

bool SurfaceContact::moved_too_far(std::span<const Row> x) {
  travelled_ += approach([this, &x](std::size_t i) { return step_of(seen_at_[i], x[active_nodes_[i]]); });
  // Steps added up are never less than the whole way: while they are short that need not be measured.
  return travelled_ - searched_when_ > margin_ && !lists_are_good_for(x);
}

/// Whether no two points have come closer by more than the margin since the search.
bool SurfaceContact::lists_are_good_for(std::span<const Row> x) {
  return approach([this, &x](std::size_t i) { return four(x[active_nodes_[i]]) - four_of(searched_at_[i]); }) <=
         margin_;
}

/// The same of the nodes of a block's pairs, which most often move much like each other.
void SurfaceContact::follow(Block& block, std::span<const Row> x) {
  if (block.near.empty()) return;
  DisplacementBox moved;
  for (std::size_t i = 0; i < block.near.size(); ++i) moved.add(step_of(block.seen[i], x[block.near[i]]));
  const Box box = moved.box();
  block.travelled += norm(box.high - box.low);
}

/// Lists the nodes of a block's pairs, from now on to be followed.
void SurfaceContact::list_near(Block& block, std::span<const Row> x) const {
  std::vector<int> near;
  for (int t = block.begin; t < block.end; ++t) {
    if (block.first[t - block.begin] < block.first[t - block.begin + 1]) near.push_back(nodes_[t].node);
    for (int i = block.first[t - block.begin]; i < block.first[t - block.begin + 1]; ++i)
      for (const int n : faces_[block.pairs[i].segment].node) near.push_back(n);
  }
  std::ranges::sort(near);
  near.erase(std::unique(near.begin(), near.end()), near.end());
  block.near.assign(near.begin(), near.end());
  block.seen.clear();
  block.seen.reserve(near.size());
  for (const int n : near) block.seen.push_back(vec(x[n]));
}

void SurfaceContact::search(const Step& step) {
  if (share_ != nullptr && !by_share_) share_->spread(step.shared->x);
  if (by_share_) held_ = fetch_segments_near(step);
  list_active_nodes(step);
  if (share_ != nullptr) list_followed_nodes();
  searched_at_ = places_of_active_nodes(step.x);
  free_room(seen_at_);  // the tree takes more
  list_all(step.x, step.element_alive);
  seen_at_ = places_of_active_nodes(step.x);
  if (by_share_) hold_segments_of_pairs();
  if (share_ != nullptr) ask_for_ghosts();
  searched_ = true;
  searched_when_ = travelled_;
  ++searches_;
}

void SurfaceContact::list_active_nodes(const Step& step) {
  const auto is_active = [&](int n) { return node_alive(n, step.element_alive) && finite(step.x[n]); };
  active_nodes_.clear();
  active_nodes_.reserve(forces_.nodes().size());
  if (!by_share_) {
    for (int n : forces_.nodes())
      if (is_active(n)) active_nodes_.push_back(n);
    return;
  }
  std::vector<int> inactive;
  for (const int place : answered_[rank_])
    if (const int n = forces_.nodes()[at(place)]; !is_active(n)) inactive.push_back(n);
  for (int n : forces_.nodes())
    if (share_->adding(n).empty() && rank_ == 0 && !is_active(n)) inactive.push_back(n);
  inactive = gather_lists(share_->ranks(), inactive);
  std::ranges::sort(inactive);
  std::ranges::set_difference(forces_.nodes(), inactive, std::back_inserter(active_nodes_));
}

/// Lists the pairs of all blocks that this process looks at.
void SurfaceContact::list_all(std::span<const Row> x, std::span<const unsigned char> element_alive) {
  const Box within = box_of_own_blocks(x);
  std::vector<BoxTree::Entry> boxes;
  const auto add = [&](int s) {
    const Face& face = faces_[s];
    const bool whole = std::all_of(face.node.begin(), face.node.end(), [&](int n) { return finite(x[n]); });
    if (!whole || !(face.side & pressing_) || !alive(s, element_alive)) return;
    const Box box = box_of(face, x);
    if (!rank_of_block_.empty() && !box.overlaps(within)) return;
    boxes.push_back({box, s});
  };
  boxes.reserve(held());
  if (holds_some())
    std::ranges::for_each(held_, add);
  else
    for (std::size_t s = 0; s < faces_.size(); ++s) add(static_cast<int>(s));
  const BoxTree tree(std::move(boxes));
  parallel_for(blocks_.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
      if (computes(b)) list_neighbours(blocks_[b], tree, work_of_thread(), x, element_alive);
  });
}

ZeroedVector<Vec3d> SurfaceContact::places_of_active_nodes(std::span<const Row> x) const {
  ZeroedVector<Vec3d> places(active_nodes_.size());
  const auto put = [&](std::size_t i) { places[i] = vec(x[active_nodes_[i]]); };
  if (share_ != nullptr)
    for (const int i : followed_) put(at(i));
  for (std::size_t i = 0; share_ == nullptr && i < places.size(); ++i) put(i);
  return places;
}

/// Makes the lists of the nodes of a block anew; what their pairs remember goes on.
void SurfaceContact::list_neighbours(Block& block, const BoxTree& tree, Work& work, std::span<const Row> x,
                                     std::span<const unsigned char> element_alive) const {
  const auto by_segment = [](const Pair& a, const Pair& b) { return a.segment < b.segment; };
  follow(block, x);
  std::vector<Pair>& listed = work.listed;
  listed.clear();
  if (block.first.empty()) {
    block.first.assign(at(block.end - block.begin + 1), 0);
    block.next_check_travel.assign(at(block.end - block.begin), 0.0);
    block.widest.assign(at(block.end - block.begin), 0.0);
  }
  int next_old = 0, end_of_group = block.begin;
  for (int t = block.begin; t < block.end; ++t) {
    const auto start = static_cast<std::ptrdiff_t>(listed.size());
    const std::span<Pair> old = std::span(block.pairs).subspan(next_old, block.first[t - block.begin + 1] - next_old);
    next_old = block.first[t - block.begin + 1];
    block.first[t - block.begin] = static_cast<int>(start);
    const Tracked& tracked = nodes_[t];
    if (!finite(x[tracked.node]) || !node_alive(tracked.node, element_alive)) {
      for (Pair& pair : old) {
        if (block.pressed(pair)) block.energies.deleted += block.touch_of(pair)->held();
        block.release(pair);
      }
      continue;
    }
    if (t >= end_of_group) end_of_group = find_around(block, t, tree, work, x);
    const Vec3d p = vec(x[tracked.node]);
    const Box box = around(block, t, p);
    for (const auto& [segment, its_box] : work.around) {
      if (!its_box.overlaps(box)) continue;
      const Face& face = faces_[segment];
      const double far = contact_distance(t, segment) + reach(block, t, segment) + margin_;
      if (!(face.side & tracked.against) || face.has(tracked.node) || meets_at_place(places_, face, tracked.node))
        continue;
      const kernel::Corners corners = corners_of(face, x);
      if (kernel::least_distance(corners, p) > far) continue;
      const kernel::Foot foot = kernel::closest_point(corners, face.triangle(), p);
      if (foot.distance > far) continue;
      Pair pair;
      pair.segment = static_cast<unsigned>(segment) & 0x7fffffffu;
      pair.xi = foot.xi;
      pair.eta = foot.eta;
      pair.next_check_travel = block.travelled + (foot.distance - reach(block, t, segment));  // less the widest
      listed.push_back(pair);
    }
    std::sort(listed.begin() + start, listed.end(), by_segment);
    double widest = 0.0;
    const auto widen = [&](const Pair& pair) {
      widest = std::max(widest, contact_distance(t, static_cast<int>(pair.segment)));
    };
    std::for_each(listed.begin() + start, listed.end(), widen);
    for (const Pair& was : old)
      if (was.touch != none) widen(was);
    const double grown = std::max(0.0, widest - std::exchange(block.widest[at(t - block.begin)], widest));
    for (auto pair = listed.begin() + start; pair != listed.end(); ++pair) {
      const auto was = std::lower_bound(old.begin(), old.end(), *pair, by_segment);
      const bool is_kept = was != old.end() && was->segment == pair->segment;
      if (is_kept)
        *pair = *was;
      else
        pair->near_own = is_near_own(tracked.node, faces_[pair->segment]) ? 1 : 0;
      pair->next_check_travel -= is_kept ? grown : widest;
    }
    const auto end = static_cast<std::ptrdiff_t>(listed.size());
    bool wakes = !element_alive.empty();  // what hid others may be gone
    for (Pair& was : old) {
      if (was.touch == none || std::binary_search(listed.begin() + start, listed.begin() + end, was, by_segment))
        continue;
      const bool pressed = block.pressed(was);
      if (pressed && alive(static_cast<int>(was.segment), element_alive)) {
        listed.push_back(was);
        continue;
      }
      if (pressed) block.energies.deleted += block.touch_of(was)->held();
      block.release(was);
      wakes = true;
    }
    for (auto pair = listed.begin() + start; wakes && pair != listed.end(); ++pair)
      pair->next_check_travel = std::min(pair->next_check_travel, block.travelled);
    if (static_cast<std::ptrdiff_t>(listed.size()) > end) std::sort(listed.begin() + start, listed.end(), by_segment);
  }
  block.first.back() = static_cast<int>(listed.size());
  block.pairs.assign(listed.begin(), listed.end());
  list_near(block, x);
  if (listed.empty()) {
    block.clear_hits();
    block.energies.springs = 0.0;
  }
  std::fill(block.next_check_travel.begin(), block.next_check_travel.end(), 0.0);
  block.asleep_until = 0.0;
}

/// All that is within reach of the nodes of blocks that this process looks at.
Box SurfaceContact::box_of_own_blocks(std::span<const Row> x) const {
  Box all;
  if (rank_of_block_.empty()) return all;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!computes(b)) continue;
    for (int t = blocks_[b].begin; t < blocks_[b].end; ++t)
      if (finite(x[nodes_[t].node])) all.add(around(blocks_[b], t, vec(x[nodes_[t].node])));
  }
  return all;
}

/// All that is within reach of a node at `p`.
Box SurfaceContact::around(const Block& block, int tracked, const Vec3d& p) const {
  return Box{p, p}.grown(0.5 * nodes_[tracked].thickness + margin_ + block.depth_of(tracked));
}

/// Finds the segments around the nodes of a block from `first` on, as many of them as stand close together, in one walk
/// through the tree: neighbours find the same. Returns the end of these nodes.
int SurfaceContact::find_around(const Block& block, int first, const BoxTree& tree, Work& work,
                                std::span<const Row> x) const {
  Box all;
  int end = first;
  for (; end < block.end; ++end) {
    const int node = nodes_[end].node;
    if (!finite(x[node])) continue;
    Box more = all;
    more.add(around(block, end, vec(x[node])));
    const Vec3d size = more.high - more.low;
    if (end > first && std::max({size.x, size.y, size.z}) > nodes_close_together * margin_) break;
    all = more;
  }
  work.around.clear();
  tree.overlapping(all, [&](int segment) { work.around.emplace_back(segment, box_of(faces_[segment], x)); });
  return end;
}

/// The box of a segment with its skin and all that it presses behind it.
Box SurfaceContact::box_of(const Face& face, std::span<const Row> x) {
  Box box;
  for (const Vec3d& c : corners_of(face, x)) box.add(c);
  return box.grown(0.5 * face.thickness + face.inner);
}

/// Whether a segment has a corner of one of the node's own segments.
bool SurfaceContact::is_near_own(int node, const Facet& segment) const {
  const std::span<const int> around = around_.at(node);
  return std::any_of(around.begin(), around.end(), [&](int own) {
    return std::any_of(segment.node.begin(), segment.node.end(), [&](int n) { return faces_[own].has(n); });
  });
}

}  // namespace nugget::contact
