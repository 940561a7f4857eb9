// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/vec3.hpp"
#include "system/system.hpp"

namespace nugget::system {

/// What a force or a moment at a node accelerates: 3 x 3 inverse mass and inverse inertia of the node by itself, of the
/// nodes that it follows or of its rigid body (with the lever: n . translation n is the inverse mass that a force along
/// n meets). A node without mass has no mobility, not an infinite one: nothing that acts on it moves it.
struct Mobility {
  using Matrix = std::array<std::array<double, 3>, 3>;
  Matrix translation{}, rotation{};

  static double along(const Matrix& m, const Vec3d& n) {
    const std::array<double, 3> v{n.x, n.y, n.z};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sum += v[i] * m[i][j] * v[j];
    return sum;
  }
  /// An upper bound of the largest eigenvalue of a matrix of which all are real, the same in all axes: mean + sqrt(2)
  /// times the standard deviation of the three (Wolkowicz and Styan, Linear Algebra Appl. 29, 1980); the eigenvalue
  /// itself where the other two are equal.
  static double largest(const Matrix& m);
};

Mobility mobility(const System& system, int node);

/// Adds rows `first` to `first` + 2 of B M^-1 B^t to `g`: what one independent node adds.
void add_inverse_mass(Mobility::Matrix& g, const ConstraintMap::Block& b, std::size_t first, double inverse_mass,
                      const Mobility::Matrix& inverse_inertia);
Mobility::Matrix inverse_inertia(const RigidBody& body);

}  // namespace nugget::system
