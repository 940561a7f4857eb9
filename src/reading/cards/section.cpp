// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "deck/text.hpp"
#include "kernel/element/shell.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/beam_rule.hpp"
#include "reading/cards/families.hpp"

// *SECTION_..., *HOURGLASS. An element formulation is judged where the part that uses it is known (check_parts): a
// rigid part is not computed by elements, so any of them will do.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using deck::RowOf;

/// What the cards say beside the section's own members.
struct ShellCards : SectionShell {
  int qr_irid = 0, icomp = 0;
  std::array<double, 4> corner{};  ///< T1 to T4
};
const CardOf<ShellCards> shell_card{
    {&ShellCards::id, id("secid", IdSpace::other, required, "section id")},
    {&ShellCards::elform,
     integer("elform", 0, any_value,
             "formulation: 2 Belytschko-Tsay (10: with warping), 4 and 17 triangles (C0, discrete Kirchhoff), 16 "
             "fully integrated (also for -16, 6, 7, 18, 20, 21), 5 and 9 membranes of one and of 2x2 points; linear "
             "analyses: 1, 8, 11 also, no membranes; blank: THEORY of *CONTROL_SHELL")},
    {&ShellCards::shear_factor, real("shrf", dimension::number, 1, above_zero(), "shear correction factor")},
    {&ShellCards::layers, integer("nip", 2, between(1, 10), "layers through the thickness; membranes have one")},
    integer("propt", 1, any_value, "printout option, no effect"),
    {&ShellCards::qr_irid,
     or_negative(integer("qr_irid", 0, between(-99999999, 1),
                         "layers: 0 Gauss or Lobatto by *CONTROL_SHELL, 1 trapezoidal; below 0: of *INTEGRATION_SHELL, "
                         "whose IRID is this without its sign"),
                 IdSpace::other)},
    {&ShellCards::icomp, integer("icomp", 0, between(0, 1), "1: a card of angles follows for each eight layers")},
    integer("setyp", 1, only(1), "two-dimensional sections"),
};

struct RuleCard {
  int irid = 0, nip = 0, esop = 0, failopt = 0;
};
const CardOf<RuleCard> rule_card{
    {&RuleCard::irid,
     id("irid", IdSpace::other, required, "id of the rule, which QR/IRID of *SECTION_SHELL gives with a minus")},
    {&RuleCard::nip, integer("nip", required, between(1, kernel::most_layers), "layers through the thickness")},
    {&RuleCard::esop,
     integer("esop", 0, between(0, 1), "0: a card for each layer follows; 1: layers of equal thickness")},
    {&RuleCard::failopt,
     integer("failopt", 0, between(0, 1),
             "where only some layers can fail: 0 the shell goes with the last of these, 1 it stays")},
};
struct RuleLayerCard {
  double s = 0, wf = 0;
  int pid = 0;
};
const CardOf<RuleLayerCard> rule_layer_card{
    {&RuleLayerCard::s, real("s", dimension::number, 0, between(-1, 1), "place of the layer: -1 bottom, 1 top")},
    {&RuleLayerCard::wf, real("wf", dimension::number, required, above_zero(), "its share of the thickness")},
    {&RuleLayerCard::pid,
     id("pid", IdSpace::part, 0, "part whose material the layer has; 0: that of the shells' own part")},
};

const CardOf<ShellCards> shell_thickness_card{
    {at(&ShellCards::corner, 0), real("t1", dimension::length, 0, at_least(0), "thickness at node 1")},
    {at(&ShellCards::corner, 1), real("t2", dimension::length, 0, at_least(0), "thickness at node 2; 0: t1")},
    {at(&ShellCards::corner, 2), real("t3", dimension::length, 0, at_least(0), "thickness at node 3; 0: t1")},
    {at(&ShellCards::corner, 3), real("t4", dimension::length, 0, at_least(0), "thickness at node 4; 0: t1")},
    {&ShellCards::nloc,
     real("nloc", dimension::number, 0, any_value, "nodes on the top (1), mid (0) or bottom (-1) surface")},
    {&ShellCards::extra_mass, real("marea", dimension::mass_per_area, 0, at_least(0), "non-structural mass per area")},
    real("idof", dimension::number, 0, any_value, "for formulations 25 and 26 only"),
    integer("edgset", 0, any_value, "for two-dimensional seatbelts only"),
};

