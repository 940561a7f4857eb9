// SPDX-License-Identifier: Apache-2.0
// Tetrahedra (ELFORM 10, and 4 with nodal rotations) and wedges (ELFORM 15), also sorted out of bricks by ESORT.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "impact/recording/element_histories.hpp"
#include "linear.hpp"
#include "nvh/statics/statics.hpp"
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

/// Holds three faces of the bar as planes of symmetry and drives the fourth along x by curve 9. What turns a node out
/// of its face is held, too: rotations bend the edges of tetrahedra that have them.
void stretch_between_smooth_grips(Specimen& s, const Bar& bar) {
  for (int axis = 0; axis < 3; ++axis) {
    const double x = axis == 0, y = axis == 1, z = axis == 2;
    s.node_set(1 + axis, bar.plane(axis)).card("BOUNDARY_SPC_SET", {1.0 + axis, 0, x, y, z, 1 - x, 1 - y, 1 - z});
  }
  s.node_set(4, bar.plane(0, true)).card("BOUNDARY_PRESCRIBED_MOTION_SET", {4, 1, 2, 9});
  s.card("BOUNDARY_SPC_SET", {4, 0, 0, 0, 0, 0, 1, 1});
}

/// Energy of the bar, stretched by 0.04 between smooth grips.
double stretched(int elform, const std::vector<std::array<int, 8>>& pieces, const std::string& control = "") {
  Specimen s =
      steel(elform, control +
                        "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
                        "*CONTROL_TERMINATION\n       1.0\n*DEFINE_CURVE\n         9\n"
                        "                 0.0                 0.0\n                 1.0                0.04\n");
  const Bar bar(s, pieces);
  stretch_between_smooth_grips(s, bar);
  const LinearExperiment experiment(s.deck());
  Findings findings;
  return nvh::solve_statics(experiment.matrices(), findings).energy;
}

