// SPDX-License-Identifier: Apache-2.0
// Joints between rigid bodies: pendulums, a universal joint, free sliding and turning, momentum, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "impact/recording/histories.hpp"
#include "joint_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi;

// The pendulum on a hinge: a uniform rod released from the horizontal. The hinge's reaction at the bottom is m g (1 +
// 3/2), and it has no moment about its axis. Sabotage: the hinge's damper about its own axis.
void pendulum(bool by_points) {
  const double length = 400.0, g = 9810.0, m = 2e-3, across = m * length * length / 12.0;
  Specimen s;
  const Pairs p(s, {{0, 0, 0}, {0, 100, 0}});
  body(s, 1, {.center = {0, 0, 0}, .fixed = true}, p.a);
  body(s, 2, {.center = {0.5 * length, 0, 0}, .mass = m, .inertia = {0.01 * across, across, across}}, p.b);
  if (by_points)
    joint_by_points(s, "REVOLUTE", {{0, 0, 0}, {0, 100, 0}});
  else
    joint(s, "REVOLUTE", p);
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, g});
  timing(s, 1.3, 2e-5);
  Experiment experiment(s.deck());
  double fastest = 0.0, twist = 0.0, drift = 0.0, reaction = 0.0, last = 0.0, before = 1.0, period = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double rate = spin(now, 2).y;
    if (now.state.time > 0.1 && before < 0.0 && rate >= 0.0)
      period = last + (now.state.time - last) * before / (before - rate);
    if (std::abs(rate) > fastest) {
      fastest = std::abs(rate);
      reaction = now.components.joints.force(0).z;
    }
    before = rate;
    last = now.state.time;
    twist = std::max(twist, std::abs(now.components.joints.moment(0).y));
    drift = std::max(drift, std::abs(now.energy.total() - now.energy.external));
  });
  expect_reference("pendulum", "rod on a hinge: period [s]", period, 1.222748, 5e-3);
  expect_reference("pendulum", "rod on a hinge: spin at the bottom [rad/s]", fastest, 8.57759, 5e-3);
  expect_reference("joints", "rod on a hinge: reaction at the bottom [N]", reaction, 2.5 * m * g, 5e-3);
  expect_reference("joints", "rod on a hinge: moment about its axis, of m g L", twist, 0.0, 1e-9, m * g * length);
  EXPECT_NEAR(drift, 0.0, 1e-4 * m * g * length);
}
TEST(Joints, PhysicalPendulumOnAHinge) {
  pendulum(false);
}
TEST(Joints, PhysicalPendulumOnAHingeByPoints) {
  pendulum(true);
}

// Two rods on ball joints without damping, falling from the horizontal, out of plane: energy, and the joints stay
// closed.
TEST(Joints, DoublePendulumKeepsItsEnergy) {
  const double g = 9.81;
  Specimen s;
  const Pairs top(s, {{0, 0, 0}}), middle(s, {{1, 0, 0}});
  body(s, 1, {.center = {0, 0, 0}, .fixed = true}, top.a);
  std::vector<int> first = top.b;
  first.push_back(middle.a[0]);
  body(s, 2,
       {.center = {0.5, 0, 0}, .mass = 2.0, .inertia = {0.02, 0.2, 0.2}, .velocity = {0, 0.5, 0}, .spin = {0, 0, 1}},
       first);
  body(s, 3, {.center = {1, 0.4, 0}, .mass = 1.0, .inertia = {0.1, 0.01, 0.1}, .velocity = {0, 1, 0}}, middle.b);
  joint(s, "SPHERICAL", top, 0.01);
  joint(s, "SPHERICAL", middle, 0.01);
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, g});
  timing(s, 3.0, 2e-4);
  Experiment experiment(s.deck());
  double drift = 0.0, open = 0.0, kinetic = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    drift = std::max(drift, std::abs(now.energy.total() - now.energy.external - now.energy.initial));
    kinetic = std::max(kinetic, now.energy.kinetic);
    for (std::size_t j = 0; j < 2; ++j) open = std::max(open, now.components.joints.largest_opening(j));
  });
  expect_reference("joints", "double pendulum: drift of the total energy, of the largest kinetic one", drift, 0.0, 1e-3,
                   kinetic);
  expect_reference("joints", "double pendulum: joints stay closed, of 1 m", open, 0.0, 5e-4, 1.0);
}

