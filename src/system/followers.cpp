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

std::vector<Followers> followers_of_nodes(const System& system, const Partition& partition,
                                          std::span<const char> for_everyone) {
  const auto everyone_is_to = [&](int node) { return !for_everyone.empty() && for_everyone[node] != 0; };
  std::vector<Followers> of_node(system.nodes);
  each_corner(system, [&](int g, const ElementGroup& group, std::size_t e, int, int node) {
    Followers& followers = of_node[node];
    followers.turns |= group.rotational;
    const int rank = partition.of_element(g, e);
    if (rank == Partition::everyone)
      followers.of_everyone = true;
    else
      insert(followers.owners, rank);
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
    of.all |= everyone_is_to(k) || of_node[k].of_everyone;
    for (const int rank : of_node[k].owners) insert(of.owners, rank);
  }
  for (int k = 0; k < static_cast<int>(system.nodes); ++k) {
    Followers& followers = of_node[k];
    if (family_of[k] < 0) {
      // Without elements a node moves by what acts on it: nobody's share, so everyone's.
      followers.all = everyone_is_to(k) || followers.of_everyone || followers.owners.empty();
      continue;
    }
    const Family& of = family[family_of[k]];
    followers.all = of.all || of.owners.empty();
    if (!followers.all) std::ranges::set_difference(of.owners, followers.owners, std::back_inserter(followers.others));
  }
  return of_node;
}

}  // namespace nugget::system
