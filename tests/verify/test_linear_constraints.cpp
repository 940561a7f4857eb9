// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_LINEAR_GLOBAL, _LOCAL: levers, gears and cells that repeat, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/index.hpp"
#include "linear.hpp"
#include "nvh/statics/statics.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double pi = std::numbers::pi;

struct Freedom {
  int node, dof;
  double factor;
};
std::string equation(int id, const std::vector<Freedom>& terms) {
  std::string text = "*CONSTRAINED_LINEAR_GLOBAL\n" + fields({double(id)});
  for (const Freedom& t : terms) text += fields({double(t.node), double(t.dof), t.factor});
  return text;
}

/// Masses m1 and m2 on a line, the second on a bar of stiffness k, u1 = 2 u2: a lever.
struct Lever {
  Specimen s;
  int first, second;
  static constexpr double m1 = 3e-3, m2 = 5e-3, k = 40.0, length = 50.0;

  Lever() {
    s.card("MAT_ELASTIC", {1, 1e-15, 2000.0, 0.0});
    s.text("*SECTION_BEAM\n" + fields({1, 3}) + fields({k * length / 2000.0})).part(1, 1, 1);
    first = s.mass_point({0, 10, 0}, m1);
    second = s.mass_point({length, 0, 0}, m2);
    const int ground = s.node({0, 0, 0});
    s.text("*ELEMENT_BEAM\n" + element_line(1, 1, {ground, second}));
    s.card("BOUNDARY_SPC_NODE", {double(ground), 0, 1, 1, 1});
    for (const int n : {first, second}) s.card("BOUNDARY_SPC_NODE", {double(n), 0, 0, 1, 1});
    s.text(equation(1, {{first, 1, 1.0}, {second, 1, -2.0}}));
  }
  static double frequency() { return std::sqrt(k / (4 * m1 + m2)) / (2 * pi); }
};

// Moved by the force on one side of the lever, which carries both masses: 4 m1 + m2 seen from the second.
// Sabotage: the force on one node only; masses out of the weights.
TEST(LinearConstraints, LeverSwings) {
  Lever lever;
  const double force = 0.08, static_u2 = 2 * force / Lever::k, period = 1.0 / Lever::frequency();
  lever.s.text(constant_curve(1)).text("*LOAD_NODE_POINT\n" + fields({double(lever.first), 1, 1, force}));
  lever.s.text(constant_curve(8, period / 2000)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 8});
  lever.s.card("CONTROL_TERMINATION", {2.25 * period});
  Experiment experiment(lever.s.deck());
  double most = 0.0, apart = 0.0, drift = 0.0;
  Passage back(1.0);
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const double u1 = experiment.displacement(now, lever.first).x, u2 = experiment.displacement(now, lever.second).x;
    most = std::max(most, u2);
    apart = std::max(apart, std::abs(u1 - 2 * u2));
    // u2 = us (1 - cos wt): passes us for the third time at 5/4 of a period.
    if (now.state.time > period) back.add(now.state.time, u2 / static_u2);
    // Once in a period all energies are 0 but for round-off, and so is what they are measured by.
    drift = std::max(drift, std::abs(now.energy.kinetic + now.energy.internal - now.energy.external));
  });
  expect_reference("linear equations", "lever under a sudden force: largest displacement [mm]", most, 2 * static_u2,
                   1e-4);
  ASSERT_TRUE(back.seen());
  expect_reference("linear equations", "lever under a sudden force: 5/4 of its period [s]", back.time(), 1.25 * period,
                   1e-3);
  EXPECT_LT(apart, 1e-12 * Lever::length);
  EXPECT_LT(drift, 1e-3 * force * 2 * most);
}

TEST(LinearConstraints, LeverInModesAndStatics) {
  Lever modal;
  modal.s.card("CONTROL_IMPLICIT_GENERAL", {1, 1})
      .card("CONTROL_IMPLICIT_EIGENVALUE", {1})
      .card("CONTROL_TERMINATION", {1.0});
  const LinearExperiment modes(modal.s.deck());
  expect_reference("linear equations", "lever: natural frequency [Hz]", modes.modes(1).frequency(0), Lever::frequency(),
                   1e-6);

  Lever still;
  const double force = 8.0;
  still.s.text(constant_curve(1)).text("*LOAD_NODE_POINT\n" + fields({double(still.first), 1, 1, force}));
  still.s.card("CONTROL_IMPLICIT_GENERAL", {1, 1.0})
      .card("CONTROL_IMPLICIT_SOLUTION", {1})
      .card("CONTROL_TERMINATION", {1.0});
  const LinearExperiment experiment(still.s.deck());
  Findings findings;
  const nvh::Statics statics = nvh::solve_statics(experiment.matrices(), findings);
  const auto moved = [&](int n) {
    return statics.motion[experiment.system().node_of[at(experiment.system().model.node_index(n))]][0];
  };
  expect_reference("linear equations", "lever: static displacement [mm]", moved(still.second), 2 * force / Lever::k,
                   1e-9);
  EXPECT_NEAR(moved(still.first), 2 * moved(still.second), 1e-12);
}

