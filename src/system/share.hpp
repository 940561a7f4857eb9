// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/ranks.hpp"
#include "base/runs.hpp"
#include "system/partition.hpp"

namespace nugget::system {

/// What one rank does of a run over several, and what it sends and receives for that (docs/decisions/0101).
///
/// Ranks number nodes, elements and slots alike, as one process does. A rank computes the elements of its share and
/// knows, in each cycle, all slots around the nodes that it follows: its own, and those that others send. It adds them
/// in the order in which one process does, so every rank that follows a node moves it by the same bits. Of a node that
/// everyone follows, but that only one rank's elements have, that rank sends the sum. Who follows a tied node or one
/// that it follows has its row of the constraint map too (FollowersOfNodes).
class Share {
 public:
  /// `followed`: by node, whether everyone follows it, besides those of FollowersOfNodes.
  Share(const System& system, Ranks& ranks, Partition partition, std::span<const char> followed);

  Ranks& ranks() const { return ranks_; }
  const Partition& partition() const { return partition_; }
  bool computes(int group, std::size_t e) const {
    const int rank = partition_.of_element(group, e);
    return rank == Partition::everyone || rank == ranks_.rank();
  }
  /// Whether this rank alone, or the first one where everyone does, computes it: who answers for it.
  bool answers_for(int group, std::size_t e) const {
    const int rank = partition_.of_element(group, e);
    return rank == ranks_.rank() || (rank == Partition::everyone && ranks_.rank() == 0);
  }

  using Block = std::pair<int, std::size_t>;  ///< group, block
  /// Blocks that this rank computes: those at nodes of others first, so that their slots are on the way meanwhile.
  const std::vector<Block>& blocks() const { return blocks_; }
  std::size_t border_blocks() const { return border_blocks_; }

  /// Sends the slots of own elements at nodes that others follow.
  void send(const Slots& slots, const SingleSlots& single);
  /// Waits for those of others, and puts them in their places.
  void receive(Slots& slots, SingleSlots& single);
  /// Sends and receives the sums of nodes that are summed by one rank and followed by everyone.
  void exchange_sums(std::span<Row> force, std::span<Row> moment);
  struct Range {
    int begin, end;
  };
  /// Ranges of nodes that this rank follows, bodies' and anchors' virtual ones included.
  const std::vector<Range>& followed() const { return followed_; }

  bool everyone_follows(int node) const { return node >= nodes() || everyone_follows_[node] != 0; }
  /// Whether this rank follows a node.
  bool follows(int node) const { return everyone_follows(node) || adds_up(node); }
  /// The ranks that add up the forces on a node, rising: those that follow it; of a node that everyone follows the one
  /// whose sum travels. None stand for all of them.
  std::span<const int> adding(int node) const {
    if (node >= nodes()) return {};
    return std::span(adding_).subspan(first_adding_[node], first_adding_[node + 1] - first_adding_[node]);
  }
  /// Whether this rank is one of them.
  bool adds_up(int node) const {
    const std::span<const int> some = adding(node);
    return some.empty() || std::ranges::binary_search(some, ranks_.rank());
  }
  /// The first of them, who answers for the node.
  int answering(int node) const { return adding(node).empty() ? 0 : adding(node).front(); }
  static constexpr int nobody = -1;
  /// The first rank that follows all these nodes, or `nobody`; `of_all` where every rank does.
  int follower_of_all(std::span<const int> nodes, int of_all) const;
  /// The first rank that adds up the forces on all these nodes, or `nobody`; `of_all` where every rank does.
  int adder_of_all(std::span<const int> nodes, int of_all) const;
  /// Nodes that not all ranks follow, rising, by the rank that answers for them.
  const Runs& reported_by(int rank) const { return reported_[rank]; }
  /// The rows of these nodes come to all ranks.
  void spread(std::span<Row> of_nodes) const;
  /// Rows, or numbers, of nodes that this rank does not follow take no room any more, until somebody writes them.
  template <class T>
  void forget_others(ZeroedVector<T>& of_nodes) const {
    std::size_t begin = 0;
    for (const Range& range : followed_) {
      forget(of_nodes, begin, std::min(static_cast<std::size_t>(range.begin), of_nodes.size()));
      begin = static_cast<std::size_t>(range.end);
    }
    forget(of_nodes, begin, of_nodes.size());
  }

 private:
  struct Row3 {
    double x, y, z;
  };
  /// Slots, or nodes, of one rank that others need, in one order for sender and receivers.
  struct Message {
    int from;
    std::vector<int> to;
    std::vector<std::size_t> slots;  ///< moments have their own
    std::vector<Row3> data;
  };
  struct Sums {
    std::vector<int> nodes;
    std::vector<char> turns;  ///< by node: a moment follows
    std::vector<Row3> data;
  };
  int nodes() const { return static_cast<int>(everyone_follows_.size()); }
  template <class Ignored>
  int first_of_all(std::span<const int> nodes, int of_all, const Ignored& ignored) const;

  Ranks& ranks_;
  Partition partition_;
  std::vector<Block> blocks_;
  std::size_t border_blocks_ = 0;
  std::vector<Message> out_, in_;
  std::vector<Sums> sums_;  ///< by rank
  std::vector<Range> followed_;
  std::vector<char> everyone_follows_;  ///< by node; virtual ones all follow
  std::vector<std::uint32_t> first_adding_;
  std::vector<int> adding_;     ///< ranks, from `first_adding_` on of each node
  std::vector<Runs> reported_;  ///< by rank
};

}  // namespace nugget::system
