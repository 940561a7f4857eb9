// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/joint_springs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "base/rotation_between.hpp"
#include "impact/connections/body_points.hpp"

namespace nugget::impact {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<Vec3d, 3> rows(const Frame3d& f) {
  return {f.e1, f.e2, f.e3};
}

}  // namespace

double JointSprings::Freedom::advance(double increment, double rate) {
  const double place = now.place + increment;
  friction = std::clamp(friction + stiffness * increment, -friction_limit, friction_limit);
  const double beyond = place > high ? place - high : place < low ? place - low : 0.0;
  now = {place, rate, load(place) + friction + stiffness * beyond, damper(rate)};
  return now.stiffness + now.damping;
}

JointSprings::JointSprings(const system::System& system) {
  for (const model::JointStiffness& source : system.model.joint_stiffnesses) {
    Spring s;
    s.rotational = source.rotational;
    for (std::size_t side = 0; side < 2; ++side) {
      s.body[side] = &system.bodies[system.body_of[source.body[side]]];
      s.arm[side] = source.origin[side] - s.body[side]->center0;
    }
    s.axes = source.axes[1];
    const Vec3d start =
        s.rotational ? rotation_between(source.axes[0], source.axes[1]) : source.origin[1] - source.origin[0];
    const std::array<Vec3d, 3> e = rows(s.axes);
    for (std::size_t i = 0; i < 3; ++i) {
      const model::JointStiffness::Freedom& given = source.freedom[i];
      const auto curve = [&](model::Index c) {
        return c == model::none ? kernel::ForceCurve() : kernel::ForceCurve(system.model.curves[c]);
      };
      Freedom& f = s.freedom[i];
      f.load = curve(given.load);
      f.damper = curve(given.damper);
      f.stiffness = given.stiffness;
      f.friction_limit = given.friction;
      f.low = given.low_stop > 0.0 ? -given.low_stop : -infinity;
      f.high = given.high_stop > 0.0 ? given.high_stop : infinity;
      f.now.place = dot(e[i], start);
    }
    springs_.push_back(std::move(s));
  }
  find_stable_step();
}

void JointSprings::find_stable_step() {
  stable_step_ = infinity;
  const auto sharing = [this](const system::RigidBody* body) {
    return static_cast<double>(std::count_if(
        springs_.begin(), springs_.end(), [body](const Spring& s) { return s.body[0] == body || s.body[1] == body; }));
  };
  for (const Spring& s : springs_) {
    double stiffness = 0.0, viscosity = 0.0, mobility = 0.0;
    for (const Freedom& f : s.freedom) {
      const bool stops = f.low > -infinity || f.high < infinity;
      stiffness = std::max(
          stiffness, f.load.steepest() + (f.friction_limit > 0.0 ? f.stiffness : 0.0) + (stops ? f.stiffness : 0.0));
      viscosity = std::max(viscosity, f.damper.steepest());
    }
    for (std::size_t side = 0; side < 2; ++side) {
      const system::Mobility::Matrix inverse = system::inverse_inertia(*s.body[side]);
      mobility +=
          sharing(s.body[side]) * trace(s.rotational ? inverse : inverse_mass_at(*s.body[side], inverse, s.arm[side]));
    }
    // x'' = -k G x - c G x', the damper half a step late: dt = (sqrt(c^2 G + 4 k) - c sqrt(G)) / (k sqrt(G)).
    const double c = viscosity * std::sqrt(mobility), over = std::sqrt(c * c + 4.0 * stiffness) + c;
    if (over > 0.0 && mobility > 0.0) stable_step_ = std::min(stable_step_, 4.0 / (over * std::sqrt(mobility)));
  }
}

void JointSprings::apply(system::State& state) {
  for (Spring& s : springs_) apply(s, state);
}

void JointSprings::apply(Spring& s, system::State& state) {
  std::array<Vec3d, 2> arm, spin, velocity;
  for (std::size_t side = 0; side < 2; ++side) {
    const system::RigidBody& body = *s.body[side];
    spin[side] = vec(state.w[body.node]);
    arm[side] = body.axes.global(s.arm[side]);
    velocity[side] = vec(state.v[body.node]);
  }
  const auto centre = [&](std::size_t side) { return vec(state.x[s.body[side]->node]); };
  const Vec3d gap = centre(1) + arm[1] - centre(0) - arm[0];
  const Vec3d lever = arm[1] - gap;  // from B's centre to the origin of A
  const Vec3d rate =
      s.rotational ? spin[1] - spin[0] : velocity[1] + cross(spin[1], lever) - velocity[0] - cross(spin[0], arm[0]);
  Vec3d load{};
  const std::array<Vec3d, 3> own = rows(s.axes);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3d e = s.body[1]->axes.global(own[i]);
    Freedom& f = s.freedom[i];
    const double speed = dot(e, rate);
    load -= f.advance(s.rotational ? state.dt * speed : dot(e, gap) - f.now.place, speed) * e;
  }
  const std::array<Vec3d, 2> force_before = s.force, moment_before = s.moment;
  if (s.rotational) {
    s.moment = {-load, load};
  } else {
    s.force = {-load, load};
    s.moment = {-cross(arm[0], load), cross(lever, load)};
  }
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t n = at(s.body[side]->node);
    add(state.f[n], s.force[side]);
    add(state.m[n], s.moment[side]);
    s.energy -= 0.5 * state.dt *
                (dot(force_before[side] + s.force[side], velocity[side]) +
                 dot(moment_before[side] + s.moment[side], spin[side]));
  }
}

double JointSprings::energy() const {
  double sum = 0.0;
  for (const Spring& s : springs_) sum += s.energy;
  return sum;
}

void JointSprings::Freedom::archive(Archive& a) {
  a(friction, now.place, now.rate, now.stiffness, now.damping);
  a.built(load, damper, stiffness, friction_limit, low, high);
}

void JointSprings::Spring::archive(Archive& a) {
  for (Freedom& f : freedom) a(f);
  a(force, moment, energy);
  a.built(rotational, body, arm, axes);
}

void JointSprings::archive(Archive& a) {
  a(springs_);
  a.built(stable_step_);
}

}  // namespace nugget::impact