/// Of ICOMP 1, for eight layers.
struct AnglesCard {
  std::array<double, 8> b{};  ///< [degrees]
};
const CardOf<AnglesCard> layer_angles_card{
    {at(&AnglesCard::b, 0),
     real("b1", dimension::number, 0, any_value,
          "angle in degrees that turns the material axes of the first layer about the normal; of a membrane 0")},
    {at(&AnglesCard::b, 1),
     real("b2", dimension::number, 0, any_value, "of the second; of a membrane that of the threads b: 0 or 90")},
    {at(&AnglesCard::b, 2), real("b3", dimension::number, 0, any_value, "of the third, and so on")},
    {at(&AnglesCard::b, 3), real("b4", dimension::number, 0, any_value, "the same of the next")},
    {at(&AnglesCard::b, 4), real("b5", dimension::number, 0, any_value, "the same of the next")},
    {at(&AnglesCard::b, 5), real("b6", dimension::number, 0, any_value, "the same of the next")},
    {at(&AnglesCard::b, 6), real("b7", dimension::number, 0, any_value, "the same of the next")},
    {at(&AnglesCard::b, 7), real("b8", dimension::number, 0, any_value, "the same of the next")},
};

/// A written 0 is a formulation of its own, not a blank field.
constexpr IntegerField solid_formulation() {
  IntegerField f = integer(
      "elform", 1, any_value,
      "formulation: 1 constant stress, 2 fully integrated, -1, -2 and 3 the same without locking in bending, "
      "tetrahedra 4 with nodal rotations, 10, 13 with pressure by nodes, 16 of ten nodes (also for 17), 15 wedge "
      "(as a collapsed 2), adhesive 19 and between shells 20 (their wedges 21, 22); 0 is computed as 1");
  f.zero_is_default = false;
  return f;
}

const CardOf<SolidCard> solid_card{
    {&SolidCard::id, id("secid", IdSpace::other, required, "section id")},
    {&SolidCard::elform, solid_formulation()},
    integer("aet", 0, any_value, "ambient elements of ELFORM 7, 11 and 12 (fluids), no effect on others"),
    unused(),
    unused(),
    unused(),
    {&SolidCard::cohoff,
     real("cohoff", dimension::number, 0, any_value, "of ELFORM 20: place of the adhesive; only 0, midway, is built")},
    {&SolidCard::gaskett, real("gaskett", dimension::number, 0, any_value, "for gaskets only")},
};

const CardOf<SolidCard> thick_shell_card{
    {&SolidCard::id, id("secid", IdSpace::other, required, "section id")},
    {&SolidCard::elform,
     integer(
         "elform", 1, any_value,
         "formulation: 1 one point in its plane, 2 four, layers with laws of shells and a stiffness across of their "
         "own; 3 four points, 5 one, assumed strains, laws of solids; others are refused")},
    {&SolidCard::shrf, real("shrf", dimension::number, 1, above_zero(),
                            "factor on the transverse shear stiffness; of ELFORM 3 and 5 with TSHEAR 1, the parabola "
                            "of TSHEAR 0 has 5/6")},
    {&SolidCard::nip,
     integer("nip", 2, between(2, 10), "layers through the thickness; of ELFORM 1 3 for 2 and 5 for 4")},
    real("propt", dimension::number, 0, any_value, "listings, no effect"),
    {&SolidCard::qr, integer("qr", 0, between(0, 1),
                             "places of the layers: 0 Gauss, 1 equally spaced with the outermost on the faces")},
    integer("icomp", 0, only(0), "angles of layers are not built"),
    {&SolidCard::tshear,
     real("tshear", dimension::number, 0, between(0, 1),
          "transverse shear strain of ELFORM 3 and 5: 0 a parabola through the thickness, 1 constant, as that of 1 and "
          "2 always is")},
};

