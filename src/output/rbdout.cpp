// SPDX-License-Identifier: Apache-2.0
#include "output/rbdout.hpp"

namespace nugget::output {
namespace {

void motion(AsciiFile& file, const char* name, const Vec3d& translation, const Vec3d& rotation) {
  file.print("{:>14}:  ", name);
  file.print_vector(translation);
  file.print_vector(rotation);
  file.print("\n");
}

void direction_row(AsciiFile& file, int number, double a, double b, double c) {
  file.print("     row {}{:15.4E}{:15.4E}{:15.4E}\n", number, column(a), column(b), column(c));
}

void body(AsciiFile& file, const char* kind, const RbdoutRow& row) {
  file.print("\n {}{:8}\n", kind, row.id);
  file.print("   global             x           y           z          x-rot       y-rot       z-rot\n");
  file.print("   coordinates:  ");
  file.print_vector(row.coordinate);
  file.print("\n");
  motion(file, "displacements", row.displacement, row.rotation);
  motion(file, "velocities", row.velocity, row.angular_velocity);
  motion(file, "accelerations", row.acceleration, row.angular_acceleration);

  const Frame3d& axes = row.axes;
  file.print("\nprincipal or user defined local coordinate direction vectors\n");
  file.print("                     a           b           c\n");
  direction_row(file, 1, axes.e1.x, axes.e2.x, axes.e3.x);
  direction_row(file, 2, axes.e1.y, axes.e2.y, axes.e3.y);
  direction_row(file, 3, axes.e1.z, axes.e2.z, axes.e3.z);
  file.print("\n output in principal or user defined local coordinate directions\n");
  file.print("                      a           b           c          a-rot       b-rot       c-rot\n");
  motion(file, "displacements", axes.local(row.displacement), axes.local(row.rotation));
  motion(file, "velocities", axes.local(row.velocity), axes.local(row.angular_velocity));
  motion(file, "accelerations", axes.local(row.acceleration), axes.local(row.angular_acceleration));
}

/// Rigid parts, then nodal rigid bodies.
std::vector<RbdoutRow> bodies(const RbdoutState& s) {
  std::vector<RbdoutRow> all = s.parts;
  all.insert(all.end(), s.nodal.begin(), s.nodal.end());
  return all;
}

template <Vec3d RbdoutRow::*vector>
Vec3d local(const RbdoutRow& row) {
  return row.axes.local(row.*vector);
}

void print(AsciiFile& file, const RbdoutState& state) {
  file.print("1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle={:8}    time={:15.6E}\n", state.cycle,
             column(state.time));
  for (const RbdoutRow& row : state.parts) body(file, "rigid body", row);
  for (const RbdoutRow& row : state.nodal) body(file, "nodal rigid body", row);
}

}  // namespace

const HistoryFormat<RbdoutState>& rbdout() {
  static const HistoryFormat<RbdoutState> format{
      .branches = {{
          .path = "rbdout",
          .ids =
              [](const RbdoutState& s) {
                std::vector<int> all;
                for (const RbdoutRow& r : bodies(s)) all.push_back(r.id);
                return all;
              },
          .once =
              columns<RbdoutState>({{"num_nodal", [](const RbdoutState& s) { return static_cast<int>(s.nodal.size()); },
                                     dimension::number, "how many of the bodies, at the end, are nodal rigid bodies"}}),
          .columns = columns(
              bodies,
              {
                  {"time", &RbdoutState::time, dimension::time, "time"},
                  {"cycle", &RbdoutState::cycle, dimension::number, "number of the cycle, from 1"},
                  {"global_*", &RbdoutRow::coordinate, dimension::length, "centre of mass of a body now"},
                  {"global_d*", &RbdoutRow::displacement, dimension::length, "displacement"},
                  {"global_rd*", &RbdoutRow::rotation, dimension::angle, "rotation"},
                  {"global_v*", &RbdoutRow::velocity, dimension::velocity, "velocity"},
                  {"global_rv*", &RbdoutRow::angular_velocity, dimension::rate, "angular velocity"},
                  {"global_a*", &RbdoutRow::acceleration, dimension::acceleration, "acceleration"},
                  {"global_ra*", &RbdoutRow::angular_acceleration, dimension::angular_acceleration,
                   "angular acceleration"},
                  {"local_d*", local<&RbdoutRow::displacement>, dimension::length, "displacement in the body's axes"},
                  {"local_rd*", local<&RbdoutRow::rotation>, dimension::angle, "rotation in the body's axes"},
                  {"local_v*", local<&RbdoutRow::velocity>, dimension::velocity, "velocity in the body's axes"},
                  {"local_rv*", local<&RbdoutRow::angular_velocity>, dimension::rate,
                   "angular velocity in the body's axes"},
                  {"local_a*", local<&RbdoutRow::acceleration>, dimension::acceleration,
                   "acceleration in the body's axes"},
                  {"local_ra*", local<&RbdoutRow::angular_acceleration>, dimension::angular_acceleration,
                   "angular acceleration in the body's axes"},
                  {"dircos_#1", [](const RbdoutRow& r) { return r.axes.e1; }, dimension::number,
                   "direction of the axis a now"},
                  {"dircos_#2", [](const RbdoutRow& r) { return r.axes.e2; }, dimension::number,
                   "direction of the axis b now"},
                  {"dircos_#3", [](const RbdoutRow& r) { return r.axes.e3; }, dimension::number,
                   "direction of the axis c now"},
              }),
      }},
      .print = print,
  };
  return format;
}

}  // namespace nugget::output
