// SPDX-License-Identifier: Apache-2.0
// Rigid bodies against rigid walls, RWPNAL: a rigid body with an elastic impact and Coulomb's friction in one point,
// in closed form.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

// mm, t, s, N. A block 100 x 60 x 20, its centre in the origin, its lower face 10.37 steps of the way above the wall.
const Vec3d sides{100.0, 60.0, 20.0};
constexpr double mass = 9.42e-4, speed = 1000.0, dt = 2e-7, gap = 10.37 * speed * dt;
const Vec3d principal{0.3140, 0.8164, 1.0676};
const Vec3d up{0, 0, 1};
const Vec3d below{0, 0, -0.5 * sides.z}, corner{0.5 * sides.x, 0.5 * sides.y, -0.5 * sides.z},
    edge{0.5 * sides.x, 0, -0.5 * sides.z};

struct Motion {
  Vec3d v{}, w{};
};

struct Body {
  Vec3d inertia = principal;
  Motion start{};
  double duration = 3e-4;
  double scale = 1.0;  ///< RWPNAL
  std::string more{};
};

/// J acts at `arm` from the centre.
Motion struck(const Body& body, const Vec3d& arm, const Vec3d& impulse) {
  const Vec3d turn = cross(arm, impulse);
  return {body.start.v + (1.0 / mass) * impulse,
          body.start.w + Vec3d{turn.x / body.inertia.x, turn.y / body.inertia.y, turn.z / body.inertia.z}};
}

/// Change of the velocity of the point at `arm` by impulse J there.
Vec3d give(const Body& body, const Vec3d& arm, const Vec3d& impulse) {
  const Motion m = struck(body, arm, impulse);
  return m.v - body.start.v + cross(m.w - body.start.w, arm);
}

/// Impulse along `n` of an elastic impact, with friction that slides all the time along the unit vector `t`.
Vec3d bounce(const Body& body, const Vec3d& arm, const Vec3d& n, double mu = 0.0, const Vec3d& t = {}) {
  const Vec3d along = n - mu * t, u = body.start.v + cross(body.start.w, arm);
  return (-2.0 * dot(u, n) / dot(give(body, arm, along), n)) * along;
}

struct Result {
  Motion end;
  Vec3d impulse;  ///< of the wall on the body
  double ratio = 0.0, wall_velocity = 0.0, wall_energy = 0.0, initial = 0.0;
  int touching = 0;
};

/// A node of the block's mesh, 4 x 2 x 2 bricks; the wall sees it alone as set 1, or the whole block (set 0).
int block_node(const Vec3d& arm) {
  const int i = static_cast<int>(std::lround((arm.x + 50.0) / 25.0)),
            j = static_cast<int>(std::lround((arm.y + 30) / 30)), k = static_cast<int>(std::lround((arm.z + 10) / 10));
  return 1 + (k * 3 + j) * 5 + i;
}

std::string plane(int set, double friction = 0.0, const std::string& options = "") {
  return "*RIGIDWALL_PLANAR" + options + "\n" + fields({double(set)}) +
         fields({0, 0, below.z - gap, 0, 0, 100, friction});
}

Result run(const Body& body, const std::string& wall, const Vec3d& seen = below) {
  Specimen s;
  s.card("MAT_RIGID", {1, 7.85e-9, 210000.0, 0.3}).text(fields({}) + fields({})).card("SECTION_SOLID", {1, 1});
  s.text("*PART_INERTIA\nblock\n" + fields({1, 1, 1}) + fields({0, 0, 0, mass}) +
         fields({body.inertia.x, 0, 0, body.inertia.y, 0, body.inertia.z}) +
         fields({body.start.v.x, body.start.v.y, body.start.v.z, body.start.w.x, body.start.w.y, body.start.w.z}));
  s.bricks(1, -0.5 * sides, sides, {4, 2, 2});
  s.node_set(1, {block_node(seen)});
  s.text(constant_curve(1, dt)).card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 1});
  s.card("CONTROL_CONTACT", {0.1, body.scale}).card("CONTROL_TERMINATION", {body.duration}).text(wall).text(body.more);
  Experiment experiment(s.deck());
  Result result;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    const auto k = at(now.system.bodies.at(0).node);
    result.end = {now.velocity(k), now.spin(k)};
    result.impulse = now.components.walls.all()[0].impulse();
    result.wall_velocity = now.components.walls.all()[0].velocity();
    result.wall_energy = now.energy.wall;
    result.initial = now.energy.initial;
    result.touching = now.components.walls.all()[0].touching();
    if (now.energy.initial > 0.0) result.ratio = std::max(result.ratio, std::abs(now.energy.ratio() - 1.0));
  });
  return result;
}

