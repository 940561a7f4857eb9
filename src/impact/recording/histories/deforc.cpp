// SPDX-License-Identifier: Apache-2.0
#include "output/deforc.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "impact/recording/histories.hpp"
#include "system/spring_group.hpp"

namespace nugget::impact {
namespace {

output::DeforcState deforc_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::DeforcState s;
  s.time = now.state.time;
  for (std::size_t e = 0; e < model.discretes.size(); ++e) {
    if (!model.discretes[e].in_deforc) continue;
    const system::System::ElementLocation location = now.system.discrete_location[e];
    const auto& group = static_cast<const system::SpringGroup&>(*now.system.groups[location.group]);
    const std::size_t i = at(location.element);
    const double force = group.force(i);
    s.rows.push_back({model.discretes[e].id, group.torsional(), force * group.line(i), force, group.elongation(i)});
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"deforc">() {
  return make_history(output::deforc(), deforc_state, {.concerns = [](const system::System& system) {
                        return std::ranges::any_of(system.model.discretes,
                                                   [](const model::Discrete& d) { return d.in_deforc; });
                      }});
}

}  // namespace nugget::impact