// Two free bodies on a hinge, tumbling: momentum and angular momentum to round-off. Sabotage: the force on A at its own
// point while it has slid.
TEST(Joints, FreeBodiesKeepTheirMomenta) {
  for (const std::string kind :
       {"SPHERICAL", "REVOLUTE", "CYLINDRICAL", "PLANAR", "UNIVERSAL", "TRANSLATIONAL", "LOCKING"}) {
    Specimen s;
    Pairs p(s, {{1, 0, 0}});
    if (kind == "UNIVERSAL") {
      p.a.push_back(s.node({1, 1, 0}));
      p.b.push_back(s.node({1, 0, 1}));
    } else if (kind != "SPHERICAL") {
      const Pairs more(s, {{1, 1, 0}, {1, 0, 1}});
      const std::size_t count = kind == "TRANSLATIONAL" || kind == "LOCKING" ? 2 : 1;
      p.a.insert(p.a.end(), more.a.begin(), more.a.begin() + static_cast<std::ptrdiff_t>(count));
      p.b.insert(p.b.end(), more.b.begin(), more.b.begin() + static_cast<std::ptrdiff_t>(count));
    }
    body(s, 1,
         {.center = {0, 0, 0}, .mass = 2.0, .inertia = {0.3, 0.5, 0.7}, .velocity = {0, 0.2, 0}, .spin = {1, 0.5, 0.3}},
         p.a);
    body(s, 2,
         {.center = {2, 0.3, 0}, .mass = 1.0, .inertia = {0.2, 0.3, 0.1}, .velocity = {0.3, 0, 1}, .spin = {0, 0.2, 1}},
         p.b);
    joint(s, kind, p);
    timing(s, 2.0, 1e-3);
    Experiment experiment(s.deck());
    Drift drift;
    run_to_end(experiment, [&](const impact::Snapshot& now) { drift.add(now); });
    EXPECT_NEAR(drift.linear, 0.0, 1e-12) << kind;
    EXPECT_NEAR(drift.angular, 0.0, 1e-11) << kind;
    EXPECT_NEAR(drift.ratio, 0.0, 2e-3) << kind;
  }
}

// A universal joint between two shafts at an angle: the driven one turns at omega cos b / (1 - sin^2 b sin^2 theta).
TEST(Joints, UniversalJointTurnsUnevenly) {
  const double angle = 0.5, omega = 2.0 * pi;
  const Vec3d out{std::cos(angle), std::sin(angle), 0.0}, across{-std::sin(angle), std::cos(angle), 0.0};
  Specimen s;
  const Pairs input(s, {{-1, 0, 0}, {-2, 0, 0}}), output(s, {out, 2.0 * out});
  Pairs cross_joint(s, {{0, 0, 0}});
  // The driving fork lies along z, the driven one across both shafts.
  cross_joint.a.push_back(s.node({0, 0, 1}));
  cross_joint.b.push_back(s.node(across));
  const auto joined = [](std::vector<int> a, const std::vector<int>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  body(s, 1, {.center = {0, 0, 0}, .fixed = true}, joined(input.a, output.a));
  body(s, 2, {.center = {-0.5, 0, 0}, .mass = 1.0, .inertia = {0.1, 0.2, 0.2}, .spin = {omega, 0, 0}},
       joined(input.b, cross_joint.a));
  const double start = omega * std::cos(angle);  // the driving fork out of the plane of the shafts
  body(s, 3, {.center = 0.5 * out, .mass = 1e-3, .inertia = {1e-4, 1e-4, 1e-4}, .spin = start * out},
       joined(output.b, cross_joint.b));
  joint(s, "REVOLUTE", input);
  joint(s, "REVOLUTE", output);
  joint(s, "UNIVERSAL", cross_joint);
  s.text(curve(9, {{0, omega}, {10, omega}})).card("BOUNDARY_PRESCRIBED_MOTION_RIGID", {2, 5, 0, 9, 1});
  timing(s, 1.0, 1e-4);
  Experiment experiment(s.deck());
  double worst = 0.0, slowest = 1e9, fastest = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time < 0.1) return;
    const double theta = omega * now.state.time, rate = dot(spin(now, 3), out);
    // theta from the fork out of the shafts' plane: the ratio there is cos b, a quarter turn later 1 / cos b.
    const double sine = std::sin(angle) * std::sin(theta);
    const double expected = omega * std::cos(angle) / (1.0 - sine * sine);
    worst = std::max(worst, std::abs(rate - expected) / omega);
    slowest = std::min(slowest, rate);
    fastest = std::max(fastest, rate);
  });
  expect_reference("joints", "universal joint at 0.5 rad: least speed ratio", slowest / omega, std::cos(angle), 2e-3);
  expect_reference("joints", "universal joint: greatest speed ratio", fastest / omega, 1.0 / std::cos(angle), 2e-3);
  EXPECT_NEAR(worst, 0.0, 2e-2);
}

