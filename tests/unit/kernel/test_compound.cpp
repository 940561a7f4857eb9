// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "base/index.hpp"
#include "kernel/law/law_components.hpp"
#include "law_point.hpp"
#include "motion.hpp"

// Laws that are put together at run time, against their formulas worked out plainly in one dimension.
namespace nugget::kernel {
namespace {

constexpr double E = 210000.0, nu = 0.3, G = E / 2.6;

/// Yield stress over plastic strain and its rate.
using Yield = std::function<double(double, double)>;

/// A bar, or a block in shear, that yields where |stress| factor = yield: isotropic hardening in one dimension, each
/// step solved by halving an interval.
struct Bar {
  Yield yield;
  double modulus = E;   ///< of the stress over the strain
  double factor = 1.0;  ///< effective stress over stress: 1, in shear sqrt 3
  double s = 0.0, ep = 0.0;
  double dt = 1.0;

  void strain(double increment) {
    const double trial = s + modulus * increment, most = factor * std::abs(trial);
    // sqrt 3 of plastic shear strain a plastic strain: the stress falls by modulus * factor.
    const auto over = [&](double dep) { return most - factor * factor * modulus * dep - yield(ep + dep, dep / dt); };
    if (over(0.0) <= 0.0) {
      s = trial;
      return;
    }
    double low = 0.0, high = most / (factor * factor * modulus);
    for (int i = 0; i < 200; ++i) (over(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
    ep += low;
    s = std::copysign((most - factor * factor * modulus * low) / factor, trial);
  }
};

/// Strains in steps of 1e-4: to 0.03, back to -0.01, again to 0.05.
void cycle(const std::function<void(double)>& strain) {
  for (const auto& [steps, sign] : {std::pair{300, 1.0}, {400, -1.0}, {600, 1.0}})
    for (int i = 0; i < steps; ++i) strain(sign * 1e-4);
}

/// Layer and solid follow the bar through tension, compression and shear. `gate`: share of the yield stress.
void expect_follows(const std::string& name, const ComposedLaw& law, const Yield& yield, double rate, double gate) {
  const double dt = 1e-4 / rate;
  for (const double sign : {1.0, -1.0}) {
    Bar bar{yield};
    LayerPoint<ComposedLaw> layer(law);
    SolidPoint<ComposedLaw> solid(law);
    bar.dt = layer.dt = solid.dt = dt;
    cycle([&](double e) {
      bar.strain(sign * e);
      layer.uniaxial(sign * e);
      solid.uniaxial(sign * e);
      ASSERT_NEAR(layer.s.xx, bar.s, gate * yield(bar.ep, rate)) << name << ", layer, ep = " << bar.ep;
      ASSERT_NEAR(solid.s.xx, bar.s, gate * yield(bar.ep, rate)) << name << ", solid, ep = " << bar.ep;
    });
    EXPECT_NEAR(layer.plastic_strain(), bar.ep, 1e-4) << name;
    EXPECT_NEAR(solid.plastic_strain(), bar.ep, 1e-4) << name;
    EXPECT_GT(bar.ep, 0.08) << name;
  }
  Bar bar{yield, G, std::sqrt(3.0)};
  LayerPoint<ComposedLaw> layer(law), across(law);
  SolidPoint<ComposedLaw> solid(law);
  bar.dt = layer.dt = across.dt = solid.dt = dt;
  cycle([&](double g) {
    bar.strain(g);
    layer.strain({0, 0, g, 0, 0});
    across.strain({0, 0, 0, 0, g});
    solid.strain({0, 0, 0, 0, 0, g});
    ASSERT_NEAR(layer.s.xy, bar.s, gate * yield(bar.ep, rate)) << name << ", layer in shear";
    ASSERT_NEAR(across.s.yz, bar.s, gate * yield(bar.ep, rate)) << name << ", layer in transverse shear";
    ASSERT_NEAR(solid.s.zx, bar.s, gate * yield(bar.ep, rate)) << name << ", solid in shear";
  });
}

JohnsonCook johnson_cook() {
  JohnsonCook flow;
  flow.E = E;
  flow.nu = nu;
  flow.yield = 300.0;
  flow.hardening = 500.0;
  flow.exponent = 0.3;
  return flow;
}
LawComponents failing(double strain) {
  LawComponents law{johnson_cook()};
  law.failure_strain = strain;
  return law;
}

TEST(ComposedLaw, JohnsonCookWithoutRates) {
  expect_follows(
      "MAT_098", composed_law({johnson_cook()}), [](double ep, double) { return 300.0 + 500.0 * std::pow(ep, 0.3); },
      1.0, 1e-6);
}

TEST(ComposedLaw, JohnsonCookRates) {
  for (const double rate : {0.5, 100.0, 5000.0}) {  // EPSO 2: the first has no effect
    JohnsonCook flow = johnson_cook();
    flow.rate_factor = 0.05;
    flow.reference_rate = 2.0;
    const Yield yield = [](double ep, double r) {
      const double over = std::max(1.0, r / 2.0);
      return (300.0 + 500.0 * std::pow(ep, 0.3)) * (1.0 + 0.05 * std::log(over));
    };
    expect_follows("MAT_098 with rates", composed_law({flow}), yield, rate, 2e-3);
  }
}

TEST(ComposedLaw, JohnsonCookLimits) {
  JohnsonCook flow = johnson_cook();
  flow.static_stress_limit = 420.0;
  expect_follows(
      "SIGMAX", composed_law({flow}),
      [](double ep, double) { return std::min(420.0, 300.0 + 500.0 * std::pow(ep, 0.3)); }, 1.0, 1e-6);
  flow.rate_factor = 0.05;
  flow.saturation = 470.0;
  expect_follows(
      "SIGMAX and SIGSAT", composed_law({flow}),
      [](double ep, double rate) {
        const double hardened = std::min(420.0, 300.0 + 500.0 * std::pow(ep, 0.3));
        return std::min(470.0, hardened * (1.0 + 0.05 * std::log(std::max(1.0, rate))));
      },
      100.0, 5e-3);
}

TEST(ComposedLaw, PowerLaw) {
  // First yield where E e = k e^n.
  const double k = 600.0, n = 0.2, e0 = std::pow(E / k, 1.0 / (n - 1.0));
  EXPECT_NEAR(E * e0, k * std::pow(e0, n), 1e-9 * k);
  PowerLaw flow{E, nu, k, n, e0, 0.0, 1.0};
  expect_follows(
      "MAT_018", composed_law({flow}), [&](double ep, double) { return k * std::pow(e0 + ep, n); }, 1.0, 1e-6);
  flow.rate_c = 40.4;
  flow.rate_p = 5.0;
  expect_follows(
      "MAT_018 with rates", composed_law({flow}),
      [&](double ep, double rate) { return k * std::pow(e0 + ep, n) * (1.0 + std::pow(rate / 40.4, 0.2)); }, 100.0,
      3e-3);
}

TEST(ComposedLaw, Viscoplastic) {
  Viscoplastic flow{E, nu, 250.0, 120.0, 40.0, 200.0, 3.0};
  const auto at_rest = [](double ep) {
    return 250.0 + 120.0 * (1.0 - std::exp(-40.0 * ep)) + 200.0 * (1.0 - std::exp(-3.0 * ep));
  };
  expect_follows(
      "MAT_103", composed_law({flow}), [&](double ep, double) { return at_rest(ep); }, 1.0, 1e-6);
  flow.viscosity = 20.0;
  flow.rate_exponent = 0.25;
  for (const double rate : {0.01, 1.0, 1000.0})
    expect_follows(
        "MAT_103 with VK", composed_law({flow}),
        [&](double ep, double r) { return at_rest(ep) + 20.0 * std::pow(r, 0.25); }, rate, 3e-3);
  flow.hardening_1 = -100.0;  // falls from 250 to 150 and rises again
  flow.viscosity = 0.0;
  expect_follows(
      "MAT_103 that softens", composed_law({flow}),
      [](double ep, double) {
        return 250.0 - 100.0 * (1.0 - std::exp(-40.0 * ep)) + 200.0 * (1.0 - std::exp(-3.0 * ep));
      },
      1.0, 1e-6);
}

TEST(ComposedLaw, StraightYieldCurvesOverTheRate) {
  const Curve yield{0, {0.0, 10.0, 1000.0}, {250.0, 300.0, 400.0}};
  PiecewiseLinear flow;
  flow.E = E;
  flow.nu = nu;
  flow.rates = yield.x;
  for (const double y : yield.y) flow.yield.push_back({0, {0.0, 1.0}, {y, y + 1000.0}});
  for (const double rate : {5.0, 500.0, 5000.0})
    expect_follows(
        "MAT_019", composed_law({flow}), [&](double ep, double r) { return yield.clamped(r) + 1000.0 * ep; }, rate,
        2e-2);
}

TEST(ComposedLaw, LargeStepsKeepTheYieldCondition) {
  Random random;
  LayerPoint<ComposedLaw> layer(composed_law({johnson_cook()}));
  SolidPoint<ComposedLaw> solid(composed_law({johnson_cook()}));
  for (int i = 0; i < 2000; ++i) {
    const double size = i % 7 ? 1e-5 : 0.03, before = layer.plastic_strain(), begun = solid.plastic_strain();
    layer.strain({size * random(), size * random(), size * random(), size * random(), size * random()});
    solid.strain({size * random(), size * random(), size * random(), size * random(), size * random(), 0.0});
    const auto yield = [](double ep) { return 300.0 + 500.0 * std::pow(ep, 0.3); };
    if (layer.plastic_strain() > before) {
      EXPECT_NEAR(layer.effective(), yield(layer.plastic_strain()), 1e-9 * 300.0) << i;
    }
    if (solid.plastic_strain() > begun) {
      EXPECT_NEAR(solid.effective(), yield(solid.plastic_strain()), 1e-9 * 300.0) << i;
    }
  }
  EXPECT_GT(layer.plastic_strain(), 1.0);
  EXPECT_GT(solid.plastic_strain(), 1.0);
}

TEST(ComposedLaw, OtherFlowsAreThoseOfTheirOwnKernels) {
  // Bit for bit the law that stands alone, back stress included.
  const PlasticKinematic alone = mixed(0.4);
  LayerPoint<PlasticKinematic> layer(alone);
  SolidPoint<PlasticKinematic> solid(alone);
  LayerPoint<ComposedLaw> same_layer(composed_law({alone}));
  SolidPoint<ComposedLaw> same_solid(composed_law({alone}));
  Random random;
  for (int i = 0; i < 500; ++i) {
    const double a = 1e-3 * random(), b = 1e-3 * random(), c = 1e-3 * random();
    layer.strain({a, b, c, a, b});
    same_layer.strain({a, b, c, a, b});
    solid.strain({a, b, c, a, b, c});
    same_solid.strain({a, b, c, a, b, c});
    ASSERT_EQ(layer.s.xx, same_layer.s.xx);
    ASSERT_EQ(solid.s.zz, same_solid.s.zz);
  }
  EXPECT_GT(solid.plastic_strain(), 0.01);
}

TEST(ComposedLaw, BatchesDoWhatSinglePointsDo) {
  const ComposedLaw law = composed_law(failing(0.05));
  const LawKernel<ComposedLaw> prepared(law);
  constexpr int width = native_width;
  std::vector<double> history(at(width * prepared.layer_history()));
  LayerTensor<NativeBatch> s;
  std::vector<LayerPoint<ComposedLaw>> single(at(width), LayerPoint<ComposedLaw>(law));
  Random random;
  for (int i = 0; i < 200; ++i) {
    LayerTensor<NativeBatch> rate;
    for (int l = 0; l < width; ++l) {
      const double a = 1e-3 * (l + 1) * random(), b = 1e-3 * random();
      set_lane(rate.xx, l, a);
      set_lane(rate.xy, l, b);
      single[l].strain({a, 0, b, 0, 0});
    }
    prepared.layer(s, rate, 1.0, history.data());
    for (int l = 0; l < width; ++l) {
      const auto& one = single[l];
      ASSERT_EQ(lane(s.xx, l), one.s.xx) << i;
      ASSERT_EQ(lane(s.xy, l), one.s.xy) << i;
      ASSERT_EQ(history[l], one.plastic_strain()) << i;
    }
  }
}

TEST(ComposedLaw, FailedPointsCarryNothing) {
  const ComposedLaw law = composed_law(failing(0.02));
  LayerPoint<ComposedLaw> layer(law);
  SolidPoint<ComposedLaw> solid(law);
  while (layer.plastic_strain() < 0.02) {
    EXPECT_FALSE(layer.law.failed<double>(layer.history.data()));
    layer.uniaxial(1e-4);
    solid.uniaxial(1e-4);
  }
  solid.uniaxial(1e-4);
  EXPECT_TRUE(layer.law.failed<double>(layer.history.data()));
  EXPECT_TRUE(solid.law.failed<double>(solid.history.data()));
  layer.strain({1e-3, 0, 0, 0, 0});
  solid.strain({1e-3, 0, 0, 0, 0, 0});
  EXPECT_EQ(layer.effective(), 0.0);
  EXPECT_EQ(solid.s.xx, 0.0);
}

}  // namespace
}  // namespace nugget::kernel
