// SPDX-License-Identifier: Apache-2.0
#include "weld/coupon/damage_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace nugget::weld {
namespace {

TEST(DamageFit, WorkBehindThePeakOfATriangle) {
  EXPECT_NEAR(work_after_peak(std::vector{0.0, 1.0, 3.0, 4.0}, std::vector{0.0, 10.0, 0.0, 0.0}), 10.0, 1e-12);
  EXPECT_EQ(work_after_peak(std::vector{0.0, 1.0}, std::vector{0.0, 10.0}), 0.0);
}

/// Works c RS^p: the mean of ln(measured / c) / p, and an interval by Student's t of one degree of freedom, 12.706.
TEST(DamageFit, PowersOfTheRuptureStrain) {
  constexpr double power = 0.8, truth = 0.35, off = 1.03;
  const std::vector<double> factor{100.0, 4000.0};
  const std::vector<double> measured{factor[0] * std::pow(truth, power) * off,
                                     factor[1] * std::pow(truth, power) / off};
  int runs = 0;
  const DamageFit fit = fit_damage(measured, 0.05, [&](double rupture) {
    ++runs;
    return std::vector{factor[0] * std::pow(rupture, power), factor[1] * std::pow(rupture, power)};
  });
  EXPECT_TRUE(fit.fault.empty()) << fit.fault;
  EXPECT_NEAR(fit.rupture, truth, 1e-3 * truth);
  EXPECT_NEAR(fit.ratio[0], 1.0 / off, 1e-3);
  EXPECT_NEAR(std::log(fit.high / fit.rupture), 12.706 * std::log(off) * std::sqrt(2.0) / (power * std::sqrt(2.0)),
              0.01);
  EXPECT_LT(runs, 12);
}

TEST(DamageFit, WorkThatDoesNotDependOnIt) {
  const DamageFit fit = fit_damage({10.0}, 0.2, [](double) { return std::vector{12.0}; });
  EXPECT_NE(fit.fault.find("does not depend on RS"), std::string::npos);
}

}  // namespace
}  // namespace nugget::weld
