// SPDX-License-Identifier: Apache-2.0
// Nodes that stay tied until the mesh tears: which of a set stand at one place, and what they may not have.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

constexpr double same_place = 1e-3;  // of the shortest side of the elements there
constexpr const char* tied_nodes_keyword = "*CONSTRAINED_TIED_NODES_FAILURE";

/// What stands at the nodes that are named in any of the sets.
class AroundTiedNodes {
 public:
  explicit AroundTiedNodes(const Model& m) : at_(m.nodes.size(), none) {
    for (const TiedNodes& tied : m.tied_nodes)
      for (const Index n : tied.nodes)
        if (at_[n] == none) {
          at_[n] = static_cast<Index>(nodes_.size());
          nodes_.emplace_back();
        }
    add(m, m.shells, ElementKind::shell);
    add(m, m.solids, ElementKind::solid);
    for (const SinglePointConstraint& spc : m.spcs)
      if (OfNode* node = find(spc.node))
        node->supports.insert({spc.fixed, spc.system, spc.birth, spc.death, spc.control});
    for (std::size_t k = 0; k < m.motions.size(); ++k)
      if (m.motions[k].target == PrescribedMotion::Target::nodes)
        for (const Index n : m.motions[k].nodes)
          if (OfNode* node = find(n)) node->motions.insert(k);
  }

  struct OfNode {
    double shortest = std::numeric_limits<double>::infinity();  ///< side of an element
    std::set<Index> shell_parts, solid_parts;
    std::set<std::tuple<unsigned, Index, double, double, Index>> supports;
    std::set<std::size_t> motions;
    const std::set<Index>& parts(ElementKind kind) const {
      return kind == ElementKind::solid ? solid_parts : shell_parts;
    }
    bool held_as(const OfNode& other) const { return supports == other.supports && motions == other.motions; }
  };
  const OfNode& of(Index n) const { return nodes_[at_[n]]; }

 private:
  OfNode* find(Index n) { return n == none || at_[n] == none ? nullptr : &nodes_[at_[n]]; }

  template <class Elements>
  void add(const Model& m, const Elements& elements, ElementKind kind) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const auto nodes = elements.nodes(e);
      if (std::ranges::none_of(nodes, [&](Index n) { return find(n) != nullptr; })) continue;
      double shortest = std::numeric_limits<double>::infinity();
      for (const Index a : nodes)
        for (const Index b : nodes)
          if (a < b) shortest = std::min(shortest, norm(m.nodes.x[a] - m.nodes.x[b]));
      for (const Index n : nodes)
        if (OfNode* node = find(n)) {
          node->shortest = std::min(node->shortest, shortest);
          (kind == ElementKind::solid ? node->solid_parts : node->shell_parts).insert(elements.part[e]);
        }
    }
  }

  std::vector<Index> at_;  // by node
  std::vector<OfNode> nodes_;
};

/// The nodes of a set by the places where they stand, each place in the order of the set.
std::vector<std::vector<Index>> by_place(const Model& m, const AroundTiedNodes& around, const std::vector<Index>& set) {
  std::vector<Index> nodes;
  std::set<Index> seen;
  for (const Index n : set)
    if (seen.insert(n).second) nodes.push_back(n);
  double shortest = std::numeric_limits<double>::infinity();
  for (const Index n : nodes) shortest = std::min(shortest, around.of(n).shortest);
  const double close = shortest < std::numeric_limits<double>::infinity() ? same_place * shortest : 0.0;
  std::vector<std::size_t> order(nodes.size()), first(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::iota(first.begin(), first.end(), std::size_t{0});
  const auto first_of = [&first](std::size_t i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  const auto x = [&](std::size_t i) -> const Vec3d& { return m.nodes.x[nodes[i]]; };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return x(a).x < x(b).x; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size() && x(order[k]).x - x(order[i]).x <= close; ++k) {
      if (norm(x(order[k]) - x(order[i])) > close) continue;
      const std::size_t one = first_of(order[i]), other = first_of(order[k]);
      first[std::max(one, other)] = std::min(one, other);
    }
  std::map<std::size_t, std::vector<Index>> places;
  for (std::size_t i = 0; i < nodes.size(); ++i) places[first_of(i)].push_back(nodes[i]);
  std::vector<std::vector<Index>> groups;
  for (auto& [place, members] : places) groups.push_back(std::move(members));
  return groups;
}

/// What a law gives for EPPF.
enum class Measure { strain, damage, none, unknown, refused };
Measure measure_of(const Model& m, Index part) {
  if (m.parts[part].material == none) return Measure::none;
  const Law& law = m.materials[m.parts[part].material].law;
  if (std::holds_alternative<kernel::PlasticKinematic>(law) || std::holds_alternative<kernel::PiecewiseLinear>(law))
    return Measure::strain;
  if (std::holds_alternative<kernel::Laminate>(law)) return Measure::unknown;
  const auto* composed = std::get_if<kernel::ComposedLaw>(&law);
  if (composed == nullptr) return Measure::none;
  const kernel::LawComponents& made = *composed->components;
  if (made.gissmo) return Measure::damage;
  const auto is_fracture = [](const kernel::FailureRule& rule) {
    return std::holds_alternative<kernel::DuctileFracture>(rule);
  };
  if (std::holds_alternative<kernel::Honeycomb>(made.flow) || std::ranges::any_of(made.rules, is_fracture))
    return Measure::refused;
  return kernel::has_plastic_strain(made.flow) ? Measure::strain : Measure::none;
}

}  // namespace

