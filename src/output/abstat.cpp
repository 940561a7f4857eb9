// SPDX-License-Identifier: Apache-2.0
#include "output/abstat.hpp"

namespace nugget::output {

const HistoryFormat<AbstatState>& abstat() {
  static const HistoryFormat<AbstatState> format{
      .branches = {{
          .path = "abstat",
          .ids = ids(&AbstatState::rows, &AbstatRow::id),
          .columns = columns(
              &AbstatState::rows,
              {
                  {"time", &AbstatState::time, dimension::time, "time"},
                  {"volume", &AbstatRow::volume, dimension::volume, "volume inside the faces"},
                  {"pressure", &AbstatRow::pressure, dimension::stress, "pressure on the faces"},
                  {"internal_energy", &AbstatRow::internal_energy, dimension::energy, "internal energy of the gas"},
                  {"density", &AbstatRow::density, dimension::density, "density of the gas"},
                  {"total_mass", &AbstatRow::total_mass, dimension::mass, "mass of the gas"},
                  {"surface_area", &AbstatRow::surface_area, dimension::area, "area of the faces"},
                  {"dm_dt_in", &AbstatRow::inflow, dimension::mass_flow, "mass that flows in over time"},
                  {"dm_dt_out", &AbstatRow::outflow, dimension::mass_flow, "mass that flows out over time"},
                  {"gas_temp", &AbstatRow::temperature, dimension::number, "absolute temperature of the gas"},
                  {"reaction", [](const AbstatRow&) { return 0.0; }, dimension::force, "of the format; always 0"},
              }),
      }},
      .legend = LegendLines::titles,
      .lines = {.head = "\n\n      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      "
                        "density dm/dt out  total mass gas temp. surface area   reaction\n",
                .row =
                    "{time:12.5E}{id:8}{volume:15.4E}{pressure:15.4E}{internal_energy:15.4E}{dm_dt_in:15.4E}{density:"
                    "15.4E}{dm_dt_out:11.3E}{total_mass:11.3E}{gas_temp:11.3E}{surface_area:11.3E}{reaction:11.3E}\n",
                .tail = ""},
  };
  return format;
}

}  // namespace nugget::output
