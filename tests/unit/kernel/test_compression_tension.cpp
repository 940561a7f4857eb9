// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// MAT_124: another yield curve in compression than in tension.
namespace nugget::kernel {
namespace {

CompressionTension plastic(double full_compression = 0.0, double full_tension = 0.0) {
  return {.E = 2000.0,
          .nu = 0.35,
          .compression = {0, {0.0, 0.5}, {60.0, 110.0}},
          .tension = {0, {0.0, 0.5}, {40.0, 50.0}},
          .full_compression = full_compression,
          .full_tension = full_tension};
}

template <class Point>
double yield(const CompressionTension& law, double strain) {
  Point p(composed_law({law}));
  p.dt = 1e-3;
  for (int i = 0; i < 1000; ++i) p.uniaxial(strain / 1000.0);
  return p.s.xx;
}

// A bar that is pulled has the curve of tension, one that is pressed that of compression: sigma = Y(e - sigma / E).
// Sabotage: the curves exchanged; the share of tension for that of compression.
TEST(CompressionTension, ABarHasTheCurveOfItsSide) {
  const double tension = (40.0 + 20.0 * 0.3) / (1.0 + 20.0 / 2000.0), pressed = (60.0 + 30.0) / (1.0 + 100.0 / 2000.0);
  EXPECT_NEAR(yield<SolidPoint<ComposedLaw>>(plastic(), 0.3), tension, 1e-6 * tension);
  EXPECT_NEAR(yield<LayerPoint<ComposedLaw>>(plastic(), 0.3), tension, 1e-4 * tension);
  EXPECT_NEAR(yield<SolidPoint<ComposedLaw>>(plastic(), -0.3), -pressed, 1e-6 * pressed);
  EXPECT_NEAR(yield<LayerPoint<ComposedLaw>>(plastic(), -0.3), -pressed, 1e-4 * pressed);
}

// Between PC and PT the curves are weighted: shear without pressure, by PT / (PC + PT), whose effective stress is
// sqrt(3) tau; pressed by p besides, by (p + PT) / (PC + PT), a solid keeps p.
TEST(CompressionTension, ThePressureWeightsTheCurves) {
  for (const auto& [pc, pt, p0, share] :
       {std::array{0.0, 0.0, 0.0, 0.5}, std::array{30.0, 10.0, 0.0, 0.25}, std::array{30.0, 10.0, 10.0, 0.5},
        std::array{30.0, 10.0, 40.0, 1.0}, std::array{30.0, 10.0, -40.0, 0.0}}) {
    SolidPoint<ComposedLaw> p(composed_law({plastic(pc, pt)}));
    p.dt = 1e-3;
    const double bulk = 2000.0 / (3.0 * 0.3), volume = -p0 / bulk / 3.0;
    p.strain({volume, volume, volume, 0, 0, 0});
    for (int i = 0; i < 500; ++i) p.strain({0, 0, 0, 1e-3, 0, 0});
    const double e = p.plastic_strain(), expected = share * (60.0 + 100.0 * e) + (1.0 - share) * (40.0 + 20.0 * e);
    EXPECT_GT(e, 0.2);
    EXPECT_NEAR(p.effective(), expected, 1e-6 * expected) << pc << ' ' << p0;
    EXPECT_NEAR((p.s.xx + p.s.yy + p.s.zz) / -3.0, p0, 1e-9);
  }
}

// Factors over the rate of the plastic strain, one of each side, or C and P of both. Sabotage: the factor of the other
// side; the rates of one scale only.
TEST(CompressionTension, TheRateRaisesEachSideByItsOwn) {
  CompressionTension law = plastic();
  law.compression = {0, {0.0, 1.0}, {60.0, 60.0}};
  law.tension = {0, {0.0, 1.0}, {40.0, 40.0}};
  law.compression_scale = {0, {0.0, 1.0, 3.0}, {1.0, 1.2, 2.0}};
  law.tension_scale = {0, {0.0, 0.5, 2.0}, {1.0, 1.1, 1.7}};
  const auto flowing = [&](double rate) {  // 2000 steps, the last of which have the plastic strain grow at `rate`
    SolidPoint<ComposedLaw> p(composed_law({law}));
    p.dt = 1e-4;
    for (int i = 0; i < 2000; ++i) p.uniaxial(rate * p.dt);
    return p.s.xx;
  };
  EXPECT_NEAR(flowing(2.0), 40.0 * 1.7, 1e-3);
  EXPECT_NEAR(flowing(1.0), 40.0 * 1.3, 1e-3);
  EXPECT_NEAR(flowing(-2.0), -60.0 * 1.6, 1e-3);
  EXPECT_NEAR(flowing(-0.5), -60.0 * 1.1, 1e-3);
  law.tension_scale = {};
  EXPECT_NEAR(flowing(1.0), 40.0, 1e-3);
  law.compression_scale = {};
  law.rate_c = 8.0;
  law.rate_p = 2.0;
  EXPECT_NEAR(flowing(2.0), 40.0 * 1.5, 1e-3);
  EXPECT_NEAR(flowing(-2.0), -60.0 * 1.5, 1e-3);
}

TEST(CompressionTension, AFibreKnowsItsSide) {
  for (const double side : {1.0, -1.0}) {
    LawKernel<ComposedLaw> law(composed_law({plastic()}));
    std::vector<double> history(128);
    StateInAllLanes lanes(history);
    FibreTensor<NativeBatch> s{};
    const auto rate = in_all_lanes(FibreTensor<double>{side * 0.3, 0, 0});
    for (int i = 0; i < 1000; ++i) law.fibre(s, rate, 1e-3, lanes.data());
    const double expected =
        side > 0.0 ? (40.0 + 20.0 * 0.3) / (1.0 + 20.0 / 2000.0) : -(60.0 + 30.0) / (1.0 + 100.0 / 2000.0);
    EXPECT_NEAR(lane(s.rr, 0), expected, 1e-6 * std::abs(expected));
  }
}

TEST(CompressionTension, FailsAtItsPlasticStrain) {
  CompressionTension law = plastic();
  law.failure_strain = 0.1;
  SolidPoint<ComposedLaw> p(composed_law(components_of(law)));
  for (int i = 0; i < 200; ++i) p.uniaxial(1e-3);
  EXPECT_EQ(p.s.xx, 0.0);
}

}  // namespace
}  // namespace nugget::kernel
