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

// The sixteen numbers of a joint stiffness in binout: the names are LS-DYNA's, which has rotations of
// _GENERALIZED under those of _FLEXION-TORSION (LSTC's l2a.c tells what they mean).
using BinoutNames = std::array<std::string_view, 16>;
constexpr BinoutNames names_of_displacements{"phi_degrees",          "d(phi)_dt",
                                             "theta_degrees",        "d(theta)_dt",
                                             "psi_degrees",          "d(psi)_dt",
                                             "phi_moment_stiffness", "phi_moment_damping",
                                             "phi_moment_total",     "theta_moment_stiffness",
                                             "theta_moment_damping", "theta_moment_total",
                                             "psi_moment_stiffness", "psi_moment_damping",
                                             "psi_moment_total",     "joint_energy"};
constexpr BinoutNames names_of_rotations{
    "alpha_degrees",      "d(alpha)_dt",        "gamma_degrees",          "d(gamma)_dt",
    "beta_degrees",       "d(beta)_dt",         "alpha_moment_stiffness", "alpha_moment_damping",
    "alpha_moment_total", "gamma_scale_factor", "beta_moment_stiffness",  "beta_moment_damping",
    "beta_moment_total",  "joint_energy",       "joint_extra1",           "joint_extra2"};

template <std::size_t axis>
double place(const JntforcStiffness& s) {
  return s.axis[axis].place;
}
template <std::size_t axis>
double rate(const JntforcStiffness& s) {
  return s.axis[axis].rate;
}
template <std::size_t axis>
double stiffness(const JntforcStiffness& s) {
  return s.axis[axis].stiffness;
}
template <std::size_t axis>
double damping(const JntforcStiffness& s) {
  return s.axis[axis].damping;
}
template <std::size_t axis>
double total(const JntforcStiffness& s) {
  return s.axis[axis].stiffness + s.axis[axis].damping;
}

struct StiffnessDimensions {
  Dimension place, rate, resistance;
};
Columns<JntforcState> stiffness_columns(std::vector<JntforcStiffness> JntforcState::*rows, const BinoutNames& name,
                                        const StiffnessDimensions& of) {
  return columns(rows, {
                           {"time", &JntforcState::time, dimension::time, "time"},
                           {name[0], place<0>, of.place, "place on the first axis"},
                           {name[1], rate<0>, of.rate, "its rate"},
                           {name[2], place<1>, of.place, "place on the second axis"},
                           {name[3], rate<1>, of.rate, "its rate"},
                           {name[4], place<2>, of.place, "place on the third axis"},
                           {name[5], rate<2>, of.rate, "its rate"},
                           {name[6], stiffness<0>, of.resistance, "first axis: of springs, friction and stops"},
                           {name[7], damping<0>, of.resistance, "first axis: of dampers"},
                           {name[8], total<0>, of.resistance, "first axis: both"},
                           {name[9], stiffness<1>, of.resistance, "second axis: of springs, friction and stops"},
                           {name[10], damping<1>, of.resistance, "second axis: of dampers"},
                           {name[11], total<1>, of.resistance, "second axis: both"},
                           {name[12], stiffness<2>, of.resistance, "third axis: of springs, friction and stops"},
                           {name[13], damping<2>, of.resistance, "third axis: of dampers"},
                           {name[14], total<2>, of.resistance, "third axis: both"},
                           {name[15], &JntforcStiffness::energy, dimension::energy, "energy of the joint stiffness"},
                       });
}

void print(AsciiFile& file, const JntforcState& state) {
  const auto quantity = [&](const char* name, double value) { file.print(" {:.<29}{:14.5E}\n", name, column(value)); };
  file.print("\n {:.<29}{:14.5E}\n", "time", column(state.time));
  for (const JntforcRow& r : state.rows) {
    file.print(" {:.<29}{:10}\n", "joint ID", r.joint);
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
    file.print(" {:.<29}{:10}\n", "joint stiffness id number", s.id);
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
}

}  // namespace

const HistoryFormat<JntforcState>& jntforc() {
  static const HistoryFormat<JntforcState> format{
      .branches =
          {
              {.path = "jntforc/type0",
               .ids = ids(&JntforcState::displacements, &JntforcStiffness::id),
               .columns = stiffness_columns(&JntforcState::displacements, names_of_displacements,
                                            {dimension::length, dimension::velocity, dimension::force}),
               .written = [](const JntforcState& s) { return !s.displacements.empty(); }},
              {.path = "jntforc/type1",
               .ids = ids(&JntforcState::rotations, &JntforcStiffness::id),
               .columns = stiffness_columns(&JntforcState::rotations, names_of_rotations,
                                            {dimension::angle, dimension::rate, dimension::moment}),
               .written = [](const JntforcState& s) { return !s.rotations.empty(); }},
              {.path = "jntforc/joints",
               .ids = ids(&JntforcState::rows, &JntforcRow::joint),
               .once = columns(&JntforcState::rows,
                               {{"local", &JntforcRow::local, dimension::number, "1: in the axes that _LOCAL names"}}),
               .columns = columns(
                   &JntforcState::rows,
                   {
                       {"time", &JntforcState::time, dimension::time, "time"},
                       {"*_force", &JntforcRow::force, dimension::force, "force of a joint on its second body"},
                       {"*_moment", &JntforcRow::moment, dimension::moment, "moment of a joint on its second body"},
                       {"resultant_force", [](const JntforcRow& r) { return norm(r.force); }, dimension::force,
                        "size of the force"},
                       {"resultant_moment", [](const JntforcRow& r) { return norm(r.moment); }, dimension::moment,
                        "size of the moment"},
                       {"energy", &JntforcRow::energy, dimension::energy, "stored and lost in the joint"},
                   }),
               .written = [](const JntforcState& s) { return !s.rows.empty(); }},
          },
      .legend = LegendLines::titles,
      .print = print,
      .tables_apart = true,
  };
  return format;
}

}  // namespace nugget::output
