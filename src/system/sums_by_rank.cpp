// SPDX-License-Identifier: Apache-2.0
#include "system/sums_by_rank.hpp"

#include <algorithm>
#include <numeric>

#include "base/index.hpp"
#include "system/share.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

/// The rank that computes all elements [begin, end) of a group; the first one where all ranks compute them.
int rank_of_all(const Partition& partition, int group, std::size_t begin, std::size_t end) {
  int rank = Partition::everyone;
  for (std::size_t e = begin; e < end; ++e) {
    const int of_element = partition.of_element(group, e);
    if (of_element == Partition::everyone || of_element == rank) continue;
    if (rank != Partition::everyone) return SumsByRank::nobody;
    rank = of_element;
  }
  return rank == Partition::everyone ? 0 : rank;
}

}  // namespace

SumsByRank::SumsByRank(const System& system) {
  std::vector<char> travels(system.all_nodes());
  const Share& share = *system.share();
  std::vector<int> row;
  for (std::size_t begin = 0; begin < system.nodes; begin += in_a_row) {
    const std::size_t end = std::min(system.nodes, begin + in_a_row);
    row.resize(end - begin);
    std::iota(row.begin(), row.end(), static_cast<int>(begin));
    // A dependent node moves with those that its row of the constraint map names, which may be dependent themselves.
    for (std::size_t i = 0; i < row.size(); ++i)
      if (system.map.dependent(row[i]))
        for (const ConstraintMap::Term& t : system.map.terms(row[i]))
          if (std::ranges::find(row, t.node) == row.end()) row.push_back(t.node);
    of_nodes_.push_back(share.follower_of_all(row, 0));
    if (of_nodes_.back() == nobody)
      std::fill(travels.begin() + std::ptrdiff_t(begin), travels.begin() + std::ptrdiff_t(end), 1);
  }
  of_elements_.resize(system.groups.size());
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const ElementGroup& group = *system.groups[g];
    for (std::size_t begin = 0; begin < group.size(); begin += in_a_row) {
      const std::size_t end = std::min(group.size(), begin + in_a_row);
      of_elements_[g].push_back(rank_of_all(share.partition(), static_cast<int>(g), begin, end));
    }
  }
  for (const System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a) travels[at(mass_only.node[a])] = 1;
  for (const model::PointMass& m : system.model.masses) travels[at(system.node_of[m.node])] = 1;
  for (const model::PointInertia& p : system.model.inertias) travels[at(system.node_of[p.node])] = 1;
  // Nodes that a row names may be dependent themselves.
  for (bool more = true; more;) {
    more = false;
    system.map.each_row([&](int dependent, int other) {
      if (travels[at(dependent)] == 0 || travels[at(other)] != 0) return;
      travels[at(other)] = 1;
      more = true;
    });
  }
  travels_.resize((travels.size() + bits - 1) / bits);
  for (std::size_t k = 0; k < travels.size(); ++k) {
    Bits& word = travels_[k / bits];
    if (k % bits == 0) word.before = static_cast<std::uint32_t>(travelling_);
    if (travels[k] == 0) continue;
    word.mask |= std::uint64_t{1} << k % bits;
    ++travelling_;
  }
}

}  // namespace nugget::system
