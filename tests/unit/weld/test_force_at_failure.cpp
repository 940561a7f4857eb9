// SPDX-License-Identifier: Apache-2.0
// The failure surface of forces out of a weld's own failure function, against closed forms. Sabotage: axial and shear
// swapped; a function that is asked twice with what it remembers.
#include "weld/failure/force_at_failure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nugget::weld::failure {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

TEST(ForceAtFailure, ResultantsMakeAnEllipse) {
  model::Model model;
  model::WeldLaw law;
  law.strength[0].value = 6000.0, law.strength[1].value = law.strength[2].value = 9000.0;
  for (const double angle : {0.0, 15.0, 45.0, 75.0, 90.0}) {
    const double expected = 1.0 / std::hypot(std::sin(angle * degree) / 6000.0, std::cos(angle * degree) / 9000.0);
    EXPECT_NEAR(force_at_failure(model, law, disc(6.0), angle), expected, 1e-8 * expected) << angle;
  }
}

TEST(ForceAtFailure, StressesOfTheBar) {
  model::Model model;
  model::WeldLaw law;
  law.option = 1;
  law.normal_stress.value = 320.0, law.shear_stress.value = 190.0;
  const double area = 0.25 * std::numbers::pi * 36.0;
  EXPECT_NEAR(force_at_failure(model, law, disc(6.0), 90.0), 320.0 * area, 1e-6);
  EXPECT_NEAR(force_at_failure(model, law, disc(6.0), 0.0), 190.0 * area, 1e-6);
}

TEST(ForceAtFailure, LoadRatesCountNothing) {
  model::Model model;
  model.load_rate_strengths.emplace_back();
  model.load_rate_strengths[0].normal = 300.0, model.load_rate_strengths[0].shear = 400.0;
  model.load_rate_strengths[0].dynamic = {1.0, 0.5, 0.0, 1.0};
  model::WeldLaw law;
  law.option = 10;
  law.table = 0;
  Geometry weld = disc(6.0);
  weld.thickness = {1.5, 2.0};
  EXPECT_NEAR(force_at_failure(model, law, weld, 0.0), 400.0 * 6.0 * 1.5, 1e-5);
  EXPECT_NEAR(force_at_failure(model, law, weld, 90.0), 300.0 * 6.0 * 1.5, 1e-5);
}

TEST(ForceAtFailure, NoLimitIsInfinite) {
  model::Model model;
  model::WeldLaw law;
  law.strength[1].value = law.strength[2].value = 9000.0;
  EXPECT_TRUE(std::isinf(force_at_failure(model, law, disc(6.0), 90.0)));
  EXPECT_NEAR(force_at_failure(model, law, disc(6.0), 60.0), 18000.0, 1e-6);
}

}  // namespace
}  // namespace nugget::weld::failure
