// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/stoppers.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::impact {

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
  const double place = dot(card.direction, vec(state.x[at(body.node)])), start = dot(card.direction, body.center0);
  const auto to_bound = [&](const model::BodyStopper::Bound& bound) {
    return (at_end(bound.curve) + (bound.of_displacement ? start : 0.0) - place) / state.dt;
  };
  if (card.most.curve != model::none) velocity = std::min(velocity, to_bound(card.most));
  if (card.least.curve != model::none) velocity = std::max(velocity, to_bound(card.least));
  return velocity;
}

void Stoppers::apply(system::State& state, double velocity_interval) {
  power_on_change_ = 0.0;
  for (Stop& stop : stops_) {
    const system::RigidBody& body = system_.bodies[at(stop.body)];
    const Vec3d& n = stop.card->direction;
    Row& v = state.v[at(body.node)];
    const double free = dot(n, vec(v)), velocity = allowed(stop, state, free);
    stop.force = 0.0;
    if (velocity != free) {
      add(v, (velocity - free) * n);
      power_on_change_ += (velocity - free) * dot(n, vec(state.f[at(body.node)]));
      if (velocity_interval > 0.0) stop.force = body.mass * (velocity - free) / velocity_interval;
      work_ += 0.5 * stop.force * stop.velocity * state.dt_previous;
    }
    stop.velocity = velocity;
  }
}

void Stoppers::book_opening_work(double dt) {
  for (const Stop& stop : stops_) work_ += 0.5 * stop.force * stop.velocity * dt;
}

void Stoppers::Stop::archive(Archive& a) {
  a(force, velocity);
  a.built(card, body);
}

void Stoppers::archive(Archive& a) {
  a(stops_, work_);
  a.built(system_, power_on_change_);
}

}  // namespace nugget::impact
