// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/anisotropic_sheet.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "kernel/law/piecewise_linear_kernel.hpp"
#include "law_point.hpp"

// Rolled sheets: ratios and strengths against what defines them, the isotropic case against that of von Mises.
namespace nugget::kernel {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

AnisotropicSheet sheet(double m, double r00, double r45, double r90, const SheetFormula& hardening) {
  return {.E = 210000.0,
          .nu = 0.3,
          .surface = BarlatLian::from_ratios(m, r00, r45, r90),
          .hardening = hardening,
          .axes = {}};
}

/// A point whose axis a lies at `angle` to the element's axis.
LayerPoint<AnisotropicSheet> turned(const AnisotropicSheet& law, double angle) {
  LayerPoint<AnisotropicSheet> point(law);
  point.history[first_axis_field] = std::cos(angle);
  point.history[first_axis_field + 1] = std::sin(angle);
  return point;
}

/// Strains the point along the element's axis by `step`, with the transverse strain and the shear that leave no other
/// stress, by Newton's method on differences. Gives the strain that it took.
LayerTensor<double> pull(LayerPoint<AnisotropicSheet>& point, double step) {
  double lateral = -0.5 * step, shear = 0.0;
  const auto after = [&](double b, double c) {
    auto copy = point;
    copy.strain({step, b, c, 0, 0});
    return copy.s;
  };
  for (int i = 0; i < 40; ++i) {
    const LayerTensor<double> s = after(lateral, shear);
    if (std::abs(s.yy) + std::abs(s.xy) < 1e-8) break;
    const double h = 1e-4 * step;
    const LayerTensor<double> b = after(lateral + h, shear), c = after(lateral, shear + h);
    const double byy = (b.yy - s.yy) / h, bxy = (b.xy - s.xy) / h, cyy = (c.yy - s.yy) / h, cxy = (c.xy - s.xy) / h;
    const double over = 1.0 / (byy * cxy - cyy * bxy);
    lateral -= over * (cxy * s.yy - cyy * s.xy);
    shear -= over * (byy * s.xy - bxy * s.yy);
  }
  point.strain({step, lateral, shear, 0, 0});
  return {step, lateral, shear, 0, 0};
}

TEST(AnisotropicSheet, StretchesByItsLankfordRatios) {
  const double ratios[] = {1.8, 1.3, 2.2};
  for (const double m : {2.0, 5.5, 6.0, 8.0}) {
    const AnisotropicSheet law = sheet(m, ratios[0], ratios[1], ratios[2], {.offset = 300.0, .factor = 1000.0});
    for (int i = 0; i < 3; ++i) {
      auto point = turned(law, 45.0 * i * degree);
      for (int k = 0; k < 20; ++k) pull(point, 5e-4);
      const double stress = point.s.xx, plastic = point.plastic_strain();
      const LayerTensor<double> strain = pull(point, 5e-4);
      const double across = strain.yy + 0.3 * (point.s.xx - stress) / 210000.0;
      EXPECT_NEAR(across / point.thickness.plastic, ratios[i], 1e-6 * ratios[i]) << "m " << m << " at " << 45 * i;
      // Plastic work is yield stress times plastic strain, whatever the direction.
      const double along = strain.xx - (point.s.xx - stress) / 210000.0;
      const double yield = 300.0 + 1000.0 * point.plastic_strain();
      EXPECT_NEAR(point.s.xx * along, yield * (point.plastic_strain() - plastic), 1e-4 * yield * along);
    }
  }
}

TEST(AnisotropicSheet, TensionAlongAGivesTheCurve) {
  auto point =
      turned(sheet(8.0, 0.7, 0.5, 0.8, {.offset = 200.0, .factor = 500.0, .exponent = 0.3, .start_strain = 0.01}), 0.0);
  for (int k = 0; k < 200; ++k) pull(point, 1e-3);
  EXPECT_NEAR(point.s.xx, 200.0 + 500.0 * std::pow(0.01 + point.plastic_strain(), 0.3), 1e-7 * point.s.xx);
  EXPECT_GT(point.plastic_strain(), 0.19);
}

TEST(AnisotropicSheet, SaturatesAsHockettAndSherby) {
  auto point =
      turned(sheet(6.0, 1.0, 1.0, 1.0, {.offset = 400.0, .factor = 180.0, .exponent = 0.8, .decay = 9.0}), 0.0);
  for (int k = 0; k < 200; ++k) pull(point, 1e-3);
  EXPECT_NEAR(point.s.xx, 400.0 - 180.0 * std::exp(-9.0 * std::pow(point.plastic_strain(), 0.8)), 1e-6 * point.s.xx);
}

// Hill (1948): strengths across and at 45 degrees over that along a.
TEST(AnisotropicSheet, StrengthsOfHill) {
  const double r0 = 1.8, r45 = 1.3, r90 = 2.2;
  const BarlatLianSurface surface(BarlatLian::from_ratios(2.0, r0, r45, r90));
  const double across = surface(PlaneStress<double>{0.0, 1.0, 0.0}).effective;
  EXPECT_NEAR(1.0 / across, std::sqrt(r90 * (1.0 + r0) / (r0 * (1.0 + r90))), 1e-9);
  const double f = r0 / (r90 * (1.0 + r0)), g = 1.0 / (1.0 + r0),
               n = (r0 + r90) * (1.0 + 2.0 * r45) / (2.0 * r90 * (1.0 + r0));
  const double diagonal = surface(PlaneStress<double>{0.5, 0.5, 0.5}).effective;
  EXPECT_NEAR(diagonal, std::sqrt((f + g + 2.0 * n) / 4.0), 1e-9);
}

// Hosford (1972): 2 Y^m = |s1|^m + |s2|^m + |s1 - s2|^m where all ratios are 1.
TEST(AnisotropicSheet, IsHosfordsWhereAllDirectionsAreAlike) {
  const BarlatLianSurface surface(BarlatLian::from_ratios(8.0, 1.0, 1.0, 1.0));
  const double shear = surface(PlaneStress<double>{0.0, 0.0, 1.0}).effective;
  EXPECT_NEAR(shear, std::pow((2.0 + 256.0) / 2.0, 1.0 / 8.0), 1e-9);
  const double plane = surface(PlaneStress<double>{1.0, 0.5, 0.0}).effective;
  EXPECT_NEAR(plane, std::pow((1.0 + 2.0 * std::pow(0.5, 8.0)) / 2.0, 1.0 / 8.0), 1e-9);
  EXPECT_NEAR(surface(PlaneStress<double>{1.0, 1.0, 0.0}).effective, 1.0, 1e-9);
}

std::vector<LayerTensor<double>> random_path(int steps, double size, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> chance(-size, size);
  std::vector<LayerTensor<double>> path(steps);
  LayerTensor<double> drift{chance(engine), chance(engine), chance(engine), 0, 0};
  for (auto& step : path)
    step = {drift.xx + chance(engine), drift.yy + chance(engine), drift.xy + chance(engine), 0, 0};
  return path;
}

// With the exponent 2 and all ratios 1 the surface is that of von Mises: MAT_024's stresses, with and without rates.
TEST(AnisotropicSheet, IsVonMisesWhereExponentAndRatiosSaySo) {
  for (const double rate : {0.0, 40.0}) {
    PiecewiseLinear curves;
    curves.E = 210000.0;
    curves.nu = 0.3;
    curves.yield = {{0, {0.0, 0.1, 0.5}, {250.0, 380.0, 500.0}}};
    curves.rate_c = rate;
    curves.rate_p = 5.0;
    AnisotropicSheet law = sheet(2.0, 1.0, 1.0, 1.0, {});
    law.hardening = curves;
    auto point = turned(law, 25.0 * degree);
    LayerPoint<PiecewiseLinear> reference(curves);
    point.dt = reference.dt = 1e-3;
    for (const auto& step : random_path(300, 1e-3, 7)) {
      point.strain(step);
      reference.strain(step);
      EXPECT_NEAR(point.s.xx, reference.s.xx, 1e-5);
      EXPECT_NEAR(point.s.yy, reference.s.yy, 1e-5);
      EXPECT_NEAR(point.s.xy, reference.s.xy, 1e-5);
      EXPECT_NEAR(point.thickness.total, reference.thickness.total, 1e-10);
      EXPECT_NEAR(point.plastic_strain(), reference.plastic_strain(), 1e-10);
    }
    EXPECT_GT(point.plastic_strain(), 0.01);
  }
}

// Steps of any size end on the surface, also where Newton's method runs away (high exponents, a long way past corners).
TEST(AnisotropicSheet, ReturnsFromAfar) {
  for (const double m : {2.0, 6.0, 8.0, 20.0})
    for (const double size : {1e-4, 1e-3, 1e-2, 5e-2})
      for (const double rate : {0.0, 40.0}) {
        AnisotropicSheet law = sheet(
            m, 0.6, 2.4, 1.1,
            {.offset = 0.0, .factor = 500.0, .exponent = 0.2, .start_strain = 0.002, .rate_c = rate, .rate_p = 5.0});
        auto point = turned(law, 0.0);
        point.dt = 1e-3;
        const BarlatLianSurface surface(law.surface);
        for (const auto& step : random_path(200, size, 3)) {
          const double before = point.plastic_strain();
          point.strain(step);
          const double increment = point.plastic_strain() - before;
          ASSERT_GE(increment, 0.0);
          if (increment == 0.0) continue;
          double yield = 500.0 * std::pow(0.002 + point.plastic_strain(), 0.2);
          if (rate > 0.0) yield *= 1.0 + std::pow(increment / point.dt / rate, 0.2);
          ASSERT_NEAR(surface(PlaneStress<double>{point.s.xx, point.s.yy, point.s.xy}).effective, yield, 1e-8 * yield)
              << "m " << m << ", steps of " << size;
        }
      }
}

// A batch gives bit for bit what its lanes give alone.
TEST(AnisotropicSheet, BatchesGiveTheBitsOfTheirLanes) {
  const AnisotropicSheet law =
      sheet(8.0, 0.6, 2.4, 1.1,
            {.offset = 100.0, .factor = 500.0, .exponent = 0.2, .start_strain = 0.002, .rate_c = 40.0, .rate_p = 5.0});
  constexpr int steps = 100;
  std::vector<std::vector<LayerTensor<double>>> path;
  for (int l = 0; l < lanes<NativeBatch>; ++l) path.push_back(random_path(steps, l == 1 ? 1e-5 : 2e-3, 11 + l));
  std::vector<std::size_t> done(path.size(), 0);
  expect_bits_of_lanes(
      law, steps, 1e-3, [&](int l) { return turned(law, 0.3 * l); }, [&](int l) { return path[l][done[l]++]; },
      [](int, const auto&) {});
}

}  // namespace
}  // namespace nugget::kernel
