// SPDX-License-Identifier: Apache-2.0
#include "system/rigid_body.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace nugget::system {
namespace {

struct Top {
  RigidBody body;
  State state;
  Top(const Inertia& inertia, const Vec3d& spin) {
    body.mass = 2.0;
    body.inertia = inertia;
    body.axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    state.x.resize(1);
    state.v.resize(1);
    state.w.resize(1);
    state.f.resize(1);
    state.m.resize(1);
    set(state.w[0], spin);
    body.angular_momentum = body.momentum(spin, body.axes);
  }
  void step(double velocity_interval, double dt) {
    body.advance(velocity_interval, dt, state);
    body.turn(dt, state);
  }
  Vec3d spin() const { return vec(state.w[0]); }
};

// A body that tumbles about its middle axis: the hardest case. Sabotage to be caught: the gyroscopic term left out; the
// spin taken with the axes of the start of the step.
TEST(RigidBody, TorqueFreeMotionConserves) {
  Top top({1.0, 0.0, 0.0, 2.0, 0.0, 3.0}, {0.01, 5.0, 0.01});
  const Vec3d momentum = top.body.angular_momentum;
  const double energy = 0.5 * dot(momentum, top.spin());
  double worst = 0.0, lowest = 1.0;
  for (int i = 0; i < 20000; ++i) {
    top.step(1e-3, 1e-3);
    worst = std::max(worst, std::abs(0.5 * dot(top.body.angular_momentum, top.spin()) / energy - 1.0));
    lowest = std::min(lowest, top.body.axes.e2.y);
  }
  EXPECT_EQ(norm(top.body.angular_momentum - momentum), 0.0);
  EXPECT_LT(lowest, -0.9);  // it did tumble
  EXPECT_LT(worst, 1e-4);
  EXPECT_NEAR(dot(top.body.axes.e1, top.body.axes.e2), 0.0, 1e-15);
  EXPECT_NEAR(norm(top.body.axes.e3), 1.0, 1e-15);
}

// A symmetric top goes round its axis at (I3 - I1) / I1 times its own spin, in the body.
TEST(RigidBody, SymmetricTopPrecesses) {
  const double dt = 1e-4, end = 2.0;
  Top top({1.0, 0.0, 0.0, 1.0, 0.0, 1.5}, {0.5, 0.0, 4.0});
  top.body.advance(0.0, dt, top.state);
  top.body.turn(dt, top.state);
  const int steps = static_cast<int>(end / dt);
  for (int i = 1; i < steps; ++i) top.step(dt, dt);
  const Vec3d local = top.body.axes.local(top.spin());
  const double angle = 0.5 * 4.0 * (end - 0.5 * dt);
  EXPECT_NEAR(local.x, 0.5 * std::cos(angle), 1e-4);
  EXPECT_NEAR(local.y, 0.5 * std::sin(angle), 1e-4);
  EXPECT_NEAR(local.z, 4.0, 1e-6);
}

TEST(RigidBody, ForceAndTorque) {
  Top top({2.0, 0.0, 0.0, 2.0, 0.0, 2.0}, {});
  set(top.state.f[0], {4.0, 0.0, 0.0});
  set(top.state.m[0], {0.0, 6.0, 0.0});
  top.step(0.1, 0.1);
  EXPECT_NEAR(vec(top.state.v[0]).x, 0.2, 1e-15);
  EXPECT_NEAR(top.spin().y, 0.3, 1e-15);
  top.body.fixed = 1u | 1u << 4;  // x and rotation about y
  top.step(0.1, 0.1);
  EXPECT_EQ(vec(top.state.v[0]).x, 0.0);
  EXPECT_EQ(top.spin().y, 0.0);
}

// A bar in the plane of x and y at 45 degrees to both, held against turning about y, z or both: about x it turns as
// T/I_xx, whatever products of inertia it has, and the work of the torque is its kinetic energy. Sabotage: the free
// spin I^-1 L, of which the held components are then taken away.
TEST(RigidBody, HeldAboutAnAxisThatIsNotItsOwn) {
  const Inertia bar{2.0, -1.9, 0.0, 2.0, 0.0, 4.0};
  const double dt = 1e-6;
  for (const unsigned held : {1u << 4, 1u << 4 | 1u << 5, 1u << 5}) {
    Top top(bar, {});
    top.body.fixed = held;
    set(top.state.m[0], {3.0, 0.0, 0.0});
    double work = 0.0;
    for (int i = 0; i < 100; ++i) {
      const Vec3d before = top.spin();
      top.body.advance(dt, dt, top.state);  // the axes stay: its angles are next to nothing
      work += 0.5 * dt * dot({3.0, 0.0, 0.0}, before + top.spin());
    }
    const Vec3d w = top.spin();
    if (held & 1u << 4) {
      EXPECT_NEAR(w.x, 100.0 * dt * 3.0 / 2.0, 1e-12);
      EXPECT_EQ(w.y, 0.0);
    } else {  // (I_xx I_xy; I_xy I_yy) w = (T t, 0)
      EXPECT_NEAR(w.x, 100.0 * dt * 3.0 * 2.0 / (4.0 - 1.9 * 1.9), 1e-12);
      EXPECT_NEAR(w.y, 100.0 * dt * 3.0 * 1.9 / (4.0 - 1.9 * 1.9), 1e-12);
    }
    EXPECT_NEAR(w.z, 0.0, 1e-12);
    EXPECT_NEAR(0.5 * dot(w, top.body.momentum(w, top.body.axes)) / work, 1.0, 1e-9);
  }
}

// The same about an axis across the global ones, with the axes of the support turned by a third of a turn.
TEST(RigidBody, HeldInAxesOfItsOwn) {
  Top top({2.0, -1.9, 0.0, 2.0, 0.0, 4.0}, {});
  top.body.fixed_axes = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  top.body.fixed = 1u << 3 | 1u << 4;  // about y and z
  set(top.state.m[0], {3.0, 5.0, 7.0});
  top.body.advance(1e-6, 1e-6, top.state);
  EXPECT_NEAR(top.spin().x, 1e-6 * 3.0 / 2.0, 1e-14);
  EXPECT_EQ(top.spin().y, 0.0);
  EXPECT_EQ(top.spin().z, 0.0);
}

TEST(RigidBody, PointMassesGiveTheInertiaOfADumbbell) {
  Inertia i{};
  add_point(i, 3.0, 0.0, {0, 0, 2});
  add_point(i, 3.0, 0.0, {0, 0, -2});
  EXPECT_EQ(i, (Inertia{24, 0, 0, 24, 0, 0}));
  Inertia oblique{};
  add_point(oblique, 1.0, 0.5, {1, 2, 3});
  EXPECT_EQ(oblique, (Inertia{13.5, -2, -3, 10.5, -6, 5.5}));
}

}  // namespace
}  // namespace nugget::system
