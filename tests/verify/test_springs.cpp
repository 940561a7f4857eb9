// SPDX-License-Identifier: Apache-2.0
// Springs and dampers (*ELEMENT_DISCRETE): oscillators, laws driven through cycles, stops and clearances, against
// closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "specimen.hpp"
#include "system/spring_group.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi;

/// Element line: part, nodes, orientation, factor, offset.
std::string spring(int id, int part, int n1, int n2, int vid = 0, double scale = 1.0, double offset = 0.0) {
  return fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}{:8}{:16g}{:8}{:16g}\n", id, part, n1, n2, vid, scale, 0,
                     offset);
}

/// *SECTION_DISCRETE 1 and part 1 of material 1.
void section(Specimen& s, int id, bool torsional, std::initializer_list<double> kd_v0_cl_fd = {},
             std::initializer_list<double> limits = {}) {
  std::vector<double> first{double(id), torsional ? 1.0 : 0.0};
  first.insert(first.end(), kd_v0_cl_fd.begin(), kd_v0_cl_fd.end());
  s.text("*SECTION_DISCRETE\n");
  std::string line;
  for (const double v : first) line += fields({v}).substr(0, 10);
  s.text(line + "\n" + fields(limits));
}

Specimen& timing(Specimen& s, double end, double step) {
  if (step > 0.0) s.text(constant_curve(90, step)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90});
  return s.card("CONTROL_TERMINATION", {end});
}

const system::SpringGroup& springs(const impact::Snapshot& now, std::size_t group = 0) {
  return dynamic_cast<const system::SpringGroup&>(*now.system.groups.at(group));
}

// Two free masses, or disks, on a spring at the step that it asks for itself. Sabotage: a mass halved in the step; the
// signs of the two ends exchanged.
TEST(Springs, TwoMassesAndTheirTimeStep) {
  for (const bool torsional : {false, true}) {
    Specimen s;
    s.card("MAT_SPRING_ELASTIC", {1, 1000.0});
    section(s, 1, torsional);
    s.part(1, 1, 1);
    const int a = s.mass_point({0, 0, 0}, 2.0, 2.0), b = s.mass_point({0, 3, 4}, 3.0, 3.0);
    s.text(spring(1, 1, a, b));
    const double v = torsional ? 0.0 : 0.1, w = torsional ? 0.1 : 0.0;
    s.card("INITIAL_VELOCITY_NODE", {double(b), 0, 0.6 * v, 0.8 * v, 0, 0.6 * w, 0.8 * w});
    const double omega = std::sqrt(1000.0 / 1.2), step = 2.0 / omega;
    timing(s, 20.0 * 2.0 * pi / omega, 0.02 * step);
    Experiment experiment(s.deck());
    Period period;
    double drift = 0.0, own_step = 0.0;
    run_to_end(experiment, [&](const impact::Snapshot& now) {
      period.add(now.state.time, springs(now).force(0));
      own_step = springs(now).stable_step(0);
      drift = std::max(drift, std::abs(now.energy.ratio() - 1.0));
    });
    const char* what = torsional ? "two disks on a torsional spring" : "two masses on a spring";
    expect_reference("springs", fmt::format("{}: period [s]", what), period.mean(), 2.0 * pi / omega, 1e-4);
    expect_reference("springs", fmt::format("{}: stable step [s]", what), own_step, step, 1e-9);
    EXPECT_NEAR(drift, 0.0, 1e-3);
  }
}

