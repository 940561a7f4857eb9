// SPDX-License-Identifier: Apache-2.0
#include "output/glstat.hpp"

namespace nugget::output {
namespace {

const char* name(ElementKind kind) {
  switch (kind) {
    case ElementKind::solid: return "solid";
    case ElementKind::beam: return "beam";
    case ElementKind::shell: return "shell";
    case ElementKind::thick_shell: return "thk shell";
    case ElementKind::discrete: return "discrete";
  }
  return "";
}

/// ` name.....................   value`: names fill 32 columns with dots.
void quantity(AsciiFile& file, const char* name, double value) {
  file.print(" {:.<31}{:14.5E}\n", name, column(value));
}

void quantity(AsciiFile& file, const char* name, const std::optional<double>& value) {
  if (value) quantity(file, name, *value);
}

void count(AsciiFile& file, const char* name, const std::optional<int>& value) {
  if (value) file.print(" {:.<31}{:14}\n", name, *value);
}

/// What of the controlling element; nothing where the step comes from a load curve.
template <int (*what)(const ControllingElement&)>
std::optional<int> controlling(const GlstatState& s) {
  return s.controlling ? std::optional(what(*s.controlling)) : std::nullopt;
}
/// LS-DYNA counts element types from 1, in the order of glstat/metadata/element_types.
int kind(const ControllingElement& e) {
  return static_cast<int>(e.kind) + 1;
}
int element(const ControllingElement& e) {
  return e.element;
}
int part(const ControllingElement& e) {
  return e.part;
}

Values walls(const GlstatState& s) {
  return s.walls.empty() ? Values{} : Values{s.walls};
}

void print(AsciiFile& file, const GlstatState& s) {
  file.print("\n\n dt of cycle{:8} is controlled by ", s.cycle);
  if (s.controlling)
    file.print("{:<10}{:10} of part{:10}\n\n", name(s.controlling->kind), s.controlling->element, s.controlling->part);
  else
    file.print("load curve\n\n");

  quantity(file, "time", s.time);
  quantity(file, "time step", s.time_step);
  quantity(file, "kinetic energy", s.kinetic);
  quantity(file, "internal energy", s.internal);
  for (std::size_t i = 0; i < s.walls.size(); ++i)
    file.print(" {:.<31}{:14.5E} wall#{:2}\n", "stonewall energy", column(s.walls[i]), i + 1);
  quantity(file, "spring and damper energy", s.spring_and_damper);
  quantity(file, "joint internal energy", s.joint);
  quantity(file, "hourglass energy ", s.hourglass);
  quantity(file, "system damping energy", s.system_damping);
  quantity(file, "sliding interface energy", s.sliding_interface);
  quantity(file, "external work", s.external_work);
  quantity(file, "eroded kinetic energy", s.eroded_kinetic);
  quantity(file, "eroded internal energy", s.eroded_internal);
  quantity(file, "eroded hourglass energy", s.eroded_hourglass);
  quantity(file, "total energy", s.total);
  quantity(file, "total energy / initial energy", s.ratio);
  quantity(file, "energy ratio w/o eroded energy", s.ratio_without_eroded);
  quantity(file, "global x velocity", s.velocity.x);
  quantity(file, "global y velocity", s.velocity.y);
  quantity(file, "global z velocity", s.velocity.z);
  count(file, "number of nodes", s.nodes);
  count(file, "number of elements", s.elements);
  count(file, "time per zone cycle.(nanosec)", s.nanoseconds_per_element_cycle);
  if (s.added_mass) file.print("\n\n");
  quantity(file, "added mass", s.added_mass);
  quantity(file, "percentage increase", s.percent_increase);
}

}  // namespace

const HistoryFormat<GlstatState>& glstat() {
  static const HistoryFormat<GlstatState> format{
      .branches = {{
          .path = "glstat",
          .once = columns<GlstatState>(
              {{"element_types", [](const GlstatState&) { return "solid,beam,shell,thick shell,discrete"; },
                dimension::number, "names of ts_eltype, from 1"}}),
          .columns = columns<GlstatState>({
              {"cycle", &GlstatState::cycle, dimension::number, "number of the cycle, from 1"},
              {"ts_eltype", controlling<kind>, dimension::number, "kind of the element that controls the step"},
              {"ts_element", controlling<element>, dimension::number, "id of the element that controls the step"},
              {"ts_part", controlling<part>, dimension::number, "id of its part"},
              {"time", &GlstatState::time, dimension::time, "time"},
              {"time_step", &GlstatState::time_step, dimension::time, "time step"},
              {"kinetic_energy", &GlstatState::kinetic, dimension::energy, "kinetic energy"},
              {"internal_energy", &GlstatState::internal, dimension::energy, "internal energy"},
              {"stonewall_energy", walls, dimension::energy, "energy that each rigid wall has taken"},
              {"spring_and_damper_energy", &GlstatState::spring_and_damper, dimension::energy,
               "part of the internal energy in springs and dampers"},
              {"joint_internal_energy", &GlstatState::joint, dimension::energy,
               "part of the internal energy in joints"},
              {"hourglass_energy", &GlstatState::hourglass, dimension::energy, "hourglass energy"},
              {"system_damping_energy", &GlstatState::system_damping, dimension::energy, "energy lost to damping"},
              {"sliding_interface_energy", &GlstatState::sliding_interface, dimension::energy, "energy of contacts"},
              {"external_work", &GlstatState::external_work, dimension::energy, "work of loads and prescribed motions"},
              {"eroded_kinetic_energy", &GlstatState::eroded_kinetic, dimension::energy,
               "kinetic energy of deleted elements"},
              {"eroded_internal_energy", &GlstatState::eroded_internal, dimension::energy,
               "internal energy of deleted elements"},
              {"eroded_hourglass_energy", &GlstatState::eroded_hourglass, dimension::energy,
               "hourglass energy of deleted elements"},
              {"total_energy", &GlstatState::total, dimension::energy, "sum of all"},
              {"energy_ratio", &GlstatState::ratio, dimension::number,
               "total energy over initial energy and external work"},
              {"energy_ratio_wo_eroded", &GlstatState::ratio_without_eroded, dimension::number,
               "the same without deleted elements"},
              {"global_*_velocity", &GlstatState::velocity, dimension::velocity, "velocity of the centre of mass"},
              {"number_of_nodes", &GlstatState::nodes, dimension::number, "number of nodes"},
              {"number_of_elements", &GlstatState::elements, dimension::number, "number of elements"},
              {"nzc", &GlstatState::nanoseconds_per_element_cycle, dimension::number, "always 0: no clock in results"},
              {"added_mass", &GlstatState::added_mass, dimension::mass, "by mass scaling"},
              {"percent_increase", &GlstatState::percent_increase, dimension::number,
               "added mass in percent of the physical mass"},
          }),
      }},
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
