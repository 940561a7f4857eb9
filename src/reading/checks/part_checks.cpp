// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "base/index.hpp"
#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/law_components.hpp"
#include "kernel/law/own_kernels.hpp"
#include "model/bond.hpp"
#include "reading/builder/passes.hpp"
#include "reading/cards/equation_of_state.hpp"

namespace nugget::reading {
namespace {

template <class L>
bool is(const Model& m, const Part& part) {
  return part.material != none && std::holds_alternative<L>(m.materials[part.material].law);
}

/// LS-DYNA's other fully integrated quadrilaterals, which 16 stands for.
bool computed_as_full(int elform) {
  return elform == -16 || elform == 6 || elform == 7 || elform == 18 || elform == 20 || elform == 21;
}

/// LS-DYNA's other one-point quadrilaterals, in place of which linear analyses use 16 as they do for 2.
bool one_point(int elform) {
  return elform == 1 || elform == 8 || elform == 10 || elform == 11;
}

/// A membrane is strained alike through its thickness: one layer has all that it does.
void make_one_layer(Builder& b, const Part& part, SectionShell& section) {
  if (is<kernel::Laminate>(b.model, part))
    return refuse(b, b.shell_formulations[at(part.section)],
                  fmt::format("membranes (ELFORM {}) with layers of different materials are not built", section.elform),
                  "give the membrane one material, or the layers ELFORM 2 or 16");
  section.layers = 1;
  section.trapezoidal = false;
  section.rule.clear();
}

void check_shell_formulation(Builder& b, const Part& part, std::vector<char>& reported) {
  const auto s = at(part.section);
  SectionShell& section = b.model.shell_sections[s];
  if (section.elform == 0) section.elform = b.model.control.default_shell;
  const bool is_computed = !is<kernel::Rigid>(b.model, part) && !is<kernel::Null>(b.model, part);
  const bool is_built = section.elform == 2 || section.elform == 4 || section.elform == 16 || section.elform == 17;
  if (!is_computed || is_built || std::exchange(reported[s], char{1})) return;
  if (is_membrane(section.elform)) return make_one_layer(b, part, section);
  if (computed_as_full(section.elform)) {
    b.shell_formulations[s].report(
        b.findings, Severity::warning,
        fmt::format("shell formulation {} is computed as 16, fully integrated, with large rotations", section.elform),
        "write 16");
    section.elform = 16;
    return;
  }
  if (b.model.implicit.active && one_point(section.elform)) {
    section.elform = 2;
    return;
  }
  if (one_point(section.elform)) {
    const char* const name = section.elform == 10  ? "Belytschko-Wong-Chiang"
                             : section.elform == 8 ? "Belytschko-Leviathan"
                                                   : "Hughes-Liu";
    b.shell_formulations[s].report(
        b.findings, Severity::warning,
        fmt::format("shell formulation {} ({}) is computed as 2 with its warping coupling, as with BWC = 1; the "
                    "transverse shear stays the one-point form",
                    section.elform, name),
        "write 16 where warped shells matter");
    section.elform = 2;
    section.warping_stiffness = true;
    return;
  }
  if (section.elform >= 12 && section.elform <= 15)
    return refuse(b, b.shell_formulations[s],
                  fmt::format("formulation {} is {}; models in two dimensions are not built", section.elform,
                              section.elform < 14 ? "a plane element" : "an axisymmetric solid"),
                  "model it in three dimensions: a layer of bricks, or a sector of the body");
  refuse(b, b.shell_formulations[s],
         fmt::format("shell formulation {} is not built; built are 2 (Belytschko-Tsay), 4 and 17 (triangles), 5 and 9 "
                     "(membranes), 10 (2 with warping coupling) and 16 (fully integrated)",
                     section.elform),
         "write 16, or 2 with an hourglass control of type 4 for stiffness against hourglassing");
}

/// Adhesive has a law of its own, and the law only such bricks.
void check_bond_formulation(Builder& b, const Part& part, std::vector<char>& reported) {
  const auto s = at(part.section);
  const int elform = b.model.solid_sections[s].elform;
  const deck::RowOf<SolidCard>& row = b.solid_section_rows[s];
  const kernel::CohesiveBond* bond = bond_of(b.model, part);
  const bool is_bond = bond != nullptr;
  if (is<kernel::Rigid>(b.model, part) || (is_bond && is_cohesive(elform) && reported[s])) return;
  if (!is_bond)
    return refuse(b, row[&SolidCard::elform],
                  fmt::format("solid formulation {} is adhesive, but the material of part {} is no law of adhesive",
                              elform, part.id),
                  "give the part *MAT_138, 169, 184, 185, 186 or 240, or the section ELFORM 1");
  if (bond->in_plain_bricks && (elform == 1 || elform == 2))
    return row[&SolidCard::elform].report(
        b.findings, Severity::note,
        fmt::format("the bricks of part {} are computed as cohesive bricks (19): they carry the stresses across the "
                    "layer alone, at four points",
                    part.id));
  if (!is_cohesive(elform))
    return refuse(b, row[&SolidCard::elform],
                  fmt::format("part {} has a law of adhesive, which bricks of ELFORM {} do not", part.id, elform),
                  "write 19, or 20 where its nodes are those of shells");
  reported[s] = 1;
  if (row->cohoff != 0.0)
    refuse(b, row[&SolidCard::cohoff], "adhesive elsewhere than midway between its nodes is not built", "leave it 0");
  if (row->gaskett != 0.0) refuse(b, row[&SolidCard::gaskett], "gaskets are not built", "leave it 0");
  if (elform > 20)
    row[&SolidCard::elform].report(
        b.findings, Severity::warning,
        fmt::format("adhesive wedges are computed as bricks of {} whose nodes 3 and 4, 7 and 8 are one, with "
                    "four points, not three",
                    elform - 2));
}

void check_solid_formulation(Builder& b, const Part& part, std::vector<char>& reported) {
  const auto s = at(part.section);
  if (b.model.solid_sections[s].thickness) return;  // check_thick_shells
  int& elform = b.model.solid_sections[s].elform;
  if (is_cohesive(elform) || bond_of(b.model, part)) return check_bond_formulation(b, part, reported);
  // Linear analyses have a brick for 18 (nvh::linear_model).
  const bool linear = elform == 18 && b.model.implicit.active;
  const bool is_weld = is<kernel::Spotweld>(b.model, part),
             is_corner_shape = elform == 4 || elform == 10 || elform == 13 || elform == 15 || elform == 16;
  const bool is_composite = elform == 17 && !is_weld, is_scaled = elform == -1 || elform == -2,
             has_rotations = elform == 3 || (elform == 4 && !is_weld);
  const bool is_built =
      elform == 1 || elform == 2 || elform == 3 || linear || is_scaled || is_composite || (is_corner_shape && !is_weld);
  const bool is_wedge = elform == 15 && is_built;
  if (elform == 13 && is_built && is<kernel::ComposedLaw>(b.model, part) && !reported[s]) {
    reported[s] = 1;
    return b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        "the nodes' pressure is built for *MAT_001, 003, 012 and 024; with this law the tetrahedra are computed as 10");
  }
  const bool as_asked = is_built && !is_wedge && !is_scaled && !has_rotations && !is_composite;
  if (is<kernel::Rigid>(b.model, part) || as_asked || std::exchange(reported[s], char{1})) return;
  if (elform == 3)
    return b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        "solid formulation 3 is computed as a brick of eight points with assumed strains (as -1), which bends without "
        "locking, and without nodal rotations: LS-DYNA's are not public. Where shells, beams or supports are to turn "
        "its nodes, they turn freely",
        "write -1; tie shells to a face of it rather than to one row of nodes");
  if (has_rotations)
    return b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        "solid formulation 4 is computed as the tetrahedron of ten nodes whose mid-side nodes follow displacements and "
        "rotations of its corners (Allman; Pawlak, Yunus, Cook 1991); LS-DYNA's is not public and may differ. What "
        "turns its nodes, such as a shell on edge, meets next to no resistance",
        "hold the rotations that turn nodes out of planes of symmetry and grips; tie shells to a face");
  if (is_composite)
    return b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        "solid formulation 17, a tetrahedron composed of smaller ones on the same ten nodes, is computed as 16, the "
        "quadratic tetrahedron of four points",
        "write 16");
  if (is_scaled)
    return b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        fmt::format("solid formulation {} is computed as a brick of eight points with assumed strains, which does not "
                    "lock in bending either; LS-DYNA's changed Jacobian is not public in detail, and a patent "
                    "application, US 2011/0191072, covers it",
                    elform));
  if (is_wedge)
    return b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        "wedges have eight points and one pressure here, as bricks of formulation 2; LS-DYNA's have two points");
  if (elform == 0) {
    const bool own_strains =
        part.material != none && b.model.materials[part.material].keyword == "MAT_MODIFIED_HONEYCOMB";
    b.solid_section_rows[s][&SolidCard::elform].report(
        b.findings, Severity::warning,
        fmt::format("solid formulation 0 is the brick of LS-DYNA's honeycombs (*MAT_126); it is computed as 1, as a "
                    "blank field is{}",
                    own_strains ? ", but with the curves over engineering strains" : ""),
        own_strains ? "keep 0: with 1 the curves are over logarithmic strains" : "write 1");
    elform = 1;
    return;
  }
  const bool is_brick_that_bends = elform == 18 || is_weld;
  refuse(b, b.solid_section_rows[s][&SolidCard::elform],
         fmt::format("solid formulation {} is not built{}; built are 1 (constant stress), 2 (fully integrated), -1, -2 "
                     "and 3 (without locking in bending) and, not for welds, 4, 10 and 13 (tetrahedra), 15 (wedge), 16 "
                     "(tetrahedron of ten nodes) and 19 to 22 (adhesive)",
                     elform, is_weld ? " for welds" : ""),
         is_brick_that_bends ? "write -1, a brick of eight points that bends without locking"
                             : "write 1, with an hourglass control of type 2 or 3");
}

