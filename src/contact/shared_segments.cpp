// SPDX-License-Identifier: Apache-2.0
// Segments of a surface contact by share (docs/decisions/0140, 0141): a rank holds those at the nodes whose forces it
// adds up and at the tracked nodes of its blocks, and, from a search to the next, those that its pairs press, with all
// around their corners. Their numbers are those of the whole surface, and what is written of them never changes.
#include <algorithm>
#include <cstring>
#include <iterator>

#include "base/bvh.hpp"
#include "base/cleared.hpp"
#include "base/free_room.hpp"
#include "base/index.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"
#include "system/exchange.hpp"
#include "system/share.hpp"

namespace nugget::contact {
namespace {

constexpr std::size_t boxed_together = 16;  // segments: one box of them stands for all

/// Around some segments of a rank.
struct RankBox {
  Box box;
  int rank = 0, number = 0;
};

/// Of two rising lists, what is in one of them.
std::vector<int> joined(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

void sort_once(std::vector<int>& list) {
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// Segments by number on their way to another rank.
template <class Face>
void append(std::vector<std::byte>& data, int number, const Face& face) {
  const std::size_t place = data.size();
  data.resize(place + sizeof number + sizeof face);
  std::memcpy(data.data() + place, &number, sizeof number);
  std::memcpy(data.data() + place + sizeof number, static_cast<const void*>(&face), sizeof face);
}

/// Puts them in their places; returns their numbers.
template <class Faces>
std::vector<int> take(const std::vector<std::vector<std::byte>>& arrived, Faces& faces) {
  std::vector<int> numbers;
  for (const std::vector<std::byte>& data : arrived)
    for (std::size_t place = 0; place < data.size();) {
      int number = 0;
      std::memcpy(&number, data.data() + place, sizeof number);
      std::memcpy(static_cast<void*>(&faces[number]), data.data() + place + sizeof number, sizeof faces[number]);
      place += sizeof number + sizeof faces[number];
      numbers.push_back(number);
    }
  sort_once(numbers);
  return numbers;
}

}  // namespace

/// Makes the segments and tracked nodes of a part, in their places among those of the whole surface; none is there yet.
void SurfaceContact::fill(const SurfaceContactSetup& part, std::span<const Row> x) {
  faces_ = ZeroedVector<Face>(outline_->segments);
  nodes_ = ZeroedVector<Tracked>(outline_->tracked.size());
  for (std::size_t i = 0; i < part.number.size(); ++i)
    faces_[part.number[i]] = face_of(part.segments[i], part.stiffness_scale, x);
  held_ = part.number;
  around_ = NodeSegments(faces_, held_);
  for (const TrackedNode& t : part.nodes) {
    const auto place = std::ranges::lower_bound(outline_->tracked, t.node) - outline_->tracked.begin();
    nodes_[at(static_cast<int>(place))] = tracked_of(t);
  }
}

/// For the costs of blocks, before anybody has a share: their tracked nodes, with the segments at these and within
/// reach.
void SurfaceContact::fill_near_own_blocks(const SurfaceSource& source, std::span<const Row> x) {
  std::vector<char> own(x.size());
  std::vector<BoxTree::Entry> boxes;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (!computes(b)) continue;
    Box box;
    for (int t = blocks_[b].begin; t < blocks_[b].end; ++t) {
      own[at(tracked_node(t))] = 1;
      box.add(vec(x[at(tracked_node(t))]));
    }
    boxes.push_back({box.grown(0.5 * outline_->thickest_node + margin_), static_cast<int>(b)});
  }
  const BoxTree tree(std::move(boxes));
  const auto is_own = [&](int n) { return own[at(n)] != 0; };
  const auto is_near = [&](const Segment& s) {
    if (std::ranges::any_of(s.node, is_own)) return true;
    Box box;
    for (const Vec3d& c : corners_of(s, x)) box.add(c);
    const double a = s.volume > 0.0 ? area(s, x) : 0.0;
    bool found = false;
    tree.overlapping(box.grown(0.5 * s.thickness + (a > 0.0 ? pressing_depth * s.volume / a : 0.0)),
                     [&](int) { found = true; });
    return found;
  };
  fill(source({is_near, is_own}), x);
}

/// At the start, once the shares are known. Where a segment has corners that no rank follows together all ranks make
/// the whole surface.
void SurfaceContact::fill_share(const SurfaceSource& source, std::span<const Row> x) {
  std::vector<char> marked(forces_.nodes().size());
  for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = share_->adds_up(forces_.nodes()[i]);
  std::vector<int> of_blocks;  // tracked nodes
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (int t = blocks_[b].begin; computes(b) && t < blocks_[b].end; ++t) {
      of_blocks.push_back(tracked_node(t));
      marked[forces_.place(of_blocks.back())] = 1;
    }
  bool by_share = !looks_everywhere_ && !results_need_hits_;
  int number = 0;
  const auto is_marked = [&](int n) { return marked[forces_.place(n)] != 0; };
  const auto is_own = [&](const Segment& s) {
    const int rank = by_share ? share_->follower_of_all(s.node, share_->answering(s.node[0])) : -1;
    by_share = by_share && rank >= 0;
    if (rank == rank_) boxed_.push_back(number);
    ++number;
    return by_share && std::ranges::any_of(s.node, is_marked);
  };
  const SurfaceContactSetup part = source({is_own, is_marked});
  if (by_share) {
    fill(part, x);
    at_own_ = held_;
    tracked_ghosts_.ask_for(*share_, std::move(of_blocks));
  } else {
    fill(source({[](const Segment&) { return true; }, [](int) { return true; }}), x);
    free_room(boxed_);
    free_room(held_);
  }
  by_share_ = by_share;
  outline_.reset();
}

/// The pairs of a restart file: their segments, from the ranks that follow the corners, and what goes by them.
void SurfaceContact::hold_what_was_read() {
  list_followed_nodes();
  if (by_share_) {
    std::vector<int> missing;
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      for (const Pair& pair : blocks_[b].pairs)
        if (computes(b)) missing.push_back(static_cast<int>(pair.segment));
    sort_once(missing);
    std::erase_if(missing, [this](int s) { return std::ranges::binary_search(held_, s); });
    const std::size_t count = at(share_->ranks().count());
    std::vector<std::vector<int>> wanted(count, missing), given;
    free_room(wanted[at(rank_)]);
    system::exchange(share_->ranks(), wanted, given);
    std::vector<std::vector<std::byte>> leaving(count), arrived;
    for (std::size_t r = 0; r < count; ++r)
      for (const int s : given[r])
        if (std::ranges::binary_search(boxed_, s)) append(leaving[r], s, faces_[s]);
    system::exchange(share_->ranks(), leaving, arrived);
    take(arrived, faces_);
    hold_segments_of_pairs();
  }
  if (searched_) ask_for_ghosts();
}

/// Others take no room any more.
void SurfaceContact::hold(std::vector<int> segments) {
  held_ = std::move(segments);
  around_ = NodeSegments(faces_, held_);
  std::size_t begin = 0;
  for (const int s : held_) {
    clear_range(faces_, begin, at(s));
    begin = at(s) + 1;
  }
  clear_range(faces_, begin, faces_.size());
}

/// Segments near the own blocks come from the ranks that follow their corners, which send all others boxes of their
/// segments before. Returns those that are here from then on.
std::vector<int> SurfaceContact::fetch_segments_near(const Step& step) {
  Ranks& ranks = share_->ranks();
  const int count = ranks.count();
  const std::span<const Row> x = step.x;
  tracked_ghosts_.fetch(*share_, step.shared->x, step.shared->v);
  std::vector<RankBox> boxes;
  for (std::size_t first = 0; first < boxed_.size(); first += boxed_together) {
    Box all;
    for (std::size_t i = first; i < std::min(boxed_.size(), first + boxed_together); ++i) {
      const Face& face = faces_[boxed_[i]];
      const bool whole = std::ranges::all_of(face.node, [&](int n) { return finite(x[n]); });
      if (whole && (face.side & pressing_) != 0 && alive(boxed_[i], step.element_alive)) all.add(box_of(face, x));
    }
    if (all.low.x <= all.high.x) boxes.push_back({all, rank_, static_cast<int>(first / boxed_together)});
  }
  boxes = gather_lists(ranks, boxes);
  std::vector<std::vector<int>> wanted(at(count)), given;
  {
    const Box within = box_of_own_blocks(x);
    std::vector<BoxTree::Entry> entries;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].rank != rank_ && boxes[i].box.overlaps(within))
        entries.push_back({boxes[i].box, static_cast<int>(i)});
    const BoxTree tree(std::move(entries));
    std::vector<int> near;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      if (!computes(b)) continue;
      Box around_block;
      for (int t = blocks_[b].begin; t < blocks_[b].end; ++t)
        if (const Row& place = x[nodes_[t].node]; finite(place)) around_block.add(around(blocks_[b], t, vec(place)));
      tree.overlapping(around_block, [&](int i) { near.push_back(i); });
    }
    sort_once(near);
    for (const int i : near) wanted[boxes[i].rank].push_back(boxes[i].number);
  }
  system::exchange(ranks, wanted, given);
  std::vector<std::vector<std::byte>> leaving(at(count)), arrived;
  for (int r = 0; r < count; ++r)
    for (const int number : given[r])
      for (std::size_t i = at(number) * boxed_together; i < std::min(boxed_.size(), (at(number) + 1) * boxed_together);
           ++i)
        append(leaving[r], boxed_[i], faces_[boxed_[i]]);
  system::exchange(ranks, leaving, arrived);
  const std::vector<int> near = take(arrived, faces_);
  std::vector<int> of_pairs;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (const Pair& pair : blocks_[b].pairs)
      if (computes(b)) of_pairs.push_back(static_cast<int>(pair.segment));
  sort_once(of_pairs);
  std::vector<int> here = joined(joined(at_own_, near), of_pairs), corners;
  for (const int s : here)
    for (const int n : faces_[s].node)
      if (!share_->follows(n)) corners.push_back(n);
  system::GhostNodes ghosts;
  ghosts.ask_for(*share_, std::move(corners));
  ghosts.fetch(*share_, step.shared->x, step.shared->v);
  return here;
}

