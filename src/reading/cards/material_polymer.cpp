// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_PLASTICITY_POLYMER (089), *MAT_PLASTICITY_COMPRESSION_TENSION (124): plastics, and metals that differ in
// tension.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Entry;

// ---- 089

struct PolymerCards : MaterialCard {
  double e = 0, pr = 0, c = 0, p = 0, eftx = 0, numint = 0;
  int lcss = 0, lcsr = 0, lcfail = 0;
};
const CardOf<PolymerCards> polymer_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&PolymerCards::e, young},
    {&PolymerCards::pr, poisson},
};
const CardOf<PolymerCards> polymer_rate_card{
    {&PolymerCards::c, real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect")},
    {&PolymerCards::p, real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P")},
    {&PolymerCards::lcss, id("lcss", IdSpace::function, required,
                             "true stress over total true strain: curve, or table over the strain rate")},
    {&PolymerCards::lcsr, id("lcsr", IdSpace::function, 0, "curve: factor on the yield stress over the strain rate")},
};
const CardOf<PolymerCards> polymer_failure_card{
    {&PolymerCards::eftx, real("eftx", dimension::number, 0, only(0),
                               "failure 0: by the largest principal strain; 1, 2: by x, y of the element")},
    real("damp", dimension::number, 0, only(0), "viscous damping: not built"),
    real("ratefac", dimension::number, 0, between(0, 1),
         "filter of rates: no effect, as the rate of the plastic strain is found together with the stress"),
    {&PolymerCards::lcfail,
     id("lcfail", IdSpace::function, 0, "curve: true strain at failure over the logarithm of the strain rate")},
    {&PolymerCards::numint, numint},
};

/// `rate`, `failure`: the second and third card, with the values of all.
void set_polymer(Builder& b, Index material, const deck::RowOf<PolymerCards>& rate,
                 const deck::RowOf<PolymerCards>& failure) {
  const PolymerCards& cards = *failure;
  kernel::PiecewiseLinear flow;
  flow.E = cards.e;
  flow.nu = cards.pr;
  YieldTable table = yield_table(b, rate[&PolymerCards::lcss], cards.lcss, false, cards.e);
  if (table.curves.empty()) return;
  flow.yield = std::move(table.curves);
  flow.rates = std::move(table.rates);
  flow.log_rates = table.log_rates;
  const bool by_table = !flow.rates.empty();
  if (const Index scale = b.curve(rate[&PolymerCards::lcsr]); scale != none && !by_table)
    flow.rate_scale = b.model.curves[scale];
  if (by_table && (cards.c > 0.0 || cards.lcsr != 0))
    rate[cards.c > 0.0 ? &PolymerCards::c : &PolymerCards::p].report(
        b.findings, Severity::warning, "C, P and LCSR are not obeyed: the rates are those of the table in LCSS",
        "leave them empty");
  if (!by_table && flow.rate_scale.empty() && cards.c > 0.0 && cards.p > 0.0) {
    flow.rate_c = cards.c;
    flow.rate_p = cards.p;
  }
  kernel::LawComponents law{flow};
  law.points_to_delete = cards.numint;
  if (const Index fails = b.curve(failure[&PolymerCards::lcfail]); fails != none) {
    law.erosion = kernel::Erosion{};
    law.erosion->most_strain_over_log_rate = b.model.curves[fails];
  }
  b.model.materials[material].law = kernel::composed_law(std::move(law));
}

void read_polymer(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  PolymerCards cards;
  const auto row = cursor.read(polymer_card, cards);
  const auto rate = cursor.read(polymer_rate_card, cards);
  const auto failure = cursor.read(polymer_failure_card, cards);
  expect_end(b, cursor);
  warn_of_half_a_rate(b, rate[&PolymerCards::c], rate[&PolymerCards::p]);
  const Index material =
      add_material(b, row, std::move(title), "MAT_PLASTICITY_POLYMER", kernel::Elastic{cards.e, cards.pr});
  b.defer(Phase::parts, [=](Builder& later) { set_polymer(later, material, rate, failure); });
}

// ---- 124

struct TwoCurves : MaterialCard, kernel::CompressionTension {
  double c = 0, p = 0, ec = 0, rpct = 0, srflag = 0, srfilt = 0;
  int lcidc = 0, lcidt = 0, lcsrc = 0, lcsrt = 0, lcfail = 0;
};
const CardOf<TwoCurves> two_curves_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&kernel::CompressionTension::E, young},
    {&kernel::CompressionTension::nu, poisson},
    {&TwoCurves::c, real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect")},
    {&TwoCurves::p, real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P")},
    {&kernel::CompressionTension::failure_strain,
     real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    {&kernel::CompressionTension::deletion_step, tdel},
};
const CardOf<TwoCurves> two_curves_rate_card{
    {&TwoCurves::lcidc,
     id("lcidc", IdSpace::function, required, "curve: yield stress over plastic strain in compression")},
    {&TwoCurves::lcidt, id("lcidt", IdSpace::function, required, "curve: the same in tension")},
    {&TwoCurves::lcsrc, id("lcsrc", IdSpace::function, 0, "curve: factor in compression over the strain rate")},
    {&TwoCurves::lcsrt, id("lcsrt", IdSpace::function, 0, "curve: the same in tension")},
    real("srflag", dimension::number, 0, between(0, 2),
         "which rate: no effect, as the rate of the plastic strain is found together with the stress"),
    {&TwoCurves::lcfail, id("lcfail", IdSpace::function, 0, "curve: plastic strain at failure over the strain rate")},
    {&TwoCurves::ec, real("ec", dimension::stress, 0, at_least(0), "Young's modulus in compression, if it is another")},
    {&TwoCurves::rpct, real("rpct", dimension::number, 0, at_least(0),
                            "share of PC and PT from which on EC and E count alone, weighted in between")},
};
const CardOf<TwoCurves> pressures_card{
    {&kernel::CompressionTension::full_compression,
     real("pc", dimension::stress, 0, at_least(0), "mean pressure from which on LCIDC counts")},
    {&kernel::CompressionTension::full_tension,
     real("pt", dimension::stress, 0, at_least(0), "mean tension from which on LCIDT counts")},
    real("pcutc", dimension::stress, 0, any_value, "cutoff of the pressure in compression, with PCUTF"),
    real("pcutt", dimension::stress, 0, any_value, "the same in tension"),
    real("pcutf", dimension::number, 0, only(0), "1: cutoff of the pressure: not built"),
    real("srfilt", dimension::number, 0, between(0, 1), "filter of rates: no effect, as with SRFLAG"),
};
const CardOf<TwoCurves> kelvin_card{
    real("k", dimension::stress, 0, only(0), "bulk modulus of a viscous part: not built"),
};
struct ViscousTerm {
  double gi = 0;
};
const CardOf<ViscousTerm> viscous_card{
    {&ViscousTerm::gi, real("gi", dimension::stress, 0, only(0), "shear modulus of a viscous part: not built")},
    real("betai", dimension::rate, 0, any_value, "its decay"),
};

/// `rate`: the second card.
void set_two_curves(Builder& b, Index material, const TwoCurves& cards, const deck::RowOf<TwoCurves>& rate) {
  kernel::CompressionTension flow = cards;
  const auto curve_of = [&](const Entry& field, int id, Curve& curve) {
    const YieldTable table = yield_table(b, field, id, false);
    if (table.curves.size() == 1)
      curve = table.curves.front();
    else if (table.curves.size() > 1)
      refuse(b, field, "a table over the rate is not built here", "give one curve, and LCSRC, LCSRT");
    return table.curves.size() == 1;
  };
  if (!curve_of(rate[&TwoCurves::lcidc], cards.lcidc, flow.compression)) return;
  if (!curve_of(rate[&TwoCurves::lcidt], cards.lcidt, flow.tension)) return;
  const auto take_scale = [&](const Entry& field, Curve& scale) {
    const Index found = b.curve(field);
    if (found == none) return;
    scale = b.model.curves[found];
    if (std::any_of(scale.y.begin(), scale.y.end(), [](double y) { return !(y > 0.0); }))
      refuse(b, field, fmt::format("curve {} has a factor that is not above 0", scale.id), "give factors above 0");
    if (!std::is_sorted(scale.y.begin(), scale.y.end()))
      warn_of_softening_by_rate(b, field, fmt::format("curve {}", scale.id));
  };
  take_scale(rate[&TwoCurves::lcsrc], flow.compression_scale);
  take_scale(rate[&TwoCurves::lcsrt], flow.tension_scale);
  const bool scaled = !flow.compression_scale.empty() || !flow.tension_scale.empty();
  if (!scaled && cards.c > 0.0 && cards.p > 0.0) {
    flow.rate_c = cards.c;
    flow.rate_p = cards.p;
  }
  const double in_tension = flow.E;
  if (cards.ec > 0.0 && cards.ec != flow.E) {
    flow.E = std::max(cards.E, cards.ec);
    flow.tension_share = cards.E / flow.E;
    flow.compression_share = cards.ec / flow.E;
    flow.soft_compression = cards.rpct * cards.full_compression;
    flow.soft_tension = cards.rpct * cards.full_tension;
  }
  kernel::LawComponents law = components_of(std::move(flow));
  if (cards.ec > 0.0) law.contact_modulus = in_tension;
  law.failure_strain = plastic_strain_at_failure(law.failure_strain);
  if (const Index failure = b.curve(rate[&TwoCurves::lcfail]); failure != none)
    law.failure_strain_over_rate = b.model.curves[failure];
  b.model.materials[material].law = kernel::composed_law(std::move(law));
}

void read_two_curves(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  TwoCurves cards;
  const auto row = cursor.read(two_curves_card, cards);
  const auto rate = cursor.read(two_curves_rate_card, cards);
  if (!at_end(cursor)) cursor.read(pressures_card, cards);
  if (!at_end(cursor)) cursor.read(kelvin_card, cards);
  while (cursor.more()) cursor.read(viscous_card);
  warn_of_half_a_rate(b, row[&TwoCurves::c], row[&TwoCurves::p]);
  if (cards.c > 0.0 && (cards.lcsrc != 0 || cards.lcsrt != 0))
    row[&TwoCurves::c].report(b.findings, Severity::warning, "C and P are not obeyed with LCSRC and LCSRT",
                              "leave them empty");
  const Index material =
      add_material(b, row, std::move(title), "MAT_PLASTICITY_COMPRESSION_TENSION", kernel::Elastic{cards.E, cards.nu});
  b.defer(Phase::parts, [=](Builder& later) { set_two_curves(later, material, cards, rate); });
}

}  // namespace

std::vector<Keyword> polymer_material_keywords() {
  return {
      {.name = "MAT_PLASTICITY_POLYMER",
       .aliases = {"MAT_089"},
       .options = {"TITLE"},
       .layout = {{"", &polymer_card}, {"", &polymer_rate_card}, {"", &polymer_failure_card}},
       .read = read_polymer},
      {.name = "MAT_PLASTICITY_COMPRESSION_TENSION",
       .aliases = {"MAT_124"},
       .options = {"TITLE"},
       .layout = {{"", &two_curves_card},
                  {"", &two_curves_rate_card},
                  {"may be left out", &pressures_card},
                  {"may be left out", &kelvin_card},
                  {"may be left out", &viscous_card}},
       .read = read_two_curves},
  };
}

}  // namespace nugget::reading
