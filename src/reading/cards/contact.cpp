// SPDX-License-Identifier: Apache-2.0
// *CONTACT_...: the penalty contact and the ties that are built, and by name those that are not.
#include <fmt/format.h>

#include "model/bond.hpp"
#include "model/contact_form.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/contact_glue.hpp"
#include "reading/cards/contact_interior.hpp"
#include "reading/cards/contact_options.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/friction.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using ContactKind = Contact::Kind;

struct MppCard1 {
  int ignore = 0, cparm8 = 0;
};
const CardOf<MppCard1> mpp_card1{
    {&MppCard1::ignore, integer("ignore", 0, any_value, "1, 2: as on card C, where that is 0; others are not built")},
    integer("bckt", 200, any_value, "search interval"),
    integer("lcbckt", 0, any_value, "curve of that interval"),
    integer("ns2trk", 3, any_value, "contacts tracked a node"),
    integer("inititr", 2, any_value, "iterations for initial penetrations"),
    real("parmax", dimension::number, 0, any_value, "extension of segments"),
    unused(),
    {&MppCard1::cparm8, integer("cparm8", 0, any_value,
                                "_GENERAL: 1 beams of one part do not press each other; 2 and weld beams take part")},
};
struct MppCard2 {
  double pensf = 0;
};
const CardOf<MppCard2> mpp_card2{
    text("mark", 10, "& in column 1"),
    integer("chksegs", 0, any_value, "check of segments"),
    {&MppCard2::pensf, real("pensf", dimension::number, 1, any_value, "penalty scale")},
    integer("grpable", 0, any_value, "search method"),
};

/// The first card; the name space of the ids of either side depends on its type.
struct SidesCard {
  int surfa = 0, surfb = 0, surfatyp = 0, surfbtyp = 0, saboxid = 0, sbboxid = 0, sapr = 0, sbpr = 0;
};
CardOf<SidesCard> sides_card(IdSpace a, IdSpace b) {
  return {
      {&SidesCard::surfa, id("surfa", a, 0, "tracked side (SSID); 0 in a single surface contact: all parts")},
      {&SidesCard::surfb, id("surfb", b, 0, "reference side (MSID)")},
      {&SidesCard::surfatyp,
       integer("surfatyp", 0, between(0, 7),
               "0 segment set, 1 shell set, 2 part set, 3 part, 4 node set, 5 all, 6 all but a part set, 7 branch of "
               "parts (*SET_PART_TREE)")},
      {&SidesCard::surfbtyp, integer("surfbtyp", 0, between(0, 7), "the same, without 4")},
      {&SidesCard::saboxid,
       or_negative(id("saboxid", IdSpace::define, 0, "only what lies in this box, of the tracked side"),
                   IdSpace::define)},
      {&SidesCard::sbboxid,
       or_negative(id("sbboxid", IdSpace::define, 0, "only what lies in this box, of the reference side"),
                   IdSpace::define)},
      {&SidesCard::sapr,
       integer("sapr", 0, any_value, "not 0: ncforc has the forces on the nodes of the tracked side")},
      {&SidesCard::sbpr, integer("sbpr", 0, any_value, "the same of the reference side")},
  };
}
const CardOf<SidesCard> sides_of_sets = sides_card(IdSpace::set, IdSpace::set);
const CardOf<SidesCard> sides_part_set = sides_card(IdSpace::part, IdSpace::set);
const CardOf<SidesCard> sides_set_part = sides_card(IdSpace::set, IdSpace::part);
const CardOf<SidesCard> sides_of_parts = sides_card(IdSpace::part, IdSpace::part);

