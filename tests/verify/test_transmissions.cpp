// SPDX-License-Identifier: Apache-2.0
// Gears, pulleys, racks and screws between rigid bodies: ratios, impulses and accelerations against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "joint_decks.hpp"
#include "linear.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi;

/// Three nodes of a body: a point, one on the axis from there, one off it.
std::vector<int> points_on(Specimen& s, const Vec3d& at, const Vec3d& axis, const Vec3d& off) {
  return {s.node(at), s.node(at + axis), s.node(at + off)};
}

void transmission(Specimen& s, const std::string& kind, const std::vector<int>& a, const std::vector<int>& b,
                  double parm, double damp = 1.0) {
  s.text("*CONSTRAINED_JOINT_" + kind + '\n' +
         fields({double(a[0]), double(b[0]), double(a[1]), double(b[1]), double(a[2]), double(b[2]), 1.0, damp}) +
         fields({parm}));
}

/// A rigid body whose motion is held as CON1 and CON2 say.
void guided(Specimen& s, int id, const Body& b, int con1, int con2, const std::vector<int>& nodes) {
  s.card("MAT_RIGID", {double(id), 1e-9, 210000.0, 0.3}).text(fields({1.0, double(con1), double(con2)}) + fields({}));
  s.text(fmt::format("*PART_INERTIA\nbody {}\n", id) + fields({double(id), 0, double(id)}) +
         fields({b.center.x, b.center.y, b.center.z, b.mass}) +
         fields({b.inertia.x, 0, 0, b.inertia.y, 0, b.inertia.z}) +
         fields({b.velocity.x, b.velocity.y, b.velocity.z, b.spin.x, b.spin.y, b.spin.z}));
  s.node_set(id, nodes).card("CONSTRAINED_EXTRA_NODES_SET", {double(id), double(id)});
}

// A wheel that turns meets one at rest: what is left is I_A w0 / (I_A + I_B / rho^2), the other turns at -1/rho (gears)
// or 1/rho (pulley) of it in space, however its own axis points. Sabotage: the ratio upside down; no sign of the axes.
TEST(Transmissions, WheelsShareTheirSpin) {
  const double rho = 2.5, ia = 0.4, ib = 1.5, w0 = 8.0, left = ia * w0 / (ia + ib / (rho * rho));
  for (const std::string kind : {"GEARS", "PULLEY"})
    for (const double way : {1.0, -1.0}) {
      Specimen s;
      const auto a = points_on(s, {0, 0, 0}, {0, 0, 1}, {2, 0, 0}),
                 b = points_on(s, {7, 0, 0}, {0, 0, way}, {-5, 0, 0});
      body(s, 1, {.center = {0, 0, 0}, .mass = 2, .inertia = {1, 1, ia}, .spin = {0, 0, w0}}, a);
      body(s, 2, {.center = {7, 0, 0}, .mass = 3, .inertia = {1, 1, ib}}, b);
      transmission(s, kind, a, b, rho);
      timing(s, 1.0, 1e-3);
      Experiment experiment(s.deck());
      Vec3d first, second;
      double force = 0.0, moment = 0.0, apart = 0.0;
      run_to_end(experiment, [&](const impact::Snapshot& now) {
        first = spin(now, 1);
        second = spin(now, 2);
        // The force of the teeth times R1 is the moment on A, which is 1/rho of that on B.
        force = norm(now.components.joints.force(0)) * 2.0;
        moment = norm(now.components.joints.moment(0)) / rho;
        apart = std::max(apart, std::abs(force - moment) / (1e-9 + moment));
        EXPECT_LT(now.energy.ratio(), 1.0 + 1e-3);
      });
      const double sign = kind == "GEARS" ? -1.0 : 1.0;
      const std::string what = fmt::format("{}, axes {}: spin of ", kind, way > 0 ? "alike" : "opposite");
      expect_reference("transmissions", what + "A [rad/s]", first.z, left, 1e-4);
      expect_reference("transmissions", what + "B", second.z, sign * left / rho, 1e-4);
      EXPECT_NEAR(apart, 0.0, 1e-9);
    }
}

