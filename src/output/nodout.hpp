// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// One node of *DATABASE_HISTORY_NODE: motion in global axes [length, time, radian].
struct NodoutRow {
  int node = 0;  ///< user id
  Vec3d displacement, velocity, acceleration;
  Vec3d coordinate;                                              ///< now
  Vec3d rotation, rotational_velocity, rotational_acceleration;  ///< written where NodoutState::rotations is set
};

struct NodoutState {
  long cycle = 0;
  double time = 0.0;
  bool rotations = false;       ///< the model has shells or beams: a second table follows
  std::vector<NodoutRow> rows;  ///< the same nodes in the same order in every state
};

/// The tables of `nodout` as text: each has its head, then rows, all at once or some at a time. That of rotations is
/// there where NodoutState::rotations is set.
enum class NodoutTable { translations, rotations };
void print_head(AsciiFile& file, NodoutTable table, const NodoutState& state);
void print_rows(AsciiFile& file, NodoutTable table, const NodoutState& rows);

/// The file `nodout`; the legend holds the headings of *DATABASE_HISTORY_NODE_ID.
const HistoryFormat<NodoutState>& nodout();

}  // namespace nugget::output
