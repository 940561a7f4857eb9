// SPDX-License-Identifier: Apache-2.0
#include <iterator>

#include "model/cards/families.hpp"
#include "model/cards/frequency_cards.hpp"

// *FREQUENCY_DOMAIN_SSD: harmonic loads together.
namespace nugget::model {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using Excitation = FrequencyResponse::Excitation;
using Quantity = FrequencyResponse::Quantity;

const Card modes_card{{
    integer("mdmin", 1, at_least(0), "first mode that is used"),
    integer("mdmax", 0, at_least(0), "last mode that is used; 0: all"),
    real("fnmin", dimension::rate, 0, at_least(0), "no modes below this natural frequency [cycles/time]"),
    real("fnmax", dimension::rate, 0, at_least(0), "no modes above this natural frequency [cycles/time]; 0: all"),
    integer("restmd", 0, any_value, "reuse of modes of an earlier run; modes are always computed"),
    integer("restdp", 0, any_value, "reuse of a d3ssd of an earlier run; refused"),
    integer("lcflag", 0, between(0, 1), "load curves are 0: amplitude and phase [degree], 1: real and imaginary part"),
    integer("relatv", 0, between(0, 1), "1: responses to base motion are relative to it"),
}};

const Card damping_card{{
    real("dampf", dimension::number, 0, at_least(0), "modal damping ratio of all modes, share of the critical"),
    id("lcdam", IdSpace::function, 0, "curve of the damping ratio, instead of dampf"),
    integer("lctyp", 0, between(0, 1), "lcdam is over 0: natural frequency [cycles/time], 1: number of the mode"),
    real("dmpmas", dimension::rate, 0, at_least(0), "alpha of Rayleigh's damping alpha M + beta K; adds to the others"),
    real("dmpstf", dimension::time, 0, at_least(0), "beta"),
    integer("dmpflg", 0, between(0, 1),
            "1: dashpots and *DAMPING_PART_MASS, _STIFFNESS instead of the fields before this one"),
}};

const Card options_card{{
    integer("unused", 0, any_value, "no effect"),
    integer("istress", 0, any_value, "stresses over frequency; not written"),
    integer("memory", 0, any_value, "no effect"),
    integer("nerp", 0, any_value, "panels of radiated power; refused"),
    integer("strtyp", 0, any_value, "of the radiated power, no effect"),
    integer("nout", 0, any_value, "of the radiated power, no effect"),
    integer("notyp", 0, any_value, "of the radiated power, no effect"),
    integer("nova", 0, any_value, "of the radiated power, no effect"),
}};

/// The name space of NID depends on its type, which stands behind it.
Card load_card(IdSpace nid) {
  return {{
      id("nid", nid, 0, "node, node set or segment set that is loaded; base motion moves all supports instead"),
      integer("ntyp", 0, between(0, 2), "0: node, 1: node set, 2: segment set (pressure)"),
      integer("dof", 1, between(1, 4), "1, 2, 3: along (torque: about) x, y, z; 4: along vid; pressure: no effect"),
      integer("vad", 0, between(0, 14),
              "0: nodal force, 1: pressure; 2, 3, 4: base velocity, acceleration, displacement; 5, 6, 7 (12, 13, 14): "
              "enforced velocity, acceleration, displacement of the nodes; 8: torque; others are refused"),
      id("lc1", IdSpace::function, required, "curve over frequency: amplitude or real part; 0 outside"),
      id("lc2", IdSpace::function, 0, "curve over frequency: phase [degree] or imaginary part; 0 outside"),
      real("sf", dimension::number, 1, any_value, "factor on the amplitude"),
      id("vid", IdSpace::define, 0, "vector of the direction, where dof is 4"),
  }};
}
const Card load_of_node = load_card(IdSpace::node), load_of_set = load_card(IdSpace::set);

const Card ascii_card = frequency_card(), states_card = frequency_card();

const Card binary_card{{
    integer("binary", 0, between(0, 91),
            "d3ssd holds 1: amplitudes, 90: real parts, 91: imaginary parts of the motion of all nodes; 0: no file; "
            "others are refused"),
}};

/// By VAD; rotations of the base have none.
std::optional<Driven> driven(int vad) {
  using Kind = Excitation::Kind;
  constexpr Quantity order[] = {Quantity::velocity, Quantity::acceleration, Quantity::displacement};
  if (vad == 0) return Driven{Kind::force};
  if (vad == 1) return Driven{Kind::pressure};
  if (vad <= 4) return Driven{Kind::base, order[vad - 2]};
  if (vad <= 7) return Driven{Kind::enforced, order[vad - 5]};
  if (vad == 8) return Driven{Kind::torque};
  if (vad >= 12) return Driven{Kind::enforced, order[vad - 12]};
  return {};
}

/// What stands on *FREQUENCY_DOMAIN_SSD and on the card of its output meet in the model.
SteadyState& steady_state(Builder& b) {
  if (!b.model.steady_state) b.model.steady_state.emplace();
  return *b.model.steady_state;
}

/// Loads that cannot act together.
void check_together(Builder& b, const Row& row, const SteadyState& s) {
  bool base = false, enforced = false;
  for (const SteadyState::Load& load : s.loads) {
    base |= load.excitation.kind == Excitation::Kind::base;
    enforced |= load.excitation.kind == Excitation::Kind::enforced;
  }
  if (base && enforced)
    refuse(b, row, "vad", "motion of the base and enforced motion of nodes do not go together",
           "drive all supports as nodes, by enforced motion");
  if (s.relative && !base)
    row.complain(b.findings, Severity::warning, "vad", "RELATV has no effect: no base moves (VAD 2, 3, 4)");
}

void read_ssd(Builder& b, const Block& block, const Options& options) {
  const bool direct = options.contains("DIRECT");
  Cursor cursor(b.deck, block, b.findings);
  const Row modes = cursor.read(modes_card), damping = cursor.read(damping_card), more = cursor.read(options_card);
  std::vector<Row> loads;
  while (cursor.more()) loads.push_back(cursor.read(cursor.peek_number(1) == 0.0 ? load_of_node : load_of_set));
  if (loads.empty()) return refuse(b, modes, "mdmin", "no load is given", "give a load card after the first three");
  b.later(Phase::conditions, [=](Builder& later) {
    SteadyState& s = steady_state(later);
    if (!s.loads.empty())
      return refuse(later, modes, "mdmin", "a deck has one *FREQUENCY_DOMAIN_SSD", "put all loads under one");
    refuse_nonzero(later, modes, "restdp", "results of an earlier run are not read", "leave it out");
    refuse_nonzero(later, more, "nerp", "radiated power is not built", "leave it out");
    expect(later, modes, Severity::warning, {{"restmd", 0, "not obeyed: the modes are computed anew, as with 0"}});
    expect(later, more, Severity::warning, {{"istress", 0, "not obeyed: stresses over frequency are not written"}});
    s.direct = direct;
    s.modes = selection_of(later, modes);
    s.modes.lowest = modes.real("fnmin");
    s.damping = damping_of(later, damping);
    if (damping.integer("dmpflg") == 1) {
      if (s.damping.ratio > 0.0 || s.damping.curve != none || s.damping.mass > 0.0 || s.damping.stiffness > 0.0)
        damping.complain(later.findings, Severity::warning, "dmpflg",
                         "it replaces DAMPF, LCDAM, DMPMAS and DMPSTF, which have no effect");
      s.damping = {};
      s.damping.of_parts = true;
    }
    s.by_parts = modes.integer("lcflag") == 1;
    s.relative = modes.integer("relatv") == 1;
    for (const Row& load : loads)
      s.loads.push_back({excitation_of(later, load, {"nid", "ntyp", "dof", "vad", "vid"}, driven(load.integer("vad"))),
                         load.real("sf"), later.curve(load, "lc1"), later.curve(load, "lc2")});
  });
  b.later(Phase::checks, [modes, loads, direct](Builder& later) {
    check_analysis(later, modes, "mdmin", !direct);
    const SteadyState& s = steady_state(later);
    if (s.loads.size() != loads.size()) return;
    for (std::size_t i = 0; i < loads.size(); ++i) check_excitation(later, loads[i], "vad", s.loads[i].excitation);
    check_together(later, loads.back(), s);
    if (s.frequency.empty() && !s.states)
      refuse(later, modes, "mdmin", "no frequencies are given",
             "add *DATABASE_FREQUENCY_ASCII_NODOUT_SSD or _BINARY_D3SSD with FMIN, FMAX and NFREQ");
    if (!s.frequency.empty() && later.model.requests.history_nodes.empty())
      refuse(later, modes, "mdmin", "no nodes are given whose response is wanted", "add *DATABASE_HISTORY_NODE");
  });
}

/// A request of output is for nothing without loads.
void expect_loads(Builder& b, const Row& row, std::string_view field) {
  if (!b.model.steady_state || !b.model.steady_state->loads.empty()) return;
  row.complain(b.findings, Severity::warning, field, "no response: there is no *FREQUENCY_DOMAIN_SSD");
  b.model.steady_state.reset();
}

void read_nodout_ssd(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row row = cursor.read(ascii_card);
  expect_end(b, cursor);
  b.later(Phase::conditions,
          [row](Builder& later) { static_cast<Frequencies&>(steady_state(later)) = frequencies_of(later, row); });
  b.later(Phase::checks, [row](Builder& later) { expect_loads(later, row, "fmin"); });
}

void read_d3ssd(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row kind = cursor.read(binary_card), row = cursor.read(states_card);
  expect_end(b, cursor);
  const int binary = kind.integer("binary");
  if (binary == 0)
    return kind.complain(b.findings, Severity::warning, "binary", "no d3ssd is written", "write 1, 90 or 91");
  if (binary != 1 && binary < 90)
    return refuse(b, kind, "binary", "files of complex numbers are not built", "write 90 in one run and 91 in another");
  b.later(Phase::conditions, [binary, row](Builder& later) {
    using Part = SteadyState::States::Part;
    SteadyState::States states;
    static_cast<Frequencies&>(states) = frequencies_of(later, row);
    states.part = binary == 90 ? Part::real : binary == 91 ? Part::imaginary : Part::amplitude;
    steady_state(later).states = std::move(states);
  });
  b.later(Phase::checks, [kind](Builder& later) { expect_loads(later, kind, "binary"); });
}

}  // namespace

std::vector<Keyword> steady_state_keywords() {
  return {
      {.name = "FREQUENCY_DOMAIN_SSD",
       .options = {"DIRECT"},
       .layout = {{"", &modes_card}, {"", &damping_card}, {"", &options_card}, {"for each load", &load_of_node}},
       .read = read_ssd},
      {.name = "DATABASE_FREQUENCY_ASCII_NODOUT_SSD", .layout = {{"", &ascii_card}}, .read = read_nodout_ssd},
      {.name = "DATABASE_FREQUENCY_BINARY_D3SSD",
       .layout = {{"", &binary_card}, {"", &states_card}},
       .read = read_d3ssd},
      {.name = "DATABASE_FREQUENCY_ASCII_*",
       .verdict = Verdict::refused,
       .why = "of the histories over frequency _NODOUT_SSD is written"},
      {.name = "DATABASE_FREQUENCY_BINARY_*",
       .verdict = Verdict::refused,
       .why = "of the state files over frequency _D3SSD is written, without _SUBCASE"},
  };
}

}  // namespace nugget::model
