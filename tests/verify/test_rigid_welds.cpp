// SPDX-License-Identifier: Apache-2.0
// Rigid welds (*CONSTRAINED_SPOTWELD, *CONSTRAINED_GENERALIZED_WELD_SPOT) of point masses against Newton's laws: force
// in the weld, load at failure, what goes on after it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

using testing::HasSubstr;

constexpr double step = 1e-4;

/// Runs to `end` in steps of `step`; curve 1 rises from 0 by 1 in a unit of time.
Specimen& timing(Specimen& s, double end) {
  return s.text(curve(1, {{0.0, 0.0}, {1000.0, 1000.0}}) + constant_curve(2, step))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 2})
      .card("CONTROL_TERMINATION", {end});
}

/// DOF of *LOAD_NODE_POINT: 1 to 3 forces, 5 to 7 moments.
void load(Specimen& s, int node, int dof, double factor) {
  s.card("LOAD_NODE_POINT", {double(node), double(dof), 1, factor});
}

std::string generalized(int set, double cid, std::initializer_list<double> failure) {
  return "*CONSTRAINED_GENERALIZED_WELD_SPOT\n" + fields({double(set), cid}) + fields(failure);
}

// Masses 2 and 1, the first pulled away by F = 30 t: the weld carries F m2/(m1 + m2), so it fails at a third of F.
// Sabotage: the force of the weld without the applied load; the mass of the body instead of the node's.
TEST(RigidWelds, TensionFailsAtItsStrengthAndMomentumStays) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 2.0, 0.2), b = s.mass_point({5, 0, 0}, 1.0, 0.1);
  load(s, a, 1, -30.0);
  s.card("CONSTRAINED_SPOTWELD", {double(a), double(b), 4.0, 0, 1.5, 0});
  timing(s, 1.0);
  Experiment experiment(s.deck());
  double worst = 0.0, failed_at = 0.0, momentum_error = 0.0, shear = 0.0, later_change = 0.0, speed_at_failure = 0.0;
  std::vector<double> energy;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const weld::RigidWeldHistory& h = now.components.rigid_welds.history(0);
    const double t = now.state.time, force = 30.0 * t;
    if (!h.failed()) {
      worst = std::max(worst, std::abs(h.axial() - force / 3.0));
      shear = std::max(shear, h.shear());
    } else {
      if (failed_at == 0.0) {
        failed_at = h.failure_time();
        speed_at_failure = experiment.velocity(now, b).x;
      }
      later_change = std::max(later_change, std::abs(experiment.velocity(now, b).x - speed_at_failure));
    }
    // Velocities of held nodes are those of the step before, half a step back.
    const double momentum = 2.0 * experiment.velocity(now, a).x + experiment.velocity(now, b).x;
    const double bound =
        now.system.map.dependent(static_cast<int>(experiment.node(a))) ? force * step : 30.0 * step * step;
    // The mean of both half-steps' velocities stands at t only between equal steps; the last one is trimmed.
    if (now.state.dt == now.state.dt_previous)
      momentum_error = std::max(momentum_error, std::abs(momentum + 15.0 * t * t) - bound);
    energy.push_back(now.energy.ratio());
  });
  EXPECT_NEAR(worst, 0.0, 1e-9);
  EXPECT_NEAR(shear, 0.0, 1e-12);
  expect_reference("rigid weld", "two masses pulled apart, time of failure of a weld of strength 4", failed_at, 0.4,
                   1e-3);
  EXPECT_LE(momentum_error, 0.0);
  EXPECT_NEAR(later_change, 0.0, 1e-12) << "the other mass coasts";
  EXPECT_NEAR(speed_at_failure, -0.8, 1e-3);
  EXPECT_NEAR(energy.back(), 1.0, 1e-6);
  EXPECT_EQ(experiment.simulation().components().rigid_welds.failed(), 1);
  EXPECT_THAT(experiment.simulation().components().rigid_welds.events().at(0), HasSubstr("axial force"));
}

TEST(RigidWelds, CompressionDoesNotFail) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 2.0, 0.2), b = s.mass_point({5, 0, 0}, 1.0, 0.1);
  load(s, a, 1, 30.0);
  s.card("CONSTRAINED_SPOTWELD", {double(a), double(b), 4.0, 0, 1.0, 0});
  timing(s, 1.0);
  Experiment experiment(s.deck());
  double axial = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) { axial = now.components.rigid_welds.history(0).axial(); });
  EXPECT_NEAR(axial, -10.0, 1e-6);
  EXPECT_EQ(experiment.simulation().components().rigid_welds.failed(), 0);
}

