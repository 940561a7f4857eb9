// SPDX-License-Identifier: Apache-2.0
#include "output/ncforc.hpp"

#include <algorithm>
#include <memory>
#include <set>

#include "impact/recording/contact_sides.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

/// In the ASCII file a contact has one line, and none without a title.
std::vector<output::LegendEntry> lines_of_contacts(const std::vector<output::LegendEntry>& legend) {
  std::vector<output::LegendEntry> lines;
  std::set<int> seen;
  for (const output::LegendEntry& entry : legend)
    if (!entry.heading.empty() && seen.insert(entry.id).second) lines.push_back(entry);
  return lines;
}

/// Sides and nodes follow from the deck, so that there is a table of columns for each model.
OpenHistory open_ncforc(model::HistoryName name, const system::System& system, const HistoryTarget& to) {
  const auto sides = std::make_shared<ContactSides>(system);
  const auto format =
      std::make_shared<const output::HistoryFormat<output::NcforcState>>(output::ncforc(sides->sides()));
  std::shared_ptr<output::AsciiHistory<output::NcforcState>> ascii;
  if (to.ascii)
    ascii = std::make_shared<output::AsciiHistory<output::NcforcState>>(*format, to.directory / name.text(), to.header,
                                                                        lines_of_contacts(to.legend));
  const auto write = [sides, format, ascii, binout = to.binout](const Snapshot& now) {
    const output::NcforcState state = sides->state(now);
    if (ascii) ascii->write(state);
    if (binout) binout->write(*format, state);
  };
  const auto archive = [ascii](Archive& a) {
    if (ascii) a(*ascii);
  };
  return {write, archive};
}

bool asks_for_nodes(const model::Contact& card) {
  return (card.prints_a || card.prints_b) &&
         (card.slides() || (card.kind == model::Contact::Kind::transducer && card.b.empty()));
}

/// Of each branch the title of its contact alone: a reader of LSTC's looks for nothing else.
std::vector<Legend> legends_of_sides(const model::Model& model) {
  std::vector<Legend> legends;
  for (const model::Contact& card : model.contacts)
    if (asks_for_nodes(card))
      for (const auto side : {output::ContactSide::tracked, output::ContactSide::reference})
        legends.push_back({output::branch_of({card.id, side, {}}), {{card.id, card.title}}});
  return legends;
}

std::vector<output::ColumnMeaning> columns_of_sides() {
  std::vector<output::ColumnMeaning> columns = output::meanings(output::ncforc({{}}));
  for (output::ColumnMeaning& column : columns) column.branch = "ncforc/slave_ID, master_ID";
  return columns;
}

}  // namespace

template <>
HistoryFile history<"ncforc">() {
  return {columns_of_sides(),
          {.concerns =
               [](const system::System& system) { return std::ranges::any_of(system.model.contacts, asks_for_nodes); },
           .legends = legends_of_sides},
          open_ncforc};
}

}  // namespace nugget::impact
