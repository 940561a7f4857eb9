// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/response_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/index.hpp"
#include "nvh/matrices/resistance.hpp"
#include "nvh/response/harmonic_load.hpp"

namespace nugget::nvh {
namespace {

using Response = model::FrequencyResponse::Response;

/// How forces on a node and its followers add up to the one that is wanted: six factors by system node.
std::map<int, SixDof> weights(const system::System& system, int node, bool rotation, const Vec3d& direction) {
  SixDof wanted{};
  add_to(wanted, rotation, direction);
  std::map<int, SixDof> weight{{node, wanted}};
  for (std::size_t d = 0; d < system.nodes; ++d) {
    if (!system.map.dependent(static_cast<int>(d))) continue;
    for (const system::ConstraintMap::Block& b : system.map.blocks(static_cast<int>(d)))
      if (b.node == node)
        for (std::size_t i = 0; i < 6; ++i)
          for (std::size_t j = 0; j < 6; ++j) weight[static_cast<int>(d)][i] += b.of[i][j] * wanted[j];
  }
  return weight;
}

Form elastic_force(const Matrices& m, const std::map<int, SixDof>& weight) {
  Form form;
  for (const auto& group : m.system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      const system::ElementNodes node = group->nodes(e);
      const std::size_t corners = at(group->nodes_per_element), per_node = at(group->freedoms()),
                        n = corners * per_node;
      if (std::none_of(node.begin(), node.begin() + static_cast<std::ptrdiff_t>(corners),
                       [&](int k) { return weight.contains(k); }))
        continue;
      const std::vector<double> k = tangent_stiffness(m, *group, e);
      for (std::size_t i = 0; i < n; ++i) {
        const auto found = weight.find(node[i / per_node]);
        if (found == weight.end() || found->second[i % per_node] == 0.0) continue;
        for (std::size_t j = 0; j < n; ++j)
          form.add(node[j / per_node], static_cast<int>(j % per_node), found->second[i % per_node] * k[i * n + j]);
      }
    }
  for (const BodyLink& link : m.links) {
    const std::vector<double> k = link.stiffness();
    for (std::size_t i = 0; i < 12; ++i) {
      const auto found = weight.find(link.node[i / 6]);
      if (found == weight.end() || found->second[i % 6] == 0.0) continue;
      for (std::size_t j = 0; j < 12; ++j)
        form.add(link.node[j / 6], static_cast<int>(j % 6), found->second[i % 6] * k[12 * i + j]);
    }
  }
  return form;
}

Form inertia_force(const Matrices& m, const std::map<int, SixDof>& weight) {
  Form form;
  for (const auto& [node, factor] : weight) {
    const std::array<double, 36> mass = mass_matrix(m.nodal_mass[node]);
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        if (factor[i] * mass[6 * i + j] != 0.0) form.add(node, static_cast<int>(j), factor[i] * mass[6 * i + j]);
  }
  return form;
}

bool is_supported(const Equations& equations, int node, bool rotation, const Vec3d& direction) {
  return std::any_of(equations.supports().begin(), equations.supports().end(), [&](const Equations::Support& s) {
    return s.node == node && s.rotation == rotation && std::abs(dot(s.taken, direction)) > 1e-9;
  });
}

/// Whether nothing knows a node: no element, mass, body or tie, and no support.
bool is_unknown(const Matrices& m, int node) {
  if (m.system.map.dependent(node)) return false;
  for (int i = 0; i < 6; ++i)
    if (!m.equations.terms(node, i).empty()) return false;
  return m.nodal_mass[at(node)].none() &&
         std::ranges::none_of(m.equations.supports(), [&](const Equations::Support& s) { return s.node == node; });
}

/// What is asked for where the node is held since nothing resists its motion there.
void warn_of_held_responses(const Matrices& m, const Response& response, const char* keyword, Findings& findings) {
  if (m.auto_constrained == 0 || m.system.model.implicit.geometric) return;
  for (const Vec3d& d : response.directions) {
    Nodal along(m.system.all_nodes());
    for (const model::Index n : response.nodes)
      if (const int node = m.system.node_of[n]; !m.system.map.dependent(node))
        add_to(along[at(node)], response.rotation, d);
    for (const UnresistedLoad& held : unresisted_loads(m, std::move(along)))
      if (!held.nothing_there)
        findings.warning(response.place, keyword,
                         fmt::format("nothing resists {} of {} along ({:.3g} {:.3g} {:.3g}), which is held there "
                                     "(AUTOSPC): the response has none of it",
                                     held.moment ? "rotation" : "motion", name_of(m.system, held.node),
                                     held.direction.x, held.direction.y, held.direction.z),
                         "give the node stiffness in that direction, or ask for another one");
  }
}

}  // namespace

double Form::of(const Nodal& motion) const {
  double sum = 0.0;
  for (const Part& p : parts_) sum += p.factor * motion[p.node][p.component];
  return sum;
}

std::vector<Equations::Term> Form::over(const Equations& equations) const {
  std::map<int, double> sum;
  for (const Part& p : parts_)
    for (const Equations::Term& t : equations.terms(p.node, p.component)) sum[t.equation] += p.factor * t.factor;
  std::vector<Equations::Term> terms;
  for (const auto& [equation, factor] : sum) terms.push_back({equation, factor});
  return terms;
}

std::vector<ResponsePoint> response_points_of(const Matrices& m, const Response& response) {
  std::vector<ResponsePoint> points;
  for (const model::Index n : response.nodes)
    for (const Vec3d& d : response.directions) {
      ResponsePoint p;
      p.id = m.system.model.nodes.id[n];
      p.node = m.system.node_of[n];
      p.direction = d;
      p.rotation = response.rotation;
      p.force = response.quantity == model::FrequencyResponse::Quantity::force;
      if (p.force) {
        const std::map<int, SixDof> weight = weights(m.system, p.node, p.rotation, d);
        p.elastic = elastic_force(m, weight);
        p.inertia = inertia_force(m, weight);
      } else {
        const double component[] = {d.x, d.y, d.z};
        for (int i = 0; i < 3; ++i)
          if (component[i] != 0.0) p.motion.add(p.node, i + 3 * p.rotation, component[i]);
      }
      points.push_back(std::move(p));
    }
  return points;
}

void check_response(const Matrices& m, const Response& response, const char* keyword, Findings& findings) {
  const bool force = response.quantity == model::FrequencyResponse::Quantity::force;
  for (const model::Index n : response.nodes) {
    const int node = m.system.node_of[n], id = m.system.model.nodes.id[n];
    if (is_unknown(m, node)) {
      findings.error(response.place, keyword,
                     fmt::format("node {} belongs to no element, mass or rigid body: it has no motion", id),
                     "ask for a node of the structure");
      continue;
    }
    if (response.rotation && !turns(m.equations, node))
      findings.error(response.place, keyword, fmt::format("nothing turns at node {}: it has no rotations", id),
                     "ask for translations, or for a node of shells, beams or a rigid body");
    for (const Vec3d& d : response.directions)
      if (force && !is_supported(m.equations, node, response.rotation, d))
        findings.error(response.place, keyword,
                       fmt::format("the force of supports is wanted at node {}, and none holds it in direction "
                                   "({:.3g} {:.3g} {:.3g})",
                                   id, d.x, d.y, d.z),
                       "ask for a node with *BOUNDARY_SPC or enforced motion in that direction");
  }
  if (!force) warn_of_held_responses(m, response, keyword, findings);
}

}  // namespace nugget::nvh
