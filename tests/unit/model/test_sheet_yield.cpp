// SPDX-License-Identifier: Apache-2.0
#include "model/sheet_yield.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace nugget::model {
namespace {

Material sheet() {
  kernel::PiecewiseLinear law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = {{.x = {0.0, 0.1, 1.0}, .y = {300.0, 400.0, 400.0}}};
  Material material;
  material.law = law;
  material.density = 7.85e-9;
  return material;
}

// What the deck's curve says at these plastic strains.
TEST(SheetYield, IsTheSheetsOwnCurve) {
  const Curve yield = yield_at_rest(sheet(), 1.0);
  ASSERT_FALSE(yield.empty());
  EXPECT_NEAR(yield.extrapolated(0.0), 300.0, 0.1);
  EXPECT_NEAR(yield.extrapolated(0.05), 350.0, 0.1);
  EXPECT_NEAR(yield.extrapolated(0.3), 400.0, 0.1);
  EXPECT_TRUE(rate_factor(sheet(), 1.0).empty());
}

// Cowper and Symonds: 1 + (rate / C)^(1/P); under shear the law's rate is that of the effective strain, 1/sqrt(3) of
// the shear's.
TEST(SheetYield, RateIsTheSheetsOwn) {
  Material material = sheet();
  std::get<kernel::PiecewiseLinear>(material.law).rate_c = 40.0;
  std::get<kernel::PiecewiseLinear>(material.law).rate_p = 5.0;
  const Curve factor = rate_factor(material, 1.0);
  ASSERT_FALSE(factor.empty());
  EXPECT_EQ(factor.clamped(0.0), 1.0);
  EXPECT_NEAR(factor.clamped(40.0), 2.0, 0.03);
  EXPECT_NEAR(yield_at_rest(material, 1.0).extrapolated(0.05), 350.0, 3.0);
}

// The same sheet in milliseconds. Sabotage: the same numbers for its rates in any unit of time.
TEST(SheetYield, UnitsOfTimeDoNotMatter) {
  Material seconds = sheet(), milliseconds = sheet();
  milliseconds.density = 7.85e-3;
  for (auto [material, c] : {std::pair{&seconds, 40.0}, std::pair{&milliseconds, 0.04}}) {
    auto& law = std::get<kernel::PiecewiseLinear>(material->law);
    law.rate_c = c;
    law.rate_p = 5.0;
  }
  const Curve one = rate_factor(seconds, 1.2), other = rate_factor(milliseconds, 1.2);
  ASSERT_FALSE(one.empty());
  for (const double rate : {1e-3, 0.7, 40.0, 900.0, 1.5e4})
    EXPECT_NEAR(other.clamped(1e-3 * rate), one.clamped(rate), 1e-9 * one.clamped(rate)) << rate;
  EXPECT_NEAR(yield_at_rest(milliseconds, 1.2).extrapolated(0.05), yield_at_rest(seconds, 1.2).extrapolated(0.05),
              1e-9 * 350.0);
}

TEST(SheetYield, AnElasticSheetHasNone) {
  Material material;
  material.law = kernel::Elastic{210000.0, 0.3};
  EXPECT_TRUE(yield_at_rest(material, 1.0).empty());
}

// Hollomon's law s = K e^n necks at the strain n: at the engineering stress K n^n exp(-n), the elastic strain left out.
TEST(SheetYield, NecksWhereHollomonsLawDoes) {
  kernel::PiecewiseLinear law;
  law.E = 1e8;
  law.nu = 0.3;
  law.yield = {{.x = {}, .y = {}}};
  for (int i = 0; i <= 1000; ++i) {
    law.yield[0].x.push_back(1e-3 * i);
    law.yield[0].y.push_back(500.0 * std::pow(1e-4 + 1e-3 * i, 0.2));
  }
  Material material;
  material.law = law;
  const Strength strength = strength_of(material);
  EXPECT_NEAR(strength.yield, 500.0 * std::pow(0.0021, 0.2), 0.5);
  EXPECT_NEAR(strength.tensile, 500.0 * std::pow(0.2, 0.2) * std::exp(-0.2), 0.1);
}

// s = S + H e necks at e = 1 - S / H, at the engineering stress H exp(-e): farther than the curve of yield_at_rest
// goes.
TEST(SheetYield, NecksFarOutWithLinearHardening) {
  kernel::PlasticKinematic law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = 300.0;
  law.tangent_modulus = law.E * 1000.0 / (law.E + 1000.0);
  law.beta = 1.0;
  Material material;
  material.law = law;
  EXPECT_NEAR(strength_of(material).yield, 302.0, 0.1);
  EXPECT_NEAR(strength_of(material).tensile, 1000.0 * std::exp(-0.7 - 1000.0 / 210000.0), 0.3);
}

}  // namespace
}  // namespace nugget::model
