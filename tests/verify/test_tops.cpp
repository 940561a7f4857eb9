// SPDX-License-Identifier: Apache-2.0
// A fast top, as a rigid body on a spherical joint and as elastic bricks on a pinned node.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "specimen.hpp"

namespace nugget::verify {
namespace {

constexpr double side = 60.0, height = 240.0, density = 2.7e-9, gravity = 9810.0, tilt = 0.05;
constexpr double spin = 313.0 * std::numbers::pi, end_time = 0.4;

/// Lagrange's top by its conserved momenta, integrated by Runge-Kutta: psi' + phi' cos(theta) = spin,
/// p_phi = I1 phi' sin^2(theta) + I3 spin cos(theta), I1 theta'' = (I1 phi'^2 cos - I3 spin phi' + m g l) sin(theta).
class Top {
 public:
  /// Moments of inertia about the pivot, across and along the axis; m g l.
  Top(double across, double along, double weight_moment)
      : across_(across), along_(along * spin), weight_(weight_moment), momentum_(along_ * std::cos(tilt)) {}

  /// Place of the tip at a time that is not before that of the last call.
  Vec3d tip(double time) {
    while (time_ < time) {
      const double dt = std::min(1e-5, time - time_);
      const State k1 = rate(s_), k2 = rate(s_ + 0.5 * dt * k1), k3 = rate(s_ + 0.5 * dt * k2), k4 = rate(s_ + dt * k3);
      s_ = s_ + (dt / 6.0) * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
      time_ += dt;
    }
    // In a Vec3d stand theta, theta' and phi.
    return height * Vec3d{std::sin(s_.x) * std::cos(s_.z), std::sin(s_.x) * std::sin(s_.z), std::cos(s_.x)};
  }

 private:
  using State = Vec3d;
  State rate(const State& s) const {
    const double sine = std::sin(s.x), cosine = std::cos(s.x);
    const double precession = (momentum_ - along_ * cosine) / (across_ * sine * sine);
    return {s.y, (across_ * precession * precession * cosine - along_ * precession + weight_) * sine / across_,
            precession};
  }
  double across_, along_, weight_, momentum_, time_ = 0.0;
  State s_{tilt, 0.0, 0.0};
};

/// From axes of the upright top to space.
Vec3d tilted(const Vec3d& p) {
  return {std::cos(tilt) * p.x + std::sin(tilt) * p.z, p.y, std::cos(tilt) * p.z - std::sin(tilt) * p.x};
}

/// Farthest distance of a node from the reference's tip.
double farthest(Experiment& experiment, int tip, Top top) {
  double worst = 0.0;
  run_to_end(experiment, [&](const impact::Snapshot& now) {
    if (now.state.cycle % 20 == 0)
      worst = std::max(worst, norm(experiment.position(now, tip) - top.tip(now.state.time)));
  });
  return worst;
}

// Sabotage: the spin of the body kept along its first axis; gyroscopic terms left out (the angular momentum kept in the
// body's axes).
TEST(Tops, RigidBodyOnASphericalJoint) {
  const double mass = density * side * side * height, arm = 0.5 * height;
  const double own = mass * (side * side + height * height) / 12.0, along = mass * side * side / 6.0;
  Specimen s;
  const int pivot = s.node({}), ground = s.node({}), tip = s.node(tilted({0, 0, height}));
  const Vec3d center = tilted({0, 0, arm}), w = tilted({0, 0, spin});
  const Vec3d velocity = cross(w, center), axis = tilted({0, 0, 1});
  s.card("MAT_RIGID", {1, density, 71240.0, 0.3}).text(fields({}) + fields({}));
  s.card("MAT_RIGID", {2, density, 71240.0, 0.3}).text(fields({1, 7, 7}) + fields({}));
  // own 1 + (along - own) a a
  const double d = along - own;
  s.text("*PART_INERTIA\ntop\n" + fields({1, 0, 1}) + fields({center.x, center.y, center.z, mass}) +
         fields({own + d * axis.x * axis.x, d * axis.x * axis.y, d * axis.x * axis.z, own + d * axis.y * axis.y,
                 d * axis.y * axis.z, own + d * axis.z * axis.z}) +
         fields({velocity.x, velocity.y, velocity.z, w.x, w.y, w.z}));
  s.text("*PART_INERTIA\nground\n" + fields({2, 0, 2}) + fields({0, 0, 0, 1}) + fields({1, 0, 0, 1, 0, 1}) +
         fields({}));
  s.node_set(1, {pivot, tip}).card("CONSTRAINED_EXTRA_NODES_SET", {1, 1});
  s.node_set(2, {ground}).card("CONSTRAINED_EXTRA_NODES_SET", {2, 2});
  s.card("CONSTRAINED_JOINT_SPHERICAL", {double(pivot), double(ground), 0, 0, 0, 0, 1, 1});
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, gravity});
  s.text(constant_curve(90, 1e-5))
      .card("CONTROL_TIMESTEP", {0, 0.9, 0, 0, 0, 90})
      .card("CONTROL_TERMINATION", {end_time});
  Experiment experiment(s.deck());
  const double error = farthest(experiment, tip, {own + mass * arm * arm, along, mass * gravity * arm});
  expect_reference("fast top", "fast top, rigid: distance of its tip from Lagrange's, over the radius of its path",
                   error, 0.0, 0.02, height * std::sin(tilt));
}

// Sixty turns of elastic bricks. Their lumped masses have a larger moment of inertia than the block; the reference has
// that of the masses.
TEST(Tops, ElasticBricksOnAPinnedNode) {
  Specimen s;
  s.card("MAT_ELASTIC", {1, density, 71240.0, 0.33}).card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
  s.card("CONTROL_HOURGLASS", {6, 1.0}).card("CONTROL_TERMINATION", {end_time});
  const Grid grid = s.bricks(1, {2, 2, 8}, [](int i, int j, int k) {
    return tilted({0.5 * side * (i - 1), 0.5 * side * (j - 1), height * k / 8.0});
  });
  const Vec3d axis = tilted({0, 0, 1});
  s.text("*INITIAL_VELOCITY_GENERATION\n" + fields({1, 2, spin}) + fields({0, 0, 0, axis.x, axis.y, axis.z}));
  s.text("*BOUNDARY_SPC_NODE\n" + fields({double(grid(1, 1, 0)), 0, 1, 1, 1}));
  s.text(constant_curve(1)).card("LOAD_BODY_Z", {1, gravity});
  Experiment experiment(s.deck());
  double across = 0.0, along = 0.0, moment = 0.0;
  const system::System& system = experiment.system();
  for (std::size_t n = 0; n < experiment.model().nodes.size(); ++n) {
    const double m = system.mass[system.node_of[n]];
    const Vec3d x = experiment.model().nodes.x[n];
    const double z = dot(x, axis), r2 = dot(x, x) - z * z;
    along += m * r2, across += m * (0.5 * r2 + z * z), moment += m * gravity * z;
  }
  const double error = farthest(experiment, grid(1, 1, 8), {across, along, moment});
  expect_reference("fast top", "fast top, elastic bricks: the same", error, 0.0, 0.02, height * std::sin(tilt));
}

}  // namespace
}  // namespace nugget::verify