// A moment on the pinion moves the rack: alpha = M / (I + m h^2), way h times the angle. Sabotage: h on the wrong side.
TEST(Transmissions, PinionDrivesItsRack) {
  const double h = 30.0, m = 0.002, inertia = 4.0, moment = 500.0, end = 0.2;
  const double alpha = moment / (inertia + m * h * h);
  for (const bool by_points : {false, true}) {
    Specimen s;
    const auto a = points_on(s, {0, 0, 0}, {0, 0, 10}, {0, h, 0}), b = points_on(s, {20, -h, 0}, {10, 0, 0}, {0, 5, 0});
    guided(s, 1, {.center = {0, 0, 0}, .mass = 0.01, .inertia = {9, 9, inertia}}, 7, 4, a);  // turns about z
    guided(s, 2, {.center = {20, -h, 0}, .mass = m, .inertia = {1, 1, 1}}, 5, 7, b);         // slides along x
    if (by_points)
      s.text("*CONSTRAINED_JOINT_COOR_RACK_AND_PINION\n" + fields({1, 2, 1, 1}) + fields({0, 0, 0}) +
             fields({20, -h, 0}) + fields({0, 0, 10}) + fields({30, -h, 0}) + fields({0, h, 0}) +
             fields({20, 5 - h, 0}) + fields({h}));
    else
      transmission(s, "RACK_AND_PINION", a, b, h);
    s.text(constant_curve(1)).card("LOAD_RIGID_BODY", {1, 7, 1, moment});
    timing(s, end, 1e-4);
    Experiment experiment(s.deck());
    double angle = 0.0, way = 0.0, drift = 0.0, force = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      angle += now.state.dt * vec(now.state.w[body_of(now, 1).node]).z;
      way = place(now, 2).x - 20.0;
      force = now.components.joints.force(0).x;
      drift = std::max(drift, std::abs(now.energy.total() - now.energy.external));
    });
    const std::string what = by_points ? "rack and pinion by points: " : "rack and pinion: ";
    expect_reference("transmissions", what + "way of the rack [mm]", way, 0.5 * h * alpha * end * end, 2e-3);
    expect_reference("transmissions", what + "way over angle [mm]", way / angle, h, 2e-3);
    expect_reference("transmissions", what + "force on the rack [N]", force, m * h * alpha, 1e-3);
    EXPECT_NEAR(drift, 0.0, 2e-3 * moment * 0.5 * alpha * end * end);
  }
}

// A spinning body A drives B along their axis, both free: impulse J = p w0 / (1/m_A + 1/m_B + p^2 (1/I_A + 1/I_B)).
// Momentum and angular momentum stay, to round-off. Sabotage: the moment on A alone; the force at A's own point.
TEST(Transmissions, ScrewBetweenFreeBodies) {
  const double p = 0.7, ma = 2, mb = 1, ia = 0.3, ib = 0.5, w0 = 5;
  Specimen s;
  const auto a = points_on(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), b = points_on(s, {2, 0, 0}, {1, 0, 0}, {0, 1, 0});
  body(s, 1, {.center = {0, 0, 0}, .mass = ma, .inertia = {ia, 1, 1}, .spin = {w0, 0, 0}}, a);
  body(s, 2, {.center = {2, 0, 0}, .mass = mb, .inertia = {ib, 1, 1}}, b);
  transmission(s, "SCREW", a, b, p);
  timing(s, 2.0, 1e-3);
  Experiment experiment(s.deck());
  Drift drift;
  Vec3d va, vb, wa, wb;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    drift.linear = 0.0;
    drift.add(now);
    va = velocity(now, 1), vb = velocity(now, 2), wa = spin(now, 1), wb = spin(now, 2);
  });
  const double j = p * w0 / (1 / ma + 1 / mb + p * p * (1 / ia + 1 / ib));
  expect_reference("transmissions", "screw between free bodies: velocity of B", vb.x, j / mb, 1e-4);
  expect_reference("transmissions", "screw: velocity of A", va.x, -j / ma, 1e-4);
  expect_reference("transmissions", "screw: spin of A", wa.x, w0 - p * j / ia, 1e-4);
  expect_reference("transmissions", "screw: spin of B", wb.x, p * j / ib, 1e-4);
  EXPECT_NEAR(drift.linear, 0.0, 1e-12);
  EXPECT_NEAR(drift.angular, 0.0, 1e-11);
}

// The same, tumbling and out of line: nothing is lost or gained from nowhere.
TEST(Transmissions, TumblingScrewKeepsItsMomenta) {
  Specimen s;
  const auto a = points_on(s, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), b = points_on(s, {1, 0.5, 0}, {0, 1, 0}, {0, 0, 1});
  body(s, 1, {.center = {0, 0, 0}, .mass = 2, .inertia = {0.3, 0.5, 0.7}, .velocity = {0, 0.2, 0}, .spin = {1, 2, 0.3}},
       a);
  body(s, 2, {.center = {2, 0.3, 0}, .mass = 1, .inertia = {0.2, 0.3, 0.1}, .velocity = {0.3, 0, 1}, .spin = {0, 1, 1}},
       b);
  transmission(s, "SCREW", a, b, 0.2);
  timing(s, 1.0, 1e-3);
  Experiment experiment(s.deck());
  Drift drift;
  run_to_end(experiment, [&](const impact::Snapshot& now) { drift.add(now); });
  EXPECT_NEAR(drift.linear, 0.0, 1e-12);
  EXPECT_NEAR(drift.angular, 0.0, 1e-11);
  EXPECT_NEAR(drift.ratio, 0.0, 2e-3);
}

