// SPDX-License-Identifier: Apache-2.0
// Tetrahedra (ELFORM 10) and wedges (ELFORM 15), also sorted out of bricks by ESORT.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "linear.hpp"
#include "nvh/statics.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double length = 40.0, side = 10.0;

/// A bar along x, its inner nodes out of line, of cubes that are each parted into solids with repeated nodes.
class Bar {
 public:
  Bar(Specimen& s, const std::vector<std::array<int, 8>>& pieces) {
    for (int k = 0; k <= 2; ++k)
      for (int j = 0; j <= 2; ++j)
        for (int i = 0; i <= 4; ++i) {
          const bool inner = j == 1 && k == 1 && i > 0 && i < 4;
          nodes_[i][j][k] =
              s.node({10.0 * i + (inner ? 1.3 : 0.0), 5.0 * j + (inner ? 0.9 : 0.0), 5.0 * k - (inner ? 0.7 : 0.0)});
        }
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 2; ++j)
        for (int k = 0; k < 2; ++k)
          for (const auto& p : pieces) {
            const auto at = [&](int c) { return nodes_[i + (c & 1)][j + (c >> 1 & 1)][k + (c >> 2)]; };
            s.brick(1, {at(p[0]), at(p[1]), at(p[2]), at(p[3]), at(p[4]), at(p[5]), at(p[6]), at(p[7])});
          }
  }
  /// Nodes of the plane at the beginning (or end) of an axis.
  std::vector<int> plane(int axis, bool end = false) const {
    std::vector<int> chosen;
    for (int i = 0; i <= 4; ++i)
      for (int j = 0; j <= 2; ++j)
        for (int k = 0; k <= 2; ++k) {
          const int index = axis == 0 ? i : axis == 1 ? j : k, last = axis == 0 ? 4 : 2;
          if (index == (end ? last : 0)) chosen.push_back(nodes_[i][j][k]);
        }
    return chosen;
  }
  int corner() const { return nodes_[4][2][2]; }

 private:
  int nodes_[5][3][3]{};
};

// Corners of a cube by their bits: 1 along x, 2 along y, 4 along z. Six tetrahedra around the diagonal 0-7; two wedges.
const std::vector<std::array<int, 8>> tetrahedra{{0, 1, 3, 7, 7, 7, 7, 7}, {0, 3, 2, 7, 7, 7, 7, 7},
                                                 {0, 2, 6, 7, 7, 7, 7, 7}, {0, 6, 4, 7, 7, 7, 7, 7},
                                                 {0, 4, 5, 7, 7, 7, 7, 7}, {0, 5, 1, 7, 7, 7, 7, 7}};
const std::vector<std::array<int, 8>> wedges{{1, 0, 4, 5, 2, 2, 6, 6}, {3, 1, 5, 7, 2, 2, 6, 6}};

Specimen steel(int elform, const std::string& control) {
  Specimen s;
  s.text(control);
  s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.3});
  s.card("SECTION_SOLID", {1, static_cast<double>(elform)}).part(1, 1, 1);
  return s;
}

/// Energy of the bar, stretched by 0.04 between smooth grips.
double stretched(int elform, const std::vector<std::array<int, 8>>& pieces, const std::string& control = "") {
  Specimen s =
      steel(elform, control +
                        "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
                        "*CONTROL_TERMINATION\n       1.0\n*DEFINE_CURVE\n         9\n"
                        "                 0.0                 0.0\n                 1.0                0.04\n");
  const Bar bar(s, pieces);
  for (int axis = 0; axis < 3; ++axis)
    s.node_set(1 + axis, bar.plane(axis))
        .card("BOUNDARY_SPC_SET", {1.0 + axis, 0, axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0});
  s.node_set(4, bar.plane(0, true)).card("BOUNDARY_PRESCRIBED_MOTION_SET", {4, 1, 2, 9});
  const LinearExperiment experiment(s.deck());
  Findings findings;
  return nvh::solve_statics(experiment.matrices(), findings).energy;
}

// E A u^2 / (2 L) = 420 N mm: a linear field, which every mesh must give exactly.
TEST(Tetrahedra, StretchedBar) {
  constexpr double exact = 0.5 * 210000.0 * side * side * 0.04 * 0.04 / length;
  expect_reference("patch", "bar of 96 tetrahedra, ELFORM 10: strain energy", stretched(10, tetrahedra), exact, 1e-9);
  expect_reference("patch", "bar of 32 wedges, ELFORM 15: strain energy", stretched(15, wedges), exact, 1e-9);
}

// The tetrahedron has a step of its own, so ESORT shows.
TEST(Tetrahedra, EsortTakesThemOutOfBricks) {
  const auto step = [](int elform, double sort) {
    Specimen s = steel(elform, "");
    s.card("CONTROL_SOLID", {sort}).text("*CONTROL_TERMINATION\n1.0e-6\n");
    const Bar bar(s, tetrahedra);
    Experiment experiment(s.deck());
    double first = 0.0;
    experiment.run([&](const impact::Snapshot& now) { first = first == 0.0 ? now.state.dt : first; });
    return first;
  };
  EXPECT_DOUBLE_EQ(step(1, 1.0), step(10, 0.0));
  EXPECT_NE(step(1, 0.0), step(10, 0.0));
}

// Thrown, stretched and twisted at once, free of everything: energy and momentum stay.
TEST(Tetrahedra, FreeBlockKeepsItsEnergy) {
  Specimen s = steel(10, "*CONTROL_TERMINATION\n5.0e-4\n*CONTROL_BULK_VISCOSITY\n0.0,1.0e-9\n");
  const Bar bar(s, tetrahedra);
  s.node_set(1, bar.plane(0, true)).card("INITIAL_VELOCITY", {1}).text("2000.0,1000.0,-500.0\n");
  Experiment experiment(s.deck());
  double start = 0.0, worst = 0.0, moved = 0.0;
  int cycles = 0;
  experiment.run([&](const impact::Snapshot& now) {
    ++cycles;
    const double total = now.energy.kinetic + now.energy.internal;
    if (start == 0.0) start = total;
    worst = std::max(worst, std::abs(total / start - 1.0));
    moved = std::max(moved, norm(experiment.displacement(now, bar.corner())));
  });
  EXPECT_GT(cycles, 500);
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(worst, 0.01);
}

TEST(Tetrahedra, ABrickAmongThemIsRefused) {
  Specimen s = steel(10, "*CONTROL_TERMINATION\n1.0\n");
  s.bricks(1, {}, {10, 10, 10}, {1, 1, 1});
  try {
    const Experiment refused(s.deck());
    FAIL() << "accepted";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("has 8 different nodes, expected the four of a tetrahedron"));
  }
}

}  // namespace
}  // namespace nugget::verify
