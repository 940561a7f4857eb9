// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "reading/cards/families.hpp"
#include "reading/cards/frequency_cards.hpp"

// *FREQUENCY_DOMAIN_SSD: harmonic loads together, and the power that panels radiate under them.
namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;
using SteadyExcitation = FrequencyResponse::Excitation;
using SteadyQuantity = FrequencyResponse::Quantity;

struct ModesCard : SelectionCard {
  double fnmin = 0;
  int restmd = 0, restdp = 0, lcflag = 0, relatv = 0;
};
const CardOf<ModesCard> modes_card{
    {&SelectionCard::mdmin, integer("mdmin", 1, at_least(0), "first mode that is used")},
    {&SelectionCard::mdmax, integer("mdmax", 0, at_least(0), "last mode that is used; 0: all")},
    {&ModesCard::fnmin,
     real("fnmin", dimension::rate, 0, at_least(0), "no modes below this natural frequency [cycles/time]")},
    {&SelectionCard::fnmax,
     real("fnmax", dimension::rate, 0, at_least(0), "no modes above this natural frequency [cycles/time]; 0: all")},
    {&ModesCard::restmd,
     integer("restmd", 0, any_value, "reuse of modes of an earlier run; modes are always computed")},
    {&ModesCard::restdp, integer("restdp", 0, any_value, "reuse of a d3ssd of an earlier run; refused")},
    {&ModesCard::lcflag, integer("lcflag", 0, between(0, 1),
                                 "load curves are 0: amplitude and phase [degree], 1: real and imaginary part")},
    {&ModesCard::relatv, integer("relatv", 0, between(0, 1), "1: responses to base motion are relative to it")},
};

const CardOf<DampingCard> steady_damping_card = damping_card_of_response(
    {{&DampingCard::dmpflg,
      integer("dmpflg", 0, between(0, 1),
              "1: dashpots and *DAMPING_PART_MASS, _STIFFNESS instead of the fields before this one")}});

struct OptionsCard {
  int istress = 0, nerp = 0, nout = 0;
};
const CardOf<OptionsCard> options_card{
    integer("unused", 0, any_value, "no effect"),
    {&OptionsCard::istress, integer("istress", 0, any_value, "stresses over frequency; not written")},
    integer("memory", 0, any_value, "no effect"),
    {&OptionsCard::nerp,
     integer("nerp", 0, at_least(0), "with _ERP: number of panels that radiate power; else it must be 0")},
    integer("strtyp", 0, any_value, "of fatigue, no effect"),
    {&OptionsCard::nout, integer("nout", 0, any_value, "what moves for acoustics; not written")},
    integer("notyp", 0, any_value, "of nout, no effect"),
    integer("nova", 0, any_value, "of nout, no effect"),
};

struct FluidCard {
  double ro = 0, c = 0, erprlf = 0, erpref = 0;
  int radeff = 0;
};
const CardOf<FluidCard> fluid_card{
    {&FluidCard::ro, real("ro", dimension::density, required, above_zero(), "density of the fluid")},
    {&FluidCard::c, real("c", dimension::velocity, required, above_zero(), "speed of sound in the fluid")},
    {&FluidCard::erprlf,
     or_negative(real("erprlf", dimension::number, 1, any_value,
                      "radiation loss factor, on the power; below 0: -erprlf is its curve over frequency"),
                 IdSpace::function)},
    {&FluidCard::erpref, real("erpref", Dimension{1, 2, -3}, 0, at_least(0),
                              "power of 0 decibels, in the units of the deck; 0: no decibels")},
    {&FluidCard::radeff,
     integer("radeff", 0, between(0, 2), "0: by the normal velocity of each point; others are refused")},
};
/// The name space of PID depends on its type, which stands behind it.
struct PanelCard {
  int pid = 0, ptyp = 0;
};
CardOf<PanelCard> panel_card(IdSpace pid) {
  return {
      {&PanelCard::pid, id("pid", pid, required, "shells of a part or part set, or segment set, that radiate")},
      {&PanelCard::ptyp, integer("ptyp", 0, between(0, 2), "0: part, 1: part set, 2: segment set")},
  };
}
const CardOf<PanelCard> panel_of_part = panel_card(IdSpace::part), panel_of_set = panel_card(IdSpace::set);

