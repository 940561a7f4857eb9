// SPDX-License-Identifier: Apache-2.0
// Linear statics (*CONTROL_IMPLICIT_SOLUTION, NSOLVR 1) against closed forms and three-dimensional models.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "linear.hpp"
#include "nvh/statics.hpp"
#include "nvh/stresses.hpp"
#include "specimen.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

const char* const linear =
    "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
    "*CONTROL_TERMINATION\n       1.0\n";
const char* const ramp =
    "*DEFINE_CURVE\n         9\n                 0.0                 0.0\n"
    "                 1.0                 1.0\n";

nvh::Statics solve(const LinearExperiment& experiment) {
  Findings findings;
  nvh::check_statics(experiment.system().model, findings);
  const nvh::Statics s = nvh::solve_statics(experiment.matrices(), findings);
  EXPECT_EQ(findings.errors(), 0);
  EXPECT_LT(s.residual, 1e-8);
  EXPECT_NEAR(s.energy, s.external, 1e-6 * s.energy);
  return s;
}

/// Force of prescribed motions in global direction i.
double driving_force(const LinearExperiment& experiment, const nvh::Statics& s, int i) {
  const auto& supports = experiment.matrices().equations.supports();
  Vec3d sum{};
  for (std::size_t k = 0; k < supports.size(); ++k)
    if (supports[k].source == nvh::Equations::Support::Source::motion && !supports[k].rotation)
      sum += s.support_force[k] * supports[k].taken;
  return i == 0 ? sum.x : i == 1 ? sum.y : sum.z;
}

// Cantilever 200 x 20 x 2: P L^3 / (3 E I) = .952381 mm for 1 N (Poisson 0: a beam). Sabotage: the load at time 0.
TEST(LinearStatics, CantileverStripUnderTipForce) {
  Specimen s;
  s.text(linear).text(ramp);
  s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.0});
  s.card("SECTION_SHELL", {1, 16, 0.833333, 5}).text("       2.0       2.0       2.0       2.0\n").part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {200.0, 20.0, 0.0}, 40, 4);
  s.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  s.node_set(2, grid.across(40)).card("LOAD_NODE_SET", {2, 3, 9, 0.2});
  const LinearExperiment strip(s.deck());
  const nvh::Statics solved = solve(strip);
  const auto tip = static_cast<std::size_t>(
      strip.system().node_of[static_cast<std::size_t>(strip.system().model.node_index(grid.across(40)[2]))]);
  expect_reference("A-54", "cantilever strip, static, 40 x 4 shells: deflection for 1 N [mm]", solved.motion[tip][2],
                   0.952381, 5e-3);
  const auto& supports = strip.matrices().equations.supports();
  double force = 0.0, moment = 0.0;
  for (std::size_t k = 0; k < supports.size(); ++k)
    (supports[k].rotation ? moment : force) +=
        solved.support_force[k] * (supports[k].rotation ? supports[k].taken.y : supports[k].taken.z);
  EXPECT_NEAR(force, -1.0, 1e-7);
  EXPECT_NEAR(moment, 200.0, 1e-5);
}

/// MacNeal and Harder's patch of five shells; its four outer nodes move by `motion` of their place.
template <class Motion>
std::string patch(const Motion& motion) {
  Specimen s;
  s.text(linear).text(ramp);
  s.card("MAT_ELASTIC", {1, 1e-9, 1e6, 0.25});
  s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("     0.001     0.001     0.001     0.001\n").part(1, 1, 1);
  const Vec3d place[] = {{0, 0, 0},     {.24, 0, 0},   {.24, .12, 0}, {0, .12, 0},
                         {.04, .02, 0}, {.18, .03, 0}, {.16, .08, 0}, {.08, .08, 0}};
  std::array<int, 8> n{};
  for (std::size_t k = 0; k < 8; ++k) n[k] = s.node(place[k]);
  for (const std::array<std::size_t, 4>& e : std::initializer_list<std::array<std::size_t, 4>>{
           {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}})
    s.shell(1, {n[e[0]], n[e[1]], n[e[2]], n[e[3]]});
  for (std::size_t k = 0; k < 4; ++k) {
    const std::array<double, 6> u = motion(place[k]);
    std::array<double, 6> held{};
    for (std::size_t i = 0; i < 6; ++i) {
      constexpr double freedom[] = {1, 2, 3, 5, 6, 7};
      held[i] = u[i] == 0.0;  // a scale of 0 would mean its default
      if (u[i] != 0.0) s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * n[k], freedom[i], 2, 9, u[i]});
    }
    s.card("BOUNDARY_SPC_NODE", {1.0 * n[k], 0, held[0], held[1], held[2], held[3], held[4], held[5]});
  }
  return s.deck();
}

