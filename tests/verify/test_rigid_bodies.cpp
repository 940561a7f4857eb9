// SPDX-License-Identifier: Apache-2.0
// Large free rotations: the torque-free block as a rigid body and of elastic bricks, a physical pendulum.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/index.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

// mm, t, s, N. Steel block 100 x 60 x 20, spinning about its middle axis of inertia, a little off it.
constexpr double density = 7.85e-9;
const Vec3d sides{100.0, 60.0, 20.0}, principal{0.3140, 0.8164, 1.0676}, spin{1.0, 100.0, 0.0};

/// Times at which the spin about the body's y axis changes its sign, from Euler's equations (Runge-Kutta of fourth
/// order).
std::vector<double> flips(const Vec3d& inertia, Vec3d w, double until) {
  const auto rate = [&](const Vec3d& a) {
    return Vec3d{(inertia.y - inertia.z) / inertia.x * a.y * a.z, (inertia.z - inertia.x) / inertia.y * a.z * a.x,
                 (inertia.x - inertia.y) / inertia.z * a.x * a.y};
  };
  std::vector<double> times;
  const double dt = 1e-6;
  for (double t = 0.0; t < until; t += dt) {
    const Vec3d k1 = rate(w), k2 = rate(w + (0.5 * dt) * k1), k3 = rate(w + (0.5 * dt) * k2), k4 = rate(w + dt * k3);
    const Vec3d next = w + (dt / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    if (w.y * next.y < 0.0) times.push_back(t + dt * w.y / (w.y - next.y));
    w = next;
  }
  return times;
}

/// Collects the flips of a run.
class Flips {
 public:
  void add(double time, double value) {
    if (value_ * value < 0.0) times.push_back(time_ + (time - time_) * value_ / (value_ - value));
    value_ = value;
    time_ = time;
  }
  std::vector<double> times;

 private:
  double value_ = 0.0, time_ = 0.0;
};

// Free spinning block. Sabotage: the spin solved with the inertia at the beginning of the step instead of the
// half-turned axes.
TEST(RigidBodies, TorqueFreeBlockFlips) {
  Specimen s;
  s.card("MAT_RIGID", {1, density, 210000.0, 0.3}).text(fields({}) + fields({}));
  s.card("SECTION_SOLID", {1, 1});
  s.text("*PART_INERTIA\nblock\n" + fields({1, 1, 1}) + fields({0, 0, 0, 9.42e-4}) +
         fields({principal.x, 0, 0, principal.y, 0, principal.z}) + fields({0, 0, 0, spin.x, spin.y, spin.z}));
  s.bricks(1, -0.5 * sides, sides, {1, 1, 1});
  s.text(constant_curve(1, 2e-5)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 1}).card("CONTROL_TERMINATION", {0.5});
  Experiment experiment(s.deck());

  Flips seen;
  double drift = 0.0;
  Vec3d momentum;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const system::RigidBody& body = now.system.bodies.at(0);
    seen.add(now.state.time, body.axes.local(now.spin(at(body.node))).y);
    drift = std::max(drift, std::abs(now.energy.kinetic / 4082.157 - 1.0));
    momentum = body.angular_momentum;
  });
  ASSERT_GE(seen.times.size(), 3u);
  expect_reference("free spinning block", "rigid block, first flip [s]", seen.times[0], 0.0964783, 0.02);
  expect_reference("free spinning block", "rigid block, second flip after the first [s]", seen.times[1] - seen.times[0],
                   0.1929610, 0.01);
  expect_reference("free spinning block", "rigid block, period [s]", seen.times[2] - seen.times[0], 0.3859219, 0.01);
  expect_reference("free spinning block", "rigid block, largest change of the kinetic energy, of 4082.157 mJ", drift,
                   0.0, 1e-3, 1.0);
  expect_reference("free spinning block", "rigid block, angular momentum at the end [mJ s]", norm(momentum), 81.6406,
                   1e-6);
}

