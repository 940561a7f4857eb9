// SPDX-License-Identifier: Apache-2.0
#include "output/glstat.hpp"

#include "impact/energy/energy.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

output::ElementKind kind(const model::Model& model, const system::ElementGroup& group) {
  if (model.has_thick_shells(group.part)) return output::ElementKind::thick_shell;
  switch (group.kind) {
    case model::ElementKind::beam: return output::ElementKind::beam;
    case model::ElementKind::shell: return output::ElementKind::shell;
    case model::ElementKind::discrete: return output::ElementKind::discrete;
    default: return output::ElementKind::solid;
  }
}

output::GlstatState glstat_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  const Energy& e = now.energy;
  output::GlstatState s;
  s.cycle = now.state.cycle + 1;  // LS-DYNA counts from 1
  if (now.controlling.group >= 0) {
    const system::ElementGroup& group = *now.system.groups[now.controlling.group];
    const model::Index element = now.controlling.element >= 0 ? group.element[now.controlling.element] : 0;
    s.controlling = output::ControllingElement{kind(model, group), now.system.element_id(group, element),
                                               model.parts[group.part].id};
  }
  s.time = now.state.time;
  s.time_step = now.state.dt;
  s.kinetic = e.kinetic;
  s.internal = e.internal;
  for (const contact::RigidWall& wall : now.components.walls.all()) s.walls.push_back(wall.energy_at_time());
  if (!model.discretes.empty()) {
    s.spring_and_damper = 0.0;  // part of the internal energy, as in LS-DYNA
    for (std::size_t p = 0; p < now.parts.size(); ++p)
      if (model.parts[p].kind == model::ElementKind::discrete) *s.spring_and_damper += now.parts[p].internal;
  }
  if (!now.components.joints.empty()) s.joint = now.components.joints.energy();  // also part of it
  if (model.control.hourglass_energy) s.hourglass = e.hourglass;
  s.system_damping = e.damping;
  s.sliding_interface = e.contact;
  s.external_work = e.external;
  s.eroded_kinetic = e.eroded_kinetic;
  s.eroded_internal = e.eroded;
  s.eroded_hourglass = 0.0;
  s.total = e.total();
  s.ratio = e.ratio();
  const double base = e.initial + e.external;
  s.ratio_without_eroded = base != 0.0 ? (e.total() - e.eroded - e.eroded_kinetic) / base : 1.0;
  s.velocity = mean_velocity(e, now.parts);
  if (now.masses.added != 0.0) {
    s.added_mass = now.masses.added;
    s.percent_increase = 100.0 * now.masses.added / now.masses.physical;
  }
  return s;
}

/// As the deck says, but as text too, since the report draws the energies from it; where it asks for none, 200 times
/// over the run.
model::Request with_text(const model::Request& asked, const model::Model& model) {
  model::Request request = asked;
  if (!request.asked()) request.interval = model.control.end_time / 200.0;
  if (request.binary == 2) request.binary = 3;
  return request;
}

}  // namespace

template <>
HistoryFile history<"glstat">() {
  return make_history(output::glstat(), glstat_state, {.request = with_text});
}

}  // namespace nugget::impact
