// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *CONTROL_..., *TITLE. Fields that only tune an algorithm that this program does otherwise are read past, and their
// meaning says so; a field that would change the physics and is not built is an error at any value but its default.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

constexpr IntegerField flag(std::string_view name, std::string_view meaning) {
  return integer(name, 0, any_value, meaning);
}
constexpr RealField factor(std::string_view name, double fallback, std::string_view meaning) {
  return real(name, dimension::number, fallback, any_value, meaning);
}

const Card model_title_card{{text("title", 80, "title of the model")}};

struct TerminationCard : Control {
  int endcyc = 0;
};
const CardOf<TerminationCard> termination_card{
    {&TerminationCard::end_time, real("endtim", dimension::time, 0, at_least(0), "end time")},
    {&TerminationCard::endcyc, integer("endcyc", 0, at_least(0), "last cycle; 0: no limit")},
    {&TerminationCard::smallest_step,
     real("dtmin", dimension::number, 0, at_least(0), "stop below this share of the first time step; 0: never")},
    {&TerminationCard::energy_limit,
     real("endeng", dimension::number, 0, at_least(0), "stop at this change of the energy ratio in percent; 0: never")},
    {&TerminationCard::added_mass_limit,
     real("endmas", dimension::number, 1e8, at_least(0), "stop at this share of added mass in percent")},
    integer("nosol", 0, only(0), "reading without a run: `nugget check` does that"),
};

struct StepCard {
  double dtinit = 0, tssfac = 0;
  int isdo = 0;
  double tslimt = 0, dt2ms = 0;
  int lctm = 0, erode = 0, ms1st = 0;
};
const CardOf<StepCard> step_card{
    {&StepCard::dtinit, real("dtinit", dimension::time, 0, at_least(0), "first time step; 0: computed")},
    {&StepCard::tssfac, real("tssfac", dimension::number, 0.9, any_value, "factor on the stable time step")},
    {&StepCard::isdo, integer("isdo", 0, between(0, 2),
                              "length of shells: 0 area over longest side, 1 over diagonal, 2 bar wave speed")},
    {&StepCard::tslimt, real("tslimt", dimension::time, 0, any_value,
                             "softening of shells to hold a time step: not built; above 0 beside dt2ms: no effect")},
    {&StepCard::dt2ms, real("dt2ms", dimension::time, 0, any_value,
                            "mass scaling: time step that is to be held; below 0: where needed only")},
    {&StepCard::lctm, id("lctm", IdSpace::function, 0, "curve: largest time step over time")},
    {&StepCard::erode,
     integer(
         "erode", 0, at_least(0),
         "1: bricks below dtmin or of negative volume are deleted, 10: shells below dtmin, 100: beams; or their sum")},
    {&StepCard::ms1st, integer("ms1st", 0, between(0, 1), "1: masses are scaled at the start only")},
};

struct StepCard2 {
  double emscl = 0;
};
const CardOf<StepCard2> step_card_2{
    real("dt2msf", dimension::number, 0, only(0), "mass scaling by a factor on the first step"),
    integer("dt2mslc", 0, only(0), "mass scaling over time"),
    integer("imscl", 0, only(0), "selective mass scaling"),
    unused(),
    unused(),
    real("rmscl", dimension::number, 0, only(0), "selective mass scaling of rotations"),
    {&StepCard2::emscl,
     real("emscl", dimension::number, 0, between(0, 1), "share of the mass added by scaling on which body loads act")},
    flag("ihdo", "step of solids, no effect"),
};

struct StepCard3 {
  double rmavg = 0;
};
const CardOf<StepCard3> step_card_3{
    {&StepCard3::rmavg, real("rmavg", dimension::inertia, 0, at_least(0), "inertia of tied nodes, not obeyed")},
    flag("igado", "isogeometric shells, no effect"),
    real("dtusr", dimension::time, 0, only(0), "time step of user routines"),
    flag("dtdynv", "no effect"),
};

struct RelaxationCard : Relaxation {
  int idrflg = 0;
};
const CardOf<RelaxationCard> control_relaxation_card{
    {&RelaxationCard::check_cycles, integer("nrcyck", 250, at_least(1), "cycles between the checks")},
    {&RelaxationCard::tolerance,
     real("drtol", dimension::number, 0.001, above_zero(), "at rest: kinetic energy over the largest so far")},
    {&RelaxationCard::factor,
     real("drfctr", dimension::number, 0.995, between(0, 1), "factor on all velocities in every cycle")},
    {&RelaxationCard::end_time,
     real("drterm", dimension::time, 0, at_least(0), "end of the relaxation, at rest or not; 0: none")},
    {&RelaxationCard::step_scale, real("tssfdr", dimension::number, 0, between(0, 1), "in place of TSSFAC; 0: TSSFAC")},
    integer("irelal", 0, only(0), "automatic choice of the factor (Papadrakakis): not built"),
    real("edttl", dimension::number, 0.04, any_value, "of that choice, no effect"),
    {&RelaxationCard::idrflg,
     integer("idrflg", 0, any_value, "1: relaxation; 0: if a curve with SIDR 1 or 2 asks for it; -999: never")},
};