/// A spring needs a mass to have a time step.
void check_discrete_beam(Builder& b, const Part& part) {
  const auto s = at(part.section);
  const SectionBeam& section = b.model.beam_sections[s];
  if (!is<kernel::DiscreteBeam>(b.model, part)) return;  // reported by check_law
  const auto& law = std::get<kernel::DiscreteBeam>(b.model.materials[part.material].law);
  const auto works = [&](std::size_t i) {
    const kernel::DiscreteSpring& spring = law.dof[i];
    return spring.greatest_stiffness() > 0.0 || spring.greatest_viscosity(0.0) > 0.0;
  };
  if (law.cable && law.cable->needs_area() && !(section.cable_area > 0.0))
    refuse(b, b.beam_formulations[s], "the stiffness of a cable is that of its area (CA), which is not given",
           "give CA");
  const bool translations = law.cable || works(0) || works(1) || works(2), rotations = works(3) || works(4) || works(5);
  const bool couples = std::abs(section.scoor) >= 2 && (works(1) || works(2));
  if (translations && !(section.volume > 0.0))
    refuse(b, b.beam_formulations[s], "a discrete beam of no volume (VOL) has no mass, so no time step",
           "give VOL; mass = density times VOL");
  if ((rotations || couples) && !(section.inertia > 0.0))
    refuse(b, b.beam_formulations[s], "a discrete beam whose moments turn its nodes needs a rotary inertia (INER)",
           "give INER");
}

