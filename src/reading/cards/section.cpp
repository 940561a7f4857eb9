// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "deck/text.hpp"
#include "kernel/element/shell.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *SECTION_..., *HOURGLASS. An element formulation is judged where the part that uses it is known (check_parts): a
// rigid part is not computed by elements, so any of them will do.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

const Card shell_card{{
    id("secid", IdSpace::other, required, "section id"),
    integer("elform", 0, any_value,
            "formulation: 2 Belytschko-Tsay (10: with warping), 4 and 17 triangles (C0, discrete Kirchhoff), 16 "
            "fully integrated (also for -16, 6, 7, 18, 20, 21); linear analyses: 1, 8, 11 also; blank: THEORY of "
            "*CONTROL_SHELL"),
    real("shrf", dimension::number, 1, above_zero(), "shear correction factor"),
    integer("nip", 2, between(1, 10), "layers through the thickness"),
    integer("propt", 1, any_value, "printout option, no effect"),
    or_negative(integer("qr_irid", 0, between(-99999999, 1),
                        "layers: 0 Gauss or Lobatto by *CONTROL_SHELL, 1 trapezoidal; below 0: of *INTEGRATION_SHELL, "
                        "whose IRID is this without its sign"),
                IdSpace::other),
    integer("icomp", 0, only(0), "layered composites"),
    integer("setyp", 1, only(1), "two-dimensional sections"),
}};

const Card rule_card{{
    id("irid", IdSpace::other, required, "id of the rule, which QR/IRID of *SECTION_SHELL gives with a minus"),
    integer("nip", required, between(1, kernel::most_layers), "layers through the thickness"),
    integer("esop", 0, between(0, 1), "0: a card for each layer follows; 1: layers of equal thickness"),
    integer("failopt", 0, between(0, 1),
            "where only some layers can fail: 0 the shell goes with the last of these, 1 it stays"),
}};
const Card rule_layer_card{{
    real("s", dimension::number, 0, between(-1, 1), "place of the layer: -1 bottom, 1 top"),
    real("wf", dimension::number, required, above_zero(), "its share of the thickness"),
    id("pid", IdSpace::part, 0, "part whose material the layer has; 0: that of the shells' own part"),
}};

const Card shell_thickness_card{{
    real("t1", dimension::length, 0, at_least(0), "thickness at node 1"),
    real("t2", dimension::length, 0, at_least(0), "thickness at node 2; 0: t1"),
    real("t3", dimension::length, 0, at_least(0), "thickness at node 3; 0: t1"),
    real("t4", dimension::length, 0, at_least(0), "thickness at node 4; 0: t1"),
    real("nloc", dimension::number, 0, any_value, "nodes on the top (1), mid (0) or bottom (-1) surface"),
    real("marea", dimension::mass_per_area, 0, at_least(0), "non-structural mass per area"),
    real("idof", dimension::number, 0, any_value, "for formulations 25 and 26 only"),
    integer("edgset", 0, any_value, "for two-dimensional seatbelts only"),
}};

/// A written 0 is a formulation of its own, not a blank field.
constexpr Field solid_formulation() {
  Field f = integer(
      "elform", 1, any_value,
      "formulation: 1 constant stress, 2 fully integrated, -1, -2 and 3 the same without locking in bending, "
      "tetrahedra 4 with nodal rotations, 10, 13 with pressure by nodes, 16 of ten nodes (also for 17), 15 wedge "
      "(as a collapsed 2), adhesive 19 and between shells 20 (their wedges 21, 22); 0 is computed as 1");
  f.zero_is_default = false;
  return f;
}

const Card solid_card{{
    id("secid", IdSpace::other, required, "section id"),
    solid_formulation(),
    integer("aet", 0, only(0), "ambient elements"),
    unused(),
    unused(),
    unused(),
    real("cohoff", dimension::number, 0, any_value, "of ELFORM 20: place of the adhesive; only 0, midway, is built"),
    real("gaskett", dimension::number, 0, any_value, "for gaskets only"),
}};

