// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// Damage of a layer by direction: MAT_082 and MAT_099.
namespace nugget::kernel {
namespace {

constexpr double E = 200000.0, nu = 0.3, G = E / 2.6;

PiecewiseLinear plastic() {
  PiecewiseLinear law;
  law.E = E;
  law.nu = nu;
  law.yield = {{0, {0.0, 1.0}, {300.0, 500.0}}};
  return law;
}

ComposedLaw damaged(double onset, double rupture, Curve growth = {}) {
  LawComponents law{plastic()};
  law.directional_damage = PlasticDamage{onset, rupture, std::move(growth)};
  return composed_law(std::move(law));
}
ComposedLaw sound() {
  return composed_law({plastic()});
}

// Sabotage: damage by the effective plastic strain, which in equal pulls is twice the principal one.
TEST(Cracks, APullSoftensAsItsPlasticStrainSays) {
  LayerPoint<ComposedLaw> p(damaged(0.05, 0.25)), whole(sound());
  for (int i = 0; i < 2200; ++i) {
    p.uniaxial(1e-4);
    whole.uniaxial(1e-4);
    const double w = std::max((whole.plastic_strain() - 0.05) / 0.2, 0.0);
    ASSERT_NEAR(p.s.xx, (1.0 - w) * whole.s.xx, 1e-3 * whole.s.xx) << i;
  }
  for (int i = 0; i < 500; ++i) p.uniaxial(1e-4);
  EXPECT_EQ(p.s.xx, 0.0);
  EXPECT_TRUE(p.law.failed<double>(p.history.data()));

  LayerPoint<ComposedLaw> both(damaged(0.05, 0.25)), sound_both(sound());
  for (int i = 0; i < 1000; ++i) {
    both.strain({1e-4, 1e-4, 0, 0, 0});
    sound_both.strain({1e-4, 1e-4, 0, 0, 0});
  }
  const double w = (0.5 * sound_both.plastic_strain() - 0.05) / 0.2;
  EXPECT_GT(w, 0.2);
  EXPECT_NEAR(both.s.xx, (1.0 - w) * sound_both.s.xx, 1e-3 * both.s.xx);
  EXPECT_NEAR(both.s.yy, both.s.xx, 1e-9);
}

TEST(Cracks, AlongTheCrackAllIsLeft) {
  LayerPoint<ComposedLaw> p(damaged(0.05, 0.25)), whole(sound());
  for (LayerPoint<ComposedLaw>* each : {&p, &whole})
    for (int i = 0; i < 1500; ++i) each->uniaxial(1e-4);
  const double w = (whole.plastic_strain() - 0.05) / 0.2;
  EXPECT_NEAR(p.s.xx, (1.0 - w) * whole.s.xx, 0.5);
  // Unload across, then elastic steps in each component: the stiffness left is that of M C M.
  for (LayerPoint<ComposedLaw>* each : {&p, &whole}) each->uniaxial(-2e-4);
  const LayerTensor<double> a = p.s, b = whole.s;
  const double e = 1e-5, plane = E / (1 - nu * nu), left = 1.0 - w;
  for (LayerPoint<ComposedLaw>* each : {&p, &whole}) each->strain({0, e, e, e, e});
  EXPECT_NEAR((whole.s.yy - b.yy) / e, plane, 1.0);
  EXPECT_NEAR((p.s.yy - a.yy) / e, plane, 1.0);
  EXPECT_NEAR((p.s.xx - a.xx) / e, left * nu * plane, 5.0);
  EXPECT_NEAR((p.s.xy - a.xy) / e, std::sqrt(left) * G, 5.0);
  EXPECT_NEAR((p.s.xz - a.xz) / e, std::sqrt(left) * G, 5.0);
  EXPECT_NEAR((p.s.yz - a.yz) / e, G, 5.0);
}

// Sabotage: crack axes along those of the element.
TEST(Cracks, DirectionOfTheCrackDoesNotDependOnTheAxes) {
  LayerPoint<ComposedLaw> p(damaged(0.02, 0.2)), turned(damaged(0.02, 0.2));
  const double angle = 0.7, c = std::cos(angle), t = std::sin(angle);
  for (int i = 0; i < 1200; ++i) {
    p.strain({1e-4, -0.3e-4, 0, 0, 0});
    const double x = 1e-4, y = -0.3e-4;
    turned.strain({c * c * x + t * t * y, t * t * x + c * c * y, 2.0 * c * t * (x - y), 0, 0});
  }
  EXPECT_LT(p.s.xx, 0.7 * 350.0);
  EXPECT_NEAR(turned.s.xx + turned.s.yy, p.s.xx + p.s.yy, 1e-6);
  EXPECT_NEAR(c * c * turned.s.xx + t * t * turned.s.yy + 2.0 * c * t * turned.s.xy, p.s.xx, 1e-6);
}

TEST(Cracks, PressureDoesNotCrack) {
  // Pressed along x the layer grows along y by half as much: no damage before that is the onset.
  LayerPoint<ComposedLaw> p(damaged(0.05, 0.25)), whole(sound());
  for (int i = 0; i < 900; ++i) {
    p.uniaxial(-1e-4);
    whole.uniaxial(-1e-4);
  }
  EXPECT_NEAR(p.s.xx, whole.s.xx, 1e-9);
}

TEST(Cracks, ByACurve) {
  LayerPoint<ComposedLaw> p(damaged(0.05, 0.0, {1, {0.0, 0.1, 0.2}, {0.0, 0.1, 1.0}})), whole(sound());
  for (LayerPoint<ComposedLaw>* each : {&p, &whole})
    for (int i = 0; i < 2000; ++i) each->uniaxial(1e-4);
  const double beyond = whole.plastic_strain() - 0.05;
  ASSERT_GT(beyond, 0.1);
  EXPECT_NEAR(p.s.xx, (1.0 - (0.1 + 9.0 * (beyond - 0.1))) * whole.s.xx, 2.0);
}

}  // namespace
}  // namespace nugget::kernel