void check_beam_formulation(Builder& b, const Part& part, std::vector<char>& reported) {
  const auto s = at(part.section);
  const int elform = b.model.beam_sections[s].elform;
  if (elform == 6) return check_discrete_beam(b, part);
  const bool is_built = elform == 9 || (elform >= 1 && elform <= 3);
  if (is_built || std::exchange(reported[s], char{1})) return;
  refuse(b, b.beam_formulations[s],
         fmt::format("beam formulation {} is not built; built are 1 (Hughes-Liu), 2 (Belytschko-Schwer), 3 (truss), 6 "
                     "(discrete) and 9 (spot weld)",
                     elform),
         "write 1 with the dimensions of the section, or 2 with its moments");
}

/// Whether the law has a kernel for the fibres of beams.
bool has_fibres(const Law& law) {
  if (const auto* compound = std::get_if<kernel::ComposedLaw>(&law)) return for_beams(*compound->components);
  return std::visit([]<class Own>(const Own&) { return kernel::LawOfFibres<Own>; }, law);
}

/// Spot-weld beams have the weld's law, discrete beams one of springs, others that of a bar.
void check_beam_law(Builder& b, const Part& part, const deck::RowOf<PartCard>& row) {
  const Model& m = b.model;
  const Material& material = m.materials[part.material];
  const int elform = m.beam_sections[part.section].elform;
  if (elform == 6) {
    if (!is<kernel::DiscreteBeam>(m, part))
      refuse(b, row[&PartCard::mid], fmt::format("*{} is not a law of discrete beams (ELFORM 6)", material.keyword),
             "built are *MAT_066, 067, 068, 071, 074, 119, 121 and 196");
  } else if (elform == 9) {
    if (!is<kernel::Spotweld>(m, part))
      refuse(b, row[&PartCard::mid],
             fmt::format("spot-weld beams (ELFORM 9) need *MAT_SPOTWELD, not *{}", material.keyword),
             "give the part *MAT_SPOTWELD, or its section ELFORM 1");
  } else if (is<kernel::Spotweld>(m, part)) {
    refuse(b, row[&PartCard::mid],
           fmt::format("*MAT_SPOTWELD needs spot-weld beams, but the section has ELFORM {}", elform), "write ELFORM 9");
  } else if (elform <= 3) {
    const bool is_moved = is<kernel::Rigid>(m, part) || is<kernel::Null>(m, part),
               is_elastic = is<kernel::Elastic>(m, part);
    if (elform == 2 && !is_moved && !is_elastic)
      refuse(b, row[&PartCard::mid],
             fmt::format("resultant beams (ELFORM 2) are elastic here, but the part has *{}", material.keyword),
             "write ELFORM 1 with the dimensions of the section");
    else if (const auto* compound = std::get_if<kernel::ComposedLaw>(&material.law);
             compound && compound->components->gissmo &&
             !std::holds_alternative<kernel::TabulatedJohnsonCook>(compound->components->flow))
      refuse(b, row[&PartCard::mid], "*MAT_ADD_DAMAGE_GISSMO is not built for beams",
             "take it away, or write *MAT_ADD_EROSION, or the failure strain of *MAT_003 or 024");
    else if (compound && compound->components->erosion && compound->components->erosion->thinning)
      refuse(b, row[&PartCard::mid], "EPSTHIN of *MAT_ADD_EROSION is a limit of layers: a beam has none",
             "limit the plastic or the principal strain");
    else if (compound && compound->components->erosion && compound->components->points_to_delete < 0.0)
      refuse(b, row[&PartCard::mid],
             "NUMFIP of *MAT_ADD_EROSION as a percentage of layers is not built for beams, which have none",
             "give the number of points of the cross-section");
    else if (!is_moved && !has_fibres(material.law))
      refuse(b, row[&PartCard::mid], fmt::format("*{} is not built for beams", material.keyword),
             "built are *MAT_001, 003, 009, 020 and 024");
  }
}

