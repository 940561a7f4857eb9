// SPDX-License-Identifier: Apache-2.0
#include "output/abstat.hpp"

namespace nugget::output {

Abstat::Abstat(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Abstat::write(const AbstatState& state) {
  file_.print(
      "\n\n      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  "
      "total mass gas temp. surface area   reaction\n");
  for (const AbstatRow& r : state.rows)
    file_.print("{:12.5E}{:8}{:15.4E}{:15.4E}{:15.4E}{:15.4E}{:15.4E}{:11.3E}{:11.3E}{:11.3E}{:11.3E}{:11.3E}\n",
                column(state.time), r.id, column(r.volume), column(r.pressure), column(r.internal_energy),
                column(r.inflow), column(r.density), column(r.outflow), column(r.total_mass), column(r.temperature),
                column(r.surface_area), 0.0);
  file_.end_state();
}

}  // namespace nugget::output
