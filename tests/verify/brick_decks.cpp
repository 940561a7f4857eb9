// SPDX-License-Identifier: Apache-2.0
#include "brick_decks.hpp"

#include <fmt/format.h>

namespace nugget::verify {

std::string brick_part(int part, const WeldData& w, const HourglassData& hourglass) {
  const double id = part;
  const auto& f = w.strength;
  const bool plain = w.option == 0 && w.true_thickness == 0.0;
  return "*PART\nbrick welds\n" + fields({id, id, id, 0, id}) + "*SECTION_SOLID\n" + fields({id, 1}) + "*HOURGLASS\n" +
         fields({id, static_cast<double>(hourglass.type), hourglass.coefficient}) +
         (plain ? "*MAT_SPOTWELD\n" : "*MAT_SPOTWELD_DAMAGE-FAILURE\n") +
         fields({id, w.density, w.E, w.nu, w.yield, w.hardening, w.mass_step, w.failure_time}) +
         fields({w.failure_strain, f[0], f[1], f[2], f[3], f[4], f[5], static_cast<double>(w.filter)}) +
         (plain ? "" : fields({0, static_cast<double>(w.option), 0, w.true_thickness}));
}

std::vector<int> Prism::layer(int k) const {
  std::vector<int> ids;
  for (int i = 0; i < count(); ++i) ids.push_back(node(k, i));
  return ids;
}

Vec3d Prism::place(int id) const {
  const auto& xy = section[(id - 1) % count()];
  return {xy[0], xy[1], z[(id - 1) / count()]};
}

std::string Prism::text() const {
  const int layers = static_cast<int>(z.size());
  std::string nodes = "*NODE\n", solids = "*ELEMENT_SOLID\n";
  for (int id = 1; id <= layers * count(); ++id) nodes += node_line(id, place(id).x, place(id).y, place(id).z);
  int element = 0;
  for (int k = 0; k + 1 < layers; ++k)
    for (const auto& q : quads)
      solids += element_line(++element, 1,
                             {node(k, q[0]), node(k, q[1]), node(k, q[2]), node(k, q[3]), node(k + 1, q[0]),
                              node(k + 1, q[1]), node(k + 1, q[2]), node(k + 1, q[3])});
  return nodes + solids;
}

Prism square_prism(double side, double length, int n) {
  Prism p;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) p.section.push_back({side * i / n - 0.5 * side, side * j / n - 0.5 * side});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      p.quads.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  p.z = {0.0, length};
  return p;
}

std::string held(const std::vector<int>& nodes, std::array<int, 3> held) {
  std::string text = "*BOUNDARY_SPC_NODE\n";
  for (int n : nodes)
    text += fields({static_cast<double>(n), 0, static_cast<double>(held[0]), static_cast<double>(held[1]),
                    static_cast<double>(held[2])});
  return text;
}

std::string moved(const Prism& prism, const std::vector<int>& nodes, std::array<int, 3> along, const Motion& motion,
                  double duration, int points, int first_curve) {
  constexpr double Vec3d::*component[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};
  std::string motions = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n", curves;
  int curve = first_curve;
  for (int n : nodes)
    for (int i = 0; i < 3; ++i) {
      if (!along[i]) continue;
      motions += fields({static_cast<double>(n), i + 1.0, 2, static_cast<double>(curve)});
      curves += "*DEFINE_CURVE\n" + fields({static_cast<double>(curve++), 0, 1, 1, 0, 0, 0});
      for (int k = 0; k <= points; ++k) {
        const double s = static_cast<double>(k) / points;
        curves += fmt::format("{:20.14g}{:20.13g}\n", s * duration, motion(prism.place(n), s).*component[i]);
      }
    }
  return motions + curves;
}

double smooth(double s) {
  return s * s * s * (10.0 - s * (15.0 - 6.0 * s));
}

}  // namespace nugget::verify
