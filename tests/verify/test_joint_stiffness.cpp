// SPDX-License-Identifier: Apache-2.0
// Stiffness, damping, friction and stops between rigid bodies (*CONSTRAINED_JOINT_STIFFNESS_...), against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "joint_decks.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi;

/// A body on a hinge about z through the origin, or on a slide along z, and a stiffness against what holds it. The axes
/// of the stiffness are turned so that it is their `axis` (0 x, 1 y, 2 z) that counts.
struct Hinge {
  static constexpr double inertia = 2.0, mass = 3.0;
  Specimen s;
  bool slides;
  int axis;
  double start;

  Hinge(bool slide, int which, double speed) : slides(slide), axis(which), start(speed) {
    const Pairs p(s, {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}});
    body(s, 1, {.center = {0, 0, 0}, .fixed = true}, p.a);
    body(s, 2,
         {.center = {0, 0, 0},
          .mass = mass,
          .inertia = {inertia, inertia, inertia},
          .velocity = {0, 0, slides ? speed : 0.0},
          .spin = {0, 0, slides ? 0.0 : speed}},
         p.b);
    Pairs pairs = p;
    if (!slides) pairs.a.pop_back(), pairs.b.pop_back();
    joint(s, slides ? "TRANSLATIONAL" : "REVOLUTE", pairs);
    const std::string axes[] = {fields({1, 0, 0, 0, 0, 0, 1}) + fields({1, 0, 0}),
                                fields({1, 0, 0, 0, 0, 1, 0}) + fields({0, 0, 1}),
                                fields({1, 0, 0, 0, 1, 0, 0}) + fields({0, 1, 0})};
    s.text("*DEFINE_COORDINATE_SYSTEM\n" + axes[axis]);
  }

  /// Fields of the stiffness at the axis that counts.
  Hinge& stiffness(double load, double damper, double spring, double friction, double low, double high) {
    const auto at = [this](double x) {
      return std::array{axis == 0 ? x : 0.0, axis == 1 ? x : 0.0, axis == 2 ? x : 0.0};
    };
    const auto pairs = [&](double a, double b) {
      const auto x = at(a), y = at(b);
      return fields({x[0], y[0], x[1], y[1], x[2], y[2]});
    };
    const auto x = at(load), y = at(damper);
    s.text(std::string("*CONSTRAINED_JOINT_STIFFNESS_") + (slides ? "TRANSLATIONAL\n" : "GENERALIZED\n") +
           fields({7, 1, 2, 1}) + fields({x[0], x[1], x[2], y[0], y[1], y[2]}) + pairs(spring, friction) +
           pairs(low, high));
    return *this;
  }

  /// Time, and rotation or displacement. The largest drift of the total energy, of the first, is looked at.
  std::vector<std::pair<double, double>> run(double end, double step, double drift = 2e-3) {
    timing(s, end, step);
    Experiment experiment(s.deck());
    std::vector<std::pair<double, double>> path;
    double turned = 0.0, first = 0.0, worst = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      path.push_back({now.state.time, slides ? place(now, 2).z : turned});
      turned += now.state.dt * vec(now.state.w[body_of(now, 2).node]).z;
      if (first == 0.0) first = now.energy.total();
      worst = std::max(worst, std::abs(now.energy.total() / first - 1.0));
    });
    EXPECT_LT(worst, drift);
    return path;
  }
  double moved() const { return slides ? mass : inertia; }
  std::string name(const std::string& what) const {
    return fmt::format("{} about {}: {}", slides ? "displacement" : "rotation", "xyz"[axis], what);
  }
};

double largest(const std::vector<std::pair<double, double>>& path, double from = 0.0) {
  double most = 0.0;
  for (const auto& [t, x] : path)
    if (t >= from) most = std::max(most, x);
  return most;
}
/// When the path comes down through 0 first.
double half_period(const std::vector<std::pair<double, double>>& path) {
  for (std::size_t i = 2; i < path.size(); ++i)
    if (path[i].second <= 0.0 && path[i - 1].second > 0.0) {
      const auto& [t, x] = path[i - 1];
      return t + (path[i].first - t) * x / (x - path[i].second);
    }
  return 0.0;
}

