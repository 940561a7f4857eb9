// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/body_load.hpp"

#include <algorithm>
#include <map>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "system/share.hpp"

namespace nugget::impact {

ActingLoad<model::BodyLoad>::ActingLoad(const model::BodyLoad& load, const system::System& system)
    : load_(load),
      system_(system),
      last_force_(load.centrifugal ? system.all_nodes() : 0),
      last_moment_(last_force_.size()),
      work_of_node_(system.all_nodes()) {
  update_masses();
}

void ActingLoad<model::BodyLoad>::update_masses() {
  nodes_.clear();
  mass_.clear();
  if (!load_.nodes.empty())
    load_nodes();
  else if (load_.parts.empty())
    load_everything();
  else
    load_parts();
}

void ActingLoad<model::BodyLoad>::Weightless::add(std::size_t k, double mass) {
  if (mass_.size() <= k) {
    mass_.resize(k + 1, 0.0);
    known_.resize(k + 1, 0);
  }
  mass_[k] += mass;
  if (known_[k] != 0) return;
  known_[k] = 1;
  is_sorted_ = false;
  nodes_.push_back(static_cast<int>(k));
}

const std::vector<int>& ActingLoad<model::BodyLoad>::Weightless::ascending() {
  if (!is_sorted_) std::sort(nodes_.begin(), nodes_.end());
  is_sorted_ = true;
  return nodes_;
}

void ActingLoad<model::BodyLoad>::Weightless::clear() {
  for (const int k : nodes_) mass_[nugget::at(k)] = 0.0;
}

void ActingLoad<model::BodyLoad>::find_weightless() {
  const double share = 1.0 - system_.model.control.weight_of_added_mass;
  of_elements_.clear();
  for (std::size_t g = 0; g < system_.groups.size(); ++g) {
    const system::ElementGroup& group = *system_.groups[g];
    for (const int element : system_.scaled_elements(g)) {
      const std::size_t e = at(element);
      const double added = group.mass_scale(e) - group.physical_mass_scale(e);
      if (!(added > 0.0)) continue;
      const auto nodes = group.nodes(e);
      for (int a = 0; a < group.nodes_per_element; ++a)
        of_elements_.add(nodes[a], share * added * group.nodal_mass(e, a));
    }
  }
}

void ActingLoad<model::BodyLoad>::find_weightless_of_all() {
  find_weightless();
  handed_over_.clear();
  for (const int node : of_elements_.ascending()) {
    const double own = of_elements_.at(at(node));
    if (own == 0.0) continue;
    if (!system_.map.dependent(node))
      handed_over_.add(at(node), own);
    else
      for (const system::ConstraintMap::Term& t : system_.map.terms(node)) handed_over_.add(at(t.node), t.weight * own);
  }
}

/// Of a node of the system, or of a body behind them.
double ActingLoad<model::BodyLoad>::mass_of_all(std::size_t k) const {
  if (k < system_.nodes) return system_.mass[k] - handed_over_.at(k);
  const system::RigidBody& body = system_.bodies[k - system_.nodes];
  // The mass that a deck gives a body is not that of its elements, scaled or not.
  return body.mass - (system_.model.rigid_bodies[body.source].given ? 0.0 : handed_over_.at(k));
}

void ActingLoad<model::BodyLoad>::load_everything() {
  find_weightless_of_all();
  for (std::size_t k = 0; k < system_.nodes + system_.bodies.size(); ++k) {
    const double m = mass_of_all(k);
    if (m <= 0.0) continue;
    nodes_.push_back(static_cast<int>(k));
    mass_.push_back(m);
  }
}

void ActingLoad<model::BodyLoad>::update_masses(std::span<const int> changed) {
  if (!load_.nodes.empty() || !load_.parts.empty()) return update_masses();
  find_weightless_of_all();
  const auto update = [&](std::size_t k) {
    const auto place = std::lower_bound(nodes_.begin(), nodes_.end(), static_cast<int>(k));
    const bool loaded = place != nodes_.end() && *place == static_cast<int>(k);
    const double m = mass_of_all(k);
    if (loaded == (m <= 0.0)) return false;  // it comes in or goes out
    if (loaded) mass_[static_cast<std::size_t>(place - nodes_.begin())] = m;
    return true;
  };
  bool same_nodes = true;
  for (const int node : changed) same_nodes &= update(at(node));
  for (std::size_t b = 0; b < system_.bodies.size(); ++b) same_nodes &= update(system_.nodes + b);
  if (!same_nodes) update_masses();
}

/// The parts' own nodal masses; what they put on dependent nodes reaches the independent ones through `collect`.
void ActingLoad<model::BodyLoad>::load_parts() {
  const std::vector<model::Index>& parts = load_.parts;
  const auto wanted = [&](model::Index part) { return std::find(parts.begin(), parts.end(), part) != parts.end(); };
  std::map<int, double> mass;
  for (const auto& group : system_.groups) {
    if (!wanted(group->part)) continue;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const auto nodes = group->nodes(e);
      const double physical = group->physical_mass_scale(e);
      const double weight = physical + system_.model.control.weight_of_added_mass * (group->mass_scale(e) - physical);
      for (int a = 0; a < group->nodes_per_element; ++a) mass[nodes[a]] += weight * group->nodal_mass(e, a);
    }
  }
  // Rigid parts, and what else has mass without a kernel. A body of given mass weighs that, not what its mesh would.
  struct Mesh {
    double wanted = 0.0, all = 0.0;
  };
  std::map<model::Index, Mesh> meshes;
  for (const system::System::MassOnlyElement& mass_only : system_.mass_only_elements()) {
    const model::Index source = system_.model.parts[mass_only.part].rigid_body;
    const bool given = source != model::none && system_.model.rigid_bodies[source].given;
    if (given) {
      meshes[source].all += mass_only.mass;
      if (wanted(mass_only.part)) meshes[source].wanted += mass_only.mass;
    } else if (wanted(mass_only.part)) {
      for (int a = 0; a < mass_only.corners; ++a) mass[mass_only.node[a]] += mass_only.nodal_mass(a);
    }
  }
  for (const auto& [source, mesh] : meshes) {
    const system::RigidBody& rigid = system_.bodies[system_.body_of[source]];
    if (mesh.wanted > 0.0) mass[rigid.node] += mesh.wanted / mesh.all * rigid.mass;
  }
  add_points(mass);
  for (const auto& [node, m] : mass) {
    if (!(m > 0.0)) continue;
    nodes_.push_back(node);
    mass_.push_back(m);
  }
}

