// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/segment.hpp"

#include <gtest/gtest.h>

#include <random>

namespace nugget::weld {
namespace {

const Corners rectangle{Vec3d{0, 0, 0}, {10, 0, 0}, {10, 8, 0}, {0, 8, 0}};
const Corners triangle{Vec3d{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 10, 0}};

// Shares of a tie's force and mass. Sabotage: exchange N2 and N3, as one public talk does.
TEST(Segment, WeightsOfTheValidationExample) {
  const Foot foot = project(rectangle, false, {7, 2, 0.9});
  EXPECT_NEAR(foot.xi, 0.4, 1e-12);
  EXPECT_NEAR(foot.eta, -0.5, 1e-12);
  const std::array<double, 4> expected{0.225, 0.525, 0.175, 0.075};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(foot.weight[i], expected[i], 1e-12);
  EXPECT_NEAR(foot.gap, 0.9, 1e-12);
  EXPECT_NEAR(foot.point.z, 0.0, 1e-12);
  EXPECT_TRUE(foot.over);
}

TEST(Segment, CentreAndCorner) {
  for (const double w : project(rectangle, false, {5, 4, -1}).weight) EXPECT_NEAR(w, 0.25, 1e-12);
  const Foot corner = project(rectangle, false, {10, 8, 0.5});
  EXPECT_NEAR(corner.weight[2], 1.0, 1e-12);
  EXPECT_NEAR(std::abs(corner.weight[0]) + std::abs(corner.weight[1]) + std::abs(corner.weight[3]), 0.0, 1e-12);
}

TEST(Segment, ClampsToItsBorderBeyondTheParametricExtension) {
  const Foot within = project(rectangle, false, {10.1, 4, 0.5});  // xi = 1.02
  EXPECT_TRUE(within.over);
  EXPECT_NEAR(within.xi, 1.02, 1e-12);
  EXPECT_NEAR(within.gap, 0.5, 1e-12);
  EXPECT_NEAR(within.distance, std::hypot(0.1, 0.5), 1e-12);
  const Foot beyond = project(rectangle, false, {10.2, 4, 0.5});  // xi = 1.04
  EXPECT_FALSE(beyond.over);
  EXPECT_NEAR(beyond.xi, 1.0, 1e-12);
  EXPECT_NEAR(beyond.gap, std::hypot(0.2, 0.5), 1e-12);
  const Foot beside_corner = project(rectangle, false, {-3, -4, 0});
  EXPECT_NEAR(beside_corner.weight[0], 1.0, 1e-12);
  EXPECT_NEAR(beside_corner.gap, 5.0, 1e-12);
}

TEST(Segment, EachEdgeHasItsOwnParameters) {
  const std::array<Vec3d, 4> outside{Vec3d{2.5, -3, 0}, {13, 2, 0}, {2.5, 11, 0}, {-3, 2, 0}};
  const std::array<std::array<double, 2>, 4> expected{{{-0.5, -1}, {1, -0.5}, {-0.5, 1}, {-1, -0.5}}};
  for (int edge = 0; edge < 4; ++edge) {
    const Foot foot = project(rectangle, false, outside[edge]);
    EXPECT_NEAR(foot.xi, expected[edge][0], 1e-12) << edge;
    EXPECT_NEAR(foot.eta, expected[edge][1], 1e-12) << edge;
    EXPECT_NEAR(foot.gap, 3.0, 1e-12) << edge;
  }
}

TEST(Segment, TrianglesAreBarycentric) {
  const Foot inside = project(triangle, true, {2, 3, 1});
  EXPECT_NEAR(inside.weight[0], 0.5, 1e-12);
  EXPECT_NEAR(inside.weight[1], 0.2, 1e-12);
  EXPECT_NEAR(inside.weight[2], 0.3, 1e-12);
  EXPECT_EQ(inside.weight[3], 0.0);
  EXPECT_NEAR(inside.gap, 1.0, 1e-12);
  const Foot outside = project(triangle, true, {8, 8, 0});
  EXPECT_FALSE(outside.over);
  EXPECT_NEAR(outside.weight[1], 0.5, 1e-12);
  EXPECT_NEAR(outside.weight[2], 0.5, 1e-12);
  EXPECT_NEAR(outside.gap, std::hypot(3, 3), 1e-12);
  EXPECT_TRUE(project(triangle, true, {5, -0.1, 0}).over);
  EXPECT_FALSE(project(triangle, true, {5, -0.2, 0}).over);
}

// On a warped patch the distance must be the least that a fine grid of its points shows, and the foot must be
// perpendicular.
TEST(Segment, ClosestPointOfWarpedSegments) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> warp(-2.0, 2.0), place(-2.0, 12.0), height(-3.0, 3.0);
  int inner = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Corners k{Vec3d{0, 0, 0}, {10, 1, 0}, {11, 9, 0}, {-1, 8, 0}};
    for (Vec3d& corner : k) corner.z = warp(random) + 1e4;
    const Vec3d x{place(random), place(random), height(random) + 1e4};
    const Foot foot = project(k, false, x);
    double least = 1e30;
    for (int i = 0; i <= 400; ++i)
      for (int j = 0; j <= 400; ++j) {
        const std::array<double, 4> w = shape_functions(-1.0 + i / 200.0, -1.0 + j / 200.0);
        least = std::min(least, norm(w[0] * k[0] + w[1] * k[1] + w[2] * k[2] + w[3] * k[3] - x));
      }
    EXPECT_LE(foot.distance, least + 1e-9);
    EXPECT_GE(foot.distance, least - 2e-2);
    if (!foot.over) continue;
    ++inner;
    const Vec3d x_xi = 0.25 * ((1 - foot.eta) * (k[1] - k[0]) + (1 + foot.eta) * (k[2] - k[3]));
    const Vec3d x_eta = 0.25 * ((1 - foot.xi) * (k[3] - k[0]) + (1 + foot.xi) * (k[2] - k[1]));
    EXPECT_NEAR(dot(x - foot.point, x_xi), 0.0, 1e-9);
    EXPECT_NEAR(dot(x - foot.point, x_eta), 0.0, 1e-9);
  }
  EXPECT_GT(inner, 50);
}

TEST(Segment, WithoutAreaIsStillAnEdge) {
  const Corners line{Vec3d{0, 0, 0}, {10, 0, 0}, {10, 0, 0}, {0, 0, 0}};
  const Foot foot = project(line, false, {4, 3, 0});
  EXPECT_FALSE(foot.over);
  EXPECT_NEAR(foot.gap, 3.0, 1e-12);
  EXPECT_EQ(norm(normal(line)), 0.0);
}

TEST(Segment, NormalAndDiagonal) {
  EXPECT_NEAR(normal(rectangle).z, 1.0, 1e-15);
  EXPECT_NEAR(0.05 * shorter_diagonal(rectangle), 0.6403, 1e-4);
  EXPECT_NEAR(normal(triangle).z, 1.0, 1e-15);
}

}  // namespace
}  // namespace nugget::weld
