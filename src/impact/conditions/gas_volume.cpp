// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/gas_volume.hpp"

#include <fmt/format.h>

#include <cmath>

#include "impact/conditions/in_force.hpp"

namespace nugget::impact {

ActingLoad<model::ControlVolume>::ActingLoad(const model::ControlVolume& source, const system::System& system)
    : source_(source), system_(system), faces_(source.segments, source.share, system) {
  gas_.at_start = source.volume_scale *
                  enclosed_volume(source.segments, source.openings, [&](model::Index n) { return system.ties.x[n]; });
  gas_.volume = gas_.at_start;
  if (source.gas == model::ControlVolume::Gas::flowing) gas_.bag = bag_at_start(source, gas_.at_start);
  for (const model::PorousFabric& fabric : source.flowing.fabric) {
    Porous& porous = porous_.emplace_back();
    for (const model::Segment& face : fabric.faces)
      porous.at_start.push_back(model::face_area(face, [&](model::Index n) { return system.ties.x[n]; }));
    if (fabric.covered_by_contact) porous.covered.assign(fabric.faces.size(), 0.0);
  }
  openings_.fabric.resize(porous_.size());
}

void ActingLoad<model::ControlVolume>::find_covered(const std::function<bool(int)>& presses) {
  for (std::size_t i = 0; i < porous_.size(); ++i) {
    const std::vector<model::Segment>& faces = source_.flowing.fabric[i].faces;
    for (std::size_t f = 0; f < porous_[i].covered.size(); ++f) {
      const model::Segment& face = faces[f];
      const std::size_t corners = face[3] == face[2] ? 3 : 4;
      int pressed = 0;
      for (std::size_t c = 0; c < corners; ++c) pressed += presses(system_.node_of[face[c]]) ? 1 : 0;
      porous_[i].covered[f] = static_cast<double>(pressed) / static_cast<double>(corners);
    }
  }
}

void ActingLoad<model::ControlVolume>::find_openings(const system::State& state) {
  openings_.vent = model::surface_area(source_.flowing.vent.faces, places(state));
  for (std::size_t i = 0; i < porous_.size(); ++i) {
    const model::PorousFabric& fabric = source_.flowing.fabric[i];
    const Porous& porous = porous_[i];
    const double leaks = fabric.covered_curve == model::none
                             ? fabric.covered
                             : system_.model.curves[fabric.covered_curve].clamped(state.time);
    Openings::Faces sum;
    for (std::size_t f = 0; f < fabric.faces.size(); ++f) {
      const double open = porous.covered.empty() ? 1.0 : 1.0 - (1.0 - leaks) * porous.covered[f];
      sum.now += open * model::face_area(fabric.faces[f], places(state));
      sum.at_start += open * porous.at_start[f];
    }
    openings_.fabric[i] = sum;
  }
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
    find_openings(state);
    advance(gas_.bag, source_, system_.model.curves, gas_.volume, inflow, !state.relaxing, state.time, dt, openings_);
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

std::vector<std::string> leakage_summary(const std::vector<ActingLoad<model::ControlVolume>>& gases) {
  std::vector<std::string> lines;
  int number = 0;
  for (const auto& acting : gases) {
    ++number;
    const model::ControlVolume& source = acting.source();
    if (source.flowing.fabric.empty()) continue;
    const Bag& bag = acting.gas().bag;
    lines.push_back(
        fmt::format("gas {}: a mass of {:.4g} has leaked through fabric and {:.4g} has left otherwise; {:.4g} is there",
                    source.id > 0 ? source.id : number, bag.leaked, bag.vented, bag.mass));
  }
  return lines;
}

void ActingLoad<model::ControlVolume>::archive(Archive& a) {
  a(gas_, faces_);
  a.built(source_, system_, porous_, openings_);  // what of these changes is found in each cycle before it is used
}

}  // namespace nugget::impact
