// SPDX-License-Identifier: Apache-2.0
#include "system/partition.hpp"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <stdexcept>

#include "base/index.hpp"
#include "system/followers.hpp"

namespace nugget::system {
namespace {

/// Lists of numbers, one behind the other.
template <class Number>
class Lists {
 public:
  std::size_t size() const { return start_.size() - 1; }
  std::span<const Number> operator[](std::size_t i) const {
    return std::span(number_).subspan(start_[i], start_[i + 1] - start_[i]);
  }
  void add(std::span<const Number> list) {
    number_.insert(number_.end(), list.begin(), list.end());
    start_.push_back(static_cast<std::uint32_t>(number_.size()));
  }
  /// For each of so many numbers the lists in which it stands, rising.
  Lists<std::uint32_t> turned(std::size_t numbers) const {
    Lists<std::uint32_t> lists;
    lists.start_.assign(numbers + 2, 0);
    // Counted two places on, so that in the end each place holds where its list begins.
    for (const Number n : number_) ++lists.start_[static_cast<std::size_t>(n) + 2];
    for (std::size_t n = 1; n < lists.start_.size(); ++n) lists.start_[n] += lists.start_[n - 1];
    lists.number_.resize(number_.size());
    for (std::size_t i = 0; i < size(); ++i)
      for (const Number n : (*this)[i])
        lists.number_[lists.start_[static_cast<std::size_t>(n) + 1]++] = static_cast<std::uint32_t>(i);
    lists.start_.pop_back();
    return lists;
  }