// Three masses in a row, each end at its own limit: the step of the middle must hold the chain. Sabotage: the step of
// each spring alone.
TEST(Springs, AChainRunsAtItsOwnStep) {
  Specimen s;
  s.card("MAT_SPRING_ELASTIC", {1, 1000.0});
  section(s, 1, false);
  s.part(1, 1, 1);
  std::vector<int> n;
  for (int i = 0; i < 12; ++i) n.push_back(s.mass_point({double(i), 0, 0}, 1.0));
  for (int i = 0; i < 11; ++i) s.text(spring(i + 1, 1, n[std::size_t(i)], n[std::size_t(i) + 1]));
  s.card("INITIAL_VELOCITY_NODE", {double(n[0]), 0.1});
  timing(s, 20.0, 0.0);
  Experiment experiment(s.deck());
  double drift = 0.0;
  run_to_end(experiment,
             [&](const impact::Snapshot& now) { drift = std::max(drift, std::abs(now.energy.ratio() - 1.0)); });
  EXPECT_NEAR(experiment.simulation().first_step(), 0.9 / std::sqrt(1000.0), 1e-9);
  EXPECT_LT(drift, 0.05);
}

// A spring and a damper side by side to the ground. Sabotage: the damper's force halved.
TEST(Springs, DampedOscillator) {
  const double m = 2.0, k = 800.0, c = 4.0;
  Specimen s;
  s.card("MAT_S01", {1, k}).card("MAT_DAMPER_VISCOUS", {2, c});
  section(s, 1, false);
  s.part(1, 1, 1).part(2, 1, 2).card("DEFINE_SD_ORIENTATION", {1, 0, 0, 2, 0});
  const int a = s.mass_point({1, 2, 3}, m);
  s.text(spring(1, 1, a, 0, 1) + spring(2, 2, a, 0, 1));
  s.card("INITIAL_VELOCITY_NODE", {double(a), 5.0, 1.0, 5.0});
  const double a0 = 0.5 * c / m, omega = std::sqrt(k / m - a0 * a0);
  timing(s, 5.25 * 2.0 * pi / omega, 1e-4);
  Experiment experiment(s.deck());
  double last = 0.0, ratio = 1.0;
  Vec3d u;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    u = experiment.displacement(now, a);
    last = now.state.time;
    ratio = std::max(ratio, now.energy.ratio());
  });
  expect_reference("springs", "damped oscillator: displacement after 5 1/4 periods", u.y,
                   std::exp(-a0 * last) * std::sin(omega * last) / omega, 1e-3);
  EXPECT_NEAR(u.x, 5.0 * last, 1e-9);  // across its line nothing holds
  EXPECT_NEAR(ratio, 1.0, 1e-6);
}

// Ball on a spring: a mass falls by a height onto a spring, which a clearance stands for. Sabotage: a clearance that
// pulls as well.
TEST(Springs, BallOnSpring) {
  const double m = 0.5, k = 1973.92, h = 1.0, g = 386.0;
  Specimen s;
  s.card("MAT_SPRING_ELASTIC", {1, k});
  section(s, 1, false, {0, 0, h});
  s.part(1, 1, 1).card("DEFINE_SD_ORIENTATION", {1, 0, 0, 0, -1});
  const int ball = s.mass_point({0, 0, h}, m);
  s.text(spring(1, 1, ball, 0, 1));
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, g});
  timing(s, 0.16, 2e-5);
  Experiment experiment(s.deck());
  Passage touch(-h);
  double speed = 0.0, energy = 0.0, deepest = 0.0, drift = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double z = experiment.displacement(now, ball).z;
    if (!touch.seen()) {
      speed = experiment.velocity(now, ball).z;
      energy = now.energy.kinetic;
    }
    touch.add(now.state.time, z);
    deepest = std::min(deepest, z);
    drift = std::max(drift, std::abs(now.energy.total() - now.energy.external));
  });
  expect_reference("ball on a spring", "ball on spring: impact [s]", touch.time(), 0.071982, 1e-3);
  expect_reference("ball on a spring", "velocity at impact [in/s]", speed, -27.785, 1e-3);
  expect_reference("ball on a spring", "kinetic energy at impact [lbf in]", energy, 193.0, 2e-3);
  const double weight = m * g;
  expect_reference("ball on a spring", "deepest point [in]", deepest,
                   -h - weight / k * (1.0 + std::sqrt(1.0 + 2.0 * k * h / weight)), 1e-3);
  EXPECT_NEAR(drift, 0.0, 1e-3 * 193.0);
}

