// SPDX-License-Identifier: Apache-2.0
#include "output/rcforc.hpp"

namespace nugget::output {

Rcforc::Rcforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Rcforc::write(const RcforcState& state) {
  for (const RcforcRow& row : state.rows)
    file_.print("  {}{:11} time{:12.5E}  x {:12.5E}  y {:12.5E}  z {:12.5E} mass {:12.5E}\n",
                row.side == ContactSide::reference ? "master" : "slave ", row.contact, column(state.time),
                column(row.force.x), column(row.force.y), column(row.force.z), column(row.mass));
  file_.end_state();
}

}  // namespace nugget::output
