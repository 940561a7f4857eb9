// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/hexahedron.hpp"

namespace nugget::kernel {

/// Fields of the state of a tetrahedron of ten nodes. Field i of lane l stands at state[i * lanes + l].
struct QuadraticTetrahedronLayout {
  static constexpr int alive = 0;                ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;        ///< factor on the density by mass scaling [1]
  static constexpr int hourglass_energy = -1;    ///< there is none
  static constexpr int volume = 2;               ///< at the start [length^3]
  static constexpr int bulk_viscosity_work = 3;  ///< done against the bulk viscosity so far [energy]
  static constexpr int bulk_pressure = 4;        ///< of the last cycle [stress]
  static constexpr int first_point = 5;
  static constexpr int points = 4;

  int history = 0;

  int size() const { return point(points); }
  /// Stress xx yy zz xy yz zx of a point in global axes, without bulk viscosity, followed by its history.
  int point(int p) const { return first_point + p * (SolidTensor<double>::size + history); }
  int history_of(int p) const { return point(p) + SolidTensor<double>::size; }
};

template <class Law>
QuadraticTetrahedronLayout quadratic_tetrahedron_layout(const LawKernel<Law>& law) {
  return {law.solid_history()};
}

/// Corners 1 to 4, then the nodes amid the edges 1-2, 2-3, 3-1, 1-4, 2-4, 3-4.
inline constexpr int quadratic_tetrahedron_edge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

/// Share of the element's mass at each corner and at each node amid an edge [1]: the diagonal of the consistent mass
/// matrix of a straight-sided element, scaled to its mass (E. Hinton, T. Rock, O.C. Zienkiewicz, Earthquake Engineering
/// and Structural Dynamics 4 (1976)). The rows' sums would be negative at the corners.
inline constexpr double quadratic_tetrahedron_corner_mass = 1.0 / 36.0, quadratic_tetrahedron_edge_mass = 4.0 / 27.0;
constexpr double quadratic_tetrahedron_mass_share(int node) {
  return node < 4 ? quadratic_tetrahedron_corner_mass : quadratic_tetrahedron_edge_mass;
}

/// State of an undeformed, stress-free tetrahedron in lane `lane` of `width`.
void start_quadratic_tetrahedron(const QuadraticTetrahedronLayout& layout, const std::array<Vec3d, 10>& x,
                                 double* state, int width, int lane);

/// Motion of ten nodes, the fourth above the face 1-2-3 seen counter-clockwise: end position x(t + dt) and velocity at
/// t + dt/2.
template <class R>
struct QuadraticTetrahedronMotion {
  Vec3<R> x[10], v[10];
};

/// As SolidForces, of ten nodes. `volume` is the smallest at a point times the number of points, which must be above
/// zero.
template <class R>
struct QuadraticTetrahedronForces {
  Vec3<R> f[10];
  R stable_step{}, volume{};
};

/// One cycle of the quadratic tetrahedron (ELFORM 16).
///
/// Isoparametric, with four points at the area coordinates (.585, .138, .138, .138), which integrate the stiffness of a
/// straight-sided element exactly and leave no motion without stiffness. At a point the element is the tetrahedron of
/// four nodes whose corners are the derivatives of the position by the area coordinates; its gradients take the
/// velocity gradient from the mid-step geometry and the forces from the geometry at the end. Each point's stress turns
/// with its own spin, as in hexahedron_cycle; the dilatation is the point's own, nothing is reduced. Bulk viscosity is
/// of the mean dilatation. An element is deleted when all its points have failed (or as many as the law says), or its
/// stable step falls below the law's deletion step.
///
/// Stable step: no frequency exceeds omega^2 = 4 max(3 K, 2 G) c max_p(V_p g_p) / (rho V_0), with V_p the volume at
/// point p, g_p as in tetrahedron_cycle of the four-node tetrahedron there, V_0 the volume at the start, and c =
/// 25.7507 the largest eigenvalue of (sum over points of 1/4 D P D^T) u = lambda M u, D the derivatives of the shape
/// functions by the area coordinates, P the projection onto those whose sum is zero, M the lumped masses of a unit
/// mass. It follows from |grad u|^2 <= g |P D^T u|^2 at each point, whatever the shape; the true frequency is up to
/// 1.8 times lower. The length of the bulk viscosity is the wave speed times this step.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw. Hourglass data of
/// `solid` are not used. Source: Zienkiewicz, Taylor, The Finite Element Method, vol. 1, quadratic tetrahedron; points
/// of P.C. Hammer, O.P. Marlowe, A.H. Stroud, Math. Tables Aids Comput. 10 (1956).
template <class R, class Law>
QuadraticTetrahedronForces<R> quadratic_tetrahedron_cycle(const HexahedronProperties& solid, const LawKernel<Law>& law,
                                                          const QuadraticTetrahedronMotion<R>& nodes, double dt,
                                                          double* state);

/// Volume by the four points; negative for inverted node order [length^3].
double quadratic_tetrahedron_volume(const std::array<Vec3d, 10>& x);
/// The least volume at one of the points, times four [length^3].
double quadratic_tetrahedron_least_volume(const std::array<Vec3d, 10>& x);
/// Mean over the volume of the gradient v_i,j: rows of x, y and z.
std::array<Vec3d, 3> quadratic_tetrahedron_gradient(const std::array<Vec3d, 10>& x, const std::array<Vec3d, 10>& v);

}  // namespace nugget::kernel