struct CaseCard {
  std::string caseid, title;
  int nload = 0;
};
const CardOf<CaseCard> case_card{
    {&CaseCard::caseid, text("caseid", 10, "name of the case; its files end with it")},
    {&CaseCard::title, text("title", 60, "of the case")},
    {&CaseCard::nload, integer("nload", 1, at_least(1), "number of its loads, whose cards follow")},
};

/// The name space of NID depends on its type, which stands behind it.
CardOf<ExcitationCard> load_card(IdSpace nid) {
  return {
      {&ExcitationCard::entity,
       id("nid", nid, 0, "node, node set or segment set that is loaded; base motion moves all supports instead")},
      {&ExcitationCard::type, integer("ntyp", 0, between(0, 2), "0: node, 1: node set, 2: segment set (pressure)")},
      {&ExcitationCard::direction,
       integer("dof", 1, between(1, 4),
               "1, 2, 3: along (torque, turning base: about) x, y, z; 4: along vid; pressure: no effect")},
      {&ExcitationCard::vad,
       integer("vad", 0, between(0, 14),
               "0: nodal force, 1: pressure; 2, 3, 4: base velocity, acceleration, displacement; 5, 6, 7 (12, 13, 14): "
               "enforced velocity, acceleration, displacement of the nodes; 8: torque; 9, 10, 11: base angular "
               "velocity, acceleration, rotation")},
      {&ExcitationCard::lc1,
       id("lc1", IdSpace::function, required, "curve over frequency: amplitude or real part; 0 outside")},
      {&ExcitationCard::lc2,
       id("lc2", IdSpace::function, 0, "curve over frequency: phase [degree] or imaginary part; 0 outside")},
      {&ExcitationCard::sf, real("sf", dimension::number, 1, any_value, "factor on the amplitude")},
      {&ExcitationCard::vector, id("vid", IdSpace::define, 0, "vector of the direction, where dof is 4")},
  };
}
const CardOf<ExcitationCard> load_of_node = load_card(IdSpace::node), load_of_set = load_card(IdSpace::set);

const CardOf<FrequencyCard> ascii_card = frequency_card(), states_card = frequency_card();

struct BinaryCard {
  int binary = 0, psetid = 0;
};
const CardOf<BinaryCard> binary_card{
    {&BinaryCard::binary,
     integer("binary", 0, between(0, 91),
             "d3ssd holds 1: amplitudes, 90: real parts, 91: imaginary parts of the motion of all nodes; 0: no file; "
             "others are refused")},
    unused(),
    unused(),
    unused(),
    {&BinaryCard::psetid, id("psetid", IdSpace::set, 0, "parts that the file holds; it holds all")},
};
const CardOf<BinaryCard> power_card{
    {&BinaryCard::binary,
     integer("binary", 0, between(0, 91), "d3erp is not written; ERP_abs, ERP_dB and erp.csv are, whatever this is")},
};

/// By VAD.
Driven driven(int vad) {
  using Kind = SteadyExcitation::Kind;
  constexpr SteadyQuantity order[] = {SteadyQuantity::velocity, SteadyQuantity::acceleration,
                                      SteadyQuantity::displacement};
  if (vad <= 0) return Driven{Kind::force};
  if (vad == 1) return Driven{Kind::pressure};
  if (vad <= 4) return Driven{Kind::base, order[vad - 2]};
  if (vad <= 7) return Driven{Kind::enforced, order[vad - 5]};
  if (vad == 8) return Driven{Kind::torque};
  if (vad <= 11) return Driven{Kind::base, order[vad - 9], true};
  return Driven{Kind::enforced, order[std::min(vad, 14) - 12]};
}

/// What stands on *FREQUENCY_DOMAIN_SSD and on the card of its output meet in the model.
SteadyState& steady_state(Builder& b) {
  if (!b.model.steady_state) b.model.steady_state.emplace();
  return *b.model.steady_state;
}

