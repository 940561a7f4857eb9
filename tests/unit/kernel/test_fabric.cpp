// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/fabric.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "driven_shell.hpp"
#include "kernel/element/membrane.hpp"
#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

namespace nugget::kernel {
namespace {

constexpr double young_a = 400.0, young_b = 250.0, poisson_ba = 0.2, shear = 20.0;

Fabric woven(bool no_compression = false) {
  Fabric law;
  law.young_a = young_a;
  law.young_b = young_b;
  law.poisson_ba = poisson_ba;
  law.shear_ab = shear;
  law.no_compression = no_compression;
  law.nu = 0.2;
  law.E = law.wave_modulus() * (1.0 - law.nu * law.nu);
  return law;
}

/// A point whose axis a stands at an angle to the element's x [rad].
LayerPoint<Fabric> point(const Fabric& law, double angle) {
  LayerPoint<Fabric> p(law);
  start_layer_axes(p.history.data(), 1, std::cos(angle), std::sin(angle));
  return p;
}

/// Strain along x, and the lateral strain and shear that leave the other stresses 0, by linear elasticity.
double modulus_along_x(LayerPoint<Fabric> p) {
  // Three unit strains give the stiffness; the stress along x alone is what its inverse asks for.
  double k[3][3];
  for (int j = 0; j < 3; ++j) {
    LayerPoint<Fabric> one = p;
    one.strain({j == 0 ? 1e-6 : 0.0, j == 1 ? 1e-6 : 0.0, j == 2 ? 1e-6 : 0.0, 0, 0});
    k[0][j] = one.s.xx / 1e-6, k[1][j] = one.s.yy / 1e-6, k[2][j] = one.s.xy / 1e-6;
  }
  const double minor = k[1][1] * k[2][2] - k[1][2] * k[2][1];
  const double determinant = k[0][0] * minor - k[0][1] * (k[1][0] * k[2][2] - k[1][2] * k[2][0]) +
                             k[0][2] * (k[1][0] * k[2][1] - k[1][1] * k[2][0]);
  return determinant / minor;
}

// S.W. Tsai and H.T. Hahn, Introduction to Composite Materials (1980): 1/E = c^4/EA + s^4/EB + c^2 s^2 (1/G - 2 nu/E).
// Sabotage: the angle the other way round with EA for EB, tensorial for engineering shear, PRBA over EA.
TEST(Fabric, ModulusAtAnAngleToTheThreads) {
  for (const double angle : {0.0, 0.3, M_PI / 4, 1.2, M_PI / 2}) {
    const double cc = std::cos(angle) * std::cos(angle), ss = 1.0 - cc;
    const double compliance =
        cc * cc / young_a + ss * ss / young_b + cc * ss * (1.0 / shear - 2.0 * poisson_ba / young_b);
    EXPECT_NEAR(modulus_along_x(point(woven(), angle)) * compliance, 1.0, 1e-9) << angle;
  }
}

// Sabotage: the stress increment clipped in the place of the stress, so that the way back stretches.
TEST(Fabric, NoStressUnderCompressionAndTheSameOnTheWayBack) {
  for (const double angle : {0.0, 0.7}) {
    LayerPoint<Fabric> p = point(woven(true), angle), taut = point(woven(), angle);
    for (int i = 0; i < 50; ++i) p.strain({-1e-3, -2e-3, 5e-4, 0, 0});
    EXPECT_NEAR(std::abs(p.s.xx) + std::abs(p.s.yy) + std::abs(p.s.xy), 0.0, 1e-12);
    for (int i = 0; i < 50; ++i) p.strain({1e-3, 2e-3, -5e-4, 0, 0});
    p.strain({0.01, 0.01, 0, 0, 0});
    taut.strain({0.01, 0.01, 0, 0, 0});
    EXPECT_NEAR(p.s.xx, taut.s.xx, 1e-9);
    EXPECT_NEAR(p.s.yy, taut.s.yy, 1e-9);
    EXPECT_NEAR(p.s.xy, taut.s.xy, 1e-9);
  }
}

// Pulled along a thread, pushed together across it by more than Poisson's ratio: EA times the strain, whatever the
// push.
TEST(Fabric, WrinklesAcrossAThreadLeaveTheThread) {
  for (const double push : {0.01, 0.05, 0.3}) {
    LayerPoint<Fabric> p = point(woven(true), 0.0);
    p.strain({0.01, -push, 0, 0, 0});
    EXPECT_NEAR(p.s.xx, 0.01 * young_a, 1e-9);
    EXPECT_NEAR(p.s.yy, 0.0, 1e-9);
    EXPECT_NEAR(p.s.xy, 0.0, 1e-9);
  }
}

/// Least elastic energy over all waves, beta n n with beta >= 0, by trial: over directions, with the best beta of each.
/// Where no strain is above 0, waves in two directions take all of it up.
double relaxed_energy(const SheetModuli& m, const AxesTensor& e) {
  if (0.5 * (e.a + e.b) + std::hypot(0.5 * (e.a - e.b), 0.5 * e.ab) <= 0.0) return 0.0;
  const auto energy = [&](const AxesTensor& strain) {
    const AxesTensor s = m.times(strain);
    return 0.5 * (s.a * strain.a + s.b * strain.b + s.ab * strain.ab);
  };
  double least = energy(e);
  constexpr int directions = 200000;
  for (int i = 0; i < directions; ++i) {
    const double c = std::cos(M_PI * i / directions), s = std::sin(M_PI * i / directions);
    const AxesTensor wave{c * c, s * s, 2.0 * c * s}, own = m.times(wave);
    const double slope = own.a * e.a + own.b * e.b + own.ab * e.ab;
    const double beta = std::max(0.0, -slope / (own.a * wave.a + own.b * wave.b + own.ab * wave.ab));
    least = std::min(least, energy({e.a + beta * wave.a, e.b + beta * wave.b, e.ab + beta * wave.ab}));
  }
  return least;
}

// The stress is the derivative of Pipkin's relaxed energy, here found by trial; its principal values are not below 0.
TEST(Fabric, WrinkledStressIsThatOfTheRelaxedEnergy) {
  const SheetModuli m{420.0, 260.0, 50.0, 20.0};
  Random random;
  int wrinkled = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const AxesTensor e{0.02 * random() + 0.01, 0.02 * random() - 0.005, 0.04 * random()};
    const AxesTensor s = Wrinkling(m).stress(e);
    const AxesTensor elastic = m.times(e);
    wrinkled += std::abs(s.a - elastic.a) > 1e-6 && s.a + s.b > 1e-6;
    EXPECT_GT(0.5 * (s.a + s.b) - std::hypot(0.5 * (s.a - s.b), s.ab), -1e-9);
    constexpr double h = 1e-4;
    const auto slope = [&](const AxesTensor& d) {
      return (relaxed_energy(m, {e.a + h * d.a, e.b + h * d.b, e.ab + h * d.ab}) -
              relaxed_energy(m, {e.a - h * d.a, e.b - h * d.b, e.ab - h * d.ab})) /
             (2.0 * h);
    };
    EXPECT_NEAR(s.a, slope({1, 0, 0}), 0.01) << trial;
    EXPECT_NEAR(s.b, slope({0, 1, 0}), 0.01) << trial;
    EXPECT_NEAR(s.ab, slope({0, 0, 1}), 0.01) << trial;
  }
  EXPECT_GE(wrinkled, 4);
}

// Of many strains and moduli: the stress is a tension along one direction, and no waves would save more. Sabotage: any
// direction but the best.
TEST(Fabric, WrinklesAreTheBest) {
  Random random;
  int wrinkled = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const double aa = 100.0 * std::pow(10.0, random()), bb = 100.0 * std::pow(10.0, random()),
                 ab = 0.9 * random() * std::sqrt(aa * bb), g = 100.0 * std::pow(10.0, 2.0 * random());
    const SheetModuli m{aa, bb, ab, g};
    const AxesTensor e{0.02 * random(), 0.02 * random(), 0.03 * random()}, s = Wrinkling(m).stress(e);
    const AxesTensor elastic = m.times(e);
    const double size = std::abs(elastic.a) + std::abs(elastic.b) + std::abs(elastic.ab);
    EXPECT_GE(s.a, 0.0) << trial;
    if (s.a == elastic.a || s.a + s.b < 1e-9 * size) continue;
    ++wrinkled;
    EXPECT_NEAR(s.a * s.b, s.ab * s.ab, 1e-11 * size * size) << trial;
    // What the waves take up, from the compliance, is beta n n: across the tension, and of no shear with it.
    const double over = 1.0 / (aa * bb - ab * ab), tension = s.a + s.b, nb = s.a / tension, na = s.b / tension,
                 nab = -s.ab / tension;
    const AxesTensor left{over * (bb * s.a - ab * s.b), over * (aa * s.b - ab * s.a), s.ab / g};
    const double beta = (left.a - e.a) + (left.b - e.b);
    EXPECT_GT(beta, 0.0) << trial;
    EXPECT_NEAR(left.a - e.a, beta * na, 1e-9) << trial;
    EXPECT_NEAR(left.b - e.b, beta * nb, 1e-9) << trial;
    EXPECT_NEAR(left.ab - e.ab, 2.0 * beta * nab, 1e-9) << trial;
  }
  EXPECT_GT(wrinkled, 1000);
}

