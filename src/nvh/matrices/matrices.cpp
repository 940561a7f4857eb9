// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "nvh/matrices/assembly.hpp"
#include "nvh/matrices/prestress.hpp"
#include "nvh/matrices/resistance.hpp"

namespace nugget::nvh {
namespace {

/// Where the share of corner a of a shell lies beside the node, so that the corners' sum is the integral of the square
/// of the normal velocity over the shell: the trapezoidal rule with its end correction. Along an edge of length h,
///     integral f = h/2 (f1 + f2) + h^2/12 (f1' - f2'),   f = w^2,  f' = 2 w w',
/// is a mass m h/2 whose first moment about node 1 is m h/2 times h/6; likewise on triangles, from the rule of the
/// middles of the edges, with an eighth.
Vec3d corner_offset(const system::ElementGroup& group, std::size_t e, std::size_t a, const system::State& rest) {
  const system::ElementNodes node = group.nodes(e);
  const std::size_t corners = at(group.nodes_per_element);
  const auto place = [&](std::size_t k) { return vec(rest.x[node[k % corners]]); };
  return (corners == 4 ? 1.0 / 6.0 : 1.0 / 8.0) * (place(a + 1) + place(a + corners - 1) - 2.0 * place(a));
}

Vec3d shell_normal(const system::ElementGroup& group, std::size_t e, const system::State& rest) {
  const system::ElementNodes node = group.nodes(e);
  const auto place = [&](std::size_t k) { return vec(rest.x[node[k]]); };
  return group.nodes_per_element == 4 ? unit(cross(place(2) - place(0), place(3) - place(1)))
                                      : unit(cross(place(1) - place(0), place(2) - place(0)));
}

/// The section of resultant beams (ELFORM 2); null for other elements.
const model::SectionBeam* resultant_section(const system::System& system, const system::ElementGroup& group) {
  if (group.kind != model::ElementKind::beam || group.nodes_per_element != 2) return nullptr;
  const model::Part& part = system.model.parts[group.part];
  if (part.section == model::none) return nullptr;
  const model::SectionBeam& section = system.model.beam_sections[part.section];
  return section.elform == 2 ? &section : nullptr;
}

/// Rotary inertia of half a resultant beam by its moments of area. What the group has for explicit dynamics is raised
/// for the sake of the step, up to six times the larger one in all directions.
system::Inertia section_inertia(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                const model::SectionBeam& section, const system::State& rest) {
  const system::ElementNodes node = group.nodes(e);
  const Vec3d line = vec(rest.x[node[1]]) - vec(rest.x[node[0]]), r = unit(line);
  const model::Index third = system.model.beams.orientation[group.element[e]];
  const Vec3d towards = third == model::none ? Vec3d{} : system.ties.x[third] - vec(rest.x[node[0]]);
  const Vec3d in_plane = towards - dot(towards, r) * r;
  const double half = 0.5 * system.model.materials[system.model.parts[group.part].material].density * norm(line);
  const double is = half * section.moment_s, it = half * section.moment_t;
  // Without a third node the section has no direction in space, and is as large as it may be.
  const bool turned = !(norm(in_plane) > 0.0);
  const Vec3d s = turned ? Vec3d{} : unit(in_plane), t = turned ? Vec3d{} : cross(r, s);
  const double round = turned ? std::max(is, it) : 0.0;
  const auto component = [&](double Vec3d::*i, double Vec3d::*j) {
    const double same = i == j ? round : 0.0;
    return same + (is + it - round) * r.*i * r.*j + is * s.*i * s.*j + it * t.*i * t.*j;
  };
  return {component(&Vec3d::x, &Vec3d::x), component(&Vec3d::x, &Vec3d::y), component(&Vec3d::x, &Vec3d::z),
          component(&Vec3d::y, &Vec3d::y), component(&Vec3d::y, &Vec3d::z), component(&Vec3d::z, &Vec3d::z)};
}

/// Mass beside a node needs at least the inertia of being there, S^t S / m.
void add_least_inertia(NodalMass& n) {
  if (!(n.mass > 0.0)) return;
  std::size_t place = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) {
      double square = 0.0;
      for (std::size_t k = 0; k < 3; ++k) square += n.first[k][i] * n.first[k][j];
      n.inertia[place++] += square / n.mass;
    }
}

/// Masses at the nodes as the elements, point masses and given bodies put them there.
std::vector<NodalMass> nodal_masses(const system::System& system, const system::State& rest) {
  std::vector<NodalMass> at_node(system.all_nodes());
  const auto put = [&](int node, const NodalMass& share) { at_node[node].add(share); };
  for (const auto& group : system.groups) {
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      const system::ElementNodes node = group->nodes(e);
      for (std::size_t a = 0; a < at(group->nodes_per_element); ++a)
        put(node[a], nodal_share(system, *group, e, a, rest));
    }
  }
  for (const system::System::MassOnlyElement& mass_only : system.mass_only_elements())
    for (int a = 0; a < mass_only.corners; ++a) {
      const double inertia = mass_only.nodal_inertia;
      put(mass_only.node[a], {mass_only.nodal_mass(a), {inertia, 0, 0, inertia, 0, inertia}, {}});
    }
  for (const model::PointMass& m : system.model.masses) put(system.node_of[m.node], {m.mass, {}, {}});
  // Where nodes move as one until the mesh tears there is no edge.
  for (const model::TiedNodes& tied : system.model.tied_nodes)
    for (const model::Index n : tied.nodes)
      if (const int node = system.node_of[n]; system.map.dependent(node))
        at_node[system.map.terms(node).front().node].add(std::exchange(at_node[node], {}));
  for (NodalMass& n : at_node) add_least_inertia(n);
  for (const model::PointInertia& p : system.model.inertias) put(system.node_of[p.node], {p.mass, p.inertia, {}});
  for (const system::RigidBody& body : system.bodies) {
    const model::RigidBody& source = system.model.rigid_bodies[body.source];
    if (source.given) at_node[body.node] = {source.inertia.mass, source.inertia.inertia, {}};
  }
  // A given mass stands for all that the body carries, nodes that are tied to it included, as in a run.
  for (std::size_t k = 0; k < system.nodes; ++k) {
    const int b = system.rigid_body_of_node(static_cast<int>(k));
    if (b >= 0 && system.model.rigid_bodies[system.bodies[b].source].given) at_node[k] = {};
  }
  return at_node;
}

