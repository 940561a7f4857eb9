// SPDX-License-Identifier: Apache-2.0
#include "impact/element_histories.hpp"

#include <string_view>
#include <utility>

#include "base/index.hpp"

namespace nugget::impact {
namespace {

/// The group that holds an element, and its place there; null where the element has no kernel.
std::pair<const system::ElementGroup*, std::size_t> find(const Snapshot& now,
                                                         const std::vector<system::System::Seat>& seats,
                                                         model::Index element) {
  const system::System::Seat seat = seats[at(element)];
  if (seat.group < 0) return {nullptr, 0};
  return {now.system.groups[at(seat.group)].get(), at(seat.element)};
}

output::EloutPoint point(const system::ElementGroup& group, std::size_t e, int layer, const Snapshot& now) {
  if (!group.alive(e)) return {};
  const system::ElementGroup::Layer l = group.layer(e, layer, now.state);
  return {l.stress, l.plastic_strain};
}

/// LS-DYNA's number of the laws that beams can have; 0 where this table does not know it.
int material_type(const model::Material& material) {
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

output::EloutBeam beam(const Snapshot& now, model::Index index, const system::ElementGroup& group, std::size_t e) {
  const model::Model& model = now.system.model;
  const model::Part& part = model.parts[at(group.part)];
  output::EloutBeam row;
  row.id = model.beams.id[at(index)];
  row.part = part.id;
  row.material_type = material_type(model.materials[at(part.material)]);
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

output::EloutState elout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  output::EloutState s;
  s.cycle = now.state.cycle + 1;  // LS-DYNA counts from 1
  s.time = now.state.time;
  s.strains = model.requests.strains;
  for (const model::NamedEntity& entity : model.requests.history_solids) {
    const auto [group, e] = find(now, now.system.solid_seat, entity.index);
    if (group == nullptr) continue;
    s.solids.push_back({model.solids.id[at(entity.index)], model.parts[at(group->part)].id, point(*group, e, 0, now),
                        now.strains.solid(at(entity.index))});
  }
  for (const model::NamedEntity& entity : model.requests.history_beams) {
    const auto [group, e] = find(now, now.system.beam_seat, entity.index);
    if (group != nullptr) s.beams.push_back(beam(now, entity.index, *group, e));
  }
  for (const model::NamedEntity& entity : model.requests.history_shells) {
    const auto [group, e] = find(now, now.system.shell_seat, entity.index);
    if (group == nullptr) continue;
    output::EloutShell shell;
    shell.id = model.shells.id[at(entity.index)];
    shell.part = model.parts[at(group->part)].id;
    for (int k = 0; k < group->layers(); ++k) shell.layers.push_back(point(*group, e, k, now));
    const Strains::Faces faces = now.strains.shell(at(entity.index), now.state);
    shell.lower_strain = faces.lower;
    shell.upper_strain = faces.upper;
    s.shells.push_back(std::move(shell));
  }
  return s;
}

}  // namespace nugget::impact
