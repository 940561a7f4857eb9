// SPDX-License-Identifier: Apache-2.0
#include "output/matsum.hpp"

namespace nugget::output {
namespace {

void print(AsciiFile& file, const MatsumState& state) {
  file.print("\n\n time ={:13.4E}\n", column(state.time));
  if (state.lumped_kinetic)
    file.print(
        " mat.#={:5}             inten={:13.4E}     kinen={:13.4E}     eroded_ie={:13.4E}     eroded_ke={:13.4E}\n", 0,
        0.0, column(*state.lumped_kinetic), 0.0, 0.0);
  for (const MatsumRow& row : state.rows) {
    if (row.part < 100000)
      file.print(" mat.#={:5}   ", row.part);
    else
      file.print(" mat.#={:8}", row.part);
    file.print("          inten={:13.4E}     kinen={:13.4E}     eroded_ie={:13.4E}     eroded_ke={:13.4E}\n",
               column(row.internal), column(row.kinetic), column(row.eroded_internal), column(row.eroded_kinetic));
    file.print(" x-mom={:13.4E}     y-mom={:13.4E}     z-mom={:13.4E}\n", column(row.momentum.x),
               column(row.momentum.y), column(row.momentum.z));
    file.print(" x-rbv={:13.4E}     y-rbv={:13.4E}     z-rbv={:13.4E}\n", column(row.velocity.x),
               column(row.velocity.y), column(row.velocity.z));
    file.print("                         hgeng={:13.4E}     +mass={:13.4E}\n\n\n", column(row.hourglass),
               column(row.added_mass));
  }
}

}  // namespace

const HistoryFormat<MatsumState>& matsum() {
  static const HistoryFormat<MatsumState> format{
      .branches = {{
          .path = "matsum",
          .ids = ids(&MatsumState::rows, &MatsumRow::part),
          .columns =
              columns(&MatsumState::rows,
                      {
                          {"time", &MatsumState::time, dimension::time, "time"},
                          {"internal_energy", &MatsumRow::internal, dimension::energy, "internal energy of a part"},
                          {"kinetic_energy", &MatsumRow::kinetic, dimension::energy, "kinetic energy"},
                          {"eroded_internal_energy", &MatsumRow::eroded_internal, dimension::energy,
                           "internal energy of deleted elements"},
                          {"eroded_kinetic_energy", &MatsumRow::eroded_kinetic, dimension::energy,
                           "kinetic energy of deleted elements"},
                          {"mass", &MatsumRow::added_mass, dimension::mass, "added by mass scaling"},
                          {"hourglass_energy", &MatsumRow::hourglass, dimension::energy, "hourglass energy"},
                          {"*_momentum", &MatsumRow::momentum, dimension::momentum, "momentum"},
                          {"*_rbvelocity", &MatsumRow::velocity, dimension::velocity, "momentum over mass"},
                          {"lumped_kinetic_energy", &MatsumState::lumped_kinetic, dimension::energy,
                           "kinetic energy of masses that belong to no part"},
                      }),
      }},
      .legend = LegendLines::titles,
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
