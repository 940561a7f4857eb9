// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "system/partition.hpp"

namespace nugget::system {

/// Of one node in a run over several ranks: whose elements it has, and which ranks move it (docs/decisions/0101, 0119).
struct Followers {
  std::span<const int> owners;  ///< ranks whose elements it has, rising, without elements that all ranks compute
  std::span<const int> others;  ///< ranks that follow it besides, rising: it is tied to nodes of theirs
  bool of_everyone = false;     ///< it has elements that all ranks compute
  bool turns = false;           ///< it has elements with moments
  bool all = false;             ///< every rank follows it

  bool owned_by(int rank) const { return std::ranges::binary_search(owners, rank); }
  /// Of a node that not all follow.
  bool has(int rank) const { return owned_by(rank) || std::ranges::binary_search(others, rank); }
};

/// Followers of each node. All follow those of `for_everyone` (by node; empty: none), those that have elements of
/// everyone, those of bodies and anchors, and those that nobody's elements have. Who follows a node follows all nodes
/// of the rows of the constraint map in which it stands, and so on: forces on a tied node end up at those that it
/// follows.
class FollowersOfNodes {
 public:
  FollowersOfNodes(const System& system, const Partition& partition, std::span<const char> for_everyone);

  std::size_t size() const { return of_node_.size(); }
  /// As long as these here last.
  Followers operator[](std::size_t node) const {
    const OfNode& of = of_node_[node];
    return {sets_[of.owners], sets_[of.others], of.of_everyone, of.turns, of.all};
  }

 private:
  /// Sets of ranks: most nodes have one of a few.
  struct OfNode {
    int owners = 0, others = 0;  ///< in sets_
    bool of_everyone = false, turns = false, all = false;
  };
  int number_of(std::vector<int> ranks);
  /// Of a set with one more rank.
  int with(int set, int rank);

  std::vector<OfNode> of_node_;
  std::deque<std::vector<int>> sets_;        ///< the first one is empty
  std::map<std::vector<int>, int> number_;   ///< of each
  std::map<std::pair<int, int>, int> with_;  ///< by set and rank
};

/// Calls `visit(group number, group, element, corner, node)` with each node of each element; not with the ground.
template <class Visit>
void each_corner(const System& system, const Visit& visit) {
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const ElementGroup& group = *system.groups[g];
    for (std::size_t e = 0; e < group.size(); ++e) {
      const ElementNodes nodes = group.nodes(e);
      for (int a = 0; a < group.nodes_per_element; ++a)
        if (nodes[a] >= 0) visit(static_cast<int>(g), group, e, a, nodes[a]);
    }
  }
}

}  // namespace nugget::system
