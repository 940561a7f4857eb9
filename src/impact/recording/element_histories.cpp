// SPDX-License-Identifier: Apache-2.0
#include "impact/recording/element_histories.hpp"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/index.hpp"
#include "impact/simulation/strains.hpp"
#include "model/history_files.hpp"
#include "output/element_stresses.hpp"

namespace nugget::impact {
namespace {

output::EloutPoint point(const system::ElementGroup& group, std::size_t e, int layer, const Snapshot& now) {
  if (!group.alive(e)) return {};
  const system::ElementGroup::Layer l = output::shown_layer(now.system, group, e, layer, now.state);
  return {l.stress, l.plastic_strain};
}

using output::EloutTable;
using Locations = std::vector<system::System::ElementLocation>;

output::EloutSolid blank_solid(const model::Model& model, model::Index index, const system::ElementGroup& group) {
  output::EloutSolid row;
  row.id = model.solids.id[index];
  row.part = model.parts[group.part].id;
  return row;
}

void fill(const Snapshot& now, const system::ElementGroup& group, std::size_t e, output::EloutSolid& row) {
  const auto turned = [&](const output::Tensor& t) {
    return output::by_cmpflg(now.system.model, group, e, 0, now.state, t);
  };
  row.point = point(group, e, 0, now);
  row.point.stress = turned(row.point.stress);
  row.strain = turned(solid_strain(group, e));
}

output::EloutShell blank_shell(const model::Model& model, int id, const system::ElementGroup& group) {
  output::EloutShell row;
  row.id = id;
  row.part = model.parts[group.part].id;
  row.layers.resize(at(group.layers()));
  return row;
}

void fill_shell(const Snapshot& now, const system::ElementGroup& group, std::size_t e, output::EloutShell& row) {
  const auto turn = [&](output::Tensor& tensor, int layer) {
    if (const auto axes = output::axes_in_elout(now.system, group, e, layer, now.state))
      tensor = output::along(*axes, tensor);
  };
  const std::vector<int> order = output::layers_in_elout(now.system.model, group);
  for (std::size_t i = 0; i < order.size(); ++i) {
    row.layers[i] = point(group, e, order[i], now);
    turn(row.layers[i].stress, order[i]);
  }
  const FaceStrains faces = shell_strains(now.system, group, e, now.state);
  row.lower_strain = faces.lower;
  row.upper_strain = faces.upper;
  turn(row.lower_strain, 0);
  turn(row.upper_strain, group.layers() - 1);
}

/// Layers from the bottom up, in global axes.
void fill_thick_shell(const Snapshot& now, const system::ElementGroup& group, std::size_t e, output::EloutShell& row) {
  for (std::size_t k = 0; k < row.layers.size(); ++k) row.layers[k] = point(group, e, static_cast<int>(k), now);
  const FaceStrains faces = thick_shell_strains(group, e);
  row.lower_strain = faces.lower;
  row.upper_strain = faces.upper;
}

output::EloutBeam blank_beam(const model::Model& model, model::Index index, const system::ElementGroup& group) {
  const model::Part& part = model.parts[group.part];
  output::EloutBeam row;
  row.id = model.beams.id[index];
  row.part = part.id;
  row.material_type = number_of_law(model.materials[part.material]);
  row.points.resize(at(std::min(model.requests.beam_points, group.layers())));
  return row;
}

void fill(const Snapshot& now, const system::ElementGroup& group, std::size_t e, output::EloutBeam& row) {
  if (group.alive(e)) {
    const std::array<double, 8> r = group.resultants(e);
    row.axial = r[0];
    row.shear_s = r[1];
    row.shear_t = r[2];
    row.torsion = r[3];
    row.moment_s = r[4];
    row.moment_t = r[5];
  }
  for (std::size_t k = 0; k < row.points.size(); ++k) {
    const output::EloutPoint p = point(group, e, static_cast<int>(k), now);
    row.points[k] = {p.stress[0], p.stress[3], p.stress[5], p.plastic_strain};
  }
}

void carry(output::EloutSolid& row, system::Parcel& parcel) {
  parcel(&row.point, 1);
  parcel(&row.strain, 1);
}
void carry(output::EloutShell& row, system::Parcel& parcel) {
  parcel(row.layers.data(), row.layers.size());
  parcel(&row.lower_strain, 1);
  parcel(&row.upper_strain, 1);
}
void carry(output::EloutBeam& row, system::Parcel& parcel) {
  for (double* number : {&row.axial, &row.shear_s, &row.shear_t, &row.moment_s, &row.moment_t, &row.torsion})
    parcel(number, 1);
  parcel(row.points.data(), row.points.size());
}

/// Calls visit(entities, locations, list, blank, fill) for the rows of a table.
template <class Visit>
void of_table(const system::System& system, EloutTable table, const Visit& visit) {
  const model::Model& model = system.model;
  const model::Requests& ask = model.requests;
  using Group = const system::ElementGroup&;
  using output::EloutState;
  const auto fill_row = [](const Snapshot& now, Group group, std::size_t e, auto& row) { fill(now, group, e, row); };
  switch (table) {
    case EloutTable::solids:
    case EloutTable::strains_of_solids:
      return visit(
          ask.history_solids, system.solid_location, &EloutState::solids,
          [&model](model::Index i, Group group) { return blank_solid(model, i, group); }, fill_row);
    case EloutTable::beams:
      return visit(
          ask.history_beams, system.beam_location, &EloutState::beams,
          [&model](model::Index i, Group group) { return blank_beam(model, i, group); }, fill_row);
    case EloutTable::shells:
    case EloutTable::strains_of_shells:
      return visit(
          ask.history_shells, system.shell_location, &EloutState::shells,
          [&model](model::Index i, Group group) { return blank_shell(model, model.shells.id[i], group); }, fill_shell);
    case EloutTable::thick_shells:
    case EloutTable::strains_of_thick:
      return visit(
          ask.history_thick_shells, system.solid_location, &EloutState::thick_shells,
          [&model](model::Index i, Group group) { return blank_shell(model, model.solids.id[i], group); },
          fill_thick_shell);
  }
}

/// Places in the list of those entities that have a kernel; those without are not in elout.
std::vector<std::size_t> with_kernel(const std::vector<model::NamedEntity>& entities, const Locations& locations) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < entities.size(); ++i)
    if (locations[entities[i].index].group >= 0) places.push_back(i);
  return places;
}

