// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "kernel/element/cohesive_brick.hpp"
#include "kernel/law/law_components.hpp"
#include "model/bond.hpp"
#include "reading/builder/passes.hpp"

namespace nugget::reading {
namespace {

/// Eight different nodes, or six of a wedge whose triangles are its faces.
bool has_two_faces(const Model& model, std::size_t solid) {
  const auto& n = model.solids.node[solid];
  const std::size_t different = model.solids.corners(solid).size();
  return different == 8 || (different == 6 && n[2] == n[3] && n[6] == n[7]);
}

/// The surface midway: whether it turns over at no corner, its shortest side, and the pairs of nodes.
struct Midway {
  bool is_plain = true;
  double shortest = std::numeric_limits<double>::infinity(), height = 0.0, aslant = 0.0;

  explicit Midway(const std::array<Vec3d, 8>& x) {
    std::array<Vec3d, 4> m;
    for (std::size_t a = 0; a < 4; ++a) m[a] = 0.5 * (x[a] + x[a + 4]);
    const Vec3d across = cross(m[2] - m[0], m[3] - m[1]);
    const double longest = std::max(norm(m[2] - m[0]), norm(m[3] - m[1]));
    is_plain = norm(across) > 1e-9 * longest * longest;
    if (!is_plain) return;
    const Vec3d normal = unit(across);
    for (std::size_t a = 0; a < 4; ++a) {
      const Vec3d side = m[(a + 1) % 4] - m[a], before = m[(a + 3) % 4] - m[a], pair = x[a + 4] - x[a];
      if (dot(cross(side, before), normal) < -1e-9 * longest * longest) is_plain = false;
      if (norm(side) > 0.0) shortest = std::min(shortest, norm(side));
      height += 0.25 * dot(pair, normal);
      aslant = std::max(aslant, norm(pair - dot(pair, normal) * normal));
    }
  }
};

/// Whether N1-N4 and N5-N8 are the closest of the three pairs of opposite faces.
bool are_closest_faces(const std::array<Vec3d, 8>& x) {
  const auto apart = [&x](const std::array<int, 4>& one, const std::array<int, 4>& other) {
    Vec3d sum{};
    for (std::size_t i = 0; i < 4; ++i) sum += 0.25 * (x[other[i]] - x[one[i]]);
    return norm(sum);
  };
  return apart({0, 1, 2, 3}, {4, 5, 6, 7}) <=
         (1.0 + 1e-6) * std::min(apart({0, 1, 5, 4}, {3, 2, 6, 7}), apart({0, 3, 7, 4}, {1, 2, 6, 5}));
}

/// What is wrong with a brick, or nothing.
struct Fault {
  std::string what, remedy;
};
Fault fault_of(const Model& model, std::size_t solid, const kernel::CohesiveBond& bond) {
  if (!has_two_faces(model, solid))
    return {"repeats nodes, expected two faces of four nodes, or of three with N3 = N4 and N7 = N8",
            "write a wedge of adhesive as N1 N2 N3 N3 N5 N6 N7 N7, its triangles on the sheets"};
  if (bond.between_closest_faces && !are_closest_faces(corners_of(model, solid)))
    return {"has other faces that lie closer than N1-N4 and N5-N8, and with THKDIR = 0 would lie between those",
            "number it so that N1-N4 lie on one sheet and N5-N8 over them on the other, or give THKDIR 1"};
  const Midway m(corners_of(model, solid));
  if (!m.is_plain)
    return {"has no area midway between the faces N1-N4 and N5-N8, or one that turns over",
            "number N1 to N4 around one sheet, N5 to N8 on the other in the same sense, N5 over N1"};
  if (m.height < -1e-6 * m.shortest)
    return {fmt::format("is upside down: by its numbering the face N5-N8 lies {:.4g} below N1-N4", -m.height),
            "exchange the two faces, or turn the sense of both: seen from N5-N8, N1 to N4 run counterclockwise"};
  if (bond.yields() && !(bond.thickness_in(std::max(0.0, m.height)) > 1e-9 * m.shortest))
    return {"has no thickness, from which its stiffness and its strain rates follow",
            "give THICK (*MAT_169: BTHK) of its material"};
  if (!(bond_mass(model, solid, bond) > 0.0))
    return {"has no thickness, so with a density per volume no mass and no time step",
            "give the density per area and ROFLG = 1"};
  return {};
}

}  // namespace

void check_bonds(Builder& b) {
  const Model& m = b.model;
  Tally faults(b.findings, Severity::error, "*ELEMENT_SOLID"), odd(b.findings, Severity::warning, "*ELEMENT_SOLID"),
      loose(b.findings, Severity::warning, "*ELEMENT_SOLID");
  std::vector<char> turned(m.nodes.size(), 0);
  for (const auto& nodes : m.shells.node)
    for (const Index n : nodes) turned[n] = 1;
  const bool tied = std::any_of(m.contacts.begin(), m.contacts.end(),
                                [](const Contact& c) { return c.tie() && !c.ties_what_touches(); });
  for (std::size_t e = 0; e < m.solids.size(); ++e) {
    const Part& part = m.parts[m.solids.part[e]];
    const kernel::CohesiveBond* bond = bond_of(m, part);
    if (bond == nullptr || m.solids.quadratic(e)) continue;
    if (const Fault fault = fault_of(m, e, *bond); !fault.what.empty()) {
      faults.add(
          m.solids.place[e], [&] { return fmt::format("adhesive brick {} {}", m.solids.id[e], fault.what); },
          fault.remedy);
      continue;
    }
    const Midway midway(corners_of(m, e));
    if (midway.height > midway.shortest || midway.aslant > 0.5 * midway.shortest)
      odd.add(
          m.solids.place[e],
          [&] {
            return fmt::format(
                "the faces N1-N4 and N5-N8 of adhesive brick {} lie {:.4g} apart and {:.4g} aside of "
                "each other, its shortest side is {:.4g}: they may not be those on the sheets",
                m.solids.id[e], midway.height, midway.aslant, midway.shortest);
          },
          "number N1 to N4 on one sheet, N5 to N8 over them on the other");
    const bool apart = midway.height > 1e-6 * midway.shortest;
    if (apart && !bond_between_shells(m, e) &&
        std::ranges::all_of(m.solids.node[e], [&](Index n) { return turned[n] == 1; }))
      loose.add(
          m.solids.place[e],
          [&] {
            return fmt::format("adhesive brick {} of ELFORM 19 joins shells {:.4g} apart, whose spins it does not see",
                               m.solids.id[e], midway.height);
          },
          "write ELFORM 20");
    const auto has_no_shell = [&](Index n) { return turned[n] == 0; };
    const auto& nodes = m.solids.node[e];
    if (!tied && bond_between_shells(m, e) && std::any_of(nodes.begin(), nodes.end(), has_no_shell))
      loose.add(
          m.solids.place[e],
          [&] {
            return fmt::format(
                "adhesive brick {} is of ELFORM 20, but has nodes that are of no shell: they turn "
                "freely and give way to shear",
                m.solids.id[e]);
          },
          "write ELFORM 19 for adhesive between solids, or on faces that do not turn");
  }
}

}  // namespace nugget::reading
