// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/law_components.hpp"
#include "kernel/law/point_failure.hpp"
#include "law_point.hpp"
#include "motion.hpp"

// Damage and failure of points, against the criteria's formulas.
namespace nugget::kernel {
namespace {

constexpr double E = 210000.0, nu = 0.3;

LawComponents perfectly_plastic(double yield) {
  return {bilinear(yield, 0.0)};
}
LawComponents elastic() {
  return {Elastic{E, nu}};
}

/// Strain increments until the point fails; how many it took, 0 if it never did.
int steps_to_failure(const LawComponents& law, const SolidTensor<double>& increment, double dt = 1.0, int most = 2000) {
  SolidPoint<ComposedLaw> p(composed_law(law));
  p.dt = dt;
  for (int i = 1; i <= most; ++i) {
    p.strain(increment);
    if (p.law.failed<double>(p.history.data())) {
      EXPECT_EQ(p.effective(), 0.0);
      return i;
    }
  }
  return 0;
}
int steps_to_failure(const LawComponents& law, const LayerTensor<double>& increment, int most = 2000) {
  LayerPoint<ComposedLaw> p(composed_law(law));
  for (int i = 1; i <= most; ++i) {
    p.strain(increment);
    if (p.law.failed<double>(p.history.data())) return i;
  }
  return 0;
}

TEST(PointFailure, PrincipalValues) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const SolidTensor<double> a{random(), random(), random(), random(), random(), random()};
    const std::array<double, 3> v = principal_values(a);
    EXPECT_LE(v[0], v[1]);
    EXPECT_LE(v[1], v[2]);
    for (const double p : v) {  // det(a - p) = 0
      const double x = a.xx - p, y = a.yy - p, z = a.zz - p;
      EXPECT_NEAR(x * (y * z - a.yz * a.yz) - a.xy * (a.xy * z - a.yz * a.zx) + a.zx * (a.xy * a.yz - y * a.zx), 0.0,
                  1e-12);
    }
  }
  EXPECT_EQ(principal_values({2.0, 2.0, 2.0, 0, 0, 0})[0], 2.0);
}

TEST(PointFailure, DamageTakesTheStress) {
  // MAT_081: (1 - w) 250, w from 0 at 0.01 to 1 at 0.03.
  LawComponents law = perfectly_plastic(250.0);
  law.damage = PlasticDamage{0.01, 0.03, {}};
  LayerPoint<ComposedLaw> layer(composed_law(law));
  SolidPoint<ComposedLaw> solid(composed_law(law));
  const auto expected = [](double ep) { return 250.0 * std::clamp(1.0 - (ep - 0.01) / 0.02, 0.0, 1.0); };
  while (layer.plastic_strain() < 0.029) {
    layer.strain({1e-4, -0.5e-4, 0, 0, 0});
    solid.strain({0, 0, 0, 1e-4, 0, 0});
    if (solid.plastic_strain() == 0.0) continue;
    ASSERT_NEAR(layer.effective(), expected(layer.plastic_strain()), 1e-8 * 250.0);
    ASSERT_NEAR(solid.effective(), expected(solid.plastic_strain()), 1e-8 * 250.0);
  }
  // The stiffness of unloading is damaged alike.
  const double left = solid.effective() / 250.0, tau = solid.s.xy;
  solid.strain({0, 0, 0, -1e-5, 0, 0});
  EXPECT_NEAR(tau - solid.s.xy, left * E / 2.6 * 1e-5, 1e-9);
  for (int i = 0; i < 40; ++i) layer.strain({1e-4, -0.5e-4, 0, 0, 0});
  EXPECT_TRUE(layer.law.failed<double>(layer.history.data()));
  EXPECT_EQ(layer.effective(), 0.0);
}

TEST(PointFailure, DamageByCurve) {
  LawComponents law = perfectly_plastic(250.0);
  law.damage = PlasticDamage{0.01, 0.0, Curve{0, {0.0, 0.01, 0.05}, {0.0, 0.6, 0.8}}};
  SolidPoint<ComposedLaw> p(composed_law(law));
  while (p.plastic_strain() < 0.02) p.strain({0, 0, 0, 1e-5, 0, 0});
  EXPECT_NEAR(p.effective(), 250.0 * 0.4, 0.1);
  while (p.plastic_strain() < 0.2) p.strain({0, 0, 0, 1e-4, 0, 0});
  EXPECT_NEAR(p.effective(), 250.0 * 0.2, 1e-6);
  EXPECT_FALSE(p.law.failed<double>(p.history.data()));
}

