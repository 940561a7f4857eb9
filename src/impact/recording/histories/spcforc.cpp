// SPDX-License-Identifier: Apache-2.0
#include "output/spcforc.hpp"

#include <algorithm>

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::SpcforcState spcforc_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::SpcforcState s;
  s.time = now.state.time;
  for (const Supports::Reaction& r : now.components.supports.spc_reactions()) {
    const model::SinglePointConstraint& spc = model.spcs[r.source];
    const Frame3d axes =
        spc.system == model::none ? Frame3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}} : model.systems[spc.system].axes;
    if (spc.fixed & 7u) {
      s.forces.push_back({now.system.node_id(r.node), axes.local(r.force), spc.id});
      s.resultant += r.force;
    }
    if (spc.fixed >> 3) s.moments.push_back({now.system.node_id(r.node), axes.local(r.moment), spc.id});
  }
  const auto ascending = [](const output::SpcforcRow& a, const output::SpcforcRow& b) { return a.node < b.node; };
  std::stable_sort(s.forces.begin(), s.forces.end(), ascending);
  std::stable_sort(s.moments.begin(), s.moments.end(), ascending);
  return s;
}

}  // namespace

template <>
HistoryFile history<"spcforc">() {
  return make_history(output::spcforc(), spcforc_state,
                      {.concerns = [](const system::System& system) { return !system.model.spcs.empty(); }});
}

}  // namespace nugget::impact
