// SPDX-License-Identifier: Apache-2.0
// An elastic sphere against a rigid wall, by Hertz.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

/// From 0 to 1 in steps that grow by a constant factor from the first one.
std::vector<double> graded(double first, int cells) {
  double low = 1.0, high = 3.0;
  const auto length = [&](double factor) { return first * (std::pow(factor, cells) - 1.0) / (factor - 1.0); };
  for (int i = 0; i < 60; ++i) (length(0.5 * (low + high)) < 1.0 ? low : high) = 0.5 * (low + high);
  std::vector<double> x{0.0};
  for (double step = first; static_cast<int>(x.size()) < cells; step *= low) x.push_back(x.back() + step);
  x.push_back(1.0);
  return x;
}

/// A point of the cube of half side 1 in the unit ball: on the ray to it, as far out as it is in the cube.
Vec3d in_ball(const Vec3d& c) {
  const double largest = std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)});
  return largest > 0.0 ? (largest / norm(c)) * c : c;
}

// A quarter of a steel ball of radius 10 falls on a wall with 1 m/s; its elements are 0.14 mm at the pole, a third of
// the radius of contact. Sabotage: a wall that lets nodes through by a step; E for E / (1 - nu^2).
TEST(Hertz, SphereOnARigidWall) {
  constexpr double radius = 10.0, speed = 1000.0, E = 210000.0, nu = 0.3, density = 7.85e-9;
  constexpr int cells = 9, cells_up = cells + 3;  // graded ones to the centre, three even ones above it
  const double pi = std::acos(-1.0);
  const std::vector<double> across = graded(0.014, cells), up = across;
  Specimen s;
  s.card("MAT_ELASTIC", {1, density, E, nu}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  s.card("CONTROL_HOURGLASS", {6, 1.0}).card("CONTROL_TERMINATION", {7e-5});
  const Grid grid = s.bricks(1, {cells, cells, cells_up}, [&](int i, int j, int k) {
    const double z = k <= cells ? up[k] - 1.0 : (k - cells) / 3.0;
    const Vec3d p = in_ball({across[i], across[j], z});
    return radius * (p + Vec3d{0, 0, 1});
  });
  std::vector<int> left, front;
  for (int k = 0; k <= cells_up; ++k)
    for (int a = 0; a <= cells; ++a) left.push_back(grid(0, a, k)), front.push_back(grid(a, 0, k));
  s.node_set(1, left).card("BOUNDARY_SPC_SET", {1, 0, 1}).node_set(2, front).card("BOUNDARY_SPC_SET", {2, 0, 0, 1});
  s.card("INITIAL_VELOCITY_GENERATION", {1, 2, 0, 0, 0, -speed}).text(fields({}));
  s.text("*RIGIDWALL_PLANAR\n" + fields({0}) + fields({0, 0, 0, 0, 0, 1}));
  Experiment experiment(s.deck());

  double mass = 0.0, impulse = 0.0, largest = 0.0, deepest = 0.0, before_time = 0.0, last_touch = 0.0;
  const int center = grid(0, 0, cells);
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle == 0) mass = now.masses.physical;
    deepest = std::max(deepest, -experiment.displacement(now, center).z);
    // The mean force over 2 % of the contact's time: single nodes come to rest with a knock.
    if (now.state.time - before_time > 1e-6) {
      const double force =
          4.0 * (now.components.walls.all()[0].normal_impulse() - impulse) / (now.state.time - before_time);
      largest = std::max(largest, force);
      impulse = now.components.walls.all()[0].normal_impulse(), before_time = now.state.time;
    }
    if (now.components.walls.all()[0].normal_force() > 0.0) last_touch = now.state.time;
  });
  // Timoshenko & Goodier, Theory of Elasticity: F = 4/3 E' sqrt(R) d^(3/2), 1/2 m v^2 = 2/5 F d, t = 2.943 d / v.
  const double stiffness = 4.0 / 3.0 * E / (1.0 - nu * nu) * std::sqrt(radius);
  const double m = density * 4.0 / 3.0 * pi * radius * radius * radius;
  const double depth = std::pow(1.25 * m * speed * speed / stiffness, 0.4);
  expect_reference("sphere on a rigid wall", "mass of the ball [t]", 4.0 * mass, m, 0.02);
  expect_reference("sphere on a rigid wall", "sphere on a rigid wall: greatest force [N]", largest, 2309.8, 0.07);
  expect_reference("sphere on a rigid wall", "the same by the formulas of Hertz", largest,
                   stiffness * std::pow(depth, 1.5), 0.07);
  expect_reference("sphere on a rigid wall", "approach of its centre [mm]", deepest, 0.017795, 0.07);
  expect_reference("sphere on a rigid wall", "time of contact [s]", last_touch, 5.2376e-5, 0.07);
}

}  // namespace
}  // namespace nugget::verify
