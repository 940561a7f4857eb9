// SPDX-License-Identifier: Apache-2.0
// Joints and their stiffnesses between rigid bodies in linear statics and modes, against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "joint_decks.hpp"
#include "linear.hpp"
#include "nvh/response/frequency_response.hpp"
#include "nvh/response/steady_state.hpp"
#include "nvh/statics/statics.hpp"

namespace nugget::verify {
namespace {

constexpr double length = 400.0, stiffness = 30.0, load = 12.0;

/// A rod of 400 along x from a support at the origin, with a node in its middle and one at its end.
struct Rod {
  Specimen s;
  Pairs pair;
  int middle, end;

  explicit Rod(const std::string& analysis, std::initializer_list<Vec3d> places)
      : s(begin(analysis)), pair(s, places), middle(s.node({0.5 * length, 0, 0})), end(s.node({length, 0, 0})) {
    std::vector<int> own = pair.b;
    own.insert(own.end(), {middle, end});
    body(s, 1, {.fixed = true}, pair.a);
    body(s, 2, {.center = {0.5 * length, 0, 0}, .mass = 2e-3, .inertia = {1.0, 40.0, 40.0}}, own);
  }
  static Specimen begin(const std::string& analysis) {
    Specimen s;
    s.text(analysis).card("CONTROL_TERMINATION", {1.0}).text(curve(9, {{0.0, 0.0}, {1.0, 1.0}}));
    s.text("*MAT_SPRING_ELASTIC\n" + fields({90, stiffness}) + "*SECTION_DISCRETE\n" + fields({90, 0}) +
           fields({0, 0}));
    s.part(90, 90, 90).text("*DEFINE_SD_ORIENTATION\n" + fields({3, 0, 0, 0, 1}));
    return s;
  }
  Rod& ground_spring(int node) {
    s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}{:8}{:16g}\n", node, 90, node, 0, 3, 1.0));
    return *this;
  }
  Rod& push(int node) {
    s.card("LOAD_NODE_POINT", {1.0 * node, 3, 9, load});
    return *this;
  }
};

const std::string statics =
    "*CONTROL_IMPLICIT_GENERAL\n" + fields({1, 1}) + "*CONTROL_IMPLICIT_SOLUTION\n" + fields({1});

nvh::Statics solve(const LinearExperiment& experiment) {
  Findings findings;
  nvh::check_statics(experiment.system().model, findings);
  const nvh::Statics solved = nvh::solve_statics(experiment.matrices(), findings);
  EXPECT_EQ(findings.errors(), 0);
  EXPECT_NEAR(solved.energy, solved.external, 1e-6 * solved.energy);
  return solved;
}

double lift(const LinearExperiment& e, const nvh::Statics& solved, int node) {
  const auto n = at(e.system().model.node_index(node));
  return solved.motion[e.system().node_of[n]][2];
}

// A rod on a hinge and a spring, pushed in its middle: half the load each, the end rises by F / (2 k). Sabotage: the
// joint's force on its first body; the hinge holds its axis.
TEST(JointStatics, RodOnAHinge) {
  Rod rod(statics, {{0, 0, 0}, {0, 100, 0}});
  joint(rod.s, "REVOLUTE", rod.pair);
  rod.ground_spring(rod.end).push(rod.middle);
  const LinearExperiment e(rod.s.deck());
  const nvh::Statics solved = solve(e);
  expect_reference("joints", "rod on a hinge and a spring, static: rise of its end [mm]", lift(e, solved, rod.end),
                   load / (2.0 * stiffness), 1e-4);
  ASSERT_EQ(solved.joint.size(), 1u);
  EXPECT_NEAR(solved.joint[0][2], -0.5 * load, 1e-4 * load);
  for (const std::size_t i : {0u, 1u, 3u, 4u, 5u}) EXPECT_NEAR(solved.joint[0][i], 0.0, 1e-4 * load * length);
}

// A rod locked to its support carries its load by force and moment there, F and F L. Sabotage: rotations free.
TEST(JointStatics, RodLockedAtItsEnd) {
  Rod rod(statics, {{0, 0, 0}, {100, 0, 0}, {0, 100, 0}});
  joint(rod.s, "LOCKING", rod.pair);
  rod.push(rod.end);
  const LinearExperiment e(rod.s.deck());
  const nvh::Statics solved = solve(e);
  EXPECT_NEAR(solved.joint[0][2], -load, 1e-6 * load);
  EXPECT_NEAR(solved.joint[0][4], load * length, 1e-6 * load * length);
}

std::string joint_spring(double per_radian) {
  return curve(31, {{0.0, 0.0}, {1.0, per_radian}}) + "*DEFINE_COORDINATE_VECTOR\n" + fields({41, 1, 0, 0, 0, 1, 0}) +
         "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n" + fields({1, 1, 2, 41, 0}) + fields({0, 31, 0}) + fields({0}) +
         fields({0});
}

// The hinge turns against a joint stiffness C: the end rises by F L^2 / (2 C) and the rod swings at sqrt(C / I).
// Sabotage: the curve of another axis; degrees.
TEST(JointStatics, StiffnessOfAHinge) {
  constexpr double rotary = 5e6;
  for (const bool modes : {false, true}) {
    Rod rod(modes ? "*CONTROL_IMPLICIT_GENERAL\n" + fields({1, 1}) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields({1})
                  : statics,
            {{0, 0, 0}, {0, 100, 0}});
    joint(rod.s, "REVOLUTE", rod.pair);
    rod.s.text(joint_spring(rotary));
    rod.push(rod.middle);
    const LinearExperiment e(rod.s.deck());
    if (modes)
      expect_reference("joints", "rod on a hinge with stiffness [rad/s]", std::sqrt(e.modes(1).eigenvalue[0]),
                       std::sqrt(rotary / (40.0 + 2e-3 * 0.25 * length * length)), 1e-4);
    else
      expect_reference("joints", "rod on a hinge with stiffness, static: rise of its end [mm]",
                       lift(e, solve(e), rod.end), load * length * length / (2.0 * rotary), 1e-4);
  }
}

// The hinge with a damper D beside its stiffness, by DMPFLG 1: the end of the rod answers a force there with
// L^2 / (C - omega^2 I + i omega D), by modes and directly. Sabotage: the damper left out; its slope at another rate.
TEST(JointStatics, DamperOfAHinge) {
  constexpr double rotary = 5e6, damper = 2e4, inertia = 40.0 + 2e-3 * 0.25 * length * length;
  const double omega = 0.9 * std::sqrt(rotary / inertia), frequency = omega / (2.0 * std::numbers::pi);
  Rod rod("*CONTROL_IMPLICIT_GENERAL\n" + fields({1, 1}) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields({1}),
          {{0, 0, 0}, {0, 100, 0}});
  joint(rod.s, "REVOLUTE", rod.pair);
  std::string cards = joint_spring(rotary);
  cards.replace(cards.find(fields({0, 31, 0})), fields({0, 31, 0}).size(), fields({0, 31, 0, 0, 32, 0}));
  rod.s.text(cards + curve(32, {{-1.0, -damper}, {0.0, 0.0}, {1.0, damper}, {2.0, damper}}));
  rod.s.text(curve(11, {{0.0, 3.0}, {10.0 * frequency, 3.0}}) + "*FREQUENCY_DOMAIN_SSD\n" + fields({1}) +
             fields({0, 0, 0, 0, 0, 1}) + fields({0}) + fields({1.0 * rod.end, 0, 3, 0, 11}) +
             "*DATABASE_FREQUENCY_ASCII_NODOUT_SSD\n" + fields({frequency, 2.0 * frequency, 2}) +
             "*DATABASE_HISTORY_NODE\n" + fields({1.0 * rod.end}));
  const LinearExperiment e(rod.s.deck());
  model::SteadyState request = *e.system().model.steady_state;
  for (const bool direct : {false, true}) {
    request.direct = direct;
    const nvh::SteadyResult result = nvh::steady_state(e.matrices(), direct ? nvh::Modes{} : e.modes(1), request);
    const double w = 2.0 * std::numbers::pi * result.frequency[0];
    const std::complex<double> expected =
        3.0 * length * length / std::complex<double>(rotary - w * w * inertia, w * damper);
    EXPECT_LT(std::abs(result.curve[2].value[0][0] - expected), 1e-4 * std::abs(expected)) << direct;
  }
}

// A rod on a hinge, driven at its end through a spring: its middle moves by 1/2 / (1 - omega^2 I / (k L^2)). Sabotage:
// joints left out of the shape that goes along.
TEST(JointStatics, EnforcedMotionOfAHingedRod) {
  Rod rod("*CONTROL_IMPLICIT_GENERAL\n" + fields({1, 1}) + "*CONTROL_IMPLICIT_EIGENVALUE\n" + fields({1}),
          {{0, 0, 0}, {0, 100, 0}});
  joint(rod.s, "REVOLUTE", rod.pair);
  const int driven = rod.s.node({length, 0, 0});
  rod.s.text(fmt::format("*ELEMENT_MASS\n{:8}{:8}{:16g}\n", 1, driven, 1e-4));
  rod.s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}{:8}{:16g}\n", 1, 90, driven, rod.end, 3, 1.0));
  rod.s.text("*FREQUENCY_DOMAIN_FRF\n" + fields({1.0 * driven, 0, 3, 7}) + fields({0.0}) +
             fields({1.0 * rod.middle, 0, 3, 2}) + fields({1, 2, 2}));
  const LinearExperiment e(rod.s.deck());
  const double omega = 100.0, inertia = 40.0 + 2e-3 * 0.25 * length * length;
  model::FrequencyResponse request = *e.system().model.frequency_response;
  request.frequency = {omega / (2.0 * std::numbers::pi)};
  const double expected = 0.5 / (1.0 - omega * omega * inertia / (stiffness * length * length));
  for (const bool direct : {false, true}) {
    request.direct = direct;
    Findings findings;
    nvh::check_frequency_response(e.matrices(), request, findings);
    EXPECT_EQ(findings.errors(), 0);
    const nvh::FrfResult result = nvh::frequency_response(e.matrices(), direct ? nvh::Modes{} : e.modes(1), request);
    expect_reference("joints", direct ? "rod on a hinge, driven, directly" : "rod on a hinge, driven, by modes",
                     result.curve[0].value[0].real(), expected, 1e-4);
  }
}

}  // namespace
}  // namespace nugget::verify
