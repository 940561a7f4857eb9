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

const HistoryFormat<SleoutState>& sleout() {
  static const HistoryFormat<SleoutState> format{
      .branches = {{
          .path = "sleout",
          .ids = ids(&SleoutState::rows, &SleoutRow::contact),
          .once = columns(&SleoutState::rows, {{"single_sided", &SleoutRow::single_surface, dimension::number,
                                                "1: it has no second side"}}),
          .columns = columns(
              &SleoutState::rows,
              {
                  {"time", &SleoutState::time, dimension::time, "time"},
                  {"cycle", &SleoutState::cycle, dimension::number, "number of the cycle, from 1"},
                  {"slave", &SleoutRow::tracked, dimension::energy, "energy of a contact on the tracked side"},
                  {"master", &SleoutRow::reference, dimension::energy, "energy of a contact on the reference side"},
                  {"friction_energy", &SleoutRow::friction, dimension::energy, "what of it friction has taken"},
                  {"total_slave", &SleoutState::total_tracked, dimension::energy,
                   "sum over the contacts, tracked sides"},
                  {"total_master", &SleoutState::total_reference, dimension::energy,
                   "sum over the contacts, reference sides"},
                  {"total_energy", [](const SleoutState& s) { return s.total_tracked() + s.total_reference(); },
                   dimension::energy, "sum of both"},
                  {"total_friction", &SleoutState::total_friction, dimension::energy, "sum of the friction energies"},
              }),
      }},
      .legend = LegendLines::titles,
      .lines = {.head = "\n contact interface energy file, time={time:14.7E}\n"
                        "    #             slave       master       cycle={cycle:14}    frictional\n\n",
                .row = "{id:10}{slave:13.4E}{master:13.4E}{friction_energy:41.4E}\n",
                .tail = "\n summary   total slave side={total_slave:14.7E}\n"
                        "           total mastr side={total_master:14.7E}\n"
                        "           total energy    ={total_energy:14.7E}\n"
                        "           friction energy ={total_friction:14.7E}\n\n"},
  };
  return format;
}

}  // namespace nugget::output
