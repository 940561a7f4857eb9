// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "impact/conditions/axes_now.hpp"
#include "impact/simulation/components.hpp"
#include "kernel/law/point_now.hpp"
#include "output/element_stresses.hpp"
#include "system/spring_group.hpp"

namespace nugget::impact {

namespace {

using model::Sensor;

double calculated(Sensor::Calculation how, const std::vector<Sensor::Term>& terms, const std::vector<double>& s) {
  using enum Sensor::Calculation;
  const auto amount = [](double a, double b) { return std::abs(a) < std::abs(b); };
  switch (how) {
    case least: return *std::min_element(s.begin(), s.end());
    case greatest: return *std::max_element(s.begin(), s.end());
    case least_amount: return std::abs(*std::min_element(s.begin(), s.end(), amount));
    case greatest_amount: return std::abs(*std::max_element(s.begin(), s.end(), amount));
    default: break;
  }
  double result = how == product ? 1.0 : 0.0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (how == product)
      result *= terms[i].inverse ? 1.0 / s[i] : s[i];
    else if (how == sum_of_amounts)
      result += std::abs(s[i]);
    else if (how == squares || how == root_of_squares)
      result += s[i] * s[i];
    else if (how == roots)
      result += std::sqrt(s[i]);
    else
      result += terms[i].inverse ? -s[i] : s[i];
  }
  return how == root_of_squares ? std::sqrt(result) : result;
}

/// Of a stress xx yy zz xy yz zx.
double component_of(const Sensor& sensor, const std::array<double, 6>& s) {
  const double mean = (s[0] + s[1] + s[2]) / 3.0;
  switch (sensor.of_element) {
    case Sensor::OfElement::hydrostatic: return mean;
    case Sensor::OfElement::von_mises: {
      const double a = s[0] - s[1], b = s[1] - s[2], c = s[2] - s[0];
      return std::sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
    }
    case Sensor::OfElement::principal:
    case Sensor::OfElement::shear: {
      std::array<double, 3> p = kernel::principal_values({s[0], s[1], s[2], s[3], s[4], s[5]});
      std::sort(p.begin(), p.end(), std::greater<>());
      return sensor.of_element == Sensor::OfElement::shear ? 0.5 * (p[0] - p[2]) : p[sensor.component];
    }
    default: return s[sensor.component];
  }
}

}  // namespace

Sensors::Sensors(const system::System& system) : system_(system) {
  const model::Model& model = system.model;
  values_.resize(model.sensors.size());
  motions_.resize(model.sensors.size());
  switches_.resize(model.sensor_switches.size());
  next_.resize(model.sensor_controls.size());
  for (const model::RunEnd& end : model.run_ends)
    if (end.of_switch != model::none) ask_for_switch(end.of_switch);
  for (const model::SensorControl& control : model.sensor_controls)
    for (const model::Index s : control.switches) ask_for_switch(s);
}

void Sensors::ask_for_switch(model::Index of_switch) {
  if (std::ranges::find(asked_switches_, of_switch) != asked_switches_.end()) return;
  const model::SensorSwitch& one = system_.model.sensor_switches[of_switch];
  for (const model::SensorSwitch::Term& term : one.terms) ask_for_switch(term.of);
  if (one.kind == model::SensorSwitch::Kind::sensor) ask_for_sensor(one.sensor);
  asked_switches_.push_back(of_switch);
}

void Sensors::ask_for_sensor(model::Index sensor) {
  if (std::ranges::find(asked_sensors_, sensor) != asked_sensors_.end()) return;
  for (const Sensor::Term& term : system_.model.sensors[sensor].terms) ask_for_sensor(term.sensor);
  asked_sensors_.push_back(sensor);
}

void Sensors::elements_read(const std::function<void(system::System::ElementLocation)>& visit) const {
  for (const model::Index i : asked_sensors_) {
    const Sensor& sensor = system_.model.sensors[i];
    if (sensor.quantity != Sensor::Quantity::element || sensor.kind == model::ElementKind::discrete) continue;
    if (const auto location = system_.location_of(sensor.kind, sensor.element); location.group >= 0) visit(location);
  }
}

double Sensors::along(const Sensor& sensor, const Vec3d& vector, const system::State& state) const {
  if (!(norm(sensor.direction) > 0.0)) return norm(vector);
  return dot(vector, sensor.system == model::none ? sensor.direction
                                                  : axes_now(system_, state, sensor.system).global(sensor.direction));
}

Vec3d Sensors::velocity_of(const Sensor& sensor, const system::State& state, bool turning) const {
  const system::Rows& rows = turning ? state.w : state.v;
  if (sensor.body != model::none) return vec(rows[at(system_.bodies[system_.body_of[sensor.body]].node)]);
  const auto of = [&](model::Index node) { return vec(rows[at(system_.node_of[node])]); };
  return sensor.node[1] == model::none ? of(sensor.node[0]) : of(sensor.node[0]) - of(sensor.node[1]);
}

