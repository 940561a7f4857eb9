// SPDX-License-Identifier: Apache-2.0
// Masses while a model runs: what follows from those of the system.
#include <algorithm>

#include "base/index.hpp"
#include "impact/contact/contact_setup.hpp"
#include "impact/simulation/simulation.hpp"

namespace nugget::impact {
namespace {

/// What a node of a rigid part brings to a contact is its share of the body's mass, whatever the density of its mesh;
/// of a body that nothing can move, none, which counts as held. `mass`: that of all nodes then; empty where there is no
/// such body, and what nodes have is what they bring. `rigid`: the nodes of such bodies, ascending.
void find_rigid_contact_mass(const system::System& system, std::span<const unsigned char> dependent,
                             std::vector<double>& mass, std::vector<int>& rigid) {
  mass.clear();
  rigid.clear();
  for (const system::RigidBody& body : system.bodies) {
    const model::RigidBody& source = system.model.rigid_bodies[body.source];
    const bool held = is_fully_prescribed(system.model, body.source);
    if (source.origin != model::RigidBody::Origin::part || !(held || source.given)) continue;
    if (mass.empty()) {
      mass.resize(system.all_nodes());
      for (std::size_t k = 0; k < system.nodes; ++k) mass[k] = dependent[k] ? system.own_mass[k] : system.mass[k];
    }
    double mesh = 0.0;
    for (const model::Index n : source.nodes) mesh += system.own_mass[system.node_of[n]];
    const double share = held || !(mesh > 0.0) ? 0.0 : body.mass / mesh;
    for (const model::Index n : source.nodes) {
      const std::size_t k = at(system.node_of[n]);
      mass[k] = share * system.own_mass[k];
      rigid.push_back(static_cast<int>(k));
    }
  }
  std::sort(rigid.begin(), rigid.end());
}

/// 0 of what has none.
double inverse(double mass) {
  return mass > 0.0 ? 1.0 / mass : 0.0;
}

}  // namespace

void Simulation::update_mass_bounds() {
  masses_changed_ = true;
  update_inverse_mass();
  components_.tie_forces.find_bounds();
  system::bound_springs(system_);
}

void Simulation::update_inverse_mass() {
  dependent_.resize(system_.all_nodes());
  for (std::size_t k = 0; k < system_.all_nodes(); ++k) dependent_[k] = system_.map.dependent(static_cast<int>(k));
  inverse_mass_.resize(system_.nodes);
  inverse_inertia_.resize(system_.nodes);
  system_.for_each_node(4096, [this](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < std::min(end, system_.nodes); ++k) {
      inverse_mass_[k] = inverse(system_.mass[k]);
      inverse_inertia_[k] = inverse(system_.inertia[k]);
    }
  });
  find_rigid_contact_mass(system_, dependent_, contact_mass_, rigid_contact_nodes_);
  components_.loads.update_masses();
}

void Simulation::update_scaled_mass() {
  const std::span<const int> changed = system_.nodes_of_changed_mass();
  const auto is_rigid = [&](int k) {
    return std::binary_search(rigid_contact_nodes_.begin(), rigid_contact_nodes_.end(), k);
  };
  bool rigid = false;
  for (const int node : changed) {
    const std::size_t k = at(node);
    if (system_.follows(k)) {
      inverse_mass_[k] = inverse(system_.mass[k]);
      inverse_inertia_[k] = inverse(system_.inertia[k]);
    }
    if (contact_mass_.empty()) continue;
    contact_mass_[k] = dependent_[k] ? system_.own_mass[k] : system_.mass[k];
    rigid |= is_rigid(node);
  }
  if (rigid) find_rigid_contact_mass(system_, dependent_, contact_mass_, rigid_contact_nodes_);
  components_.loads.update_masses(changed);
}

}  // namespace nugget::impact
