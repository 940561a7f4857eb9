// SPDX-License-Identifier: Apache-2.0
// The failure surface of forces out of a weld's own failure function, against closed forms. Sabotage: axial and shear
// swapped; a function that is asked twice with what it remembers; a damage of joints that begins too late.
#include "weld/failure/force_at_failure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nugget::weld::failure {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(ForceAtFailure, ResultantsMakeAnEllipse) {
  model::Model model;
  model::WeldLaw law;
  law.strength[0].value = 6000.0, law.strength[1].value = law.strength[2].value = 9000.0;
  for (const double angle : {0.0, 15.0, 45.0, 75.0, 90.0}) {
    const double expected = 1.0 / std::hypot(std::sin(angle * degree) / 6000.0, std::cos(angle * degree) / 9000.0);
    EXPECT_NEAR(force_at_failure(model, law, disc(6.0), angle), expected, 1e-8 * expected) << angle;
  }
}

TEST(ForceAtFailure, StressesOfTheBar) {
  model::Model model;
  model::WeldLaw law;
  law.option = 1;
  law.normal_stress.value = 320.0, law.shear_stress.value = 190.0;
  const double area = 0.25 * std::numbers::pi * 36.0;
  EXPECT_NEAR(force_at_failure(model, law, disc(6.0), 90.0), 320.0 * area, 1e-6);
  EXPECT_NEAR(force_at_failure(model, law, disc(6.0), 0.0), 190.0 * area, 1e-6);
}

TEST(ForceAtFailure, LoadRatesCountNothing) {
  model::Model model;
  model.load_rate_strengths.emplace_back();
  model.load_rate_strengths[0].normal = 300.0, model.load_rate_strengths[0].shear = 400.0;
  model.load_rate_strengths[0].dynamic = {1.0, 0.5, 0.0, 1.0};
  model::WeldLaw law;
  law.option = 10;
  law.table = 0;
  Geometry weld = disc(6.0);
  weld.thickness = {1.5, 2.0};
  EXPECT_NEAR(force_at_failure(model, law, weld, 0.0), 400.0 * 6.0 * 1.5, 1e-5);
  EXPECT_NEAR(force_at_failure(model, law, weld, 90.0), 300.0 * 6.0 * 1.5, 1e-5);
}

TEST(ForceAtFailure, NoLimitIsInfinite) {
  model::Model model;
  model::WeldLaw law;
  law.strength[1].value = law.strength[2].value = 9000.0;
  EXPECT_TRUE(std::isinf(force_at_failure(model, law, disc(6.0), 90.0)));
  EXPECT_NEAR(force_at_failure(model, law, disc(6.0), 60.0), 18000.0, 1e-6);
}

// ---- interpolation spot welds and rivets: the largest force of a path along which the joint itself is pulled

kernel::Spr3 interpolation_weld() {
  kernel::Spr3 joint;
  joint.normal = 40e3, joint.shear = 25e3, joint.bending = joint.torsion = 1e6;
  joint.normal_strength = 5000.0, joint.shear_strength = 8000.0, joint.exponent = 1.7;
  joint.yield = kernel::ForceCurve(Curve{1, {0.0, 0.5, 3.0}, {1.0, 1.3, 1.3}});
  joint.initiation = Curve{2, {0.0, 1.0}, {0.8, 0.3}};
  joint.rupture = Curve{3, {0.0, 1.0}, {1.5, 0.9}};
  return joint;
}

/// Pulled by small displacements, each so directed that the force keeps its direction: what Spr3 gives for them.
double largest_of_a_path(const kernel::Spr3& joint, double angle) {
  const double n = std::sin(angle * degree), s = std::cos(angle * degree);
  const auto across = [&](const kernel::Spr3::Freedoms& f) { return s * f[0] - n * f[1]; };
  kernel::Spr3::State state;
  double largest = 0.0;
  while (state.damage < 0.9) {
    const auto turned = [&](double turn) {
      constexpr double step = 1e-3;
      return kernel::Spr3::Freedoms{step * std::sin(turn), step * std::cos(turn), 0, 0, 0, 0};
    };
    double low = -0.5 * std::numbers::pi, high = std::numbers::pi;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      kernel::Spr3::State trial = state;
      joint.advance(trial, turned(middle));
      (across(trial.force) > 0.0 ? high : low) = middle;
    }
    const kernel::Spr3::Freedoms force = joint.advance(state, turned(low));
    largest = std::max(largest, std::hypot(force[0], force[1]));
  }
  return largest;
}

TEST(ForceAtFailure, InterpolationWeldPulledAlongAPath) {
  const kernel::Spr3 joint = interpolation_weld();
  for (const double angle : {0.0, 30.0, 45.0, 70.0, 90.0}) {
    const double expected = largest_of_a_path(joint, angle);
    EXPECT_NEAR(force_at_failure(joint, angle), expected, 2e-3 * expected) << angle;
  }
}

TEST(ForceAtFailure, InterpolationWeldThatNeverBreaks) {
  kernel::Spr3 joint = interpolation_weld();
  joint.initiation = joint.rupture = Curve{};
  EXPECT_NEAR(force_at_failure(joint, 0.0), 8000.0 * 1.3, 1e-6);
  EXPECT_NEAR(force_at_failure(joint, 90.0), 5000.0 * 1.3, 1e-6);
}

kernel::Spr2 rivet() {
  kernel::Spr2 joint;
  joint.normal_force = 4000.0, joint.shear_force = 6000.0;
  joint.normal_failure = 3.0, joint.shear_failure = 5.0;
  joint.normal_peak = 0.4, joint.shear_peak = 0.6;
  joint.alpha = {1.2, 0.9, 0.7};
  joint.normal_exponent = 8.0, joint.shear_exponent = 5.0;
  return joint;
}

TEST(ForceAtFailure, RivetInTensionAndShear) {
  EXPECT_NEAR(force_at_failure(rivet(), 90.0), 4000.0, 1e-3 * 4000.0);
  EXPECT_NEAR(force_at_failure(rivet(), 0.0), 6000.0, 1e-3 * 6000.0);
}

/// Pulled along a path on which the force keeps its direction, the damage as it has become before each step.
TEST(ForceAtFailure, RivetPulledAlongAPath) {
  const kernel::Spr2 joint = rivet();
  for (const double angle : {20.0, 45.0, 75.0}) {
    const double n = std::sin(angle * degree), s = std::cos(angle * degree);
    double damage = 0.0, largest = 0.0;
    for (double opening = 1e-4; damage < 0.95; opening += 1e-4) {
      double low = 0.0, high = 100.0 * opening;  // of sliding
      for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        const kernel::Spr2::Freedoms f = joint.forces({opening, middle, 0, 0, 0, 0}, damage);
        (n * f[1] > s * f[0] ? high : low) = middle;
      }
      damage = std::max(damage, joint.effective_displacement({opening, low, 0, 0, 0, 0}, damage));
      const kernel::Spr2::Freedoms f = joint.forces({opening, low, 0, 0, 0, 0}, damage);
      largest = std::max(largest, std::hypot(f[0], f[1]));
    }
    EXPECT_NEAR(force_at_failure(joint, angle), largest, 2e-3 * largest) << angle;
  }
}

}  // namespace
}  // namespace nugget::weld::failure