const Card beam_card{{
    id("secid", IdSpace::other, required, "section id"),
    integer("elform", 1, any_value,
            "formulation: 1 Hughes-Liu, 2 Belytschko-Schwer, 3 truss, 6 discrete beam, 9 spot weld"),
    real("shrf", dimension::number, 1, above_zero(), "shear factor"),
    integer("qr_irid", 2, any_value, "points: 1 one, 2 2x2 Gauss, 3 3x3 Gauss, 4 3x3 Lobatto, 5 4x4 Gauss"),
    integer("cst", 0, any_value, "cross section: 0 rectangle, 1 tube; a weld is round in any case"),
    real("scoor", dimension::number, 0, any_value,
         "discrete beam: triad turns with node 1 (< 0), 2 (> 0), both (0); 2, 3: finite length; 2: r along the nodes"),
    real("nsm", dimension::mass_per_length, 0, at_least(0), "non-structural mass per length"),
    integer("naupd", 0, any_value, "for integrated beams only"),
}};

const Card weld_card{{
    real("ts1", dimension::length, 0, at_least(0), "outer diameter at node 1"),
    real("ts2", dimension::length, 0, at_least(0), "outer diameter at node 2; 0: ts1"),
    real("tt1", dimension::length, 0, at_least(0), "inner diameter at node 1"),
    real("tt2", dimension::length, 0, at_least(0), "inner diameter at node 2; 0: tt1"),
    integer("print", 0, between(0, 1), "1: not in swforc"),
    unused(),
    integer("itoff", 0, between(0, 1), "1: no torsional stiffness"),
}};

const Card integrated_card{{
    real("ts1", dimension::length, required, above_zero(), "extent along s at node 1; tube: outer diameter"),
    real("ts2", dimension::length, 0, at_least(0), "at node 2; 0: ts1"),
    real("tt1", dimension::length, 0, at_least(0), "extent along t at node 1; tube: inner diameter"),
    real("tt2", dimension::length, 0, at_least(0), "at node 2; 0: tt1"),
    real("nsloc", dimension::number, 0, any_value,
         "the nodes stand at s = 1 the upper, 0 the middle, -1 the lower side"),
    real("ntloc", dimension::number, 0, any_value, "the same along t"),
}};

const Card resultant_card{{
    real("a", dimension::area, required, above_zero(), "area of the cross-section"),
    real("iss", dimension::second_moment, 0, at_least(0), "second moment about s"),
    real("itt", dimension::second_moment, 0, at_least(0), "second moment about t; 0: iss"),
    real("j", dimension::second_moment, 0, at_least(0), "torsion constant; 0: iss + itt"),
    real("sa", dimension::area, 0, at_least(0), "shear area; 0: no shear deformation"),
    real("ist", dimension::second_moment, 0, only(0), "product of inertia"),
}};

const Card truss_card{{
    real("a", dimension::area, required, above_zero(), "area of the cross-section"),
    real("rampt", dimension::time, 0, only(0), "time in which the stress of dynamic relaxation comes up"),
    real("stress", dimension::stress, 0, only(0), "initial stress of dynamic relaxation"),
}};

const Card discrete_card{{
    real("vol", dimension::volume, 0, at_least(0), "volume; mass = density times volume, half at each node"),
    real("iner", dimension::inertia, 0, at_least(0), "rotary inertia, half at each node"),
    id("cid", IdSpace::define, 0, "coordinate system of r s t; 0: third node, else global axes"),
    real("ca", dimension::area, 0, any_value, "for cables only"),
    real("offset", dimension::length, 0, any_value, "for cables only"),
    real("rrcon", dimension::number, 0, only(0), "1: the triad does not turn about r"),
    real("srcon", dimension::number, 0, only(0), "1: the triad does not turn about s"),
    real("trcon", dimension::number, 0, only(0), "1: the triad does not turn about t"),
}};

const Card hourglass_card{{
    id("hgid", IdSpace::other, required, "id"),
    integer("ihq", 0, between(0, 10),
            "type: shells 1-3 viscous, 4 5 stiffness, 8 warping stiffness of formulation 16; solids 1-3 viscous"),
    real("qm", dimension::number, 0.1, at_least(0), "coefficient (membrane)"),
    unused(),
    real("q1", dimension::number, 1.5, any_value, "quadratic bulk viscosity"),
    real("q2", dimension::number, 0.06, any_value, "linear bulk viscosity"),
    real("qb_vdc", dimension::number, 0, at_least(0), "coefficient of bending; 0: qm"),
    real("qw", dimension::number, 0, at_least(0), "coefficient of warping; 0: qm"),
}};

