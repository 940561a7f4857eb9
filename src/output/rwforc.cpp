// SPDX-License-Identifier: Apache-2.0
#include "output/rwforc.hpp"

#include <fmt/format.h>

#include <numeric>

namespace nugget::output {
namespace {

constexpr const char* wall_heading =
    "\n\n    time       wall#   normal-force    x-force        y-force        z-force\n";
constexpr const char* wall_row =
    "{time:12.5E}{id:8}{normal_force:15.6E}{x_force:15.6E}{y_force:15.6E}{z_force:15.6E}\n";
constexpr const char* transducer_heading =
    "\n\n\nr i g i d   w a l l   n o d e   s e t   f o r c e   s u m m a t i o n s\n"
    "f o r   t i m e   s t e p {:9}   ( at time {:12.5E} )\n\n"
    "    time       wall #   transducer node set #    x-force      y-force      z-force\n";

Vec3d total(const WallAreas& areas) {
  Vec3d sum;
  for (const Vec3d& force : areas.forces) sum += force;
  return sum;
}

/// The heading stands before the first state, and before each where transducers stand between them.
void print(AsciiFile& file, const RwforcState& state) {
  if (!state.transducers.empty() && state.time > 0.0) file.print("{}", wall_heading);
  for (std::size_t w = 0; w < state.rows.size(); ++w) {
    const RwforcRow& row = state.rows[w];
    file.print_text(fmt::format(fmt::runtime(wall_row), fmt::arg("time", column(state.time)), fmt::arg("id", row.wall),
                                fmt::arg("normal_force", column(row.normal)), fmt::arg("x_force", column(row.force.x)),
                                fmt::arg("y_force", column(row.force.y)), fmt::arg("z_force", column(row.force.z))));
    for (const WallAreas& areas : state.areas) {
      if (areas.wall != w) continue;
      file.print("                seg#    \n");
      int number = 0;
      for (const Vec3d& f : areas.forces)
        file.print("            {:8}               {:15.6E}{:15.6E}{:15.6E}\n", ++number, column(f.x), column(f.y),
                   column(f.z));
      const Vec3d sum = total(areas);
      file.print("  total force                      {:15.6E}{:15.6E}{:15.6E}\n", column(sum.x), column(sum.y),
                 column(sum.z));
    }
  }
  if (state.transducers.empty()) return;
  file.print(transducer_heading, state.cycle, column(state.time));
  for (const WallTransducerRow& t : state.transducers)
    file.print("{:12.5E} {:10} {:10} {:10} {:12.5E} {:12.5E} {:12.5E}\n", column(state.time), t.wall, t.id, t.set,
               column(t.force.x), column(t.force.y), column(t.force.z));
  file.print("\n\n");
}

bool has_transducers(const RwforcState& state) {
  return !state.transducers.empty();
}

HistoryFormat<RwforcState> walls_and_transducers() {
  return {
      .branches = {{
                       .path = "rwforc/forces",
                       .ids = ids(&RwforcState::rows, &RwforcRow::wall),
                       .once = columns(&RwforcState::rows,
                                       {{"setid", &RwforcRow::wall, dimension::number, "id of the wall again"}}),
                       .columns =
                           columns(&RwforcState::rows,
                                   {
                                       {"time", &RwforcState::time, dimension::time, "time"},
                                       {"normal_force", &RwforcRow::normal, dimension::force,
                                        "force of a wall along its normal"},
                                       {"*_force", &RwforcRow::force, dimension::force, "force of a wall on the model"},
                                   }),
                   },
                   {
                       .path = "rwforc/transducer",
                       .ids = ids(&RwforcState::transducers, &WallTransducerRow::id),
                       .once = columns(&RwforcState::transducers,
                                       {{"nodeset", &WallTransducerRow::set, dimension::number, "node set"},
                                        {"rigidwall", &WallTransducerRow::wall, dimension::number, "wall"}}),
                       .columns = columns(&RwforcState::transducers,
                                          {{"time", &RwforcState::time, dimension::time, "time"},
                                           {"cycle", &RwforcState::cycle, dimension::number, "cycle"},
                                           {"*_force", &WallTransducerRow::force, dimension::force,
                                            "force of the wall on the nodes of the set"}}),
                       .written = has_transducers,
                   }},
      .legend = LegendLines::titles,
      .heading = wall_heading,
      .lines = {.head = "", .row = wall_row, .tail = ""},  // as the reader finds a wall's
      .print = print,
  };
}

}  // namespace

const HistoryFormat<RwforcState>& rwforc() {
  static const HistoryFormat<RwforcState> format = walls_and_transducers();
  return format;
}

HistoryFormat<RwforcState> rwforc_with_areas(const std::vector<std::size_t>& walls) {
  HistoryFormat<RwforcState> format = walls_and_transducers();
  for (const std::size_t wall : walls) {
    const auto of_wall = [wall](const RwforcState& state) {
      for (const WallAreas& areas : state.areas)
        if (areas.wall == wall) return areas;
      return WallAreas{wall, {}};
    };
    const auto add = [](Columns<RwforcState>& columns, std::string name, Dimension dimension, std::string_view meaning,
                        bool of_rows, std::function<Values(const RwforcState&)> values) {
      columns.push_back({std::move(name), dimension, meaning, of_rows, std::move(values)});
    };
    Branch<RwforcState> branch;
    branch.path = fmt::format("rwforc/wall{:03}", wall + 1);
    branch.ids = [of_wall](const RwforcState& state) {
      std::vector<int> numbers(of_wall(state).forces.size());
      std::iota(numbers.begin(), numbers.end(), 1);
      return numbers;
    };
    add(branch.columns, "time", dimension::time, "time", false,
        [](const RwforcState& state) -> Values { return std::vector{state.time}; });
    for (int i = 0; i < 3; ++i) {
      add(branch.columns, component_name("*_force", i, 3), dimension::force, "force on an area of the wall", true,
          [of_wall, i](const RwforcState& state) -> Values {
            std::vector<double> all;
            for (const Vec3d& force : of_wall(state).forces) all.push_back(component(force, i));
            return all;
          });
      add(branch.columns, component_name("total_*", i, 3), dimension::force, "force on all of its areas", false,
          [of_wall, i](const RwforcState& state) -> Values {
            return std::vector{component(total(of_wall(state)), i)};
          });
    }
    format.branches.push_back(std::move(branch));
  }
  return format;
}

}  // namespace nugget::output
