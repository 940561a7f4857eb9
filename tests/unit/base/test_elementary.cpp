// SPDX-License-Identifier: Apache-2.0
#include "base/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace nugget {
namespace {

TEST(Elementary, AgreesWithTheLibraryToTwoInTheLastPlace) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> far(-700.0, 700.0), near(-1.0, 1.0);
  for (int i = 0; i < 20000; ++i) {
    const double a = i % 2 ? far(generator) : near(generator), grown = std::exp(a);
    EXPECT_NEAR(exponential(a) / grown, 1.0, 5e-16) << a;
    EXPECT_NEAR(logarithm(grown), std::log(grown), 3e-16 * std::max(std::abs(a), 1.0)) << grown;
    const double base = std::exp(3.0 * near(generator)), p = 4.0 * near(generator);
    EXPECT_NEAR(power(base, p) / std::pow(base, p), 1.0, 3e-15) << base << ' ' << p;
  }
}

TEST(Elementary, OfSinglePrecision) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> exponent(-80.0, 80.0);
  for (int i = 0; i < 5000; ++i) {
    const SingleBatch a(exponent(generator)), grown = exponential(a);
    EXPECT_NEAR(lane(grown, 1) / std::exp(lane(a, 1)), 1.0, 4e-7);
    EXPECT_NEAR(lane(logarithm(grown), 1), std::log(lane(grown, 1)), 3e-7 * std::max(std::abs(lane(a, 1)), 1.0));
  }
}

TEST(Elementary, EachLaneHasTheBitsOfOneNumber) {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> any_number(-300.0, 300.0);
  for (int i = 0; i < 2000; ++i) {
    NativeBatch a;
    for (int l = 0; l < native_width; ++l) set_lane(a, l, any_number(generator));
    const NativeBatch grown = exponential(a), back = logarithm(grown);
    for (int l = 0; l < native_width; ++l) {
      EXPECT_EQ(lane(grown, l), exponential(lane(a, l)));
      EXPECT_EQ(lane(back, l), logarithm(lane(grown, l)));
    }
  }
}

TEST(Elementary, AtTheEndsOfTheRange) {
  EXPECT_EQ(exponential(0.0), 1.0);
  EXPECT_EQ(logarithm(1.0), 0.0);
  EXPECT_TRUE(std::isfinite(exponential(1e300)));
  EXPECT_GT(exponential(-1e300), 0.0);
  EXPECT_LT(exponential(-1e300), 1e-307);
  EXPECT_LT(logarithm(0.0), -700.0);
  EXPECT_EQ(power(0.0, 0.2), 0.0);
  EXPECT_EQ(lane(each_lane<NativeBatch>([](int l) { return 3.0 * l; }), native_width - 1), 3.0 * (native_width - 1));
}

}  // namespace
}  // namespace nugget
