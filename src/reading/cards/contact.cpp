// SPDX-License-Identifier: Apache-2.0
// *CONTACT_...: the penalty contact and the ties that are built, and by name those that are not.
#include <fmt/format.h>

#include "model/contact_form.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/contact_glue.hpp"
#include "reading/cards/contact_interior.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/friction.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using Kind = Contact::Kind;

const Card mpp_card1{{
    integer("ignore", 0, any_value, "1, 2: as on card C, where that is 0; others are not built"),
    integer("bckt", 200, any_value, "search interval"),
    integer("lcbckt", 0, any_value, "curve of that interval"),
    integer("ns2trk", 3, any_value, "contacts tracked a node"),
    integer("inititr", 2, any_value, "iterations for initial penetrations"),
    real("parmax", dimension::number, 0, any_value, "extension of segments"),
    unused(),
    integer("cparm8", 0, any_value,
            "_GENERAL: 1 beams of one part do not press each other; 2 and weld beams take part"),
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
      or_negative(id("saboxid", IdSpace::define, 0, "only what lies in this box, of the tracked side"),
                  IdSpace::define),
      or_negative(id("sbboxid", IdSpace::define, 0, "only what lies in this box, of the reference side"),
                  IdSpace::define),
      integer("sapr", 0, any_value, "forces of the tracked side in ncforc and intfor"),
      integer("sbpr", 0, any_value, "forces of the reference side in ncforc and intfor"),
  }};
}
const Card sides_of_sets = sides_card(IdSpace::set, IdSpace::set);
const Card sides_part_set = sides_card(IdSpace::part, IdSpace::set);
const Card sides_set_part = sides_card(IdSpace::set, IdSpace::part);
const Card sides_of_parts = sides_card(IdSpace::part, IdSpace::part);

