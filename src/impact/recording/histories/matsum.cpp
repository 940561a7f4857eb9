// SPDX-License-Identifier: Apache-2.0
#include "output/matsum.hpp"

#include <algorithm>

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::MatsumState matsum_state(const Snapshot& now) {
  output::MatsumState s;
  s.time = now.state.time;
  const model::Model& model = now.system.model;
  const bool given_nodal =
      std::ranges::any_of(model.rigid_bodies, [](const model::RigidBody& b) { return b.given && b.parts.empty(); });
  if (!model.masses.empty() || !model.inertias.empty() || given_nodal) s.lumped_kinetic = now.energy.lumped.kinetic;
  for (std::size_t p = 0; p < now.parts.size(); ++p) {
    const PartEnergy& part = now.parts[p];
    output::MatsumRow row;
    row.part = now.system.model.parts[p].id;
    row.internal = part.internal;
    row.kinetic = part.kinetic;
    row.hourglass = part.hourglass;
    row.eroded_internal = part.eroded;
    row.eroded_kinetic = part.eroded_kinetic;
    row.added_mass = now.masses.added_by_part[p];
    row.momentum = part.momentum;
    if (part.mass > 0.0) row.velocity = (1.0 / part.mass) * part.momentum;
    s.rows.push_back(row);
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"matsum">() {
  return make_history(output::matsum(), matsum_state, {.legends = [](const model::Model& model) {
                        std::vector<output::LegendEntry> titles;
                        for (const auto& p : model.parts) titles.push_back({p.id, p.title});
                        return std::vector<Legend>{{"matsum", titles}};
                      }});
}

}  // namespace nugget::impact
