// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Force of a spring or damper on its first node; of a torsional one the moment, and the twist instead of the
/// elongation.
struct DeforcRow {
  int spring = 0;  ///< user id
  bool torsional = false;
  Vec3d force;                ///< global axes
  double resultant = 0.0;     ///< positive in tension
  double displacement = 0.0;  ///< change in length
};

struct DeforcState {
  double time = 0.0;
  std::vector<DeforcRow> rows;  ///< the same springs in the same order in every state
};

/// The file `deforc`.
const HistoryFormat<DeforcState>& deforc();

}  // namespace nugget::output
