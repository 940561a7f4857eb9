// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "deck/expression.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"

// *DEFINE_CURVE, *DEFINE_TABLE and their forms, *DEFINE_FUNCTION. Curves and tables share one name space.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;
using deck::RowOf;

/// Factors and offsets of abscissae and ordinates.
struct Rescaling {
  double sfa = 1, sfo = 1, offa = 0, offo = 0;
};
struct CurveCard : Rescaling {
  int lcid = 0, sidr = 0;
};
const CardOf<CurveCard> curve_card{
    {&CurveCard::lcid, id("lcid", IdSpace::function, required, "curve id")},
    {&CurveCard::sidr,
     integer("sidr", 0, between(0, 2), "loads follow the curve 0 in the run, 1 in dynamic relaxation, 2 in both")},
    {&CurveCard::sfa, real("sfa", dimension::number, 1, any_value, "factor on the abscissae")},
    {&CurveCard::sfo, real("sfo", dimension::number, 1, any_value, "factor on the ordinates")},
    {&CurveCard::offa, real("offa", dimension::number, 0, any_value, "offset of the abscissae, before the factor")},
    {&CurveCard::offo, real("offo", dimension::number, 0, any_value, "offset of the ordinates, before the factor")},
    integer("dattyp", 0, any_value, "kind of data, no effect"),
    integer("lcint", 0, any_value, "points of LS-DYNA's resampling; curves are evaluated as they are"),
};

const CardOf<CurveCard> function_curve_card{
    {&CurveCard::lcid, id("lcid", IdSpace::function, required, "curve id; a function of TIME follows, on any lines")},
    {&CurveCard::sidr,
     integer("sidr", 0, between(0, 2), "loads follow the curve 0 in the run, 1 in dynamic relaxation, 2 in both")},
    real("sfa", dimension::number, 1, only(1), "factor on the time: not built, write it into the function"),
    {&CurveCard::sfo, real("sfo", dimension::number, 1, any_value, "factor on the function")},
    real("offa", dimension::number, 0, only(0), "offset of the time: the same"),
    {&CurveCard::offo, real("offo", dimension::number, 0, any_value, "offset of the function, before the factor")},
    integer("dattyp", 0, any_value, "kind of data, no effect"),
};

struct PointCard {
  double a = 0, o = 0;
};
const CardOf<PointCard> point_card{
    {&PointCard::a, wide(real("a", dimension::number, 0, any_value, "abscissa"), 20)},
    {&PointCard::o, wide(real("o", dimension::number, 0, any_value, "ordinate"), 20)},
};

struct SmoothCard {
  int lcid = 0, sidr = 0;
  double dist = 0, tstart = 0, tend = 0, trise = 0, vmax = 0;
};
const CardOf<SmoothCard> smooth_card{
    {&SmoothCard::lcid, id("lcid", IdSpace::function, required, "curve id")},
    {&SmoothCard::sidr,
     integer("sidr", 0, between(0, 2), "loads follow the curve 0 in the run, 1 in dynamic relaxation, 2 in both")},
    {&SmoothCard::dist,
     real("dist", dimension::number, required, any_value, "distance to go: the area under the curve")},
    {&SmoothCard::tstart, real("tstart", dimension::number, 0, at_least(0), "time at which it rises")},
    {&SmoothCard::tend, real("tend", dimension::number, 0, at_least(0), "time at which it is back at 0; 0: by VMAX")},
    {&SmoothCard::trise, real("trise", dimension::number, required, above_zero(), "time of the rise, and of the fall")},
    {&SmoothCard::vmax, real("vmax", dimension::number, 0, any_value, "velocity in between; used where TEND is 0")},
};

