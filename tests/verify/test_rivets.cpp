// SPDX-License-Identifier: Apache-2.0
// Rivets (*CONSTRAINED_RIVET): rigid massless trusses between two nodes, against Newton's laws.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

using testing::HasSubstr;

constexpr double step = 1e-4;

Specimen& timing(Specimen& s, double end) {
  return s.text(constant_curve(1) + constant_curve(2, step))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 2})
      .card("CONTROL_TERMINATION", {end});
}

// Masses 2 and 1, three apart, spin about their centre: tension m1 m2/(m1 + m2) omega^2 L; the distance stays.
// Sabotage: the truss as a spring; the constraint on velocities only, whose distance drifts.
TEST(Rivets, ASpinningPairKeepsItsDistance) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 2.0, 0.2), b = s.mass_point({3, 0, 0}, 1.0, 0.1);
  const double omega = 4.0;
  s.card("INITIAL_VELOCITY_NODE", {double(a), 0, -omega * 1.0, 1});
  s.card("INITIAL_VELOCITY_NODE", {double(b), 0, omega * 2.0, 1});
  s.card("CONSTRAINED_RIVET", {double(a), double(b)});
  timing(s, 4.0);
  Experiment experiment(s.deck());
  double tension = 0.0, distance = 0.0, ratio = 0.0, drift = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle < 2) return;
    const impact::Rivets& rivets = now.components.rivets;
    tension = std::max(tension, std::abs(rivets.axial(0) - 32.0));
    distance = std::max(distance, std::abs(rivets.length(0, now.state) - 3.0));
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
    drift = std::max(drift, norm(2.0 * experiment.velocity(now, a) + experiment.velocity(now, b) - Vec3d{0, 0, 3}));
  });
  expect_reference("rivet", "spinning pair over 2.5 turns: largest error of the tension of 32", tension, 0.0, 1e-6,
                   32.0);
  expect_reference("rivet", "spinning pair over 2.5 turns: largest change of the distance of 3", distance, 0.0, 1e-12,
                   3.0);
  EXPECT_NEAR(ratio, 0.0, 1e-6);
  EXPECT_NEAR(drift, 0.0, 1e-9);
}

// A pendulum released from the horizontal: 3 m g in the truss at the bottom, and in the support. Sabotage: the held
// node taken for a free one; the reaction without the truss.
TEST(Rivets, APendulumPullsThreeTimesItsWeightAtTheBottom) {
  Specimen s;
  const int pivot = s.mass_point({0, 0, 0}, 1.0, 0.1), bob = s.mass_point({2, 0, 0}, 1.5, 0.15);
  const double weight = 1.5 * 10.0;
  s.card("BOUNDARY_SPC_NODE", {double(pivot), 0, 1, 1, 1, 1, 1, 1});
  s.card("LOAD_NODE_POINT", {double(bob), 3, 1, -weight});
  s.card("CONSTRAINED_RIVET", {double(pivot), double(bob)});
  timing(s, 1.2);
  Experiment experiment(s.deck());
  double largest = 0.0, support = 0.0, distance = 0.0, speed = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    largest = std::max(largest, now.components.rivets.axial(0));
    distance = std::max(distance, std::abs(now.components.rivets.length(0, now.state) - 2.0));
    speed = std::max(speed, norm(experiment.velocity(now, bob)));
    for (const impact::Supports::Reaction& r : now.components.supports.spc_reactions())
      support = std::max(support, norm(r.force));
  });
  expect_reference("rivet", "pendulum from the horizontal: largest tension over its weight", largest / weight, 3.0,
                   1e-5);
  expect_reference("rivet", "pendulum from the horizontal: largest force in its support over its weight",
                   support / weight, 3.0, 1e-5);
  expect_reference("rivet", "pendulum from the horizontal: speed at the bottom", speed, std::sqrt(2.0 * 10.0 * 2.0),
                   1e-5);
  EXPECT_NEAR(distance, 0.0, 1e-12);
}

