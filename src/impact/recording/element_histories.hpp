// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "impact/recording/result_parcels.hpp"
#include "impact/simulation/snapshot.hpp"
#include "output/elout.hpp"

namespace nugget::impact {

/// Stresses, strains and resultants of the elements of *DATABASE_HISTORY_... Elements without a kernel (rigid parts)
/// are not in it; deleted ones stay, without stress.
output::EloutState elout_state(const Snapshot& now);

/// Its rows, some of a table at a time, for HistoryByRows. Strains of shells are in the rows of either table.
struct EloutRows {
  using State = output::EloutState;
  using Table = output::EloutTable;
  using Take = std::function<void(const State&)>;
  static const output::HistoryFormat<State>& format() { return output::elout(); }
  static std::vector<Table> tables(const model::Model& model);
  static bool text_only(Table table) { return output::shows_strains(table); }
  static void set_head(State& state, const Snapshot& now);
  static void blank(const system::System& system, const Take& take);
  static void pass(const Snapshot& now, Table table, ResultParcels& parcels, const Take& take);
  void archive(Archive&) {}
};

/// LS-DYNA's number of the laws that beams can have; 0 where it is not known.
int number_of_law(const model::Material& material);

}  // namespace nugget::impact