/// A bar of bricks that repeats: u(right) = u(left) + u(reference) in all three directions for every pair of nodes.
struct Cell {
  Specimen s;
  int reference = 0;
  static constexpr double E = 210000.0, nu = 0.3, rho = 7.85e-9, length = 20.0, side = 10.0;

  explicit Cell(bool mass) {
    s.card("MAT_ELASTIC", {1, rho, E, nu});
    s.card("SECTION_SOLID", {1, 2}).part(1, 1, 1);
    const Grid g = s.bricks(1, {0, 0, 0}, {length, side, side}, {2, 2, 2});
    reference = mass ? s.mass_point({0, 0, 100}, 1e-3) : s.node({0, 0, 100});
    int id = 0;
    for (int k = 0; k <= 2; ++k)
      for (int j = 0; j <= 2; ++j)
        for (int dof = 1; dof <= 3; ++dof)
          s.text(equation(++id, {{g(2, j, k), dof, 1.0}, {g(0, j, k), dof, -1.0}, {reference, dof, -1.0}}));
    // Rigid motions: one node of the middle plane, and turns about the axes.
    s.card("BOUNDARY_SPC_NODE", {double(g(1, 0, 0)), 0, 1, 1, 1});
    s.card("BOUNDARY_SPC_NODE", {double(g(1, 2, 0)), 0, 0, 0, 1});
    s.card("BOUNDARY_SPC_NODE", {double(reference), 0, 0, 1, 1});
  }
};

// Pulled at the reference node: that stretches the cell by F L / (E A), free to contract.
TEST(LinearConstraints, CellThatRepeatsInStatics) {
  Cell cell(true);
  // v and w of the reference are held, so they are taken out of the equations there.
  std::string deck = cell.s.deck();
  for (const int dof : {2, 3}) {
    const std::string line = fields({double(cell.reference), double(dof), -1.0});
    for (std::size_t at_ = deck.find(line); at_ != std::string::npos; at_ = deck.find(line))
      deck.erase(at_, line.size());
  }
  const double force = 5000.0;
  const std::string more = constant_curve(1) + "*LOAD_NODE_POINT\n" + fields({double(cell.reference), 1, 1, force}) +
                           "*CONTROL_IMPLICIT_GENERAL\n" + fields({1, 1.0}) + "*CONTROL_IMPLICIT_SOLUTION\n" +
                           fields({1}) + "*CONTROL_TERMINATION\n" + fields({1.0});
  deck.insert(deck.find('\n') + 1, more);
  const LinearExperiment experiment(deck);
  Findings findings;
  const nvh::Statics statics = nvh::solve_statics(experiment.matrices(), findings);
  const auto k = at(experiment.system().node_of[at(experiment.system().model.node_index(cell.reference))]);
  expect_reference("linear equations", "cell that repeats: stretch by a force at its reference node [mm]",
                   statics.motion[k][0], force * Cell::length / (Cell::E * Cell::side * Cell::side), 1e-6);
}

// The reference node, without mass, is driven: the strain energy and the work of the support are E/2 e^2 V.
// Sabotage: the force on the driven node left out, whose work is then missing.
TEST(LinearConstraints, CellThatRepeatsIsDriven) {
  Cell cell(false);
  const double stretch = 0.02, strain = std::log1p(stretch / Cell::length), end = 2e-3;
  cell.s.text(smooth_ramp(1, 0.9 * end, stretch));
  cell.s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {double(cell.reference), 1, 2, 1, 1.0});
  cell.s.card("CONTROL_TERMINATION", {end}).card("CONTROL_ENERGY", {2, 2, 2, 2});
  Experiment experiment(cell.s.deck());
  double internal = 0.0, external = 0.0, drift = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    internal = now.energy.internal;
    external = now.energy.external;
    if (now.state.time > 0.2 * end) drift = std::max(drift, std::abs(now.energy.ratio() - 1.0));
  });
  const double expected = 0.5 * Cell::E * strain * strain * Cell::length * Cell::side * Cell::side;
  expect_reference("linear equations", "cell that repeats, driven: internal energy [mJ]", internal, expected, 5e-3);
  expect_reference("linear equations", "cell that repeats, driven: work of the support [mJ]", external, expected, 5e-3);
  EXPECT_LT(drift, 1e-3);
}

