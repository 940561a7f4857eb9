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
  linked_nodes_.clear();
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

void System::transfer_changed_mass() {
  ++mass_changes_;
  const auto make_unique = [](std::vector<int>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  if (linked_nodes_.empty()) {
    map.each_row([&](int dependent, int other) {
      linked_nodes_.push_back(dependent);
      linked_nodes_.push_back(other);
    });
    make_unique(linked_nodes_);
  }
  // What is linked is summed up anew, in the order of transfer_dependent_mass(), so that the sums have the same bits.
  carried_mass_.resize(all_nodes());
  carried_inertia_.resize(all_nodes());
  for (const int node : linked_nodes_) {
    const auto k = at(node);
    carried_mass_[k] = k < nodes ? own_mass[k] : 0.0;
    carried_inertia_[k] = k < nodes ? own_inertia_[k] : 0.0;
  }
  map.transfer_mass(carried_mass_, carried_inertia_, static_cast<int>(nodes));
  make_unique(changed_mass_);
  const auto of_elements = static_cast<std::ptrdiff_t>(changed_mass_.size());
  for (const int node : changed_mass_) {
    const auto k = at(node);
    if (std::binary_search(linked_nodes_.begin(), linked_nodes_.end(), node)) continue;
    mass[k] = own_mass[k];
    inertia[k] = own_inertia_[k];
  }
  for (const int node : linked_nodes_) {
    const auto k = at(node);
    if (k >= nodes) break;
    const bool dependent = map.dependent(node);
    const double m = dependent ? 0.0 : carried_mass_[k],
                 j = dependent && map.rotations(node) ? 0.0 : carried_inertia_[k];
    if (m == mass[k] && j == inertia[k]) continue;
    mass[k] = m;
    inertia[k] = j;
    changed_mass_.push_back(node);
  }
  std::inplace_merge(changed_mass_.begin(), changed_mass_.begin() + of_elements, changed_mass_.end());
  changed_mass_.erase(std::unique(changed_mass_.begin(), changed_mass_.end()), changed_mass_.end());
}

void System::find_scaled_elements() {
  scaled_elements_.assign(groups.size(), {});
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t e = 0; e < groups[g]->size(); ++e)
      if (groups[g]->mass_scale(e) != 1.0) scaled_elements_[g].push_back(static_cast<int>(e));
}

void System::set_mass_scale(std::size_t g, std::size_t e, double factor) {
  ElementGroup& group = *groups[g];
  factor = group.kept_mass_scale(factor);
  const int corners = group.nodes_per_element;
  const double more = factor - group.mass_scale(e);
  const double j = more * group.nodal_inertia(e);
  const ElementNodes node = group.nodes(e);
  for (int a = 0; a < corners; ++a) {
    own_mass[node[a]] += more * group.nodal_mass(e, a);
    own_inertia_[node[a]] += j;
    changed_mass_.push_back(node[a]);
  }
  group.scale_mass(e, factor);
  ++mass_changes_;
  std::vector<int>& scaled = scaled_elements_[g];
  const auto place = std::lower_bound(scaled.begin(), scaled.end(), static_cast<int>(e));
  if (place == scaled.end() || *place != static_cast<int>(e)) scaled.insert(place, static_cast<int>(e));
}

bool System::scale_mass(bool at_start) {
  if (!at_start && model.control.mass_scaling_at_start_only) return false;
  bool any = false;
  changed_mass_.clear();
  std::vector<ScaledMass> scaled;  // over several ranks
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto& group = groups[g];
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
          const auto index = static_cast<int>(g);
          const double physical = group->physical_mass_scale(e);
          if ((wanted != now || physical != by_dt) && share_->answers_for(index, e))
            scaled.push_back({wanted, physical, e, index});
          continue;
        }
        if (group->physical_mass_scale(e) != by_dt) ++mass_changes_;
        if (!exactly && wanted == now) continue;
        set_mass_scale(g, e, wanted);
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
      set_mass_scale(at(s.group), s.element, s.factor);
    }
  }
  if (changed_mass_.empty()) return false;
  if (at_start)
    transfer_dependent_mass();
  else
    transfer_changed_mass();
  return true;
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