// A tenth of the thickness is liner: it carries compression, the fabric does not.
TEST(Fabric, LinerCarriesCompression) {
  Fabric law = woven(true);
  law.liner_young = 60.0;
  law.liner_poisson = 0.3;
  law.liner_share = 0.1;
  LayerPoint<Fabric> p = point(law, 0.4);
  p.strain({-0.01, -0.01, 0, 0, 0});
  EXPECT_NEAR(p.s.xx, 0.1 * 60.0 / 0.7 * -0.01, 1e-12);
  EXPECT_NEAR(p.s.yy, 0.1 * 60.0 / 0.7 * -0.01, 1e-12);
  p = point(law, 0.0);
  p.strain({0.02, 0.02, 0, 0, 0});
  const double plane = 1.0 - poisson_ba * poisson_ba * young_a / young_b;
  EXPECT_NEAR(p.s.xx, 0.02 * (0.1 * 60.0 / 0.7 + 0.9 * young_a * (1.0 + poisson_ba) / plane), 1e-9);
}

TEST(Fabric, DampingIsAShareOfTheChangeOfStress) {
  Fabric law = woven();
  law.damping = 0.05;
  LayerPoint<Fabric> p = point(law, 0.4), undamped = point(woven(), 0.4);
  double before = 0.0;
  for (int i = 0; i < 3; ++i) {
    p.strain({0.01 * i, 0.003, -0.002, 0, 0});
    undamped.strain({0.01 * i, 0.003, -0.002, 0, 0});
    EXPECT_NEAR(p.s.xx, undamped.s.xx + 0.05 * (undamped.s.xx - before), 1e-12);
    before = undamped.s.xx;
  }
  EXPECT_NEAR(p.law.step_share(), 1.0 / std::sqrt(1.1), 1e-15);
}

