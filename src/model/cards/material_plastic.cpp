// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "kernel/law/composition.hpp"
#include "model/cards/families.hpp"
#include "model/cards/material.hpp"
#include "model/cards/reading.hpp"
#include "model/cards/yield_curves.hpp"

// *MAT_... of metals that are put together at run time (kernel::Compound), and MAT_012.
namespace nugget::model {

namespace {

using deck::Block;
using deck::Cursor;
using deck::Row;

constexpr Field vp =
    real("vp", dimension::number, 0, between(0, 1), "rate of 0: the total strain, 1: the plastic strain");
constexpr Field numint = real("numint", dimension::number, 0, any_value,
                              "failed points that delete a shell; 0: all; below 0: percentage of its layers");
constexpr Field tdel =
    real("tdel", dimension::time, 0, at_least(0), "smallest time step of an element before it is deleted; 0: none");

// ---- 098, 015

const Card simplified_johnson_cook_card{{material_id, density, young, poisson, vp}};

const Card simplified_johnson_cook_yield_card{{
    real("a", dimension::stress, required, above_zero(), "yield stress at rest"),
    real("b", dimension::stress, 0, at_least(0), "hardening: factor of the power of the plastic strain"),
    real("n", dimension::number, 0, at_least(0), "hardening: exponent of the plastic strain"),
    real("c", dimension::number, 0, at_least(0), "factor of the logarithm of the rate; 0: no rate effect"),
    real("psfail", dimension::number, 1e17, at_least(0), "plastic strain at failure; 0: none"),
    real("sigmax", dimension::stress, 1e28, at_least(0), "greatest yield stress before rate effects; 0: none"),
    real("sigsat", dimension::stress, 1e28, at_least(0), "greatest yield stress with rate effects; 0: none"),
    real("epso", dimension::rate, 1, above_zero(), "rate up to which there is no rate effect"),
}};

const Card johnson_cook_card{{
    material_id,
    density,
    real("g", dimension::stress, 0, any_value, "shear modulus, for solids only"),
    young,
    poisson,
    real("dtf", dimension::time, 0, at_least(0), "smallest time step of a shell before it is deleted; 0: none"),
    vp,
    real("rateop", dimension::number, 0, only(0), "form of the rate effect: 0, the logarithm"),
}};

const Card johnson_cook_yield_card{{
    real("a", dimension::stress, required, above_zero(), "yield stress at rest and cold"),
    real("b", dimension::stress, 0, at_least(0), "hardening: factor of the power of the plastic strain"),
    real("n", dimension::number, 0, at_least(0), "hardening: exponent of the plastic strain"),
    real("c", dimension::number, 0, at_least(0), "factor of the logarithm of the rate; 0: no rate effect"),
    real("m", dimension::number, 0, at_least(0), "softening: exponent of the relative temperature"),
    real("tm", dimension::number, 0, any_value, "temperature of melting"),
    real("tr", dimension::number, 0, any_value, "temperature at the start"),
    real("epso", dimension::rate, 1, above_zero(), "rate up to which there is no rate effect"),
}};

const Card johnson_cook_heat_card{{
    real("cp", {0, 2, -2}, 0, at_least(0), "heat capacity a mass and degree; 0: plastic work does not heat"),
    real("pc", dimension::stress, 0, any_value, "pressure cutoff, for solids only"),
    real("spall", dimension::number, 2, any_value, "form of spalling, for solids only"),
    real("it", dimension::number, 0, any_value, "iteration of plastic strain, for solids only"),
    real("d1", dimension::number, 0, any_value, "strain at fracture; D1 to D5 0: none"),
    real("d2", dimension::number, 0, any_value, "strain at fracture: factor of exp(D3 mean over effective stress)"),
    real("d3", dimension::number, 0, any_value, "strain at fracture; below 0: less under tension"),
    real("d4", dimension::number, 0, any_value, "strain at fracture: factor of the logarithm of the rate"),
}};

const Card johnson_cook_fracture_card{{
    real("d5", dimension::number, 0, any_value, "strain at fracture: factor of the relative temperature"),
    real("c2", dimension::number, 0, any_value, "for RATEOP other than 0 only"),
    real("erod", dimension::number, 0, only(0), "0: an element that fails is deleted"),
    real("efmin", dimension::number, 1e-6, at_least(0), "least strain at fracture"),
    numint,
    real("k", dimension::number, 0, any_value, "for RATEOP 5 only"),
    real("eps1", dimension::rate, 0, any_value, "for RATEOP 5 only"),
    real("dmodel", dimension::number, 0, only(0), "damage model: 0, of Johnson and Cook"),
}};

/// A failure strain so large is none.
double plastic_strain_at_failure(double written) {
  return written >= 1e12 ? 0.0 : written;
}

kernel::JohnsonCook johnson_cook(const Row& main, const Row& yield) {
  kernel::JohnsonCook flow;
  flow.E = main.real("e");
  flow.nu = main.real("pr");
  flow.yield = yield.real("a");
  flow.hardening = yield.real("b");
  flow.exponent = yield.real("n");
  flow.rate_factor = yield.real("c");
  flow.rest_rate = yield.real("epso");
  flow.viscoplastic = main.real("vp") == 1.0;
  return flow;
}

void read_simplified_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(simplified_johnson_cook_card);
  const Row yield = cursor.read(simplified_johnson_cook_yield_card);
  expect_end(b, cursor);
  kernel::JohnsonCook flow = johnson_cook(row, yield);
  flow.most_hardened = yield.real("sigmax");
  flow.saturation = yield.real("sigsat");
  kernel::Composition law{flow};
  law.failure_strain = plastic_strain_at_failure(yield.real("psfail"));
  add_material(b, row, std::move(title), "MAT_SIMPLIFIED_JOHNSON_COOK", compound(std::move(law)));
}

/// Heating by plastic work, where CP is given.
void heat(Builder& b, const Row& main, const Row& yield, const Row& heat, kernel::JohnsonCook& flow) {
  if (!(heat.real("cp") > 0.0)) return;
  if (!(yield.real("tm") > yield.real("tr")))
    return refuse(b, yield, "tm", "with CP the temperature of melting must lie above TR", "give TM and TR, or CP 0");
  if (!(yield.real("m") > 0.0))
    return refuse(b, yield, "m", "with CP the exponent M must be above 0", "give M, or CP 0");
  flow.heating = 1.0 / (main.real("ro") * heat.real("cp"));
  flow.melting_rise = yield.real("tm") - yield.real("tr");
  flow.softening = yield.real("m");
}

void read_johnson_cook(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(johnson_cook_card);
  const Row yield = cursor.read(johnson_cook_yield_card);
  const Row third = cursor.read(johnson_cook_heat_card);
  const Row fourth = cursor.read(johnson_cook_fracture_card);
  expect_end(b, cursor);
  kernel::JohnsonCook flow = johnson_cook(row, yield);
  heat(b, row, yield, third, flow);
  kernel::Composition law{flow};
  const kernel::JohnsonCookFracture fracture{
      third.real("d1"),  third.real("d2"),     third.real("d3"), third.real("d4"),
      fourth.real("d5"), fourth.real("efmin"), flow.rest_rate,   flow.heating > 0.0 ? flow.melting_rise : 0.0,
      flow.viscoplastic};
  if (fracture.d1 != 0.0 || fracture.d2 != 0.0 || fracture.d3 != 0.0 || fracture.d4 != 0.0 || fracture.d5 != 0.0)
    law.fracture = fracture;
  if (fracture.d2 > 0.0 && fracture.d3 > 0.0)
    third.complain(b.findings, Severity::warning, "d3",
                   "tension is positive here: with D3 above 0 the strain at fracture grows with tension",
                   "published constants have a D3 below 0");
  law.points_to_delete = fourth.real("numint");
  law.deletion_step = row.real("dtf");
  law.for_bricks = false;
  add_material(b, row, std::move(title), "MAT_JOHNSON_COOK", compound(std::move(law)));
}

// ---- 012

const Card isotropic_card{{
    material_id,
    density,
    real("g", dimension::stress, required, above_zero(), "shear modulus"),
    real("sigy", dimension::stress, required, above_zero(), "yield stress"),
    real("etan", dimension::stress, 0, at_least(0), "plastic hardening modulus"),
    real("bulk", dimension::stress, required, above_zero(), "bulk modulus"),
}};

void read_isotropic(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(isotropic_card);
  expect_end(b, cursor);
  const double G = row.real("g"), K = row.real("bulk"), yield = row.real("sigy");
  kernel::PiecewiseLinear law;
  law.E = 9.0 * K * G / (3.0 * K + G);
  law.nu = (3.0 * K - 2.0 * G) / (6.0 * K + 2.0 * G);
  if (law.nu < 0.0) refuse(b, row, "bulk", "G and BULK make a negative Poisson's ratio", "3 BULK must be above 2 G");
  law.yield = {{0, {0.0, 1.0}, {yield, yield + row.real("etan")}}};
  add_material(b, row, std::move(title), "MAT_ISOTROPIC_ELASTIC_PLASTIC", law);
}

// ---- 018

const Card power_law_card{{
    material_id,
    density,
    young,
    poisson,
    real("k", dimension::stress, required, above_zero(), "yield stress at an elastic and plastic strain of 1"),
    real("n", dimension::number, required, above_zero(), "hardening: exponent of the strain"),
    real("src", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect"),
    real("srp", dimension::number, 0, at_least(0), "Cowper-Symonds P"),
}};

const Card power_law_yield_card{{
    real("sigy", dimension::stress, 0, at_least(0),
         "first yield; 0: where E e = K e^N; up to 0.02 the strain at first yield, else its stress"),
    vp,
    real("epsf", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none"),
}};

/// Elastic strain at first yield.
double yield_strain(Builder& b, const Row& row, const Row& yield) {
  const double k = row.real("k"), n = row.real("n"), sigy = yield.real("sigy");
  if (sigy > 0.02) return std::pow(sigy / k, 1.0 / n);
  if (sigy > 0.0) return sigy;
  if (n >= 1.0) {
    refuse(b, row, "n", "with an exponent of 1 or more the line E e does not meet the curve K e^N", "give SIGY");
    return 1.0;
  }
  return std::pow(row.real("e") / k, 1.0 / (n - 1.0));
}

void read_power_law(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(power_law_card);
  const Row yield = cursor.read(power_law_yield_card);
  expect_end(b, cursor);
  warn_of_half_a_rate(b, row, "src", "srp");
  kernel::PowerLaw flow{row.real("e"), row.real("pr"), row.real("k"), row.real("n"), yield_strain(b, row, yield)};
  if (row.real("src") > 0.0 && row.real("srp") > 0.0) {
    flow.rate_c = row.real("src");
    flow.rate_p = row.real("srp");
  }
  flow.viscoplastic = yield.real("vp") == 1.0;
  kernel::Composition law{flow};
  law.failure_strain = plastic_strain_at_failure(yield.real("epsf"));
  add_material(b, row, std::move(title), "MAT_POWER_LAW_PLASTICITY", compound(std::move(law)));
}

// ---- 019

const Card rate_dependent_card{{material_id, density, young, poisson, vp}};

const Card rate_dependent_curves_card{{
    id("lc1", IdSpace::function, required, "curve: yield stress over the strain rate"),
    real("etan", dimension::stress, 0, at_least(0), "plastic hardening modulus"),
    integer("lc2", 0, only(0), "curve: Young's modulus over the strain rate"),
    id("lc3", IdSpace::function, 0, "curve: tangent modulus over the strain rate, instead of ETAN"),
    id("lc4", IdSpace::function, 0, "curve: plastic strain at failure over the strain rate"),
    tdel,
    real("rdef", dimension::number, 1, only(1), "what LC4 is: 1 the plastic strain at failure"),
}};

void set_rate_curves(Builder& b, Index material, const Row& main, const Row& row) {
  kernel::RateDependentYield flow;
  flow.E = main.real("e");
  flow.nu = main.real("pr");
  flow.viscoplastic = main.real("vp") == 1.0;
  const Index yield = b.curve(row, "lc1");
  if (yield == none) return;
  const auto curve = [&b](Index c) -> const Curve& { return b.model.curves[static_cast<std::size_t>(c)]; };
  flow.yield = curve(yield);
  for (const double y : flow.yield.y)
    if (!(y > 0.0)) return refuse(b, row, "lc1", "a yield stress is not above 0");
  flow.plastic_modulus = {0, {0.0}, {row.real("etan")}};
  if (const Index tangent = b.curve(row, "lc3"); tangent != none) {
    flow.plastic_modulus = curve(tangent);
    for (double& y : flow.plastic_modulus.y) {
      if (!(y >= 0.0 && y < flow.E)) return refuse(b, row, "lc3", "a tangent modulus is not between 0 and E");
      y = flow.E * y / (flow.E - y);
    }
  }
  kernel::Composition law{flow};
  law.deletion_step = row.real("tdel");
  if (const Index failure = b.curve(row, "lc4"); failure != none) law.failure_strain_over_rate = curve(failure);
  b.model.materials[static_cast<std::size_t>(material)].law = compound(std::move(law));
}

void read_rate_dependent(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const Row row = cursor.read(rate_dependent_card);
  const Row curves = cursor.read(rate_dependent_curves_card);
  expect_end(b, cursor);
  const Index material = add_material(b, row, std::move(title), "MAT_STRAIN_RATE_DEPENDENT_PLASTICITY",
                                      kernel::Elastic{row.real("e"), row.real("pr")});
  b.later(Phase::parts, [=](Builder& later) { set_rate_curves(later, material, row, curves); });
}

// ---- 081, 123

const Card damage_card{{
    material_id,
    density,
    young,
    poisson,
    real("sigy", dimension::stress, 0, at_least(0), "yield stress, unless LCSS or EPS and ES are given"),
    real("etan", dimension::stress, 0, at_least(0), "tangent modulus, below E"),
    real("eppf", dimension::number, 1e12, at_least(0), "plastic strain at which softening begins"),
    tdel,
}};

const Card damage_rate_card{{
    real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect"),
    real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P"),
    id("lcss", IdSpace::function, 0, "yield stress over plastic strain: curve, or table over the strain rate"),
    id("lcsr", IdSpace::function, 0, "curve: factor on the yield stress over the strain rate"),
    real("eppfr", dimension::number, 1e14, at_least(0), "plastic strain at rupture"),
    vp,
    id("lcdm", IdSpace::function, 0, "curve: damage over plastic strain beyond EPPF"),
    numint,
}};

const Card modified_card{{
    material_id,
    density,
    young,
    poisson,
    real("sigy", dimension::stress, 0, at_least(0), "yield stress, unless LCSS or EPS and ES are given"),
    real("etan", dimension::stress, 0, at_least(0), "tangent modulus, below E"),
    real("fail", dimension::number, 0, at_least(0), "plastic strain at failure; 0: none"),
    tdel,
}};

const Card modified_rate_card{{
    real("c", dimension::rate, 0, at_least(0), "Cowper-Symonds C; 0: no rate effect"),
    real("p", dimension::number, 0, at_least(0), "Cowper-Symonds P"),
    id("lcss", IdSpace::function, 0, "yield stress over plastic strain: curve, or table over the strain rate"),
    id("lcsr", IdSpace::function, 0, "curve: factor on the yield stress over the strain rate"),
    vp,
    real("epsthin", dimension::number, 0, at_least(0), "plastic thinning of a layer at failure; 0: none"),
    real("epsmaj", dimension::number, 0, at_least(0), "major strain in the plane at failure; 0: none"),
    numint,
}};

/// The part of a law that MAT_081 and 123 share with MAT_024: yield curves, rates, deletion.
kernel::PiecewiseLinear piecewise_linear(const YieldCards& cards) {
  kernel::PiecewiseLinear flow;
  flow.E = cards.main.real("e");
  flow.nu = cards.main.real("pr");
  if (cards.rate.real("c") > 0.0 && cards.rate.real("p") > 0.0) {
    flow.rate_c = cards.rate.real("c");
    flow.rate_p = cards.rate.real("p");
  }
  flow.vp = static_cast<int>(cards.rate.real("vp"));
  return flow;
}

/// Reads the four cards; `complete` adds to the law what is the keyword's own, once curves are known.
void read_with_curves(Builder& b, const Block& block, const Options& options, std::string_view name, const Card& main,
                      const Card& rate, void (*complete)(Builder&, const YieldCards&, kernel::Composition&)) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  const YieldCards cards{cursor.read(main), cursor.read(rate), cursor.read(yield_strain_card),
                         cursor.read(yield_stress_card), options.contains("LOG_INTERPOLATION")};
  expect_end(b, cursor);
  check_tangent(b, cards.main);
  warn_of_half_a_rate(b, cards.rate, "c", "p");
  const Index material =
      add_material(b, cards.main, std::move(title), name, kernel::Elastic{cards.main.real("e"), cards.main.real("pr")});
  b.later(Phase::parts, [=](Builder& later) {
    kernel::PiecewiseLinear flow = piecewise_linear(cards);
    set_yield_curves(later, cards, flow);
    if (flow.yield.empty()) return;
    kernel::Composition law{flow};
    law.deletion_step = cards.main.real("tdel");
    law.points_to_delete = cards.rate.real("numint");
    complete(later, cards, law);
    later.model.materials[static_cast<std::size_t>(material)].law = compound(std::move(law));
  });
}

void add_damage(Builder& b, const YieldCards& cards, kernel::Composition& law) {
  const double onset = cards.main.real("eppf"), rupture = cards.rate.real("eppfr");
  if (const Index curve = b.curve(cards.rate, "lcdm"); curve != none) {
    if (rupture < 1e12)
      return refuse(b, cards.rate, "lcdm", "a damage curve together with EPPFR is not supported",
                    "give EPPF and LCDM only");
    law.damage =
        kernel::PlasticDamage{onset < 1e12 ? onset : 0.0, 0.0, b.model.curves[static_cast<std::size_t>(curve)]};
  } else if (rupture < 1e12) {
    if (onset < 1e12 && rupture <= onset)
      return refuse(b, cards.rate, "eppfr", "rupture must come after the onset of damage EPPF");
    if (onset < 1e12)
      law.damage = kernel::PlasticDamage{onset, rupture};
    else
      law.failure_strain = rupture;
  } else if (onset < 1e12) {
    cards.main.complain(b.findings, Severity::warning, "eppf", "without EPPFR or LCDM nothing is damaged",
                        "give EPPFR, the plastic strain at rupture");
  }
}

void add_strain_limits(Builder&, const YieldCards& cards, kernel::Composition& law) {
  law.failure_strain = plastic_strain_at_failure(cards.main.real("fail"));
  law.limits = {cards.rate.real("epsthin"), cards.rate.real("epsmaj")};
}

void read_damage(Builder& b, const Block& block, const Options& options) {
  read_with_curves(b, block, options, "MAT_PLASTICITY_WITH_DAMAGE", damage_card, damage_rate_card, add_damage);
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
      {.name = "MAT_JOHNSON_COOK",
       .aliases = {"MAT_015"},
       .options = {"TITLE"},
       .layout = {{"", &johnson_cook_card},
                  {"", &johnson_cook_yield_card},
                  {"", &johnson_cook_heat_card},
                  {"", &johnson_cook_fracture_card}},
       .read = read_johnson_cook},
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
      {.name = "MAT_SIMPLIFIED_JOHNSON_COOK",
       .aliases = {"MAT_098"},
       .options = {"TITLE"},
       .layout = {{"", &simplified_johnson_cook_card}, {"", &simplified_johnson_cook_yield_card}},
       .read = read_simplified_johnson_cook},
      {.name = "MAT_MODIFIED_PIECEWISE_LINEAR_PLASTICITY",
       .aliases = {"MAT_123"},
       .options = {"TITLE", "LOG_INTERPOLATION"},
       .layout = {{"", &modified_card}, {"", &modified_rate_card}, {"", &yield_strain_card}, {"", &yield_stress_card}},
       .read = read_modified},
      {.name = "MAT_PLASTICITY_WITH_DAMAGE_ORTHO",
       .aliases = {"MAT_082"},
       .options = {"TITLE"},
       .verdict = Verdict::refused,
       .why =
           "damage across the crack only is not built; *MAT_PLASTICITY_WITH_DAMAGE (081) damages all directions alike"},
      {.name = "MAT_SIMPLIFIED_JOHNSON_COOK_ORTHOTROPIC_DAMAGE",
       .aliases = {"MAT_099"},
       .options = {"TITLE"},
       .verdict = Verdict::refused,
       .why = "damage by direction is not built; *MAT_SIMPLIFIED_JOHNSON_COOK (098) with PSFAIL comes nearest"},
  };
}

}  // namespace nugget::model