struct CopyCard : Rescaling {
  int lcid = 0, rlcid = 0;
};
const CardOf<CopyCard> copy_card{
    {&CopyCard::lcid, id("lcid", IdSpace::function, required, "curve id")},
    {&CopyCard::rlcid, id("rlcid", IdSpace::function, required, "curve to be copied")},
    {&CopyCard::sfa, real("sfa", dimension::number, 1, any_value, "factor on the abscissae")},
    {&CopyCard::sfo, real("sfo", dimension::number, 1, any_value, "factor on the ordinates")},
    {&CopyCard::offa, real("offa", dimension::number, 0, any_value, "offset of the abscissae, before the factor")},
    {&CopyCard::offo, real("offo", dimension::number, 0, any_value, "offset of the ordinates, before the factor")},
};

struct FunctionCard {
  int fid = 0;
  std::string heading;
};
const CardOf<FunctionCard> function_card{
    {&FunctionCard::fid, id("fid", IdSpace::function, required, "function id")},
    {&FunctionCard::heading, text("heading", 70, "what it is; its text follows, on as many lines as it takes")},
};

struct TableCard {
  int tbid = 0;
  double sfa = 0, offa = 0;
};
const CardOf<TableCard> table_card{
    {&TableCard::tbid, id("tbid", IdSpace::function, required, "table id")},
    {&TableCard::sfa, real("sfa", dimension::number, 1, any_value, "factor on the values")},
    {&TableCard::offa, real("offa", dimension::number, 0, any_value, "offset of the values, before the factor")},
};

struct ValueCard {
  double value = 0;
};
const CardOf<ValueCard> value_card{
    {&ValueCard::value, wide(real("value", dimension::number, 0, any_value, "value; its curve follows the table"), 20)},
};

struct Value2dCard {
  double value = 0;
  int curveid = 0;
};
const CardOf<Value2dCard> value_2d_card{
    {&Value2dCard::value, wide(real("value", dimension::number, 0, any_value, "value"), 20)},
    {&Value2dCard::curveid, wide(id("curveid", IdSpace::function, required, "its curve"), 20)},
};

/// A unit factor would have to know what the numbers of a curve are; the curve itself does not say.
void refuse_unit_factors(Builder& b, const Block& block) {
  if (block.transform == nullptr || !block.transform->changes_units()) return;
  b.findings.error(block.place, block.starred(), "the unit factors of *INCLUDE_TRANSFORM cannot be applied to a curve",
                   "write the curve in the units of the main deck, outside this include");
}

/// Scales and offsets as *DEFINE_CURVE means them: factor (value + offset).
void rescale(Curve& curve, const Rescaling& by) {
  for (double& x : curve.x) x = by.sfa * (x + by.offa);
  for (double& y : curve.y) y = by.sfo * (y + by.offo);
  if (by.sfa < 0.0) {
    std::reverse(curve.x.begin(), curve.x.end());
    std::reverse(curve.y.begin(), curve.y.end());
  }
}

void add_curve(Builder& b, const Row& row, Curve curve) {
  const std::string keyword = row.keyword();
  if (curve.x.size() == 1)
    b.findings.warning(row.place(), keyword, fmt::format("curve {} has one point: it is constant", curve.id),
                       "give a second point, if it is to be so");
  if (curve.empty() && curve.id != 0)
    b.findings.error(row.place(), keyword, fmt::format("curve {} has no points", curve.id));
  const auto index = static_cast<Index>(b.model.curves.size());
  if (b.tables.find(curve.id) != none)
    b.findings.error(row.place(), keyword, fmt::format("{} is already the id of a table", curve.id),
                     "curves and tables share their ids; give one of them another id");
  b.curves.add(curve.id, index, row.place(), keyword, "curve", b.findings);
  b.model.curves.push_back(std::move(curve));
}

/// In which phases loads follow a curve, by SIDR.
void set_phases(Builder& b, Curve& curve, int sidr) {
  curve.in_run = sidr != 1;
  curve.in_relaxation = sidr != 0;
  if (curve.in_relaxation) b.model.control.relaxation.asked = true;
}

