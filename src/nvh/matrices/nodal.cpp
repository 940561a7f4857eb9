// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/nodal.hpp"

#include "base/index.hpp"
#include "nvh/matrices/prestress.hpp"

namespace nugget::nvh {

Vec3d part_of(const SixDof& six, bool rotation) {
  return rotation ? Vec3d{six[3], six[4], six[5]} : Vec3d{six[0], six[1], six[2]};
}

void add_to(SixDof& six, bool rotation, const Vec3d& v) {
  const std::size_t first = rotation ? 3 : 0;
  six[first] += v.x;
  six[first + 1] += v.y;
  six[first + 2] += v.z;
}

void apply_constraints(const system::System& system, Nodal& u) {
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) u[d][i] += b.of[i][j] * u[b.node][j];
  }
}

void transfer_forces(const system::System& system, Nodal& f) {
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) f[b.node][j] += b.of[i][j] * f[d][i];
    const bool turns = system.map.rotations(static_cast<int>(d));
    for (std::size_t i = 0; i < (turns ? 6u : 3u); ++i) f[d][i] = 0.0;
  }
}

std::vector<double> element_stiffness(const Matrices& m, const system::ElementGroup& group, std::size_t e) {
  const std::size_t n = at(group.nodes_per_element) * at(group.freedoms());
  std::vector<double> k(n * n);
  group.stiffness(e, m.rest, k);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) k[i * n + j] = k[j * n + i] = 0.5 * (k[i * n + j] + k[j * n + i]);
  return k;
}

std::vector<double> tangent_stiffness(const Matrices& m, const system::ElementGroup& group, std::size_t e) {
  std::vector<double> k = element_stiffness(m, group, e);
  if (m.prestress) m.prestress->add_element_stiffness(group, e, k);
  return k;
}

std::vector<double> element_force(const Matrices& m, const system::ElementGroup& group, std::size_t e, const Nodal& u) {
  const std::vector<double> k = element_stiffness(m, group, e);
  const system::ElementNodes node = group.nodes(e);
  const std::size_t per_node = at(group.freedoms()), n = at(group.nodes_per_element) * per_node;
  std::vector<double> f(n, 0.0);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) f[i] += k[i * n + j] * u[node[j / per_node]][j % per_node];
  return f;
}

Nodal forces_at_start(const Matrices& m) {
  Nodal all(m.system.all_nodes());
  for (const auto& group : m.system.groups) {
    const std::size_t per_node = at(group->freedoms()), n = at(group->nodes_per_element) * per_node;
    std::vector<double> f(n);
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e) || !group->force_at_start(e, m.rest, f)) continue;
      const system::ElementNodes node = group->nodes(e);
      for (std::size_t i = 0; i < n; ++i) all[node[i / per_node]][i % per_node] += f[i];
    }
  }
  for (const BodyLink& link : m.links)
    for (const ConstrainedMotion& constrained : link.constrained)
      for (std::size_t i = 0; i < 12; ++i) all[link.node[i / 6]][i % 6] += constrained.start * constrained.row[i];
  return all;
}

ConstrainedMotion::Row motion_of(const BodyLink& link, const Nodal& u) {
  ConstrainedMotion::Row motion;
  for (std::size_t i = 0; i < 12; ++i) motion[i] = u[link.node[i / 6]][i % 6];
  return motion;
}

Internal internal_forces(const Matrices& m, const Nodal& u) {
  Internal all{Nodal(u.size()), std::vector<double>(m.system.model.parts.size())};
  for (const auto& group : m.system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      const std::vector<double> k = tangent_stiffness(m, *group, e);
      const system::ElementNodes node = group->nodes(e);
      const std::size_t per_node = at(group->freedoms()), n = at(group->nodes_per_element) * per_node;
      double twice = 0.0;
      for (std::size_t i = 0; i < n; ++i) {
        double f = 0.0;
        for (std::size_t j = 0; j < n; ++j) f += k[i * n + j] * u[node[j / per_node]][j % per_node];
        all.force[node[i / per_node]][i % per_node] += f;
        twice += f * u[node[i / per_node]][i % per_node];
      }
      all.part_energy[group->part] += 0.5 * twice;
    }
  for (const BodyLink& link : m.links) {
    const ConstrainedMotion::Row motion = motion_of(link, u);
    for (const ConstrainedMotion& constrained : link.constrained) {
      double moved = 0.0;
      for (std::size_t i = 0; i < 12; ++i) moved += constrained.row[i] * motion[i];
      for (std::size_t i = 0; i < 12; ++i)
        all.force[link.node[i / 6]][i % 6] += constrained.spring * moved * constrained.row[i];
      all.link_energy += 0.5 * constrained.spring * moved * moved;
    }
  }
  if (m.prestress) m.prestress->add_arm_forces(u, all.force);
  return all;
}

Vec3d force_of_pressure(const Matrices& m, const model::Segment& s) {
  const auto place = [&](std::size_t a) { return m.system.ties.x[s[a]]; };
  if (s[3] == s[2]) return -0.5 * cross(place(1) - place(0), place(2) - place(0));
  return -0.5 * cross(place(2) - place(0), place(3) - place(1));
}

}  // namespace nugget::nvh