double mean_thickness(const Row& row) {
  const double t1 = row.real("t1");
  double sum = t1;
  for (const auto* corner : {"t2", "t3", "t4"}) sum += row.real(corner) > 0.0 ? row.real(corner) : t1;
  return 0.25 * sum;
}

/// Adds a section of its kind under its id, with the row of ELFORM for the later judgement.
template <class Section>
void add_section(Builder& b, const Row& row, Section section, Ids& ids, std::vector<Section>& sections,
                 std::vector<Row>& rows, std::string_view what) {
  section.id = row.integer("secid");
  section.elform = row.integer("elform");
  section.place = row.place();
  ids.add(section.id, static_cast<Index>(sections.size()), section.place, row.keyword(), what, b.findings);
  sections.push_back(section);
  rows.push_back(row);
}

/// The layers of the section that comes next are those of a rule of the user.
void take_rule(Builder& b, const Row& row) {
  const int id = -row.integer("qr_irid");
  b.defer(Phase::curves, [row, id, index = b.model.shell_sections.size()](Builder& builder) {
    const auto found = builder.layer_rules.find(id);
    if (found == builder.layer_rules.end())
      return refuse(builder, row, "qr_irid", fmt::format("rule {} is not defined", id),
                    "define it with *INTEGRATION_SHELL, or write 0 or 1");
    SectionShell& section = builder.model.shell_sections[index];
    builder.layer_stacks[static_cast<Index>(index)] = found->second;
    section.rule.clear();
    for (const LayerCard& layer : found->second.layers) section.rule.push_back({layer.place, layer.share});
    section.layers = static_cast<int>(section.rule.size());
    if (row.integer("nip") != section.layers)
      row.report(builder.findings, Severity::warning, "nip",
                 fmt::format("there are {} layers, as rule {} of *INTEGRATION_SHELL says", section.layers, id),
                 fmt::format("write {}", section.layers));
  });
}

void read_shell(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(shell_card);
    const int errors = b.findings.errors();
    const Row size = cursor.read(shell_thickness_card);
    const bool size_is_known = b.findings.errors() == errors;
    if (row.integer("icomp") != 0) return;  // refused by its range; the cards of layers that follow are not read
    SectionShell s;
    s.shear_factor = row.real("shrf");
    s.layers = row.integer("nip");
    s.trapezoidal = row.integer("qr_irid") == 1;
    s.thickness = size_is_known ? mean_thickness(size) : std::numeric_limits<double>::quiet_NaN();
    s.nloc = size.real("nloc");
    s.extra_mass = size.real("marea");
    if (row.integer("qr_irid") < 0) take_rule(b, row);
    add_section(b, row, s, b.shell_sections, b.model.shell_sections, b.shell_section_rows, "shell section");
  }
}

void read_rule(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const Row row = cursor.read(rule_card);
    const int count = row.integer("nip");
    if (count < 1 || count > kernel::most_layers) return;  // refused by its range
    LayerStack rule;
    rule.kept_by_unfailing_layers = row.integer("failopt") == 1;
    const bool equal = row.integer("esop") == 1;
    for (int k = 0; k < count; ++k) {
      if (equal) {
        rule.layers.push_back({(2.0 * k + 1.0) / count - 1.0, 1.0 / count, row, "irid"});
        continue;
      }
      const Row layer = cursor.read(rule_layer_card);
      const auto names = layer.integer("pid") == 0 ? LayerCard::Names::nothing : LayerCard::Names::part;
      rule.layers.push_back({layer.real("s"), layer.real("wf"), layer, "pid", names});
    }
    std::stable_sort(rule.layers.begin(), rule.layers.end(), [](const LayerCard& one, const LayerCard& other) {
      return std::pair(one.place, one.share) < std::pair(other.place, other.share);
    });
    double sum = 0.0, moment = 0.0;
    for (const LayerCard& layer : rule.layers) sum += layer.share, moment += layer.share * layer.place;
    if (std::abs(sum - 1.0) > 1e-3 || std::abs(moment) > 1e-3)
      row.report(b.findings, Severity::warning, "irid",
                 fmt::format("the layers' shares sum up to {:.4g} and lie about {:.4g} of half the thickness", sum,
                             moment / sum),
                 "a sheet has 1 and 0: see WF and S");
    if (!b.layer_rules.try_emplace(row.integer("irid"), std::move(rule)).second)
      refuse(b, row, "irid", fmt::format("rule {} is defined twice", row.integer("irid")), "give it another id");
  }
}

