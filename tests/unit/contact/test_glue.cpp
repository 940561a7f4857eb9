// SPDX-License-Identifier: Apache-2.0
#include "contact/glue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace nugget::contact {
namespace {

/// A heavy plate of one segment, 10 x 10 x 1, and one above it of the same size, whose four nodes are glued to it.
struct TwoPlates {
  SurfaceContactSetup setup;
  std::vector<Row> x, v, force;
  std::vector<double> mass;
  std::vector<unsigned char> alive{1, 1};

  TwoPlates() {
    for (int p = 0; p < 2; ++p) {
      const double low = p == 0 ? -20.0 : -5.0, high = -low, z = p;
      for (const Vec3d& c : {Vec3d{low, low, z}, Vec3d{high, low, z}, Vec3d{high, high, z}, Vec3d{low, high, z}}) {
        x.push_back({c.x, c.y, c.z, 0.0});
        mass.push_back(p == 0 ? 1e10 : 1e-5);
      }
      Segment s;
      s.node = {4 * p, 4 * p + 1, 4 * p + 2, 4 * p + 3};
      s.thickness = 1.0;
      s.bulk_modulus = 1e5;
      s.element = p;
      s.side = p == 0 ? 2 : 1;
      setup.segments.push_back(s);
    }
    v.resize(8);
    setup.nodes = nodes_of(setup.segments, 1, 2);
  }
  void pull(Glue& glue, const Vec3d& displacement) {
    for (std::size_t n = 4; n < 8; ++n) nugget::add(x[n], displacement);
    force.assign(8, {});
    glue.apply({0.0, 0.0, 0.0, 0.0, x, v, mass, alive}, force);
  }
};

model::Glue brittle(double normal_strength, double shear_strength) {
  model::Glue glue;
  glue.law.normal_strength = normal_strength;
  glue.law.shear_strength = shear_strength;
  return glue;
}

constexpr double area = 25.0;  // of a node
// That of the lower segment, by area.
const double stiffness = 0.1 * 1e5 * 1600.0 / (40.0 * std::sqrt(2.0)) * area / 1600.0;

// The force is that of the spring; at (25 area) x strength the node is released. Sabotage: the area of the whole
// segment.
TEST(Glue, FailsAtItsStrengthInTension) {
  TwoPlates s;
  Glue glue(s.setup, brittle(10.0, 0.0), s.x);
  EXPECT_EQ(glue.at_start(), 4);
  const double at_failure = 10.0 * area / stiffness;
  s.pull(glue, {0, 0, 0.99 * at_failure});
  EXPECT_EQ(glue.failed(), 0);
  EXPECT_NEAR(s.force[4].z, -0.99 * 10.0 * area, 1e-9);
  Vec3d sum;
  for (const Row& f : s.force) sum += vec(f);
  EXPECT_NEAR(norm(sum), 0.0, 1e-12 * 10.0 * area);
  s.pull(glue, {0, 0, 0.02 * at_failure});
  EXPECT_EQ(glue.failed(), 4);
  EXPECT_EQ(s.force[4].z, 0.0);
  EXPECT_EQ(glue.bonded(), (std::vector<unsigned char>{0, 0, 0, 0}));
}

TEST(Glue, TensionAndShearAddUpByTheirSquares) {
  for (const double share : {0.99, 1.01}) {
    TwoPlates s;
    Glue glue(s.setup, brittle(10.0, 20.0), s.x);
    const double c = share * area / stiffness;
    s.pull(glue, {20.0 * std::sqrt(0.5) * c, 0.0, 10.0 * std::sqrt(0.5) * c});
    EXPECT_EQ(glue.failed(), share > 1.0 ? 4 : 0);
  }
}

TEST(Glue, CompressionDoesNotFailIt) {
  TwoPlates s;
  Glue glue(s.setup, brittle(10.0, 20.0), s.x);
  s.pull(glue, {0, 0, -100.0 * area / stiffness});
  EXPECT_EQ(glue.failed(), 0);
  EXPECT_NEAR(s.force[4].z, 100.0 * area, 1e-9);
}

TEST(Glue, GoesWithItsShell) {
  TwoPlates s;
  Glue glue(s.setup, brittle(10.0, 20.0), s.x);
  s.alive = {0, 1};
  s.pull(glue, {});
  EXPECT_EQ(glue.failed(), 4);
}

// A wall goes down from the edge of the lower plate, below two of the four nodes. Pulled up, these are in tension all
// the same. Sabotage caught: the first of the closest segments.
TEST(Glue, AboveAFoldThePlateBelowHolds) {
  TwoPlates s;
  for (std::size_t n : {0, 3}) s.x[n].x = -5.0;
  for (double y : {-20.0, 20.0}) {
    s.x.push_back({-5.0, y, -20.0, 0.0});
    s.mass.push_back(1e10);
  }
  s.v.resize(10);
  Segment wall = s.setup.segments[0];
  wall.node = {8, 0, 3, 9};
  s.setup.segments.insert(s.setup.segments.begin(), wall);
  Glue glue(s.setup, brittle(10.0, 0.0), s.x);
  EXPECT_EQ(glue.at_start(), 4);
  s.force.assign(10, {});
  for (std::size_t n = 4; n < 8; ++n) s.x[n].z += 20.0 * area / stiffness;
  glue.apply({0.0, 0.0, 0.0, 0.0, s.x, s.v, s.mass, s.alive}, s.force);
  EXPECT_EQ(glue.failed(), 4);
}

// Glue that slides goes off the plate where a wall goes down from its edge: until it lets go it holds the height above
// the plate, whichever of the two segments round-off makes the closer one. Sabotage: the wall goes on as the plate.
TEST(Glue, SlidesOffAnEdgeWithoutForce) {
  TwoPlates s;
  for (double y : {-20.0, 20.0}) {
    s.x.push_back({20.0, y, -20.0, 0.0});
    s.mass.push_back(1e10);
  }
  s.v.resize(10);
  Segment wall = s.setup.segments[0];
  wall.node = {1, 8, 9, 2};
  s.setup.segments.push_back(wall);
  const auto turned = [](const Vec3d& p) {  // by 36.9 degrees about each of two axes
    const Vec3d q{0.8 * p.x - 0.6 * p.y, 0.6 * p.x + 0.8 * p.y, p.z};
    return Vec3d{q.x, 0.8 * q.y - 0.6 * q.z, 0.6 * q.y + 0.8 * q.z};
  };
  for (Row& p : s.x) set(p, turned(vec(p)));
  model::Glue card = brittle(10.0, 0.0);
  card.slides = true;
  Glue glue(s.setup, card, s.x);
  EXPECT_EQ(glue.at_start(), 4);
  s.pull(glue, turned({15.0, 0.0, 0.0}));
  for (int k = 0; k < 100; ++k) {
    s.force.assign(10, {});
    for (std::size_t n = 4; n < 8; ++n) nugget::add(s.x[n], turned({0.009, 0.0313, 0.0}));
    glue.apply({0.0, 0.0, 0.0, 0.0, s.x, s.v, s.mass, s.alive}, s.force);
    for (const Row& f : s.force) EXPECT_NEAR(norm(vec(f)), 0.0, 1e-9 * area * stiffness) << k;
  }
  EXPECT_EQ(glue.failed(), 0);
  s.force.assign(10, {});
  for (std::size_t n = 4; n < 8; ++n) nugget::add(s.x[n], turned({0.3, 0.0, 0.0}));
  glue.apply({0.0, 0.0, 0.0, 0.0, s.x, s.v, s.mass, s.alive}, s.force);
  EXPECT_EQ(glue.failed(), 2);
}

TEST(Glue, HoldsOnlyWhatTouches) {
  TwoPlates s;
  for (std::size_t n = 4; n < 6; ++n) s.x[n].z += 0.06;
  EXPECT_EQ(Glue(s.setup, brittle(10.0, 20.0), s.x).at_start(), 2);
}

}  // namespace
}  // namespace nugget::contact
