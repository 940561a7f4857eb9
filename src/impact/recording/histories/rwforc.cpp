// SPDX-License-Identifier: Apache-2.0
#include "output/rwforc.hpp"

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::RwforcState rwforc_state(const Snapshot& now) {
  output::RwforcState s;
  s.time = now.state.time;
  for (std::size_t w = 0; w < now.components.walls.all().size(); ++w)
    s.rows.push_back({now.system.model.walls[w].id, now.components.walls.all()[w].normal_force(),
                      now.components.walls.all()[w].force()});
  return s;
}

}  // namespace

template <>
HistoryFile history<"rwforc">() {
  return make_history(output::rwforc(), rwforc_state,
                      {.concerns = [](const system::System& system) { return !system.model.walls.empty(); },
                       .legends =
                           [](const model::Model& model) {
                             std::vector<output::LegendEntry> titles;
                             for (const auto& w : model.walls)
                               if (!w.title.empty()) titles.push_back({w.id, w.title});
                             return std::vector<Legend>{{"rwforc", titles}};
                           }});
}

}  // namespace nugget::impact
