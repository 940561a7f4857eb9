// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "kernel/element/quadratic_tetrahedron.hpp"
#include "model/bond.hpp"
#include "model/lumped_mass.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

const Vec3d& position(const Model& m, Index node) {
  return m.nodes.x[node];
}

/// Largest angle between the normals of the two triangles on either side of a diagonal [degrees].
double warpage(const std::array<Vec3d, 4>& x) {
  const auto angle = [](const Vec3d& a, const Vec3d& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b)) * 180.0 / std::numbers::pi;
  };
  const auto normal = [&](std::size_t i, std::size_t j, std::size_t k) { return cross(x[j] - x[i], x[k] - x[i]); };
  return std::max(angle(normal(0, 1, 2), normal(0, 2, 3)), angle(normal(0, 1, 3), normal(1, 2, 3)));
}

/// Shells without a thickness of their own: said once, of the section that they take it from.
void report_sections_without_thickness(Builder& b) {
  const Model& m = b.model;
  std::vector<Index> first(m.shell_sections.size(), none);
  std::vector<int> count(m.shell_sections.size(), 0);
  for (std::size_t e = 0; e < m.shells.size(); ++e) {
    const Index section = m.parts[m.shells.part[e]].section;
    if (section == none || !(m.shells.thickness[e] <= 0.0) || !(m.shell_sections[section].thickness <= 0.0)) continue;
    if (count[section]++ == 0) first[section] = static_cast<Index>(e);
  }
  for (std::size_t s = 0; s < first.size(); ++s)
    if (count[s] > 0)
      b.findings.error(m.shell_sections[s].place, "*SECTION_SHELL",
                       fmt::format("section {}: thickness 0, expected more than 0: {} shells take theirs from it, the "
                                   "first is {}",
                                   m.shell_sections[s].id, count[s], m.shells.id[first[s]]),
                       "give T1, or the shells thicknesses of their own (*ELEMENT_SHELL_THICKNESS)");
}

void check_shells(Builder& b) {
  report_sections_without_thickness(b);
  const Model& m = b.model;
  const double largest_warp = m.control.warp_warning;
  Tally flat(b.findings, Severity::error, "*ELEMENT_SHELL"), crossed(b.findings, Severity::error, "*ELEMENT_SHELL"),
      coincident(b.findings, Severity::warning, "*ELEMENT_SHELL"), thin(b.findings, Severity::error, "*ELEMENT_SHELL"),
      warped(b.findings, Severity::warning, "*ELEMENT_SHELL");
  for (std::size_t e = 0; e < m.shells.size(); ++e) {
    const auto& n = m.shells.node[e];
    const std::array<Vec3d, 4> x{position(m, n[0]), position(m, n[1]), position(m, n[2]), position(m, n[3])};
    const int id = m.shells.id[e];
    const Vec3d across = cross(x[2] - x[0], x[3] - x[1]);
    const double longest = std::max(dot(x[2] - x[0], x[2] - x[0]), dot(x[3] - x[1], x[3] - x[1]));
    const Index section = m.parts[m.shells.part[e]].section;
    if (section != none && m.shells.thickness[e] <= 0.0 && m.shell_sections[section].thickness > 0.0)
      thin.add(
          m.shells.place[e],
          [&] { return fmt::format("shell {}: thickness {:g}, expected more than 0", id, m.shells.thickness[e]); },
          "mend its nodal thicknesses, or leave them to its section");
    if (!(norm(across) > 1e-12 * longest)) {
      flat.add(
          m.shells.place[e], [&] { return fmt::format("shell {} has no area, or its sides cross each other", id); },
          "remove it or mend its nodes");
      continue;
    }
    if (m.shells.triangle(e)) continue;
    for (std::size_t i = 0; i < 4; ++i)
      if (const std::size_t j = (i + 1) % 4; n[i] != n[j] && dot(x[j] - x[i], x[j] - x[i]) <= 1e-12 * longest)
        coincident.add(
            m.shells.place[e],
            [&] {
              return fmt::format("shell {}: its nodes {} and {} are at one place, and move apart", id, m.nodes.id[n[i]],
                                 m.nodes.id[n[j]]);
            },
            "merge them: it is a triangle");
    // Edges cross where the corner normals point to both sides of the element's.
    int inward = 0;
    for (std::size_t i = 0; i < 4; ++i)
      inward += dot(cross(x[(i + 1) % 4] - x[i], x[(i + 3) % 4] - x[i]), across) < 0.0;
    if (inward >= 2)
      crossed.add(
          m.shells.place[e], [&] { return fmt::format("the sides of shell {} cross each other", id); },
          "number its nodes around the element");
    else if (const double warp = warpage(x); largest_warp > 0.0 && warp > largest_warp)
      warped.add(
          m.shells.place[e],
          [&] {
            return fmt::format("shell {} is warped by {:.1f} degrees, more than WRPANG {:g}", id, warp, largest_warp);
          },
          "split it into triangles, or mesh finer");
  }
}