struct ContactCard1 {
  double slsfac = 0, rwpnal = 0;
  int penopt = 0, thkchg = 0, enmass = 0;
};
const CardOf<ContactCard1> contact_card_1{
    {&ContactCard1::slsfac, real("slsfac", dimension::number, 0.1, above_zero(), "penalty factor")},
    {&ContactCard1::rwpnal,
     factor("rwpnal", 0, "0: rigid walls do not stop rigid bodies; above: by penalty, with this scale")},
    flag("islchk", "check of initial penetration, no effect"),
    flag("shlthk", "for contacts that are not automatic, no effect"),
    {&ContactCard1::penopt, integer("penopt", 1, any_value, "choice of the penalty stiffness: 1")},
    {&ContactCard1::thkchg, flag("thkchg", "1: thinning of shells in contact")},
    flag("orien", "turning of segments, no effect on automatic contacts"),
    {&ContactCard1::enmass,
     integer("enmass", 0, between(0, 2),
             "nodes without elements in eroding contact: 0 leave it, 1 of bricks stay, 2 all stay")},
};

struct ContactCard2 {
  int ssthk = 0, tiedprj = 0;
};
const CardOf<ContactCard2> contact_card_2{
    integer("usrstr", 0, only(0), "user routines"),
    integer("usrfrc", 0, only(0), "user routines"),
    flag("nsbcs", "cycles between searches, chosen by the program"),
    flag("interm", "for contacts that are not automatic, no effect"),
    factor("xpene", 4, "for contacts that are not automatic, no effect"),
    {&ContactCard2::ssthk, integer("ssthk", 0, between(0, 1), "1: full shell thickness in single surface contact")},
    flag("ecdt", "for eroding contact, no effect"),
    {&ContactCard2::tiedprj, integer("tiedprj", 0, between(0, 1), "1: tied nodes stay where they are")},
};

struct ContactCard3 {
  double sfric = 0, dfric = 0, edc = 0, vfc = 0, th = 0, th_sf = 0, pen_sf = 0;
};
const CardOf<ContactCard3> contact_card_3{
    {&ContactCard3::sfric, real("sfric", dimension::number, 0, at_least(0),
                                "static friction of parts that give none, for contacts with FS = -1")},
    {&ContactCard3::dfric, real("dfric", dimension::number, 0, at_least(0), "dynamic friction of these")},
    {&ContactCard3::edc, real("edc", {0, -1, 1}, 0, at_least(0), "decay of their friction")},
    {&ContactCard3::vfc, real("vfc", dimension::stress, 0, at_least(0), "viscous friction of these")},
    {&ContactCard3::th, real("th", dimension::length, 0, at_least(0), "OPTT of parts that give none")},
    {&ContactCard3::th_sf, real("th_sf", dimension::number, 0, at_least(0), "SFT of parts whose own is 1; 0: 1")},
    {&ContactCard3::pen_sf, real("pen_sf", dimension::number, 0, at_least(0), "SSF of parts whose own is 1; 0: 1")},
    factor("ptscl", 1, "contact stress on shells of formulations 25 to 27, no effect"),
};

struct ContactCard4 {
  int ignore = 0, outseg = 0, spotstp = 0, spotdel = 0;
  double spothin = 0;
};
const CardOf<ContactCard4> contact_card_4{
    {&ContactCard4::ignore,
     integer("ignore", 0, between(0, 2), "initial penetration: 0 nodes are moved, 1 2 it is kept")},
    flag("frceng", "friction in the file of contact surfaces, which is not written; sleout has it, no effect"),
    flag("skiprwg", "pictures of rigid walls, no effect"),
    {&ContactCard4::outseg, integer("outseg", 0, between(0, 1), "1: list weld nodes and their segments")},
    {&ContactCard4::spotstp,
     integer("spotstp", 0, between(0, 3), "weld without a sheet: 0 warn, 1 stop, 2 delete it, 3 keep it")},
    {&ContactCard4::spotdel,
     integer("spotdel", 0, between(0, 1),
             "when the shells that a weld is tied to are deleted: 0 its nodes are released, 1 it is deleted too")},
    {&ContactCard4::spothin, real("spothin", dimension::number, 0, between(0, 1),
                                  "factor on the contact thickness of shells near welds; 0: as it is")},
    flag("dir_tie", "of LS-DYNA over several processes, no effect"),
};

