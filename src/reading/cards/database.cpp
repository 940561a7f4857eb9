// SPDX-License-Identifier: Apache-2.0
// *DATABASE_...: which results are written, how often, and of what.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <string>
#include <utility>

#include "model/history_files.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

namespace nugget::reading {
namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

struct IntervalCard {
  double dt = 0;
  int binary = 0, lcur = 0, ioopt = 0;
  std::array<double, 4> option{};
};
const CardOf<IntervalCard> interval_card{
    {&IntervalCard::dt, real("dt", dimension::time, 0, at_least(0), "time between two records; 0 writes none")},
    {&IntervalCard::binary, integer("binary", 0, between(0, 3), "0, 1 ASCII file; 2 binout; 3 both")},
    {&IntervalCard::lcur, id("lcur", IdSpace::function, 0, "curve of the interval over time, instead of dt")},
    {&IntervalCard::ioopt,
     integer("ioopt", 1, between(0, 3),
             "next output: 1 after the curve's value at this one, 2 where its own value is what has passed, 3 at each "
             "of the "
             "curve's abscissas")},
    {at(&IntervalCard::option, 0), real("option1", dimension::number, 0, any_value,
                                        "more output: of swforc 1 gives the resultant force of each weld (ours; "
                                        "LS-DYNA has no such field there); of other "
                                        "files a finer nodout, history variables in elout, which are not written")},
    {at(&IntervalCard::option, 1), real("option2", dimension::number, 0, any_value, "the same")},
    {at(&IntervalCard::option, 2), real("option3", dimension::number, 0, any_value, "the same")},
    {at(&IntervalCard::option, 3), real("option4", dimension::number, 0, any_value, "the same")},
};

struct D3plotCard {
  double dt = 0;
  int lcdt = 0, npltc = 0;
};
const CardOf<D3plotCard> d3plot_card{
    {&D3plotCard::dt, real("dt", dimension::time, 0, at_least(0), "time between two states")},
    {&D3plotCard::lcdt, id("lcdt", IdSpace::function, 0, "curve of the interval over time")},
    integer("beam", 0, between(0, 2), "how discrete elements are shown"),
    {&D3plotCard::npltc,
     integer("npltc", 0, at_least(0), "number of states at equal intervals up to the end time, instead of dt")},
    id("psetid", IdSpace::set, 0, "part set of d3part"),
};

struct D3plotCard2 {
  int ioopt = 0;
  double rate = 0, cutoff = 0, window = 0;
};
const CardOf<D3plotCard2> d3plot_card2{
    {&D3plotCard2::ioopt, integer("ioopt", 0, between(0, 3), "as of the ASCII files")},
    {&D3plotCard2::rate, real("rate", dimension::number, 0, any_value, "filter rate")},
    {&D3plotCard2::cutoff, real("cutoff", dimension::rate, 0, any_value, "filter frequency")},
    {&D3plotCard2::window, real("window", dimension::number, 0, any_value, "width of the filter window")},
    integer("type", 0, any_value, "what is filtered"),
    integer("pset", 0, any_value, "part set of what is filtered"),
};

struct FormatCard {
  int iform = 0;
};
const CardOf<FormatCard> format_card{
    {&FormatCard::iform, integer("iform", 0, any_value, "0 LS-DYNA's format")},
    integer("ibinary", 0, between(0, 1), "word size; this program writes 32-bit words in either case"),
};

struct ExtentCard1 {
  int neiph = 0, neips = 0, maxint = 0, strflg = 0, sigflg = 0, epsflg = 0, rltflg = 0, engflg = 0;
};
const CardOf<ExtentCard1> extent_card1{
    {&ExtentCard1::neiph, integer("neiph", 0, between(0, 1000), "extra history variables of solids")},
    {&ExtentCard1::neips, integer("neips", 0, between(0, 1000), "extra history variables of shells")},
    {&ExtentCard1::maxint,
     integer("maxint", 3, between(-1000, 1000),
             "3: middle, bottom and top of a shell; another number: so many layers from the bottom")},
    {&ExtentCard1::strflg,
     integer("strflg", 0, between(0, 111), "last digit 1: strains are written; the other digits: not built")},
    {&ExtentCard1::sigflg, integer("sigflg", 1, any_value, "1: stresses of shells are written")},
    {&ExtentCard1::epsflg, integer("epsflg", 1, any_value, "1: plastic strains of shells are written")},
    {&ExtentCard1::rltflg, integer("rltflg", 1, any_value, "1: resultants of shells are written")},
    {&ExtentCard1::engflg, integer("engflg", 1, any_value, "1: thickness and energy of shells are written")},
};
struct ExtentCard2 {
  int cmpflg = 0, ieverp = 0, beamip = 0, dcomp = 0, shge = 0, stssz = 0;
};
const CardOf<ExtentCard2> extent_card2{
    {&ExtentCard2::cmpflg,
     integer("cmpflg", 0, between(-1, 1),
             "1, -1: stresses and strains where a material has axes of its own in these; 0: in global axes")},
    {&ExtentCard2::ieverp, integer("ieverp", 0, between(0, 1), "1: one state a file")},
    {&ExtentCard2::beamip, integer("beamip", 0, at_least(0), "integration points of a beam that are written")},
    {&ExtentCard2::dcomp, integer("dcomp", 1, any_value, "1: no compression")},
    {&ExtentCard2::shge, integer("shge", 1, any_value, "2: hourglass energy of shells")},
    {&ExtentCard2::stssz, integer("stssz", 1, any_value, "2: time step, 3: added mass of shells")},
    integer("n3thdt", 2, any_value, "material energies in d3thdt"),
    integer("ialemat", 1, any_value, "ALE materials"),
};
struct ExtentCard3 {
  int nintsld = 0, pkp_sen = 0, hydro = 0, msscl = 0, therm = 0;
  std::string intout, nodout;
};
const CardOf<ExtentCard3> extent_card3{
    {&ExtentCard3::nintsld, integer("nintsld", 0, any_value, "integration points of a solid that are written")},
    {&ExtentCard3::pkp_sen, integer("pkp_sen", 0, any_value, "peak pressure of segments")},
    real("sclp", dimension::number, 1, any_value, "scale of that pressure"),
    {&ExtentCard3::hydro, integer("hydro", 0, any_value, "extra variables of solids")},
    {&ExtentCard3::msscl, integer("msscl", 0, any_value, "nodal mass scaling")},
    {&ExtentCard3::therm, integer("therm", 0, any_value, "thermal data")},
    {&ExtentCard3::intout, text("intout", 10, "stresses in eloutdet")},
    {&ExtentCard3::nodout, text("nodout", 10, "extrapolated stresses in eloutdet")},
};
struct ExtentCard4 {
  int dtdt = 0, resplt = 0, neipb = 0, quadsld = 0, deleres = 0;
};
const CardOf<ExtentCard4> extent_card4{
    {&ExtentCard4::dtdt, integer("dtdt", 0, any_value, "temperature rates")},
    {&ExtentCard4::resplt, integer("resplt", 0, any_value, "residual forces")},
    {&ExtentCard4::neipb, integer("neipb", 0, any_value, "extra history variables of beams")},
    {&ExtentCard4::quadsld, integer("quadsld", 0, any_value, "quadratic solids")},
    integer("cubsld", 0, any_value, "cubic solids"),
    {&ExtentCard4::deleres, integer("deleres", 0, any_value, "results of deleted elements")},
};

/// Eight ids, or one with a name.
struct IdsCard {
  std::array<int, 8> id{};
  std::string heading;
};
CardOf<IdsCard> eight(IdSpace space, std::string_view meaning) {
  constexpr std::array<std::string_view, 8> names{"id1", "id2", "id3", "id4", "id5", "id6", "id7", "id8"};
  CardOf<IdsCard> card;
  for (std::size_t i = 0; i < names.size(); ++i) card.add({at(&IdsCard::id, i), id(names[i], space, 0, meaning)});
  return card;
}
CardOf<IdsCard> headed_history(IdSpace space, std::string_view meaning) {
  return {{at(&IdsCard::id, 0), id("id", space, 0, meaning)}, {&IdsCard::heading, text("heading", 70, "its name")}};
}

const CardOf<IdsCard> history_node_ids =
    eight(IdSpace::node, "node with a time history; 8 a line, any number of lines");
const CardOf<IdsCard> history_element_ids =
    eight(IdSpace::element, "element with a time history; 8 a line, any number of lines");
const CardOf<IdsCard> history_set_ids =
    eight(IdSpace::set, "set whose members have time histories; 8 a line, any number of lines");
struct LocalNodeCard {
  int id = 0, cid = 0, ref = 0;
};
const CardOf<LocalNodeCard> local_node_card{
    {&LocalNodeCard::id, id("id", IdSpace::node, 0, "node with a time history in local axes")},
    {&LocalNodeCard::cid, id("cid", IdSpace::define, 0, "coordinate system; 0: global axes")},
    {&LocalNodeCard::ref,
     integer("ref", 0, between(0, 2),
             "0: its axes at time 0; 1: as they turn with their nodes; 2: likewise, and relative to their origin")},
    integer("hfo", 0, only(0), "high frequency output: not built"),
};
struct LocalHeadingCard {
  std::string heading;
};
const CardOf<LocalHeadingCard> local_heading_card{{&LocalHeadingCard::heading, text("heading", 80, "its name")}};
const CardOf<IdsCard> node_id_heading = headed_history(IdSpace::node, "node with a time history; one a line");
const CardOf<IdsCard> element_id_heading = headed_history(IdSpace::element, "element with a time history; one a line");
const CardOf<IdsCard> set_id_heading =
    headed_history(IdSpace::set, "set whose members have time histories; one a line");

// ---- intervals

/// Where the request of one file stands.
using RequestOf = Request& (*)(Requests&);
template <model::HistoryName file>
Request& of_history(Requests& requests) {
  return requests[file];
}
Request& of_d3plot(Requests& requests) {
  return requests.d3plot;
}

/// The curve of an interval, and how it counts.
void take_sampling_curve(Builder& builder, const deck::Entry& field, int ioopt, RequestOf file) {
  if (field.integer() == 0) return;
  builder.defer(Phase::conditions, [field, ioopt, file](Builder& b) {
    Request& asked = file(b.model.requests);
    asked.curve = b.curve(field);
    if (asked.curve == none) return;
    using enum Request::Rule;
    asked.rule = ioopt == 2 ? to_next : ioopt == 3 ? at_points : from_last;
    const Curve& curve = b.model.curves[asked.curve];
    if (asked.rule != at_points && *std::min_element(curve.y.begin(), curve.y.end()) <= 0.0)
      return refuse(b, field, "an interval of 0 or below is none",
                    "give a curve above 0, or IOOPT 3, which takes the curve's abscissas");
    asked.interval = asked.rule == at_points ? 1.0 : curve.y.front();  // of a curve: asked for, and no more
  });
}

void take_request(Builder& builder, const Block& block, RequestOf file) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(interval_card);
  Request& request = file(builder.model.requests);
  request.interval = row->dt;
  request.binary = row->binary;
  take_sampling_curve(builder, row[&IntervalCard::lcur], row->ioopt, file);
  request.resultant_force = file == of_history<model::HistoryName("swforc")> && row->option[0] == 1.0;
  for (std::size_t i = request.resultant_force ? 1 : 0; i < row->option.size(); ++i)
    expect(builder, Severity::warning,
           {{row[at(&IntervalCard::option, i)], 0, "this additional output is not written"}});
}

