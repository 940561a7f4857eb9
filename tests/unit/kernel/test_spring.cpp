// SPDX-License-Identifier: Apache-2.0
// Laws of *ELEMENT_DISCRETE that a discrete beam does not have: S06, S07, S08.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/spring.hpp"

namespace nugget::kernel {
namespace {

Curve curve(std::vector<double> x, std::vector<double> y) {
  Curve c;
  c.x = std::move(x);
  c.y = std::move(y);
  return c;
}

/// Moves to the elongation `d` in equal increments; returns the last force.
template <class Law>
double drive(const Law& law, typename Law::State& state, double d, int steps = 100) {
  const double increment = (d - state.elongation) / steps;
  double force = 0.0;
  for (int i = 0; i < steps; ++i) force = law.advance(state, increment);
  return force;
}

/// Loads with 100 to 20, then with 10; unloads with 200.
ReversingSpring reversing(bool isotropic) {
  ReversingSpring spring;
  spring.load = curve({-10.2, -0.2, 0.2, 10.2}, {-120, -20, 20, 120});
  spring.unload = curve({-1, 1}, {-200, 200});
  spring.tension_yield = 20.0;
  spring.compression_yield = -20.0;
  spring.isotropic = isotropic;
  return spring;
}

TEST(ReversingSpring, ElasticWithinTheYieldForces) {
  const ReversingSpring spring = reversing(true);
  ReversingSpring::State state;
  EXPECT_NEAR(drive(spring, state, 0.15), 15.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, -0.1), -10.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 0.0), 0.0, 1e-12);
  EXPECT_FALSE(state.yielded);
}

// Sabotage: unloading without a shift; reversed yield at the first yield force.
TEST(ReversingSpring, UnloadsAndYieldsTheOtherWay) {
  ReversingSpring spring = reversing(true);
  ReversingSpring::State state;
  EXPECT_NEAR(drive(spring, state, 3.2), 50.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 3.1), 30.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 3.2), 50.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 4.2), 60.0, 1e-9);
  // Isotropic: in compression from -60 on, 120/200 further back, then with the slope 10.
  EXPECT_NEAR(drive(spring, state, 3.6), -60.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 2.6), -70.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 2.6 + 140.0 / 200.0 + 1.0), 80.0, 1e-9);

  spring = reversing(false);
  state = {};
  drive(spring, state, 4.2);
  // Each side by itself: in compression from -20 on.
  EXPECT_NEAR(drive(spring, state, 4.2 - 80.0 / 200.0 - 1.0), -30.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 4.2 - 80.0 / 200.0 - 1.0 + 90.0 / 200.0 + 0.5), 65.0, 1e-9);
}

TEST(ReversingSpring, SoftensWithoutHardeningOfTheOtherSide) {
  ReversingSpring spring = reversing(false);
  spring.load = curve({-10.2, -0.2, 0.2, 3.2, 10}, {-120, -20, 20, 5, 5});
  ReversingSpring::State state;
  EXPECT_NEAR(drive(spring, state, 1.2), 15.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 1.1), -5.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 1.2), 15.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 5.0), 5.0, 1e-9);
}

TEST(ReversingSpring, OneStepIsAsGoodAsMany) {
  const ReversingSpring spring = reversing(true);
  for (const int steps : {1, 7, 200}) {
    ReversingSpring::State state;
    EXPECT_NEAR(drive(spring, state, 3.2, steps), 50.0, 1e-9) << steps;
    EXPECT_NEAR(drive(spring, state, 1.2, steps), -65.0, 1e-9) << steps;
  }
}

// A ramp and then a hold, by the convolution integral.
TEST(MaxwellSpring, RelaxesByItsIntegral) {
  MaxwellSpring spring;
  spring.instantaneous_stiffness = 100.0;
  spring.long_term_stiffness = 30.0;
  spring.decay = 5.0;
  for (const int steps : {10, 1000}) {
    MaxwellSpring::State state;
    const double rate = 2.0, ramp = 0.4, dt = ramp / steps;
    double force = 0.0;
    for (int i = 0; i < steps; ++i) force = spring.advance(state, rate * dt, dt);
    const double relaxing = 70.0 * rate / 5.0 * (1.0 - std::exp(-5.0 * ramp));
    EXPECT_NEAR(force, 30.0 * 0.8 + relaxing, 1e-9);
    for (int i = 0; i < steps; ++i) force = spring.advance(state, 0.0, dt);
    EXPECT_NEAR(force, 30.0 * 0.8 + relaxing * std::exp(-5.0 * 0.4), 1e-9);
  }
  MaxwellSpring cut = spring;
  cut.cut_off = 1.0;
  cut.last_force = 7.0;
  MaxwellSpring::State state;
  cut.advance(state, 1.0, 0.9);
  EXPECT_DOUBLE_EQ(cut.advance(state, 1.0, 0.2), 7.0);
}

TEST(InelasticSpring, StaysCrushedAndClosesAgain) {
  InelasticSpring spring;
  spring.load = ForceCurve(curve({0, 1, 3}, {0, 40, 60}));
  spring.unloading = 80.0;
  InelasticSpring::State state;
  EXPECT_NEAR(drive(spring, state, 2.0), 0.0, 1e-12);  // in compression only
  EXPECT_NEAR(drive(spring, state, -2.0), -50.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, -1.5), -10.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, 0.0), 0.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, -1.3), 0.0, 1e-9);  // remains 2 - 50/80 = 1.375
  EXPECT_NEAR(drive(spring, state, -1.875), -40.0, 1e-9);
  EXPECT_NEAR(drive(spring, state, -3.0), -60.0, 1e-9);

  spring.tension = true;
  state = {};
  EXPECT_NEAR(drive(spring, state, -1.0), 0.0, 1e-12);
  EXPECT_NEAR(drive(spring, state, 1.0), 40.0, 1e-9);
}

TEST(DiscreteSpring, ScaleOverRateIsEvenAndClamped) {
  DiscreteSpring spring;
  spring.kind = DiscreteSpring::Kind::linear;
  spring.stiffness = 10.0;
  spring.rate_scale = ForceCurve(curve({0, 10}, {1, 3}));
  DiscreteSpring::State state;
  EXPECT_DOUBLE_EQ(spring.advance(state, 1.0, 5.0), 20.0);
  EXPECT_DOUBLE_EQ(spring.advance(state, 0.0, -5.0), 20.0);
  EXPECT_DOUBLE_EQ(spring.advance(state, 0.0, 100.0), 30.0);
}

// Sabotage: a factor over displacement that is odd, as the force itself: the damper would push.
TEST(DiscreteSpring, DamperIsScaledAlikeInTensionAndCompression) {
  DiscreteSpring spring;
  spring.damper = ForceCurve(curve({0, 10}, {0, 20}));
  spring.damper_scale = ForceCurve(curve({0, 1}, {1, 2}));
  DiscreteSpring::State state;
  EXPECT_DOUBLE_EQ(spring.advance(state, -1.0, -3.0), -12.0);
  EXPECT_DOUBLE_EQ(spring.greatest_viscosity(0.0), 4.0);
}

}  // namespace
}  // namespace nugget::kernel