/// What the cards say beside the section's own members.
struct BeamCards : SectionBeam {
  double scoor_written = 0.0;
  int print = 0, itoff = 0, cid = 0;
};
const CardOf<BeamCards> beam_card{
    {&BeamCards::id, id("secid", IdSpace::other, required, "section id")},
    {&BeamCards::elform,
     integer("elform", 1, any_value,
             "formulation: 1 Hughes-Liu, 2 Belytschko-Schwer, 3 truss, 6 discrete beam, 9 spot weld")},
    {&BeamCards::shear_factor, real("shrf", dimension::number, 1, above_zero(), "shear factor")},
    {&BeamCards::quadrature,
     or_negative(integer("qr_irid", 2, any_value,
                         "points: 1 one, 2 2x2 Gauss, 3 3x3 Gauss, 4 3x3 Lobatto, 5 4x4 Gauss; below 0: of "
                         "*INTEGRATION_BEAM, whose IRID is this without its sign"),
                 IdSpace::other)},
    {&BeamCards::cross_section,
     integer("cst", 0, any_value,
             "cross section: 0 rectangle, 1 tube, 2 of *INTEGRATION_BEAM; a weld is round in any case")},
    {&BeamCards::scoor_written,
     real(
         "scoor", dimension::number, 0, any_value,
         "discrete beam: triad turns with node 1 (< 0), 2 (> 0), both (0); 2, 3: finite length; 2: r along the nodes")},
    {&BeamCards::extra_mass, real("nsm", dimension::mass_per_length, 0, at_least(0), "non-structural mass per length")},
    integer("naupd", 0, any_value, "for integrated beams only"),
};

const CardOf<BeamCards> weld_card{
    {at(&BeamCards::outer, 0), real("ts1", dimension::length, 0, at_least(0), "outer diameter at node 1")},
    {at(&BeamCards::outer, 1), real("ts2", dimension::length, 0, at_least(0), "outer diameter at node 2; 0: ts1")},
    {at(&BeamCards::inner, 0), real("tt1", dimension::length, 0, at_least(0), "inner diameter at node 1")},
    {at(&BeamCards::inner, 1), real("tt2", dimension::length, 0, at_least(0), "inner diameter at node 2; 0: tt1")},
    {&BeamCards::print, integer("print", 0, between(0, 1), "1: not in swforc")},
    unused(),
    {&BeamCards::itoff, integer("itoff", 0, between(0, 1), "1: no torsional stiffness")},
};

const CardOf<BeamCards> integrated_card{
    {at(&BeamCards::outer, 0),
     real("ts1", dimension::length, 0, at_least(0),
          "extent along s at node 1; tube: outer diameter; a standard cross-section of *INTEGRATION_BEAM needs none")},
    {at(&BeamCards::outer, 1), real("ts2", dimension::length, 0, at_least(0), "at node 2; 0: ts1")},
    {at(&BeamCards::inner, 0),
     real("tt1", dimension::length, 0, at_least(0), "extent along t at node 1; tube: inner diameter")},
    {at(&BeamCards::inner, 1), real("tt2", dimension::length, 0, at_least(0), "at node 2; 0: tt1")},
    {at(&BeamCards::location, 0), real("nsloc", dimension::number, 0, any_value,
                                       "the nodes stand at s = 1 the upper, 0 the middle, -1 the lower side")},
    {at(&BeamCards::location, 1), real("ntloc", dimension::number, 0, any_value, "the same along t")},
};