 private:
  template <class Other>
  friend class Lists;
  std::vector<std::uint32_t> start_{0};
  std::vector<Number> number_;
};

/// Units that are shared out, and which share nodes with which (METIS: compressed rows).
struct UnitGraph {
  std::vector<std::pair<int, std::size_t>> unit;  ///< group and unit of each vertex
  std::vector<idx_t> start{0}, neighbour, shared_nodes;
  std::vector<double> elements, contact;  ///< what they cost
};

/// Calls `visit` with pairs of nodes that belong together though no element that is shared out has both: of elements
/// that everyone computes, and of what is tied, each in place of the dependent node the first one of its row.
template <class Visit>
void each_joined(const System& system, const std::vector<std::vector<int>>& rank, const Visit& visit) {
  const auto stand_in = [&](int node) {
    for (int k = 0; k < 4 && node >= 0 && at(node) < system.nodes && system.map.dependent(node); ++k)
      node = system.map.terms(node).front().node;
    return node;
  };
  const auto join = [&](int a, int b) {
    if (a >= 0 && b >= 0 && a != b && at(a) < system.nodes && at(b) < system.nodes) visit(a, b);
  };
  for (int k = 0; k < static_cast<int>(system.nodes); ++k)
    if (system.map.dependent(k)) join(k, stand_in(k));
  for (std::size_t g = 0; g < rank.size(); ++g) {
    const ElementGroup& group = *system.groups[g];
    for (std::size_t e = 0; e < group.size(); ++e) {
      if (rank[g][e / Partition::unit_size(group)] != Partition::everyone) continue;
      const ElementNodes nodes = group.nodes(e);
      for (int a = 1; a < group.nodes_per_element; ++a) join(stand_in(nodes[0]), stand_in(nodes[a]));
    }
  }
}

/// What a node costs in contact goes to the units at it in equal shares.
UnitGraph graph_of(const System& system, const std::vector<std::vector<int>>& rank, const ContactCosts& contact,
                   const std::function<bool(std::size_t, std::size_t)>& is_deleted) {
  UnitGraph graph;
  std::vector<std::vector<std::size_t>> vertex_of(system.groups.size());
  for (std::size_t g = 0; g < rank.size(); ++g) {
    vertex_of[g].resize(rank[g].size());
    for (std::size_t u = 0; u < rank[g].size(); ++u) {
      vertex_of[g][u] = graph.unit.size();
      if (rank[g][u] != Partition::everyone) graph.unit.emplace_back(static_cast<int>(g), u);
    }
  }
  // Nodes of each vertex, each once, and vertices of each node.
  Lists<int> nodes_of;
  std::vector<int> nodes;
  for (const auto& [g, u] : graph.unit) {
    const ElementGroup& group = *system.groups[g];
    const std::size_t size = Partition::unit_size(group), end = std::min(group.size(), (u + 1) * size);
    nodes.clear();
    for (std::size_t e = u * size; e < end; ++e) {
      const ElementNodes of_element = group.nodes(e);
      nodes.insert(nodes.end(), of_element.begin(), of_element.begin() + group.nodes_per_element);
    }
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    nodes_of.add(nodes);
    std::size_t alive = 0;
    for (std::size_t e = u * size; e < end; ++e) alive += is_deleted(at(g), e) ? 0 : 1;
    graph.elements.push_back(element_cost(system, group) * static_cast<double>(alive));
  }
  const Lists<std::uint32_t> vertices_at = nodes_of.turned(system.nodes);
  for (std::size_t v = 0; !contact.of_node.empty() && v < nodes_of.size(); ++v) {
    double sum = 0.0;
    for (const int n : nodes_of[v]) sum += contact.of_node[at(n)] / static_cast<double>(vertices_at[at(n)].size());
    graph.contact.push_back(sum);
  }
  std::vector<std::vector<std::size_t>> joined(graph.unit.size());
  const auto join = [&](int a, int b, std::size_t weight) {
    if (vertices_at[at(a)].empty() || vertices_at[at(b)].empty()) return;
    const std::size_t v = vertices_at[at(a)].front(), w = vertices_at[at(b)].front();
    joined[v].insert(joined[v].end(), weight, w);
    joined[w].insert(joined[w].end(), weight, v);
  };
  constexpr std::size_t of_joint = 4;  // as much as a side of an element and its neighbours
  each_joined(system, rank, [&](int a, int b) { join(a, b, of_joint); });
  for (const auto& [a, b] : contact.together) join(a, b, 1);
  std::vector<idx_t> common(graph.unit.size(), 0);
  std::vector<std::size_t> found;
  for (std::size_t v = 0; v < graph.unit.size(); ++v) {
    found.clear();
    for (const int n : nodes_of[v])
      for (const std::size_t other : vertices_at[n])
        if (other != v && common[other]++ == 0) found.push_back(other);
    for (const std::size_t other : joined[v])
      if (other != v && common[other]++ == 0) found.push_back(other);
    std::sort(found.begin(), found.end());
    for (const std::size_t other : found) {
      graph.neighbour.push_back(static_cast<idx_t>(other));
      graph.shared_nodes.push_back(common[other]);
      common[other] = 0;
    }
    graph.start.push_back(static_cast<idx_t>(graph.neighbour.size()));
  }
  return graph;
}

/// The rank of each vertex.
std::vector<idx_t> cut(UnitGraph& graph, int ranks) {
  auto vertices = static_cast<idx_t>(graph.unit.size());
  std::vector<idx_t> rank(graph.unit.size(), 0);
  if (ranks == 1) return rank;
  if (vertices <= ranks) {  // fewer than METIS can cut
    for (idx_t v = 0; v < vertices; ++v) rank[at(v)] = v;
    return rank;
  }
  std::array<idx_t, METIS_NOPTIONS> options;
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_UFACTOR] = 10;  // thousandths by which a rank may have more than the mean
  const bool two = !graph.contact.empty();
  std::vector<idx_t> cost;
  const double contact = std::accumulate(graph.contact.begin(), graph.contact.end(), 0.0);
  for (std::size_t v = 0; v < graph.unit.size(); ++v) {
    cost.push_back(static_cast<idx_t>(std::max(1.0, std::round(graph.elements[v]))));
    // All of it is a thousand a vertex in the mean: METIS adds whole numbers.
    if (two) cost.push_back(static_cast<idx_t>(1e3 * static_cast<double>(vertices) * graph.contact[v] / contact));
  }
  std::array<real_t, 2> uneven{1.01f, 1.03f};
  idx_t constraints = two ? 2 : 1, parts = ranks, edge_cut = 0;
  const auto method = ranks <= 8 ? METIS_PartGraphRecursive : METIS_PartGraphKway;
  const int status = method(&vertices, &constraints, graph.start.data(), graph.neighbour.data(), cost.data(), nullptr,
                            graph.shared_nodes.data(), &parts, nullptr, two ? uneven.data() : nullptr, options.data(),
                            &edge_cut, rank.data());
  if (status != METIS_OK) throw std::runtime_error("METIS cannot cut the graph of the elements");
  return rank;
}

/// Units, by group and number in it, that one rank must have.
using Units = std::vector<std::pair<int, std::size_t>>;

/// Units of lists that have a unit in common, together; those of one unit are left out.
std::vector<Units> joined_units(const System& system,
                                std::span<const std::vector<System::ElementLocation>> of_one_rank) {
  std::map<std::pair<int, std::size_t>, std::size_t> list_of;  // unit, to the list that has it
  std::vector<Units> lists;
  for (const std::vector<System::ElementLocation>& elements : of_one_rank) {
    Units all;
    for (const System::ElementLocation& one : elements) {
      const std::pair unit{one.group, at(one.element) / Partition::unit_size(*system.groups[one.group])};
      const auto known = list_of.find(unit);
      if (known == list_of.end()) {
        all.push_back(unit);
        continue;
      }
      Units& before = lists[known->second];  // empty if it is in `all` by now
      all.insert(all.end(), before.begin(), before.end());
      before.clear();
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    if (all.empty()) continue;
    for (const auto& unit : all) list_of[unit] = lists.size();
    lists.push_back(std::move(all));
  }
  std::erase_if(lists, [](const Units& units) { return units.size() < 2; });
  return lists;
}

}  // namespace

Partition::Partition(const System& system, int ranks) : ranks_(ranks) {
  for (const auto& group : system.groups) {
    const std::size_t size = unit_size(*group);
    unit_.push_back(size);
    // A unit must be whole blocks.
    const bool shared_out = size % group->block_width() == 0;
    rank_.emplace_back((group->size() + size - 1) / size, shared_out ? 0 : everyone);
  }
}

Partition::Partition(const System& system, int ranks, std::span<const System::ElementLocation> for_everyone,
                     const ContactCosts& contact, std::span<const std::vector<System::ElementLocation>> of_one_rank,
                     DeletedElements deleted)
    : Partition(system, ranks) {
  deleted_ = std::move(deleted);
  for (const System::ElementLocation& one : for_everyone)
    if (one.group >= 0) rank_[one.group][at(one.element) / unit_[one.group]] = everyone;
  constexpr std::size_t most_joined = 64;
  std::vector<Units> joined = joined_units(system, of_one_rank);
  for (const Units& units : joined) {
    const auto is_everyones = [this](const auto& unit) { return rank_[unit.first][unit.second] == everyone; };
    if (units.size() <= most_joined && std::ranges::none_of(units, is_everyones)) continue;
    for (const auto& [g, u] : units) rank_[g][u] = everyone;
  }
  UnitGraph graph =
      graph_of(system, rank_, contact, [&](std::size_t g, std::size_t e) { return is_deleted(system, g, e); });
  for (std::size_t g = 0; !contact.of_node.empty() && g < rank_.size(); ++g)
    contact_.emplace_back(rank_[g].size(), 0.0);
  for (std::size_t v = 0; v < graph.contact.size(); ++v)
    contact_[graph.unit[v].first][graph.unit[v].second] = graph.contact[v];
  const std::vector<idx_t> rank = cut(graph, ranks);
  for (std::size_t v = 0; v < rank.size(); ++v)
    rank_[graph.unit[v].first][graph.unit[v].second] = static_cast<int>(rank[v]);
  for (const Units& units : joined)
    for (const auto& [g, u] : units) rank_[g][u] = rank_[units.front().first][units.front().second];
}

void Partition::take_from_first(Ranks& ranks) {
  for (std::vector<int>& of_units : rank_) ranks.broadcast(std::as_writable_bytes(std::span(of_units)));
  bool has_contact = !contact_.empty();
  broadcast(ranks, has_contact);
  if (has_contact && contact_.empty())
    for (const std::vector<int>& of_units : rank_) contact_.emplace_back(of_units.size(), 0.0);
  for (std::vector<double>& of_units : contact_) ranks.broadcast(std::as_writable_bytes(std::span(of_units)));
}

std::size_t Partition::elements_of_everyone(const System& system) const {
  std::size_t count = 0;
  for (std::size_t g = 0; g < system.groups.size(); ++g)
    for (std::size_t e = 0; e < system.groups[g]->size(); ++e) count += of_element(static_cast<int>(g), e) == everyone;
  return count;
}

std::vector<Partition::Share> Partition::shares(const System& system, std::span<const char> for_everyone) const {
  std::vector<Share> all(at(ranks_));
  double whole = 0.0;
  for (std::size_t g = 0; g < system.groups.size(); ++g) {
    const ElementGroup& group = *system.groups[g];
    const double cost = element_cost(system, group);
    for (std::size_t e = 0; e < group.size(); ++e) {
      const int rank = of_element(static_cast<int>(g), e);
      for (int r = rank == everyone ? 0 : rank; r < (rank == everyone ? ranks_ : rank + 1); ++r) {
        ++all[r].elements;
        if (is_deleted(system, g, e)) continue;
        all[r].cost += cost;
        whole += cost;
      }
    }
  }
  double all_contact = 0.0;
  for (std::size_t g = 0; g < contact_.size(); ++g)
    for (std::size_t u = 0; u < contact_[g].size(); ++u) {
      if (rank_[g][u] == everyone) continue;
      all[at(rank_[g][u])].contact += contact_[g][u];
      all_contact += contact_[g][u];
    }
  const auto add_node = [&](int rank, const std::vector<int>& others) {
    Share& share = all[at(rank)];
    ++share.nodes;
    if (others.size() < 2) return;
    ++share.shared_nodes;
    for (const int other : others)
      if (other != rank && std::ranges::find(share.neighbours, other) == share.neighbours.end())
        share.neighbours.push_back(other);
  };
  std::vector<int> every_rank(at(ranks_)), these;
  std::iota(every_rank.begin(), every_rank.end(), 0);
  const FollowersOfNodes of_nodes(system, *this, for_everyone);
  for (std::size_t k = 0; k < of_nodes.size(); ++k) {
    const Followers followers = of_nodes[k];
    these.assign(followers.owners.begin(), followers.owners.end());
    these.insert(these.end(), followers.others.begin(), followers.others.end());
    const std::vector<int>& followed_by = followers.all ? every_rank : these;
    for (const int rank : followed_by) add_node(rank, followed_by);
  }
  for (Share& share : all) {
    if (whole > 0.0) share.cost *= ranks_ / whole;
    if (all_contact > 0.0) share.contact *= ranks_ / all_contact;
    std::sort(share.neighbours.begin(), share.neighbours.end());
  }
  return all;
}

}  // namespace nugget::system
