// SPDX-License-Identifier: Apache-2.0
// The discrete Kirchhoff triangle (ELFORM 17): thin plates against closed forms and published values, in linear
// analyses and in time.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "nvh/matrices/stresses.hpp"
#include "nvh/statics/statics.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

const char* const linear_statics =
    "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
    "*CONTROL_TERMINATION\n       1.0\n*DEFINE_CURVE\n         9\n                 0.0                 0.0\n"
    "                 1.0                 1.0\n";

/// A rectangle in the plane z = 0 of cells that are each parted into two triangles, along diagonals that alternate.
struct Plate {
  Specimen specimen;
  Grid grid;

  Plate(int elform, double a, double b, double t, int nx, int ny, const std::string& material, double layers = 2) {
    specimen.text(material);
    specimen.text("*SECTION_SHELL\n" + fields({1, 1.0 * elform, 5.0 / 6.0, layers}) + fields({t, t, t, t}));
    specimen.part(1, 1, 1);
    grid.cells = {nx, ny, 0};
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) specimen.node({a * i / nx, b * j / ny, 0.0});
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const int n[4] = {grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1)};
        const std::size_t turn = (i + j) % 2 == 0 ? 0 : 1;
        const auto corner = [&](std::size_t k) { return n[(k + turn) % 4]; };
        specimen.shell(1, {corner(0), corner(1), corner(2), corner(2)});
        specimen.shell(1, {corner(0), corner(2), corner(3), corner(3)});
      }
  }
  std::vector<int> edges() const {
    std::vector<int> ids;
    for (int j = 0; j <= grid.cells[1]; ++j)
      for (int i = 0; i <= grid.cells[0]; ++i)
        if (i == 0 || j == 0 || i == grid.cells[0] || j == grid.cells[1]) ids.push_back(grid(i, j));
    return ids;
  }
};

std::string elastic(double density, double modulus, double nu) {
  return "*MAT_ELASTIC\n" + fields({1, density, modulus, nu});
}

nvh::Statics solve(const LinearExperiment& experiment) {
  Findings findings;
  const nvh::Statics s = nvh::solve_statics(experiment.matrices(), findings);
  EXPECT_EQ(findings.errors(), 0);
  EXPECT_LT(s.residual, 1e-8);
  return s;
}

double deflection(const LinearExperiment& experiment, const nvh::Statics& solved, int id) {
  return solved.motion[experiment.system().node_of[experiment.system().model.node_index(id)]][2];
}

// MacNeal and Harder's patch, each of its five shells parted into two triangles, bent to a constant curvature.
TEST(KirchhoffTriangles, BendingPatch) {
  Specimen s;
  s.text(linear_statics).text(elastic(1e-9, 1e6, 0.25));
  s.card("SECTION_SHELL", {1, 17, 0.833333, 2}).text("     0.001     0.001     0.001     0.001\n").part(1, 1, 1);
  const Vec3d place[] = {{0, 0, 0},     {.24, 0, 0},   {.24, .12, 0}, {0, .12, 0},
                         {.04, .02, 0}, {.18, .03, 0}, {.16, .08, 0}, {.08, .08, 0}};
  std::array<int, 8> n{};
  for (std::size_t k = 0; k < 8; ++k) n[k] = s.node(place[k]);
  for (const std::array<std::size_t, 4>& e : std::initializer_list<std::array<std::size_t, 4>>{
           {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}) {
    s.shell(1, {n[e[0]], n[e[1]], n[e[2]], n[e[2]]});
    s.shell(1, {n[e[0]], n[e[2]], n[e[3]], n[e[3]]});
  }
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3d& x = place[k];
    const double u[3] = {0.5e-3 * (x.x * x.x + x.x * x.y + x.y * x.y), 1e-3 * (x.y + 0.5 * x.x),
                         -1e-3 * (x.x + 0.5 * x.y)};
    constexpr double freedom[] = {3, 5, 6};
    double held[3];
    for (std::size_t i = 0; i < 3; ++i) {
      held[i] = u[i] == 0.0;  // a scale of 0 would mean its default
      if (u[i] != 0.0) s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * n[k], freedom[i], 2, 9, u[i]});
    }
    s.card("BOUNDARY_SPC_NODE", {1.0 * n[k], 0, 1, 1, held[0], held[1], held[2], 1});
  }
  const LinearExperiment patch(s.deck());
  const nvh::ElasticStresses stresses(patch.system(), solve(patch).motion);
  double xx = -2.0 / 3.0, xy = -0.2;
  for (const auto& location : stresses.system().shell_location) {
    const auto stress = stresses.stress(location, 1);
    const double direct = std::sqrt(3.0) * stress[0], shear = std::sqrt(3.0) * stress[3];
    if (std::abs(direct + 2.0 / 3.0) > std::abs(xx + 2.0 / 3.0)) xx = direct;
    if (std::abs(shear + 0.2) > std::abs(xy + 0.2)) xy = shear;
  }
  expect_reference("bending patch", "bending patch, ELFORM 17: direct stress at the surface, worst triangle", xx,
                   -2.0 / 3.0, 1e-6);
  expect_reference("bending patch", "bending patch, ELFORM 17: shear stress at the surface, worst triangle", xy, -0.2,
                   1e-6);
}

