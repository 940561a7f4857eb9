// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/spring.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nugget::kernel {
namespace {

double steepest(const Curve& curve) {
  double s = 0.0;
  for (std::size_t i = 0; i + 1 < curve.x.size(); ++i)
    s = std::max(s, std::abs((curve.y[i + 1] - curve.y[i]) / (curve.x[i + 1] - curve.x[i])));
  return s;
}

/// On the curve, whose end slopes go on.
double on(const Curve& curve, double x) {
  if (x > curve.x.front()) return curve.extrapolated(x);
  return curve.y.front() + curve.slope(x) * (x - curve.x.front());
}

}  // namespace

double ReversingSpring::reach(const Curve& curve, double start, double force, bool towards_tension) {
  const double sign = towards_tension ? 1.0 : -1.0;
  double from = start;
  const auto on_piece = [&](double to) {
    const double begin = on(curve, from), end = on(curve, to);
    return end == begin ? from : from + (to - from) * (force - begin) / (end - begin);
  };
  if (sign * (on(curve, from) - force) >= 0.0) return from;
  const std::size_t count = curve.x.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double to = towards_tension ? curve.x[i] : curve.x[count - 1 - i];
    if (sign * (to - from) <= 0.0) continue;
    if (sign * (on(curve, to) - force) >= 0.0) return on_piece(to);
    from = to;
  }
  // Behind the last point: its slope leads there, unless it falls; then the end is as far as the curve reaches.
  const double slope = curve.slope(from + sign * std::abs(from) + sign);
  return slope > 0.0 ? from + (force - on(curve, from)) / slope : from;
}

double ReversingSpring::advance(State& s, double increment) const {
  s.elongation += increment;
  const double d = s.elongation;
  const auto unloading_at = [&](double force) {
    const bool above = force >= on(unload, 0.0);
    return reach(unload, 0.0, force, above);
  };
  if (!s.yielded) {
    s.force = on(load, d);
    s.tension = reach(load, 0.0, tension_yield, true);
    s.compression = reach(load, 0.0, compression_yield, false);
    if (d <= s.tension && d >= s.compression) return s.force;
    s.yielded = true;
    s.shift = d > s.tension ? s.tension - unloading_at(tension_yield) : s.compression - unloading_at(compression_yield);
  }
  const double trial = on(unload, d - s.shift), upper = on(load, s.tension), lower = on(load, s.compression);
  s.force = trial;
  if (trial > upper) {
    s.tension += d - (s.shift + unloading_at(upper));
    s.force = on(load, s.tension);
    if (isotropic) s.compression = reach(load, 0.0, compression_yield - (s.force - tension_yield), false);
  } else if (trial < lower) {
    s.compression += d - (s.shift + unloading_at(lower));
    s.force = on(load, s.compression);
    if (isotropic) s.tension = reach(load, 0.0, tension_yield + (compression_yield - s.force), true);
  } else {
    return s.force;
  }
  s.shift = d - unloading_at(s.force);
  return s.force;
}

double MaxwellSpring::advance(State& s, double increment, double dt) const {
  s.elongation += increment;
  s.time += dt;
  const double z = decay * dt;
  // (1 - e^-z)/z, by its series where z is small.
  const double mean = z > 1e-6 ? -std::expm1(-z) / z : 1.0 - 0.5 * z;
  s.relaxing_force =
      s.relaxing_force * std::exp(-z) + (instantaneous_stiffness - long_term_stiffness) * mean * increment;
  return s.time > cut_off ? last_force : long_term_stiffness * s.elongation + s.relaxing_force;
}

double InelasticSpring::advance(State& s, double increment) const {
  s.elongation += increment;
  const double way = tension ? s.elongation : -s.elongation;
  double force = std::max(0.0, unloading * (way - s.remaining));
  if (way > 0.0 && force > load(way)) {
    force = std::max(0.0, load(way));
    s.remaining = way - force / unloading;
  }
  return tension ? force : -force;
}

Spring::State Spring::start() const {
  return std::visit([](const auto& l) -> State { return typename std::decay_t<decltype(l)>::State{}; }, law);
}

double Spring::advance(State& state, double increment, double velocity, double dt) const {
  if (const auto* l = std::get_if<DiscreteSpring>(&law))
    return l->advance(std::get<DiscreteSpring::State>(state), increment, velocity);
  if (const auto* l = std::get_if<ReversingSpring>(&law))
    return l->advance(std::get<ReversingSpring::State>(state), increment);
  if (const auto* l = std::get_if<MaxwellSpring>(&law))
    return l->advance(std::get<MaxwellSpring::State>(state), increment, dt);
  return std::get<InelasticSpring>(law).advance(std::get<InelasticSpring::State>(state), increment);
}

double ReversingSpring::stiffness_at(double first) const {
  if (first == 0.0) return 0.5 * (load.slope(0.0) + load.slope(std::nextafter(0.0, -1.0)));
  State state;
  advance(state, first);
  return state.yielded ? unload.slope(first - state.shift) : load.slope(first);
}

double InelasticSpring::stiffness_at(double first) const {
  if (first == 0.0) return load.slope(0.0);
  const double way = tension ? first : -first;
  return way > 0.0 ? load.slope(way) : 0.0;
}

double Spring::stiffness_at(double elongation) const {
  if (const auto* l = std::get_if<MaxwellSpring>(&law)) return l->instantaneous_stiffness;
  if (const auto* l = std::get_if<ReversingSpring>(&law)) return l->stiffness_at(elongation);
  if (const auto* l = std::get_if<InelasticSpring>(&law)) return l->stiffness_at(elongation);
  return std::get<DiscreteSpring>(law).stiffness_at(elongation);
}

double Spring::initial_viscosity() const {
  const auto* l = std::get_if<DiscreteSpring>(&law);
  return l ? l->initial_viscosity() : 0.0;
}

double Spring::greatest_stiffness() const {
  if (const auto* l = std::get_if<DiscreteSpring>(&law)) return l->greatest_stiffness();
  if (const auto* l = std::get_if<ReversingSpring>(&law)) return std::max(steepest(l->load), steepest(l->unload));
  if (const auto* l = std::get_if<MaxwellSpring>(&law))
    return std::max(l->instantaneous_stiffness, l->long_term_stiffness);
  return std::get<InelasticSpring>(law).unloading;
}

double Spring::greatest_viscosity(double force) const {
  const auto* l = std::get_if<DiscreteSpring>(&law);
  return l ? l->greatest_viscosity(force) : 0.0;
}

}  // namespace nugget::kernel