/// The points up to the end of the keyword. Each abscissa must be larger than the one before.
Curve read_points(Builder& b, Cursor& cursor, int id) {
  Curve curve;
  curve.id = id;
  bool is_reported = false;
  while (!at_end(cursor)) {
    const auto point = cursor.read(point_card);
    const double a = point->a;
    if (!curve.empty() && a <= curve.x.back() && !is_reported) {
      refuse(b, point[&PointCard::a], fmt::format("expected more than {:g}: abscissae must ascend", curve.x.back()),
             "sort the points; a step needs two abscissae a little apart");
      is_reported = true;
    }
    curve.x.push_back(a);
    curve.y.push_back(point->o);
  }
  return curve;
}

void read_curve(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(curve_card);
  refuse_unit_factors(b, block);
  Curve curve = read_points(b, cursor, row->lcid);
  set_phases(b, curve, row->sidr);
  rescale(curve, *row);
  add_curve(b, row, std::move(curve));
}

/// Velocity that rises and falls along half a wave of a cosine each, by chords whose area is that of the wave.
Curve smooth_curve(int id, double start, double end, double rise, double velocity) {
  constexpr int chords = 32;
  Curve curve;
  curve.id = id;
  const auto add = [&](double x, double y) {
    if (!curve.empty() && !(x > curve.x.back())) return;
    curve.x.push_back(x);
    curve.y.push_back(y);
  };
  const auto wave = [](int i) { return 0.5 * (1.0 - std::cos(std::numbers::pi * i / chords)); };
  add(0.0, 0.0);
  for (int i = 0; i <= chords; ++i) add(start + rise * i / chords, velocity * wave(i));
  for (int i = chords; i >= 0; --i) add(end - rise * i / chords, velocity * wave(i));
  return curve;
}

/// The text of a function, parameters replaced, and where each of its lines stands.
void read_function(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(function_card);
  refuse_unit_factors(b, block);
  std::string text;
  std::vector<std::pair<std::size_t, Place>> lines;  // where in the text a line begins
  while (cursor.more()) {
    lines.emplace_back(text.size(), cursor.place());
    std::vector<std::string> unknown;
    text += cursor.read_text(&unknown) + '\n';
  }
  Formula::Fault fault;
  UserFunction function{row->fid, row->heading, Formula::read(text, fault), row.place()};
  if (fault.any()) {
    Place place = row.place();
    for (const auto& [begin, where] : lines)
      if (begin <= fault.at) place = {where.file, where.line, static_cast<int>(fault.at - begin) + 1};
    const std::string_view rest = std::string_view(text).substr(std::min(fault.at, text.size()));
    b.findings.error(place, row.keyword(),
                     fmt::format("function {} at '{}': {}", row->fid, rest.substr(0, rest.find('\n')), fault.text),
                     "correct its text");
  }
  b.functions.add(row->fid, static_cast<Index>(b.model.functions.size()), row.place(), row.keyword(), "function",
                  b.findings);
  b.model.functions.push_back(std::move(function));
}

void read_smooth(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(smooth_card);
  expect_end(b, cursor);
  refuse_unit_factors(b, block);
  const double distance = row->dist, start = row->tstart, rise = row->trise;
  double end = row->tend, velocity = row->vmax;
  if (!(rise > 0.0)) return;  // refused by its range
  if (end == 0.0 && velocity == 0.0)
    return refuse(b, row[&SmoothCard::vmax], "neither TEND nor VMAX is given",
                  "give one of them; DIST gives the other");
  if (end == 0.0)
    end = start + distance / velocity + rise;
  else
    velocity = distance / (end - start - rise);
  if (const double given = row->vmax; given != 0.0 && std::abs(given - velocity) > 1e-3 * std::abs(given))
    row[&SmoothCard::vmax].report(b.findings, Severity::warning,
                                  fmt::format("not obeyed: DIST and TEND give {:.6g}", velocity),
                                  "leave one of TEND and VMAX 0");
  if (!(end - start >= 2.0 * rise) || !std::isfinite(velocity))
    return refuse(b, row[&SmoothCard::trise],
                  fmt::format("from TSTART to TEND, {:.6g}, there is no room for a rise and a fall", end - start),
                  "give a shorter TRISE, or a smaller VMAX");
  Curve curve = smooth_curve(row->lcid, start, end, rise, velocity);
  set_phases(b, curve, row->sidr);
  add_curve(b, row, std::move(curve));
}