void expect_motion(const std::string& what, const Body& body, const Result& r, const Motion& expected,
                   double gate = 0.01) {
  const auto& [v, w] = expected;
  const double spin_scale = std::max(norm(w), speed / 50.0);
  expect_reference("RWPNAL", what + ": velocity, largest error of the speed before",
                   norm(r.end.v - v) / norm(body.start.v), 0.0, gate, 1.0);
  expect_reference("RWPNAL", what + ": spin, largest error of the spin", norm(r.end.w - w) / spin_scale, 0.0, gate,
                   1.0);
  expect_reference("RWPNAL", what + ": impulse in rwforc, error",
                   norm(r.impulse - mass * (r.end.v - body.start.v)) / (mass * norm(body.start.v)), 0.0, 1e-9, 1.0);
  expect_reference("RWPNAL", what + ": energy ratio", 1.0 + r.ratio, 1.0, 1e-3);
}

// Sabotage to be caught: forces not counted in rwforc; their work left out of the energy balance; k depth in the first
// and last cycle; stiffness of the sum of masses at each node.
TEST(RigidBodiesOnWalls, ComesBackAsItCame) {
  Body body{.start = {{0, 0, -speed}, {}}};
  for (const double scale : {0.1, 1.0, 5.0}) {
    body.scale = scale;
    expect_motion(fmt::format("block flat on a plane, RWPNAL {}", scale), body, run(body, plane(0)),
                  struck(body, below, bounce(body, below, up)));
  }
  for (const double moved : {0.0, 0.2, 0.4, 0.6, 0.8}) {  // of a step: where the body enters the spring
    body.start.v = (1.0 + 0.1 * moved) * Vec3d{0, 0, -speed};
    expect_motion(fmt::format("one node, RWPNAL 5, velocity {}", -body.start.v.z), body, run(body, plane(1)),
                  struck(body, below, bounce(body, below, up)), 1e-3);
  }
  body = {.start = {{0.5 * speed, 0.2 * speed, -speed}, {}}};
  expect_motion("oblique", body, run(body, plane(0)), struck(body, below, bounce(body, below, up)));
  body = {.start = {{0, 0, -speed}, {}}};
  expect_motion("corner of a block", body, run(body, plane(1), corner), struck(body, corner, bounce(body, corner, up)));
  body = {.inertia = {1.5, 2.5, 2.0}, .start = {{100, 0, -speed}, {1, -2, 5}}};
  expect_motion("edge of a block with *PART_INERTIA", body, run(body, plane(1), edge),
                struck(body, edge, bounce(body, edge, up)));
}

// The isotropic body touches below its centre, as a sphere does. Sabotage to be caught: no friction; friction that goes
// on when the sliding has ended; mass without the body's turning.
TEST(RigidBodiesOnWalls, Friction) {
  const double inertia = 0.4 * mass * 100.0;
  Body body{.inertia = {inertia, inertia, inertia}, .start = {{600, 0, -speed}, {}}};
  const Vec3d x{1, 0, 0};
  const double to_stick = 600.0 / (1.0 / mass + 100.0 / inertia);
  expect_motion("sphere, friction .05: slides", body, run(body, plane(1, 0.05)),
                struck(body, below, bounce(body, below, up, 0.05, x)));
  ASSERT_LT(to_stick, 0.4 * 2 * mass * speed);
  expect_motion("sphere, friction .4: rolls", body, run(body, plane(1, 0.4)),
                struck(body, below, bounce(body, below, up) - to_stick * x));
  expect_motion("sphere, friction 1: rolls", body, run(body, plane(1, 1.0)),
                struck(body, below, bounce(body, below, up) - to_stick * x));
  body.start = {{0, 0, -speed}, {0, 300, 0}};  // slips along -x with 3000
  expect_motion("sphere with spin, friction .3: slides", body, run(body, plane(1, 0.3)),
                struck(body, below, bounce(body, below, up, 0.3, -x)));
  // Friction presses the edge on, or takes it off.
  body = {.start = {{800, 0, -speed}, {}}};
  for (const Vec3d& arm : {edge, Vec3d{-edge.x, 0, edge.z}})
    expect_motion(fmt::format("edge at x = {}, friction .2", arm.x), body, run(body, plane(1, 0.2), arm),
                  struck(body, arm, bounce(body, arm, up, 0.2, x)));
}

// Sabotage to be caught: the force does not act on the wall; the wall's velocity left out of the approach.
TEST(RigidBodiesOnWalls, WallsThatMove) {
  Body body{.start = {{0, 0, -speed}, {}}};
  const double wall_mass = 0.5 * mass, v0 = 400.0;
  const std::string moving = plane(0, 0, "_MOVING") + fields({wall_mass, v0});
  const double common = (wall_mass * v0 - mass * speed) / (wall_mass + mass);
  Result r = run(body, moving);
  expect_motion("wall of half the mass", body, r, {2.0 * common * up - body.start.v, {}});
  expect_reference("RWPNAL", "wall of half the mass: momentum", mass * r.end.v.z + wall_mass * r.wall_velocity,
                   wall_mass * v0 - mass * speed, 1e-9);
  const std::string driven = "*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n" + fields({1}) +
                             fields({0, 0, below.z - gap, 0, 0, 100}) + fields({100, 0, below.z - gap, 0, 0}) +
                             fields({5, 0, 0, 0, 1}) + constant_curve(5, 300.0);
  body.scale = 5.0;
  expect_motion("driven wall", body, run(body, driven), {(speed + 600.0) * up, {}});
}

