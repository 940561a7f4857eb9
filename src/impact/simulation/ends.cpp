// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/index.hpp"

namespace nugget::impact {

namespace {

using model::Sensor;

double component(const Vec3d& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : axis == 2 ? v.z : norm(v);
}

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

}  // namespace

double Ends::value(std::size_t sensor, const system::State& state) const {
  const Sensor& one = system_.model.run_ends.sensors[sensor];
  switch (one.quantity) {
    case Sensor::Quantity::time: return state.time;
    case Sensor::Quantity::curve: return system_.model.curves[one.curve].clamped(state.time);
    case Sensor::Quantity::calculation: {
      std::vector<double> values;
      for (const Sensor::Term& term : one.terms) values.push_back(value(at(term.sensor), state));
      return calculated(one.calculation, one.terms, values);
    }
    default: break;
  }
  const auto& rows = one.quantity == Sensor::Quantity::place ? state.x : state.v;
  const auto of = [&](model::Index node) { return vec(rows[at(system_.node_of[at(node)])]); };
  Vec3d found = of(one.node[0]);
  if (one.node[1] != model::none) found -= of(one.node[1]);
  return norm(one.direction) > 0.0 ? dot(found, one.direction) : norm(found);
}

bool Ends::holds(const model::SensorSwitch& one, const system::State& state) const {
  if (one.kind == model::SensorSwitch::Kind::time) return state.time > one.value;
  const double now = value(at(one.sensor), state);
  return one.above ? now > one.value : now < one.value;
}

bool Ends::on(std::size_t number, const system::State& state) const {
  const model::SensorSwitch& one = system_.model.run_ends.switches[number];
  if (one.kind != model::SensorSwitch::Kind::logic)
    return since_[number] >= 0.0 && state.time - since_[number] >= one.window;
  bool found = on(at(one.terms.front().of), state);
  for (std::size_t i = 1; i < one.terms.size(); ++i) {
    const bool next = on(at(one.terms[i].of), state);
    found = one.terms[i].any ? found || next : found && next;
  }
  return found;
}

std::string Ends::update(const system::State& state) {
  const model::RunEnds& given = system_.model.run_ends;
  if (given.ends.empty()) return {};
  for (std::size_t i = 0; i < given.switches.size(); ++i) {
    const model::SensorSwitch& one = given.switches[i];
    if (one.kind == model::SensorSwitch::Kind::logic) continue;
    if (!holds(one, state))
      since_[i] = -1.0;
    else if (since_[i] < 0.0)
      since_[i] = state.time;
  }
  static constexpr std::array<std::string_view, 4> axes{"x", "y", "z", "whole"};
  for (const model::RunEnd& end : given.ends) {
    if (end.kind == model::RunEnd::Kind::sensor) {
      if (on(at(end.of_switch), state))
        return fmt::format("sensor switch {} is on", given.switches[at(end.of_switch)].id);
      continue;
    }
    const bool of_node = end.kind == model::RunEnd::Kind::node;
    double now = 0.0;
    if (of_node) {
      now = component(vec(state.x[at(system_.node_of[at(end.node)])]), end.axis);
    } else {
      const auto body = std::find_if(system_.bodies.begin(), system_.bodies.end(),
                                     [&](const system::RigidBody& b) { return b.source == end.body; });
      if (body == system_.bodies.end()) continue;
      now = component(vec(state.x[at(body->node)]) - body->center0, end.axis);
    }
    if (now <= end.most && now >= end.least) continue;
    const std::string what =
        of_node ? fmt::format("node {} has the {} coordinate", system_.model.nodes.id[at(end.node)], axes[at(end.axis)])
                : fmt::format("rigid body {} has the {} displacement", system_.model.rigid_bodies[at(end.body)].id,
                              axes[at(end.axis)]);
    return fmt::format("{} {:.6g}, beyond {:.6g}", what, now, now > end.most ? end.most : end.least);
  }
  return {};
}

void Ends::archive(Archive& a) {
  a(since_);
  a.built(system_);
}

}  // namespace nugget::impact
