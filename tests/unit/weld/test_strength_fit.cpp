// SPDX-License-Identifier: Apache-2.0
// Strengths out of tests with known ones. Sabotage: residuals over f instead of the force (scatter twice as large),
// loads of failed samples left out, an interval without Student's factor.
#include "weld/coupon/strength_fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace nugget::weld {
namespace {

/// Loads at failure of tests at angles, each with a moment in proportion to its force.
std::vector<StrengthSample> tests_of(const std::array<double, 4>& s, double lever, double noise, unsigned seed,
                                     int repeats) {
  std::mt19937 random(seed);
  std::normal_distribution<double> scatter(0.0, noise);
  std::vector<StrengthSample> samples;
  for (int r = 0; r < repeats; ++r)
    for (const double degrees : {0.0, 30.0, 60.0, 90.0}) {
      for (const double arm : {0.0, lever}) {
        const double a = degrees * std::numbers::pi / 180.0;
        const std::array<double, 4> unit{std::sin(a), std::cos(a), 0.0, arm};
        double f = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
          if (s[k] > 0.0) f += std::pow(unit[k] / s[k], 2);
        const double force = std::exp(scatter(random)) / std::sqrt(f);
        StrengthSample sample{"test", {}};
        for (std::size_t k = 0; k < 4; ++k) sample.load[k] = force * unit[k];
        samples.push_back(sample);
      }
    }
  return samples;
}

TEST(StrengthFit, FindsTheStrengthsThatMadeTheTests) {
  const std::array<double, 4> truth{5500.0, 9800.0, 0.0, 7300.0};
  const StrengthFit fit = fit_strengths(tests_of(truth, 1.2, 0.0, 1, 1), {1000.0, 1000.0, 0.0, 50000.0});
  EXPECT_EQ(fit.fault, "");
  for (const std::size_t k : {0u, 1u, 3u}) EXPECT_NEAR(fit.strength[k] / truth[k], 1.0, 1e-8) << k;
  EXPECT_EQ(fit.strength[2], 0.0);
  EXPECT_LT(fit.scatter, 1e-8);
}

TEST(StrengthFit, IntervalsHoldTheTruthAsOftenAsTheySay) {
  const std::array<double, 4> truth{5500.0, 9800.0, 0.0, 7300.0};
  int inside = 0, all = 0;
  double scatter = 0.0;
  constexpr int trials = 400;
  for (unsigned seed = 1; seed <= trials; ++seed) {
    const StrengthFit fit = fit_strengths(tests_of(truth, 1.2, 0.05, seed, 2), {4000.0, 4000.0, 0.0, 4000.0});
    scatter += fit.scatter * fit.scatter / trials;
    for (const std::size_t k : {0u, 1u, 3u}) {
      inside += fit.low[k] <= truth[k] && truth[k] <= fit.high[k];
      ++all;
    }
  }
  EXPECT_NEAR(std::sqrt(scatter), 0.05, 0.002);
  EXPECT_NEAR(static_cast<double>(inside) / all, 0.95, 0.02);
}

/// Interpolation spot welds: the force of each test by solving the surface ((N + a M)/R_n)^b + ((S + g T)/R_s)^b = 1
/// for it.
TEST(StrengthFit, FindsTheSurfaceOfAnInterpolationWeld) {
  const double rn = 5200.0, rs = 8100.0, alpha = 0.2, gamma = 0.05, beta = 1.6;
  std::vector<StrengthSample> samples;
  for (const auto& [n, s, t, m] : std::vector<std::array<double, 4>>{
           {1, 0, 0, 0.5}, {0.1, 1, 0, 0}, {0.7, 0.7, 9, 0}, {0.2, 0.9, 2, 4}, {1, 0.2, 0, 11}}) {
    const double across = (n + alpha * m) / rn, along = (s + gamma * t) / rs;
    const double force = std::pow(std::pow(across, beta) + std::pow(along, beta), -1.0 / beta);
    samples.push_back({"test", {n * force, s * force, t * force, m * force}});
  }
  const StrengthFit fit = fit_strengths(samples, {4000.0, 4000.0, 4e5, 4e4}, form_of_interpolation(beta));
  EXPECT_EQ(fit.fault, "");
  const std::array<double, 4> truth{rn, rs, rs / gamma, rn / alpha};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(fit.strength[k] / truth[k], 1.0, 1e-7) << k;
  EXPECT_LT(fit.scatter, 1e-8);
}

TEST(StrengthFit, StudentsTable) {  // W. S. Gosset's table, two-sided 5 %
  EXPECT_NEAR(student_limit(1), 12.706, 0.002);
  EXPECT_NEAR(student_limit(2), 4.303, 0.001);
  EXPECT_NEAR(student_limit(5), 2.571, 0.001);
  EXPECT_NEAR(student_limit(30), 2.042, 0.001);
}

TEST(StrengthFit, SaysWhatTheTestsDoNotTell) {
  const std::array<double, 4> truth{5500.0, 9800.0, 0.0, 0.0};
  std::vector<StrengthSample> shear{{"lap_shear", {0.0, 9800.0, 0.0, 100.0}}, {"ks2_00", {10.0, 9700.0, 0.0, 100.0}}};
  EXPECT_THAT(fit_strengths(shear, {4000.0, 4000.0, 0.0, 0.0}).fault, testing::HasSubstr("do not determine NRR"));
  EXPECT_THAT(fit_strengths(shear, {4000.0, 4000.0, 4000.0, 0.0}).fault, testing::HasSubstr("2 tests for 3 strengths"));
  EXPECT_THAT(fit_strengths(shear, {0.0, 0.0, 4000.0, 0.0}).fault, testing::HasSubstr("loads none"));
  EXPECT_THAT(fit_strengths(tests_of(truth, 0.0, 0.0, 1, 1), {}).fault, testing::HasSubstr("no strength above 0"));
}

}  // namespace
}  // namespace nugget::weld