// One node of the block meets the wall where its normal is oblique. Sabotage to be caught: the plane's normal.
TEST(RigidBodiesOnWalls, OfAllForms) {
  const double inertia = 1e9;  // does not turn
  const Body body{.inertia = {inertia, inertia, inertia}, .start = {{0, 0, -speed}, {}}};
  const Vec3d n = unit(Vec3d{0.6, 0, 0.8});
  const double radius = 50.0;
  const Vec3d axis = below - gap * up - radius * n;
  const Vec3d expected = body.start.v - 2.0 * dot(body.start.v, n) * n;
  const auto form = [&](const std::string& name, const Vec3d& tail, const Vec3d& head, const std::string& card) {
    expect_motion("oblique on _" + name, body,
                  run(body, "*RIGIDWALL_GEOMETRIC_" + name + "\n" + fields({1}) +
                                fields({tail.x, tail.y, tail.z, head.x, head.y, head.z}) + card),
                  {expected, {}});
  };
  form("SPHERE", axis, axis + up, fields({radius}));
  form("CYLINDER", axis - Vec3d{0, 20, 0}, axis + Vec3d{0, 20, 0}, fields({radius, 60.0}));
  const Vec3d tail = below - gap * up - 40.0 * Vec3d{0.8, 0, -0.6} - Vec3d{0, 20, 0}, head = tail + n;
  const Vec3d l = tail + Vec3d{0.8, 0, -0.6};
  form("FLAT", tail, head, fields({l.x, l.y, l.z, 80, 40}));
  form("PRISM", tail, head, fields({l.x, l.y, l.z, 80, 40, 30}));
}

// A block tumbles on a plane under a load, over its edges and corners, without friction: its energy is what it was.
// Sabotage to be caught: springs that give back more or less than they took.
TEST(RigidBodiesOnWalls, TumbleWithoutLoss) {
  Body body{.start = {{0, 0, -speed}, {30, 50, 20}}, .duration = 8e-3};
  const double load = 2e6;
  body.more = constant_curve(2) + "*LOAD_BODY_Z\n" + fields({2, load});
  const Result r = run(body, plane(0));
  EXPECT_GT(r.impulse.z, 10 * mass * speed);
  expect_reference("RWPNAL", "block that tumbles: energy left in the wall, of the first", r.wall_energy / r.initial,
                   0.0, 0.01, 1.0);
  expect_reference("RWPNAL", "block that tumbles: energy ratio", 1.0 + r.ratio, 1.0, 1e-3);
}

// A body that is driven goes its way, one that is held along the normal stays; the wall's force is a load. Sabotage to
// be caught: wall before motion.
TEST(RigidBodiesOnWalls, DrivenAndHeld) {
  Body body{.duration = 1e-4};
  body.more = constant_curve(2) + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" + fields({1, 3, 0, 2, -speed});
  const Result driven = run(body, plane(0));
  EXPECT_NEAR(driven.end.v.z, -speed, 1e-9);
  EXPECT_GT(driven.impulse.z, mass * speed);
  EXPECT_LT(driven.ratio, 1e-3);
  // A wall with mass comes back from a body that cannot move along its normal.
  body = {};
  body.more = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" + fields({1, 3, 0, 2}) + constant_curve(2, 0.0);
  const Result held = run(body, plane(0, 0, "_MOVING") + fields({0.1 * mass, speed}));
  EXPECT_NEAR(held.end.v.z, 0.0, 1e-9);
  expect_reference("RWPNAL", "wall with mass against a held body: velocity", held.wall_velocity, -speed, 0.01);
}

// Under its weight the block comes to rest on an incline whose friction holds it; the force is its weight. Sabotage to
// be caught: sums of forces of nodes; friction that does not hold.
TEST(RigidBodiesOnWalls, BearsWeight) {
  const double g = 9810.0, mu = 0.6, slope = 0.3;
  Body body{.duration = 4e-3};
  // Body loads push against the acceleration given. Viscous damping ends the bounces.
  body.more = constant_curve(2) + "*LOAD_BODY_X\n" + fields({2, g * std::sin(slope)}) + "*LOAD_BODY_Z\n" +
              fields({2, g * std::cos(slope)}) + constant_curve(3, 2000.0) + "*DAMPING_GLOBAL\n" + fields({3});
  const std::string wall = "*RIGIDWALL_PLANAR\n" + fields({0}) + fields({0, 0, below.z, 0, 0, 100, mu});
  const Result r = run(body, wall);
  EXPECT_EQ(r.touching, 15);
  expect_reference("RWPNAL", "block at rest on an incline: speed over that of its fall", norm(r.end.v) / (g * 4e-3),
                   0.0, 2e-3, 1.0);
  expect_reference("RWPNAL", "block at rest on an incline: impulse over that of its weight, normal",
                   r.impulse.z / (mass * g * std::cos(slope) * 4e-3), 1.0, 0.01);
  expect_reference("RWPNAL", "block at rest on an incline: impulse over that of its weight, along",
                   r.impulse.x / (mass * g * std::sin(slope) * 4e-3), 1.0, 0.01);
}

}  // namespace
}  // namespace nugget::verify
