// SPDX-License-Identifier: Apache-2.0
#include "output/bndout.hpp"

#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::BndoutState bndout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::BndoutState s;
  s.time = now.state.time;
  for (const Supports::Reaction& r : now.components.supports.motion_reactions()) {
    const model::PrescribedMotion& motion = model.motions[r.source];
    if (motion.target == model::PrescribedMotion::Target::nodes)
      s.nodes.push_back({now.system.node_id(r.node), r.force, r.energy, motion.id});
    else
      s.bodies.push_back({model.rigid_bodies[motion.rigid_body].id, r.force, r.moment, r.energy});
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"bndout">() {
  return make_history(output::bndout(), bndout_state,
                      {.concerns = [](const system::System& system) { return !system.model.motions.empty(); }});
}

}  // namespace nugget::impact
