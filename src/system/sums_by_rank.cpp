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

SumsByRank::SumsByRank(const System& system) : travels_(system.all_nodes()) {
  const Share& share = *system.share();
  std::vector<int> row;
  for (std::size_t begin = 0; begin < system.nodes; begin += in_a_row) {
    const std::size_t end = std::min(system.nodes, begin + in_a_row);
    row.resize(end - begin);
    std::iota(row.begin(), row.end(), static_cast<int>(begin));
    of_nodes_.push_back(share.follower_of_all(row, 0));
    if (of_nodes_.back() == nobody)
      std::fill(travels_.begin() + std::ptrdiff_t(begin), travels_.begin() + std::ptrdiff_t(end), 1);
  }
  of_elements_.resize(system.groups.size());
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const ElementGroup& group = *system.groups[g];
    for (std::size_t begin = 0; begin < group.size(); begin += in_a_row) {
      const std::size_t end = std::min(group.size(), begin + in_a_row);
      of_elements_[g].push_back(rank_of_all(share.partition(), static_cast<int>(g), begin, end));
      for (std::size_t e = begin; of_elements_[g].back() == nobody && e < end; ++e) {
        const ElementNodes nodes = group.nodes(e);
        for (int a = 0; a < group.nodes_per_element; ++a)
          if (nodes[a] >= 0) travels_[at(nodes[a])] = 1;
      }
    }
  }
  for (const System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a) travels_[at(mass_only.node[a])] = 1;
  for (const model::PointMass& m : system.model.masses) travels_[at(system.node_of[m.node])] = 1;
  for (const model::PointInertia& p : system.model.inertias) travels_[at(system.node_of[p.node])] = 1;
  // Nodes that a row names may be dependent themselves.
  for (bool more = true; more;) {
    more = false;
    system.map.each_row([&](int dependent, int other) {
      if (travels_[at(dependent)] == 0 || travels_[at(other)] != 0) return;
      travels_[at(other)] = 1;
      more = true;
    });
  }
}

}  // namespace nugget::system
