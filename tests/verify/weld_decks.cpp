// SPDX-License-Identifier: Apache-2.0
#include "weld_decks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace nugget::verify {

double WeldData::area() const {
  return 0.25 * std::numbers::pi * diameter * diameter;
}
double WeldData::second_moment() const {
  return area() * diameter * diameter / 16.0;
}

std::string weld_part(int part, const WeldData& w) {
  const double id = part;
  const auto& f = w.strength;
  return "*PART\nwelds\n" + fields({id, id, id}) + "*SECTION_BEAM\n" +
         fields({id, 9, 1, static_cast<double>(w.quadrature), 1}) + fields({w.diameter, w.diameter, 0, 0}) +
         "*MAT_SPOTWELD\n" + fields({id, w.density, w.E, w.nu, w.yield, w.hardening, w.mass_step, w.failure_time}) +
         fields({w.failure_strain, f[0], f[1], f[2], f[3], f[4], f[5], static_cast<double>(w.filter)});
}

std::string sheet_part(int part, double thickness) {
  const double id = part;
  return "*PART\nsheet\n" + fields({id, id, id}) + "*SECTION_SHELL\n" + fields({id, 2, 0.8333, 3}) +
         fields({thickness, thickness, thickness, thickness}) + "*MAT_ELASTIC\n" + fields({id, 7.85e-9, 210000.0, 0.3});
}

std::string weld_contact(int weld_part, int sheet_part, double sast, double sbst) {
  return "*CONTACT_SPOTWELD\n" + fields({static_cast<double>(weld_part), static_cast<double>(sheet_part), 3, 3}) +
         fields({0}) + fields({1, 1, sast, sbst});
}

std::string weld_contact_to_set(int weld_part, std::initializer_list<int> sheet_parts) {
  std::string ids;
  for (int p : sheet_parts) ids += fmt::format("{:10d}", p);
  return "*CONTACT_SPOTWELD\n" + fields({static_cast<double>(weld_part), 1, 3, 2}) + fields({0}) + fields({1, 1}) +
         "*SET_PART_LIST\n" + fields({1}) + ids + '\n';
}

std::string SheetMesh::text() const {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const Vec3d x = corner + double(i) * along + double(j) * across;
      nodes += node_line(node(i, j), x.x, x.y, x.z);
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      shells +=
          element_line(first + j * nx + i, part, {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
  return nodes + shells;
}

std::string beam_between(int element, int part, int n1, const Vec3d& x1, int n2, const Vec3d& x2) {
  return "*NODE\n" + node_line(n1, x1.x, x1.y, x1.z) + node_line(n2, x2.x, x2.y, x2.z) + "*ELEMENT_BEAM\n" +
         element_line(element, part, {n1, n2});
}

std::string fixed(std::initializer_list<int> nodes) {
  std::string text = "*BOUNDARY_SPC_NODE\n";
  for (int n : nodes) text += fields({static_cast<double>(n), 0, 1, 1, 1, 1, 1, 1});
  return text;
}

std::string termination(double end_time, double step_scale, double mass_step, int step_curve) {
  return "*CONTROL_TERMINATION\n" + fields({end_time}) + "*CONTROL_ENERGY\n" + fields({2, 2, 2, 2}) +
         "*CONTROL_TIMESTEP\n" + fields({0, step_scale, 0, 0, mass_step, static_cast<double>(step_curve)});
}

std::string driven(int node, const Path& path, double duration, int points, int first_curve, double start) {
  constexpr int dof[6] = {1, 2, 3, 5, 6, 7};
  std::string motions = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n", curves;
  for (int i = 0; i < 6; ++i) {
    const int id = first_curve + i;
    motions += fields({static_cast<double>(node), static_cast<double>(dof[i]), 2, static_cast<double>(id)});
    curves += "*DEFINE_CURVE\n" + fields({static_cast<double>(id), 0, 1, 1, 0, 0, 0});
    if (start > 0.0) curves += fmt::format("{:20.12g}{:20.12g}\n", 0.0, 0.0);
    for (int k = 0; k <= points; ++k) {
      const double s = static_cast<double>(k) / points;
      curves += fmt::format("{:20.14g}{:20.13g}\n", start + s * duration, path(s)[i]);
    }
  }
  return motions + curves;
}

}  // namespace nugget::verify
