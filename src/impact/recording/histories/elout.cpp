// SPDX-License-Identifier: Apache-2.0
#include "output/elout.hpp"

#include "impact/recording/element_histories.hpp"
#include "impact/recording/histories.hpp"
#include "impact/recording/history_by_rows.hpp"

namespace nugget::impact {
namespace {

Legend headings(const char* branch, const std::vector<model::NamedEntity>& entities, const std::vector<int>& ids) {
  Legend legend{branch, {}};
  for (const model::NamedEntity& e : entities)
    if (!e.heading.empty()) legend.entries.push_back({ids[e.index], e.heading});
  return legend;
}

}  // namespace

template <>
HistoryFile history<"elout">() {
  HistoryFile file =
      make_history(output::elout(), elout_state,
                   {.concerns =
                        [](const system::System& system) {
                          const model::Requests& ask = system.model.requests;
                          return !ask.history_shells.empty() || !ask.history_solids.empty() ||
                                 !ask.history_beams.empty() || !ask.history_thick_shells.empty();
                        },
                    .legends =
                        [](const model::Model& model) {
                          return std::vector<Legend>{
                              headings("elout/solid", model.requests.history_solids, model.solids.id),
                              headings("elout/beam", model.requests.history_beams, model.beams.id),
                              headings("elout/shell", model.requests.history_shells, model.shells.id),
                              headings("elout/thickshell", model.requests.history_thick_shells, model.solids.id)};
                        }});
  file.open = HistoryByRows<EloutRows>::open;
  return file;
}

}  // namespace nugget::impact
