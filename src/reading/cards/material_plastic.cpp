// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"
#include "reading/cards/yield_curves.hpp"

// *MAT_... of metals that are put together at run time (kernel::ComposedLaw), and MAT_012. Those of Johnson and Cook
// are in material_johnson_cook.cpp.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;
using deck::RowOf;

// ---- 012

struct IsotropicCard : MaterialCard {
  double g = 0, sigy = 0, etan = 0, bulk = 0;
};
const CardOf<IsotropicCard> isotropic_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&IsotropicCard::g, real("g", dimension::stress, required, above_zero(), "shear modulus")},
    {&IsotropicCard::sigy, real("sigy", dimension::stress, required, above_zero(), "yield stress")},
    {&IsotropicCard::etan, real("etan", dimension::stress, 0, at_least(0), "plastic hardening modulus")},
    {&IsotropicCard::bulk, real("bulk", dimension::stress, required, above_zero(), "bulk modulus")},
};

void read_isotropic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const auto row = cursor.read(isotropic_card);
  expect_end(b, cursor);
  const double G = row->g, K = row->bulk;
  kernel::PiecewiseLinear law;
  law.E = 9.0 * K * G / (3.0 * K + G);
  law.nu = (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G);
  if (law.nu < 0.0)
    refuse(b, row[&IsotropicCard::bulk], "G and BULK make a negative Poisson's ratio", "3 BULK must be above 2 G");
  law.yield = {{0, {0.0, 1.0}, {row->sigy, row->sigy + row->etan}}};
  add_material(b, row, std::move(title), "MAT_ISOTROPIC_ELASTIC_PLASTIC", law);
}

// ---- 018

