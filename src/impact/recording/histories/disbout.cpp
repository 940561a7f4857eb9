// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/index.hpp"
#include "impact/recording/element_histories.hpp"
#include "impact/recording/histories.hpp"

namespace nugget::impact {
namespace {

/// A discrete beam: motion of node 2 relative to node 1, forces on node 2, and the axes in which both stand.
struct DiscreteBeamRow {
  int id = 0, part = 0, material_type = 0;
  std::array<double, 6> displacement{};  ///< along r, s, t [length], about them [radian]
  std::array<double, 6> resultant{};     ///< likewise [force, moment]
  Frame3d axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};
struct DisboutState {
  long cycle = 0;
  double time = 0.0;
  std::vector<DiscreteBeamRow> rows;  ///< the same beams in the same order in every state
};

void print(output::AsciiFile& file, const DisboutState& state) {
  const auto line = [&file](const char* head, std::initializer_list<double> values) {
    file.print("{}\n           ", head);
    for (const double value : values) file.print("{:11.3E}", output::column(value));
    file.print("\n");
  };
  const auto six = [&line](const char* head, const std::array<double, 6>& v) {
    line(head, {v[0], v[1], v[2], v[3], v[4], v[5]});
  };
  const auto direction = [&line](const char* head, const Vec3d& v) { line(head, {v.x, v.y, v.z}); };
  file.print("\n d i s c r e t e  b e a m  o u t p u t  f o r   t i m e  s t e p{:9}   ( at time{:12.5E} )\n\n",
             state.cycle, output::column(state.time));
  for (const DiscreteBeamRow& r : state.rows) {
    file.print(" beam/truss # ={:8}      part ID  ={:10}      material type={:8}\n", r.id, r.part, r.material_type);
    six(" relative displ. axial   normal-s   normal-t  axial rot rotation-s rotation-t", r.displacement);
    six(" local resultant axial   normal-s   normal-t    torsion   moment-s  moment-t", r.resultant);
    direction(" axial direction     x          y          z", r.axes.e1);
    direction(" s direction         x          y          z", r.axes.e2);
    direction(" t direction         x          y          z", r.axes.e3);
    file.print("\n");
  }
}

template <std::array<double, 6> DiscreteBeamRow::*values, std::size_t i>
double component_of(const DiscreteBeamRow& row) {
  return (row.*values)[i];
}

const output::HistoryFormat<DisboutState>& disbout() {
  constexpr auto u = &DiscreteBeamRow::displacement;
  constexpr auto f = &DiscreteBeamRow::resultant;
  static const output::HistoryFormat<DisboutState> format{
      .branches = {{
          .path = "disbout",
          .columns = output::columns(
              &DisboutState::rows,
              {
                  {"time", &DisboutState::time, dimension::time, "time"},
                  {"cycle", &DisboutState::cycle, dimension::number, "number of the cycle, from 1"},
                  {"nelb", &DiscreteBeamRow::id, dimension::number, "id of the beam"},
                  {"matid", &DiscreteBeamRow::part, dimension::number, "id of its part"},
                  {"mtype", &DiscreteBeamRow::material_type, dimension::number, "LS-DYNA's number of its law"},
                  {"r_dis_axial", component_of<u, 0>, dimension::length, "displacement of node 2 from node 1 along r"},
                  {"r_dis_ns", component_of<u, 1>, dimension::length, "the same along s"},
                  {"r_dis_nt", component_of<u, 2>, dimension::length, "the same along t"},
                  {"axial_rot", component_of<u, 3>, dimension::angle, "rotation of node 2 from node 1 about r"},
                  {"rot_s", component_of<u, 4>, dimension::angle, "the same about s"},
                  {"rot_t", component_of<u, 5>, dimension::angle, "the same about t"},
                  {"rslt_axial", component_of<f, 0>, dimension::force, "force along r, positive in tension"},
                  {"rslt_ns", component_of<f, 1>, dimension::force, "force along s"},
                  {"rslt_nt", component_of<f, 2>, dimension::force, "force along t"},
                  {"torsion", component_of<f, 3>, dimension::moment, "moment about r"},
                  {"moment_s", component_of<f, 4>, dimension::moment, "moment about s"},
                  {"moment_t", component_of<f, 5>, dimension::moment, "moment about t"},
                  {"axial_*", [](const DiscreteBeamRow& r) { return r.axes.e1; }, dimension::number, "r, global axes"},
                  {"s_dir_*", [](const DiscreteBeamRow& r) { return r.axes.e2; }, dimension::number, "s, global axes"},
                  {"t_dir_*", [](const DiscreteBeamRow& r) { return r.axes.e3; }, dimension::number, "t, global axes"},
              }),
      }},
      .print = print,
  };
  return format;
}

/// A discrete beam that *DATABASE_HISTORY_BEAM names; null: another beam.
const system::ElementGroup* group_of(const system::System& system, model::Index beam) {
  const system::System::ElementLocation location = system.beam_location[beam];
  if (location.group < 0) return nullptr;
  const system::ElementGroup* group = system.groups[location.group].get();
  const model::Model& model = system.model;
  const model::Material& material = model.materials[model.parts[group->part].material];
  return std::holds_alternative<kernel::DiscreteBeam>(material.law) ? group : nullptr;
}

DisboutState disbout_state(const Snapshot& now) {
  const model::Model& model = now.system.model;
  DisboutState s{now.state.cycle + 1, now.state.time, {}};  // LS-DYNA counts from 1
  for (const model::NamedEntity& entity : model.requests.history_beams) {
    const system::ElementGroup* group = group_of(now.system, entity.index);
    if (group == nullptr) continue;
    const model::Part& part = model.parts[group->part];
    DiscreteBeamRow row{model.beams.id[entity.index], part.id, number_of_law(model.materials[part.material])};
    const auto e = at(now.system.beam_location[entity.index].element);
    row.displacement = group->displacements(e);
    if (group->alive(e)) std::copy_n(group->resultants(e).begin(), 6, row.resultant.begin());
    row.axes = group->axes(e, now.state).value_or(row.axes);
    s.rows.push_back(row);
  }
  return s;
}

}  // namespace

template <>
HistoryFile history<"disbout">() {
  return make_history(disbout(), disbout_state, {.concerns = [](const system::System& system) {
                        return std::ranges::any_of(
                            system.model.requests.history_beams,
                            [&](const model::NamedEntity& e) { return group_of(system, e.index) != nullptr; });
                      }});
}

}  // namespace nugget::impact