/// Whether some block of the deck has a keyword that begins so, with this option.
bool has_option(const Builder& b, std::string_view keyword, std::string_view option) {
  return std::any_of(b.deck.blocks.begin(), b.deck.blocks.end(), [&](const deck::Block& block) {
    return block.keyword.starts_with(keyword) && block.keyword.find(option) != std::string::npos;
  });
}

/// AOPT 3 in solids: hexahedra whose midway surface is not normal to v.
void check_cross_axes(Builder& b, const Part& part, const deck::Entry& field, const kernel::MaterialAxes& axes) {
  const Model& m = b.model;
  const auto index = static_cast<Index>(&part - m.parts.data());
  for (std::size_t e = 0; e < m.solids.size(); ++e) {
    if (m.solids.part[e] != index) continue;
    const auto& corner = m.solids.node[e];
    if (std::set<Index>(corner.begin(), corner.begin() + 8).size() < 8)
      return refuse(b, field, fmt::format("AOPT 3 is for hexahedra, but solid {} is none", m.solids.id[e]),
                    "use AOPT 2 with vectors a and d");
    std::array<Vec3d, 8> x;
    for (std::size_t i = 0; i < 8; ++i) x[i] = m.nodes.x[corner[i]];
    const Vec3d normal = kernel::MaterialAxes::midway_normal(x);
    if (norm(cross(axes.a, normal)) > 1e-6 * norm(axes.a) * norm(normal)) continue;
    return refuse(b, field,
                  fmt::format("solid {}: the vector v of AOPT 3 stands normal to its midway surface", m.solids.id[e]),
                  "give another vector, or AOPT 2");
  }
}

bool is_mirrored_material(const Builder& b, Index material) {
  return material != none && at(material) < b.mirrored_materials.size() && b.mirrored_materials[at(material)] != 0;
}

/// True where the elements of a part stand in mirrored files and its axes or angles do not, or the other way round.
bool has_other_hand(const Builder& b, const Part& part, bool mirrored) {
  const Model& m = b.model;
  const auto index = static_cast<Index>(&part - m.parts.data());
  const auto differs = [&](const auto& elements, const std::vector<char>& hands) {
    if (hands.empty() && !mirrored) return false;
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (elements.part[e] == index && (!hands.empty() && hands[e] != 0) != mirrored) return true;
    return false;
  };
  return part.kind == ElementKind::solid ? differs(m.solids, b.mirrored_solids) : differs(m.shells, b.mirrored_shells);
}

/// A mirrored brick has nodes 1 and 2, 3 and 4 exchanged: the plane through its nodes 1, 2 and 4 is the image of that
/// before only where these four lie in a plane.
void check_mirrored_bricks(Builder& b, const Part& part, const deck::Entry& field) {
  const Model& m = b.model;
  const auto index = static_cast<Index>(&part - m.parts.data());
  for (std::size_t e = 0; e < b.mirrored_solids.size(); ++e) {
    if (b.mirrored_solids[e] == 0 || m.solids.part[e] != index || m.solids.node[e][4] == m.solids.node[e][3]) continue;
    const auto x = [&](std::size_t i) { return m.nodes.x[m.solids.node[e][i]]; };
    const Vec3d now = cross(x(1) - x(0), x(3) - x(0)), image = cross(x(0) - x(1), x(2) - x(1));
    if (norm(cross(now, image)) <= 1e-6 * norm(now) * norm(image)) continue;
    return refuse(b, field,
                  fmt::format("solid {}: axes by its nodes (AOPT 0) in a file that *INCLUDE_TRANSFORM mirrors need "
                              "its nodes 1 to 4 in a plane",
                              m.solids.id[e]),
                  "give vectors (AOPT 2)");
  }
}

void check_hand_of_axes(Builder& b, const Part& part, const deck::Entry& field, const kernel::MaterialAxes& axes,
                        bool mirrored) {
  using By = kernel::MaterialAxes::By;
  const bool solid = part.kind == ElementKind::solid;
  if (axes.by == By::nodes && solid) check_mirrored_bricks(b, part, field);
  if ((axes.by == By::nodes && (solid || axes.angle == 0.0)) || !has_other_hand(b, part, mirrored)) return;
  refuse(b, field,
         fmt::format("*INCLUDE_TRANSFORM mirrors {} of part {} and not {}", mirrored ? "the material axes" : "elements",
                     part.id, mirrored ? "all of its elements" : "its material axes"),
         "write elements and material in one file, or give the mirrored ones a material of their own");
}

