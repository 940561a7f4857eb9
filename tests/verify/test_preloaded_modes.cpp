// SPDX-License-Identifier: Apache-2.0
// Modes with the geometric stiffness of initial stresses and of static loads, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "nvh/matrices/prestress.hpp"
#include "nvh/statics/statics.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi, young = 210000.0, density = 7.85e-9;

Specimen linear_deck() {
  Specimen s;
  s.text(
      "*CONTROL_TERMINATION\n       1.0\n*CONTROL_IMPLICIT_GENERAL\n         1       1.0                             "
      "1\n"
      "*CONTROL_IMPLICIT_SOLUTION\n         1\n*CONTROL_IMPLICIT_EIGENVALUE\n        20\n"
      "*DEFINE_CURVE\n         9\n                 0.0                 0.0\n                 1.0                 "
      "1.0\n");
  return s;
}

std::string shell_stress(int count, double xx, double yy) {
  std::string s = "*INITIAL_STRESS_SHELL\n";
  for (int e = 1; e <= count; ++e) s += fields({1.0 * e, 1, 1}) + fields({0, xx, yy, 0, 0, 0, 0, 0});
  return s;
}

/// Modes of the deck under its initial stresses, and under its static loads where `loaded`.
nvh::Modes modes_of(const std::string& deck, int count, bool loaded = false) {
  const LinearExperiment experiment(deck);
  nvh::Matrices m = experiment.matrices();
  const auto prestress = std::make_shared<nvh::Prestress>(m);
  prestress->add_initial();
  Findings findings;
  if (loaded) prestress->add(nvh::solve_statics(m, findings).motion);
  nvh::stiffen(m, prestress);
  nvh::ModeRequest request;
  request.count = count;
  nvh::Modes modes = nvh::find_modes(m, request);
  EXPECT_TRUE(modes.proof.complete());
  return modes;
}

/// A beam 200 x 20 x 2 of shells without Poisson's effect on two supports, one of which can slide along it.
struct Strip {
  static constexpr double length = 200.0, width = 20.0, height = 2.0, inertia = width * height * height * height / 12.0;
  static constexpr int along = 40, across = 2;
  Specimen s = linear_deck();
  Grid grid;

  Strip() {
    s.card("MAT_ELASTIC", {1, density, young, 0.0});
    s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("       2.0       2.0       2.0       2.0\n").part(1, 1, 1);
    grid = s.shells(1, {}, {length, width, 0.0}, along, across);
    s.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 0, 1});
    s.node_set(2, grid.across(along)).card("BOUNDARY_SPC_SET", {2, 0, 0, 1, 1, 1, 0, 1});
    s.node_set(3, grid.all()).card("BOUNDARY_SPC_SET", {3, 0, 0, 1, 0, 1, 0, 1});  // bending in one plane
  }
  static double critical() { return pi * pi * young * inertia / (length * length); }
  /// Bending frequency n under an axial force.
  static double frequency(int n, double force) {
    const double wave = n * pi / length;
    return wave * std::sqrt((young * inertia * wave * wave + force) / (density * width * height)) / (2.0 * pi);
  }
  void pull(double force) { s.text(shell_stress(along * across, force / (width * height), 0.0)); }
  void load(double force) {
    for (int j = 0; j <= across; ++j)
      s.card("LOAD_NODE_POINT", {1.0 * grid(along, j), 1, 9, force / across * (j == 0 || j == across ? 0.5 : 1.0)});
  }
};

// Sabotage: the sign of K_s; the thickness left out of the membrane force.
TEST(PreloadedModes, PulledAndPressedBeamByInitialStress) {
  for (const double share : {10.0, 1.0, -0.5, -0.9}) {
    Strip strip;
    strip.pull(share * Strip::critical());
    const nvh::Modes modes = modes_of(strip.s.deck(), 3);
    for (int n = 1; n <= 3; ++n)
      expect_reference("preload",
                       fmt::format("beam on two supports, {} of Euler's load pulling: mode {} [Hz]", share, n),
                       modes.frequency(at(n - 1)), Strip::frequency(n, share * Strip::critical()), 1e-2);
  }
  Strip soft;
  soft.pull(-0.99 * Strip::critical());
  EXPECT_LT(modes_of(soft.s.deck(), 1).frequency(0), 0.12 * Strip::frequency(1, 0.0));
  Strip buckled;
  buckled.pull(-1.02 * Strip::critical());
  EXPECT_THROW(modes_of(buckled.s.deck(), 1), nvh::Factorization::SolverError);
}