/// Quads with two corners at one node are stiffer or softer by which corner that is, unless they become triangles.
void report_collapsed_quads(Builder& b) {
  const Model& m = b.model;
  if (m.control.sort_triangles != SortTriangles::no) return;
  constexpr double few = 0.1;  // of a part
  std::vector<std::size_t> collapsed(m.parts.size(), 0), all(m.parts.size(), 0);
  for (std::size_t e = 0; e < m.shells.size(); ++e) {
    ++all[m.shells.part[e]];
    if (m.shells.triangle(e)) ++collapsed[m.shells.part[e]];
  }
  for (std::size_t p = 0; p < m.parts.size(); ++p) {
    const Part& part = m.parts[p];
    if (collapsed[p] == 0 || part.section == none || part.material == none) continue;
    if (std::holds_alternative<kernel::Rigid>(m.materials[part.material].law)) continue;
    const int elform = m.shell_sections[part.section].elform;
    if (elform != 2 && elform != 16) continue;  // membranes have triangles of their own
    b.findings.add(
        {static_cast<double>(collapsed[p]) > few * static_cast<double>(all[p]) ? Severity::warning : Severity::note,
         part.place,
         "*PART",
         {},
         {},
         fmt::format("part {}: {} of its {} shells are quadrilaterals with two corners at one node, computed as such "
                     "in an explicit run (ESORT 0): how stiff each is depends on which corner that is",
                     part.id, collapsed[p], all[p]),
         "give ESORT = 1 in *CONTROL_SHELL: they are computed as triangles"});
  }
}

/// Smallest Jacobian determinant over the corners of a brick with eight different nodes, times eight.
double smallest_corner_volume(const Model& m, std::size_t e) {
  static constexpr std::size_t next[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                             {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
  const auto& n = m.solids.node[e];
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 8; ++i) {
    const auto edge = [&](std::size_t j) { return position(m, n[next[i][j]]) - position(m, n[i]); };
    smallest = std::min(smallest, dot(edge(0), cross(edge(1), edge(2))));
  }
  return smallest;
}

bool has_equal_nodes(const std::array<Index, 8>& nodes) {
  for (std::size_t i = 0; i < 8; ++i)
    for (std::size_t j = i + 1; j < 8; ++j)
      if (nodes[i] == nodes[j]) return true;
  return false;
}

std::array<Vec3d, 10> ten_places(const Model& m, std::size_t e) {
  std::array<Vec3d, 10> x;
  for (std::size_t a = 0; a < 10; ++a) x[a] = position(m, m.solids.ten(e)[a]);
  return x;
}

double least_volume(const Model& m, std::size_t e) {
  return kernel::quadratic_tetrahedron_least_volume(ten_places(m, e));
}

/// How far the nodes of a quadratic tetrahedron are from the middles of their edges, as a share of the edge.
double farthest_from_middle(const Model& m, std::size_t e) {
  const std::array<Vec3d, 10> x = ten_places(m, e);
  double most = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vec3d &from = x[kernel::quadratic_tetrahedron_edge[i][0]], &to = x[kernel::quadratic_tetrahedron_edge[i][1]];
    most = std::max(most, norm(x[4 + i] - 0.5 * (from + to)) / norm(to - from));
  }
  return most;
}