/// Material axes that the elements of a part cannot have.
void check_material_axes(Builder& b, const Part& part, const deck::Entry& field, const kernel::MaterialAxes& axes) {
  using By = kernel::MaterialAxes::By;
  const Model& m = b.model;
  if (part.kind == ElementKind::solid) {
    if (axes.by == By::cross) check_cross_axes(b, part, field, axes);
    if (axes.by == By::vectors && norm(cross(axes.a, axes.d)) == 0.0)
      refuse(b, field, "AOPT 2 needs a vector d that is not along a", "give D1 to D3 of the material");
    if (has_option(b, "ELEMENT_SOLID", "_ORTHO"))
      refuse(b, field, "axes of single solids (*ELEMENT_SOLID_ORTHO) are not built", "use AOPT 2 of the material");
    return;
  }
  if (has_option(b, "ELEMENT_SHELL", "_MCID"))
    refuse(b, field, "axes of single shells by coordinate system (_MCID) are not built",
           "use BETA of *ELEMENT_SHELL_BETA, or AOPT 2 of the material");
  const auto index = static_cast<Index>(&part - m.parts.data());
  for (std::size_t e = 0; e < m.shells.size(); ++e) {
    if (m.shells.part[e] != index) continue;
    std::array<Vec3d, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = m.nodes.x[m.shells.node[e][i]];
    const Vec3d normal = cross(x[2] - x[0], x[3] - x[1]);
    if (!(norm(normal) > 0.0)) continue;  // reported elsewhere
    const Vec3d seen = axes.in_shell(x[1] - x[0], unit(normal), {});
    if (norm(seen) > 1e-6 * (axes.by == By::nodes ? norm(x[1] - x[0]) : norm(axes.a))) continue;
    return refuse(
        b, field,
        fmt::format("shell {}: the vector of AOPT stands so that it gives no direction in its plane", m.shells.id[e]),
        "give another vector, or AOPT 0");
  }
}

/// The material that *PART names: the one of the part may be made of its layers.
Index own_material(const Builder& b, const Part& part) {
  const auto index = static_cast<Index>(&part - b.model.parts.data());
  for (const auto& [of, row] : b.part_rows)
    if (of == index) return b.materials.find(row->mid);
  return none;
}

/// Axes of the materials of a part's layers.
void check_layers(Builder& b, const Part& part) {
  if (part.kind != ElementKind::shell || part.material == none || !is<kernel::Laminate>(b.model, part)) return;
  const auto& law = std::get<kernel::Laminate>(b.model.materials[part.material].law);
  const auto stack = b.layer_stacks.find(part.section);
  if (stack == b.layer_stacks.end()) return;  // laminated glass without a rule, which is refused
  const auto& cards = stack->second.layers;
  for (std::size_t k = 0; k < cards.size(); ++k)
    if (const auto* axes = axes_of((*law.layers)[k].law.components->flow)) {
      check_material_axes(b, part, cards[k].id, *axes);
      const Index material = cards[k].names == LayerCard::Names::material ? b.materials.find(cards[k].id.integer())
                                                                          : own_material(b, part);
      check_hand_of_axes(b, part, cards[k].id, *axes, is_mirrored_material(b, material));
      if (cards[k].angle != 0.0 && has_other_hand(b, part, cards[k].mirrored))
        refuse(b, cards[k].id,
               fmt::format("*INCLUDE_TRANSFORM mirrors {} of part {} and not {}",
                           cards[k].mirrored ? "the layers" : "elements", part.id,
                           cards[k].mirrored ? "all of its elements" : "its layers"),
               "write elements and part in one file");
    }
}

