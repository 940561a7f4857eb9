// SPDX-License-Identifier: Apache-2.0
#include "output/rbdout.hpp"

#include "base/index.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::RbdoutState rbdout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::RbdoutState s;
  s.cycle = now.state.cycle + 1;
  s.time = now.state.time;
  for (std::size_t b = 0; b < now.system.bodies.size(); ++b) {
    const system::RigidBody& body = now.system.bodies[b];
    const model::RigidBody::Origin origin = model.rigid_bodies[body.source].origin;
    if (origin == model::RigidBody::Origin::weld) continue;
    const auto k = at(body.node);
    output::RbdoutRow row;
    row.id = body.id;
    row.coordinate = vec(now.state.x[k]);
    row.displacement = row.coordinate - body.center0;
    row.rotation = now.history_rotation[model.requests.history_nodes.size() + b];
    row.velocity = now.velocity(k);
    row.angular_velocity = now.spin(k);
    row.acceleration = now.acceleration(k);
    row.angular_acceleration = now.rotary_acceleration(k);
    const Frame3d& own = model.rigid_bodies[body.source].own_axes;
    row.axes = {body.axes.global(own.e1), body.axes.global(own.e2), body.axes.global(own.e3)};
    (origin == model::RigidBody::Origin::part ? s.parts : s.nodal).push_back(row);
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"rbdout">() {
  return make_history(output::rbdout(), rbdout_state,
                      {.concerns = [](const system::System& system) { return !system.bodies.empty(); }});
}

}  // namespace nugget::impact
