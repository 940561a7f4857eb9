// SPDX-License-Identifier: Apache-2.0
// *CONTACT_...: the penalty contact and the ties that are built, and by name those that are not.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "model/cards/families.hpp"
#include "model/cards/reading.hpp"
#include "model/contact_form.hpp"

namespace nugget::model {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using Kind = Contact::Kind;

const Card mpp_card1{{
    integer("ignore", 0, any_value, "initial penetrations"),
    integer("bckt", 200, any_value, "search interval"),
    integer("lcbckt", 0, any_value, "curve of that interval"),
    integer("ns2trk", 3, any_value, "contacts tracked a node"),
    integer("inititr", 2, any_value, "iterations for initial penetrations"),
    real("parmax", dimension::number, 0, any_value, "extension of segments"),
    unused(),
    integer("cparm8", 0, any_value, "beams"),
}};
const Card mpp_card2{{
    text("mark", 10, "& in column 1"),
    integer("chksegs", 0, any_value, "check of segments"),
    real("pensf", dimension::number, 1, any_value, "penalty scale"),
    integer("grpable", 0, any_value, "search method"),
}};

/// The first card; the name space of the ids of either side depends on its type.
Card sides_card(IdSpace a, IdSpace b) {
  return {{
      id("surfa", a, 0, "tracked side (SSID); 0 in a single surface contact: all parts"),
      id("surfb", b, 0, "reference side (MSID)"),
      integer("surfatyp", 0, between(0, 7),
              "0 segment set, 1 shell set, 2 part set, 3 part, 4 node set, 5 all, 6 all but a part set, 7 branch of "
              "parts (*SET_PART_TREE)"),
      integer("surfbtyp", 0, between(0, 7), "the same, without 4"),
      id("saboxid", IdSpace::define, 0, "only what lies in this box, of the tracked side"),
      id("sbboxid", IdSpace::define, 0, "only what lies in this box, of the reference side"),
      integer("sapr", 0, any_value, "forces of the tracked side in ncforc and intfor"),
      integer("sbpr", 0, any_value, "forces of the reference side in ncforc and intfor"),
  }};
}
const Card sides_of_sets = sides_card(IdSpace::set, IdSpace::set);
const Card sides_part_set = sides_card(IdSpace::part, IdSpace::set);
const Card sides_set_part = sides_card(IdSpace::set, IdSpace::part);
const Card sides_of_parts = sides_card(IdSpace::part, IdSpace::part);

const Card friction_card{{
    real("fs", dimension::number, 0, any_value, "static friction; -1: of *PART_CONTACT; ties have none"),
    real("fd", dimension::number, 0, any_value, "dynamic friction"),
    real("dc", dimension::number, 0, any_value, "decay from the static to the dynamic coefficient"),
    real("vc", dimension::stress, 0, any_value, "viscous friction"),
    real("vdc", dimension::number, 0, at_least(0), "damping, percent of critical"),
    integer("penchk", 0, any_value, "check of small penetrations; none in automatic contacts"),
    real("bt", dimension::time, 0, at_least(0), "the contact acts from this time on"),
    real("dt", dimension::time, forever, at_least(0), "until this time; 0: for ever"),
}};
const Card scale_card{{
    real("sfsa", dimension::number, 1, at_least(0), "scale of the tracked side's stiffness (SFS)"),
    real("sfsb", dimension::number, 1, at_least(0), "scale of the reference side's stiffness (SFM)"),
    real("sast", dimension::length, 0, any_value,
         "thickness of the tracked side (SST); ties: a negative value is the tolerance"),
    real("sbst", dimension::length, 0, any_value, "thickness of the reference side (MST)"),
    real("sfsat", dimension::number, 1, at_least(0), "scale of the tracked side's thickness (SFST)"),
    real("sfsbt", dimension::number, 1, at_least(0), "scale of the reference side's thickness (SFMT)"),
    real("fsf", dimension::number, 1, any_value, "scale of friction"),
    real("vsf", dimension::number, 1, any_value, "scale of viscous friction"),
}};
const Card card_a{{
    integer("soft", 0, any_value, "0 penalty by material, 1 by nodal masses and step, 2 by segment masses and step"),
    real("sofscl", dimension::number, 0.1, at_least(0), "scale of the stiffness with soft 1"),
    integer("lcidab", 0, any_value, "curve of airbag contact"),
    real("maxpar", dimension::number, 1.025, any_value, "extension of segments"),
    real("sbopt", dimension::number, 2, any_value, "soft 2: segments may be warped and hand contacts on in any case"),
    integer("depth", 2, any_value, "soft 2: from 3 on edges of shells too; else all pairs are found in any case"),
    integer("bsort", 0, any_value, "cycles between searches; 0: chosen by the program"),
    integer("frcfrq", 1, any_value, "cycles between forces; here each cycle"),
}};
const Card card_b{{
    real("penmax", dimension::number, 0, at_least(0), "a node deeper than so many thicknesses is let go; 0: never"),
    integer("thkopt", 0, any_value, "thickness option of contacts that are not automatic"),
    integer("shlthk", 0, any_value, "the same"),
    integer("snlog", 0, any_value, "nodes that penetrate far within a cycle"),
    integer("isym", 0, any_value, "symmetry planes"),
    integer("i2d3d", 0, any_value, "which elements give segments"),
    real("sldthk", dimension::length, 0, any_value, "thickness on solids"),
    real("sldstf", dimension::stress, 0, any_value, "stiffness on solids"),
}};
const Card card_c{{
    integer("igap", 1, any_value, "convergence of implicit runs"),
    integer("ignore", 0, between(0, 2),
            "initial penetrations: 0 by the control card, 1 tracked, 2 tracked and reported"),
    real("dprfac", dimension::number, 0, any_value, "depth of reports"),
    real("dtstif", dimension::time, 0, any_value,
         "step for which soft 1 and 2 find their stiffness; 0: that of the run"),
    real("edgek", dimension::number, 0, any_value, "stiffness of edges"),
    unused(),
    real("flangl", dimension::number, 0, any_value, "angle of feature lines"),
    id("cid_rcf", IdSpace::define, 0, "coordinate system of rcforc"),
}};
const Card card_d{{
    integer("q2tri", 0, any_value, "quadrilaterals as triangles"),
    real("dtpchk", dimension::length, 0, any_value, "time step check"),
    real("sfnbr", dimension::number, 0, any_value, "scale of neighbours"),
    real("fnlscl", dimension::number, 0, any_value, "scale of a nonlinear force"),
    real("dnlscl", dimension::number, 0, any_value, "distance of that force"),
    integer("tcso", 0, any_value, "thickness from the section"),
    integer("tiedid", 0, any_value, "incremental ties"),
    integer("shledg", 0, any_value, "shell edges"),
}};
const Card card_e{{
    integer("sharec", 0, any_value, "shared constraints"),
    integer("cparm8", 0, any_value, "beams"),
    integer("ipback", 0, any_value, "ties: not 0: springs where a node or its segment is constrained already"),
    integer("srnde", 0, any_value, "round edges of shells"),
    real("fricsf", dimension::number, 1, any_value, "scale of friction"),
    integer("icor", 0, any_value, "restitution"),
    integer("ftorq", 0, any_value, "moments of friction"),
    integer("region", 0, any_value, "region of contact"),
}};
const Card card_f{{
    integer("pstiff", 0, any_value, "how the stiffness is found"),
    integer("ignroff", 0, any_value, "thickness offsets"),
    unused(),
    real("fstol", dimension::number, 2, any_value, "tolerance of smoothing"),
    integer("2dbinr", 0, any_value, "two-dimensional binning"),
    integer("ssftyp", 0, any_value, "which scale holds"),
    integer("swtpr", 0, any_value, "use of thickness"),
    real("tetfac", dimension::number, 0, any_value, "stiffness of tetrahedra"),
}};

const Card eroding_card{{
    integer("isym", 0, any_value, "planes of symmetry: nothing to do here"),
    integer("erosop", 0, any_value, "faces that come to light take part in any case"),
    integer("iadj", 0, any_value, "faces between materials take part where the parts are all in the contact"),
}};

/// What SFLS and PARAM are depends on the option.
Card tiebreak_card_of(Field shear, Dimension parameter) {
  return {{
      integer("option", 0, any_value,
              "1: what touches sticks, also later; 3: until it fails; 2: what touches at the start is glued until it "
              "fails; 4: along the normal alone; 5: it yields, and fades by a curve; 6, 8: the stress falls to 0 at a "
              "distance; 7, 9, 10, 11: by an energy; 13, 14: it yields and softens as *MAT_240"),
      real("nfls", dimension::stress, 0, at_least(0),
           "normal stress at which it fails; 0: does not count; 5: at which it yields"),
      std::move(shear),
      real(
          "param", parameter, 0, any_value,
          "2: 1 leaves out thicknesses; 4: 1 makes SFLS friction; 6, 8: the distance (CCRIT); 7, 10: angle of friction "
          "[degrees]; 9, 11: exponent of mixed modes, negative: after Benzeggagh and Kenane; 13, 14: thickness"),
      real("eraten", Dimension{1, 0, -2}, 0, at_least(0), "7, 9, 10, 11: energy per area in tension"),
      real("erates", Dimension{1, 0, -2}, 0, at_least(0), "7, 9, 10, 11: energy per area in shear"),
      real("ct2cn", dimension::number, 1, above_zero(), "9, 11, 13, 14: stiffness in shear over that in tension"),
      real("cn", Dimension{1, -2, -2}, 0, at_least(0),
           "9, 11, 13, 14: stiffness in tension per area; 0: the penalty's"),
  }};
}
Field shear_strength() {
  return real("sfls", dimension::stress, 0, at_least(0),
              "shear stress at which it fails; 0: does not count; 4: of friction; 5: curve of the factor on NFLS over "
              "the opening");
}
const Card tiebreak_card = tiebreak_card_of(shear_strength(), dimension::number);
const Card tiebreak_by_length = tiebreak_card_of(shear_strength(), dimension::length);
const Card tiebreak_by_curve =
    tiebreak_card_of(id("sfls", IdSpace::function, 0, "curve: factor on NFLS over the opening"), dimension::number);

/// One mode of OPTION 13 and 14, in the words of *MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE.
Card tiebreak_mode_card(std::string_view energy, std::string_view fast_energy, std::string_view energy_rate,
                        std::string_view yield, std::string_view growth, std::string_view yield_rate,
                        std::string_view plateau, std::string_view curve) {
  constexpr Dimension energy_per_area{1, 0, -2}, rate{0, 0, -1};
  return {{
      real(energy, energy_per_area, 0, any_value, "energy per area; negative: at low rates"),
      real(fast_energy, energy_per_area, 0, any_value, "at high rates, where that is negative"),
      real(energy_rate, rate, 0, at_least(0), "rate that parts low from high"),
      real(yield, dimension::stress, 0, any_value, "yield stress; negative: at low rates"),
      real(growth, dimension::stress, 0, any_value,
           "its growth with the square of the logarithm of the rate; negative: with the logarithm"),
      real(yield_rate, rate, 0, at_least(0), "rate from which on it grows"),
      real(plateau, dimension::number, 0, any_value,
           "share of the plateau in the energy; negative: in the opening beyond the yield point"),
      integer(curve, 0, any_value, "curve of the energy over the thickness"),
  }};
}
const Card tiebreak_tension_card =
    tiebreak_mode_card("g1c_0", "g1c_inf", "edot_g1", "t0", "t1", "edot_t", "fg1", "lcg1c");
const Card tiebreak_shear_card =
    tiebreak_mode_card("g2c_0", "g2c_inf", "edot_g2", "s0", "s1", "edot_s", "fg2", "lcg2c");

/// The card of the older *CONTACT_TIEBREAK_NODES_...
const Card tiebreak_nodes_card{{
    real("nflf", dimension::force, 0, above_zero(), "normal force on a node at which it fails"),
    real("sflf", dimension::force, 0, above_zero(), "shear force on a node at which it fails"),
    real("nen", dimension::number, 2, above_zero(), "exponent of the normal force"),
    real("mes", dimension::number, 2, above_zero(), "exponent of the shear force"),
}};
/// And of *CONTACT_TIEBREAK_SURFACE_TO_SURFACE.
const Card tiebreak_surface_card{{
    real("nfls", dimension::stress, 0, above_zero(),
         "normal stress at which it fails; with TBLCID: at which it yields"),
    real("sfls", dimension::stress, 0, at_least(0), "shear stress at which it fails"),
    id("tblcid", IdSpace::function, 0, "curve: factor on the stress over the opening, as with OPTION 5"),
    integer("thkoff", 0, between(0, 1), "1: the thickness of shells counts"),
}};

// ---- sides
// -----------------------------------------------------------------------------------------------------------------

const Card& card_of_sides(const Cursor& cursor) {
  const bool a = cursor.peek_number(2) == 3.0, b = cursor.peek_number(3) == 3.0;
  return a ? (b ? sides_of_parts : sides_part_set) : (b ? sides_set_part : sides_of_sets);
}

void add_shells(const Model& model, const std::vector<Index>& shells, Surface& surface) {
  for (const Index shell : shells) surface.segments.push_back(model.shells.node[static_cast<std::size_t>(shell)]);
}

void take_all_but(const Builder& builder, const std::vector<Index>& exempt, Surface& surface) {
  for (std::size_t p = 0; p < builder.model.parts.size(); ++p)
    if (std::find(exempt.begin(), exempt.end(), static_cast<Index>(p)) == exempt.end())
      surface.parts.push_back(static_cast<Index>(p));
}

/// What a side's id and type stand for. Nothing but findings where the id is unknown.
Surface surface_of(Builder& builder, const Row& row, std::string_view field, std::string_view type_field) {
  Surface surface;
  switch (row.integer(type_field)) {
    case 0:
      if (const auto* set = builder.segment_set(row, field)) surface.segments = set->members;
      break;
    case 1:
      if (const auto* set = builder.shell_set(row, field)) add_shells(builder.model, set->members, surface);
      break;
    case 2:
      if (row.integer(field) == 0)
        surface.everything = true;
      else if (const auto* set = builder.part_set(row, field))
        surface.parts = set->members;
      break;
    case 3:
      if (const Index part = builder.part(row, field); part != none) surface.parts = {part};
      break;
    case 4:
      if (const auto* set = builder.node_set(row, field)) surface.nodes = set->members;
      break;
    case 5: surface.everything = true; break;
    case 6:
      if (const auto* set = builder.part_set(row, field)) take_all_but(builder, set->members, surface);
      break;
    case 7:
      if (const auto* branch = builder.branch(row, field)) surface.parts = branch->members;
      break;
    default: break;
  }
  return surface;
}

void take_box(Builder& builder, const Row& row, std::string_view field, Surface& surface) {
  const Box* box = builder.box(row, field);
  if (box == nullptr) return;
  surface.boxed = true;
  surface.box_low = box->low;
  surface.box_high = box->high;
}

void take_boxes(Builder& builder, const Row& row, Contact& contact) {
  for (const std::string_view field : {"saboxid", "sbboxid"})
    if (row.integer(field) < 0)
      refuse(builder, row, field, "a box that moves on is not built; expected the id of a *DEFINE_BOX",
             "give the id without its sign: what lies in the box at the start takes part");
  take_box(builder, row, "saboxid", contact.a);
  take_box(builder, row, "sbboxid", contact.b);
}

void take_single_surface(Builder& builder, const Row& row, Contact& contact) {
  if (row.integer("surfatyp") == 4)
    return refuse(builder, row, "surfatyp", "a single surface has no node set for a side",
                  "name parts, shells or segments");
  if (row.integer("surfa") == 0)
    contact.a.everything = true;
  else
    contact.a = surface_of(builder, row, "surfa", "surfatyp");
}

/// Both sides of a contact of two surfaces; a tracked side may be a set of nodes where only its nodes are looked at.
void take_two_sides(Builder& builder, const Row& row, Contact& contact) {
  if (row.integer("surfatyp") == 4 && contact.kind == Kind::two_surfaces)
    refuse(builder, row, "surfatyp", "a set of nodes has no segments for the nodes of the other side",
           "use *CONTACT_AUTOMATIC_NODES_TO_SURFACE");
  if (row.integer("surfbtyp") == 4)
    refuse(builder, row, "surfbtyp", "the reference side needs segments", "name parts, shells or a segment set");
  contact.a = surface_of(builder, row, "surfa", "surfatyp");
  contact.b = surface_of(builder, row, "surfb", "surfbtyp");
}

void take_transducer(Builder& builder, const Row& row, Contact& contact) {
  if (row.integer("surfb") != 0)
    refuse(builder, row, "surfb", "forces between two sides alone are not built; expected 0",
           "give one transducer a side, or read the contact's own rows in rcforc");
  contact.a = surface_of(builder, row, "surfa", "surfatyp");
}

void take_tie(Builder& builder, const Row& row, Contact& contact) {
  if (row.integer("surfbtyp") == 4)
    return refuse(builder, row, "surfbtyp", "the reference side of a tie needs segments",
                  "name parts, shells or a segment set");
  for (const auto& [field, type] : {std::pair{"surfa", "surfatyp"}, std::pair{"surfb", "surfbtyp"}})
    if (row.integer(field) == 0 && row.integer(type) != 5 && row.integer(type) != 2)
      refuse(builder, row, field, "must be given", "name what is tied, and to what");
  contact.a = surface_of(builder, row, "surfa", "surfatyp");
  contact.b = surface_of(builder, row, "surfb", "surfbtyp");
}

// ---- the cards that always stand
// --------------------------------------------------------------------------------------------

void take_friction(Builder& builder, const Row& row, Contact& contact) {
  contact.friction_by_part = contact.slides() && row.real("fs") == -1.0;
  if (contact.slides() && !contact.friction_by_part)
    for (const std::string_view field : {"fs", "fd", "dc", "vc"})
      if (row.real(field) < 0.0)
        refuse(builder, row, field, "friction by table or function is not built; expected 0 or more, or FS = -1",
               "give the coefficients here, or in *PART_CONTACT with FS = -1");
  if (contact.slides() && row.real("fs") == 2.0)
    row.complain(builder.findings, Severity::warning, "fs",
                 "is taken as a coefficient; LS-DYNA reads 2 as friction from a table", "give 1.99 or 2.01");
  contact.friction = {row.real("fs"), row.real("fd"), row.real("dc"), row.real("vc")};
  if (contact.friction_by_part) contact.friction = {1.0, 1.0, 0.0, 1.0};
  if (contact.friction_by_part && checks_edges(contact))
    row.complain(builder.findings, Severity::warning, "fs",
                 "friction of the parts acts on nodes against segments; edges slide on each other without",
                 "give FS and FD here if edges are to rub");
  contact.damping = row.real("vdc");
  contact.birth = row.real("bt");
  contact.death = death_time(row.real("dt"));
  if (contact.tie_by_springs())
    expect(builder, row, Severity::warning, {{"vdc", 0, "the springs of a tie have no damping here"}});
}

void take_scales(Builder& builder, const Row& row, Contact& contact) {
  if (contact.slides())
    for (const std::string_view field : {"sast", "sbst"})
      if (row.real(field) < 0.0)
        refuse(builder, row, field, "a negative thickness has a meaning for ties alone; expected 0 or more",
               "leave it 0 for the thickness of the shells");
  contact.stiffness_scale_a = row.real("sfsa");
  contact.stiffness_scale_b = row.real("sfsb");
  contact.thickness_a = row.real("sast");
  contact.thickness_b = row.real("sbst");
  contact.thickness_scale_a = row.real("sfsat");
  contact.thickness_scale_b = row.real("sfsbt");
  contact.friction.at_rest *= row.real("fsf");
  contact.friction.sliding *= row.real("fsf");
  contact.friction.shear_strength *= row.real("vsf");
}

bool by_length(double option) {
  return option == 6.0 || option == 8.0 || option == 13.0 || option == 14.0;
}

const Card& card_of_glue(const Cursor& cursor) {
  const auto option = cursor.peek_number(0);
  if (option == 5.0) return tiebreak_by_curve;
  return by_length(option) ? tiebreak_by_length : tiebreak_card;
}

/// Fields without which an option of the glue has no meaning.
void demand(Builder& builder, const Row& row, std::initializer_list<std::string_view> fields) {
  for (const std::string_view field : fields)
    if (row.real(field) == 0.0)
      refuse(builder, row, field, fmt::format("must be given with OPTION {}", row.integer("option")),
             "give it, or use OPTION 2, which needs NFLS and SFLS alone");
}

/// Fields that an option does not look at, in LS-DYNA neither.
void tell_idle(Builder& builder, const Row& row, std::initializer_list<std::string_view> fields) {
  for (const std::string_view field : fields)
    if (row.real(field) != 0.0)
      row.complain(builder.findings, Severity::note, field,
                   fmt::format("is not looked at with OPTION {}", row.integer("option")), {});
}

void take_strengths(const Row& row, kernel::Cohesion& law) {
  law.normal_strength = row.real("nfls");
  law.shear_strength = row.real("sfls");
}

/// OPTION 2, 3: fails at once.
void take_brittle(const Row& row, Contact& contact) {
  take_strengths(row, contact.glue->law);
}

void take_thickness_switch(Builder& builder, const Row& row, Contact& contact) {
  const double param = row.real("param");
  if (param != 0.0 && param != 1.0)
    refuse(builder, row, "param", "expected 0, or 1 to leave out the thickness of shells", "give 0 or 1");
  contact.glue->without_thickness = param == 1.0;
}

/// OPTION 4.
void take_sliding(Builder& builder, const Row& row, Contact& contact) {
  const double param = row.real("param");
  if (param != 0.0 && param != 1.0)
    refuse(builder, row, "param", "expected 0, or 1 to make SFLS the stress of friction", "give 0 or 1");
  contact.glue->slides = true;
  contact.glue->law.normal_strength = row.real("nfls");
  if (param == 1.0) {
    demand(builder, row, {"sfls"});
    contact.glue->slip_stress = row.real("sfls");
  } else if (row.real("sfls") != 0.0) {
    row.complain(builder.findings, Severity::note, "sfls", "is looked at with PARAM = 1 alone", {});
  }
}

/// OPTION 6, 8.
void take_distance(Builder& builder, const Row& row, Contact& contact) {
  kernel::Cohesion& law = contact.glue->law;
  take_strengths(row, law);
  demand(builder, row, {"param"});
  law.softening = kernel::Cohesion::Softening::to_distance;
  law.distance = row.real("param");
  if (law.distance < 0.0) refuse(builder, row, "param", "expected a distance", "give CCRIT, 0 or more");
}

/// OPTION 7, 10 and 9, 11.
void take_energies(Builder& builder, const Row& row, Contact& contact) {
  kernel::Cohesion& law = contact.glue->law;
  take_strengths(row, law);
  demand(builder, row, {"nfls", "sfls", "eraten", "erates"});
  law.softening = kernel::Cohesion::Softening::by_energy;
  law.normal_energy = row.real("eraten");
  law.shear_energy = row.real("erates");
  const int option = row.integer("option");
  if (option == 7 || option == 10) {
    const double angle = row.real("param");
    if (!(angle >= 0.0) || !(angle < 90.0))
      refuse(builder, row, "param", "expected the angle of friction, 0 to 90 degrees", "give 0 for none");
    law.pressure_share = std::sin(angle * std::numbers::pi / 180.0);
    return;
  }
  demand(builder, row, {"param"});
  law.exponent = row.real("param");
  law.normal_stiffness = row.real("cn");
  law.shear_ratio = row.real("ct2cn");
}

kernel::ElastoplasticMode elastoplastic_mode(Builder& builder, const Row& row, std::array<std::string_view, 8> field) {
  const auto value = [&](std::size_t i) { return row.real(field[i]); };
  const auto required = [&](std::size_t i, const char* why) {
    if (value(i) == 0.0) refuse(builder, row, field[i], why, "give it");
  };
  kernel::ElastoplasticMode mode;
  required(0, "must be given with OPTION 13 and 14");
  required(3, "must be given with OPTION 13 and 14");
  mode.energy = std::abs(value(0));
  mode.yield = std::abs(value(3));
  mode.plateau = value(6);
  if (value(0) < 0.0) {
    required(1, "must be given where the energy depends on the rate");
    required(2, "must be given where the energy depends on the rate");
    mode.fast_energy = std::abs(value(1));
    mode.energy_rate = value(2);
  }
  if (value(3) < 0.0) {
    required(5, "must be given where the yield stress depends on the rate");
    mode.yield_growth = value(4);
    mode.yield_rate = value(5);
  }
  if (!(std::abs(mode.plateau) < 1.0))
    refuse(builder, row, field[6], "expected a share, between -1 and 1", "0 is glue without a plateau");
  if (row.integer(field[7]) != 0)
    refuse(builder, row, field[7], "an energy by the thickness of the layer is not built; expected 0",
           "read the energy off the curve at the thickness that PARAM gives");
  return mode;
}

/// OPTION 13, 14.
void take_layer(Builder& builder, Cursor& cursor, const Row& row, Contact& contact) {
  kernel::Cohesion& law = contact.glue->law;
  law.softening = kernel::Cohesion::Softening::elastoplastic;
  law.thickness = row.real("param");
  law.normal_stiffness = row.real("cn");
  law.shear_ratio = row.real("ct2cn");
  if (law.thickness < 0.0)
    refuse(builder, row, "param", "rates that are filtered (a negative thickness and card 4.2c) are not built",
           "give the thickness without its sign and leave out that card");
  const Row tension = cursor.read(tiebreak_tension_card);
  law.tension =
      elastoplastic_mode(builder, tension, {"g1c_0", "g1c_inf", "edot_g1", "t0", "t1", "edot_t", "fg1", "lcg1c"});
  const Row shear = cursor.read(tiebreak_shear_card);
  law.shear = elastoplastic_mode(builder, shear, {"g2c_0", "g2c_inf", "edot_g2", "s0", "s1", "edot_s", "fg2", "lcg2c"});
  const bool by_rate =
      law.tension.yield_rate + law.tension.energy_rate + law.shear.yield_rate + law.shear.energy_rate > 0.0;
  if (by_rate && law.thickness == 0.0)
    refuse(builder, row, "param", "the thickness makes a strain rate of a speed and must be given here",
           "give it, or stresses and energies that do not depend on the rate");
  tell_idle(builder, row, {"nfls", "sfls", "eraten", "erates"});
}

void take_glue(Builder& builder, Cursor& cursor, const Row& row, Contact& contact) {
  contact.glue.emplace();
  switch (row.integer("option")) {
    case 1:
      contact.glue->sticks_later = true;
      tell_idle(builder, row, {"nfls", "sfls", "eraten", "erates"});
      break;
    case 2:
      take_brittle(row, contact);
      take_thickness_switch(builder, row, contact);
      break;
    case 3:
      take_brittle(row, contact);
      contact.glue->sticks_later = true;
      break;
    case 4: take_sliding(builder, row, contact); break;
    case 5:
      demand(builder, row, {"nfls"});
      contact.glue->law.normal_strength = row.real("nfls");
      break;
    case 6:
    case 8: take_distance(builder, row, contact); break;
    case 7:
    case 9:
    case 10:
    case 11: take_energies(builder, row, contact); break;
    case 13:
    case 14: take_layer(builder, cursor, row, contact); break;
    case -1:
    case -2:
    case -3:
      refuse(builder, row, "option", "glue that hands over moments is not built; expected 1 to 11, 13 or 14",
             "give the option without its sign: the force then acts without the lever of the gap");
      break;
    default:
      refuse(builder, row, "option", "expected 1 to 11, 13 or 14",
             "2 fails at once, 6 and 8 give way up to a distance, 9 and 11 up to an energy");
  }
}

/// *CONTACT_TIEBREAK_NODES_TO_SURFACE and _NODES_ONLY.
void take_glue_of_nodes(const Row& row, Contact& contact) {
  Glue& glue = contact.glue.emplace();
  glue.by_force = true;
  glue.without_thickness = true;
  glue.law.normal_strength = row.real("nflf");
  glue.law.shear_strength = row.real("sflf");
  glue.law.normal_exponent = row.real("nen");
  glue.law.shear_exponent = row.real("mes");
}

/// *CONTACT_TIEBREAK_SURFACE_TO_SURFACE.
void take_glue_of_surfaces(Builder& builder, const Row& row, Contact& contact) {
  Glue& glue = contact.glue.emplace();
  glue.without_thickness = row.integer("thkoff") == 0;
  glue.law.normal_strength = row.real("nfls");
  if (row.integer("tblcid") == 0) {
    glue.law.shear_strength = row.real("sfls");
    if (glue.law.shear_strength == 0.0)
      refuse(builder, row, "sfls", "must be given where there is no TBLCID", "give a large number for no failure");
  } else if (row.real("sfls") != 0.0) {
    row.complain(builder.findings, Severity::note, "sfls",
                 "is not looked at with TBLCID: the glue yields in shear at NFLS over the root of 3", {});
  }
}

/// The curve of OPTION 5, and TBLCID: a factor on the yield stress, or that stress itself.
void take_resistance(Builder& builder, const Row& row, std::string_view field, Contact& contact) {
  const Index c = builder.curve(row, field);
  if (c == none) {
    if (row.integer(field) == 0)
      refuse(builder, row, field, "must be the curve of the stress over the opening with OPTION 5",
             "give the id of a *DEFINE_CURVE that begins with 1 and ends with 0");
    return;
  }
  kernel::Cohesion& law = contact.glue->law;
  law.softening = kernel::Cohesion::Softening::by_curve;
  law.resistance = builder.model.curves[static_cast<std::size_t>(c)];
  const double first = law.resistance.clamped(0.0);
  const auto is = [first](double level) { return std::abs(first - level) <= 1e-6 * level; };
  if (!is(1.0) && !is(law.normal_strength))
    refuse(
        builder, row, field,
        fmt::format("the curve is {:g} where nothing has opened; expected 1 (a factor on NFLS) or NFLS itself", first),
        "scale the curve");
  if (std::any_of(law.resistance.y.begin(), law.resistance.y.end(), [](double y) { return y < 0.0; }))
    refuse(builder, row, field, "the curve has negative ordinates", "end it with 0");
  if (law.resistance.y.back() > 0.0)
    row.complain(builder.findings, Severity::warning, field, "the curve does not end with 0: this glue never fails",
                 "end it with 0 at the opening where nothing holds any more");
  if (first > 0.0)
    for (double& y : law.resistance.y) y /= first;
}

// ---- optional cards A to F
// ---------------------------------------------------------------------------------------------------

constexpr std::string_view left = "not built: runs as with the default";

void take_a(Builder& builder, const Row& row, Contact& contact) {
  contact.soft = row.integer("soft");
  contact.soft_scale = row.real("sofscl");
  contact.search_interval = std::max(0, row.integer("bsort"));
  if (contact.tie()) return;  // of these fields none acts on a constraint
  contact.depth = row.integer("depth");
  if (contact.soft == 2 && contact.keyword.find("NODES_TO_SURFACE") != std::string::npos) {
    row.complain(builder.findings, Severity::warning, "soft",
                 "a contact of nodes has no segments on one side; it runs as with soft = 1",
                 "use a contact of surfaces for segment-based contact");
    contact.soft = 1;
  }
  if (contact.soft < 0 || contact.soft > 2)
    refuse(builder, row, "soft", "this form of the penalty is not built; expected 0, 1 or 2",
           "use 2 for segment-based contact");
  expect(builder, row, Severity::error, {{"lcidab", 0, "airbag contact is not built"}});
}

void take_b(Builder& builder, const Row& row, Contact& contact) {
  if (contact.tie()) return;
  expect(builder, row, Severity::error,
         {{"sldthk", 0, "a contact thickness on solids is not built"},
          {"sldstf", 0, "a contact stiffness on solids is not built"}});
  expect(builder, row, Severity::warning, {{"snlog", 0, left}, {"isym", 0, left}, {"i2d3d", 0, left}});
  contact.deepest = row.real("penmax");
}

void take_c(Builder& builder, const Row& row, Contact& contact) {
  contact.ignore = row.integer("ignore");
  if (contact.tie()) return;
  contact.soft_step = row.real("dtstif");
  if (contact.soft_step < 0.0)
    refuse(builder, row, "dtstif", "a step by a curve or by a running mean is not built; expected 0 or a step",
           "leave it 0 for the step of the run, or give the step");
  expect(builder, row, Severity::warning,
         {{"edgek", 0, left}, {"flangl", 0, left}, {"cid_rcf", 0, "forces are written in global axes"}});
}

void take_d(Builder& builder, const Row& row, const Contact& contact) {
  if (contact.tie())
    expect(builder, row, Severity::error, {{"tiedid", 0, "incremental ties are not built"}});
  else
    expect(builder, row, Severity::warning,
           {{"q2tri", 0, left},
            {"dtpchk", 0, left},
            {"sfnbr", 0, left},
            {"fnlscl", 0, left},
            {"dnlscl", 0, left},
            {"tcso", 0, left},
            {"shledg", 0, left}});
}

void take_e(Builder& builder, const Row& row, Contact& contact) {
  if (contact.tie()) {
    contact.penalty_fallback = row.integer("ipback") != 0;
    return;
  }
  contact.friction.at_rest *= row.real("fricsf");
  contact.friction.sliding *= row.real("fricsf");
  expect(builder, row, Severity::warning,
         {{"srnde", 0, left}, {"icor", 0, left}, {"ftorq", 0, left}, {"region", 0, left}});
}

void take_f(Builder& builder, const Row& row, const Contact& contact) {
  if (contact.tie()) return;
  expect(builder, row, Severity::warning,
         {{"pstiff", 0, left}, {"ignroff", 0, left}, {"ssftyp", 0, left}, {"swtpr", 0, left}, {"tetfac", 0, left}});
}

void take_optional_cards(Builder& builder, Cursor& cursor, Contact& contact) {
  if (cursor.more()) take_a(builder, cursor.read(card_a), contact);
  if (cursor.more()) take_b(builder, cursor.read(card_b), contact);
  if (cursor.more()) take_c(builder, cursor.read(card_c), contact);
  if (cursor.more()) take_d(builder, cursor.read(card_d), contact);
  if (cursor.more()) take_e(builder, cursor.read(card_e), contact);
  if (cursor.more()) take_f(builder, cursor.read(card_f), contact);
  if (cursor.more())
    builder.findings.error(cursor.place(), '*' + contact.keyword,
                           "has more data lines than its optional cards A to F; a card G is not built",
                           "leave it out: none of its fields is read");
}

// ---- reader
// --------------------------------------------------------------------------------------------------------------------

/// The cards of the distributed-memory version are read past, as LS-DYNA's shared-memory version does.
void skip_mpp(Cursor& cursor, const Options& options) {
  if (!options.contains("MPP")) return;
  cursor.read(mpp_card1);
  if (cursor.peek().starts_with('&')) cursor.read(mpp_card2);
}

/// The forms of a tie that its keyword names.
void take_form(Builder& builder, const Block& block, const Options& options, Contact& contact) {
  using Offset = Contact::Offset;
  int offsets = 0;
  for (const auto& [name, offset] :
       {std::pair{"OFFSET", Offset::penalty}, std::pair{"BEAM_OFFSET", Offset::beam},
        std::pair{"CONSTRAINED_OFFSET", Offset::constrained}, std::pair{"PENALTY", Offset::beam},
        std::pair{"WITH_TORSION_PENALTY", Offset::beam}}) {
    if (!options.contains(name)) continue;
    contact.offset = offset;
    ++offsets;
  }
  contact.torsion = options.contains("WITH_TORSION") || options.contains("WITH_TORSION_PENALTY");
  if (offsets > 1)
    builder.findings.error(block.place, '*' + block.keyword, "says twice how the gap is to be kept",
                           "keep one of _OFFSET, _BEAM_OFFSET, _CONSTRAINED_OFFSET, _PENALTY");
}

void judge_mortar(Builder& builder, const Block& block, const Options& options) {
  if (options.contains("MORTAR"))
    builder.findings.warning(block.place, '*' + block.keyword,
                             "segments are not integrated against segments as mortar contact does: this one presses "
                             "nodes against segments",
                             "expect forces that are less smooth over coarse meshes");
}

/// The oriented forms of earlier releases. Their segments have one face each, which the automatic forms do not need to
/// know; those of two surfaces leave the thickness of sheets out unless SHLTHK or THKOPT asks for it.
void judge_oriented(Builder& builder, const Block& block, const Contact& contact) {
  if (!contact.slides() || block.keyword.starts_with("CONTACT_AUTOMATIC") || erodes(contact)) return;
  if (block.keyword.find("_ONLY") != std::string::npos) return;  // glue alone: nothing slides
  const bool single = contact.kind == Kind::single_surface;
  builder.findings.warning(
      block.place, '*' + block.keyword,
      single
          ? "computed as *CONTACT_AUTOMATIC_SINGLE_SURFACE: both faces of a sheet press, not that of its normal alone"
          : "computed as the _AUTOMATIC form: both faces of a sheet press, and at half its thickness in any case "
            "(this form: one face, and the thickness with SHLTHK 1 or 2 alone)",
      single ? "write the automatic form"
             : "write the automatic form; where sheets were meshed closer than their thickness, IGNORE = 1 keeps them "
               "in place");
}

/// The card of glue, if the keyword has one.
std::optional<Row> read_glue(Builder& builder, Cursor& cursor, const Options& options, Contact& contact) {
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_NODES")) {
    const Row row = cursor.read(tiebreak_nodes_card);
    take_glue_of_nodes(row, contact);
    contact.glue->alone = contact.keyword.starts_with("CONTACT_TIEBREAK_NODES_ONLY");
    return row;
  }
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_SURFACE")) {
    const Row row = cursor.read(tiebreak_surface_card);
    take_glue_of_surfaces(builder, row, contact);
    contact.glue->alone = contact.keyword.find("_ONLY") != std::string::npos;
    return row;
  }
  if (!options.contains("TIEBREAK")) return std::nullopt;
  const Row row = cursor.read(card_of_glue(cursor));
  take_glue(builder, cursor, row, contact);
  return row;
}

