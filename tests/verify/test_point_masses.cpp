// SPDX-License-Identifier: Apache-2.0
// *ELEMENT_INERTIA in rigid bodies, bodies held in local axes, accelerometers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "impact/recording/histories.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

Specimen& timing(Specimen& s, double end, double step) {
  return s.text(constant_curve(90, step))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90})
      .card("CONTROL_TERMINATION", {end});
}

// The whole tensor of a point belongs to its body, not the mean of its diagonal. Under a moment about x the body gets
// L_x / I_xx. Sabotage: the mean for all axes.
TEST(PointMasses, TensorOfAPointInABody) {
  Specimen s;
  const int a = s.node({0, 0, 0}), b = s.node({2, 0, 0});
  s.text(fmt::format("*ELEMENT_INERTIA\n{:8}{:8}\n", 1, a) + fields({3, 0, 0, 1, 0, 1, 4}));
  s.text(fmt::format("*ELEMENT_INERTIA\n{:8}{:8}\n", 2, b) + fields({1, 0, 0, 2, 0, 1, 4}));
  s.node_set(7, {a, b}).card("CONSTRAINED_NODAL_RIGID_BODY", {7, 0, 7});
  s.text(constant_curve(1));
  for (const int dof : {4, 5, 6}) s.card("LOAD_RIGID_BODY", {7, double(dof + 1), 1, 1e-3});
  timing(s, 0.1, 1e-3);
  Experiment experiment(s.deck());
  Vec3d w;
  run_to_end(experiment, [&](const impact::Snapshot& now) { w = now.spin(at(now.system.bodies.at(0).node)); });
  expect_reference("bodies", "spin about x of two points with tensors", w.x, 1e-4 / 4.0, 1e-4);
  expect_reference("bodies", "about y, with their distance", w.y, 1e-4 / (3.0 + 8.0), 1e-4);
  expect_reference("bodies", "about z, with their distance", w.z, 1e-4 / (2.0 + 8.0), 1e-4);
}

// CMO = -1: held along one local direction, free across it. Sabotage: the directions taken as global ones.
TEST(PointMasses, BodyHeldInLocalAxes) {
  Specimen s;
  const double c = std::cos(0.5), d = std::sin(0.5);
  s.text("*DEFINE_COORDINATE_VECTOR\n" + fields({5, c, d, 0, -d, c, 0}));
  s.card("MAT_RIGID", {1, 1.0, 1.0, 0.3}).text(fields({-1, 5, 100111}) + fields({}));
  s.text("*PART_INERTIA\nbody\n" + fields({1, 0, 1}) + fields({0, 0, 0, 2}) + fields({1, 0, 0, 1, 0, 1}) + fields({}));
  const int a = s.node({0, 0, 0});
  s.card("CONSTRAINED_EXTRA_NODES_NODE", {1, double(a)});
  s.text(constant_curve(1)).card("LOAD_RIGID_BODY", {1, 1, 1, 4.0}).card("LOAD_RIGID_BODY", {1, 5, 1, 4.0});
  timing(s, 1.0, 1e-3);
  Experiment experiment(s.deck());
  Vec3d u, w;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    u = experiment.displacement(now, a);
    w = now.spin(experiment.node(a));
  });
  // Along the free direction (-d, c): acceleration -4 d / 2.
  expect_reference("bodies", "sliding body, way along x", u.x, 0.5 * 2.0 * d * d, 1e-3);
  expect_reference("bodies", "sliding body, way along y", u.y, -0.5 * 2.0 * d * c, 1e-3);
  EXPECT_NEAR(norm(w), 0.0, 1e-12);
}

// A sensor on a turning arm sees r omega^2 along the arm, and gravity in axes that turn with it.
TEST(PointMasses, AccelerometerInAxesThatTurn) {
  for (const int gravity_flag : {0, 1}) {
    Specimen s;
    const double omega = 2.0, r = 3.0, g = 5.0;
    const int hub = s.node({0, 0, 0}), tip = s.node({r, 0, 0}), out = s.node({r + 1, 0, 0}), side = s.node({r, 1, 0});
    s.text(fmt::format("*ELEMENT_INERTIA\n{:8}{:8}\n", 1, hub) + fields({1, 0, 0, 1, 0, 1, 1}));
    s.node_set(7, {hub, tip, out, side}).card("CONSTRAINED_NODAL_RIGID_BODY", {7, 0, 7});
    for (const int n : {hub, tip, out, side}) {
      const double x = n == hub ? 0 : n == out ? r + 1 : r;
      s.card("INITIAL_VELOCITY_NODE", {double(n), n == side ? -omega : 0.0, omega * x, 0, 0, 0, omega});
    }
    s.card("ELEMENT_SEATBELT_ACCELEROMETER", {1, double(tip), double(out), double(side), double(gravity_flag)});
    s.card("DATABASE_HISTORY_NODE", {double(tip)}).card("DATABASE_NODOUT", {0.1});
    s.text(constant_curve(1)).card("LOAD_BODY_Y", {1, g});
    timing(s, 1.0, 1e-4);
    Experiment experiment(s.deck());
    output::NodoutRow last;
    double time = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      last = impact::nodout_state(now).rows.at(0);
      time = now.state.time;
    });
    const double pull = gravity_flag == 1 ? 0.0 : g, angle = omega * time;
    const std::string what = fmt::format("accelerometer on an arm, IGRAV {}: ", gravity_flag);
    expect_reference("bodies", what + "along the arm", last.acceleration.x, -r * omega * omega - pull * std::sin(angle),
                     2e-3);
    expect_reference("bodies", what + "across it", last.acceleration.y, -pull * std::cos(angle), 2e-3, g);
    EXPECT_NEAR(last.acceleration.z, 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace nugget::verify