/// Largest departure of a stress component in point k of all shells.
double worst(const nvh::ElasticStresses& stresses, int k, std::size_t component, double expected) {
  double value = expected;
  for (const auto& seat : stresses.system().shell_seat)
    if (const double s = stresses.stress(seat, k)[component]; std::abs(s - expected) > std::abs(value - expected))
      value = s;
  return value;
}

// Sabotage: the spins of the solution left out (bending), a step that is no power of two.
TEST(LinearStatics, PatchesHaveTheirStresses) {
  const LinearExperiment membrane(patch([](const Vec3d& x) {
    return std::array<double, 6>{1e-3 * (x.x + 0.5 * x.y), 1e-3 * (x.y + 0.5 * x.x), 0, 0, 0, 0};
  }));
  const nvh::ElasticStresses flat(membrane.system(), solve(membrane).motion);
  expect_reference("A-22", "membrane patch by statics, xx stress, worst point", worst(flat, 0, 0, 4000.0 / 3.0),
                   4000.0 / 3.0, 1e-6);
  expect_reference("A-22", "membrane patch by statics, xy stress, worst point", worst(flat, 1, 3, 400.0), 400.0, 1e-6);

  const LinearExperiment bending(patch([](const Vec3d& x) {
    return std::array<double, 6>{
        0, 0, 0.5e-3 * (x.x * x.x + x.x * x.y + x.y * x.y), 1e-3 * (x.y + 0.5 * x.x), -1e-3 * (x.x + 0.5 * x.y), 0};
  }));
  const nvh::ElasticStresses bent(bending.system(), solve(bending).motion);
  const double at_point = 1.0 / std::sqrt(3.0);  // of the surface's stress, at the two points of Gauss
  expect_reference("A-23", "bending patch by statics, xx stress at the upper point, worst shell",
                   worst(bent, 1, 0, -at_point * 2.0 / 3.0), -at_point * 2.0 / 3.0, 1e-4);
  expect_reference("A-23", "bending patch by statics, xy stress at the upper point, worst shell",
                   worst(bent, 1, 3, -at_point * 0.2), -at_point * 0.2, 1e-4);
}

/// One of the coupons of the suite. Its sheets are swept over points in order.
struct Coupon {
  static constexpr double t = 1.5;
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  std::string held, pulled;  ///< SPCs of the grips
  std::vector<int> driven;
  int element = 0;

  static void spread(std::vector<double>& to, double a, double b, double size) {
    const int count = std::max(1, static_cast<int>(std::lround(std::abs(b - a) / size)));
    for (int i = 0; i < count; ++i) to.push_back(a + i * (b - a) / count);
  }
  template <class Grip>
  void sheet(int part, const std::vector<Vec3d>& path, const std::vector<Vec3d>& across, const Grip& grip, int pull) {
    const auto id = [&](std::size_t i, std::size_t j) {
      return 10000 * part + 1 + static_cast<int>(i * across.size() + j);
    };
    for (std::size_t i = 0; i < path.size(); ++i)
      for (std::size_t j = 0; j < across.size(); ++j) {
        const Vec3d x = path[i] + across[j];
        nodes += node_line(id(i, j), x.x, x.y, x.z);
        if (i + 1 < path.size() && j + 1 < across.size())
          shells += element_line(++element, part, {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
        if (!grip(path[i])) continue;
        const bool moves = part == 2;
        (moves ? pulled : held) += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}{:10d}\n", id(i, j), 0,
                                               moves && pull == 1 ? 0 : 1, 1, moves && pull == 3 ? 0 : 1, 1, 1, 1);
        if (moves) driven.push_back(id(i, j));
      }
  }
  std::string deck(int pull) const {
    WeldData weld;
    std::string text = "*KEYWORD\n" + std::string(linear) + ramp + sheet_part(1, t) + sheet_part(2, t) +
                       weld_part(3, weld) + weld_contact_to_set(3, {1, 2}) + nodes + shells;
    text += beam_between(90001, 3, 90001, {0, 0, -t / 2}, 90002, {0, 0, t / 2});
    text += "*BOUNDARY_SPC_NODE\n" + held + pulled + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n";
    for (const int n : driven) text += fmt::format("{:10d}{:10d}{:10d}{:10d}{:10.3g}\n", n, pull, 2, 9, 0.01);
    return text + "*END\n";
  }
};