/// ncforc has the sides of contacts that ask for it on their own cards.
void report_sides_of_ncforc(Builder& builder, const Block& block) {
  bool any = false;
  for (const Contact& contact : builder.model.contacts) {
    if (!contact.prints_a && !contact.prints_b) continue;
    const auto lacks = [&](const char* what, const char* remedy) {
      builder.findings.warning(contact.place, '*' + contact.keyword,
                               fmt::format("ncforc lacks contact {}: {}", contact.id, what), remedy);
    };
    if (contact.tie())
      lacks("ties have no forces by node there", "rcforc has the sums of ties by springs, swforc the forces of welds");
    else if (contact.kind == Contact::Kind::transducer && !contact.b.empty())
      lacks("forces of a transducer between two sides are not resolved by node",
            "leave SURFB blank; rcforc has the force between the two");
    else
      any = true;
  }
  if (!any)
    builder.findings.warning(block.place, '*' + block.keyword,
                             "no contact asks for its forces by node: there is no ncforc",
                             "write 1 for SAPR, SBPR (SPR, MPR) on the first card of the contacts that are meant");
}

template <model::HistoryName file>
void read_request(Builder& builder, const Block& block, const Options&) {
  take_request(builder, block, of_history<file>);
  if constexpr (file.text() == "ncforc")
    builder.defer(Phase::checks, [block](Builder& b) { report_sides_of_ncforc(b, block); });
}