// A linear curve: period 2 pi sqrt(I / k), amplitude speed / omega. Sabotage: axes of B not turned with it would not
// show here; the moment on A instead of B does.
TEST(JointStiffness, Oscillator) {
  for (const bool slides : {false, true})
    for (const int axis : {0, 1, 2}) {
      Hinge h(slides, axis, 1.5);
      h.s.text(curve(20, {{-10.0, -500.0}, {10.0, 500.0}}));
      h.stiffness(20, 0, 0, 0, 0, 0);
      const auto path = h.run(2.0, 1e-3);
      const double omega = std::sqrt(50.0 / h.moved());
      expect_reference("joints", h.name("half a period of a linear curve [s]"), half_period(path), pi / omega, 2e-3);
      expect_reference("joints", h.name("amplitude"), largest(path), 1.5 / omega, 2e-3);
    }
}

// Only damping: the speed decays as exp(-c t / I).
TEST(JointStiffness, Damper) {
  for (const bool slides : {false, true}) {
    Hinge h(slides, 2, 2.0);
    h.s.text(curve(20, {{-10.0, -40.0}, {10.0, 40.0}}));
    h.stiffness(0, 20, 0, 0, 0, 0);
    const auto path = h.run(1.0, 5e-4);
    const double rate = 4.0 / h.moved();
    expect_reference("joints", h.name("way against a linear damper"), path.back().second,
                     2.0 * (1.0 - std::exp(-rate)) / rate, 3e-3);
  }
}

// Friction is a spring ES up to FM: from speed v the body stops after m v^2 / (2 FM) + FM / (2 ES) and then swings
// about FM / ES before that.
TEST(JointStiffness, Friction) {
  for (const bool slides : {false, true}) {
    Hinge h(slides, 1, 2.0);
    h.stiffness(0, 0, 400.0, 5.0, 0, 0);
    const auto path = h.run(2.0, 2e-4, 5e-3);
    const double way = h.moved() * 2.0 * 2.0 / (2.0 * 5.0) + 5.0 / (2.0 * 400.0);
    expect_reference("joints", h.name("way against friction"), largest(path), way, 2e-3);
    double low = 1e9;
    for (const auto& [t, x] : path)
      if (t > 1.6) low = std::min(low, x);
    EXPECT_NEAR(low, way - 2.0 * 5.0 / 400.0, 2e-3) << slides;
  }
}

// A stop at 20 degrees (or 0.35): beyond it a spring ES; thrown back it meets the other one. Sabotage: the stop's angle
// in radians.
TEST(JointStiffness, Stops) {
  for (const bool slides : {false, true})
    for (const int axis : {0, 2}) {
      Hinge h(slides, axis, 3.0);
      const double high = slides ? 0.35 : 20.0, low = slides ? 0.2 : 10.0, unit = slides ? 1.0 : pi / 180.0;
      h.stiffness(0, 0, 3000.0, 0, low, high);
      const auto path = h.run(0.6, 1e-4);
      const double beyond = 3.0 * std::sqrt(h.moved() / 3000.0);
      expect_reference("joints", h.name("turn at the stop"), largest(path), high * unit + beyond, 2e-3);
      double least = 0.0;
      for (const auto& [t, x] : path) least = std::min(least, x);
      expect_reference("joints", h.name("turn at the other stop"), least, -low * unit - beyond, 2e-3);
    }
}

// Systems that do not agree at the start are loaded at once: turned by 0.3 against each other, it swings about that.
TEST(JointStiffness, WhatIsTurnedIsLoaded) {
  Hinge h(false, 2, 0.0);
  h.s.text("*DEFINE_COORDINATE_SYSTEM\n" + fields({2, 0, 0, 0, std::cos(0.3), std::sin(0.3), 0}) + fields({0, 1, 0}));
  h.s.text(curve(20, {{-10.0, -500.0}, {10.0, 500.0}}));
  h.s.text("*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n" + fields({7, 1, 2, 1, 2}) + fields({0, 0, 20}) + fields({}) +
           fields({}));
  timing(h.s, 1.0, 1e-3);
  Experiment experiment(h.s.deck());
  double turned = 0.0, least = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    least = std::min(least, turned);
    turned += now.state.dt * vec(now.state.w[body_of(now, 2).node]).z;
  });
  expect_reference("joints", "systems 0.3 rad apart at the start: turn to the other side", least, -0.6, 2e-3);
}

