// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Gas in one control volume (*AIRBAG_...). The format's reaction is 0.
struct AbstatRow {
  int id = 0;                    ///< ID of *AIRBAG_..._ID, or the place in the deck from 1
  double volume = 0.0;           ///< [length^3]
  double pressure = 0.0;         ///< on the faces [force/length^2]
  double internal_energy = 0.0;  ///< [force length]
  double inflow = 0.0;           ///< [mass/time]
  double density = 0.0;          ///< [mass/length^3]
  double outflow = 0.0;          ///< [mass/time]
  double total_mass = 0.0;       ///< of the gas
  double temperature = 0.0;      ///< absolute
  double surface_area = 0.0;     ///< of the faces [length^2]
};

struct AbstatState {
  double time = 0.0;
  std::vector<AbstatRow> rows;  ///< the same volumes in the same order in every state
};

/// The file `abstat`, as LSTC's own translator of binout prints it; the legend holds the headings of
/// *AIRBAG_..._ID.
const HistoryFormat<AbstatState>& abstat();

}  // namespace nugget::output