const CardOf<BeamCards> resultant_card{
    {&BeamCards::area, real("a", dimension::area, required, above_zero(), "area of the cross-section")},
    {&BeamCards::moment_s, real("iss", dimension::second_moment, 0, at_least(0), "second moment about s")},
    {&BeamCards::moment_t, real("itt", dimension::second_moment, 0, at_least(0), "second moment about t; 0: iss")},
    {&BeamCards::torsion_constant,
     real("j", dimension::second_moment, 0, at_least(0), "torsion constant; 0: iss + itt")},
    {&BeamCards::shear_area, real("sa", dimension::area, 0, at_least(0), "shear area; 0: no shear deformation")},
    real("ist", dimension::second_moment, 0, only(0), "product of inertia"),
};

const CardOf<BeamCards> truss_card{
    {&BeamCards::area, real("a", dimension::area, required, above_zero(), "area of the cross-section")},
    real("rampt", dimension::time, 0, only(0), "time in which the stress of dynamic relaxation comes up"),
    real("stress", dimension::stress, 0, only(0), "initial stress of dynamic relaxation"),
};

const CardOf<BeamCards> discrete_card{
    {&BeamCards::volume,
     real("vol", dimension::volume, 0, at_least(0), "volume; mass = density times volume, half at each node")},
    {&BeamCards::inertia, real("iner", dimension::inertia, 0, at_least(0), "rotary inertia, half at each node")},
    {&BeamCards::cid, id("cid", IdSpace::define, 0, "coordinate system of r s t; 0: third node, else global axes")},
    {&BeamCards::cable_area, real("ca", dimension::area, 0, at_least(0), "area of a cable; no effect in others")},
    {&BeamCards::cable_offset, real("offset", dimension::length, 0, any_value,
                                    "what a cable is stretched by at the start, below 0 slack; no effect in others")},
    real("rrcon", dimension::number, 0, only(0), "1: the triad does not turn about r"),
    real("srcon", dimension::number, 0, only(0), "1: the triad does not turn about s"),
    real("trcon", dimension::number, 0, only(0), "1: the triad does not turn about t"),
};

const CardOf<Hourglass> hourglass_card{
    {&Hourglass::id, id("hgid", IdSpace::other, required, "id")},
    {&Hourglass::type,
     integer("ihq", 0, between(0, 10),
             "type: shells 1-3 viscous, 4 5 stiffness, 8 warping stiffness of formulation 16; solids 1-3 viscous")},
    {&Hourglass::membrane, real("qm", dimension::number, 0.1, at_least(0), "coefficient (membrane)")},
    unused(),
    {&Hourglass::bulk_quadratic, real("q1", dimension::number, 1.5, any_value, "quadratic bulk viscosity")},
    {&Hourglass::bulk_linear, real("q2", dimension::number, 0.06, any_value, "linear bulk viscosity")},
    {&Hourglass::bending, real("qb_vdc", dimension::number, 0, at_least(0), "coefficient of bending; 0: qm")},
    {&Hourglass::warping, real("qw", dimension::number, 0, at_least(0), "coefficient of warping; 0: qm")},
};

double mean_thickness(const std::array<double, 4>& corner) {
  double sum = 0.0;
  for (const double t : corner) sum += t > 0.0 ? t : corner[0];
  return 0.25 * sum;
}

/// Adds a section of its kind under its id.
template <class Section>
void add_section(Builder& b, const Row& row, Section section, Ids& ids, std::vector<Section>& sections,
                 std::string_view what) {
  section.place = row.place();
  ids.add(section.id, static_cast<Index>(sections.size()), section.place, row.keyword(), what, b.findings);
  sections.push_back(std::move(section));
}

