// SPDX-License-Identifier: Apache-2.0
#include "output/ncforc.hpp"

#include <array>
#include <string_view>

namespace nugget::output {
namespace {

/// Lines as LSTC's translator `l2a` writes them.
void print_sides(AsciiFile& file, const NcforcState& state) {
  for (const NcforcSide& side : state.sides) {
    file.print("\n\n\n forces (t={:11.5E}) for interface{:10} {} side\n\n", column(state.time), side.contact,
               side.side == ContactSide::reference ? "master" : "slave ");
    file.print(
        "     node           x-force/      y-force/      z-force/     pressure/\n"
        "                   coordinate    coordinate    coordinate\n");
    for (const NcforcRow& row : side.rows) {
      file.print("{:10}      {:14.5E}{:14.5E}{:14.5E}{:14.5E}\n", row.node, column(row.force.x), column(row.force.y),
                 column(row.force.z), column(row.pressure));
      file.print("                {:14.5E}{:14.5E}{:14.5E}\n", column(row.x.x), column(row.x.y), column(row.x.z));
    }
  }
}

Columns<NcforcState> columns_of_side(std::size_t place) {
  constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
  const auto rows = [place](const NcforcState& state) -> const std::vector<NcforcRow>& {
    return state.sides[place].rows;
  };
  Columns<NcforcState> columns = columns_of<NcforcState, NcforcRow>(
      rows, {{"time", &NcforcState::time, dimension::time, "time"},
             {"*_force", &NcforcRow::force, dimension::force, "contact force on a node of this side"},
             {"pressure", &NcforcRow::pressure, dimension::stress,
              "its normal component, over the node's share of the surface"}});
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto coordinate = [i](const NcforcRow& row) { return component(row.x, static_cast<int>(i)); };
    for (Column<NcforcState>& column :
         columns_of<NcforcState, NcforcRow>(rows, {{axes[i], coordinate, dimension::length, "where the node stands"}}))
      columns.push_back(std::move(column));
  }
  return columns;
}

}  // namespace

std::string branch_of(const NcforcSide& side) {
  return fmt::format("ncforc/{}_{:06}", side.side == ContactSide::reference ? "master" : "slave", side.contact);
}

HistoryFormat<NcforcState> ncforc(const std::vector<NcforcSide>& sides) {
  HistoryFormat<NcforcState> format;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    Branch<NcforcState> branch;
    branch.path = branch_of(sides[i]);
    branch.ids = [i](const NcforcState& state) {
      std::vector<int> nodes;
      for (const NcforcRow& row : state.sides[i].rows) nodes.push_back(row.node);
      return nodes;
    };
    branch.columns = columns_of_side(i);
    format.branches.push_back(std::move(branch));
  }
  format.legend = LegendLines::titles;
  format.print = print_sides;
  return format;
}

}  // namespace nugget::output
