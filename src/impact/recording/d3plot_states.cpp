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

template <class Put>
void put_each(std::size_t count, const Put& put) {
  parallel_for(count, 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) put(i);
  });
}

void put_shells(const Snapshot& now, output::D3plotWords& words) {
  const model::Model& model = now.system.model;
  put_each(model.shells.size(), [&](std::size_t e) {
    thread_local std::vector<output::StressRecord> layers;
    layers.resize(at(model.requests.layers));
    const system::System::ElementLocation location = now.system.shell_location[e];
    output::ShellRecord shell = output::shell_forces(now.system, now.state, location, layers);
    shell.thickness = model.shells.thickness[e];
    const system::ElementGroup* group = group_of(now, location);
    const std::size_t i = at(location.element);
    if (group != nullptr) {
      shell.thickness = group->thickness(i);
      const double density = model.materials[model.parts[group->part].material].density;
      shell.internal_energy = group->mass(i) > 0.0 ? group->internal_energy(i) * density / group->mass(i) : 0.0;
    }
    if (group != nullptr && model.requests.strains) {
      const Strains::Faces faces = now.components.strains.shell(e, now.state);
      const auto axes = [&](int layer, const Strains::Tensor& strain) {
        return output::by_cmpflg(model, *group, i, layer, now.state, strain);
      };
      shell.inner_strain = axes(0, faces.lower);
      shell.outer_strain = axes(group->layers() - 1, faces.upper);
    }
    words.put_shell(e, shell, layers, group == nullptr || group->alive(i));
  });
}

void put_thick_shell(const Snapshot& now, std::size_t e, output::D3plotWords& words) {
  thread_local std::vector<output::StressRecord> layers;
  layers.resize(at(now.system.model.requests.layers));
  const system::System::ElementLocation location = now.system.solid_location[e];
  output::thick_shell_stresses(now.system, now.state, location, layers);
  const system::ElementGroup* group = group_of(now, location);
  const Strains::Faces faces = now.components.strains.thick_shell(e);
  const std::size_t i = at(location.element);
  output::ThickShellRecord record{faces.lower, faces.upper, 0.0};
  if (group != nullptr && group->mass(i) > 0.0)
    record.internal_energy = group->internal_energy(i) *
                             now.system.model.materials[now.system.model.parts[group->part].material].density /
                             group->mass(i);
  words.put_thick_shell(e, record, layers, group == nullptr || group->alive(i));
}

void put_solids(const Snapshot& now, output::D3plotWords& words) {
  const model::Model& model = now.system.model;
  put_each(model.solids.size(), [&](std::size_t e) {
    const system::System::ElementLocation location = now.system.solid_location[e];
    if (model.has_thick_shells(model.solids.part[e])) return put_thick_shell(now, e, words);
    output::SolidRecord solid{output::solid_stress(now.system, now.state, location), {}};
    const system::ElementGroup* group = group_of(now, location);
    const std::size_t i = at(location.element);
    if (group != nullptr)
      solid.strain = output::by_cmpflg(model, *group, i, 0, now.state, now.components.strains.solid(e));
    words.put_solid(e, solid, group == nullptr || group->alive(i));
  });
}

void put_beams(const Snapshot& now, output::D3plotWords& words) {
  const model::Model& model = now.system.model;
  put_each(model.beams.size(), [&](std::size_t e) {
    thread_local std::vector<output::BeamPointRecord> points;
    points.resize(at(model.requests.beam_points));
    const system::System::ElementLocation location = now.system.beam_location[e];
    const output::BeamRecord beam = output::beam_forces(now.system, now.state, location, points);
    const system::ElementGroup* group = group_of(now, location);
    bool alive = group == nullptr || group->alive(at(location.element));
    if (group == nullptr) {
      // A weld was taken out before the run; beams of rigid parts have no group either, but are there.
      const model::Law& law = model.materials[model.parts[model.beams.part[e]].material].law;
      alive = !std::holds_alternative<kernel::Spotweld>(law) && !std::holds_alternative<kernel::DiscreteBeam>(law);
    }
    words.put_beam(e, beam, points, alive);
  });
}

}  // namespace

void put_state(const Snapshot& now, output::D3plotWords& words) {
  const model::Model& model = now.system.model;
  output::D3plotTotals totals;
  totals.time = now.state.time;
  totals.kinetic = now.energy.kinetic;
  totals.internal = now.energy.internal;
  totals.total = now.energy.total();
  for (const PartEnergy& p : now.parts)
    totals.parts.push_back(
        {p.internal, p.kinetic, p.hourglass, p.mass, p.mass > 0.0 ? (1.0 / p.mass) * p.momentum : Vec3d{}});
  totals.velocity = mean_velocity(now.energy, now.parts);
  for (const contact::RigidWall& w : now.components.walls.all()) totals.wall_forces.push_back(w.normal_force());
  words.put(totals);
  put_each(model.nodes.size(), [&](std::size_t n) {
    const auto k = at(now.system.node_of[n]);
    const NodeMotion motion = node_motion(now, k);
    words.put_node(n, vec(now.state.x[k]), motion.velocity, motion.acceleration);
  });
  put_solids(now, words);
  put_beams(now, words);
  put_shells(now, words);
}

}  // namespace nugget::impact
