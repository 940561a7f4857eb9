// SPDX-License-Identifier: Apache-2.0
#include "output/matsum.hpp"

namespace nugget::output {

Matsum::Matsum(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Matsum::write(const MatsumState& state) {
  file_.print("\n\n time ={:13.4E}\n", column(state.time));
  if (state.lumped_kinetic)
    file_.print(
        " mat.#={:5}             inten={:13.4E}     kinen={:13.4E}     eroded_ie={:13.4E}     eroded_ke={:13.4E}\n", 0,
        0.0, column(*state.lumped_kinetic), 0.0, 0.0);
  for (const MatsumRow& row : state.rows) {
    if (row.part < 100000)
      file_.print(" mat.#={:5}   ", row.part);
    else
      file_.print(" mat.#={:8}", row.part);
    file_.print("          inten={:13.4E}     kinen={:13.4E}     eroded_ie={:13.4E}     eroded_ke={:13.4E}\n",
                column(row.internal), column(row.kinetic), column(row.eroded_internal), column(row.eroded_kinetic));
    file_.print(" x-mom={:13.4E}     y-mom={:13.4E}     z-mom={:13.4E}\n", column(row.momentum.x),
                column(row.momentum.y), column(row.momentum.z));
    file_.print(" x-rbv={:13.4E}     y-rbv={:13.4E}     z-rbv={:13.4E}\n", column(row.velocity.x),
                column(row.velocity.y), column(row.velocity.z));
    file_.print("                         hgeng={:13.4E}     +mass={:13.4E}\n\n\n", column(row.hourglass),
                column(row.added_mass));
  }
  file_.end_state();
}

}  // namespace nugget::output