/// After a search: those of the own pairs and all around their corners, which come from the ranks that answer for these
/// nodes and hold all at them.
void SurfaceContact::hold_segments_of_pairs() {
  Ranks& ranks = share_->ranks();
  std::vector<int> of_pairs;
  std::vector<std::vector<int>> wanted(at(ranks.count())), given;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (const Pair& pair : blocks_[b].pairs) {
      if (!computes(b)) continue;
      of_pairs.push_back(static_cast<int>(pair.segment));
      for (const int n : faces_[pair.segment].node)
        if (!share_->adds_up(n)) wanted[share_->answering(n)].push_back(n);
    }
  sort_once(of_pairs);
  std::ranges::for_each(wanted, sort_once);
  system::exchange(ranks, wanted, given);
  std::vector<std::vector<std::byte>> leaving(given.size()), arrived;
  for (std::size_t r = 0; r < given.size(); ++r) {
    std::vector<int> segments;
    for (const int n : given[r]) segments.insert(segments.end(), around_.at(n).begin(), around_.at(n).end());
    sort_once(segments);
    for (const int s : segments) append(leaving[r], s, faces_[s]);
  }
  system::exchange(ranks, leaving, arrived);
  hold(joined(joined(at_own_, of_pairs), take(arrived, faces_)));
}

}  // namespace nugget::contact
