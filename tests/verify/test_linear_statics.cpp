// SPDX-License-Identifier: Apache-2.0
// Linear statics (*CONTROL_IMPLICIT_SOLUTION, NSOLVR 1) against closed forms and three-dimensional models.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/index.hpp"
#include "linear.hpp"
#include "nvh/matrices/stresses.hpp"
#include "nvh/statics/statics.hpp"
#include "specimen.hpp"

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
  const auto tip = at(strip.system().node_of[strip.system().model.node_index(grid.across(40)[2])]);
  expect_reference("cantilever strip", "cantilever strip, static, 40 x 4 shells: deflection for 1 N [mm]",
                   solved.motion[tip][2], 0.952381, 5e-3);
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
  for (const auto& location : stresses.system().shell_location)
    if (const double s = stresses.stress(location, k)[component]; std::abs(s - expected) > std::abs(value - expected))
      value = s;
  return value;
}

// Sabotage: the spins of the solution left out (bending), a step that is no power of two.
TEST(LinearStatics, PatchesHaveTheirStresses) {
  const LinearExperiment membrane(patch([](const Vec3d& x) {
    return std::array<double, 6>{1e-3 * (x.x + 0.5 * x.y), 1e-3 * (x.y + 0.5 * x.x), 0, 0, 0, 0};
  }));
  const nvh::ElasticStresses flat(membrane.system(), solve(membrane).motion);
  expect_reference("membrane patch", "membrane patch by statics, xx stress, worst point",
                   worst(flat, 0, 0, 4000.0 / 3.0), 4000.0 / 3.0, 1e-6);
  expect_reference("membrane patch", "membrane patch by statics, xy stress, worst point", worst(flat, 1, 3, 400.0),
                   400.0, 1e-6);

  const LinearExperiment bending(patch([](const Vec3d& x) {
    return std::array<double, 6>{
        0, 0, 0.5e-3 * (x.x * x.x + x.x * x.y + x.y * x.y), 1e-3 * (x.y + 0.5 * x.x), -1e-3 * (x.x + 0.5 * x.y), 0};
  }));
  const nvh::ElasticStresses bent(bending.system(), solve(bending).motion);
  const double at_point = 1.0 / std::sqrt(3.0);  // of the surface's stress, at the two points of Gauss
  expect_reference("bending patch", "bending patch by statics, xx stress at the upper point, worst shell",
                   worst(bent, 1, 0, -at_point * 2.0 / 3.0), -at_point * 2.0 / 3.0, 1e-4);
  expect_reference("bending patch", "bending patch by statics, xy stress at the upper point, worst shell",
                   worst(bent, 1, 3, -at_point * 0.2), -at_point * 0.2, 1e-4);
}

// A rod from (4, 3) on a circle of 5 around (1, -1), tangent to it: the angle phi pulls it by r phi, force E A/L r phi.
// With the radius free a second rod along the arm stays without force. Sabotage: the angle for the way; the arm held.
TEST(LinearStatics, AMotionAroundAnAxisPullsByTheArc) {
  constexpr double E = 210000.0, area = 4.0, length = 100.0, phi = 1e-3, arm = 5.0;
  for (const double dof : {11.0, -11.0}) {
    Specimen s;
    s.text(linear).text(ramp);
    s.card("MAT_ELASTIC", {1, 7.85e-9, E, 0.3}).text("*SECTION_BEAM\n" + fields({1, 3}) + fields({area})).part(1, 1, 1);
    // Outwards (0.6, 0.8), around (-0.8, 0.6).
    const int driven = s.node({4.0, 3.0, 0.0}), behind = s.node({4.0 + 0.8 * length, 3.0 - 0.6 * length, 0.0}),
              out = s.node({4.0 + 0.6 * length, 3.0 + 0.8 * length, 0.0});
    s.text(fmt::format("*ELEMENT_BEAM\n{:8}{:8}{:8}{:8}\n{:8}{:8}{:8}{:8}\n", 1, 1, behind, driven, 2, 1, driven, out));
    for (const int held : {behind, out}) s.card("BOUNDARY_SPC_NODE", {1.0 * held, 0, 1, 1, 1, 1, 1, 1});
    s.card("BOUNDARY_SPC_NODE", {1.0 * driven, 0, 0, 0, 1, 1, 1, 1});
    s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * driven, dof, 2, 9, phi}).text(fields({1.0, -1.0}));
    const LinearExperiment rods(s.deck());
    const nvh::Statics solved = solve(rods);
    const auto k = at(rods.system().node_of[rods.system().model.node_index(driven)]);
    expect_reference("arc", fmt::format("linear statics, DOF {:g}: way around the axis", dof),
                     -0.8 * solved.motion[k][0] + 0.6 * solved.motion[k][1], arm * phi, 1e-9);
    EXPECT_NEAR(0.6 * solved.motion[k][0] + 0.8 * solved.motion[k][1], 0.0, 1e-12);
    const auto& supports = rods.matrices().equations.supports();
    double force = 0.0;
    std::size_t held = 0;
    for (std::size_t i = 0; i < supports.size(); ++i) {
      if (supports[i].source != nvh::Equations::Support::Source::motion) continue;
      force += solved.support_force[i] * (-0.8 * supports[i].taken.x + 0.6 * supports[i].taken.y);
      ++held;
    }
    EXPECT_EQ(held, dof > 0.0 ? 2u : 1u);
    expect_reference("arc", fmt::format("linear statics, DOF {:g}: force E A/L r phi [N]", dof), force,
                     E * area / length * arm * phi, 1e-6);
  }
}

