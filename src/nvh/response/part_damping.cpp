// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/part_damping.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/index.hpp"
#include "nvh/matrices/assembly.hpp"
#include "nvh/matrices/nodal.hpp"

namespace nugget::nvh {
namespace {

/// alpha by model part.
std::vector<double> mass_factors(const model::Model& model) {
  std::vector<double> alpha(model.parts.size(), 0.0);
  for (const model::MassDamping& d : model.damping.mass)
    if (!d.everything) alpha[d.part] += d.factor * (d.curve == model::none ? 1.0 : model.curves[d.curve].y.front());
  return alpha;
}

/// beta by model part.
std::vector<double> stiffness_factors(const model::Model& model) {
  std::vector<double> beta(model.parts.size(), 0.0);
  for (const model::StiffnessDamping& d : model.damping.stiffness) beta[d.part] += d.time;
  return beta;
}

/// A matrix of nodes or of an element, and the unknowns that it reaches.
struct Piece {
  DofMap dof_map;
  std::vector<double> c;
};

/// Of one element: its dashpots, and the share of its stiffness.
void add_element(const Matrices& m, const system::ElementGroup& group, std::size_t e, double beta,
                 std::vector<Piece>& pieces) {
  const system::ElementNodes node = group.nodes(e);
  const auto put = [&](std::vector<double> c) {
    pieces.push_back({DofMap(m.equations, element_nodes(group, node), group.freedoms()), std::move(c)});
  };
  const std::size_t n = at(group.nodes_per_element) * at(group.freedoms());
  if (std::vector<double> c(n * n); group.viscosity(e, m.rest, c)) put(std::move(c));
  if (beta == 0.0) return;
  std::vector<double> k = element_stiffness(m, group, e);
  for (double& v : k) v *= beta;
  put(std::move(k));
}

void add_masses(const Matrices& m, const system::ElementGroup& group, std::size_t e, double alpha,
                std::vector<Piece>& pieces) {
  const system::ElementNodes node = group.nodes(e);
  for (std::size_t a = 0; a < at(group.nodes_per_element); ++a) {
    const std::array<double, 36> mass = mass_matrix(nodal_share(m.system, group, e, a, m.rest));
    std::vector<double> c(mass.begin(), mass.end());
    for (double& v : c) v *= alpha;
    pieces.push_back({DofMap(m.equations, {&node[a], 1}, 6), std::move(c)});
  }
}

/// Of one without stiffness (*MAT_NULL).
void add_masses(const Matrices& m, const system::System::MassOnlyElement& element, double alpha,
                std::vector<Piece>& pieces) {
  for (int a = 0; a < element.corners; ++a) {
    const double mass = alpha * element.nodal_mass(a), inertia = alpha * element.nodal_inertia;
    std::vector<double> c(36, 0.0);
    for (std::size_t i = 0; i < 6; ++i) c[7 * i] = i < 3 ? mass : inertia;
    pieces.push_back({DofMap(m.equations, {&element.node[a], 1}, 6), std::move(c)});
  }
}

bool same(const Vec3d& scale) {
  return scale.x == 1.0 && scale.y == 1.0 && scale.z == 1.0;
}

}  // namespace

Symmetric part_damping(const Matrices& m) {
  const std::vector<double> alpha = mass_factors(m.system.model), beta = stiffness_factors(m.system.model);
  std::vector<Piece> pieces;
  for (const auto& group : m.system.groups)
    for (std::size_t e = 0; e < group->size(); ++e) {
      if (!group->alive(e)) continue;
      add_element(m, *group, e, beta[group->part], pieces);
      if (alpha[group->part] != 0.0) add_masses(m, *group, e, alpha[group->part], pieces);
    }
  for (const system::System::MassOnlyElement& mass_only : m.system.mass_only_elements())
    if (alpha[mass_only.part] != 0.0) add_masses(m, mass_only, alpha[mass_only.part], pieces);
  for (const BodyLink& link : m.links)
    if (link.damps()) pieces.push_back({DofMap(m.equations, link.node, 6), link.viscosity()});
  std::vector<std::vector<int>> lists;
  for (const Piece& p : pieces) lists.push_back(p.dof_map.equations());
  Symmetric c(pattern(m.size(), lists));
  for (const Piece& p : pieces) scatter(p.dof_map, p.c, c);
  return c;
}

void warn_of_idle_damping(const model::Model& model, bool of_parts, const Place& place, const char* keyword,
                          const char* remedy, Findings& findings) {
  const model::Damping& d = model.damping;
  const auto of_all = [](const model::MassDamping& mass) { return mass.everything; };
  std::vector<const char*> idle;
  if (std::ranges::any_of(d.mass, of_all)) idle.push_back("*DAMPING_GLOBAL");
  if (!of_parts && !std::ranges::all_of(d.mass, of_all)) idle.push_back("*DAMPING_PART_MASS");
  if (!of_parts && !d.stiffness.empty()) idle.push_back("*DAMPING_PART_STIFFNESS");
  if (!d.range.empty()) idle.push_back("*DAMPING_FREQUENCY_RANGE");
  if (!d.relative.empty()) idle.push_back("*DAMPING_RELATIVE");
  if (!idle.empty())
    findings.warning(place, keyword,
                     fmt::format("{} {} no part in it", fmt::join(idle, ", "), idle.size() == 1 ? "takes" : "take"),
                     remedy);
}

bool has_dashpots(const Matrices& m) {
  for (const auto& group : m.system.groups) {
    const std::size_t n = at(group->nodes_per_element) * at(group->freedoms());
    std::vector<double> c(n * n);
    if (group->size() > 0 && group->viscosity(0, m.rest, c)) return true;  // all elements of a group have one law
  }
  return std::ranges::any_of(m.links, &BodyLink::damps);
}

void check_part_damping(const Matrices& m, const Place& place, const char* keyword, Findings& findings) {
  const model::Model& model = m.system.model;
  const char* const remedy = "give DMPFLG 0 with DAMPF, LCDAM, DMPMAS or DMPSTF";
  bool any = has_dashpots(m);
  for (const model::MassDamping& d : model.damping.mass) {
    if (d.everything) continue;
    any = true;
    const int part = model.parts[d.part].id;
    if (d.curve != model::none) {
      const Curve& curve = model.curves[d.curve];
      if (std::any_of(curve.y.begin(), curve.y.end(), [&](double y) { return y != curve.y.front(); }))
        findings.error(place, "*DAMPING_PART_MASS",
                       fmt::format("the damping of part {} changes over time, which a harmonic response (DMPFLG 1) has "
                                   "not",
                                   part),
                       "give a constant curve");
    }
    if (!same(d.scale) || !same(d.rotary_scale))
      findings.error(place, "*DAMPING_PART_MASS",
                     fmt::format("scales by direction (part {}) are not built in responses over frequency", part),
                     remedy);
    if (model.parts[d.part].rigid_body != model::none)
      findings.error(place, "*DAMPING_PART_MASS",
                     fmt::format("part {} is rigid: its damping is not built in responses over frequency", part),
                     remedy);
  }
  for (const model::StiffnessDamping& d : model.damping.stiffness) {
    any = true;
    if (d.share != 0.0)
      findings.error(place, "*DAMPING_PART_STIFFNESS",
                     fmt::format("COEF of part {} is a share of critical damping at the highest frequency of each "
                                 "element, which means nothing in a response over frequency",
                                 model.parts[d.part].id),
                     "write Rayleigh's beta as a negative COEF");
  }
  if (!any)
    findings.warning(place, keyword, "DMPFLG is 1, but nothing damps: no dashpot, no *DAMPING_PART_MASS or _STIFFNESS",
                     remedy);
}

}  // namespace nugget::nvh
