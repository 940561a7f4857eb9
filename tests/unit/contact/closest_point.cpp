// SPDX-License-Identifier: Apache-2.0
#include "kernel/contact/closest_point.hpp"

#include <gtest/gtest.h>

#include <random>

namespace nugget::kernel {
namespace {

const Corners square{{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {2.0, 2.0, 0.0}, {0.0, 2.0, 0.0}}};
const Corners warped{{{0.0, 0.0, 0.3}, {2.1, 0.1, -0.3}, {1.9, 2.2, 0.3}, {-0.2, 1.8, -0.3}}};
const Corners triangle{{{0.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 2.0, 0.0}}};

TEST(ClosestPoint, InsideASquare) {
  const Foot foot = closest_point(square, false, {1.5, 0.5, 0.7});
  EXPECT_NEAR(foot.xi, 0.5, 1e-14);
  EXPECT_NEAR(foot.eta, -0.5, 1e-14);
  EXPECT_NEAR(foot.distance, 0.7, 1e-14);
  EXPECT_NEAR(foot.normal.z, 1.0, 1e-14);
  EXPECT_EQ(foot.boundary, 0u);
}

TEST(ClosestPoint, EdgeAndCornerAreNamed) {
  const Foot edge = closest_point(square, false, {3.0, 1.0, 0.0});
  EXPECT_EQ(edge.boundary, 0b0110u);
  EXPECT_NEAR(edge.distance, 1.0, 1e-14);
  const Foot corner = closest_point(square, false, {3.0, 3.0, 1.0});
  EXPECT_EQ(corner.boundary, 0b0100u);
  EXPECT_NEAR(corner.distance, std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(corner.weight[2], 1.0, 1e-15);
}

TEST(ClosestPoint, Triangle) {
  const Foot inside = closest_point(triangle, true, {0.5, 0.5, -1.0});
  EXPECT_NEAR(inside.weight[0], 0.5, 1e-14);
  EXPECT_EQ(inside.boundary, 0u);
  EXPECT_NEAR(inside.distance, 1.0, 1e-14);
  const Foot hypotenuse = closest_point(triangle, true, {2.0, 2.0, 0.0});
  EXPECT_EQ(hypotenuse.boundary, 0b0110u);
  EXPECT_NEAR(hypotenuse.distance, std::sqrt(2.0), 1e-14);
  EXPECT_EQ(hypotenuse.weight[3], 0.0);
}

/// Smallest distance to a fine raster of points of the surface.
double by_raster(const Corners& c, const Vec3d& x) {
  double best = 1e30;
  constexpr int n = 400;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n;
      const Vec3d p = (1 - u) * (1 - v) * c[0] + u * (1 - v) * c[1] + u * v * c[2] + (1 - u) * v * c[3];
      best = std::min(best, norm(x - p));
    }
  return best;
}

TEST(ClosestPoint, WarpedQuadrilateralAgreesWithSearchByRaster) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> at(-1.0, 3.0), height(-1.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    const Vec3d x{at(random), at(random), height(random)};
    const Foot foot = closest_point(warped, false, x);
    const double raster = by_raster(warped, x);
    EXPECT_LT(foot.distance, raster + 1e-12) << i;
    EXPECT_GT(foot.distance, raster - 1e-2) << i;
    EXPECT_NEAR(foot.weight[0] + foot.weight[1] + foot.weight[2] + foot.weight[3], 1.0, 1e-14);
    if (foot.boundary == 0) {
      EXPECT_NEAR(norm(cross(x - foot.point, foot.normal)), 0.0, 1e-9);  // at right angles
    }
  }
}

TEST(ClosestPoint, SegmentWithoutAreaGivesItsEdge) {
  const Corners line{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
  const Foot foot = closest_point(line, false, {0.5, 1.0, 0.0});
  EXPECT_NEAR(foot.distance, 1.0, 1e-14);
}

TEST(LeastDistance, IsNeverMoreThanTheDistance) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-1.0, 3.0), height(-1.5, 1.5);
  int far = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d x{at(random), at(random), height(random)};
    for (const Corners& c : {square, warped, triangle}) {
      const double distance = closest_point(c, c[2].x == c[3].x && c[2].y == c[3].y, x).distance;
      const double least = least_distance(c, x);
      EXPECT_LE(least, distance * (1.0 + 1e-14));
      if (least > 0.5) ++far;
    }
  }
  EXPECT_GT(far, 1000);
}

}  // namespace
}  // namespace nugget::kernel
