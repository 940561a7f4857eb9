// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/element_histories.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "output/element_stresses.hpp"

namespace nugget::impact {
namespace {

/// The group that holds an element, and its place there; null where the element has no kernel.
std::pair<const system::ElementGroup*, std::size_t> find(const Snapshot& now,
                                                         const std::vector<system::System::ElementLocation>& locations,
                                                         model::Index element) {
  const system::System::ElementLocation location = locations[element];
  if (location.group < 0) return {nullptr, 0};
  return {now.system.groups[location.group].get(), at(location.element)};
}

output::EloutPoint point(const system::ElementGroup& group, std::size_t e, int layer, const Snapshot& now) {
  if (!group.alive(e)) return {};
  const system::ElementGroup::Layer l = output::shown_layer(now.system, group, e, layer, now.state);
  return {l.stress, l.plastic_strain};
}

output::EloutSolid solid(const Snapshot& now, model::Index index, const system::ElementGroup& group, std::size_t e) {
  const model::Model& model = now.system.model;
  const auto turned = [&](const output::Tensor& t) { return output::by_cmpflg(model, group, e, 0, now.state, t); };
  output::EloutSolid row{model.solids.id[index], model.parts[group.part].id, point(group, e, 0, now),
                         turned(now.components.strains.solid(at(index)))};
  row.point.stress = turned(row.point.stress);
  return row;
}

output::EloutShell shell(const Snapshot& now, model::Index index, const system::ElementGroup& group, std::size_t e) {
  const model::Model& model = now.system.model;
  output::EloutShell row;
  row.id = model.shells.id[index];
  row.part = model.parts[group.part].id;
  const auto turn = [&](output::Tensor& tensor, int layer) {
    if (const auto axes = output::axes_in_elout(now.system, group, e, layer, now.state))
      tensor = output::along(*axes, tensor);
  };
  for (const int k : output::layers_in_elout(model, group)) {
    row.layers.push_back(point(group, e, k, now));
    turn(row.layers.back().stress, k);
  }
  const Strains::Faces faces = now.components.strains.shell(at(index), now.state);
  row.lower_strain = faces.lower;
  row.upper_strain = faces.upper;
  turn(row.lower_strain, 0);
  turn(row.upper_strain, group.layers() - 1);
  return row;
}

/// Layers from the bottom up, in global axes.
output::EloutShell thick_shell(const Snapshot& now, model::Index index, const system::ElementGroup& group,
                               std::size_t e) {
  const model::Model& model = now.system.model;
  output::EloutShell row;
  row.id = model.solids.id[index];
  row.part = model.parts[group.part].id;
  for (int k = 0; k < group.layers(); ++k) row.layers.push_back(point(group, e, k, now));
  const Strains::Faces faces = now.components.strains.thick_shell(at(index));
  row.lower_strain = faces.lower;
  row.upper_strain = faces.upper;
  return row;
}

output::EloutBeam beam(const Snapshot& now, model::Index index, const system::ElementGroup& group, std::size_t e) {
  const model::Model& model = now.system.model;
  const model::Part& part = model.parts[group.part];
  output::EloutBeam row;
  row.id = model.beams.id[index];
  row.part = part.id;
  row.material_type = number_of_law(model.materials[part.material]);
  if (group.alive(e)) {
    const std::array<double, 8> r = group.resultants(e);
    row.axial = r[0];
    row.shear_s = r[1];
    row.shear_t = r[2];
    row.torsion = r[3];
    row.moment_s = r[4];
    row.moment_t = r[5];
  }
  for (int k = 0; k < std::min(model.requests.beam_points, group.layers()); ++k) {
    const output::EloutPoint p = point(group, e, k, now);
    row.points.push_back({p.stress[0], p.stress[3], p.stress[5], p.plastic_strain});
  }
  return row;
}

}  // namespace

int number_of_law(const model::Material& material) {
  static constexpr std::pair<std::string_view, int> numbers[] = {{"MAT_SPOTWELD", 100},
                                                                 {"MAT_LINEAR_ELASTIC_DISCRETE_BEAM", 66},
                                                                 {"MAT_NONLINEAR_ELASTIC_DISCRETE_BEAM", 67},
                                                                 {"MAT_NONLINEAR_PLASTIC_DISCRETE_BEAM", 68},
                                                                 {"MAT_ELASTIC_SPRING_DISCRETE_BEAM", 74},
                                                                 {"MAT_GENERAL_NONLINEAR_6DOF_DISCRETE_BEAM", 119},
                                                                 {"MAT_GENERAL_NONLINEAR_1DOF_DISCRETE_BEAM", 121},
                                                                 {"MAT_GENERAL_SPRING_DISCRETE_BEAM", 196},
                                                                 {"MAT_ELASTIC", 1},
                                                                 {"MAT_PLASTIC_KINEMATIC", 3},
                                                                 {"MAT_PIECEWISE_LINEAR_PLASTICITY", 24}};
  for (const auto& [keyword, number] : numbers)
    if (material.keyword.starts_with(keyword)) return number;
  return 0;
}

output::EloutState elout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::EloutState s;
  s.cycle = now.state.cycle + 1;  // LS-DYNA counts from 1
  s.time = now.state.time;
  s.strains = model.requests.strains;
  s.local_shells = model.requests.shell_axes != model::Requests::ShellAxes::global;
  for (const model::NamedEntity& entity : model.requests.history_solids) {
    const auto [group, e] = find(now, now.system.solid_location, entity.index);
    if (group == nullptr) continue;
    s.solids.push_back(solid(now, entity.index, *group, e));
  }
  for (const model::NamedEntity& entity : model.requests.history_beams) {
    const auto [group, e] = find(now, now.system.beam_location, entity.index);
    if (group != nullptr) s.beams.push_back(beam(now, entity.index, *group, e));
  }
  for (const model::NamedEntity& entity : model.requests.history_shells) {
    const auto [group, e] = find(now, now.system.shell_location, entity.index);
    if (group == nullptr) continue;
    s.shells.push_back(shell(now, entity.index, *group, e));
  }
  for (const model::NamedEntity& entity : model.requests.history_thick_shells) {
    const auto [group, e] = find(now, now.system.solid_location, entity.index);
    if (group != nullptr) s.thick_shells.push_back(thick_shell(now, entity.index, *group, e));
  }
  return s;
}

}  // namespace nugget::impact
