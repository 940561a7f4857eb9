// SPDX-License-Identifier: Apache-2.0
#include "impact/joints.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "impact/body_points.hpp"

namespace nugget::impact {
namespace {

constexpr double stiffness_share = 0.25, largest_share = 0.5, damping_ratio = 0.1;

using Kind = model::Joint::Kind;

}  // namespace

Joints::Joints(const system::System& system) : system_(system), springs_(system) {
  for (const model::Joint& source : system.model.joints) {
    Joint j;
    j.source = &source;
    const auto place = [&](std::size_t i) { return source.point[i]; };
    // The pairs stand at one place but for the last digits of their coordinates: A's place counts.
    for (std::size_t side = 0; side < 2; ++side) {
      j.body[side] = &system.bodies[at(system.body_of[at(source.body[side])])];
      j.arm[side] = place(0) - j.body[side]->center0;
    }
    if (source.kind != Kind::spherical) j.axis = unit(place(2) - place(0));
    if (source.kind == Kind::universal)
      j.directions.push_back({j.axis, unit(place(3) - place(1)), true});
    else if (source.kind != Kind::spherical)
      j.directions.push_back({j.axis, j.axis});
    if (source.kind == Kind::translational || source.kind == Kind::locking) {
      const Vec3d off = place(4) - place(0), across = unit(off - dot(off, j.axis) * j.axis);
      j.directions.push_back({across, across});
    }
    if (source.kind == Kind::cylindrical || source.kind == Kind::translational) j.held = Held::across;
    if (source.kind == Kind::planar) j.held = Held::along;
    joints_.push_back(std::move(j));
  }
  find_bounds();
}

void Joints::find_bounds() {
  std::vector<int> pieces(system_.bodies.size(), 0);
  const auto count = [&](const system::RigidBody* body) -> int& { return pieces[at(body->node) - system_.nodes]; };
  for (const Joint& j : joints_)
    for (const system::RigidBody* body : j.body) count(body) += 1 + static_cast<int>(j.directions.size());
  for (Joint& j : joints_) {
    // Traces: row sums in body axes would change as bodies turn. They bound the largest eigenvalue.
    double shared = 0.0, rotary_shared = 0.0, own = 0.0, rotary_own = 0.0;
    for (const std::size_t side : {0u, 1u}) {
      const system::RigidBody& body = *j.body[side];
      const system::Mobility::Matrix inverse = system::inverse_inertia(body);
      const double point = trace(inverse_mass_at(body, inverse, j.arm[side])), turning = trace(inverse);
      own += point;
      rotary_own += turning;
      shared += count(&body) * point;
      rotary_shared += count(&body) * turning;
    }
    const double share = std::min(stiffness_share * j.source->stiffness_scale, largest_share);
    const auto over = [](double a, double sum) { return sum > 0.0 ? a / sum : 0.0; };
    j.bound = over(share, shared);
    j.rotary_bound = over(share, rotary_shared);
    // c = 2 xi sqrt(k m) with the mean mass of the relative motion.
    const double ratio = 2.0 * damping_ratio * j.source->damping;
    j.damping = ratio * std::sqrt(j.bound * over(3.0, own));
    j.rotary_damping = ratio * std::sqrt(j.rotary_bound * over(3.0, rotary_own));
  }
}

void Joints::apply(system::State& state) {
  longest_step_ = std::max(longest_step_, state.dt);
  springs_.apply(state);
  if (!(longest_step_ > 0.0)) return;
  for (Joint& j : joints_) apply(j, state, longest_step_);
}

void Joints::apply(Joint& j, system::State& state, double longest_step) {
  const double k = j.bound / (longest_step * longest_step), rotary = j.rotary_bound / (longest_step * longest_step);
  const double c = j.damping / longest_step, rotary_c = j.rotary_damping / longest_step;
  std::array<Vec3d, 2> arm, point, velocity, spin;
  for (std::size_t side = 0; side < 2; ++side) {
    const system::RigidBody& body = *j.body[side];
    const std::size_t n = at(body.node);
    arm[side] = body.axes.global(j.arm[side]);
    point[side] = vec(state.x[n]) + arm[side];
    spin[side] = vec(state.w[n]);
    velocity[side] = vec(state.v[n]) + cross(spin[side], arm[side]);
  }
  const Vec3d axis = j.body[0]->axes.global(j.axis), gap = point[1] - point[0];
  // B's point meets that point of A which is where it is.
  const Vec3d sliding = velocity[1] - velocity[0] - cross(spin[0], gap), turning = spin[1] - spin[0];
  const auto held = [&](const Vec3d& v) {
    const Vec3d along = dot(v, axis) * axis;
    return j.held == Held::all ? v : j.held == Held::along ? along : v - along;
  };
  const Vec3d open = held(gap);
  j.force = -k * open - c * held(sliding);
  j.moment = {};
  for (const Directions& d : j.directions) {
    const Vec3d a = j.body[0]->axes.global(d.a), b = j.body[1]->axes.global(d.b), normal = cross(a, b);
    const double cosine = dot(a, b);
    j.moment += (d.perpendicular ? rotary * cosine : -rotary * cosine) * normal;
    // What turns the directions against each other: about their normal where they are to be perpendicular, across
    // them where they are to be parallel.
    const Vec3d rate = d.perpendicular ? dot(turning, normal) * normal : turning - dot(turning, a) * a;
    j.moment -= rotary_c * rate;
  }
  j.opening = norm(open);
  j.largest_opening = std::max(j.largest_opening, j.opening);

  const std::array<Load, 2> before = j.load;
  j.load = {Load{-j.force, -j.moment - cross(arm[0] + gap, j.force)}, Load{j.force, j.moment + cross(arm[1], j.force)}};
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t n = at(j.body[side]->node);
    add(state.f[n], j.load[side].force);
    add(state.m[n], j.load[side].moment);
    j.energy -= 0.5 * state.dt *
                (dot(before[side].force + j.load[side].force, vec(state.v[n])) +
                 dot(before[side].moment + j.load[side].moment, spin[side]));
  }
}

double Joints::energy() const {
  double sum = springs_.energy();
  for (const Joint& j : joints_) sum += j.energy;
  return sum;
}

}  // namespace nugget::impact