std::vector<double> patch(double side, int cells) {
  std::vector<double> x;
  for (int i = 0; i <= cells; ++i) x.push_back(-0.5 * side + i * side / cells);
  return x;
}

std::vector<Vec3d> along_y(const std::vector<double>& y, double sign) {
  std::vector<Vec3d> v;
  for (const double value : y) v.push_back({0.0, sign * value, 0.0});
  return v;
}

void expect_stiffness(const Coupon& coupon, int pull, const std::string& what, double expected, double gate,
                      bool axial) {
  const LinearExperiment experiment(coupon.deck(pull));
  const nvh::Statics s = solve(experiment);
  const double force = driving_force(experiment, s, pull - 1);
  expect_reference("A-66", what, force / 0.01, expected, gate);
  // All of it goes through the one weld.
  ASSERT_TRUE(s.weld[0].has_value());
  const weld::Resultants& r = s.weld[0]->resultants;
  EXPECT_NEAR(axial ? r.axial : r.shear(), force, 1e-6 * force);
}

// Sabotage: the weld nodes tied without rotations.
TEST(LinearStatics, LapShearCoupon) {
  Coupon c;
  std::vector<double> x;
  const std::vector<double> middle = patch(40.0, 7);
  Coupon::spread(x, -80.0, -50.0, 40.0 / 7);
  Coupon::spread(x, -50.0, -20.0, 40.0 / 7);
  x.insert(x.end(), middle.begin(), middle.end());
  std::vector<Vec3d> lower, upper;
  for (const double v : x) lower.push_back({v, 0, -Coupon::t / 2}), upper.push_back({-v, 0, Coupon::t / 2});
  const auto grip = [](const Vec3d& p) { return std::abs(p.x) > 50.0 - 1e-6; };
  c.sheet(1, lower, along_y(middle, 1.0), grip, 1);
  c.sheet(2, upper, along_y(middle, -1.0), grip, 1);
  expect_stiffness(c, 1, "lap shear coupon, linear statics, 7 shells across [N/mm]", 62500.0, 0.05, false);
}

TEST(LinearStatics, CoachPeelCoupon) {
  Coupon c;
  std::vector<double> arm;
  const std::vector<double> middle = patch(40.0, 7);
  Coupon::spread(arm, -60.0, 0.0, 40.0 / 7);
  std::vector<Vec3d> lower, upper;
  for (const double h : arm)
    lower.push_back({-20.0, 0, h - Coupon::t / 2}), upper.push_back({-20.0, 0, Coupon::t / 2 - h});
  for (const double v : middle) lower.push_back({v, 0, -Coupon::t / 2}), upper.push_back({v, 0, Coupon::t / 2});
  const auto grip = [](const Vec3d& p) { return std::abs(p.z) > 60.0; };
  c.sheet(1, lower, along_y(middle, 1.0), grip, 3);
  c.sheet(2, upper, along_y(middle, -1.0), grip, 3);
  expect_stiffness(c, 3, "coach peel coupon, linear statics, 7 shells across [N/mm]", 472.0, 0.2, true);
}

TEST(LinearStatics, CrossTensionCoupon) {
  Coupon c;
  std::vector<double> s;
  const std::vector<double> middle = patch(48.0, 7);
  Coupon::spread(s, -60.0, -40.0, 48.0 / 7);
  Coupon::spread(s, -40.0, -24.0, 48.0 / 7);
  const std::vector<double> wing = s;
  s.insert(s.end(), middle.begin(), middle.end());
  for (std::size_t i = wing.size(); i-- > 0;) s.push_back(-wing[i]);
  std::vector<Vec3d> lower, upper, across;
  for (const double v : s) lower.push_back({v, 0, -Coupon::t / 2}), upper.push_back({0, v, Coupon::t / 2});
  for (const double v : middle) across.push_back({-v, 0, 0});
  const auto grip = [](const Vec3d& p) { return std::max(std::abs(p.x), std::abs(p.y)) > 40.0 - 1e-6; };
  c.sheet(1, lower, along_y(middle, 1.0), grip, 3);
  c.sheet(2, upper, across, grip, 3);
  expect_stiffness(c, 3, "cross tension coupon, linear statics, 7 shells across [N/mm]", 490.0, 0.2, true);
}

}  // namespace
}  // namespace nugget::verify