/// Positions at rest, which is all that stiffnesses need.
system::State at_rest(const system::System& system) {
  system::State state;
  state.x.resize(system.all_nodes());
  for (std::size_t k = 0; k < system.nodes; ++k) set(state.x[k], system.ties.x[system.model_node[k]]);
  return state;
}

Symmetric assemble_stiffness(Matrices& m) {
  const system::System& system = m.system;
  const system::State& rest = m.rest;
  const Equations& equations = m.equations;
  std::vector<std::vector<int>> lists;
  for (const auto& group : system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      const system::ElementNodes node = group->nodes(e);
      lists.push_back(DofMap(equations, element_nodes(*group, node), group->freedoms()).equations());
    }
  for (const BodyLink& link : m.links) lists.push_back(DofMap(equations, link.node, 6).equations());
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
        if (!group->alive(first + i)) continue;
        const system::ElementNodes node = group->nodes(first + i);
        scatter(DofMap(equations, element_nodes(*group, node), group->freedoms()), matrix(i), k);
      }
    }
  }
  const auto add_links = [&](bool rigid) {
    for (const BodyLink& link : m.links)
      if (link.rigid == rigid) scatter(DofMap(equations, link.node, 6), link.stiffness(), k);
  };
  add_links(false);
  stiffen_joints(m.links, equations, k);
  add_links(true);
  return k;
}

Symmetric assemble_mass(const Equations& equations, const std::vector<NodalMass>& nodal) {
  std::vector<std::vector<int>> lists;
  const auto dof_map = [&](std::size_t k) {
    const int node = static_cast<int>(k);
    return DofMap(equations, {&node, 1}, 6);
  };
  for (std::size_t k = 0; k < nodal.size(); ++k) lists.push_back(dof_map(k).equations());
  Symmetric m(pattern(at(equations.size()), lists));
  for (std::size_t k = 0; k < nodal.size(); ++k) scatter(dof_map(k), mass_matrix(nodal[k]), m);
  return m;
}

/// K with what a prestress adds, and M, in the unknowns that have any stiffness.
void assemble(Matrices& m) {
  const auto stiffness = [&] {
    Symmetric k = assemble_stiffness(m);
    return m.prestress ? sum(k, m.prestress->stiffness(m.equations)) : std::move(k);
  };
  m.stiffness = stiffness();
  const std::size_t all = m.size();
  if (const std::vector<char> loose = unresisted(m.stiffness); std::ranges::count(loose, 1) > 0) {
    m.equations.constrain(loose);
    m.stiffness = stiffness();
  }
  if (const std::vector<Equations::Turned> askew = unresisted_askew(m.equations, m.stiffness); !askew.empty()) {
    m.equations.turn(askew);
    m.stiffness = stiffness();
  }
  m.auto_constrained = static_cast<int>(all - m.size());
  m.mass = assemble_mass(m.equations, m.nodal_mass);
  // What cancels between elements or belongs to another direction is left as round-off of a few 1e-16.
  m.stiffness.drop_small(1e-14);
  m.mass.drop_small(1e-14);
}

}  // namespace