struct FrictionCard {
  double fs = 0, fd = 0, dc = 0, vc = 0, vdc = 0, bt = 0, dt = 0;
};
CardOf<FrictionCard> friction_card_of(const RealField& fs, const RealField& fd) {
  return {
      {&FrictionCard::fs, fs},
      {&FrictionCard::fd, fd},
      {&FrictionCard::dc, real("dc", {0, -1, 1}, 0, any_value, "decay from the static to the dynamic coefficient")},
      {&FrictionCard::vc, real("vc", dimension::stress, 0, any_value, "viscous friction")},
      {&FrictionCard::vdc, real("vdc", dimension::number, 0, at_least(0), "damping, percent of critical")},
      integer("penchk", 0, any_value, "check of small penetrations; none in automatic contacts"),
      {&FrictionCard::bt, real("bt", dimension::time, 0, at_least(0), "the contact acts from this time on")},
      {&FrictionCard::dt, real("dt", dimension::time, forever, at_least(0), "until this time; 0: for ever")},
  };
}
const CardOf<FrictionCard> friction_card = friction_card_of(
    real("fs", dimension::number, 0, any_value,
         "static friction; -1: of *PART_CONTACT; -2: of *DEFINE_FRICTION; ties have none"),
    real("fd", dimension::number, 0, any_value, "dynamic friction; with FS -2: id of *DEFINE_FRICTION, 0: the first"));
/// Of a tie that fails.
const CardOf<FrictionCard> failure_card = friction_card_of(
    real("fs", dimension::stress, 0, at_least(0), "normal stress at which it fails; 0: does not count"),
    real("fd", dimension::stress, 0, at_least(0), "shear stress at which it fails; 0: does not count"));
struct ScaleCard {
  double sfsa = 0, sfsb = 0, sast = 0, sbst = 0, sfsat = 0, sfsbt = 0, fsf = 0, vsf = 0;
};
const CardOf<ScaleCard> contact_scale_card{
    {&ScaleCard::sfsa, real("sfsa", dimension::number, 1, at_least(0), "scale of the tracked side's stiffness (SFS)")},
    {&ScaleCard::sfsb,
     real("sfsb", dimension::number, 1, at_least(0), "scale of the reference side's stiffness (SFM)")},
    {&ScaleCard::sast, real("sast", dimension::length, 0, any_value,
                            "thickness of the tracked side (SST); ties: a negative value is the tolerance")},
    {&ScaleCard::sbst, real("sbst", dimension::length, 0, any_value, "thickness of the reference side (MST)")},
    {&ScaleCard::sfsat,
     real("sfsat", dimension::number, 1, at_least(0), "scale of the tracked side's thickness (SFST)")},
    {&ScaleCard::sfsbt,
     real("sfsbt", dimension::number, 1, at_least(0), "scale of the reference side's thickness (SFMT)")},
    {&ScaleCard::fsf, real("fsf", dimension::number, 1, at_least(0), "scale of friction")},
    {&ScaleCard::vsf, real("vsf", dimension::number, 1, at_least(0), "scale of viscous friction")},
};
struct CloseCard {
  double close = 0;
};
const CardOf<CloseCard> close_card{
    {&CloseCard::close, real("close", dimension::length, 0, at_least(0),
                             "surfaces closer than this are tied; 0: one percent of the segment's size")},
};
const Card eroding_card{{
    integer("isym", 0, any_value, "planes of symmetry: nothing to do here"),
    integer("erosop", 0, any_value, "faces that come to light take part in any case"),
    integer("iadj", 0, any_value, "faces between materials take part where the parts are all in the contact"),
}};

const CardOf<SidesCard>& card_of_sides(const Cursor& cursor) {
  const bool a = cursor.peek_number(2) == 3.0, b = cursor.peek_number(3) == 3.0;
  return a ? (b ? sides_of_parts : sides_part_set) : (b ? sides_set_part : sides_of_sets);
}

void add_shells(const Model& model, const std::vector<Index>& shells, Surface& surface) {
  for (const Index shell : shells) surface.segments.push_back(model.shells.node[shell]);
}

void take_all_but(const Builder& builder, const std::vector<Index>& exempt, Surface& surface) {
  for (std::size_t p = 0; p < builder.model.parts.size(); ++p)
    if (std::find(exempt.begin(), exempt.end(), static_cast<Index>(p)) == exempt.end())
      surface.parts.push_back(static_cast<Index>(p));
}

