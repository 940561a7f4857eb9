// SPDX-License-Identifier: Apache-2.0
// A surface contact over several ranks (docs/decisions/0115): each looks at blocks of tracked nodes that it mostly
// follows, at places that other ranks send where it follows not, and sends hits to the ranks that add up the forces on
// their nodes.
#include <algorithm>
#include <array>
#include <cstring>
#include <utility>

#include "base/free_room.hpp"
#include "contact/surface_contact.hpp"
#include "contact/surface_work.hpp"
#include "system/exchange.hpp"
#include "system/parcel.hpp"
#include "system/share.hpp"

namespace nugget::contact {
namespace {

/// Before the hits of a block in a message.
struct BlockHead {
  int block = 0, hits = 0;
};

void append(std::vector<std::byte>& data, const void* from, std::size_t size) {
  const std::size_t place = data.size();
  data.resize(place + size);
  std::memcpy(data.data() + place, from, size);
}

template <class T>
void carry_list(system::Parcel& parcel, std::vector<T>& list) {
  std::size_t size = list.size();
  parcel(&size, 1);
  list.resize(size);
  parcel(list.data(), size);
}

}  // namespace

/// A block goes to the rank that adds up the forces on most of its nodes; one of nodes that all add up, to the next in
/// turn.
void SurfaceContact::take_share(const SharedNodes& shared, const SurfaceSource& source) {
  if (share_ == &shared.share) return;
  share_ = &shared.share;
  const int count = share_->ranks().count();
  rank_ = share_->ranks().rank();
  rank_of_block_.clear();
  std::vector<int> nodes_of(at(count));
  for (const Block& block : blocks_) {
    std::ranges::fill(nodes_of, 0);
    for (int t = block.begin; t < block.end; ++t)
      if (const std::span<const int> some = share_->adding(tracked_node(t)); !some.empty()) ++nodes_of[some.front()];
    const auto most = std::ranges::max_element(nodes_of);
    rank_of_block_.push_back(*most > 0 ? static_cast<int>(most - nodes_of.begin())
                                       : static_cast<int>(rank_of_block_.size() % at(count)));
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    if (!computes(b)) leave(blocks_[b]);
  std::vector<char> left_out;
  others_add_.clear();
  answered_.assign(at(count), {});
  out_.resize(at(count));
  hits_for_.resize(at(count));
  for (std::size_t i = 0; i < forces_.nodes().size(); ++i) {
    const int node = forces_.nodes()[i];
    const std::span<const int> adding = share_->adding(node);
    if (!adding.empty()) answered_[adding.front()].add(static_cast<int>(i));
    left_out.push_back(!looks_everywhere_ && !share_->adds_up(node));
    others_add_.push_back(looks_everywhere_ || adding.size() != 1 || adding.front() != rank_);
  }
  forces_.leave_out(std::move(left_out));
  rank_of_part_.clear();
  const std::span<const int> nodes = forces_.nodes();
  for (std::size_t begin = 0; begin < nodes.size(); begin += NodalForces::part_size) {
    const std::size_t size = std::min<std::size_t>(NodalForces::part_size, nodes.size() - begin);
    rank_of_part_.push_back(looks_everywhere_ ? 0 : share_->adder_of_all(nodes.subspan(begin, size), 0));
  }
  list_followed_nodes();
  if (outline_ != nullptr) fill_share(source, shared.x);
  if (searched_) ask_for_ghosts();
}

void SurfaceContact::leave(Block& block) {
  block.clear_hits();
  free_room(block.first);
  free_room(block.near);
  free_room(block.seen);
  free_room(block.next_check_travel);
  free_room(block.widest);
  free_room(block.deep);
  free_room(block.pairs);
  free_room(block.touches);
  free_room(block.free);
}

void SurfaceContact::list_followed_nodes() {
  followed_.clear();
  for (std::size_t i = 0; i < active_nodes_.size(); ++i)
    if (share_->follows(active_nodes_[i])) followed_.push_back(static_cast<int>(i));
}

/// The pairs of a block look at the tracked node, the corners of the segment, and at all segments at any of these. At
/// the start and after each search.
void SurfaceContact::ask_for_ghosts() {
  std::vector<char> corner(forces_.nodes().size());
  at_border_.assign(blocks_.size(), 0);
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = blocks_[b];
    if (!computes(b) || block.pairs.empty()) continue;
    const auto look_at = [&](int node) {
      corner[forces_.place(node)] = 1;
      at_border_[b] = at_border_[b] | others_add_[forces_.place(node)];
    };
    for (int t = block.begin; t < block.end; ++t) look_at(nodes_[t].node);
    for (const Pair& pair : block.pairs) std::ranges::for_each(faces_[pair.segment].node, look_at);
  }
  std::vector<char> wanted = corner;
  const auto look_around = [&](const Face& face) {
    if (std::ranges::any_of(face.node, [&](int n) { return corner[forces_.place(n)] != 0; }))
      for (const int n : face.node) wanted[forces_.place(n)] = 1;
  };
  for (const int s : held_) look_around(faces_[s]);
  for (std::size_t s = 0; !by_share_ && s < faces_.size(); ++s) look_around(faces_[s]);
  std::vector<int> nodes;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] != 0) nodes.push_back(forces_.nodes()[i]);
  ghosts_.ask_for(*share_, std::move(nodes));
}

