// SPDX-License-Identifier: Apache-2.0
// A stressed element is turned by 360 degrees about an oblique axis, every node on its prescribed circle: no work is
// done on it (docs/decisions/0001), and its stress goes round with it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "experiment.hpp"
#include "system/constraint_map.hpp"
#include "weld_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double dt = 1e-7;
constexpr int loading = 50;  // steps
const Vec3d spindle = unit(Vec3d{1, 2, 3});

/// A node, brought to its stressed place and tilt during the loading steps.
struct Point {
  int node;
  Vec3d x, moved, tilt;
};

std::string line(double t, double value) {
  return fmt::format("{:20.14g}{:20.15f}\n", t, value);
}

double part(const Vec3d& a, int i) {
  return i == 0 ? a.x : i == 1 ? a.y : a.z;
}

/// Motions of all points; with `rotations` also of their spins. The circle is given at the end of every step.
std::string driven_round(const std::vector<Point>& points, int steps, bool rotations) {
  std::string text = curve(90, {{0, dt}, {1, dt}});
  int id = 100;
  for (const Point& p : points) {
    const auto drive = [&](int dof) {
      ++id;
      text += "*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fields({double(p.node), double(dof), 2, double(id)}) +
              "*DEFINE_CURVE\n" + fields({double(id), 0, 1, 1, 0, 0, 0}) + line(0, 0);
    };
    const Vec3d stressed = p.x + p.moved;
    std::vector<Vec3d> circle;
    for (int k = 0; k <= steps; ++k)
      circle.push_back(system::turned(stressed, (2.0 * std::numbers::pi * k / steps) * spindle) - p.x);
    for (int i = 0; i < 3; ++i) {
      drive(i + 1);
      for (int k = 0; k <= steps; ++k) text += line((loading + k) * dt, part(circle[k], i));
      if (!rotations) continue;
      drive(i + 5);
      text += line(loading * dt, part(p.tilt, i));
      text += line((loading + steps) * dt, part(p.tilt, i) + 2.0 * std::numbers::pi * part(spindle, i));
    }
  }
  return text;
}

struct Turn {
  double energy = 0.0;          ///< stored at the beginning of the turn
  double largest_change = 0.0;  ///< of it during the turn
  double total_work = 0.0;      ///< of the supports over the turn
};

/// Turns a model; `watch` sees every state of the turn.
Turn turn(const std::string& model, const std::vector<Point>& points, int steps, bool rotations,
          const Watch& watch = {}) {
  Experiment run("*KEYWORD\n" + termination((loading + steps) * dt, 0.9, 0.0, 90) + model +
                 driven_round(points, steps, rotations) + "*END\n");
  Turn turn;
  double work = 0.0;
  run.run([&](const impact::Snapshot& now) {
    if (now.state.cycle < loading) return;
    const double energy = now.energy.internal + now.energy.hourglass;
    if (now.state.cycle == loading) {
      turn.energy = energy;
      work = now.energy.external - now.energy.kinetic;
    }
    turn.largest_change = std::max(turn.largest_change, std::abs(energy - turn.energy));
    turn.total_work = now.energy.external - now.energy.kinetic - work;
    if (watch) watch(now);
  });
  EXPECT_GE(run.simulation().state().cycle, loading + steps);
  return turn;
}

/// A field of displacements with all strains in it.
Vec3d stretched(const Vec3d& x) {
  return {1e-3 * x.x + 4e-4 * x.y + 3e-4 * x.z, 4e-4 * x.x - 6e-4 * x.y + 2e-4 * x.z,
          3e-4 * x.x + 2e-4 * x.y + 8e-4 * x.z};
}

// Sabotage to be caught: rates on the geometry of the end of the step (energy grows by the square of the angle a step);
// Jaumann's rate without the half-step.
TEST(Rotation, StressedBrick) {
  std::string model = "*PART\nbrick\n" + fields({1, 1, 1}) + "*SECTION_SOLID\n" + fields({1, 1}) + "*MAT_ELASTIC\n" +
                      fields({1, 7.85e-9, 210000.0, 0.3}) + "*NODE\n";
  std::vector<Point> points;
  for (int i = 0; i < 8; ++i) {
    const bool right = i % 4 == 1 || i % 4 == 2, back = i % 4 >= 2;
    const Vec3d x{right ? 10.0 : 0.0, back ? 8.0 : 0.0, i >= 4 ? 6.0 : 0.0};
    model += node_line(i + 1, x.x, x.y, x.z);
    points.push_back({i + 1, x, stretched(x), {}});
  }
  model += "*ELEMENT_SOLID\n" + element_line(1, 1, {1, 2, 3, 4, 5, 6, 7, 8});
  // Steps of 0.72 degrees and of 15.
  for (const int steps : {500, 24}) {
    std::array<double, 6> first{}, last{};
    const Turn t = turn(model, points, steps, false, [&](const impact::Snapshot& now) {
      last = now.system.groups[0]->layer(0, 0, now.state).stress;
      if (now.state.cycle == loading) first = last;
    });
    ASSERT_GT(t.energy, 100.0);
    const std::string what = fmt::format("stressed brick turned by 360 degrees in {} steps: ", steps);
    // What is left is the fifteenth decimal of the deck's displacements.
    expect_reference("rotation", what + "change of its energy", t.largest_change / t.energy, 0.0, 1e-9, 1.0);
    double change = 0.0;
    for (std::size_t i = 0; i < 6; ++i) change = std::max(change, std::abs(last[i] - first[i]));
    // The Hughes-Winget rotation is an orthogonal matrix whose angle is that of the step: the stress comes back.
    expect_reference("rotation", what + "change of its stress", change / 300.0, 0.0, 1e-10, 1.0);
  }
}