/// Some laws are made for shells or bricks only.
void check_compound(Builder& b, const Part& part, const deck::RowOf<PartCard>& row) {
  const Material& material = b.model.materials[part.material];
  const auto* law = std::get_if<kernel::ComposedLaw>(&material.law);
  if (law == nullptr) return;
  if (part.kind == ElementKind::solid && law->components->directional_damage)
    refuse(b, row[&PartCard::mid],
           fmt::format("*{} damages the layers of shells, but the part has solids", material.keyword),
           "use *MAT_PLASTICITY_WITH_DAMAGE, or *MAT_SIMPLIFIED_JOHNSON_COOK with PSFAIL");
  else if (part.kind == ElementKind::solid && !for_bricks(*law->components) &&
           !b.model.has_thick_shells(static_cast<Index>(&part - b.model.parts.data())))  // they say what they take
    refuse(b, row[&PartCard::mid], fmt::format("*{} is a law of shells, but the part has solids", material.keyword),
           "use a law of solids");
  const kernel::LawComponents& components = *law->components;
  const bool in_layers = part.section != none && part.kind == ElementKind::solid &&
                         b.model.solid_sections[part.section].has_laws_of_shells();
  if (part.kind == ElementKind::solid && !in_layers &&
      (components.limits.plastic_thinning > 0.0 || (components.erosion && components.erosion->thinning)))
    row[&PartCard::mid].report(
        b.findings, Severity::warning,
        fmt::format("EPSTHIN of material {} is a limit of layers and has no effect in this part's solids", material.id),
        "limit the plastic strain or the major strain");
  const bool is_of_shells = for_shells(components);
  if (const auto* axes = axes_of(components.flow); axes && (is_of_shells || part.kind == ElementKind::solid)) {
    check_material_axes(b, part, row[&PartCard::mid], *axes);
    check_hand_of_axes(b, part, row[&PartCard::mid], *axes, is_mirrored_material(b, part.material));
  }
  if (part.kind == ElementKind::shell && !is_of_shells)
    refuse(b, row[&PartCard::mid], fmt::format("*{} is a law of solids, but the part has shells", material.keyword),
           "give it the law of a sheet");
  const kernel::LawKernel<kernel::ComposedLaw> made(*law);
  const bool gets_thinner = made.layers_stiffen() && !is_fabric(law->components->flow);
  if (part.kind == ElementKind::shell && gets_thinner && b.model.control.thickness_update == 0)
    row[&PartCard::mid].report(
        b.findings, Severity::warning,
        fmt::format("the shells keep their thickness while *{} stretches: their forces are those "
                    "of a sheet that does not get thinner",
                    material.keyword),
        "write ISTUPD 1 in *CONTROL_SHELL");
  // The check may give the material another law.
  if (const auto own = b.part_checks.find(part.material); own != b.part_checks.end()) own->second(b, part, row);
}

/// Which law may be used by which elements.
void check_law(Builder& b, const Part& part, const deck::RowOf<PartCard>& row) {
  if (part.material == none) return;
  const Model& m = b.model;
  const Material& material = m.materials[part.material];
  const bool is_weld = is<kernel::Spotweld>(m, part);
  check_compound(b, part, row);
  if (part.kind == ElementKind::solid && is<kernel::Laminate>(m, part) &&
      !(part.section != none && m.solid_sections[part.section].thickness))  // thick shells say what they take
    refuse(b, row[&PartCard::mid], fmt::format("*{} is a law of shells, but the part has solids", material.keyword),
           "use a law of solids");
  const bool is_fluid = part.kind == ElementKind::solid && is<kernel::Null>(m, part);
  if (row->eosid != 0 && !is_fluid && !(takes_equation_of_state(material) && part.kind == ElementKind::solid))
    row[&PartCard::eosid].report(
        b.findings, Severity::warning,
        fmt::format("ignored: *{} in these elements has no equation of state", material.keyword));
  if (is_weld && part.kind == ElementKind::shell)
    refuse(b, row[&PartCard::mid], "*MAT_SPOTWELD is a law of weld beams, but the part has shells",
           "give it a sheet's law");
  else if (is_weld && part.kind == ElementKind::beam && material.weld != none && m.weld_laws[material.weld].connection)
    refuse(b, row[&PartCard::mid], "*MAT_SPOTWELD_DAIMLERCHRYSLER is a law of welds of bricks, but the part has beams",
           "model the welds by bricks, or use *MAT_SPOTWELD_DAMAGE-FAILURE");
  else if (part.kind == ElementKind::discrete && b.belt_materials.contains(part.material))
    refuse(b, row[&PartCard::mid], "*MAT_SEATBELT is the law of belts (*ELEMENT_SEATBELT), but the part has springs",
           "give one of *MAT_S01 to *MAT_S08");
  else if (part.kind == ElementKind::discrete && !is<kernel::Spring>(m, part))
    refuse(b, row[&PartCard::mid], fmt::format("*{} is not a law of springs and dampers", material.keyword),
           "give one of *MAT_S01 to *MAT_S08");
  else if (is<kernel::Spring>(m, part) && part.kind != ElementKind::discrete && part.kind != ElementKind::nothing)
    refuse(
        b, row[&PartCard::mid],
        fmt::format("*{} is a law of springs (*ELEMENT_DISCRETE), but the part has other elements", material.keyword),
        "give it the law of its elements");
  else if (part.kind == ElementKind::beam && part.section != none)
    check_beam_law(b, part, row);
  else if (is<kernel::DiscreteBeam>(m, part) && (part.kind == ElementKind::shell || part.kind == ElementKind::solid))
    refuse(b, row[&PartCard::mid],
           fmt::format("*{} is a law of discrete beams, but the part has other elements", material.keyword),
           "give it the law of a sheet");
  else if (is_fluid && row->eosid != 0)
    refuse_unknown_state(b, row);
  else if (is_fluid)
    refuse(b, row[&PartCard::eosid], "*MAT_NULL in solids is a fluid, whose pressure is that of an equation of state",
           "name an *EOS_... in EOSID of the part");
  else if (part.kind == ElementKind::solid && material.poisson() >= 0.5 && !is<kernel::Rigid>(m, part))
    refuse(b, row[&PartCard::mid], "a Poisson's ratio of 0.5 makes solids incompressible",
           "give a ratio below 0.5, e.g. 0.495");
}

