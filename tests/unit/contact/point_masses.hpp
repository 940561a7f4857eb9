// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/row.hpp"

namespace nugget::contact::test {

/// Point masses, and central differences with the forces of a contact.
struct PointMasses {
  std::vector<Row> x, v, force;
  std::vector<double> mass;
  std::vector<unsigned char> alive;
  double time = 0.0, dt = 1e-7;

  int add_node(const Vec3d& p, const Vec3d& velocity = {}, double m = 1e-5) {
    x.push_back({p.x, p.y, p.z, 0.0});
    v.push_back({velocity.x, velocity.y, velocity.z, 0.0});
    mass.push_back(m);
    return static_cast<int>(x.size()) - 1;
  }
  template <class Contact>
  void evaluate(Contact& contact, double step) {
    force.assign(x.size(), {});
    contact.apply({time, step, step, step, x, v, mass, alive}, force);
  }
  template <class Contact>
  void step(Contact& contact) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      nugget::add(v[i], (dt / mass[i]) * vec(force[i]));
      nugget::add(x[i], dt * vec(v[i]));
    }
    time += dt;
    evaluate(contact, dt);
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

}  // namespace nugget::contact::test