/// Attributes of sets (of memory: DA1 and DA2 are strengths of glue, DA3 and DA4 scales of friction) are not heeded.
template <class Set>
void report_attributes(Builder& builder, const deck::Entry& field, const Contact& contact, const Set& set) {
  const std::array<double, 4>& a = set.attributes;
  if (!contact.slides() || (a[2] == 0.0 && a[3] == 0.0 && (!contact.glue || (a[0] == 0.0 && a[1] == 0.0)))) return;
  field.report(
      builder.findings, Severity::warning,
      fmt::format("attributes {:g}, {:g}, {:g}, {:g} of set {} (strengths, scales of friction) are not obeyed: "
                  "those of the contact's cards hold",
                  a[0], a[1], a[2], a[3], set.id),
      "give a contact of its own to what has other strengths or friction");
}

/// What a side's id and type stand for. Nothing but findings where the id is unknown.
Surface surface_of(Builder& builder, const deck::Entry& field, int type, const Contact& contact) {
  Surface surface;
  switch (type) {
    case 0:
      if (const auto* set = builder.segment_set(field)) {
        surface.segments = set->members;
        report_attributes(builder, field, contact, *set);
      }
      break;
    case 1:
      if (const auto* set = builder.shell_set(field)) {
        add_shells(builder.model, set->members, surface);
        report_attributes(builder, field, contact, *set);
      }
      break;
    case 2:
      if (field.integer() == 0)
        surface.everything = true;
      else if (const auto* set = builder.part_set(field))
        surface.parts = set->members;
      break;
    case 3:
      if (const Index part = builder.part(field); part != none) surface.parts = {part};
      break;
    case 4:
      if (const auto* set = builder.node_set(field)) {
        surface.nodes = set->members;
        report_attributes(builder, field, contact, *set);
      }
      break;
    case 5: surface.everything = true; break;
    case 6:
      if (const auto* set = builder.part_set(field)) take_all_but(builder, set->members, surface);
      break;
    case 7:
      if (const auto* branch = builder.branch(field)) surface.parts = branch->members;
      break;
    default: break;
  }
  return surface;
}

/// The sides of the card; nothing where the type could not be read, which was said: what the id is of is not known.
Surface side_a(Builder& builder, const RowOf<SidesCard>& row, const Contact& contact) {
  if (row[&SidesCard::surfatyp].refused) return {};
  return surface_of(builder, row[&SidesCard::surfa], row->surfatyp, contact);
}
Surface side_b(Builder& builder, const RowOf<SidesCard>& row, const Contact& contact) {
  if (row[&SidesCard::surfbtyp].refused) return {};
  return surface_of(builder, row[&SidesCard::surfb], row->surfbtyp, contact);
}

void take_box(Builder& builder, const deck::Entry& field, Surface& surface) {
  const Box* box = builder.box(field);
  if (box == nullptr) return;
  surface.boxed = true;
  surface.box_low = box->low;
  surface.box_high = box->high;
}

void take_boxes(Builder& builder, const RowOf<SidesCard>& row, Contact& contact) {
  for (const deck::Entry& field : {row[&SidesCard::saboxid], row[&SidesCard::sbboxid]})
    if (field.integer() < 0)
      refuse(builder, field, "a box that moves on is not built; expected the id of a *DEFINE_BOX",
             "give the id without its sign: what lies in the box at the start takes part");
  if (row->saboxid > 0) take_box(builder, row[&SidesCard::saboxid], contact.a);
  if (row->sbboxid > 0) take_box(builder, row[&SidesCard::sbboxid], contact.b);
}

void take_single_surface(Builder& builder, const RowOf<SidesCard>& row, Contact& contact) {
  if (row->surfatyp == 4)
    return refuse(builder, row[&SidesCard::surfatyp], "a single surface has no node set for a side",
                  "name parts, shells or segments");
  if (row->surfb != 0)
    row[&SidesCard::surfb].report(builder.findings, Severity::warning,
                                  "no effect: a single surface has no other side; what SURFA names meets itself",
                                  "leave it 0, or write *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE for two sides");
  if (row->surfa == 0)
    contact.a.everything = true;
  else
    contact.a = side_a(builder, row, contact);
}

