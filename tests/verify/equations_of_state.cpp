// SPDX-License-Identifier: Apache-2.0
// Equations of state: a shock against Rankine and Hugoniot, a gas against its adiabat, a tension that breaks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

/// *PART 1 of *MAT_015 of shear modulus G and yield stress A, next to nothing unless given, and EOS 7.
std::string part(double density, double G, double yield, double cutoff = 0.0, double spall = 2.0) {
  return "*MAT_JOHNSON_COOK\n" + fields({1, density, G}) + fields({yield}) + fields({0.0, cutoff, spall}) +
         fields({0.0}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*PART\nblock\n" + fields({1, 1, 1, 7});
}

/// Copper, mm, t, s (M.A. Meyers, Dynamic Behavior of Materials, 1994, table 4.4).
constexpr double density = 8.93e-9, sound = 3.94e6, slope = 1.49, gruneisen = 1.96;
std::string copper() {
  return "*EOS_GRUNEISEN\n" + fields({7, sound, slope, 0.0, 0.0, gruneisen, 0.0, 0.0}) + fields({1.0});
}

/// A column of bricks along x, free along x only.
Grid column(Specimen& s, double length, int cells) {
  const double side = length / cells;
  const Grid grid = s.bricks(1, {}, {length, side, side}, {cells, 1, 1});
  s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  s.node_set(2, grid.across(0)).text(constant_curve(1));
  return grid;
}

// A piston at 2 km/s into copper at rest: U = c + s u, p = rho U u, relative volume 1 - u/U, energy u^2/2 a mass.
// The line of Hugoniot is the one that the equation is built on, so its energy must be right: without the work of the
// bulk viscosity the shock is too cold. Sabotage: add_viscous_work does nothing; gamma0 E left out.
TEST(EquationsOfState, ShockInCopper) {
  constexpr double length = 100.0, piston = 2e6, end = 1.2e-5;
  constexpr int cells = 400;
  const double front = sound + slope * piston;
  Specimen s;
  s.text(part(density, 1.0, 1e-3) + copper());
  const Grid grid = column(s, length, cells);
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 0, 1, piston}).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());
  TimeMean pressure;
  Passage passed(0.5 * density * front * piston);
  double volume = 0.0, ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
    if (now.state.time < end) return;
    for (int e = 1; e <= cells; ++e) {
      const double p = -brick_layer(experiment, now, e).stress[0], x = length * (e - 0.5) / cells;
      passed.add(x, p);
      if (x > 15.0 && x < 40.0) pressure.add(p, 1.0);
    }
    volume = (experiment.position(now, grid(160, 0)).x - experiment.position(now, grid(60, 0)).x) / 25.0;
  });
  ASSERT_TRUE(passed.seen());
  expect_reference("Hugoniot", "shock in copper, piston 2 km/s: pressure [MPa]", pressure.value(),
                   density * front * piston, 0.01);
  expect_reference("Hugoniot", "shock in copper, piston 2 km/s: relative volume", volume, 1.0 - piston / front, 2e-3);
  expect_reference("Hugoniot", "shock in copper, piston 2 km/s: way of the front [mm]", passed.time(), front * end,
                   0.01);
  expect_reference("Hugoniot", "shock in copper, piston 2 km/s: energy ratio", 1.0 + ratio, 1.0, 2e-3);
}

// An ideal gas, C4 = C5 = gamma - 1, squeezed slowly to half of its volume: p V^gamma is constant. Sabotage: half of
// the pressure's work left out of the energy.
TEST(EquationsOfState, AdiabatOfAGas) {
  constexpr double gamma = 1.4, start = 0.1, end = 1e-2;
  Specimen s;
  s.text(part(1.2e-12, 1e-5, 1e-6) + "*EOS_LINEAR_POLYNOMIAL\n" +
         fields({7, 0.0, 0.0, 0.0, 0.0, gamma - 1.0, gamma - 1.0}) + fields({start / (gamma - 1.0), 1.0}));
  const Grid grid = s.bricks(1, {}, {1.0, 1.0, 1.0}, {1, 1, 1});
  s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1});
  s.node_set(3, grid.across(1)).text(smooth_ramp(1, end));
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {3, 1, 2, 1, -0.5}).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());
  double first = 0.0, last = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    last = -brick_layer(experiment, now, 1).stress[0];
    if (first == 0.0) first = last;
  });
  expect_reference("Adiabat", "ideal gas, pressure at the start [MPa]", first, start, 1e-6);
  expect_reference("Adiabat", "ideal gas, pressure at half of its volume over that at the start", last / first,
                   std::pow(2.0, gamma), 1e-3);
}

// A block of copper pulled apart: with SPALL 2 and 3 it breaks at PC, bears pressure again and, pulled to ten times its
// length, has none of its own; with SPALL 1 it holds PC. Sabotage: a broken point bears tension again once it has been
// pressed; the energy of a broken point grows by the tension that it would have.
TEST(EquationsOfState, Spall) {
  constexpr double K = density * sound * sound, cutoff = 1000.0, end = 1e-4;
  for (const double form : {1.0, 2.0, 3.0}) {
    Specimen s;
    s.text(part(density, 48000.0, 100.0, -cutoff, form) + copper());
    const Grid grid = s.bricks(1, {}, {1.0, 1.0, 1.0}, {1, 1, 1});
    s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
    s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1});
    s.node_set(3, grid.across(1));
    s.text(curve(1, {{0.0, 0.0}, {0.3 * end, 0.02}, {0.6 * end, -0.01}, {end, 9.0}}));
    s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {3, 1, 2, 1, 1.0}).card("CONTROL_TERMINATION", {end});
    Experiment experiment(s.deck());
    double most = 0.0, least = 0.0, late = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      const auto& stress = brick_layer(experiment, now, 1).stress;
      const double mean = (stress[0] + stress[1] + stress[2]) / 3.0;
      most = std::max(most, form == 2.0 ? stress[0] : mean);
      least = std::min(least, mean);
      late = mean;
    });
    EXPECT_LE(most, cutoff * (1.0 + 1e-9)) << form;
    EXPECT_GT(most, 0.95 * cutoff) << form;
    // mu = 1/99; the heat of the work of pulling and pressing, at most 20 MPa, beside it.
    const double mu = 1.0 / 99.0, bow = 1.0 - 0.5 * gruneisen, root = 1.0 - (slope - 1.0) * mu;
    const double cold = K * mu * (1.0 + bow * mu) / (root * root);
    EXPECT_NEAR(least, -cold, 0.03 * cold) << form;
    EXPECT_NEAR(late, form == 1.0 ? cutoff : 0.0, 1e-6) << form;
  }
}

}  // namespace
}  // namespace nugget::verify
