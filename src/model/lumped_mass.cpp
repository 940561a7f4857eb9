// SPDX-License-Identifier: Apache-2.0
#include "model/lumped_mass.hpp"

#include <algorithm>
#include <numbers>
#include <span>

#include "base/index.hpp"
#include "kernel/element/quadratic_tetrahedron.hpp"
#include "kernel/element/tetrahedron.hpp"
#include "model/bond.hpp"

namespace nugget::model {

namespace {

const Vec3d& position(const Model& m, Index node) {
  return m.nodes.x[node];
}

template <class Section>
const Section* section_of(const std::vector<Section>& sections, const Part& part) {
  return part.section == none ? nullptr : &sections[part.section];
}

void share(std::vector<NodeMass>& out, std::span<const Index> nodes, double mass) {
  for (std::size_t a = 0; a < nodes.size(); ++a) out.push_back({nodes[a], mass_at(mass, nodes.size(), a)});
}

std::vector<NodeMass> joined(std::vector<NodeMass> shares) {
  std::stable_sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.node < b.node; });
  std::vector<NodeMass> out;
  for (const NodeMass& s : shares) {
    if (out.empty() || out.back().node != s.node) out.push_back({s.node, 0.0});
    out.back().mass += s.mass;
  }
  return out;
}

}  // namespace

double mass_at(double mass, std::size_t nodes, std::size_t node) {
  if (nodes == 10) return mass * kernel::quadratic_tetrahedron_mass_share(static_cast<int>(node));
  return mass / static_cast<double>(nodes);
}

double beam_area(const SectionBeam& s) {
  if (s.area > 0.0) return s.area;
  if (s.elform == 1 && s.cross_section == 0) return 0.25 * (s.outer[0] + s.outer[1]) * (s.inner[0] + s.inner[1]);
  const auto squared = [](const std::array<double, 2>& d) { return 0.5 * (d[0] * d[0] + d[1] * d[1]); };
  return 0.25 * std::numbers::pi * (squared(s.outer) - squared(s.inner));
}

double shell_area(const Model& m, std::size_t e) {
  const auto& n = m.shells.node[e];
  return 0.5 * norm(cross(position(m, n[2]) - position(m, n[0]), position(m, n[3]) - position(m, n[1])));
}

/// Four corners, and no one-point brick that is collapsed to them, which has a volume of its own.
static bool is_tetrahedron(const Model& m, std::size_t e) {
  if (m.solids.node[e][4] != m.solids.node[e][7] || m.solids.corners(e).size() != 4) return false;
  const Part& part = m.parts[m.solids.part[e]];
  const SectionSolid* section = section_of(m.solid_sections, part);
  const bool rigid = part.material != none && std::holds_alternative<kernel::Rigid>(m.materials[part.material].law);
  return rigid || m.control.sort_solids || (section && (section->elform == 4 || section->elform >= 10));
}

double solid_volume(const Model& m, std::size_t e) {
  if (m.solids.quadratic(e)) {
    std::array<Vec3d, 10> ten;
    for (std::size_t a = 0; a < 10; ++a) ten[a] = position(m, m.solids.ten(e)[a]);
    return kernel::quadratic_tetrahedron_volume(ten);
  }
  std::array<Vec3d, 8> x;
  if (is_tetrahedron(m, e)) {
    const std::vector<Index> corner = m.solids.corners(e);
    return kernel::tetrahedron_volume(
        {position(m, corner[0]), position(m, corner[1]), position(m, corner[2]), position(m, corner[3])});
  }
  for (std::size_t a = 0; a < 8; ++a) x[a] = position(m, m.solids.node[e][a]);
  return kernel::hexahedron_volume(x);
}

double beam_length(const Model& m, std::size_t e) {
  const auto& n = m.beams.node[e];
  return norm(position(m, n[1]) - position(m, n[0]));
}

/// Calls `visit(part, nodes, mass)` for each element of a part that has a section and a material.
template <class Visit>
static void each_mass(const Model& m, const Visit& visit) {
  const auto each = [&](const auto& elements, ElementKind kind, const auto& look) {
    for (std::size_t e = 0; e < elements.size(); ++e) {
      if (elements.part[e] == none) continue;
      const auto part = at(elements.part[e]);
      const Part& p = m.parts[part];
      if (p.kind != kind || p.material == none) continue;
      look(e, p, m.materials[p.material].density, part);
    }
  };
  each(m.shells, ElementKind::shell, [&](std::size_t e, const Part& p, double density, std::size_t part) {
    const SectionShell* shell = section_of(m.shell_sections, p);
    if (shell == nullptr) return;
    visit(part, std::span(m.shells.node[e]).first(m.shells.triangle(e) ? 3 : 4),
          (density * m.shells.thickness[e] + shell->extra_mass) * shell_area(m, e));
  });
  each(m.solids, ElementKind::solid, [&](std::size_t e, const Part& p, double density, std::size_t part) {
    const kernel::CohesiveBond* bond = bond_of(m, p);
    visit(part, m.solids.different_nodes(e), bond ? bond_mass(m, e, *bond) : density * solid_volume(m, e));
  });
  each(m.beams, ElementKind::beam, [&](std::size_t e, const Part& p, double density, std::size_t part) {
    const SectionBeam* beam = section_of(m.beam_sections, p);
    if (beam == nullptr) return;
    visit(part, m.beams.node[e],
          beam->elform == 6 ? density * beam->volume
                            : (density * beam_area(*beam) + beam->extra_mass) * beam_length(m, e));
  });
}

std::vector<std::vector<NodeMass>> lumped_masses(const Model& m) {
  std::vector<std::vector<NodeMass>> shares(m.parts.size());
  each_mass(m, [&](std::size_t part, std::span<const Index> nodes, double mass) { share(shares[part], nodes, mass); });
  for (std::vector<NodeMass>& of_part : shares) of_part = joined(std::move(of_part));
  return shares;
}

double mass_of_elements(const Model& m) {
  double sum = 0.0;
  each_mass(m, [&](std::size_t, std::span<const Index>, double mass) { sum += mass; });
  return sum;
}

std::vector<double> nodal_masses(const Model& m) {
  std::vector<double> mass(m.nodes.size(), 0.0);
  const auto add = [&](const auto& at) { mass[at.node] += at.mass; };
  for (const std::vector<NodeMass>& of_part : lumped_masses(m)) std::for_each(of_part.begin(), of_part.end(), add);
  std::for_each(m.masses.begin(), m.masses.end(), add);
  std::for_each(m.inertias.begin(), m.inertias.end(), add);
  return mass;
}

}  // namespace nugget::model
