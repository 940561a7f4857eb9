// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "base/parallel.hpp"

namespace nugget::nvh {
namespace {

/// Masses at the nodes as the elements, point masses and given bodies put them there.
std::vector<NodalMass> nodal_masses(const system::System& system) {
  std::vector<NodalMass> at_node(system.all_nodes());
  const auto put = [&](int node, double mass, double inertia) {
    NodalMass& n = at_node[at(node)];
    n.mass += mass;
    for (const int i : {0, 3, 5}) n.inertia[at(i)] += inertia;
  };
  for (const auto& group : system.groups) {
    const int corners = group->nodes_per_element;
    for (std::size_t e = 0; e < group->size(); ++e) {
      const double mass = group->mass(e) / corners, t = group->thickness(e);
      const bool shell = group->kind == model::ElementKind::shell;
      const double inertia = shell ? mass * t * t / 12.0 : group->nodal_inertia(e);
      const std::array<int, 8> node = group->nodes(e);
      for (int a = 0; a < corners; ++a) put(node[at(a)], mass, inertia);
    }
  }
  for (const system::System::Lump& lump : system.lumps())
    for (int a = 0; a < lump.corners; ++a) put(lump.node[at(a)], lump.mass / lump.corners, lump.nodal_inertia);
  for (const model::PointMass& m : system.model.masses) put(system.node_of[at(m.node)], m.mass, 0.0);
  for (const model::PointInertia& p : system.model.inertias) {
    NodalMass& n = at_node[at(system.node_of[at(p.node)])];
    n.mass += p.mass;
    for (std::size_t i = 0; i < 6; ++i) n.inertia[i] += p.inertia[i];
  }
  for (const system::RigidBody& body : system.bodies) {
    const model::RigidBody& source = system.model.rigid_bodies[at(body.source)];
    if (!source.given) continue;
    for (const model::Index n : source.nodes) at_node[at(system.node_of[at(n)])] = {};
    at_node[at(body.node)] = {source.inertia.mass, source.inertia.inertia};
  }
  return at_node;
}

/// The unknowns that a list of freedoms depends on, and how: u = C q.
class Reach {
 public:
  Reach(const Equations& equations, std::span<const int> nodes, int freedoms_a_node) {
    for (const int node : nodes)
      for (int i = 0; i < freedoms_a_node; ++i) {
        for (const Equations::Term& t : equations.terms(node, i)) {
          term_.push_back(t);
          equation_.push_back(t.equation);
        }
        end_.push_back(term_.size());
      }
    std::sort(equation_.begin(), equation_.end());
    equation_.erase(std::unique(equation_.begin(), equation_.end()), equation_.end());
    for (Equations::Term& t : term_)
      t.equation =
          static_cast<int>(std::lower_bound(equation_.begin(), equation_.end(), t.equation) - equation_.begin());
  }
  const std::vector<int>& equations() const { return equation_; }

  /// C^t k C, row-major; `k` has as many rows as there are freedoms.
  std::vector<double> reduced(std::span<const double> k) const {
    const std::size_t n = end_.size(), m = equation_.size();
    std::vector<double> half(n * m, 0.0), full(m * m, 0.0);
    for (std::size_t i = 0; i < n; ++i)
      each_term([&](std::size_t j, std::size_t place, double factor) { half[i * m + place] += k[i * n + j] * factor; });
    each_term([&](std::size_t i, std::size_t place, double factor) {
      for (std::size_t j = 0; j < m; ++j) full[place * m + j] += factor * half[i * m + j];
    });
    return full;
  }

 private:
  template <class Visit>
  void each_term(const Visit& visit) const {
    std::size_t t = 0;
    for (std::size_t i = 0; i < end_.size(); ++i)
      for (; t < end_[i]; ++t) visit(i, at(term_[t].equation), term_[t].factor);
  }
  std::vector<Equations::Term> term_;  ///< equations as places in `equation_`
  std::vector<std::size_t> end_;       ///< of each freedom's terms
  std::vector<int> equation_;
};

std::span<const int> element_nodes(const system::ElementGroup& group, const std::array<int, 8>& nodes) {
  return {nodes.data(), at(group.nodes_per_element)};
}

/// Adds an element's or a node's matrix, given in its freedoms.
void scatter(const Reach& reach, std::span<const double> k, Symmetric& into) {
  const std::vector<double> q = reach.reduced(k);
  const std::vector<int>& eq = reach.equations();
  for (std::size_t i = 0; i < eq.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)  // mean of both triangles: kernels are symmetric to round-off only
      into.add(eq[i], eq[j], 0.5 * (q[i * eq.size() + j] + q[j * eq.size() + i]));
}

/// Rows of the lower triangle for elements with these lists of unknowns.
std::vector<std::vector<int>> pattern(std::size_t size, const std::vector<std::vector<int>>& lists) {
  std::vector<std::vector<int>> rows(size);
  for (std::size_t j = 0; j < size; ++j) rows[j].push_back(static_cast<int>(j));
  const auto tidy = [](std::vector<int>& r) {
    std::sort(r.begin(), r.end());
    r.erase(std::unique(r.begin(), r.end()), r.end());
  };
  for (const std::vector<int>& list : lists)
    for (std::size_t j = 0; j < list.size(); ++j) {
      std::vector<int>& r = rows[at(list[j])];
      r.insert(r.end(), list.begin() + static_cast<std::ptrdiff_t>(j), list.end());
      if (r.size() > 1000) tidy(r);
    }
  parallel_for(size, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) tidy(rows[j]);
  });
  return rows;
}