void read_d3plot(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(d3plot_card);
  builder.model.requests.d3plot.interval = row->dt;
  int ioopt = 1;
  if (cursor.more()) {
    constexpr std::string_view plain = "states are written unfiltered";
    const auto second = cursor.read(d3plot_card2);
    expect(builder, Severity::warning,
           {{second[&D3plotCard2::rate], 0, plain},
            {second[&D3plotCard2::cutoff], 0, plain},
            {second[&D3plotCard2::window], 0, plain}});
    ioopt = second->ioopt;
  }
  if (row->npltc == 0) take_sampling_curve(builder, row[&D3plotCard::lcdt], ioopt, of_d3plot);
  if (const int states = row->npltc; states > 0)
    builder.defer(Phase::conditions,
                  [states](Builder& b) { b.model.requests.d3plot.interval = b.model.control.end_time / states; });
}

void read_format(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const auto row = cursor.read(format_card);
  expect(builder, Severity::warning, {{row[&FormatCard::iform], 0, "results are written in LS-DYNA's format only"}});
}

void read_extent_binary(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  Requests& requests = builder.model.requests;
  const auto others = [&](std::initializer_list<Supported> fields) { expect(builder, Severity::warning, fields); };
  constexpr std::string_view absent = "not written yet; d3plot comes without it",
                             present = "cannot be left out; d3plot has it";

  const auto row1 = cursor.read(extent_card1);
  requests.layers = std::abs(row1->maxint);
  if (row1->maxint < 0)
    row1[&ExtentCard1::maxint].report(
        builder.findings, Severity::warning,
        "the mean over a shell's in-plane points is written, as many layers as with the positive number");
  requests.strains = row1->strflg % 10 == 1;
  if (row1->strflg > 1)
    row1[&ExtentCard1::strflg].report(
        builder.findings, Severity::warning,
        "plastic and thermal strain tensors are not written: only its last digit, 0 or 1, is obeyed");
  requests.solid_histories = row1->neiph;
  requests.shell_histories = row1->neips;
  for (const auto field : {&ExtentCard1::neiph, &ExtentCard1::neips})
    if ((*row1).*field > 3)
      row1[field].report(builder.findings, Severity::note,
                         "1 is the lost share of the stress, 2 and 3 are damage and instability; zeros follow");
  others({{row1[&ExtentCard1::sigflg], 1, present},
          {row1[&ExtentCard1::epsflg], 1, present},
          {row1[&ExtentCard1::rltflg], 1, present},
          {row1[&ExtentCard1::engflg], 1, present}});

  if (!cursor.more()) return;
  const auto row2 = cursor.read(extent_card2);
  requests.one_state_a_file = row2->ieverp == 1;
  requests.beam_points = row2->beamip;
  if (requests.beam_points > 0)
    row2[&ExtentCard2::beamip].report(builder.findings, Severity::note,
                                      "the axial strain of a beam's points is not known; d3plot has 0 in its place");
  requests.material_axes = row2->cmpflg != 0;
  others(
      {{row2[&ExtentCard2::dcomp], 1, "d3plot is written without compression, velocities and accelerations included"},
       {row2[&ExtentCard2::shge], 1, absent},
       {row2[&ExtentCard2::stssz], 1, absent}});

  if (!cursor.more()) return;
  const auto row3 = cursor.read(extent_card3);
  if (row3->nintsld > 1)
    row3[&ExtentCard3::nintsld].report(builder.findings, Severity::warning,
                                       "solids have one integration point; one is written");
  others({{row3[&ExtentCard3::pkp_sen], 0, absent},
          {row3[&ExtentCard3::hydro], 0, absent},
          {row3[&ExtentCard3::msscl], 0, absent},
          {row3[&ExtentCard3::therm], 0, absent}});
  for (const auto field : {&ExtentCard3::intout, &ExtentCard3::nodout})
    if (!((*row3).*field).empty())
      row3[field].report(builder.findings, Severity::warning, "eloutdet is not written; elout has the elements' means");

  if (!cursor.more()) return;
  const auto row4 = cursor.read(extent_card4);
  others({{row4[&ExtentCard4::dtdt], 0, absent},
          {row4[&ExtentCard4::resplt], 0, absent},
          {row4[&ExtentCard4::neipb], 0, absent},
          {row4[&ExtentCard4::quadsld], 0, "d3plot has the corners of quadratic solids only"},
          {row4[&ExtentCard4::deleres], 0, "deleted elements have no stress in d3plot, as with 0"}});
}

