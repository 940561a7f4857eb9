// SPDX-License-Identifier: Apache-2.0
// *DATABASE_...: which results are written, how often, and of what.
#include <algorithm>
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
using deck::Row;

const Card interval_card{{
    real("dt", dimension::time, 0, at_least(0), "time between two records; 0 writes none"),
    integer("binary", 0, between(0, 3), "0, 1 ASCII file; 2 binout; 3 both"),
    id("lcur", IdSpace::function, 0, "curve of the interval over time, instead of dt"),
    integer("ioopt", 1, between(0, 3),
            "next output: 1 after the curve's value at this one, 2 where its own value is what has passed, 3 at each "
            "of the "
            "curve's abscissas"),
    real("option1", dimension::number, 0, any_value, "more output: a finer nodout, history variables in elout"),
    real("option2", dimension::number, 0, any_value, "the same"),
    real("option3", dimension::number, 0, any_value, "the same"),
    real("option4", dimension::number, 0, any_value, "the same"),
}};

const Card d3plot_card{{
    real("dt", dimension::time, 0, at_least(0), "time between two states"),
    id("lcdt", IdSpace::function, 0, "curve of the interval over time"),
    integer("beam", 0, between(0, 2), "how discrete elements are shown"),
    integer("npltc", 0, at_least(0), "number of states at equal intervals up to the end time, instead of dt"),
    id("psetid", IdSpace::set, 0, "part set of d3part"),
}};

const Card d3plot_card2{{
    integer("ioopt", 0, between(0, 3), "as of the ASCII files"),
    real("rate", dimension::number, 0, any_value, "filter rate"),
    real("cutoff", dimension::rate, 0, any_value, "filter frequency"),
    real("window", dimension::number, 0, any_value, "width of the filter window"),
    integer("type", 0, any_value, "what is filtered"),
    integer("pset", 0, any_value, "part set of what is filtered"),
}};

const Card format_card{{
    integer("iform", 0, any_value, "0 LS-DYNA's format"),
    integer("ibinary", 0, between(0, 1), "word size; this program writes 32-bit words in either case"),
}};

const Card extent_card1{{
    integer("neiph", 0, between(0, 1000), "extra history variables of solids"),
    integer("neips", 0, between(0, 1000), "extra history variables of shells"),
    integer("maxint", 3, any_value,
            "3: middle, bottom and top of a shell; another number: so many layers from the bottom"),
    integer("strflg", 0, between(0, 111), "last digit 1: strains are written; the other digits: not built"),
    integer("sigflg", 1, any_value, "1: stresses of shells are written"),
    integer("epsflg", 1, any_value, "1: plastic strains of shells are written"),
    integer("rltflg", 1, any_value, "1: resultants of shells are written"),
    integer("engflg", 1, any_value, "1: thickness and energy of shells are written"),
}};
const Card extent_card2{{
    integer("cmpflg", 0, between(-1, 1),
            "1, -1: stresses and strains where a material has axes of its own in these; 0: in global axes"),
    integer("ieverp", 0, between(0, 1), "1: one state a file"),
    integer("beamip", 0, at_least(0), "integration points of a beam that are written"),
    integer("dcomp", 1, any_value, "1: no compression"),
    integer("shge", 1, any_value, "2: hourglass energy of shells"),
    integer("stssz", 1, any_value, "2: time step, 3: added mass of shells"),
    integer("n3thdt", 2, any_value, "material energies in d3thdt"),
    integer("ialemat", 1, any_value, "ALE materials"),
}};
const Card extent_card3{{
    integer("nintsld", 0, any_value, "integration points of a solid that are written"),
    integer("pkp_sen", 0, any_value, "peak pressure of segments"),
    real("sclp", dimension::number, 1, any_value, "scale of that pressure"),
    integer("hydro", 0, any_value, "extra variables of solids"),
    integer("msscl", 0, any_value, "nodal mass scaling"),
    integer("therm", 0, any_value, "thermal data"),
    text("intout", 10, "stresses in eloutdet"),
    text("nodout", 10, "extrapolated stresses in eloutdet"),
}};
const Card extent_card4{{
    integer("dtdt", 0, any_value, "temperature rates"),
    integer("resplt", 0, any_value, "residual forces"),
    integer("neipb", 0, any_value, "extra history variables of beams"),
    integer("quadsld", 0, any_value, "quadratic solids"),
    integer("cubsld", 0, any_value, "cubic solids"),
    integer("deleres", 0, any_value, "results of deleted elements"),
}};

