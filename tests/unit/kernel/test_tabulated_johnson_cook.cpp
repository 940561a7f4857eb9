// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/tabulated_johnson_cook.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// MAT_224: its yield stress over strain, rate and temperature against the formula, its heat and its failure against
// closed forms.
namespace nugget::kernel {
namespace {

/// 400 + 500 p at rest, 100 more at a rate of 1000; a third less at 200 degrees, whatever the strain, and less by 0.4
/// of the hardening.
TabulatedJohnsonCook metal(bool table = true, double heating = 0.5) {
  TabulatedJohnsonCook law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = {Curve{1, {0.0, 1.0}, {400.0, 900.0}}};
  if (table) {
    law.yield.push_back(Curve{2, {0.0, 1.0}, {500.0, 1000.0}});
    law.rates = {0.0, 1000.0};
  }
  law.softening = {3, {0.0, 200.0}, {Curve{4, {0.0, 1.0}, {300.0, 800.0}}, Curve{5, {0.0, 1.0}, {200.0, 500.0}}}};
  law.heating = heating;
  return law;
}
double yield_of(double p, double rate, double strain_before, double rise) {
  const double share = std::min(rise, 200.0) / 200.0, cold = 300.0 + 500.0 * strain_before,
               hot = 200.0 + 300.0 * strain_before;
  return (400.0 + 500.0 * p + 100.0 * std::min(rate, 1000.0) / 1000.0) * (cold + share * (hot - cold)) / cold;
}

// Sabotage: the factor without kt(TR); the temperature of the plastic strain alone; rates of the total strain.
template <class Point>
void expect_yield(const Point& fresh, double dt, const char* what) {
  Point p = fresh;
  p.dt = dt;
  double rise = 0.0;
  for (int k = 0; k < 400; ++k) {
    const double before = p.plastic_strain();
    p.uniaxial(1e-3);
    const double now = p.plastic_strain();
    if (now == before) continue;
    const double expected = yield_of(now, (now - before) / dt, before, rise);
    ASSERT_NEAR(p.effective(), expected, 1e-9 * expected) << what << " " << k;
    rise += 0.5 * expected * (now - before);
    ASSERT_NEAR(p.history[temperature_rise_field], rise, 1e-9 * rise) << what;
  }
  EXPECT_GT(rise, 40.0) << what;
}

TEST(TabulatedJohnsonCook, YieldsByStrainRateAndTemperature) {
  for (const double dt : {1e-2, 3e-6, 1e-7}) {
    expect_yield(LayerPoint<TabulatedJohnsonCook>(metal()), dt, "layer");
    expect_yield(SolidPoint<TabulatedJohnsonCook>(metal()), dt, "solid");
  }
  // Rates by a curve alone have no effect.
  LayerPoint<TabulatedJohnsonCook> a(metal(false)), b(metal(false));
  b.dt = 1e-7;
  for (int k = 0; k < 100; ++k) {
    a.uniaxial(1e-3);
    b.uniaxial(1e-3);
  }
  EXPECT_NEAR(a.s.xx, b.s.xx, 1e-9 * a.s.xx);
  EXPECT_LT(a.s.xx, 400.0 + 500.0 * a.plastic_strain());
}

// A fibre of a beam is heated by the same work.
TEST(TabulatedJohnsonCook, FibresAreHeated) {
  const LawKernel<TabulatedJohnsonCook> law(metal(false));
  std::vector<double> history(8);
  FibreTensor<double> s{};
  double rise = 0.0;
  for (int k = 0; k < 300; ++k) {
    const double before = history[0];
    law.fibre(s, FibreTensor<double>{1e-3, 0.0, 0.0}, 1.0, history.data());
    const double expected = yield_of(history[0], 0.0, before, rise);
    if (history[0] > before) {
      ASSERT_NEAR(s.rr, expected, 1e-9 * expected);
    }
    rise += 0.5 * expected * (history[0] - before);
  }
  EXPECT_NEAR(history[temperature_rise_field], rise, 1e-6);
}

// Without hardening, kt falling by a half over 200 degrees in a straight line: dT = h s dp, s = 500 (1 - T/400).
TEST(TabulatedJohnsonCook, SoftensByItsHeat) {
  TabulatedJohnsonCook law = metal(false, 0.3);
  law.yield = {Curve{1, {0.0, 1.0}, {500.0, 500.0}}};
  law.softening = {3, {0.0, 200.0}, {Curve{4, {0.0}, {2.0}}, Curve{5, {0.0}, {1.0}}}};
  SolidPoint<TabulatedJohnsonCook> p(law);
  for (int k = 0; k < 4000; ++k) p.uniaxial(1e-4);
  EXPECT_NEAR(p.s.xx, 500.0 * std::exp(-500.0 * 0.3 * p.plastic_strain() / 400.0), 0.05);
}

// Failure at 0.4 (1 + T/300), T = h s p: where the sum of dp over it is 1, p = (300/(h s)) (exp(0.4 h s/300) - 1).
// Sabotage: the curve over the plastic strain; the temperature at the start.
TEST(TabulatedJohnsonCook, StrainAtFailureGrowsWithTheTemperature) {
  TabulatedJohnsonCook flow = metal(false, 0.5);
  flow.yield = {Curve{1, {0.0, 1.0}, {500.0, 500.0}}};
  flow.softening = {};
  LawComponents law{flow};
  law.gissmo.emplace();
  law.gissmo->fracture = {0, {0.0}, {Curve{0, {0.0}, {0.4}}}};
  law.gissmo->threshold = 1.0;
  law.gissmo->fading = {0, {0.0}, {Curve{0, {0.0}, {1.0}}}};
  law.gissmo->heat = {0, {0.0, 600.0}, {1.0, 3.0}};
  LayerPoint<ComposedLaw> p(composed_law(law));
  for (int k = 0; k < 20000 && !p.law.failed<double>(p.history.data()); ++k) {
    EXPECT_GE(p.s.xx, k == 0 ? 0.0 : 20.0);
    p.uniaxial(1e-4);
  }
  EXPECT_NEAR(p.plastic_strain(), 300.0 / 250.0 * (std::exp(0.4 * 250.0 / 300.0) - 1.0), 5e-4);
  EXPECT_EQ(p.s.xx, 0.0);
}

// Steps of any size end on the yield surface, at any rate, hot or cold.
TEST(TabulatedJohnsonCook, AnyStepEndsOnTheYieldSurface) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  for (const double yield : {400.0, 1e-3}) {
    for (int trial = 0; trial < 400; ++trial) {
      TabulatedJohnsonCook law = metal(true, trial % 3 == 0 ? 0.0 : 1e-4);
      for (Curve& curve : law.yield)
        for (double& y : curve.y) y *= yield / 400.0;
      law.softening.curve[1].y = {3e-4, 5e-4};  // nothing is left of it
      SolidPoint<TabulatedJohnsonCook> p(law);
      p.dt = std::pow(10.0, -6.0 + 5.0 * chance(engine));
      p.history[temperature_rise_field] = trial % 3 == 0 ? 0.0 : 180.0 + 30.0 * chance(engine);
      for (int k = 0; k < 5; ++k) {
        const double size = std::pow(10.0, -3.0 + 3.0 * chance(engine)), before = p.plastic_strain(),
                     rise = trial % 3 == 0 ? 0.0 : p.history[temperature_rise_field];
        p.strain({size * chance(engine), size * chance(engine), size * chance(engine), size * chance(engine), 0, 0});
        const double now = p.plastic_strain();
        ASSERT_TRUE(std::isfinite(p.effective()));
        if (now == before) continue;
        const double share = std::min(rise, 200.0) / 200.0, cold = 300.0 + 500.0 * std::min(before, 1.0),
                     hot = 3e-4 + 2e-4 * std::min(before, 1.0), factor = (cold + share * (hot - cold)) / cold,
                     rate = (now - before) / p.dt;
        const double expected =
            factor * (yield / 400.0) * (400.0 + 500.0 * now + 100.0 * std::min(rate, 1000.0) / 1000.0);
        const double round_off = 1e-14 * (law.E * size + std::abs(p.s.xx) + std::abs(p.s.yy) + std::abs(p.s.zz));
        ASSERT_NEAR(p.effective(), expected, 1e-8 * expected + round_off) << yield << " " << trial;
      }
    }
  }
}

// A batch gives bit for bit what its lanes give alone.
TEST(TabulatedJohnsonCook, BatchesGiveTheBitsOfTheirLanes) {
  const TabulatedJohnsonCook law = metal();
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  const auto increment = [&](int l) {
    const double size = l == 1 ? 1e-6 : 2e-3;
    return LayerTensor<double>{size * chance(engine), size * chance(engine), size * chance(engine), 0, 0};
  };
  double strain = 0.0;
  expect_bits_of_lanes(
      law, 200, 1e-5, [&](int) { return LayerPoint<TabulatedJohnsonCook>(law); }, increment,
      [&](int l, const auto& p) { strain = l == 0 ? p.plastic_strain() : strain; });
  EXPECT_GT(strain, 0.05);
}

}  // namespace
}  // namespace nugget::kernel
