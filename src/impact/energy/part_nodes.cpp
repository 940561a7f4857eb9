// SPDX-License-Identifier: Apache-2.0
#include "impact/energy/part_nodes.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "model/lumped_mass.hpp"
#include "system/share.hpp"
#include "system/sums_by_rank.hpp"

namespace nugget::impact {
namespace {

/// Calls `visit(part, groups)` with each part that has elements, rising, and its groups of these.
template <class Visit>
void each_part(const system::System& system, const Visit& visit) {
  std::vector<std::vector<const system::ElementGroup*>> of_part(system.model.parts.size());
  for (const auto& group : system.groups)
    if (group->kind != model::ElementKind::discrete) of_part[group->part].push_back(group.get());  // these have no mass
  for (std::size_t p = 0; p < of_part.size(); ++p)
    if (!of_part[p].empty()) visit(static_cast<model::Index>(p), of_part[p]);
}

/// Calls `visit(node)` for each corner of each element of a group.
template <class Visit>
void each_corner(const system::ElementGroup& group, const Visit& visit) {
  for (std::size_t e = 0; e < group.size(); ++e) {
    const system::ElementNodes nodes = group.nodes(e);
    for (int a = 0; a < group.nodes_per_element; ++a) visit(nodes[a]);
  }
}

/// Calls `visit(node, mass, inertia)` for each corner of each element of a group.
template <class Visit>
void each_corner_mass(const system::ElementGroup& group, const Visit& visit) {
  const std::size_t count = at(group.nodes_per_element);
  for (std::size_t e = 0; e < group.size(); ++e) {
    const system::ElementNodes nodes = group.nodes(e);
    const double scale = group.mass_scale(e), inertia = scale * group.nodal_inertia(e), mass = group.mass(e);
    for (std::size_t a = 0; a < count; ++a) visit(nodes[a], scale * model::mass_at(mass, count, a), inertia);
  }
}

}  // namespace

void PartNodes::update(const system::System& system, Sums sums) {
  if (mass_changes_ < 0) find_weightless(system);
  if (mass_changes_ < 0 || sums != sums_) {
    sums_ = sums;
    find_pieces(system);
    mass_changes_ = -1;
  }
  int deletions = 0;
  for (const auto& group : system.groups) deletions += group->deletions;
  // Released nodes count as having no elements from then on: their release is a change of masses.
  if (deletions > 0 && (deletions != deletions_ || mass_changes_ != system.mass_changes()))
    find_nodes_without_elements(system);
  if (mass_changes_ != system.mass_changes()) find_masses(system);
  mass_changes_ = system.mass_changes();
  deletions_ = deletions;
}

void PartNodes::find_weightless(const system::System& system) {
  for (const system::RigidBody& body : system.bodies) {
    const model::RigidBody& source = system.model.rigid_bodies[body.source];
    if (!source.given) continue;
    weightless_.resize(system.all_nodes());
    for (const model::Index n : source.nodes) weightless_[system.node_of[n]] = 1;
  }
}

void PartNodes::find_pieces(const system::System& system) {
  pieces_.clear();
  at_nodes_.clear();
  const system::SumsByRank* by_rank = sums_ == Sums::own ? system.sums_by_rank() : nullptr;
  const auto is_own = [&](std::size_t row) {
    return by_rank == nullptr || std::max(0, by_rank->of_nodes(row)) == system.share()->ranks().rank();
  };
  std::vector<int> nodes;
  each_part(system, [&](model::Index part, const std::vector<const system::ElementGroup*>& groups) {
    nodes.clear();
    for (const system::ElementGroup* group : groups)
      each_corner(*group, [&](int node) {
        if (!is_weightless(at(node))) nodes.push_back(node);
      });
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const int node : nodes) {
      const std::size_t row = at(node) / system::SumsByRank::in_a_row;
      if (pieces_.empty() || pieces_.back().part != part || pieces_.back().row != row)
        pieces_.push_back({part, row, at_nodes_.size(), at_nodes_.size()});
      if (!is_own(row)) continue;
      at_nodes_.push_back({node});
      ++pieces_.back().end;
    }
  });
  at_nodes_.shrink_to_fit();
}

void PartNodes::find_masses(const system::System& system) {
  struct Lumped {
    double mass = 0.0, inertia = 0.0;
  };
  std::vector<Lumped> lumped(system.nodes);
  auto piece = pieces_.begin();
  each_part(system, [&](model::Index part, const std::vector<const system::ElementGroup*>& groups) {
    for (const system::ElementGroup* group : groups)
      each_corner_mass(*group, [&](int node, double mass, double inertia) {
        lumped[node].mass += mass;
        lumped[node].inertia += inertia;
      });
    for (; piece != pieces_.end() && piece->part == part; ++piece)
      for (AtNode& n : std::span(at_nodes_).subspan(piece->begin, piece->end - piece->begin))
        n = {n.node, lumped[n.node].mass, lumped[n.node].inertia};
    for (const system::ElementGroup* group : groups) each_corner(*group, [&](int node) { lumped[node] = {}; });
  });
}

void PartNodes::find_nodes_without_elements(const system::System& system) {
  has_no_elements_.assign(system.all_nodes(), 1);
  for (const auto& group : system.groups)
    for (std::size_t e = 0; e < group->size(); ++e)
      if (group->alive(e)) {
        const system::ElementNodes node = group->nodes(e);
        for (int a = 0; a < group->nodes_per_element; ++a) has_no_elements_[node[a]] = 0;
      }
  for (const system::System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a) has_no_elements_[mass_only.node[a]] = 0;
  for (const model::PointMass& m : system.model.masses) has_no_elements_[system.node_of[m.node]] = 0;
  for (const model::PointInertia& p : system.model.inertias) has_no_elements_[system.node_of[p.node]] = 0;
  for (std::size_t k = 0; k < has_no_elements_.size(); ++k)
    if (system.map.dependent(static_cast<int>(k))) has_no_elements_[k] = 0;
}

}  // namespace nugget::impact
