// SPDX-License-Identifier: Apache-2.0
// *CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED: plates that lie on each other vibrate as one.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "specimen.hpp"
#include "weld/tie/touching.hpp"

namespace nugget::verify {
namespace {

/// A unit system by what one of its units of length, mass and time is in mm, t, s.
struct Units {
  double length = 1.0, mass = 1.0, time = 1.0;
};

/// Strips of 200 x 20 on top of each other, free in space, without Poisson's effect: beams.
struct Stack {
  Stack() { plates[1].z = 2.0; }
  struct Plate {
    double thickness = 2.0, z = 0.0;
    int along = 40, across = 2;
  };
  std::vector<Plate> plates = std::vector<Plate>(2);
  double close = 0.05;
  Units units;
  bool mirrored = false;                      ///< x becomes -x
  double skew = 0.0;                          ///< of the lines across, in the outermost plate's plane [length]
  std::array<double, 3> turn{0.0, 0.0, 0.0};  ///< axis times angle
  int sides_type = 5;                         ///< SURFATYP: 5 everything

  static constexpr double length = 200.0, width = 20.0, young = 210000.0, density = 7.85e-9;

  Vec3d place(Vec3d x) const {
    if (mirrored) x.x = -x.x;
    const Vec3d axis{turn[0], turn[1], turn[2]};
    if (const double angle = norm(axis); angle > 0.0) {
      const Vec3d e = unit(axis);
      x = std::cos(angle) * x + std::sin(angle) * cross(e, x) + ((1.0 - std::cos(angle)) * dot(e, x)) * e;
    }
    return (1.0 / units.length) * x;
  }

