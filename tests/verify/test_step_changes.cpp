// SPDX-License-Identifier: Apache-2.0
// The energy account when the time step changes: an oscillator against the closed form of its discrete motion, and
// models with supports and walls, whose energy balance has to close (docs/decisions/0021).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "brick_decks.hpp"
#include "experiment.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

/// Step curve 90 that jumps between `steps` every `every`.
std::string jumping_steps(std::initializer_list<double> steps, double every, int jumps) {
  std::string text = "*DEFINE_CURVE\n" + fields({90, 0, 1, 1, 0, 0, 0});
  const std::vector<double> step(steps);
  for (int i = 0; i < jumps; ++i) {
    const double value = step[at(i) % step.size()];
    text += fmt::format("{:20.12g}{:20.12g}\n{:20.12g}{:20.12g}\n", i * every, value, (i + 1 - 1e-9) * every, value);
  }
  return text;
}

/// A free weld beam whose ends part with velocities of +-v: x'' = -(2 c / L)^2 x for half its elongation x. The step
/// jumps from `before` to `after` (shares of L / c) after some `cycles` of the discrete motion x(n) = X sin(n theta),
/// sin(theta/2) = before, X sin(theta) = v dt. The kinetic energy then loses m a^2 (dt2^2 - dt1^2) / 8 at each end.
void expect_oscillator(double before, double after, int cycles) {
  const WeldData weld{.length = 1.5};
  const double c = std::sqrt(weld.E / weld.density), fastest = weld.length / c, omega = 2.0 / fastest;
  const double v = 1e-7 * c, mass = 0.5 * weld.density * weld.area() * weld.length;
  const double dt = before * fastest, dt_after = after * fastest;
  const double theta = 2.0 * std::asin(before), amplitude = v * dt / std::sin(theta);
  const double place = amplitude * std::sin(cycles * theta), acceleration = omega * omega * place;
  // Velocities at t(n) belong to an ellipse whose half axis is the amplitude times omega cos(theta/2).
  const double speed = amplitude * omega * std::sqrt(1 - before * before) * std::cos(cycles * theta);
  const double amplitude_after = std::hypot(place, speed / (omega * std::sqrt(1 - after * after)));

  const double jump = (cycles - 0.5) * dt;
  Experiment run("*KEYWORD\n" + termination(jump + 200 * dt_after, 1.0, 0.0, 90) +
                 curve(90, {{0.0, dt}, {jump, dt}, {jump * (1 + 1e-9), dt_after}, {1.0, dt_after}}) +
                 weld_part(1, weld) + beam_between(1, 1, 1, {0, 0, 0}, 2, {weld.length, 0, 0}) +
                 "*INITIAL_VELOCITY_NODE\n" + fields({1, -v}) + fields({2, v}) + "*END\n");
  double worst = 0.0, largest_after = 0.0, lost = 0.0;
  run.run([&](const impact::Snapshot& now) {
    worst = std::max(worst, std::abs(now.energy.ratio() - 1.0));
    if (now.state.cycle > cycles) largest_after = std::max(largest_after, std::abs(run.displacement(now, 2).x));
    if (now.state.cycle == cycles + 1) lost = now.energy.step_change;
  });
  const double energy = mass * v * v;
  const std::string what = fmt::format("oscillator, step from {} to {} L/c: ", before, after);
  expect_reference("step change", what + "energy lost to the change, of the whole", lost / energy,
                   2.0 * mass * acceleration * acceleration * (dt_after * dt_after - dt * dt) / 8.0 / energy, 1e-5,
                   1.0);
  expect_reference("step change", what + "amplitude afterwards over that before", largest_after / amplitude,
                   amplitude_after / amplitude, 2e-3);
  expect_reference("step change", what + "largest error of the energy ratio", worst, 0.0, 1e-6, 1.0);
}

// Sabotage to be caught: the term left out, its sign, half of it, the square of the new step alone.
TEST(StepChange, Oscillator) {
  expect_oscillator(0.1, 0.8, 8);  // at the largest elongation
  expect_oscillator(0.8, 0.1, 3);
  expect_oscillator(0.3, 0.9, 4);
}

