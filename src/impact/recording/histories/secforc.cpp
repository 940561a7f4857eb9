// SPDX-License-Identifier: Apache-2.0
#include "output/secforc.hpp"

#include <memory>

#include "impact/recording/cross_sections.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

Recording<output::SecforcState> begin(const system::System& system) {
  const auto sections = std::make_shared<CrossSections>(system);
  return [sections](const Snapshot& now) { return sections->state(now); };
}

}  // namespace

template <>
HistoryFile history<"secforc">() {
  return make_history<output::SecforcState>(
      output::secforc(), begin,
      {.concerns = [](const system::System& system) { return !system.model.requests.cross_sections.empty(); },
       .legends =
           [](const model::Model& model) {
             std::vector<output::LegendEntry> titles;
             for (const auto& c : model.requests.cross_sections)
               if (!c.title.empty()) titles.push_back({c.id, c.title});
             return std::vector<Legend>{{"secforc", titles}};
           }});
}

}  // namespace nugget::impact