// The transverse shear of shells and beams compares a gradient (2 tan phi/2) with a spin (phi): phi^3/12 a step is
// left, (2 pi)^3 / 12 N^2 in N of them. All other resultants stay. Sabotage to be caught: rates on the geometry of the
// end of the step; a frame that lags behind.
TEST(Rotation, StressedShell) {
  const int steps = 5000;
  SheetMesh mesh;
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i) {
    const Vec3d x{i % 2 == 1 ? 10.0 : 0.0, i >= 2 ? 10.0 : 0.0, 0.0};
    Vec3d moved = stretched(x);
    moved.z = 0.0;
    points.push_back({i + 1, x, moved, {2e-4 * (x.y - 5.0), -3e-4 * (x.x - 5.0), 0.0}});
  }
  const std::string model = sheet_part(1, 1.0) + mesh.text() + "*CONTROL_ACCURACY\n" + fields({1});
  std::array<double, 8> first{}, last{};  // Mx My Mxy Qx Qy Nx Ny Nxy
  const Turn t = turn(model, points, steps, true, [&](const impact::Snapshot& now) {
    last = now.system.groups[0]->resultants(0);
    if (now.state.cycle == loading) first = last;
  });
  ASSERT_GT(t.energy, 1.0);
  double moments = 0.0, forces = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    moments = std::max(moments, std::abs(last[i] - first[i]) / std::abs(first[0]));
    forces = std::max(forces, std::abs(last[5 + i] - first[5 + i]) / std::abs(first[5]));
  }
  const std::string what = "stressed shell turned by 360 degrees in 5,000 steps: ";
  expect_reference("rotation", what + "change of a moment", moments, 0.0, 1e-9, 1.0);
  expect_reference("rotation", what + "change of a membrane force", forces, 0.0, 1e-9, 1.0);
  const double angle = std::pow(2.0 * std::numbers::pi, 3) / (12.0 * steps * steps),
               stiffness = 0.8333 * 210000.0 / 2.6;
  expect_reference("rotation", what + "shear force that phi^3/12 leaves [N/mm]",
                   std::hypot(last[3] - first[3], last[4] - first[4]),
                   stiffness * angle * std::hypot(spindle.x, spindle.y), 1e-3);
  expect_reference("rotation", what + "change of its energy", t.largest_change / t.energy, 0.0, 1e-6, 1.0);
  expect_reference("rotation", what + "work done on it over its energy", t.total_work / t.energy, 0.0, 1e-6, 1.0);
}

// docs/theory/weld.md#reference-values: local resultants constant to 1e-6.
TEST(Rotation, LoadedWeld) {
  const WeldData weld{.yield = 1e9};
  const std::vector<Point> points{{1, {0, 0, 0}, {}, {}}, {2, {1.5, 0, 0}, {4e-3, 8e-3, -6e-3}, {3e-3, 4e-3, -5e-3}}};
  const std::string model = weld_part(1, weld) + beam_between(1, 1, 1, points[0].x, 2, points[1].x);
  std::array<double, 8> first{}, last{};
  double worst = 0.0;
  const Turn t = turn(model, points, 100000, true, [&](const impact::Snapshot& now) {
    last = now.system.groups[0]->resultants(0);
    if (now.state.cycle == loading) first = last;
    for (std::size_t i = 0; i < 6; ++i) worst = std::max(worst, std::abs(last[i] - first[i]) / std::abs(first[i]));
  });
  for (std::size_t i = 0; i < 6; ++i) ASSERT_GT(std::abs(first[i]), 100.0) << i;
  expect_reference("welds turned by a full circle",
                   "loaded weld turned by 360 degrees in 100,000 steps: largest change of a resultant", worst, 0.0,
                   1e-6, 1.0);
  expect_reference("rotation", "loaded weld turned by 360 degrees: change of its energy", t.largest_change / t.energy,
                   0.0, 1e-5, 1.0);
}

}  // namespace
}  // namespace nugget::verify
