// SPDX-License-Identifier: Apache-2.0
#include "output/sleout.hpp"

namespace nugget::output {

double SleoutState::total_tracked() const {
  double sum = 0.0;
  for (const SleoutRow& row : rows) sum += row.tracked;
  return sum;
}

double SleoutState::total_reference() const {
  double sum = 0.0;
  for (const SleoutRow& row : rows) sum += row.reference;
  return sum;
}

Sleout::Sleout(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Sleout::write(const SleoutState& state) {
  file_.print("\n contact interface energy file, time={:14.7E}\n", column(state.time));
  file_.print("    #            slave       master        cycle={:14}\n\n", state.cycle);
  for (const SleoutRow& row : state.rows)
    file_.print("{:10}{:13.4E}{:13.4E}\n", row.contact, column(row.tracked), column(row.reference));
  const double tracked = state.total_tracked(), reference = state.total_reference();
  file_.print("\n summary   total slave side={:14.7E}\n", column(tracked));
  file_.print("           total mastr side={:14.7E}\n", column(reference));
  file_.print("           total energy    ={:14.7E}\n\n", column(tracked + reference));
  file_.end_state();
}

}  // namespace nugget::output