/// Hourglass types that the elements of parts do not have: one finding for all parts that share the card. The control
/// card's type is for all elements of a deck, of which some may not have it (6 is for solids, 8 for shells of ELFORM
/// 16): they get the type that stands for none.
void check_hourglass(Builder& b) {
  Model& m = b.model;
  std::map<std::pair<Index, ElementKind>, std::vector<int>> parts;
  for (const Part& part : m.parts) {
    if (part.section == none || is<kernel::Rigid>(m, part) || is<kernel::Null>(m, part)) continue;
    // Shells 16 and 9 have no hourglass modes: type 8 gives 16 warping stiffness, the others mean nothing to them. Of
    // solids the one-point brick has some, the others have none.
    const auto section = at(part.section);
    const int shell_form = part.kind == ElementKind::shell ? m.shell_sections[section].elform : 0;
    const bool has_modes = part.kind == ElementKind::shell ? shell_form != 16 && shell_form != 9
                           : part.kind == ElementKind::solid
                               ? m.solid_sections[section].elform == 1 && !m.solid_sections[section].thickness
                               : true;
    if (has_modes) parts[{part.hourglass, part.kind}].push_back(part.id);
  }
  for (const auto& [user, ids] : parts) {
    const auto [card, kind] = user;
    Hourglass h = card == none ? m.control.hourglass : m.hourglass[card];
    const int highest = kind == ElementKind::shell ? 5 : kind == ElementKind::solid ? 6 : 10;
    if (h.type <= highest) continue;
    const bool is_shell = kind == ElementKind::shell, viscous = card == none && (is_shell || h.type == 8);
    // Total strains, enhanced assumed strains: as 6 meant to be exact in elastic bending with QM = 1.
    const bool as_six = !is_shell && (h.type == 7 || h.type == 9), stands_in = viscous || as_six;
    b.findings.add(
        {stands_in ? Severity::warning : Severity::error, h.place, card == none ? "*CONTROL_HOURGLASS" : "*HOURGLASS",
         "ihq", std::to_string(h.type),
         fmt::format("part{} {} {} {}, for which types 1 to {} are built{}", ids.size() == 1 ? "" : "s",
                     fmt::join(ids, " "), ids.size() == 1 ? "has" : "have", is_shell ? "shells" : "solids", highest,
                     as_six    ? ": they get type 6, of the same stiffness, which adds up its strains"
                     : viscous ? ": they get type 1, viscosity, as with IHQ 0"
                               : ""),
         is_shell ? "write 4, or give the shells ELFORM 16"
                  : "write 2, 5 or 6, or give the solids an *HOURGLASS of their own"});
    if (!stands_in) continue;
    h.type = as_six ? 6 : 1;
    const auto index = static_cast<Index>(m.hourglass.size());
    m.hourglass.push_back(h);
    for (const int id : ids) m.parts[m.part_index(id)].hourglass = index;
  }
}

/// Bending and torsion of a one-point brick are carried by its hourglass forces alone.
void check_weld_hourglass(Builder& b) {
  const Model& m = b.model;
  for (const Part& part : m.parts) {
    if (part.kind != ElementKind::solid || part.section == none || !is<kernel::Spotweld>(m, part)) continue;
    const Hourglass& h = part.hourglass == none ? m.control.hourglass : m.hourglass[part.hourglass];
    const bool one_point = m.solid_sections[part.section].elform == 1;
    if (!one_point || (h.type == 6 && h.membrane == 1.0)) continue;
    b.findings.warning(
        part.place, "*PART",
        fmt::format("the brick welds of part {} have hourglass control type {} with QM = {:g}; their moments are "
                    "hourglass forces, and right (elastic) with type 6 and QM = 1 only",
                    part.id, h.type, h.membrane),
        "give the part an *HOURGLASS with IHQ = 6, QM = 1");
  }
}

/// OPT 7 is documented for bricks, 11 for beams; the formulas ask for resultants only, which both have.
void check_weld_options(Builder& b) {
  const Model& m = b.model;
  for (const Part& part : m.parts) {
    const Index law = part.material == none ? none : m.materials[part.material].weld;
    if (law == none) continue;
    const int option = m.weld_laws[law].option;
    const bool of_bricks = part.kind == ElementKind::solid, of_beams = part.kind == ElementKind::beam;
    if ((option == 11 && of_bricks) || (option == 7 && of_beams))
      b.findings.warning(part.place, "*PART",
                         fmt::format("OPT {} is documented for {} only, but part {} has {}; it acts on their "
                                     "resultants in the same way",
                                     option, of_bricks ? "beams" : "bricks", part.id, of_bricks ? "bricks" : "beams"),
                         of_bricks ? "OPT 0, 1 or 7 are defined for bricks" : "OPT 1 has the same formula");
    const WeldDamage& damage = m.weld_laws[law].damage;
    if (!of_beams || m.control.weld_beams.bricks > 0) continue;
    if (damage.true_thickness > 0.0)
      b.findings.warning(part.place, "*PART",
                         fmt::format("TRUE_T = {:g} of its material corrects single bricks, but part {} has beams: "
                                     "nothing is corrected",
                                     damage.true_thickness, part.id),
                         "let the beams end on the mid-surfaces of their sheets, and leave TRUE_T blank");
    if (damage.whole)
      b.findings.note(part.place, "*PART",
                      fmt::format("ASFF = 1 of its material is about assemblies of bricks, but part {} has beams, each "
                                  "of which fails as a whole",
                                  part.id));
  }
}

