// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/harmonic_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "nvh/eigen/modes.hpp"
#include "nvh/matrices/factorization.hpp"

namespace nugget::nvh {
namespace {

using Excitation = model::FrequencyResponse::Excitation;
using Kind = Excitation::Kind;

Nodal applied_forces(const Matrices& m, const Excitation& e) {
  Nodal f(m.system.all_nodes());
  const auto node = [&](model::Index n) { return at(m.system.node_of[n]); };
  for (const model::Index n : e.nodes) add_to(f[node(n)], e.kind == Kind::torque, e.direction);
  for (std::size_t i = 0; i < e.pressed.size(); ++i) {
    const model::Segment& s = e.pressed[i];
    const Vec3d force = force_of_pressure(m, s);
    for (std::size_t a = 0; a < 4; ++a) add_to(f[node(s[a])], false, e.share[i][a] * force);
  }
  return f;
}

void add_load(const Matrices& m, const Nodal& f, double factor, std::span<double> q) {
  for (std::size_t k = 0; k < f.size(); ++k) {
    SixDof scaled = f[k];
    for (double& component : scaled) component *= factor;
    m.equations.add_load(static_cast<int>(k), scaled, q);
  }
}

void solve_statically(const Matrices& m, Columns& q) {
  const Factorization factor(m, small_shift(m));
  const Columns load = q;
  const auto largest = [](const std::vector<double>& v) {
    double most = 0.0;
    for (const double x : v) most = std::max(most, std::abs(x));
    return most;
  };
  q.value.assign(q.value.size(), 0.0);
  std::vector<double> internal(m.size());
  for (int pass = 0; pass < 100; ++pass) {
    Columns rest = load;
    m.stiffness.multiply(q[0], internal);
    for (std::size_t i = 0; i < m.size(); ++i) rest.value[i] -= internal[i];
    if (largest(rest.value) <= 1e-12 * largest(load.value)) return;
    factor.solve(rest);
    for (std::size_t i = 0; i < m.size(); ++i) q.value[i] += rest.value[i];
  }
}

/// The structure at rest under a unit displacement of the nodes, the other supports standing still. A small shift lets
/// what is not held otherwise stay where it is; its error is worked off by refinement.
Nodal static_shape(const Matrices& m, const Excitation& e) {
  Nodal u(m.system.all_nodes());
  for (const model::Index n : e.nodes) add_to(u[m.system.node_of[n]], false, e.direction);
  apply_constraints(m.system, u);
  Columns q(m.size(), 1);
  add_load(m, internal_forces(m, u).force, -1.0, q[0]);
  if (m.size() > 0) solve_statically(m, q);
  for (std::size_t k = 0; k < u.size(); ++k) {
    const SixDof more = m.equations.motion(static_cast<int>(k), q[0]);
    for (std::size_t i = 0; i < 6; ++i) u[k][i] += more[i];
  }
  return u;
}

/// Of a unit of its translation, or of its (small) rotation about the axis.
Nodal motion_of_base(const Matrices& m, const Excitation& e) {
  const Vec3d& d = e.direction;
  Nodal u(m.system.all_nodes(), SixDof{d.x, d.y, d.z, 0, 0, 0});
  if (!e.turning) return u;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const Vec3d v = cross(d, m.place(k) - e.axis);
    u[k] = {v.x, v.y, v.z, d.x, d.y, d.z};
  }
  return u;
}

/// Forces act where something can move; what supports carry moves nothing.
void check_effect(const Matrices& m, const Excitation& e, const char* keyword, Findings& findings) {
  std::vector<double> load(m.size(), 0.0);
  const Nodal f = applied_forces(m, e);
  add_load(m, f, 1.0, load);
  const auto zero = [](double v) { return v == 0.0; };
  if (std::ranges::all_of(load, zero))
    findings.warning(e.place, keyword, "the load moves nothing: supports hold what it acts on in its direction",
                     "load nodes that are free to move that way");
}

}  // namespace

HarmonicLoad harmonic_load(const Matrices& m, const Excitation& e) {
  HarmonicLoad load{std::vector<double>(m.size(), 0.0), {}, {}};
  if (!e.moves()) {
    load.applied = applied_forces(m, e);
    add_load(m, load.applied, 1.0, load.force);
    transfer_forces(m.system, load.applied);
    return load;
  }
  if (e.kind == Kind::base)
    load.carried = motion_of_base(m, e);
  else
    load.carried = static_shape(m, e);
  for (std::size_t k = 0; k < m.nodal_mass.size(); ++k) {
    if (m.nodal_mass[k].none()) continue;
    SixDof inertia = m.nodal_mass[k].momentum(load.carried[k]);
    for (double& component : inertia) component = -component;
    m.equations.add_load(static_cast<int>(k), inertia, load.force);
  }
  return load;
}

bool turns(const Equations& equations, int node) {
  for (int i = 3; i < 6; ++i)
    if (!equations.terms(node, i).empty()) return true;
  return std::any_of(equations.supports().begin(), equations.supports().end(),
                     [&](const Equations::Support& s) { return s.node == node && s.rotation; });
}

void check_excitation(const Matrices& m, const Excitation& e, const char* keyword, Findings& findings) {
  const model::Model& model = m.system.model;
  const int errors = findings.errors();
  if (e.kind == Kind::torque)
    for (const model::Index n : e.nodes)
      if (!turns(m.equations, m.system.node_of[n]))
        findings.error(e.place, keyword,
                       fmt::format("node {} carries a torque, but nothing there can turn", model.nodes.id[n]),
                       "put it on a node of shells, beams or a rigid body, or write a pair of forces");
  if (!e.moves() && findings.errors() == errors) check_effect(m, e, keyword, findings);
}

}  // namespace nugget::nvh