/// What of the glue needs the curves.
void finish_glue(Builder& builder, const Row& row, Contact& contact) {
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_NODES")) return;
  if (contact.keyword.starts_with("CONTACT_TIEBREAK_SURFACE")) {
    if (row.integer("tblcid") != 0) take_resistance(builder, row, "tblcid", contact);
  } else if (row.integer("option") == 5) {
    take_resistance(builder, row, "sfls", contact);
  }
}

template <Kind kind>
void read_contact(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  Contact contact;
  contact.kind = kind;
  contact.keyword = block.keyword;
  contact.place = block.place;
  take_form(builder, block, options, contact);
  judge_mortar(builder, block, options);
  judge_oriented(builder, block, contact);
  const Heading heading = read_heading(cursor, options.contains("ID") || options.contains("TITLE"));
  contact.id = heading.id;
  contact.title = heading.text;
  skip_mpp(cursor, options);
  const Row sides = cursor.read(card_of_sides(cursor));
  if (!contact.slides())
    expect(builder, sides, Severity::error,
           {{"saboxid", 0, "a box around a side of a tie or a transducer is not built"},
            {"sbboxid", 0, "a box around a side of a tie or a transducer is not built"}});
  take_friction(builder, cursor.read(friction_card), contact);
  take_scales(builder, cursor.read(scale_card), contact);
  if (erodes(contact) && cursor.more()) cursor.read(eroding_card);
  const std::optional<Row> glue = read_glue(builder, cursor, options, contact);
  take_optional_cards(builder, cursor, contact);
  builder.later(Phase::conditions, [sides, glue, contact = std::move(contact)](Builder& b) mutable {
    if (kind == Kind::single_surface)
      take_single_surface(b, sides, contact);
    else if (contact.slides())
      take_two_sides(b, sides, contact);
    else if (kind == Kind::transducer)
      take_transducer(b, sides, contact);
    else
      take_tie(b, sides, contact);
    if (contact.slides()) take_boxes(b, sides, contact);
    if (glue) finish_glue(b, *glue, contact);
    if (contact.ignore == 0) contact.ignore = b.model.control.ignore_penetration;
    // Where thicknesses are left out sheets may be meshed at any distance: their nodes stay where they are.
    if (contact.ignore == 0 && contact.glue && contact.glue->without_thickness) contact.ignore = 1;
    if (contact.id == 0) contact.id = static_cast<int>(b.model.contacts.size()) + 1;
    b.model.contacts.push_back(std::move(contact));
  });
}