// Two masses at one place, pulled at 30 degrees to the normal z of a coordinate system:
// (f cos 30 / SN)^N + (f sin 30 / SS)^M = 1. Sabotage: shear and normal exchanged.
TEST(RigidWelds, CombinedLoadFailsOnItsCurve) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 1.0, 0.1), b = s.mass_point({0, 0, 0}, 1.0, 0.1);
  s.node_set(1, {a, b});
  s.text("*DEFINE_COORDINATE_SYSTEM\n" + fields({1, 0, 0, 0, 0, 1, 0}) + fields({0, 0, 1}));  // z = global x
  load(s, b, 1, 40.0 * std::cos(M_PI / 6.0));
  load(s, b, 3, 40.0 * std::sin(M_PI / 6.0));
  s.text(generalized(1, 1, {1e20, 0, 10.0, 6.0, 2.0, 2.0}));
  timing(s, 1.0);
  Experiment experiment(s.deck());
  run_to_end(experiment, [](const impact::Snapshot&) {});
  // f = 20 t along the load: 20 t sqrt((cos 30/10)^2 + (sin 30/6)^2) = 1.
  const double expected = 1.0 / (20.0 * std::hypot(std::cos(M_PI / 6.0) / 10.0, std::sin(M_PI / 6.0) / 6.0));
  expect_reference("rigid weld", "spot at one place, 30 degrees, round failure curve: time of failure",
                   experiment.simulation().components().rigid_welds.history(0).failure_time(), expected, 1e-3);
}

// A mean of 101 force vectors of a ramp lags by 50 steps; a window of 20.5 steps keeps 21 of them, which lag by 10.
TEST(RigidWelds, AFilterDelaysFailureByHalfItsLength) {
  const auto failure_time = [](double vectors, double window) {
    Specimen s;
    const int a = s.mass_point({0, 0, 0}, 2.0, 0.2), b = s.mass_point({5, 0, 0}, 1.0, 0.1);
    load(s, a, 1, -30.0);
    s.text("*CONSTRAINED_SPOTWELD_FILTERED_FORCE\n" + fields({double(a), double(b), 4.0, 0, 1.0, 0}) +
           fields({vectors, window}));
    timing(s, 0.5);
    Experiment experiment(s.deck());
    run_to_end(experiment, [](const impact::Snapshot&) {});
    return experiment.simulation().components().rigid_welds.history(0).failure_time();
  };
  EXPECT_NEAR(failure_time(0, 0), 0.4, 1.01 * step);
  EXPECT_NEAR(failure_time(101, 0) - failure_time(0, 0), 50.0 * step, 1.01 * step);
  EXPECT_NEAR(failure_time(101, 20.5 * step) - failure_time(0, 0), 10.0 * step, 1.01 * step);
}

// A pair turning about its centre: each mass pulls with m omega^2 r whatever the direction of the weld; bending stays
// 0. Sabotage: the centripetal term left out; the axis held in space.
TEST(RigidWelds, SpinningPairCarriesItsCentrifugalForce) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 2.0, 0.2), b = s.mass_point({3, 0, 0}, 1.0, 0.1);
  const double omega = 4.0;
  s.card("INITIAL_VELOCITY_NODE", {double(a), 0, -omega * 1.0, 0, 0, 0, omega});
  s.card("INITIAL_VELOCITY_NODE", {double(b), 0, omega * 2.0, 0, 0, 0, omega});
  s.card("CONSTRAINED_SPOTWELD", {double(a), double(b)});
  timing(s, 2.0);
  Experiment experiment(s.deck());
  double worst_axial = 0.0, worst_shear = 0.0, worst_moment = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle == 0) return;
    const weld::RigidWeldHistory& h = now.components.rigid_welds.history(0);
    worst_axial = std::max(worst_axial, std::abs(h.axial() - 2.0 * omega * omega));
    worst_shear = std::max(worst_shear, h.shear());
    worst_moment = std::max({worst_moment, h.moment(), std::abs(h.torsion())});
  });
  expect_reference("rigid weld", "spinning pair over 1.3 turns: largest error of the tension of 32", worst_axial, 0.0,
                   1e-6, 32.0);
  EXPECT_NEAR(worst_shear, 0.0, 1e-6);
  EXPECT_NEAR(worst_moment, 0.0, 1e-6);
}

// The same pair, turning and moving, torn apart at a time: both momenta and the energy stay. Sabotage: velocities of
// the released nodes taken from the body's centre.
TEST(RigidWelds, ReleaseOfASpinningPairKeepsItsMomenta) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 2.0, 0.2), b = s.mass_point({3, 0, 0}, 1.0, 0.1);
  const double omega = 4.0;
  s.card("INITIAL_VELOCITY_NODE", {double(a), 1, -omega * 1.0, 5, 0, 0, omega});
  s.card("INITIAL_VELOCITY_NODE", {double(b), 1, omega * 2.0, 5, 0, 0, omega});
  s.card("CONSTRAINED_SPOTWELD", {double(a), double(b), 0, 0, 0, 0, 0.3});
  timing(s, 1.0);
  Experiment experiment(s.deck());
  double drift = 0.0, turn = 0.0, kinetic = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const Vec3d linear = 2.0 * experiment.velocity(now, a) + 1.0 * experiment.velocity(now, b);
    const auto spin = [&](int n, double m) {
      return cross(experiment.position(now, n), m * experiment.velocity(now, n)) +
             (0.1 * m) * now.spin(experiment.node(n));
    };
    const Vec3d angular = spin(a, 2.0) + spin(b, 1.0);
    if (now.state.cycle < 2) return;  // the mean of two half-steps' velocities needs two of them
    static Vec3d first;
    if (now.state.cycle == 2) first = angular;
    drift = std::max(drift, norm(linear - Vec3d{3, 0, 15}));
    turn = std::max(turn, norm(angular - first));
    kinetic = now.energy.kinetic;
  });
  EXPECT_EQ(experiment.simulation().components().rigid_welds.failed(), 1);
  EXPECT_NEAR(drift, 0.0, 1e-6);
  // L = 3*(1,0,5)-motion about the origin is constant as well: the sum of both is what counts.
  EXPECT_NEAR(turn, 0.0, 2e-4);
  EXPECT_NEAR(kinetic, 0.5 * 3.0 * 26.0 + 0.5 * 16.0 * (2.0 * 1.0 + 1.0 * 4.0 + 0.3), 1e-3);
}

