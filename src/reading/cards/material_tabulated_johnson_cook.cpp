// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/added_law.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_TABULATED_JOHNSON_COOK.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

/// All cards of *MAT_TABULATED_JOHNSON_COOK.
struct TabulatedCards : MaterialCard {
  double e = 0, pr = 0, cp = 0, tr = 0, beta = 1, numint = 1;
  int lck1 = 0, lckt = 0, lcf = 0, lcg = 0, lch = 0, lci = 0;
};

const CardOf<TabulatedCards> tabulated_metal_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&TabulatedCards::e, young},
    {&TabulatedCards::pr, poisson},
    {&TabulatedCards::cp,
     real("cp", {0, 2, -2}, 0, at_least(0), "heat capacity a mass and degree; 0: plastic work does not heat")},
    {&TabulatedCards::tr, real("tr", dimension::number, 0, any_value, "temperature at the start")},
    {&TabulatedCards::beta,
     real("beta", dimension::number, 1, between(0, 1), "share of the plastic work that becomes heat")},
    {&TabulatedCards::numint, real("numint", dimension::number, 1, any_value,
                                   "failed points that delete an element; below 0: percentage of a shell's layers")},
};

const CardOf<TabulatedCards> tabulated_metal_curves_card{
    {&TabulatedCards::lck1,
     id("lck1", IdSpace::function, required,
        "table: yield stress over plastic strain for rates of the plastic strain, or their logarithms; or a curve")},
    {&TabulatedCards::lckt,
     id("lckt", IdSpace::function, 0,
        "table: yield stress over plastic strain for temperatures, of which the ratio to that at TR counts")},
    {&TabulatedCards::lcf,
     id("lcf", IdSpace::function, 0,
        "curve: plastic strain at failure over triaxiality, pressure over effective stress; a table: for Lode "
        "parameters")},
    {&TabulatedCards::lcg,
     id("lcg", IdSpace::function, 0,
        "curve: factor on it over the rate of the plastic strain, or its logarithm where the first is below 0")},
    {&TabulatedCards::lch, id("lch", IdSpace::function, 0, "curve: factor on it over the temperature")},
    {&TabulatedCards::lci,
     id("lci", IdSpace::function, 0, "curve: factor on it over the element size; a table: for triaxialities")},
};

const CardOf<TabulatedCards> tabulated_metal_failure_card{
    real("failopt", dimension::number, 0, only(0), "1: failure after cycles, by an average"),
    real("numavg", dimension::number, 1, any_value, "cycles of the average, no effect without FAILOPT"),
    real("ncyfail", dimension::number, 1, any_value, "cycles until failure, no effect without FAILOPT"),
    real("erode", dimension::number, 0, only(0), "1: elements that fail are kept"),
    integer("lcps", 0, only(0), "table: limit of the first principal stress"),
};

/// Over triaxialities of the other sign: the cards have pressure positive.
Curve over_tension(Curve curve) {
  std::reverse(curve.x.begin(), curve.x.end());
  std::reverse(curve.y.begin(), curve.y.end());
  for (double& x : curve.x) x = -x;
  return curve;
}
CurveTable with_values_of_tension(CurveTable table) {
  if (table.value.size() < 2) return table;
  std::reverse(table.value.begin(), table.value.end());
  std::reverse(table.curve.begin(), table.curve.end());
  for (double& value : table.value) value = -value;
  return table;
}

