// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "base/archive.hpp"
#include "base/vec3.hpp"
#include "model/parts.hpp"
#include "system/state.hpp"

namespace nugget::system {

/// Symmetric 3x3: xx xy xz yy yz zz.
using Inertia = std::array<double, 6>;

/// Dynamics of one rigid body; its centre is a virtual node of the State, its nodes follow that node by the constraint
/// map. Angular momentum is the primary unknown: it is conserved to round-off in torque-free motion.
struct RigidBody {
  model::Index source = model::none;  ///< in Model::rigid_bodies
  int id = 0;
  std::string title;
  int node = 0;                                         ///< virtual node in State
  unsigned fixed = 0;                                   ///< bits 0..2 translations, 3..5 rotations that cannot move
  Frame3d fixed_axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< whose x y z those are; they stay where they are
  double mass = 0.0;
  Inertia inertia{};       ///< about the centre, in body axes (global axes of time 0)
  Frame3d axes;            ///< rows: body axes in global components, at t(n)
  Vec3d center0;           ///< centre at time 0
  Vec3d angular_momentum;  ///< about the centre, at t(n-1/2), after `advance` at t(n+1/2)

  /// Spin that belongs to an angular momentum with the axes given.
  Vec3d spin(const Vec3d& momentum, const Frame3d& at) const;
  Vec3d momentum(const Vec3d& spin, const Frame3d& at) const;
  /// The same where the body cannot turn about some axes: those of them that are not its own ask for a moment of the
  /// supports, which does no work.
  Vec3d constrained_spin(const Vec3d& momentum, const Frame3d& at) const;
  /// The spin that has given components along some axes of a basis, and whose momentum about the others is that given.
  Vec3d spin_of(const Vec3d& momentum, const Frame3d& at, const Frame3d& basis, unsigned given,
                const Vec3d& values) const;

  /// From t(n-1/2) to t(n+1/2): momentum by force and torque over `velocity_interval`, then the spin that turns the
  /// body over `dt`. The spin satisfies the midpoint rule w = I(t+dt/2)^-1 L with I at the half-turned axes
  /// (fixed-point iteration to round-off). Returns force times change of velocity plus torque times change of spin.
  double advance(double velocity_interval, double dt, State& state);
  /// Turns the axes over the step with the spin in `state`.
  void turn(double dt, const State& state);
  /// Makes the components of the spin along those axes of a basis whose bits are set in `given` equal to `values`
  /// [1/time], by moments about these axes alone: about the others the angular momentum stays, and products of inertia
  /// turn the body there.
  void drive_spin(const Frame3d& basis, unsigned given, const Vec3d& values, double dt, State& state);
  void archive(Archive& a);
};

/// a^-1 b.
Vec3d solve(const Inertia& a, const Vec3d& b);

/// Adds a point mass with isotropic inertia at position r from the reference point.
void add_point(Inertia& inertia, double mass, double point_inertia, const Vec3d& r);

}  // namespace nugget::system
