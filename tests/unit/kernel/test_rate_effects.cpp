// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/rate_effects.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "kernel/law/piecewise_linear_kernel.hpp"
#include "kernel/law/rate_table.hpp"
#include "law_point.hpp"

// The returns of points with rate effects end on the yield surface, and after few evaluations of the yield stress: in
// terms of the plastic strain Newton's method would need dozens, since the slopes at small rates are without bound.
namespace nugget::kernel {
namespace {

constexpr double ka = 150000.0, kb = 3.0 * 80769.0;

struct LinearYield {
  static constexpr bool limited = false;
  double yield, slope, strain;
  YieldStress<double> operator()(double increment) const { return {yield + slope * (strain + increment), slope}; }
};

class AtStrain {
 public:
  static constexpr bool limited = false;
  AtStrain(const RateTable& table, double strain) : strain_(strain), rows_{}, row_(rows_.find(table, strain)) {}
  double plastic_strain() const { return strain_; }
  const RateRows<double>& rows() const { return rows_; }
  const double& begin() const { return row_.begin; }
  const double& end() const { return row_.end; }

 private:
  double strain_;
  RateRows<double> rows_;
  RateRows<double>::Row row_;
};

/// An unknown that counts how often it is asked.
template <class Unknown>
struct Counted {
  static constexpr bool is_increment = false;
  Unknown unknown;
  int asked = 0;
  Range<double> range(const BeyondYield<double>& s) { return unknown.range(s); }
  Trial<double> operator()(double x) {
    ++asked;
    return unknown(x);
  }
  bool smooth(double x, double next, double increment) const requires requires(const Unknown& u) {
    u.smooth(x, next, increment);
  }
  { return unknown.smooth(x, next, increment); }
};

class Chance {
 public:
  double operator()() { return std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }
  double power_of_ten(double from, double to) { return std::pow(10.0, from + (to - from) * (*this)()); }