struct ContactCard5 {
  double swradf = 0;
};
const CardOf<ContactCard5> contact_card_5{
    flag("isym", "for symmetry planes in old contacts, no effect"),
    flag("nserod", "for eroding contact, no effect"),
    integer("rwgaps", 1, any_value, "for rigid walls by penalty, no effect"),
    factor("rwgdth", 0, "for rigid walls by penalty, no effect"),
    factor("rwksf", 1, "for rigid walls by penalty, no effect"),
    flag("icov", "for eroding contact, no effect"),
    {&ContactCard5::swradf, real("swradf", dimension::number, 0, at_least(0),
                                 "SPOTHIN thins shells within this many radii of a weld; 0: those that it is tied to")},
    flag("ithoff", "thermal, no effect"),
};

struct ContactCard6 {
  int shledg = 0, pstiff = 0;
  double shltrw = 0;
};
const CardOf<ContactCard6> contact_card_6{
    {&ContactCard6::shledg, flag("shledg", "1: square shell edges in contact")},
    {&ContactCard6::pstiff, flag("pstiff", "1: penalty stiffness from nodal masses")},
    flag("ithcnt", "thermal, no effect"),
    flag("tdcnof", "for ties with constrained offset, no effect"),
    flag("ftall", "output of force transducers, no effect"),
    unused(),
    {&ContactCard6::shltrw,
     real("shltrw", dimension::number, 0, between(0, 1), "share of the shell thickness at rigid walls")},
    flag("igactc", "isogeometric shells, no effect"),
};

const Card contact_card_7{{
    flag("irevspt", "older behaviour of SPOTHIN, no effect"),
    unused(),
    flag("cohtiem", "for cohesive elements, no effect"),
    flag("tieopt", "storage of ties, no effect"),
    flag("strobj", "no effect"),
    factor("befblk", 0, "no effect"),
}};

struct ShellCard1 {
  double wrpang = 0;
  int esort = 0, istupd = 0, theory = 0, bwc = 0, proj = 0;
};
const CardOf<ShellCard1> shell_card_1{
    {&ShellCard1::wrpang, real("wrpang", dimension::number, 20, at_least(0), "warpage that is warned of [degrees]")},
    {&ShellCard1::esort,
     integer("esort", 0, between(0, 2), "collapsed quads are computed as triangles: 1 of formulation 4, 2 of 17")},
    integer("irnxx", -1, any_value, "update of normals of other formulations, no effect"),
    {&ShellCard1::istupd,
     integer("istupd", 0, any_value, "1: membrane strain thins the shells; 0: not; 4: plastic strain does")},
    {&ShellCard1::theory, integer("theory", 2, any_value, "formulation of sections that name none")},
    {&ShellCard1::bwc,
     integer("bwc", 2, between(1, 2), "warping stiffness of Belytschko, Wong and Chiang: 1 on, 2 off")},
    integer("miter", 1, any_value, "plane stress iteration; always run to a residual here"),
    {&ShellCard1::proj, integer("proj", 0, any_value, "1: full projection of the warping stiffness")},
};

struct ShellCard2 {
  double rotascl = 0;
  int intgrd = 0, lamsht = 0, nfail1 = 0, nfail4 = 0;
};
const CardOf<ShellCard2> shell_card_2{
    {&ShellCard2::rotascl, real("rotascl", dimension::number, 1, only(1), "factor on rotary masses")},
    {&ShellCard2::intgrd, integer("intgrd", 0, between(0, 1), "layers: 0 Gauss, 1 Lobatto")},
    {&ShellCard2::lamsht,
     integer(
         "lamsht", 0, between(0, 5),
         "1, 3, 5: transverse shear of layers that cards give by laminated shell theory; 4: thick shells, no effect")},
    flag("cstyp6", "for formulation 6, no effect"),
    flag("thshel", "thermal, no effect"),
    {&ShellCard2::nfail1, integer("nfail1", 0, at_least(0), "as on the fourth card: where LS-DYNA 971 had it")},
    {&ShellCard2::nfail4, integer("nfail4", 0, at_least(0), "the same")},
    flag("psnfail", "the same"),
};

struct ShellCard3 {
  int cntco = 0;
};
const CardOf<ShellCard3> shell_card_3{
    integer("pstupd", 0, only(0), "parts whose thickness changes; all do"),
    flag("sidt4tu", "thermal, no effect"),
    {&ShellCard3::cntco, integer("cntco", 0, any_value, "offset of the contact surface with NLOC")},
    flag("itsflg", "initial transverse shear, no effect"),
    integer("irquad", 3, any_value, "for shells of eight nodes, no effect"),
    real("w_mode", dimension::number, 0, only(0), "deletion by w-mode"),
    real("stretch", dimension::number, 0, only(0), "deletion by stretch"),
    flag("icrq", "for composites, no effect"),
};