// Isotropic: E / (1 - nu^2). Soft in shear along the threads: the fastest goes along one; stiff in shear: between them.
TEST(Fabric, FastestWave) {
  Fabric law = woven();
  law.young_b = law.young_a;
  law.shear_ab = young_a / (2.0 * (1.0 + poisson_ba));
  EXPECT_NEAR(law.wave_modulus(), young_a / (1.0 - poisson_ba * poisson_ba), 1e-9);
  law.poisson_ba = 0.0;
  law.shear_ab = 20.0;
  EXPECT_NEAR(law.wave_modulus(), young_a, 1e-9);
  law.shear_ab = 1.5 * young_a;
  EXPECT_NEAR(law.wave_modulus(), 0.5 * young_a + law.shear_ab, 1e-9);
}

struct OnePointFabric : OnePoint {
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state) {
    return membrane_cycle<R>(shell, law, nodes, dt, state);
  }
};

TEST(Fabric, BatchGivesTheBitsOfEachAlone) {
  constexpr int W = native_width;
  Fabric law = woven(true);
  law.liner_young = 60.0;
  law.liner_share = 0.1;
  law.damping = 0.1;
  const LawKernel<Fabric> kernel(law);
  const auto size = static_cast<std::size_t>(kernel.layer_history());
  std::vector<double> together(size * W);
  std::vector<LayerPoint<Fabric>> alone;
  LayerTensor<NativeBatch> s{};
  Random random;
  for (int l = 0; l < W; ++l) {
    alone.push_back(point(law, 0.3 * l));
    start_layer_axes(together.data() + l, W, std::cos(0.3 * l), std::sin(0.3 * l));
  }
  for (int cycle = 0; cycle < 200; ++cycle) {
    LayerTensor<NativeBatch> rate{};
    for (int l = 0; l < W; ++l) {
      const LayerTensor<double> d{0.01 * random(), 0.01 * random(), 0.01 * random(), 0, 0};
      alone[static_cast<std::size_t>(l)].strain(d);
      set_lane(rate.xx, l, d.xx);
      set_lane(rate.yy, l, d.yy);
      set_lane(rate.xy, l, d.xy);
    }
    kernel.layer<NativeBatch>(s, rate, 1.0, together.data());
    for (int l = 0; l < W; ++l) {
      ASSERT_EQ(lane(s.xx, l), alone[static_cast<std::size_t>(l)].s.xx);
      ASSERT_EQ(lane(s.yy, l), alone[static_cast<std::size_t>(l)].s.yy);
      ASSERT_EQ(lane(s.xy, l), alone[static_cast<std::size_t>(l)].s.xy);
    }
  }
}

// A viscous stress asks for a shorter step: L/c over the root of 1 + 2 DAMP.
TEST(Fabric, StepOfAMembrane) {
  Fabric law = woven();
  law.damping = 0.5;
  const double c = std::sqrt(law.wave_modulus() / steel_density);
  Driven<ComposedLaw, OnePointFabric> d(section(1), composed_law({law}), square());
  EXPECT_NEAR(d.step(0.0).stable_step, 5.0 / c / std::sqrt(2.0), 1e-6 * 5.0 / c);
}

}  // namespace
}  // namespace nugget::kernel