// Three masses in a row, the last one pulled: the joint next to it carries the force of the two others and fails; what
// is left continues as one. Sabotage: the whole weld released.
TEST(RigidWelds, ThreeNodesFailFromTheOutside) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 1.0, 0.1), b = s.mass_point({2, 0, 0}, 1.0, 0.1),
            c = s.mass_point({4, 0, 0}, 1.0, 0.1);
  s.node_set(1, {a, b, c});
  load(s, c, 1, 30.0);
  s.text(generalized(1, 0, {1e20, 0, 8.0, 0, 1.0, 0}));
  timing(s, 0.6);
  Experiment experiment(s.deck());
  double apart = 0.0, momentum = 0.0, at_release = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    apart = std::max(apart, std::abs(experiment.position(now, b).x - experiment.position(now, a).x - 2.0));
    momentum = experiment.velocity(now, a).x + experiment.velocity(now, b).x + experiment.velocity(now, c).x;
    if (at_release == 0.0 && experiment.position(now, c).x - experiment.position(now, b).x > 2.0 + 1e-6)
      at_release = now.state.time;
  });
  EXPECT_NEAR(apart, 0.0, 1e-12) << "the inner joint carries nothing any more";
  EXPECT_NEAR(at_release, 0.4, 0.003) << "8 of 30 t: two thirds of the load";
  EXPECT_NEAR(momentum, 15.0 * 0.36, 30.0 * step);
  EXPECT_EQ(experiment.simulation().components().rigid_welds.failed(), 0) << "two of its nodes still hold";
  EXPECT_EQ(experiment.simulation().components().rigid_welds.events().size(), 1u);
}

// A weld on a sheet that is stretched into the plastic range opens when an element at it has strained enough, and does
// not change the time step. Sabotage: the mean over the elements, or the far element's strain.
TEST(RigidWelds, PlasticStrainOfTheSheetOpensTheWeld) {
  const auto sheet = [](bool welded) {
    Specimen s;
    s.card("MAT_PLASTIC_KINEMATIC", {1, 7.85e-9, 210000.0, 0.3, 250.0, 1000.0, 1.0}).text(fields({}));
    s.card("SECTION_SHELL", {1, 2, 1, 2}).text(fields({1.0}));
    s.part(1, 1, 1);
    const Grid g = s.shells(1, {0, 0, 0}, {40, 10, 0}, 4, 1);
    s.node_set(1, g.across(0)).node_set(2, g.across(4));
    s.card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
    s.text(curve(1, {{0.0, 0.0}, {1.0, 1.0}}));
    s.card("BOUNDARY_PRESCRIBED_MOTION_SET", {2, 1, 2, 1, 4000.0});
    const int loose = s.mass_point({20, 0, 3}, 1e-9, 1e-10);
    if (welded) s.card("CONSTRAINED_SPOTWELD", {double(g(2, 0)), double(loose), 0, 0, 0, 0, 1e20, 0.02});
    s.card("CONTROL_TERMINATION", {3e-4});
    return s.deck();
  };
  Experiment plain(sheet(false)), welded(sheet(true));
  const auto run = [](Experiment& e) { run_to_end(e, [](const impact::Snapshot&) {}); };
  run(plain);
  double before = 0.0;
  run_to_end(welded, [&](const impact::Snapshot& now) {
    double largest = 0.0;
    for (const int e : {2, 3}) largest = std::max(largest, shell_layer(welded, now, e, 0).plastic_strain);
    if (!now.components.rigid_welds.history(0).failed()) before = largest;
  });
  EXPECT_EQ(plain.simulation().first_step(), welded.simulation().first_step());
  EXPECT_EQ(welded.simulation().components().rigid_welds.failed(), 1);
  EXPECT_LE(before, 0.02);
  EXPECT_GT(before, 0.0195);
  EXPECT_THAT(welded.simulation().components().rigid_welds.events().at(0), HasSubstr("plastic strain"));
}

}  // namespace
}  // namespace nugget::verify
