// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

template <std::size_t... place>
std::vector<HistoryFile> all(std::index_sequence<place...>) {
  std::vector<HistoryFile> histories{history<model::HistoryName(place)>()...};
  for (std::size_t i = 0; i < histories.size(); ++i) histories[i].name = model::HistoryName(i);
  return histories;
}

}  // namespace

std::vector<HistoryFile> histories() {
  return all(std::make_index_sequence<model::history_files.size()>());
}

std::vector<output::LegendEntry> titles_of_contacts(const model::Model& model) {
  std::vector<output::LegendEntry> titles;
  for (const model::Contact& c : model.contacts)
    if (!c.title.empty()) titles.push_back({c.id, c.title});
  for (const model::InteriorContact& c : model.interiors)
    if (!c.title.empty()) titles.push_back({c.id, c.title});
  return titles;
}

}  // namespace nugget::impact
