// SPDX-License-Identifier: Apache-2.0
// Laws of one degree of freedom and the rule of failure of six of them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/element/discrete_beam.hpp"
#include "one_element.hpp"

namespace nugget::kernel {
namespace {

using Kind = DiscreteSpring::Kind;

ForceCurve curve(std::vector<double> x, std::vector<double> y) {
  Curve c;
  c.x = std::move(x);
  c.y = std::move(y);
  return ForceCurve(c);
}

/// Force after moving to `d` in `steps` equal increments over a unit of time.
double drive(const DiscreteSpring& spring, DiscreteSpring::State& state, double d, int steps = 10) {
  const double increment = (d - state.displacement) / steps;
  double force = 0.0;
  for (int i = 0; i < steps; ++i) force = spring.advance(state, increment, 0.0);
  return force;
}

TEST(ForceCurve, MirrorsWhenItStartsAtZeroAndGoesOnWithItsEndSlopes) {
  const ForceCurve half = curve({0, 1, 3}, {0, 10, 14});
  EXPECT_DOUBLE_EQ(half(0.5), 5.0);
  EXPECT_DOUBLE_EQ(half(-2.0), -12.0);
  EXPECT_DOUBLE_EQ(half(5.0), 18.0);
  const ForceCurve whole = curve({-1, 0, 2}, {-30, 0, 4});
  EXPECT_DOUBLE_EQ(whole(-2.0), -60.0);
  EXPECT_DOUBLE_EQ(whole(1.0), 2.0);
  EXPECT_DOUBLE_EQ(whole.steepest(), 30.0);
  EXPECT_DOUBLE_EQ(curve({0, 1, 2}, {0, 4, 1}).steepest_fall(), 3.0);
}

TEST(DiscreteSpring, LinearWithPreloadAndDamper) {
  DiscreteSpring spring;
  spring.kind = Kind::linear;
  spring.stiffness = 100.0;
  spring.damping = 3.0;
  spring.preload = 7.0;
  DiscreteSpring::State state;
  EXPECT_DOUBLE_EQ(spring.advance(state, 0.2, 5.0), 7.0 + 20.0 + 15.0);
}

TEST(DiscreteSpring, RateFactorsAndDampingCurves) {
  DiscreteSpring spring;
  spring.kind = Kind::linear;
  spring.stiffness = 100.0;
  spring.linear_rate = 0.1;
  spring.log_rate = 0.5;
  spring.rate = 2.0;
  spring.damper = curve({-10, 0, 10}, {-40, 0, 20});
  spring.damper_scale = curve({-1, 1}, {0, 2});
  DiscreteSpring::State state;
  const double log = 0.5 * std::log(3.0);
  EXPECT_NEAR(spring.advance(state, 0.5, 6.0), 50.0 * (1.6 + log) + 1.5 * 12.0, 1e-12);
  EXPECT_NEAR(spring.advance(state, 0.0, -6.0), 50.0 * (0.4 - log) - 1.5 * 24.0, 1e-12);
}

// Bilinear: yields at 50, hardens with 20; unloads with the stiffness 100 and yields again at what it hardened to.
TEST(DiscreteSpring, ElastoplasticFollowsItsYieldCurveInBothDirections) {
  DiscreteSpring spring;
  spring.kind = Kind::elastoplastic;
  spring.stiffness = 100.0;
  spring.load = spring.unload = curve({0, 1}, {50, 70});
  DiscreteSpring::State state;
  EXPECT_DOUBLE_EQ(drive(spring, state, 0.4), 40.0);
  // F = 50 + 20 q and F = 100 (1.1 - q): q = 0.5.
  EXPECT_NEAR(drive(spring, state, 1.1), 60.0, 1e-12);
  EXPECT_NEAR(state.plastic, 0.5, 1e-12);
  EXPECT_NEAR(drive(spring, state, 0.0), -50.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, -0.1), -60.0, 1e-12);
  // One step does the same as many, over kinks of the curve as well.
  spring.load = spring.unload = curve({0, 0.1, 0.2, 1}, {50, 60, 40, 44});
  spring.stiffness = 1000.0;
  DiscreteSpring::State once, often;
  EXPECT_NEAR(drive(spring, once, 0.7, 1), drive(spring, often, 0.7, 1000), 1e-9);
  EXPECT_NEAR(once.plastic, often.plastic, 1e-12);
}

TEST(DiscreteSpring, YieldForceThatEndsAtZeroStaysThere) {
  DiscreteSpring spring;
  spring.kind = Kind::elastoplastic;
  spring.stiffness = 1000.0;
  spring.load = spring.unload = curve({0, 1}, {50, 0});
  DiscreteSpring::State state;
  EXPECT_NEAR(drive(spring, state, 3.0), 0.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 4.0, 1), 0.0, 1e-9);
}

TEST(DiscreteSpring, TwoSidedYieldCurve) {
  DiscreteSpring spring;
  spring.kind = Kind::elastoplastic;
  spring.stiffness = 100.0;
  const ForceCurve both = curve({-1, -0.01, 0, 1}, {-30, -20.1, 50, 50});
  spring.load = both.tension_side();
  spring.unload = both.compression_side();
  DiscreteSpring::State state;
  EXPECT_NEAR(drive(spring, state, 1.0), 50.0, 1e-6);
  DiscreteSpring::State pushed;
  // F = 20 + 10 q = 100 (1 - q): q = 80/110.
  EXPECT_NEAR(drive(spring, pushed, -1.0), -(20.0 + 800.0 / 110.0), 1e-6);
}

