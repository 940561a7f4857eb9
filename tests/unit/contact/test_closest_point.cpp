// SPDX-License-Identifier: Apache-2.0
#include "kernel/contact/closest_point.hpp"

#include <gtest/gtest.h>

#include <bit>
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

/// Pairs whose lanes go different ways: inside, over an edge, over a corner or exactly on it, a segment without area.
TEST(ClosestPoint, LanesGiveTheBitsOfDouble) {
  using R = NativeBatch;
  std::mt19937 random(13);
  std::uniform_real_distribution<double> at(-1.0, 3.0), height(-1.5, 1.5);
  int boundaries[3] = {};
  for (int i = 0; i < 2000; ++i) {
    CornersOf<R> corners;
    Vec3<R> x;
    R xi, eta;
    std::array<Foot, lanes<R>> alone;
    std::array<double, lanes<R>> least;
    for (int l = 0; l < lanes<R>; ++l) {
      const Corners c = (i + l) % 5 == 0 ? Corners{warped[0], warped[0], warped[2], warped[3]}
                        : l % 2          ? warped
                                         : square;
      Vec3d p{at(random), at(random), height(random)};
      if ((i + l) % 3 == 0) p = c[i % 4] + Vec3d{0.0, 0.0, 1.0};
      const Vec3d start = i % 2 ? Vec3d{1.0, -1.0, 0.0} : Vec3d{};
      for (int k = 0; k < 4; ++k) {
        set_lane(corners[k].x, l, c[k].x);
        set_lane(corners[k].y, l, c[k].y);
        set_lane(corners[k].z, l, c[k].z);
      }
      set_lane(x.x, l, p.x);
      set_lane(x.y, l, p.y);
      set_lane(x.z, l, p.z);
      set_lane(xi, l, start.x);
      set_lane(eta, l, start.y);
      alone[l] = closest_point(c, false, p, start.x, start.y);
      least[l] = least_distance(c, p);
    }
    const Feet<R> feet = closest_points(corners, x, xi, eta);
    const R clear = least_distance(corners, x);
    for (int l = 0; l < lanes<R>; ++l) {
      const Foot foot = feet.at(l);
      EXPECT_EQ(foot.xi, alone[l].xi);
      EXPECT_EQ(foot.eta, alone[l].eta);
      EXPECT_EQ(foot.weight, alone[l].weight);
      EXPECT_EQ(norm(foot.point - alone[l].point), 0.0);
      EXPECT_EQ(norm(foot.normal - alone[l].normal), 0.0);
      EXPECT_EQ(foot.distance, alone[l].distance);
      EXPECT_EQ(foot.boundary, alone[l].boundary);
      EXPECT_EQ(lane(clear, l), least[l]);
      ++boundaries[std::min(std::popcount(foot.boundary), 2)];
    }
  }
  for (const int count : boundaries) EXPECT_GT(count, 500);
}

TEST(ClosestPoint, SegmentWithoutAreaGivesItsEdge) {
  const Corners line{{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
  const Foot foot = closest_point(line, false, {0.5, 1.0, 0.0});
  EXPECT_NEAR(foot.distance, 1.0, 1e-14);
}

/// Of nodes around quadrilaterals, flat and warped: whether the closest point lies on the first edge, or on the first
/// corner, as the search of the closest point finds it, and for how far a motion.
TEST(RoomAtFirst, SaysWhereTheClosestPointIsAndStays) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> somewhere(-1.0, 1.0);
  constexpr double round_off = 1e-9;
  const auto anywhere = [&] { return Vec3d{somewhere(random), somewhere(random), somewhere(random)}; };
  const auto is_at_first = [](const Corners& c, double edge, const Vec3d& x) {
    const unsigned boundary = closest_point(c, false, x).boundary;
    return edge == 1.0 ? boundary != 0 && (boundary & ~0b0011u) == 0 : boundary == 0b0001u;
  };
  for (const bool flat : {true, false})
    for (const double edge : {0.0, 1.0}) {
      int there = 0, found = 0;
      double longest = 0.0;
      for (int i = 0; i < 4000; ++i) {
        Corners c = square;
        for (Vec3d& corner : c)
          corner += 0.3 * Vec3d{somewhere(random), somewhere(random), flat ? 0.0 : somewhere(random)};
        const Vec3d x = Vec3d{1.0 + 2.0 * somewhere(random), 2.0 * somewhere(random), somewhere(random)};
        const double room = room_at_first(c, edge, x, round_off);
        const bool here = is_at_first(c, edge, x);
        there += here;
        found += room > 0.0;
        if (!(room > 0.0)) continue;
        EXPECT_TRUE(here);
        longest = std::max(longest, room);
        // Two points have come closer to each other by the room at most: each has moved by half of it.
        for (int k = 0; k < 20; ++k) {
          const auto moved = [&](const Vec3d& p) {
            const Vec3d way = anywhere();
            return p + (0.5 * room / norm(way)) * way;
          };
          const Corners then{moved(c[0]), moved(c[1]), moved(c[2]), moved(c[3])};
          EXPECT_TRUE(is_at_first(then, edge, moved(x)));
        }
      }
      // Of what is flat all are found; of what is warped some may not be.
      EXPECT_GT(there, 100);
      EXPECT_GE(found, flat ? there : there * 4 / 5);
      EXPECT_GT(longest, 0.3);
    }
}

TEST(RoomAtFirst, TiltIsTheSineOfAnAngle) {
  const Vec3d over{0.02, 0.0, 1.0}, beyond{0.02, -0.5, 1.0};  // the square, by 0.02 of the height; its first edge
  EXPECT_LT(room_at_first(square, 0.0, over, 0.01), 0.0);
  EXPECT_GT(room_at_first(square, 0.0, over, 0.03), 0.0);
  EXPECT_LT(room_at_first(square, 0.0, beyond, 0.01), 0.0);
  EXPECT_GT(room_at_first(square, 1.0, beyond, 0.01), 0.0);
  // Straight above a corner by 1, sides 2: 0.01 of the way is left, for a motion of the node and one of the way.
  EXPECT_NEAR(room_at_first(square, 0.0, Vec3d{0.0, 0.0, 1.0}, 0.01), 0.01 * 2.0 / 3.0, 1e-15);
}

TEST(RoomAtFirst, LanesGiveTheBitsOfDouble) {
  constexpr int width = lanes<NativeBatch>;
  std::mt19937 random(13);
  std::uniform_real_distribution<double> somewhere(-1.0, 1.0);
  CornersOf<NativeBatch> corners;
  Vec3<NativeBatch> x;
  NativeBatch edge;
  const auto put = [](Vec3<NativeBatch>& to, int l, const Vec3d& p) {
    set_lane(to.x, l, p.x);
    set_lane(to.y, l, p.y);
    set_lane(to.z, l, p.z);
  };
  std::array<double, width> expected{};
  for (int l = 0; l < width; ++l) {
    Corners c = warped;
    for (Vec3d& corner : c) corner += Vec3d{somewhere(random), somewhere(random), somewhere(random)};
    const Vec3d p{3.0 * somewhere(random), -somewhere(random), somewhere(random)};
    for (std::size_t k = 0; k < 4; ++k) put(corners[k], l, c[k]);
    put(x, l, p);
    set_lane(edge, l, l % 2);
    expected[static_cast<std::size_t>(l)] = room_at_first(c, static_cast<double>(l % 2), p, 0.01);
  }
  const NativeBatch room = room_at_first(corners, edge, x, NativeBatch(0.01));
  for (int l = 0; l < width; ++l) EXPECT_EQ(lane(room, l), expected[static_cast<std::size_t>(l)]);
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
