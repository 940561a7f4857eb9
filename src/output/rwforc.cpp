// SPDX-License-Identifier: Apache-2.0
#include "output/rwforc.hpp"

namespace nugget::output {

const HistoryFormat<RwforcState>& rwforc() {
  static const HistoryFormat<RwforcState> format{
      .branches = {{
          .path = "rwforc/forces",
          .ids = ids(&RwforcState::rows, &RwforcRow::wall),
          .once = columns(&RwforcState::rows, {{"setid", &RwforcRow::wall, dimension::number, "id of the wall again"}}),
          .columns =
              columns(&RwforcState::rows,
                      {
                          {"time", &RwforcState::time, dimension::time, "time"},
                          {"normal_force", &RwforcRow::normal, dimension::force, "force of a wall along its normal"},
                          {"*_force", &RwforcRow::force, dimension::force, "force of a wall on the model"},
                      }),
      }},
      .legend = LegendLines::titles,
      .heading = "\n\n    time       wall#   normal-force    x-force        y-force        z-force\n",
      .lines = {.head = "",
                .row = "{time:12.5E}{id:8}{normal_force:15.6E}{x_force:15.6E}{y_force:15.6E}{z_force:15.6E}\n",
                .tail = ""},
  };
  return format;
}

}  // namespace nugget::output
