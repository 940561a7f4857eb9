// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/yld2000.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "kernel/law/anisotropic_sheet.hpp"
#include "kernel/law/piecewise_linear_kernel.hpp"
#include "law_point.hpp"

// Yld2000-2d (MAT_133): the surface against the paper's matrices and principal values, its derivatives against
// differences, published constants against the tests that they are of, and the return to it.
namespace nugget::kernel {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// 2090-T3 with the exponent 8, as F. Barlat and others (2003) have it: constants, and what they were made of.
const Yld2000 aluminium{.m = 8.0, .alpha = {0.4865, 1.3783, 0.7536, 1.0246, 1.0363, 0.9036, 1.2321, 1.4858}};
const std::array<double, 3> strengths{1.0, 0.8114, 0.9102}, lankford{0.2115, 1.5769, 0.6923};
constexpr double biaxial_strength = 1.0350, biaxial_ratio = 0.670;

/// The effective stress by principal values of L' s and L'' s, the matrices as they are printed.
double effective_of(const Yld2000& law, double aa, double bb, double ab) {
  const std::array<double, 8>& a = law.alpha;
  struct InPlane {
    double first, second;
  };
  const auto principal = [](double x, double y, double xy) {
    const double middle = 0.5 * (x + y), radius = std::hypot(0.5 * (x - y), xy);
    return InPlane{middle + radius, middle - radius};
  };
  const InPlane x =
      principal(2.0 / 3.0 * a[0] * aa - a[0] / 3.0 * bb, -a[1] / 3.0 * aa + 2.0 / 3.0 * a[1] * bb, a[6] * ab);
  const double l11 = (-2 * a[2] + 2 * a[3] + 8 * a[4] - 2 * a[5]) / 9,
               l12 = (a[2] - 4 * a[3] - 4 * a[4] + 4 * a[5]) / 9, l21 = (4 * a[2] - 4 * a[3] - 4 * a[4] + a[5]) / 9,
               l22 = (-2 * a[2] + 8 * a[3] + 2 * a[4] - 2 * a[5]) / 9;
  const InPlane z = principal(l11 * aa + l12 * bb, l21 * aa + l22 * bb, a[7] * ab);
  const double sum = std::pow(std::abs(x.first - x.second), law.m) + std::pow(std::abs(2 * z.second + z.first), law.m) +
                     std::pow(std::abs(2 * z.first + z.second), law.m);
  return std::pow(0.5 * sum, 1.0 / law.m);
}

Yld2000Sheet yld_sheet(const Yld2000& surface, const SheetFormula& hardening) {
  return {.E = 70000.0, .nu = 0.33, .surface = surface, .hardening = hardening, .axes = {}};
}

LayerPoint<Yld2000Sheet> yld_point(const Yld2000Sheet& law, double angle) {
  LayerPoint<Yld2000Sheet> point(law);
  point.history[first_axis_field] = std::cos(angle);
  point.history[first_axis_field + 1] = std::sin(angle);
  return point;
}

TEST(Yld2000, IsThePapersSurface) {
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  for (int trial = 0; trial < 500; ++trial) {
    Yld2000 law{.m = trial % 3 == 0 ? 2.0 : trial % 3 == 1 ? 8.0 : 6.3};
    for (double& alpha : law.alpha) alpha = 1.0 + 0.4 * chance(engine);
    const Yld2000Surface surface(law);
    const double size = std::pow(10.0, 3.0 * chance(engine));
    const PlaneStress<double> s{size * chance(engine), size * chance(engine), size * chance(engine)};
    const SurfaceAt<double> at = surface(s);
    ASSERT_NEAR(at.effective, effective_of(law, s.aa, s.bb, s.ab), 1e-12 * size);
    ASSERT_NEAR(s.aa * at.flow.aa + s.bb * at.flow.bb + s.ab * at.flow.ab, at.effective, 1e-12 * size);
    const double h = 1e-5 * size;
    const std::array<PlaneStress<double>, 3> along{{{h, 0, 0}, {0, h, 0}, {0, 0, h}}};
    const double curvature[3][3] = {
        {at.aa_aa, at.aa_bb, at.aa_ab}, {at.aa_bb, at.bb_bb, at.bb_ab}, {at.aa_ab, at.bb_ab, at.ab_ab}};
    const double flow[3] = {at.flow.aa, at.flow.bb, at.flow.ab};
    for (std::size_t i = 0; i < 3; ++i) {
      const PlaneStress<double>& d = along[i];
      const auto up = surface(PlaneStress<double>{s.aa + d.aa, s.bb + d.bb, s.ab + d.ab}),
                 down = surface(PlaneStress<double>{s.aa - d.aa, s.bb - d.bb, s.ab - d.ab});
      ASSERT_NEAR(flow[i], (up.effective - down.effective) / (2.0 * h), 1e-6);
      ASSERT_NEAR(curvature[i][0] * size, (up.flow.aa - down.flow.aa) / (2.0 * h) * size, 2e-3) << trial;
      ASSERT_NEAR(curvature[i][1] * size, (up.flow.bb - down.flow.bb) / (2.0 * h) * size, 2e-3) << trial;
      ASSERT_NEAR(curvature[i][2] * size, (up.flow.ab - down.flow.ab) / (2.0 * h) * size, 2e-3) << trial;
    }
  }
}

// Published constants give the published tests, and the tests the constants, to the digits that are printed.
// Sabotage: alpha7 and alpha8 exchanged; L'' transposed.
TEST(Yld2000, ConstantsOfAnAluminium) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(aluminium.stress(45.0 * degree * static_cast<double>(i)), strengths[i], 1e-3) << i;
    EXPECT_NEAR(aluminium.ratio(45.0 * degree * static_cast<double>(i)), lankford[i], 5e-3) << i;
  }
  const auto both = Yld2000Surface(aluminium)(PlaneStress<double>{1.0, 1.0, 0.0});
  EXPECT_NEAR(1.0 / both.effective, biaxial_strength, 1e-3);
  EXPECT_NEAR(both.flow.bb / both.flow.aa, biaxial_ratio, 5e-3);
  const SheetTests tests{.stress = strengths,
                         .ratio = lankford,
                         .point = {biaxial_strength, biaxial_strength, 0.0},
                         .tangent = {-biaxial_ratio, 1.0, 0.0}};
  const auto found = Yld2000::from_tests(8.0, tests);
  ASSERT_TRUE(found);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(found->alpha[k], aluminium.alpha[k], 5e-3) << k;
  EXPECT_NEAR(found->ratio(0.0), lankford[0], 1e-8);
  EXPECT_NEAR(found->stress(45.0 * degree), strengths[1], 1e-8);
  SheetTests none = tests;
  none.stress = {1.0, 1e-3, 1e3};
  EXPECT_FALSE(Yld2000::from_tests(8.0, none));
}