/// Both cards of *MAT_POWER_LAW_PLASTICITY.
struct PowerLawCards : MaterialCard {
  double e = 0, pr = 0, k = 0, n = 0, src = 0, srp = 0;
  double sigy = 0, epsf = 0;
};
const CardOf<PowerLawCards> power_law_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&PowerLawCards::e, young},
    {&PowerLawCards::pr, poisson},
    {&PowerLawCards::k,
     real("k", dimension::stress, required, above_zero(), "yield stress at an elastic and plastic strain of 1")},
    {&PowerLawCards::n, real("n", dimension::number, required, above_zero(), "hardening: exponent of the strain")},
    {&PowerLawCards::src, real("src", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect")},
    {&PowerLawCards::srp, real("srp", dimension::number, 0, at_least(0), "Cowper-Symonds P")},
};

const CardOf<PowerLawCards> power_law_yield_card{
    {&PowerLawCards::sigy,
     real("sigy", dimension::number, 0, at_least(0),
          "first yield; 0: where E e = K e^N; up to 0.02 the strain at first yield, else its stress, as written")},
    vp,
    {&PowerLawCards::epsf, real("epsf", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
};

/// Elastic strain at first yield. `stress`: factor of stresses by *INCLUDE_TRANSFORM; the number that stands in the
/// deck says whether it is one.
double yield_strain(Builder& b, const PowerLawCards& cards, const deck::Entry& exponent, double stress) {
  const double k = cards.k, n = cards.n, sigy = cards.sigy;
  if (sigy > 0.02) return std::pow(sigy * stress / k, 1.0 / n);
  if (sigy > 0.0) return sigy;
  if (n >= 1.0) {
    refuse(b, exponent, "with an exponent of 1 or more the line E e does not meet the curve K e^N", "give SIGY");
    return 1.0;
  }
  return std::pow(cards.e / k, 1.0 / (n - 1.0));
}

void read_power_law(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  PowerLawCards cards;
  const auto row = cursor.read(power_law_card, cards);
  cursor.read(power_law_yield_card, cards);
  expect_end(b, cursor);
  warn_of_half_a_rate(b, row[&PowerLawCards::src], row[&PowerLawCards::srp]);
  kernel::PowerLaw flow{cards.e, cards.pr, cards.k, cards.n,
                        yield_strain(b, cards, row[&PowerLawCards::n],
                                     block.transform ? block.transform->factor(dimension::stress) : 1.0)};
  if (cards.src > 0.0 && cards.srp > 0.0) {
    flow.rate_c = cards.src;
    flow.rate_p = cards.srp;
  }
  kernel::LawComponents law{flow};
  law.failure_strain = plastic_strain_at_failure(cards.epsf);
  add_material(b, row, std::move(title), "MAT_POWER_LAW_PLASTICITY", composed_law(std::move(law)));
}

// ---- 019

/// Both cards of *MAT_STRAIN_RATE_DEPENDENT_PLASTICITY.
struct RateDependentCards : MaterialCard {
  double e = 0, pr = 0, etan = 0, tdel = 0;
  int lc1 = 0, lc3 = 0, lc4 = 0;
};
const CardOf<RateDependentCards> rate_dependent_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&RateDependentCards::e, young},
    {&RateDependentCards::pr, poisson},
    vp,
};

const CardOf<RateDependentCards> rate_dependent_curves_card{
    {&RateDependentCards::lc1, id("lc1", IdSpace::function, required, "curve: yield stress over the strain rate")},
    {&RateDependentCards::etan, real("etan", dimension::stress, 0, at_least(0), "plastic hardening modulus")},
    integer("lc2", 0, only(0), "curve: Young's modulus over the strain rate"),
    {&RateDependentCards::lc3,
     id("lc3", IdSpace::function, 0, "curve: tangent modulus over the strain rate, instead of ETAN")},
    {&RateDependentCards::lc4,
     id("lc4", IdSpace::function, 0, "curve: plastic strain at failure over the strain rate")},
    {&RateDependentCards::tdel, tdel},
    real("rdef", dimension::number, 1, only(1), "what LC4 is: 1 the plastic strain at failure"),
};

/// Yield stress and plastic modulus over the rate, each between its neighbours, as a table of straight yield curves at
/// the rates of both.
/// `row`: the second card, with the values of both.
void set_rate_curves(Builder& b, Index material, const RowOf<RateDependentCards>& row) {
  kernel::PiecewiseLinear flow;
  flow.E = row->e;
  flow.nu = row->pr;
  const Index lc1 = b.curve(row[&RateDependentCards::lc1]);
  if (lc1 == none) return;
  const auto curve = [&b](Index c) -> const Curve& { return b.model.curves[c]; };
  const Curve& yield = curve(lc1);
  for (const double y : yield.y)
    if (!(y > 0.0)) return refuse(b, row[&RateDependentCards::lc1], "a yield stress is not above 0");
  if (!std::is_sorted(yield.y.begin(), yield.y.end()))
    warn_of_softening_by_rate(b, row[&RateDependentCards::lc1], fmt::format("curve {}", yield.id));
  Curve modulus{0, {0.0}, {row->etan}};
  if (const Index tangent = b.curve(row[&RateDependentCards::lc3]); tangent != none) {
    modulus = curve(tangent);
    for (double& y : modulus.y) {
      if (!(y >= 0.0 && y < flow.E))
        return refuse(b, row[&RateDependentCards::lc3], "a tangent modulus is not between 0 and E");
      y = flow.E * y / (flow.E - y);
    }
  }
  std::set<double> rates{0.0};
  for (const Curve* over_rate : std::initializer_list<const Curve*>{&yield, &modulus})
    rates.insert(over_rate->x.begin(), over_rate->x.end());
  rates.erase(rates.begin(), rates.find(0.0));
  for (const double rate : rates) {
    const double at_first_yield = yield.clamped(rate);
    flow.rates.push_back(rate);
    flow.yield.push_back({0, {0.0, 1.0}, {at_first_yield, at_first_yield + modulus.clamped(rate)}});
  }
  kernel::LawComponents law{flow};
  law.deletion_step = row->tdel;
  if (const Index failure = b.curve(row[&RateDependentCards::lc4]); failure != none)
    law.failure_strain_over_rate = curve(failure);
  b.model.materials[material].law = composed_law(std::move(law));
}

void read_rate_dependent(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  RateDependentCards cards;
  const auto row = cursor.read(rate_dependent_card, cards);
  const auto curves = cursor.read(rate_dependent_curves_card, cards);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_STRAIN_RATE_DEPENDENT_PLASTICITY",
                                      kernel::Elastic{cards.e, cards.pr});
  b.defer(Phase::parts, [=](Builder& later) { set_rate_curves(later, material, curves); });
}