template <Kind kind>
Keyword contact_keyword(std::string_view name, std::vector<std::string_view> forms = {}) {
  forms.insert(forms.end(), {"ID", "TITLE", "MPP"});
  const bool glued = std::find(forms.begin(), forms.end(), "TIEBREAK") != forms.end();
  std::vector<LayoutCard> layout{{"with _ID or _TITLE", &heading_card},
                                 {"with _MPP; read past", &mpp_card1},
                                 {"with _MPP, if it begins with &; read past", &mpp_card2},
                                 {{}, &sides_of_sets},
                                 {{}, &friction_card},
                                 {{}, &scale_card}};
  if (name.starts_with("CONTACT_ERODING")) layout.push_back({{}, &eroding_card});
  if (glued)
    layout.insert(layout.end(), {{"with _TIEBREAK", &tiebreak_card},
                                 {"with _TIEBREAK, OPTION 13 and 14", &tiebreak_tension_card},
                                 {"with _TIEBREAK, OPTION 13 and 14", &tiebreak_shear_card}});
  if (name.starts_with("CONTACT_TIEBREAK_NODES")) layout.push_back({{}, &tiebreak_nodes_card});
  if (name.starts_with("CONTACT_TIEBREAK_SURFACE")) layout.push_back({{}, &tiebreak_surface_card});
  layout.insert(layout.end(), {{"optional card A", &card_a},
                               {"optional card B", &card_b},
                               {"optional card C", &card_c},
                               {"optional card D", &card_d},
                               {"optional card E", &card_e},
                               {"optional card F", &card_f}});
  return {name, {}, std::move(forms), Verdict::used, {}, std::move(layout), read_contact<kind>};
}

