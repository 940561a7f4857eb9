// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"
#include "kernel/law/discrete_beam.hpp"

namespace nugget::kernel {

/// Section data of a block of discrete beams (*SECTION_BEAM, ELFORM 6).
struct DiscreteBeamProperties {
  double mass = 0.0;     ///< RO VOL, half of it at each node, before mass scaling [mass]
  double inertia = 0.0;  ///< INER, half of it at each node [mass length^2]
  /// SCOOR. The triad turns with node 1 (negative), node 2 (positive) or their mean (0). From 2 on in size the beam is
  /// one of finite length: rotation as a rigid body makes no displacement, and couples at the nodes balance the forces;
  /// at 2 the r axis moreover follows the line of the nodes.
  int scoor = 0;
  bool between_points = false;  ///< DiscreteBeam::between_points of its law
  double cable_area = 0.0;      ///< CA [area]
  double cable_offset = 0.0;    ///< OFFSET: a cable's length at the start less its unstretched one [length]
  bool joins_sheets = false;    ///< of finite length whatever SCOOR, its forces at the middle; its law is a joint

  bool long_beam() const { return scoor <= -2 || scoor >= 2 || joins_sheets; }
  bool follows_line() const { return scoor == -2 || scoor == 2; }
};

/// Fields of the state of a discrete beam. Field i of lane l stands at state[i * lanes + l].
struct DiscreteBeamLayout {
  static constexpr int alive = 0;           ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;   ///< factor on mass and inertia by mass scaling [1]
  static constexpr int axis_r = 2;          ///< global components of the unit vector r
  static constexpr int axis_s = 5;          ///< and s; t = r x s
  static constexpr int displacement = 8;    ///< along r s t [length], about r s t [rad]
  static constexpr int spring = 14;         ///< force of each spring without dampers and preload
  static constexpr int plastic = 20;        ///< plastic displacement of each
  static constexpr int resultant = 26;      ///< N_r N_s N_t [force], M_r M_s M_t [moment]
  static constexpr int length = 32;         ///< distance of the nodes [length]
  static constexpr int on_line = 33;        ///< 1 where the r axis lies on the line of the nodes, whatever SCOOR says
  static constexpr int joint_plastic = 34;  ///< of an Spr3 joint: plastic displacement
  static constexpr int joint_damage = 35;   ///< of a joint: damage
  static constexpr int unstretched = 36;    ///< length of a cable without force but F0 [length]
  static constexpr int count = 37;
};

/// State at time 0 in lane `lane` of `width`. `axes`: the triad; where the r axis follows the nodes (SCOOR, or a spring
/// between two points that stand apart) it is turned there by the shortest way.
void start_discrete_beam(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                         const Vec3d& x1, const Vec3d& x2, double* state, int width, int lane);

/// Stable time step before TSSFAC [time]: the smallest of the six modes of the free beam in which one spring alone
/// works, 2/(a + sqrt(a^2 + w^2)) with w^2 = k/m and 2 a = c/m; infinite without stiffness and viscosity. `scale`: mass
/// scaling; `force`: of the springs, on which the viscosity of rate factors depends. Of a cable `length` is that at the
/// start.
double discrete_beam_stable_step(const DiscreteBeamProperties& beam, const DiscreteBeam& law, double length,
                                 double scale = 1.0, const std::array<double, 6>& force = {});

/// Stiffness of the beam at rest in its axes, with node 2 at `line` from node 1: row i, column j of `k` is the force in
/// freedom i for a unit motion of freedom j, three translations and three rotations of node 1, then of node 2, global
/// axes. Springs count with their slope at the start; dampers, preload and failure do not. Beams of no length (SCOOR up
/// to 1 in size) have no couples here and no part of the spin, so that it is symmetric whatever their length.
void discrete_beam_stiffness(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                             const Vec3d& line, std::span<double> k);
/// Internal forces at rest in the same freedoms, by preloads (F0) and by what the springs are stretched at time 0;
/// false, and `f` as it was, where there are none.
bool discrete_beam_force_at_start(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                                  const Vec3d& line, std::span<double> f);
/// The same as the stiffness of its dampers; false, and `c` as it was, where there is none.
bool discrete_beam_viscosity(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                             const Vec3d& line, std::span<double> c);

/// One cycle: displacements of node 2 relative to node 1 in the turning triad,
///     u' = R (v2 - v1 - w x (x2 - x1)),   theta' = R (w2 - w1),
/// w the spin of the triad, for a long beam the mean of both nodes'; then the six springs; then their forces on the
/// nodes, for a long beam with the couples -(x2 - x1) x F / 2. A beam whose law says so is deleted: alive 0, no force,
/// infinite stable step. Source: docs/theory/time_step.md#beams and docs/theory/beam.md#discrete-beam; LS-DYNA Keyword
/// Manual, *SECTION_BEAM, SCOOR.
///
/// Instantiated for R = NativeBatch.
template <class R>
NodalForces<R, 2> discrete_beam_cycle(const DiscreteBeamProperties& beam, const DiscreteBeam& law,
                                      const NodalMotion<R, 2>& nodes, double dt, double* state);

}  // namespace nugget::kernel