/// Loads that cannot act together; subcases share their modes.
void check_together(Builder& b, const deck::Entry& vad, const SteadyState& s, const SteadyState::Case& c) {
  bool base = false, enforced = false;
  for (const SteadyState::Load& load : c.loads) {
    base |= load.excitation.kind == SteadyExcitation::Kind::base;
    enforced |= load.excitation.kind == SteadyExcitation::Kind::enforced;
  }
  if (base && enforced)
    refuse(b, vad, "motion of the base and enforced motion of nodes do not go together",
           "drive all supports as nodes, by enforced motion");
  if (enforced && s.cases.size() > 1)
    refuse(b, vad, "subcases share their modes, and enforced nodes would be held in those of all",
           "make a deck for each enforced motion");
  if (s.relative && !base)
    vad.report(b.findings, Severity::warning, "RELATV has no effect: no base moves (VAD 2, 3, 4, 9, 10, 11)");
}

/// What stands on the cards.
struct SteadyStateCards {
  struct Case {
    std::string id, title;
    std::vector<RowOf<ExcitationCard>> loads;
  };
  RowOf<ModesCard> modes;
  RowOf<DampingCard> damping;
  RowOf<OptionsCard> more;
  std::optional<RowOf<FluidCard>> fluid;  ///< of _ERP
  std::vector<RowOf<PanelCard>> panels;
  std::vector<Case> cases;
  bool direct = false;
};

std::string name_of(int type, int id) {
  return fmt::format("{} {}", type == 0 ? "part" : type == 1 ? "part set" : "segment set", id);
}

SteadyState::RadiatedPower::Panel panel_of(Builder& b, const RowOf<PanelCard>& row) {
  const deck::Entry pid = row[&PanelCard::pid];
  const int type = row->ptyp;
  SteadyState::RadiatedPower::Panel panel{name_of(type, row->pid), {}};
  if (type == 2) {
    const Set<Segment>* set = b.segment_set(pid);
    if (set == nullptr) return panel;
    panel.segments = set->members;
  } else {
    std::vector<Index> parts;
    if (type == 0) {
      parts = {b.part(pid)};
      if (parts.front() == none) return panel;
    } else {
      const Set<Index>* set = b.part_set(pid);
      if (set == nullptr) return panel;
      parts = set->members;
    }
    const Shells& shells = b.model.shells;
    for (std::size_t e = 0; e < shells.size(); ++e)
      if (std::find(parts.begin(), parts.end(), shells.part[e]) != parts.end())
        panel.segments.push_back(shells.node[e]);
  }
  if (panel.segments.empty())
    refuse(b, pid, fmt::format("{} has no {}, so it has no surface", panel.name, type == 2 ? "segments" : "shells"),
           "give a part of shells, or a segment set on the surface of solids");
  return panel;
}

SteadyState::RadiatedPower& radiated_power(Builder& b) {
  SteadyState& s = steady_state(b);
  if (!s.radiated_power) s.radiated_power = SteadyState::RadiatedPower{};
  return *s.radiated_power;
}

void make_power(Builder& b, const SteadyStateCards& cards) {
  SteadyState::RadiatedPower& p = radiated_power(b);
  const RowOf<FluidCard>& row = *cards.fluid;
  p.density = row->ro;
  p.sound_speed = row->c;
  p.loss_factor = row->erprlf;
  p.reference = row->erpref;
  if (p.loss_factor < 0.0) {
    const int id = static_cast<int>(std::lround(-p.loss_factor));
    p.loss_curve = b.curves.find(id);
    if (p.loss_curve == none)
      refuse(b, row[&FluidCard::erprlf], fmt::format("curve {} is not defined", id),
             "define it, or give a loss factor above 0");
  }
  if (row->radeff != 0)
    refuse(b, row[&FluidCard::radeff],
           row->radeff == 1 ? "radiation efficiency by Rayleigh's integral is not built"
                            : "the corrected radiated power is not built (what corrects it is not public)",
           "write 0 for the classic one");
  if (p.reference == 0.0)
    row[&FluidCard::erpref].report(b.findings, Severity::warning, "no ERP_dB: decibels need a power that they refer to",
                                   "give it in the units of the deck (1e-12 W is 1e-9 mN m/s, that of mm, t, s)");
  for (const RowOf<PanelCard>& panel : cards.panels) p.panels.push_back(panel_of(b, panel));
}