struct ShellCard4 {
  int nfail1 = 0, nfail4 = 0, psnfail = 0, keepcs = 0, delfr = 0, drcpsid = 0;
  double drcprm = 0;
};
const CardOf<ShellCard4> shell_card_4{
    {&ShellCard4::nfail1, integer("nfail1", 0, at_least(0),
                                  "1: shells of one in-plane point with a corner inside out are deleted; 2: they stop "
                                  "the run; above 2: they are "
                                  "deleted, and so many failed shells stop it")},
    {&ShellCard4::nfail4, integer("nfail4", 0, at_least(0), "the same for fully integrated shells")},
    {&ShellCard4::psnfail, id("psnfail", IdSpace::set, 0, "part set that NFAIL1 and NFAIL4 are about; 0: all shells")},
    {&ShellCard4::keepcs, flag("keepcs", "1: contact segments of failed shells stay, not obeyed")},
    {&ShellCard4::delfr, integer("delfr", 0, any_value, "1: free shells are deleted")},
    {&ShellCard4::drcpsid,
     id("drcpsid", IdSpace::set, 0, "part set with stiffness against drilling rotations, of formulation 16 or 4")},
    {&ShellCard4::drcprm,
     real("drcprm", dimension::number, 1, at_least(0), "factor on that stiffness; 1: a tenth of G t^3 a shell")},
    flag("intperr", "message of stress initialization, no effect"),
};

const Card shell_card_5{{
    flag("drcmth", "method of the drilling constraint; there is one here"),
    flag("lispsid", "implicit, no effect"),
    flag("nlocdt", "shorter step with NLOC: rotary inertia is raised instead, no effect"),
    flag("iswshl", "no effect"),
}};

const CardOf<Hourglass> control_hourglass_card{
    {&Hourglass::type,
     integer("ihq", 0, between(0, 10), "type: shells 1-3 viscous, 4 5 stiffness; solids 1-3 viscous; 0: 1")},
    {&Hourglass::membrane, real("qh", dimension::number, 0.1, at_least(0), "coefficient")},
};

const CardOf<Control> bulk_card{
    {within(&Control::hourglass, &Hourglass::bulk_quadratic),
     real("q1", dimension::number, 1.5, any_value, "quadratic bulk viscosity")},
    {within(&Control::hourglass, &Hourglass::bulk_linear),
     real("q2", dimension::number, 0.06, any_value, "linear bulk viscosity")},
    {&Control::bulk_viscosity_type,
     integer("type", 1, between(-2, 1), "1 solids; -1 shells too, -2 with their energy")},
    flag("btype", "for beams of formulation 1 and 11, no effect"),
    flag("tstype", "for thick shells, no effect"),
};

struct EnergyCard {
  int hgen = 0, rwen = 0, slnten = 0, rylen = 0;
};
const CardOf<EnergyCard> energy_card{
    {&EnergyCard::hgen,
     integer("hgen", 1, between(1, 2), "2: glstat has the hourglass energy; its total has it with 1 too")},
    {&EnergyCard::rwen, integer("rwen", 2, between(1, 2), "energy of rigid walls is written and counted, as with 2")},
    {&EnergyCard::slnten, integer("slnten", 1, between(1, 2), "the same of contacts")},
    {&EnergyCard::rylen, integer("rylen", 1, between(1, 2), "the same of damping")},
    integer("irgen", 2, any_value, "reference geometry, no effect"),
    integer("maten", 1, any_value, "shares of the internal energy, no effect"),
    integer("drlen", 1, any_value, "drilling energy, no effect"),
    integer("disen", 1, any_value, "energy of discrete elements, no effect"),
};

struct AccuracyCard {
  int osu = 0, inn = 0;
};
const CardOf<AccuracyCard> accuracy_card{
    {&AccuracyCard::osu,
     integer("osu", 0, between(0, 1), "1: second-order stress update; of ELFORM 2, others always have it")},
    {&AccuracyCard::inn,
     integer(
         "inn", 1, any_value,
         "invariant node numbering; shells always have it, 2 and 4 in their results too (axes of elout, resultants)")},
    id("pidos", IdSpace::set, 0, "parts of OSU, no effect"),
    flag("iacc", "implicit, no effect"),
    factor("exacc", 0, "implicit, no effect"),
    flag("srtflg", "no effect"),
};