std::array<double, 36> mass_matrix(const NodalMass& n) {
  std::array<double, 36> m{};
  for (const std::size_t i : {0u, 1u, 2u}) m[7 * i] = n.mass;
  const system::Inertia& j = n.inertia;
  const double block[3][3] = {{j[0], j[1], j[2]}, {j[1], j[3], j[4]}, {j[2], j[4], j[5]}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) m[6 * (3 + i) + 3 + k] = block[i][k];
  return m;
}

/// Positions at rest, which is all that stiffnesses need.
system::State at_rest(const system::System& system) {
  system::State state;
  state.x.resize(system.all_nodes());
  for (std::size_t k = 0; k < system.nodes; ++k) set(state.x[k], system.ties.x[at(system.model_node[k])]);
  return state;
}

Symmetric assemble_stiffness(const system::System& system, const system::State& rest, const Equations& equations) {
  std::vector<std::vector<int>> lists;
  for (const auto& group : system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      const std::array<int, 8> node = group->nodes(e);
      lists.push_back(Reach(equations, element_nodes(*group, node), group->freedoms()).equations());
    }
  Symmetric k(pattern(at(equations.size()), lists));
  // Kernels in parallel, a stretch at a time; added up in the order of the elements.
  constexpr std::size_t stretch = 2048;
  std::vector<double> matrices;
  for (const auto& group : system.groups) {
    const std::size_t n = at(group->nodes_per_element * group->freedoms());
    matrices.resize(stretch * n * n);
    for (std::size_t first = 0; first < group->size(); first += stretch) {
      const std::size_t count = std::min(stretch, group->size() - first);
      const auto matrix = [&](std::size_t i) { return std::span(matrices).subspan(i * n * n, n * n); };
      parallel_for(count, 32, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) group->stiffness(first + i, rest, matrix(i));
      });
      for (std::size_t i = 0; i < count; ++i) {
        const std::array<int, 8> node = group->nodes(first + i);
        scatter(Reach(equations, element_nodes(*group, node), group->freedoms()), matrix(i), k);
      }
    }
  }
  return k;
}

/// Marks the unknowns whose row of K is zero.
std::vector<char> unresisted(const Symmetric& k) {
  std::vector<char> loose(k.size(), 1);
  for (std::size_t j = 0; j < k.size(); ++j)
    for (std::size_t i = 0; i < k.rows(j).size(); ++i)
      if (k.values(j)[i] != 0.0) loose[j] = loose[at(k.rows(j)[i])] = 0;
  return loose;
}

Symmetric assemble_mass(const Equations& equations, const std::vector<NodalMass>& nodal) {
  std::vector<std::vector<int>> lists;
  const auto reach = [&](std::size_t k) {
    const int node = static_cast<int>(k);
    return Reach(equations, {&node, 1}, 6);
  };
  for (std::size_t k = 0; k < nodal.size(); ++k) lists.push_back(reach(k).equations());
  Symmetric m(pattern(at(equations.size()), lists));
  for (std::size_t k = 0; k < nodal.size(); ++k) scatter(reach(k), mass_matrix(nodal[k]), m);
  return m;
}

}  // namespace

Matrices::Matrices(const system::System& s, Findings& findings)
    : system(s), rest(at_rest(s)), equations(s, findings), nodal_mass(nodal_masses(s)) {
  for (const model::Joint& joint : s.model.joints)
    findings.error(joint.place, "*CONSTRAINED_JOINT",
                   fmt::format("joint {}: joints are not in the linear analyses yet", joint.id),
                   "leave the joint out, or join the bodies by springs (*ELEMENT_DISCRETE, ELFORM 6)");
  stiffness = assemble_stiffness(s, rest, equations);
  const std::vector<char> loose = unresisted(stiffness);
  held = static_cast<int>(std::count(loose.begin(), loose.end(), 1));
  if (held > 0) {
    equations.hold(loose);
    stiffness = assemble_stiffness(s, rest, equations);
    findings.note({s.model.deck, 0, 0}, "*CONTROL_IMPLICIT_SOLVER",
                  fmt::format("{} directions of nodes are held, since nothing resists motion in them (AUTOSPC)", held));
  }
  mass = assemble_mass(equations, nodal_mass);
}

std::vector<double> Matrices::element_energies(const system::ElementGroup& group, std::size_t e,
                                               const Columns& q) const {
  const std::size_t per_node = at(group.freedoms()), n = at(group.nodes_per_element) * per_node;
  std::vector<double> k(n * n), u(n), energy;
  group.stiffness(e, rest, k);
  const std::array<int, 8> node = group.nodes(e);
  for (std::size_t mode = 0; mode < q.count; ++mode) {
    for (std::size_t a = 0; a < at(group.nodes_per_element); ++a) {
      const Six motion = equations.motion(node[a], q[mode]);
      for (std::size_t i = 0; i < per_node; ++i) u[a * per_node + i] = motion[i];
    }
    double twice = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) twice += u[i] * k[i * n + j] * u[j];
    energy.push_back(0.5 * twice);
  }
  return energy;
}

}  // namespace nugget::nvh
