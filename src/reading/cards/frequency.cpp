// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/index.hpp"
#include "model/segments.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/frequency_cards.hpp"

// *FREQUENCY_DOMAIN_FRF, and what it shares with *FREQUENCY_DOMAIN_SSD.
namespace nugget::reading {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

namespace {

using Excitation = FrequencyResponse::Excitation;
using Response = FrequencyResponse::Response;
using Quantity = FrequencyResponse::Quantity;

/// The name space of N1 depends on its type, which stands behind it; so with N2.
CardOf<ExcitationCard> excitation_card(IdSpace n1, std::initializer_list<FieldOf<ExcitationCard>> rest = {}) {
  const CardOf<ExcitationCard> fields{
      {&ExcitationCard::entity,
       id("n1", n1, 0, "node, node set or segment set that is loaded; base motion moves all supports instead")},
      {&ExcitationCard::type,
       integer("n1typ", 0, between(0, 2),
               "0: n1 is a node, 1: a node set, each of whose nodes is driven, 2: a segment set under pressure")},
      {&ExcitationCard::direction,
       integer("dof1", 0, between(0, 3),
               "1, 2, 3: along (torque, turning base: about) x, y, z; 0: along vid1; pressure: no effect")},
      {&ExcitationCard::vad,
       zero_counts(integer("vad1", 3, between(0, 12),
                           "what has amplitude 1. 0, 1, 2: base velocity, acceleration, displacement; 3: nodal force; "
                           "4: pressure; 5, 6, 7: enforced velocity, acceleration, displacement of the nodes; 8: "
                           "torque; 9, 10, 11: base angular velocity, acceleration, rotation; 12 is refused"))},
      {&ExcitationCard::vector, id("vid1", IdSpace::define, 0, "vector of the direction, where dof1 is 0")},
  };
  return with_rest(fields, rest);
}
constexpr RealField fnmax =
    real("fnmax", dimension::rate, 0, at_least(0), "no modes above this natural frequency [cycles/time]; 0: all");
constexpr IntegerField mdmin = integer("mdmin", 0, at_least(0), "first mode that is used; 0: the first");
constexpr IntegerField mdmax = integer("mdmax", 0, at_least(0), "last mode that is used; 0: all");
const std::initializer_list<FieldOf<ExcitationCard>> selection_fields{
    {&SelectionCard::fnmax, fnmax}, {&SelectionCard::mdmin, mdmin}, {&SelectionCard::mdmax, mdmax}};
const CardOf<ExcitationCard> excitation_of_node = excitation_card(IdSpace::node, selection_fields),
                             excitation_of_set = excitation_card(IdSpace::set, selection_fields),
                             case_excitation_of_node = excitation_card(IdSpace::node),
                             case_excitation_of_set = excitation_card(IdSpace::set);

const CardOf<DampingCard> modal_damping_card = damping_card_of_response();

constexpr IntegerField relatv = integer("relatv", 0, between(0, 1), "1: relative to the base");

struct ResponseCard {
  int entity = 0, type = 0, direction = 0, vad = 0, vector = 0, relatv = 0;
};
CardOf<ResponseCard> response_card(IdSpace n2, std::initializer_list<FieldOf<ResponseCard>> rest = {}) {
  const CardOf<ResponseCard> fields{
      {&ResponseCard::entity, id("n2", n2, 0, "node or node set whose response is written, node by node")},
      {&ResponseCard::type, integer("n2typ", 0, between(0, 2), "0: n2 is a node, 1: a node set")},
      {&ResponseCard::direction,
       integer("dof2", 0, between(0, 8),
               "1, 2, 3: along x, y, z; 7: all three; 4, 5, 6: about x, y, z; 8: all three; 0: along vid2")},
      {&ResponseCard::vad,
       zero_counts(integer("vad2", 2, between(0, 3),
                           "0: velocity, 1: acceleration, 2: displacement, 3: force (moment) of the support that holds "
                           "the node"))},
      {&ResponseCard::vector, id("vid2", IdSpace::define, 0, "vector of the direction, where dof2 is 0")},
  };
  return with_rest(fields, rest);
}
const CardOf<ResponseCard> response_of_node = response_card(IdSpace::node, {{&ResponseCard::relatv, relatv}}),
                           response_of_set = response_card(IdSpace::set, {{&ResponseCard::relatv, relatv}}),
                           case_response_of_node = response_card(IdSpace::node),
                           case_response_of_set = response_card(IdSpace::set);

const CardOf<FrequencyCard> frf_frequencies = frequency_card({
    {&FrequencyCard::restrt,
     integer("restrt", 0, any_value, "reuse of files of an earlier run; modes are always computed")},
    {&FrequencyCard::output,
     integer("output", 0, between(0, 1), "0: files frf_amplitude and frf_angle, 1: frf_real and frf_imag")},
});

struct CasesCard : SelectionCard {
  int ncases = 0, relatv = 0;
};
const CardOf<CasesCard> cases_card{
    {&CasesCard::ncases,
     integer("ncases", required, at_least(1), "number of subcases, each a title, an excitation and a response")},
    unused(),
    unused(),
    unused(),
    {&CasesCard::relatv, relatv},
    {&SelectionCard::fnmax, fnmax},
    {&SelectionCard::mdmin, mdmin},
    {&SelectionCard::mdmax, mdmax},
};
const Card title_of_case{{text("title", 80, "of the subcase")}};

struct StructuralCard {
  double g = 0;
  int lcid = 0, lctyp = 0;
};
const CardOf<StructuralCard> structural_damping_card{
    {&StructuralCard::g, real("g", dimension::number, 0, at_least(0), "loss factor: the stiffness is K (1 + i g)")},
    {&StructuralCard::lcid,
     id("lcid", IdSpace::function, 0, "curve of the loss factor, instead of g; end values hold outside")},
    {&StructuralCard::lctyp,
     integer("lctyp", 0, between(0, 1), "lcid is over 0: frequency of the excitation, 1: number of the mode")},
};

const Card control_card{{
    integer("refgeo", 0, any_value, "of acoustics, no effect"),
    real("mpn", dimension::mass, 0, any_value,
         "large mass at driven nodes; no effect: their motion is enforced exactly"),
}};

constexpr Vec3d frequency_axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/// What stands on the cards of a case.
struct CaseRows {
  std::string title;
  RowOf<ExcitationCard> excitation;
  RowOf<ResponseCard> response;
};

constexpr Driven of_frf[] = {{Excitation::Kind::base, Quantity::velocity},
                             {Excitation::Kind::base, Quantity::acceleration},
                             {Excitation::Kind::base, Quantity::displacement},
                             {Excitation::Kind::force},
                             {Excitation::Kind::pressure},
                             {Excitation::Kind::enforced, Quantity::velocity},
                             {Excitation::Kind::enforced, Quantity::acceleration},
                             {Excitation::Kind::enforced, Quantity::displacement},
                             {Excitation::Kind::torque},
                             {Excitation::Kind::base, Quantity::velocity, true},
                             {Excitation::Kind::base, Quantity::acceleration, true},
                             {Excitation::Kind::base, Quantity::displacement, true}};

Response response_of(Builder& b, const RowOf<ResponseCard>& row) {
  Response r;
  r.place = row.place();
  if (row->type == 2) {
    refuse(b, row[&ResponseCard::type], "responses of segment sets are not built", "write 1 and give a node set");
    return r;
  }
  r.nodes = nodes_of(b, row[&ResponseCard::entity], row->type);
  const int dof = row->direction;
  r.rotation = dof == 8 || (dof >= 4 && dof <= 6);
  if (dof > 6)
    r.directions.assign(std::begin(frequency_axes), std::end(frequency_axes));
  else
    r.directions = {dof > 3 ? frequency_axes[dof - 4]
                            : direction_of(b, row[&ResponseCard::direction], row[&ResponseCard::vector])};
  r.quantity = static_cast<Quantity>(row->vad);
  return r;
}

FrequencyResponse::Case case_of(Builder& b, const CaseRows& rows) {
  const int vad = rows.excitation->vad;
  if (vad < 0 || at(vad) >= std::size(of_frf)) return {};  // refused
  return {rows.title, excitation_of(b, rows.excitation, of_frf[vad]), response_of(b, rows.response)};
}

void make_relative(Builder& b, const deck::Entry& relatv_entry, FrequencyResponse& r) {
  if (relatv_entry.integer() == 0) return;
  for (FrequencyResponse::Case& c : r.cases) {
    c.response.relative = true;
    if (c.excitation.kind != Excitation::Kind::base)
      refuse(b, relatv_entry, "relative to the base means nothing where no base moves (VAD1 0, 1, 2)", "write 0");
    else if (c.response.quantity == Quantity::force)
      refuse(b, relatv_entry, "a force is not relative to the base", "write 0");
  }
}

/// Subcases share their modes.
void check_cases(Builder& b, const CaseRows& rows, const FrequencyResponse& r) {
  for (const FrequencyResponse::Case& c : r.cases)
    if (r.cases.size() > 1 && c.excitation.kind == Excitation::Kind::enforced)
      return refuse(b, rows.excitation[&ExcitationCard::vad],
                    "subcases share their modes, and enforced nodes would be held in those of all",
                    "make a deck for each enforced motion");
}

/// The fields that all cases share, on their own card or on that of the only case.
struct SharedFields {
  SelectionCard selection;
  deck::Entry mdmin_entry, mdmax_entry, relatv_entry;
};

template <class SelectingCard, class RelativeCard>
SharedFields shared_fields(const RowOf<SelectingCard>& selection, const RowOf<RelativeCard>& relative) {
  return {*selection, selection[&SelectionCard::mdmin], selection[&SelectionCard::mdmax],
          relative[&RelativeCard::relatv]};
}

void make_frf(Builder& builder, const std::vector<CaseRows>& cases, const SharedFields& shared,
              const RowOf<DampingCard>& damping, const RowOf<FrequencyCard>& frequencies) {
  builder.defer(Phase::conditions, [=](Builder& b) {
    if (b.model.frequency_response)
      return refuse(b, cases.front().excitation[&ExcitationCard::entity], "a deck has one *FREQUENCY_DOMAIN_FRF",
                    "put the excitations under one *FREQUENCY_DOMAIN_FRF_SUBCASE");
    FrequencyResponse r;
    static_cast<Frequencies&>(r) = frequencies_of(b, frequencies);
    for (const CaseRows& rows : cases) r.cases.push_back(case_of(b, rows));
    make_relative(b, shared.relatv_entry, r);
    check_cases(b, cases.front(), r);
    expect(b, Severity::warning,
           {{frequencies[&FrequencyCard::restrt], 0, "not obeyed: the modes are computed anew, as with 0"}});
    r.modes = selection_of(b, shared.selection, shared.mdmax_entry);
    r.damping = damping_of(b, damping);
    r.by_parts = frequencies->output == 1;
    b.model.frequency_response = std::move(r);
  });
  builder.defer(Phase::checks, [=](Builder& b) {
    if (b.model.frequency_response) check_analysis(b, shared.mdmin_entry, true, b.model.frequency_response->modes);
    if (b.model.frequency_response) check_damped(b, damping[&DampingCard::dampf], b.model.frequency_response->damping);
    if (!b.model.frequency_response || b.model.frequency_response->cases.size() != cases.size()) return;
    for (std::size_t i = 0; i < cases.size(); ++i)
      check_excitation(b, cases[i].excitation[&ExcitationCard::vad], b.model.frequency_response->cases[i].excitation);
  });
}

/// False, and an error, for torsion.
bool no_torsion(Builder& b, const RowOf<ExcitationCard>& excitation) {
  if (excitation->vad != 12) return true;
  refuse(b, excitation[&ExcitationCard::vad], "torsion by a pair of nodes is not built",
         "write 8 for a torque on a node");
  return false;
}

void read_frf(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  const auto either = [&](const auto& of_node, const auto& of_set) {
    return cursor.read(cursor.peek_number(1) == 0.0 ? of_node : of_set);
  };
  if (!options.contains("SUBCASE")) {
    const auto excitation = either(excitation_of_node, excitation_of_set);
    if (!no_torsion(b, excitation)) return;
    const auto damping = cursor.read(modal_damping_card);
    const auto response = either(response_of_node, response_of_set);
    const auto frequencies = cursor.read(frf_frequencies);
    expect_end(b, cursor);
    return make_frf(b, {{"", excitation, response}}, shared_fields(excitation, response), damping, frequencies);
  }
  const auto shared = cursor.read(cases_card);
  const auto damping = cursor.read(modal_damping_card);
  const auto frequencies = cursor.read(frf_frequencies);
  std::vector<CaseRows> cases;
  for (int i = 0; i < shared->ncases; ++i) {
    if (!cursor.more())
      return refuse(b, shared[&CasesCard::ncases], fmt::format("only {} subcases are there", i),
                    "give a title, an excitation and a response for each");
    const std::string title = cursor.read_text();
    const auto excitation = either(case_excitation_of_node, case_excitation_of_set);
    if (!no_torsion(b, excitation)) return;
    cases.push_back({title, excitation, either(case_response_of_node, case_response_of_set)});
  }
  expect_end(b, cursor);
  if (!cases.empty()) make_frf(b, cases, shared_fields(shared, shared), damping, frequencies);
}

/// LCFREQ. The manual does not say which column holds the frequencies: a curve that leaves it open is refused.
std::vector<double> listed_frequencies(Builder& b, const deck::Entry& lcfreq) {
  const Index id = b.curve(lcfreq);
  if (id == none) return {};
  const Curve& curve = b.model.curves[id];
  if (curve.empty()) return {};  // reported where it is defined
  const bool same = curve.x == curve.y,
             constant = std::all_of(curve.y.begin(), curve.y.end(), [&](double y) { return y == curve.y.front(); });
  if (!same && !constant)
    refuse(b, lcfreq, "it is open whether the curve's abscissae or its ordinates are the frequencies",
           "write each frequency in both columns, or a constant in the second");
  if (curve.x.front() < 0.0) refuse(b, lcfreq, "there are frequencies below 0", "leave them out");
  return curve.x;
}

void read_structural(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  const auto row = cursor.read(structural_damping_card);
  expect_end(b, cursor);
  b.defer(Phase::conditions, [row](Builder& later) {
    if (later.model.structural_damping.given())
      return refuse(later, row[&StructuralCard::g], "a deck has one *DAMPING_STRUCTURAL", "take one of them out");
    later.model.structural_damping = {row->g, later.curve(row[&StructuralCard::lcid]), row->lctyp == 1};
  });
  b.defer(Phase::checks, [row](Builder& later) {
    if (!later.model.frequency_response && !later.model.steady_state)
      row[&StructuralCard::g].report(later.findings, Severity::warning,
                                     "no effect: it damps responses over frequency only",
                                     "damp an impact with another *DAMPING_ keyword");
  });
}

void read_frequency_control(Builder& b, const Block& block, const Options&) {
  Cursor cursor(b.deck, block, b.findings);
  cursor.read(control_card);
  expect_end(b, cursor);
}

}  // namespace

std::vector<Index> nodes_of(Builder& b, const deck::Entry& entity, int type) {
  if (entity.integer() == 0) {
    refuse(b, entity, "no node is given", "give a node or a node set");
    return {};
  }
  if (type == 1) {
    const Set<Index>* set = b.node_set(entity);
    if (set == nullptr) return {};
    if (set->members.empty()) refuse(b, entity, "the node set has no members", "give a set with nodes");
    return set->members;
  }
  const Index node = b.node(entity);
  return node != none ? std::vector<Index>{node} : std::vector<Index>{};
}

Vec3d direction_of(Builder& b, const deck::Entry& axis, const deck::Entry& vector) {
  if (const int i = axis.integer(); i >= 1 && i <= 3) return frequency_axes[i - 1];
  if (vector.integer() == 0) {
    // As LS-DYNA's own result of such a deck is called (docs/evidence/vibration.md).
    axis.report(b.findings, Severity::warning, "it means the direction of a vector, and none is given: z is taken",
                "write 1, 2 or 3, or give the vector");
    return frequency_axes[2];
  }
  const Vec3d* v = b.vector(vector);
  return v != nullptr && dot(*v, *v) > 0.0 ? unit(*v) : Vec3d{};
}

Excitation excitation_of(Builder& b, const RowOf<ExcitationCard>& row, const Driven& driven) {
  const deck::Entry entity = row[&ExcitationCard::entity], type = row[&ExcitationCard::type],
                    vector = row[&ExcitationCard::vector];
  Excitation e;
  e.place = row.place();
  e.kind = driven.kind;
  e.quantity = driven.quantity;
  e.turning = driven.turning;
  const bool segments = row->type == 2;
  if (e.kind == Excitation::Kind::pressure) {
    if (!segments)
      refuse(b, type, "pressure acts on segments", "write 2 and give a segment set");
    else if (const Set<Segment>* set = b.segment_set(entity)) {
      e.pressed = set->members;
      if (e.pressed.empty()) refuse(b, entity, "the segment set has no members", "give one with segments");
      e.share = share_pressure(b.model, e.pressed);
    } else if (row->entity == 0)
      refuse(b, entity, "no segment set is given", "give the set that carries the pressure");
    return e;
  }
  e.direction = direction_of(b, row[&ExcitationCard::direction], vector);
  if (e.kind == Excitation::Kind::base) {
    const int axis = row->direction;
    const bool along_vector = e.turning && (axis < 1 || axis > 3) && row->vector != 0;
    if (const Vec3d* tail = along_vector ? b.vector_tail(vector) : nullptr) e.axis = *tail;
    return e;
  }
  if (segments)
    refuse(b, type, "only pressure acts on segment sets", "write 1 and give a node set");
  else
    e.nodes = nodes_of(b, entity, row->type);
  return e;
}

CardOf<DampingCard> damping_card_of_response(std::initializer_list<FieldOf<DampingCard>> rest) {
  return with_rest(
      CardOf<DampingCard>{
          {&DampingCard::dampf,
           real("dampf", dimension::number, 0, at_least(0), "modal damping ratio of all modes, share of the critical")},
          {&DampingCard::lcdam, id("lcdam", IdSpace::function, 0, "curve of the damping ratio, instead of dampf")},
          {&DampingCard::lctyp, integer("lctyp", 0, between(0, 1),
                                        "lcdam is over 0: natural frequency [cycles/time], 1: number of the mode")},
          {&DampingCard::dmpmas, real("dmpmas", dimension::rate, 0, at_least(0),
                                      "alpha of Rayleigh's damping alpha M + beta K; adds to the others")},
          {&DampingCard::dmpstf, real("dmpstf", dimension::time, 0, at_least(0), "beta")},
      },
      rest);
}

CardOf<FrequencyCard> frequency_card(std::initializer_list<FieldOf<FrequencyCard>> rest) {
  return with_rest(
      CardOf<FrequencyCard>{
          {&FrequencyCard::fmin, real("fmin", dimension::rate, 0, at_least(0), "lowest frequency [cycles/time]")},
          {&FrequencyCard::fmax, real("fmax", dimension::rate, 0, at_least(0), "highest frequency [cycles/time]")},
          {&FrequencyCard::nfreq, integer("nfreq", 2, between(1, 1000000),
                                          "number of frequencies, ends included; 1: FMIN alone, which FMAX must be")},
          {&FrequencyCard::fspace,
           integer("fspace", 0, between(0, 3),
                   "spacing 0: linear, 1: logarithmic, 2: gathered at the natural frequencies, 3: these alone")},
          {&FrequencyCard::lcfreq, id("lcfreq", IdSpace::function, 0,
                                      "curve whose abscissae are the frequencies, instead of the fields before")},
      },
      rest);
}

Frequencies frequencies_of(Builder& b, const RowOf<FrequencyCard>& row) {
  if (row->lcfreq != 0) return {listed_frequencies(b, row[&FrequencyCard::lcfreq]), {}};
  const double low = row->fmin, high = row->fmax;
  const int count = row->nfreq, spacing = row->fspace;
  const bool logarithmic = spacing == 1;
  if (low == high && low > 0.0 && spacing < 2) return {{low}, {}};
  if (low >= high) refuse(b, row[&FrequencyCard::fmax], "the range of frequencies is empty", "give an FMAX above FMIN");
  if (count < 2)
    refuse(b, row[&FrequencyCard::nfreq], "one frequency of a range: which one?",
           "give FMAX as FMIN for that frequency alone, or an NFREQ of 2 or more");
  if (logarithmic && !(low > 0.0))
    refuse(b, row[&FrequencyCard::fmin], "logarithmic spacing cannot begin at 0", "give an FMIN above 0, or FSPACE 0");
  if (spacing > 1) return {{low, high}, spacing == 2 ? count : 0};
  std::vector<double> f;
  for (int i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(count - 1);
    f.push_back(logarithmic ? low * std::pow(high / low, s) : low + s * (high - low));
  }
  return {f, {}};
}

FrequencyResponse::Selection selection_of(Builder& b, const SelectionCard& card, const deck::Entry& mdmax_entry) {
  const FrequencyResponse::Selection s{card.fnmax, std::max(1, card.mdmin), card.mdmax};
  if (s.last > 0 && s.last < s.first) refuse(b, mdmax_entry, "no mode is left", "give an MDMAX of at least MDMIN");
  return s;
}

FrequencyResponse::Damping damping_of(Builder& b, const RowOf<DampingCard>& row) {
  return {row->dampf, b.curve(row[&DampingCard::lcdam]), row->lctyp == 1, row->dmpmas, row->dmpstf};
}

void check_damped(Builder& b, const deck::Entry& dampf, const FrequencyResponse::Damping& d) {
  if (d.ratio > 0.0 || d.curve != none || d.mass > 0.0 || d.stiffness > 0.0 || d.of_parts ||
      b.model.structural_damping.given())
    return;
  dampf.report(b.findings, Severity::warning, "nothing damps: responses grow without bound at resonances",
               "give DAMPF, LCDAM, DMPMAS, DMPSTF or *DAMPING_STRUCTURAL");
}

void check_analysis(Builder& b, const deck::Entry& field, bool modal, const FrequencyResponse::Selection& selection) {
  const Implicit& implicit = b.model.implicit;
  const int modes = std::abs(implicit.modes);
  if (modal && modes > 0 && selection.first > modes)
    refuse(b, field, fmt::format("no mode is left: NEIG of *CONTROL_IMPLICIT_EIGENVALUE asks for {}", modes),
           "raise NEIG, or lower MDMIN");
  if (modal && (implicit.low || implicit.centre > 0.0))
    refuse(b, field, "modes of an interval (LFLAG, CENTER) leave lower ones out of the response",
           "drop LFLAG and CENTER in *CONTROL_IMPLICIT_EIGENVALUE; MDMIN chooses the first mode");
}

void check_excitation(Builder& b, const deck::Entry& field, const Excitation& excitation) {
  if (excitation.kind == Excitation::Kind::base && b.model.spcs.empty())
    refuse(b, field, "base motion moves the supports, and the model has none",
           "hold nodes with *BOUNDARY_SPC, or give a nodal force");
  const auto enforced = [](const Excitation& e) { return e.kind == Excitation::Kind::enforced; };
  if (enforced(excitation) && b.model.frequency_response && b.model.steady_state)
    refuse(b, field, "enforced nodes are held in the modes, which two responses cannot share",
           "make a deck for each of *FREQUENCY_DOMAIN_FRF and _SSD");
}

std::vector<Keyword> frequency_keywords() {
  return {
      {.name = "FREQUENCY_DOMAIN_FRF",
       .options = {"SUBCASE"},
       .layout = {{"without _SUBCASE", &excitation_of_node},
                  {"with _SUBCASE", &cases_card},
                  {"", &modal_damping_card},
                  {"without _SUBCASE", &response_of_node},
                  {"", &frf_frequencies},
                  {"with _SUBCASE, for each", &title_of_case},
                  {"with _SUBCASE, for each", &case_excitation_of_node},
                  {"with _SUBCASE, for each", &case_response_of_node}},
       .read = read_frf},
      {.name = "FREQUENCY_DOMAIN_FRF_*",
       .status = KeywordStatus::refused,
       .why = "of the options of *FREQUENCY_DOMAIN_FRF _SUBCASE is built"},
      {.name = "DAMPING_STRUCTURAL", .layout = {{"", &structural_damping_card}}, .read = read_structural},
      {.name = "CONTROL_FREQUENCY_DOMAIN", .layout = {{"", &control_card}}, .read = read_frequency_control},
      {.name = "FREQUENCY_DOMAIN_*",
       .status = KeywordStatus::refused,
       .why = "of the responses over frequency *FREQUENCY_DOMAIN_FRF and _SSD are built"},
  };
}

}  // namespace nugget::reading
