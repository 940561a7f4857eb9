// SPDX-License-Identifier: Apache-2.0
// Elastic waves in bars: exact solutions of the discrete bar, wave speed, the rod on a rigid wall.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

// mm, t, s, N. Without Poisson's effect a row of bricks is the chain of lumped masses and springs of the textbook.
constexpr double modulus = 210000.0, density = 7.85e-9;
const double wave_speed = std::sqrt(modulus / density);

/// Ten bricks of 50 mm that move along x only. The step is `share` of h/c; no damping of any kind.
struct LumpedBar {
  static constexpr int cells = 10;
  static constexpr double length = 500.0, pitch = length / cells;
  Specimen specimen;
  Grid grid;

  explicit LumpedBar(double share) {
    specimen.card("MAT_ELASTIC", {1, density, modulus, 0.0})
        .card("SECTION_SOLID", {1, 1})
        .card("CONTROL_TIMESTEP", {0, share})
        .card("CONTROL_BULK_VISCOSITY", {1e-30, 1e-30})
        .card("CONTROL_HOURGLASS", {2, 1e-30})
        .part(1, 1, 1);
    grid = specimen.bricks(1, {}, {length, 100.0, 100.0}, {cells, 1, 1});
    specimen.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
    specimen.node_set(2, grid.across(0));
  }
};

// Sabotage: V^(1/3) instead of V / largest face as the length of the stable step.
TEST(Waves, AStepOfVelocityTravelsAsASharpFrontAtTheCriticalStep) {
  constexpr double v = 1e-6;  // small enough that the lengths do not change
  LumpedBar bar(1.0);
  const double step = LumpedBar::pitch / wave_speed;
  bar.specimen.text(constant_curve(1))
      .card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 0, 1, v})
      .card("CONTROL_TERMINATION", {20.5 * step});
  Experiment experiment(bar.specimen.deck());

  constexpr int n = LumpedBar::cells;
  double error = 0.0, reached = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle >= 2 * n) return;  // then the front is back at the driven end
    for (int i = 0; i <= n; ++i) {
      const double expected = (now.state.cycle >= i ? v : 0.0) + (now.state.cycle >= 2 * n - i ? v : 0.0);
      for (int id : bar.grid.across(i))
        error = std::max(error, std::abs(now.state.v[experiment.node(id)].x - expected) / v);
    }
    reached = std::max(reached, now.state.v[experiment.node(bar.grid(n, 0))].x / v);
  });
  expect_reference("bar of lumped masses", "lumped bar at dt = h/c: largest error of a nodal velocity, of the step",
                   error, 0.0, 1e-9, 1.0);
  expect_reference("bar of lumped masses", "lumped bar at dt = h/c: velocity of the free end, of the step", reached,
                   2.0, 1e-9);
}

// Started in the shape of a mode, the clamped-free chain moves in it alone. Its velocities obey v(n+1) + v(n-1) = 2
// cos(w' dt) v(n), and the frequency of the chain follows from that of the central differences as w = 2/dt sin(w' dt /
// 2). Sabotage: a brick's mass in shares other than one eighth.
TEST(Waves, ClampedFreeLumpedBarHasItsFrequencies) {
  const double expected[] = {2583.439, 7686.704, 12600.698, 17204.420};
  constexpr int n = LumpedBar::cells;
  for (int mode = 1; mode <= 4; ++mode) {
    LumpedBar bar(0.5);
    const auto shape = [&](int i) { return std::sin((2 * mode - 1) * std::numbers::pi * i / (2 * n)); };
    bar.specimen.card("BOUNDARY_SPC_SET", {2, 0, 1});
    for (int i = 1; i <= n; ++i)
      for (int id : bar.grid.across(i)) bar.specimen.card("INITIAL_VELOCITY_NODE", {1.0 * id, 1e-3 * shape(i)});
    bar.specimen.card("CONTROL_TERMINATION", {1e-3});
    Experiment experiment(bar.specimen.deck());

    // Projected on the mode with the masses: the digits that the deck's columns cut off excite the others.
    std::vector<double> amplitude;
    double step = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      double sum = 0.0;
      for (int i = 1; i <= n; ++i)
        sum += (i < n ? 1.0 : 0.5) * shape(i) * now.state.v[experiment.node(bar.grid(i, 0))].x;
      amplitude.push_back(sum);
      step = now.state.dt;
    });
    amplitude.pop_back();  // the last step is cut
    amplitude.pop_back();
    double cross = 0.0, square = 0.0;
    for (std::size_t i = 1; i + 1 < amplitude.size(); ++i) {
      cross += amplitude[i] * (amplitude[i - 1] + amplitude[i + 1]);
      square += amplitude[i] * amplitude[i];
    }
    const double dt = 0.5 * LumpedBar::pitch / wave_speed;
    ASSERT_GT(amplitude.size(), 100u);
    ASSERT_GT(step, 0.0);
    const double frequency = std::sin(0.5 * std::acos(0.5 * cross / square)) / (std::numbers::pi * dt);
    expect_reference("bar of lumped masses", fmt::format("clamped-free lumped bar, frequency {} [Hz]", mode), frequency,
                     expected[mode - 1], 1e-6);
  }
}