/// A surface that is tied to itself is both sides of the tie.
void face_itself(Contact& contact) {
  contact.b = contact.a;
  contact.thickness_b = contact.thickness_a;
  contact.thickness_scale_b = contact.thickness_scale_a;
}

void refuse_missing_sides(Builder& builder, const RowOf<SidesCard>& row, const char* advice) {
  const auto check = [&](const deck::Entry& side, int type) {
    if (side.integer() == 0 && type != 5 && type != 2) refuse(builder, side, "must be given", advice);
  };
  check(row[&SidesCard::surfa], row->surfatyp);
  check(row[&SidesCard::surfb], row->surfbtyp);
}

/// Both sides of a contact of two surfaces; a tracked side may be a set of nodes where only its nodes are looked at.
void take_two_sides(Builder& builder, const RowOf<SidesCard>& row, Contact& contact) {
  if (row->surfatyp == 4 && contact.kind == ContactKind::two_surfaces)
    refuse(builder, row[&SidesCard::surfatyp], "a set of nodes has no segments for the nodes of the other side",
           "use *CONTACT_AUTOMATIC_NODES_TO_SURFACE");
  if (row->surfbtyp == 4)
    refuse(builder, row[&SidesCard::surfbtyp], "the reference side needs segments",
           "name parts, shells or a segment set");
  refuse_missing_sides(builder, row,
                       "name both sides; *CONTACT_AUTOMATIC_SINGLE_SURFACE with SURFA 0 is for all parts and all");
  contact.a = side_a(builder, row, contact);
  contact.b = side_b(builder, row, contact);
}

void take_transducer(Builder& builder, const RowOf<SidesCard>& row, Contact& contact) {
  contact.a = side_a(builder, row, contact);
  if (row->surfb != 0) contact.b = side_b(builder, row, contact);
}

void take_tie(Builder& builder, const RowOf<SidesCard>& row, Contact& contact) {
  if (row->surfbtyp == 4)
    return refuse(builder, row[&SidesCard::surfbtyp], "the reference side of a tie needs segments",
                  "name parts, shells or a segment set");
  refuse_missing_sides(builder, row, "name what is tied, and to what");
  contact.a = side_a(builder, row, contact);
  contact.b = side_b(builder, row, contact);
}

// ---- the cards that always stand

/// *CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE: what holds it until it fails is glue.
bool is_failing_tie(const Contact& contact) {
  return contact.keyword.starts_with("CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE");
}

bool slides_by_table(const Contact& contact, const RowOf<FrictionCard>& row) {
  return contact.slides() && !is_failing_tie(contact) && row->fs == -2.0;
}

void take_failing_tie(Builder& builder, const RowOf<FrictionCard>& row, Contact& contact) {
  if (row->fs == 0.0 && row->fd == 0.0)
    refuse(builder, row[&FrictionCard::fs], "the stress at which the tie fails must be given, here or in FD",
           "give it, or use *CONTACT_TIED_SURFACE_TO_SURFACE, which does not fail");
  Glue& glue = contact.glue.emplace();
  glue.law.normal_strength = row->fs;
  glue.law.shear_strength = row->fd;
  glue.without_thickness = glue.moments = true;
}

void take_friction(Builder& builder, const RowOf<FrictionCard>& row, Contact& contact) {
  contact.friction_by_part = contact.slides() && row->fs == -1.0;
  const bool by_table = slides_by_table(contact, row);
  if (contact.slides() && !contact.friction_by_part && !by_table)
    for (const deck::Entry& field :
         {row[&FrictionCard::fs], row[&FrictionCard::fd], row[&FrictionCard::dc], row[&FrictionCard::vc]})
      if (field.value < 0.0)
        refuse(builder, field, "friction by a curve or function is not built; expected 0 or more, or FS = -1 or -2",
               "give the coefficients here, in *PART_CONTACT with FS = -1, or in *DEFINE_FRICTION with FS = -2");
  if (contact.slides() && row->fs == 2.0)
    refuse(builder, row[&FrictionCard::fs], "2 asks for friction by a table (its id in FD), which is not built",
           "give the coefficients, 1.99 or 2.01 where 2 is one");
  contact.friction = {row->fs, row->fd, row->dc, row->vc};
  if (contact.friction_by_part || by_table) contact.friction = {1.0, 1.0, 0.0, 1.0};
}

