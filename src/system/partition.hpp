// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/index.hpp"
#include "system/system.hpp"

namespace nugget::system {

/// What contact costs, for a partition.
struct ContactCosts {
  std::vector<double> of_node;               ///< in any measure; empty: there is no contact
  std::vector<std::array<int, 2>> together;  ///< nodes that look at each other
};
/// Whether elements are deleted, by group and element; empty: as the system has it.
using DeletedElements = std::vector<std::vector<char>>;

/// Which rank computes which elements. Elements go to ranks by units, so many as the widest block of their group holds,
/// whatever the width of this machine's: the partition is the same everywhere.
class Partition {
 public:
  static constexpr int everyone = -1;  ///< in place of a rank: all of them compute the unit

  /// Cuts the graph of units that share nodes by METIS so that all ranks have about the same cost (`element_cost`;
  /// deleted elements cost nothing), about the same in contact, and few nodes lie on several. `for_everyone`: elements
  /// whose state is looked at by what is computed on all ranks; so are all springs. As ranks wait for each other
  /// between elements and contact, both must be even on their own. What is joined by welds, springs and ties, or rests
  /// on each other, is kept together. `of_one_rank`: lists of elements that one rank must compute, those of a weld;
  /// where lists share so many units that much would hang together, everyone computes them.
  Partition(const System& system, int ranks, std::span<const System::ElementLocation> for_everyone,
            const ContactCosts& contact = {}, std::span<const std::vector<System::ElementLocation>> of_one_rank = {},
            DeletedElements deleted = {});

  /// Of which nothing is known yet: to be taken from the first rank.
  Partition(const System& system, int ranks);

  /// All ranks take that of the first one: METIS of another machine may cut in another way.
  void take_from_first(Ranks& ranks);

  int ranks() const { return ranks_; }
  static std::size_t unit_size(const ElementGroup& group) { return group.widest(); }
  int of_element(int group, std::size_t e) const { return rank_[group][e / unit_[group]]; }
  int of_element(System::ElementLocation one) const { return of_element(one.group, at(one.element)); }
  int of_block(int group, std::size_t block, std::size_t width) const {
    return rank_[group][block * width / unit_[group]];
  }

  /// What a rank has.
  struct Share {
    std::size_t elements = 0;      ///< those that everyone computes included
    std::size_t nodes = 0;         ///< that it follows (Followers)
    std::size_t shared_nodes = 0;  ///< of them, those that other ranks follow too
    std::vector<int> neighbours;   ///< these ranks
    double cost = 0.0;             ///< of its elements, as a share of the mean
    double contact = 0.0;          ///< the same of what its nodes cost in contact; 0 where none does
  };
  /// `for_everyone`: as for FollowersOfNodes.
  std::vector<Share> shares(const System& system, std::span<const char> for_everyone) const;
  /// How many elements everyone computes.
  std::size_t elements_of_everyone(const System& system) const;

 private:
  int ranks_;
  std::vector<std::size_t> unit_;       ///< elements of a unit, by group
  std::vector<std::vector<int>> rank_;  ///< by group and unit
  DeletedElements deleted_;
  bool is_deleted(const System& system, std::size_t group, std::size_t e) const {
    return deleted_.empty() ? !system.groups[group]->alive(e) : deleted_[group][e] != 0;
  }
  std::vector<std::vector<double>> contact_;  ///< cost in contact, likewise; empty where nothing has any
};

/// What a cycle of one element costs on one machine [ns]: only ratios matter. A table of kinds, formulations, layers
/// and laws that bench/element_costs.py measured.
double element_cost(const System& system, const ElementGroup& group);

}  // namespace nugget::system