// A bar that is free to contract carries its waves at sqrt(E/rho), not at the speed of a dilatational wave (16 %
// faster). Sabotage: nu left out of the elastic law's lateral terms.
TEST(Waves, AThinBarCarriesWavesAtTheBarSpeed) {
  Specimen s;
  s.card("MAT_ELASTIC", {1, density, modulus, 0.3}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  const Grid grid = s.bricks(1, {}, {400.0, 6.0, 6.0}, {100, 1, 1});
  s.node_set(1, grid.across(0)).text(smooth_ramp(1, 2e-5));
  s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {1, 1, 0, 1, 1000.0}).card("CONTROL_TERMINATION", {9e-5});
  Experiment experiment(s.deck());
  Passage near(500.0), far(500.0);
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    near.add(now.state.time, experiment.velocity(now, grid(25, 0)).x);
    far.add(now.state.time, experiment.velocity(now, grid(75, 0)).x);
  });
  ASSERT_TRUE(near.seen() && far.seen());
  expect_reference("wave speed", "bar of bricks, nu 0.3, speed of a smooth front [mm/s]",
                   200.0 / (far.time() - near.time()), 5.172194e6, 5e-3);
}

// The bricks are flat (20:1), as weld bricks are. Sabotage: V^(1/3) as the length of the bulk viscosity (the run
// diverges), or a wall that keeps a node which its own velocity takes off.
TEST(Waves, RodOnARigidWall) {
  constexpr double speed = 8000.0;
  Specimen s;
  s.card("MAT_ELASTIC", {1, density, modulus, 0.0}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  s.bricks(1, {}, {300.0, 10.0, 10.0}, {600, 1, 1});
  s.card("INITIAL_VELOCITY_GENERATION", {1, 2, 0, -speed}).text(fields({}));
  s.text("*RIGIDWALL_PLANAR\n" + fields({0}) + fields({0, 0, 0, 1, 0, 0}));
  s.card("CONTROL_TERMINATION", {1.5e-4});
  Experiment experiment(s.deck());

  constexpr double contact = 1.160049e-4;
  double release = 0.0, early = 0.0, late = 0.0, early_time = 0.0, late_time = 0.0, rebound = 0.0, ratio = 1.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const contact::RigidWall& wall = now.components.walls.all()[0];
    if (wall.touching() > 0) release = now.state.time;
    if (now.state.time < 0.1 * contact) early = wall.normal_impulse(), early_time = now.state.time;
    if (now.state.time < 0.9 * contact) late = wall.normal_impulse(), late_time = now.state.time;
    rebound = now.parts[0].momentum.x / now.parts[0].mass;
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0) + 1.0);
  });
  expect_reference("rod on a rigid wall", "rod on a rigid wall: mean force of the plateau [N]",
                   (late - early) / (late_time - early_time), 32481.4, 0.01);
  expect_reference("rod on a rigid wall", "rod on a rigid wall: contact time [s]", release, contact, 0.02);
  expect_reference("rod on a rigid wall", "rod on a rigid wall: coefficient of restitution", rebound / speed, 1.0,
                   0.01);
  expect_reference("rod on a rigid wall", "rod on a rigid wall: largest energy ratio", ratio, 1.0, 1e-3);
}

}  // namespace
}  // namespace nugget::verify
