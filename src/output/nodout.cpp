// SPDX-License-Identifier: Apache-2.0
#include "output/nodout.hpp"

namespace nugget::output {
namespace {

/// The node's number and the first vector, whose first component has one column more.
void node_and_vector(AsciiFile& file, int node, const Vec3d& v) {
  file.print("{:9} ", node);
  file.print_vector(v);
}

void table_head(AsciiFile& file, const NodoutState& state) {
  file.print(
      "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p{:8}                              ( at "
      "time{:14.7E} )\n",
      state.cycle, column(state.time));
}

void print(AsciiFile& file, const NodoutState& state) {
  for (const NodoutTable table : {NodoutTable::translations, NodoutTable::rotations}) {
    if (table == NodoutTable::rotations && !state.rotations) continue;
    print_head(file, table, state);
    print_rows(file, table, state);
  }
}

}  // namespace

void print_head(AsciiFile& file, NodoutTable table, const NodoutState& state) {
  table_head(file, state);
  if (table == NodoutTable::translations)
    file.print(
        "\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl      "
        "z-accl      x-coor      y-coor      z-coor\n");
  else
    file.print(
        "\n nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel   x-rot acc   y-rot acc  "
        " "
        "z-rot acc\n");
}

void print_rows(AsciiFile& file, NodoutTable table, const NodoutState& rows) {
  for (const NodoutRow& row : rows.rows) {
    if (table == NodoutTable::translations) {
      node_and_vector(file, row.node, row.displacement);
      file.print_vector(row.velocity);
      file.print_vector(row.acceleration);
      file.print_vector(row.coordinate);
    } else {
      node_and_vector(file, row.node, row.rotation);
      file.print_vector(row.rotational_velocity);
      file.print_vector(row.rotational_acceleration);
    }
    file.print("\n");
  }
}

const HistoryFormat<NodoutState>& nodout() {
  static const HistoryFormat<NodoutState> format{
      .branches = {{
          .path = "nodout",
          .ids = ids(&NodoutState::rows, &NodoutRow::node),
          .columns =
              columns(&NodoutState::rows,
                      {
                          {"time", &NodoutState::time, dimension::time, "time"},
                          {"cycle", &NodoutState::cycle, dimension::number, "number of the cycle, from 1"},
                          {"*_displacement", &NodoutRow::displacement, dimension::length, "displacement of a node"},
                          {"*_velocity", &NodoutRow::velocity, dimension::velocity, "velocity"},
                          {"*_acceleration", &NodoutRow::acceleration, dimension::acceleration, "acceleration"},
                          {"*_coordinate", &NodoutRow::coordinate, dimension::length, "coordinate now"},
                      }) +
              columns(&NodoutState::rows,
                      {
                          {"r*_displacement", &NodoutRow::rotation, dimension::angle, "rotation"},
                          {"r*_velocity", &NodoutRow::rotational_velocity, dimension::rate, "rotational velocity"},
                          {"r*_acceleration", &NodoutRow::rotational_acceleration, dimension::angular_acceleration,
                           "rotational acceleration"},
                      })
                  .where([](const NodoutState& s) { return s.rotations; }),
      }},
      .legend = LegendLines::titles,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