// ---- time histories

/// What *DATABASE_HISTORY_ of one kind needs: where single ids and sets are looked up, and where the result goes.
struct History {
  std::string_view what;
  Ids Builder::*ids;
  Ids Builder::*set_ids;
  std::vector<Set<Index>> Sets::*sets;
  std::vector<NamedEntity> Requests::*list;
};
constexpr History node_history{"node", &Builder::nodes, &Builder::node_sets, &Sets::nodes, &Requests::history_nodes};
constexpr History shell_history{"shell", &Builder::shells, &Builder::shell_sets, &Sets::shells,
                                &Requests::history_shells};
constexpr History solid_history{"solid", &Builder::solids, &Builder::solid_sets, &Sets::solids,
                                &Requests::history_solids};
constexpr History thick_shell_history{"thick shell", &Builder::solids, &Builder::solid_sets, &Sets::solids,
                                      &Requests::history_thick_shells};
constexpr History beam_history{"beam", &Builder::beams, &Builder::beam_sets, &Sets::beams, &Requests::history_beams};

void add_history(Builder& builder, std::vector<NamedEntity>& list, Index index, const std::string& heading) {
  if (builder.in_history[&list].insert(index).second) list.push_back({index, heading});
}

void resolve_history(Builder& builder, const History& history, const deck::Entry& field, bool set,
                     const std::string& heading) {
  const int id = field.integer();
  if (id == 0) return;
  auto& list = builder.model.requests.*history.list;
  Index index = set ? (builder.*history.set_ids).find(id) : (builder.*history.ids).find(id);
  // Bricks and thick shells share their ids.
  if (!set && index != none && history.ids == &Builder::solids) {
    const bool thick = at(index) < builder.thick_solids.size() && builder.thick_solids[index] != 0;
    if (thick != (&history == &thick_shell_history)) index = none;
  }
  if (index == none) {
    field.report(builder.findings, Severity::warning,
                 std::string(history.what) + (set ? " set" : "") + " is not in the model; it has no time history");
  } else if (set) {
    for (const Index member : (builder.model.sets.*history.sets)[index].members)
      add_history(builder, list, member, heading);
  } else {
    add_history(builder, list, index, heading);
  }
}