const Card control_solution_card{{
    integer("soln", 0, only(0), "0: structural; heat conduction is not built"),
    flag("nlq", "vector length, no effect"),
    flag("isnan", "a force that is not a number ends the run in any case"),
    integer("lcint", 100, any_value, "curves are taken as they are given, not at equal spaces"),
    flag("lcacc", "truncation of curves, no effect"),
    integer("ncdcf", 1, any_value, "no effect"),
    flag("nocopy", "no effect"),
    flag("crvp", "listing of curves, no effect"),
}};

struct SolidCard1 {
  int esort = 0, niptets = 0, psfail = 0;
};
const CardOf<SolidCard1> solid_card_1{
    {&SolidCard1::esort, integer("esort", 0, between(0, 4), "1 to 4: tetrahedra become formulation 10, wedges 15")},
    flag("fmatrx", "deformation gradient of other laws, no effect"),
    {&SolidCard1::niptets, integer("niptets", 4, any_value, "points of tetrahedra of ten nodes; always 4")},
    integer("swlocl", 1, any_value, "axes of the stresses of brick welds, no effect"),
    {&SolidCard1::psfail,
     id("psfail", IdSpace::set, 0, "part set whose bricks of negative volume are deleted; others stop the run")},
    factor("t10jtol", 0, "warning about misshapen tetrahedra of ten nodes, no effect"),
    flag("icoh", "for cohesive elements, no effect"),
    flag("tet13k", "for formulation 13, no effect"),
};

struct OutputCard1 {
  int iaccop = 0;
};
const CardOf<OutputCard1> output_card_1{
    flag("npopt", "listing, no effect"),
    flag("neecho", "listing, no effect"),
    flag("nrefup", "reference nodes of beams, no effect"),
    {&OutputCard1::iaccop, integer("iaccop", 0, between(0, 1), "1: nodout has accelerations averaged between outputs")},
    real("opifs", dimension::time, 0, any_value, "interface file, no effect"),
    flag("ipnint", "listing, no effect"),
    integer("ikedit", 100, any_value, "listing, no effect"),
    integer("iflush", 5000, any_value, "buffers, no effect"),
};
struct OutputCard2 {
  int tet10s8 = 0, eocs = 0;
};
const CardOf<OutputCard2> output_card_2{
    integer("iprtf", 0, any_value, "listing, no effect"),
    integer("ierode", 0, any_value, "output of eroded energies, no effect"),
    {&OutputCard2::tet10s8,
     integer("tet10s8", 2, any_value, "nodes of ten-node tetrahedra in d3plot: 2 corners; 1 all, not obeyed")},
    integer("msgmax", 50, any_value, "messages, no effect"),
    integer("ipcurv", 0, any_value, "listing, no effect"),
    real("gmdt", dimension::time, 0, any_value, "interval of generalised masses, no effect"),
    integer("ip1dblt", 0, any_value, "output of pretensioned bars, no effect"),
    {&OutputCard2::eocs,
     integer("eocs", 0, between(0, 2),
             "axes of shells in elout: 1 the element's, 2 global; 0: the element's, or with CMPFLG 1 the material's")},
};

/// The card of a keyword that has one, read into what is there.
template <class Values>
RowOf<Values> read_one(Builder& b, const Block& block, const CardOf<Values>& card, Values& into) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(card, into);
  expect_end(b, cursor);
  return row;
}

void read_model_title(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  b.model.title = cursor.read_text();
}

void read_termination(Builder& b, const Block& block, const Options&) {
  TerminationCard card{b.model.control};
  const auto row = read_one(b, block, termination_card, card);
  card.end_time_place = row[&TerminationCard::end_time].place;
  card.end_cycle = card.endcyc;
  b.model.control = card;
}

