// SPDX-License-Identifier: Apache-2.0
#include "system/mobility.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"

namespace nugget::system {
void add_inverse_mass(Mobility::Matrix& g, const ConstraintMap::Block& b, std::size_t first, double inverse_mass,
                      const Mobility::Matrix& inverse_inertia) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        g[i][j] += b.of[first + i][k] * inverse_mass * b.of[first + j][k];
        for (std::size_t l = 0; l < 3; ++l)
          g[i][j] += b.of[first + i][3 + k] * inverse_inertia[k][l] * b.of[first + j][3 + l];
      }
}

Mobility::Matrix inverse_inertia(const RigidBody& body) {
  Mobility::Matrix inverse{};
  const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3d column = body.spin(axes[j], body.axes);
    inverse[0][j] = column.x;
    inverse[1][j] = column.y;
    inverse[2][j] = column.z;
  }
  return inverse;
}

double Mobility::largest(const Matrix& m) {
  // From the first entry, so that a multiple of the unit matrix gives just that.
  const double mean = m[0][0] + ((m[1][1] - m[0][0]) + (m[2][2] - m[0][0])) / 3.0;
  double spread = 0.0;  // trace of (m - mean)^2
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) spread += (m[i][j] - (i == j ? mean : 0.0)) * (m[j][i] - (i == j ? mean : 0.0));
  return mean + std::sqrt(2.0 / 3.0 * std::max(spread, 0.0));
}

Mobility mobility(const System& system, int node) {
  std::vector<ConstraintMap::Block> blocks;
  if (system.map.dependent(node)) {
    blocks = system.map.blocks(node);
  } else {
    blocks.push_back({node, {}});
    for (std::size_t i = 0; i < 6; ++i) blocks.back().of[i][i] = 1.0;
  }
  Mobility m;
  for (const ConstraintMap::Block& b : blocks) {
    double inverse_mass = 0.0;
    Mobility::Matrix inverse{};
    if (at(b.node) < system.nodes) {
      const double mass = system.mass[b.node], inertia = system.inertia[b.node];
      if (mass > 0.0) inverse_mass = 1.0 / mass;
      for (std::size_t k = 0; k < 3; ++k)
        if (inertia > 0.0) inverse[k][k] = 1.0 / inertia;
    } else {
      const RigidBody& body = system.bodies[at(b.node) - system.nodes];
      if (body.mass > 0.0) inverse_mass = 1.0 / body.mass;
      inverse = inverse_inertia(body);
    }
    add_inverse_mass(m.translation, b, 0, inverse_mass, inverse);
    add_inverse_mass(m.rotation, b, 3, inverse_mass, inverse);
  }
  return m;
}

}  // namespace nugget::system