template <const History& history, bool set>
void read_history(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  const bool nodes = &history == &node_history;
  const bool headings = options.contains("ID");
  const CardOf<IdsCard>& plain = set ? history_set_ids : nodes ? history_node_ids : history_element_ids;
  const CardOf<IdsCard>& headed_history = set ? set_id_heading : nodes ? node_id_heading : element_id_heading;
  while (cursor.more()) {
    const auto row = cursor.read(headings ? headed_history : plain);
    builder.defer(Phase::conditions, [row, headings](Builder& b) {
      const std::size_t count = headings ? 1 : row->id.size();
      for (std::size_t i = 0; i < count; ++i) resolve_history(b, history, row[at(&IdsCard::id, i)], set, row->heading);
    });
  }
}

/// *DATABASE_HISTORY_DISCRETE: deforc has the springs and dampers that are listed, and no others.
void read_discrete_history(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  const bool headings = options.contains("ID");
  builder.defer(Phase::bodies, [](Builder& b) {
    for (Discrete& d : b.model.discretes) d.in_deforc = false;
  });
  while (cursor.more()) {
    const auto row = cursor.read(headings ? element_id_heading : history_element_ids);
    builder.defer(Phase::conditions, [row, headings](Builder& b) {
      const std::size_t count = headings ? 1 : row->id.size();
      for (std::size_t i = 0; i < count; ++i) {
        const int id = row->id[i];
        const Index index = b.discretes.find(id);
        if (index != none)
          b.model.discretes[index].in_deforc = true;
        else if (id != 0)
          row[at(&IdsCard::id, i)].report(b.findings, Severity::warning,
                                          "spring is not in the model; it has no time history");
      }
    });
  }
}

