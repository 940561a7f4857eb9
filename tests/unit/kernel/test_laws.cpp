// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <functional>

#include "law_point.hpp"
#include "motion.hpp"

namespace nugget::kernel {
namespace {

constexpr double E = steel_E;

TEST(Laws, UniaxialBilinear) {
  // sigma = Y + Et (e - Y / E) after yield, to round-off: hardening is linear.
  const double Y = 250.0, H = 1000.0, Et = E * H / (E + H);
  LayerPoint<PiecewiseLinear> p(bilinear(Y, H));
  for (int i = 1; i <= 100; ++i) {
    p.uniaxial(1e-4);
    const double e = i * 1e-4, expected = e < Y / E ? E * e : Y + Et * (e - Y / E);
    EXPECT_NEAR(p.s.xx, expected, 2e-6 * Y) << i;
    EXPECT_NEAR(p.plastic_strain(), e < Y / E ? 0.0 : e - p.s.xx / E, 1e-8);
  }
}

TEST(Laws, ThicknessStrainKeepsPlasticVolume) {
  LayerPoint<PiecewiseLinear> p(bilinear(250.0, 0.0));
  for (int i = 0; i < 50; ++i) p.uniaxial(1e-4);
  EXPECT_NEAR(p.thickness.total, -0.5e-4, 1e-9);  // incompressible flow
  EXPECT_NEAR(p.thickness.plastic, -0.5e-4, 1e-9);
  LayerPoint<PiecewiseLinear> q(bilinear(250.0, 0.0));
  q.uniaxial(1e-4);
  EXPECT_NEAR(q.thickness.total, -0.3e-4, 1e-12);
  EXPECT_EQ(q.thickness.plastic, 0.0);
}

TEST(Laws, CyclesOfMixedHardening) {
  // MAT_003: after tension to plastic strain ep the stress is Y + H' ep for any beta; reversed yield comes 2 (Y + beta
  // H' ep) below.
  const double Y = 300.0, H = E * 2000.0 / (E - 2000.0);
  for (const double beta : {0.0, 0.4, 1.0}) {
    LayerPoint<PlasticKinematic> p(mixed(beta));
    while (p.plastic_strain() < 0.02) p.uniaxial(2e-5);
    const double top = p.s.xx, ep = p.plastic_strain();
    EXPECT_NEAR(top, Y + H * ep, 1e-6 * Y);
    while (p.plastic_strain() == ep) p.uniaxial(-2e-6);
    EXPECT_NEAR(p.s.xx, top - 2 * (Y + beta * H * ep), 0.5) << beta;
    SolidPoint<PlasticKinematic> q(mixed(beta));  // the same in shear: tau = (Y + H' ep) / sqrt 3
    while (q.plastic_strain() < 0.02) q.strain({0, 0, 0, 2e-5, 0, 0});
    const double tau = q.s.xy, sp = q.plastic_strain();
    EXPECT_NEAR(tau, (Y + H * sp) / std::sqrt(3.0), 1e-9 * Y);
    while (q.plastic_strain() == sp) q.strain({0, 0, 0, -2e-6, 0, 0});
    EXPECT_NEAR(q.s.xy, tau - 2 * (Y + beta * H * sp) / std::sqrt(3.0), 0.2) << beta;
    LayerPoint<PlasticKinematic> r(mixed(beta));  // and in a layer's transverse shear
    while (r.plastic_strain() < 0.02) r.strain({0, 0, 0, 0, 2e-5});
    EXPECT_NEAR(r.s.yz, (Y + H * r.plastic_strain()) / std::sqrt(3.0), 1e-9 * Y);
  }
}

TEST(Laws, YieldConditionHoldsInALayer) {
  Random random;
  const auto curve = curved().yield[0];
  LayerPoint<PiecewiseLinear> p(curved());
  LayerPoint<PlasticKinematic> q(mixed(0.3));
  const double H = E * 2000.0 / (E - 2000.0);
  int plastic = 0;
  for (int i = 0; i < 3000; ++i) {
    const double size = i % 10 ? 1e-4 : 0.03;  // small steps, and some that cross points of the curve
    const LayerTensor<double> step{size * random(), size * random(), size * random(), size * random(), size * random()};
    const double ep = p.plastic_strain(), eq = q.plastic_strain();
    p.strain(step);
    q.strain(step);
    const double yield = curve.extrapolated(p.plastic_strain());
    EXPECT_LE(p.effective(), yield * (1 + 1e-10));
    if (p.plastic_strain() > ep) {
      EXPECT_NEAR(p.effective(), yield, 1e-10 * yield);
      ++plastic;
    }
    const LayerTensor<double> back = load_layer<double>(q.history.data() + 1);
    if (q.plastic_strain() > eq) {
      EXPECT_NEAR(q.effective(back), 300.0 + 0.3 * H * q.plastic_strain(), 1e-7);
    }
  }
  EXPECT_GT(plastic, 1000);
}

TEST(Laws, YieldConditionHoldsInASolid) {
  Random random;
  const auto curve = curved().yield[0];
  SolidPoint<PiecewiseLinear> p(curved());
  int plastic = 0;
  for (int i = 0; i < 2000; ++i) {
    const double size = i % 10 ? 1e-4 : 0.02, ep = p.plastic_strain();
    p.strain({size * random(), size * random(), size * random(), size * random(), size * random(), size * random()});
    const double yield = curve.extrapolated(p.plastic_strain());
    if (p.plastic_strain() > ep) {
      EXPECT_NEAR(p.effective(), yield, 1e-10 * yield);
      ++plastic;
    }
  }
  EXPECT_GT(plastic, 500);
}

TEST(Laws, PlaneStressAgreesWithTheSolid) {
  // The layer's return is that of a solid whose zz stress is held at zero.
  Random random;
  LayerPoint<PiecewiseLinear> layer(curved());
  SolidPoint<PiecewiseLinear> solid(curved());
  for (int i = 0; i < 100; ++i) {
    const double x = 2e-4 * random() + 2e-4, y = 2e-4 * random(), g = 3e-4 * random();
    layer.strain({x, y, g, 0, 0});
    const auto normal_stress = [&](double zz) {
      SolidPoint<PiecewiseLinear> copy = solid;
      copy.strain({x, y, zz, g, 0, 0});
      return copy.s.zz;
    };
    double a = 0.0, b = -(x + y), fa = normal_stress(a), fb = normal_stress(b);
    for (int k = 0; k < 60 && std::abs(fb) > 1e-9 && fa != fb; ++k) {
      const double c = b - fb * (b - a) / (fb - fa);
      a = b, fa = fb;
      b = c, fb = normal_stress(c);
    }
    solid.strain({x, y, b, g, 0, 0});
    EXPECT_NEAR(layer.s.xx, solid.s.xx, 1e-5);
    EXPECT_NEAR(layer.s.yy, solid.s.yy, 1e-5);
    EXPECT_NEAR(layer.s.xy, solid.s.xy, 1e-5);
    EXPECT_NEAR(layer.plastic_strain(), solid.plastic_strain(), 1e-9);
    EXPECT_NEAR(layer.thickness.total, b, 1e-10);
  }
  EXPECT_GT(layer.plastic_strain(), 0.005);
}

TEST(Laws, CowperSymonds) {  // rate 100 1/s, C = 40.4, P = 5: factor 2.19874
  PiecewiseLinear law = bilinear(250.0, 0.0);
  law.rate_c = 40.4;
  law.rate_p = 5.0;
  const PlasticKinematic kinematic{E, steel_nu, 250.0, 0.0, 1.0, 40.4, 5.0, 0.0};
  LayerPoint<PiecewiseLinear> p(law);
  LayerPoint<PlasticKinematic> k(kinematic);
  SolidPoint<PiecewiseLinear> q(law);
  p.dt = q.dt = k.dt = 1e-6;
  for (int i = 0; i < 100; ++i) {
    p.uniaxial(1e-4);
    k.uniaxial(1e-4);
    q.strain({1e-4, -0.5e-4, -0.5e-4, 0, 0, 0});
  }
  EXPECT_NEAR(p.s.xx, 250.0 * 2.19874, 0.001 * 250.0 * 2.2);
  EXPECT_NEAR(k.s.xx, 250.0 * 2.19874, 0.001 * 250.0 * 2.2);
  EXPECT_NEAR(q.effective(), 250.0 * 2.19874, 0.001 * 250.0 * 2.2);
}

TEST(Laws, RateTable) {
  for (const bool logarithmic : {false, true}) {
    PiecewiseLinear law = bilinear(200.0, 100.0);
    law.yield.push_back(Curve{0, {0.0, 0.1, 1.0}, {300.0, 310.0, 400.0}});
    law.yield.push_back(Curve{0, {0.0, 1.0}, {500.0, 600.0}});
    law.rates = {1.0, 100.0, 1000.0};
    law.log_rates = logarithmic;
    const auto flow = [&](double rate) {
      SolidPoint<PiecewiseLinear> p(law);
      p.dt = 1e-5 / rate;
      while (p.plastic_strain() < 0.05) p.strain({1e-5, -0.5e-5, -0.5e-5, 0, 0, 0});
      return p.effective();
    };
    EXPECT_NEAR(flow(0.1), 205.0, 0.3);
    EXPECT_NEAR(flow(1.0), 205.0, 0.3);
    EXPECT_NEAR(flow(10.0), logarithmic ? 255.0 : 205.0 + 100.0 * 9 / 99, 0.5);
    EXPECT_NEAR(flow(100.0), 305.0, 0.5);
    EXPECT_NEAR(flow(1000.0), 505.0, 0.5);
    EXPECT_NEAR(flow(5000.0), 505.0, 0.5);
  }
}

TEST(Laws, RateScaleCurve) {
  PiecewiseLinear law = bilinear(200.0, 0.0);
  law.rate_scale = Curve{0, {0.0, 10.0, 1000.0}, {1.0, 1.2, 2.0}};
  SolidPoint<PiecewiseLinear> p(law);
  p.dt = 1e-5 / 10.0;
  for (int i = 0; i < 1000; ++i) p.strain({1e-5, -0.5e-5, -0.5e-5, 0, 0, 0});
  EXPECT_NEAR(p.effective(), 240.0, 0.1);
}

TEST(Laws, YieldCurves) {
  const YieldCurve many(curved().yield[0]);
  const Curve curve = curved().yield[0];
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const double e = std::abs(random()) * (i % 2 ? 1.3 : 0.02);
    const YieldCurve::Piece p = many.at(e);
    EXPECT_GE(e, p.x);
    EXPECT_LT(e, p.end);
    EXPECT_NEAR(p.y + p.slope * (e - p.x), curve.extrapolated(e), 1e-10);
  }
  for (const double e : curve.x)
    EXPECT_NEAR(many.at(e).y + many.at(e).slope * (e - many.at(e).x), curve.clamped(e), 1e-10);
  const YieldCurve late(Curve{0, {0.1, 0.2}, {100.0, 200.0}});  // its first ordinate holds before the start
  EXPECT_EQ(late.at(0.05).y, 100.0);
  EXPECT_EQ(late.at(0.05).slope, 0.0);
  const YieldCurve softening(Curve{0, {0.0, 0.1}, {200.0, 100.0}});  // never below its last ordinate
  EXPECT_EQ(softening.at(0.5).y, 100.0);
  EXPECT_EQ(softening.at(0.5).slope, 0.0);
  EXPECT_EQ(softening.lowest(), 100.0);
  const YieldCurve constant(Curve{0, {0.0}, {123.0}});
  EXPECT_EQ(constant.at(5.0).y, 123.0);
}

TEST(Laws, SofteningIsFollowed) {
  PiecewiseLinear law = bilinear(0, 0);
  law.yield = {Curve{0, {0.0, 0.01, 0.03}, {200.0, 250.0, 120.0}}};
  SolidPoint<PiecewiseLinear> p(law);
  for (int i = 0; i < 500; ++i) p.strain({1e-4, -0.5e-4, -0.5e-4, 0, 0, 0});
  EXPECT_NEAR(p.effective(), 120.0, 1e-7);
}

TEST(Laws, FailedPointsCarryNothing) {
  PiecewiseLinear law = bilinear(250.0, 0.0);
  law.failure_strain = 0.01;
  LayerPoint<PiecewiseLinear> p(law);
  while (p.plastic_strain() < 0.01) p.uniaxial(1e-4);
  EXPECT_TRUE(p.law.failed<double>(p.history.data()));
  EXPECT_EQ(p.effective(), 0.0);
  p.strain({1e-3, 0, 0, 0, 0});
  EXPECT_EQ(p.effective(), 0.0);
}

}  // namespace
}  // namespace nugget::kernel