  Specimen specimen() const {
    const double stress = units.mass / (units.length * units.time * units.time);  // of the unit, in MPa
    Specimen s;
    s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
    s.card("MAT_ELASTIC", {1, density / units.mass * std::pow(units.length, 3), young / stress, 0.0});
    s.text("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED_ID\n         7\n" + fields({0, 0, double(sides_type)}) + fields({}) +
           fields({}) + fields({close / units.length}));
    int part = 0, node = 0, shell = 0;
    std::string nodes, shells;
    for (const Plate& p : plates) {
      ++part;
      const double t = p.thickness / units.length;
      s.text("*SECTION_SHELL\n" + fields({double(part), 16, 5.0 / 6.0, 5}) + fields({t, t, t, t})).part(part, part, 1);
      const int first = node + 1;
      for (int j = 0; j <= p.across; ++j)
        for (int i = 0; i <= p.along; ++i) {
          const double v = double(j) / p.across, u = double(i) / p.along, lean = skew * (part - 1);
          const double slant = lean * (v - 0.5) * 4.0 * u * (1.0 - u);
          const Vec3d x = place({length * u + slant, width * v, p.z});
          nodes += node_line(++node, x.x, x.y, x.z);
        }
      const auto at_grid = [&](int i, int j) { return first + j * (p.along + 1) + i; };
      for (int j = 0; j < p.across; ++j)
        for (int i = 0; i < p.along; ++i)
          shells +=
              element_line(++shell, part, {at_grid(i, j), at_grid(i + 1, j), at_grid(i + 1, j + 1), at_grid(i, j + 1)});
    }
    s.text("*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells);
    return s;
  }

  /// Bending frequencies of a free beam as thick as `height`, in the units of the deck [1/time].
  static std::vector<double> closed_form(double height, int count, const Units& units = {}) {
    constexpr double roots[] = {4.730040745, 7.853204624, 10.99560784, 14.13716549};
    std::vector<double> f;
    for (int i = 0; i < count; ++i)
      f.push_back(roots[i] * roots[i] / (2.0 * std::numbers::pi * length * length) * height *
                  std::sqrt(young / (12.0 * density)) * units.time);
    return f;
  }

  std::vector<double> elastic(int count) const {
    return LinearExperiment(specimen().deck()).elastic_frequencies(count);
  }
};

double closest(const std::vector<double>& f, double expected) {
  double best = f.front();
  for (const double value : f)
    if (std::abs(value - expected) < std::abs(best - expected)) best = value;
  return best;
}

const char* const test_case = "plates that touch";

void expect_beam(const std::string& what, const Stack& stack, double height, double gate, int modes = 3) {
  const std::vector<double> f = stack.elastic(8);
  int mode = 0;
  for (const double expected : Stack::closed_form(height, modes, stack.units))
    expect_reference(test_case, fmt::format("{}: bending, mode {} [Hz]", what, ++mode),
                     closest(f, expected) / stack.units.time, expected / stack.units.time, gate);
}

// Two plates of 2 mm are one of 4 mm: the tie hands over shear and moments. Sabotage to be caught: no lever (half the
// frequencies), both sides tied to each other, rotations left out at the ends.
TEST(TouchingParts, TwoPlatesAreOneOfTwiceTheThickness) {
  expect_beam("two plates of 2 mm as one of 4 mm, meshes alike", {}, 4.0, 5e-3);
}

// Sabotage: arms without the half way to the corners (a finer mesh that follows a coarser one locks: 5 % and more).
TEST(TouchingParts, MeshesNeedNotBeAlike) {
  Stack stack;
  for (const int along : {27, 90}) {
    stack.plates[1].along = along;
    expect_beam(fmt::format("two plates, 40 x 2 on {} x 2 elements", along), stack, 4.0, 6e-3);
  }
  // Where rows across differ, too, rotations about the normal soften the tie a little: what is left falls with the
  // element.
  for (const auto& [along, across] : {std::pair{27, 3}, {90, 5}}) {
    stack.plates[1].along = along;
    stack.plates[1].across = across;
    expect_beam(fmt::format("two plates, 40 x 2 on {} x {} elements", along, across), stack, 4.0, 5e-3, 1);
  }
  stack.skew = 6.0;
  expect_beam("two plates, 40 x 2 on 90 x 5 skewed elements", stack, 4.0, 5e-3, 1);
  stack.skew = 0.0;
  stack.plates = {{2.0, 0.0, 80, 4}, {2.0, 2.0, 54, 6}};
  expect_beam("two plates, 80 x 4 on 54 x 6 elements", stack, 4.0, 8e-3);
}

// Three sheets in whatever order of element sizes: the one in the middle follows one neighbour, the other follows it.
TEST(TouchingParts, ThreePlatesHoldTogether) {
  for (const auto& along :
       {std::array{40, 40, 40}, std::array{20, 50, 33}, std::array{33, 20, 50}, std::array{50, 33, 20}}) {
    Stack stack;
    stack.plates = {{1.0, 0.0, along[0]}, {2.0, 1.5, along[1]}, {1.0, 3.0, along[2]}};
    expect_beam(fmt::format("plates of 1, 2 and 1 mm, {}, {} and {} elements", along[0], along[1], along[2]), stack,
                4.0, 8e-3);
  }
}

// Other units, the mirror image, half and twice the size in space.
TEST(TouchingParts, UnitsAndPlacesDoNotCount) {
  const std::vector<double> f = Stack{}.elastic(6);
  const auto expect_same = [&](const char* what, const Stack& stack) {
    const std::vector<double> other = stack.elastic(6);
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(other[i] / stack.units.time, f[i], 1e-5 * f[i]) << what << i;
  };
  Stack mirrored, turned, metres, milliseconds;
  mirrored.mirrored = true;
  turned.turn = {0.4, -1.1, 0.7};
  metres.units = {1e3, 1e-3, 1.0};
  milliseconds.units = {1.0, 1e-3, 1e-3};
  expect_same("mirrored", mirrored);
  expect_same("turned", turned);
  expect_same("m kg s", metres);
  expect_same("mm kg ms", milliseconds);
}

// A gap beyond CLOSE: two plates that know nothing of each other, twice six rigid motions.
TEST(TouchingParts, BeyondCloseTheyAreApart) {
  Stack stack;
  stack.plates[1].z = 2.3;
  stack.close = 0.2;
  const LinearExperiment apart(stack.specimen().deck());
  EXPECT_TRUE(apart.system().ties.ties.empty());
  const nvh::Modes modes = apart.modes(16);
  EXPECT_LT(std::abs(modes.eigenvalue[11]), 1e-6 * modes.eigenvalue[12]);
  for (std::size_t i = 0; i < 2; ++i)
    expect_reference(test_case, fmt::format("plates 0.3 mm apart, CLOSE 0.2: each bends for itself ({}) [Hz]", i + 1),
                     modes.frequency(12 + i), Stack::closed_form(2.0, 1)[0], 5e-3);
  stack.close = 0.4;
  EXPECT_EQ(LinearExperiment(stack.specimen().deck()).system().ties.ties.size(), 41u * 3u);
}

// CLOSE 0: a hundredth of the elements' size, here 0.07 mm of 7.07 mm.
TEST(TouchingParts, CloseOfTheMesh) {
  Stack stack;
  stack.close = 0.0;
  for (const auto& [gap, tied] : {std::pair{0.069, true}, std::pair{0.072, false}}) {
    stack.plates[1].z = 2.0 + gap;
    const LinearExperiment e(stack.specimen().deck());
    EXPECT_EQ(!e.system().ties.ties.empty(), tied) << gap;
  }
}

// Clamped at one end with all six freedoms, and held in a plane of symmetry: supports of both sheets, tied or not,
// hold.
TEST(TouchingParts, SupportsOfBothSheetsHold) {
  constexpr double root = 1.875104069;
  Specimen s = Stack{}.specimen();
  std::vector<int> held;
  for (int plate = 0; plate < 2; ++plate)
    for (int j = 0; j < 3; ++j) held.push_back(123 * plate + 41 * j + 1);
  s.node_set(1, held).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1, 1, 1, 1});
  const LinearExperiment cantilever(s.deck());
  EXPECT_EQ(cantilever.system().ties.ties.size(), 123u);
  for (const Finding& f : cantilever.findings().all()) EXPECT_NE(f.severity, Severity::warning) << to_string(f);
  const double expected = root * root / (2.0 * std::numbers::pi * 4e4) * 4.0 * std::sqrt(210000.0 / (12.0 * 7.85e-9));
  expect_reference(test_case, "cantilever of two plates of 2 mm: bending, mode 1 [Hz]",
                   cantilever.modes(2).frequency(0), expected, 5e-3);
}

// A hem: a sheet folded back on itself, its leg on itself, is twice as thick there and carries as one.
TEST(TouchingParts, ASheetTouchesItself) {
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
  s.card("MAT_ELASTIC", {1, 7.85e-9, 210000.0, 0.0});
  s.text("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED\n" + fields({0, 0, 5}) + fields({}) + fields({}) + fields({0.05}));
  s.text("*SECTION_SHELL\n" + fields({1, 16, 5.0 / 6.0, 5}) + fields({2.0, 2.0, 2.0, 2.0})).part(1, 1, 1);
  // Along y: 20 wide at z = 0, round at a radius of 1, 20 back at z = 2.
  std::vector<Vec3d> profile;
  for (int k = 0; k <= 4; ++k) profile.push_back({0, 5.0 * k, 0});
  profile.push_back({0, 20.0 + std::sin(std::numbers::pi / 4), 1.0 - std::cos(std::numbers::pi / 4)});
  profile.push_back({0, 21.0, 1.0});
  profile.push_back({0, 20.0 + std::sin(std::numbers::pi / 4), 1.0 + std::cos(std::numbers::pi / 4)});
  for (int k = 4; k >= 0; --k) profile.push_back({0, 5.0 * k, 2.0});
  std::string nodes, shells;
  const int n = static_cast<int>(profile.size());
  for (int i = 0; i <= 40; ++i)
    for (int k = 0; k < n; ++k) nodes += node_line(i * n + k + 1, 5.0 * i, profile[k].y, profile[k].z);
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k + 1 < n; ++k)
      shells += element_line(i * (n - 1) + k + 1, 1,
                             {i * n + k + 1, (i + 1) * n + k + 1, (i + 1) * n + k + 2, i * n + k + 2});
  s.text("*NODE\n" + nodes + "*ELEMENT_SHELL\n" + shells);
  const LinearExperiment hem(s.deck());
  for (const weld::Tie& tie : hem.system().ties.ties) {
    EXPECT_EQ(tie.part, tie.own_part);
    EXPECT_NEAR(tie.gap, 2.0, 1e-9);
  }
  // One leg follows the other, but for the row at the fold and the one beside it, which the walk around the fold
  // reaches.
  EXPECT_GE(hem.system().ties.ties.size(), 41u * 4u);
  EXPECT_LE(hem.system().ties.ties.size(), 41u * 5u);
  const std::vector<double> f = hem.elastic_frequencies(6);
  const double expected = Stack::closed_form(4.0, 1)[0];
  EXPECT_NEAR(closest(f, expected), expected, 0.03 * expected);  // the fold is part of it: not a closed form
}

}  // namespace
}  // namespace nugget::verify
