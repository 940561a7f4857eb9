// SPDX-License-Identifier: Apache-2.0
#include "kernel/contact/closest_edges.hpp"

#include <gtest/gtest.h>

#include <random>

namespace nugget::kernel {
namespace {

/// The least distance of 1000 x 1000 points on both edges; it exceeds the true one by less than `error`.
double by_trial(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1) {
  double least = 1e300;
  for (int i = 0; i <= 1000; ++i)
    for (int j = 0; j <= 1000; ++j)
      least = std::min(least, norm(a0 + 1e-3 * i * (a1 - a0) - (b0 + 1e-3 * j * (b1 - b0))));
  return least;
}

TEST(ClosestEdges, AsFoundByTrial) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> part(-1.0, 1.0);
  const auto point = [&] { return Vec3d{part(random), part(random), part(random)}; };
  for (int trial = 0; trial < 40; ++trial) {
    const Vec3d a0 = point(), a1 = point(), b0 = point();
    const Vec3d b1 = trial % 4 == 0 ? b0 + 0.7 * (a1 - a0) : point();  // some of them parallel
    const EdgeFeet feet = closest_points(a0, a1, b0, b1);
    const double least = by_trial(a0, a1, b0, b1);
    EXPECT_LE(feet.distance, least + 1e-12);
    EXPECT_NEAR(feet.distance, least, 4e-3);
    EXPECT_NEAR(norm(feet.a - (a0 + feet.s * (a1 - a0))), 0.0, 1e-14);
    EXPECT_NEAR(norm(feet.b - (b0 + feet.t * (b1 - b0))), 0.0, 1e-14);
  }
}

TEST(ClosestEdges, ParallelEdgesMeetInTheMiddleOfWhereTheyOverlap) {
  const EdgeFeet feet = closest_points({0, 0, 0}, {10, 0, 0}, {14, 1, 0}, {4, 1, 0});
  EXPECT_DOUBLE_EQ(feet.a.x, 7.0);
  EXPECT_DOUBLE_EQ(feet.b.x, 7.0);
  EXPECT_DOUBLE_EQ(feet.distance, 1.0);
  const EdgeFeet apart = closest_points({0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {4, 0, 0});
  EXPECT_DOUBLE_EQ(apart.distance, 2.0);
}

}  // namespace
}  // namespace nugget::kernel