void take_times(Builder& builder, const RowOf<FrictionCard>& row, Contact& contact) {
  contact.damping = row->vdc;
  contact.birth = row->bt;
  contact.death = death_time(row->dt);
  if (contact.kind == ContactKind::transducer && (contact.birth > 0.0 || contact.death < forever))
    row[contact.birth > 0.0 ? &FrictionCard::bt : &FrictionCard::dt].report(
        builder.findings, Severity::warning, "not obeyed: a transducer sums up the forces of the whole run",
        "leave BT and DT 0");
  if (contact.tie_by_springs())
    expect(builder, Severity::warning, {{row[&FrictionCard::vdc], 0, "the springs of a tie have no damping here"}});
}

/// The tolerance of a tie, where it is given; 0: it is not.
double reach_of_tie(const Contact& contact) {
  if (contact.thickness_a >= 0.0 && contact.thickness_b >= 0.0) return 0.0;
  return 0.6 * (std::abs(contact.thickness_a) + std::abs(contact.thickness_b));
}

void take_contact_scales(Builder& builder, const RowOf<ScaleCard>& row, Contact& contact) {
  if ((contact.slides() && !is_failing_tie(contact)) || contact.ties_what_touches())
    for (const deck::Entry& field : {row[&ScaleCard::sast], row[&ScaleCard::sbst]})
      if (field.value < 0.0)
        refuse(builder, field, "a negative thickness has a meaning for ties alone; expected 0 or more",
               "leave it 0 for the thickness of the shells");
  contact.stiffness_scale_a = row->sfsa;
  contact.stiffness_scale_b = row->sfsb;
  contact.thickness_a = row->sast;
  contact.thickness_b = row->sbst;
  contact.thickness_scale_a = row->sfsat;
  contact.thickness_scale_b = row->sfsbt;
  contact.friction.static_coefficient *= row->fsf;
  contact.friction.dynamic_coefficient *= row->fsf;
  contact.friction.shear_strength *= row->vsf;
  if (is_failing_tie(contact)) contact.glue->reach = reach_of_tie(contact);
}

/// A tie of translations that begins later: springs hold what is in reach when it begins, at the place that it has
/// then, and never fail.
void tie_later(Contact& contact) {
  Glue& glue = contact.glue.emplace();
  glue.alone = glue.without_thickness = true;
  glue.moments = contact.offset != Contact::Offset::penalty;
  glue.reach = reach_of_tie(contact);
  contact.kind = ContactKind::one_way;
  contact.friction = {};
  contact.soft = 0;
}

// ---- reader

/// Of the cards of the distributed-memory version those fields count that say what the contact is: CPARM8 (what it
/// holds; docs/evidence/decks.md, the bolted connection) and IGNORE. The others tune its search.
void read_mpp(Builder& builder, Cursor& cursor, const Options& options, Contact& contact) {
  if (!options.contains("MPP")) return;
  const auto row = cursor.read(mpp_card1);
  take_cparm8(builder, row[&MppCard1::cparm8], contact);
  if (contact.slides()) {
    if (const int ignore = row->ignore; ignore == 1 || ignore == 2)
      contact.ignore = ignore;
    else
      expect(builder, Severity::warning,
             {{row[&MppCard1::ignore], 0, "not built: IGNORE of card C or of *CONTROL_CONTACT holds"}});
  }
  if (!cursor.peek().starts_with('&')) return;
  const auto second = cursor.read(mpp_card2);
  if (contact.slides())
    expect(builder, Severity::warning,
           {{second[&MppCard2::pensf], 1, "not built: an initial overlap is kept as it is"}});
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
  if (is_failing_tie(contact)) return;                           // what follows its failure is ours
  const bool single = contact.kind == ContactKind::single_surface;
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
          fmt::format("contact {} has the number of the one at {}:{}: rcforc, ncforc and sleout cannot be told apart",
                      contact.id, other.place.file, other.place.line),
          "give each an id of its own, with _ID");
}

