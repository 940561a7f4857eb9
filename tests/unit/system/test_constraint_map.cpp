// SPDX-License-Identifier: Apache-2.0
#include "system/constraint_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "base/parallel.hpp"

namespace nugget::system {
namespace {

using Term = ConstraintMap::Term;
using Corner = ConstraintMap::Corner;
using Turn = ConstraintMap::Turn;

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

constexpr std::size_t all = 14;
constexpr std::size_t dependents[] = {6, 7, 8, 9, 10, 11, 12, 13};

/// Nodes 0 to 5 independent; 6 to 8 follow segments, 6 with an arm, 8 without rotations; 9 follows 6 and 7 (a chain);
/// 10 a body's node; 11 is turned about the normal of a segment by its corners, two of which are dependent themselves;
/// 12 is turned wholly by corners, with an arm; 13 follows these two. `x`: where the nodes are.
ConstraintMap some_map(Random& random, std::vector<Vec3d>& x) {
  ConstraintMap map;
  x.assign(all, {});
  for (std::size_t i = 0; i < 6; ++i) x[i] = random.vector();
  const auto put = [&](std::size_t d, bool rotations, const std::vector<Term>& terms) {
    for (const Term& t : terms) x[d] += t.weight * (x[t.node] + t.arm);
    map.add(static_cast<int>(d), rotations, terms);
  };
  const auto put_turned = [&](std::size_t d, const std::vector<Term>& terms, Turn turn,
                              std::initializer_list<int> nodes, const Vec3d& own_arm) {
    std::vector<Corner> corners;
    for (int n : nodes) corners.push_back({n, 1.0, x[n]});
    for (const Term& t : terms) x[d] += t.weight * (x[t.node] + t.arm);
    x[d] += own_arm;
    map.add(static_cast<int>(d), true, terms, turn, corners, own_arm);
  };
  const Vec3d arm = random.vector();
  put(6, true, {{0, 0.4, arm}, {1, 0.1, arm}, {2, 0.2, arm}, {3, 0.3, arm}});
  put(7, true, {{2, 0.5, {}}, {3, 0.25, {}}, {4, 0.25, {}}});
  put(8, false, {{4, 0.6, {}}, {0, 0.4, {}}});
  put(10, true, {{5, 1.0, random.vector()}});
  put_turned(11, {{0, 0.3, arm}, {6, 0.7, arm}}, Turn::twist, {0, 6, 2, 8}, {});
  put_turned(12, {{1, 0.25, {}}, {3, 0.75, {}}}, Turn::whole, {1, 3, 4, 7}, random.vector());
  put(13, true, {{11, 0.5, arm}, {12, 0.5, arm}});
  put(9, true, {{6, 0.3, random.vector()}, {7, 0.7, {}}});
  return map;
}

// Sabotage to be caught: cross(force, arm) for cross(arm, force); moments of rows without rotations handed over; the
// component along the normal handed over twice; corners' forces without the moment of the row's own arm.
TEST(ConstraintMap, VirtualPowerIsTheSameOnBothSides) {
  Random random;
  std::vector<Vec3d> x;
  ConstraintMap map = some_map(random, x);
  ASSERT_TRUE(map.sort_rows(all).empty());
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Row> f = random.rows(all), m = random.rows(all), v = random.rows(all), w = random.rows(all);
    for (std::size_t d : dependents) {
      v[d] = Row{};
      if (d != 8) w[d] = Row{};
    }
    std::vector<Row> tv = v, tw = w;
    map.apply_to_velocities(0.0, tv, tw);
    const double before = power(f, tv) + power(m, tw);
    map.transfer_forces(f, m);
    EXPECT_NEAR(power(f, v) + power(m, w), before, 1e-12);
    for (std::size_t d : dependents) EXPECT_EQ(dot(vec(f[d]), vec(f[d])), 0.0);
  }
}

// What NVH takes is what impact does.
TEST(ConstraintMap, BlocksAreTheMapItself) {
  Random random;
  std::vector<Vec3d> x;
  ConstraintMap map = some_map(random, x);
  map.sort_rows(all);
  std::vector<Row> v = random.rows(all), w = random.rows(all);
  const std::vector<Row> qv = v, qw = w;
  map.apply_to_velocities(0.0, v, w);
  for (std::size_t d : dependents) {
    double sum[6] = {};
    for (const ConstraintMap::Block& b : map.blocks(static_cast<int>(d))) {
      const Row &bv = qv[b.node], &bw = qw[b.node];
      const double q[6] = {bv.x, bv.y, bv.z, bw.x, bw.y, bw.z};
      EXPECT_TRUE(b.node == 8 || !map.dependent(b.node));
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) sum[i] += b.of[i][j] * q[j];
    }
    EXPECT_NEAR(norm(Vec3d{sum[0], sum[1], sum[2]} - vec(v[d])), 0.0, 1e-12) << d;
    if (d == 8) continue;
    EXPECT_NEAR(norm(Vec3d{sum[3], sum[4], sum[5]} - vec(w[d])), 0.0, 1e-12) << d;
  }
}