/// The mean over the time between the middles of the last two steps; 0 before there were two.
Vec3d Sensors::acceleration_of(std::size_t sensor, const system::State& state, bool turning) {
  Motion& motion = motions_[sensor];
  const Vec3d now = velocity_of(system_.model.sensors[sensor], state, turning);
  const double between = 0.5 * (state.dt_previous + motion.step);
  if (motion.known && between > 0.0) motion.acceleration = (1.0 / between) * (now - motion.velocity);
  motion.velocity = now;
  motion.step = state.dt_previous;
  motion.known = true;
  return motion.acceleration;
}

Vec3d Sensors::load_of(const Sensor& sensor, const Components& components) const {
  const bool moment = sensor.quantity == Sensor::Quantity::moment;
  Vec3d sum;
  const auto add_reactions = [&](const std::vector<Supports::Reaction>& reactions) {
    for (const Supports::Reaction& r : reactions)
      if (std::ranges::binary_search(sensor.sources, r.source)) sum += moment ? r.moment : r.force;
  };
  switch (sensor.pushing) {
    case Sensor::Pushing::wall:
      for (const model::Index w : sensor.sources) sum += components.walls.all()[at(w)].force();
      break;
    case Sensor::Pushing::support: add_reactions(components.supports.spc_reactions()); break;
    case Sensor::Pushing::motion: add_reactions(components.supports.motion_reactions()); break;
    case Sensor::Pushing::joint:
      for (const model::Index j : sensor.sources)
        sum += moment ? components.joints.moment(at(j)) : components.joints.force(at(j));
      break;
    case Sensor::Pushing::contact: {
      std::size_t c = 0;
      for (std::size_t i = 0; i < system_.model.contacts.size(); ++i) {
        if (!system_.model.contacts[i].slides()) continue;
        if (static_cast<model::Index>(i) == sensor.sources.front())
          return components.contacts.all()[c].resultant_of_all_ranks();
        ++c;
      }
    }
  }
  return sum;
}

double Sensors::of_element(const Sensor& sensor, const system::State& state) const {
  const auto location = sensor.kind == model::ElementKind::discrete ? system_.discrete_location[sensor.element]
                                                                    : system_.location_of(sensor.kind, sensor.element);
  if (location.group < 0) return 0.0;
  const system::ElementGroup& group = *system_.groups[location.group];
  const std::size_t e = at(location.element);
  if (sensor.of_element == Sensor::OfElement::failed) return group.alive(e) ? 0.0 : 1.0;
  if (!group.alive(e)) return 0.0;
  if (sensor.kind == model::ElementKind::discrete) {
    const auto& springs = static_cast<const system::SpringGroup&>(group);
    return sensor.of_element == Sensor::OfElement::force ? springs.force(e) : springs.elongation(e);
  }
  if (sensor.of_element == Sensor::OfElement::resultant) return group.resultants(e)[sensor.component];
  const int layers = group.layers();
  int layer = sensor.layer < 0 ? layers - 1 : 0;
  if (sensor.layer > 0) layer = output::layers_in_elout(system_.model, group)[at(std::min(sensor.layer, layers) - 1)];
  std::array<double, 6> stress = output::shown_layer(system_, group, e, layer, state).stress;
  if (sensor.kind == model::ElementKind::solid) {
    stress = output::by_cmpflg(system_.model, group, e, layer, state, stress);
  } else if (const auto axes = output::axes_in_elout(system_, group, e, layer, state)) {
    stress = output::along(*axes, stress);
  }
  return component_of(sensor, stress);
}

namespace {

double of_belts(const Sensor& sensor, const Belts& belts) {
  const std::size_t i = at(sensor.element);
  switch (sensor.of_belt) {
    case Sensor::OfBelt::tension: return belts.force(i);
    case Sensor::OfBelt::elongation: return belts.is_inside(i) ? 0.0 : belts.length(i) - belts.unstretched(i);
    case Sensor::OfBelt::slip: return belts.slip(i);
    case Sensor::OfBelt::first_tension: return belts.ring_tension(i, 0);
    case Sensor::OfBelt::second_tension: return belts.ring_tension(i, 1);
    case Sensor::OfBelt::pull_out: return belts.pull_out(i);
    case Sensor::OfBelt::pull_out_rate: return belts.pull_out_rate(i);
    case Sensor::OfBelt::reel_tension: return belts.tension(i);
  }
  return 0.0;
}

}  // namespace