/// The strain at failure, as damage of GISSMO that weakens nothing until it is 1.
kernel::Gissmo fracture_of(Builder& b, const RowOf<TabulatedCards>& row, double start) {
  const auto curves = [&](int TabulatedCards::*field, bool may_be_table) {
    const deck::Entry entry = row[field];
    return entry.integer() == 0 ? CurveTable{} : positive_curves(b, entry, entry.integer(), may_be_table);
  };
  const auto curve = [&](int TabulatedCards::*field) {
    const CurveTable found = curves(field, false);
    return found.given() ? found.curve.front() : Curve{};
  };
  kernel::Gissmo g;
  g.fracture = curves(&TabulatedCards::lcf, true);
  for (Curve& of_lode : g.fracture.curve) of_lode = over_tension(std::move(of_lode));
  g.threshold = 1.0;
  g.fading = {0, {0.0}, {Curve{0, {0.0}, {1.0}}}};
  g.mesh = with_values_of_tension(curves(&TabulatedCards::lci, true));
  g.rate = curve(&TabulatedCards::lcg);
  g.log_rates = !g.rate.empty() && g.rate.x.front() < 0.0;
  g.heat = curve(&TabulatedCards::lch);
  for (double& temperature : g.heat.x) temperature -= start;
  return g;
}

void set_tables(Builder& b, Index material, const RowOf<TabulatedCards>& row, bool log_rates) {
  const int errors = b.findings.errors();
  YieldTable yield = yield_table(b, row[&TabulatedCards::lck1], row->lck1, log_rates);
  if (yield.curves.empty()) return;
  kernel::TabulatedJohnsonCook flow;
  flow.E = row->e;
  flow.nu = row->pr;
  flow.yield = std::move(yield.curves);
  flow.rates = std::move(yield.rates);
  flow.log_rates = yield.log_rates;
  if (row->cp > 0.0) flow.heating = row->beta / (row->ro * row->cp);
  const auto needs_heat = [&](const deck::Entry& field) {
    if (!(flow.heating > 0.0))
      field.report(b.findings, Severity::warning, "has no effect without CP: the temperature stays TR", "give CP");
  };
  if (row->lckt != 0) {
    const deck::Entry field = row[&TabulatedCards::lckt];
    flow.softening = positive_curves(b, field, row->lckt, true);
    for (double& temperature : flow.softening.value) temperature -= row->tr;
    if (flow.softening.curve.size() == 1)
      refuse(b, field, "a curve of one temperature says nothing of others", "give a table over the temperature");
    needs_heat(field);
  }
  kernel::LawComponents law{flow};
  law.points_to_delete = row->numint;
  if (row->lcf != 0) {
    law.gissmo = fracture_of(b, row, row->tr);
    if (row->lch != 0) needs_heat(row[&TabulatedCards::lch]);
  } else {
    for (const auto field : {&TabulatedCards::lcg, &TabulatedCards::lch, &TabulatedCards::lci})
      if ((*row).*field != 0) row[field].report(b.findings, Severity::warning, "has no effect without LCF", "give LCF");
  }
  if (b.findings.errors() > errors) return;
  b.model.materials[material].law = composed_law(std::move(law));
}

void read_tabulated_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  TabulatedCards cards;
  const auto elastic = cursor.read(tabulated_metal_card, cards);
  const auto curves = cursor.read(tabulated_metal_curves_card, cards);
  if (cursor.more()) cursor.read(tabulated_metal_failure_card, cards);
  expect_end(b, cursor);
  if (cards.numint < -100.0)
    refuse(b, elastic[&TabulatedCards::numint], "elements that stay when all their points have failed are not built",
           "give a number of points, or a percentage from -1 to -100");
  const Index material =
      add_material(b, elastic, std::move(title), "MAT_TABULATED_JOHNSON_COOK", kernel::Elastic{cards.e, cards.pr});
  b.defer(Phase::parts, [=, log_rates = options.contains("LOG_INTERPOLATION")](Builder& later) {
    set_tables(later, material, curves, log_rates);
  });
}

}  // namespace

std::vector<Keyword> tabulated_johnson_cook_keywords() {
  return {{.name = "MAT_TABULATED_JOHNSON_COOK",
           .aliases = {"MAT_224"},
           .options = {"TITLE", "LOG_INTERPOLATION"},
           .layout = {{"", &tabulated_metal_card},
                      {"", &tabulated_metal_curves_card},
                      {"optional", &tabulated_metal_failure_card}},
           .read = read_tabulated_johnson_cook}};
}

}  // namespace nugget::reading