/// A tie of translations that begins at BT is glue from then on; one of rotations is refused.
void tie_from_birth(Builder& builder, const deck::Entry& bt, Contact& contact) {
  if (!contact.ties_rotations()) return tie_later(contact);
  refuse(builder, bt, "a tie of rotations that begins later is not built",
         "leave BT blank, or tie translations alone (*CONTACT_TIED_NODES_TO_SURFACE); DT, the end of a tie, is obeyed");
  contact.birth = 0.0;  // said: the weld audit of a refused deck need not say it again
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

/// Adhesive bricks give contacts no segments, so a tie by glue would not see their nodes.
void refuse_adhesive(Builder& builder, const RowOf<SidesCard>& row, const Contact& contact) {
  if (!contact.glue || !contact.keyword.starts_with("CONTACT_TIED")) return;
  const auto check = [&](const Surface& side, const deck::Entry& field) {
    for (const Index p : side.parts)
      if (bond_of(builder.model, builder.model.parts[p]) != nullptr)
        return refuse(builder, field,
                      fmt::format("part {} is adhesive, which a tie that fails or begins later does not see",
                                  builder.model.parts[p].id),
                      "tie adhesive without _FAILURE and BT: it fails by its own law");
  };
  check(contact.a, row[&SidesCard::surfa]);
  check(contact.b, row[&SidesCard::surfb]);
}

template <ContactKind kind>
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
  const auto sides = cursor.read(card_of_sides(cursor));
  contact.prints_a = sides->sapr != 0;
  contact.prints_b = sides->sbpr != 0;
  if (!contact.slides() && !contact.ties_what_touches())
    expect(builder, Severity::error,
           {{sides[&SidesCard::saboxid], 0, "a box around a side of a tie or a transducer is not built"},
            {sides[&SidesCard::sbboxid], 0, "a box around a side of a tie or a transducer is not built"}});
  const auto friction = cursor.read(is_failing_tie(contact) ? failure_card : friction_card);
  if (is_failing_tie(contact))
    take_failing_tie(builder, friction, contact);
  else
    take_friction(builder, friction, contact);
  take_times(builder, friction, contact);
  take_contact_scales(builder, cursor.read(contact_scale_card), contact);
  if (erodes(contact) && cursor.more()) cursor.read(eroding_card);
  if (kind == ContactKind::tied_single_surface) contact.close = cursor.read(close_card)->close;
  const auto glue = read_glue(builder, cursor, options, contact);
  read_optional_contact_cards(builder, cursor, contact);
  const long offset = block.transform ? block.transform->id_offset[static_cast<std::size_t>(IdSpace::define)] : 0;
  builder.defer(Phase::conditions, [sides, friction, offset, glue, contact = std::move(contact)](Builder& b) mutable {
    if (slides_by_table(contact, friction))
      contact.friction_table = friction_table(b, friction[&FrictionCard::fs], friction[&FrictionCard::fd], offset);
    if (kind == ContactKind::single_surface || kind == ContactKind::tied_single_surface)
      take_single_surface(b, sides, contact);
    else if (contact.slides())
      take_two_sides(b, sides, contact);
    else if (kind == ContactKind::transducer)
      take_transducer(b, sides, contact);
    else
      take_tie(b, sides, contact);
    if (contact.slides() || contact.ties_what_touches()) take_boxes(b, sides, contact);
    if (contact.ties_what_touches()) face_itself(contact);
    if (contact.birth > 0.0 && contact.tie()) tie_from_birth(b, friction[&FrictionCard::bt], contact);
    refuse_adhesive(b, sides, contact);
    if (glue) finish_glue(b, *glue, contact);
    if (contact.ignore == 0) contact.ignore = b.model.control.ignore_penetration;
    // Where thicknesses are left out sheets may be meshed at any distance: their nodes stay where they are.
    if (contact.ignore == 0 && contact.glue && contact.glue->without_thickness) contact.ignore = 1;
    // Segment-based contact moves no nodes: "the initially penetrated location becomes the baseline from which
    // additional penetration is measured" (lsdyna.ansys.com, "SOFT option").
    if (contact.ignore == 0 && contact.soft == 2) contact.ignore = 1;
    if (contact.id == 0) contact.id = static_cast<int>(b.model.contacts.size()) + 1;
    report_same_id(b, contact);
    report_late_birth(b, contact);
    check_skins(b, contact);
    b.model.contacts.push_back(std::move(contact));
  });
}

