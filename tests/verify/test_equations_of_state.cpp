// SPDX-License-Identifier: Apache-2.0
// Equations of state: a shock against Rankine and Hugoniot, a gas against its adiabat, a tension that breaks.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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

// A brick of fluid, stretched or pressed at a constant speed, is deleted when its relative volume 1 + v t passes TEROD
// or CEROD. Sabotage: the volume itself taken for its logarithm.
TEST(EquationsOfState, ErosionByVolume) {
  constexpr double end = 1e-3, terod = 1.3, cerod = 0.7;
  for (const double speed : {500.0, -500.0}) {
    Specimen s;
    s.text("*MAT_NULL\n" + fields({1, 1e-9, 0.0, 0.0, terod, cerod}) + "*SECTION_SOLID\n" + fields({1, 1}) +
           "*PART\nblock\n" + fields({1, 1, 1, 7}) + "*EOS_LINEAR_POLYNOMIAL\n" + fields({7, 0.1, 2000.0}) +
           fields({0.0, 1.0}));
    const Grid grid = s.bricks(1, {}, {1.0, 1.0, 1.0}, {1, 1, 1});
    s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
    s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1});
    s.node_set(3, grid.across(1)).text(constant_curve(1));
    s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {3, 1, 0, 1, speed}).card("CONTROL_TERMINATION", {end});
    Experiment experiment(s.deck());
    double volume = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      if (brick_layer(experiment, now, 1).stress[0] != 0.0) volume = experiment.position(now, grid(1, 0)).x;
    });
    expect_reference("Erosion by volume",
                     speed > 0.0 ? "fluid, TEROD 1.3: relative volume" : "fluid, CEROD 0.7: relative volume", volume,
                     speed > 0.0 ? terod : cerod, 2e-3);
  }
}

// A block of copper pulled apart: with SPALL 2 and 3 it breaks at PC, carries pressure again and, pulled to ten times
// its length, has none of its own; with SPALL 1 it holds PC. Sabotage: a broken point carries tension again once it has
// been pressed; the energy of a broken point grows by the tension that it would have.
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

/// *PART 1 of *MAT_NULL and EOS 7, with next to no hourglass force.
std::string fluid(double rho, double viscosity, double cutoff = 0.0) {
  return "*MAT_NULL\n" + fields({1, rho, cutoff, viscosity}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*HOURGLASS\n" +
         fields({1, 1, 1e-6}) + "*PART\nfluid\n" + fields({1, 1, 1, 7, 1});
}

/// Water, mm, t, s.
constexpr double water = 1e-9, speed = 1.48e6, steepness = 1.92, heat = 0.28;
std::string water_state() {
  return "*EOS_GRUNEISEN\n" + fields({7, speed, steepness, 0.0, 0.0, heat, 0.0, 0.0}) + fields({1.0});
}

// A wave of 1 m/s in water, by Gruneisen's equation and by a polynomial of the same K: it runs at c and bears rho c v.
// Sabotage: the pressure's modulus with a shear modulus.
TEST(Fluids, WavesInWater) {
  constexpr double length = 200.0, v = 1000.0, end = 1.0e-4;
  constexpr int cells = 200;
  for (const bool polynomial : {false, true}) {
    Specimen s;
    s.text(fluid(water, 0.0) +
           (polynomial ? "*EOS_LINEAR_POLYNOMIAL\n" + fields({7, 0.0, water * speed * speed}) + fields({0.0, 1.0})
                       : water_state()));
    column(s, length, cells);
    s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 0, 1, v}).card("CONTROL_TERMINATION", {end});
    Experiment experiment(s.deck());
    Passage passed(0.5 * water * speed * v);
    TimeMean pressure;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      if (now.state.time < end) return;
      for (int e = 1; e <= cells; ++e) {
        const double p = -brick_layer(experiment, now, e).stress[0], x = length * (e - 0.5) / cells;
        passed.add(x, p);
        if (x > 50.0 && x < 120.0) pressure.add(p, 1.0);
      }
    });
    ASSERT_TRUE(passed.seen());
    const std::string by = polynomial ? ", polynomial" : ", Gruneisen";
    expect_reference("acoustics", "wave of 1 m/s in water" + by + ": pressure [MPa]", pressure.value(),
                     water * speed * v, 5e-3);
    expect_reference("acoustics", "wave of 1 m/s in water" + by + ": way of the front [mm]", passed.time(), speed * end,
                     5e-3);
  }
}

