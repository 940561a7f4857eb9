// SPDX-License-Identifier: Apache-2.0
#include "base/axis_across.hpp"

#include <gtest/gtest.h>

namespace nugget {
namespace {

void expect_axis(const Vec3d& r, const Vec3d& axis) {
  EXPECT_EQ(norm(global_axis_across(unit(r)) - axis), 0.0) << r.x << ' ' << r.y << ' ' << r.z;
}

TEST(AxisAcross, IsTheOneFarthestOff) {
  expect_axis({0.1, 0.5, 0.8}, {1, 0, 0});
  expect_axis({0.5, 0.1, 0.8}, {0, 1, 0});
  expect_axis({0.8, 0.5, 0.1}, {0, 0, 1});
}

// Sabotage: compare to the last digit.
TEST(AxisAcross, HasNothingToDoWithTheLastDigits) {
  for (const double lost : {0.0, 1e-17, -3e-12, 5e-7}) {
    expect_axis({lost, 0, 1}, {1, 0, 0});
    expect_axis({0, lost, 1}, {1, 0, 0});
    expect_axis({lost, 1, 0}, {1, 0, 0});
    expect_axis({1, lost, 0}, {0, 1, 0});
    expect_axis({1, 0, lost}, {0, 1, 0});
    expect_axis({1, 1 + lost, 1}, {1, 0, 0});
  }
}

}  // namespace
}  // namespace nugget
