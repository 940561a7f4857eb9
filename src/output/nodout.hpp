// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/vec3.hpp"
#include "output/ascii.hpp"

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

/// The ASCII file `nodout`; the legend holds the headings of *DATABASE_HISTORY_NODE_ID.
class Nodout {
 public:
  Nodout(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend = {});
  void write(const NodoutState& state);
  void archive(Archive& a) { a(file_); }

 private:
  void table_head(const NodoutState& state);

  AsciiFile file_;
};

}  // namespace nugget::output
