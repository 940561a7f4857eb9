// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/accelerometers.hpp"

#include "model/axes.hpp"

namespace nugget::impact {

Frame3d accelerometer_axes(const system::System& system, const system::State& state, const model::Accelerometer& a) {
  const auto place = [&](std::size_t i) { return vec(state.x[system.node_of[a.node[i]]]); };
  Frame3d axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  model::frame_from(place(1) - place(0), place(2) - place(0), axes);
  return axes;
}

void Accelerometers::start(const system::State& state) {
  sums_.clear();
  for (const model::Accelerometer& a : system_.model.accelerometers) {
    const Vec3d v = vec(state.v[system_.node_of[a.node[0]]]);
    sums_.push_back({accelerometer_axes(system_, state, a).local(v), v});
  }
}

void Accelerometers::add_step(const system::State& state) {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    const model::Accelerometer& a = system_.model.accelerometers[i];
    if (!a.sums_local) continue;
    const Vec3d v = vec(state.v[system_.node_of[a.node[0]]]);
    sums_[i].velocity += accelerometer_axes(system_, state, a).local(v - sums_[i].last);
    sums_[i].last = v;
  }
}

void Accelerometers::archive(Archive& a) {
  a(sums_);
  a.built(system_);
}

}  // namespace nugget::impact
