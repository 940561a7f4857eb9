// SPDX-License-Identifier: Apache-2.0
#include "system/constraint_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/parallel.hpp"

namespace nugget::system {
namespace {

using Term = ConstraintMap::Term;

struct Random {
  std::mt19937 engine{7};
  double number() { return std::uniform_real_distribution<double>(-1.0, 1.0)(engine); }
  Vec3d vector() { return {number(), number(), number()}; }
  std::vector<Row> rows(std::size_t n) {
    std::vector<Row> r(n);
    for (Row& row : r) set(row, vector());
    return r;
  }
};

double power(const std::vector<Row>& f, const std::vector<Row>& v) {
  double sum = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) sum += dot(vec(f[i]), vec(v[i]));
  return sum;
}

/// Nodes 0 to 5 independent; 6 to 8 follow segments, 6 with an arm, 8 without rotations; 9 follows 6 and 7 (a chain);
/// 10 a body's node.
ConstraintMap some_map(Random& random) {
  ConstraintMap map;
  map.add(9, true, std::vector<Term>{{6, 0.3, random.vector()}, {7, 0.7, {}}});
  const Vec3d arm = random.vector();
  map.add(6, true, std::vector<Term>{{0, 0.4, arm}, {1, 0.1, arm}, {2, 0.2, arm}, {3, 0.3, arm}});
  map.add(7, true, std::vector<Term>{{2, 0.5, {}}, {3, 0.25, {}}, {4, 0.25, {}}});
  map.add(8, false, std::vector<Term>{{4, 0.6, {}}, {0, 0.4, {}}});
  map.add(10, true, std::vector<Term>{{5, 1.0, random.vector()}});
  return map;
}

// Sabotage to be caught: cross(force, arm) for cross(arm, force); moments of rows without rotations handed over.
TEST(ConstraintMap, VirtualPowerIsTheSameOnBothSides) {
  Random random;
  ConstraintMap map = some_map(random);
  ASSERT_TRUE(map.close(11).empty());
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Row> f = random.rows(11), m = random.rows(11), v = random.rows(11), w = random.rows(11);
    for (int d : {6, 7, 8, 9, 10}) v[static_cast<std::size_t>(d)] = w[static_cast<std::size_t>(d)] = Row{};
    m[8] = Row{};  // has no rotations to work on
    std::vector<Row> tv = v, tw = w;
    map.follow(0.0, tv, tw);
    const double before = power(f, tv) + power(m, tw);
    map.collect(f, m);
    EXPECT_NEAR(power(f, v) + power(m, w), before, 1e-13);
    for (std::size_t d : {6u, 7u, 8u, 9u, 10u}) EXPECT_EQ(dot(vec(f[d]), vec(f[d])), 0.0);
  }
}

TEST(ConstraintMap, ChainsAreClosed) {
  Random random;
  ConstraintMap map = some_map(random);
  map.close(11);
  double sum = 0.0;
  for (const Term& t : map.terms(9)) {
    EXPECT_LT(t.node, 6);
    EXPECT_FALSE(map.dependent(t.node));
    sum += t.weight;
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_EQ(map.terms(9).size(), 5u);  // 0 1 2 3 4, each once
  EXPECT_TRUE(map.dependent(9));
  EXPECT_FALSE(map.dependent(5));
}

// A rigid motion of the independent nodes must carry every dependent node along.
TEST(ConstraintMap, FollowsARigidMotion) {
  Random random;
  ConstraintMap map = some_map(random);
  map.close(11);
  // Places: independent ones at random, dependent ones where their rows put them.
  std::vector<Vec3d> x(11);
  for (std::size_t i = 0; i < 6; ++i) x[i] = random.vector();
  for (int d = 6; d < 11; ++d)
    for (const Term& t : map.terms(d))
      x[static_cast<std::size_t>(d)] += t.weight * (x[static_cast<std::size_t>(t.node)] + t.arm);
  const Vec3d phi{0.3, -0.5, 0.2};
  const double dt = 0.1;
  for (int step = 0; step < 3; ++step) {  // arms turn along
    std::vector<Row> v(11), w(11);
    for (std::size_t i = 0; i < 6; ++i) {
      set(v[i], (1.0 / dt) * (turned(x[i], phi) - x[i]));
      set(w[i], (1.0 / dt) * phi);
    }
    map.follow(dt, v, w);
    for (std::size_t i = 0; i < 11; ++i) {
      const Vec3d end = turned(x[i], phi);
      const Vec3d moved = x[i] + dt * vec(v[i]);
      EXPECT_NEAR(norm(moved - end), 0.0, 1e-14) << i;
      x[i] = end;
    }
  }
}

TEST(ConstraintMap, CirclesAreFound) {
  ConstraintMap map;
  map.add(0, true, std::vector<Term>{{1, 1.0, {}}});
  map.add(1, true, std::vector<Term>{{2, 0.5, {}}, {3, 0.5, {}}});
  map.add(2, true, std::vector<Term>{{0, 1.0, {}}});
  EXPECT_FALSE(map.close(4).empty());
}

TEST(ConstraintMap, ThreadsDoNotChangeTheResult) {
  std::vector<Row> reference;
  for (int count : {1, 3}) {
    set_threads(count);
    Random random;
    ConstraintMap map;
    for (int d = 0; d < 2000; ++d) {
      const Vec3d arm = random.vector();
      map.add(2000 + d, true, std::vector<Term>{{d, 0.3, arm}, {(d + 7) % 2000, 0.7, arm}});
    }
    map.close(4000);
    std::vector<Row> v = random.rows(4000), w = random.rows(4000);
    map.follow(0.01, v, w);
    if (reference.empty()) reference = v;
    for (std::size_t i = 0; i < v.size(); ++i) ASSERT_EQ(vec(v[i]).y, vec(reference[i]).y);
  }
  set_threads(1);
}

TEST(Turned, IsARotation) {
  const Vec3d a{1, 2, 3}, phi{0.2, 0.4, -0.3};
  EXPECT_NEAR(norm(turned(a, phi)), norm(a), 1e-15 * 4);
  EXPECT_NEAR(norm(turned(turned(a, phi), -phi) - a), 0.0, 1e-15 * 8);
  EXPECT_NEAR(norm(turned(a, 1e-6 * phi) - (a + cross(1e-6 * phi, a))), 0.0, 1e-11);
  const Vec3d quarter = turned({1, 0, 0}, {0, 0, 1.57079632679489662});
  EXPECT_NEAR(quarter.y, 1.0, 1e-15);
}

}  // namespace
}  // namespace nugget::system