Card eight(IdSpace space, std::string_view meaning) {
  Card card;
  for (const std::string_view name : {"id1", "id2", "id3", "id4", "id5", "id6", "id7", "id8"})
    card.fields.push_back(id(name, space, 0, meaning));
  return card;
}
Card headed(IdSpace space, std::string_view meaning) {
  return {{id("id", space, 0, meaning), text("heading", 70, "its name")}};
}

const Card node_ids = eight(IdSpace::node, "node with a time history; 8 a line, any number of lines");
const Card element_ids = eight(IdSpace::element, "element with a time history; 8 a line, any number of lines");
const Card set_ids = eight(IdSpace::set, "set whose members have time histories; 8 a line, any number of lines");
const Card local_node_card{{
    id("id", IdSpace::node, 0, "node with a time history in local axes"),
    id("cid", IdSpace::define, 0, "coordinate system; 0: global axes"),
    integer("ref", 0, between(0, 2),
            "0: its axes at time 0; 1: as they turn with their nodes; 2: likewise, and relative to their origin"),
    integer("hfo", 0, only(0), "high frequency output: not built"),
}};
const Card local_heading_card{{text("heading", 80, "its name")}};
const Card node_id_heading = headed(IdSpace::node, "node with a time history; one a line");
const Card element_id_heading = headed(IdSpace::element, "element with a time history; one a line");
const Card set_id_heading = headed(IdSpace::set, "set whose members have time histories; one a line");

// ---- intervals -----------------------------------------------------------------------------------------------------

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
void take_curve(Builder& builder, const Row& row, std::string_view field, int ioopt, RequestOf file) {
  if (row.integer(field) == 0) return;
  builder.defer(Phase::conditions, [row, field = std::string(field), ioopt, file](Builder& b) {
    Request& asked = file(b.model.requests);
    asked.curve = b.curve(row, field);
    if (asked.curve == none) return;
    using enum Request::Rule;
    asked.rule = ioopt == 2 ? to_next : ioopt == 3 ? at_points : from_last;
    const Curve& curve = b.model.curves[static_cast<std::size_t>(asked.curve)];
    if (asked.rule != at_points && *std::min_element(curve.y.begin(), curve.y.end()) <= 0.0)
      return refuse(b, row, field, "an interval of 0 or below is none",
                    "give a curve above 0, or IOOPT 3, which takes the curve's abscissas");
    asked.interval = asked.rule == at_points ? 1.0 : curve.y.front();  // of a curve: asked for, and no more
  });
}

void take_request(Builder& builder, const Block& block, RequestOf file) {
  Cursor cursor(builder.deck, block, builder.findings);
  const Row row = cursor.read(interval_card);
  Request& request = file(builder.model.requests);
  request.interval = row.real("dt");
  request.binary = row.integer("binary");
  take_curve(builder, row, "lcur", row.integer("ioopt"), file);
  for (const std::string_view option : {"option1", "option2", "option3", "option4"})
    expect(builder, row, Severity::warning, {{option, 0, "this additional output is not written"}});
}

template <model::HistoryName file>
void read_request(Builder& builder, const Block& block, const Options&) {
  take_request(builder, block, of_history<file>);
}