/// Masses and inertias at the nodes of the parts weigh with them; at other nodes of a rigid body where all of its parts
/// do. What a body of given mass weighs is known.
void ActingLoad<model::BodyLoad>::add_points(std::map<int, double>& mass) const {
  const model::Model& model = system_.model;
  std::vector<char> weighs(system_.nodes, 0);
  for (const auto& [node, m] : mass)
    if (at(node) < system_.nodes) weighs[at(node)] = 1;
  std::vector<int> parts_of_body(model.rigid_bodies.size(), 0);
  for (const model::Part& part : model.parts)
    if (part.rigid_body != model::none) ++parts_of_body[at(part.rigid_body)];
  std::vector<int> loaded(parts_of_body.size(), 0);
  for (const model::Index p : load_.parts)
    if (const model::Index body = model.parts[p].rigid_body; body != model::none) ++loaded[at(body)];
  for (std::size_t b = 0; b < loaded.size(); ++b) {
    const model::RigidBody& body = model.rigid_bodies[b];
    const bool whole = parts_of_body[b] > 0 && loaded[b] == parts_of_body[b];
    if (!body.given && !whole) continue;
    for (const model::Index n : body.nodes) weighs[at(system_.node_of[n])] = body.given ? 0 : 1;
  }
  const auto add = [&](const auto& point) {
    if (const int node = system_.node_of[point.node]; weighs[at(node)] != 0) mass[node] += point.mass;
  };
  std::for_each(model.masses.begin(), model.masses.end(), add);
  std::for_each(model.inertias.begin(), model.inertias.end(), add);
}

