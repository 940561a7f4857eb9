// SPDX-License-Identifier: Apache-2.0
// The three coupons in which spot welds are tested: elastic stiffness by linear statics, and forces and work in large
// plastic deformation by explicit runs, against models of 20-node bricks in CalculiX. With the weld as bricks, on other
// meshes and over edges and nodes: examples/coupons.
#include "coupons.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiment.hpp"
#include "linear.hpp"
#include "nvh/statics/statics.hpp"
#include "specimen.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

// ---- elastic, by linear statics

void expect_stiffness(const Coupon& coupon, const std::string& what, double expected, double gate, bool axial) {
  constexpr double u = 0.01;
  std::string deck =
      "*KEYWORD\n*CONTROL_IMPLICIT_GENERAL\n1,1.0\n*CONTROL_IMPLICIT_SOLUTION\n1\n*CONTROL_TERMINATION\n1.0\n" +
      curve(9, {{0.0, 0.0}, {1.0, 1.0}}) + sheet_part(1, Coupon::thickness) + sheet_part(2, Coupon::thickness) +
      weld_part(3, WeldData{}) + weld_contact_to_set(3, {1, 2}) + coupon.text() + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n";
  for (const int n : coupon.driven()) deck += fields({1.0 * n, 1.0 * coupon.pull(), 2, 9, u});
  const LinearExperiment experiment(deck + "*END\n");
  Findings findings;
  nvh::check_statics(experiment.system().model, findings);
  const nvh::Statics s = nvh::solve_statics(experiment.matrices(), findings);
  EXPECT_EQ(findings.errors(), 0);
  EXPECT_LT(s.residual, 1e-8);
  const auto& supports = experiment.matrices().equations.supports();
  double force = 0.0;
  for (std::size_t k = 0; k < supports.size(); ++k)
    if (supports[k].source == nvh::Equations::Support::Source::motion && !supports[k].rotation)
      force += s.support_force[k] * (coupon.pull() == 1 ? supports[k].taken.x : supports[k].taken.z);
  expect_reference("coupons: elastic stiffness", what, force / u, expected, gate);
  // All of it goes through the one weld.
  ASSERT_TRUE(s.weld[0].has_value());
  const weld::Resultants& r = s.weld[0]->resultants;
  EXPECT_NEAR(axial ? r.axial : r.shear(), force, 1e-6 * force);
}

// Sabotage: the weld nodes tied without rotations.
TEST(ElasticCoupons, LapShear) {
  expect_stiffness(Coupon::lap_shear(7), "lap shear coupon, linear statics, 7 shells across [N/mm]", 62500.0, 0.05,
                   false);
}
TEST(ElasticCoupons, CoachPeel) {
  expect_stiffness(Coupon::coach_peel(7), "coach peel coupon, linear statics, 7 shells across [N/mm]", 472.0, 0.2,
                   true);
}
TEST(ElasticCoupons, CrossTension) {
  expect_stiffness(Coupon::cross_tension(7), "cross tension coupon, linear statics, 7 shells across [N/mm]", 490.0, 0.2,
                   true);
}

// ---- plastic, explicit

/// Force in the grip over its displacement, pulled to `stroke` within `duration`.
class Pull {
 public:
  Pull(const Coupon& coupon, double stroke, double duration, const WeldData& weld) {
    const std::string sheet = "*SECTION_SHELL\n" + fields({1, 2, 0.8333, 5}) + fields({1.5, 1.5, 1.5, 1.5}) +
                              "*MAT_PIECEWISE_LINEAR_PLASTICITY\n" + fields({1, 7.85e-9, 210000, 0.3, 300, 1489.36}) +
                              fields({0}) + "\n\n*PART\nlower\n" + fields({1, 1, 1}) + "*PART\nupper\n" +
                              fields({2, 1, 1});
    std::string deck = "*KEYWORD\n" + termination(duration) + "*CONTROL_SHELL\n" + fields({20, 0, -1, 1}) +
                       "*CONTROL_HOURGLASS\n" + fields({4, 0.01}) + sheet + weld_part(3, weld) +
                       weld_contact_to_set(3, {1, 2}) + smooth_ramp(1, 0.2 * duration) + coupon.text() +
                       "*BOUNDARY_PRESCRIBED_MOTION_NODE\n";
    // The ramp's mean is a half.
    for (const int n : coupon.driven()) deck += fields({1.0 * n, 1.0 * coupon.pull(), 0, 1, stroke / (0.9 * duration)});
    Experiment run(deck + "*END\n");
    const auto along = [&](const Vec3d& v) { return coupon.pull() == 1 ? v.x : v.z; };
    const impact::Outcome outcome = run.run([&](const impact::Snapshot& now) {
      failed_ = run.history(now, 90001).failed();
      if (failed_) return;
      double force = 0.0;
      for (const auto& r : now.components.supports.spc_reactions()) force -= along(r.force);
      points_.emplace_back(along(run.displacement(now, coupon.driven().front())), force);
    });
    EXPECT_EQ(outcome.termination, impact::Termination::normal) << outcome.message;
  }