/// Ten nodes belong to formulations 16 and 17, and they to ten nodes; rigid parts have no formulation.
void check_order(const Model& m, std::size_t e, int elform, Tally& order) {
  const Part& part = m.parts[m.solids.part[e]];
  const bool quadratic = elform == 16 || elform == 17;
  if (m.solids.quadratic(e) == quadratic || part.section == none || part.rigid_body != none) return;
  order.add(
      m.solids.place[e],
      [&] {
        return fmt::format("solid {} has {} nodes, which formulation {} does not", m.solids.id[e],
                           m.solids.different_nodes(e).size(), elform);
      },
      quadratic ? "give it ten nodes, or keep four and write *ELEMENT_SOLID_TET4TOTET10"
                : "give its part a section of ELFORM 16");
}

void check_solids(Builder& b) {
  const Model& m = b.model;
  Tally negative(b.findings, Severity::error, "*ELEMENT_SOLID"), bent(b.findings, Severity::warning, "*ELEMENT_SOLID");
  Tally misshapen(b.findings, Severity::error, "*ELEMENT_SOLID"), order(b.findings, Severity::error, "*ELEMENT_SOLID");
  for (std::size_t e = 0; e < m.solids.size(); ++e) {
    const int id = m.solids.id[e];
    if (bond_of(m, m.parts[m.solids.part[e]])) continue;  // check_bonds
    const double volume = m.solids.quadratic(e) ? least_volume(m, e) : solid_volume(m, e);
    if (!(volume > 0.0))
      negative.add(
          m.solids.place[e],
          [&] {
            return fmt::format("solid {} has the volume {:g}, expected more than 0 (negative Jacobian)", id, volume);
          },
          m.solids.quadratic(e)
              ? "number its nodes 1-3 around the bottom and 4 above them, seen from inside right-handed, then those "
                "amid "
                "1-2, 2-3, 3-1, 1-4, 2-4, 3-4"
              : "number its nodes 1-4 around the bottom and 5-8 above them, seen from inside right-handed");
    else if (const double off = m.solids.quadratic(e) ? farthest_from_middle(m, e) : 0.0; off > 0.25)
      bent.add(
          m.solids.place[e],
          [&] {
            return fmt::format("a node amid an edge of solid {} is {:.2f} of its length off the middle", id, off);
          },
          "number nodes 5-10 amid the edges 1-2, 2-3, 3-1, 1-4, 2-4, 3-4, or mend the mesh; its step is short");
    else if (!has_equal_nodes(m.solids.node[e]) && !(smallest_corner_volume(m, e) > 0.0))
      bent.add(
          m.solids.place[e],
          [&] { return fmt::format("solid {} is turned inside out at a corner (negative Jacobian there)", id); },
          "mend the mesh there; it may fail early");
    const Index section = m.parts[m.solids.part[e]].section;
    const int elform = section == none ? 1 : m.solid_sections[section].elform;
    check_order(m, e, elform, order);
    const bool tetrahedron = !m.solids.quadratic(e) && (elform == 4 || elform == 10 || elform == 13);
    const std::size_t corners = tetrahedron || elform == 15 ? m.solids.corners(e).size() : 0;
    if ((tetrahedron && corners != 4) || (elform == 15 && corners != 6))
      misshapen.add(
          m.solids.place[e],
          [&] {
            return fmt::format("solid {} has {} different nodes, expected {} of formulation {}", id, corners,
                               tetrahedron ? "the four of a tetrahedron" : "the six of a wedge", elform);
          },
          "write ELFORM 1 and sort by ESORT = 1 of *CONTROL_SOLID, or part the mesh by shape");
  }
}

/// Whether it matters how the cross-section is turned about the beam.
bool directed(const SectionBeam& s) {
  if (s.elform == 2) return s.moment_s != s.moment_t;
  if (s.points) return true;
  return s.cross_section == 0 && (s.outer != s.inner || s.quadrature != 2);
}

/// Whether the third node, or the vector in its place, determines a side.
bool has_side(const Model& m, std::size_t e) {
  const auto& n = m.beams.node[e];
  const Vec3d line = position(m, n[1]) - position(m, n[0]), side = m.beams.side(e, m.nodes.x);
  return norm(cross(line, side)) > 1e-6 * norm(line) * norm(side);
}

