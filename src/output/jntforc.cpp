// SPDX-License-Identifier: Apache-2.0
#include "output/jntforc.hpp"

namespace nugget::output {

namespace {

/// What LS-DYNA calls the numbers of one axis.
struct AxisNames {
  const char *place, *rate, *stiffness, *damping, *total;
};
using StiffnessNames = std::array<AxisNames, 3>;
constexpr StiffnessNames of_displacements{
    {{"x-displacement", "d(dispx)/dt", "force-x-stiffness", "force-x-damping", "force-x-total"},
     {"y-displacement", "d(dispy)/dt", "force-y-stiffness", "force-y-damping", "force-y-total"},
     {"z-displacement", "d(dispz)/dt", "force-z-stiffness", "force-z-damping", "force-z-total"}}};
constexpr StiffnessNames of_rotations{
    {{"phi (degrees)", "d(phi)/dt (degrees)", "phi moment-stiffness", "phi moment-damping", "phi moment-total"},
     {"theta (degrees)", "d(theta)/dt (degrees)", "theta-moment-stiffness", "theta-moment-damping",
      "theta-moment-total"},
     {"psi (degrees)", "d(psi)/dt (degrees)", "psi-moment-stiffness", "psi-moment-damping", "psi-moment-total"}}};

}  // namespace

Jntforc::Jntforc(std::filesystem::path path, const Header& header, std::span<const LegendEntry> legend)
    : file_(std::move(path), header, legend_lines(legend)) {}

void Jntforc::write(const JntforcState& state) {
  const auto quantity = [&](const char* name, double value) { file_.print(" {:.<29}{:14.5E}\n", name, column(value)); };
  file_.print("\n {:.<29}{:14.5E}\n", "time", column(state.time));
  for (const JntforcRow& r : state.rows) {
    file_.print(" {:.<29}{:10}\n", "joint ID", r.joint);
    quantity("x-force", r.force.x);
    quantity("y-force", r.force.y);
    quantity("z-force", r.force.z);
    quantity("x-moment", r.moment.x);
    quantity("y-moment", r.moment.y);
    quantity("z-moment", r.moment.z);
    quantity("resultant force", norm(r.force));
    quantity("resultant moment", norm(r.moment));
  }
  const auto stiffness = [&](const JntforcStiffness& s, const StiffnessNames& names) {
    file_.print(" {:.<29}{:10}\n", "joint stiffness id number", s.id);
    for (std::size_t i = 0; i < 3; ++i) {
      quantity(names[i].place, s.axis[i].place);
      quantity(names[i].rate, s.axis[i].rate);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      quantity(names[i].stiffness, s.axis[i].stiffness);
      quantity(names[i].damping, s.axis[i].damping);
      quantity(names[i].total, s.axis[i].stiffness + s.axis[i].damping);
    }
    quantity("joint energy", s.energy);
  };
  for (const JntforcStiffness& s : state.displacements) stiffness(s, of_displacements);
  for (const JntforcStiffness& s : state.rotations) stiffness(s, of_rotations);
  file_.end_state();
}

}  // namespace nugget::output
