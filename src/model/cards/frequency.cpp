// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>

#include "model/cards/families.hpp"
#include "model/cards/reading.hpp"

// *FREQUENCY_DOMAIN_...: response to harmonic excitation.
namespace nugget::model {
namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

/// A number whose 0 has a meaning of its own beside the default.
constexpr Field zero_counts(Field f) {
  f.zero_is_default = false;
  return f;
}

/// The name space of N1 depends on its type, which stands behind it; so with N2.
Card excitation_card(IdSpace n1) {
  return {{
      id("n1", n1, 0, "node, node set or segment set that is loaded; base motion moves all supports instead"),
      integer("n1typ", 0, between(0, 2),
              "0: n1 is a node, 1: a node set, each of whose nodes carries the unit force, 2: a segment set under unit "
              "pressure"),
      integer("dof1", 0, between(0, 3), "1, 2, 3: along x, y, z; 0: along vid1"),
      zero_counts(integer(
          "vad1", 3, between(0, 12),
          "0, 1, 2: base velocity, acceleration, displacement; 3: nodal force; 4: pressure; others are refused")),
      id("vid1", IdSpace::define, 0, "vector of the direction, where dof1 is 0"),
      real("fnmax", dimension::rate, 0, at_least(0), "no modes above this natural frequency [cycles/time]; 0: all"),
      integer("mdmin", 0, at_least(0), "first mode that is used; 0: the first"),
      integer("mdmax", 0, at_least(0), "last mode that is used; 0: all"),
  }};
}
const Card excitation_of_node = excitation_card(IdSpace::node), excitation_of_set = excitation_card(IdSpace::set);

const Card damping_card{{
    real("dampf", dimension::number, 0, at_least(0), "modal damping ratio of all modes, share of the critical"),
    id("lcdam", IdSpace::function, 0, "curve of the damping ratio, instead of dampf"),
    integer("lctyp", 0, between(0, 1), "lcdam is over 0: natural frequency [cycles/time], 1: number of the mode"),
    real("dmpmas", dimension::rate, 0, at_least(0), "alpha of Rayleigh's damping alpha M + beta K; adds to the others"),
    real("dmpstf", dimension::time, 0, at_least(0), "beta"),
}};

Card response_card(IdSpace n2) {
  return {{
      id("n2", n2, 0, "node or node set whose response is written, node by node"),
      integer("n2typ", 0, between(0, 2), "0: n2 is a node, 1: a node set"),
      integer("dof2", 0, between(0, 8), "1, 2, 3: along x, y, z; 7: all three; 0: along vid2; rotations are refused"),
      zero_counts(integer("vad2", 2, between(0, 3), "0: velocity, 1: acceleration, 2: displacement")),
      id("vid2", IdSpace::define, 0, "vector of the direction, where dof2 is 0"),
      integer("relatv", 0, between(0, 1), "1: relative to the base"),
  }};
}
const Card response_of_node = response_card(IdSpace::node), response_of_set = response_card(IdSpace::set);

const Card frequency_card{{
    real("fmin", dimension::rate, 0, at_least(0), "lowest frequency [cycles/time]"),
    real("fmax", dimension::rate, required, above_zero(), "highest frequency [cycles/time]"),
    integer("nfreq", 2, at_least(2), "number of frequencies, ends included"),
    integer("fspace", 0, between(0, 3), "spacing 0: linear, 1: logarithmic; others are refused"),
    id("lcfreq", IdSpace::function, 0, "curve of frequencies; refused"),
    integer("restrt", 0, any_value, "reuse of files of an earlier run; modes are always computed"),
    integer("output", 0, between(0, 1), "no effect: frf.csv has amplitude and phase, real and imaginary part"),
}};

/// Nodes of a node or node set; other entities are refused.
std::vector<Index> nodes_of(Builder& b, const Row& row, std::string_view entity, std::string_view type) {
  if (row.integer(entity) == 0) {
    refuse(b, row, entity, "no node is given", "give a node or a node set");
    return {};
  }
  if (row.integer(type) == 1) {
    const Set<Index>* set = b.node_set(row, entity);
    return set != nullptr ? set->members : std::vector<Index>{};
  }
  const Index node = b.node(row, entity);
  return node != none ? std::vector<Index>{node} : std::vector<Index>{};
}

constexpr Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

Vec3d direction_of(Builder& b, const Row& row, std::string_view dof, std::string_view vector) {
  if (const int i = row.integer(dof); i >= 1 && i <= 3) return axes[i - 1];
  if (row.integer(vector) == 0)
    refuse(b, row, dof, "0 means the direction of a vector, and none is given", "write 1, 2 or 3, or give the vector");
  const Vec3d* v = b.vector(row, vector);
  return v != nullptr && dot(*v, *v) > 0.0 ? unit(*v) : Vec3d{};
}

/// Findings for frequencies that cannot be made; true where there was none.
bool spaced(Builder& b, const Row& row) {
  const int before = b.findings.errors();
  if (row.integer("fspace") > 1)
    refuse(b, row, "fspace", "frequencies that gather at the natural ones are not built", "write 0 or 1");
  refuse_nonzero(b, row, "lcfreq", "frequencies by curve are not built", "give FMIN, FMAX, NFREQ and FSPACE");
  return b.findings.errors() == before;
}

/// Findings for what is on the cards but not built; true where there was none.
bool built(Builder& b, const Row& excitation, const Row& response, const Row& frequencies) {
  const int before = b.findings.errors();
  if (const int vad = excitation.integer("vad1"); vad > 4)
    refuse(b, excitation, "vad1", "enforced motions by large masses, torques and rotations are not built",
           "write 3 for a nodal force, 4 for pressure, or 0, 1, 2 for base motion along an axis");
  else if (vad == 3 && excitation.integer("n1typ") == 2)
    refuse(b, excitation, "n1typ", "forces on segment sets are not built", "write 1 and give a node set");
  else if (vad == 4 && excitation.integer("n1typ") != 2)
    refuse(b, excitation, "n1typ", "pressure acts on segments", "write 2 and give a segment set");
  if (response.integer("n2typ") == 2)
    refuse(b, response, "n2typ", "responses of segment sets are not built", "write 1 and give a node set");
  if (const int dof = response.integer("dof2"); dof > 3 && dof != 7)
    refuse(b, response, "dof2", "rotations as responses are not built", "write 1, 2, 3 or 7");
  if (response.integer("vad2") == 3)
    refuse(b, response, "vad2", "nodal forces as responses are not built", "write 0, 1 or 2");
  spaced(b, frequencies);
  expect(b, frequencies, Severity::warning, {{"restrt", 0, "not obeyed: the modes are computed anew, as with 0"}});
  return b.findings.errors() == before;
}

std::vector<double> frequencies_of(Builder& b, const Row& row) {
  const double low = row.real("fmin"), high = row.real("fmax");
  const bool logarithmic = row.integer("fspace") == 1;
  if (low >= high) refuse(b, row, "fmax", "the range of frequencies is empty", "give an FMAX above FMIN");
  if (logarithmic && !(low > 0.0))
    refuse(b, row, "fmin", "logarithmic spacing cannot begin at 0", "give an FMIN above 0, or FSPACE 0");
  const auto n = static_cast<std::size_t>(row.integer("nfreq"));
  std::vector<double> f;
  for (std::size_t i = 0; i < n; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(n - 1);
    f.push_back(logarithmic ? low * std::pow(high / low, s) : low + s * (high - low));
  }
  return f;
}

FrequencyResponse::Selection selection_of(Builder& b, const Row& row) {
  const FrequencyResponse::Selection s{row.real("fnmax"), std::max(1, row.integer("mdmin")), row.integer("mdmax")};
  if (s.last > 0 && s.last < s.first) refuse(b, row, "mdmax", "no mode is left", "give an MDMAX of at least MDMIN");
  return s;
}

FrequencyResponse::Damping damping_of(Builder& b, const Row& row) {
  return {row.real("dampf"), b.curve(row, "lcdam"), row.integer("lctyp") == 1, row.real("dmpmas"), row.real("dmpstf")};
}

void check_analysis(Builder& b, const Row& excitation) {
  const Implicit& implicit = b.model.implicit;
  if (implicit.low || implicit.centre > 0.0)
    refuse(b, excitation, "mdmin", "modes of an interval (LFLAG, CENTER) leave lower ones out of the response",
           "drop LFLAG and CENTER in *CONTROL_IMPLICIT_EIGENVALUE; MDMIN chooses the first mode");
  if (!implicit.active)
    excitation.complain(
        b.findings, Severity::warning, "mdmin",
        "no frequency response: the run is explicit, since IMFLAG of *CONTROL_IMPLICIT_GENERAL is not 1",
        "write IMFLAG 1, or use `nugget frf`");
}

void check_base(Builder& b, const Row& row, std::string_view field) {
  if (b.model.spcs.empty())
    refuse(b, row, field, "base motion moves the supports, and the model has none",
           "hold nodes with *BOUNDARY_SPC, or give a nodal force");
}

void read_frf(Builder& b, const Block& block, const Options&) {
  using Quantity = FrequencyResponse::Quantity;
  Cursor cursor(b.deck, block, b.findings);
  const Row excitation = cursor.read(cursor.peek_number(1) == 0.0 ? excitation_of_node : excitation_of_set);
  if (excitation.integer("vad1") == 12)
    return refuse(b, excitation, "vad1", "torsion by a pair of nodes is not built", "write 3 for a nodal force");
  const Row damping = cursor.read(damping_card);
  const Row response = cursor.read(cursor.peek_number(1) == 0.0 ? response_of_node : response_of_set);
  const Row frequencies = cursor.read(frequency_card);
  expect_end(b, cursor);
  b.later(Phase::conditions, [=](Builder& later) {
    if (later.model.frequency_response)
      return refuse(later, excitation, "n1", "a deck has one *FREQUENCY_DOMAIN_FRF", "make a deck for each excitation");
    if (!built(later, excitation, response, frequencies)) return;
    FrequencyResponse r;
    const int vad = excitation.integer("vad1");
    r.excitation.base = vad < 3;
    if (vad != 4) r.excitation.direction = direction_of(later, excitation, "dof1", "vid1");
    if (r.excitation.base)
      r.excitation.quantity = static_cast<Quantity>(vad);
    else if (vad == 3)
      r.excitation.nodes = nodes_of(later, excitation, "n1", "n1typ");
    else if (const Set<Segment>* set = later.segment_set(excitation, "n1"))
      r.excitation.pressed = set->members;
    r.modes = selection_of(later, excitation);
    r.damping = damping_of(later, damping);
    r.response.nodes = nodes_of(later, response, "n2", "n2typ");
    if (response.integer("dof2") == 7)
      r.response.directions.assign(std::begin(axes), std::end(axes));
    else
      r.response.directions = {direction_of(later, response, "dof2", "vid2")};
    r.response.quantity = static_cast<Quantity>(response.integer("vad2"));
    r.response.relative = response.integer("relatv") == 1;
    r.frequency = frequencies_of(later, frequencies);
    later.model.frequency_response = std::move(r);
  });
  b.later(Phase::checks, [excitation](Builder& later) {
    check_analysis(later, excitation);
    if (excitation.integer("vad1") < 3) check_base(later, excitation, "vad1");
  });
}

const Card steady_modes_card{{
    integer("mdmin", 1, at_least(0), "first mode that is used"),
    integer("mdmax", 0, at_least(0), "last mode that is used; 0: all"),
    real("fnmin", dimension::rate, 0, at_least(0), "no modes below this natural frequency [cycles/time]"),
    real("fnmax", dimension::rate, 0, at_least(0), "no modes above this natural frequency [cycles/time]; 0: all"),
    integer("restmd", 0, any_value, "reuse of modes of an earlier run; modes are always computed"),
    integer("restdp", 0, any_value, "reuse of a d3ssd of an earlier run; refused"),
    integer("lcflag", 0, between(0, 1), "load curves are 0: amplitude and phase [degree], 1: real and imaginary part"),
    integer("relatv", 0, between(0, 1), "1: responses to base motion are relative to it"),
}};

const Card steady_damping_card{{
    real("dampf", dimension::number, 0, at_least(0), "modal damping ratio of all modes, share of the critical"),
    id("lcdam", IdSpace::function, 0, "curve of the damping ratio, instead of dampf"),
    integer("lctyp", 0, between(0, 1), "lcdam is over 0: natural frequency [cycles/time], 1: number of the mode"),
    real("dmpmas", dimension::rate, 0, at_least(0), "alpha of Rayleigh's damping alpha M + beta K; adds to the others"),
    real("dmpstf", dimension::time, 0, at_least(0), "beta"),
    integer("dmpflg", 0, between(0, 1), "1: damping of *DAMPING_PART_...; refused"),
}};

const Card steady_options_card{{
    integer("unused", 0, any_value, "no effect"),
    integer("istress", 0, any_value, "stresses over frequency; not written"),
    integer("memory", 0, any_value, "no effect"),
    integer("nerp", 0, any_value, "panels of radiated power; refused"),
    integer("strtyp", 0, any_value, "of the radiated power, no effect"),
    integer("nout", 0, any_value, "of the radiated power, no effect"),
    integer("notyp", 0, any_value, "of the radiated power, no effect"),
    integer("nova", 0, any_value, "of the radiated power, no effect"),
}};

Card steady_load_card(IdSpace nid) {
  return {{
      id("nid", nid, 0, "node, node set or segment set that is loaded; base motion moves all supports instead"),
      integer("ntyp", 0, between(0, 2), "0: node, 1: node set, 2: segment set (pressure)"),
      integer("dof", 1, between(1, 4), "1, 2, 3: along x, y, z; 4: along vid"),
      integer("vad", 0, between(0, 12),
              "0: nodal force, 1: pressure, 2, 3, 4: base velocity, acceleration, displacement; others are refused"),
      id("lc1", IdSpace::function, required, "curve over frequency: amplitude or real part; 0 outside"),
      id("lc2", IdSpace::function, 0, "curve over frequency: phase [degree] or imaginary part; 0 outside"),
      real("sf", dimension::number, 1, any_value, "factor on the amplitude"),
      id("vid", IdSpace::define, 0, "vector of the direction, where dof is 4"),
  }};
}
const Card steady_load_of_node = steady_load_card(IdSpace::node), steady_load_of_set = steady_load_card(IdSpace::set);

const Card steady_frequency_card{{
    real("fmin", dimension::rate, 0, at_least(0), "lowest frequency [cycles/time]"),
    real("fmax", dimension::rate, required, above_zero(), "highest frequency [cycles/time]"),
    integer("nfreq", 2, at_least(2), "number of frequencies, ends included"),
    integer("fspace", 0, between(0, 3), "spacing 0: linear, 1: logarithmic; others are refused"),
    id("lcfreq", IdSpace::function, 0, "curve of frequencies; refused"),
}};

SteadyState::Load steady_load(Builder& b, const Row& row) {
  SteadyState::Load load;
  FrequencyResponse::Excitation& e = load.excitation;
  const int vad = row.integer("vad");
  const bool segments = row.integer("ntyp") == 2;
  if (vad > 4)
    refuse(b, row, "vad", "enforced motions by large masses, torques and rotations are not built",
           "write 0 for a nodal force, 1 for pressure, or 2, 3, 4 for base motion");
  else if (vad == 1 && !segments)
    refuse(b, row, "ntyp", "pressure acts on segments", "write 2 and give a segment set");
  else if (vad == 0 && segments)
    refuse(b, row, "ntyp", "forces on segment sets are not built", "write 1 and give a node set");
  else if (vad == 1) {
    if (const Set<Segment>* set = b.segment_set(row, "nid")) e.pressed = set->members;
  } else {
    e.direction = direction_of(b, row, "dof", "vid");
    e.base = vad > 1;
    if (e.base)
      e.quantity = static_cast<FrequencyResponse::Quantity>(vad - 2);
    else
      e.nodes = nodes_of(b, row, "nid", "ntyp");
  }
  load.scale = row.real("sf");
  load.first = b.curve(row, "lc1");
  load.second = b.curve(row, "lc2");
  return load;
}

/// What stands on *FREQUENCY_DOMAIN_SSD and on the card of its output meet in the model.
SteadyState& steady_state(Builder& b) {
  if (!b.model.steady_state) b.model.steady_state.emplace();
  return *b.model.steady_state;
}

void read_ssd(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row modes = cursor.read(steady_modes_card), damping = cursor.read(steady_damping_card),
            options = cursor.read(steady_options_card);
  std::vector<Row> loads;
  while (cursor.more())
    loads.push_back(cursor.read(cursor.peek_number(1) == 0.0 ? steady_load_of_node : steady_load_of_set));
  if (loads.empty()) refuse(b, modes, "mdmin", "no load is given", "give a load card after the first three");
  b.later(Phase::conditions, [=](Builder& later) {
    SteadyState& s = steady_state(later);
    if (!s.loads.empty())
      return refuse(later, modes, "mdmin", "a deck has one *FREQUENCY_DOMAIN_SSD", "put all loads under one");
    refuse_nonzero(later, modes, "restdp", "results of an earlier run are not read", "leave it out");
    refuse_nonzero(later, damping, "dmpflg", "damping of parts is not built in the response over frequency",
                   "give DAMPF, LCDAM, DMPMAS or DMPSTF");
    refuse_nonzero(later, options, "nerp", "radiated power is not built", "leave it out");
    expect(later, modes, Severity::warning, {{"restmd", 0, "not obeyed: the modes are computed anew, as with 0"}});
    expect(later, options, Severity::warning, {{"istress", 0, "not obeyed: stresses over frequency are not written"}});
    s.modes = selection_of(later, modes);
    s.modes.lowest = modes.real("fnmin");
    s.damping = damping_of(later, damping);
    s.by_parts = modes.integer("lcflag") == 1;
    s.relative = modes.integer("relatv") == 1;
    for (const Row& load : loads) s.loads.push_back(steady_load(later, load));
  });
  b.later(Phase::checks, [modes, loads](Builder& later) {
    check_analysis(later, modes);
    for (const Row& load : loads)
      if (load.integer("vad") > 1) check_base(later, load, "vad");
    if (steady_state(later).frequency.empty())
      refuse(later, modes, "mdmin", "no frequencies are given",
             "add *DATABASE_FREQUENCY_ASCII_NODOUT_SSD with FMIN, FMAX and NFREQ");
    if (later.model.requests.history_nodes.empty())
      refuse(later, modes, "mdmin", "no nodes are given whose response is wanted", "add *DATABASE_HISTORY_NODE");
  });
}

void read_nodout_ssd(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const Row row = cursor.read(steady_frequency_card);
  expect_end(b, cursor);
  b.later(Phase::conditions, [row](Builder& later) {
    if (spaced(later, row)) steady_state(later).frequency = frequencies_of(later, row);
  });
  b.later(Phase::checks, [row](Builder& later) {
    if (!later.model.steady_state || !later.model.steady_state->loads.empty()) return;
    row.complain(later.findings, Severity::warning, "fmin", "no response: there is no *FREQUENCY_DOMAIN_SSD", "");
    later.model.steady_state.reset();
  });
}

}  // namespace

std::vector<Keyword> frequency_keywords() {
  return {
      {.name = "FREQUENCY_DOMAIN_FRF",
       .layout = {{"", &excitation_of_node}, {"", &damping_card}, {"", &response_of_node}, {"", &frequency_card}},
       .read = read_frf},
      {.name = "FREQUENCY_DOMAIN_FRF_*",
       .verdict = Verdict::refused,
       .why = "options of *FREQUENCY_DOMAIN_FRF (_SUBCASE) are not built; make a deck for each excitation"},
      {.name = "FREQUENCY_DOMAIN_SSD",
       .layout = {{"", &steady_modes_card},
                  {"", &steady_damping_card},
                  {"", &steady_options_card},
                  {"for each load", &steady_load_of_node}},
       .read = read_ssd},
      {.name = "DATABASE_FREQUENCY_ASCII_NODOUT_SSD",
       .layout = {{"", &steady_frequency_card}},
       .read = read_nodout_ssd},
      {.name = "FREQUENCY_DOMAIN_*",
       .verdict = Verdict::refused,
       .why = "of the responses over frequency *FREQUENCY_DOMAIN_FRF and _SSD by modes are built"},
  };
}

}  // namespace nugget::model
