// SPDX-License-Identifier: Apache-2.0
// Dynamic relaxation before the run, against closed forms of bars.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double modulus = 210000.0, density = 7.85e-9, length = 100.0, area = 100.0;
const double wave_speed = std::sqrt(modulus / density);

/// *DEFINE_CURVE that rises to 1 within `rise` and stays there, followed in the phases that SIDR says.
std::string phase_curve(int id, int sidr, double rise = 1e-4) {
  std::string text = "*DEFINE_CURVE\n" + fields({1.0 * id, 1.0 * sidr});
  for (const auto& [time, value] : {std::pair{0.0, 0.0}, {rise, 1.0}, {1e3, 1.0}})
    text += fmt::format("{:20.12g}{:20.12g}\n", time, value);
  return text;
}
const std::string relaxation = "*CONTROL_DYNAMIC_RELAXATION\n" + fields({250, 1e-9, 0.99, 0, 0, 0, 0, 1});

/// A bar of 10 x 1 x 1 bricks, 100 x 10 x 10, nu = 0, held at x = 0, that moves along x only.
struct Bar {
  Specimen specimen;
  Grid grid;
  explicit Bar(double end_time) {
    specimen.card("MAT_ELASTIC", {1, density, modulus, 0.0})
        .card("SECTION_SOLID", {1, 1})
        .card("CONTROL_TERMINATION", {end_time})
        .part(1, 1, 1);
    grid = specimen.bricks(1, {}, {length, 10.0, 10.0}, {10, 1, 1});
    specimen.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
    specimen.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1});
    specimen.node_set(3, grid.across(10));
  }
  int tip() const { return grid.across(10).front(); }
};

// A bar that hangs in gravity is at rest when the run begins and stays so: u = rho g L^2 / (2 E) at its end, for lumped
// masses too. LCIDDR has the load at rest, so that the run's own curve may be a step at time 0.
// Sabotages: no damping; the relaxation's work left in the run's balance; the run's curve in the relaxation as well.
TEST(DynamicRelaxation, BarUnderGravityIsAtRestWhenTheRunBegins) {
  constexpr double gravity = -9.81e6;  // stretches the bar
  Bar bar(2e-4);
  bar.specimen.text(relaxation).text(phase_curve(1, 1)).text(constant_curve(2)).card("LOAD_BODY_X", {2, gravity, 1});
  Experiment experiment(bar.specimen.deck());
  const double closed = density * -gravity * length * length / (2.0 * modulus);
  double first = 0.0, least = 1e9, largest = 0.0, kinetic = 0.0, ratio = 1.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double u = experiment.displacement(now, bar.tip()).x;
    if (now.state.cycle == 0) first = u;
    least = std::min(least, u), largest = std::max(largest, u);
    kinetic = std::max(kinetic, now.energy.kinetic / now.energy.internal);
    if (std::abs(now.energy.ratio() - 1.0) > std::abs(ratio - 1.0)) ratio = now.energy.ratio();
  });
  EXPECT_TRUE(experiment.simulation().relaxation().at_rest());
  expect_reference("dynamic relaxation", "bar under gravity: its end at time 0 [mm]", first, closed, 1e-4);
  expect_reference("dynamic relaxation", "how far it moves in the run that follows", largest - least, 0.0, 1e-4,
                   closed);
  expect_reference("dynamic relaxation", "kinetic over internal energy in the run", kinetic, 0.0, 1e-8, 1.0);
  expect_reference("dynamic relaxation", "energy ratio of the run", ratio, 1.0, 1e-8);
}

// Stretched by a force that is there in the relaxation only, then released: the end snaps back and is at -u0 after half
// a period, t = 2 L / c (waves in a bar). Before that the end stands still but for the unloading wave: v = -c sigma /
// E.
TEST(DynamicRelaxation, StretchedBarIsLetGo) {
  constexpr double force = 1000.0;
  const double half_period = 2.0 * length / wave_speed, u0 = force * length / (modulus * area);
  Bar bar(1.1 * half_period);
  // Without bulk viscosity, which would damp the wave's front.
  bar.specimen.card("CONTROL_BULK_VISCOSITY", {1e-9, 1e-9})
      .text(relaxation)
      .text(phase_curve(1, 1))
      .card("LOAD_NODE_SET", {3, 1, 1, 0.25 * force});
  Experiment experiment(bar.specimen.deck());
  double first = 0.0, passage = 0.0, before = 1.0, before_time = 0.0;
  double back = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double u = experiment.displacement(now, bar.tip()).x;
    if (now.state.cycle == 0) first = u;
    if (passage == 0.0 && before > 0.0 && u <= 0.0)
      passage = before_time + (now.state.time - before_time) * before / (before - u);
    before = u, before_time = now.state.time;
    back = std::min(back, u);
  });
  expect_reference("dynamic relaxation", "stretched bar: its end at time 0 [mm]", first, u0, 1e-4);
  expect_reference("dynamic relaxation", "released: it is unstretched after L / c [s]", passage, 0.5 * half_period,
                   0.02);
  expect_reference("dynamic relaxation", "released: how far it comes back [mm]", back, -u0, 0.08);
}

// Initial velocities wait for the run, and SIDR alone asks for the relaxation.
TEST(DynamicRelaxation, InitialVelocitiesWaitAndCurvesAsk) {
  Bar bar(1e-6);
  bar.specimen.text(phase_curve(1, 2, 1e-5))
      .card("LOAD_BODY_X", {1, -9.81e6})
      .text("*INITIAL_VELOCITY_NODE\n" + fields({1.0 * bar.tip(), 123.0}));
  Experiment experiment(bar.specimen.deck());
  double velocity = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle == 0) velocity = now.v_before[experiment.node(bar.tip())].x;
  });
  EXPECT_TRUE(experiment.simulation().relaxation().at_rest());
  EXPECT_GE(experiment.simulation().relaxation().cycles(), 500)
      << "a load that acts cannot be at rest at the first look";
  EXPECT_EQ(velocity, 123.0);
}

// -999 forbids what a curve asks for; DRTERM ends a relaxation that goes nowhere.
TEST(DynamicRelaxation, ForbiddenOrEnded) {
  Bar never(1e-6);
  never.specimen.text("*CONTROL_DYNAMIC_RELAXATION\n" + fields({250, 1e-3, 0.99, 0, 0, 0, 0, -999}))
      .text(phase_curve(1, 2))
      .card("LOAD_BODY_X", {1, -9.81e6});
  Experiment plain(never.specimen.deck());
  run_to_end(plain, [](const impact::Snapshot&) {});
  EXPECT_EQ(plain.simulation().relaxation().cycles(), 0);

  Bar swings(1e-6);
  swings.specimen.text("*CONTROL_DYNAMIC_RELAXATION\n" + fields({10, 1e-9, 0.999999, 1e-4, 0, 0, 0, 1}))
      .text(phase_curve(1, 2))
      .card("LOAD_BODY_X", {1, -9.81e6});
  Experiment ended(swings.specimen.deck());
  run_to_end(ended, [](const impact::Snapshot&) {});
  EXPECT_FALSE(ended.simulation().relaxation().at_rest());
  EXPECT_GT(ended.simulation().relaxation().cycles(), 0);
}

}  // namespace
}  // namespace nugget::verify