Keyword refused(std::string_view name, std::string_view why) {
  return {name, {}, {"ID", "TITLE", "MPP"}, Verdict::refused, why, {}, nullptr};
}

const Card interior_card{{
    id("psid", IdSpace::set, required,
       "set of parts; its attributes: DA1 = PSF (1), DA2 = Fa (0.1), DA3 = ED, DA4 = TYPE (1, 2: the same here)"),
}};

void read_interior(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  const Heading heading = read_heading(cursor, options.contains("ID") || options.contains("TITLE"));
  const Row row = cursor.read(interior_card);
  expect_end(builder, cursor);
  builder.later(Phase::conditions, [row, heading, place = block.place](Builder& b) {
    const auto* set = b.part_set(row, "psid");
    if (!set) return;
    const auto [scale, activation, modulus, type] = set->attributes;
    if (scale < 0.0 || activation < 0.0 || activation >= 1.0 || modulus < 0.0 || type < 0.0 || type > 2.0)
      return refuse(
          b, row, "psid",
          fmt::format("attributes {:g}, {:g}, {:g}, {:g} of part set {}: expected PSF and ED of 0 or more, Fa "
                      "below 1, TYPE 0 to 2",
                      scale, activation, modulus, type, set->id),
          "set DA1 to DA4 of the set");
    InteriorContact contact;
    contact.id =
        heading.id != 0 ? heading.id : static_cast<int>(b.model.contacts.size() + b.model.interiors.size()) + 1;
    contact.title = heading.text;
    contact.parts = set->members;
    if (scale > 0.0) contact.scale = scale;
    if (activation > 0.0) contact.activation = activation;
    contact.modulus = modulus;
    contact.place = place;
    b.model.interiors.push_back(std::move(contact));
  });
}