// The same block of 10 mm bricks, elastic, against Euler's equations with the inertia of its lumped masses: along a
// side cut into n, sum m x^2 = m a^2/12 (1 + 2/n^2). Sabotage: strain rates
// on the geometry of the end of the step instead of its middle.
TEST(RigidBodies, TorqueFreeElasticBlockFlips) {
  const double m = density * sides.x * sides.y * sides.z / 12.0;
  const Vec3d square{m * 1e4 * (1 + 2.0 / 100), m * 3600 * (1 + 2.0 / 36), m * 400 * (1 + 2.0 / 4)};
  const Vec3d inertia{square.y + square.z, square.z + square.x, square.x + square.y};
  const std::vector<double> expected = flips(inertia, spin, 0.4);
  EXPECT_NEAR(flips(principal, spin, 0.4).at(0), 0.0964783, 1e-5);  // the case's own value

  Specimen s;
  s.card("MAT_ELASTIC", {1, density, 210000.0, 0.3}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  const Grid grid = s.bricks(1, -0.5 * sides, sides, {10, 6, 2});
  s.card("INITIAL_VELOCITY_GENERATION", {1, 2, norm(spin)}).text(fields({0, 0, 0, spin.x, spin.y, spin.z}));
  s.card("CONTROL_TERMINATION", {expected.at(1) + 0.01});
  Experiment experiment(s.deck());
  Flips seen;
  double first = 0.0, least = 1e300, most = 0.0, ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle % 10 != 0) return;
    // The spin about the body's y axis, from the velocities of its ends along x and z.
    const Vec3d ex = unit(experiment.position(now, grid(10, 3, 1)) - experiment.position(now, grid(0, 3, 1)));
    const Vec3d top = experiment.position(now, grid(5, 3, 2)) - experiment.position(now, grid(5, 3, 0));
    const Vec3d turn = experiment.velocity(now, grid(5, 3, 2)) - experiment.velocity(now, grid(5, 3, 0));
    seen.add(now.state.time, dot(turn, ex) / norm(top));
    if (now.state.cycle % 100 != 0) return;  // energies are up to date then
    const double kinetic = now.energy.kinetic;
    if (first == 0.0) first = kinetic;
    least = std::min(least, kinetic);
    most = std::max(most, kinetic);
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
  });
  ASSERT_GE(seen.times.size(), 2u);
  expect_reference("free spinning block", "block of 120 elastic bricks, first flip [s]", seen.times[0], expected[0],
                   0.02);
  expect_reference("free spinning block", "block of 120 elastic bricks, time between flips [s]",
                   seen.times[1] - seen.times[0], expected[1] - expected[0], 0.01);
  expect_reference("free spinning block",
                   "block of 120 elastic bricks, range of the kinetic energy, of its initial value",
                   (most - least) / first, 0.0, 0.01, 1.0);
  expect_reference("free spinning block", "block of 120 elastic bricks, energy ratio", 1.0 + ratio, 1.0, 1e-3);
}

/// Angular momentum about the y axis through the origin over the moment of inertia: what of the motion is rotation.
double angular_velocity(const Experiment& experiment, const impact::Snapshot& now) {
  double momentum = 0.0, inertia = 0.0;
  for (int id : experiment.model().nodes.id) {
    const Vec3d x = experiment.position(now, id), v = experiment.velocity(now, id);
    const double mass = now.system.mass[experiment.node(id)];
    momentum += mass * (x.z * v.x - x.x * v.z);
    inertia += mass * (x.x * x.x + x.z * x.z);
  }
  return std::abs(momentum) / inertia;
}

// Pendulum. A bar of elastic bricks hangs on two nodes in the middle of its end face and falls from the horizontal. It
// is thin, so that the hinge sees the inertia of a rod (4e-4 more), and soft by a tenth, which allows a larger step.
// Sabotage: body loads that push along the base acceleration instead of against it.
TEST(RigidBodies, PhysicalPendulum) {
  constexpr double length = 400.0, gravity = 9810.0;
  Specimen s;
  s.card("MAT_ELASTIC", {1, density, 21000.0, 0.0}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  const Grid grid = s.bricks(1, {0.0, 0.0, -5.0}, {length, 10.0, 10.0}, {20, 1, 2});
  s.card("CONTROL_HOURGLASS", {6, 1.0});
  s.node_set(1, {grid(0, 0, 1), grid(0, 1, 1)}).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, gravity});
  s.card("CONTROL_TERMINATION", {0.65});
  Experiment experiment(s.deck());

  Passage bottom(0.0), back(0.0);
  TimeMean at_bottom, height;
  double ratio = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const Vec3d tip = experiment.position(now, grid(20, 0, 1)), v = experiment.velocity(now, grid(20, 0, 1));
    bottom.add(now.state.time, tip.x);
    if (now.state.time > 0.45) back.add(now.state.time, v.z);  // the tip turns on the other side
    if (std::abs(tip.x) < 10.0) {
      at_bottom.add(angular_velocity(experiment, now), now.state.dt);
      height.add(tip.z, now.state.dt);
    }
    if (now.state.time > 0.01) ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
  });
  ASSERT_TRUE(bottom.seen() && back.seen());
  EXPECT_LT(height.value(), -0.99 * length);  // a positive acceleration along z pulls down
  expect_reference("pendulum", "pendulum of elastic bricks, quarter of the period [s]", bottom.time(), 0.25 * 1.222748,
                   5e-3);
  expect_reference("pendulum", "pendulum of elastic bricks, half of the period [s]", back.time(), 0.5 * 1.222748, 5e-3);
  expect_reference("pendulum", "pendulum of elastic bricks, angular velocity at the bottom [rad/s]", at_bottom.value(),
                   8.57759, 5e-3);
  expect_reference("pendulum", "pendulum of elastic bricks, energy ratio", 1.0 + ratio, 1.0, 1e-3);
}

}  // namespace
}  // namespace nugget::verify