// docs/theory/weld.md#reference-values: on a square of side a each corner gets M / (2 sqrt(2) a), tangentially.
TEST(ConstraintMap, ATwistBecomesInPlaneForces) {
  const double a = 7.0, moment = 300.0;
  const Vec3d x[4] = {{0, 0, 0}, {a, 0, 0}, {a, a, 0}, {0, a, 0}};
  std::vector<Term> terms;
  std::vector<Corner> corners;
  for (int i = 0; i < 4; ++i) {
    terms.push_back({i, 0.25, {}});
    corners.push_back({i, 1.0, x[i]});
  }
  ConstraintMap map;
  map.add(4, true, terms, Turn::twist, corners);
  map.sort_rows(5);
  std::vector<Row> f(5), m(5);
  set(m[4], {20.0, -10.0, moment});
  map.transfer_forces(f, m);
  Vec3d force{}, twist{}, couples{};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(norm(vec(f[i])), moment / (2.0 * std::sqrt(2.0) * a), 1e-12);
    EXPECT_NEAR(dot(vec(f[i]), x[i] - Vec3d{0.5 * a, 0.5 * a, 0}), 0.0, 1e-12);
    EXPECT_NEAR(vec(m[i]).z, 0.0, 1e-12);
    force += vec(f[i]);
    twist += cross(x[i], vec(f[i]));
    couples += vec(m[i]);
  }
  EXPECT_NEAR(norm(force), 0.0, 1e-12);
  EXPECT_NEAR(norm(twist - Vec3d{0, 0, moment}), 0.0, 1e-12);
  EXPECT_NEAR(norm(couples - Vec3d{20.0, -10.0, 0}), 0.0, 1e-12);
}

