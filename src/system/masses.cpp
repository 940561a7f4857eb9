// SPDX-License-Identifier: Apache-2.0
// Masses of a System: of nodes, of what depends on others, of elements whose density is scaled, and their sums.
#include <algorithm>
#include <vector>

#include "base/free_room.hpp"
#include "base/index.hpp"
#include "system/share.hpp"
#include "system/system.hpp"

namespace nugget::system {
namespace {

/// An element whose density is scaled, on its way to other ranks.
struct ScaledMass {
  double factor, physical;
  std::size_t element;
  int group;
  friend bool operator<(const ScaledMass& a, const ScaledMass& b) {
    return a.group != b.group ? a.group < b.group : a.element < b.element;
  }
};

}  // namespace

void System::assemble_mass() {
  own_mass.assign(nodes, 0.0);
  own_inertia_.assign(nodes, 0.0);
  const auto put = [&](int node, double m, double j) {
    own_mass[node] += m;
    own_inertia_[node] += j;
  };
  for (const auto& group : groups) {
    const int corners = group->nodes_per_element;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const ElementNodes node = group->nodes(e);
      const double scale = group->mass_scale(e), j = scale * group->nodal_inertia(e);
      for (int a = 0; a < corners; ++a) put(node[a], scale * group->nodal_mass(e, a), j);
    }
  }
  for (const MassOnlyElement& mass_only : mass_only_elements_)
    for (int a = 0; a < mass_only.corners; ++a)
      put(mass_only.node[a], mass_only.nodal_mass(a), mass_only.nodal_inertia);
  for (const model::PointMass& m : model.masses) put(node_of[m.node], m.mass, 0.0);
  for (const model::PointInertia& p : model.inertias)
    put(node_of[p.node], p.mass, (p.inertia[0] + p.inertia[3] + p.inertia[5]) / 3.0);
}

void System::transfer_dependent_mass() {
  ++mass_changes_;
  carried_mass_ = own_mass;
  carried_inertia_ = own_inertia_;
  carried_mass_.resize(all_nodes(), 0.0);
  carried_inertia_.resize(all_nodes(), 0.0);
  map.transfer_mass(carried_mass_, carried_inertia_, static_cast<int>(nodes));
  mass.assign(carried_mass_.begin(), carried_mass_.begin() + static_cast<std::ptrdiff_t>(nodes));
  inertia.assign(carried_inertia_.begin(), carried_inertia_.begin() + static_cast<std::ptrdiff_t>(nodes));
  for (std::size_t d = 0; d < nodes; ++d) {
    if (!map.dependent(static_cast<int>(d))) continue;
    mass[d] = 0.0;
    if (map.rotations(static_cast<int>(d))) inertia[d] = 0.0;
  }
  if (!start_is_forgotten_) return;
  free_room(carried_mass_);
  free_room(carried_inertia_);
}

void System::set_mass_scale(ElementGroup& group, std::size_t e, double factor) {
  factor = group.kept_mass_scale(factor);
  const int corners = group.nodes_per_element;
  const double more = factor - group.mass_scale(e);
  const double j = more * group.nodal_inertia(e);
  const ElementNodes node = group.nodes(e);
  for (int a = 0; a < corners; ++a) {
    own_mass[node[a]] += more * group.nodal_mass(e, a);
    own_inertia_[node[a]] += j;
  }
  group.scale_mass(e, factor);
  ++mass_changes_;
}

bool System::scale_mass(bool at_start) {
  if (!at_start && model.control.mass_scaling_at_start_only) return false;
  bool changed = false, any = false;
  std::vector<ScaledMass> scaled;  // over several ranks
  for (auto& group : groups) {
    const double target = std::max(group->mass_step, group->physical_mass_step);
    if (target <= 0.0) continue;
    any = true;
    // DT2MS > 0: every element gets exactly this step, mass added or taken away, but for what DT of a weld added.
    const bool exactly = at_start && model.control.mass_step > 0.0 && group->physical_mass_step == 0.0;
    const std::size_t width = group->block_width();
    for (std::size_t b = 0; b < group->blocks(); ++b) {
      if (!exactly && !(group->block_step[b] < target * (1.0 - 1e-9))) continue;
      for (std::size_t e = b * width; e < std::min(group->size(), (b + 1) * width); ++e) {
        const double step = group->stable_step(e), now = group->mass_scale(e), by_dt = group->physical_mass_scale(e);
        // What is inside out has no step, and no mass would give it one.
        if (!group->alive(e) || step == 0.0) continue;
        const double wanted = exactly ? now * (target / step) * (target / step) : group->wanted_mass_scale(e);
        if (share_) {
          const auto g = static_cast<int>(&group - groups.data());
          const double physical = group->physical_mass_scale(e);
          if ((wanted != now || physical != by_dt) && share_->answers_for(g, e))
            scaled.push_back({wanted, physical, e, g});
          continue;
        }
        if (group->physical_mass_scale(e) != by_dt) ++mass_changes_;
        if (!exactly && wanted == now) continue;
        set_mass_scale(*group, e, wanted);
        changed = true;
      }
    }
  }
  if (share_ && any) {
    scaled = gather_lists(share_->ranks(), scaled);
    std::sort(scaled.begin(), scaled.end());
    for (const ScaledMass& s : scaled) {
      ElementGroup& group = *groups[s.group];
      group.take_physical_mass_scale(s.element, s.physical);
      ++mass_changes_;
      if (s.factor == group.mass_scale(s.element)) continue;
      set_mass_scale(group, s.element, s.factor);
      changed = true;
    }
  }
  if (changed) transfer_dependent_mass();
  return changed;
}

const System::Masses& System::masses() const {
  if (masses_are_of_ == mass_changes_) return masses_;
  masses_are_of_ = mass_changes_;
  Masses& m = masses_ = {};
  m.added_by_part.assign(model.parts.size(), 0.0);
  for (const auto& group : groups) {
    for (std::size_t e = 0; e < group->size(); ++e) {
      const double own = group->mass(e), by_dt = own * (group->physical_mass_scale(e) - 1.0),
                   extra = own * (group->mass_scale(e) - group->physical_mass_scale(e));
      m.physical += own + by_dt;
      if (group->weld) m.added_to_welds += by_dt + extra;
      m.added += extra;
      m.added_by_part[group->part] += extra;
    }
  }
  for (const MassOnlyElement& mass_only : mass_only_elements_) m.physical += mass_only.mass;
  for (const model::PointMass& p : model.masses) m.physical += p.mass;
  for (const model::PointInertia& p : model.inertias) m.physical += p.mass;
  // The mass that a deck gives a rigid body stands in place of that of its elements and nodes.
  const auto given = [&](const ConstraintMap::Term& t) {
    return at(t.node) >= nodes && model.rigid_bodies[bodies[at(t.node) - nodes].source].given;
  };
  for (std::size_t d = 0; d < nodes; ++d) {
    if (!map.dependent(static_cast<int>(d))) continue;
    for (const ConstraintMap::Term& t : map.terms(static_cast<int>(d)))
      if (given(t)) m.physical -= t.weight * own_mass[d];
  }
  for (const RigidBody& body : bodies)
    if (model.rigid_bodies[body.source].given) m.physical += body.mass;
  return m;
}

double System::part_mass(model::Index part) const {
  double sum = 0.0;
  for (const auto& group : groups)
    if (group->part == part)
      for (std::size_t e = 0; e < group->size(); ++e) sum += group->mass(e);
  for (const MassOnlyElement& mass_only : mass_only_elements_)
    if (mass_only.part == part) sum += mass_only.mass;
  return sum;
}

}  // namespace nugget::system
