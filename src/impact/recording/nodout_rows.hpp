// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "impact/recording/result_parcels.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/nodout.hpp"

namespace nugget::impact {

/// Rows of nodout, some at a time, for HistoryByRows.
struct NodoutRows {
  using State = output::NodoutState;
  using Table = output::NodoutTable;
  using Take = std::function<void(const State&)>;
  static const output::HistoryFormat<State>& format() { return output::nodout(); }
  static std::vector<Table> tables(const model::Model& model);
  static bool text_only(Table table) { return table == Table::rotations; }
  static void set_head(State& state, const Snapshot& now);
  static void blank(const system::System& system, const Take& take);
  static void pass(const Snapshot& now, Table table, ResultParcels& parcels, const Take& take);
};

}  // namespace nugget::impact
