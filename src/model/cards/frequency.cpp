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
      id("n1", n1, 0, "node or node set that is loaded; base motion moves all supports instead"),
      integer("n1typ", 0, between(0, 2), "0: n1 is a node, 1: a node set, each of whose nodes carries the unit force"),
      integer("dof1", 0, between(0, 3), "1, 2, 3: along x, y, z; 0: along vid1"),
      zero_counts(integer("vad1", 3, between(0, 12),
                          "0, 1, 2: base velocity, acceleration, displacement; 3: nodal force; others are refused")),
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

/// Findings for what is on the cards but not built; true where there was none.
bool built(Builder& b, const Row& excitation, const Row& response, const Row& frequencies) {
  const int before = b.findings.errors();
  if (const int vad = excitation.integer("vad1"); vad > 3)
    refuse(b, excitation, "vad1",
           vad == 4 ? "pressure is not built" : "enforced motions by large masses, torques and rotations are not built",
           "write 3 for a nodal force, or 0, 1, 2 for base motion along an axis");
  else if (vad == 3 && excitation.integer("n1typ") == 2)
    refuse(b, excitation, "n1typ", "forces on segment sets are not built", "write 1 and give a node set");
  if (response.integer("n2typ") == 2)
    refuse(b, response, "n2typ", "responses of segment sets are not built", "write 1 and give a node set");
  if (const int dof = response.integer("dof2"); dof > 3 && dof != 7)
    refuse(b, response, "dof2", "rotations as responses are not built", "write 1, 2, 3 or 7");
  if (response.integer("vad2") == 3)
    refuse(b, response, "vad2", "nodal forces as responses are not built", "write 0, 1 or 2");
  if (frequencies.integer("fspace") > 1)
    refuse(b, frequencies, "fspace", "frequencies that gather at the natural ones are not built", "write 0 or 1");
  refuse_nonzero(b, frequencies, "lcfreq", "frequencies by curve are not built", "give FMIN, FMAX, NFREQ and FSPACE");
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

void check_analysis(Builder& b, const Row& excitation) {
  const Implicit& implicit = b.model.implicit;
  if (implicit.low || implicit.centre > 0.0)
    refuse(b, excitation, "mdmin", "modes of an interval (LFLAG, CENTER) leave lower ones out of the response",
           "drop LFLAG and CENTER in *CONTROL_IMPLICIT_EIGENVALUE; MDMIN chooses the first mode");
  if (!implicit.active)
    excitation.complain(
        b.findings, Severity::warning, "n1",
        "no frequency response: the run is explicit, since IMFLAG of *CONTROL_IMPLICIT_GENERAL is not 1",
        "write IMFLAG 1, or use `nugget frf`");
  if (excitation.integer("vad1") < 3 && b.model.spcs.empty())
    refuse(b, excitation, "vad1", "base motion moves the supports, and the model has none",
           "hold nodes with *BOUNDARY_SPC, or write 3 for a nodal force");
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
    r.excitation.direction = direction_of(later, excitation, "dof1", "vid1");
    if (r.excitation.base)
      r.excitation.quantity = static_cast<Quantity>(vad);
    else
      r.excitation.nodes = nodes_of(later, excitation, "n1", "n1typ");
    r.modes = {excitation.real("fnmax"), std::max(1, excitation.integer("mdmin")), excitation.integer("mdmax")};
    if (r.modes.last > 0 && r.modes.last < r.modes.first)
      refuse(later, excitation, "mdmax", "no mode is left", "give an MDMAX of at least MDMIN");
    r.damping = {damping.real("dampf"), later.curve(damping, "lcdam"), damping.integer("lctyp") == 1,
                 damping.real("dmpmas"), damping.real("dmpstf")};
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
  b.later(Phase::checks, [excitation](Builder& later) { check_analysis(later, excitation); });
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
      {.name = "FREQUENCY_DOMAIN_*",
       .verdict = Verdict::refused,
       .why = "of the responses over frequency only *FREQUENCY_DOMAIN_FRF is built"},
  };
}

}  // namespace nugget::model
