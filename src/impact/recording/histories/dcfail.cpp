// SPDX-License-Identifier: Apache-2.0
#include "output/dcfail.hpp"

#include <algorithm>

#include "impact/recording/histories.hpp"
#include "impact/recording/weld_results.hpp"

namespace nugget::impact {

template <>
HistoryFile history<"dcfail">() {
  return make_history(output::dcfail(), dcfail_state, {.concerns = [](const system::System& system) {
                        return std::ranges::any_of(system.model.weld_laws,
                                                   [](const auto& law) { return law.properties != model::none; });
                      }});
}

}  // namespace nugget::impact