/// `now`: null: rows stay blank, and no rank gives any.
void pass_table(const system::System& system, const Snapshot* now, EloutTable table, ResultParcels* parcels,
                const output::EloutState& head, const std::function<void(const output::EloutState&)>& take) {
  of_table(system, table,
           [&](const auto& entities, const Locations& locations, auto list, const auto& blank, const auto& fill_row) {
             const std::vector<std::size_t> places = with_kernel(entities, locations);
             const auto location = [&](std::size_t i) { return locations[entities[places[i]].index]; };
             using Row = typename std::decay_t<decltype(head.*list)>::value_type;
             pass_rows<Row>(
                 parcels, places.size(), [&](std::size_t i) { return parcels->owner(location(i)); },
                 [&](std::size_t i) { return blank(entities[places[i]].index, *system.groups[location(i).group]); },
                 [&](std::size_t i, Row& row) {
                   const system::System::ElementLocation here = location(i);
                   fill_row(*now, *system.groups[here.group], at(here.element), row);
                 },
                 [](Row& row, system::Parcel& parcel) { carry(row, parcel); },
                 [&](std::vector<Row> rows) {
                   output::EloutState piece = head;
                   piece.*list = std::move(rows);
                   take(piece);
                 });
           });
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

void EloutRows::set_head(State& s, const Snapshot& now) {
  const model::Model& model = now.system.model;
  s.cycle = now.state.cycle + 1;  // LS-DYNA counts from 1
  s.time = now.state.time;
  s.strains = model.requests.strains;
  s.local_shells = model.requests.shell_axes != model::Requests::ShellAxes::global;
}

void EloutRows::pass(const Snapshot& now, Table table, ResultParcels& parcels, const Take& take) {
  State head;
  set_head(head, now);
  pass_table(now.system, &now, table, &parcels, head, take);
}

void EloutRows::blank(const system::System& system, const Take& take) {
  State head;
  head.strains = system.model.requests.strains;
  for (const Table table : output::elout_tables)
    if (!text_only(table)) pass_table(system, nullptr, table, nullptr, head, take);
}

std::vector<EloutTable> EloutRows::tables(const model::Model& model) {
  constexpr model::HistoryName elout("elout");
  std::vector<Table> tables;
  for (const Table table : output::elout_tables)
    if (!text_only(table) || (model.requests.strains && model.requests[elout].ascii())) tables.push_back(table);
  return tables;
}

output::EloutState elout_state(const Snapshot& now) {
  output::EloutState all;
  EloutRows::set_head(all, now);
  ResultParcels parcels(now.system);
  const auto add = [](auto& to, const auto& rows) { to.insert(to.end(), rows.begin(), rows.end()); };
  for (const EloutTable table : output::elout_tables)
    if (!EloutRows::text_only(table))
      EloutRows::pass(now, table, parcels, [&](const output::EloutState& piece) {
        add(all.solids, piece.solids);
        add(all.beams, piece.beams);
        add(all.shells, piece.shells);
        add(all.thick_shells, piece.thick_shells);
      });
  return all;
}

}  // namespace nugget::impact
