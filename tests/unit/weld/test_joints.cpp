// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/joints.hpp"

#include <gtest/gtest.h>

namespace nugget::weld {
namespace {

model::Material sheet() {
  kernel::PiecewiseLinear law;
  law.E = 210000.0;
  law.nu = 0.3;
  law.yield = {{.x = {0.0, 0.1, 1.0}, .y = {300.0, 400.0, 400.0}}};
  model::Material material;
  material.law = law;
  return material;
}

// What the deck's curve says at these plastic strains.
TEST(Joints, TakeTheSheetsOwnCurve) {
  const Curve yield = yield_at_rest(sheet());
  ASSERT_FALSE(yield.empty());
  EXPECT_NEAR(yield.extrapolated(0.0), 300.0, 0.1);
  EXPECT_NEAR(yield.extrapolated(0.05), 350.0, 0.1);
  EXPECT_NEAR(yield.extrapolated(0.3), 400.0, 0.1);
  EXPECT_TRUE(rate_factor(sheet()).empty());
}

// Cowper and Symonds: 1 + (rate / C)^(1/P); under shear the law's rate is that of the effective strain, 1/sqrt(3) of
// the shear's.
TEST(Joints, TakeTheSheetsOwnRate) {
  model::Material material = sheet();
  std::get<kernel::PiecewiseLinear>(material.law).rate_c = 40.0;
  std::get<kernel::PiecewiseLinear>(material.law).rate_p = 5.0;
  const Curve factor = rate_factor(material);
  ASSERT_FALSE(factor.empty());
  EXPECT_EQ(factor.clamped(0.0), 1.0);
  EXPECT_NEAR(factor.clamped(40.0), 2.0, 0.03);
  EXPECT_NEAR(yield_at_rest(material).extrapolated(0.05), 350.0, 3.0);
}

TEST(Joints, AnElasticSheetHasNone) {
  model::Material material;
  material.law = kernel::Elastic{210000.0, 0.3};
  EXPECT_TRUE(yield_at_rest(material).empty());
}

}  // namespace
}  // namespace nugget::weld