/// The nodes of a set with their own masses. A rigid body that is in the set as a whole weighs what it weighs: its
/// given mass is not that of its nodes.
void ActingLoad<model::BodyLoad>::load_nodes() {
  const model::Model& model = system_.model;
  std::vector<char> wanted(system_.nodes, 0);
  const auto place = [&](model::Index n) { return at(system_.node_of[n]); };
  for (const model::Index n : load_.nodes) wanted[place(n)] = 1;
  const auto take = [&](int node, double mass) {
    if (!(mass > 0.0)) return;
    nodes_.push_back(node);
    mass_.push_back(mass);
  };
  for (const system::RigidBody& rigid : system_.bodies) {
    const std::vector<model::Index>& nodes = model.rigid_bodies[rigid.source].nodes;
    if (!std::all_of(nodes.begin(), nodes.end(), [&](model::Index n) { return wanted[place(n)] != 0; })) continue;
    for (const model::Index n : nodes) wanted[place(n)] = 0;
    take(rigid.node, rigid.mass);
  }
  find_weightless();
  for (std::size_t k = 0; k < system_.nodes; ++k)
    if (wanted[k]) take(static_cast<int>(k), system_.own_mass[k] - of_elements_.at(k));
}

double ActingLoad<model::BodyLoad>::motion(const system::State& state) const {
  if (state.relaxing && load_.relaxation_curve != model::none)
    return load_.scale * system_.model.curves[load_.relaxation_curve].zero_outside(state.time);
  if (load_.curve == model::none) return load_.scale;
  return load_.scale * load_value(system_.model.curves[load_.curve], state.time, state);
}

void ActingLoad<model::BodyLoad>::apply(system::State& state, double dt, double&) {
  if (load_.centrifugal) return apply_centrifugal(state, dt, motion(state));
  // Base acceleration: the structure feels -m a.
  const double a = -motion(state);
  parallel_for(nodes_.size(), 2048, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto k = at(nodes_[i]);
      if (!system_.follows(k)) continue;
      work_of_node_[k] += 0.5 * dt * (last_ + a) * mass_[i] * dot(load_.direction, vec(state.v[k]));
      add(state.f[k], (a * mass_[i]) * load_.direction);
    }
  });
  last_ = a;
}

void ActingLoad<model::BodyLoad>::apply_centrifugal(system::State& state, double dt, double omega) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto k = at(nodes_[i]);
    if (!system_.follows(k)) continue;
    const Vec3d arm = vec(state.x[k]) - load_.center;
    const Vec3d outwards = arm - dot(arm, load_.direction) * load_.direction;
    const Vec3d force = (mass_[i] * omega * omega) * outwards;
    work_of_node_[k] += 0.5 * dt * dot(last_force_[k] + force, vec(state.v[k]));
    add(state.f[k], force);
    last_force_[k] = force;
    if (k >= system_.nodes) apply_to_body(k, mass_[i], dt, omega, state);
  }
}

/// What the force on all points of a body amounts to about its centre, w^2 (J n) x n for the axis n: a body that lies
/// askew to the axis turns away from it.
void ActingLoad<model::BodyLoad>::apply_to_body(std::size_t k, double mass, double dt, double omega,
                                                system::State& state) {
  const system::RigidBody& body = system_.bodies[k - system_.nodes];
  if (!(body.mass > 0.0)) return;
  const Vec3d& axis = load_.direction;
  const Vec3d moment = (mass / body.mass * omega * omega) * cross(body.momentum(axis, body.axes), axis);
  work_of_node_[k] += 0.5 * dt * dot(last_moment_[k] + moment, vec(state.w[k]));
  add(state.m[k], moment);
  last_moment_[k] = moment;
}

double ActingLoad<model::BodyLoad>::work() const {
  return ordered_sum(work_of_node_.size(), [this](std::size_t k) { return work_of_node_[k]; });
}

void ActingLoad<model::BodyLoad>::carry(system::Carried what, const system::System::Computed& of,
                                        system::Parcel& parcel) {
  if (what == system::Carried::histories) return;
  for (const int k : of.share.reported_by(of.rank)) {
    parcel(&work_of_node_[k], 1);
    if (what != system::Carried::restart || last_force_.empty()) continue;
    parcel(&last_force_[k], 1);
    parcel(&last_moment_[k], 1);
  }
}

void ActingLoad<model::BodyLoad>::archive(Archive& a) {
  a(last_, last_force_, last_moment_, work_of_node_, nodes_, mass_);
  a.built(load_, system_, of_elements_, handed_over_);
}

}  // namespace nugget::impact