/// Force of a spring of material 1 whose second node is driven through `path` (time, elongation), at the times asked.
std::vector<double> driven(const std::string& material, std::initializer_list<std::pair<double, double>> path,
                           const std::vector<double>& times, std::initializer_list<double> kd_v0_cl_fd = {}) {
  Specimen s;
  s.text(material);
  section(s, 1, false, kd_v0_cl_fd);
  s.part(1, 1, 1);
  const int a = s.node({0, 0, 0}), b = s.node({10, 0, 0});  // no mass: both are held
  s.text(spring(1, 1, a, b)).card("BOUNDARY_SPC_NODE", {double(a), 0, 1, 1, 1});
  s.card("BOUNDARY_SPC_NODE", {double(b), 0, 0, 1, 1});
  s.text(curve(9, path)).card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(b), 1, 2, 9, 1});
  timing(s, path.end()[-1].first, 1e-4);
  Experiment experiment(s.deck());
  std::vector<double> forces;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (forces.size() < times.size() && now.state.time >= times[forces.size()] - 1e-9)
      forces.push_back(springs(now).force(0));
  });
  forces.resize(times.size());
  return forces;
}

void expect_forces(const std::string& law, const std::vector<double>& forces, const std::vector<double>& expected) {
  double scale = 0.0;
  for (const double f : expected) scale = std::max(scale, std::abs(f));
  for (std::size_t i = 0; i < expected.size(); ++i)
    expect_reference("springs", fmt::format("{}: force at station {}", law, i + 1), forces[i], expected[i], 1e-3,
                     scale);
}

TEST(Springs, LawsDrivenThroughACycle) {
  // 0 to 1, to -1, to 0 at unit speed.
  const auto path = {std::pair{0.0, 0.0}, {1.0, 1.0}, {3.0, -1.0}, {4.0, 0.0}};
  const std::vector<double> times{0.5, 1.0, 2.0, 3.0, 4.0};
  const auto curve_text = curve(5, {{0.0, 0.0}, {0.5, 20.0}, {1.0, 30.0}});
  expect_forces("S01", driven("*MAT_S01\n" + fields({1, 40}), path, times), {20, 40, 0, -40, 0});
  expect_forces("S02", driven("*MAT_S02\n" + fields({1, 7}), path, {0.5, 2.0, 3.5}), {7, -7, 7});
  // Yield at 10 (0.25), tangent 8: 10 + 8 0.75 = 16; back 32 along 40: 0.8; then 8 1.2.
  expect_forces("S03", driven("*MAT_SPRING_ELASTOPLASTIC\n" + fields({1, 40, 8, 10}), path, times),
                {12, 16, -16 - 8 * 0.2, -16 - 8 * 1.2, -16 - 8 * 1.2 + 40});
  expect_forces("S04", driven("*MAT_SPRING_NONLINEAR_ELASTIC\n" + fields({1, 5}) + curve_text, path, times),
                {20, 30, 0, -30, 0});
  expect_forces("S05", driven("*MAT_DAMPER_NONLINEAR_VISCOUS\n" + fields({1, 5}) + curve_text, path, {0.5, 2.0}),
                {30, -30});
  expect_forces("S08",
                driven("*MAT_SPRING_INELASTIC\n" + fields({1, 5, 100}) + curve_text, path, {1.0, 2.5, 3.0, 3.2, 3.5}),
                {0, -20, -30, -10, 0});
  // KD: at unit speed and V0 = 4 the force grows by a quarter of KD.
  expect_forces("S01 with KD", driven("*MAT_S01\n" + fields({1, 40}), path, times, {2, 4}), {30, 60, 0, -60, 0});
  expect_forces("S01 with clearance", driven("*MAT_S01\n" + fields({1, 40}), path, times, {0, 0, 0.4}),
                {0, 0, 0, -24, 0});
  expect_forces("S01 failing at -0.5", driven("*MAT_S01\n" + fields({1, 40}), path, {1.0, 2.4, 3.0}, {0, 0, 0, -0.5}),
                {40, -16, 0});
}