void read_d3plot(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  const Row row = cursor.read(d3plot_card);
  builder.model.requests.d3plot.interval = row.real("dt");
  int ioopt = 1;
  if (cursor.more()) {
    constexpr std::string_view plain = "states are written unfiltered";
    const Row second = cursor.read(d3plot_card2);
    expect(builder, second, Severity::warning, {{"rate", 0, plain}, {"cutoff", 0, plain}, {"window", 0, plain}});
    ioopt = second.integer("ioopt");
  }
  if (row.integer("npltc") == 0) take_curve(builder, row, "lcdt", ioopt, of_d3plot);
  if (const int states = row.integer("npltc"); states > 0)
    builder.defer(Phase::conditions,
                  [states](Builder& b) { b.model.requests.d3plot.interval = b.model.control.end_time / states; });
}

void read_format(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  expect(builder, cursor.read(format_card), Severity::warning,
         {{"iform", 0, "results are written in LS-DYNA's format only"}});
}

void read_extent_binary(Builder& builder, const Block& block, const Options&) {
  Cursor cursor(builder.deck, block, builder.findings);
  Requests& requests = builder.model.requests;
  const auto others = [&](const Row& row, std::initializer_list<SupportedValue> fields) {
    expect(builder, row, Severity::warning, fields);
  };
  constexpr std::string_view absent = "not written yet; d3plot comes without it",
                             present = "cannot be left out; d3plot has it";

  const Row row1 = cursor.read(extent_card1);
  requests.layers = std::abs(row1.integer("maxint"));
  if (row1.integer("maxint") < 0)
    row1.report(builder.findings, Severity::warning, "maxint",
                "the mean over a shell's in-plane points is written, as many layers as with the positive number");
  requests.strains = row1.integer("strflg") % 10 == 1;
  if (row1.integer("strflg") > 1)
    row1.report(builder.findings, Severity::warning, "strflg",
                "plastic and thermal strain tensors are not written: only its last digit, 0 or 1, is obeyed");
  requests.solid_histories = row1.integer("neiph");
  requests.shell_histories = row1.integer("neips");
  for (const std::string_view field : {"neiph", "neips"})
    if (row1.integer(field) > 3)
      row1.report(builder.findings, Severity::note, field,
                  "1 is the lost share of the stress, 2 and 3 are damage and instability; zeros follow");
  others(row1, {{"sigflg", 1, present}, {"epsflg", 1, present}, {"rltflg", 1, present}, {"engflg", 1, present}});

  if (!cursor.more()) return;
  const Row row2 = cursor.read(extent_card2);
  requests.one_state_a_file = row2.integer("ieverp") == 1;
  requests.beam_points = row2.integer("beamip");
  if (requests.beam_points > 0)
    row2.report(builder.findings, Severity::note, "beamip",
                "the axial strain of a beam's points is not known; d3plot has 0 in its place");
  requests.material_axes = row2.integer("cmpflg") != 0;
  others(row2, {{"dcomp", 1, "d3plot is written without compression, velocities and accelerations included"},
                {"shge", 1, absent},
                {"stssz", 1, absent}});

  if (!cursor.more()) return;
  const Row row3 = cursor.read(extent_card3);
  if (row3.integer("nintsld") > 1)
    row3.report(builder.findings, Severity::warning, "nintsld", "solids have one integration point; one is written");
  others(row3, {{"pkp_sen", 0, absent}, {"hydro", 0, absent}, {"msscl", 0, absent}, {"therm", 0, absent}});
  for (const std::string_view field : {"intout", "nodout"})
    if (!row3.text(field).empty())
      row3.report(builder.findings, Severity::warning, field, "eloutdet is not written; elout has the elements' means");

  if (cursor.more())
    others(cursor.read(extent_card4), {{"dtdt", 0, absent},
                                       {"resplt", 0, absent},
                                       {"neipb", 0, absent},
                                       {"quadsld", 0, "d3plot has the corners of quadratic solids only"},
                                       {"deleres", 0, "deleted elements have no stress in d3plot, as with 0"}});
}

// ---- time histories ------------------------------------------------------------------------------------------------

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
constexpr History beam_history{"beam", &Builder::beams, &Builder::beam_sets, &Sets::beams, &Requests::history_beams};

