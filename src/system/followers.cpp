// SPDX-License-Identifier: Apache-2.0
#include "system/followers.hpp"

#include <iterator>
#include <numeric>

#include "base/index.hpp"

namespace nugget::system {
namespace {

void insert(std::vector<int>& rising, int value) {
  const auto place = std::lower_bound(rising.begin(), rising.end(), value);
  if (place == rising.end() || *place != value) rising.insert(place, value);
}

/// Sets of nodes that stand in rows with each other, each by one of its nodes.
class Families {
 public:
  explicit Families(const System& system) : parent_(system.all_nodes()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    system.map.each_row([&](int dependent, int other) { parent_[find(other)] = find(dependent); });
  }
  int find(int node) {
    while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
    return node;
  }

 private:
  std::vector<int> parent_;
};

/// What all nodes of a family have.
struct Family {
  std::vector<int> owners;
  bool all = false;
};

}  // namespace

int FollowersOfNodes::number_of(std::vector<int> ranks) {
  const auto [entry, is_new] = number_.try_emplace(ranks, static_cast<int>(sets_.size()));
  if (is_new) sets_.push_back(std::move(ranks));
  return entry->second;
}

int FollowersOfNodes::with(int set, int rank) {
  if (std::ranges::binary_search(sets_[set], rank)) return set;
  const auto known = with_.find({set, rank});
  if (known != with_.end()) return known->second;
  std::vector<int> more = sets_[set];
  insert(more, rank);
  return with_[{set, rank}] = number_of(std::move(more));
}

FollowersOfNodes::FollowersOfNodes(const System& system, const Partition& partition, std::span<const char> for_everyone)
    : of_node_(system.nodes) {
  number_of({});
  const auto everyone_is_to = [&](int node) { return !for_everyone.empty() && for_everyone[node] != 0; };
  each_corner(system, [&](int g, const ElementGroup& group, std::size_t e, int, int node) {
    OfNode& followers = of_node_[node];
    followers.turns |= group.rotational;
    const int rank = partition.of_element(g, e);
    if (rank == Partition::everyone)
      followers.of_everyone = true;
    else
      followers.owners = with(followers.owners, rank);
  });

  Families families(system);
  std::vector<int> size(system.all_nodes(), 0), family_of(system.all_nodes(), -1);
  for (int k = 0; k < static_cast<int>(system.all_nodes()); ++k) ++size[families.find(k)];
  std::vector<Family> family;
  for (int k = 0; k < static_cast<int>(system.all_nodes()); ++k) {
    const int first = families.find(k);
    if (size[first] == 1) continue;
    if (family_of[first] < 0) {
      family_of[first] = static_cast<int>(family.size());
      family.emplace_back();
    }
    family_of[k] = family_of[first];
    Family& of = family[family_of[k]];
    if (at(k) >= system.nodes) {
      of.all = true;
      continue;
    }
    of.all |= everyone_is_to(k) || of_node_[k].of_everyone;
    for (const int rank : sets_[of_node_[k].owners]) insert(of.owners, rank);
  }
  for (int k = 0; k < static_cast<int>(system.nodes); ++k) {
    OfNode& followers = of_node_[k];
    if (family_of[k] < 0) {
      // Without elements a node moves by what acts on it: nobody's share, so everyone's.
      followers.all = everyone_is_to(k) || followers.of_everyone || followers.owners == 0;
      continue;
    }
    const Family& of = family[family_of[k]];
    followers.all = of.all || of.owners.empty();
    if (followers.all) continue;
    std::vector<int> others;
    std::ranges::set_difference(of.owners, sets_[followers.owners], std::back_inserter(others));
    followers.others = number_of(std::move(others));
  }
}

}  // namespace nugget::system
