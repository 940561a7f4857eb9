// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_INTERPOLATION: a node carried by the best rigid motion of others.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

int mass_point(Specimen& s, const Vec3d& x, double m) {
  const int n = s.node(x);
  s.text(fmt::format("*ELEMENT_MASS\n{:8}{:8}{:16g}\n", n, n, m));
  return n;
}

struct Frame4 {
  Specimen s;
  std::array<int, 4> n{};
  int dependent = 0;
  /// Four masses of 1 on a square of side 2 about the origin; the dependent node at `x`.
  explicit Frame4(const Vec3d& x) {
    n = {mass_point(s, {-1, -1, 0}, 1), mass_point(s, {1, -1, 0}, 1), mass_point(s, {1, 1, 0}, 1),
         mass_point(s, {-1, 1, 0}, 1)};
    dependent = s.node(x);
    s.text("*CONSTRAINED_INTERPOLATION\n" + fields({1, double(dependent)}));
    for (const int i : n) s.text(fields({double(i), 123}));
    s.text(curve(1, {{0.0, 1.0}, {9.0, 1.0}}) + constant_curve(2, 1e-4));
    s.card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 2}).card("CONTROL_TERMINATION", {0.01});
  }
};

// A force on the dependent node off the centre: shares of the force and of its moment, f_i = F/4 + (M x r_i)/sum r^2.
// Sabotage: the moment of the arm left out; the shares without weights.
TEST(Interpolation, ForceAndItsMomentGoToTheIndependentNodes) {
  Frame4 f({0.5, 0, 0});
  f.s.card("LOAD_NODE_POINT", {double(f.dependent), 2, 1, 8.0});
  Experiment experiment(f.s.deck());
  std::array<Vec3d, 4> velocity;
  double time = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.dt != now.state.dt_previous) return;  // the mean velocity stands at t only between equal steps
    for (std::size_t i = 0; i < 4; ++i) velocity[i] = experiment.velocity(now, f.n[i]);
    time = now.state.time;
  });
  // M = 4 about z, sum r^2 = 8, so the tangential part is 4/8 (-r_y, r_x).
  const double sx[4] = {-1, 1, 1, -1}, sy[4] = {-1, -1, 1, 1};
  for (std::size_t i = 0; i < 4; ++i) {
    expect_reference("interpolation", fmt::format("force 8 half a side off the centre: y-force on node {}", i + 1),
                     velocity[i].y / time, 2.0 + 0.5 * sx[i], 1e-3);
    EXPECT_NEAR(velocity[i].x / time, -0.5 * sy[i], 1e-3);
    EXPECT_NEAR(velocity[i].z, 0.0, 1e-12);
  }
}

// The dependent node follows a rigid rotation exactly, whatever its place. Sabotage: the mean of the velocities alone.
TEST(Interpolation, FollowsARotation) {
  Frame4 f({3, 1, 2});
  const double omega = 50.0;
  const double x[4] = {-1, 1, 1, -1}, y[4] = {-1, -1, 1, 1};
  for (std::size_t i = 0; i < 4; ++i)
    f.s.card("INITIAL_VELOCITY_NODE", {double(f.n[i]), -omega * y[i], omega * x[i], 0});
  Experiment experiment(f.s.deck());
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle != 1) return;
    const Vec3d v = experiment.velocity(now, f.dependent);
    const double turned = omega * now.state.time, c = std::cos(turned), s = std::sin(turned);
    EXPECT_NEAR(v.x, -omega * (c * 1.0 + s * 3.0), 0.01);
    EXPECT_NEAR(v.y, omega * (c * 3.0 - s * 1.0), 0.01);
    EXPECT_NEAR(now.spin(experiment.node(f.dependent)).z, omega, 0.01);
  });
}

}  // namespace
}  // namespace nugget::verify
