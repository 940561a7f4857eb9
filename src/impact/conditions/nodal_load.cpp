// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/nodal_load.hpp"

#include "base/index.hpp"

namespace nugget::impact {

ActingLoad<model::NodalLoad>::ActingLoad(const model::NodalLoad& load, const system::System& system)
    : load_(load), system_(system) {
  for (const model::Index i : load.nodes) nodes_.push_back(system.node_of[i]);
  if (load.rigid_body != model::none) nodes_.push_back(system.bodies[system.body_of[load.rigid_body]].node);
}

void ActingLoad<model::NodalLoad>::apply(system::State& state, double dt, double& work) {
  Vec3d direction = load_.direction;
  if (load_.follower_nodes[0] != model::none) {
    std::array<Vec3d, 3> x;
    for (std::size_t i = 0; i < 3; ++i) x[i] = vec(state.x[system_.node_of[load_.follower_nodes[i]]]);
    direction = unit(cross(x[1] - x[0], x[2] - x[0]));
  }
  const Curve& curve = system_.model.curves[load_.curve];
  const Vec3d force = load_.scale * load_value(curve, state.time, state) * direction;
  for (const int node : nodes_) {
    const auto k = at(node);
    const Vec3d velocity = vec(load_.moment ? state.w[k] : state.v[k]);
    work += 0.5 * dt * dot(last_ + force, velocity);
    add(load_.moment ? state.m[k] : state.f[k], force);
  }
  last_ = force;
}

void ActingLoad<model::NodalLoad>::archive(Archive& a) {
  a(last_);
  a.built(load_, system_, nodes_);
}

}  // namespace nugget::impact