TEST(PointFailure, JohnsonCookFracture) {
  // Perfectly plastic in shear (no mean stress) and in tension (a third), at a rate of 100 with EPSO 1.
  LawComponents law = perfectly_plastic(250.0);
  law.rules = {JohnsonCookFracture{0.05, 0.1, -1.5, 0.02, 0.0}};
  const double by_rate = 1.0 + 0.02 * std::log(100.0);
  for (const double triaxiality : {0.0, 1.0 / 3.0, -1.0 / 3.0}) {
    SolidPoint<ComposedLaw> p(composed_law(law));
    p.dt = 1e-6;
    while (!p.law.failed<double>(p.history.data()) && p.plastic_strain() < 1.0) {
      if (triaxiality == 0.0)
        p.strain({0, 0, 0, std::sqrt(3.0) * 1e-4, 0, 0});
      else
        p.uniaxial(std::copysign(1e-4, triaxiality));
    }
    EXPECT_NEAR(p.plastic_strain(), (0.05 + 0.1 * std::exp(-1.5 * triaxiality)) * by_rate, 4e-4) << triaxiality;
  }
  law.rules = {JohnsonCookFracture{-1.0, 0.0, 0.0, 0.0, 0.0, 0.02}};  // EFMIN
  SolidPoint<ComposedLaw> p(composed_law(law));
  while (!p.law.failed<double>(p.history.data())) p.strain({0, 0, 0, 1e-4, 0, 0});
  EXPECT_NEAR(p.plastic_strain(), 0.02, 1e-4);
}

TEST(PointFailure, PlasticWorkHeats) {
  // Adiabatic shear of a perfectly plastic point: dT = s ep / (rho c), s = A (1 - T / Tm) => s = A exp(-A ep / (rho c
  // Tm)); and D5 raises the strain at fracture.
  JohnsonCook flow;
  flow.E = E;
  flow.nu = nu;
  flow.yield = 500.0;
  flow.heating = 1.0 / (7.85e-9 * 4.5e8);  // 1/(rho cp), K/MPa
  flow.melting_rise = 1500.0;
  for (const double exponent : {1.0, 0.5}) {
    flow.softening = exponent;
    LayerPoint<ComposedLaw> layer(composed_law({flow}));
    SolidPoint<ComposedLaw> solid(composed_law({flow}));
    double rise = 0.0, before = 0.0;  // plainly, by the midpoint rule
    for (int i = 0; i < 10000; ++i) {
      layer.strain({0, 0, 1e-4, 0, 0});
      solid.strain({0, 0, 0, 0, 1e-4, 0});
      const double ep = solid.plastic_strain(), cold = 1.0 - std::pow(rise / 1500.0, exponent);
      rise += 500.0 * cold * (ep - before) * flow.heating;
      before = ep;
    }
    const double expected = 500.0 * (1.0 - std::pow(rise / 1500.0, exponent));
    EXPECT_NEAR(solid.effective(), expected, 0.5);
    EXPECT_NEAR(layer.effective(), expected, 0.5);
    if (exponent == 1.0) {
      const double ep = solid.plastic_strain();
      EXPECT_NEAR(solid.effective(), 500.0 * std::exp(-500.0 * ep * flow.heating / 1500.0), 0.1);
      EXPECT_NEAR(solid.history[1], 1500.0 * (1.0 - std::exp(-500.0 * ep * flow.heating / 1500.0)), 1.0);
    }
  }
}

TEST(PointFailure, StrainLimitsOfALayer) {
  LawComponents law = perfectly_plastic(250.0);
  law.limits.major = 0.0305;
  EXPECT_EQ(steps_to_failure(law, LayerTensor<double>{1e-3, 0.3e-3, 0, 0, 0}), 31);
  EXPECT_EQ(steps_to_failure(law, LayerTensor<double>{0, 0, 2e-3, 0, 0}), 31);  // shear: major = gamma / 2
  EXPECT_EQ(steps_to_failure(law, LayerTensor<double>{-1e-3, -1e-3, 0, 0, 0}), 0);
  law.limits = {0.03, 0.0};
  LayerPoint<ComposedLaw> p(composed_law(law));
  double thinning = 0.0;
  while (!p.law.failed<double>(p.history.data())) {
    EXPECT_LT(thinning, 0.03);
    p.strain({1e-3, 0.5e-3, 0, 0, 0});
    thinning -= p.thickness.plastic;
  }
  EXPECT_GE(thinning, 0.03);
}

