// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Force of one rigid wall on the model [force].
struct RwforcRow {
  int wall = 0;         ///< ID of *RIGIDWALL_..._ID, or the place in the deck from 1
  double normal = 0.0;  ///< along the wall's normal
  Vec3d force;          ///< global axes
};

struct RwforcState {
  double time = 0.0;
  std::vector<RwforcRow> rows;  ///< the same walls in the same order in every state
};

/// The file `rwforc`; the legend holds the headings of *RIGIDWALL_..._ID.
const HistoryFormat<RwforcState>& rwforc();

}  // namespace nugget::output
