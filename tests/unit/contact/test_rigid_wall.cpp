// SPDX-License-Identifier: Apache-2.0
#include "contact/rigid_wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/parallel.hpp"

namespace nugget::contact {
namespace {

constexpr double no_end = 1e20;

model::RigidWall floor_wall() {
  model::RigidWall wall;
  wall.normal = {0.0, 0.0, 1.0};
  wall.death = no_end;
  return wall;
}

/// Free masses under constant accelerations and one wall, by central differences.
struct Masses {
  std::vector<Row> x, v;
  std::vector<double> mass;
  std::vector<Vec3d> acceleration;
  std::vector<unsigned char> skip;
  double time = 0.0, dt = 1e-6;
  double force_work = 0.0;  // of the accelerations, f . (v_before + v_after)/2 dt
  double kinetic_before = 0.0;

  void add(const Vec3d& position, const Vec3d& velocity, double m = 1.0, const Vec3d& a = {}) {
    x.push_back({position.x, position.y, position.z, 0.0});
    v.push_back({velocity.x, velocity.y, velocity.z, 0.0});
    mass.push_back(m);
    acceleration.push_back(a);
  }
  std::vector<int> nodes() const {
    std::vector<int> all(x.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<int>(i);
    return all;
  }
  double kinetic() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * mass[i] * dot(vec(v[i]), vec(v[i]));
    return sum;
  }
  void step(RigidWall& wall, bool knows_speeds = false) {
    const std::vector<Row> before = v;
    std::vector<Row> force(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) nugget::add(force[i], mass[i] * acceleration[i]);
    for (std::size_t i = 0; i < x.size(); ++i) nugget::add(v[i], dt * acceleration[i]);
    double fastest = knows_speeds ? 0.0 : std::numeric_limits<double>::infinity();
    for (const Row& r : v) fastest = std::max(fastest, norm(vec(r)));
    wall.constrain(time, dt, dt, x, v, force, mass, skip, fastest);
    for (std::size_t i = 0; i < x.size(); ++i) {
      force_work += 0.5 * mass[i] * dt * dot(acceleration[i], vec(before[i]) + vec(v[i]));
      nugget::add(x[i], dt * vec(v[i]));
    }
    time += dt;
  }
};

TEST(RigidWall, MassStopsRidesAndLeaves) {
  Masses m;
  m.add({0.0, 0.0, 0.00105}, {3.0, 0.0, -1000.0}, 2.0);
  RigidWall wall(floor_wall(), m.nodes());
  m.step(wall);
  EXPECT_EQ(wall.touching(), 0);
  m.step(wall);  // lands: ends on the surface
  EXPECT_EQ(wall.touching(), 1);
  EXPECT_NEAR(m.x[0].z, 0.0, 1e-18);
  EXPECT_GT(wall.normal_force(), 0.0);
  m.step(wall);
  EXPECT_NEAR(m.v[0].z, 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(m.v[0].x, 3.0);
  EXPECT_NEAR(wall.impulse().z, 2000.0, 1e-9);                    // all momentum
  EXPECT_NEAR(wall.energy(), 0.5 * 2.0 * 1000.0 * 1000.0, 1e-6);  // all kinetic energy along the normal

  m.acceleration[0] = {0.0, 0.0, -5e6};  // pressed on
  for (int i = 0; i < 100; ++i) m.step(wall);
  EXPECT_NEAR(m.x[0].z, 0.0, 1e-15);
  EXPECT_NEAR(wall.normal_force(), 2.0 * 5e6, 1e-3);
  const double resting = wall.energy();
  for (int i = 0; i < 100; ++i) m.step(wall);
  EXPECT_DOUBLE_EQ(wall.energy(), resting);  // a node at rest gives nothing

  m.acceleration[0] = {0.0, 0.0, 5e6};  // pulled off
  m.step(wall);
  EXPECT_EQ(wall.touching(), 0);
  EXPECT_EQ(wall.normal_force(), 0.0);
  EXPECT_DOUBLE_EQ(m.v[0].z, 5.0);
}

/// Each mass that lands gives m v in one step. Sabotage: areas that stay behind as the wall moves; the edge counted
/// twice.
TEST(RigidWall, SumsUpForcesOfNodesAndAreasApart) {
  Masses m;
  m.add({0.5, 0.5, 0.0}, {0.0, 0.0, -1000.0}, 2.0);
  m.add({1.0, 0.5, 0.0}, {0.0, 0.0, -2000.0}, 3.0);  // on the edge of both squares
  m.add({1.5, 0.5, 0.0}, {0.0, 0.0, -1000.0}, 4.0);
  m.add({5.0, 0.5, 0.0}, {0.0, 0.0, -1000.0}, 5.0);   // in none
  m.add({2.75, 0.5, 0.0}, {0.0, 0.0, -1000.0}, 6.0);  // in the triangle
  m.add({2.25, 0.9, 0.0}, {0.0, 0.0, -1000.0}, 7.0);  // beside it
  const auto square = [](double x) {
    return std::array<Vec3d, 4>{{{x, 0.0, 0.0}, {x + 1.0, 0.0, 0.0}, {x + 1.0, 1.0, 0.0}, {x, 1.0, 0.0}}};
  };
  RigidWall wall(floor_wall(), m.nodes());
  const std::size_t nodes = wall.sum_apart(std::vector<int>{1, 3}), left = wall.sum_apart(square(0.0)),
                    right = wall.sum_apart(square(1.0)),
                    triangle = wall.sum_apart(
                        std::array<Vec3d, 4>{{{2.0, 0.0, 0.0}, {3.0, 0.0, 0.0}, {3.0, 1.0, 0.0}, {3.0, 1.0, 0.0}}});
  m.step(wall);
  EXPECT_NEAR(m.dt * wall.force_apart(nodes).z, 3.0 * 2000.0 + 5.0 * 1000.0, 1e-8);
  EXPECT_NEAR(m.dt * wall.force_apart(left).z, 2.0 * 1000.0 + 3.0 * 2000.0, 1e-8);
  EXPECT_NEAR(m.dt * wall.force_apart(right).z, 4.0 * 1000.0, 1e-8);
  EXPECT_NEAR(m.dt * wall.force_apart(triangle).z, 6.0 * 1000.0, 1e-8);
  m.step(wall);
  EXPECT_NEAR(wall.force_apart(nodes).z, 0.0, 1e-6);

  // The wall moves by 1 along x, and what lands then meets the area that was beside it.
  model::RigidWall card = floor_wall();
  card.motion_direction = {1.0, 0.0, 0.0};
  Masses later;
  later.add({1.5, 0.5, 0.0105}, {0.0, 0.0, -1000.0}, 2.0);
  const Curve motion{1, {0.0, 1.0}, {1e5, 1e5}};
  RigidWall moving(card, later.nodes(), &motion);
  const std::size_t area = moving.sum_apart(square(0.0));
  double impulse = 0.0;
  for (int i = 0; i < 20; ++i) {
    later.step(moving);
    impulse += later.dt * moving.force_apart(area).z;
  }
  EXPECT_NEAR(impulse, 2000.0, 1e-6);
}

TEST(RigidWall, NodeBehindTheWallGoesNoDeeper) {
  Masses m;
  m.add({0.0, 0.0, -0.5}, {0.0, 0.0, -100.0});
  RigidWall wall(floor_wall(), m.nodes());
  m.step(wall);
  EXPECT_DOUBLE_EQ(m.x[0].z, -0.5);
  EXPECT_NEAR(m.v[0].z, 0.0, 1e-9);
}

TEST(RigidWall, SkippedNodeIsLeftAlone) {
  Masses m;
  m.add({0.0, 0.0, 0.0}, {0.0, 0.0, -100.0});
  m.skip = {1};
  RigidWall wall(floor_wall(), m.nodes());
  m.step(wall);
  EXPECT_EQ(m.v[0].z, -100.0);
  EXPECT_EQ(wall.touching(), 0);
}

TEST(RigidWall, BirthAndDeath) {
  model::RigidWall card = floor_wall();
  card.birth = 2.5e-6;
  card.death = 4.5e-6;
  Masses m;
  m.add({0.0, 0.0, 0.0}, {0.0, 0.0, -100.0});
  RigidWall wall(card, m.nodes());
  std::vector<int> touching;
  for (int i = 0; i < 6; ++i) {
    m.acceleration[0] = {0.0, 0.0, -1e6};
    m.step(wall);
    touching.push_back(wall.touching());
  }
  EXPECT_EQ(touching, (std::vector<int>{0, 0, 0, 1, 1, 0}));
}

// Block sliding to rest: mu = 0.2, 1000 g press the block on, v = 2000 mm/s: stops after 1.019368 mm at 1.019368e-3 s.
TEST(RigidWall, CoulombBlockStopsAsInClosedForm) {
  model::RigidWall card = floor_wall();
  card.friction = 0.2;
  Masses m;
  m.add({0.0, 0.0, 5e-5}, {2000.0, 0.0, 0.0}, 1e-3, {0.0, 0.0, -9.81e6});
  const double kinetic = m.kinetic();
  RigidWall wall(card, m.nodes());
  double stopped_at = 0.0;
  for (int i = 0; i < 1200; ++i) {
    m.step(wall);
    if (stopped_at == 0.0 && m.v[0].x == 0.0) stopped_at = m.time;
  }
  EXPECT_NEAR(stopped_at, 1.019368e-3, 2e-6);
  EXPECT_NEAR(m.x[0].x, 1.019368, 2e-3);
  EXPECT_NEAR(wall.energy(), kinetic + m.force_work, 1e-12 * kinetic);
}

TEST(RigidWall, FrictionOneSticks) {
  model::RigidWall card = floor_wall();
  card.friction = 1.0;
  Masses m;
  m.add({0.0, 0.0, 1e-4}, {2000.0, 0.0, -1000.0});
  RigidWall wall(card, m.nodes());
  m.step(wall);
  EXPECT_EQ(m.v[0].x, 0.0);
  EXPECT_NEAR(m.x[0].z, 0.0, 1e-18);
}

TEST(RigidWall, FastNodeIsWeldedSlowOneIsNot) {
  for (double friction : {2.0, 3.0}) {
    model::RigidWall card = floor_wall();
    card.friction = friction;
    card.weld_velocity = 500.0;
    Masses m;
    m.add({0.0, 0.0, 0.0}, {100.0, 0.0, -600.0});
    m.add({9.0, 0.0, 0.0}, {100.0, 0.0, -400.0});
    RigidWall wall(card, m.nodes());
    m.step(wall);
    EXPECT_EQ(m.v[0].x, friction == 2.0 ? 100.0 : 0.0);
    m.acceleration = {{0.0, 0.0, 1e6}, {0.0, 0.0, 1e6}};
    m.step(wall);
    EXPECT_EQ(m.v[0].z, 0.0);
    EXPECT_DOUBLE_EQ(m.v[1].z, 1.0);
    EXPECT_NEAR(wall.force().z, -1e6, 1e-6);  // the weld pulls
  }
}

TEST(RigidWall, MovingWallSharesMomentumPlastically) {
  model::RigidWall card = floor_wall();
  card.mass = 10.0;
  card.velocity = 500.0;
  Masses m;
  m.add({0.0, 0.0, 0.0}, {0.0, 0.0, -1000.0}, 3.0);
  m.add({1.0, 0.0, 0.0}, {7.0, 0.0, -200.0}, 2.0);
  m.add({2.0, 0.0, 0.3}, {0.0, 0.0, 0.0}, 1.0);  // not reached
  const double momentum = 10.0 * 500.0 - 3.0 * 1000.0 - 2.0 * 200.0;
  const double energy = m.kinetic() + 0.5 * 10.0 * 500.0 * 500.0;
  RigidWall wall(card, m.nodes());
  m.step(wall);
  const double common = momentum / 15.0;
  EXPECT_NEAR(wall.velocity(), common, 1e-10);
  EXPECT_NEAR(m.v[0].z, common, 1e-10);
  EXPECT_NEAR(m.v[1].z, common, 1e-10);
  EXPECT_EQ(m.v[1].x, 7.0);
  EXPECT_EQ(m.v[2].z, 0.0);
  EXPECT_NEAR(wall.origin().z, common * m.dt, 1e-18);
  // Plastic collision: the loss in the centre-of-mass system.
  const double after = m.kinetic() + wall.kinetic_energy();
  EXPECT_NEAR(wall.energy() - (wall.kinetic_energy() - 0.5 * 10.0 * 500.0 * 500.0), energy - after, 1e-6);
  const double reduced = 0.5 * 10.0 * 500.0 * 500.0 + 0.5 * 3.0 * 1e6 + 0.5 * 2.0 * 4e4 - 0.5 * 15.0 * common * common;
  EXPECT_NEAR(energy - after, reduced, 1e-6);
}

TEST(RigidWall, SlowedWallLetsGoOfWhatItNoLongerReaches) {
  // The second node would be caught by the wall at its old speed, not by the one that the heavy first node has turned.
  model::RigidWall card = floor_wall();
  card.mass = 1.0;
  card.velocity = 500.0;
  Masses m;
  m.add({0.0, 0.0, 0.0}, {0.0, 0.0, -1000.0}, 100.0);
  m.add({1.0, 0.0, 0.0}, {0.0, 0.0, 400.0}, 1.0);
  RigidWall wall(card, m.nodes());
  m.step(wall);
  EXPECT_NEAR(wall.velocity(), (500.0 - 1e5) / 101.0, 1e-9);
  EXPECT_EQ(m.v[1].z, 400.0);
}

TEST(RigidWall, MovingWallKeepsMomentumOverManySteps) {
  model::RigidWall card = floor_wall();
  card.mass = 5.0;
  card.velocity = 1000.0;
  Masses m;
  for (int i = 0; i < 50; ++i) m.add({1.0 * i, 0.0, 1e-3 * i}, {0.0, 0.0, -10.0 * i}, 0.1 + 0.01 * i);
  RigidWall wall(card, m.nodes());
  const auto momentum = [&] {
    double sum = card.mass * wall.velocity();
    for (std::size_t i = 0; i < m.x.size(); ++i) sum += m.mass[i] * m.v[i].z;
    return sum;
  };
  const double start = momentum();
  for (int i = 0; i < 200; ++i) m.step(wall);
  for (std::size_t i = 0; i < m.x.size(); ++i)
    EXPECT_GT(m.v[i].z, -10.0 * static_cast<double>(i)) << i;  // all were hit
  EXPECT_NEAR(momentum(), start, 1e-11 * std::abs(start));
}

TEST(RigidWall, PrescribedMotionPushesNodes) {
  model::RigidWall card = floor_wall();
  card.motion_direction = {0.0, 0.0, 1.0};
  Curve curve;
  curve.x = {0.0, 1e-3};
  curve.y = {0.0, 2.0};
  for (bool displacement : {true, false}) {
    card.motion_is_displacement = displacement;
    Masses m;
    m.add({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0});
    RigidWall wall(card, m.nodes(), &curve);
    for (int i = 0; i < 500; ++i) m.step(wall);
    const double expected = displacement ? 1.0 : 0.5 * 2000.0 * 5e-4 * 5e-4;
    EXPECT_NEAR(wall.origin().z, expected, 1e-9);
    EXPECT_NEAR(m.x[0].z, expected, 1e-9);
    EXPECT_NEAR(wall.energy(), -m.kinetic(), 1e-9 * m.kinetic());  // the wall does the work
  }
}

// The wall, activated at 1e-3, moves by 1 in the 1e-3 after that, and meets the node at 0.5 half-way (keyword manual,
// BIRTH: the times of the curve are offset by it). Sabotage: the curve over the time of the run (the node stands behind
// the wall when it is activated, and is taken along immediately).
TEST(RigidWall, MotionBeginsWithItsBirth) {
  model::RigidWall card = floor_wall();
  card.motion_direction = {0.0, 0.0, 1.0};
  card.birth = 1e-3;
  for (bool displacement : {true, false}) {
    card.motion_is_displacement = displacement;
    Curve curve;
    curve.x = {0.0, 1e-3};
    curve.y = displacement ? std::vector{0.0, 1.0} : std::vector{1000.0, 1000.0};
    Masses m;
    m.dt = 1e-5;
    m.add({0.0, 0.0, 0.5}, {0.0, 0.0, 0.0});
    RigidWall wall(card, m.nodes(), &curve);
    double met = 0.0;
    for (int i = 0; i < 250; ++i) {
      m.step(wall);
      if (met == 0.0 && wall.touching() > 0) met = m.time;
    }
    EXPECT_NEAR(met, 1.5e-3, 1.1e-5);
    EXPECT_NEAR(wall.origin().z, 1.0, 1e-9);
  }
}

TEST(RigidWall, WallWithMassStandsUntilItIsBorn) {
  model::RigidWall card = floor_wall();
  card.mass = 10.0;
  card.velocity = 500.0;
  card.birth = 1e-3;
  Masses m;
  m.dt = 1e-5;
  m.add({0.0, 0.0, 9.0}, {0.0, 0.0, 0.0});
  RigidWall wall(card, m.nodes());
  for (int i = 0; i < 300; ++i) m.step(wall);
  EXPECT_NEAR(wall.origin().z, 1.0, 1.1 * 500.0 * 1e-5);
}

TEST(RigidWall, FiniteWallStopsOnlyWhatComesThroughItsFace) {
  model::RigidWall card = floor_wall();
  card.finite = true;
  card.edge_l = {1.0, 0.0, 0.0};
  card.edge_m = {0.0, 1.0, 0.0};
  card.length_l = 10.0;
  card.length_m = 5.0;
  Masses m;
  m.add({5.0, 2.0, 0.01}, {0.0, 0.0, -1000.0});     // inside
  m.add({10.5, 2.0, 0.01}, {0.0, 0.0, -1000.0});    // beyond l
  m.add({5.0, -0.5, 0.01}, {0.0, 0.0, -1000.0});    // beyond m
  m.add({-0.5, 2.0, -0.5}, {10000.0, 0.0, -10.0});  // behind, moving under the wall
  RigidWall wall(card, m.nodes());
  for (int i = 0; i < 200; ++i) m.step(wall);
  EXPECT_NEAR(m.x[0].z, 0.0, 1e-15);
  EXPECT_NEAR(m.x[1].z, 0.01 - 0.2, 1e-9);
  EXPECT_NEAR(m.x[2].z, 0.01 - 0.2, 1e-9);
  EXPECT_EQ(m.v[3].z, -10.0);
}

TEST(RigidWall, NodeLeavesOverTheEdgeOfAFiniteWall) {
  model::RigidWall card = floor_wall();
  card.finite = true;
  card.edge_l = {1.0, 0.0, 0.0};
  card.edge_m = {0.0, 1.0, 0.0};
  card.length_l = 0.1;
  Masses m;
  m.add({0.05, 0.0, 0.0}, {1000.0, 0.0, 0.0}, 1.0, {0.0, 0.0, -1e7});
  RigidWall wall(card, m.nodes());
  for (int i = 0; i < 100; ++i) m.step(wall);
  EXPECT_LT(m.x[0].z, -1e-3);
  EXPECT_EQ(wall.touching(), 0);
}

model::RigidWall pole(double radius) {
  model::RigidWall wall;
  wall.shape = model::RigidWall::Shape::cylinder;
  wall.normal = {0.0, 0.0, 1.0};
  wall.radius = radius;
  wall.death = no_end;
  return wall;
}

TEST(RigidWall, CylinderStopsRadially) {
  Masses m;
  m.add({177.001, 0.0, 40.0}, {-8333.0, 0.0, 12.0}, 1e-4);
  RigidWall wall(pole(177.0), m.nodes());
  for (int i = 0; i < 3; ++i) m.step(wall);
  EXPECT_NEAR(m.x[0].x, 177.0, 1e-12);
  EXPECT_NEAR(m.v[0].x, 0.0, 1e-6);
  EXPECT_EQ(m.v[0].z, 12.0);
  EXPECT_NEAR(wall.impulse().x, 0.8333, 1e-12);
}

TEST(RigidWall, GlancingNodeFollowsTheCylinderWithoutChatter) {
  // A central force presses the node on; it must run around at constant speed, the wall force the pressing force less m
  // v^2/r.
  const double radius = 10.0, speed = 8000.0, press = 2e7;
  Masses m;
  m.add({radius, 0.0, 0.0}, {0.0, speed, 0.0}, 1e-3);
  RigidWall wall(pole(radius), m.nodes());
  double low = 1e30, high = 0.0;
  for (int i = 0; i < 2000; ++i) {
    m.acceleration[0] = (-press / norm(vec(m.x[0]))) * vec(m.x[0]);
    m.step(wall);
    if (i < 10) continue;
    low = std::min(low, wall.normal_force());
    high = std::max(high, wall.normal_force());
  }
  const double expected = 1e-3 * (press - speed * speed / radius);
  EXPECT_NEAR(low, expected, 1e-3 * expected);
  EXPECT_NEAR(high, expected, 1e-3 * expected);
  EXPECT_NEAR(norm(vec(m.v[0])), speed, 1e-4 * speed);
  EXPECT_NEAR(norm(vec(m.x[0])), radius, 1e-9);
}

TEST(RigidWall, NodePassesACylinderThatItOnlyGrazes) {
  Masses m;
  m.add({10.0 + 1e-6, -5.0, 0.0}, {0.0, 8000.0, 0.0});
  RigidWall wall(pole(10.0), m.nodes());
  for (int i = 0; i < 2000; ++i) m.step(wall);
  EXPECT_EQ(wall.impulse().x, 0.0);
  EXPECT_EQ(m.v[0].y, 8000.0);
}

TEST(RigidWall, EndsOfAFiniteCylinder) {
  model::RigidWall card = pole(10.0);
  card.length = 100.0;
  Masses m;
  m.add({3.0, 0.0, 100.01}, {0.0, 0.0, -1000.0});   // on the end face
  m.add({3.0, 0.0, -0.01}, {0.0, 0.0, 1000.0});     // on the other
  m.add({10.01, 0.0, 100.5}, {-1000.0, 0.0, 0.0});  // passes above
  m.add({10.01, 0.0, 50.0}, {-1000.0, 0.0, 0.0});   // on the side
  RigidWall wall(card, m.nodes());
  for (int i = 0; i < 50; ++i) m.step(wall);
  EXPECT_NEAR(m.x[0].z, 100.0, 1e-12);
  EXPECT_NEAR(m.x[1].z, 0.0, 1e-12);
  EXPECT_NEAR(m.x[2].x, 10.01 - 0.05, 1e-9);
  EXPECT_NEAR(m.x[3].x, 10.0, 1e-12);
}

model::RigidWall block() {
  model::RigidWall wall = floor_wall();
  wall.shape = model::RigidWall::Shape::prism;
  wall.edge_l = {1.0, 0.0, 0.0};
  wall.edge_m = {0.0, 1.0, 0.0};
  wall.length_l = 4.0;
  wall.length_m = 2.0;
  wall.depth = 1.0;
  return wall;
}

// Sabotage: the face that is nearest where the node would stand instead of the one that it came through.
TEST(RigidWall, PrismStopsOnAllItsFaces) {
  const std::pair<Vec3d, Vec3d> arrivals[] = {
      {{1.0, 1.0, 0.1}, {0.0, 0.0, -1.0}},  {{1.0, 1.0, -1.1}, {0.0, 0.0, 1.0}},  {{-0.1, 1.0, -0.5}, {1.0, 0.0, 0.0}},
      {{4.1, 1.0, -0.5}, {-1.0, 0.0, 0.0}}, {{1.0, -0.1, -0.5}, {0.0, 1.0, 0.0}}, {{1.0, 2.1, -0.5}, {0.0, -1.0, 0.0}}};
  for (const auto& [from, towards] : arrivals) {
    Masses m;
    m.dt = 1e-2;
    m.add(from, 1000.0 * towards);  // more than the block in a step
    RigidWall wall(block(), m.nodes());
    m.step(wall);
    EXPECT_NEAR(norm(vec(m.x[0]) - from - 0.1 * towards), 0.0, 1e-12);
    m.step(wall);
    EXPECT_NEAR(norm(vec(m.v[0])), 0.0, 1e-9);
  }
}

TEST(RigidWall, NodePassesAPrismAndSlidesOffIt) {
  Masses m;
  m.dt = 1e-2;
  m.add({-1.0, 1.0, 0.5}, {10.0, 0.0, 0.0});                         // above it
  m.add({1.0, 1.0, 0.001}, {10.0, 0.0, 0.0}, 1.0, {0, 0, -1000.0});  // along its top, then down beside it
  RigidWall wall(block(), m.nodes());
  for (int i = 0; i < 29; ++i) m.step(wall);
  EXPECT_DOUBLE_EQ(m.v[0].x, 10.0);
  EXPECT_NEAR(m.x[1].z, 0.0, 1e-9);
  for (int i = 0; i < 11; ++i) m.step(wall);
  EXPECT_LT(m.x[1].z, -1.0);
  EXPECT_DOUBLE_EQ(m.v[1].x, 10.0);
}

TEST(RigidWall, SphereStopsAndLetsSlide) {
  model::RigidWall card = pole(10.0);
  card.shape = model::RigidWall::Shape::sphere;
  Masses m;
  m.add({0.0, 0.0, 10.0}, {50.0, 0.0, -1000.0});
  RigidWall wall(card, m.nodes());
  m.step(wall);
  EXPECT_NEAR(norm(vec(m.x[0])), 10.0, 1e-12);
  EXPECT_EQ(m.v[0].x, 50.0);
}

TEST(RigidWall, BalanceClosesWithOtherForcesAtWork) {
  // Many masses under their own accelerations on a round wall with friction: work of the accelerations less energy
  // given to the wall is the kinetic energy gained, to round-off.
  model::RigidWall card = pole(50.0);
  card.friction = 0.3;
  Masses m;
  for (int i = 0; i < 40; ++i)
    m.add({50.5, -20.0 + i, 0.0}, {-2000.0 - 10.0 * i, 100.0, 50.0}, 1e-3 + 1e-4 * i, {-1e6, 2e5, 0.0});
  RigidWall wall(card, m.nodes());
  const double start = m.kinetic();
  for (int i = 0; i < 20000; ++i) m.step(wall);
  EXPECT_GT(wall.touching(), 10);
  EXPECT_NEAR(m.kinetic() + wall.energy(), start + m.force_work, 1e-10 * wall.energy());
}

/// Three groups of nodes, the nearest 2 mm from a wall, thrown at it; the farthest is turned round on its way.
/// `knows_speeds`: the wall is told how fast nodes are, and leaves alone those that cannot reach it.
struct Throw {
  Masses m;
  std::vector<Vec3d> forces;
  std::vector<double> energies;
  std::size_t least_awake = 3000, most_awake = 0;

  Throw(const model::RigidWall& card, bool knows_speeds, int lift = 0) {
    for (int i = 0; i < 3000; ++i) m.add({0.01 * (i % 50), 0.01 * (i % 30), 2.0 + 0.01 * i}, {}, 1.0 + 0.1 * (i % 7));
    for (int i = 0; i < 3000; ++i) m.v[i] = {3.0 * (i % 5), 1.0, -2e4 - 10.0 * (i % 11), 0.0};
    RigidWall wall(card, m.nodes());
    for (int step = 0; step < 1200; ++step) {
      for (int i = 2048; i < 3000; ++i) m.acceleration[i] = {0.0, 0.0, step >= 300 && step < 400 ? 4e8 : 0.0};
      // From one step to the next a node goes more than half of its way to the wall.
      if (step == lift && lift > 0) m.acceleration[1100].z = -2e13;
      m.step(wall, knows_speeds);
      if (step == lift && lift > 0) m.acceleration[1100].z = 0.0;
      forces.push_back(wall.force());
      energies.push_back(wall.energy_at_time());
      least_awake = std::min(least_awake, wall.awake());
      most_awake = std::max(most_awake, wall.awake());
    }
  }
};

// Sabotage to be caught: groups that sleep for all of their way, or one that is woken by its own travel alone.
TEST(RigidWall, NodesThatCannotReachItAreNotLookedAt) {
  std::vector<model::RigidWall> walls(3, floor_wall());
  walls[1].mass = 500.0;
  walls[1].velocity = 3e3;
  walls[1].friction = 0.2;
  walls[2].shape = model::RigidWall::Shape::sphere;
  walls[2].radius = 1.5;
  for (const model::RigidWall& card : walls) {
    const Throw all(card, false), few(card, true);
    EXPECT_EQ(all.least_awake, 3000u);
    EXPECT_LT(few.least_awake, 1500u);
    EXPECT_GT(few.most_awake, 2000u);
    ASSERT_EQ(all.forces.size(), few.forces.size());
    double largest = 0.0;
    for (std::size_t i = 0; i < all.forces.size(); ++i) {
      largest = std::max(largest, norm(all.forces[i]));
      ASSERT_TRUE(all.forces[i].x == few.forces[i].x && all.forces[i].y == few.forces[i].y &&
                  all.forces[i].z == few.forces[i].z && all.energies[i] == few.energies[i])
          << "step " << i;
    }
    EXPECT_GT(largest, 0.0);
    for (std::size_t i = 0; i < all.m.x.size(); ++i) ASSERT_EQ(all.m.x[i].z, few.m.x[i].z) << i;
  }
}

// It is stopped in the step in which its group wakes, and the ledger knows its velocity of the step before.
TEST(RigidWall, ANodeThatJumpsAtItIsStopped) {
  const Throw all(floor_wall(), false, 20), few(floor_wall(), true, 20);
  EXPECT_LT(few.least_awake, 1500u);
  EXPECT_GE(few.m.x[1100].z, -1e-12);
  EXPECT_GT(all.energies[20], 0.0);
  for (std::size_t i = 0; i < all.forces.size(); ++i)
    ASSERT_NEAR(all.energies[i], few.energies[i], 1e-12 * all.energies[i]) << i;
}

TEST(RigidWall, SameBitsForAnyNumberOfThreads) {
  const auto run = [](int count) {
    set_threads(count);
    model::RigidWall card = pole(50.0);
    card.friction = 0.3;
    Masses m;
    for (int i = 0; i < 5000; ++i)
      m.add({50.0 + 1e-4 * i, 0.01 * (i % 977), 0.0}, {-2000.0, 3.0 * (i % 7), 0.0}, 1e-3 + 1e-6 * i);
    RigidWall wall(card, m.nodes());
    for (int i = 0; i < 100; ++i) m.step(wall);
    set_threads(1);
    return std::array<double, 4>{wall.energy(), wall.impulse().x, wall.impulse().y, m.kinetic()};
  };
  const auto one = run(1);
  EXPECT_EQ(one, run(2));
  EXPECT_EQ(one, run(3));
}

}  // namespace
}  // namespace nugget::contact
