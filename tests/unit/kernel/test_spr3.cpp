// SPDX-License-Identifier: Apache-2.0
// The law of interpolation spot welds (SPR3) against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/law/spr3.hpp"

namespace nugget::kernel {
namespace {

using Freedoms = Spr3::Freedoms;
constexpr std::size_t normal = 0, shear = 1, other_shear = 2, torsion = 3, bending = 4, other_bending = 5;

constexpr double first_yield = 100.0, hardening = 50.0;

/// F0 = 100 + 50 u, no damage.
Spr3 hardening_joint() {
  Spr3 law;
  law.normal = 1e4;
  law.shear = 6e3;
  law.bending = 2e4;
  law.torsion = 3e4;
  law.normal_strength = 2.0;
  law.shear_strength = 3.0;
  law.exponent = 2.4;
  Curve yield;
  yield.x = {0.0, 10.0};
  yield.y = {first_yield, first_yield + 10.0 * hardening};
  law.yield = ForceCurve(yield);
  return law;
}

Spr3 ideal_joint(double exponent) {
  Spr3 law = hardening_joint();
  law.exponent = exponent;
  Curve yield;
  yield.x = {0.0, 1.0};
  yield.y = {first_yield, first_yield};
  law.yield = ForceCurve(yield);
  return law;
}

Freedoms along(std::size_t freedom, double amount) {
  Freedoms u{};
  u[freedom] = amount;
  return u;
}

/// Takes the whole way in `steps`.
Freedoms pull(const Spr3& law, Spr3::State& state, const Freedoms& whole, int steps = 1) {
  Freedoms step = whole, force{};
  for (double& s : step) s /= steps;
  for (int i = 0; i < steps; ++i) force = law.advance(state, step);
  return force;
}

// In one freedom the law is a spring with a slider: K (u - v) = R F0(v). One step and a hundred give the same, since
// the return is implicit. Sabotage: the strength left out; flow by the yield force of the step before.
TEST(Spr3, TensionAndShearAlone) {
  const Spr3 law = hardening_joint();
  for (const auto& [freedom, k, r] : {std::tuple{normal, law.normal, law.normal_strength},
                                      {shear, law.shear, law.shear_strength},
                                      {other_shear, law.shear, law.shear_strength}})
    for (const int steps : {1, 100}) {
      Spr3::State state;
      const double u = 0.4, v = (k * u - r * first_yield) / (k + r * hardening);
      EXPECT_NEAR(pull(law, state, along(freedom, u), steps)[freedom], k * (u - v), 1e-9);
      EXPECT_NEAR(state.plastic, v, 1e-12);
    }
}

// Bending counts alpha times in N, and the angle that flows is alpha times the opening:
// K_b (angle - alpha v) = R F0(v) / alpha. Sabotage: the angle not turned back; alpha counted once.
TEST(Spr3, BendingAlone) {
  Spr3 law = hardening_joint();
  law.bending_share = 0.3;
  Spr3::State state;
  const double angle = 0.1, a = law.bending_share, k = law.bending, r = law.normal_strength;
  const double v = (a * k * angle - r * first_yield) / (a * a * k + r * hardening);
  const Freedoms force = pull(law, state, {0, 0, 0, 0, 0.6 * angle, -0.8 * angle});
  EXPECT_NEAR(std::hypot(force[bending], force[other_bending]), k * (angle - a * v), 1e-9);
  EXPECT_NEAR(force[bending] / force[other_bending], -0.75, 1e-12);
  EXPECT_NEAR(state.plastic, v, 1e-12);
}

// Tension with bending: both give way to one opening. Sabotage: the moment left out of N.
TEST(Spr3, TensionWithBending) {
  Spr3 law = hardening_joint();
  law.bending_share = 0.3;
  Spr3::State state;
  const double u = 0.05, angle = 0.04, a = law.bending_share, r = law.normal_strength;
  const double v =
      (law.normal * u + a * law.bending * angle - r * first_yield) / (law.normal + a * a * law.bending + r * hardening);
  const Freedoms force = pull(law, state, {u, 0, 0, 0, angle, 0});
  EXPECT_NEAR(force[normal], law.normal * (u - v), 1e-9);
  EXPECT_NEAR(force[bending], law.bending * (angle - a * v), 1e-9);
}

// Torsion counts gamma times in S; without gamma it is elastic for ever.
TEST(Spr3, Torsion) {
  Spr3 law = hardening_joint();
  Spr3::State elastic, state;
  EXPECT_NEAR(pull(law, elastic, along(torsion, 5.0))[torsion], 5.0 * law.torsion, 1e-9);
  EXPECT_EQ(elastic.plastic, 0.0);
  law.torsion_share = 0.5;
  const double angle = 0.1, g = law.torsion_share, r = law.shear_strength;
  const double w = (g * law.torsion * angle - r * first_yield) / (g * g * law.torsion + r * hardening);
  EXPECT_NEAR(pull(law, state, along(torsion, -angle))[torsion], -law.torsion * (angle - g * w), 1e-9);
}

// Under a long pull at an angle the force comes to rest where the surface's normal is the pull's direction: with
// x^beta + y^beta = 1 there, x^(beta-1) / R_n : y^(beta-1) / R_s = tan(angle) : 1, f_n = R_n F0 x and f_s = R_s F0 y.
// At 45 degrees, and others. Sabotage: flow along the force; strengths exchanged in the flow.
TEST(Spr3, PullAtAnAngle) {
  for (const double exponent : {1.5, 2.0, 4.0})
    for (const double degrees : {20.0, 45.0, 75.0}) {
      const Spr3 law = ideal_joint(exponent);
      const double angle = degrees * std::numbers::pi / 180.0;
      Spr3::State state;
      const Freedoms force = pull(law, state, {2.0 * std::sin(angle), 2.0 * std::cos(angle), 0, 0, 0, 0}, 50);
      const double ratio =
          std::pow(std::tan(angle) * law.normal_strength / law.shear_strength, 1.0 / (exponent - 1.0));  // x / y
      const double y = std::pow(1.0 + std::pow(ratio, exponent), -1.0 / exponent);
      EXPECT_NEAR(force[normal] / (law.normal_strength * first_yield * ratio * y), 1.0, 1e-9) << exponent << degrees;
      EXPECT_NEAR(force[shear] / (law.shear_strength * first_yield * y), 1.0, 1e-9);
    }
}

// After any step beyond yield the force lies on the surface that has hardened with the flow, whatever the load.
// Sabotage: the return stopped after one step of Newton's.
TEST(Spr3, ForceLiesOnTheSurface) {
  Spr3 law = hardening_joint();
  law.bending_share = 0.2;
  law.torsion_share = 0.1;
  for (const double exponent : {1.0, 1.3, 2.0, 8.0}) {
    law.exponent = exponent;
    Spr3::State state;
    for (int i = 0; i < 40; ++i) {
      law.advance(state, {0.03 * std::sin(1.0 + i), 0.05 * std::cos(3.0 * i), 0.02 * std::sin(2.0 * i),
                          0.01 * std::cos(1.0 * i), 0.02 * std::sin(5.0 * i), 0.01});
      EXPECT_LE(law.equivalent_force(state.force), law.yield.yield(state.plastic) * (1.0 + 1e-11));
    }
    EXPECT_GT(state.plastic, 0.05);
  }
}

// One step from rest, far beyond yield: what the force has lost over the stiffnesses is the flow, and it is normal to
// the surface at the force that is left, also where all of the bending flows away. Sabotage: the flow of the step taken
// at the trial force; parts that end left in N.
TEST(Spr3, FlowIsNormalToTheSurface) {
  Spr3 law = hardening_joint();
  law.bending_share = 0.4;
  int ended = 0;
  for (const double exponent : {1.2, 2.0, 5.0})
    for (int i = 0; i < 60; ++i) {
      law.exponent = exponent;
      const Freedoms u{
          0.1 + 0.08 * std::sin(1.7 * i), 0.2 + 0.19 * std::cos(2.9 * i), 0, 0, 0.03 + 0.029 * std::sin(4.1 * i), 0};
      Spr3::State state;
      const Freedoms f = law.advance(state, u);
      const double sliding = u[shear] - f[shear] / law.shear, by_tension = u[normal] - f[normal] / law.normal,
                   by_bending = (u[bending] - f[bending] / law.bending) / law.bending_share;
      const double opening = std::max(by_tension, by_bending);  // a part that has ended tells less
      ended += f[normal] == 0.0 || f[bending] == 0.0;
      EXPECT_NEAR((f[normal] > 0.0 ? by_tension : opening) / opening, 1.0, 1e-9);
      EXPECT_NEAR((f[bending] > 0.0 ? by_bending : opening) / opening, 1.0, 1e-9);
      const double x = (f[normal] + law.bending_share * f[bending]) / law.normal_strength,
                   y = f[shear] / law.shear_strength, p = exponent - 1.0;
      const double wanted = std::pow(x / y, p) * law.shear_strength / law.normal_strength;
      EXPECT_NEAR(opening / sliding / wanted, 1.0, 1e-7) << exponent << ' ' << i;
      EXPECT_NEAR(state.plastic, std::hypot(opening, sliding), 1e-12);
    }
  EXPECT_GT(ended, 10);
  EXPECT_LT(ended, 170);
}

// A straight surface (beta 1) does not open what is only sheared.
TEST(Spr3, StraightSurface) {
  Spr3 law = hardening_joint();
  law.exponent = 1.0;
  Spr3::State state;
  const double u = 0.4, k = law.shear, r = law.shear_strength, w = (k * u - r * first_yield) / (k + r * hardening);
  const Freedoms force = pull(law, state, along(shear, u));
  EXPECT_NEAR(force[shear], k * (u - w), 1e-9);
  EXPECT_NEAR(state.plastic, w, 1e-12);
}

// Compression never flows; unloading is elastic.
TEST(Spr3, CompressionAndUnloading) {
  const Spr3 law = hardening_joint();
  Spr3::State state;
  EXPECT_NEAR(pull(law, state, along(normal, -3.0))[normal], -3.0 * law.normal, 1e-9);
  EXPECT_EQ(state.plastic, 0.0);
  Spr3::State pulled;
  const double force = pull(law, pulled, along(normal, 0.4))[normal];
  EXPECT_NEAR(pull(law, pulled, along(normal, -0.01))[normal], force - 0.01 * law.normal, 1e-9);
}

// R and F0 may be a force and a number, or a number and a force: only their product counts.
// Sabotage: u counted as the plastic multiplier.
TEST(Spr3, OnlyTheProductOfStrengthAndCurveCounts) {
  Spr3 law = hardening_joint(), scaled = law;
  constexpr double c = 1000.0;
  scaled.normal_strength *= c;
  scaled.shear_strength *= c;
  Curve yield;
  yield.x = {0.0, 10.0};
  yield.y = {first_yield / c, (first_yield + 10.0 * hardening) / c};
  scaled.yield = ForceCurve(yield);
  Spr3::State one, other;
  const Freedoms way{0.1, 0.07, 0.02, 0, 0, 0}, a = pull(law, one, way), b = pull(scaled, other, way);
  for (const std::size_t i : {normal, shear, other_shear}) EXPECT_NEAR(a[i], b[i], 1e-8);
  EXPECT_NEAR(one.plastic, other.plastic, 1e-12);
}

// Damage from u_0 to u_f of the mode: half of the force is left halfway, none at u_f; it does not heal.
// Sabotage: mode mixity turned round; the damage left out of the force.
TEST(Spr3, DamageByMode) {
  Spr3 law = ideal_joint(2.0);
  law.initiation.x = law.rupture.x = {0.0, 1.0};
  law.initiation.y = {0.1, 0.3};
  law.rupture.y = {0.5, 0.9};
  for (const auto& [freedom, k, r, begins, ends] : {std::tuple{normal, law.normal, law.normal_strength, 0.3, 0.9},
                                                    {shear, law.shear, law.shear_strength, 0.1, 0.5}}) {
    const double elastic = r * first_yield / k;
    Spr3::State state;
    EXPECT_NEAR(pull(law, state, along(freedom, elastic + begins))[freedom], r * first_yield, 1e-8);
    EXPECT_NEAR(pull(law, state, along(freedom, 0.5 * (ends - begins)), 7)[freedom], 0.5 * r * first_yield, 1e-8);
    EXPECT_NEAR(state.damage, 0.5, 1e-10);
    EXPECT_NEAR(law.failure_value(state.force, state.plastic), 0.5 * (begins + ends) / ends, 1e-10);
    EXPECT_NEAR(pull(law, state, along(freedom, -elastic))[freedom], 0.0, 1e-8);
    EXPECT_NEAR(pull(law, state, along(freedom, elastic + 0.5 * (ends - begins)), 5)[freedom], 0.0, 1e-8);
    EXPECT_NEAR(state.damage, 1.0, 1e-10);
  }
  Spr3::State both;
  EXPECT_NEAR(Spr3::mode_mixity({5.0, 3.0, 4.0, 0, 0, 0}), 0.5, 1e-12);
  EXPECT_EQ(Spr3::mode_mixity({-5.0, 3.0, 4.0, 0, 0, 0}), 0.0);
}

}  // namespace
}  // namespace nugget::kernel