 private:
  std::mt19937 engine_{1};
};

struct Count {
  double mean = 0.0;
  int most = 0;
};

/// Returns of trial stresses up to twice the yield stress at rest, in steps of 0.1 to 10 us; `make(strain, dt)` gives
/// an unknown and its yield stress at rest, `yield(strain, rate)` what the yield stress must be.
template <class Make, class YieldAt>
Count count(Make&& make, YieldAt&& yield) {
  Chance chance;
  Count result;
  constexpr int tries = 3000;
  for (int i = 0; i < tries; ++i) {
    const double dt = chance.power_of_ten(-7.0, -5.0), strain = 0.1 * chance(), share = chance();
    const double rest = yield(strain, 0.0), trial = rest * (1.0 + chance.power_of_ten(-8.0, 0.0));
    make(strain, dt, [&](auto unknown) {
      Counted<decltype(unknown)> counted{unknown};
      const double A = share * trial * trial, B = (1.0 - share) * trial * trial;
      const PlasticReturn<double> r = plastic_return<true>(A, B, trial * trial, ka, kb, counted, {rest, 0.0}, true);
      const double a = r.yield + ka * r.increment, b = r.yield + kb * r.increment;
      EXPECT_NEAR(A / (a * a) + B / (b * b), 1.0, 1e-11) << i;
      EXPECT_NEAR(r.yield, yield(strain + r.increment, r.increment / dt), 1e-9 * rest) << i;
      result.mean += static_cast<double>(counted.asked) / tries;
      result.most = std::max(result.most, counted.asked);
    });
  }
  return result;
}

TEST(RateEffects, CowperSymondsReturnsInFewSteps) {
  for (const double p : {1.0, 3.585, 5.0, 8.0})
    for (const double c : {0.1, 40.4, 8000.0}) {
      const CowperSymonds rate(c, p);
      const Count asked = count(
          [&](double strain, double dt, auto&& go) {
            LinearYield yield{300.0, 1000.0, strain};
            go(ByRate<double, LinearYield, CowperSymonds>(yield, rate, dt));
          },
          [&](double strain, double at) { return (300.0 + 1000.0 * strain) * (1.0 + std::pow(at / c, 1.0 / p)); });
      EXPECT_LE(asked.mean, 3.0) << p << ' ' << c;
      EXPECT_LE(asked.most, 12) << p << ' ' << c;
    }
}

TEST(RateEffects, LogarithmOfTheRateReturnsInFewSteps) {
  for (const double factor : {0.005, 0.02, 0.1})
    for (const double rest : {1e-6, 1e-3, 1.0}) {
      const LogarithmicRate rate(factor, rest);
      const Count asked = count(
          [&](double strain, double dt, auto&& go) {
            LinearYield yield{300.0, 1000.0, strain};
            go(ByRate<double, LinearYield, LogarithmicRate>(yield, rate, dt));
          },
          [&](double strain, double at) {
            return (300.0 + 1000.0 * strain) * (1.0 + factor * std::log(std::max(at / rest, 1.0)));
          });
      EXPECT_LE(asked.mean, 5.0) << factor << ' ' << rest;
      EXPECT_LE(asked.most, 12) << factor << ' ' << rest;
    }
}

TEST(RateEffects, TablesReturnInFewSteps) {
  const Curve rest{0, {0.0, 0.01, 0.05, 0.1, 0.3}, {300.0, 350.0, 390.0, 430.0, 500.0}};
  for (const bool log_rates : {false, true})
    for (const double lowest : {0.0, 1e-3}) {
      if (log_rates && lowest == 0.0) continue;
      const std::vector<double> rates{lowest, 1.0, 10.0, 100.0, 1000.0};
      std::vector<YieldCurve> curves;
      for (std::size_t i = 0; i < rates.size(); ++i) {
        Curve curve = rest;
        for (double& y : curve.y) y *= 1.0 + 0.05 * static_cast<double>(i);
        curves.emplace_back(curve);
      }
      const RateTable table(curves, rates, log_rates);
      const Count asked = count(
          [&](double strain, double dt, auto&& go) {
            const AtStrain yield(table, strain);
            go(ByTable<double, AtStrain>(yield, table, dt));
          },
          [&](double strain, double at) {
            double place = 0.0;
            for (std::size_t i = 0; i + 1 < rates.size(); ++i) {
              if (at < rates[i]) break;
              const double share = log_rates ? std::log(at / rates[i]) / std::log(rates[i + 1] / rates[i])
                                             : (at - rates[i]) / (rates[i + 1] - rates[i]);
              place = static_cast<double>(i) + std::min(share, 1.0);
            }
            return rest.extrapolated(strain) * (1.0 + 0.05 * place);
          });
      EXPECT_LE(asked.mean, 1.3) << log_rates << ' ' << lowest;
      EXPECT_LE(asked.most, 6) << log_rates << ' ' << lowest;
    }
}

/// Of a part of the yield stress alone, as with VP 1 (here 1.2 of 280): its curve and raised (rate / C)^(1/P).
template <class Point, class Tensor>
void expect_stress_by_the_rate(const Tensor& increment) {
  for (const double p : {5.0, 8.0, 10.0, 30.0, 50.0, 300.0})
    for (const double raised : {1.2, 25.0, 280.0}) {
      PiecewiseLinear law;
      law.E = 210000.0;
      law.nu = 0.3;
      law.yield = {{0, {0.0, 1.0}, {280.0, 1280.0}}};
      law.rate_c = 1.0;
      law.rate_p = p;
      law.rate_yield = raised;
      Point point(law);
      point.dt = 1e-7;
      double before = 0.0;
      for (int k = 0; k < 200; ++k) {
        before = point.plastic_strain();
        point.strain(increment);
      }
      const double e = point.plastic_strain();
      EXPECT_GT(e, 0.01);
      EXPECT_NEAR(point.effective(), 280.0 + 1000.0 * e + raised * std::pow((e - before) / point.dt, 1.0 / p), 1e-6)
          << p << ' ' << raised;
    }
}

// Sabotage caught: a range whose end is the rate itself, so high a power of what is sought that it is not left again.
TEST(CowperSymonds, ComesBackFromAHighPowerOfTheRate) {
  expect_stress_by_the_rate<SolidPoint<PiecewiseLinear>>(1e-4 * SolidTensor<double>{1.0, -0.4, -0.5, 0.3, 0.0, 0.0});
  expect_stress_by_the_rate<LayerPoint<PiecewiseLinear>>(1e-4 * LayerTensor<double>{1.0, -0.4, 0.3, 0.0, 0.0});
}

}  // namespace
}  // namespace nugget::kernel