// Three masses in a row on two rivets, the last one pulled along: the first truss carries the force of one mass, the
// second that of two. A pull across them moves the last one alone. Sabotage: one pass over the rivets instead of all.
TEST(Rivets, ChainsAreSolvedTogether) {
  Specimen s;
  std::array<int, 3> n{};
  for (int i = 0; i < 3; ++i) n[i] = s.mass_point({2.0 * i, 0, 0}, 1.0, 0.1);
  s.card("CONSTRAINED_RIVET", {double(n[0]), double(n[1])});
  s.card("CONSTRAINED_RIVET", {double(n[1]), double(n[2])});
  s.card("LOAD_NODE_POINT", {double(n[2]), 1, 1, 6.0});
  timing(s, 0.5);
  Experiment experiment(s.deck());
  double error = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    error = std::max(
        {error, std::abs(now.components.rivets.axial(0) - 2.0), std::abs(now.components.rivets.axial(1) - 4.0)});
  });
  // 1e-13 of the length is a force of 1e-13 L m / step^2 = 2e-5.
  expect_reference("rivet", "three masses on two rivets, pulled with 6: largest error of the tensions 2 and 4", error,
                   0.0, 2e-5, 6.0);
}

// At TF the pair flies on as it moves. Sabotage: the truss holds on.
TEST(Rivets, FailAtTheirTime) {
  Specimen s;
  const int a = s.mass_point({0, 0, 0}, 1.0, 0.1), b = s.mass_point({2, 0, 0}, 1.0, 0.1);
  s.card("INITIAL_VELOCITY_NODE", {double(a), 0, -3.0, 0});
  s.card("INITIAL_VELOCITY_NODE", {double(b), 0, 3.0, 0});
  s.text("*CONSTRAINED_RIVET_ID\n" + fields({77}) + fields({double(a), double(b), 0.25}));
  timing(s, 1.0);
  Experiment experiment(s.deck());
  double after = 0.0, speed = 0.0;
  Vec3d at_failure;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (!now.components.rivets.failed(0)) return;
    if (norm(at_failure) == 0.0) at_failure = vec(now.state.v[experiment.node(b)]);
    after = std::max(after, norm(vec(now.state.v[experiment.node(b)]) - at_failure));
    speed = norm(at_failure);
    EXPECT_EQ(now.components.rivets.axial(0), 0.0);
  });
  EXPECT_NEAR(after, 0.0, 1e-12);
  EXPECT_NEAR(speed, 3.0, 1e-5);
  EXPECT_NEAR(experiment.simulation().components().rivets.failure_time(0), 0.25, 1.01 * step);
  EXPECT_THAT(experiment.simulation().components().rivets.events().at(0), HasSubstr("rivet failed  id=      77"));
}

TEST(Rivets, NodesThatCannotBePulledAreRefusedByName) {
  const auto refusal = [](const std::string& more) {
    Specimen s;
    const int a = s.mass_point({0, 0, 0}, 1.0, 0.1), b = s.mass_point({2, 0, 0}, 1.0, 0.1),
              c = s.mass_point({3, 0, 0}, 1.0, 0.1);
    s.card("CONSTRAINED_RIVET", {double(a), double(b)});
    s.node_set(1, {b, c});
    s.text(more);
    timing(s, 0.1);
    try {
      Experiment experiment(s.deck());
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(""), "");
  EXPECT_THAT(refusal("*CONSTRAINED_NODAL_RIGID_BODY\n" + fields({50, 0, 1})),
              HasSubstr("node 2 moves with nodal rigid body 50, and a rivet cannot pull it"));
  EXPECT_THAT(refusal("*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + fields({2, 1, 0, 1})),
              HasSubstr("node 2 is driven: not built for a node of a rivet"));
}

}  // namespace
}  // namespace nugget::verify
