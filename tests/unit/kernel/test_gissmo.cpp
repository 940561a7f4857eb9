// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"
#include "motion.hpp"

// Damage of GISSMO in perfectly plastic points, whose stress is what the damage leaves of the yield stress: against the
// formulas of Neukamm, Feucht and Haufe (2009).
namespace nugget::kernel {
namespace {

constexpr double yield = 250.0, step = 1e-4;

CurveTable constant(double value) {
  return {0, {0.0}, {Curve{0, {0.0}, {value}}}};
}
/// Strain at fracture: 0.9 compressed, 0.6 in shear, 0.3 pulled, 0.5 pulled both ways.
CurveTable fracture() {
  return {1, {0.0}, {Curve{1, {-1.0 / 3.0, 0.0, 1.0 / 3.0, 2.0 / 3.0}, {0.9, 0.6, 0.3, 0.5}}}};
}
Gissmo damage() {
  Gissmo g;
  g.fracture = fracture();
  g.fading = constant(1.0);
  return g;
}
ComposedLaw steel(const Gissmo& g) {
  LawComponents law{bilinear(yield, 0.0)};
  law.gissmo = g;
  return composed_law(law);
}

template <class Point>
Point point(const Gissmo& g, double size = 1.0) {
  Point p(steel(g));
  p.history[p.law.size_field()] = size;
  return p;
}

const auto pull = [](LayerPoint<ComposedLaw>& p) { p.uniaxial(step); };
const auto shear = [](LayerPoint<ComposedLaw>& p) { p.strain({0, 0, step, 0, 0}); };
const auto pull_both = [](LayerPoint<ComposedLaw>& p) { p.strain({step, step, 0, 0, 0}); };

/// Plastic strain at which the point fails; loads until then.
template <class Point, class Load>
double strain_at_fracture(Point p, const Load& load) {
  double last = 0.0;
  for (int i = 0; i < 30000 && !p.law.template failed<double>(p.history.data()); ++i) {
    last = p.plastic_strain();
    load(p);
  }
  return last;
}

TEST(Gissmo, StressFadesBetweenInstabilityAndFracture) {
  Gissmo g = damage();
  g.growth = 2.0;
  g.instability = constant(0.1);
  g.fading = constant(3.0);
  auto p = point<LayerPoint<ComposedLaw>>(g);
  const double critical = std::pow(0.1 / 0.3, 2);
  for (double before = 0.0; before < 0.2995; before = p.plastic_strain()) {
    p.uniaxial(step);
    if (p.plastic_strain() == 0.0) continue;
    const double d = std::pow(p.plastic_strain() / 0.3, 2), beyond = std::max(d - critical, 0.0) / (1.0 - critical);
    ASSERT_NEAR(p.s.xx / yield, 1.0 - std::pow(beyond, 3), 2e-3) << p.plastic_strain();
  }
  EXPECT_LT(p.s.xx, 0.02 * yield);
  EXPECT_NEAR(strain_at_fracture(point<LayerPoint<ComposedLaw>>(g), pull), 0.3, 2 * step);
}

TEST(Gissmo, StrainAtFractureIsThatOfTheStressState) {
  EXPECT_NEAR(strain_at_fracture(point<LayerPoint<ComposedLaw>>(damage()), pull), 0.3, 2 * step);
  EXPECT_NEAR(strain_at_fracture(point<LayerPoint<ComposedLaw>>(damage()), shear), 0.6, 2 * step);
  EXPECT_NEAR(strain_at_fracture(point<LayerPoint<ComposedLaw>>(damage()), pull_both), 0.5, 4 * step);
  EXPECT_NEAR(strain_at_fracture(point<LayerPoint<ComposedLaw>>(damage()), [](auto& p) { p.uniaxial(-step); }), 0.9,
              2 * step);
}

TEST(Gissmo, DamageOfUnlikeStatesAddsUp) {
  // A third of the life in shear, the rest in tension, for any exponent of the growth.
  for (const double n : {1.0, 2.0, 0.5}) {
    Gissmo g = damage();
    g.growth = n;
    auto p = point<LayerPoint<ComposedLaw>>(g);
    while (p.plastic_strain() < 0.2) shear(p);
    // Back from shear to tension the stress turns within a few elastic strains.
    EXPECT_NEAR(strain_at_fracture(p, pull), 0.2 + 0.2, 2e-3) << n;
  }
}

TEST(Gissmo, ThresholdInPlaceOfInstability) {
  Gissmo g = damage();
  g.threshold = 0.5;
  auto p = point<LayerPoint<ComposedLaw>>(g);
  while (p.plastic_strain() < 0.149) pull(p);
  EXPECT_NEAR(p.s.xx, yield, 1e-6);
  while (p.plastic_strain() < 0.225) pull(p);
  EXPECT_NEAR(p.s.xx, 0.5 * yield, 0.01 * yield);
  g.threshold = 1.0;  // all the stress until the end
  auto q = point<LayerPoint<ComposedLaw>>(g);
  while (q.plastic_strain() < 0.299) pull(q);
  EXPECT_NEAR(q.s.xx, yield, 1e-6);
}

TEST(Gissmo, LodeParameterOfSolids) {
  Gissmo g = damage();  // 0.2 compressed, 0.4 in shear, 0.8 pulled
  g.fracture = {1, {-1.0, 0.0, 1.0}, {Curve{1, {0.0}, {0.2}}, Curve{2, {0.0}, {0.4}}, Curve{3, {0.0}, {0.8}}}};
  const auto solid = [&] { return point<SolidPoint<ComposedLaw>>(g); };
  EXPECT_NEAR(strain_at_fracture(solid(), [](auto& p) { p.uniaxial(-step); }), 0.2, 2 * step);
  EXPECT_NEAR(strain_at_fracture(solid(), [](auto& p) { p.strain({0, 0, 0, step, 0, 0}); }), 0.4, 2 * step);
  EXPECT_NEAR(strain_at_fracture(solid(), [](auto& p) { p.uniaxial(step); }), 0.8, 2 * step);
  EXPECT_NEAR(strain_at_fracture(point<LayerPoint<ComposedLaw>>(g), pull_both), 0.2, 4 * step);  // as if pressed
}

TEST(Gissmo, FactorOfTheElementSize) {
  Gissmo g = damage();
  g.mesh = {2, {0.0}, {Curve{2, {1.0, 5.0}, {1.0, 0.6}}}};
  const auto fails_at = [&](double size, const auto& load) {
    return strain_at_fracture(point<LayerPoint<ComposedLaw>>(g, size), load);
  };
  EXPECT_NEAR(fails_at(3.0, pull), 0.8 * 0.3, 2 * step);
  EXPECT_NEAR(fails_at(9.0, pull), 0.6 * 0.3, 2 * step);
  EXPECT_NEAR(fails_at(5.0, shear), 0.6 * 0.6, 2 * step);
  g.shear = 1.0;  // none in shear, half of it half way to tension; all of it in tension
  g.biaxial = 0.5;
  EXPECT_NEAR(fails_at(5.0, shear), 0.6, 2 * step);
  EXPECT_NEAR(fails_at(5.0, pull), 0.6 * 0.3, 2 * step);
  EXPECT_NEAR(fails_at(5.0, pull_both), 0.8 * 0.5, 4 * step);
  g.shear_end = 0.1;
  EXPECT_NEAR(fails_at(5.0, shear), 0.6, 2 * step);
  g.mesh = {2, {0.0, 1.0 / 3.0}, {Curve{2, {1.0}, {1.0}}, Curve{3, {1.0}, {0.5}}}};  // by triaxiality
  g.shear = g.biaxial = 0.0;
  EXPECT_NEAR(fails_at(5.0, shear), 0.6, 2 * step);
  EXPECT_NEAR(fails_at(5.0, pull), 0.5 * 0.3, 2 * step);
}

TEST(Gissmo, FadingOverTheElementSize) {
  Gissmo g = damage();
  g.fading = {3, {0.0}, {Curve{3, {1.0, 5.0}, {4.0, 2.0}}}};
  for (const double size : {1.0, 5.0}) {
    auto p = point<LayerPoint<ComposedLaw>>(g, size);
    while (p.plastic_strain() < 0.24) pull(p);
    EXPECT_NEAR(p.s.xx / yield, 1.0 - std::pow(0.8, size < 2.0 ? 4 : 2), 3e-3);
  }
}

TEST(Gissmo, FactorOfTheRate) {
  for (const bool logarithms : {false, true}) {
    Gissmo g = damage();
    g.log_rates = logarithms;
    g.rate = logarithms ? Curve{4, {std::log(0.01), std::log(100.0)}, {1.0, 2.0}} : Curve{4, {0.0, 2.0}, {1.0, 2.0}};
    g.instability = constant(0.1);
    auto p = point<LayerPoint<ComposedLaw>>(g);
    p.dt = step;  // a rate of 1
    EXPECT_NEAR(strain_at_fracture(p, pull), 1.5 * 0.3, 4e-3);
    for (const bool too : {false, true}) {  // stress is lost from 0.1 or 0.15 on
      g.rate_of_instability = too;
      auto q = point<LayerPoint<ComposedLaw>>(g);
      q.dt = step;
      while (q.plastic_strain() < 0.13) pull(q);
      EXPECT_EQ(q.s.xx > yield - 1e-6, too);
    }
  }
}

TEST(Gissmo, DamageThatIsOnlySummed) {
  Gissmo g = damage();
  g.weakens = false;
  auto p = point<LayerPoint<ComposedLaw>>(g);
  while (p.plastic_strain() < 0.5) pull(p);
  EXPECT_NEAR(p.s.xx, yield, 1e-6);
  EXPECT_FALSE(p.law.failed<double>(p.history.data()));
}

}  // namespace
}  // namespace nugget::kernel