// What each joint leaves free goes on unchanged, what it holds is shared. Body A is fixed but for the locking joint.
TEST(Joints, FreedomsThatAreLeft) {
  struct Case {
    std::string kind;
    Vec3d velocity, spin;  ///< of B about the joint at its centre; the axis is z
    bool free;
  };
  const Case cases[] = {
      {"SPHERICAL", {}, {1, 2, 3}, true},      {"REVOLUTE", {}, {0, 0, 3}, true},
      {"REVOLUTE", {0, 0, 1}, {}, false},      {"CYLINDRICAL", {0, 0, 1}, {0, 0, 3}, true},
      {"CYLINDRICAL", {}, {1, 0, 0}, false},   {"PLANAR", {1, -1, 0}, {0, 0, 3}, true},
      {"PLANAR", {0, 0, 1}, {}, false},        {"PLANAR", {}, {0, 1, 0}, false},
      {"TRANSLATIONAL", {0, 0, 1}, {}, true},  {"TRANSLATIONAL", {}, {0, 0, 1}, false},
      {"TRANSLATIONAL", {1, 0, 0}, {}, false}, {"LOCKING", {0, 0, 1}, {}, false},
      {"LOCKING", {}, {0, 0, 1}, false},       {"UNIVERSAL", {}, {1, 2, 0}, true},
      {"UNIVERSAL", {}, {0, 0, 1}, false},
  };
  for (const bool by_points : {false, true})
    for (const Case& c : cases) {
      Specimen s;
      Pairs p(s, {{0, 0, 0}});
      if (c.kind == "UNIVERSAL") {
        p.a.push_back(s.node({1, 0, 0}));
        p.b.push_back(s.node({0, 1, 0}));
      } else if (c.kind != "SPHERICAL") {
        for (const Vec3d& x : {Vec3d{0, 0, 1}, Vec3d{1, 0, 0}}) {
          if (p.a.size() == 2 && c.kind != "TRANSLATIONAL" && c.kind != "LOCKING") break;
          p.a.push_back(s.node(x));
          p.b.push_back(s.node(x));
        }
      }
      body(s, 1, {.center = {0, 0, 0}, .fixed = true}, p.a);
      body(s, 2, {.center = {0, 0, 0}, .velocity = c.velocity, .spin = c.spin}, p.b);
      if (!by_points)
        joint(s, c.kind, p);
      else if (c.kind == "UNIVERSAL")
        joint_by_points(s, c.kind, {{0, 0, 0}, {1, 0, 0}}, {0, 1, 0});
      else
        joint_by_points(s, c.kind, {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
      timing(s, 0.8, 1e-3);
      Experiment experiment(s.deck());
      Vec3d v, w;
      run_to_end(experiment, [&](const impact::Snapshot& now) { v = velocity(now, 2), w = spin(now, 2); });
      const std::string what = fmt::format("{} {} {} {} / {} {} {}", c.kind, c.velocity.x, c.velocity.y, c.velocity.z,
                                           c.spin.x, c.spin.y, c.spin.z);
      const double kept = c.free ? 1.0 : 0.0;
      EXPECT_NEAR(norm(v - kept * c.velocity), 0.0, 0.02) << what;
      // A universal joint's axes turn with the bodies: two rotations at once are no longer free.
      if (c.kind == "UNIVERSAL" && c.free) continue;
      EXPECT_NEAR(norm(w - kept * c.spin), 0.0, 0.05) << what;
    }
}

// Two bodies locked together far from their centres turn as one: spin by the parallel-axis theorem.
TEST(Joints, LockedBodiesTurnAsOne) {
  Specimen s;
  const Pairs p(s, {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}});
  body(s, 1, {.center = {0, 0, 0}, .mass = 2.0, .inertia = {0.5, 0.5, 0.5}, .spin = {0, 0, 1}}, p.a);
  body(s, 2, {.center = {2, 0, 0}, .mass = 2.0, .inertia = {0.5, 0.5, 0.5}}, p.b);
  joint(s, "LOCKING", p, 3.0);
  timing(s, 0.5, 1e-3);
  Experiment experiment(s.deck());
  Vec3d a, b;
  run_to_end(experiment, [&](const impact::Snapshot& now) { a = spin(now, 1), b = spin(now, 2); });
  // Angular momentum about the common centre: 0.5 1 of the first body alone; both together 2 (0.5 + 2).
  expect_reference("joints", "locking joint: common spin of two bodies", a.z, 0.5 / 5.0, 1e-3);
  EXPECT_NEAR(b.z, a.z, 1e-4);
}

/// Joints of bodies 1 (held) and 2, mass 2, whose centre is 3 along x from the joint, under a weight that grows as
/// 100 t: when the joint, with these cards behind it, is released.
double failing(const std::string& kind, const std::string& cards, double arm, const std::string& more = {}) {
  Specimen s;
  const Pairs p(s, {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}});
  body(s, 1, {.center = {0, 0, 0}, .fixed = true}, p.a);
  body(s, 2, {.center = {arm, 0, 0}, .mass = 2.0, .inertia = {1, 1, 1}}, p.b);
  joint(s, kind, p, 3.0);
  s.text(cards + more).text(curve(9, {{0, 0}, {10, 100}})).card("LOAD_BODY_Z", {9, 10});
  timing(s, 1.0, 1e-4);
  Experiment experiment(s.deck());
  double at = -1.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (at < 0.0 && now.components.joints.failed(0)) at = now.components.joints.failure_time(0);
    if (at > 0.0) {
      EXPECT_EQ(norm(now.components.joints.force(0)) + norm(now.components.joints.moment(0)), 0.0);
    }
  });
  return at;
}

