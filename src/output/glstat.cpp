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

}  // namespace

Glstat::Glstat(std::filesystem::path path, const Header& header) : file_(std::move(path), header) {}

void Glstat::write(const GlstatState& s) {
  file_.print("\n\n dt of cycle{:8} is controlled by ", s.cycle);
  if (s.controlling)
    file_.print("{:<10}{:10} of part{:10}\n\n", name(s.controlling->kind), s.controlling->element, s.controlling->part);
  else
    file_.print("load curve\n\n");

  quantity(file_, "time", s.time);
  quantity(file_, "time step", s.time_step);
  quantity(file_, "kinetic energy", s.kinetic);
  quantity(file_, "internal energy", s.internal);
  for (std::size_t i = 0; i < s.walls.size(); ++i)
    file_.print(" {:.<31}{:14.5E} wall#{:2}\n", "stonewall energy", column(s.walls[i]), i + 1);
  quantity(file_, "spring and damper energy", s.spring_and_damper);
  quantity(file_, "joint internal energy", s.joint);
  quantity(file_, "hourglass energy ", s.hourglass);
  quantity(file_, "system damping energy", s.system_damping);
  quantity(file_, "sliding interface energy", s.sliding_interface);
  quantity(file_, "external work", s.external_work);
  quantity(file_, "eroded kinetic energy", s.eroded_kinetic);
  quantity(file_, "eroded internal energy", s.eroded_internal);
  quantity(file_, "eroded hourglass energy", s.eroded_hourglass);
  quantity(file_, "total energy", s.total);
  quantity(file_, "total energy / initial energy", s.ratio);
  quantity(file_, "energy ratio w/o eroded energy", s.ratio_without_eroded);
  quantity(file_, "global x velocity", s.velocity.x);
  quantity(file_, "global y velocity", s.velocity.y);
  quantity(file_, "global z velocity", s.velocity.z);
  count(file_, "number of nodes", s.nodes);
  count(file_, "number of elements", s.elements);
  count(file_, "time per zone cycle.(nanosec)", s.nanoseconds_per_element_cycle);
  if (s.added_mass) file_.print("\n\n");
  quantity(file_, "added mass", s.added_mass);
  quantity(file_, "percentage increase", s.percent_increase);
  file_.end_state();
}

}  // namespace nugget::output
