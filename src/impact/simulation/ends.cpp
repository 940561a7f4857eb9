// SPDX-License-Identifier: Apache-2.0
#include "impact/simulation/ends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/index.hpp"

namespace nugget::impact {

namespace {

double component(const Vec3d& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : axis == 2 ? v.z : norm(v);
}

}  // namespace

std::string reason_to_end(const system::System& system, const system::State& state, const Sensors& sensors) {
  static constexpr std::array<std::string_view, 4> axes{"x", "y", "z", "whole"};
  for (const model::RunEnd& end : system.model.run_ends) {
    if (end.kind == model::RunEnd::Kind::sensor) {
      if (sensors.on(end.of_switch))
        return fmt::format("sensor switch {} is on", system.model.sensor_switches[end.of_switch].id);
      continue;
    }
    const bool of_node = end.kind == model::RunEnd::Kind::node;
    double now = 0.0;
    if (of_node) {
      now = component(vec(state.x[at(system.node_of[at(end.node)])]), end.axis);
    } else {
      const auto body = std::find_if(system.bodies.begin(), system.bodies.end(),
                                     [&](const system::RigidBody& b) { return b.source == end.body; });
      if (body == system.bodies.end()) continue;
      now = component(vec(state.x[at(body->node)]) - body->center0, end.axis);
    }
    if (now <= end.most && now >= end.least) continue;
    const std::string what =
        of_node ? fmt::format("node {} has the {} coordinate", system.model.nodes.id[at(end.node)], axes[at(end.axis)])
                : fmt::format("rigid body {} has the {} displacement", system.model.rigid_bodies[at(end.body)].id,
                              axes[at(end.axis)]);
    return fmt::format("{} {:.6g}, beyond {:.6g}", what, now, now > end.most ? end.most : end.least);
  }
  return {};
}

}  // namespace nugget::impact
