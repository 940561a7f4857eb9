// SPDX-License-Identifier: Apache-2.0
// Intervals and centres of *CONTROL_IMPLICIT_EIGENVALUE: the modes of a simply supported plate that lie there.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

}  // namespace
}  // namespace nugget::verify