// A spring that turns freely, stretched by its OFFSET as its masses need. Sabotage: the line left where it was.
TEST(Springs, TurningPairKeepsItsLength) {
  const double omega = 3.0, half = 2.0, m = 1.5, k = 900.0;
  Specimen s;
  s.card("MAT_S01", {1, k});
  section(s, 1, false);
  s.part(1, 1, 1);
  const int a = s.mass_point({-half, 0, 0}, m), b = s.mass_point({half, 0, 0}, m);
  s.text(spring(1, 1, a, b, 0, 1.0, m * omega * omega * half / k));
  for (const int n : {a, b}) s.card("INITIAL_VELOCITY_NODE", {double(n), 0, (n == b ? 1 : -1) * omega * half});
  timing(s, 2.0 * pi / omega, 1e-4);
  Experiment experiment(s.deck());
  double change = 0.0, drift = 0.0;
  Vec3d place;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    change = std::max(change, std::abs(springs(now).force(0) / (m * omega * omega * half) - 1.0));
    drift = std::max(drift, std::abs(now.energy.ratio() - 1.0));
    place = experiment.position(now, b);
  });
  expect_reference("springs", "turning pair: largest change of its force, share", change, 0.0, 1e-4, 1.0);
  EXPECT_NEAR(place.x, half, 1e-3);
  EXPECT_NEAR(place.y, 0.0, 1e-2);
  EXPECT_NEAR(drift, 0.0, 1e-6);
}

// A line that follows two nodes (IOP 2), and one in the plane normal to a vector (IOP 1).
TEST(Springs, OrientationsThatMoveAndThatProject) {
  Specimen s;
  s.card("MAT_S01", {1, 100.0});
  section(s, 1, false);
  s.part(1, 1, 1);
  const int a = s.node({0, 0, 0}), b = s.node({3, 4, 5});
  const int p = s.node({0, 0, 0}), q = s.node({1, 0, 0});
  for (const int n : {a, p}) s.card("BOUNDARY_SPC_NODE", {double(n), 0, 1, 1, 1});
  // q goes from (1,0,0) to (1,1,0): the line turns by 45 degrees. b moves by (1, 0, 2).
  s.text(curve(9, {{0, 0}, {1, 1}, {2, 1}}));
  for (const auto& [n, dof, scale] : {std::tuple{q, 2, 1.0}, {b, 1, 1.0}, {b, 3, 2.0}})
    s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(n), double(dof), 2, 9, scale});
  s.card("BOUNDARY_SPC_NODE", {double(q), 0, 1, 0, 1}).card("BOUNDARY_SPC_NODE", {double(b), 0, 0, 1, 0});
  s.text("*DEFINE_SD_ORIENTATION\n" + fields({1, 2, 0, 0, 0, double(p), double(q)}) + fields({2, 1, 0, 0, 1}));
  s.text(spring(1, 1, a, b, 1) + spring(2, 1, a, b, 2));
  timing(s, 1.5, 1e-3);
  Experiment experiment(s.deck());
  std::array<double, 2> force{};
  Vec3d line;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    force = {springs(now).force(0), springs(now).force(1)};
    line = springs(now).line(1);
  });
  expect_reference("springs", "IOP 2: force on the turned line", force[0], 100.0 * (8.0 / std::sqrt(2.0) - 3.0), 1e-6);
  expect_reference("springs", "IOP 1: force in the plane", force[1], 100.0 * (std::sqrt(32.0) - 5.0), 1e-6);
  EXPECT_NEAR(line.x, std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(line.z, 0.0, 1e-12);
}