// ---- 081, 105, 123

const CardOf<YieldCards> damage_card = yield_card({
    {&YieldCards::eppf, real("eppf", dimension::number, 1e12, at_least(0), "plastic strain at which softening begins")},
    {&YieldCards::tdel, tdel},
});

const CardOf<YieldCards> damage_rate_card = yield_rate_card({
    {&YieldCards::eppfr, real("eppfr", dimension::number, 1e14, at_least(0), "plastic strain at rupture")},
    {&YieldCards::vp, vp_of_curves},
    {&YieldCards::lcdm, id("lcdm", IdSpace::function, 0, "curve: damage over plastic strain beyond EPPF")},
    {&YieldCards::numint, numint},
});

const CardOf<YieldCards> energy_damage_card = yield_card({
    {&YieldCards::fail, real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    {&YieldCards::tdel, tdel},
});
const CardOf<YieldCards> energy_damage_rate_card = yield_rate_card({});
const CardOf<YieldCards> energy_card{
    {&YieldCards::epsd, real("epsd", dimension::number, 0, at_least(0), "plastic strain at which damage begins")},
    {&YieldCards::s,
     real("s", dimension::stress, 0, at_least(0), "damage is energy over S; 0: a 200th of the first yield stress")},
    {&YieldCards::dc, real("dc", dimension::number, 0.5, between(0, 1), "damage at which a point fails")},
};

const CardOf<YieldCards> modified_card = yield_card({
    {&YieldCards::fail, real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none")},
    {&YieldCards::tdel, tdel},
});

const CardOf<YieldCards> modified_rate_card = yield_rate_card({
    {&YieldCards::vp, vp_of_curves},
    {&YieldCards::epsthin,
     real("epsthin", dimension::number, 0, at_least(0), "plastic thinning of a layer at failure; 0: none")},
    {&YieldCards::epsmaj,
     real("epsmaj", dimension::number, 0, at_least(0), "major strain in the plane at failure; 0: none")},
    {&YieldCards::numint, numint},
});

/// Reads the four cards, and `third` between them; `complete` adds to the law what is the keyword's own, once curves
/// are known.
void read_with_curves(Builder& b, const Block& block, const Options& options, std::string_view name,
                      const CardOf<YieldCards>& main, const CardOf<YieldCards>& rate,
                      void (*complete)(Builder&, const YieldRows&, kernel::LawComponents&),
                      const CardOf<YieldCards>* third = nullptr) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const YieldRows rows = read_yield_cards(cursor, main, rate, options.contains("LOG_INTERPOLATION"), third);
  expect_end(b, cursor);
  const YieldCards& cards = rows.cards();
  check_tangent(b, cards.e, rows.main[&YieldCards::etan]);
  const Index material = add_material(b, rows.main, std::move(title), name, kernel::Elastic{cards.e, cards.pr});
  b.defer(Phase::parts, [=](Builder& later) {
    const YieldCards& values = rows.cards();
    kernel::PiecewiseLinear flow;
    flow.E = values.e;
    flow.nu = values.pr;
    set_yield_curves(later, rows, flow);
    if (flow.yield.empty()) return;
    kernel::LawComponents law{flow};
    law.deletion_step = values.tdel;
    law.points_to_delete = values.numint;
    complete(later, rows, law);
    later.model.materials[material].law = composed_law(std::move(law));
  });
}

void add_damage(Builder& b, const YieldRows& rows, kernel::LawComponents& law) {
  law.damage =
      plastic_damage(b, rows.main[&YieldCards::eppf], rows.rate[&YieldCards::eppfr], rows.rate[&YieldCards::lcdm]);
}

void add_directional_damage(Builder& b, const YieldRows& rows, kernel::LawComponents& law) {
  law.directional_damage =
      plastic_damage(b, rows.main[&YieldCards::eppf], rows.rate[&YieldCards::eppfr], rows.rate[&YieldCards::lcdm]);
  law.for_layers_only = true;
}

void add_strain_limits(Builder&, const YieldRows& rows, kernel::LawComponents& law) {
  law.failure_strain = plastic_strain_at_failure(rows.cards().fail);
  law.limits = {rows.cards().epsthin, rows.cards().epsmaj};
}

void add_energy_damage(Builder&, const YieldRows& rows, kernel::LawComponents& law) {
  const YieldCards& cards = rows.cards();
  law.failure_strain = plastic_strain_at_failure(cards.fail);
  const auto& flow = std::get<kernel::PiecewiseLinear>(law.flow);
  const double resistance = cards.s > 0.0 ? cards.s : flow.yield.front().clamped(0.0) / 200.0;
  law.energy_damage = kernel::EnergyDamage{cards.e, cards.pr, cards.epsd, resistance, cards.dc};
}

void read_energy_damage(Builder& b, const Block& block, const Options& options) {
  read_with_curves(b, block, options, "MAT_DAMAGE_2", energy_damage_card, energy_damage_rate_card, add_energy_damage,
                   &energy_card);
}

void read_damage(Builder& b, const Block& block, const Options& options) {
  read_with_curves(b, block, options, "MAT_PLASTICITY_WITH_DAMAGE", damage_card, damage_rate_card, add_damage);
}

void read_directional_damage(Builder& b, const Block& block, const Options& options) {
  read_with_curves(b, block, options, "MAT_PLASTICITY_WITH_DAMAGE_ORTHO", damage_card, damage_rate_card,
                   add_directional_damage);
}

void read_modified(Builder& b, const Block& block, const Options& options) {
  read_with_curves(b, block, options, "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY", modified_card, modified_rate_card,
                   add_strain_limits);
}

}  // namespace