constexpr const char* other_tie_of_translations =
    "this form is not built; ties of translations only have _OFFSET and _CONSTRAINED_OFFSET (_BEAM_OFFSET is for shell "
    "edges and spot welds; ties that fail are not built)";

}  // namespace

std::vector<Keyword> contact_keywords() {
  return {
      contact_keyword<Kind::single_surface>("CONTACT_AUTOMATIC_SINGLE_SURFACE", {"MORTAR"}),
      contact_keyword<Kind::two_surfaces>("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", {"TIEBREAK", "MORTAR"}),
      contact_keyword<Kind::one_way>("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", {"TIEBREAK"}),
      contact_keyword<Kind::one_way>("CONTACT_AUTOMATIC_NODES_TO_SURFACE"),
      contact_keyword<Kind::single_surface>("CONTACT_AUTOMATIC_GENERAL", {"INTERIOR"}),
      contact_keyword<Kind::single_surface>("CONTACT_SINGLE_SURFACE"),
      contact_keyword<Kind::two_surfaces>("CONTACT_SURFACE_TO_SURFACE"),
      contact_keyword<Kind::one_way>("CONTACT_ONE_WAY_SURFACE_TO_SURFACE"),
      contact_keyword<Kind::one_way>("CONTACT_NODES_TO_SURFACE"),
      contact_keyword<Kind::single_surface>("CONTACT_ERODING_SINGLE_SURFACE"),
      contact_keyword<Kind::two_surfaces>("CONTACT_ERODING_SURFACE_TO_SURFACE"),
      contact_keyword<Kind::one_way>("CONTACT_ERODING_NODES_TO_SURFACE"),
      contact_keyword<Kind::one_way>("CONTACT_TIEBREAK_NODES_TO_SURFACE"),
      contact_keyword<Kind::one_way>("CONTACT_TIEBREAK_NODES_ONLY"),
      contact_keyword<Kind::two_surfaces>("CONTACT_TIEBREAK_SURFACE_TO_SURFACE", {"ONLY"}),
      contact_keyword<Kind::transducer>("CONTACT_FORCE_TRANSDUCER"),
      contact_keyword<Kind::transducer>("CONTACT_FORCE_TRANSDUCER_PENALTY"),
      contact_keyword<Kind::spotweld>("CONTACT_SPOTWELD", {"WITH_TORSION", "WITH_TORSION_PENALTY", "PENALTY", "OFFSET",
                                                           "BEAM_OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<Kind::tied_nodes>("CONTACT_TIED_NODES_TO_SURFACE", {"OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<Kind::tied_surface>("CONTACT_TIED_SURFACE_TO_SURFACE", {"OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<Kind::tied_shell_edge>("CONTACT_TIED_SHELL_EDGE_TO_SURFACE",
                                             {"OFFSET", "BEAM_OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<Kind::tied_shell_edge_to_solid>("CONTACT_TIED_SHELL_EDGE_TO_SOLID"),

      refused("CONTACT_SPOTWELD_*", "this form of the weld tie is not built; use *CONTACT_SPOTWELD"),
      refused("CONTACT_TIED_NODES_TO_SURFACE_*", other_tie_of_translations),
      refused("CONTACT_TIED_SURFACE_TO_SURFACE_*", other_tie_of_translations),
      refused(
          "CONTACT_TIED_SHELL_EDGE_TO_SURFACE_*",
          "this form is not built; _OFFSET, _BEAM_OFFSET, _CONSTRAINED_OFFSET and the plain one are (ties that fail "
          "are not)"),
      refused("CONTACT_TIED_*",
              "this tie is not built; *CONTACT_SPOTWELD, *CONTACT_TIED_NODES_TO_SURFACE, "
              "*CONTACT_TIED_SURFACE_TO_SURFACE, *CONTACT_TIED_SHELL_EDGE_TO_SURFACE and ..._TO_SOLID are"),
      refused("CONTACT_AUTOMATIC_SINGLE_SURFACE_*", "this form is not built; use *CONTACT_AUTOMATIC_SINGLE_SURFACE"),
      refused("CONTACT_AUTOMATIC_GENERAL_*",
              "this form is not built; *CONTACT_AUTOMATIC_GENERAL and *CONTACT_AUTOMATIC_GENERAL_INTERIOR are"),
      refused("CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK*",
              "glue is built between two surfaces; use *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK"),
      refused("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_*", "this form is not built; use it without the last word"),
      refused("CONTACT_FORCE_TRANSDUCER_*", "this transducer is not built; *CONTACT_FORCE_TRANSDUCER_PENALTY is"),
      {"CONTACT_INTERIOR",
       {},
       {"ID", "TITLE"},
       Verdict::used,
       {},
       {{"with _ID or _TITLE", &heading_card}, {{}, &interior_card}},
       read_interior},
      refused("CONTACT_ERODING_*",
              "this form is not built; *CONTACT_ERODING_SINGLE_SURFACE, _SURFACE_TO_SURFACE and _NODES_TO_SURFACE "
              "are"),
      refused("CONTACT_RIGID*", "contact of rigid bodies by force curves is not built"),
      refused("CONTACT_2D*", "contact in two dimensions is not built"),
      refused("CONTACT_*",
              "this contact is not built; *CONTACT_AUTOMATIC_SINGLE_SURFACE, _SURFACE_TO_SURFACE, _NODES_TO_SURFACE, "
              "_GENERAL, the eroding ones, *CONTACT_SPOTWELD and *CONTACT_TIED_... are (`nugget keywords CONTACT`)"),
  };
}

}  // namespace nugget::model
