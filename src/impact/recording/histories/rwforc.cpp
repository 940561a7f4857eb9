// SPDX-License-Identifier: Apache-2.0
#include "output/rwforc.hpp"

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::RwforcState rwforc_state(const Snapshot& now) {
  const Walls& walls = now.components.walls;
  const model::Model& model = now.system.model;
  output::RwforcState s;
  s.time = now.state.time;
  s.cycle = static_cast<int>(now.state.cycle) + 1;  // LS-DYNA counts from 1
  for (std::size_t w = 0; w < walls.all().size(); ++w) {
    s.rows.push_back({model.walls[w].id, walls.all()[w].normal_force(), walls.all()[w].force()});
    if (model.walls[w].areas.empty()) continue;
    output::WallAreas& areas = s.areas.emplace_back();
    areas.wall = w;
    for (std::size_t a = 0; a < model.walls[w].areas.size(); ++a) areas.forces.push_back(walls.all()[w].force_apart(a));
  }
  for (std::size_t t = 0; t < model.wall_transducers.size(); ++t) {
    const model::WallTransducer& card = model.wall_transducers[t];
    s.transducers.push_back({card.id, card.set, model.walls[card.wall].id, walls.force_of_transducer(t)});
  }
  return s;
}

output::HistoryFormat<output::RwforcState> rwforc_format(const system::System& system) {
  std::vector<std::size_t> with_areas;
  for (std::size_t w = 0; w < system.model.walls.size(); ++w)
    if (!system.model.walls[w].areas.empty()) with_areas.push_back(w);
  return output::rwforc_with_areas(with_areas);
}

}  // namespace

template <>
HistoryFile history<"rwforc">() {
  HistoryFile file =
      make_history(output::rwforc(), rwforc_state,
                   {.concerns = [](const system::System& system) { return !system.model.walls.empty(); },
                    .legends =
                        [](const model::Model& model) {
                          std::vector<output::LegendEntry> walls, transducers;
                          for (const auto& w : model.walls)
                            if (!w.title.empty()) walls.push_back({w.id, w.title});
                          for (const auto& t : model.wall_transducers)
                            if (!t.title.empty()) transducers.push_back({t.id, t.title});
                          return std::vector<Legend>{{"rwforc/forces", walls}, {"rwforc/transducer", transducers}};
                        }});
  // A branch for each wall with areas, which only the model knows.
  file.open = [](model::HistoryName name, const system::System& system, const HistoryTarget& to) {
    const auto format = std::make_shared<output::HistoryFormat<output::RwforcState>>(rwforc_format(system));
    return open_history<output::RwforcState>(format, rwforc_state, name, to);
  };
  return file;
}

}  // namespace nugget::impact