void read_time_step(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(step_card);
  const auto second = cursor.read(step_card_2);
  const auto third = cursor.read(step_card_3);
  expect_end(b, cursor);
  if (row->tslimt > 0.0 && row->dt2ms != 0.0)
    row[&StepCard::tslimt].report(b.findings, Severity::note, "no effect beside DT2MS, as in LS-DYNA");
  else if (row->tslimt != 0.0)
    refuse(b, row[&StepCard::tslimt], "softening of shells to hold a time step is not built",
           "write 0, and DT2MS below 0 for mass scaling");
  if (row->tssfac < 0.0)
    refuse(b, row[&StepCard::tssfac], "a factor over time (curve) is not supported", "give a number");
  if (row->tssfac > 1.0)
    row[&StepCard::tssfac].report(b.findings, Severity::warning,
                                  "a step longer than the stable one: the run will diverge", "give 0.9 or less");
  Control& c = b.model.control;
  c.first_step = row->dtinit;
  c.step_scale = row->tssfac;
  const auto tssfac = row[&StepCard::tssfac];
  // A written 0 is the default, too.
  c.step_scale_given = !tssfac.blank && tssfac.text.find_first_of("123456789&") != std::string::npos;
  c.step_scale_place = tssfac.place;
  c.length_basis = row->isdo;
  c.mass_step = row->dt2ms;
  c.erode_small_steps = row->erode;
  if (const int kinds = c.erode_small_steps; kinds % 10 > 1 || kinds / 10 % 10 > 1 || kinds / 100 > 1)
    refuse(b, row[&StepCard::erode], "expected 1 (solids), 10 (shells), 100 (beams), a sum of these, or 0",
           "write the sum of the kinds that are to be deleted");
  c.mass_scaling_at_start_only = row->ms1st == 1;
  c.weight_of_added_mass = second->emscl;
  expect(b, Severity::warning,
         {{third[&StepCard3::rmavg], 0, "not obeyed: tied nodes of solids get no rotary inertia by it, as with 0"}});
  b.defer(Phase::conditions, [row](Builder& later) {
    const Index curve = later.curve(row[&StepCard::lctm]);
    later.model.control.step_curve = curve;
    if (curve != none && std::ranges::any_of(later.model.curves[curve].y, [](double y) { return !(y > 0.0); }))
      refuse(later, row[&StepCard::lctm], "a largest time step of this curve is not above 0", "give ordinates above 0");
  });
}

void check_wall_penalty(Builder& b, const RowOf<ContactCard1>& row) {
  if (!(row->rwpnal < 0.0) || b.model.walls.empty()) return;
  row[&ContactCard1::rwpnal].report(
      b.findings, Severity::warning,
      "below 0, all nodes by penalty, is not obeyed: rigid walls stop nodes of rigid bodies by penalty, with "
      "its size as the scale, all others by constraint",
      "give the positive number");
}

/// TH, TH_SF, PEN_SF: what *PART_CONTACT says of a part is left as it is.
void set_part_defaults(Builder& b, const RowOf<ContactCard3>& row) {
  const double thickness = row->th, scale = row->th_sf, stiffness = row->pen_sf;
  for (Part& part : b.model.parts) {
    if (part.contact_thickness == 0.0) part.contact_thickness = thickness;
    if (part.contact_scale == 1.0 && scale > 0.0) part.contact_scale = scale;
    if (part.stiffness_scale == 1.0 && stiffness > 0.0) part.stiffness_scale = stiffness;
  }
}

void read_control_contact(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto one = cursor.read(contact_card_1);
  const auto two = cursor.read(contact_card_2);
  const auto three = cursor.read(contact_card_3);
  const auto four = cursor.read(contact_card_4);
  const auto five = cursor.read(contact_card_5);
  const auto six = cursor.read(contact_card_6);
  cursor.read(contact_card_7);
  expect_end(b, cursor);
  expect(b, Severity::warning,
         {{one[&ContactCard1::penopt], 1, "not obeyed: the smaller stiffness of node and segment is used, as with 1"},
          {one[&ContactCard1::thkchg], 0, "not obeyed: contact sees the initial thickness, as with 0"},
          {six[&ContactCard6::shledg], 0, "not obeyed: shell edges are round, as with 0"},
          {six[&ContactCard6::shltrw], 0, "not obeyed: rigid walls stop the mid-surface of shells, as with 0"},
          {six[&ContactCard6::pstiff], 0, "not obeyed: penalty stiffness comes from the material, as with 0"}});
  b.defer(Phase::checks, [one](Builder& later) { check_wall_penalty(later, one); });
  b.defer(Phase::conditions, [three](Builder& later) { set_part_defaults(later, three); });
  Control& c = b.model.control;
  c.penalty_scale = one->slsfac;
  c.wall_penalty = std::abs(one->rwpnal);
  c.keep_tied_gap = two->tiedprj == 1;
  c.keep_nodes_of_deleted = one->enmass;
  c.part_friction = {three->sfric, three->dfric, three->edc, three->vfc};
  c.ignore_penetration = four->ignore;
  c.full_thickness = two->ssthk == 1;
  c.list_ties = four->outseg == 1;
  c.untied_weld = four->spotstp;
  c.untied_weld_place = four[&ContactCard4::spotstp].place;
  c.weld_of_deleted_shell = four->spotdel;
  c.weld_thinning = four->spothin;
  c.weld_thinning_radius = five->swradf;
}