void read_solid(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(solid_card);
    add_section(b, row, SectionSolid{}, b.solid_sections, b.model.solid_sections, b.solid_section_rows,
                "solid section");
  }
}

/// The round section of a weld. Zero at the second end means: as at the first.
void read_diameters(Builder& b, const Row& row, const Row& weld, SectionBeam& s) {
  const auto second = [&](std::string_view field, double first) {
    return weld.real(field) > 0.0 ? weld.real(field) : first;
  };
  s.outer = {weld.real("ts1"), second("ts2", weld.real("ts1"))};
  s.inner = {weld.real("tt1"), second("tt2", weld.real("tt1"))};
  s.in_swforc = weld.integer("print") == 0;
  s.torsion = weld.integer("itoff") == 0;
  if (!(s.outer[0] > 0.0))
    refuse(b, weld, "ts1", "a spot weld needs its diameter", "write the nugget's diameter there");
  for (const std::size_t end : {0u, 1u})
    if (s.inner[end] >= s.outer[end] && s.outer[end] > 0.0)
      refuse(b, weld, end == 0 ? "tt1" : "tt2", "the inner diameter must be smaller than the outer one",
             "leave it 0 for a full section");
  if (row.integer("cst") != 1)
    row.report(b.findings, Severity::warning, "cst", "a weld is round: TS and TT are taken as diameters", "write 1");
  if (s.quadrature < 1 || s.quadrature > 5)
    refuse(b, row, "qr_irid", "integration rules of the user are not built", "write 1 to 5");
  else if (s.quadrature == 1)
    row.report(b.findings, Severity::warning, "qr_irid", "one point has no bending stiffness: a weld gets four",
               "write 2");
}

void read_discrete(Builder& b, const Row& row, const Row& discrete, SectionBeam& s) {
  s.volume = discrete.real("vol");
  s.inertia = discrete.real("iner");
  s.scoor = static_cast<int>(row.real("scoor"));
  if (s.scoor != row.real("scoor") || std::abs(s.scoor) > 3)
    refuse(b, row, "scoor", "this way of turning the triad is not built", "write a whole number from -3 to 3");
  if (discrete.integer("cid") == 0) return;
  b.defer(Phase::bodies, [index = b.model.beam_sections.size(), discrete](Builder& later) {
    later.model.beam_sections[index].system = later.system(discrete, "cid");
  });
}

/// ELFORM 1: a rectangle or a tube with points of its own.
void read_integrated(Builder& b, const Row& row, const Row& size, SectionBeam& s) {
  const auto second = [&](std::string_view field, double first) {
    return size.real(field) > 0.0 ? size.real(field) : first;
  };
  s.outer = {size.real("ts1"), second("ts2", size.real("ts1"))};
  s.inner = {size.real("tt1"), second("tt2", size.real("tt1"))};
  s.location = {size.real("nsloc"), size.real("ntloc")};
  if (s.quadrature < 1 || s.quadrature > 5)
    refuse(b, row, "qr_irid", "integration rules of the user are not built", "write 1 to 5");
  if (s.cross_section != 0 && s.cross_section != 1)
    refuse(b, row, "cst", "cross-sections of the user (*INTEGRATION_BEAM) are not built", "write 0 or 1");
  if (s.cross_section == 0 && !(s.inner[0] > 0.0))
    refuse(b, size, "tt1", "a rectangle needs its extent along t", "give TT1");
  if (s.cross_section == 1 && (s.inner[0] >= s.outer[0] || s.inner[1] >= s.outer[1]))
    refuse(b, size, "tt1", "the inner diameter must be smaller than the outer one", "leave it 0 for a full section");
  if (s.cross_section == 1 && (s.location[0] != 0.0 || s.location[1] != 0.0))
    refuse(b, size, "nsloc", "nodes off the axis of a tube are not built", "leave it 0");
}

