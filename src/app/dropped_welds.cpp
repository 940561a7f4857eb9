// SPDX-License-Identifier: Apache-2.0
#include "app/dropped_welds.hpp"

#include <fmt/format.h>

#include <charconv>

namespace nugget::app {
namespace {

constexpr const char* option = "--drop-weld";

void drop_weld(PreparedDeck& p, std::size_t w, Findings& findings) {
  const weld::Weld& weld = p.ties.welds[w];
  if (!has_weld_elements(weld))
    return findings.error(weld.place, option,
                          fmt::format("weld {} is a rigid constraint, a discrete beam or was deleted: it has no weld "
                                      "element to be taken out",
                                      weld.id),
                          "take its keyword out of the deck");
  for (const model::Index element : weld.elements)
    p.model.element_deaths.push_back({weld.element_kind(), element, 0.0});
  p.welds[w].remarks.push_back(fmt::format("not there from the start ({})", option));
}

}  // namespace

bool has_weld_elements(const weld::Weld& weld) {
  return weld.kind != weld::Weld::Kind::rigid && weld.kind != weld::Weld::Kind::connector && !weld.deleted;
}

std::optional<std::vector<int>> read_weld_ids(const std::string& text, std::string& error_text) {
  std::vector<int> ids;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    int id = 0;
    const auto [stop, error] = std::from_chars(text.data() + begin, text.data() + end, id);
    if (error != std::errc{} || stop != text.data() + end) {
      error_text = fmt::format("'{}' is no weld, expected its id, ids separated by commas, or 'all'",
                               text.substr(begin, end - begin));
      return {};
    }
    ids.push_back(id);
    begin = end + 1;
  }
  return ids;
}

void drop_welds(PreparedDeck& p, const std::string& text, Findings& findings) {
  std::string error_text;
  const auto ids = read_weld_ids(text, error_text);
  if (!ids) return findings.error({p.model.deck, 0, 0}, option, error_text, "write e.g. --drop-weld 7,12");
  for (const int id : *ids) {
    bool found = false;
    for (std::size_t w = 0; w < p.ties.welds.size(); ++w)
      if (p.ties.welds[w].id == id) {
        found = true;
        drop_weld(p, w, findings);
      }
    if (!found)
      findings.error({p.model.deck, 0, 0}, option, fmt::format("there is no weld {}", id),
                     "welds.csv of `nugget check` lists them");
  }
}

}  // namespace nugget::app