/// The layers of the section that comes next are those of a rule of the user.
void take_rule(Builder& b, const RowOf<ShellCards>& row) {
  const int id = -row->qr_irid;
  b.defer(Phase::curves, [row, id, index = b.model.shell_sections.size()](Builder& builder) {
    const auto found = builder.layer_rules.find(id);
    if (found == builder.layer_rules.end())
      return refuse(builder, row[&ShellCards::qr_irid], fmt::format("rule {} is not defined", id),
                    "define it with *INTEGRATION_SHELL, or write 0 or 1");
    SectionShell& section = builder.model.shell_sections[index];
    builder.layer_stacks[static_cast<Index>(index)] = found->second;
    section.rule.clear();
    for (const LayerCard& layer : found->second.layers) section.rule.push_back({layer.place, layer.share});
    section.layers = static_cast<int>(section.rule.size());
    if (row->layers != section.layers)
      row[&ShellCards::layers].report(
          builder.findings, Severity::warning,
          fmt::format("there are {} layers, as rule {} of *INTEGRATION_SHELL says", section.layers, id),
          fmt::format("write {}", section.layers));
  });
}

/// One of the angles of ICOMP 1.
struct LayerAngle {
  deck::Entry entry;
  double degrees = 0.0;
};

/// The one layer of a membrane has no angle of its own: fabric has B1 and B2 for its threads a and b.
void check_threads(Builder& b, const std::vector<LayerAngle>& angles) {
  for (std::size_t k = 0; k < angles.size(); ++k) {
    const double degrees = angles[k].degrees;
    if (degrees == 0.0 || (k == 1 && degrees == 90.0)) continue;
    refuse(b, angles[k].entry,
           k == 1   ? "threads b of a membrane that are not at right angles to its threads a are not built"
           : k == 0 ? "an angle of a membrane's threads by the section is not built"
                    : "a membrane has one layer",
           k == 1   ? "write 90 or 0"
           : k == 0 ? "write 0, and the angle as BETA of the material"
                    : "write 0");
  }
}

/// The points of a section that no rule of the user gives.
LayerStack own_points(const SectionShell& section, const Control& control) {
  const kernel::LayerRule rule = section.trapezoidal ? kernel::equally_spaced_layers(section.layers)
                                 : control.lobatto   ? kernel::lobatto_layers(section.layers)
                                                     : kernel::gauss_layers(section.layers);
  LayerStack points;
  for (int k = 0; k < rule.count; ++k) {
    points.layers.push_back({rule.zeta[at(k)], rule.weight[at(k)], {}});
    points.layers.back().number = k;
  }
  return points;
}

/// The layers of the section that comes next are turned by B1, B2 and so on. Comes after take_rule.
void take_angles(Builder& b, const Block& block, std::vector<LayerAngle> angles) {
  if (std::all_of(angles.begin(), angles.end(), [](const LayerAngle& a) { return a.degrees == 0.0; })) return;
  b.defer(Phase::curves, [angles = std::move(angles), sense = hand(block), mirrored = is_mirrored(block),
                          index = static_cast<Index>(b.model.shell_sections.size())](Builder& builder) {
    const SectionShell& section = builder.model.shell_sections[index];
    const Control& control = builder.model.control;
    if (is_membrane(section.elform == 0 ? control.default_shell : section.elform))
      return check_threads(builder, angles);
    LayerStack& stack = builder.layer_stacks.try_emplace(index, own_points(section, control)).first->second;
    for (LayerCard& layer : stack.layers) {
      const LayerAngle& angle = angles[at(layer.number)];
      layer.angle = sense * angle.degrees * (std::numbers::pi / 180.0);
      layer.mirrored = mirrored;
      if (layer.names == LayerCard::Names::nothing) layer.id = angle.entry;
    }
    for (std::size_t k = stack.layers.size(); k < angles.size(); ++k)
      if (angles[k].degrees != 0.0)
        angles[k].entry.report(builder.findings, Severity::warning,
                               fmt::format("not looked at: the section has {} layers", stack.layers.size()),
                               "write 0, or as many layers in NIP as there are angles");
  });
}

