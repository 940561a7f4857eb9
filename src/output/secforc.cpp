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

}  // namespace

Secforc::Secforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend) + column_heads) {}

void Secforc::write(const SecforcState& state) {
  for (const SecforcRow& row : state.rows) {
    file_.print("{:12}{:15.5E}", row.id, column(state.time));
    four(file_, row.force, norm(row.force));
    file_.print("{}", axes_of(row));
    four(file_, row.moment, norm(row.moment));
    file_.print("{:27}", "");
    four(file_, row.centroid, row.area);
    file_.print("\n");
  }
  file_.end_state();
}

}  // namespace nugget::output