/// Over several ranks each looks at as many blocks in a row; they follow each other along a curve through space.
void SurfaceContact::add_costs(std::span<const Row> x, system::ContactCosts& costs, Ranks* ranks,
                               const SurfaceSource& source) {
  if (!costs_something()) return;
  if (ranks != nullptr) {
    rank_ = ranks->rank();
    for (std::size_t b = 0; b < blocks_.size(); ++b)
      rank_of_block_.push_back(static_cast<int>(b * at(ranks->count()) / blocks_.size()));
  }
  if (outline_ != nullptr) fill_near_own_blocks(source, x);
  list_all(x, {});
  const auto touches = [&](const Block&, int t, const Pair& pair) {
    const kernel::Corners corners = corners_of(faces_[pair.segment], x);
    return kernel::least_distance(corners, vec(x[at(nodes_[t].node)])) <= contact_distance(t, pair.segment);
  };
  OwnCosts own = costs_of_own_blocks(touches, [](int, const Pair&) { return true; });
  forget_lists();
  if (outline_ != nullptr) {
    free_room(faces_);
    free_room(nodes_);
    around_ = {};
    free_room(held_);
  }
  rank_of_block_.clear();
  costs.of_node.resize(x.size());
  add_to_first(std::move(own), costs, ranks);
}

void SurfaceContact::add_costs_now(std::size_t nodes, system::ContactCosts& costs, Ranks* ranks) const {
  if (!costs_something()) return;
  costs.of_node.resize(nodes);
  const auto is_awake = [](const Block& block, int, const Pair& pair) {
    return pair.next_check_travel <= block.travelled;
  };
  const auto touches = [](int, const Pair& pair) { return pair.touch != none; };
  add_to_first(costs_of_own_blocks(is_awake, touches), costs, ranks);
}

bool SurfaceContact::costs_something() const {
  return (!faces_.empty() || outline_ != nullptr) && !(birth_ > 0.0);
}

template <class IsAwake, class Touches>
SurfaceContact::OwnCosts SurfaceContact::costs_of_own_blocks(const IsAwake& is_awake, const Touches& touches) const {
  constexpr double awake = 8.0, node = 1.0;
  OwnCosts own;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Block& block = blocks_[b];
    for (int t = block.begin; computes(b) && t < block.end; ++t) {
      OwnCosts::OfNode& cost = own.of_nodes.emplace_back(OwnCosts::OfNode{nodes_[t].node, node});
      if (block.first.empty()) continue;
      for (int i = block.first[t - block.begin]; i < block.first[t - block.begin + 1]; ++i) {
        const Pair& pair = block.pairs[i];
        const bool looks = is_awake(block, t, pair);
        cost.value += looks ? awake : 1.0;
        if (looks && touches(t, pair)) own.pairs.push_back({nodes_[t].node, faces_[pair.segment].node[0]});
      }
    }
  }
  return own;
}

void SurfaceContact::add_to_first(OwnCosts own, system::ContactCosts& costs, Ranks* ranks) {
  const auto add = [&](const auto& of_nodes, const auto& pairs) {
    for (const OwnCosts::OfNode& cost : of_nodes) costs.of_node[at(cost.node)] += cost.value;
    costs.together.insert(costs.together.end(), pairs.begin(), pairs.end());
  };
  if (ranks == nullptr || ranks->rank() == 0) {  // a message to itself there is none
    add(own.of_nodes, own.pairs);
    own = {};
  }
  if (ranks == nullptr) return;
  std::vector<std::vector<OwnCosts::OfNode>> costs_to(at(ranks->count())), costs_from;
  std::vector<std::vector<std::array<int, 2>>> pairs_to(costs_to.size()), pairs_from;
  costs_to[0] = std::move(own.of_nodes);
  pairs_to[0] = std::move(own.pairs);
  system::exchange(*ranks, costs_to, costs_from);
  system::exchange(*ranks, pairs_to, pairs_from);
  for (std::size_t r = 1; ranks->rank() == 0 && r < costs_from.size(); ++r) add(costs_from[r], pairs_from[r]);
}

/// As before the first search.
void SurfaceContact::forget_lists() {
  for (Block& block : blocks_) {
    free_room(block.pairs);
    free_room(block.near);
    free_room(block.seen);
    std::ranges::fill(block.first, 0);
    std::ranges::fill(block.next_check_travel, 0.0);
    std::ranges::fill(block.widest, 0.0);
    block.asleep_until = 0.0;
  }
  free_room(active_nodes_);
  free_room(searched_at_);
  free_room(seen_at_);
  searched_ = false;
  searches_ = 0;
}