// Two free bodies far apart, no joint: all stiffnesses at once keep both momenta; the step follows from them alone.
TEST(JointStiffness, FreeBodiesKeepTheirMomenta) {
  Specimen s;
  body(s, 1, {.center = {0, 0, 0}, .mass = 2.0, .inertia = {0.3, 0.5, 0.7}, .spin = {1, 0.5, 0.3}},
       {s.node({1, 0, 0})});
  body(s, 2, {.center = {2, 0.3, 0}, .mass = 1.0, .inertia = {0.2, 0.3, 0.1}, .velocity = {0.3, 0, 1}},
       {s.node({2, 1, 0})});
  s.text("*DEFINE_COORDINATE_SYSTEM\n" + fields({1, 0.5, 0.2, 0, 1.5, 0.2, 0.4}) + fields({0.5, 1.2, 0}));
  s.text(curve(20, {{-10.0, -300.0}, {10.0, 300.0}})).text(curve(21, {{-10.0, -5.0}, {10.0, 5.0}}));
  s.text("*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n" + fields({1, 1, 2, 1}) + fields({20, 20, 20, 21}) +
         fields({100, 1, 0, 0, 100}) + fields({0, 0, 0, 0, 2, 2}));
  s.text("*CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL\n" + fields({2, 1, 2, 1}) + fields({20, 20, 20, 0, 21}) +
         fields({100, 1}) + fields({0, 0, 0.02, 0.02}));
  s.card("CONTROL_TERMINATION", {3.0});
  Experiment experiment(s.deck());
  Drift drift;
  double moved = 0.0, step = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    drift.add(now);
    moved = std::max(moved, norm(place(now, 2) - Vec3d{2, 0.3, 0}));
    step = std::max(step, now.state.dt);
  });
  EXPECT_NEAR(drift.linear, 0.0, 1e-12);
  EXPECT_NEAR(drift.angular, 0.0, 1e-11);
  EXPECT_GT(moved, 0.05);
  EXPECT_LT(step, 0.1);
  EXPECT_NEAR(drift.ratio, 0.0, 0.05);
}

TEST(JointStiffness, FaultsAreNamed) {
  const auto refusal = [](const std::string& cards) {
    Specimen s;
    body(s, 1, {.fixed = true}, {s.node({1, 0, 0})});
    body(s, 2, {}, {s.node({0, 1, 0})});
    s.card("CONTROL_TERMINATION", {0.01})
        .text("*DEFINE_COORDINATE_SYSTEM\n" + fields({1, 0, 0, 0, 1, 0, 0}) + fields({0, 1, 0}));
    s.text(cards);
    try {
      Experiment experiment(s.deck());
    } catch (const std::runtime_error& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  const std::string name = "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n", rest = fields({}) + fields({}) + fields({});
  const auto expect = [&](const std::string& cards, const char* words) {
    EXPECT_NE(refusal(cards).find(words), std::string::npos) << refusal(cards);
  };
  expect(name + fields({1, 1, 2, 1}) + rest, "accepted");
  expect(name + fields({1, 1, 3, 1}) + rest, "part 3 is not a rigid body");
  expect(name + fields({1, 1, 1, 1}) + rest, "both are the same");
  expect(name + fields({1, 1, 2, 9}) + rest, "coordinate system 9 is not defined");
  expect(name + fields({1, 1, 2, 1}) + fields({30}) + fields({}) + fields({}), "curve 30 is not defined");
  expect(name + fields({1, 1, 2, 1}) + fields({}) + fields({100, -5}) + fields({}), "fmph");
  expect("*CONSTRAINED_JOINT_STIFFNESS_CYLINDRICAL\n" + fields({1, 1, 2, 1}),
         "GENERALIZED and TRANSLATIONAL are built");
}

}  // namespace
}  // namespace nugget::verify
