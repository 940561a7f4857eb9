// SPDX-License-Identifier: Apache-2.0
#include "output/rwforc.hpp"

namespace nugget::output {
namespace {

constexpr const char* columns = "\n\n    time       wall#   normal-force    x-force        y-force        z-force\n";

}  // namespace

Rwforc::Rwforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend) + columns) {}

void Rwforc::write(const RwforcState& state) {
  for (const RwforcRow& row : state.rows)
    file_.print("{:12.5E}{:8}{:15.6E}{:15.6E}{:15.6E}{:15.6E}\n", column(state.time), row.wall, column(row.normal),
                column(row.force.x), column(row.force.y), column(row.force.z));
  file_.end_state();
}

}  // namespace nugget::output