template <ContactKind kind>
Keyword contact_keyword(std::string_view name, std::vector<std::string_view> forms = {}) {
  forms.insert(forms.end(), {"ID", "TITLE", "MPP"});
  const bool glued = std::find(forms.begin(), forms.end(), "TIEBREAK") != forms.end();
  std::vector<LayoutCard> layout{{"with _ID or _TITLE", &heading_card},
                                 {"with _MPP; IGNORE and CPARM8 count", &mpp_card1},
                                 {"with _MPP, if it begins with &; read past", &mpp_card2},
                                 {{}, &sides_of_sets},
                                 {{}, name.ends_with("_FAILURE") ? &failure_card : &friction_card},
                                 {{}, &contact_scale_card}};
  if (name.starts_with("CONTACT_ERODING")) layout.push_back({{}, &eroding_card});
  if (kind == ContactKind::tied_single_surface) layout.push_back({{}, &close_card});
  const std::vector<LayoutCard> glue = glue_layout(name, glued);
  layout.insert(layout.end(), glue.begin(), glue.end());
  const std::vector<LayoutCard> optional = optional_contact_layout();
  layout.insert(layout.end(), optional.begin(), optional.end());
  return {.name = name, .options = std::move(forms), .layout = std::move(layout), .read = read_contact<kind>};
}

Keyword refused_contact(std::string_view name, std::string_view why) {
  return {.name = name, .options = {"ID", "TITLE", "MPP"}, .status = KeywordStatus::refused, .why = why};
}

constexpr const char* other_tie_of_translations =
    "this form is not built; ties of translations only have _OFFSET and _CONSTRAINED_OFFSET (_BEAM_OFFSET is for shell "
    "edges and spot welds; ties that fail are *CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE, "
    "*CONTACT_TIEBREAK_NODES_TO_SURFACE and glue by _TIEBREAK)";

}  // namespace