/// A sheet between a rigid disc of radius 3 in its middle and a clamped rim of radius 25, t = 1.5, in rings x around
/// quadrilaterals or twice as many triangles: the moment about the normal that turns the disc by 1.
double twist_of_a_disc(int rings, int around, bool triangles) {
  constexpr double disc = 3.0, rim = 25.0, moment = 1e4;
  Specimen s;
  s.text(linear).text(ramp);
  s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3});
  s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("       1.5       1.5       1.5       1.5\n").part(1, 1, 1);
  std::vector<int> node, held;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j < around; ++j) {
      const double r = disc * std::pow(rim / disc, double(i) / rings), phi = 2.0 * M_PI * j / around;
      node.push_back(s.node({r * std::cos(phi), r * std::sin(phi), 0.0}));
      if (i == rings) held.push_back(node.back());
    }
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < around; ++j) {
      const auto corner = [&](int ring, int way) { return node[ring * around + way % around]; };
      const int a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
      if (triangles) {
        s.shell(1, {a, b, c, c});
        s.shell(1, {a, c, d, d});
      } else {
        s.shell(1, {a, b, c, d});
      }
    }
  s.node_set(1, held).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  s.node_set(7, {node.begin(), node.begin() + around}).card("CONSTRAINED_NODAL_RIGID_BODY", {7, 0, 7});
  s.card("LOAD_RIGID_BODY", {7, 7, 9, moment});
  return moment * moment / (2.0 * solve(LinearExperiment(s.deck())).energy);
}

// Plane elasticity: 4 pi G t / (1/a^2 - 1/b^2), whatever the spins of the nodes. Sabotage: drilling stiffness that does
// not go by the element's size (decision 0018: + 2.7, 4.5, 6.1 %), or none of triangles that does.
TEST(LinearStatics, ARigidDiscTurnsInItsSheet) {
  const double exact = 4.0 * M_PI * (210000.0 / 2.6) * 1.5 / (1.0 / 9.0 - 1.0 / 625.0);
  const auto expect = [&](int rings, int around, bool triangles, double gate) {
    const double stiffness = twist_of_a_disc(rings, around, triangles);
    expect_reference("rigid disc twisted in its sheet",
                     fmt::format("{} x {} {}: stiffness [N mm/rad]", rings, around,
                                 triangles ? "pairs of triangles" : "quadrilaterals"),
                     stiffness, exact, gate);
    return std::abs(stiffness / exact - 1.0);
  };
  expect(14, 36, false, 0.01);
  const double medium = expect(28, 72, false, 0.005), fine = expect(56, 144, false, 0.005);
  EXPECT_LT(fine, 0.6 * medium);
  expect(56, 144, true, 0.005);
}

}  // namespace
}  // namespace nugget::verify
