// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/hexahedron.hpp"

namespace nugget::kernel {

/// Fields of the state of a tetrahedron. Field i of lane l stands at state[i * lanes + l].
struct TetrahedronLayout {
  static constexpr int alive = 0;                ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;        ///< factor on the density by mass scaling [1]
  static constexpr int hourglass_energy = -1;    ///< there is none
  static constexpr int stress = 2;               ///< xx yy zz xy yz zx, global axes, without bulk viscosity
  static constexpr int bulk_viscosity_work = 8;  ///< done against the bulk viscosity so far [energy]
  static constexpr int bulk_pressure = 9;        ///< of the last cycle [stress]
  static constexpr int first_history = 10;

  int history = 0;
  bool nodal_pressure = false;  ///< the mean stress comes from outside

  /// Where it stands, if it does [stress].
  int mean_stress() const { return first_history + history; }
  int size() const { return first_history + history + (nodal_pressure ? 1 : 0); }
};

template <class Law>
TetrahedronLayout tetrahedron_layout(const LawKernel<Law>& law, bool nodal_pressure = false) {
  return {law.solid_history(), nodal_pressure};
}

/// State of an undeformed, stress-free tetrahedron in lane `lane` of `width`.
void start_tetrahedron(const TetrahedronLayout& layout, double* state, int width, int lane);

/// Motion of four nodes, the fourth above the face 1-2-3 seen counter-clockwise: end position x(t + dt) and velocity at
/// t + dt/2.
template <class R>
struct TetrahedronMotion {
  Vec3<R> x[4], v[4];
};

/// As SolidForces, of four nodes.
template <class R>
struct TetrahedronForces {
  Vec3<R> f[4];
  R stable_step{}, volume{};
};

/// One cycle of the tetrahedron of constant strain (ELFORM 10).
///
/// Gradients, rotation of the stress, forces and bulk viscosity as in hexahedron_cycle. It has no hourglass modes, and
/// it locks: in bending, and where plastic flow keeps the volume.
///
/// Stable step: with a quarter of the mass rho V at each node no frequency exceeds omega^2 = 4 max(3 K, 2 G) g / rho,
/// where g is the largest eigenvalue of the sum of b_I b_I^T over the gradients of the shape functions; exact for a
/// regular tetrahedron alone. g is taken from above by the norm of the matrix's eighth power (at most 7 % too large).
/// The least altitude over the wave speed, which LS-DYNA's theory manual gives, is up to 1.6 times longer and not safe
/// for a tetrahedron alone. The length of the bulk viscosity is the wave speed times this step.
///
/// With nodal_pressure (ELFORM 13) the mean stress is that of the state, which the nodes agree on (NodalPressure): the
/// law gives the deviator only, so it must be one whose mean stress is elastic.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw. Hourglass data of
/// `solid` are not used. Source: Zienkiewicz, Taylor, The Finite Element Method, vol. 1, constant-strain tetrahedron;
/// the bound follows from |sum u_I b_I^T|^2 <= g |u|^2.
template <class R, class Law>
TetrahedronForces<R> tetrahedron_cycle(const HexahedronProperties& solid, const LawKernel<Law>& law,
                                       const TetrahedronLayout& layout, const TetrahedronMotion<R>& nodes, double dt,
                                       double* state);

/// Volume; negative for inverted node order [length^3].
double tetrahedron_volume(const std::array<Vec3d, 4>& x);

}  // namespace nugget::kernel