TEST(ConstraintMap, ChainsAreWorkedThroughInOrder) {
  Random random;
  std::vector<Vec3d> x;
  ConstraintMap map = some_map(random, x);
  map.sort_rows(all);
  double sum = 0.0;
  for (const ConstraintMap::Block& b : map.blocks(9)) {
    EXPECT_LT(b.node, 6);
    sum += b.of[0][0];
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_EQ(map.blocks(9).size(), 5u);  // 0 1 2 3 4, each once
  EXPECT_TRUE(map.dependent(9));
  EXPECT_FALSE(map.dependent(5));
}

TEST(ConstraintMap, MassIsHandedOverWholeButBodiesNodesKeepTheirs) {
  ConstraintMap map;  // 5 is a body; 3 follows 2, which belongs to it, and 1; 4 follows 3
  map.add(4, true, std::vector<Term>{{3, 0.5, {}}, {0, 0.5, {0, 2, 0}}});
  map.add(3, true, std::vector<Term>{{2, 0.25, {}}, {1, 0.75, {}}});
  map.add(2, true, std::vector<Term>{{5, 1.0, {1, 2, 3}}});
  map.sort_rows(6);
  std::vector<double> mass{1, 1, 1, 1, 1, 0}, inertia{0, 0, 0, 0.5, 0.25, 0};
  map.transfer_mass(mass, inertia, 5);
  EXPECT_EQ(mass, (std::vector<double>{1.5, 2.125, 1.375, 0, 0, 0}));
  EXPECT_EQ(inertia, (std::vector<double>{0.5 * (0.25 + 4.0), 0.75 * 0.625, 0.25 * 0.625, 0, 0, 0}));
}

TEST(ConstraintMap, ANodeOfTranslationsAloneKeepsItsRotaryInertia) {
  ConstraintMap map;
  map.add(2, false, std::vector<Term>{{0, 0.25, {}}, {1, 0.75, {0, 2, 0}}});
  map.sort_rows(3);
  std::vector<double> mass{1, 1, 2}, inertia{0, 0, 0.5};
  map.transfer_mass(mass, inertia, 3);
  EXPECT_EQ(mass, (std::vector<double>{1.5, 2.5, 0}));
  EXPECT_EQ(inertia, (std::vector<double>{0, 0.75 * 2.0 * 4.0, 0.5}));
}

TEST(ConstraintMap, ARemovedRowLetsItsNodeGo) {
  Random random;
  std::vector<Vec3d> x;
  ConstraintMap map = some_map(random, x);
  map.sort_rows(all);
  map.remove(6);
  EXPECT_FALSE(map.dependent(6));
  std::vector<Row> v = random.rows(all), w = random.rows(all);
  const std::vector<Row> before = v;
  map.apply_to_velocities(0.01, v, w);
  EXPECT_EQ(vec(v[6]).x, vec(before[6]).x);
  EXPECT_TRUE(std::any_of(map.terms(9).begin(), map.terms(9).end(), [](const Term& t) { return t.node == 6; }));
}

// A rigid motion of the independent nodes must carry every dependent node along, in place and angle. Spins from corners
// are those of the chord, (2 tan(phi / 2) - phi) / dt too fast.
TEST(ConstraintMap, FollowsARigidMotion) {
  Random random;
  std::vector<Vec3d> x;
  ConstraintMap map = some_map(random, x);
  map.sort_rows(all);
  const Vec3d phi{3e-5, -5e-5, 2e-5};
  const double dt = 0.1;
  for (int step = 0; step < 200; ++step) {  // arms turn along
    std::vector<Row> v(all), w(all);
    for (std::size_t i = 0; i < 6; ++i) {
      set(v[i], (1.0 / dt) * (turned(x[i], phi) - x[i]));
      set(w[i], (1.0 / dt) * phi);
    }
    set(w[8], (1.0 / dt) * phi);
    map.apply_to_velocities(dt, v, w);
    for (std::size_t i = 0; i < all; ++i) {
      const Vec3d end = turned(x[i], phi);
      const Vec3d moved = x[i] + dt * vec(v[i]);
      EXPECT_NEAR(norm(moved - end), 0.0, 1e-12) << i;
      EXPECT_NEAR(norm(dt * vec(w[i]) - phi), 0.0, 1e-12) << i;
      x[i] = end;
    }
  }
}

TEST(ConstraintMap, CirclesAreFound) {
  ConstraintMap map;
  map.add(0, true, std::vector<Term>{{1, 1.0, {}}});
  map.add(1, true, std::vector<Term>{{2, 0.5, {}}, {3, 0.5, {}}});
  map.add(2, true, std::vector<Term>{{0, 1.0, {}}});
  EXPECT_FALSE(map.sort_rows(4).empty());
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
    map.sort_rows(4000);
    std::vector<Row> v = random.rows(4000), w = random.rows(4000);
    map.apply_to_velocities(0.01, v, w);
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

// Sabotage: the arm not shifted with the centre.
TEST(ConstraintMap, OtherWeightsKeepTheNodeAndFollowRigidMotion) {
  Random random;
  std::vector<Vec3d> x(5);
  std::vector<Term> terms;
  std::vector<Corner> corners;
  const std::array<double, 4> first{0.1, 0.2, 0.3, 0.4}, second{0.5, 0.0, 0.2, 0.3};
  Vec3d centre;
  for (std::size_t i = 0; i < 4; ++i) {
    x[i] = random.vector();
    terms.push_back({static_cast<int>(i), first[i], {}});
    corners.push_back({static_cast<int>(i), first[i], x[i]});
    centre += first[i] * x[i];
  }
  x[4] = random.vector();
  ConstraintMap map;
  map.add(4, true, terms, Turn::whole, corners, x[4] - centre);
  map.sort_rows(5);
  map.set_weights(4, second);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(map.terms(4)[i].weight, second[i]);
  const Vec3d velocity = random.vector(), omega = random.vector();
  std::vector<Row> v(5), w(5);
  for (std::size_t i = 0; i < 4; ++i) set(v[i], velocity + cross(omega, x[i]));
  map.apply_to_velocities(0.0, v, w);
  EXPECT_LT(norm(vec(v[4]) - velocity - cross(omega, x[4])), 1e-14);
  EXPECT_LT(norm(vec(w[4]) - omega), 1e-14);
}

}  // namespace
}  // namespace nugget::system