Box SurfaceContact::over_all_ranks(const Box& own) const {
  Box all;
  for (const Box& of_rank : gather(share_->ranks(), own))
    if (of_rank.low.x <= of_rank.high.x) all.add(of_rank);  // a rank may follow none
  return all;
}

/// Hits go to the ranks that add up the forces on one of their nodes, and there to the same place in the order of
/// blocks and hits.
void SurfaceContact::exchange_hits() {
  for (std::vector<std::byte>& data : out_) data.clear();
  for (const int b : arrived_) blocks_[b].clear_hits();
  arrived_.clear();
  for (const int b : active_blocks_)
    if (at_border_[b]) put_hits(b);
  system::exchange(share_->ranks(), out_, in_);
  for (const std::vector<std::byte>& data : in_)
    for (std::size_t place = 0; place < data.size();) {
      BlockHead head;
      std::memcpy(&head, data.data() + place, sizeof head);
      place += sizeof head;
      Block& block = blocks_[head.block];
      block.hits.resize(at(head.hits));
      std::memcpy(static_cast<void*>(block.hits.data()), data.data() + place, block.hits.size() * sizeof(Hit));
      place += block.hits.size() * sizeof(Hit);
      share_out(block);
      arrived_.push_back(head.block);
    }
  std::ranges::sort(arrived_);
}

/// Puts the hits of a block into the messages to those who add up the forces on one of their nodes.
void SurfaceContact::put_hits(int b) {
  const Block& block = blocks_[b];
  const int count = static_cast<int>(out_.size());
  for (std::vector<int>& hits : hits_for_) hits.clear();
  for (std::size_t h = 0; h < block.hits.size(); ++h) {
    const int hit = static_cast<int>(h);
    const auto give = [&](int rank) {
      std::vector<int>& hits = hits_for_[rank];
      if (rank != rank_ && (hits.empty() || hits.back() != hit)) hits.push_back(hit);
    };
    const auto give_for = [&](int node) {
      if (others_add_[forces_.place(node)] == 0) return;
      const std::span<const int> some = looks_everywhere_ ? std::span<const int>() : share_->adding(node);
      for (const int rank : some) give(rank);
      for (int rank = 0; some.empty() && rank < count; ++rank) give(rank);
    };
    give_for(nodes_[block.hits[h].tracked].node);
    for (const int n : faces_[block.hits[h].segment].node) give_for(n);
  }
  for (int r = 0; r < count; ++r) {
    if (hits_for_[r].empty()) continue;
    const BlockHead head{b, static_cast<int>(hits_for_[r].size())};
    append(out_[r], &head, sizeof head);
    for (const int hit : hits_for_[r]) append(out_[r], &block.hits[hit], sizeof(Hit));
  }
}

void SurfaceContact::carry(int rank, system::Carried what, system::Parcel& parcel) {
  if (share_ == nullptr) return;  // before the first forces of several ranks everyone has everything
  if (what == system::Carried::restart) return;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    if (rank_of_block_[b] != rank) continue;
    Block& block = blocks_[b];
    parcel(&block.energies, 1);
    parcel(&block.resultant, 1);
    parcel(&block.deepest, 1);
    if (!results_need_hits_) continue;
    carry_list(parcel, block.hits);
    if (parcel.reading()) arrived_.push_back(static_cast<int>(b));
  }
  // Histories show what pressed, and nothing of the work.
  if (what == system::Carried::histories) return;
  // The first rank has what all add up.
  for (std::size_t p = 0; rank != 0 && p < rank_of_part_.size(); ++p)
    if (rank_of_part_[p] == rank) forces_.carry_sum(p, parcel);
  for (const int place : answered_[rank])
    if (rank_of_part_[at(place) / NodalForces::part_size] == system::Share::nobody) forces_.carry(place, parcel);
}

/// Of a node, by its place among all that this contact can press, the rank that answers for the forces on it.
std::function<int(std::size_t)> SurfaceContact::giver_of_places() const {
  if (share_ == nullptr) return {};
  return [this](std::size_t place) {
    const std::span<const int> adding = share_->adding(forces_.nodes()[place]);
    return adding.empty() ? Archive::everyone : adding.front();
  };
}

Archive::Holders SurfaceContact::holders_of_active_nodes() const {
  if (share_ == nullptr) return {};
  return {[this](std::size_t i) {
            const std::span<const int> adding = share_->adding(active_nodes_[i]);
            return adding.empty() ? Archive::everyone : adding.front();
          },
          [this](std::size_t i) { return share_->follows(active_nodes_[i]); }};
}

Archive::Holders SurfaceContact::holders_of_blocks() const {
  if (share_ == nullptr) return {};
  return {[this](std::size_t b) { return rank_of_block_[b]; }, [this](std::size_t b) { return computes(b); }};
}

}  // namespace nugget::contact