void make_ssd(Builder& b, const SteadyStateCards& cards) {
  SteadyState& s = steady_state(b);
  const auto& [modes, damping, more, fluid, panels, cases, direct] = cards;
  if (!s.cases.empty())
    return refuse(b, modes[&SelectionCard::mdmin], "a deck has one *FREQUENCY_DOMAIN_SSD",
                  "put all loads under one, or each group of them under one *FREQUENCY_DOMAIN_SSD_SUBCASE");
  refuse_nonzero(b, modes[&ModesCard::restdp], "results of an earlier run are not read", "leave it out");
  if (!fluid)
    refuse_nonzero(b, more[&OptionsCard::nerp], "radiated power is asked for, but not by the keyword",
                   "write *FREQUENCY_DOMAIN_SSD_ERP with its cards, or leave NERP out");
  expect(b, Severity::warning, {{modes[&ModesCard::restmd], 0, "not obeyed: the modes are computed anew, as with 0"}});
  expect(b, Severity::warning,
         {{more[&OptionsCard::istress], 0, "not obeyed: stresses over frequency are not written"},
          {more[&OptionsCard::nout], 0, "not obeyed: no files for acoustics; d3ssd holds the motion of all nodes"}});
  s.direct = direct;
  s.modes = selection_of(b, *modes, modes[&SelectionCard::mdmax]);
  s.modes.lowest = modes->fnmin;
  if (s.modes.highest > 0.0 && s.modes.lowest >= s.modes.highest)
    refuse(b, modes[&SelectionCard::fnmax], "no mode is left", "give an FNMAX above FNMIN, or 0 for all");
  s.damping = damping_of(b, damping);
  if (damping->dmpflg == 1) {
    if (s.damping.ratio > 0.0 || s.damping.curve != none || s.damping.mass > 0.0 || s.damping.stiffness > 0.0)
      damping[&DampingCard::dmpflg].report(b.findings, Severity::warning,
                                           "it replaces DAMPF, LCDAM, DMPMAS and DMPSTF, which have no effect");
    s.damping = {};
    s.damping.of_parts = true;
  }
  s.by_parts = modes->lcflag == 1;
  s.relative = modes->relatv == 1;
  for (const SteadyStateCards::Case& c : cases) {
    SteadyState::Case& made = s.cases.emplace_back(SteadyState::Case{c.id, c.title, {}});
    for (const RowOf<ExcitationCard>& load : c.loads)
      made.loads.push_back({excitation_of(b, load, driven(load->vad)), load->sf, b.curve(load[&ExcitationCard::lc1]),
                            b.curve(load[&ExcitationCard::lc2])});
  }
  if (fluid) make_power(b, cards);
}

void check_ssd(Builder& b, const SteadyStateCards& cards) {
  const SteadyState& s = steady_state(b);
  check_analysis(b, cards.modes[&SelectionCard::mdmin], !cards.direct, s.modes);
  check_damped(b, cards.damping[&DampingCard::dampf], s.damping);
  if (s.cases.size() != cards.cases.size()) return;  // of another keyword
  for (std::size_t c = 0; c < s.cases.size(); ++c) {
    const auto& loads = cards.cases[c].loads;
    for (std::size_t i = 0; i < loads.size(); ++i)
      check_excitation(b, loads[i][&ExcitationCard::vad], s.cases[c].loads[i].excitation);
    check_together(b, loads.back()[&ExcitationCard::vad], s, s.cases[c]);
  }
  const bool power = cards.fluid && !s.radiated_power->frequency.empty();
  if (s.frequency.empty() && !s.states && !power)
    refuse(b, cards.modes[&SelectionCard::mdmin], "no frequencies are given",
           "add *DATABASE_FREQUENCY_ASCII_NODOUT_SSD, _BINARY_D3SSD or (with _ERP) _BINARY_D3ERP with FMIN, FMAX and "
           "NFREQ");
  if (!s.frequency.empty() && b.model.requests.history_nodes.empty() && !cards.fluid)
    refuse(b, cards.modes[&SelectionCard::mdmin], "no nodes are given whose response is wanted",
           "add *DATABASE_HISTORY_NODE");
}

