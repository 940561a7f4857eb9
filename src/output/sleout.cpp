// SPDX-License-Identifier: Apache-2.0
#include "output/sleout.hpp"

namespace nugget::output {

namespace {

double total(const SleoutState& state, double SleoutRow::*energy) {
  double sum = 0.0;
  for (const SleoutRow& row : state.rows) sum += row.*energy;
  return sum;
}

}  // namespace

double SleoutState::total_tracked() const {
  return total(*this, &SleoutRow::tracked);
}

double SleoutState::total_reference() const {
  return total(*this, &SleoutRow::reference);
}

double SleoutState::total_friction() const {
  return total(*this, &SleoutRow::friction);
}

Sleout::Sleout(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Sleout::write(const SleoutState& state) {
  file_.print("\n contact interface energy file, time={:14.7E}\n", column(state.time));
  file_.print("    #             slave       master       cycle={:14}    frictional\n\n", state.cycle);
  for (const SleoutRow& row : state.rows)
    file_.print("{:10}{:13.4E}{:13.4E}{:41.4E}\n", row.contact, column(row.tracked), column(row.reference),
                column(row.friction));
  const double tracked = state.total_tracked(), reference = state.total_reference();
  file_.print("\n summary   total slave side={:14.7E}\n", column(tracked));
  file_.print("           total mastr side={:14.7E}\n", column(reference));
  file_.print("           total energy    ={:14.7E}\n", column(tracked + reference));
  file_.print("           friction energy ={:14.7E}\n\n", column(state.total_friction()));
  file_.end_state();
}

}  // namespace nugget::output