void read_shell(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    ShellCards s;
    const auto row = cursor.read(shell_card, s);
    const int errors = b.findings.errors();
    cursor.read(shell_thickness_card, s);
    const bool size_is_known = b.findings.errors() == errors;
    if (s.icomp != 0 && s.icomp != 1) return;  // refused by its range
    std::vector<LayerAngle> angles;
    for (int k = 0; s.icomp == 1 && k < s.layers; k += 8) {
      const auto eight = cursor.read(layer_angles_card);
      for (std::size_t i = 0; i < eight->b.size(); ++i) angles.push_back({eight[at(&AnglesCard::b, i)], eight->b[i]});
    }
    s.trapezoidal = s.qr_irid == 1;
    s.thickness = size_is_known ? mean_thickness(s.corner) : std::numeric_limits<double>::quiet_NaN();
    if (s.qr_irid < 0) take_rule(b, row);
    take_angles(b, block, std::move(angles));
    add_section<SectionShell>(b, row, s, b.shell_sections, b.model.shell_sections, "shell section");
    b.shell_formulations.push_back(row[&ShellCards::elform]);
  }
}

void read_rule(Builder& b, const Block& block, const Options&) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    const auto row = cursor.read(rule_card);
    const int count = row->nip;
    if (count < 1 || count > kernel::most_layers) return;  // refused by its range
    LayerStack rule;
    rule.kept_by_unfailing_layers = row->failopt == 1;
    const bool equal = row->esop == 1;
    for (int k = 0; k < count; ++k) {
      if (equal) {
        rule.layers.push_back({(2.0 * k + 1.0) / count - 1.0, 1.0 / count, row[&RuleCard::irid]});
        rule.layers.back().number = k;
        continue;
      }
      const auto layer = cursor.read(rule_layer_card);
      const auto names = layer->pid == 0 ? LayerCard::Names::nothing : LayerCard::Names::part;
      rule.layers.push_back({layer->s, layer->wf, layer[&RuleLayerCard::pid], names});
      rule.layers.back().number = k;
    }
    std::stable_sort(rule.layers.begin(), rule.layers.end(), [](const LayerCard& one, const LayerCard& other) {
      return std::pair(one.place, one.share) < std::pair(other.place, other.share);
    });
    double sum = 0.0, moment = 0.0;
    for (const LayerCard& layer : rule.layers) sum += layer.share, moment += layer.share * layer.place;
    if (std::abs(sum - 1.0) > 1e-3 || std::abs(moment) > 1e-3)
      row[&RuleCard::irid].report(
          b.findings, Severity::warning,
          fmt::format("the layers' shares sum up to {:.4g} and lie about {:.4g} of half the thickness", sum,
                      moment / sum),
          "a sheet has 1 and 0: see WF and S");
    if (!b.layer_rules.try_emplace(row->irid, std::move(rule)).second)
      refuse(b, row[&RuleCard::irid], fmt::format("rule {} is defined twice", row->irid), "give it another id");
  }
}

void read_solid(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(solid_card);
    add_section<SectionSolid>(b, row, *row, b.solid_sections, b.model.solid_sections, "solid section");
    b.solid_section_rows.push_back(row);
  }
}

void read_thick_shell(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    const auto row = cursor.read(thick_shell_card);
    SectionSolid section = *row;
    int layers = row->nip;
    if (row->elform == 1 && (layers == 2 || layers == 4)) {  // manual of Oasys D3PLOT: so LS-DYNA does
      ++layers;
      row[&SolidCard::nip].report(
          b.findings, Severity::note,
          fmt::format("thick shells of ELFORM 1 have {} layers for {}, as LS-DYNA gives them", layers, row->nip));
    }
    section.thickness = SectionSolid::Thickness{layers, row->qr == 1, row->shrf, row->tshear == 0.0};
    if (row->tshear != 0.0 && row->tshear != 1.0)
      refuse(b, row[&SolidCard::tshear], "this distribution of the transverse shear is not known", "write 0 or 1");
    add_section<SectionSolid>(b, row, section, b.solid_sections, b.model.solid_sections, "section of thick shells");
    b.solid_section_rows.push_back(row);
  }
}

