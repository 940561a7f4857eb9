// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/relaxation.hpp"

#include <algorithm>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

/// Of nodes and rigid bodies, with the velocities of half a step before.
double kinetic_energy(const system::System& system, const system::State& state) {
  double twice = 0.0;
  for (std::size_t k = 0; k < system.nodes; ++k)
    twice += system.mass[k] * dot(vec(state.v[k]), vec(state.v[k])) +
             system.inertia[k] * dot(vec(state.w[k]), vec(state.w[k]));
  for (const system::RigidBody& body : system.bodies) {
    const auto k = at(body.node);
    twice += body.mass * dot(vec(state.v[k]), vec(state.v[k])) + dot(body.angular_momentum, vec(state.w[k]));
  }
  return 0.5 * twice;
}

}  // namespace

void Relaxation::damp(system::System& system, system::State& state) const {
  const double factor = control_.factor;
  for (std::size_t k = 0; k < state.v.size(); ++k) {
    Row &v = state.v[k], &w = state.w[k];
    v = {factor * v.x, factor * v.y, factor * v.z, 0.0};
    w = {factor * w.x, factor * w.y, factor * w.z, 0.0};
  }
  for (system::RigidBody& body : system.bodies) body.angular_momentum = factor * body.angular_momentum;
}

void Relaxation::watch(const system::System& system, const system::State& state) {
  cycles_ = state.cycle;
  time_ = state.time;
  // The energy is that of a vibration: ten looks between two checks find its largest value well enough.
  const long between = std::max(1, control_.check_cycles / 10);
  const bool check = state.cycle % control_.check_cycles == 0;
  if (!check && state.cycle % between != 0) return;
  recent_ = std::max(recent_, kinetic_energy(system, state));
  if (!check) return;
  largest_ = std::max(largest_, recent_);
  kinetic_energy_ratio_ = largest_ > 0.0 ? recent_ / largest_ : 0.0;
  at_rest_ = kinetic_energy_ratio_ < control_.tolerance;
  recent_ = 0.0;
}

void Relaxation::archive(Archive& a) {
  a(recent_, largest_, kinetic_energy_ratio_, time_, cycles_, at_rest_);
  a.built(control_);
}

}  // namespace nugget::impact