/// True (and a finding) where the next card names a shape (STYPE, SECTION_01 to SECTION_22) in place of an area.
bool refuse_shape(Builder& b, Cursor& cursor, const Row& row) {
  const std::string line = deck::upper(cursor.peek());
  const std::string shape(deck::trimmed(line.substr(0, std::min<std::size_t>(10, line.find(',')))));
  if (!shape.starts_with("SECTION_")) return false;
  b.findings.add({Severity::error, cursor.place(), row.keyword(), "stype", shape,
                  "cross-sections by the name of their shape, with D1 to D6, are not built",
                  row.integer("elform") == 2 ? "write A, ISS, ITT, J and SA of the shape" : "write A of the shape"});
  cursor.skip();
  return true;
}

void read_resultant(const Row& size, SectionBeam& s) {
  s.area = size.real("a");
  s.moment_s = size.real("iss");
  s.moment_t = size.real("itt") > 0.0 ? size.real("itt") : s.moment_s;
  s.torsion_constant = size.real("j") > 0.0 ? size.real("j") : s.moment_s + s.moment_t;
  s.shear_area = size.real("sa");
}

void read_beam(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(beam_card);
    SectionBeam s;
    s.shear_factor = row.real("shrf");
    s.quadrature = row.integer("qr_irid");
    s.cross_section = row.integer("cst");
    s.extra_mass = row.real("nsm");
    if (row.integer("elform") == 9)
      read_diameters(b, row, cursor.read(weld_card), s);
    else if (row.integer("elform") == 6)
      read_discrete(b, row, cursor.read(discrete_card), s);
    else if (row.integer("elform") == 1)
      read_integrated(b, row, cursor.read(integrated_card), s);
    else if ((row.integer("elform") == 2 || row.integer("elform") == 3) && refuse_shape(b, cursor, row))
      s.area = std::numeric_limits<double>::quiet_NaN();  // told; the section exists for the parts that use it
    else if (row.integer("elform") == 2)
      read_resultant(cursor.read(resultant_card), s);
    else if (row.integer("elform") == 3)
      s.area = cursor.read(truss_card).real("a");
    else
      cursor.skip();  // another formulation is refused where a part uses it; its second card is not ours to read
    add_section(b, row, s, b.beam_sections, b.model.beam_sections, b.beam_section_rows, "beam section");
  }
}

void read_hourglass(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const Row row = cursor.read(hourglass_card);
    Hourglass h;
    h.id = row.integer("hgid");
    h.type = row.integer("ihq");
    h.membrane = row.real("qm");
    h.bending = row.real("qb_vdc") > 0.0 ? row.real("qb_vdc") : h.membrane;
    h.warping = row.real("qw") > 0.0 ? row.real("qw") : h.membrane;
    h.bulk_quadratic = row.real("q1");
    h.bulk_linear = row.real("q2");
    h.place = row.place("ihq");
    b.hourglass.add(h.id, static_cast<Index>(b.model.hourglass.size()), h.place, block.starred(), "hourglass control",
                    b.findings);
    b.model.hourglass.push_back(h);
  }
}

}  // namespace

std::vector<Keyword> section_keywords() {
  return {
      {.name = "SECTION_SHELL",
       .options = {"TITLE"},
       .layout = {{"", &shell_card}, {"", &shell_thickness_card}},
       .read = read_shell},
      {.name = "INTEGRATION_SHELL",
       .layout = {{"", &rule_card}, {"if ESOP = 0, NIP times", &rule_layer_card}},
       .read = read_rule},
      {.name = "SECTION_SOLID", .options = {"TITLE"}, .layout = {{"", &solid_card}}, .read = read_solid},
      {.name = "SECTION_BEAM",
       .options = {"TITLE"},
       .layout = {{"", &beam_card},
                  {"if ELFORM = 9", &weld_card},
                  {"if ELFORM = 6", &discrete_card},
                  {"if ELFORM = 1", &integrated_card},
                  {"if ELFORM = 2", &resultant_card},
                  {"if ELFORM = 3", &truss_card}},
       .read = read_beam},
      {.name = "HOURGLASS", .options = {"TITLE"}, .layout = {{"", &hourglass_card}}, .read = read_hourglass},
  };
}

}  // namespace nugget::reading