// A piston of 500 m/s: U = c + s u, p = rho U u. Sabotage: as for copper.
TEST(Fluids, ShockInWater) {
  constexpr double length = 100.0, piston = 5e5, end = 3e-5;
  constexpr int cells = 400;
  const double front = speed + steepness * piston;
  Specimen s;
  s.text(fluid(water, 0.0) + water_state());
  column(s, length, cells);
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 0, 1, piston}).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());
  TimeMean pressure;
  Passage passed(0.5 * water * front * piston);
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time < end) return;
    for (int e = 1; e <= cells; ++e) {
      const double p = -brick_layer(experiment, now, e).stress[0], x = length * (e - 0.5) / cells;
      passed.add(x, p);
      if (x > 25.0 && x < 55.0) pressure.add(p, 1.0);
    }
  });
  ASSERT_TRUE(passed.seen());
  expect_reference("Hugoniot", "shock in water, piston 500 m/s: pressure [MPa]", pressure.value(),
                   water * front * piston, 0.01);
  expect_reference("Hugoniot", "shock in water, piston 500 m/s: way of the front [mm]", passed.time(), front * end,
                   0.01);
}

// A column of 1 m at rest: rho g times the depth. Sabotage: the deviators of an elastic law, the sides' pressure with
// them.
TEST(Fluids, HydrostaticColumn) {
  constexpr double height = 1000.0, side = 100.0, gravity = 9810.0, end = 2e-2;
  Specimen s;
  s.text(fluid(water, 0.0) + water_state());
  const Grid grid = s.bricks(1, {}, {side, side, height}, {1, 1, 10});
  std::vector<int> bottom;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) bottom.push_back(grid(i, j, 0));
  s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 1, 1});
  s.node_set(2, bottom).card("BOUNDARY_SPC_SET", {2, 0, 0, 0, 1});
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, gravity}).card("DAMPING_GLOBAL", {0, 4000.0});
  s.card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());
  double worst = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time < end) return;
    for (int e = 1; e <= 10; ++e) {
      const double wanted = water * gravity * (height - 100.0 * (e - 0.5));
      for (std::size_t i = 0; i < 3; ++i)
        worst = std::max(worst, std::abs(-brick_layer(experiment, now, e).stress[i] / wanted - 1.0));
    }
  });
  expect_reference("hydrostatics", "column of water, 10 bricks: pressure over rho g depth, largest error", worst, 0.0,
                   1e-3, 1.0);
}

// A layer between a plate at rest and one that starts to slide: u = V (y/H + sum of 2 (-1)^n/(n pi) exp(-n^2 pi^2 nu
// t/H^2) sin(n pi y/H)), shear MU du/dy. The step is that of the viscosity, without which the run would not be stable.
// Sabotage: MU for 2 MU; no viscosity in the wave modulus.
TEST(Fluids, DragOfASlidingPlate) {
  constexpr double H = 10.0, V = 1000.0, mu = 2e-3, end = 1.5e-5, pi = 3.14159265358979323846;
  constexpr int cells = 20;
  Specimen s;
  s.text(fluid(water, mu) + water_state());
  const Grid grid = s.bricks(1, {}, {0.5, H, 0.5}, {1, cells, 1});
  std::vector<int> low, high;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 2; ++i) low.push_back(grid(i, 0, k)), high.push_back(grid(i, cells, k));
  s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  s.node_set(2, low).card("BOUNDARY_SPC_SET", {2, 0, 1});
  s.node_set(3, high).text(constant_curve(1)).card("BOUNDARY_PRESCRIBED_MOTION_SET", {3, 1, 0, 1, V});
  s.card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());
  double worst = 0.0, shear = 0.0, at = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time < end) return;
    at = now.state.time - 0.5 * now.state.dt_previous;
    const auto profile = [&](double y, bool rate) {
      double sum = rate ? 1.0 / H : y / H;
      for (int n = 1; n < 60; ++n) {
        const double fades = std::exp(-n * n * pi * pi * mu / water * at / (H * H)), sign = n % 2 ? -1.0 : 1.0;
        sum += rate ? 2.0 * sign / H * fades * std::cos(n * pi * y / H)
                    : 2.0 * sign / (n * pi) * fades * std::sin(n * pi * y / H);
      }
      return V * sum;
    };
    for (int j = 0; j <= cells; ++j)
      worst = std::max(worst, std::abs(experiment.velocity(now, grid(0, j)).x - profile(H * j / cells, false)));
    shear = brick_layer(experiment, now, cells).stress[3] / (mu * profile(H - 0.25, true));
  });
  expect_reference("viscosity", "layer of fluid under a sliding plate: velocity, largest error of the plate's",
                   worst / V, 0.0, 1e-2, 1.0);
  expect_reference("viscosity", "layer of fluid under a sliding plate: shear stress over MU du/dy", shear, 1.0, 1e-2);
}