// A stop in compression: after it both masses move together, then apart by the spring. Sabotage: the impulse left out.
TEST(Springs, StopIsAPlasticImpact) {
  Specimen s;
  s.card("MAT_S01", {1, 1e-6});
  section(s, 1, false, {}, {0.25, 0});
  s.part(1, 1, 1);
  const int a = s.mass_point({0, 0, 0}, 1.0), b = s.mass_point({1, 0, 0}, 3.0);
  s.text(spring(1, 1, a, b)).card("INITIAL_VELOCITY_NODE", {double(b), -2.0});
  timing(s, 0.5, 1e-4);
  Experiment experiment(s.deck());
  double ratio = 0.0, gap = 0.0;
  Vec3d va, vb;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    va = experiment.velocity(now, a), vb = experiment.velocity(now, b);
    gap = norm(experiment.position(now, b) - experiment.position(now, a));
    ratio = now.energy.ratio();
  });
  expect_reference("springs", "stop: common velocity", va.x, -1.5, 1e-6);
  EXPECT_NEAR(vb.x, -1.5, 1e-6);
  EXPECT_NEAR(gap, 0.75, 1e-3);
  EXPECT_NEAR(ratio, 1.0, 1e-3);
}

// Springs in K: a chain between walls, and a disk on a torsional spring. Sabotage: the cross terms of K left out.
TEST(Springs, NaturalFrequencies) {
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {3});
  s.card("MAT_S01", {1, 1000.0})
      .card("MAT_SPRING_NONLINEAR_ELASTIC", {2, 7})
      .text(curve(7, {{0, 0}, {1, 80}, {2, 90}}));
  section(s, 1, false);
  section(s, 2, true);
  s.part(1, 1, 1).part(2, 2, 2).card("DEFINE_SD_ORIENTATION", {1, 0, 0, 0, 1});
  const int wall = s.node({0, 0, 0}), a = s.mass_point({1, 0, 0}, 2.0, 0.1), b = s.mass_point({2, 0, 0}, 2.0, 0.1),
            far = s.node({3, 0, 0});
  s.text(spring(1, 1, wall, a) + spring(2, 1, a, b) + spring(3, 1, b, far) + spring(4, 2, a, 0, 1));
  for (const int n : {wall, far}) s.card("BOUNDARY_SPC_NODE", {double(n), 0, 1, 1, 1, 1, 1, 1});
  s.card("BOUNDARY_SPC_NODE", {double(a), 0, 0, 1, 1, 1, 1, 0});
  s.card("BOUNDARY_SPC_NODE", {double(b), 0, 0, 1, 1, 1, 1, 1});
  const LinearExperiment chain(s.deck());
  const nvh::Modes modes = chain.modes(3);
  ASSERT_EQ(modes.eigenvalue.size(), 3u);
  expect_reference("springs", "chain of two masses, first mode [rad/s]", std::sqrt(modes.eigenvalue[0]),
                   std::sqrt(500.0), 1e-9);
  expect_reference("springs", "disk on a torsional spring [rad/s]", std::sqrt(modes.eigenvalue[1]),
                   std::sqrt(80.0 / 0.1), 1e-6);
  expect_reference("springs", "chain of two masses, second mode [rad/s]", std::sqrt(modes.eigenvalue[2]),
                   std::sqrt(1500.0), 1e-9);
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

TEST(Springs, NodesWithoutMassAreRefused) {
  Specimen s;
  s.card("MAT_S01", {1, 1000.0});
  section(s, 1, false);
  s.part(1, 1, 1);
  const int a = s.node({0, 0, 0}), b = s.mass_point({1, 0, 0}, 1.0);
  s.text(spring(1, 1, a, b));
  timing(s, 1.0, 1e-3);
  EXPECT_NE(refusal(s).find(fmt::format("node {} of spring 1 has no mass", a)), std::string::npos) << refusal(s);
  Specimen held = s;
  held.card("BOUNDARY_SPC_NODE", {double(a), 0, 1});
  EXPECT_EQ(refusal(held), "accepted");
}

}  // namespace
}  // namespace nugget::verify
