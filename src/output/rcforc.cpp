// SPDX-License-Identifier: Apache-2.0
#include "output/rcforc.hpp"

namespace nugget::output {
namespace {

void print(AsciiFile& file, const RcforcState& state) {
  for (const RcforcRow& row : state.rows)
    file.print("  {}{:11} time{:12.5E}  x {:12.5E}  y {:12.5E}  z {:12.5E} mass {:12.5E}\n",
               row.side == ContactSide::reference ? "master" : "slave ", row.contact, column(state.time),
               column(row.force.x), column(row.force.y), column(row.force.z), column(row.mass));
}

}  // namespace

const HistoryFormat<RcforcState>& rcforc() {
  static const HistoryFormat<RcforcState> format{
      .branches = {{
          .path = "rcforc",
          .ids = ids(&RcforcState::rows, &RcforcRow::contact),
          .once = columns(&RcforcState::rows,
                          {{"side", &RcforcRow::side, dimension::number, "0 tracked (slave), 1 reference (master)"}}),
          .columns =
              columns(&RcforcState::rows,
                      {
                          {"time", &RcforcState::time, dimension::time, "time"},
                          {"*_force", &RcforcRow::force, dimension::force, "resultant force on one side of a contact"},
                          {"mass", &RcforcRow::mass, dimension::mass, "of the nodes on this side; always 0"},
                      }),
      }},
      .legend = LegendLines::titles,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