/// Gives the shells of DRCPSID stiffness against drilling. LS-DYNA's own amount is not published; ours is tried in
/// docs/decisions/0018.
void resist_drilling(Builder& b, const RowOf<ShellCard4>& row) {
  const auto* parts = b.part_set(row[&ShellCard4::drcpsid]);
  if (parts == nullptr) return;
  for (const Index p : parts->members) {
    Part& part = b.model.parts[p];
    if (part.kind != ElementKind::shell || part.section == none) continue;
    const int elform = b.model.shell_sections[part.section].elform;
    if (elform == 2 || is_membrane(elform))
      refuse(b, row[&ShellCard4::drcpsid],
             fmt::format("part {} has shells of formulation {}, which cannot resist drilling", part.id, elform),
             "give the part ELFORM 16, or take it out of the set");
    else
      part.drilling = row->drcprm;
  }
}

/// ISTUPD 2 and 3 add what only shells 25 and 26 do, so they come down to 0 and 1.
int thickness_update(Builder& b, const RowOf<ShellCard1>& row) {
  const int update = row->istupd;
  if (update < 0 || update > 4) refuse(b, row[&ShellCard1::istupd], "expected 0 to 4");
  return update == 2 ? 0 : update == 3 ? 1 : update;
}

void read_control_shell(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto one = cursor.read(shell_card_1);
  const auto two = cursor.read(shell_card_2);
  const auto three = cursor.read(shell_card_3);
  const auto four = cursor.read(shell_card_4);
  cursor.read(shell_card_5);
  expect_end(b, cursor);
  if (one->bwc == 1)  // what it projects is the warping stiffness
    expect(b, Severity::warning, {{one[&ShellCard1::proj], 0, "not obeyed: drill projection is used, as with 0"}});
  expect(b, Severity::warning,
         {{three[&ShellCard3::cntco], 0, "not obeyed: contact surfaces lie about the mid-surface, as with 0"},
          {four[&ShellCard4::delfr], 0, "not obeyed: shells that have come loose stay"},
          {four[&ShellCard4::keepcs], 0, "not obeyed: the contact segments of failed shells go with them"}});
  if (four->drcpsid != 0) b.defer(Phase::checks, [four](Builder& later) { resist_drilling(later, four); });
  Control& c = b.model.control;
  c.warp_warning = one->wrpang;
  c.sort_triangles = static_cast<SortTriangles>(one->esort);
  c.thickness_update = thickness_update(b, one);
  c.default_shell = one->theory;
  c.warping_stiffness = one->bwc == 1;
  if (c.warping_stiffness)
    one[&ShellCard1::bwc].report(
        b.findings, Severity::warning,
        "the warping coupling and the drill projection are computed, the transverse shear stays the one-point form",
        "compare with BWC = 2 where warped shells matter");
  c.lobatto = two->intgrd == 1;
  if (const int lamsht = two->lamsht; lamsht == 2)
    refuse(b, two[&ShellCard2::lamsht], "not a documented value", "write 1 for laminated shell theory, 0 without it");
  else
    c.laminated_shear = lamsht != 0 && lamsht != 4;
  c.distorted_shells = four->nfail1 != 0 ? four->nfail1 : two->nfail1;
  c.distorted_full_shells = four->nfail4 != 0 ? four->nfail4 : two->nfail4;
  b.defer(Phase::conditions, [four](Builder& later) {
    if (const auto* parts = later.part_set(four[&ShellCard4::psnfail]))
      later.model.control.parts_of_distorted = parts->members;
  });
}

void read_control_hourglass(Builder& b, const Block& block, const Options&) {
  Hourglass& h = b.model.control.hourglass;
  const auto row = read_one(b, block, control_hourglass_card, h);
  h.bending = h.warping = h.membrane;
  h.place = row[&Hourglass::type].place;
}

void read_control_solution(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  cursor.read(control_solution_card);
  expect_end(b, cursor);
}

void read_bulk(Builder& b, const Block& block, const Options&) {
  read_one(b, block, bulk_card, b.model.control);
}

void read_energy(Builder& b, const Block& block, const Options&) {
  EnergyCard card;
  const auto row = read_one(b, block, energy_card, card);
  b.model.control.hourglass_energy = card.hgen == 2;
  for (const auto member : {&EnergyCard::rwen, &EnergyCard::slnten, &EnergyCard::rylen})
    if (!row[member].blank && card.*member == 1)
      return row[member].report(b.findings, Severity::note, "not obeyed: it is computed and counted, as with 2");
}

void read_accuracy(Builder& b, const Block& block, const Options&) {
  AccuracyCard card;
  read_one(b, block, accuracy_card, card);
  const int inn = std::abs(card.inn);
  b.model.control.invariant_shell_axes = inn == 2 || inn == 4;
  b.model.control.second_order_stress = card.osu == 1;
}

