// SPDX-License-Identifier: Apache-2.0
#include "output/swforc.hpp"

#include "impact/recording/histories.hpp"
#include "impact/recording/weld_results.hpp"

namespace nugget::impact {

template <>
HistoryFile history<"swforc">() {
  return make_history(output::swforc(), swforc_state,
                      {.concerns = [](const system::System& system) { return !system.ties.welds.empty(); }});
}

}  // namespace nugget::impact