// Three turns of a driven screw: the nut, which cannot turn, goes three times the lead.
TEST(Transmissions, ScrewGoesItsLead) {
  const double p = 25.0, turns = 3.0, end = 0.6;
  Specimen s;
  const auto a = points_on(s, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}), b = points_on(s, {2, 0, 0}, {1, 0, 0}, {0, 1, 0});
  guided(s, 1, {.center = {0, 0, 0}, .mass = 1, .inertia = {3, 3, 3}}, 7, 5, a);
  guided(s, 2, {.center = {2, 0, 0}, .mass = 1, .inertia = {3, 3, 3}}, 5, 7, b);
  transmission(s, "SCREW", a, b, p);
  s.text(smooth_ramp(1, end, turns * 2.0 * pi)).card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {1, 5, 2, 1});
  timing(s, 2.0 * end, 1e-4);
  Experiment experiment(s.deck());
  double way = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) { way = place(now, 2).x - 2.0; });
  expect_reference("transmissions", "three turns of a screw: way of the nut [mm]", way, p * turns * 2.0 * pi, 1e-4);
}

// In modes a mass m on a spring carries the wheel that it drives: m + I/r^2, with r the way over the angle.
TEST(Transmissions, InModes) {
  const double k = 40.0, m = 0.002, inertia = 4.0, r = 30.0, rho = 2.5;
  const auto mode = [&](const std::string& kind) {
    Specimen s;
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
    s.text("*MAT_SPRING_ELASTIC\n" + fields({90, k}) + "*SECTION_DISCRETE\n" + fields({90, 0}) + fields({0, 0}));
    s.part(90, 90, 90).text("*DEFINE_SD_ORIENTATION\n" + fields({1, 0, 1, 0, 0}));
    int sprung = 0;
    if (kind == "GEARS") {
      // B turns about z; the spring holds its rim at r, along x.
      const auto a = points_on(s, {0, 0, 0}, {0, 0, 10}, {2, 0, 0}), b = points_on(s, {7, 0, 0}, {0, 0, 10}, {0, r, 0});
      guided(s, 1, {.center = {0, 0, 0}, .mass = m, .inertia = {9, 9, inertia}}, 7, 4, a);
      guided(s, 2, {.center = {7, 0, 0}, .mass = m, .inertia = {9, 9, inertia}}, 7, 4, b);
      sprung = b[2];
      transmission(s, kind, a, b, rho);
    } else {
      const bool screw = kind == "SCREW";
      const auto a = points_on(s, {0, 0, 0}, screw ? Vec3d{10, 0, 0} : Vec3d{0, 0, 10}, {0, r, 0}),
                 b = points_on(s, {20, screw ? 0 : -r, 0}, {10, 0, 0}, {0, 5, 0});
      guided(s, 1, {.center = {0, 0, 0}, .mass = m, .inertia = {inertia, 9, inertia}}, 7, screw ? 5 : 4, a);
      guided(s, 2, {.center = {20, screw ? 0 : -r, 0}, .mass = m, .inertia = {1, 1, 1}}, 5, 7, b);
      sprung = b[0];
      transmission(s, kind, a, b, r);
    }
    s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}{:8}{:16g}\n", 1, 90, sprung, 0, 1, 1.0));
    const LinearExperiment experiment(s.deck());
    return std::sqrt(experiment.modes(1).eigenvalue[0]);
  };
  const double driven = std::sqrt(k / (m + inertia / (r * r)));
  expect_reference("transmissions", "rack on a spring with its pinion: mode [rad/s]", mode("RACK_AND_PINION"), driven,
                   1e-4);
  expect_reference("transmissions", "nut on a spring with its screw: mode [rad/s]", mode("SCREW"), driven, 1e-4);
  expect_reference("transmissions", "two gears, a spring at a rim: mode [rad/s]", mode("GEARS"),
                   std::sqrt(k * r * r / (inertia * (1.0 + rho * rho))), 1e-4);
}

TEST(Transmissions, RefusedWhereTheyCannotWork) {
  const auto refused = [](const std::string& kind, const Vec3d& axis_b, double parm) {
    Specimen s;
    const auto a = points_on(s, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}), b = points_on(s, {0, 0, 3}, axis_b, {1, 0, 0});
    body(s, 1, {.center = {0, 0, 0}}, a);
    body(s, 2, {.center = {0, 0, 3}}, b);
    transmission(s, kind, a, b, parm);
    timing(s, 1e-3, 1e-4);
    EXPECT_THROW(Experiment(s.deck()), std::runtime_error) << kind;
  };
  refused("GEARS", {0, 0, 1}, 0.0);
  refused("PULLEY", {0, 0, 1}, -1.0);
  refused("SCREW", {0, 0, 1}, 0.0);
  refused("SCREW", {0, 1, 1}, 5.0);
  refused("RACK_AND_PINION", {0, 0, 1}, 5.0);
}

}  // namespace
}  // namespace nugget::verify