TEST(PointFailure, EachErosionCriterion) {
  const SolidTensor<double> pull{1e-4, 0, 0, 0, 0, 0}, push{-1e-4, 0, 0, 0, 0, 0}, shear{0, 0, 0, 1e-4, 0, 0};
  const double lambda = E * nu / (1.3 * 0.4), G = E / 2.6, K = E / 1.2;
  const auto after = [&](const Erosion& erosion, const SolidTensor<double>& increment, double dt = 1.0) {
    LawComponents law = elastic();
    law.erosion = erosion;
    return steps_to_failure(law, increment, dt, 200);
  };
  const auto with = [](auto member, double value) {
    Erosion e;
    e.*member = value;
    return e;
  };
  EXPECT_EQ(after({}, pull), 0);
  const Erosion pressure = with(&Erosion::most_pressure, 9.5 * K * 1e-4);
  EXPECT_EQ(after(pressure, push), 10);
  EXPECT_EQ(after(pressure, pull), 0);
  const Erosion suction = with(&Erosion::least_pressure, -9.5 * K * 1e-4);
  EXPECT_EQ(after(suction, pull), 10);
  EXPECT_EQ(after(suction, push), 0);
  const Erosion shortest = with(&Erosion::least_strain, -9.5e-4);
  EXPECT_EQ(after(shortest, push), 10);
  EXPECT_EQ(after(shortest, pull), 0);
  EXPECT_EQ(after(shortest, shear), 19);  // gamma / 2
  const Erosion longest = with(&Erosion::most_strain, 9.5e-4);
  EXPECT_EQ(after(longest, pull), 10);
  EXPECT_EQ(after(longest, push), 0);
  EXPECT_EQ(after(with(&Erosion::effective_strain, 9.5e-4 * 2.0 / 3.0), pull), 10);
  EXPECT_EQ(after(with(&Erosion::most_volume_strain, 9.5e-4), pull), 10);
  EXPECT_EQ(after(with(&Erosion::most_volume_strain, 9.5e-4), push), 0);
  EXPECT_EQ(after(with(&Erosion::least_volume_strain, -9.5e-4), push), 10);
  EXPECT_EQ(after(with(&Erosion::least_volume_strain, -9.5e-4), pull), 0);
  EXPECT_EQ(after(with(&Erosion::most_stress, 9.5e-4 * (lambda + 2 * G)), pull), 10);
  EXPECT_EQ(after(with(&Erosion::effective_stress, 9.5e-4 * 2 * G), push), 10);
  EXPECT_EQ(after(with(&Erosion::shear_strain, 4.75e-4), shear), 10);
  EXPECT_EQ(after(with(&Erosion::shear_strain, 4.75e-4), pull), 10);
  EXPECT_EQ(after(with(&Erosion::time, 9.5e-3), pull, 1e-3), 10);
  Erosion over_rate;
  over_rate.effective_stress_over_rate = Curve{0, {0.0, 1.0}, {1000.0 * G, 9.5e-4 * 2 * G}};
  EXPECT_EQ(after(over_rate, pull, 1e-5), 10);
  EXPECT_EQ(after(over_rate, pull, 1e3), 0);
}

TEST(PointFailure, ErosionOfALayer) {
  // Principal strains of all three axes; thinning; the first forces of a run come with no step.
  LawComponents law = perfectly_plastic(250.0);
  law.erosion = Erosion{};
  law.erosion->most_strain = 0.0305;
  EXPECT_EQ(steps_to_failure(law, LayerTensor<double>{1e-3, 0.2e-3, 0, 0, 0}), 31);
  law.erosion = Erosion{};
  law.erosion->thinning = 0.03;
  LayerPoint<ComposedLaw> p(composed_law(law));
  p.step({}, 0.0);
  double thinning = 0.0;
  while (!p.law.failed<double>(p.history.data())) {
    ASSERT_LT(thinning, 0.03);
    p.strain({1e-3, 0.5e-3, 0, 0, 0});
    thinning -= p.thickness.total;
  }
  EXPECT_GE(thinning, 0.03);
}

TEST(PointFailure, ErosionByImpulse) {
  // Tuler and Butcher: integral of (s1 - s0)^2; s1 = c i.
  const double stress = (E * nu / (1.3 * 0.4) + 2.0 * E / 2.6) * 1e-4, threshold = 4.0 * stress, dt = 2e-6;
  LawComponents law = elastic();
  law.erosion = Erosion{};
  law.erosion->threshold = threshold;
  law.erosion->impulse = 30.0 * stress * stress * dt;  // 1 + 4 + 9 + 16 = 30
  EXPECT_EQ(steps_to_failure(law, SolidTensor<double>{1e-4, 0, 0, 0, 0, 0}, dt), 8);
}

TEST(PointFailure, SeveralErosionCriteriaAtOnce) {
  LawComponents law = elastic();
  law.erosion = Erosion{};
  law.erosion->most_strain = 9.5e-4;
  law.erosion->time = 19.5;
  const SolidTensor<double> pull{1e-4, 0, 0, 0, 0, 0};
  EXPECT_EQ(steps_to_failure(law, pull), 10);
  law.erosion->needed = 2;
  EXPECT_EQ(steps_to_failure(law, pull), 20);
}

TEST(PointFailure, StrainsTurnWithTheMaterial) {
  // Pulled along x, turned by a right angle about z, pulled along y: the same fibre.
  LawComponents law = elastic();
  law.erosion = Erosion{};
  law.erosion->most_strain = 19.5e-4;
  SolidPoint<ComposedLaw> p(composed_law(law));
  for (int i = 0; i < 10; ++i) p.strain({1e-4, 0, 0, 0, 0, 0});
  const Frame3d turn{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
  p.turn(turn);
  for (int i = 0; i < 10; ++i) {
    EXPECT_FALSE(p.law.failed<double>(p.history.data()));
    p.strain({0, 1e-4, 0, 0, 0, 0});
  }
  EXPECT_TRUE(p.law.failed<double>(p.history.data()));
}

}  // namespace
}  // namespace nugget::kernel