/// Zero at the second end means: as at the first.
void complete_ends(SectionBeam& s) {
  for (auto* extent : {&s.outer, &s.inner})
    if (!((*extent)[1] > 0.0)) (*extent)[1] = (*extent)[0];
}

/// The round section of a weld.
void read_diameters(Builder& b, const RowOf<BeamCards>& row, Cursor& cursor, BeamCards& s) {
  const auto weld = cursor.read(weld_card, s);
  complete_ends(s);
  s.in_swforc = s.print == 0;
  s.torsion = s.itoff == 0;
  if (!(s.outer[0] > 0.0))
    refuse(b, weld[at(&BeamCards::outer, 0)], "a spot weld needs its diameter", "write the nugget's diameter there");
  for (const std::size_t end : {0u, 1u})
    if (s.inner[end] >= s.outer[end] && s.outer[end] > 0.0)
      refuse(b, weld[at(&BeamCards::inner, end)], "the inner diameter must be smaller than the outer one",
             "leave it 0 for a full section");
  if (s.cross_section != 1)
    row[&BeamCards::cross_section].report(b.findings, Severity::warning,
                                          "a weld is round: TS and TT are taken as diameters", "write 1");
  if (s.quadrature < 1 || s.quadrature > 5)
    refuse(b, row[&BeamCards::quadrature], "welds with integration rules of the user are not built", "write 1 to 5");
  else if (s.quadrature == 1)
    row[&BeamCards::quadrature].report(b.findings, Severity::warning,
                                       "one point has no bending stiffness: a weld gets four", "write 2");
}

void read_discrete(Builder& b, const RowOf<BeamCards>& row, Cursor& cursor, BeamCards& s) {
  const auto discrete = cursor.read(discrete_card, s);
  s.scoor = static_cast<int>(s.scoor_written);
  if (s.scoor != s.scoor_written || std::abs(s.scoor) > 3)
    refuse(b, row[&BeamCards::scoor_written], "this way of turning the triad is not built",
           "write a whole number from -3 to 3");
  if (s.cid == 0) return;
  b.defer(Phase::bodies, [index = b.model.beam_sections.size(), cid = discrete[&BeamCards::cid]](Builder& later) {
    later.model.beam_sections[index].system = later.system(cid);
  });
}

/// ELFORM 1: a rectangle or a tube with points of its own, or what *INTEGRATION_BEAM says.
void read_integrated(Builder& b, const RowOf<BeamCards>& row, Cursor& cursor, BeamCards& s) {
  const auto size = cursor.read(integrated_card, s);
  complete_ends(s);
  if (s.cross_section < 0 || s.cross_section > 2)
    refuse(b, row[&BeamCards::cross_section], "this cross-section is not known", "write 0, 1 or 2");
  if (s.quadrature < 0)
    return take_beam_rule(b, -s.quadrature, row[&BeamCards::quadrature], size[at(&BeamCards::location, 0)],
                          size[at(&BeamCards::outer, 0)]);
  if (s.quadrature > 5)
    refuse(b, row[&BeamCards::quadrature], "there is no rule of this number",
           "write 1 to 5, or the id of an *INTEGRATION_BEAM with a minus");
  if (s.cross_section == 2)
    refuse(b, row[&BeamCards::quadrature], "a cross-section of *INTEGRATION_BEAM (CST 2) needs the id of its rule",
           "write it with a minus");
  if (!(s.outer[0] > 0.0))
    refuse(b, size[at(&BeamCards::outer, 0)], "must be given, above 0",
           s.cross_section == 1 ? "give the outer diameter" : "give the extent along s");
  const deck::Entry across = size[at(&BeamCards::inner, 0)];
  if (s.cross_section == 0 && !(s.inner[0] > 0.0))
    refuse(b, across, "a rectangle needs its extent along t", "give TT1");
  if (s.cross_section == 1 && (s.inner[0] >= s.outer[0] || s.inner[1] >= s.outer[1]))
    refuse(b, across, "the inner diameter must be smaller than the outer one", "leave it 0 for a full section");
  if (s.cross_section == 1 && (s.location[0] != 0.0 || s.location[1] != 0.0))
    refuse(b, size[at(&BeamCards::location, 0)], "nodes off the axis of a tube are not built", "leave it 0");
}

