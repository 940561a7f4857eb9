// SPDX-License-Identifier: Apache-2.0
// Intervals and centres of *CONTROL_IMPLICIT_EIGENVALUE: the modes of a simply supported plate that lie there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double young = 210000.0, nu = 0.3, density = 7.85e-9, thickness = 2.0;

LinearExperiment plate(double a, double b, int along, int across) {
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
  s.card("MAT_ELASTIC", {1, density, young, nu});
  s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("       2.0       2.0       2.0       2.0\n").part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {a, b, 0.0}, along, across);
  std::vector<int> edge;
  for (int j = 0; j <= across; ++j)
    for (int i = 0; i <= along; ++i)
      if (i == 0 || j == 0 || i == along || j == across) edge.push_back(grid(i, j));
  s.node_set(1, edge).card("BOUNDARY_SPC_SET", {1, 0, 1, 1, 1});
  return LinearExperiment(s.deck());
}

/// Kirchhoff's frequencies of the plate, ascending.
std::vector<double> closed_form(double a, double b, double up_to) {
  const double d = young * thickness * thickness * thickness / (12.0 * (1.0 - nu * nu));
  std::vector<double> f;
  for (int m = 1; m < 12; ++m)
    for (int n = 1; n < 12; ++n)
      f.push_back(0.5 * std::numbers::pi * std::sqrt(d / (density * thickness)) * (m * m / (a * a) + n * n / (b * b)));
  std::sort(f.begin(), f.end());
  f.erase(std::upper_bound(f.begin(), f.end(), up_to), f.end());
  return f;
}

std::vector<double> found(const LinearExperiment& experiment, const nvh::ModeRequest& request) {
  const nvh::Modes modes = nvh::find_modes(experiment.matrices(), request);
  EXPECT_TRUE(modes.proof.complete()) << modes.proof.counted << " modes counted, " << modes.proof.found << " found";
  EXPECT_GE(modes.proof.found, static_cast<int>(modes.eigenvalue.size()));
  std::vector<double> f;
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i) f.push_back(modes.frequency(i));
  return f;
}

/// `numbers`: which of the plate's modes, counted from 1.
void expect_modes(const std::vector<double>& f, const std::vector<double>& full,
                  const std::vector<std::size_t>& numbers) {
  ASSERT_EQ(f.size(), numbers.size());
  for (std::size_t i = 0; i < f.size(); ++i)
    EXPECT_NEAR(f[i] / full[numbers[i] - 1], 1.0, 1e-9) << "mode " << numbers[i];
}

nvh::ModeRequest request(int count) {
  nvh::ModeRequest r;
  r.count = count;
  return r;
}

// 500 x 400: 50.40 109.4 142.6 201.6 207.7 296.3 ... Sabotage: the sign of the shift in Sylvester's count; modes
// outside of the interval kept; the distance from the centre measured from zero.
TEST(ModeIntervals, SimplySupportedPlate) {
  const LinearExperiment experiment = plate(500.0, 400.0, 30, 24);
  const std::vector<double> exact = closed_form(500.0, 400.0, 600.0);
  const std::vector<double> full = found(experiment, request(static_cast<int>(exact.size())));
  for (std::size_t i = 0; i < 7; ++i)
    expect_reference("response of a supported plate",
                     fmt::format("supported plate, 30 x 24 shells: mode {} [Hz]", i + 1), full[i], exact[i], 1e-2);

  nvh::ModeRequest r = request(50);
  r.low = 100.0, r.high = 270.0;
  const std::vector<double> inside = found(experiment, r);
  expect_modes(inside, full, {2, 3, 4, 5});
  for (std::size_t i = 0; i < inside.size(); ++i)
    expect_reference("response of a supported plate", fmt::format("modes between 100 and 270: number {} [Hz]", i + 1),
                     inside[i], exact[i + 1], 1e-2);
  r.count = 0;
  expect_modes(found(experiment, r), full, {2, 3, 4, 5});
  r.count = 2;  // NEIG limits
  expect_modes(found(experiment, r), full, {2, 3});
  r.low = 60.0, r.high = 100.0;
  EXPECT_TRUE(found(experiment, r).empty());

  r = request(3);
  r.low = 120.0;
  expect_modes(found(experiment, r), full, {3, 4, 5});
  r = request(20);
  r.high = 205.0;
  expect_modes(found(experiment, r), full, {1, 2, 3, 4});
  r.count = 2;
  expect_modes(found(experiment, r), full, {1, 2});

  r = request(4);
  r.centre = 160.0;
  expect_modes(found(experiment, r), full, {2, 3, 4, 5});
  r.high = 205.0;  // the nearest of those that lie below
  expect_modes(found(experiment, r), full, {1, 2, 3, 4});
  r.low = 105.0;
  expect_modes(found(experiment, r), full, {2, 3, 4});
  r = request(2);
  r.centre = 160.0, r.low = 200.0;  // a centre outside of the interval
  expect_modes(found(experiment, r), full, {4, 5});
}

