// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/gas_volume.hpp"

#include <cmath>

#include "impact/conditions/in_force.hpp"

namespace nugget::impact {

ActingLoad<model::ControlVolume>::ActingLoad(const model::ControlVolume& source, const system::System& system)
    : source_(source), system_(system), faces_(source.segments, source.share, system) {
  gas_.at_start = source.volume_scale *
                  enclosed_volume(source.segments, source.openings, [&](model::Index n) { return system.ties.x[n]; });
  gas_.volume = gas_.at_start;
  if (source.gas == model::ControlVolume::Gas::flowing) gas_.bag = bag_at_start(source, gas_.at_start);
}

double ActingLoad<model::ControlVolume>::volume(const system::State& state) const {
  return source_.volume_scale * enclosed_volume(source_.segments, source_.openings, places(state));
}

void ActingLoad<model::ControlVolume>::apply(system::State& state, double dt, double& work) {
  gas_.volume = volume(state);
  gas_.pressure = source_.pressure_scale * pressure(state, dt);
  const double before = work;
  faces_.press(-gas_.pressure, state, dt, work);
  gas_.work += work - before;
}

double ActingLoad<model::ControlVolume>::pressure(const system::State& state, double dt) {
  using Kind = model::ControlVolume::Gas;
  const auto curve = [&](model::Index c) -> const Curve& { return system_.model.curves[c]; };
  const double relative = gas_.volume / gas_.at_start;
  if (!(relative > 0.0)) return 0.0;
  if (source_.gas == Kind::flowing) {
    const model::Index c = source_.flowing.inflow_curve;
    const Curve* inflow = c != model::none && in_force(curve(c), state) ? &curve(c) : nullptr;
    const double vent_area = model::surface_area(source_.flowing.vent.faces, places(state));
    advance(gas_.bag, source_, system_.model.curves, gas_.volume, inflow, !state.relaxing, state.time, dt, vent_area);
    return gas_.bag.pressure - source_.ambient;
  }
  if (source_.gas == Kind::adiabatic) {
    if (source_.preload_curve != model::none && !gas_.preload_over) {
      gas_.preload_over = curve(source_.preload_curve).clamped(state.time) != 0.0;
      if (!gas_.preload_over) return source_.beta * (source_.absolute - source_.ambient);
    }
    gas_.relative_pressure = std::pow(relative, -source_.gamma);
    return source_.beta * (source_.absolute * gas_.relative_pressure - source_.ambient);
  }
  if (state.relaxing && source_.relaxation_curve != model::none)
    return source_.beta * curve(source_.relaxation_curve).zero_outside(state.time) / relative;
  if (source_.gas == Kind::curve) return curve(source_.curve).clamped(relative);
  if (source_.coefficient_curve != model::none)
    return source_.beta * load_value(curve(source_.coefficient_curve), state.time, state) / relative;
  return source_.coefficient / relative;
}

void ActingLoad<model::ControlVolume>::archive(Archive& a) {
  a(gas_, faces_);
  a.built(source_, system_);
}

}  // namespace nugget::impact