/// *DATABASE_HISTORY_NODE_LOCAL.
void read_local_history(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (cursor.more()) {
    const auto row = cursor.read(local_node_card);
    const std::string heading = options.contains("ID") ? cursor.read(local_heading_card)->heading : std::string{};
    builder.defer(Phase::conditions, [row, heading](Builder& b) {
      auto& list = b.model.requests.history_nodes;
      const Index node = b.nodes.find(row->id);
      if (node == none)
        return row[&LocalNodeCard::id].report(b.findings, Severity::warning,
                                              "node is not in the model; it has no time history");
      if (row->cid == 0) return add_history(b, list, node, heading);
      const bool turning = row->ref != 0, relative = row->ref == 2;
      const Index system = b.turning_or_fixed_system(row[&LocalNodeCard::cid]);
      if (system == none) return;
      // With REF 1 and 2 the axes turn whatever FLAG says.
      const CoordinateSystem& axes = b.model.systems[system];
      if (turning && !axes.nodes)
        return refuse(b, row[&LocalNodeCard::ref], "axes that turn (REF 1 and 2) need the nodes that they turn with",
                      "define the system by *DEFINE_COORDINATE_NODES, or write 0");
      if (!turning && axes.turning)
        return refuse(b, row[&LocalNodeCard::ref], "fixed axes (REF 0) need a system of fixed axes",
                      "write 1, or FLAG 0 in the system");
      list.push_back({node, heading, system, turning, relative});
      if (!relative) return;
      b.defer(Phase::checks, [row](Builder& later) {
        if (later.model.control.relaxation.on())
          refuse(later, row[&LocalNodeCard::ref],
                 "relative motion (REF 2) after a dynamic relaxation is not built: its places of "
                 "reference would be those at the end of it",
                 "write 1");
      });
    });
  }
}

// ---- the list