// A square plate has pairs of equal frequencies; a limit may fall between the two. Sabotage: counting there.
TEST(ModeIntervals, LimitsWithinPairs) {
  const LinearExperiment experiment = plate(400.0, 400.0, 16, 16);
  const std::vector<double> full = found(experiment, request(12));
  EXPECT_NEAR(full[1] / full[2], 1.0, 1e-9);
  for (const int count : {1, 2, 3, 5, 6}) {
    const std::vector<double> f = found(experiment, request(count));
    ASSERT_EQ(f.size(), at(count));
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f[i] / full[i], 1.0, 1e-9);
  }
  nvh::ModeRequest r = request(1);
  r.centre = full[1] * 1.01;
  EXPECT_NEAR(found(experiment, r).at(0) / full[1], 1.0, 1e-9);
}

/// The largest entry of |X^t M X - 1|.
double deviation_from_orthonormal(const LinearExperiment& experiment, const nvh::Columns& x) {
  nvh::Columns mass(x.rows, x.count);
  nvh::multiply(experiment.matrices().mass, x, mass);
  double largest = 0.0;
  for (std::size_t i = 0; i < x.count; ++i)
    for (std::size_t j = 0; j < x.count; ++j) {
      double product = 0.0;
      for (std::size_t k = 0; k < x.rows; ++k) product += x[i][k] * mass[j][k];
      largest = std::max(largest, std::abs(product - (i == j ? 1.0 : 0.0)));
    }
  return largest;
}

/// The modes of a request sought from several places, `slice` at the last of them, are those from one place, all of
/// them.
void expect_slices(const LinearExperiment& experiment, nvh::ModeRequest r, std::size_t slice) {
  SCOPED_TRACE(fmt::format("{} modes from {} to {}, {} a slice", r.count, r.low, r.high, slice));
  r.slice = 1000;
  const nvh::Modes whole = nvh::find_modes(experiment.matrices(), r);
  r.slice = slice;
  const nvh::Modes modes = nvh::find_modes(experiment.matrices(), r);
  EXPECT_TRUE(modes.proof.complete()) << modes.proof.counted << " modes counted, " << modes.proof.found << " found";
  EXPECT_GE(modes.proof.found, static_cast<int>(modes.eigenvalue.size()));
  EXPECT_GT(modes.cost.factorizations, 2) << "one place and the count behind the last mode";
  ASSERT_EQ(modes.eigenvalue.size(), whole.eigenvalue.size());
  for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i)
    EXPECT_NEAR(modes.eigenvalue[i], whole.eigenvalue[i], 1e-10 * whole.eigenvalue.back()) << "mode " << i + 1;
  EXPECT_LT(deviation_from_orthonormal(experiment, modes.shape), 1e-9);
}

// Kirchhoff's frequencies hold for many modes; those of one place and of several are the same. Sabotage: the count of
// pairs between two shifts not asked for; a cut within a pair.
TEST(ModeSlices, SupportedPlate) {
  const LinearExperiment experiment = plate(500.0, 400.0, 60, 48);
  const std::vector<double> exact = closed_form(500.0, 400.0, 2600.0);
  ASSERT_GT(exact.size(), 40u);
  nvh::ModeRequest r = request(static_cast<int>(exact.size()));
  r.slice = 8;
  const std::vector<double> f = found(experiment, r);
  ASSERT_EQ(f.size(), exact.size());
  for (const std::size_t i : {0u, 7u, 15u, 23u, 31u, 39u})
    expect_reference("response of a supported plate", fmt::format("supported plate in slices, mode {} [Hz]", i + 1),
                     f[i], exact[i], 2e-2);
  for (const std::size_t slice : {3u, 4u, 6u, 9u, 13u}) expect_slices(experiment, request(40), slice);
}

TEST(ModeSlices, IntervalsAndLimits) {
  const LinearExperiment experiment = plate(500.0, 400.0, 30, 24);
  nvh::ModeRequest r = request(0);
  r.low = 150.0, r.high = 2000.0;
  expect_slices(experiment, r, 6);
  r.count = 20;
  expect_slices(experiment, r, 6);
  r.low = -std::numeric_limits<double>::infinity();
  expect_slices(experiment, r, 6);
  r.count = 0;
  expect_slices(experiment, r, 6);
}

// Pairs and whole groups of equal frequencies: a square plate, free; and equal plates side by side, more of them than a
// slice has modes.
TEST(ModeSlices, EqualFrequencies) {
  const LinearExperiment supported = plate(400.0, 400.0, 20, 20);
  for (const int count : {21, 22, 23, 24, 25}) expect_slices(supported, request(count), 5);

  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
  s.card("MAT_ELASTIC", {1, density, young, nu});
  s.card("SECTION_SHELL", {1, 16, 0.833333, 2}).text("       2.0       2.0       2.0       2.0\n").part(1, 1, 1);
  for (int i = 0; i < 3; ++i) s.shells(1, {300.0 * i, 0.0, 0.0}, {200.0, 200.0, 0.0}, 10, 10);
  const LinearExperiment free(s.deck());
  for (const std::size_t slice : {3u, 4u, 6u})
    for (const int count : {30, 33, 36, 41}) expect_slices(free, request(count), slice);
}

}  // namespace
}  // namespace nugget::verify