RowOf<ExcitationCard> read_steady_load(Cursor& cursor) {
  return cursor.read(cursor.peek_number(1) == 0.0 ? load_of_node : load_of_set);
}

/// Whether a name is another one, or could be that of one of its numbered files.
bool of_one_family(const std::string& name, const std::string& other) {
  return other.starts_with(name) && other.find_first_not_of("0123456789", name.size()) == std::string::npos;
}

/// False, and why, where the cards are not all there.
bool read_subcases(Builder& b, Cursor& cursor, SteadyStateCards& cards) {
  while (cursor.more()) {
    const auto row = cursor.read(case_card);
    SteadyStateCards::Case c{row->caseid, row->title, {}};
    if (c.id.empty() || c.id.find_first_of("/ \\") != std::string::npos) {
      refuse(b, row[&CaseCard::caseid], "files are named by it: a name without blanks is needed", "give one");
      return false;
    }
    for (const SteadyStateCards::Case& before : cards.cases)
      if (of_one_family(before.id, c.id) || of_one_family(c.id, before.id)) {
        refuse(b, row[&CaseCard::caseid], fmt::format("its files would be taken for those of case {}", before.id),
               "give each case a name of its own, and not that of another with digits behind it");
        return false;
      }
    for (int i = 0; i < row->nload; ++i) {
      if (!cursor.more()) {
        refuse(b, row[&CaseCard::nload], fmt::format("only {} loads are there", i), "give a card for each");
        return false;
      }
      c.loads.push_back(read_steady_load(cursor));
    }
    cards.cases.push_back(std::move(c));
  }
  if (!cards.cases.empty()) return true;
  refuse(b, cards.modes[&SelectionCard::mdmin], "no case is given", "give a card with CASEID and NLOAD, and its loads");
  return false;
}

void read_ssd(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  const bool power = options.contains("ERP"), subcases = options.contains("SUBCASE");
  const auto modes = cursor.read(modes_card);
  const auto damping = cursor.read(steady_damping_card);
  const auto more = cursor.read(options_card);
  SteadyStateCards cards{modes, damping, more, {}, {}, {}, options.contains("DIRECT")};
  if (cards.direct + power + subcases > 1)
    return refuse(b, modes[&SelectionCard::mdmin], "_DIRECT, _ERP and _SUBCASE do not go together",
                  "write one of them; `nugget frf --direct` solves any of them directly");
  if (power) {
    cards.fluid = cursor.read(fluid_card);
    if (more->nerp == 0)
      return refuse(b, more[&OptionsCard::nerp], "no panel radiates",
                    "give their number, and a card with PID and PTYP for each");
    for (int i = 0; i < more->nerp; ++i)
      cards.panels.push_back(cursor.read(cursor.peek_number(1) == 0.0 ? panel_of_part : panel_of_set));
  }
  if (subcases) {
    if (!read_subcases(b, cursor, cards)) return;
  } else {
    SteadyStateCards::Case all;
    while (cursor.more()) all.loads.push_back(read_steady_load(cursor));
    if (all.loads.empty())
      return refuse(b, modes[&SelectionCard::mdmin], "no load is given", "give a load card after the first three");
    cards.cases.push_back(std::move(all));
  }
  b.defer(Phase::conditions, [cards](Builder& later) { make_ssd(later, cards); });
  b.defer(Phase::checks, [cards](Builder& later) { check_ssd(later, cards); });
}

/// A request of output is for nothing without loads.
void expect_loads(Builder& b, const deck::Entry& field) {
  if (!b.model.steady_state || !b.model.steady_state->cases.empty()) return;
  field.report(b.findings, Severity::warning, "no response: there is no *FREQUENCY_DOMAIN_SSD");
  b.model.steady_state.reset();
}