// The weight is 200 t, its moment about the joint 200 t times the arm. Sabotage: sums not squared; COUPL the other way
// round; the limits of other axes; the force in global axes.
TEST(Joints, FailureByTimeAndLoad) {
  const auto cards = [](double cid, double time, double coupl, std::initializer_list<double> limits) {
    return fields({cid, time, coupl}) + fields(limits);
  };
  const double arm = 3.0;
  EXPECT_NEAR(failing("LOCKING_FAILURE", cards(0, 0.25, 0, {1e3}), 0.0), 0.25, 1.5e-4);
  expect_reference("joints", "joint gone at a force along z of 60 [s]",
                   failing("LOCKING_FAILURE", cards(0, 0, 0, {1, 1, 60}), 0.0), 0.3, 5e-3);
  const std::string tilted = "*DEFINE_COORDINATE_VECTOR\n" + fields({4, std::cos(0.5), 0, std::sin(0.5), 0, 1, 0});
  expect_reference("joints", "joint gone at a force of 30 along an axis at 0.5 rad [s]",
                   failing("LOCKING_FAILURE", cards(4, 0, 0, {30}), 0.0, tilted), 30 / (200 * std::sin(0.5)), 5e-3);
  expect_reference("joints", "joint gone by force and moment together [s]",
                   failing("LOCKING_FAILURE", cards(0, 0, 0, {0, 0, 60, 0, 200}), arm),
                   1 / std::hypot(200 / 60.0, 200 * arm / 200.0), 5e-3);
  expect_reference("joints", "joint gone by the moment alone [s]",
                   failing("LOCKING_FAILURE", cards(0, 0, 1, {0, 0, 80, 0, 200}), arm), 200 / (200 * arm), 5e-3);
  EXPECT_EQ(failing("LOCKING_FAILURE", cards(0, 0, 1, {0, 0, 800, 0, 2000}), arm), -1.0);
}

// A hinge that is released lets the rod fly: its centre falls freely, its spin stays. Sabotage: the joint goes on after
// it has failed.
TEST(Joints, ARodFliesFromAJointThatIsGone) {
  const double g = 9.81, gone = 0.3;
  Specimen s;
  const Pairs p(s, {{0, 0, 0}, {0, 1, 0}});
  body(s, 1, {.center = {0, 0, 0}, .fixed = true}, p.a);
  body(s, 2, {.center = {0.5, 0, 0}, .mass = 1.0, .inertia = {0.01, 1.0 / 12, 1.0 / 12}}, p.b);
  joint(s, "REVOLUTE_FAILURE", p, 3.0);
  s.text(fields({0, gone}) + fields({0}));
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, g});
  timing(s, 0.6, 1e-4);
  Experiment experiment(s.deck());
  Vec3d v, last;
  double w = 0.0, last_spin = 0.0, ratio = 0.0;
  bool flown = false;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (!flown && now.state.time > gone + 1e-3)
      flown = true, v = velocity(now, 2) + Vec3d{0, 0, g * now.state.time}, w = spin(now, 2).y;
    last = velocity(now, 2) + Vec3d{0, 0, g * now.state.time};
    last_spin = spin(now, 2).y;
    ratio = std::max(ratio, std::abs(now.energy.total() - now.energy.external));
  });
  ASSERT_TRUE(flown);
  EXPECT_GT(std::abs(w), 1.0);
  EXPECT_NEAR(norm(last - v), 0.0, 1e-9);
  EXPECT_NEAR(last_spin, w, 1e-9);
  EXPECT_NEAR(ratio, 0.0, 1e-3 * g);
}