void check_tied_nodes(Builder& b) {
  Model& m = b.model;
  if (m.tied_nodes.empty()) return;
  const AroundTiedNodes around(m);
  std::vector<TiedNodes> groups;
  std::vector<char> taken(m.nodes.size(), 0);
  std::set<Index> parts_named;
  Tally alone(b.findings, Severity::warning, tied_nodes_keyword);
  const auto refuse_group = [&](const TiedNodes& card, std::string text, std::string remedy) {
    b.findings.error(card.place, tied_nodes_keyword, std::move(text), std::move(remedy));
  };
  for (const TiedNodes& card : m.tied_nodes) {
    const bool solid = card.kind == ElementKind::solid;
    bool any = false;
    for (std::vector<Index>& nodes : by_place(m, around, card.nodes)) {
      const Index n = nodes.front();
      if (nodes.size() < 2) {
        alone.add(
            card.place,
            [&] {
              return fmt::format("node {} of set {} stands at one place with none of the others: it is tied to nothing",
                                 m.nodes.id[n], card.set);
            },
            "nodes that are tied have the same coordinates");
        continue;
      }
      any = true;
      for (const Index k : nodes)
        if (std::exchange(taken[k], char{1}) != 0)
          refuse_group(card, fmt::format("node {} is in two sets of tied nodes", m.nodes.id[k]),
                       "name it once: all nodes at a place stand in one set");
      std::set<Index> parts;
      for (const Index k : nodes) {
        const std::set<Index>& own = around.of(k).parts(card.kind);
        parts.insert(own.begin(), own.end());
        if (!around.of(k).held_as(around.of(n)))
          refuse_group(card,
                       fmt::format("nodes {} and {} are tied, but are not held or driven alike (*BOUNDARY_SPC, "
                                   "*BOUNDARY_PRESCRIBED_MOTION)",
                                   m.nodes.id[n], m.nodes.id[k]),
                       "hold or drive all nodes at that place, or none");
      }
      if (parts.empty())
        refuse_group(card,
                     fmt::format("no {} has node {} or those tied to it, so that there is no strain to tear at",
                                 solid ? "solid" : "shell", m.nodes.id[n]),
                     solid ? "write ETYPE 0 for shells" : "write ETYPE 1 for solids");
      for (const Index p : parts) {
        const Measure measure = measure_of(m, p);
        if ((measure != Measure::refused && measure != Measure::none) || !parts_named.insert(p).second) continue;
        if (measure == Measure::refused)
          refuse_group(card,
                       fmt::format("part {} has {}, whose nodes part by volume strain (honeycomb) or its own damage "
                                   "(*MAT_107): this is not built",
                                   m.parts[p].id, m.materials[m.parts[p].material].keyword),
                       "use a metal or plastic with a plastic strain, with or without *MAT_ADD_DAMAGE_GISSMO");
        else
          b.findings.warning(card.place, tied_nodes_keyword,
                             fmt::format("elements of part {} have no plastic strain: they count as 0 where nodes are "
                                         "tied until they tear",
                                         m.parts[p].id),
                             "give the part a law with plastic strain, or merge the nodes (*NODE_MERGE_SET)");
      }
      TiedNodes group = card;
      group.nodes = std::move(nodes);
      groups.push_back(std::move(group));
    }
    if (!any && !card.nodes.empty())
      refuse_group(card, fmt::format("no two nodes of set {} stand at one place", card.set),
                   "mesh the two sides of the seam node on node, with nodes of their own");
  }
  m.tied_nodes = std::move(groups);
}

}  // namespace nugget::reading
