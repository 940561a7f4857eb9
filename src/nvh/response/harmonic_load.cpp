// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/harmonic_load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "nvh/eigen/modes.hpp"
#include "nvh/matrices/resistance.hpp"
#include "nvh/response/static_answer.hpp"

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

/// Whether this is the support by which an excitation drives a node.
bool drives(const Excitation& e, const Equations::Support& s) {
  return s.moves && !s.rotation && norm(s.direction - e.direction) == 0.0;
}

/// A unit displacement of the nodes in the excitation's direction. Where supports hold a part of that, they do not
/// move: the node goes along what is left, as far as it takes.
Nodal displacement_of(const Matrices& m, const Excitation& e) {
  Nodal u(m.system.all_nodes());
  std::vector<char> driven(m.system.all_nodes(), 0);
  for (const model::Index n : e.nodes) driven[m.system.node_of[n]] = 1;
  for (const Equations::Support& s : m.equations.supports()) {
    if (!driven[s.node] || s.rotation) continue;
    const double wanted = drives(e, s) ? 1.0 : 0.0, share = dot(s.direction, s.taken);
    const double missing = wanted - dot(s.direction, part_of(u[s.node], false));
    if (share > 0.0) add_to(u[s.node], false, (missing / share) * s.taken);
  }
  return u;
}

/// K x = f up to a millionth of f.
bool is_in_balance(const Matrices& m, std::span<const double> x, std::span<const double> f) {
  std::vector<double> internal(f.size());
  m.stiffness.multiply(x, internal);
  double rest = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    rest = std::max(rest, std::abs(f[i] - internal[i]));
    whole = std::max(whole, std::abs(f[i]));
  }
  return rest <= 1e-6 * whole;
}

/// The structure at rest under a unit displacement of the nodes, the other supports standing still. What is not held
/// otherwise stays where it is. Throws Factorization::SolverError where it is not found.
Nodal static_shape(const Matrices& m, const Excitation& e) {
  Nodal u = displacement_of(m, e);
  apply_constraints(m.system, u);
  std::vector<double> load(m.size(), 0.0), q(m.size(), 0.0);
  add_load(m, internal_forces(m, u).force, -1.0, load);
  if (std::ranges::any_of(load, [](double f) { return f != 0.0; }) &&
      !solve_statically(m, Factorization(m, small_shift(m)), load, q) && !is_in_balance(m, q, load))
    throw Factorization::SolverError{
        "the shape at rest under the displacement of the driven nodes was not found to six digits: part of the "
        "structure is hardly held, or by far softer than the rest"};
  for (std::size_t k = 0; k < u.size(); ++k) {
    const SixDof more = m.equations.motion(static_cast<int>(k), q);
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

/// Forces act where something can move and something resists; what supports carry moves nothing. What only a preload
/// resists is not known yet.
void check_effect(const Matrices& m, const Excitation& e, const char* keyword, Findings& findings) {
  std::vector<double> load(m.size(), 0.0);
  const Nodal f = applied_forces(m, e);
  if (const auto lost = unresisted_loads(m, f); !lost.empty() && !m.system.model.implicit.geometric) {
    const UnresistedLoad& first = lost.front();
    const Vec3d& d = first.direction;
    const std::string node = name_of(m.system, first.node);
    findings.error(e.place, keyword,
                   first.nothing_there
                       ? fmt::format("{} is loaded, but belongs to no element, mass or rigid body", node)
                       : fmt::format("nothing resists motion along ({:.3g} {:.3g} {:.3g}) at {}, which is held there "
                                     "(AUTOSPC): the load would move nothing",
                                     d.x, d.y, d.z, node),
                   "give the node stiffness in that direction, or load another one");
    return;
  }
  add_load(m, f, 1.0, load);
  const auto zero = [](double v) { return v == 0.0; };
  if (std::ranges::all_of(load, zero))
    findings.warning(e.place, keyword, "the load moves nothing: supports hold what it acts on in its direction",
                     "load nodes that are free to move that way");
}

/// Nodes that supports hold in the very direction in which they are to be driven.
void check_driven(const Matrices& m, const Excitation& e, const char* keyword, Findings& findings) {
  for (const model::Index n : e.nodes)
    for (const Equations::Support& s : m.equations.supports())
      if (s.node == m.system.node_of[n] && drives(e, s) && dot(s.taken, s.taken) == 0.0)
        findings.error(e.place, keyword,
                       fmt::format("node {} is to be driven in a direction in which *BOUNDARY_SPC holds it, or in "
                                   "which something else drives it",
                                   m.system.model.nodes.id[n]),
                       "free it in that direction, or drive the base (VAD1 0 to 2 of FRF, VAD 2 to 4 of SSD)");
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
  if (e.kind == Kind::enforced) check_driven(m, e, keyword, findings);
  if (!e.moves() && findings.errors() == errors) check_effect(m, e, keyword, findings);
}

}  // namespace nugget::nvh
