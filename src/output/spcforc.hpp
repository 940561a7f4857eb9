// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// Force or moment of a support on one node, in the support's local axes.
struct SpcforcRow {
  int node = 0;  ///< user id
  Vec3d value;   ///< [force] or [force length]
  int set = 0;   ///< id of the *BOUNDARY_SPC_..., 0 without one
};

struct SpcforcState {
  double time = 0.0;
  std::vector<SpcforcRow> forces;   ///< nodes held in translation, ascending; the same in every state
  std::vector<SpcforcRow> moments;  ///< nodes held in rotation, ascending; the same in every state
  Vec3d resultant;                  ///< sum of the forces in global axes [force]
};

/// The file `spcforc`. A node's force stands before its moment.
const HistoryFormat<SpcforcState>& spcforc();

}  // namespace nugget::output
