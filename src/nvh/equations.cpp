// SPDX-License-Identifier: Apache-2.0
#include "nvh/equations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::nvh {
namespace {

constexpr Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// Directions of one node that are held: orthonormal, none to three.
struct Held {
  std::vector<Vec3d> direction;

  void add(Vec3d d) {
    for (const Vec3d& h : direction) d -= dot(h, d) * h;
    if (dot(d, d) > 1e-12) direction.push_back(unit(d));
  }
  /// Directions that are left: the global axes where those will do, completed otherwise.
  std::vector<Vec3d> free() const {
    Held taken = *this;
    std::vector<Vec3d> rest;
    while (taken.direction.size() < 3) {
      Vec3d best{};
      for (Vec3d d : axes) {
        for (const Vec3d& h : taken.direction) d -= dot(h, d) * h;
        if (dot(d, d) > dot(best, best) + 1e-9) best = d;
      }
      rest.push_back(unit(best));
      taken.direction.push_back(rest.back());
    }
    return rest;
  }
};

/// What acts on each node: something that needs its translations, its rotations.
struct Needs {
  std::vector<char> translation, rotation;
};

Needs needs_of(const system::System& system) {
  Needs needs{std::vector<char>(system.all_nodes(), 0), std::vector<char>(system.all_nodes(), 0)};
  for (const auto& group : system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      const std::array<int, 8> node = group->nodes(e);
      for (std::size_t a = 0; a < at(group->nodes_per_element); ++a) {
        needs.translation[at(node[a])] = 1;
        needs.rotation[at(node[a])] |= group->rotational;
      }
    }
  for (const system::System::Lump& lump : system.lumps())
    for (int a = 0; a < lump.corners; ++a) needs.translation[at(lump.node[at(a)])] = 1;
  for (const model::PointMass& m : system.model.masses) needs.translation[at(system.node_of[at(m.node)])] = 1;
  for (const model::PointInertia& p : system.model.inertias) {
    needs.translation[at(system.node_of[at(p.node)])] = 1;
    needs.rotation[at(system.node_of[at(p.node)])] = 1;
  }
  for (const system::RigidBody& body : system.bodies)
    needs.translation[at(body.node)] = needs.rotation[at(body.node)] = 1;
  // A dependent node hands its needs on; arms make rotations of them.
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
          const bool needed = i < 3 ? needs.translation[d] : needs.rotation[d];
          if (needed && b.of[i][j] != 0.0) (j < 3 ? needs.translation : needs.rotation)[at(b.node)] = 1;
        }
  }
  return needs;
}

struct Supports {
  std::vector<Held> translation, rotation;
};

Supports supports_of(const system::System& system, Findings& findings) {
  const model::Model& model = system.model;
  Supports held{std::vector<Held>(system.all_nodes()), std::vector<Held>(system.all_nodes())};
  for (const model::SinglePointConstraint& spc : model.spcs) {
    if (spc.birth > 0.0) continue;
    const int node = system.node_of[at(spc.node)];
    if (system.map.dependent(node)) {
      findings.warning({model.deck, 0, 0}, "*BOUNDARY_SPC",
                       fmt::format("node {} is held by an SPC, but it moves with a rigid body or a tie; the SPC does "
                                   "nothing there",
                                   model.nodes.id[at(spc.node)]),
                       "constrain the rigid body (MAT_RIGID CMO, *CONSTRAINED_NODAL_RIGID_BODY_SPC) instead");
      continue;
    }
    for (int i = 0; i < 6; ++i) {
      if (!(spc.fixed >> i & 1u)) continue;
      const Frame3d local =
          spc.system == model::none ? Frame3d{axes[0], axes[1], axes[2]} : model.systems[at(spc.system)].axes;
      const Vec3d axis = i % 3 == 0 ? local.e1 : i % 3 == 1 ? local.e2 : local.e3;
      (i < 3 ? held.translation : held.rotation)[at(node)].add(axis);
    }
  }
  for (const system::RigidBody& body : system.bodies)
    for (int i = 0; i < 6; ++i)
      if (body.fixed >> i & 1u) (i < 3 ? held.translation : held.rotation)[at(body.node)].add(axes[i % 3]);
  for (const model::PrescribedMotion& motion : model.motions) {
    const auto hold = [&](int node) {
      std::vector<Held>& kind = motion.rotation ? held.rotation : held.translation;
      kind[at(node)].add(motion.direction);
      if (motion.only_direction) return;
      for (const Vec3d& axis : axes) kind[at(node)].add(axis);
    };
    if (motion.target != model::PrescribedMotion::Target::nodes) {
      hold(system.bodies[at(system.body_of[at(motion.rigid_body)])].node);
      continue;
    }
    for (model::Index n : motion.nodes)
      if (!system.map.dependent(system.node_of[at(n)])) hold(system.node_of[at(n)]);
  }
  return held;
}

}  // namespace

Equations::Equations(const system::System& system, Findings& findings) {
  const Needs needs = needs_of(system);
  const Supports held = supports_of(system, findings);
  const std::size_t nodes = system.all_nodes();

  // Unknowns of each node: directions of translation and rotation.
  std::vector<std::vector<Term>> own(6 * nodes);
  const auto number = [&](std::size_t node, int first, const Held& h) {
    for (const Vec3d& d : h.free()) {
      const double component[3] = {d.x, d.y, d.z};
      for (int i = 0; i < 3; ++i)
        if (component[i] != 0.0) own[6 * node + at(first + i)].push_back({size_, component[i]});
      owner_.push_back(static_cast<int>(node));
      ++size_;
    }
  };
  const auto dependent = [&](std::size_t k) { return k < system.nodes && system.map.dependent(static_cast<int>(k)); };
  for (std::size_t k = 0; k < nodes; ++k) {
    if (needs.translation[k] && !dependent(k)) number(k, 0, held.translation[k]);
    const bool own_rotation = !dependent(k) || !system.map.rotations(static_cast<int>(k));
    if (needs.rotation[k] && own_rotation) number(k, 3, held.rotation[k]);
  }

  // Rows of dependent nodes, in independent ones.
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!dependent(d)) continue;
    const auto put = [&](int i, int node, int j, double factor) {
      if (factor == 0.0) return;
      std::vector<Term>& row = own[6 * d + at(i)];
      for (const Term& t : own[6 * at(node) + at(j)]) {
        const auto same = std::find_if(row.begin(), row.end(), [&](const Term& r) { return r.equation == t.equation; });
        if (same != row.end())
          same->factor += factor * t.factor;
        else
          row.push_back({t.equation, factor * t.factor});
      }
    };
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) put(i, b.node, j, b.of[at(i)][at(j)]);
  }

  start_.reserve(own.size() + 1);
  start_.push_back(0);
  for (const std::vector<Term>& row : own) {
    terms_.insert(terms_.end(), row.begin(), row.end());
    start_.push_back(terms_.size());
  }
}

Six Equations::motion(int node, std::span<const double> q) const {
  Six u{};
  for (int i = 0; i < 6; ++i)
    for (const Term& t : terms(node, i)) u[at(i)] += t.factor * q[at(t.equation)];
  return u;
}

void Equations::add_load(int node, const Six& load, std::span<double> f) const {
  for (int i = 0; i < 6; ++i)
    for (const Term& t : terms(node, i)) f[at(t.equation)] += t.factor * load[at(i)];
}

}  // namespace nugget::nvh
