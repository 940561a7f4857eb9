// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_SPR2 between two sheets, against the formulas of Hanssen et al. (2010).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "sheet_joints.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double fn = 3000.0, ft = 5000.0, dn = 2.0, dt = 3.0, xin = 0.4, xit = 0.5, alpha = 0.8;

/// f hat of a share of the failure displacement, for a largest force of 1.
double f_hat(double share, double peak) {
  return share <= peak ? 1.0 - std::pow(1.0 - share / peak, 8) : std::max(1.0 - share, 0.0) / (1.0 - peak);
}

/// A rivet between two sheets (sheet_joints.hpp). `moved`: how far the upper one is at s. `unit`: what 1 mm is in the
/// deck's length; other than 1 masses are in kg.
std::string riveted(const std::function<Vec3d(double s)>& moved, double unit = 1.0) {
  const double mass = unit == 1.0 ? 1.0 : 1e3, force = mass * unit;  // t, mm, s or kg, m, s
  const std::string card = "*CONSTRAINED_SPR2\n" +
                           fields({1, 2, 7, 3.0 * unit, 5.0 * unit, fn * force, ft * force, dn * unit}) +
                           fields({dt * unit, xin, xit, alpha, alpha, alpha, 7.8e-9 * mass / (unit * unit * unit)});
  return moved_sheet(
      card, [&](const Vec3d& x, double s) { return x + moved(s); }, unit, mass);
}

// Sheets moved apart and along each other: the force over the displacement is f hat, the rivet is gone at DN and DT,
// with the work of that curve, f D [xi m/(m + 1) + (1 - xi)/2]. Sabotage: FN and FT exchanged; XIN for XIT; the
// exponent 1.
TEST(Spr2, TensionAndShearFollowTheirCurves) {
  for (const bool tension : {true, false}) {
    const double most = 1.2 * (tension ? dn : dt), full = tension ? fn : ft, peak = tension ? xin : xit,
                 fails = tension ? dn : dt;
    Experiment run(riveted([&](double s) { return tension ? Vec3d{0, 0, most * s} : most * s * Vec3d{0.6, -0.8, 0}; }));
    const std::vector<JointNow> seen = follow_joint(run);
    const char* mode = tension ? "tension" : "shear";
    for (const double share : {0.05, 0.2, 0.35, 0.6, 0.9}) {
      const JointNow& now = at_share(seen, share * fails / most);
      expect_reference("self-piercing rivet",
                       fmt::format("{}: force at {} of its failure displacement [N]", mode, share),
                       tension ? now.r[0] : now.shear(), full * f_hat(most * now.s / fails, peak), 2e-3);
      EXPECT_NEAR(tension ? now.shear() : now.r[0], 0.0, 2e-3 * full);
    }
    const auto broken = std::find_if(seen.begin(), seen.end(), [](const JointNow& now) { return !now.alive; });
    ASSERT_NE(broken, seen.end());
    expect_reference("self-piercing rivet", fmt::format("{}: displacement at which it is gone [mm]", mode),
                     most * broken->s, fails, 2e-3);
    expect_reference("self-piercing rivet", fmt::format("{}: work until then [mJ]", mode), seen.back().energy,
                     full * fails * (peak * 8.0 / 9.0 + 0.5 * (1.0 - peak)), 2e-3);
    EXPECT_TRUE(run.simulation().components().connectors.record(0)->failed);
  }
}

// At atan(d_n/d_t) = 60 degrees xi is 0: with all ALPHA alike the rivet is gone at ALPHA times the displacement at
// which sqrt((d_n/DN)^2 + (d_t/DT)^2) is 1. Sabotage: ALPHA left out; the angle taken from the normal.
TEST(Spr2, BetweenThePureModesAlphaCounts) {
  const double c = std::sin(M_PI / 3.0), q = 0.5;
  const double fails = alpha / std::hypot(c / dn, q / dt), most = 1.1 * fails;
  Experiment run(riveted([&](double s) { return most * s * Vec3d{q, 0, c}; }));
  const std::vector<JointNow> seen = follow_joint(run);
  const auto broken = std::find_if(seen.begin(), seen.end(), [](const JointNow& now) { return !now.alive; });
  ASSERT_NE(broken, seen.end());
  expect_reference("self-piercing rivet", "60 degrees: displacement at which it is gone [mm]", most * broken->s, fails,
                   3e-3);
  const JointNow& now = at_share(seen, 0.5);
  const double eta = std::hypot(c / dn, q / dt) * most * now.s / alpha;
  expect_reference("self-piercing rivet", "60 degrees: tension half way [N]", now.r[0],
                   fn * f_hat(eta, xin) * c * most * now.s / (eta * dn), 3e-3);
  expect_reference("self-piercing rivet", "60 degrees: shear half way [N]", now.shear(),
                   ft * f_hat(eta, xit) * q * most * now.s / (eta * dt), 3e-3);
}

// Sheared: each sheet carries half of f a, a = 1.5, up to XIT; from there on it goes over to the upper one.
TEST(Spr2, TheMomentOfTheShearGoesOverToTheUpperSheet) {
  const double most = dt;
  Experiment run(riveted([&](double s) { return Vec3d{most * s, 0, 0}; }));
  const std::vector<JointNow> seen = follow_joint(run);
  const JointNow &early = at_share(seen, 0.3), &late = at_share(seen, 0.75);
  EXPECT_NEAR(early.moment(0.75) / (0.75 * early.shear()), 1.0, 1e-2);
  EXPECT_NEAR(early.moment(-0.75) / (0.75 * early.shear()), 1.0, 1e-2);
  EXPECT_NEAR(late.moment(-0.75) / (0.75 * late.shear()), 1.5, 2e-2) << "the upper sheet";
  EXPECT_NEAR(late.moment(0.75) / (0.75 * late.shear()), 0.5, 2e-2) << "the lower one";
}

TEST(Spr2, UnitsDoNotMatter) {
  const auto peak = [](double unit) {
    Experiment run(riveted([](double s) { return Vec3d{1.0 * s, 0, 1.0 * s}; }, unit));
    double largest = 0.0;
    for (const JointNow& now : follow_joint(run)) largest = std::max(largest, now.r[0]);
    return largest;
  };
  const double mm = peak(1.0);
  EXPECT_GT(mm, 1000.0);
  EXPECT_NEAR(peak(1e-3) / mm, 1.0, 1e-6);
}

}  // namespace
}  // namespace nugget::verify