/// *DATABASE_ABSTAT of abstat.
template <model::HistoryName file>
Keyword file_keyword() {
  static const std::string name = [] {
    std::string written = "DATABASE_";
    std::ranges::transform(file.text(), std::back_inserter(written),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return written;
  }();
  return {.name = name, .layout = {{{}, &interval_card}}, .read = read_request<file>};
}

/// One of each history file.
template <std::size_t... file>
std::vector<Keyword> file_keywords(std::index_sequence<file...>) {
  return {file_keyword<model::HistoryName(file)>()...};
}

template <const History& history, bool set>
Keyword history_keyword(std::string_view name, const Card& plain, const Card& headed_history) {
  return {.name = name,
          .options = {"ID"},
          .layout = {{"without _ID", &plain}, {"with _ID", &headed_history}},
          .read = read_history<history, set>};
}

Keyword request_without_effect(std::string_view name, std::string_view why) {
  return {.name = name, .options = {"FILE"}, .status = KeywordStatus::ignored, .why = why};
}

}  // namespace

std::vector<Keyword> database_keywords() {
  std::vector<Keyword> rows = file_keywords(std::make_index_sequence<model::history_files.size()>());
  const std::vector<Keyword> others{
      {.name = "DATABASE_BINARY_D3PLOT",
       .layout = {{{}, &d3plot_card}, {"optional", &d3plot_card2}},
       .read = read_d3plot},
      {.name = "DATABASE_FORMAT", .layout = {{{}, &format_card}}, .read = read_format},
      {.name = "DATABASE_EXTENT_BINARY",
       .layout =
           {{{}, &extent_card1}, {"optional", &extent_card2}, {"optional", &extent_card3}, {"optional", &extent_card4}},
       .read = read_extent_binary},
      history_keyword<node_history, false>("DATABASE_HISTORY_NODE", history_node_ids, node_id_heading),
      history_keyword<node_history, true>("DATABASE_HISTORY_NODE_SET", history_set_ids, set_id_heading),
      {.name = "DATABASE_HISTORY_NODE_LOCAL",
       .options = {"ID"},
       .layout = {{"repeated", &local_node_card}, {"with _ID, after each", &local_heading_card}},
       .read = read_local_history},
      history_keyword<shell_history, false>("DATABASE_HISTORY_SHELL", history_element_ids, element_id_heading),
      history_keyword<shell_history, true>("DATABASE_HISTORY_SHELL_SET", history_set_ids, set_id_heading),
      history_keyword<solid_history, false>("DATABASE_HISTORY_SOLID", history_element_ids, element_id_heading),
      history_keyword<solid_history, true>("DATABASE_HISTORY_SOLID_SET", history_set_ids, set_id_heading),
      history_keyword<thick_shell_history, false>("DATABASE_HISTORY_TSHELL", history_element_ids, element_id_heading),
      history_keyword<beam_history, false>("DATABASE_HISTORY_BEAM", history_element_ids, element_id_heading),
      history_keyword<beam_history, true>("DATABASE_HISTORY_BEAM_SET", history_set_ids, set_id_heading),
      {.name = "DATABASE_HISTORY_DISCRETE",
       .options = {"ID"},
       .layout = {{"without _ID", &history_element_ids}, {"with _ID", &element_id_heading}},
       .read = read_discrete_history},

      request_without_effect("DATABASE_BINARY_RUNRSF",
                             "restart files are asked for on the command line (--checkpoint)"),
      request_without_effect("DATABASE_BINARY_D3DUMP",
                             "restart files are asked for on the command line (--checkpoint)"),
      request_without_effect("DATABASE_BINARY_INTFOR",
                             "the contact database (intfor) is not written; rcforc holds the forces of each contact"),
      request_without_effect("DATABASE_BINARY_D3THDT",
                             "d3thdt repeats the histories that nodout, elout and matsum hold"),
      request_without_effect("DATABASE_BINARY_D3DRLF",
                             "states of dynamic relaxation are not written; the run begins with its last one"),
  };
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

}  // namespace nugget::reading
