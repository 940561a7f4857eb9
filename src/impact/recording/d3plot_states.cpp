// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/d3plot_states.hpp"

#include "base/index.hpp"
#include "base/parallel.hpp"
#include "impact/recording/node_motion.hpp"
#include "output/element_stresses.hpp"

namespace nugget::impact {
namespace {

/// The group that holds an element, or null where the element has no kernel.
const system::ElementGroup* group_of(const Snapshot& now, const system::System::ElementLocation& location) {
  return location.group < 0 ? nullptr : now.system.groups[location.group].get();
}

void fill_shells(const Snapshot& now, output::D3plotState& s) {
  const model::Model& model = now.system.model;
  s.shell_alive.assign(model.shells.size(), 1);
  parallel_for(model.shells.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const system::System::ElementLocation location = now.system.shell_location[e];
      const system::ElementGroup* group = group_of(now, location);
      s.shells[e].thickness = model.shells.thickness[e];
      if (group == nullptr) continue;
      const std::size_t i = at(location.element);
      output::ShellRecord& shell = s.shells[e];
      shell.thickness = group->thickness(i);
      const double density = model.materials[model.parts[group->part].material].density;
      shell.internal_energy = group->mass(i) > 0.0 ? group->internal_energy(i) * density / group->mass(i) : 0.0;
      s.shell_alive[e] = group->alive(i);
      if (!model.requests.strains) continue;
      const Strains::Faces faces = now.components.strains.shell(e, now.state);
      const auto axes = [&](int layer, const Strains::Tensor& strain) {
        return output::by_cmpflg(model, *group, i, layer, now.state, strain);
      };
      shell.inner_strain = axes(0, faces.lower);
      shell.outer_strain = axes(group->layers() - 1, faces.upper);
    }
  });
}

void fill_solids(const Snapshot& now, output::D3plotState& s) {
  const model::Model& model = now.system.model;
  s.solid_alive.assign(model.solids.size(), 1);
  for (std::size_t e = 0; e < model.solids.size(); ++e) {
    const system::System::ElementLocation location = now.system.solid_location[e];
    const system::ElementGroup* group = group_of(now, location);
    if (group == nullptr) continue;
    s.solids[e].strain =
        output::by_cmpflg(model, *group, at(location.element), 0, now.state, now.components.strains.solid(e));
    s.solid_alive[e] = group->alive(at(location.element));
  }
}

void fill_beams(const Snapshot& now, output::D3plotState& s) {
  const model::Model& model = now.system.model;
  s.beam_alive.assign(model.beams.size(), 1);
  for (std::size_t e = 0; e < model.beams.size(); ++e) {
    const system::System::ElementLocation location = now.system.beam_location[e];
    const system::ElementGroup* group = group_of(now, location);
    if (group == nullptr) {
      // A weld was taken out before the run; beams of rigid parts have no group either, but are there.
      const model::Law& law = model.materials[model.parts[model.beams.part[e]].material].law;
      if (std::holds_alternative<kernel::Spotweld>(law) || std::holds_alternative<kernel::DiscreteBeam>(law))
        s.beam_alive[e] = 0;
      continue;
    }
    s.beam_alive[e] = group->alive(at(location.element));
  }
}

}  // namespace

output::D3plotState d3plot_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::D3plotState s;
  s.time = now.state.time;
  s.kinetic = now.energy.kinetic;
  s.internal = now.energy.internal;
  s.total = now.energy.total();
  for (const PartEnergy& p : now.parts)
    s.parts.push_back(
        {p.internal, p.kinetic, p.hourglass, p.mass, p.mass > 0.0 ? (1.0 / p.mass) * p.momentum : Vec3d{}});
  s.velocity = mean_velocity(now.energy, now.parts);
  for (const contact::RigidWall& w : now.components.walls.all()) s.wall_forces.push_back(w.normal_force());

  s.x.resize(model.nodes.size());
  s.v.resize(model.nodes.size());
  s.a.resize(model.nodes.size());
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const auto k = at(now.system.node_of[n]);
    s.x[n] = vec(now.state.x[k]);
    const NodeMotion motion = node_motion(now, k);
    s.v[n] = motion.velocity;
    s.a[n] = motion.acceleration;
  }
  output::fill_stresses(now.system, now.state, s);
  fill_solids(now, s);
  fill_beams(now, s);
  fill_shells(now, s);
  return s;
}

}  // namespace nugget::impact
