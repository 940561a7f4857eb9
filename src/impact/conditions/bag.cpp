// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/bag.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::impact {
namespace {

using model::ControlVolume;
using model::FlowingGas;
using model::PorousFabric;

/// Per mass.
double enthalpy(const FlowingGas& gas, double temperature) {
  return (gas.heat + 0.5 * gas.heat_slope * temperature) * temperature;
}

double heat_ratio(const FlowingGas& gas, double temperature) {
  const double cp = gas.heat + gas.heat_slope * temperature;
  return cp / (cp - gas.constant);
}

/// Temperature and pressure by mass, energy and volume.
void set_pressure(Bag& bag, const FlowingGas& gas) {
  const double energy = bag.mass > 0.0 ? std::max(0.0, bag.energy / bag.mass) : 0.0;
  const double cv = gas.heat - gas.constant;
  bag.temperature = 2.0 * energy / (cv + std::sqrt(cv * cv + 2.0 * gas.heat_slope * energy));
  bag.pressure = bag.mass * gas.constant * bag.temperature / bag.volume;
}

/// Of the curve, which is 0 outside its range.
double integral(const Curve& curve, double from, double to) {
  double sum = 0.0;
  auto i = static_cast<std::size_t>(std::upper_bound(curve.x.begin(), curve.x.end(), from) - curve.x.begin());
  for (i = std::max<std::size_t>(i, 1); i < curve.x.size() && curve.x[i - 1] < to; ++i) {
    const double a = std::max(from, curve.x[i - 1]), b = std::min(to, curve.x[i]);
    const double slope = (curve.y[i] - curve.y[i - 1]) / (curve.x[i] - curve.x[i - 1]);
    sum += (b - a) * (curve.y[i - 1] + slope * (0.5 * (a + b) - curve.x[i - 1]));
  }
  return sum;
}

}  // namespace

Bag bag_at_start(const ControlVolume& source, double volume) {
  const FlowingGas& gas = source.flowing;
  Bag bag;
  bag.volume = volume;
  bag.mass = gas.density * volume;
  if (gas.overpressure > 0.0) bag.mass += gas.overpressure * volume / (gas.constant * gas.temperature);
  bag.energy = bag.mass * (enthalpy(gas, gas.temperature) - gas.constant * gas.temperature);
  set_pressure(bag, gas);
  return bag;
}

Outflow outflow(const ControlVolume& source, const std::vector<Curve>& curves, double pressure, double temperature,
                double time, bool popped, const Openings& openings) {
  const FlowingGas& gas = source.flowing;
  if (!(pressure > source.ambient)) return {};
  const auto by_curve = [&](double value, model::Index curve, double at) {
    return curve == model::none ? value : curves[curve].clamped(at);
  };
  const auto opening_of = [&](const model::Vent& vent) {
    const double shape = by_curve(vent.shape, vent.shape_curve, pressure);
    const double area = vent.faces.empty() ? by_curve(vent.area, vent.area_curve, pressure) : openings.vent;
    return by_curve(shape, vent.shape_over_time, time) * area;
  };
  const bool by_flow = gas.outflow_curve != model::none;
  const double given = by_flow && popped ? curves[gas.outflow_curve].clamped(pressure - source.ambient) : 0.0;
  const double opening = (by_flow || !popped ? 0.0 : opening_of(gas.vent)) + opening_of(gas.leak);
  const double density = pressure / (gas.constant * temperature);
  double fabric_orifice = 0.0, fabric_flow = 0.0;  // open area of the one kind, mass flow of the others
  for (std::size_t i = 0; i < gas.fabric.size(); ++i) {
    const PorousFabric& fabric = gas.fabric[i];
    const Openings::Faces& faces = openings.fabric[i];
    const double share = by_curve(fabric.share, fabric.share_curve, pressure);
    double open =
        by_curve(fabric.leakage, fabric.leakage_curve, time) * share * faces.now;  // a flow of volume with 7, 8
    if (fabric.by_stretch) {
      const auto& [x0, x1, x2, x3] = *fabric.by_stretch;
      const double q = source.ambient / pressure;
      open = std::max(0.0, (x0 + x2 * q) * faces.at_start + (x1 + x3 * q) * faces.now);
    }
    switch (fabric.flow) {
      case PorousFabric::Flow::orifice: fabric_orifice += open; break;
      case PorousFabric::Flow::pressure:
        fabric_flow += open * std::sqrt(2.0 * density * (pressure - source.ambient));
        break;
      case PorousFabric::Flow::velocity: fabric_flow += open * density; break;
    }
  }
  if (opening == 0.0 && fabric_orifice == 0.0) return {given, fabric_flow};
  const double k = heat_ratio(gas, temperature);
  const double ratio = std::max(source.ambient / pressure, std::pow(2.0 / (k + 1.0), k / (k - 1.0)));
  const double flow = k / (k - 1.0) * (std::pow(ratio, 2.0 / k) - std::pow(ratio, (k + 1.0) / k));
  const double of_area = std::sqrt(2.0 * pressure * density * flow);
  return {given + opening * of_area, fabric_flow + fabric_orifice * of_area};
}

void advance(Bag& bag, const ControlVolume& source, const std::vector<Curve>& curves, double volume,
             const Curve* inflow, bool open, double time, double dt, const Openings& openings) {
  if (!(volume > 0.0)) return;
  const FlowingGas& gas = source.flowing;
  const Bag before = bag;
  const double in = inflow ? integral(*inflow, time - dt, time) : 0.0;
  bag.volume = volume;
  bag.inflow = inflow ? inflow->zero_outside(time) : 0.0;
  bag.popped = bag.popped || before.pressure - source.ambient >= gas.pop_pressure;
  const double inflow_temperature = gas.inflow_temperature_curve == model::none
                                        ? gas.inflow_temperature
                                        : curves[gas.inflow_temperature_curve].clamped(time - 0.5 * dt);
  double out = 0.0;
  Outflow flow;
  // Each pass is nearer by the share of the gas that moves within the step.
  constexpr int passes = 4;
  for (int pass = 0; pass < passes; ++pass) {
    const double pressure = 0.5 * (before.pressure + bag.pressure);
    const double temperature = 0.5 * (before.temperature + bag.temperature);
    bag.mass = before.mass + in;
    bag.energy = before.energy + in * enthalpy(gas, inflow_temperature) - pressure * (volume - before.volume);
    set_pressure(bag, gas);
    if (!open || !(bag.pressure > source.ambient)) {
      out = 0.0;
      continue;
    }
    // No more than what is above the ambient pressure: a small volume with a large vent.
    const double left = std::pow(source.ambient / bag.pressure, 1.0 / heat_ratio(gas, bag.temperature));
    flow = impact::outflow(source, curves, pressure, temperature, time - 0.5 * dt, bag.popped, openings);
    out = std::min(dt * flow.sum(), bag.mass * (1.0 - left));
    bag.mass -= out;
    bag.energy -= out * enthalpy(gas, temperature);
    set_pressure(bag, gas);
  }
  bag.outflow = dt > 0.0 ? out / dt : 0.0;
  if (!(out > 0.0)) return;
  bag.leaked += out * (flow.leaked / flow.sum());
  bag.vented += out * (flow.vented / flow.sum());
}

}  // namespace nugget::impact