TEST(DiscreteSpring, HysteresisGoesDownByItsStiffnessToTheUnloadingCurve) {
  DiscreteSpring spring;
  spring.kind = Kind::hysteresis;
  spring.stiffness = 100.0;
  spring.load = curve({0, 1}, {0, 50});
  spring.unload = curve({0, 1}, {0, 10});
  DiscreteSpring::State state;
  EXPECT_NEAR(drive(spring, state, 1.0), 50.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 0.8), 30.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 0.5), 5.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 0.6), 15.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 1.0), 50.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, -1.0), -50.0, 1e-12);
}

TEST(DiscreteSpring, TwoCurves) {
  DiscreteSpring spring;
  spring.kind = Kind::two_curves;
  spring.load = curve({0, 1}, {0, 50});
  spring.unload = curve({0, 1}, {0, 10});
  DiscreteSpring::State state;
  EXPECT_NEAR(drive(spring, state, 1.0), 50.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 0.5), 5.0, 1e-12);
}

TEST(DiscreteBeam, RulesOfFailure) {
  DiscreteBeam law;
  law.tension_limit = {2, 2, 0, 0, 0, 0};
  law.compression_limit = {1, 4, 0, 0, 0, 0};
  const std::array<double, 6> still{};
  const auto fails = [&](DiscreteBeam::Rule rule, double r, double s) {
    law.rule = rule;
    return law.fails(still, {r, s, 9, 9, 9, 9});
  };
  using Rule = DiscreteBeam::Rule;
  EXPECT_FALSE(fails(Rule::any, 1.9, 1.9));
  EXPECT_TRUE(fails(Rule::any, 2.0, 0.0));
  EXPECT_TRUE(fails(Rule::any, -1.0, 0.0));
  EXPECT_TRUE(fails(Rule::sides, 1.5, 1.5));
  EXPECT_FALSE(fails(Rule::sides, 1.5, -3.0)) << "0.5625 on each side";
  EXPECT_TRUE(fails(Rule::together, 1.5, -3.0));
  law.force_limit = {30, 0, 40, 0, 0, 0};
  EXPECT_TRUE(law.fails({18, 1e9, 32, 0, 0, 0}, still));
  EXPECT_FALSE(law.fails({18, 1e9, 31, 0, 0, 0}, still));
}

TEST(DiscreteBeam, StableStepIsThatOfItsFastestMode) {
  DiscreteBeamProperties beam{2.0, 0.5, 0};  // two masses of 1, two inertias of 0.25
  DiscreteBeam law;
  EXPECT_TRUE(std::isinf(discrete_beam_stable_step(beam, law, 1.0)));
  law.dof[0].kind = law.dof[1].kind = Kind::linear;
  law.dof[0].stiffness = 50.0;
  EXPECT_NEAR(discrete_beam_stable_step(beam, law, 1.0), 2.0 / std::sqrt(100.0), 1e-15);
  law.dof[1].stiffness = 50.0;
  beam.scoor = 2;  // w^2 = k (2/m + L^2/(2 J))
  EXPECT_NEAR(discrete_beam_stable_step(beam, law, 1.0), 2.0 / std::sqrt(50.0 * (2.0 + 2.0)), 1e-15);
  law.dof[1].stiffness = 0.0;
  law.dof[0].damping = 10.0;  // xi = c/(2 sqrt(k m/2)) = 1
  EXPECT_NEAR(discrete_beam_stable_step(beam, law, 1.0), 0.2 * (std::sqrt(2.0) - 1.0), 1e-15);
}

// The stiffness is what the cycle does in a small motion; here by differences.
TEST(DiscreteBeam, StiffnessIsTheDerivativeOfTheForces) {
  const DiscreteBeamProperties beam{2.0, 0.5, 2};
  DiscreteBeam law;
  for (std::size_t i = 0; i < 6; ++i) {
    law.dof[i].kind = Kind::linear;
    law.dof[i].stiffness = 100.0 + 30.0 * static_cast<double>(i);
  }
  law.dof[1].kind = Kind::elastic;
  law.dof[1].load = curve({-2, -1, 3}, {-150, -100, 300});
  const Vec3d x1{0.3, -0.2, 0.1}, x2{1.1, 0.7, 2.0};
  const Frame3d global{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::array<double, DiscreteBeamLayout::count> rest{};
  start_discrete_beam(beam, law, global, x1, x2, rest.data(), 1, 0);
  const Vec3d r{rest[2], rest[3], rest[4]}, s{rest[5], rest[6], rest[7]};
  std::array<double, 144> k{};
  discrete_beam_stiffness(beam, law, {r, s, cross(r, s)}, x2 - x1, k);
  const double small = 1e-6;
  for (int j = 0; j < 12; ++j) {
    NodalMotion<double, 2> motion{};
    motion.x[0] = x1;
    motion.x[1] = x2;
    Vec3d& moved = j % 6 < 3 ? motion.v[j / 6] : motion.w[j / 6];
    (j % 3 == 0 ? moved.x : j % 3 == 1 ? moved.y : moved.z) = 1.0;
    for (int a = 0; a < 2; ++a) motion.x[a] += small * motion.v[a];
    auto state = rest;
    const auto out = one_element(motion, state, [&](const auto& all, double* store) {
      return discrete_beam_cycle(beam, law, all, small, store);
    });
    const Vec3d force[4]{out.f[0], out.m[0], out.f[1], out.m[1]};
    for (int i = 0; i < 12; ++i) {
      const Vec3d& f = force[i / 3];
      const double got = (i % 3 == 0 ? f.x : i % 3 == 1 ? f.y : f.z) / small;
      EXPECT_NEAR(got, k[12 * i + j], 1e-2) << i << ' ' << j;
    }
  }
}

}  // namespace
}  // namespace nugget::kernel
