// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/failure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// The failure functions of MAT_100 against numbers worked from their formulas (docs/theory/failure.md)
// outside of this program.
namespace nugget::weld {
namespace {

using failure::Geometry;
using failure::Load;
using failure::Value;
using model::RateValue;
using model::WeldLaw;

Load load(const Resultants& r, double rate = 0.0, double time = 0.0) {
  return {r, rate, time};
}
double value(failure::Function& f, const Resultants& r, double rate = 0.0) {
  return f(load(r, rate)).value;
}

/// 1 at rate 0, 2 at 100.
Curve doubling() {
  return {0, {0.0, 100.0}, {1.0, 2.0}};
}

// ---- OPT 0

WeldLaw resultant_law() {
  WeldLaw law;
  const double s[6] = {8000, 6000, 6000, 9000, 7000, 7000};
  for (std::size_t i = 0; i < 6; ++i) law.strength[i].value = s[i];
  return law;
}

TEST(ResultantSurface, TermsAddUpAndCompressionDoesNotCount) {
  const auto f = failure::resultant_surface(resultant_law());
  EXPECT_NEAR(value(*f, {4000, 3000, 0, 4000, 3000, 0}), 0.25 + 0.25 + 0.197530864 + 0.183673469, 1e-8);
  EXPECT_DOUBLE_EQ(value(*f, {-80000}), 0.0);
  EXPECT_NEAR(value(*f, {0, 0, 3000, 0, 0, -7000}), 1.25, 1e-12);
  const Value v = (*f)(load({4000, 3000, 3000, 4000, 3000, 0}));
  EXPECT_EQ(v.largest(), FailureMode::shear);
  EXPECT_EQ(v.terms, 4);
}

TEST(ResultantSurface, AStrengthOf0LeavesItsTermOut) {
  WeldLaw law;
  law.strength[0].value = 8000;
  const auto f = failure::resultant_surface(law);
  EXPECT_DOUBLE_EQ(value(*f, {4000, 1e6, 1e6, 1e6, 1e6, 1e6}), 0.25);
}

TEST(ResultantSurface, StrengthsFollowTheStrainRate) {
  WeldLaw law;
  law.strength[0] = {1.0, {0, {0.0, 100.0}, {8000.0, 16000.0}}};  // as a curve of forces
  law.strength[1] = {6000.0, {}};
  const auto f = failure::resultant_surface(law);
  EXPECT_DOUBLE_EQ(value(*f, {8000}, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(value(*f, {12000}, 50.0), 1.0);
  EXPECT_DOUBLE_EQ(value(*f, {16000}, 1e9), 1.0);  // the end value holds
  EXPECT_DOUBLE_EQ(value(*f, {0, 6000}, 1e9), 1.0);
}

// ---- OPT 1, 6, 7

TEST(BeamStress, FourResultantsTogether) {
  const auto f = failure::beam_stress({320.0, {}}, {190.0, {}}, failure::disc(6.0));
  const Value v = (*f)(load({4000, 2500, 0, 2000, 3000, 0}));
  EXPECT_NEAR(v.value, 1.29097, 2e-5);
  EXPECT_EQ(v.largest(), FailureMode::normal_stress);
}

// docs/theory/weld.md#reference-values.
TEST(BeamStress, FailureLoadsOfA5mmWeld) {
  const auto f = failure::beam_stress({500.0, {}}, {300.0, {}}, failure::disc(5.0));
  EXPECT_NEAR(value(*f, {9817.5}), 1.0, 1e-4);
  EXPECT_NEAR(value(*f, {0, 5890.5}), 1.0, 1e-4);
  EXPECT_NEAR(value(*f, {0, 0, 0, 0, 0, 6135.9}), 1.0, 1e-4);
  EXPECT_NEAR(value(*f, {0, 0, 0, -7363.1}), 1.0, 1e-4);
}

TEST(BeamStress, CompressionRelievesBending) {
  const auto f = failure::beam_stress({500.0, {}}, {0.0, {}}, failure::disc(5.0));
  EXPECT_DOUBLE_EQ(value(*f, {-9817.5, 1e5, 0, 1e5, 3000}), 0.0);
  EXPECT_NEAR(value(*f, {-4908.739, 0, 0, 0, 6135.923}), 0.25, 1e-6);  // 500 - 250 MPa
}

TEST(BeamStress, RingHasItsOwnModulus) {
  Geometry ring = failure::disc(5.0);
  ring.area = 12.0;
  ring.section_modulus = 10.0;
  const auto f = failure::beam_stress({500.0, {}}, {300.0, {}}, ring);
  EXPECT_NEAR(value(*f, {3000, 0, 0, 0, 2500}), 1.0, 1e-12);  // 250 + 250
  EXPECT_NEAR(value(*f, {0, 1800, 0, 3000}), 1.0, 1e-12);     // 150 + 150
}

TEST(BeamStress, FactorsFollowTheStrainRate) {
  const auto f = failure::beam_stress({500.0, doubling()}, {300.0, {}}, failure::disc(5.0));
  EXPECT_NEAR(value(*f, {9817.477}, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(value(*f, {9817.477}, 50.0), 1.0 / 2.25, 1e-6);
  EXPECT_NEAR(value(*f, {9817.477}, 1000.0), 0.25, 1e-6);
}

TEST(SheetStress, TheWeakerSheetCountsWithItsOwnRateFactor) {
  // Sheet 1: 500 MPa, C = 100, P = 2: at rate 25 the factor is 1.5. Sheet 2: 600 MPa without a rate effect.
  const auto f = failure::sheet_stress({{{500.0, 300.0, 100.0, 2.0}, {600.0, 0.0}}}, failure::disc(5.0));
  const double n = 9817.477;  // 500 MPa
  EXPECT_NEAR(value(*f, {n}, 0.0), 1.0, 1e-6);
  EXPECT_NEAR(value(*f, {n}, 25.0), std::pow(500.0 / 600.0, 2), 1e-6);  // now sheet 2, as 750 > 600
  EXPECT_NEAR(value(*f, {0, 5890.486}, 25.0), std::pow(1.0 / 1.5, 2), 1e-6);
}

// ---- OPT 3, 4

WeldLaw notch_law(int option, double limit) {
  WeldLaw law;
  law.option = option;
  law.limit = limit;
  law.notch_radius = 0.25;
  return law;
}

TEST(NotchStress, ZhangsCoefficients) {
  const auto f = failure::notch_stress(notch_law(3, 1000.0), 5.0, 1.0);
  EXPECT_NEAR(value(*f, {0, 600, 800}), 0.4734191363, 1e-9);
  EXPECT_NEAR(value(*f, {0, 0, 0, 0, 600, 800}), 0.8796582953, 1e-9);
  EXPECT_NEAR(value(*f, {1000}), 0.3895623068, 1e-9);
  EXPECT_NEAR(value(*f, {1000, 600, 800, 0, 600, 800}), 0.4734191363 + 0.8796582953 + 0.3895623068, 1e-9);
  EXPECT_DOUBLE_EQ(value(*f, {-1000, 0, 0, 1e6}), 0.0);
}

TEST(NotchStress, FactorsScaleTheirTerms) {
  WeldLaw law = notch_law(3, 1000.0);
  law.alpha = {2.0, 3.0, 4.0};
  const auto f = failure::notch_stress(law, 5.0, 1.0);
  EXPECT_NEAR(value(*f, {1000, 600, 800, 0, 600, 800}), 2 * 0.4734191363 + 3 * 0.8796582953 + 4 * 0.3895623068, 1e-9);
}

TEST(NotchStress, StressIntensities) {
  const auto f = failure::notch_stress(notch_law(4, 100.0), 5.0, 1.0);
  EXPECT_NEAR(value(*f, {0, 1000}), 1.387480626, 1e-9);
  EXPECT_NEAR(value(*f, {0, 0, 0, 0, 1000}), 2.205315582, 1e-9);
  EXPECT_NEAR(value(*f, {1000}), 1.500527194, 1e-9);
  const Value v = (*f)(load({800, 1000, 0, 0, 500}));
  EXPECT_NEAR(v.value, 3.125505797, 1e-9);
  EXPECT_NEAR(v.term[0].value + v.term[1].value + v.term[2].value, v.value, 1e-12);
}

// ---- OPT 5

TEST(StructuralStress, SingleLoads) {
  const auto f = failure::structural_stress(5.0, {1.0, 2.0}, 100.0);
  const auto at = [&](const Resultants& r, std::size_t i) { return (*f)(load(r)).term[i].value; };
  EXPECT_NEAR(at({1000}, 0), 17.44, 1e-9);
  EXPECT_NEAR(at({1000}, 1), 4.36, 1e-9);
  EXPECT_NEAR(at({1000}, 2), 0.5092958, 1e-6);
  EXPECT_NEAR(at({0, 1000}, 0), 0.6366198, 1e-6);
  EXPECT_NEAR(at({0, 1000}, 1), 0.3183099, 1e-6);
  EXPECT_NEAR(at({0, 1000}, 2), 0.6790611, 1e-6);  // first principal stress of pure shear
  EXPECT_NEAR(at({0, 0, 0, 0, 0, 1000}, 0), 3.744, 1e-9);
  EXPECT_NEAR(at({0, 0, 0, 0, 0, 1000}, 2), 0.8148733, 1e-6);
  EXPECT_DOUBLE_EQ(value(*f, {-1000}), 0.0);
}

TEST(StructuralStress, LargestOverAllAngles) {
  const auto f = failure::structural_stress(5.0, {1.0, 2.0}, 100.0);
  const Value v = (*f)(load({800, 1000, -400, 0, 500, -300}));  // against 360,000 angles, by a script
  EXPECT_NEAR(v.term[0].value, 16.13360300, 1e-7);
  EXPECT_NEAR(v.term[1].value, 4.17719723, 1e-7);  // with the resultants in the axes of sheet 2
  EXPECT_NEAR(v.term[2].value, 1.20830556, 1e-6);
  EXPECT_DOUBLE_EQ(v.value, v.term[0].value);
  EXPECT_EQ(v.largest(), FailureMode::sheet_1);
}

// Sabotage: both sheets with the signs of sheet 1.
TEST(StructuralStress, WhichEndIsTheFirstAndHowTheAxesLieMakesNoDifferenceToSheets) {
  const Resultants r{300, 1000, -400, 0, 500, -2300};
  const Value v = (*failure::structural_stress(5.0, {1.0, 2.0}, 100.0))(load(r));
  // the other way round: r' = -r, s' = s, t' = -t, and the part beyond the section is the other one
  const Value other = (*failure::structural_stress(5.0, {2.0, 1.0}, 100.0))(load({300, -1000, -400, 0, -500, -2300}));
  EXPECT_NEAR(other.term[1].value, v.term[0].value, 1e-12);
  EXPECT_NEAR(other.term[0].value, v.term[1].value, 1e-12);
  for (const double angle : {0.3, 1.0, 2.5}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Resultants turned{300, c * r.shear_s + s * r.shear_t,   c * r.shear_t - s * r.shear_s,
                            0,   c * r.moment_s + s * r.moment_t, c * r.moment_t - s * r.moment_s};
    const Value w = (*failure::structural_stress(5.0, {1.0, 2.0}, 100.0))(load(turned));
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(w.term[i].value, v.term[i].value, 1e-6) << angle << " " << i;
  }
}

// A strip of the sheet is pulled at its middle by a force that acts in the face between the sheets, h/2 above it: the
// side that the force leaves is stretched, and bent open on that face, in either sheet.
TEST(StructuralStress, ALeverOpensTheFaceBetweenTheSheetsInBoth) {
  const double force = 1000, lever = 0.75, d = 5.0;
  const double stress = force / (std::numbers::pi * d) + 1.872 * force * lever / d;  // t = 1
  const auto f = failure::structural_stress(d, {1.0, 1.0}, 1.0);
  EXPECT_NEAR((*f)(load({0, force, 0, 0, 0, force * lever})).term[0].value, stress, 1e-9);
  EXPECT_NEAR((*f)(load({0, force, 0, 0, 0, -force * lever})).term[1].value, stress, 1e-9);
}

// ---- OPT 10

model::LoadRateStrengths load_rate_table() {
  model::LoadRateStrengths t;
  t.dynamic = {1.183, 0.002963, 0.0458, 0.1};
  return t;
}

TEST(LoadRateStress, StaticStrengthsOverDiameterTimesThickness) {
  const auto table = load_rate_table();
  const auto f = failure::load_rate_stress(table, 400.0, 300.0, 6.0, 1.5);
  EXPECT_NEAR(value(*f, {1800, 0, 1350}), 0.25 + 0.25, 1e-12);
  EXPECT_DOUBLE_EQ(value(*f, {-1800}), 0.0);
}

TEST(LoadRateStress, RateOfTheForceRaisesThem) {
  const auto table = load_rate_table();
  const auto f = failure::load_rate_stress(table, 400.0, 300.0, 6.0, 1.5);
  (*f)(load({3500}, 0.0, 1.0));
  const Value v = (*f)(load({3600}, 0.0, 2.0));  // rate 100, x = 1000: factor 4.462375
  EXPECT_NEAR(v.value, std::pow(1.0 / 4.462375192, 2), 1e-9);
  const Value slow = (*f)(load({3600.0 + 1e-9}, 0.0, 3.0));  // the factor is never below 1
  EXPECT_NEAR(slow.value, 1.0, 1e-9);
}

TEST(LoadRateStress, RatesAreAveragedOverNavgCycles) {
  auto table = load_rate_table();
  table.averaged = 4;
  const auto f = failure::load_rate_stress(table, 400.0, 300.0, 6.0, 1.5);
  const double force[5] = {3200, 3500, 3400, 3700, 3600};  // in the mean 100 a second over the last four
  Value v;
  for (int i = 0; i < 5; ++i) v = (*f)(load({force[i]}, 0.0, 1.0 + i));
  EXPECT_NEAR(v.value, std::pow(1.0 / 4.462375192, 2), 1e-9);
}

// ---- OPT 11

TEST(Direction, ForceAllowedAtItsAngle) {
  WeldLaw law;
  law.tension = {1, {0.0, 10.0}, {{0, {0.0, 90.0}, {6000.0, 8000.0}}, {0, {0.0, 90.0}, {12000.0, 16000.0}}}};
  const auto f = failure::direction(law);
  EXPECT_NEAR(value(*f, {0, 3000, 0}), 0.5, 1e-12);
  EXPECT_NEAR(value(*f, {8000}), 1.0, 1e-12);
  EXPECT_NEAR(value(*f, {3500, 3500}), std::sqrt(2.0) * 3500 / 7000, 1e-12);
  EXPECT_NEAR(value(*f, {8000}, 5.0), 8000.0 / 12000.0, 1e-12);
  EXPECT_NEAR(value(*f, {8000}, 1e3), 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(value(*f, {-8000, 8000}), 0.0);  // no curve for compression
  law.compression = {1, {0.0}, {{0, {0.0, 90.0}, {6000.0, 60000.0}}}};
  const Value v = (*failure::direction(law))(load({-6000}));
  EXPECT_NEAR(v.value, 0.1, 1e-12);
  EXPECT_EQ(v.largest(), FailureMode::compression);
}

// ---- which function a weld gets

TEST(MakeFunction, ThePairOfPartsInEitherOrder) {
  model::Model m;
  m.parts.resize(3);
  WeldLaw law;
  law.option = 7;
  law.table = 0;
  m.pair_strengths.push_back({1, {{-1, -1}, {100.0, {}}, {}}, {{{1, 2}, {200.0, {}}, {}}}, {}});
  Findings findings;
  const auto tension = [&](int i, int j) {
    Geometry g = failure::disc(5.0);
    g.sheet = {i, j};
    return value(*failure::make_function(m, law, g, {}, findings), {1963.495});  // 100 MPa
  };
  EXPECT_NEAR(tension(1, 2), 0.25, 1e-6);
  EXPECT_NEAR(tension(2, 1), 0.25, 1e-6);
  EXPECT_NEAR(tension(0, 2), 1.0, 1e-6);
}

TEST(MakeFunction, SheetsOfOpt10ByMaterialAndTheLowerStrengthCounts) {
  model::Model m;
  m.parts.resize(2);
  m.parts[0].material = 0;
  m.parts[1].material = 1;
  m.materials.resize(2);
  m.materials[0].id = 1;
  m.materials[1].id = 2;
  model::LoadRateStrengths table = load_rate_table();
  table.normal = 500.0;
  table.entries.push_back({0, {-1, -1}, 400.0, 0.0});
  table.thickness_scale = 0.5;
  WeldLaw law;
  law.option = 10;
  law.table = 0;
  Geometry g = failure::disc(6.0);
  g.sheet = {0, 1};
  g.thickness = {1.0, 2.0};
  Findings findings;
  const double force = 400.0 * 6.0 * 0.5;
  for (const auto& [rule, thickness] : {std::pair{0, 1.0}, {1, 1.5}, {2, 2.0}, {3, 3.0}}) {
    table.thickness_rule = rule;
    m.load_rate_strengths = {table};
    EXPECT_NEAR(value(*failure::make_function(m, law, g, {}, findings), {force * thickness}), 1.0, 1e-12) << rule;
  }
  g.thickness = {};
  failure::make_function(m, law, g, {}, findings);
  EXPECT_EQ(findings.warnings(), 1);
}

TEST(MakeFunction, WhatIsMissingIsSaid) {
  model::Model m;
  m.parts.resize(1);
  Findings findings;
  Geometry g = failure::disc(5.0);
  for (const int option : {3, 4, 5}) {
    WeldLaw law = notch_law(option, 1000.0);
    EXPECT_DOUBLE_EQ(value(*failure::make_function(m, law, g, {}, findings), {0, 0, 0, 0, 1000}),
                     option == 5 ? 0.08148733086305042 : 0.0);
  }
  EXPECT_EQ(findings.warnings(), 3);
  g.thickness = {2.0, 1.0};  // OPT 3: the thinner sheet's, where ZT is not given
  EXPECT_NEAR(value(*failure::make_function(m, notch_law(3, 1000.0), g, {}, findings), {1000}), 0.3895623068, 1e-9);
  WeldLaw law;
  law.option = 6;
  m.rupture_stresses.push_back({0, 500.0, 300.0});
  failure::make_function(m, law, g, {}, findings);
  EXPECT_EQ(findings.warnings(), 4);
  g.sheet = {0, -1};
  EXPECT_NEAR(value(*failure::make_function(m, law, g, {}, findings), {9817.477}), 1.0, 1e-6);
  EXPECT_EQ(findings.warnings(), 4);
}

// ---- history

History history(const WeldLaw& law) {
  return {law, failure::resultant_surface(law)};
}

TEST(WeldHistory, FailsOnceAndRemembersItsLastLoad) {
  const WeldLaw law = resultant_law();
  History h = history(law);
  EXPECT_FALSE(h.update(load({4000}, 1.0, 1.0)));
  EXPECT_TRUE(h.update(load({8100, 600}, 2.0, 2.0)));
  EXPECT_FALSE(h.update(load({9000}, 3.0, 3.0)));
  EXPECT_EQ(h.mode(), FailureMode::axial);
  EXPECT_DOUBLE_EQ(h.failure_time(), 2.0);
  EXPECT_DOUBLE_EQ(h.resultants().axial, 0.0);
  EXPECT_DOUBLE_EQ(h.last_load().resultants.axial, 8100.0);
  EXPECT_DOUBLE_EQ(h.last_load().rate, 2.0);
  EXPECT_NEAR(h.last_value().term[1].value, 0.01, 1e-12);
  EXPECT_DOUBLE_EQ(h.peak_failure_time(), 2.0);
}

TEST(WeldHistory, OptMinus1AndMinus2TellTheValueAndHold) {
  for (const int option : {-1, -2}) {
    WeldLaw law = resultant_law();
    law.option = option;
    History h = history(law);
    EXPECT_FALSE(h.update(load({16000}, 0.0, 1.0)));
    EXPECT_FALSE(h.update(load({4000}, 0.0, 2.0)));
    EXPECT_DOUBLE_EQ(h.failure_value(), 0.25);
    EXPECT_DOUBLE_EQ(h.peak_failure_value(), 4.0);
    EXPECT_DOUBLE_EQ(h.peak_failure_time(), 1.0);
  }
}

TEST(WeldHistory, Opt6WantsCyclesOnEnd) {
  WeldLaw law = resultant_law();
  law.option = 6;
  law.cycles = 3;
  History h = history(law);
  for (const double force : {9000.0, 9000.0, 7000.0, 9000.0, 9000.0}) EXPECT_FALSE(h.update(load({force})));
  EXPECT_TRUE(h.update(load({9000})));
}

// At the start the mean is that of the fewer values that there are. Sabotage to be caught: their sum over NF.
TEST(WeldHistory, FilterTakesResultantsAndRateAlike) {
  WeldLaw law = resultant_law();
  law.filter = 3;
  History h = history(law);
  h.update(load({300, 600}, 300));
  EXPECT_DOUBLE_EQ(h.resultants().axial, 300.0);
  h.update(load({600, 1200}, 600));
  EXPECT_DOUBLE_EQ(h.resultants().axial, 450.0);
  EXPECT_DOUBLE_EQ(h.strain_rate(), 450.0);
  for (const double v : {1200.0, 2400.0}) h.update(load({v, 2 * v}, v));
  EXPECT_DOUBLE_EQ(h.resultants().axial, 1400.0);
  EXPECT_DOUBLE_EQ(h.resultants().shear_s, 2800.0);
  EXPECT_DOUBLE_EQ(h.strain_rate(), 1400.0);
}

}  // namespace
}  // namespace nugget::weld