void add_history(Builder& builder, std::vector<NamedEntity>& list, Index index, const std::string& heading) {
  if (builder.in_history[&list].insert(index).second) list.push_back({index, heading});
}

void resolve_history(Builder& builder, const History& history, const Row& row, std::string_view field, bool set,
                     const std::string& heading) {
  const int id = row.integer(field);
  if (id == 0) return;
  auto& list = builder.model.requests.*history.list;
  const Index index = set ? (builder.*history.set_ids).find(id) : (builder.*history.ids).find(id);
  if (index == none) {
    row.report(builder.findings, Severity::warning, field,
               std::string(history.what) + (set ? " set" : "") + " is not in the model; it has no time history");
  } else if (set) {
    for (const Index member : (builder.model.sets.*history.sets)[static_cast<std::size_t>(index)].members)
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
  const Card& plain = set ? set_ids : nodes ? node_ids : element_ids;
  const Card& headed = set ? set_id_heading : nodes ? node_id_heading : element_id_heading;
  while (cursor.more()) {
    const Row row = cursor.read(headings ? headed : plain);
    builder.defer(Phase::conditions, [row, headings](Builder& b) {
      if (headings) return resolve_history(b, history, row, "id", set, row.text("heading"));
      for (const std::string_view field : {"id1", "id2", "id3", "id4", "id5", "id6", "id7", "id8"})
        resolve_history(b, history, row, field, set, {});
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
    const Row row = cursor.read(headings ? element_id_heading : element_ids);
    builder.defer(Phase::conditions, [row, headings](Builder& b) {
      for (const std::string_view field : {"id1", "id2", "id3", "id4", "id5", "id6", "id7", "id8"}) {
        const std::string_view own = headings ? "id" : field;
        const int id = row.integer(own);
        const Index index = b.discretes.find(id);
        if (index != none)
          b.model.discretes[static_cast<std::size_t>(index)].in_deforc = true;
        else if (id != 0)
          row.report(b.findings, Severity::warning, own, "spring is not in the model; it has no time history");
        if (headings) return;
      }
    });
  }
}

/// *DATABASE_HISTORY_NODE_LOCAL.
void read_local_history(Builder& builder, const Block& block, const Options& options) {
  Cursor cursor(builder.deck, block, builder.findings);
  while (cursor.more()) {
    const Row row = cursor.read(local_node_card);
    const std::string heading =
        options.contains("ID") ? cursor.read(local_heading_card).text("heading") : std::string{};
    builder.defer(Phase::conditions, [row, heading](Builder& b) {
      auto& list = b.model.requests.history_nodes;
      const Index node = b.nodes.find(row.integer("id"));
      if (node == none)
        return row.report(b.findings, Severity::warning, "id", "node is not in the model; it has no time history");
      if (row.integer("cid") == 0) return add_history(b, list, node, heading);
      const bool turning = row.integer("ref") != 0, relative = row.integer("ref") == 2;
      const Index system = b.turning_or_fixed_system(row, "cid");
      if (system == none) return;
      // With REF 1 and 2 the axes turn whatever FLAG says.
      const CoordinateSystem& axes = b.model.systems[static_cast<std::size_t>(system)];
      if (turning && !axes.nodes)
        return refuse(b, row, "ref", "axes that turn (REF 1 and 2) need the nodes that they turn with",
                      "define the system by *DEFINE_COORDINATE_NODES, or write 0");
      if (!turning && axes.turning)
        return refuse(b, row, "ref", "fixed axes (REF 0) need a system of fixed axes",
                      "write 1, or FLAG 0 in the system");
      list.push_back({node, heading, system, turning, relative});
      if (!relative) return;
      b.defer(Phase::checks, [row](Builder& later) {
        if (later.model.control.relaxation.on())
          refuse(later, row, "ref",
                 "relative motion (REF 2) after a dynamic relaxation is not built: its places of "
                 "reference would be those at the end of it",
                 "write 1");
      });
    });
  }
}

// ---- the list ------------------------------------------------------------------------------------------------------

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
Keyword history_keyword(std::string_view name, const Card& plain, const Card& headed) {
  return {name,
          {},
          {"ID"},
          KeywordStatus::used,
          {},
          {{"without _ID", &plain}, {"with _ID", &headed}},
          read_history<history, set>};
}

Keyword not_written(std::string_view name, std::string_view why) {
  return {name, {}, {"ID"}, KeywordStatus::refused, why, {}, nullptr};
}
Keyword without_effect(std::string_view name, std::string_view why) {
  return {name, {}, {"FILE"}, KeywordStatus::ignored, why, {}, nullptr};
}

}  // namespace

std::vector<Keyword> database_keywords() {
  std::vector<Keyword> rows = file_keywords(std::make_index_sequence<model::history_files.size()>());
  const std::vector<Keyword> others{
      {"DATABASE_BINARY_D3PLOT",
       {},
       {},
       KeywordStatus::used,
       {},
       {{{}, &d3plot_card}, {"optional", &d3plot_card2}},
       read_d3plot},
      {"DATABASE_FORMAT", {}, {}, KeywordStatus::used, {}, {{{}, &format_card}}, read_format},
      {"DATABASE_EXTENT_BINARY",
       {},
       {},
       KeywordStatus::used,
       {},
       {{{}, &extent_card1}, {"optional", &extent_card2}, {"optional", &extent_card3}, {"optional", &extent_card4}},
       read_extent_binary},
      history_keyword<node_history, false>("DATABASE_HISTORY_NODE", node_ids, node_id_heading),
      history_keyword<node_history, true>("DATABASE_HISTORY_NODE_SET", set_ids, set_id_heading),
      {"DATABASE_HISTORY_NODE_LOCAL",
       {},
       {"ID"},
       KeywordStatus::used,
       {},
       {{"repeated", &local_node_card}, {"with _ID, after each", &local_heading_card}},
       read_local_history},
      history_keyword<shell_history, false>("DATABASE_HISTORY_SHELL", element_ids, element_id_heading),
      history_keyword<shell_history, true>("DATABASE_HISTORY_SHELL_SET", set_ids, set_id_heading),
      history_keyword<solid_history, false>("DATABASE_HISTORY_SOLID", element_ids, element_id_heading),
      history_keyword<solid_history, true>("DATABASE_HISTORY_SOLID_SET", set_ids, set_id_heading),
      history_keyword<beam_history, false>("DATABASE_HISTORY_BEAM", element_ids, element_id_heading),
      history_keyword<beam_history, true>("DATABASE_HISTORY_BEAM_SET", set_ids, set_id_heading),
      {"DATABASE_HISTORY_DISCRETE",
       {},
       {"ID"},
       KeywordStatus::used,
       {},
       {{"without _ID", &element_ids}, {"with _ID", &element_id_heading}},
       read_discrete_history},

      not_written("DATABASE_NCFORC", "contact forces by node (ncforc) are not written yet; rcforc holds their sums"),
      not_written("DATABASE_DISBOUT",
                  "discrete beams (disbout) are not written; swforc has the forces of those that join sheets"),
      not_written("DATABASE_SBTOUT", "seat belts (sbtout) are not written; there are none"),

      without_effect("DATABASE_BINARY_RUNRSF", "restart files are asked for on the command line (--checkpoint)"),
      without_effect("DATABASE_BINARY_D3DUMP", "restart files are asked for on the command line (--checkpoint)"),
      without_effect("DATABASE_BINARY_INTFOR",
                     "the contact database (intfor) is not written; rcforc holds the forces of each contact"),
      without_effect("DATABASE_BINARY_D3THDT", "d3thdt repeats the histories that nodout, elout and matsum hold"),
      without_effect("DATABASE_BINARY_D3DRLF",
                     "states of dynamic relaxation are not written; the run begins with its last one"),
  };
  rows.insert(rows.end(), others.begin(), others.end());
  return rows;
}

}  // namespace nugget::reading
