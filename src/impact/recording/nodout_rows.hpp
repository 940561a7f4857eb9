// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "impact/recording/node_motion.hpp"
#include "impact/recording/result_parcels.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/nodout.hpp"

namespace nugget::impact {

/// Accelerations as means over the time since the output before (IACCOP = 1): the change of a velocity over that time.
/// At the first output they are those of the moment.
class MeanAccelerations {
 public:
  /// Begins the output at a time; again for each of its tables.
  void begin(double time, std::size_t motions);
  /// Motion i with the mean in place of its accelerations.
  NodeMotion averaged(std::size_t i, NodeMotion motion);
  void archive(Archive& a) { a(time_, time_before_, now_, before_); }

 private:
  struct Velocities {
    Vec3d velocity, spin;
  };
  double time_ = -std::numeric_limits<double>::infinity(), time_before_ = time_;
  std::vector<Velocities> now_, before_;  ///< by motion; `before_` is empty at the first output
};

/// Rows of nodout, some at a time, for HistoryByRows.
class NodoutRows {
 public:
  using State = output::NodoutState;
  using Table = output::NodoutTable;
  using Take = std::function<void(const State&)>;
  static const output::HistoryFormat<State>& format() { return output::nodout(); }
  static std::vector<Table> tables(const model::Model& model);
  static bool text_only(Table table) { return table == Table::rotations; }
  static void set_head(State& state, const Snapshot& now);
  static void blank(const system::System& system, const Take& take);
  void pass(const Snapshot& now, Table table, ResultParcels& parcels, const Take& take);
  void archive(Archive& a) { a(means_); }

 private:
  MeanAccelerations means_;  ///< of the nodes asked for, then of the origins of their moving axes; on the first rank
};

}  // namespace nugget::impact