std::vector<Keyword> contact_keywords() {
  return {
      contact_keyword<ContactKind::single_surface>("CONTACT_AUTOMATIC_SINGLE_SURFACE", {"MORTAR"}),
      contact_keyword<ContactKind::tied_single_surface>("CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED"),
      contact_keyword<ContactKind::two_surfaces>("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", {"TIEBREAK", "MORTAR"}),
      contact_keyword<ContactKind::one_way>("CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE", {"TIEBREAK"}),
      contact_keyword<ContactKind::one_way>("CONTACT_AUTOMATIC_NODES_TO_SURFACE"),
      contact_keyword<ContactKind::single_surface>("CONTACT_AUTOMATIC_GENERAL", {"INTERIOR"}),
      contact_keyword<ContactKind::single_surface>("CONTACT_SINGLE_SURFACE"),
      contact_keyword<ContactKind::two_surfaces>("CONTACT_SURFACE_TO_SURFACE"),
      contact_keyword<ContactKind::one_way>("CONTACT_ONE_WAY_SURFACE_TO_SURFACE"),
      contact_keyword<ContactKind::one_way>("CONTACT_NODES_TO_SURFACE"),
      contact_keyword<ContactKind::single_surface>("CONTACT_ERODING_SINGLE_SURFACE"),
      contact_keyword<ContactKind::two_surfaces>("CONTACT_ERODING_SURFACE_TO_SURFACE"),
      contact_keyword<ContactKind::one_way>("CONTACT_ERODING_NODES_TO_SURFACE"),
      contact_keyword<ContactKind::one_way>("CONTACT_TIEBREAK_NODES_TO_SURFACE"),
      contact_keyword<ContactKind::one_way>("CONTACT_TIEBREAK_NODES_ONLY"),
      contact_keyword<ContactKind::two_surfaces>("CONTACT_TIEBREAK_SURFACE_TO_SURFACE", {"ONLY"}),
      contact_keyword<ContactKind::transducer>("CONTACT_FORCE_TRANSDUCER"),
      contact_keyword<ContactKind::transducer>("CONTACT_FORCE_TRANSDUCER_PENALTY"),
      contact_keyword<ContactKind::spotweld>("CONTACT_SPOTWELD", {"WITH_TORSION", "WITH_TORSION_PENALTY", "PENALTY",
                                                                  "OFFSET", "BEAM_OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<ContactKind::tied_nodes>("CONTACT_TIED_NODES_TO_SURFACE", {"OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<ContactKind::tied_surface>("CONTACT_TIED_SURFACE_TO_SURFACE", {"OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<ContactKind::two_surfaces>("CONTACT_TIED_SURFACE_TO_SURFACE_FAILURE"),
      contact_keyword<ContactKind::tied_shell_edge>("CONTACT_TIED_SHELL_EDGE_TO_SURFACE",
                                                    {"OFFSET", "BEAM_OFFSET", "CONSTRAINED_OFFSET"}),
      contact_keyword<ContactKind::tied_shell_edge_to_solid>("CONTACT_TIED_SHELL_EDGE_TO_SOLID"),

      refused_contact("CONTACT_SPOTWELD_*", "this form of the weld tie is not built; use *CONTACT_SPOTWELD"),
      refused_contact("CONTACT_TIED_NODES_TO_SURFACE_*", other_tie_of_translations),
      refused_contact("CONTACT_TIED_SURFACE_TO_SURFACE_*", other_tie_of_translations),
      refused_contact(
          "CONTACT_TIED_SHELL_EDGE_TO_SURFACE_*",
          "this form is not built; _OFFSET, _BEAM_OFFSET, _CONSTRAINED_OFFSET and the plain one are (ties of "
          "rotations that fail are not)"),
      refused_contact("CONTACT_TIED_*",
                      "this tie is not built; *CONTACT_SPOTWELD, *CONTACT_TIED_NODES_TO_SURFACE, "
                      "*CONTACT_TIED_SURFACE_TO_SURFACE, *CONTACT_TIED_SHELL_EDGE_TO_SURFACE and ..._TO_SOLID are"),
      refused_contact("CONTACT_AUTOMATIC_SINGLE_SURFACE_*",
                      "this form is not built; *CONTACT_AUTOMATIC_SINGLE_SURFACE and ..._TIED (for modes) are"),
      refused_contact("CONTACT_AUTOMATIC_GENERAL_*",
                      "this form is not built; *CONTACT_AUTOMATIC_GENERAL and *CONTACT_AUTOMATIC_GENERAL_INTERIOR are"),
      refused_contact("CONTACT_AUTOMATIC_SINGLE_SURFACE_TIEBREAK*",
                      "glue is built between two surfaces; use *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_TIEBREAK"),
      refused_contact("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_*", "this form is not built; use it without the last word"),
      refused_contact("CONTACT_FORCE_TRANSDUCER_*",
                      "this transducer is not built; *CONTACT_FORCE_TRANSDUCER_PENALTY is"),
      interior_keyword(),
      refused_contact(
          "CONTACT_ERODING_*",
          "this form is not built; *CONTACT_ERODING_SINGLE_SURFACE, _SURFACE_TO_SURFACE and _NODES_TO_SURFACE "
          "are"),
      refused_contact("CONTACT_RIGID*", "contact of rigid bodies by force curves is not built"),
      refused_contact("CONTACT_2D*", "contact in two dimensions is not built"),
      refused_contact(
          "CONTACT_*",
          "this contact is not built; *CONTACT_AUTOMATIC_SINGLE_SURFACE, _SURFACE_TO_SURFACE, _NODES_TO_SURFACE, "
          "_GENERAL, the eroding ones, *CONTACT_SPOTWELD and *CONTACT_TIED_... are (`nugget keywords CONTACT`)"),
  };
}

}  // namespace nugget::reading