/// Largest error of the energy balance of a row of six bricks, 10 x 10 x 60, whose step jumps between a fifth of the
/// stable one and nearly all of it every 30 to 150 cycles.
double worst_energy_balance(const std::string& more) {
  Prism bar = square_prism(10.0, 60.0);
  bar.z = {0, 10, 20, 30, 40, 50, 60};
  Experiment run("*KEYWORD\n" + termination(2e-4, 0.8, 0.0, 90) + jumping_steps({2e-7, 1e-6, 4e-7}, 3e-5, 8) +
                 "*PART\nbar\n" + fields({1, 1, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*MAT_ELASTIC\n" +
                 fields({1, 7.85e-9, 210000.0, 0.3}) + bar.text() + more + "*END\n");
  double worst = 0.0, step_change = 0.0;
  run.run([&](const impact::Snapshot& now) {
    const double base = now.energy.initial + now.energy.external;
    if (now.state.cycle > 10) worst = std::max(worst, std::abs(now.energy.total() - base));
    step_change = std::max(step_change, std::abs(now.energy.step_change));
  });
  const impact::Energy& e = run.simulation().energy();
  EXPECT_GT(step_change, 1e-6 * (e.initial + e.external)) << more;  // a thousand times the gate
  return worst / (e.initial + e.external);
}

// Sabotage to be caught: what a wall, a driven node or a rigid body changes in velocities left out of the account.
TEST(StepChange, BalanceWithSupportsWallsAndBodies) {
  const std::string ramp = curve(1, {{0.0, 0.0}, {5e-5, 2000.0}, {1.0, 2000.0}});
  const std::string thrown = "*INITIAL_VELOCITY\n\n" + fields({0, 0, -5000});
  const std::string wall = "*RIGIDWALL_PLANAR\n" + fields({0}) + fields({0, 0, -1e-3, 0, 0, 1});
  std::string driven = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n", body = "*SET_NODE_LIST\n" + fields({1});
  for (int node : {25, 26, 27, 28}) driven += fields({double(node), 3, 0, 1});
  body += fields({25, 26, 27, 28}) + "*CONSTRAINED_NODAL_RIGID_BODY\n" + fields({1, 0, 1});
  expect_reference("step change", "energy balance of a bar against a wall", worst_energy_balance(thrown + wall), 0.0,
                   1e-9, 1.0);
  expect_reference("step change", "energy balance of a bar pulled at an end",
                   worst_energy_balance(ramp + driven + held({1, 2, 3, 4}, {1, 1, 1})), 0.0, 1e-9, 1.0);
  expect_reference("step change", "energy balance of a bar with a rigid end against a wall",
                   worst_energy_balance(thrown + wall + body), 0.0, 1e-9, 1.0);
}

// The weld that holds the step fails: its last force acts over the step that follows, so that step is still its own;
// the one after is not.
TEST(StepChange, FailedWeldHoldsTheStepOnceMore) {
  WeldData weld;
  weld.failure_time = 1e-6;
  const SheetMesh lower{1, 1, {0, 0, 0}, 2, 2, {10, 0, 0}, {0, 10, 0}},
      upper{101, 1, {0, 0, 1.5}, 2, 2, {10, 0, 0}, {0, 10, 0}};
  Experiment run("*KEYWORD\n" + termination(3e-6) + sheet_part(1, 1.5) + weld_part(2, weld) + lower.text() +
                 upper.text() + beam_between(9001, 2, 9001, {5, 5, 0}, 9002, {5, 5, 1.5}) + weld_contact(2, 1) +
                 "*END\n");
  std::vector<double> steps;  // from the cycle on in which the weld has failed
  double before = 0.0;
  ASSERT_EQ(run.run([&](const impact::Snapshot& now) {
                 if (run.history(now, 9001).failed())
                   steps.push_back(now.state.dt);
                 else
                   before = now.state.dt;
               })
                .termination,
            impact::Termination::normal);
  ASSERT_GE(steps.size(), 2u);
  EXPECT_EQ(steps[0], before);
  EXPECT_GT(steps[1], 1.5 * before);
}

}  // namespace
}  // namespace nugget::verify
