// SPDX-License-Identifier: Apache-2.0
#include "impact/conditions/blast_load.hpp"

#include "base/index.hpp"

namespace nugget::impact {

ActingLoad<model::BlastLoad>::ActingLoad(const model::BlastLoad& load, const system::System& system)
    : load_(load), system_(system), faces_(load.segments, load.share, system) {
  for (const model::Segment& segment : load.segments)
    waves_.push_back(kernel::blast_wave(load.burst, load.mass * load.units.mass,
                                        model::distance_to(load, segment, system.ties.x) * load.units.length));
}

void ActingLoad<model::BlastLoad>::apply(system::State& state, double dt, double& work) {
  const bool acts = state.time <= load_.death && !state.relaxing;
  const double since = (state.time - load_.time) * load_.units.time, scale = load_.scale / load_.units.pressure;
  for (std::size_t s = 0; s < waves_.size(); ++s) {
    double pressure = 0.0;
    if (acts && since >= waves_[s].arrival) {
      const auto [middle, area] = faces_.middle_and_area(s, state);
      const Vec3d way = load_.centre - middle;
      const double size = norm(area) * norm(way);
      if (size > 0.0) pressure = scale * waves_[s].pressure(since, dot(area, way) / size, load_.negative_phase);
    }
    faces_.press(s, pressure, state, dt, work);
  }
}

void ActingLoad<model::BlastLoad>::archive(Archive& a) {
  a(faces_);
  a.built(load_, system_, waves_);
}

}  // namespace nugget::impact
