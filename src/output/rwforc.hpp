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

/// Force of a wall on the nodes of a set (*RIGIDWALL_FORCE_TRANSDUCER) [force].
struct WallTransducerRow {
  int id = 0, set = 0, wall = 0;  ///< user ids
  Vec3d force;
};

/// Forces on the areas of a wall (SSID of *RIGIDWALL_PLANAR_FORCES).
struct WallAreas {
  std::size_t wall = 0;  ///< its place in RwforcState::rows
  std::vector<Vec3d> forces;
};

struct RwforcState {
  double time = 0.0;
  std::vector<RwforcRow> rows;  ///< the same walls in the same order in every state
  int cycle = 0;
  std::vector<WallTransducerRow> transducers{};
  std::vector<WallAreas> areas{};  ///< of walls that have some
};

/// The file `rwforc`; the legend holds the headings of *RIGIDWALL_..._ID.
const HistoryFormat<RwforcState>& rwforc();
/// The same with a branch of binout for the areas of each of these walls, by their places in RwforcState::rows:
/// rwforc/wall001 for the first one.
HistoryFormat<RwforcState> rwforc_with_areas(const std::vector<std::size_t>& walls);

}  // namespace nugget::output