/// ELFORM 4 and 17 are triangles only.
void check_triangles(Builder& b) {
  const Model& m = b.model;
  Tally quads(b.findings, Severity::error, "*ELEMENT_SHELL");
  for (std::size_t e = 0; e < m.shells.size(); ++e) {
    const Part& part = m.parts[m.shells.part[e]];
    if (part.section == none || is<kernel::Rigid>(m, part) || is<kernel::Null>(m, part)) continue;
    const int elform = m.shell_sections[part.section].elform;
    if ((elform != 4 && elform != 17) || m.shells.triangle(e)) continue;
    quads.add(
        m.shells.place[e],
        [&] {
          return fmt::format("shell {} has four corners, but its formulation {} is a triangle", m.shells.id[e], elform);
        },
        "give quads a section with ELFORM 2; with ESORT 1 (2) of *CONTROL_SHELL their triangles become ELFORM 4 (17)");
  }
}

/// Triangles of discrete Kirchhoff theory have no transverse shear, on which a soft core under LAMSHT depends.
void check_laminated_triangles(Builder& b) {
  const Model& m = b.model;
  if (!m.control.laminated_shear) return;
  std::vector<int> triangles(m.parts.size(), 0);
  for (std::size_t e = 0; e < m.shells.size(); ++e)
    if (m.shells.triangle(e)) ++triangles[m.shells.part[e]];
  for (std::size_t p = 0; p < m.parts.size(); ++p) {
    const Part& part = m.parts[p];
    if (triangles[p] == 0 || part.section == none || part.material == none) continue;
    const auto* made = std::get_if<kernel::Laminate>(&m.materials[part.material].law);
    const int elform = m.shell_sections[part.section].elform;
    const bool kirchhoff = elform == 17 || (elform != 4 && m.control.sort_triangles == SortTriangles::kirchhoff);
    if (made == nullptr || !kirchhoff || made->shear_factor > 0.8) continue;  // of one material 5/6
    b.findings.warning(part.place, "*PART",
                       fmt::format("part {}: LAMSHT of *CONTROL_SHELL has no effect in its {} triangles of formulation "
                                   "17, which have no transverse shear: with a soft core they are far too stiff",
                                   part.id, triangles[p]),
                       "write ELFORM 4, or ESORT 1 of *CONTROL_SHELL");
  }
}

}  // namespace

void check_parts(Builder& b) {
  std::set<int> of_layers;  // parts that only give layers their materials have no elements
  for (const auto& [section, stack] : b.layer_stacks)
    for (const LayerCard& layer : stack.layers)
      if (layer.names == LayerCard::Names::part) of_layers.insert(layer.id.integer());
  std::vector<char> reported_shell(b.model.shell_sections.size(), 0), reported_solid(b.model.solid_sections.size(), 0),
      reported_beam(b.model.beam_sections.size(), 0);
  std::set<Index> of_belts;
  for (const Belt& belt : b.model.belts.elements) of_belts.insert(belt.part);
  const auto warn_of_none = [&](const Part& part, Index index, const std::string& keyword) {
    const bool is_twin = b.parts.find(part.id) != index;  // its id is another part's already; reported
    if (part.kind == ElementKind::nothing && part.rigid_body == none && !is_twin && !of_layers.contains(part.id) &&
        !of_belts.contains(index))
      b.findings.warning(part.place, keyword, fmt::format("part {} has no elements", part.id));
  };
  for (const auto& [index, section, id, hourglass] : b.composite_parts) {
    const Part& part = b.model.parts[index];
    warn_of_none(part, index, id.keyword);
    if (part.section != none) check_shell_formulation(b, part, reported_shell);
  }
  for (const Part& part : b.model.parts) check_layers(b, part);
  for (const auto& [index, row] : b.part_rows) {
    const Part& part = b.model.parts[index];
    warn_of_none(part, index, row.keyword());
    check_law(b, part, row);
    if (part.section == none) continue;
    if (part.kind == ElementKind::shell) check_shell_formulation(b, part, reported_shell);
    if (part.kind == ElementKind::solid) check_solid_formulation(b, part, reported_solid);
    if (part.kind == ElementKind::beam) check_beam_formulation(b, part, reported_beam);
  }
  check_hourglass(b);
  check_weld_hourglass(b);
  check_weld_options(b);
  check_triangles(b);
  check_laminated_triangles(b);
}

}  // namespace nugget::reading
