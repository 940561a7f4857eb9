// SPDX-License-Identifier: Apache-2.0
#include "system/order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace nugget::system {
namespace {

std::vector<Vec3d> grid(int n) {
  std::vector<Vec3d> points;
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) points.push_back({10.0 * i, 10.0 * j, 10.0 * k});
  return points;
}

// Sabotage to be caught: one coordinate left out of the code; a sort that is not stable.
TEST(MortonOrder, IsAPermutationThatKeepsNeighboursClose) {
  const std::vector<Vec3d> points = grid(8);
  const std::vector<int> order = morton_order(points);
  std::vector<int> sorted = order, all(points.size());
  std::sort(sorted.begin(), sorted.end());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(sorted, all);
  double along = 0.0, shuffled = 0.0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    along += norm(points[order[i]] - points[order[i - 1]]);
    shuffled += norm(points[(i * 211) % 512] - points[((i - 1) * 211) % 512]);
  }
  EXPECT_LT(along / 511.0, 20.0);
  EXPECT_GT(shuffled / 511.0, 35.0);
  // The first eight are the corner's cube.
  for (std::size_t i = 0; i < 8; ++i) EXPECT_LE(norm(points[order[i]]), 18.0);
}

TEST(MortonOrder, EqualPointsKeepTheirOrderAndFlatOnesAreFine) {
  EXPECT_EQ(morton_order(std::vector<Vec3d>(4, Vec3d{1, 2, 3})), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(morton_order({{3, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}}), (std::vector<int>{1, 3, 2, 0}));
  EXPECT_TRUE(morton_order({}).empty());
}

}  // namespace
}  // namespace nugget::system
