// SPDX-License-Identifier: Apache-2.0
#include "nvh/statics/static_loads.hpp"

namespace nugget::nvh {

double StaticLoads::level(model::Index curve, double time) const {
  const Curve& c = m_.system.model.curves[curve];
  return c.in_run ? c.zero_outside(time) : 0.0;
}

void StaticLoads::add(const model::NodalLoad& load) {
  const std::array<model::Index, 3>& f = load.follower_nodes;
  const Vec3d direction =
      f[0] == model::none ? load.direction : unit(cross(place(f[1]) - place(f[0]), place(f[2]) - place(f[0])));
  const Vec3d force = load.scale * level(load.curve, time_) * direction;
  for (const model::Index n : load.nodes) add_to(load_[node(n)], load.moment, force);
  if (load.rigid_body == model::none) return;
  const system::RigidBody& body = m_.system.bodies[m_.system.body_of[load.rigid_body]];
  add_to(load_[body.node], load.moment, force);
}

void StaticLoads::add(const model::PressureLoad& load) {
  const double time = time_ - load.arrival;
  const double p = time >= 0.0 ? load.scale * level(load.curve, time) : 0.0;
  for (std::size_t i = 0; i < load.segments.size(); ++i) {
    const model::Segment& s = load.segments[i];
    const Vec3d force = p * force_of_pressure(m_, s);
    for (std::size_t a = 0; a < 4; ++a) add_to(load_[node(s[a])], false, load.share[i][a] * force);
  }
}

void StaticLoads::add(const model::BodyLoad& load) {
  const double a = -load.scale * level(load.curve, time_);
  for (std::size_t k = 0; k < load_.size(); ++k) add_to(load_[k], false, a * m_.nodal_mass[k].mass * load.direction);
}

Nodal static_loads(const Matrices& matrices, double time) {
  StaticLoads loads(matrices, time);
  model::for_each_load(matrices.system.model, [&]<class Load>(const Load& load) {
    if constexpr (KnownInStatics<Load>) loads.add(load);
  });
  Nodal all = loads.nodal();
  const Nodal internal = forces_at_start(matrices);
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < 6; ++i) all[k][i] -= internal[k][i];
  return all;
}

}  // namespace nugget::nvh