std::vector<Keyword> plastic_material_keywords() {
  return {
      {.name = "MAT_ISOTROPIC_ELASTIC_PLASTIC",
       .aliases = {"MAT_012"},
       .options = {"TITLE"},
       .layout = {{"", &isotropic_card}},
       .read = read_isotropic},
      {.name = "MAT_POWER_LAW_PLASTICITY",
       .aliases = {"MAT_018"},
       .options = {"TITLE"},
       .layout = {{"", &power_law_card}, {"", &power_law_yield_card}},
       .read = read_power_law},
      {.name = "MAT_STRAIN_RATE_DEPENDENT_PLASTICITY",
       .aliases = {"MAT_019"},
       .options = {"TITLE"},
       .layout = {{"", &rate_dependent_card}, {"", &rate_dependent_curves_card}},
       .read = read_rate_dependent},
      {.name = "MAT_PLASTICITY_WITH_DAMAGE",
       .aliases = {"MAT_081"},
       .options = {"TITLE"},
       .layout = {{"", &damage_card}, {"", &damage_rate_card}, {"", &yield_strain_card}, {"", &yield_stress_card}},
       .read = read_damage},
      {.name = "MAT_PLASTICITY_WITH_DAMAGE_ORTHO",
       .aliases = {"MAT_082"},
       .options = {"TITLE"},
       .layout = {{"", &damage_card}, {"", &damage_rate_card}, {"", &yield_strain_card}, {"", &yield_stress_card}},
       .read = read_directional_damage},
      {.name = "MAT_PLASTICITY_WITH_DAMAGE_ORTHO_RCDC",
       .aliases = {"MAT_082_RCDC"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "the damage of Wilkins (Rc-Dc) is not built; the keyword without _RCDC is"},
      {.name = "MAT_PLASTICITY_WITH_DAMAGE_ORTHO_RCDC1980",
       .aliases = {"MAT_082_RCDC1980"},
       .options = {"TITLE"},
       .status = KeywordStatus::refused,
       .why = "the damage of Wilkins (Rc-Dc) is not built; the keyword without _RCDC1980 is"},
      {.name = "MAT_DAMAGE_2",
       .aliases = {"MAT_105"},
       .options = {"TITLE"},
       .layout = {{"", &energy_damage_card},
                  {"", &energy_damage_rate_card},
                  {"", &energy_card},
                  {"", &yield_strain_card},
                  {"", &yield_stress_card}},
       .read = read_energy_damage},
      {.name = "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY",
       .aliases = {"MAT_123"},
       .options = {"TITLE", "LOG_INTERPOLATION"},
       .layout = {{"", &modified_card}, {"", &modified_rate_card}, {"", &yield_strain_card}, {"", &yield_stress_card}},
       .read = read_modified},
  };
}

}  // namespace nugget::reading