const Card friction_card{{
    real("fs", dimension::number, 0, any_value,
         "static friction; -1: of *PART_CONTACT; -2: of *DEFINE_FRICTION; ties have none"),
    real("fd", dimension::number, 0, any_value, "dynamic friction; with FS -2: id of *DEFINE_FRICTION, 0: the first"),
    real("dc", {0, -1, 1}, 0, any_value, "decay from the static to the dynamic coefficient"),
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
    real("fsf", dimension::number, 1, at_least(0), "scale of friction"),
    real("vsf", dimension::number, 1, at_least(0), "scale of viscous friction"),
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
    real("penmax", dimension::number, 0, at_least(0), "a node deeper than so many thicknesses is released; 0: never"),
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
    real("dprfac", dimension::number, 0, any_value, "soft 2: initial overlap that is given up with time"),
    real("dtstif", dimension::time, 0, any_value,
         "step for which soft 1 and 2 find their stiffness; 0: that of the run"),
    real("edgek", dimension::number, 0, any_value, "stiffness of edges"),
    unused(),
    real("flangl", dimension::number, 0, any_value, "angle of feature lines"),
    id("cid_rcf", IdSpace::define, 0, "coordinate system of rcforc"),
}};
const Card card_d{{
    integer("q2tri", 0, any_value, "quadrilaterals as triangles"),
    real("dtpchk", dimension::time, 0, any_value, "time between reports of penetration"),
    real("sfnbr", dimension::number, 0, any_value, "scale of neighbours"),
    real("fnlscl", dimension::number, 0, any_value, "scale of a nonlinear force"),
    real("dnlscl", dimension::number, 0, any_value, "distance of that force"),
    integer("tcso", 0, any_value, "thickness from the section"),
    integer("tiedid", 0, any_value, "incremental ties"),
    integer("shledg", 0, any_value, "shell edges"),
}};
const Card card_e{{
    integer("sharec", 0, any_value, "shared constraints"),
    integer("cparm8", 0, any_value,
            "_GENERAL: 1 beams of one part do not press each other; 2 and weld beams take part"),
    integer("ipback", 0, any_value, "ties: not 0: springs where a node or its segment is constrained already"),
    integer("srnde", 0, any_value, "round edges of shells"),
    real("fricsf", dimension::number, 1, any_value, "scale of the stiffness of friction"),
    integer("icor", 0, any_value, "restitution"),
    integer("ftorq", 0, between(0, 1), "1: the moments of friction are balanced"),
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

const Card card_g{{
    unused(),
    real("shloff", dimension::number, 0, any_value, "contact surfaces of shells that lie off their nodes"),
}};

const Card eroding_card{{
    integer("isym", 0, any_value, "planes of symmetry: nothing to do here"),
    integer("erosop", 0, any_value, "faces that come to light take part in any case"),
    integer("iadj", 0, any_value, "faces between materials take part where the parts are all in the contact"),
}};

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

/// Attributes of sets (of memory: DA1 and DA2 are strengths of glue, DA3 and DA4 scales of friction) are not heeded.
template <class Set>
void report_attributes(Builder& builder, const Row& row, std::string_view field, const Contact& contact,
                       const Set& set) {
  const std::array<double, 4>& a = set.attributes;
  if (!contact.slides() || (a[2] == 0.0 && a[3] == 0.0 && (!contact.glue || (a[0] == 0.0 && a[1] == 0.0)))) return;
  row.report(builder.findings, Severity::warning, field,
             fmt::format("attributes {:g}, {:g}, {:g}, {:g} of set {} (strengths, scales of friction) are not obeyed: "
                         "those of the contact's cards hold",
                         a[0], a[1], a[2], a[3], set.id),
             "give a contact of its own to what has other strengths or friction");
}

/// What a side's id and type stand for. Nothing but findings where the id is unknown.
Surface surface_of(Builder& builder, const Row& row, std::string_view field, std::string_view type_field,
                   const Contact& contact) {
  Surface surface;
  switch (row.integer(type_field)) {
    case 0:
      if (const auto* set = builder.segment_set(row, field)) {
        surface.segments = set->members;
        report_attributes(builder, row, field, contact, *set);
      }
      break;
    case 1:
      if (const auto* set = builder.shell_set(row, field)) {
        add_shells(builder.model, set->members, surface);
        report_attributes(builder, row, field, contact, *set);
      }
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
      if (const auto* set = builder.node_set(row, field)) {
        surface.nodes = set->members;
        report_attributes(builder, row, field, contact, *set);
      }
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
    contact.a = surface_of(builder, row, "surfa", "surfatyp", contact);
}

void refuse_missing_sides(Builder& builder, const Row& row, const char* advice) {
  for (const auto& [field, type] : {std::pair{"surfa", "surfatyp"}, std::pair{"surfb", "surfbtyp"}})
    if (row.integer(field) == 0 && row.integer(type) != 5 && row.integer(type) != 2)
      refuse(builder, row, field, "must be given", advice);
}

/// Both sides of a contact of two surfaces; a tracked side may be a set of nodes where only its nodes are looked at.
void take_two_sides(Builder& builder, const Row& row, Contact& contact) {
  if (row.integer("surfatyp") == 4 && contact.kind == Kind::two_surfaces)
    refuse(builder, row, "surfatyp", "a set of nodes has no segments for the nodes of the other side",
           "use *CONTACT_AUTOMATIC_NODES_TO_SURFACE");
  if (row.integer("surfbtyp") == 4)
    refuse(builder, row, "surfbtyp", "the reference side needs segments", "name parts, shells or a segment set");
  refuse_missing_sides(builder, row,
                       "name both sides; *CONTACT_AUTOMATIC_SINGLE_SURFACE with SURFA 0 is for all parts and all");
  contact.a = surface_of(builder, row, "surfa", "surfatyp", contact);
  contact.b = surface_of(builder, row, "surfb", "surfbtyp", contact);
}

void take_transducer(Builder& builder, const Row& row, Contact& contact) {
  contact.a = surface_of(builder, row, "surfa", "surfatyp", contact);
  if (row.integer("surfb") != 0) contact.b = surface_of(builder, row, "surfb", "surfbtyp", contact);
}

void take_tie(Builder& builder, const Row& row, Contact& contact) {
  if (row.integer("surfbtyp") == 4)
    return refuse(builder, row, "surfbtyp", "the reference side of a tie needs segments",
                  "name parts, shells or a segment set");
  refuse_missing_sides(builder, row, "name what is tied, and to what");
  contact.a = surface_of(builder, row, "surfa", "surfatyp", contact);
  contact.b = surface_of(builder, row, "surfb", "surfbtyp", contact);
}

// ---- the cards that always stand
// --------------------------------------------------------------------------------------------

bool slides_by_table(const Contact& contact, const Row& row) {
  return contact.slides() && row.real("fs") == -2.0;
}

void take_friction(Builder& builder, const Row& row, Contact& contact) {
  contact.friction_by_part = contact.slides() && row.real("fs") == -1.0;
  const bool by_table = slides_by_table(contact, row);
  if (contact.slides() && !contact.friction_by_part && !by_table)
    for (const std::string_view field : {"fs", "fd", "dc", "vc"})
      if (row.real(field) < 0.0)
        refuse(builder, row, field,
               "friction by a curve or function is not built; expected 0 or more, or FS = -1 or -2",
               "give the coefficients here, in *PART_CONTACT with FS = -1, or in *DEFINE_FRICTION with FS = -2");
  if (contact.slides() && row.real("fs") == 2.0)
    refuse(builder, row, "fs", "2 asks for friction by a table (its id in FD), which is not built",
           "give the coefficients, 1.99 or 2.01 where 2 is one");
  contact.friction = {row.real("fs"), row.real("fd"), row.real("dc"), row.real("vc")};
  if (contact.friction_by_part || by_table) contact.friction = {1.0, 1.0, 0.0, 1.0};
  contact.damping = row.real("vdc");
  contact.birth = row.real("bt");
  contact.death = death_time(row.real("dt"));
  if (contact.kind == Kind::transducer && (contact.birth > 0.0 || contact.death < forever))
    row.report(builder.findings, Severity::warning, contact.birth > 0.0 ? "bt" : "dt",
               "not obeyed: a transducer sums up the forces of the whole run", "leave BT and DT 0");
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
  contact.friction.static_coefficient *= row.real("fsf");
  contact.friction.dynamic_coefficient *= row.real("fsf");
  contact.friction.shear_strength *= row.real("vsf");
}

constexpr std::string_view left = "not built: runs as with the default";

void take_a(Builder& builder, const Row& row, Contact& contact) {
  contact.soft = row.integer("soft");
  contact.soft_scale = row.real("sofscl");
  contact.search_interval = std::max(0, row.integer("bsort"));
  if (contact.tie()) return;  // of these fields none acts on a constraint
  expect(builder, row, Severity::note,
         {{"maxpar", 1.025, "segments are extended as with 1.025"}, {"frcfrq", 1, "forces are found in each cycle"}});
  contact.depth = row.integer("depth");
  if (contact.soft == 2 && contact.keyword.find("NODES_TO_SURFACE") != std::string::npos) {
    row.report(builder.findings, Severity::warning, "soft",
               "a contact of nodes has no segments on one side; it runs as with soft = 1",
               "use a contact of surfaces for segment-based contact");
    contact.soft = 1;
  }
  if (contact.soft < 0 || contact.soft > 2)
    refuse(builder, row, "soft", "this form of the penalty is not built; expected 0, 1 or 2",
           "use 2 for segment-based contact");
  if (contact.soft == 2 && contact.depth < 0)
    refuse(builder, row, "depth", "a depth by curve is not built; expected 0 or more", "give the depth");
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
  if (const int ignore = row.integer("ignore"); ignore != 0) contact.ignore = ignore;
  if (contact.tie()) return;
  if (contact.keyword.find("MORTAR") != std::string::npos) expect(builder, row, Severity::warning, {{"igap", 1, left}});
  contact.soft_step = row.real("dtstif");
  if (contact.soft_step < 0.0)
    refuse(builder, row, "dtstif", "a step by a curve or by a running mean is not built; expected 0 or a step",
           "leave it 0 for the step of the run, or give the step");
  expect(builder, row, Severity::warning,
         {{"dprfac", 0, "not built: what overlaps at the start keeps its offset, as with 0"},
          {"edgek", 0, left},
          {"flangl", 0, left},
          {"cid_rcf", 0, "forces are written in global axes"}});
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

void take_cparm8(Builder& builder, const Row& row, Contact& contact) {
  if (contact.keyword.find("GENERAL") == std::string::npos)
    return expect(builder, row, Severity::warning, {{"cparm8", 0, "has an effect in _GENERAL alone"}});
  const int value = row.integer("cparm8"), beams = value % 10;
  if (value < 0 || beams > 2 || value / 10 > 1) return refuse(builder, row, "cparm8", "expected 0, 1 or 2, or 10 more");
  if (value >= 10)
    row.report(builder.findings, Severity::warning, "cparm8",
               "not obeyed: the bars around shell edges are not shifted into the shells");
  if (beams > 0) contact.parts_apart = true;
  if (beams == 2) contact.takes_welds = true;
}

void take_e(Builder& builder, const Row& row, Contact& contact) {
  if (contact.tie()) {
    contact.penalty_fallback = row.integer("ipback") != 0;
    return;
  }
  take_cparm8(builder, row, contact);
  contact.balances_friction = row.integer("ftorq") != 0;
  if (row.integer("icor") != 0) {
    row.report(builder.findings, Severity::warning, "icor",
               "restitution in percent (VDC) is not built: this contact is not damped",
               "give VDC in percent of critical damping, without ICOR");
    contact.damping = 0.0;
  }
  expect(builder, row, Severity::warning, {{"srnde", 0, left}, {"region", 0, left}, {"fricsf", 1, left}});
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
  if (cursor.more() && !contact.tie())
    expect(builder, cursor.read(card_g), Severity::warning,
           {{"shloff", 0, "not obeyed: contact surfaces lie about the mid-surface, as with 0"}});
  else if (cursor.more())
    cursor.read(card_g);
  expect_end(builder, cursor);
}

// ---- reader
// --------------------------------------------------------------------------------------------------------------------

/// Of the cards of the distributed-memory version those fields count that say what the contact is: CPARM8 (what it
/// holds; docs/evidence/decks.md, the bolted connection) and IGNORE. The others tune its search.
void read_mpp(Builder& builder, Cursor& cursor, const Options& options, Contact& contact) {
  if (!options.contains("MPP")) return;
  const Row row = cursor.read(mpp_card1);
  take_cparm8(builder, row, contact);
  if (contact.slides()) {
    if (const int ignore = row.integer("ignore"); ignore == 1 || ignore == 2)
      contact.ignore = ignore;
    else
      expect(builder, row, Severity::warning,
             {{"ignore", 0, "not built: IGNORE of card C or of *CONTROL_CONTACT holds"}});
  }
  if (!cursor.peek().starts_with('&')) return;
  const Row second = cursor.read(mpp_card2);
  if (contact.slides())
    expect(builder, second, Severity::warning, {{"pensf", 1, "not built: an initial overlap is kept as it is"}});
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

void check_mortar(Builder& builder, const Block& block, const Options& options) {
  if (options.contains("MORTAR"))
    builder.findings.warning(block.place, '*' + block.keyword,
                             "segments are not integrated against segments as mortar contact does: this one presses "
                             "nodes against segments",
                             "expect forces that are less smooth over coarse meshes");
}

/// The oriented forms of earlier releases. Their segments have one face each, which the automatic forms do not need to
/// know; those of two surfaces leave the thickness of sheets out unless SHLTHK or THKOPT asks for it.
void check_oriented(Builder& builder, const Block& block, const Contact& contact) {
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

/// With SOFT = 2 a thickness of *PART_CONTACT counts on bricks too (keyword manual); here these have no skin.
void check_skins(Builder& builder, const Contact& contact) {
  if (!contact.slides() || contact.soft != 2) return;
  for (std::size_t p = 0; p < builder.model.parts.size(); ++p) {
    const Part& part = builder.model.parts[p];
    const auto in = [p](const Surface& s) {
      return s.everything || std::find(s.parts.begin(), s.parts.end(), static_cast<Index>(p)) != s.parts.end();
    };
    if (part.kind != ElementKind::solid || part.contact_thickness <= 0.0 || !(in(contact.a) || in(contact.b))) continue;
    builder.findings.warning(
        contact.place, '*' + contact.keyword,
        fmt::format("part {} has a contact thickness of {:g}: bricks have none here, with SOFT = 2 "
                    "neither",
                    part.id, part.contact_thickness),
        "mesh the gap, or coat the bricks with shells");
  }
}

/// A contact without an id has its number in the deck, which may be the id of another.
void report_same_id(Builder& builder, const Contact& contact) {
  for (const Contact& other : builder.model.contacts)
    if (other.id == contact.id)
      return builder.findings.warning(
          contact.place, '*' + contact.keyword,
          fmt::format("contact {} has the number of the one at {}:{}: rcforc and sleout do not tell them apart",
                      contact.id, other.place.file, other.place.line),
          "give each an id of its own, with _ID");
}

/// A contact that is activated after the end of the run never acts.
void report_late_birth(Builder& builder, const Contact& contact) {
  const double end = builder.model.control.end_time;
  const bool outlived = end > 0.0 && contact.birth >= end;
  if (!contact.slides() || !(outlived || contact.birth >= contact.death)) return;
  builder.findings.warning(
      contact.place, '*' + contact.keyword,
      outlived
          ? fmt::format("BT = {:g} is after the end of the run ({:g}): this contact never acts", contact.birth, end)
          : fmt::format("BT = {:g} is not before DT = {:g}: this contact never acts", contact.birth, contact.death),
      "give BT 0 if it is to act from the start");
}

template <Kind kind>
void read_contact(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  Contact contact;
  contact.kind = kind;
  contact.keyword = block.keyword;
  contact.place = block.place;
  take_form(builder, block, options, contact);
  check_mortar(builder, block, options);
  check_oriented(builder, block, contact);
  const Heading heading = read_heading(cursor, options.contains("ID") || options.contains("TITLE"));
  contact.id = heading.id;
  contact.title = heading.text;
  read_mpp(builder, cursor, options, contact);
  const Row sides = cursor.read(card_of_sides(cursor));
  if (!contact.slides())
    expect(builder, sides, Severity::error,
           {{"saboxid", 0, "a box around a side of a tie or a transducer is not built"},
            {"sbboxid", 0, "a box around a side of a tie or a transducer is not built"}});
  const Row friction = cursor.read(friction_card);
  take_friction(builder, friction, contact);
  take_scales(builder, cursor.read(scale_card), contact);
  if (erodes(contact) && cursor.more()) cursor.read(eroding_card);
  const std::optional<Row> glue = read_glue(builder, cursor, options, contact);
  take_optional_cards(builder, cursor, contact);
  const long offset = block.transform ? block.transform->id_offset[static_cast<std::size_t>(IdSpace::define)] : 0;
  builder.defer(Phase::conditions, [sides, friction, offset, glue, contact = std::move(contact)](Builder& b) mutable {
    if (slides_by_table(contact, friction)) contact.friction_table = friction_table(b, friction, offset);
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
    report_same_id(b, contact);
    report_late_birth(b, contact);
    check_skins(b, contact);
    b.model.contacts.push_back(std::move(contact));
  });
}

template <Kind kind>
Keyword contact_keyword(std::string_view name, std::vector<std::string_view> forms = {}) {
  forms.insert(forms.end(), {"ID", "TITLE", "MPP"});
  const bool glued = std::find(forms.begin(), forms.end(), "TIEBREAK") != forms.end();
  std::vector<LayoutCard> layout{{"with _ID or _TITLE", &heading_card},
                                 {"with _MPP; IGNORE and CPARM8 count", &mpp_card1},
                                 {"with _MPP, if it begins with &; read past", &mpp_card2},
                                 {{}, &sides_of_sets},
                                 {{}, &friction_card},
                                 {{}, &scale_card}};
  if (name.starts_with("CONTACT_ERODING")) layout.push_back({{}, &eroding_card});
  const std::vector<LayoutCard> glue = glue_layout(name, glued);
  layout.insert(layout.end(), glue.begin(), glue.end());
  layout.insert(layout.end(), {{"optional card A", &card_a},
                               {"optional card B", &card_b},
                               {"optional card C", &card_c},
                               {"optional card D", &card_d},
                               {"optional card E", &card_e},
                               {"optional card F", &card_f},
                               {"optional card G", &card_g}});
  return {name, {}, std::move(forms), KeywordStatus::used, {}, std::move(layout), read_contact<kind>};
}

Keyword refused(std::string_view name, std::string_view why) {
  return {name, {}, {"ID", "TITLE", "MPP"}, KeywordStatus::refused, why, {}, nullptr};
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
      interior_keyword(),
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

}  // namespace nugget::reading