void read_nodout_ssd(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(ascii_card);
  expect_end(b, cursor);
  b.defer(Phase::conditions,
          [row](Builder& later) { static_cast<Frequencies&>(steady_state(later)) = frequencies_of(later, row); });
  b.defer(Phase::checks, [row](Builder& later) { expect_loads(later, row[&FrequencyCard::fmin]); });
}

void read_d3ssd(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto kind = cursor.read(binary_card);
  const auto row = cursor.read(states_card);
  expect_end(b, cursor);
  const int binary = kind->binary;
  if (binary == 0)
    return kind[&BinaryCard::binary].report(b.findings, Severity::warning, "no d3ssd is written", "write 1, 90 or 91");
  if (binary != 1 && binary < 90)
    return refuse(b, kind[&BinaryCard::binary], "files of complex numbers are not built",
                  "write 90 in one run and 91 in another");
  expect(b, Severity::warning, {{kind[&BinaryCard::psetid], 0, "not obeyed: the file holds all parts, as with 0"}});
  b.defer(Phase::conditions, [binary, row](Builder& later) {
    using Part = SteadyState::States::Part;
    SteadyState::States states;
    static_cast<Frequencies&>(states) = frequencies_of(later, row);
    states.part = binary == 90 ? Part::real : binary == 91 ? Part::imaginary : Part::amplitude;
    steady_state(later).states = std::move(states);
  });
  b.defer(Phase::checks, [kind](Builder& later) { expect_loads(later, kind[&BinaryCard::binary]); });
}

void read_d3erp(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto kind = cursor.read(power_card);
  std::optional<RowOf<FrequencyCard>> row;
  if (cursor.more()) row = cursor.read(states_card);
  expect_end(b, cursor);
  expect(b, Severity::warning,
         {{kind[&BinaryCard::binary], 0,
           "no d3erp, whose layout is not published; ERP_abs, ERP_dB and erp.csv are written"}});
  b.defer(Phase::conditions, [row](Builder& later) {
    if (row) static_cast<Frequencies&>(radiated_power(later)) = frequencies_of(later, *row);
  });
  b.defer(Phase::checks, [kind](Builder& later) {
    expect_loads(later, kind[&BinaryCard::binary]);
    if (!later.model.steady_state) return;
    std::optional<SteadyState::RadiatedPower>& power = later.model.steady_state->radiated_power;
    if (power && !power->panels.empty()) return;
    kind[&BinaryCard::binary].report(later.findings, Severity::warning,
                                     "no radiated power: *FREQUENCY_DOMAIN_SSD has no panels",
                                     "write *FREQUENCY_DOMAIN_SSD_ERP with panels");
    power.reset();
  });
}

}  // namespace

std::vector<Keyword> steady_state_keywords() {
  return {
      {.name = "FREQUENCY_DOMAIN_SSD",
       .options = {"DIRECT", "ERP", "SUBCASE"},
       .layout = {{"", &modes_card},
                  {"", &steady_damping_card},
                  {"", &options_card},
                  {"with _ERP", &fluid_card},
                  {"with _ERP, for each panel", &panel_of_part},
                  {"with _SUBCASE, for each", &case_card},
                  {"for each load", &load_of_node}},
       .read = read_ssd},
      {.name = "DATABASE_FREQUENCY_ASCII_NODOUT_SSD",
       .options = {"SUBCASE"},
       .layout = {{"", &ascii_card}},
       .read = read_nodout_ssd},
      {.name = "DATABASE_FREQUENCY_BINARY_D3ERP",
       .layout = {{"", &power_card}, {"optional", &states_card}},
       .read = read_d3erp},
      {.name = "DATABASE_FREQUENCY_BINARY_D3SSD",
       .options = {"SUBCASE"},
       .layout = {{"", &binary_card}, {"", &states_card}},
       .read = read_d3ssd},
      {.name = "DATABASE_FREQUENCY_ASCII_*",
       .status = KeywordStatus::refused,
       .why = "of the histories over frequency _NODOUT_SSD is written"},
      {.name = "DATABASE_FREQUENCY_BINARY_*",
       .status = KeywordStatus::refused,
       .why = "of the state files over frequency _D3SSD is written"},
  };
}

}  // namespace nugget::reading