  /// Mean over displacements within 1 % of u: the coupon rings a little.
  double force(double u) const {
    double sum = 0.0;
    int count = 0;
    for (const auto& [x, f] : points_)
      if (std::abs(x - u) <= 0.01 * u) sum += f, ++count;
    return sum / count;
  }
  double work(double until) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < points_.size() && points_[i].first <= until; ++i)
      sum += 0.5 * (points_[i].second + points_[i - 1].second) * (points_[i].first - points_[i - 1].first);
    return sum;
  }
  bool failed() const { return failed_; }
  double last_force() const { return points_.back().second; }  ///< before the weld failed

 private:
  std::vector<std::pair<double, double>> points_;
  bool failed_ = false;
};

WeldData strong_weld() {
  WeldData w;
  w.yield = 20000.0;
  w.mass_step = 5e-7;
  return w;
}

// On elements as large as the weld the force is too high up to 0.75 mm (docs/evidence/coupons.md).
// Sabotage: a weld that hands over no moment; shells whose thickness does not follow.
TEST(PlasticCoupons, LapShear) {
  const Pull nine(Coupon::lap_shear(9), 2.0, 0.01, strong_weld()),
      seven(Coupon::lap_shear(7), 2.0, 0.01, strong_weld());
  for (const auto& [u, force] :
       {std::pair{0.3, 9132.0}, {0.5, 10203.0}, {0.75, 11050.0}, {1.0, 11704.0}, {1.5, 12669.0}, {1.98, 13305.0}}) {
    expect_reference("coupons: plastic forces", fmt::format("lap shear, 9 shells across, force at {} mm [N]", u),
                     nine.force(u), force, 0.1);
    if (u >= 1.0)
      expect_reference("coupons: plastic forces", fmt::format("lap shear, 7 shells across, force at {} mm [N]", u),
                       seven.force(u), force, 0.1);
  }
  expect_reference("coupons: plastic forces", "lap shear, 9 shells across, work to 2 mm [N mm]", nine.work(2.0),
                   21982.0, 0.08);
  expect_reference("coupons: plastic forces", "lap shear, 7 shells across, work to 2 mm [N mm]", seven.work(2.0),
                   21982.0, 0.08);
}

TEST(PlasticCoupons, CoachPeelAndCrossTension) {
  expect_reference("coupons: plastic forces", "coach peel, 7 shells across, work to 12 mm [N mm]",
                   Pull(Coupon::coach_peel(7), 12.0, 0.03, strong_weld()).work(12.0), 10810.0, 0.2);
  expect_reference("coupons: plastic forces", "cross tension, 7 shells across, work to 8 mm [N mm]",
                   Pull(Coupon::cross_tension(7), 8.0, 0.02, strong_weld()).work(8.0), 14365.0, 0.2);
}

// Sabotage: a failure function that sees the grip's force; moments that fail a weld without MSS.
TEST(PlasticCoupons, FailureByTheForceInTheGrip) {
  WeldData in_shear = strong_weld(), in_tension = strong_weld();
  in_shear.strength = {0, 9000, 9000, 0, 0, 0};
  in_tension.strength = {800, 0, 0, 0, 0, 0};
  const Pull lap(Coupon::lap_shear(7), 1.0, 0.005, in_shear), peel(Coupon::coach_peel(7), 6.0, 0.015, in_tension);
  EXPECT_TRUE(lap.failed() && peel.failed());
  expect_reference("coupons: plastic forces", "lap shear, NRS = NRT = 9000: force in the grip at failure [N]",
                   lap.last_force(), 9000.0, 0.05);
  expect_reference("coupons: plastic forces", "coach peel, NRR = 800: force in the grip at failure [N]",
                   peel.last_force(), 800.0, 0.05);
}

}  // namespace
}  // namespace nugget::verify