// Rotations: two shafts (beams) whose free ends are geared 1 : -3; a torque on the first turns it by T L / (GJ (1 +
// 9)). And in local axes: a node of a third beam that slides along a line at 30 degrees only.
TEST(LinearConstraints, GearsAndSlides) {
  const double E = 210000.0, nu = 0.3, G = E / (2 * (1 + nu)), d = 8.0, length = 100.0, torque = 500.0, load = 30.0;
  const double I = pi * d * d * d * d / 64, J = 2 * I, A = pi * d * d / 4;
  Specimen s;
  s.card("MAT_ELASTIC", {1, 7.85e-9, E, nu});
  s.text("*SECTION_BEAM\n" + fields({1, 2}) + fields({A, I, I, J, 0})).part(1, 1, 1);
  const int third = s.node({0, 0, 1e3});
  s.card("BOUNDARY_SPC_NODE", {double(third), 0, 1, 1, 1, 1, 1, 1});
  std::vector<int> free;
  std::string text = "*ELEMENT_BEAM\n";
  for (int i = 0; i < 3; ++i) {
    const int root = s.node({0, 50.0 * i, 0}), tip = s.node({length, 50.0 * i, 0});
    s.card("BOUNDARY_SPC_NODE", {double(root), 0, 1, 1, 1, 1, 1, 1});
    text += element_line(i + 1, 1, {root, tip, third});
    free.push_back(tip);
  }
  s.text(text);
  s.text(equation(1, {{free[0], 4, 3.0}, {free[1], 4, 1.0}}));
  // Axis 2 of system 5 stands across the line at 30 degrees in the plane of x and z.
  const double c = std::cos(pi / 6), n = std::sin(pi / 6);
  s.text("*DEFINE_COORDINATE_VECTOR\n" + fields({5, c, 0, n, -n, 0, c}));
  s.text("*CONSTRAINED_LINEAR_LOCAL\n" + fields({2}) + fields({double(free[2]), 2, 5, 1.0}));
  s.text(constant_curve(1)).text("*LOAD_NODE_POINT\n" + fields({double(free[0]), 5, 1, torque}));
  s.text("*LOAD_NODE_POINT\n" + fields({double(free[2]), 3, 1, load}));
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1.0})
      .card("CONTROL_IMPLICIT_SOLUTION", {1})
      .card("CONTROL_TERMINATION", {1.0});
  const LinearExperiment experiment(s.deck());
  Findings findings;
  const nvh::Statics statics = nvh::solve_statics(experiment.matrices(), findings);
  const auto u = [&](int k) {
    return statics.motion[at(experiment.system().node_of[at(experiment.system().model.node_index(free[at(k)]))])];
  };
  expect_reference("linear equations", "geared shafts: turn of the first [rad]", u(0)[3],
                   torque * length / (10 * G * J), 1e-8);
  EXPECT_NEAR(u(1)[3], -3 * u(0)[3], 1e-12);
  // Along the line w it stretches by w c and bends by w n: load n = w (EA/L c^2 + 3EI/L^3 n^2).
  const double w = load * n / (E * A / length * c * c + 3 * E * I / (length * length * length) * n * n);
  expect_reference("linear equations", "end of a beam on a slanted line, along x [mm]", u(2)[0], w * c, 1e-8);
  expect_reference("linear equations", "end of a beam on a slanted line, along z [mm]", u(2)[2], w * n, 1e-8);
}

// Velocities that the equations do not allow: the nearest ones, by energy. Two masses, v1 = 1, v2 = 0, u1 = 2 u2:
// momentum along (2, 1) stays, 2 m1 v1 = (4 m1 + m2) v2.
TEST(LinearConstraints, StartsWithVelocitiesThatTheEquationAllows) {
  Specimen s;
  const double m1 = 2e-3, m2 = 1e-3;
  const int first = s.mass_point({0, 0, 0}, m1), second = s.mass_point({10, 0, 0}, m2);
  s.text(equation(1, {{first, 1, 1.0}, {second, 1, -2.0}}));
  s.card("INITIAL_VELOCITY_NODE", {double(first), 1000.0, 30.0, 0.0});
  s.text(constant_curve(8, 1e-5)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 8}).card("CONTROL_TERMINATION", {1e-3});
  Experiment experiment(s.deck());
  double u1 = 0.0, u2 = 0.0, across = 0.0, drift = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    u1 = experiment.displacement(now, first).x, u2 = experiment.displacement(now, second).x;
    across = experiment.displacement(now, first).y;
    drift = std::max(drift, std::abs(now.energy.ratio() - 1.0));
  });
  const double v2 = 2 * m1 * 1000.0 / (4 * m1 + m2);
  expect_reference("linear equations", "start against the equation: way of the second mass [mm]", u2, v2 * 1e-3, 1e-9);
  EXPECT_NEAR(u1, 2 * u2, 1e-12);
  EXPECT_NEAR(across, 0.03, 1e-9);
  EXPECT_LT(drift, 1e-9);
}

}  // namespace
}  // namespace nugget::verify
