// SPDX-License-Identifier: Apache-2.0
#include "output/deforc.hpp"

namespace nugget::output {
namespace {

void print(AsciiFile& file, const DeforcState& state) {
  const auto quantity = [&](const char* name, double value) { file.print(" {:.<29}{:14.5E}\n", name, column(value)); };
  file.print("\n {:.<29}{:14.5E}\n", "time", column(state.time));
  for (const DeforcRow& r : state.rows) {
    file.print(" {:.<29}{:10}\n", "spring/damper number", r.spring);
    quantity(r.torsional ? "x-moment" : "x-force", r.force.x);
    quantity(r.torsional ? "y-moment" : "y-force", r.force.y);
    quantity(r.torsional ? "z-moment" : "z-force", r.force.z);
    quantity(r.torsional ? "resultant moment" : "resultant force", r.resultant);
    quantity(r.torsional ? "relative rotation" : "change in length", r.displacement);
  }
}

}  // namespace

const HistoryFormat<DeforcState>& deforc() {
  static const HistoryFormat<DeforcState> format{
      .branches = {{
          .path = "deforc",
          .ids = ids(&DeforcState::rows, &DeforcRow::spring),
          .once = columns(&DeforcState::rows, {{"irot", &DeforcRow::torsional, dimension::number,
                                                "1: torsional, with moments for forces"}}),
          .columns = columns(
              &DeforcState::rows,
              {
                  {"time", &DeforcState::time, dimension::time, "time"},
                  {"*_force", &DeforcRow::force, dimension::force, "force of a spring or damper on its first node"},
                  {"resultant_force", &DeforcRow::resultant, dimension::force,
                   "the same along its line, positive in tension"},
                  {"displacement", &DeforcRow::displacement, dimension::length, "change in length"},
              }),
      }},
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
