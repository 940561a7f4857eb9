// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "output/history.hpp"

namespace nugget::output {

struct NodforRow {
  int node = 0;         ///< user id
  Vec3d force;          ///< [force]
  double energy = 0.0;  ///< work of it so far [force length]
};

/// One *DATABASE_NODAL_FORCE_GROUP.
struct NodforGroup {
  int set_id = 0;  ///< user id of the node set
  std::vector<NodforRow> rows;
  std::optional<Frame3d> axes;  ///< in which the sum is written as well
};
/// Sum over a group.
NodforRow total(const NodforGroup& group);

struct NodforState {
  double time = 0.0;
  std::vector<NodforGroup> groups;  ///< the same groups and nodes in the same order in every state
};

/// The file `nodfor`.
const HistoryFormat<NodforState>& nodfor();

}  // namespace nugget::output
