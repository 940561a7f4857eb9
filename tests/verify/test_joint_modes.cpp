// SPDX-License-Identifier: Apache-2.0
// Joints between rigid bodies in natural modes, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double length = 400.0, mass = 2e-3, across = mass * length * length / 12.0, spring = 30.0;

/// A uniform rod of 400 along x from a place, or a support, as a rigid part with nodes of its own.
void body(Specimen& s, int id, double from, bool fixed, const std::vector<int>& nodes) {
  const double held = fixed ? 7 : 0;
  s.card("MAT_RIGID", {double(id), 1e-9, 210000.0, 0.3}).text(fields({fixed ? 1.0 : 0.0, held, held}) + fields({}));
  s.text(fmt::format("*PART_INERTIA\nbody {}\n", id) + fields({double(id), 0, double(id)}) +
         fields({from + (fixed ? 0.0 : 0.5 * length), 0, 0, mass}) + fields({0.01 * across, 0, 0, across, 0, across}) +
         fields({0, 0, 0}));
  s.node_set(id, nodes).card("CONSTRAINED_EXTRA_NODES_SET", {double(id), double(id)});
}

struct Pairs {
  std::vector<int> a, b;
  Pairs(Specimen& s, std::initializer_list<Vec3d> places) {
    for (const Vec3d& x : places) {
      a.push_back(s.node(x));
      b.push_back(s.node(x));
    }
  }
};

void joint(Specimen& s, const std::string& kind, const Pairs& p) {
  std::vector<double> n(6, 0.0);
  for (std::size_t i = 0; i < p.a.size(); ++i) n[2 * i] = p.a[i], n[2 * i + 1] = p.b[i];
  s.card("CONSTRAINED_JOINT_" + kind, {n[0], n[1], n[2], n[3], n[4], n[5], 1.0, 1.0});
}

/// A spring from a node to the ground along axis 1 (x), 2 (y) or 3 (z).
void ground_spring(Specimen& s, int id, int node, int axis) {
  s.text(fmt::format("*ELEMENT_DISCRETE\n{:8}{:8}{:8}{:8}{:8}{:16g}\n", id, 90, node, 0, axis, 1.0));
}

Specimen begin() {
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
  s.text("*MAT_SPRING_ELASTIC\n" + fields({90, spring}) + "*SECTION_DISCRETE\n" + fields({90, 0}) + fields({0, 0}));
  s.part(90, 90, 90);
  for (int axis = 1; axis <= 3; ++axis)
    s.text("*DEFINE_SD_ORIENTATION\n" +
           fields({double(axis), 0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0, axis == 3 ? 1.0 : 0.0}));
  return s;
}

// Two rods on hinges, a spring at the second hinge and one at the end. Sabotage: a hinge that holds its own axis, or
// the arms of its point left out.
TEST(JointModes, TwoRodsOnHinges) {
  Specimen s = begin();
  const Pairs first(s, {{0, 0, 0}, {0, 100, 0}}), second(s, {{length, 0, 0}, {length, 100, 0}});
  const int end = s.node({2.0 * length, 0, 0});
  body(s, 1, 0.0, true, first.a);
  body(s, 2, 0.0, false, {first.b[0], first.b[1], second.a[0], second.a[1]});
  body(s, 3, length, false, {second.b[0], second.b[1], end});
  joint(s, "REVOLUTE", first);
  joint(s, "REVOLUTE", second);
  ground_spring(s, 1, second.a[0], 3);
  ground_spring(s, 2, end, 3);
  const LinearExperiment experiment(s.deck());
  const nvh::Modes modes = experiment.modes(2);
  // In the angles of the two rods, both over L^2.
  const double m11 = mass / 3.0 + mass, m12 = mass / 2.0, m22 = mass / 3.0, k11 = 2.0 * spring, k12 = spring,
               k22 = spring;
  const double a = m11 * m22 - m12 * m12, b = m11 * k22 + m22 * k11 - 2.0 * m12 * k12, c = k11 * k22 - k12 * k12;
  for (const int sign : {-1, 1})
    expect_reference("joints", fmt::format("two rods on hinges and springs: mode {} [rad/s]", sign < 0 ? 1 : 2),
                     std::sqrt(modes.eigenvalue[sign < 0 ? 0 : 1]),
                     std::sqrt((b + sign * std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a)), 1e-4);
}

// A ball joint leaves all rotations: the rod swings on two springs alike (its spin, which nothing resists, is held).
// Sabotage: a rotation held.
TEST(JointModes, RodOnABall) {
  Specimen s = begin();
  const Pairs ball(s, {{0, 0, 0}});
  const int end = s.node({length, 0, 0});
  body(s, 1, 0.0, true, ball.a);
  body(s, 2, 0.0, false, {ball.b[0], end});
  joint(s, "SPHERICAL", ball);
  ground_spring(s, 1, end, 2);
  ground_spring(s, 2, end, 3);
  const LinearExperiment experiment(s.deck());
  const nvh::Modes modes = experiment.modes(2);
  for (std::size_t i = 0; i < 2; ++i)
    expect_reference("joints", fmt::format("rod on a ball and two springs: mode {} [rad/s]", i + 1),
                     std::sqrt(modes.eigenvalue[i]), std::sqrt(3.0 * spring / mass), 1e-4);
}

// Sliding along x; a cylindrical joint lets the rod turn on a second spring, off its line. Sabotage: the axis held.
TEST(JointModes, SlidingRod) {
  for (const std::string kind : {"CYLINDRICAL", "TRANSLATIONAL"}) {
    Specimen s = begin();
    const bool turns = kind == "CYLINDRICAL";
    const Pairs guide(s, turns ? std::initializer_list<Vec3d>{{0, 0, 0}, {length, 0, 0}}
                               : std::initializer_list<Vec3d>{{0, 0, 0}, {length, 0, 0}, {0, 100, 0}});
    const int middle = s.node({0.5 * length, 0, 0}), aside = s.node({0.5 * length, 10.0, 0});
    std::vector<int> own = guide.b;
    own.insert(own.end(), {middle, aside});
    body(s, 1, 0.0, true, guide.a);
    body(s, 2, 0.0, false, own);
    joint(s, kind, guide);
    ground_spring(s, 1, middle, 1);
    ground_spring(s, 2, aside, 3);
    const LinearExperiment experiment(s.deck());
    const nvh::Modes modes = experiment.modes(2);
    const double sliding = std::sqrt(spring / mass), turning = std::sqrt(spring * 100.0 / (0.01 * across));
    expect_reference("joints", fmt::format("sliding rod, {} [rad/s]", turns ? "cylindrical" : "translational"),
                     std::sqrt(modes.eigenvalue[turns ? 1 : 0]), sliding, 1e-4);
    if (turns)
      expect_reference("joints", "sliding rod, cylindrical: turning [rad/s]", std::sqrt(modes.eigenvalue[0]), turning,
                       1e-4);
    else
      EXPECT_GT(modes.eigenvalue[1], 1e3 * modes.eigenvalue[0]);
  }
}

}  // namespace
}  // namespace nugget::verify
