// SPDX-License-Identifier: Apache-2.0
#include "output/rbdout.hpp"

namespace nugget::output {
namespace {

void vector(AsciiFile& file, const Vec3d& v) {
  file.print("{:12.4E}{:12.4E}{:12.4E}", column(v.x), column(v.y), column(v.z));
}

void motion(AsciiFile& file, const char* name, const Vec3d& translation, const Vec3d& rotation) {
  file.print("{:>14}:  ", name);
  vector(file, translation);
  vector(file, rotation);
  file.print("\n");
}

void direction_row(AsciiFile& file, int number, double a, double b, double c) {
  file.print("     row {}{:15.4E}{:15.4E}{:15.4E}\n", number, column(a), column(b), column(c));
}

void body(AsciiFile& file, const char* kind, const RbdoutRow& row) {
  file.print("\n {}{:8}\n", kind, row.id);
  file.print("   global             x           y           z          x-rot       y-rot       z-rot\n");
  file.print("   coordinates:  ");
  vector(file, row.coordinate);
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

}  // namespace

Rbdout::Rbdout(std::filesystem::path path, const Header& header) : file_(std::move(path), header) {}

void Rbdout::write(const RbdoutState& state) {
  file_.print("1\n\n  r i g i d   b o d y   m o t i o n   a t  cycle={:8}    time={:15.6E}\n", state.cycle,
              column(state.time));
  for (const RbdoutRow& row : state.parts) body(file_, "rigid body", row);
  for (const RbdoutRow& row : state.nodal) body(file_, "nodal rigid body", row);
  file_.end_state();
}

}  // namespace nugget::output
