// SPDX-License-Identifier: Apache-2.0
#include "reading/cards/contact_options.hpp"

#include <algorithm>

#include "reading/builder/common_cards.hpp"

// The optional cards A to G of *CONTACT_...
namespace nugget::reading {
namespace {

using deck::Cursor;
using deck::RowOf;

struct CardA {
  int soft = 0;
  double sofscl = 0;
  int lcidab = 0;
  double maxpar = 0;
  int depth = 0, bsort = 0, frcfrq = 0;
};
const CardOf<CardA> card_a{
    {&CardA::soft,
     integer("soft", 0, any_value, "0 penalty by material, 1 by nodal masses and step, 2 by segment masses and step")},
    {&CardA::sofscl, real("sofscl", dimension::number, 0.1, at_least(0), "scale of the stiffness with soft 1")},
    {&CardA::lcidab, integer("lcidab", 0, any_value, "curve of airbag contact")},
    {&CardA::maxpar, real("maxpar", dimension::number, 1.025, any_value, "extension of segments")},
    real("sbopt", dimension::number, 2, any_value, "soft 2: segments may be warped and hand contacts on in any case"),
    {&CardA::depth,
     integer("depth", 2, any_value, "soft 2: from 3 on edges of shells too; else all pairs are found in any case")},
    {&CardA::bsort, integer("bsort", 0, any_value, "cycles between searches; 0: chosen by the program")},
    {&CardA::frcfrq, integer("frcfrq", 1, any_value, "cycles between forces; here each cycle")},
};
struct CardB {
  double penmax = 0;
  int snlog = 0, isym = 0, i2d3d = 0;
  double sldthk = 0, sldstf = 0;
};
const CardOf<CardB> card_b{
    {&CardB::penmax,
     real("penmax", dimension::number, 0, at_least(0), "a node deeper than so many thicknesses is released; 0: never")},
    integer("thkopt", 0, any_value, "thickness option of contacts that are not automatic"),
    integer("shlthk", 0, any_value, "the same"),
    {&CardB::snlog, integer("snlog", 0, any_value, "nodes that penetrate far within a cycle")},
    {&CardB::isym, integer("isym", 0, any_value, "symmetry planes")},
    {&CardB::i2d3d, integer("i2d3d", 0, any_value, "which elements give segments")},
    {&CardB::sldthk, real("sldthk", dimension::length, 0, any_value, "thickness on solids")},
    {&CardB::sldstf, real("sldstf", dimension::stress, 0, any_value, "stiffness on solids")},
};
struct CardC {
  int igap = 0, ignore = 0;
  double dprfac = 0, dtstif = 0, edgek = 0, flangl = 0;
  int cid_rcf = 0;
};
const CardOf<CardC> card_c{
    {&CardC::igap, integer("igap", 1, any_value, "convergence of implicit runs")},
    {&CardC::ignore, integer("ignore", 0, between(0, 2),
                             "initial penetrations: 0 by the control card, 1 tracked, 2 tracked and reported")},
    {&CardC::dprfac,
     real("dprfac", dimension::number, 0, any_value, "soft 2: initial overlap that is given up with time")},
    {&CardC::dtstif, real("dtstif", dimension::time, 0, any_value,
                          "step for which soft 1 and 2 find their stiffness; 0: that of the run")},
    {&CardC::edgek, real("edgek", dimension::number, 0, any_value, "stiffness of edges")},
    unused(),
    {&CardC::flangl, real("flangl", dimension::number, 0, any_value, "angle of feature lines")},
    {&CardC::cid_rcf, id("cid_rcf", IdSpace::define, 0, "coordinate system of rcforc")},
};
struct CardD {
  int q2tri = 0;
  double dtpchk = 0, sfnbr = 0, fnlscl = 0, dnlscl = 0;
  int tcso = 0, shledg = 0;
};
const CardOf<CardD> card_d{
    {&CardD::q2tri, integer("q2tri", 0, any_value, "quadrilaterals as triangles")},
    {&CardD::dtpchk, real("dtpchk", dimension::time, 0, any_value, "time between reports of penetration")},
    {&CardD::sfnbr, real("sfnbr", dimension::number, 0, any_value, "scale of neighbours")},
    {&CardD::fnlscl, real("fnlscl", dimension::number, 0, any_value, "scale of a nonlinear force")},
    {&CardD::dnlscl, real("dnlscl", dimension::number, 0, any_value, "distance of that force")},
    {&CardD::tcso, integer("tcso", 0, any_value, "thickness from the section")},
    integer("tiedid", 0, between(0, 1), "of ties: 1 by increments of displacement, as they follow in any case"),
    {&CardD::shledg, integer("shledg", 0, any_value, "shell edges")},
};
struct CardE {
  int cparm8 = 0, ipback = 0, srnde = 0;
  double fricsf = 0;
  int icor = 0, ftorq = 0, region = 0;
};
const CardOf<CardE> card_e{
    integer("sharec", 0, any_value, "shared constraints"),
    {&CardE::cparm8, integer("cparm8", 0, any_value,
                             "_GENERAL: 1 beams of one part do not press each other; 2 and weld beams take part")},
    {&CardE::ipback,
     integer("ipback", 0, any_value, "ties: not 0: springs where a node or its segment is constrained already")},
    {&CardE::srnde, integer("srnde", 0, any_value, "round edges of shells")},
    {&CardE::fricsf, real("fricsf", dimension::number, 1, any_value, "scale of the stiffness of friction")},
    {&CardE::icor, integer("icor", 0, any_value, "restitution")},
    {&CardE::ftorq, integer("ftorq", 0, between(0, 1), "1: the moments of friction are balanced")},
    {&CardE::region, integer("region", 0, any_value, "region of contact")},
};
struct CardF {
  int pstiff = 0, ignroff = 0, ssftyp = 0, swtpr = 0;
  double tetfac = 0;
};
const CardOf<CardF> card_f{
    {&CardF::pstiff, integer("pstiff", 0, any_value, "how the stiffness is found")},
    {&CardF::ignroff, integer("ignroff", 0, any_value, "thickness offsets")},
    unused(),
    real("fstol", dimension::number, 2, any_value, "tolerance of smoothing"),
    integer("2dbinr", 0, any_value, "two-dimensional binning"),
    {&CardF::ssftyp, integer("ssftyp", 0, any_value, "which scale holds")},
    {&CardF::swtpr, integer("swtpr", 0, any_value, "use of thickness")},
    {&CardF::tetfac, real("tetfac", dimension::number, 0, any_value, "stiffness of tetrahedra")},
};

struct CardG {
  double shloff = 0;
};
const CardOf<CardG> card_g{
    unused(),
    {&CardG::shloff,
     real("shloff", dimension::number, 0, any_value, "contact surfaces of shells that lie off their nodes")},
};

constexpr std::string_view left = "not built: runs as with the default";

void take_a(Builder& builder, const RowOf<CardA>& row, Contact& contact) {
  contact.soft = row->soft;
  contact.soft_scale = row->sofscl;
  contact.search_interval = std::max(0, row->bsort);
  if (contact.tie()) return;  // of these fields none acts on a constraint
  expect(builder, Severity::note,
         {{row[&CardA::maxpar], 1.025, "segments are extended as with 1.025"},
          {row[&CardA::frcfrq], 1, "forces are found in each cycle"}});
  contact.depth = row->depth;
  if (contact.soft == 2 && contact.keyword.find("NODES_TO_SURFACE") != std::string::npos) {
    row[&CardA::soft].report(builder.findings, Severity::warning,
                             "a contact of nodes has no segments on one side; it runs as with soft = 1",
                             "use a contact of surfaces for segment-based contact");
    contact.soft = 1;
  }
  if (contact.soft < 0 || contact.soft > 2)
    refuse(builder, row[&CardA::soft], "this form of the penalty is not built; expected 0, 1 or 2",
           "use 2 for segment-based contact");
  if (contact.soft == 2 && contact.depth < 0)
    refuse(builder, row[&CardA::depth], "a depth by curve is not built; expected 0 or more", "give the depth");
  expect(builder, Severity::error, {{row[&CardA::lcidab], 0, "airbag contact is not built"}});
}

void take_b(Builder& builder, const RowOf<CardB>& row, Contact& contact) {
  if (contact.tie()) return;
  expect(builder, Severity::error,
         {{row[&CardB::sldthk], 0, "a contact thickness on solids is not built"},
          {row[&CardB::sldstf], 0, "a contact stiffness on solids is not built"}});
  expect(builder, Severity::warning,
         {{row[&CardB::snlog], 0, left}, {row[&CardB::isym], 0, left}, {row[&CardB::i2d3d], 0, left}});
  contact.deepest = row->penmax;
}

void take_c(Builder& builder, const RowOf<CardC>& row, Contact& contact) {
  if (const int ignore = row->ignore; ignore != 0) contact.ignore = ignore;
  if (contact.tie()) return;
  if (contact.keyword.find("MORTAR") != std::string::npos)
    expect(builder, Severity::warning, {{row[&CardC::igap], 1, left}});
  contact.soft_step = row->dtstif;
  if (contact.soft_step < 0.0)
    refuse(builder, row[&CardC::dtstif], "a step by a curve or by a running mean is not built; expected 0 or a step",
           "leave it 0 for the step of the run, or give the step");
  expect(builder, Severity::warning,
         {{row[&CardC::dprfac], 0, "not built: what overlaps at the start keeps its offset, as with 0"},
          {row[&CardC::edgek], 0, left},
          {row[&CardC::flangl], 0, left},
          {row[&CardC::cid_rcf], 0, "forces are written in global axes"}});
}

void take_d(Builder& builder, const RowOf<CardD>& row, const Contact& contact) {
  if (contact.tie()) return;
  expect(builder, Severity::warning,
         {{row[&CardD::q2tri], 0, left},
          {row[&CardD::dtpchk], 0, left},
          {row[&CardD::sfnbr], 0, left},
          {row[&CardD::fnlscl], 0, left},
          {row[&CardD::dnlscl], 0, left},
          {row[&CardD::tcso], 0, left},
          {row[&CardD::shledg], 0, left}});
}

void take_e(Builder& builder, const RowOf<CardE>& row, Contact& contact) {
  if (contact.tie()) {
    contact.penalty_fallback = row->ipback != 0;
    return;
  }
  take_cparm8(builder, row[&CardE::cparm8], contact);
  contact.balances_friction = row->ftorq != 0;
  if (row->icor != 0) {
    row[&CardE::icor].report(builder.findings, Severity::warning,
                             "restitution in percent (VDC) is not built: this contact is not damped",
                             "give VDC in percent of critical damping, without ICOR");
    contact.damping = 0.0;
  }
  expect(builder, Severity::warning,
         {{row[&CardE::srnde], 0, left}, {row[&CardE::region], 0, left}, {row[&CardE::fricsf], 1, left}});
}

void take_f(Builder& builder, const RowOf<CardF>& row, const Contact& contact) {
  if (contact.tie()) return;
  expect(builder, Severity::warning,
         {{row[&CardF::pstiff], 0, left},
          {row[&CardF::ignroff], 0, left},
          {row[&CardF::ssftyp], 0, left},
          {row[&CardF::swtpr], 0, left},
          {row[&CardF::tetfac], 0, left}});
}

void take_g(Builder& builder, const RowOf<CardG>& row) {
  expect(builder, Severity::warning,
         {{row[&CardG::shloff], 0, "not obeyed: contact surfaces lie about the mid-surface, as with 0"}});
}

}  // namespace

void take_cparm8(Builder& builder, const deck::Entry& field, Contact& contact) {
  if (contact.keyword.find("GENERAL") == std::string::npos)
    return expect(builder, Severity::warning, {{field, 0, "has an effect in _GENERAL alone"}});
  const int value = field.integer(), beams = value % 10;
  if (value < 0 || beams > 2 || value / 10 > 1) return refuse(builder, field, "expected 0, 1 or 2, or 10 more");
  if (value >= 10)
    field.report(builder.findings, Severity::warning,
                 "not obeyed: the bars around shell edges are not shifted into the shells");
  if (beams > 0) contact.parts_apart = true;
  if (beams == 2) contact.takes_welds = true;
}

std::vector<LayoutCard> optional_contact_layout() {
  return {{"optional card A", &card_a}, {"optional card B", &card_b}, {"optional card C", &card_c},
          {"optional card D", &card_d}, {"optional card E", &card_e}, {"optional card F", &card_f},
          {"optional card G", &card_g}};
}

void read_optional_contact_cards(Builder& builder, Cursor& cursor, Contact& contact) {
  if (cursor.more()) take_a(builder, cursor.read(card_a), contact);
  if (cursor.more()) take_b(builder, cursor.read(card_b), contact);
  if (cursor.more()) take_c(builder, cursor.read(card_c), contact);
  if (cursor.more()) take_d(builder, cursor.read(card_d), contact);
  if (cursor.more()) take_e(builder, cursor.read(card_e), contact);
  if (cursor.more()) take_f(builder, cursor.read(card_f), contact);
  if (cursor.more() && !contact.tie())
    take_g(builder, cursor.read(card_g));
  else if (cursor.more())
    cursor.read(card_g);
  expect_end(builder, cursor);
}

}  // namespace nugget::reading