// Sabotage: the static solution at time 0; the force of one layer only.
TEST(PreloadedModes, PulledAndPressedBeamByStaticLoad) {
  for (const double share : {2.0, -0.5}) {
    Strip strip;
    strip.load(share * Strip::critical());
    const nvh::Modes modes = modes_of(strip.s.deck(), 2, true);
    for (int n = 1; n <= 2; ++n)
      expect_reference("preload", fmt::format("beam under a load of {} of Euler's: mode {} [Hz]", share, n),
                       modes.frequency(at(n - 1)), Strip::frequency(n, share * Strip::critical()), 1e-2);
  }
}

// A cantilever loses its frequency at pi^2 E I / (4 L^2). Sabotage: as above.
TEST(PreloadedModes, CantileverToItsBucklingLoad) {
  const auto first = [](double share) {
    Strip strip;
    strip.s = linear_deck();
    Specimen& s = strip.s;
    s.card("MAT_ELASTIC", {1, density, young, 0.0});
    s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("       2.0       2.0       2.0       2.0\n").part(1, 1, 1);
    strip.grid = s.shells(1, {}, {Strip::length, Strip::width, 0.0}, Strip::along, Strip::across);
    s.node_set(1, strip.grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
    strip.load(-0.25 * share * Strip::critical());
    return modes_of(s.deck(), 1, true).eigenvalue[0];
  };
  // omega^2 falls all but linearly with the load; its zero is the buckling load.
  const double low = first(0.90), high = first(0.98);
  expect_reference("preload", "cantilever: load at which its frequency is zero, share of Euler's",
                   0.98 + 0.08 * high / (low - high), 1.0, 5e-3);
}

// Stretched along one edge: omega^2 rho t = D (p^2 + q^2)^2 + N p^2. Sabotage: N along the other edge.
TEST(PreloadedModes, StretchedPlate) {
  constexpr double a = 400.0, b = 300.0, t = 1.5, nu = 0.3, stress = 20.0;
  Specimen s = linear_deck();
  s.card("MAT_ELASTIC", {1, density, young, nu});
  s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("       1.5       1.5       1.5       1.5\n").part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {a, b, 0.0}, 32, 24);
  std::vector<int> edge;
  for (int j = 0; j <= 24; ++j)
    for (int i = 0; i <= 32; ++i)
      if (i == 0 || j == 0 || i == 32 || j == 24) edge.push_back(grid(i, j));
  s.node_set(1, edge).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  s.text(shell_stress(32 * 24, stress, 0.0));
  std::vector<double> exact;
  for (int m = 1; m < 5; ++m)
    for (int n = 1; n < 5; ++n) {
      const double p = m * pi / a, q = n * pi / b, d = young * t * t * t / (12.0 * (1.0 - nu * nu));
      exact.push_back(std::sqrt((d * (p * p + q * q) * (p * p + q * q) + stress * t * p * p) / (density * t)) /
                      (2.0 * pi));
    }
  std::sort(exact.begin(), exact.end());
  const nvh::Modes modes = modes_of(s.deck(), 5);
  for (std::size_t i = 0; i < 5; ++i)
    expect_reference("preload", fmt::format("plate 400 x 300 x 1.5 stretched by 20 N/mm2: mode {} [Hz]", i + 1),
                     modes.frequency(i), exact[i], 1e-2);
}

