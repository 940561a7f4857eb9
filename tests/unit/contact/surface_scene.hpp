// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "contact/surface_contact.hpp"
#include "unit/contact/point_masses.hpp"

namespace nugget::contact::test {

inline constexpr double bulk = 175000.0;  // steel, mm-t-s

/// Nodes and segments, with nothing but contact and given forces.
struct Scene : PointMasses {
  SurfaceContactSetup setup;
  std::function<void(Scene&)> load = [](Scene&) {};

  /// An n by m patch of square segments; `at(i, j)` gives the nodes. Returns its first node.
  int add_patch(int n, int m, double thickness, const std::function<Vec3d(int, int)>& at, const Vec3d& velocity = {},
                double node_mass = 1e-5) {
    const int first = static_cast<int>(x.size());
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) add_node(at(i, j), velocity, node_mass);
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = first + j * (n + 1) + i;
        Segment s;
        s.node = {a, a + 1, a + n + 2, a + n + 1};
        s.thickness = thickness;
        s.bulk_modulus = bulk;
        s.element = static_cast<int>(setup.segments.size());
        setup.segments.push_back(s);
      }
    return first;
  }
  SurfaceContact contact() {
    if (setup.nodes.empty()) setup.nodes = nodes_of(setup.segments);
    alive.assign(setup.segments.size(), 1);
    force.assign(x.size(), {});
    return SurfaceContact(setup, x);
  }
  void step(SurfaceContact& contact) {
    PointMasses::step(contact);
    load(*this);
  }
};

inline std::function<Vec3d(int, int)> flat(double size, double z, const Vec3d& origin = {}) {
  return [=](int i, int j) { return origin + Vec3d{size * i, size * j, z}; };
}

/// A plate at z = 0 of 2 x 2 segments of side 5, thickness 1, and one free tracked node of thickness 1.
struct PlateAndNode : Scene {
  int node;
  explicit PlateAndNode(const Vec3d& at, const Vec3d& velocity = {}, double m = 1e-5) {
    add_patch(2, 2, 1.0, flat(5.0, 0.0), {}, 1e10);
    node = add_node(at, velocity, m);
    setup.nodes = {{node, 1.0}};
  }
};

}  // namespace nugget::contact::test