void read_control_solid(Builder& b, const Block& block, const Options&) {
  // Its further cards are about tetrahedra of ten nodes, cohesive elements and brick welds only.
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(solid_card_1);
  b.defer(Phase::conditions, [row](Builder& later) {
    if (const auto* parts = later.part_set(row[&SolidCard1::psfail]))
      later.model.control.eroding_parts = parts->members;
    if (row->niptets == 5 && !later.model.solids.ten_nodes.empty())
      row[&SolidCard1::niptets].report(later.findings, Severity::warning,
                                       "tetrahedra of ten nodes have four points here", "write 4");
  });
  b.model.control.sort_solids = row->esort > 0;
}

void read_relaxation(Builder& b, const Block& block, const Options&) {
  RelaxationCard r{b.model.control.relaxation};
  const auto row = read_one(b, block, control_relaxation_card, r);
  if (block.keyword == "CONTROL_DAMPING")
    b.findings.warning(block.place, block.starred(), "an old name: read as *CONTROL_DYNAMIC_RELAXATION",
                       "write that name if this is what is meant");
  const int flag = r.idrflg;
  if (flag != 0 && flag != 1 && flag != -999)
    refuse(b, row[&RelaxationCard::idrflg],
           "this form of initialization (geometry of a file, implicit, by parts) is not built",
           "give 1, the explicit relaxation of the whole model, or -999 for none");
  r.asked |= flag == 1;
  r.forbidden = flag == -999;
  b.model.control.relaxation = r;
}

void read_output(Builder& b, const Block& block, const Options&) {
  // Its cards from the third on are about LS-DYNA's listings.
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(output_card_1);
  b.model.control.average_accelerations = row->iaccop == 1;
  const auto row2 = cursor.read(output_card_2);
  using enum Requests::ShellAxes;
  b.model.requests.shell_axes = row2->eocs == 1 ? element : row2->eocs == 2 ? global : standard;
  b.defer(Phase::conditions, [second = row2](Builder& later) {
    if (second->tet10s8 == 1 && !later.model.solids.ten_nodes.empty())
      second[&OutputCard2::tet10s8].report(later.findings, Severity::warning,
                                           "not obeyed: d3plot has the corners of tetrahedra of ten nodes, as with 2");
  });
}

}  // namespace

std::vector<Keyword> control_keywords() {
  return {
      {.name = "TITLE", .layout = {{"", &model_title_card}}, .read = read_model_title},
      {.name = "CONTROL_TERMINATION", .layout = {{"", &termination_card}}, .read = read_termination},
      {.name = "CONTROL_TIMESTEP",
       .layout = {{"", &step_card}, {"optional", &step_card_2}, {"optional", &step_card_3}},
       .read = read_time_step},
      {.name = "CONTROL_CONTACT",
       .layout = {{"", &contact_card_1},
                  {"", &contact_card_2},
                  {"optional", &contact_card_3},
                  {"optional", &contact_card_4},
                  {"optional", &contact_card_5},
                  {"optional", &contact_card_6},
                  {"optional", &contact_card_7}},
       .read = read_control_contact},
      {.name = "CONTROL_SHELL",
       .layout = {{"", &shell_card_1},
                  {"optional", &shell_card_2},
                  {"optional", &shell_card_3},
                  {"optional", &shell_card_4},
                  {"optional", &shell_card_5}},
       .read = read_control_shell},
      {.name = "CONTROL_HOURGLASS", .layout = {{"", &control_hourglass_card}}, .read = read_control_hourglass},
      {.name = "CONTROL_BULK_VISCOSITY", .layout = {{"", &bulk_card}}, .read = read_bulk},
      {.name = "CONTROL_ENERGY", .layout = {{"", &energy_card}}, .read = read_energy},
      {.name = "CONTROL_ACCURACY", .layout = {{"", &accuracy_card}}, .read = read_accuracy},
      {.name = "CONTROL_SOLID", .layout = {{"", &solid_card_1}}, .read = read_control_solid},
      {.name = "CONTROL_SOLUTION", .layout = {{"", &control_solution_card}}, .read = read_control_solution},
      {.name = "CONTROL_DYNAMIC_RELAXATION",
       .aliases = {"CONTROL_DAMPING"},
       .layout = {{"", &control_relaxation_card}},
       .read = read_relaxation},
      {.name = "CONTROL_OUTPUT", .layout = {{"", &output_card_1}, {"optional", &output_card_2}}, .read = read_output},
      {.name = "CONTROL_UNITS",
       .status = KeywordStatus::ignored,
       .why = "a remark on the units; the program computes in whatever units the deck is written in"},
  };
}

}  // namespace nugget::reading
