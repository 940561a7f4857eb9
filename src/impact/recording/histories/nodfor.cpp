// SPDX-License-Identifier: Apache-2.0
#include "output/nodfor.hpp"

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::NodforState nodfor_state(const Snapshot& now) {
  return now.components.nodal_forces.state(now.state);
}

}  // namespace

template <>
HistoryFile history<"nodfor">() {
  return make_history(output::nodfor(), nodfor_state, {.concerns = [](const system::System& system) {
                        return !system.model.requests.nodal_force_groups.empty();
                      }});
}

}  // namespace nugget::impact
