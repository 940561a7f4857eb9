// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "kernel/law/law_components.hpp"
#include "law_point.hpp"

// What of foams depends on the rate: MAT_083, damping, creep and relaxation of MAT_057 and 063.
namespace nugget::kernel {
namespace {

using Point = SolidPoint<ComposedLaw>;

/// A length along x that is 1 at first and changes by the speed given, the others held.
struct Bar {
  Point point;
  double length = 1.0;

  Bar(const LawComponents& law, double dt) : point(composed_law(law)) { point.dt = dt; }
  /// True stress after `steps` with a change of length d a step.
  double move(double d, int steps) {
    for (int i = 0; i < steps; ++i) {
      point.strain({d / (length + 0.5 * d), 0, 0, 0, 0, 0});
      length += d;
    }
    return point.s.xx;
  }
  /// At a constant true strain rate.
  double strain(double rate, int steps) {
    double stress = 0.0;
    for (int i = 0; i < steps; ++i) stress = move(length * std::expm1(rate * point.dt), 1);
    return stress;
  }
};

const Curve slow{1, {0.0, 0.1, 0.6, 0.8}, {0.0, 0.1, 0.2, 0.8}}, fast{2, {0.0, 0.1, 0.6, 0.8}, {0.0, 0.3, 0.5, 1.4}};

RateFoam rate_foam() {
  RateFoam law;
  law.E = 2.0;
  law.curves = {slow, fast};
  law.rates = {10.0, 110.0};
  return law;
}

/// Nominal stress between the curves, positive in compression.
double between(double rate, double strain) {
  const double w = std::clamp((rate - 10.0) / 100.0, 0.0, 1.0);
  return slow.extrapolated(strain) + w * (fast.extrapolated(strain) - slow.extrapolated(strain));
}

// Sabotage: the logarithm of one of the two.
TEST(FoamRates, StressIsInterpolatedBetweenTheLogarithms) {
  RateFoam law = rate_foam();
  law.log_log = true;
  for (const double rate : {10.0, 30.0, 60.0, 110.0, 500.0}) {
    Bar bar({law}, 1e-3 / rate);
    const double stress = bar.strain(-rate, 500), strain = 1.0 - bar.length;
    const double share = std::clamp(std::log(rate / 10.0) / std::log(11.0), 0.0, 1.0);
    const double low = slow.extrapolated(strain), high = fast.extrapolated(strain);
    EXPECT_NEAR(stress, -low * std::pow(high / low, share), 1e-7) << rate;
  }
}

// Sabotage: rate over the first length where SFLAG is 0.
TEST(FoamRates, StressIsInterpolatedBetweenTheRates) {
  for (const double rate : {1.0, 10.0, 60.0, 110.0, 500.0}) {
    const double dt = 1e-3 / rate;
    for (const bool engineering : {false, true}) {
      RateFoam law = rate_foam();
      law.engineering_rate = engineering;
      Bar bar({law}, dt);
      const double stress = engineering ? bar.move(-rate * dt, 500) : bar.strain(-rate, 500);
      EXPECT_NEAR(-stress, between(rate, 1.0 - bar.length), 1e-7) << rate;
      EXPECT_NEAR(bar.point.s.yy, 0.0, 1e-12);
    }
  }
}

TEST(FoamRates, WhoseRateItIs) {
  // Pressed to 0.7 and 0.9 at once: rates 60 and 60 ln(0.9) / ln(0.7) of the true strains.
  const double part = std::log(0.9) / std::log(0.7);
  for (const auto of : {RateFoam::RateOf::most_strained, RateFoam::RateOf::each_direction, RateFoam::RateOf::volume}) {
    RateFoam law = rate_foam();
    law.rate_of = of;
    Point p(composed_law({law}));
    const int steps = 500;
    p.dt = -std::log(0.7) / 60.0 / steps;
    double x = 1.0, y = 1.0;
    for (int i = 0; i < steps; ++i) {
      const double dx = x * std::expm1(-60.0 * p.dt), dy = y * std::expm1(-60.0 * part * p.dt);
      p.strain({dx / (x + 0.5 * dx), dy / (y + 0.5 * dy), 0, 0, 0, 0});
      x += dx;
      y += dy;
    }
    const bool volume = of == RateFoam::RateOf::volume, each = of == RateFoam::RateOf::each_direction;
    const double first = volume ? 60.0 * (1.0 + part) : 60.0, second = each ? 60.0 * part : first;
    EXPECT_NEAR(-p.s.xx, between(first, 0.3) / 0.9, 1e-6);
    EXPECT_NEAR(-p.s.yy, between(second, 0.1) / 0.7, 1e-6);
  }
}

// Sabotage: rates of unloading by their magnitude.
TEST(FoamRates, UnloadingFollowsTheCurveOfTheLowestRate) {
  RateFoam law = rate_foam();
  Bar bar({law}, 1e-5);
  double stress = -bar.strain(-110.0, 600);
  EXPECT_NEAR(stress, fast.extrapolated(1.0 - bar.length), 1e-7);
  stress = -bar.strain(110.0, 200);
  EXPECT_NEAR(stress, slow.extrapolated(1.0 - bar.length), 1e-9);
  // With HU it keeps a share of that.
  law.unloading = 0.2;
  law.shape = 2.0;
  law.exponent = 3.0;
  Bar other({law}, 1e-5);
  stress = -other.strain(-110.0, 600);
  EXPECT_NEAR(stress, fast.extrapolated(1.0 - other.length), 1e-7);
  const auto area = [](double x) {
    double sum = 0.0;
    for (int i = 0; i < 20000; ++i) sum += slow.extrapolated(x * (i + 0.5) / 20000) * x / 20000;
    return sum;
  };
  const double most = area(1.0 - other.length);
  stress = -other.strain(110.0, 200);
  const double strain = 1.0 - other.length;
  const double lost = std::pow(1.0 - std::pow(area(strain) / most, 2.0), 3.0);
  EXPECT_NEAR(stress, (1.0 - 0.8 * lost) * slow.extrapolated(strain), 1e-6);
}

TEST(FoamRates, Tension) {
  RateFoam law = rate_foam();
  law.cutoff = 0.3;
  Bar linear({law}, 1e-5);
  EXPECT_NEAR(linear.move(1e-3, 100), 0.2, 1e-9);
  EXPECT_NEAR(linear.move(1e-3, 100), 0.3, 1e-9);
  law.tension_failure = true;
  Bar torn({law}, 1e-5);
  EXPECT_NEAR(torn.move(1e-3, 200), 0.0, 1e-12);
  law.tension_failure = false;
  law.tension_by_curves = true;
  law.engineering_rate = true;
  law.curves[0] = {1, {-0.4, 0.0, 0.8}, {-0.16, 0.0, 0.8}};
  law.curves[1] = {2, {-0.4, 0.0, 0.8}, {-0.24, 0.0, 1.6}};
  Bar pulled({law}, 1e-5);
  EXPECT_NEAR(pulled.move(60.0 * 1e-5, 400), 0.5 * (0.4 + 0.6) * 0.24, 1e-9);  // rate 60: half way
  EXPECT_NEAR(pulled.move(-60.0 * 1e-5, 100), 0.4 * 0.18, 1e-6);
}

TEST(FoamRates, ShearHasItsPrincipalStresses) {
  // A pure stretch along the diagonals: pressed along one, pulled along the other.
  RateFoam law = rate_foam();
  Point p(composed_law({law}));
  p.dt = 1e-5;
  for (int i = 0; i < 1000; ++i) p.strain({0, 0, 0, 2.0 * 60.0 * p.dt, 0, 0});  // true strains +-0.6
  const double longer = std::exp(0.6), shorter = std::exp(-0.6);
  const double pull = 2.0 * (longer - 1.0) * longer, press = -between(60.0, 1.0 - shorter) * shorter;
  EXPECT_NEAR(p.s.xx, 0.5 * (pull + press), 1e-4);
  EXPECT_NEAR(p.s.xy, 0.5 * (pull - press), 1e-4);
}

/// A mass on a spring of this law, one length, by central differences: share of its amplitude left after one swing.
double left_after_a_swing(const LawComponents& law, double modulus, double omega_dt) {
  Bar bar(law, 1.0);
  const double mass = modulus / (omega_dt * omega_dt);  // dt = 1
  bar.length = 1.0;
  double x = 1e-6, v = 0.0, stress = bar.move(1e-6, 1), peak = 0.0;
  const int swing = static_cast<int>(std::lround(2.0 * 3.14159265358979 / omega_dt));
  for (int i = 0; i < swing + swing / 8; ++i) {
    v -= stress / mass;
    x += v;
    stress = bar.move(v, 1);
    if (i > swing / 2) peak = std::max(peak, x);
  }
  return peak / 1e-6;
}

// Sabotage: damping without the time step. DAMP is the share of critical damping at omega dt = 2, and in proportion
// below: exp(-2 pi DAMP omega dt / 2) a swing.
TEST(FoamRates, DampingIsAShareOfCriticalDamping) {
  for (const double damping : {0.05, 0.2, 0.5}) {
    LowDensityFoam low;
    low.E = 2.0;
    low.compression = {1, {0.0, 1.0}, {0.0, 2.0}};
    low.damping = damping;
    CrushableFoam crushable;
    crushable.E = 2.0;
    crushable.yield = {1, {0.0, 1.0}, {1.0, 3.0}};
    crushable.cutoff = 1.0;
    crushable.damping = damping;
    RateFoam by_table;
    by_table.E = 2.0;
    by_table.curves = {{1, {0.0, 1.0}, {0.0, 2.0}}};
    by_table.rates = {0.0};
    by_table.damping = damping;
    for (const LawComponents& law : {LawComponents{low}, LawComponents{crushable}, LawComponents{by_table}}) {
      const double w = 0.1, zeta = 0.5 * damping * w;
      EXPECT_NEAR(left_after_a_swing(law, 2.0, w), std::exp(-6.2832 * zeta), 0.006) << damping;
      // The stable step falls by sqrt(1 + D^2) - D.
      Bar bar(law, 1.0);
      bar.move(-1e-6, 1);
      const double wave = bar.point.wave_modulus();
      EXPECT_NEAR(std::sqrt(2.0 / wave), std::sqrt(1.0 + damping * damping) - damping, 1e-4);
    }
  }
}

TEST(FoamRates, LowDensityFoamComesBackToItsCurve) {
  LowDensityFoam law;
  law.E = 2.0;
  law.compression = {1, {0.0, 1.0}, {0.0, 2.0}};
  law.unloading = 0.1;
  law.recovery = 50.0;
  Bar bar({law}, 1e-6);
  bar.move(-1e-3, 600);
  const double after = -bar.move(1e-3, 200), full = 2.0 * 0.4;  // in 2e-4: hardly any recovery
  EXPECT_NEAR(after, (0.1 + 0.9 * 0.16 / 0.36) * full, 0.01);
  bar.point.dt = 1e-3;
  const double t = 0.02, most = 0.16 + (0.36 - 0.16) * std::exp(-50.0 * t);  // energies x^2
  EXPECT_NEAR(-bar.move(0.0, 20), (0.1 + 0.9 * 0.16 / most) * full, 0.005);
  bar.point.dt = 1.0;
  EXPECT_NEAR(-bar.move(0.0, 5), full, 1e-9);
}

TEST(FoamRates, LowDensityFoamRelaxes) {
  LowDensityFoam law;
  law.E = 2.0;
  law.compression = {1, {0.0, 1.0}, {0.0, 2.0}};
  law.maxwell_modulus = 7.0;
  law.decay = 300.0;
  Bar bar({law}, 1e-5);
  const double rate = 10.0;
  const double stress = -bar.strain(-rate, 1000), grown = 7.0 * rate * (1.0 - std::exp(-300.0 * 0.01)) / 300.0;
  EXPECT_NEAR(stress, 2.0 * (1.0 - bar.length) + grown, 1e-6);
  EXPECT_NEAR(-bar.move(0.0, 500), 2.0 * (1.0 - bar.length) + grown * std::exp(-1.5), 1e-6);
}

// MAT_073: several stresses that relax, beside ED's.
TEST(FoamRates, LowDensityFoamRelaxesByTerms) {
  LowDensityFoam law;
  law.E = 2.0;
  law.compression = {1, {0.0, 1.0}, {0.0, 2.0}};
  law.maxwell_modulus = 1.0;
  law.decay = 50.0;
  law.terms = {{7.0, 300.0}, {3.0, 20.0}, {0.5, 0.0}};
  Bar bar({law}, 1e-5);
  const double rate = 10.0, t = 0.01, then = 0.005;
  const auto grown = [&](double G, double b) {
    return b > 0.0 ? G * rate * (1.0 - std::exp(-b * t)) / b : G * rate * t;
  };
  const double stress = -bar.strain(-rate, 1000);
  EXPECT_NEAR(stress, 2.0 * (1.0 - bar.length) + grown(1, 50) + grown(7, 300) + grown(3, 20) + grown(0.5, 0), 1e-6);
  EXPECT_NEAR(-bar.move(0.0, 500),
              2.0 * (1.0 - bar.length) + grown(1, 50) * std::exp(-50 * then) + grown(7, 300) * std::exp(-300 * then) +
                  grown(3, 20) * std::exp(-20 * then) + grown(0.5, 0),
              1e-6);

  // The step is that of all springs together.
  const auto modulus = [](const LowDensityFoam& foam) {
    const LowDensityFoamPoint point(foam);
    std::vector<double> history(static_cast<std::size_t>(point.history()), 0.0);
    SolidTensor<double> s{}, d{};
    d.xx = -1.0;
    return point.update(s, d, 1e-3, history).wave_modulus;
  };
  LowDensityFoam bare = law;
  bare.maxwell_modulus = 0.0;
  bare.terms.clear();
  EXPECT_NEAR(modulus(law) - modulus(bare), 1.0 + 7.0 + 3.0 + 0.5, 1e-12);
}

// KCON raises the modulus of the step and of DAMP, and nothing else.
TEST(FoamRates, ModulusForTheStep) {
  RateFoam plain = rate_foam(), raised = rate_foam();
  plain.damping = raised.damping = 0.0;
  raised.step_modulus = 5.0;
  double modulus[2], stress[2];
  for (const int k : {0, 1}) {
    const RateFoamPoint point(k == 0 ? plain : raised);
    std::vector<double> history(static_cast<std::size_t>(point.history()), 0.0);
    SolidTensor<double> s{}, d{};
    d.xx = -1.0;
    const PointUpdate now = point.update(s, d, 1e-3, history);
    stress[k] = now.stress.xx;
    modulus[k] = now.wave_modulus;
  }
  EXPECT_DOUBLE_EQ(stress[0], stress[1]);
  EXPECT_GT(modulus[1], modulus[0] + 2.9);
}

}  // namespace
}  // namespace nugget::kernel
