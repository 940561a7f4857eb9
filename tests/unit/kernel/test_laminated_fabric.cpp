// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/laminated_fabric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "law_point.hpp"

// Layers with the damage of Matzenmiller, Lubliner and Taylor (MAT_058): each stress against the curve of its mode, the
// coupling of modes, unloading, and what the layer gives back.
namespace nugget::kernel {
namespace {

using Surface = LaminatedFabric::Surface;
using Mode = LaminatedFabric::Mode;

LaminatedFabric fabric(Surface surface) {
  LaminatedFabric l;
  l.young_a = 60e3;
  l.young_b = 20e3;
  l.young_c = 20e3;
  l.poisson_ba = 0.05;
  l.poisson_ca = 0.05;
  l.poisson_cb = 0.3;
  l.shear_ab = 4e3;
  l.shear_bc = 3e3;
  l.shear_ca = 3.5e3;
  l.take_isotropic_constants();
  l.surface = surface;
  l.tension_a = {900.0, 0.018, 1e-8};
  l.compression_a = {600.0, 0.014, 1e-8};
  l.tension_b = {100.0, 0.008, 1e-8};
  l.compression_b = {180.0, 0.02, 1e-8};
  l.shear = {60.0, 0.04, 1e-8};
  return l;
}

LayerPoint<LaminatedFabric> fabric_point(const LaminatedFabric& law, double degrees = 0.0) {
  LayerPoint<LaminatedFabric> p(law);
  p.history[first_axis_field] = std::cos(degrees * std::numbers::pi / 180.0);
  p.history[first_axis_field + 1] = std::sin(degrees * std::numbers::pi / 180.0);
  return p;
}

/// The curve of a mode: E e exp(-(1/(m e)) (E e/X)^m) with m = 1/ln(E ex/X), as Matzenmiller and others have it.
double curve_of(const Mode& mode, double modulus, double strain) {
  const double m = 1.0 / std::log(modulus * mode.strain / mode.strength);
  return modulus * strain * std::exp(-std::pow(modulus * strain / mode.strength, m) / (m * std::numbers::e));
}

// Sabotage: m without its logarithm; the strength at strength/modulus.
TEST(LaminatedFabric, EachStressAloneFollowsItsCurve) {
  for (const Surface surface : {Surface::faceted, Surface::fibre_alone, Surface::quadratic}) {
    const LaminatedFabric law = fabric(surface);
    struct Case {
      const Mode& mode;
      double modulus, sign;
      bool along_a;
    };
    for (const Case& c : {Case{law.tension_a, 60e3, 1.0, true}, Case{law.compression_a, 60e3, -1.0, true},
                          Case{law.tension_b, 20e3, 1.0, false}, Case{law.compression_b, 20e3, -1.0, false}}) {
      // Along b: the axes turned by a right angle.
      auto p = fabric_point(law, c.along_a ? 0.0 : 90.0);
      double strain = 0.0, most = 0.0;
      for (int k = 0; k < 600; ++k) {
        strain += 1e-4;
        p.uniaxial(c.sign * 1e-4);
        ASSERT_NEAR(c.sign * p.s.xx, curve_of(c.mode, c.modulus, strain), 2e-3 * c.mode.strength)
            << c.modulus << strain;
        most = std::max(most, c.sign * p.s.xx);
      }
      EXPECT_NEAR(most, c.mode.strength, 1e-3 * c.mode.strength);
    }
    auto p = fabric_point(law);
    double strain = 0.0;
    for (int k = 0; k < 1500; ++k) {
      strain += 1e-4;
      p.strain({0, 0, 1e-4, 0, 0});
      ASSERT_NEAR(p.s.xy, curve_of(law.shear, 4e3, strain), 1e-9 * 60.0);
    }
    EXPECT_NEAR(curve_of(law.shear, 4e3, 0.04), 60.0, 1e-9);
  }
}

// Back from any strain the layer is a line to 0, and tension does not damage compression.
TEST(LaminatedFabric, UnloadsToTheOrigin) {
  const LaminatedFabric law = fabric(Surface::faceted);
  auto p = fabric_point(law);
  for (int k = 0; k < 250; ++k) p.uniaxial(1e-4);
  const double secant = p.s.xx / 0.025;
  EXPECT_LT(secant, 0.9 * 60e3);
  for (int k = 0; k < 250; ++k) {
    p.uniaxial(-1e-4);
    ASSERT_NEAR(p.s.xx, secant * (0.025 - 1e-4 * (k + 1)), 1e-3 * 900.0);
  }
  double strain = 0.0;
  for (int k = 0; k < 140; ++k) {
    strain += 1e-4;
    p.uniaxial(-1e-4);
    ASSERT_NEAR(-p.s.xx, curve_of(law.compression_a, 60e3, strain), 2e-3 * 600.0);
  }
}

TEST(LaminatedFabric, StressStaysAtItsLimit) {
  for (const double left : {0.3, 1.0}) {
    LaminatedFabric law = fabric(Surface::quadratic);
    for (Mode* mode : {&law.tension_a, &law.compression_b, &law.shear}) mode->left = left;
    auto p = fabric_point(law);
    for (int k = 0; k < 2000; ++k) p.uniaxial(1e-4);
    EXPECT_NEAR(p.s.xx, left * 900.0, 1e-3 * 900.0);
    auto q = fabric_point(law, 90.0);
    for (int k = 0; k < 2000; ++k) q.uniaxial(-1e-4);
    EXPECT_NEAR(q.s.xx, -left * 180.0, 1e-3 * 180.0);
    auto r = fabric_point(law);
    for (int k = 0; k < 4000; ++k) r.strain({0, 0, 1e-4, 0, 0});
    EXPECT_NEAR(r.s.xy, left * 60.0, 1e-9);
  }
}

// In proportion, undamaged stresses b and ab: r is the root of the sum of their squares, and both fall by it.
// Sabotage: FS 0 as -1; the shear of FS 1 by its own alone.
TEST(LaminatedFabric, ShearAndTensionDamageEachOther) {
  const auto k_of = [](const Mode& mode, double modulus, double r) {
    const double m = 1.0 / std::log(modulus * mode.strain / mode.strength);
    return std::exp(-std::pow(r, m) / (m * std::numbers::e));
  };
  for (const Surface surface : {Surface::faceted, Surface::fibre_alone, Surface::quadratic}) {
    LaminatedFabric law = fabric(surface);
    law.poisson_ba = 0.0;
    auto p = fabric_point(law);
    for (int k = 1; k <= 200; ++k) {
      p.strain({5e-5, 3e-5, 1e-4, 0, 0});
      const double a = 60e3 * 5e-5 * k, b = 20e3 * 3e-5 * k, ab = 4e3 * 1e-4 * k, ra = a / 900.0, rb = b / 100.0,
                   rs = ab / 60.0;
      const double together_a = std::hypot(ra, rs), together_b = std::hypot(rb, rs);
      const bool alone = surface == Surface::faceted, all = surface == Surface::quadratic;
      ASSERT_NEAR(p.s.xx, a * k_of(law.tension_a, 60e3, all ? together_a : ra), 1e-9 * 900.0);
      ASSERT_NEAR(p.s.yy, b * k_of(law.tension_b, 20e3, alone ? rb : together_b), 1e-9 * 100.0);
      const double of_shear = alone ? rs : all ? std::max(together_a, together_b) : together_b;
      ASSERT_NEAR(p.s.xy, ab * k_of(law.shear, 4e3, of_shear), 1e-9 * 60.0);
    }
  }
}

TEST(LaminatedFabric, ShearOfFabricsByItsCurve) {
  LaminatedFabric law = fabric(Surface::faceted);
  law.first_shear_stress = 30.0;
  law.first_shear_strain = 0.01;
  law.shear = {60.0, 0.1, 0.8};
  auto p = fabric_point(law);
  double strain = 0.0;
  p.strain({0, 0, 1e-7, 0, 0});
  EXPECT_NEAR(p.s.xy, 4e3 * 1e-7, 1e-6 * 4e3 * 1e-7 * 10);
  p = fabric_point(law);
  for (int k = 0; k < 1400; ++k) {
    strain += 1e-4;
    p.strain({0, 0, -1e-4, 0, 0});
    if (k + 1 < 100) continue;
    if (k < 998) {
      ASSERT_NEAR(p.s.xy, -(30.0 + 30.0 * (strain - 0.01) / 0.09), 1e-9);
    } else if (k > 1000) {
      ASSERT_NEAR(p.s.xy, -0.8 * 60.0, 1e-9);
    }
  }
  const double secant = p.s.xy / -strain;
  p.strain({0, 0, 0.05, 0, 0});
  EXPECT_NEAR(p.s.xy, -secant * (strain - 0.05), 1e-9);
}

// ERODS: the effective strain of pure shear, and of uniaxial strain with a thickness that keeps the volume.
TEST(LaminatedFabric, FailsAtAnEffectiveStrain) {
  LaminatedFabric law = fabric(Surface::faceted);
  const auto at_failure = [&](double erods, const LayerTensor<double>& step) {
    law.failure_strain = erods;
    auto p = fabric_point(law, 30.0);
    int k = 0;
    while (!p.law.failed<double>(p.history.data()) && k < 100000) p.strain(step), ++k;
    return k;
  };
  EXPECT_NEAR(at_failure(0.2, {0, 0, 1e-4, 0, 0}), 2000.0 * std::sqrt(3.0), 2.0);
  EXPECT_NEAR(at_failure(0.2, {1e-4, 0, 0, 0, 0}), 2000.0 * std::sqrt(3.0) / 2.0, 2.0);
  EXPECT_NEAR(at_failure(-0.2, {0, 0, 1e-4, 0, 0}), 2000.0 * std::sqrt(3.0), 2.0);
  // The thickness hardly changes once the stresses are gone: sqrt(2/3 of the deviator) of one strain.
  EXPECT_NEAR(at_failure(-0.2, {1e-4, 0, 0, 0, 0}), 2000.0 * 1.5, 30.0);
  EXPECT_GE(at_failure(0.0, {1e-4, 0, 0, 0, 0}), 100000);
}

// Closed paths of strain give no energy, however large the steps, and stresses stay within the strengths.
TEST(LaminatedFabric, GivesNoEnergy) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> chance(-1.0, 1.0);
  for (const Surface surface : {Surface::faceted, Surface::fibre_alone, Surface::quadratic})
    for (int trial = 0; trial < 100; ++trial) {
      LaminatedFabric law = fabric(surface);
      law.poisson_ba = 0.3 * chance(engine);
      law.take_isotropic_constants();
      auto p = fabric_point(law, 180.0 * chance(engine));
      double work = 0.0;
      std::array<LayerTensor<double>, 4> corner{};
      for (std::size_t i = 1; i < 4; ++i) {
        const double size = std::pow(10.0, -2.0 + chance(engine));
        corner[i] = {size * chance(engine), size * chance(engine), size * chance(engine), 0, 0};
      }
      double most = 0.0;
      for (int lap = 0; lap < 2; ++lap)
        for (std::size_t i = 0; i < 4; ++i) {
          const LayerTensor<double>& to = corner[(i + 1) % 4];
          constexpr int steps = 200;
          const LayerTensor<double> d{(to.xx - corner[i].xx) / steps, (to.yy - corner[i].yy) / steps,
                                      (to.xy - corner[i].xy) / steps, 0, 0};
          for (int k = 0; k < steps; ++k) {
            const LayerTensor<double> before = p.s;
            p.strain(d);
            work += 0.5 * ((before.xx + p.s.xx) * d.xx + (before.yy + p.s.yy) * d.yy + (before.xy + p.s.xy) * d.xy);
            most = std::max({most, std::abs(p.s.xx), std::abs(p.s.yy)});
            ASSERT_TRUE(std::isfinite(p.s.xx + p.s.yy + p.s.xy));
          }
        }
      EXPECT_GE(work, -1e-9) << trial;
      EXPECT_LE(most, 900.0 * 1.7) << trial;
      EXPECT_NEAR(p.s.xx, 0.0, 1e-6) << trial;
      EXPECT_NEAR(p.s.xy, 0.0, 1e-6) << trial;
    }
}

// Turned with its axes, the same stresses. Sabotage: engineering shears turned as tensorial ones.
TEST(LaminatedFabric, TurnedAxesTurnTheStresses) {
  const LaminatedFabric law = fabric(Surface::quadratic);
  const double c = std::cos(0.7), s = std::sin(0.7);
  auto p = fabric_point(law), q = fabric_point(law, 0.7 * 180.0 / std::numbers::pi);
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> chance(-1e-3, 1e-3);
  for (int k = 0; k < 300; ++k) {
    const double xx = 2e-5 + chance(engine), yy = chance(engine), xy = 1e-4 + chance(engine);
    p.strain({xx, yy, xy, 1e-4, 0});
    q.strain({c * c * xx + s * s * yy - c * s * xy, s * s * xx + c * c * yy + c * s * xy,
              2.0 * c * s * (xx - yy) + (c * c - s * s) * xy, c * 1e-4, s * 1e-4});
    ASSERT_NEAR(q.s.xx, c * c * p.s.xx + s * s * p.s.yy - 2.0 * c * s * p.s.xy, 1e-9 * 900.0);
    ASSERT_NEAR(q.s.xy, c * s * (p.s.xx - p.s.yy) + (c * c - s * s) * p.s.xy, 1e-9 * 900.0);
    ASSERT_NEAR(q.s.xz, c * p.s.xz, 1e-9);
  }
}

// Beside a deleted element: the same curve, smaller in both directions.
TEST(LaminatedFabric, SoftLowersStrengths) {
  LaminatedFabric law = fabric(Surface::faceted);
  law.soft = 0.5;
  auto p = fabric_point(law);
  p.history[at(p.law.crash_front_field())] = 1.0;
  double most = 0.0;
  for (int k = 0; k < 400; ++k) {
    p.uniaxial(1e-4);
    most = std::max(most, p.s.xx);
  }
  EXPECT_NEAR(most, 450.0, 0.5);
}

// A batch gives bit for bit what its lanes give alone.
TEST(LaminatedFabric, BatchesGiveTheBitsOfTheirLanes) {
  for (const Surface surface : {Surface::faceted, Surface::fibre_alone, Surface::quadratic}) {
    LaminatedFabric law = fabric(surface);
    law.failure_strain = 0.3;
    law.first_shear_stress = 30.0;
    law.first_shear_strain = 0.01;
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> chance(-1e-2, 1e-2);
    const auto increment = [&](int l) {
      const double size = l % 2 == 0 ? 1.0 : 0.01;
      return LayerTensor<double>{size * chance(engine), size * chance(engine), size * chance(engine),
                                 size * chance(engine), size * chance(engine)};
    };
    int failed = 0;
    expect_bits_of_lanes(
        law, 400, 1e-3, [&](int l) { return fabric_point(law, 17.0 * l); }, increment,
        [&](int, const auto& p) { failed += p.law.template failed<double>(p.history.data()); });
    EXPECT_GT(failed, 0);
  }
}

}  // namespace
}  // namespace nugget::kernel