void NodalMass::add(const NodalMass& more) {
  mass += more.mass;
  for (std::size_t i = 0; i < 6; ++i) inertia[i] += more.inertia[i];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) first[i][j] += more.first[i][j];
}

SixDof NodalMass::momentum(const SixDof& motion) const {
  const std::array<double, 36> m = mass_matrix(*this);
  SixDof p{};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j) p[i] += m[6 * i + j] * motion[j];
  return p;
}

NodalMass nodal_share(const system::System& system, const system::ElementGroup& group, std::size_t e, std::size_t a,
                      const system::State& rest) {
  NodalMass share;
  share.mass = group.nodal_mass(e, static_cast<int>(a));
  const bool shell = group.kind == model::ElementKind::shell;
  // Solids with nodal rotations have rotary inertia in explicit dynamics for the sake of the step only.
  const bool solid = group.kind == model::ElementKind::solid;
  const double t = group.thickness(e), own = shell ? share.mass * t * t / 12.0 : solid ? 0.0 : group.nodal_inertia(e);
  share.inertia = {own, 0, 0, own, 0, own};
  if (const model::SectionBeam* section = resultant_section(system, group))
    share.inertia = section_inertia(system, group, e, *section, rest);
  if (!shell) return share;
  // A point at s beside the node has the normal velocity n . (v + w x s) = n . v + w . (s x n).
  const Vec3d n = shell_normal(group, e, rest), arm = cross(corner_offset(group, e, a, rest), n);
  const double normal[] = {n.x, n.y, n.z}, lever[] = {arm.x, arm.y, arm.z};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) share.first[i][j] = share.mass * normal[i] * lever[j];
  return share;
}

std::array<double, 36> mass_matrix(const NodalMass& n) {
  std::array<double, 36> m{};
  for (const std::size_t i : {0u, 1u, 2u}) m[7 * i] = n.mass;
  const system::Inertia& j = n.inertia;
  const double block[3][3] = {{j[0], j[1], j[2]}, {j[1], j[3], j[4]}, {j[2], j[4], j[5]}};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      m[6 * (3 + i) + 3 + k] = block[i][k];
      m[6 * i + 3 + k] = m[6 * (3 + k) + i] = n.first[i][k];
    }
  return m;
}

Matrices::Matrices(const system::System& s, Findings& findings)
    : system(s), rest(at_rest(s)), equations(s, findings), nodal_mass(nodal_masses(s, rest)), links(body_links(s)) {
  assemble(*this);
  if (auto_constrained > 0)
    findings.note({s.model.deck, 0, 0}, "*CONTROL_IMPLICIT_SOLVER",
                  fmt::format("{} directions of nodes are held, since nothing resists motion in them (AUTOSPC){}",
                              auto_constrained, s.model.implicit.geometric ? ", but for what a preload resists" : ""));
}

void stiffen(Matrices& m, std::shared_ptr<const Prestress> prestress) {
  Findings ignored_findings;  // when the matrices were made
  m.equations = Equations(m.system, ignored_findings);
  m.prestress = std::move(prestress);
  assemble(m);
}

Vec3d Matrices::place(std::size_t node) const {
  return node < system.nodes ? vec(rest.x[node]) : system.bodies[node - system.nodes].center0;
}

std::vector<double> Matrices::element_energies(const system::ElementGroup& group, std::size_t e,
                                               const Columns& q) const {
  const std::size_t per_node = at(group.freedoms()), n = at(group.nodes_per_element) * per_node, count = q.count;
  std::vector<double> k(n * n), u(n * count), force(count), energy(count, 0.0);
  group.stiffness(e, rest, k);
  const system::ElementNodes node = group.nodes(e);
  for (std::size_t a = 0; a < at(group.nodes_per_element); ++a)
    for (std::size_t mode = 0; mode < count; ++mode) {
      const SixDof motion = equations.motion(node[a], q[mode]);
      for (std::size_t i = 0; i < per_node; ++i) u[(a * per_node + i) * count + mode] = motion[i];
    }
  for (std::size_t i = 0; i < n; ++i) {  // all modes side by side
    std::fill(force.begin(), force.end(), 0.0);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t mode = 0; mode < count; ++mode) force[mode] += k[i * n + j] * u[j * count + mode];
    for (std::size_t mode = 0; mode < count; ++mode) energy[mode] += 0.5 * u[i * count + mode] * force[mode];
  }
  return energy;
}

}  // namespace nugget::nvh
