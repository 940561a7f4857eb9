// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/stoppers.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "system/constraint_map.hpp"
#include "system/mobility.hpp"

namespace nugget::impact {
namespace {

Frame3d turned(const Frame3d& axes, const Vec3d& by) {
  return {system::turned(axes.e1, by), system::turned(axes.e2, by), system::turned(axes.e3, by)};
}

}  // namespace

Stoppers::Stoppers(const system::System& system) : system_(system) {
  for (const model::BodyStopper& card : system.model.body_stoppers)
    stops_.push_back({&card, system.body_of[at(card.body)]});
}

double Stoppers::allowed(const Stop& stop, const system::State& state, double free) const {
  const model::BodyStopper& card = *stop.card;
  if (!(state.dt > 0.0) || state.time < card.birth || state.time >= card.death) return free;
  const system::RigidBody& body = system_.bodies[at(stop.body)];
  const auto at_end = [&](model::Index curve) {
    return system_.model.curves[at(curve)].clamped(state.time + state.dt);
  };
  double velocity = free;
  if (card.fastest != model::none) {
    const double most = std::abs(at_end(card.fastest));
    velocity = std::clamp(velocity, -most, most);
  }
  const double place = card.rotation ? stop.angle : dot(card.direction, vec(state.x[at(body.node)]));
  const double start = card.rotation ? 0.0 : dot(card.direction, body.center0);
  const auto to_bound = [&](const model::BodyStopper::Bound& bound) {
    return (at_end(bound.curve) + (bound.of_displacement ? start : 0.0) - place) / state.dt;
  };
  if (card.most.curve != model::none) velocity = std::min(velocity, to_bound(card.most));
  if (card.least.curve != model::none) velocity = std::max(velocity, to_bound(card.least));
  return velocity;
}

void Stoppers::apply(system::State& state, double velocity_interval, std::span<system::RigidBody> bodies) {
  power_on_change_ = 0.0;
  dt_previous_ = state.dt_previous;
  for (Stop& stop : stops_) {
    stop.force = 0.0;
    stop.before = stop.velocity;
    if (stop.card->rotation)
      stop_turning(stop, bodies[at(stop.body)], state, velocity_interval);
    else
      stop_centre(stop, bodies[at(stop.body)], state, velocity_interval);
  }
}

void Stoppers::stop_centre(Stop& stop, const system::RigidBody& body, system::State& state, double velocity_interval) {
  const Vec3d& n = stop.card->direction;
  Row& v = state.v[at(body.node)];
  const double free = dot(n, vec(v)), velocity = allowed(stop, state, free);
  if (state.cycle == 0) stop.before = free;
  if (velocity != free) {
    add(v, (velocity - free) * n);
    power_on_change_ += (velocity - free) * dot(n, vec(state.f[at(body.node)]));
    if (velocity_interval > 0.0) stop.force = body.mass * (velocity - free) / velocity_interval;
    work_ += 0.5 * stop.force * stop.before * state.dt_previous;
  }
  stop.velocity = velocity;
}

void Stoppers::stop_turning(Stop& stop, system::RigidBody& body, system::State& state, double velocity_interval) {
  const Vec3d& n = stop.card->direction;
  const Vec3d w = vec(state.w[at(body.node)]);
  const double free = dot(n, w), spin = allowed(stop, state, free);
  if (state.cycle == 0) stop.before = free;
  // A torque about n alone changes the spin about other axes too, where n is not one of the body's own.
  const system::Mobility::Matrix inverse = system::inverse_inertia(body);
  const auto along = [&](const std::array<double, 3>& row) { return row[0] * n.x + row[1] * n.y + row[2] * n.z; };
  const Vec3d answer{along(inverse[0]), along(inverse[1]), along(inverse[2])};
  const double ease = dot(n, answer);
  if (spin != free && ease > 0.0) {
    const Vec3d change = ((spin - free) / ease) * answer, before = body.angular_momentum;
    set(state.w[at(body.node)], w + change);
    body.angular_momentum = body.momentum(w + change, turned(body.axes, (0.5 * state.dt) * (w + change)));
    power_on_change_ += dot(change, vec(state.m[at(body.node)]));
    if (velocity_interval > 0.0) stop.force = dot(n, body.angular_momentum - before) / velocity_interval;
    work_ += 0.5 * stop.force * stop.before * state.dt_previous;
  }
  stop.velocity = dot(n, vec(state.w[at(body.node)]));
}

void Stoppers::book_opening_work(double dt) {
  // Both halves together are the impulse times the mean of the velocities before and after, whatever the two steps.
  for (Stop& stop : stops_) {
    work_ += 0.25 * stop.force * ((dt + dt_previous_) * stop.velocity + (dt - dt_previous_) * stop.before);
    if (stop.card->rotation) stop.angle += stop.velocity * dt;
  }
}

void Stoppers::Stop::archive(Archive& a) {
  a(force, before, velocity, angle);
  a.built(card, body);
}

void Stoppers::archive(Archive& a) {
  a(stops_, work_, dt_previous_);
  a.built(system_, power_on_change_);
}

}  // namespace nugget::impact