/// Deflection of the middle of a square plate under a force there, times D / (P a^2).
double middle(int elform, int n, bool clamped, const std::string& control = "") {
  constexpr double a = 100.0, t = 0.5, nu = 0.3, modulus = 210000.0;
  Plate plate(elform, a, a, t, n, n, linear_statics + control + elastic(7.85e-9, modulus, nu));
  const double turn = clamped ? 1 : 0;
  plate.specimen.node_set(1, plate.edges()).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, turn, turn, 1});
  plate.specimen.card("LOAD_NODE_POINT", {1.0 * plate.grid(n / 2, n / 2), 3, 9, 1.0});
  const LinearExperiment experiment(plate.specimen.deck());
  return deflection(experiment, solve(experiment), plate.grid(n / 2, n / 2)) * modulus * t * t * t /
         (12.0 * (1.0 - nu * nu) * a * a);
}

// Timoshenko and Woinowsky-Krieger: .01160 P a^2 / D, .00560 clamped. Sabotage: the bubbles of the slopes left out.
TEST(KirchhoffTriangles, SquarePlateUnderAForceInTheMiddle) {
  expect_reference("plate", "square plate, simply supported, force in the middle, ELFORM 17, 8 x 8 x 2: w D / P a^2",
                   middle(17, 8, false), 0.01160, 2e-2);
  expect_reference("plate", "the same, 16 x 16 x 2", middle(17, 16, false), 0.01160, 6e-3);
  expect_reference("plate", "square plate, clamped, force in the middle, ELFORM 17, 16 x 16 x 2: w D / P a^2",
                   middle(17, 16, true), 0.00560, 1.5e-2);
  // ESORT 2 takes collapsed quads out of their section.
  EXPECT_DOUBLE_EQ(middle(16, 4, true, "*CONTROL_SHELL\n      20.0         2\n"), middle(17, 4, true));
  EXPECT_NE(middle(16, 4, true, "*CONTROL_SHELL\n      20.0         1\n"), middle(17, 4, true));
}

// P L^3 / (3 E I) = .952381 mm with Poisson 0: two triangles across, five along.
TEST(KirchhoffTriangles, CoarseCantilever) {
  Plate strip(17, 200.0, 20.0, 2.0, 5, 1, linear_statics + elastic(7.85e-9, 210000.0, 0.0));
  strip.specimen.node_set(1, {strip.grid(0, 0), strip.grid(0, 1)}).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  const std::vector<int> tip{strip.grid(5, 0), strip.grid(5, 1)};
  strip.specimen.node_set(2, tip).card("LOAD_NODE_SET", {2, 3, 9, 0.5});
  const LinearExperiment experiment(strip.specimen.deck());
  const nvh::Statics solved = solve(experiment);
  expect_reference("plate", "cantilever strip of 10 triangles ELFORM 17: deflection for 1 N [mm]",
                   0.5 * (deflection(experiment, solved, tip[0]) + deflection(experiment, solved, tip[1])), 0.952381,
                   1e-2);
}

// The free square plate (FV12); six free motions are asserted by elastic_frequencies.
TEST(KirchhoffTriangles, FreeSquarePlate) {
  const Plate plate(17, 10.0, 10.0, 0.05, 16, 16,
                    "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n        20\n" +
                        elastic(8000.0, 200e9, 0.3));
  const std::vector<double> found = LinearExperiment(plate.specimen.deck()).elastic_frequencies(8);
  const double expected[] = {1.6217, 2.3595, 2.9223, 4.1902, 4.1902, 7.3560, 7.3560, 7.6682};
  for (std::size_t i = 0; i < 8; ++i)
    expect_reference("free square plate (FV12)",
                     fmt::format("free plate (FV12), 16 x 16 x 2 triangles ELFORM 17: mode {} [Hz]", i + 1), found[i],
                     expected[i], 1e-2);
}

