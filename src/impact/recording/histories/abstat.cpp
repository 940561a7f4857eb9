// SPDX-License-Identifier: Apache-2.0
#include "output/abstat.hpp"

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::AbstatState abstat_state(const Snapshot& now) {
  output::AbstatState s;
  s.time = now.state.time;
  int number = 0;
  for (const ActingLoad<model::ControlVolume>& acting : now.components.loads.of<model::ControlVolume>()) {
    const auto& volume = acting.gas();
    const model::ControlVolume& source = acting.source();
    output::AbstatRow row;
    row.id = source.id > 0 ? source.id : number + 1;
    ++number;
    row.volume = volume.volume;
    row.pressure = volume.pressure;
    using Gas = model::ControlVolume::Gas;
    if (source.gas == Gas::flowing) {
      const Bag& bag = volume.bag;
      row.internal_energy = bag.energy;
      row.inflow = bag.inflow;
      row.outflow = bag.outflow;
      row.density = bag.mass / bag.volume;
      row.total_mass = bag.mass;
      row.temperature = bag.temperature;
    } else if (source.gas == Gas::adiabatic) {
      const double absolute = source.pressure_scale * source.beta * source.absolute * volume.relative_pressure;
      row.internal_energy = absolute * volume.volume / (source.gamma - 1.0);
      row.total_mass = source.density * volume.at_start;
      row.density = volume.volume > 0.0 ? row.total_mass / volume.volume : 0.0;
    } else {
      row.internal_energy = -volume.work;
    }
    row.surface_area =
        model::surface_area(source.segments, [&](model::Index n) { return vec(now.state.x[now.system.node_of[n]]); });
    s.rows.push_back(row);
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"abstat">() {
  return make_history(output::abstat(), abstat_state,
                      {.concerns = [](const system::System& system) { return !system.model.control_volumes.empty(); },
                       .legends =
                           [](const model::Model& model) {
                             std::vector<output::LegendEntry> titles;
                             int number = 0;
                             for (const model::ControlVolume& v : model.control_volumes) {
                               ++number;
                               if (!v.title.empty()) titles.push_back({v.id > 0 ? v.id : number, v.title});
                             }
                             return std::vector<Legend>{{"abstat", titles}};
                           }});
}

}  // namespace nugget::impact