double Sensors::measure(std::size_t i, const system::State& state, const Components& components) {
  const Sensor& one = system_.model.sensors[i];
  switch (one.quantity) {
    case Sensor::Quantity::time: return state.time;
    case Sensor::Quantity::curve: return system_.model.curves[one.curve].clamped(state.time);
    case Sensor::Quantity::calculation:
    case Sensor::Quantity::function: {
      std::vector<double> values;
      for (const Sensor::Term& term : one.terms) values.push_back(values_[term.sensor]);
      return one.quantity == Sensor::Quantity::function ? system_.model.functions[one.function].formula(values)
                                                        : calculated(one.calculation, one.terms, values);
    }
    case Sensor::Quantity::place: {
      const auto of = [&](model::Index node) { return vec(state.x[at(system_.node_of[node])]); };
      return along(one, one.node[1] == model::none ? of(one.node[0]) : of(one.node[0]) - of(one.node[1]), state);
    }
    case Sensor::Quantity::displacement: {
      const system::RigidBody& body = system_.bodies[system_.body_of[one.body]];
      return along(one, vec(state.x[at(body.node)]) - body.center0, state);
    }
    case Sensor::Quantity::velocity: return along(one, velocity_of(one, state, false), state);
    case Sensor::Quantity::turning: return along(one, velocity_of(one, state, true), state);
    case Sensor::Quantity::acceleration: return along(one, acceleration_of(i, state, false), state);
    case Sensor::Quantity::turning_rate: return along(one, acceleration_of(i, state, true), state);
    case Sensor::Quantity::force:
    case Sensor::Quantity::moment: return along(one, load_of(one, components), state);
    case Sensor::Quantity::element: return of_element(one, state);
    case Sensor::Quantity::belt: return of_belts(one, components.belts);
    case Sensor::Quantity::work_of_motion: {
      double work = 0.0;
      for (const Supports::Reaction& r : components.supports.motion_reactions())
        if (std::ranges::binary_search(one.sources, r.source)) work += r.energy;
      return work;
    }
    case Sensor::Quantity::joint_stiffness: {
      const JointSprings::Reading& reading = components.joints.springs().reading(at(one.sources.front()), one.axis);
      const double unit =
          system_.model.joint_stiffnesses[one.sources.front()].rotational ? 180.0 / std::numbers::pi : 1.0;
      return unit * (one.rate ? reading.rate : reading.place);
    }
  }
  return 0.0;
}

void Sensors::look_at(std::size_t i, const system::State& state) {
  const model::SensorSwitch& one = system_.model.sensor_switches[i];
  Switch& here = switches_[i];
  bool now = false;
  if (one.kind == model::SensorSwitch::Kind::logic) {
    now = on(one.terms.front().of);
    for (std::size_t t = 1; t < one.terms.size(); ++t)
      now = one.terms[t].any ? now || on(one.terms[t].of) : now && on(one.terms[t].of);
  } else {
    const double value = one.kind == model::SensorSwitch::Kind::time ? state.time : values_[one.sensor];
    const bool above = one.above || one.kind == model::SensorSwitch::Kind::time;
    const bool holds = above ? value > one.value : value < one.value;
    here.since = !holds ? -1.0 : here.since < 0.0 ? state.time : here.since;
    now = holds && state.time - here.since >= one.window;
  }
  if (now != here.now) here.turns_later.push_back(state.time);
  here.now = now;
  while (!here.turns_later.empty() && state.time - here.turns_later.front() >= one.delay) {
    here.on = !here.on;
    here.turns_later.erase(here.turns_later.begin());
  }
}

/// One change a cycle: the next switch is looked at from the cycle after on.
void Sensors::turn(std::size_t i, system::State& state) {
  const model::SensorControl& control = system_.model.sensor_controls[i];
  if (next_[i] >= control.switches.size() || !on(control.switches[next_[i]])) return;
  system::State::Controlled& now = state.controls[i];
  now.on = !now.on;
  now.since = state.time;
  events_.push_back(fmt::format("time {:.6g}: *SENSOR_CONTROL {} turns {} {}, by switch {}", state.time, control.id,
                                control.what, now.on ? "on" : "off",
                                system_.model.sensor_switches[control.switches[next_[i]]].id));
  ++next_[i];
  if (control.repeats && next_[i] == control.switches.size()) next_[i] = 0;
}

void Sensors::update(system::State& state, const Components& components) {
  for (const model::Index i : asked_sensors_) {
    const Sensor& one = system_.model.sensors[i];
    const double measured = measure(at(i), state, components);
    const double scaled = one.scale * measured;
    values_[i] = one.power == 1.0 ? scaled : std::pow(scaled, one.power);
  }
  for (const model::Index i : asked_switches_) look_at(at(i), state);
  for (std::size_t i = 0; i < next_.size(); ++i) turn(i, state);
}

void Sensors::archive(Archive& a) {
  a(values_, motions_, switches_, next_, events_);
  a.built(system_, asked_sensors_, asked_switches_);
}

}  // namespace nugget::impact