/// The points of a function of time by which straight lines are within 1e-5 of its greatest value, where it is smooth;
/// a jump gets a ramp of a millionth of the time. `fault`: why there are none.
Curve points_of_function(const std::string& text, double end, std::string& fault) {
  constexpr int at_first = 256, halvings = 12;
  Curve curve;
  const auto value = [&](double time) {
    const deck::ExpressionResult result = deck::evaluate_function_of_time(text, time);
    if (!result.fault.empty() && fault.empty()) fault = fmt::format("at the time {:g}: {}", time, result.fault);
    return result.value;
  };
  const auto add = [&](double x, double y) {
    curve.x.push_back(x);
    curve.y.push_back(y);
  };
  add(0.0, value(0.0));
  double greatest = std::abs(curve.y.front());
  std::vector<std::array<double, 2>> rough;
  for (int i = 1; i <= at_first && fault.empty(); ++i) {
    const double x = end * i / at_first;
    rough.push_back({x, value(x)});
    greatest = std::max(greatest, std::abs(rough.back()[1]));
  }
  const std::function<void(double, double, int)> go_to = [&](double x, double y, int halvings_left) {
    const double from = curve.x.back(), middle = 0.5 * (from + x), of_middle = value(middle);
    const bool bent = std::abs(of_middle - 0.5 * (curve.y.back() + y)) > 1e-5 * greatest;
    if (!fault.empty()) return;
    if (bent && halvings_left > 0) {
      go_to(middle, of_middle, halvings_left - 1);
      go_to(x, y, halvings_left - 1);
    } else {
      if (bent) add(middle, of_middle);
      add(x, y);
    }
  };
  for (const auto& [x, y] : rough) go_to(x, y, halvings);
  return curve;
}

/// A function of TIME by its points, up to the end of the run, which the deck may give later.
void read_curve_function(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(function_curve_card);
  refuse_unit_factors(b, block);
  const Place place = cursor.place();
  std::string text;
  while (cursor.more()) text += cursor.read_text();
  const auto index = b.model.curves.size();
  Curve curve{row->lcid, {0.0}, {0.0}};
  set_phases(b, curve, row->sidr);
  add_curve(b, row, std::move(curve));
  b.model.curves[index].x.clear();  // known when the end of the run is
  b.model.curves[index].y.clear();
  b.defer(Phase::curves, [=, keyword = row.keyword(), factors = Rescaling(*row)](Builder& later) {
    const double end = later.model.control.end_time;
    std::string fault;
    Curve points = points_of_function(text, end > 0.0 ? 1.001 * end : 1.0, fault);
    if (!fault.empty()) {
      later.findings.error(place, keyword, fmt::format("curve {}, '{}', {}", row->lcid, text, fault),
                           "write a function of TIME, as in Fortran, or its points as *DEFINE_CURVE");
      points = {0, {0.0}, {0.0}};
    }
    Curve& made = later.model.curves[index];
    made.x = std::move(points.x);
    made.y = std::move(points.y);
    rescale(made, factors);
  });
}

void read_copy(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(copy_card);
  expect_end(b, cursor);
  b.defer(Phase::curves, [row](Builder& later) {
    const Index original = later.curve(row[&CopyCard::rlcid]);
    if (original == none) return;
    Curve curve = later.model.curves[original];
    if (curve.empty())
      return refuse(later, row[&CopyCard::rlcid], "the curve is a *DEFINE_CURVE_FUNCTION that stands behind its copy",
                    "let the copy stand behind it");
    curve.id = row->lcid;
    rescale(curve, *row);
    add_curve(later, row, std::move(curve));
  });
}