// The Balmer-Witmer beam as in test_plasticity.cpp, of triangles. Sabotage: the forces of one side left out of its
// nodes' moments.
TEST(KirchhoffTriangles, BalmerWitmerBeam) {
  constexpr int cells = 50;
  Plate beam(17, 5.0, 0.6, 0.125, cells, 3,
             "*MAT_PLASTIC_KINEMATIC\n" + fields({1, 2.61e-4, 1.04e7, 0.3, 41400.0, 0.0, 1.0}) + fields({}), 10);
  Specimen& s = beam.specimen;
  const Grid& grid = beam.grid;
  const auto across = [&](int i) { return std::vector<int>{grid(i, 0), grid(i, 1), grid(i, 2), grid(i, 3)}; };
  s.node_set(1, across(cells)).card("BOUNDARY_SPC_SET", {1, 0, 1, 0, 1, 1, 1, 1});
  s.node_set(2, across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1, 0, 0, 0, 1, 1});
  std::vector<int> middle;
  for (int i = 0; i <= cells; ++i) middle.push_back(grid(i, 0));
  s.node_set(3, middle).card("BOUNDARY_SPC_SET", {3, 0, 0, 1, 0, 1, 0, 1});
  for (int i = 0; i <= cells / 5; ++i)
    for (int id : across(i)) s.card("INITIAL_VELOCITY_NODE", {1.0 * id, 0, 0, i < cells / 5 ? 5000.0 : 2500.0});
  s.card("CONTROL_TERMINATION", {8.0e-4});
  Experiment experiment(s.deck());
  double peak = 0.0, when = 0.0, ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (when == 0.0 && experiment.velocity(now, grid(0, 0)).z < 0.0) when = now.state.time;
    peak = std::max(peak, experiment.displacement(now, grid(0, 0)).z);
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
  });
  expect_reference("Balmer-Witmer beam", "Balmer-Witmer beam, 50 x 3 x 2 triangles ELFORM 17: peak deflection [in]",
                   peak, 0.737, 0.04);
  expect_reference("Balmer-Witmer beam", "Balmer-Witmer beam, 50 x 3 x 2 triangles ELFORM 17: first rest [s]", when,
                   4.80e-4, 0.04);
  EXPECT_LT(ratio, 0.01);
}

// Free of everything, thrown and twisted, at TSSFAC 0.9, thin and thicker than its triangles are high: the energy
// stays. Sabotage: the step of bending left out (the thick one explodes).
TEST(KirchhoffTriangles, FreePlateKeepsItsEnergy) {
  for (const double t : {0.5, 6.0}) {
    Plate plate(17, 20.0, 20.0, t, 4, 4, elastic(7.85e-9, 210000.0, 0.3));
    constexpr double end = 2.0e-3;
    Specimen& s = plate.specimen;
    s.card("CONTROL_TERMINATION", {end});
    s.card("INITIAL_VELOCITY_NODE", {1.0 * plate.grid(0, 0), 500.0, 0.0, 2000.0, 100.0, -200.0, 0.0});
    s.card("INITIAL_VELOCITY_NODE", {1.0 * plate.grid(4, 4), 0.0, 500.0, 2000.0, 0.0, 200.0, 0.0});
    Experiment experiment(s.deck());
    // Velocities are known between the steps: the sum swings about its mean, which must not move.
    TimeMean early, late;
    double stored = 0.0;
    int cycles = 0;
    experiment.run([&](const impact::Snapshot& now) {
      ++cycles;
      const double total = now.energy.kinetic + now.energy.internal;
      if (now.state.time < 0.25 * end) early.add(total, now.state.dt);
      if (now.state.time > 0.75 * end) late.add(total, now.state.dt);
      stored = std::max(stored, now.energy.internal / total);
    });
    EXPECT_GT(cycles, 1500) << t;
    EXPECT_GT(stored, 0.1) << t;
    EXPECT_NEAR(late.value() / early.value(), 1.0, 5e-3) << t;
  }
}

}  // namespace
}  // namespace nugget::verify