void read_resultant(Cursor& cursor, BeamCards& s) {
  cursor.read(resultant_card, s);
  if (!(s.moment_t > 0.0)) s.moment_t = s.moment_s;
  if (!(s.torsion_constant > 0.0)) s.torsion_constant = s.moment_s + s.moment_t;
}

void read_beam(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    BeamCards s;
    const auto row = cursor.read(beam_card, s);
    if (s.elform == 9)
      read_diameters(b, row, cursor, s);
    else if (s.elform == 6)
      read_discrete(b, row, cursor, s);
    else if (s.elform == 1)
      read_integrated(b, row, cursor, s);
    else if ((s.elform == 2 || s.elform == 3) && names_a_shape(cursor))
      read_named_shape(b, cursor, s);
    else if (s.elform == 2)
      read_resultant(cursor, s);
    else if (s.elform == 3)
      cursor.read(truss_card, s);
    else
      cursor.skip();  // another formulation is refused where a part uses it; its second card is not ours to read
    add_section<SectionBeam>(b, row, s, b.beam_sections, b.model.beam_sections, "beam section");
    b.beam_formulations.push_back(row[&BeamCards::elform]);
  }
}

void read_hourglass(Builder& b, const Block& block, const Options& options) {
  for (Cursor cursor(b.deck, block, b.findings); !at_end(cursor);) {
    read_title(cursor, options);
    Hourglass h;
    const auto row = cursor.read(hourglass_card, h);
    if (!(h.bending > 0.0)) h.bending = h.membrane;
    if (!(h.warping > 0.0)) h.warping = h.membrane;
    h.place = row[&Hourglass::type].place;
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
       .layout = {{"", &shell_card},
                  {"", &shell_thickness_card},
                  {"if ICOMP = 1, for each eight layers", &layer_angles_card}},
       .read = read_shell},
      {.name = "INTEGRATION_SHELL",
       .layout = {{"", &rule_card}, {"if ESOP = 0, NIP times", &rule_layer_card}},
       .read = read_rule},
      {.name = "SECTION_SOLID", .options = {"TITLE"}, .layout = {{"", &solid_card}}, .read = read_solid},
      {.name = "SECTION_TSHELL", .options = {"TITLE"}, .layout = {{"", &thick_shell_card}}, .read = read_thick_shell},
      {.name = "SECTION_BEAM",
       .options = {"TITLE"},
       .layout = {{"", &beam_card},
                  {"if ELFORM = 9", &weld_card},
                  {"if ELFORM = 6", &discrete_card},
                  {"if ELFORM = 1", &integrated_card},
                  {"if ELFORM = 2", &resultant_card},
                  {"if ELFORM = 3", &truss_card},
                  {"in place of these, if it begins with SECTION_", &named_shape_card}},
       .read = read_beam},
      {.name = "INTEGRATION_BEAM",
       .layout = {{"", &beam_rule_card},
                  {"if ICST is above 0", &beam_shape_card},
                  {"if ICST = 0, NIP times", &beam_point_card}},
       .read = read_beam_rule},
      {.name = "HOURGLASS", .options = {"TITLE"}, .layout = {{"", &hourglass_card}}, .read = read_hourglass},
  };
}

}  // namespace nugget::reading
