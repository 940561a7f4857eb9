// SPDX-License-Identifier: Apache-2.0
#include "output/nodout.hpp"

namespace nugget::output {
namespace {

void vector(AsciiFile& file, const Vec3d& v) {
  file.print("{:12.4E}{:12.4E}{:12.4E}", column(v.x), column(v.y), column(v.z));
}

/// The node's number and the first vector, whose first component has one column more.
void node_and_vector(AsciiFile& file, int node, const Vec3d& v) {
  file.print("{:9} ", node);
  vector(file, v);
}

}  // namespace

Nodout::Nodout(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Nodout::table_head(const NodoutState& state) {
  file_.print(
      "\n\n\n n o d a l   p r i n t   o u t   f o r   t i m e  s t e p{:8}                              ( at "
      "time{:14.7E} )\n",
      state.cycle, column(state.time));
}

void Nodout::write(const NodoutState& state) {
  table_head(state);
  file_.print(
      "\n nodal point  x-disp     y-disp      z-disp      x-vel       y-vel       z-vel      x-accl      y-accl      "
      "z-accl      x-coor      y-coor      z-coor\n");
  for (const NodoutRow& row : state.rows) {
    node_and_vector(file_, row.node, row.displacement);
    vector(file_, row.velocity);
    vector(file_, row.acceleration);
    vector(file_, row.coordinate);
    file_.print("\n");
  }
  if (state.rotations) {
    table_head(state);
    file_.print(
        "\n nodal point  x-rot      y-rot       z-rot       x-rot vel   y-rot vel   z-rot vel   x-rot acc   y-rot acc  "
        " "
        "z-rot acc\n");
    for (const NodoutRow& row : state.rows) {
      node_and_vector(file_, row.node, row.rotation);
      vector(file_, row.rotational_velocity);
      vector(file_, row.rotational_acceleration);
      file_.print("\n");
    }
  }
  file_.end_state();
}

}  // namespace nugget::output
