// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// MAT_076: a Prony series, against its closed forms.
namespace nugget::kernel {
namespace {

constexpr double bulk = 2000.0;

GeneralViscoelastic series() {
  const double shear = 10.0 + 30.0 + 20.0;
  return {.E = 9.0 * bulk * shear / (3.0 * bulk + shear),
          .nu = (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear),
          .bulk = bulk,
          .overstress = {.maxwell_branches = {{10.0, 0.0}, {30.0, 100.0}, {20.0, 5.0}}}};
}

/// Stress of the series after a strain rate of 1 during `t`, over 2: sum of G_i (1 - exp(-b_i t)) / b_i.
double ramp(double t) {
  return 10.0 * t + 30.0 * -std::expm1(-100.0 * t) / 100.0 + 20.0 * -std::expm1(-5.0 * t) / 5.0;
}
double held(double t, double after) {
  return 10.0 * t + 30.0 * -std::expm1(-100.0 * t) / 100.0 * std::exp(-100.0 * after) +
         20.0 * -std::expm1(-5.0 * t) / 5.0 * std::exp(-5.0 * after);
}

// Sabotage: a decay of another term; the volume relaxes; the term without decay left out.
TEST(GeneralViscoelastic, ShearRelaxesByItsSeriesAndTheVolumeDoesNot) {
  for (const double dt : {1e-5, 2e-3}) {  // exact for any step
    SolidPoint<ComposedLaw> p(composed_law({series()}));
    p.dt = dt;
    const int steps = static_cast<int>(std::lround(0.02 / dt));
    for (int i = 0; i < steps; ++i) p.strain({0, 0, 0, 0.5 * dt, 0, 0});
    EXPECT_NEAR(p.s.xy, 0.5 * ramp(0.02), 1e-9);
    for (int i = 0; i < steps; ++i) p.strain({});
    EXPECT_NEAR(p.s.xy, 0.5 * held(0.02, 0.02), 1e-9);
    SolidPoint<ComposedLaw> q(composed_law({series()}));
    q.dt = dt;
    q.strain({1e-6, 1e-6, 1e-6, 0, 0, 0});
    for (int i = 0; i < 100; ++i) q.strain({});
    EXPECT_NEAR(q.s.xx, 3e-6 * bulk, 1e-8);
  }
}

// A layer that is pulled alike in its plane has E / (1 - nu) times the strain, at once by the sum of the moduli, in the
// end by the one that stays.
TEST(GeneralViscoelastic, LayersHaveNoStressThroughTheThickness) {
  const auto biaxial = [](double shear) {
    const double E = 9.0 * bulk * shear / (3.0 * bulk + shear),
                 nu = (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear);
    return E / (1.0 - nu);
  };
  LayerPoint<ComposedLaw> p(composed_law({series()}));
  p.dt = 1e-9;
  p.strain({1e-6, 1e-6, 0, 2e-6, 0});
  EXPECT_NEAR(p.s.xx, 1e-6 * biaxial(60.0), 1e-5 * p.s.xx);
  EXPECT_NEAR(p.s.xz, 2e-6 * 60.0, 1e-5 * p.s.xz);
  p.dt = 0.1;
  for (int i = 0; i < 100; ++i) p.strain({});
  EXPECT_NEAR(p.s.xx, 1e-6 * biaxial(10.0), 1e-5 * p.s.xx);
  EXPECT_NEAR(p.s.xz, 2e-6 * 10.0, 1e-5 * p.s.xz);
}

}  // namespace
}  // namespace nugget::kernel
