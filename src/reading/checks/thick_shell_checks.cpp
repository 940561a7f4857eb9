// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "base/index.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/passes.hpp"

// What thick shells (*ELEMENT_TSHELL, *SECTION_TSHELL) do not have.
namespace nugget::reading {
namespace {

/// Elements and section of a part have to be both of thick shells or both of bricks.
void check_kinds(Builder& b) {
  const Model& m = b.model;
  Tally unlike(b.findings, Severity::error, "*PART");
  std::vector<char> reported(m.parts.size(), 0);
  for (std::size_t e = 0; e < m.solids.size(); ++e) {
    const Index p = m.solids.part[e];
    const bool thick = e < b.thick_solids.size() && b.thick_solids[e] != 0;
    const Part& part = m.parts[p];
    if (part.section == none || thick == m.has_thick_shells(p) || std::exchange(reported[at(p)], char{1})) continue;
    unlike.add(
        part.place,
        [&] {
          return fmt::format("part {} has {}, as solid {}, but section {} is of {}", part.id,
                             thick ? "thick shells" : "bricks", m.solids.id[e], m.solid_sections[part.section].id,
                             thick ? "bricks" : "thick shells");
        },
        thick ? "give the part a *SECTION_TSHELL, or write the elements as *ELEMENT_SOLID"
              : "give the part a *SECTION_SOLID, or write the elements as *ELEMENT_TSHELL");
  }
}

void check_formulation(Builder& b, const deck::RowOf<SolidCard>& row) {
  const int elform = row->elform;
  if (elform == 1 || elform == 2) return;
  if (elform != 3 && elform != 5)
    return refuse(b, row[&SolidCard::elform],
                  fmt::format("thick shells of ELFORM {} are not built; built are 1 and 2 (laws of shells; one and 2 x "
                              "2 points in the plane), 3 and 5 (laws of solids, assumed strains; 2 x 2 points and "
                              "one)",
                              elform),
                  elform == 6 ? "write 2, which has laws of shells as well"
                              : "write 5: it has the stress across, bends without locking and needs no hourglass "
                                "control");
  const bool five_sixths = std::abs(row->shrf - 5.0 / 6.0) < 1e-2;
  if (row->tshear == 0.0 && row->shrf != 1.0 && !five_sixths)
    refuse(b, row[&SolidCard::shrf],
           "a parabola of transverse shear (TSHEAR 0) has the factor 5/6 of its own; another one is not built",
           "leave SHRF blank, or write TSHEAR 1");
}

/// Laws of one modulus and one ratio, plastic or not: the strain across goes by these (thick_shell.hpp), and the
/// stiffness across (extruded_shell.hpp).
bool is_of_thick_shells(const Law& law, bool in_layers_of_shells) {
  if (const auto* compound = std::get_if<kernel::ComposedLaw>(&law)) {
    const kernel::LawComponents& made = *compound->components;
    if (in_layers_of_shells && !kernel::for_shells(made)) return false;
    const bool metal = kernel::has_plastic_strain(made.flow) || std::holds_alternative<kernel::Elastic>(made.flow);
    return metal && kernel::for_bricks(made) && kernel::axes_of(made.flow) == nullptr && !made.bond && !made.state;
  }
  return std::holds_alternative<kernel::Elastic>(law) || std::holds_alternative<kernel::PlasticKinematic>(law) ||
         std::holds_alternative<kernel::PiecewiseLinear>(law) || std::holds_alternative<kernel::Rigid>(law);
}

void check_control(Builder& b, const Part& part) {
  const Model& m = b.model;
  const Hourglass& h = part.hourglass == none ? m.control.hourglass : m.hourglass[at(part.hourglass)];
  const int elform = m.solid_sections[part.section].elform;
  if (elform == 2 || elform == 3) return;  // they have no hourglass patterns
  if (elform == 1) {
    if (h.type <= 5) return;
    const bool of_part = part.hourglass != none;
    b.findings.add({of_part ? Severity::error : Severity::warning, h.place,
                    of_part ? "*HOURGLASS" : "*CONTROL_HOURGLASS", "ihq", std::to_string(h.type),
                    fmt::format("part {} has thick shells of ELFORM 1, which have hourglass control as shells have it, "
                                "types 1 to 5{}",
                                part.id, of_part ? "" : ": they get type 1, viscosity, as with IHQ 0"),
                    "write 4, or give the part ELFORM 2, which needs none"});
    return;
  }
  if (h.type == 0 || h.type == 6) return;
  if (part.hourglass == none) {
    b.findings.note(h.place, "*CONTROL_HOURGLASS",
                    fmt::format("the thick shells of part {} have the stabilisation of their assumed strains, not type "
                                "{}",
                                part.id, h.type));
    return;
  }
  b.findings.add({Severity::error, h.place, "*HOURGLASS", "ihq", std::to_string(h.type),
                  fmt::format("part {} has thick shells of ELFORM 5, whose stabilisation is that of their assumed "
                              "strains (type 6)",
                              part.id),
                  "take HGID out of the part, or write 6 with QM as the share of that stabilisation"});
}

}  // namespace

void check_thick_shells(Builder& b) {
  check_kinds(b);
  const Model& m = b.model;
  std::vector<char> reported(m.solid_sections.size(), 0);
  for (const auto& [index, row] : b.part_rows) {
    if (!m.has_thick_shells(index)) continue;
    const Part& part = m.parts[index];
    const auto s = at(part.section);
    const bool rigid = part.material != none && std::holds_alternative<kernel::Rigid>(m.materials[part.material].law);
    if (rigid) continue;
    if (!std::exchange(reported[s], char{1})) check_formulation(b, b.solid_section_rows[s]);
    if (part.material != none &&
        !is_of_thick_shells(m.materials[part.material].law, m.solid_sections[part.section].has_laws_of_shells()))
      refuse(b, row[&PartCard::mid],
             fmt::format("*{} is not built for thick shells", m.materials[part.material].keyword),
             "give the part the law of a metal (*MAT_001, 003, 015, 018, 024, 081, 098, ...), or model it with bricks "
             "or shells");
    if (row->eosid != 0)
      refuse(b, row[&PartCard::eosid], "thick shells with an equation of state are not built", "model it with bricks");
    check_control(b, part);
  }
}

}  // namespace nugget::reading