// A weight 2 from the axis turns with a heavy wheel: in axes that turn along it pulls by m w^2 r along x all the time.
// Sabotage: axes of time 0; of the other body turned back.
TEST(Joints, ResultsInAxesThatTurnWithABody) {
  const double w = 3.0, m = 0.5, r = 2.0;
  Specimen s;
  const Pairs p(s, {{2, 0, 0}, {2, 0, 1}, {2, 1, 0}});
  body(s, 1, {.mass = 1e6, .inertia = {1e6, 1e6, 1e6}, .spin = {0, 0, w}}, p.a);
  body(s, 2, {.center = {r, 0, 0}, .mass = m, .inertia = {1, 1, 1}, .velocity = {0, w * r, 0}, .spin = {0, 0, w}}, p.b);
  joint(s, "LOCKING_LOCAL", p, 3.0);
  s.text(fields({1}));
  timing(s, 1.0, 1e-4);
  Experiment experiment(s.deck());
  double worst = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.time < 0.5) return;
    const output::JntforcRow row = impact::jntforc_state(now).rows.at(0);
    EXPECT_TRUE(row.local);
    worst = std::max(worst, norm(row.force - Vec3d{-m * w * w * r, 0, 0}));
  });
  EXPECT_NEAR(worst, 0.0, 0.01 * m * w * w * r);
}

/// All findings of a deck that is refused.
std::string refusal(const Specimen& s) {
  try {
    Experiment experiment(s.deck());
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Joints, FaultsAreNamed) {
  const auto deck = [](auto change) {
    Specimen s;
    Pairs p(s, {{0, 0, 0}, {0, 0, 1}});
    const int loose = s.node({0, 0, 0}), away = s.node({0, 0.5, 1});
    std::vector<int> b = p.b;
    b.push_back(away);
    body(s, 1, {.fixed = true}, p.a);
    body(s, 2, {}, b);
    change(s, p, loose, away);
    timing(s, 0.1, 1e-3);
    return refusal(s);
  };
  EXPECT_EQ(deck([](Specimen& s, Pairs& p, int, int) { joint(s, "REVOLUTE", p); }), "accepted");
  EXPECT_NE(deck([](Specimen& s, Pairs& p, int loose, int) {
              p.b[0] = loose;
              joint(s, "REVOLUTE", p);
            }).find("this node is on none"),
            std::string::npos);
  EXPECT_NE(deck([](Specimen& s, Pairs& p, int, int away) {
              p.b[1] = away;
              joint(s, "REVOLUTE", p);
            }).find("0.5 apart"),
            std::string::npos);
  EXPECT_NE(deck([](Specimen& s, Pairs&, int, int) {
              joint_by_points(s, "REVOLUTE", {{0, 0, 1}, {0, 0, 1}});
            }).find("at one place"),
            std::string::npos);
  EXPECT_NE(deck([](Specimen& s, Pairs&, int, int) {
              s.text("*CONSTRAINED_JOINT_COOR_SPHERICAL\n" + fields({1, 1}));
            }).find("this is body A"),
            std::string::npos);
  EXPECT_NE(deck([](Specimen& s, Pairs&, int, int) {
              s.text("*CONSTRAINED_JOINT_COOR_SPHERICAL\n" + fields({1, 2, 0, 0, 1e-3}));
            }).find("tmass"),
            std::string::npos);
  EXPECT_NE(deck([](Specimen& s, Pairs& p, int, int) {
              joint(s, "REVOLUTE", p);
              s.card("CONTROL_RIGID", {1});
            }).find("Lagrange"),
            std::string::npos);
}

}  // namespace
}  // namespace nugget::verify
