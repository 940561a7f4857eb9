// SPDX-License-Identifier: Apache-2.0
// Natural modes by K and M out of the force kernels.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double young = 210000.0, steel = 7.85e-9;  // steel A: mm, t, s, N

/// A bar of bricks along x, one across; `nu` 0 and no motion across make it a chain of springs and masses.
Specimen brick_bar(double length, double width, double height, std::array<int, 3> cells, double modulus, double nu,
                   double density, Grid& grid) {
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {20});
  s.card("MAT_ELASTIC", {1, density, modulus, nu}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  grid = s.bricks(1, {}, {length, width, height}, cells);
  return s;
}

// Lumped masses between springs E A / h have frequencies in closed form. Sabotage: half a mass at the free end too
// much.
TEST(Modes, LumpedBarClampedAtOneEnd) {
  constexpr int n = 10;
  Grid grid;
  Specimen s = brick_bar(500.0, 10.0, 10.0, {n, 1, 1}, young, 0.0, steel, grid);
  s.node_set(1, grid.all()).card("BOUNDARY_SPC_SET", {1, 0, 0, 1, 1});
  s.node_set(2, grid.across(0)).card("BOUNDARY_SPC_SET", {2, 0, 1, 1, 1});
  const LinearExperiment bar(s.deck());
  // Four nodes a station make four chains that are coupled in shear; the stretch of the whole section is the mode
  // without any.
  const nvh::Modes modes = bar.modes(20);
  const double speed = std::sqrt(young / steel), h = 500.0 / n;
  for (int k = 1; k <= 2; ++k) {
    const double expected =
        2.0 * speed / h * std::sin((2 * k - 1) * std::numbers::pi / (4.0 * n)) / (2.0 * std::numbers::pi);
    double closest = 0.0;
    for (std::size_t i = 0; i < modes.eigenvalue.size(); ++i)
      if (std::abs(modes.frequency(i) - expected) < std::abs(closest - expected)) closest = modes.frequency(i);
    expect_reference("A-12", fmt::format("lumped bar of {} bricks, clamped and free: mode {} [Hz]", n, k), closest,
                     expected, 1e-6);
  }
}

// Sabotage: QM 0.1 instead of 1 for the stabilisation of one-point bricks.
TEST(Modes, FreeBarInBending) {
  Grid grid;
  const Specimen s = brick_bar(300.0, 25.0, 3.0, {60, 5, 1}, 205000.0, 0.29, 7.85e-9, grid);
  const LinearExperiment bar(s.deck());
  const std::vector<double> f = bar.elastic_frequencies(8);
  const double expected[] = {175.034, 482.158, 944.276};
  for (const double e : expected) {
    double closest = 0.0;
    for (const double value : f)
      if (std::abs(value - e) < std::abs(closest - e)) closest = value;
    expect_reference("A-55", fmt::format("free bar 300 x 25 x 3, 60 x 5 x 1 bricks: bending at {} [Hz]", e), closest, e,
                     1e-2);
  }
}

}  // namespace
}  // namespace nugget::verify
