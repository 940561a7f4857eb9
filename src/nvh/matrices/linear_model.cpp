// SPDX-License-Identifier: Apache-2.0
#include "nvh/matrices/linear_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "kernel/law/cohesive_bond.hpp"
#include "kernel/law/law_components.hpp"

namespace nugget::nvh {
namespace {

/// Formulations of bricks; tetrahedra and wedges have others.
bool of_bricks(int elform) {
  return elform == 0 || elform == 1 || elform == 2 || elform == 3 || elform == 18 || elform == -1 || elform == -2;
}

/// ISOLID of *CONTROL_IMPLICIT_EIGENVALUE.
void change_bricks(model::Model& m, Findings& findings) {
  if (m.implicit.solid_form == 0) return;
  std::vector<int> changed;
  for (model::Part& part : m.parts) {
    if (part.kind != model::ElementKind::solid || part.section == model::none || part.material == model::none) continue;
    model::SectionSolid section = m.solid_sections[part.section];
    if (std::holds_alternative<kernel::Spotweld>(m.materials[part.material].law) || section.thickness ||
        !of_bricks(section.elform) || section.elform == m.implicit.solid_form)
      continue;
    changed.push_back(part.id);
    section.elform = m.implicit.solid_form;
    part.section = static_cast<model::Index>(m.solid_sections.size());
    m.solid_sections.push_back(section);
  }
  if (!changed.empty())
    findings.note({m.deck, 0, 0}, "*CONTROL_IMPLICIT_EIGENVALUE",
                  fmt::format("bricks of part{} {}: formulation {} (ISOLID)", changed.size() == 1 ? "" : "s",
                              fmt::join(changed, " "), m.implicit.solid_form));
}

/// Tetrahedra whose nodes share a pressure (13) have no stiffness element by element; those of formulation 10 do.
void separate_pressures(model::Model& m, Findings& findings) {
  for (const model::Part& part : m.parts)
    if (part.kind == model::ElementKind::solid && part.section != model::none &&
        m.solid_sections[part.section].elform == 13)
      findings.warning(
          part.place, "*PART",
          fmt::format("part {}: tetrahedra of ELFORM 13 are computed as 10 in linear analyses: each has its "
                      "own pressure, the nodes do not share one",
                      part.id),
          "use ELFORM 16 where Poisson's ratio is near 0.5");
  for (model::SectionSolid& section : m.solid_sections)
    if (section.elform == 13) section.elform = 10;
}

/// The brick of enhanced strains (18) is not built for the law of welds.
void assume_strains_of_welds(model::Model& m, Findings& findings) {
  for (const model::Part& part : m.parts)
    if (part.kind == model::ElementKind::solid && part.section != model::none && part.material != model::none &&
        m.solid_sections[part.section].elform == 18 &&
        std::holds_alternative<kernel::Spotweld>(m.materials[part.material].law))
      findings.note(part.place, "*PART",
                    fmt::format("welds of part {}: bricks of ELFORM 18 (enhanced strains) are computed as -1, eight "
                                "points with assumed strains: both are exact in bending of rectangular bricks",
                                part.id));
}

void stabilize_bricks(model::Model& m, Findings& findings) {
  std::vector<int> changed;
  for (model::Part& part : m.parts) {
    if (part.kind != model::ElementKind::solid || part.section == model::none) continue;
    const int form = m.solid_sections[part.section].elform;
    const bool rigid = part.material != model::none &&
                       std::holds_alternative<kernel::Rigid>(m.materials[part.material].law),
               one_point = !rigid && (form == 0 || form == 1) && !m.solid_sections[part.section].thickness;
    const model::Hourglass& now = part.hourglass == model::none ? m.control.hourglass : m.hourglass[part.hourglass];
    model::Hourglass bindeman = now;
    const int elform = m.solid_sections[part.section].elform;
    const bool ten_nodes = elform == 16 || elform == 17;  // they have no hourglass modes
    if (now.type != 6 && !ten_nodes) {
      bindeman.type = 6;
      bindeman.membrane = 1.0;
      if (one_point) changed.push_back(part.id);
    }
    bindeman.bulk_linear = bindeman.bulk_quadratic = 0.0;
    part.hourglass = static_cast<model::Index>(m.hourglass.size());
    m.hourglass.push_back(bindeman);
  }
  if (!changed.empty())
    findings.note(
        {m.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
        fmt::format("bricks of part{} {}: linear analyses use hourglass type 6 with QM = 1, which is exact in "
                    "bending of rectangular bricks",
                    changed.size() == 1 ? "" : "s", fmt::join(changed, " ")));
}

/// Thick shells of one point have motions without stiffness, those of four have none.
void integrate_thick_shells_fully(model::Model& m, Findings& findings) {
  bool any = false;
  for (model::SectionSolid& section : m.solid_sections) {
    if (!section.has_laws_of_shells() || section.elform != 1) continue;
    section.elform = 2;
    any = true;
  }
  if (any)
    findings.note({m.deck, 0, 0}, "*SECTION_TSHELL",
                  "linear analyses use thick shells of ELFORM 2, four points in the plane, instead of 1, which has "
                  "motions without stiffness");
}

/// Shells run fully integrated, with stiffness against drilling and against the spins of warped corners.
void integrate_shells_fully(model::Model& m, Findings& findings) {
  std::vector<int> changed;
  for (model::Part& part : m.parts) {
    if (part.kind != model::ElementKind::shell || part.section == model::none) continue;
    part.drilling = std::max(part.drilling, 1.0);
    model::Hourglass warping = part.hourglass == model::none ? m.control.hourglass : m.hourglass[part.hourglass];
    model::SectionShell section = m.shell_sections[part.section];
    if (section.elform == 4 || section.elform == 17) continue;
    if (section.elform != 16) changed.push_back(part.id);
    section.elform = 16;
    warping.type = 8;
    part.section = static_cast<model::Index>(m.shell_sections.size());
    m.shell_sections.push_back(section);
    part.hourglass = static_cast<model::Index>(m.hourglass.size());
    m.hourglass.push_back(warping);
  }
  if (m.control.sort_triangles == model::SortTriangles::no) m.control.sort_triangles = model::SortTriangles::c0;
  if (!changed.empty())
    findings.note({m.deck, 0, 0}, "*CONTROL_IMPLICIT_GENERAL",
                  fmt::format("shells of part{} {}: linear analyses use formulation 16 instead of a one-point shell, "
                              "which has motions without stiffness",
                              changed.size() == 1 ? "" : "s", fmt::join(changed, " ")));
}

/// Rubber by a test has at small strains the slope of tension; small motions go to both sides (docs/decisions/0145).
void take_both_sides(kernel::Flow& flow) {
  auto* rubber = std::get_if<kernel::TabulatedRubber>(&flow);
  if (rubber == nullptr) return;
  const Curve& test = rubber->tests.front();
  const double pulled = test.slope(0.0), mean = 0.5 * (pulled + test.slope(std::nextafter(0.0, -1.0)));
  if (mean == pulled || !(pulled > 0.0)) return;
  if (rubber->is_foam()) {
    rubber->E *= mean / pulled;
    return;
  }
  const double shear = mean / 3.0;
  rubber->nu = std::max(0.0, (3.0 * rubber->bulk - 2.0 * shear) / (2.0 * (3.0 * rubber->bulk + shear)));
  rubber->E = 2.0 * shear * (1.0 + rubber->nu);
}

/// A viscous stress that goes by the step, of foams and honeycomb, would count as stiffness.
void take_viscosity_out(model::Model& m) {
  const auto take_out = [](kernel::ComposedLaw& law) {
    kernel::LawComponents made = *law.components;
    std::visit(
        [](auto& flow) {
          if constexpr (requires { flow.damping; }) flow.damping = 0.0;
          if constexpr (requires { flow.viscosity; }) flow.viscosity = 0.0;
        },
        made.flow);
    take_both_sides(made.flow);
    law = kernel::composed_law(std::move(made));
  };
  for (model::Material& material : m.materials) {
    if (auto* law = std::get_if<kernel::ComposedLaw>(&material.law)) take_out(*law);
    if (auto* laminate = std::get_if<kernel::Laminate>(&material.law)) {
      std::vector<kernel::Laminate::Layer> layers = *laminate->layers;
      for (kernel::Laminate::Layer& layer : layers) take_out(layer.law);
      laminate->layers = std::make_shared<const std::vector<kernel::Laminate::Layer>>(std::move(layers));
    }
  }
}

/// Adhesive whose stiffness depends on the mode, or is another one under pressure, has its first one in linear
/// analyses.
void take_bonds_unbroken(model::Model& m) {
  for (model::Material& material : m.materials) {
    auto* law = std::get_if<kernel::ComposedLaw>(&material.law);
    if (law == nullptr || !law->components->bond) continue;
    kernel::LawComponents made = *law->components;
    made.bond = std::make_shared<const kernel::CohesiveBond>(kernel::unbroken(*made.bond));
    *law = kernel::composed_law(std::move(made));
  }
}

/// Glue, and ties that fail or begin later, are springs of a contact, which linear analyses do not have.
void warn_of_glue(const model::Model& m, Findings& findings) {
  for (const model::Contact& contact : m.contacts)
    if (contact.glue)
      findings.warning(contact.place, '*' + contact.keyword,
                       "glue takes no part in linear analyses: what it holds together moves apart there",
                       "tie it for these (*CONTACT_TIED_..., without _FAILURE and BT)");
}

/// Nothing resists their change of shape, so they would have motions without stiffness.
void refuse_fluids(const model::Model& m, Findings& findings) {
  for (const model::Part& part : m.parts)
    if (part.kind == model::ElementKind::solid && part.material != model::none &&
        m.materials[part.material].keyword == "MAT_NULL")
      findings.error(part.place, "*PART", fmt::format("part {} is a fluid, which linear analyses do not have", part.id),
                     "take it out, or put its mass on the structure (*ELEMENT_MASS)");
}

/// Nothing resists their motion across the plane unless they are under tension.
void refuse_membranes(const model::Model& m, Findings& findings) {
  for (std::size_t p = 0; p < m.parts.size(); ++p)
    if (m.has_membranes(static_cast<model::Index>(p)))
      findings.error(m.parts[p].place, "*PART",
                     fmt::format("part {} is of membranes (ELFORM {}), which linear analyses do not have",
                                 m.parts[p].id, m.shell_sections[m.parts[p].section].elform),
                     "give its section ELFORM 16, which bends, or take the part out");
}

/// Nodes that a response over frequency drives are held in its modes, like those of prescribed motions.
void constrain_driven_nodes(model::Model& m) {
  const auto hold = [&](const model::FrequencyResponse::Excitation& e) {
    if (e.kind != model::FrequencyResponse::Excitation::Kind::enforced) return;
    model::PrescribedMotion motion;
    motion.nodes = e.nodes;
    motion.direction = e.direction;
    motion.place = e.place;
    m.motions.push_back(std::move(motion));
  };
  if (m.frequency_response)
    for (const model::FrequencyResponse::Case& c : m.frequency_response->cases) hold(c.excitation);
  if (m.steady_state)
    for (const model::SteadyState::Case& c : m.steady_state->cases)
      for (const model::SteadyState::Load& load : c.loads) hold(load.excitation);
}

}  // namespace

model::Model linear_model(const model::Model& model, Findings& findings) {
  model::Model m = model;
  m.control.mass_step = 0.0;
  take_viscosity_out(m);
  take_bonds_unbroken(m);
  warn_of_glue(m, findings);
  m.control.bulk_viscosity_type = 1;  // none in shells
  for (const model::RigidWeld& weld : m.rigid_welds)
    if (weld.kind == model::RigidWeld::Kind::rivet)
      findings.error(weld.place, "*CONSTRAINED_RIVET", "rivets are not built in linear analyses",
                     "weld the two nodes with *CONSTRAINED_SPOTWELD");
  if (!m.belts.empty())
    findings.error(m.belts.elements.front().place, "*ELEMENT_SEATBELT", "seat belts are not built in linear analyses",
                   "put springs (*ELEMENT_DISCRETE) in their place");
  for (const model::ControlVolume& gas : m.control_volumes)
    findings.warning(gas.place, "*" + gas.keyword,
                     "the gas takes no part in linear analyses: it has no stiffness there");
  refuse_fluids(m, findings);
  refuse_membranes(m, findings);
  constrain_driven_nodes(m);
  change_bricks(m, findings);
  separate_pressures(m, findings);
  assume_strains_of_welds(m, findings);
  stabilize_bricks(m, findings);
  integrate_thick_shells_fully(m, findings);
  integrate_shells_fully(m, findings);
  return m;
}

weld::Ties linear_ties(const weld::Ties& ties, Findings& findings) {
  weld::Ties rigid = ties;
  std::size_t springs = 0;
  for (weld::Tie& tie : rigid.ties) {
    springs += tie.spring || !tie.lever;
    tie.spring = false;
    tie.lever = true;
  }
  if (springs > 0)
    findings.note(
        {}, "*CONTACT_TIED",
        fmt::format("{} nodes are tied by springs, or without the lever of their gap: linear analyses tie them by "
                    "constraint, gaps as levers",
                    springs));
  return rigid;
}

}  // namespace nugget::nvh