// Tension at an angle: strength and Lankford ratio of the surface, hardening by the effective plastic strain, which
// does the same work. By Newton's method on differences for the strains across.
TEST(Yld2000, TensionAtAnAngle) {
  const SheetFormula swift{.factor = 500.0, .exponent = 0.25, .start_strain = 0.01};
  for (const double angle : {0.0, 20.0, 45.0, 70.0, 90.0}) {
    auto point = yld_point(yld_sheet(aluminium, swift), -angle * degree);
    double across = 0.0, along = 0.0, work = 0.0, of_hardening = 0.0;
    for (int k = 0; k < 100; ++k) {
      double lateral = -0.5e-3, shear = 0.0;
      const auto after = [&](double b, double c) {
        auto copy = point;
        copy.strain({1e-3, b, c, 0, 0});
        return copy.s;
      };
      for (int i = 0; i < 40; ++i) {
        const LayerTensor<double> s = after(lateral, shear);
        if (std::abs(s.yy) + std::abs(s.xy) < 1e-8) break;
        const LayerTensor<double> b = after(lateral + 1e-7, shear), c = after(lateral, shear + 1e-7);
        const double byy = b.yy - s.yy, bxy = b.xy - s.xy, cyy = c.yy - s.yy, cxy = c.xy - s.xy;
        const double over = 1e-7 / (byy * cxy - cyy * bxy);
        lateral -= over * (cxy * s.yy - cyy * s.xy);
        shear -= over * (byy * s.xy - bxy * s.yy);
      }
      const double before = point.s.xx, strain = point.plastic_strain();
      point.strain({1e-3, lateral, shear, 0, 0});
      const double elastic = (point.s.xx - before) / 70000.0;
      along += 1e-3 - elastic;
      across += lateral + 0.33 * elastic;
      work += point.s.xx * (1e-3 - elastic);
      of_hardening += 500.0 * std::pow(0.01 + point.plastic_strain(), 0.25) * (point.plastic_strain() - strain);
    }
    const double p = point.plastic_strain(), yield = 500.0 * std::pow(0.01 + p, 0.25);
    EXPECT_NEAR(point.s.xx, yield * aluminium.stress(angle * degree), 1e-3) << angle;
    EXPECT_NEAR(across / -(along + across), aluminium.ratio(angle * degree), 2e-3) << angle;
    EXPECT_NEAR(work, of_hardening, 1e-6 * work) << angle;
  }
}