void check_beams(Builder& b) {
  const Model& m = b.model;
  Tally short_ones(b.findings, Severity::note, "*ELEMENT_BEAM");
  const auto discrete = [&](std::size_t e) {
    const Index section = m.parts[m.beams.part[e]].section;
    return section != none && m.beam_sections[section].elform == 6;
  };
  Tally without(b.findings, Severity::error, "*ELEMENT_BEAM");
  for (std::size_t e = 0; e < m.beams.size(); ++e) {
    const bool has_length = beam_length(m, e) > 0.0;
    const Index section = m.parts[m.beams.part[e]].section;
    const int elform = section == none ? 9 : m.beam_sections[section].elform;
    if (!has_length && elform != 6 && elform != 9)
      without.add(
          m.beams.place[e], [&] { return fmt::format("beam {} has no length", m.beams.id[e]); },
          "remove it, or correct its nodes");
    else if (!has_length && !discrete(e))
      short_ones.add(m.beams.place[e], [&] {
        return fmt::format("beam {} has no length; a weld of no length takes its length from its tie", m.beams.id[e]);
      });
    else if (elform <= 2 && directed(m.beam_sections[section]) && !has_side(m, e))
      without.add(
          m.beams.place[e],
          [&] {
            return fmt::format("beam {} has no third node off its line, so its axes s and t are open", m.beams.id[e]);
          },
          "give N3, a node in the plane of r and s");
  }
}

/// Nodes that nothing holds or uses do not move with anything; often the remains of editing.
void count_free_nodes(Builder& b) {
  const Model& m = b.model;
  std::vector<char> used(m.nodes.size(), 0);
  const auto use = [&](Index n) {
    if (n != none) used[n] = 1;
  };
  for (const auto& nodes : m.shells.node) std::for_each(nodes.begin(), nodes.end(), use);
  for (std::size_t e = 0; e < m.solids.size(); ++e) std::ranges::for_each(m.solids.nodes(e), use);
  for (const auto& nodes : m.beams.node) std::for_each(nodes.begin(), nodes.end(), use);
  std::for_each(m.beams.orientation.begin(), m.beams.orientation.end(), use);
  for (const Discrete& d : m.discretes) std::for_each(d.node.begin(), d.node.end(), use);
  for (const SpringOrientation& o : m.spring_orientations) std::for_each(o.node.begin(), o.node.end(), use);
  for (const auto& p : m.masses) use(p.node);
  for (const auto& p : m.inertias) use(p.node);
  std::ranges::for_each(b.nodes_of_rings, use);
  for (const auto& body : m.rigid_bodies) std::for_each(body.nodes.begin(), body.nodes.end(), use);
  for (const auto& weld : m.interpolation_spotwelds) std::for_each(weld.nodes.begin(), weld.nodes.end(), use);
  for (const auto& interpolation : m.interpolations) use(interpolation.node);
  for (const auto& belt : m.belts.elements) std::for_each(belt.node.begin(), belt.node.end(), use);
  for (const NodalLoad& load : m.nodal_loads) {
    const auto lone = std::find_if(load.nodes.begin(), load.nodes.end(), [&](Index n) { return used[n] == 0; });
    if (lone != load.nodes.end())
      b.findings.warning(load.place, "*LOAD_NODE",
                         fmt::format("node {} is loaded, but belongs to no element, mass or rigid body: the load moves "
                                     "nothing",
                                     m.nodes.id[*lone]),
                         "load a node of the structure");
  }
  const auto free = std::count(used.begin(), used.end(), 0);
  if (free == 0) return;
  const auto first = static_cast<std::size_t>(std::find(used.begin(), used.end(), 0) - used.begin());
  b.findings.note({m.deck, 0, 0}, "*NODE",
                  free == 1 ? fmt::format("node {} belongs to no element, mass or rigid body", m.nodes.id[first])
                            : fmt::format("{} nodes belong to no element, mass or rigid body; the first is node {}",
                                          free, m.nodes.id[first]));
}

}  // namespace

void check_mesh(Builder& b) {
  check_shells(b);
  report_collapsed_quads(b);
  check_solids(b);
  check_bonds(b);
  check_beams(b);
  report_doubled_elements(b);
  count_free_nodes(b);
}

}  // namespace nugget::reading
