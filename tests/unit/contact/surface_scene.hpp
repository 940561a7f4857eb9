// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "contact/surface_contact.hpp"

namespace nugget::contact::test {

inline constexpr double bulk = 175000.0;  // steel, mm-t-s

/// Nodes and segments, and central differences with nothing but contact and given forces.
struct Scene {
  SurfaceContactSetup setup;
  std::vector<Row> x, v, force;
  std::vector<double> mass;
  std::vector<unsigned char> alive;
  double time = 0.0, dt = 1e-7;
  std::function<void(Scene&)> load = [](Scene&) {};

  int add_node(const Vec3d& p, const Vec3d& velocity = {}, double m = 1e-5) {
    x.push_back({p.x, p.y, p.z, 0.0});
    v.push_back({velocity.x, velocity.y, velocity.z, 0.0});
    mass.push_back(m);
    return static_cast<int>(x.size()) - 1;
  }
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
  void evaluate(SurfaceContact& contact, double step) {
    force.assign(x.size(), {});
    contact.apply({time, step, step, step, x, v, mass, alive}, force);
  }
  void step(SurfaceContact& contact) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      nugget::add(v[i], (dt / mass[i]) * vec(force[i]));
      nugget::add(x[i], dt * vec(v[i]));
    }
    time += dt;
    evaluate(contact, dt);
    load(*this);
  }
  double kinetic() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * mass[i] * dot(vec(v[i]), vec(v[i]));
    return sum;
  }
  Vec3d momentum() const {
    Vec3d sum;
    for (std::size_t i = 0; i < x.size(); ++i) sum += mass[i] * vec(v[i]);
    return sum;
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
