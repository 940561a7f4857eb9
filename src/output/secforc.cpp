// SPDX-License-Identifier: Apache-2.0
#include "output/secforc.hpp"

namespace nugget::output {
namespace {

constexpr const char* column_heads =
    "\n\n"
    " line#1  section#     time        x-force     y-force     z-force    magnitude\n"
    " line#2  resultant  moments       x-moment    y-moment    z-moment   magnitude\n"
    " line#3  centroids                x           y           z            area  \n";

/// The 27 columns in front of the moments.
std::string axes_of(const SecforcRow& row) {
  switch (row.axes) {
    case SectionAxes::rigid_body: return fmt::format("rb ID ={:8}            ", row.axes_id);
    case SectionAxes::accelerometer: return fmt::format("ac ID ={:8}            ", row.axes_id);
    case SectionAxes::system: return fmt::format("cs ID ={:8}            ", row.axes_id);
    default: return "global system              ";
  }
}

void four(AsciiFile& file, const Vec3d& v, double last) {
  file.print("{:15.4E}{:12.4E}{:12.4E}{:12.4E}\n", column(v.x), column(v.y), column(v.z), column(last));
}

template <SectionAxes axes>
int id_of_axes(const SecforcRow& r) {
  return r.axes == axes ? r.axes_id : 0;
}

void print(AsciiFile& file, const SecforcState& state) {
  for (const SecforcRow& row : state.rows) {
    file.print("{:12}{:15.5E}", row.id, column(state.time));
    four(file, row.force, norm(row.force));
    file.print("{}", axes_of(row));
    four(file, row.moment, norm(row.moment));
    file.print("{:27}", "");
    four(file, row.centroid, row.area);
    file.print("\n");
  }
}

}  // namespace

const HistoryFormat<SecforcState>& secforc() {
  static const HistoryFormat<SecforcState> format{
      .branches = {{
          .path = "secforc",
          .ids = ids(&SecforcState::rows, &SecforcRow::id),
          .once = columns(&SecforcState::rows,
                          {
                              {"rigidbody", id_of_axes<SectionAxes::rigid_body>, dimension::number,
                               "rigid body in whose axes it is, or 0"},
                              {"accelerometer", id_of_axes<SectionAxes::accelerometer>, dimension::number,
                               "accelerometer, likewise"},
                              {"coordinate_system", id_of_axes<SectionAxes::system>, dimension::number,
                               "coordinate system, likewise"},
                          }),
          .columns = columns(
              &SecforcState::rows,
              {
                  {"time", &SecforcState::time, dimension::time, "time"},
                  {"*_force", &SecforcRow::force, dimension::force, "force through a section"},
                  {"total_force", [](const SecforcRow& r) { return norm(r.force); }, dimension::force,
                   "size of the force"},
                  {"*_moment", &SecforcRow::moment, dimension::moment, "moment about the centroid"},
                  {"total_moment", [](const SecforcRow& r) { return norm(r.moment); }, dimension::moment,
                   "size of the moment"},
                  {"*_centroid", &SecforcRow::centroid, dimension::length, "centroid of the section in global axes"},
                  {"area", &SecforcRow::area, dimension::area, "area of the section"},
              }),
      }},
      .legend = LegendLines::titles,
      .heading = column_heads,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