/// One brick of a fluid whose length becomes `to` of the first: pressures at the start, in the end and the least.
struct Squeezed {
  double first = 0.0, last = 0.0, least = 1e300;
};
Squeezed squeezed(const std::string& deck, double to) {
  constexpr double end = 1e-2;
  Specimen s;
  s.text(deck);
  const Grid grid = s.bricks(1, {}, {1.0, 1.0, 1.0}, {1, 1, 1});
  s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1});
  s.node_set(3, grid.across(1)).text(smooth_ramp(1, end));
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {3, 1, 2, 1, to - 1.0}).card("CONTROL_TERMINATION", {end});
  Experiment experiment(s.deck());
  Squeezed result;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    result.last = -brick_layer(experiment, now, 1).stress[0];
    result.least = std::min(result.least, result.last);
    if (now.state.cycle == 0) result.first = result.last;
  });
  return result;
}

// Air at 293 degrees: p = rho (CP - CV) T, then p V^gamma constant. Sabotage: CP for CV in the energy at the start.
TEST(EquationsOfState, IdealGas) {
  constexpr double rho = 1.2e-12, cv = 7.18e8, cp = 1.005e9, T = 293.0;
  const Squeezed air =
      squeezed(fluid(rho, 0.0) + "*EOS_IDEAL_GAS\n" + fields({7, cv, cp, 0.0, 0.0, T, 1.0}) + fields({0.0}), 0.5);
  expect_reference("Adiabat", "*EOS_IDEAL_GAS, air: pressure at the start [MPa]", air.first, rho * (cp - cv) * T, 1e-6);
  expect_reference("Adiabat", "*EOS_IDEAL_GAS, air: pressure at half of its volume over that at the start",
                   air.last / air.first, std::pow(2.0, cp / cv), 1e-3);
}

std::string wide(std::initializer_list<double> values) {
  std::string line;
  for (const double v : values) line += fmt::format("{:16.9g}", v);
  return line + '\n';
}

// C = -K ln V by points and by a curve, beyond both ends of them; and p = gamma E with T = 1, so that E decays with V
// as exp(-gamma V). Sabotage: the last value for the last line; T without gamma.
TEST(EquationsOfState, Tabulated) {
  constexpr double K = 2000.0;
  const std::string head = fluid(1e-9, 0.0) + "*EOS_TABULATED\n";
  const std::string points = head + fields({7, 0.0, 0.0, 1.0}) + wide({0.0, -0.1, -0.2}) + wide({}) +
                             wide({0.0, 0.1 * K, 0.2 * K}) + wide({}) + wide({}) + wide({});
  const std::string line = head + fields({7, 0.0, 0.0, 1.0, 8}) + curve(8, {{-0.2, 0.2 * K}, {-0.1, 0.1 * K}, {0, 0}});
  for (const std::string& deck : {points, line}) {
    expect_reference("table", "*EOS_TABULATED, C = -K ln V beyond its points: pressure at half of the volume [MPa]",
                     squeezed(deck, 0.5).last, K * std::log(2.0), 1e-6);
    expect_reference("table", "the same pulled to 1.2 of its length", squeezed(deck, 1.2).last, -K * std::log(1.2),
                     1e-6);
  }
  const std::string hot = head + fields({7, 0.5, 3.0, 1.0}) + wide({-1.0, 1.0}) + wide({}) + wide({0.0, 0.0}) +
                          wide({}) + wide({1.0, 1.0}) + wide({});
  const Squeezed gas = squeezed(hot, 0.5);
  expect_reference("table", "*EOS_TABULATED, p = gamma E: pressure at the start [MPa]", gas.first, 1.5, 1e-6);
  expect_reference("table", "the same at half of the volume", gas.last, 1.5 * std::exp(0.25), 1e-3);
}

// Water pulled apart carries -PC and no more. Sabotage: no limit (-K/6).
TEST(Fluids, TensionIsCutOff) {
  const Squeezed pulled = squeezed(fluid(water, 0.0, -0.1) + water_state(), 1.2);
  expect_reference("cavitation", "water, PC = -0.1 MPa, pulled: least pressure [MPa]", pulled.least, -0.1, 1e-9);
  EXPECT_LT(squeezed(fluid(water, 0.0) + water_state(), 1.2).least, -100.0);
}

}  // namespace
}  // namespace nugget::verify