// Two bricks through the height, held along the middle. Sabotage: the gradient of a shape function with a wrong sign.
TEST(PreloadedModes, PulledBeamOfBricks) {
  constexpr double length = 200.0, height = 4.0, stress = 50.0;
  Specimen s = linear_deck();
  s.card("MAT_ELASTIC", {1, density, young, 0.0}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  const Grid grid = s.bricks(1, {}, {length, 4.0, height}, {50, 1, 2});
  std::vector<int> ends;
  for (const int i : {0, 50})
    for (const int j : {0, 1}) ends.push_back(grid(i, j, 1));
  s.node_set(1, ends).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  s.node_set(2, grid.all()).card("BOUNDARY_SPC_SET", {2, 0, 0, 1});
  s.node_set(3, {grid(0, 0, 1), grid(0, 1, 1)}).card("BOUNDARY_SPC_SET", {3, 0, 1});
  std::string cards = "*INITIAL_STRESS_SOLID\n";
  for (int e = 1; e <= 100; ++e) cards += fields({1.0 * e, 1}) + fields({stress, 0, 0, 0, 0, 0, 0});
  s.text(cards);
  const nvh::Modes modes = modes_of(s.deck(), 2);
  for (int n = 1; n <= 2; ++n) {
    const double wave = n * pi / length,
                 exact =
                     wave * std::sqrt((young * height * height / 12.0 * wave * wave + stress) / density) / (2.0 * pi);
    expect_reference("preload", fmt::format("beam of bricks pulled by 50 N/mm2: mode {} [Hz]", n),
                     modes.frequency(at(n - 1)), exact, 1e-2);
  }
}

// Trusses of a string have no stiffness across it but by their force: omega = 2 / h sqrt(T / (rho A)) sin(n pi / 2N) of
// masses on a massless string. Sabotage: what K alone does not resist held.
TEST(PreloadedModes, TautString) {
  constexpr int n = 20;
  constexpr double length = 1000.0, area = 2.0, tension = 500.0, h = length / n;
  Specimen s = linear_deck();
  s.card("MAT_ELASTIC", {1, density, young, 0.3});
  s.text("*SECTION_BEAM\n" + fields({1, 3}) + fields({area})).part(1, 1, 1);
  std::vector<int> nodes;
  for (int i = 0; i <= n; ++i) nodes.push_back(s.node({h * i, 0, 0}));
  std::string beams = "*ELEMENT_BEAM\n";
  for (std::size_t i = 0; i < n; ++i) beams += fmt::format("{:8}{:8}{:8}{:8}\n", i + 1, 1, nodes[i], nodes[i + 1]);
  s.text(beams + "*SET_BEAM\n" + fields({1}) + fields({1, 2, 3, 4, 5, 6, 7, 8}) +
         fields({9, 10, 11, 12, 13, 14, 15, 16}) + fields({17, 18, 19, 20}) + "*INITIAL_AXIAL_FORCE_BEAM\n" +
         fields({1, 8, tension}) + constant_curve(8));
  s.node_set(1, {nodes.front(), nodes.back()}).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  s.node_set(2, nodes).card("BOUNDARY_SPC_SET", {2, 0, 0, 0, 1});
  const nvh::Modes modes = modes_of(s.deck(), 4);
  for (int k = 1; k <= 4; ++k)
    expect_reference("preload", fmt::format("taut string of 20 trusses: mode {} [rad/s]", k),
                     std::sqrt(modes.eigenvalue[k - 1]),
                     2.0 / h * std::sqrt(tension / (density * area)) * std::sin(k * pi / (2.0 * n)), 1e-9);
}

// A mass between two springs that its supports stretch: omega^2 = 2 k / m along them, 2 T / (L m) across. Sabotage:
// tension that stiffens the springs along their line as well.
TEST(PreloadedModes, MassBetweenStretchedSprings) {
  constexpr double k = 50.0, mass = 1e-3, length = 100.0, stretch = 10.0, tension = 0.5 * k * stretch;
  Specimen s = linear_deck();
  s.text("*MAT_SPRING_ELASTIC\n" + fields({1, k}) + "*SECTION_DISCRETE\n" + fields({1, 0}) + fields({0, 0}));
  s.part(1, 1, 1);
  const int a = s.node({0, 0, 0}), m = s.node({length, 0, 0}), b = s.node({2.0 * length, 0, 0});
  s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}\n{:8}{:8}{:8}{:8}\n", 1, 1, a, m, 2, 1, m, b));
  s.text(fmt::format("*ELEMENT_MASS\n{:8}{:8}{:16g}\n", 1, m, mass));
  s.card("BOUNDARY_SPC_NODE", {1.0 * a, 0, 1, 1, 1}).card("BOUNDARY_SPC_NODE", {1.0 * b, 0, 0, 1, 1});
  s.card("BOUNDARY_SPC_NODE", {1.0 * m, 0, 0, 0, 1});
  s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * b, 1, 2, 9, stretch});
  const nvh::Modes modes = modes_of(s.deck(), 2, true);
  expect_reference("preload", "mass between stretched springs, across [rad/s]", std::sqrt(modes.eigenvalue[0]),
                   std::sqrt(2.0 * tension / length / mass), 1e-9);
  expect_reference("preload", "mass between stretched springs, along [rad/s]", std::sqrt(modes.eigenvalue[1]),
                   std::sqrt(2.0 * k / mass), 1e-9);
}

}  // namespace
}  // namespace nugget::verify