// E A u^2 / (2 L) = 420 N mm: a linear field, which every mesh must give exactly.
TEST(Tetrahedra, StretchedBar) {
  constexpr double exact = 0.5 * 210000.0 * side * side * 0.04 * 0.04 / length;
  expect_reference("patch", "bar of 96 tetrahedra, ELFORM 10: strain energy", stretched(10, tetrahedra), exact, 1e-9);
  expect_reference("patch", "bar of 96 tetrahedra, ELFORM 4: strain energy", stretched(4, tetrahedra), exact, 1e-9);
  expect_reference("patch", "bar of 32 wedges, ELFORM 15: strain energy", stretched(15, wedges), exact, 1e-9);
  // Sabotage: bricks with the tetrahedron's four nodes as their bottom, which have half of its volume.
  for (const int elform : {1, 2, -1})
    expect_reference("patch",
                     fmt::format("bar of 96 tetrahedra folded into bricks of ELFORM {}: strain energy", elform),
                     stretched(elform, tetrahedra), exact, 1e-9);
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
class FreeBlock : public testing::TestWithParam<int> {};
TEST_P(FreeBlock, KeepsItsEnergy) {
  Specimen s = steel(GetParam(), "*CONTROL_TERMINATION\n5.0e-4\n*CONTROL_BULK_VISCOSITY\n0.0,1.0e-9\n");
  const Bar bar(s, tetrahedra);
  s.node_set(1, bar.plane(0, true)).card("INITIAL_VELOCITY", {1}).text("2000.0,1000.0,-500.0\n");
  Experiment experiment(s.deck());
  double start = 0.0, worst = 0.0, moved = 0.0;
  int cycles = 0;
  experiment.run([&](const impact::Snapshot& now) {
    ++cycles;
    const double total = now.energy.kinetic + now.energy.internal + now.energy.hourglass;
    if (start == 0.0) start = total;
    worst = std::max(worst, std::abs(total / start - 1.0));
    moved = std::max(moved, norm(experiment.displacement(now, bar.corner())));
  });
  EXPECT_GT(cycles, 500);
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(worst, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Tetrahedra, FreeBlock, testing::Values(10, 4));

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

/// A slender bar 100 x 10 x 10 of cubes in six tetrahedra each, clamped at x = 0.
struct Cantilever {
  Specimen specimen;
  Grid grid;

  Cantilever(int elform, int along, int across, const std::string& control) : specimen(steel(elform, control)) {
    grid = {1, {along, across, across}};
    for (int k = 0; k <= across; ++k)
      for (int j = 0; j <= across; ++j)
        for (int i = 0; i <= along; ++i) specimen.node({100.0 * i / along, side * j / across, side * k / across});
    for (int i = 0; i < along; ++i)
      for (int j = 0; j < across; ++j)
        for (int k = 0; k < across; ++k)
          for (const auto& p : tetrahedra) {
            const auto at = [&](int c) { return grid(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)); };
            specimen.brick(1, {at(p[0]), at(p[1]), at(p[2]), at(p[3]), at(p[4]), at(p[5]), at(p[6]), at(p[7])});
          }
    specimen.node_set(1, grid.across(0)).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  }
};

/// Deflection of the middle of the end under a force of 1 over that of Timoshenko's beam.
double bent(int elform, int along, int across) {
  Cantilever bar(elform, along, across,
                 "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_SOLUTION\n         1\n"
                 "*CONTROL_TERMINATION\n       1.0\n*DEFINE_CURVE\n         9\n"
                 "                 0.0                 0.0\n                 1.0                 1.0\n");
  for (int k = 0; k <= across; ++k)
    for (int j = 0; j <= across; ++j) {
      const double share = (j == 0 || j == across ? 0.5 : 1.0) * (k == 0 || k == across ? 0.5 : 1.0);
      bar.specimen.card("LOAD_NODE_POINT", {1.0 * bar.grid(along, j, k), 3, 9, share / (across * across)});
    }
  const LinearExperiment experiment(bar.specimen.deck());
  Findings findings;
  const nvh::Statics solved = nvh::solve_statics(experiment.matrices(), findings);
  EXPECT_LT(solved.residual, 1e-7);
  const double inertia = std::pow(side, 4) / 12.0, shear = 210000.0 / 2.6 * side * side * 5.0 / 6.0;
  const double beam = 1e6 / (3.0 * 210000.0 * inertia) + 100.0 / shear;
  return 2.0 * solved.energy / beam;  // twice the energy over the force
}

// Sabotage: the middle of an edge moved to the other side; the small stiffness of the mean rotation a thousand times
// larger.
TEST(RotationalTetrahedra, BendWhereTheOthersLock) {
  const double coarse = bent(4, 10, 2), fine = bent(4, 20, 2);
  expect_reference("tetrahedra", "cantilever of 20 x 2 x 2 x 6 tetrahedra ELFORM 4: deflection over the beam's", fine,
                   1.0, 6e-2);
  EXPECT_GT(fine, coarse);
  EXPECT_GT(coarse, 0.8);
  EXPECT_LT(bent(10, 20, 2), 0.6);
}

// A clamped bar's first bending by Euler and Bernoulli; a bar free of everything has six free motions and no others
// below its bending.
TEST(RotationalTetrahedra, ModesOfABar) {
  const std::string control =
      "*CONTROL_IMPLICIT_GENERAL\n         1       1.0\n*CONTROL_IMPLICIT_EIGENVALUE\n         4\n";
  const double unit_frequency = std::sqrt(210000.0 * side * side / (12.0 * 7.85e-9)) / (2.0 * std::numbers::pi * 1e4);
  const Cantilever bar(4, 20, 2, control);
  const nvh::Modes modes = LinearExperiment(bar.specimen.deck()).modes(4);
  for (std::size_t i = 0; i < 2; ++i)
    expect_reference("tetrahedra", "cantilever of 20 x 2 x 2 x 6 tetrahedra ELFORM 4: bending mode [Hz]",
                     modes.frequency(i), 3.51602 * unit_frequency, 4e-2);
  Specimen free = steel(4, control);
  const Bar block(free, tetrahedra);
  const std::vector<double> f = LinearExperiment(free.deck()).elastic_frequencies(3);
  EXPECT_GT(f[0], 1e4);
}

// Stretched far beyond yield, free across: the stress of the law at the strain, log(1 + u/L).
TEST(RotationalTetrahedra, PlasticBar) {
  constexpr double end = 2.0e-3, stretch = 4.0, yield = 300.0, tangent = 2100.0;
  Specimen s;
  s.text("*CONTROL_TERMINATION\n" + fields({end})).text(smooth_ramp(9, end, stretch));
  s.card("MAT_PLASTIC_KINEMATIC", {1, 7.85e-9, 210000.0, 0.3, yield, tangent, 1.0}).text(fields({}));
  s.card("SECTION_SOLID", {1, 4}).part(1, 1, 1);
  s.card("DATABASE_EXTENT_BINARY", {0, 0, 3, 1}).card("DATABASE_HISTORY_SOLID", {7});
  const Bar bar(s, tetrahedra);
  stretch_between_smooth_grips(s, bar);
  Experiment experiment(s.deck());
  double ratio = 0.0, least = 1e9, most = 0.0, plastic = 0.0, hourglass = 0.0, internal = 0.0, shown = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    ratio = std::max(ratio, std::abs(now.energy.ratio() - 1.0));
    if (now.state.time < 0.999 * end) return;
    least = 1e9, most = 0.0;
    for (int e = 1; e <= 96; ++e) {
      const auto layer = brick_layer(experiment, now, e);
      least = std::min(least, layer.stress[0]);
      most = std::max(most, layer.stress[0]);
      plastic = layer.plastic_strain;
    }
    shown = impact::elout_state(now).solids.at(0).strain[0];
    hourglass = now.energy.hourglass;
    internal = now.energy.internal;
  });
  const double strain = std::log(1.0 + stretch / length);
  const double stress = yield + tangent * (strain - yield / 210000.0);
  expect_reference("tetrahedra", "bar of 96 tetrahedra ELFORM 4, stretched by a tenth: least stress [MPa]", least,
                   stress, 1e-2);
  expect_reference("tetrahedra", "the same: greatest stress [MPa]", most, stress, 1e-2);
  expect_reference("tetrahedra", "the same: plastic strain", plastic, strain - stress / 210000.0, 1e-2);
  expect_reference("tetrahedra", "the same: strain of the output", shown, strain, 1e-3);
  EXPECT_LT(ratio, 0.01);
  EXPECT_LT(hourglass, 1e-3 * internal);
}

}  // namespace
}  // namespace nugget::verify
