// SPDX-License-Identifier: Apache-2.0
#include "impact/energy/part_nodes.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

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

/// By node, whether elements of several parts have it, or it has a mass besides theirs.
std::vector<char> find_shared(const system::System& system) {
  std::vector<model::Index> first(system.nodes, model::none);  // part of it
  std::vector<char> shared(system.nodes);
  each_part(system, [&](model::Index part, const std::vector<const system::ElementGroup*>& groups) {
    for (const system::ElementGroup* group : groups)
      each_corner(*group, [&](int node) {
        shared[node] |= first[node] != model::none && first[node] != part;
        first[node] = part;
      });
  });
  for (const system::System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a) shared[mass_only.node[a]] = 1;
  for (const model::PointMass& m : system.model.masses) shared[system.node_of[m.node]] = 1;
  for (const model::PointInertia& p : system.model.inertias) shared[system.node_of[p.node]] = 1;
  return shared;
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
  if (mass_changes_ != system.mass_changes()) find_shared_masses(system);
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
  alone_.clear();
  shared_.clear();
  const std::vector<char> is_shared = find_shared(system);
  const system::SumsByRank* by_rank = sums_ == Sums::own ? system.sums_by_rank() : nullptr;
  const auto is_own = [&](std::size_t row) {
    return by_rank == nullptr || std::max(0, by_rank->of_nodes(row)) == system.share()->ranks().rank();
  };
  std::vector<char> has(system.nodes);  // an element of the part
  each_part(system, [&](model::Index part, const std::vector<const system::ElementGroup*>& groups) {
    int first = static_cast<int>(system.nodes), last = -1;
    for (const system::ElementGroup* group : groups)
      each_corner(*group, [&](int node) {
        has[node] = 1;
        first = std::min(first, node);
        last = std::max(last, node);
      });
    for (int node = first; node <= last; ++node) {
      if (!std::exchange(has[node], char{0}) || is_weightless(at(node))) continue;
      const std::size_t row = at(node) / system::SumsByRank::in_a_row;
      if (pieces_.empty() || pieces_.back().part != part || pieces_.back().row != row)
        pieces_.push_back({part, row, alone_.size(), alone_.size(), shared_.size(), shared_.size()});
      if (!is_own(row)) continue;
      if (is_shared[node])
        shared_.push_back({node});
      else
        alone_.push_back(node);
      pieces_.back().end = alone_.size();
      pieces_.back().end_shared = shared_.size();
    }
  });
  alone_.shrink_to_fit();
  shared_.shrink_to_fit();
}

void PartNodes::find_shared_masses(const system::System& system) {
  // By node, where it stands in shared_ among those of the part that is at hand.
  std::vector<int> place(system.nodes, -1);
  auto piece = pieces_.begin();
  each_part(system, [&](model::Index part, const std::vector<const system::ElementGroup*>& groups) {
    const auto first = piece;
    while (piece != pieces_.end() && piece->part == part) ++piece;
    if (first == piece || first->first_shared == std::prev(piece)->end_shared) return;
    const std::span<Shared> all =
        std::span(shared_).subspan(first->first_shared, std::prev(piece)->end_shared - first->first_shared);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i] = {all[i].node};
      place[all[i].node] = static_cast<int>(i);
    }
    for (const system::ElementGroup* group : groups) {
      const std::size_t count = at(group->nodes_per_element);
      for (std::size_t e = 0; e < group->size(); ++e) {
        const system::ElementNodes nodes = group->nodes(e);
        for (std::size_t a = 0; a < count; ++a) {
          if (place[nodes[a]] < 0) continue;
          Shared& there = all[at(place[nodes[a]])];
          const double scale = group->mass_scale(e);
          there.mass += scale * model::mass_at(group->mass(e), count, a);
          there.inertia += scale * group->nodal_inertia(e);
        }
      }
    }
    for (const Shared& one : all) place[one.node] = -1;
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