TEST(Yld2000, IsVonMisesWhereExponentAndConstantsSaySo) {
  PiecewiseLinear steel;
  steel.E = 210000.0;
  steel.nu = 0.3;
  steel.yield = {Curve{1, {0.0, 0.1, 1.0}, {300.0, 400.0, 600.0}}};
  Yld2000Sheet law{.E = 210000.0, .nu = 0.3, .surface = {.m = 2.0}, .hardening = steel, .axes = {}};
  auto ours = yld_point(law, 0.7);
  LayerPoint<PiecewiseLinear> theirs(steel);
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> chance(-2e-3, 2e-3);
  for (int k = 0; k < 300; ++k) {
    const LayerTensor<double> d{chance(engine), chance(engine), chance(engine), 0, 0};
    ours.strain(d);
    theirs.strain(d);
    ASSERT_NEAR(ours.s.xx, theirs.s.xx, 1e-6);
    ASSERT_NEAR(ours.s.xy, theirs.s.xy, 1e-6);
    ASSERT_NEAR(ours.plastic_strain(), theirs.plastic_strain(), 1e-9);
    ASSERT_NEAR(ours.thickness.total, theirs.thickness.total, 1e-9);
  }
}

TEST(Yld2000, ReturnsFromAfar) {
  std::mt19937 engine(6);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  for (int trial = 0; trial < 3000; ++trial) {
    const double yield = trial % 2 == 0 ? 200.0 : 1e-3;
    Yld2000 surface = aluminium;
    if (trial % 3 == 0)
      for (double& alpha : surface.alpha) alpha = 1.0 + 0.5 * chance(engine);
    surface.m = trial % 5 == 0 ? 2.0 : 8.0;
    const Yld2000Sheet law = yld_sheet(surface, SheetFormula{.offset = yield, .factor = 0.5 * yield});
    auto p = yld_point(law, 3.0 * chance(engine));
    double before = 0.0, size = 0.0;
    for (int k = 0; k < 3; ++k) {
      before = p.plastic_strain();
      size = std::pow(10.0, -2.0 + 2.0 * chance(engine));
      p.strain({size * chance(engine), size * chance(engine), size * chance(engine), 0, 0});
    }
    if (p.plastic_strain() == before) continue;
    const double c = p.history[first_axis_field], s = p.history[first_axis_field + 1];
    const double aa = c * c * p.s.xx + s * s * p.s.yy + 2 * c * s * p.s.xy,
                 bb = s * s * p.s.xx + c * c * p.s.yy - 2 * c * s * p.s.xy,
                 ab = c * s * (p.s.yy - p.s.xx) + (c * c - s * s) * p.s.xy;
    const double now = yield + 0.5 * yield * p.plastic_strain();
    ASSERT_NEAR(effective_of(surface, aa, bb, ab), now, 1e-8 * now + 1e-15 * 70000.0 * size) << trial;
  }
}

// A batch gives bit for bit what its lanes give alone.
TEST(Yld2000, BatchesGiveTheBitsOfTheirLanes) {
  const Yld2000Sheet law = yld_sheet(aluminium, {.factor = 500.0, .exponent = 0.25, .start_strain = 0.01});
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> chance(-4e-3, 4e-3);
  const auto increment = [&](int l) {
    const double size = l == 1 ? 1e-3 : 1.0;
    return LayerTensor<double>{size * chance(engine), size * chance(engine), size * chance(engine), 0, 0};
  };
  double strain = 0.0;
  expect_bits_of_lanes(
      law, 300, 1.0, [&](int l) { return yld_point(law, 17.0 * degree * l); }, increment,
      [&](int l, const auto& p) { strain = l == 0 ? p.plastic_strain() : strain; });
  EXPECT_GT(strain, 0.05);
}

}  // namespace
}  // namespace nugget::kernel
