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

CompressionTension two_moduli(double compression, double soft_compression = 0.0, double soft_tension = 0.0,
                              double pc = 0.0, double pt = 0.0) {
  CompressionTension law = plastic(pc, pt);
  law.E = std::max(2000.0, compression);
  law.tension_share = 2000.0 / law.E;
  law.compression_share = compression / law.E;
  law.soft_compression = soft_compression;
  law.soft_tension = soft_tension;
  return law;
}

/// The stress of a bar at each of these strains, one after the other.
template <class Point>
std::vector<double> pulled(const CompressionTension& law, const std::vector<double>& strains) {
  Point p(composed_law({law}));
  p.dt = 1e-3;
  std::vector<double> stress;
  double now = 0.0;
  for (const double strain : strains) {
    for (int i = 0; i < 4000; ++i) p.uniaxial((strain - now) / 4000.0);
    now = strain;
    stress.push_back(p.s.xx);
  }
  return stress;
}

// EC without RPCT: the sign of the pressure decides. Pulled, let go, pressed, and pressed until it flows, where
// sigma = -(60 + 100 (e - sigma / EC)). EC above and below E. Sabotage: EC for both; yield stresses that go with it.
TEST(CompressionTension, AnotherModulusInCompression) {
  for (const double ec : {3000.0, 1000.0}) {
    const double pressed = (60.0 + 100.0 * 0.3) / (1.0 + 100.0 / ec);
    for (const std::vector<double>& s : {pulled<SolidPoint<ComposedLaw>>(two_moduli(ec), {0.005, 0.0, -0.005, -0.3}),
                                         pulled<LayerPoint<ComposedLaw>>(two_moduli(ec), {0.005, 0.0, -0.005, -0.3})}) {
      EXPECT_NEAR(s[0], 10.0, 1e-6);
      EXPECT_NEAR(s[1], 0.0, 1e-2);
      EXPECT_NEAR(s[2], -0.005 * ec, 2e-2);
      EXPECT_NEAR(s[3], -pressed, 2e-4 * pressed);
    }
  }
}

// With RPCT the modulus goes from E at a mean tension of RPCT PT = 7.5 to EC at a pressure of RPCT PC = 15. Of a bar,
// p = -sigma / 3, it is a - b sigma there, with a = E + (EC - E) / 3 and b = (EC - E) / 67.5, so that sigma is
// a / b (1 - exp(-b e)).
TEST(CompressionTension, BetweenThemTheModulusFollowsThePressure) {
  for (const double ec : {3000.0, 1000.0}) {
    const double a = 2000.0 + (ec - 2000.0) / 3.0, b = (ec - 2000.0) / 67.5;
    const auto expected = [&](double e) { return a / b * (1.0 - std::exp(-b * e)); };
    const CompressionTension law = two_moduli(ec, 15.0, 7.5, 30.0, 15.0);
    for (const double e : {0.008, -0.01}) {
      EXPECT_NEAR(pulled<SolidPoint<ComposedLaw>>(law, {e})[0], expected(e), 1e-3) << ec << ' ' << e;
      EXPECT_NEAR(pulled<LayerPoint<ComposedLaw>>(law, {e})[0], expected(e), 1e-3) << ec << ' ' << e;
    }
    const double end = -std::log(1.0 - 22.5 * b / a) / b;  // from there on it is E
    EXPECT_NEAR(pulled<SolidPoint<ComposedLaw>>(law, {end + 0.002})[0], 22.5 + 2000.0 * 0.002, 5e-3);
    // Of small motions about the start it is a, whichever way.
    SolidPoint<ComposedLaw> p(composed_law({law}));
    p.law = p.law.linear_at_start();
    p.uniaxial(1e-9);
    EXPECT_NEAR(p.s.xx, a * 1e-9, 1e-6 * a * 1e-9);
  }
}

// Rates raise the yield stress as they do with one modulus.
TEST(CompressionTension, TwoModuliKeepYieldStressesOverTheRate) {
  CompressionTension law = two_moduli(1000.0);
  law.compression = {0, {0.0, 1.0}, {60.0, 60.0}};
  law.tension = {0, {0.0, 1.0}, {40.0, 40.0}};
  const auto flowing = [&](double rate) {
    SolidPoint<ComposedLaw> p(composed_law({law}));
    p.dt = 1e-4;
    for (int i = 0; i < 4000; ++i) p.uniaxial(rate * p.dt);
    return p.s.xx;
  };
  law.rate_c = 8.0;
  law.rate_p = 2.0;
  EXPECT_NEAR(flowing(2.0), 40.0 * 1.5, 1e-3);
  EXPECT_NEAR(flowing(-2.0), -60.0 * 1.5, 1e-3);
  law.compression_scale = {0, {0.0, 1.0, 3.0}, {1.0, 1.2, 2.0}};
  law.tension_scale = {0, {0.0, 0.5, 2.0}, {1.0, 1.1, 1.7}};
  EXPECT_NEAR(flowing(2.0), 40.0 * 1.7, 1e-3);
  EXPECT_NEAR(flowing(-2.0), -60.0 * 1.6, 1e-3);
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