/// Adds a table under its id, its values checked and scaled.
Index add_table(Builder& b, const RowOf<TableCard>& row, std::vector<double> values) {
  Table table;
  table.id = row->tbid;
  for (double& v : values) v = row->sfa * (v + row->offa);
  if (values.empty() || !std::is_sorted(values.begin(), values.end(), std::less_equal<>{}))
    b.findings.error(row.place(), row.keyword(), fmt::format("the values of table {} must ascend", table.id),
                     "sort the values, and their curves with them");
  table.value = std::move(values);
  const auto index = static_cast<Index>(b.model.tables.size());
  if (b.curves.find(table.id) != none)
    b.findings.error(row.place(), row.keyword(), fmt::format("{} is already the id of a curve", table.id),
                     "curves and tables share their ids; give one of them another id");
  b.tables.add(table.id, index, row.place(), row.keyword(), "table", b.findings);
  b.model.tables.push_back(std::move(table));
  return index;
}

/// *DEFINE_TABLE: one *DEFINE_CURVE a value follows, in the same order.
void read_table(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(table_card);
  refuse_unit_factors(b, block);
  std::vector<double> values;
  while (!at_end(cursor)) values.push_back(cursor.read(value_card)->value);
  const std::size_t count = values.size();
  const Index table = add_table(b, row, std::move(values));
  const std::size_t first = b.model.curves.size();
  b.defer(Phase::curves, [=](Builder& later) {
    auto& curves = later.model.tables[table].curve;
    for (std::size_t i = first; i < std::min(first + count, later.model.curves.size()); ++i)
      curves.push_back(static_cast<Index>(i));
    if (curves.size() == count) return;
    later.findings.error(row.place(), row.keyword(),
                         fmt::format("{} values, but {} curves follow", count, curves.size()),
                         "let one *DEFINE_CURVE follow for each value, or use *DEFINE_TABLE_2D");
  });
}

void read_table_2d(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  read_title(cursor, options);
  const auto row = cursor.read(table_card);
  refuse_unit_factors(b, block);
  std::vector<double> values;
  std::vector<deck::Entry> curves;
  while (!at_end(cursor)) {
    const auto line = cursor.read(value_2d_card);
    values.push_back(line->value);
    curves.push_back(line[&Value2dCard::curveid]);
  }
  const Index table = add_table(b, row, std::move(values));
  b.defer(Phase::curves, [table, curves](Builder& later) {
    for (const deck::Entry& id : curves)
      if (const Index curve = later.curve(id); curve != none) later.model.tables[table].curve.push_back(curve);
  });
}

}  // namespace

std::vector<Keyword> curve_keywords() {
  return {
      {.name = "DEFINE_CURVE",
       .options = {"TITLE"},
       .layout = {{"", &curve_card}, {"repeated", &point_card}},
       .read = read_curve},
      {.name = "DEFINE_CURVE_DUPLICATE", .options = {"TITLE"}, .layout = {{"", &copy_card}}, .read = read_copy},
      {.name = "DEFINE_CURVE_FUNCTION",
       .options = {"TITLE"},
       .layout = {{"", &function_curve_card}},
       .read = read_curve_function},
      {.name = "DEFINE_CURVE_SMOOTH", .options = {"TITLE"}, .layout = {{"", &smooth_card}}, .read = read_smooth},
      {.name = "DEFINE_FUNCTION", .options = {"TITLE"}, .layout = {{"", &function_card}}, .read = read_function},
      {.name = "DEFINE_FUNCTION_TABULATED",
       .status = KeywordStatus::refused,
       .why = "tabulated functions are not built; give a curve or a *DEFINE_FUNCTION"},
      {.name = "DEFINE_TABLE",
       .options = {"TITLE"},
       .layout = {{"", &table_card}, {"repeated", &value_card}},
       .read = read_table},
      {.name = "DEFINE_TABLE_2D",
       .options = {"TITLE"},
       .layout = {{"", &table_card}, {"repeated", &value_2d_card}},
       .read = read_table_2d},
  };
}

}  // namespace nugget::reading
