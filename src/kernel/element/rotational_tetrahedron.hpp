// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/hexahedron.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// Fields of the state of a tetrahedron with nodal rotations. Field i of lane l stands at state[i * lanes + l].
struct RotationalTetrahedronLayout {
  static constexpr int alive = 0;                ///< 1, or 0 once the element is deleted
  static constexpr int density_scale = 1;        ///< factor on the density by mass scaling [1]
  static constexpr int hourglass_energy = 2;     ///< work done against the two stabilising forces [energy]
  static constexpr int moment = 3;               ///< against the mean rotation, global axes [force length]
  static constexpr int dilation = 6;             ///< against the divergence of the rotations [force length^2]
  static constexpr int edge2 = 7;                ///< mean square of the edges at the start [length^2]
  static constexpr int bulk_viscosity_work = 8;  ///< done against the bulk viscosity so far [energy]
  static constexpr int bulk_pressure = 9;        ///< of the last cycle [stress]
  static constexpr int first_point = 10;
  static constexpr int points = 4;

  int history = 0;

  int size() const { return point(points); }
  /// Stress xx yy zz xy yz zx of a point in global axes, without bulk viscosity, followed by its history.
  int point(int p) const { return first_point + p * (SolidTensor<double>::size + history); }
  int history_of(int p) const { return point(p) + SolidTensor<double>::size; }
};

template <class Law>
RotationalTetrahedronLayout rotational_tetrahedron_layout(const LawKernel<Law>& law) {
  return {law.solid_history()};
}

/// State of an undeformed, stress-free tetrahedron in lane `lane` of `width`.
void start_rotational_tetrahedron(const RotationalTetrahedronLayout& layout, const std::array<Vec3d, 4>& x,
                                  double* state, int width, int lane);

/// As NodalForces, with the volume, which must be above zero.
template <class R>
struct RotationalTetrahedronForces {
  Vec3<R> f[4], m[4];
  R stable_step{}, volume{};
};

/// One cycle of the tetrahedron with nodal rotations (ELFORM 4; how LS-DYNA's is made is not public).
///
/// It is the tetrahedron of ten nodes whose mid-side nodes follow those at the ends i, j of their edge,
///     v_mid = (v_i + v_j) / 2 + (w_i - w_j) x (x_j - x_i) / 8,
/// as a beam's middle does (D.J. Allman, Computers and Structures 19 (1984); T.P. Pawlak, S.M. Yunus, R.D. Cook, Int.
/// J. Numer. Meth. Eng. 31 (1991)); edges stay straight. Four points at the area coordinates (.585, .138, .138, .138),
/// selectively reduced: each takes its deviatoric rate from its own velocity gradient and the dilatation from the
/// element's mean, forces come from the points' deviators and the mean pressure (B-bar), as in full_hexahedron_cycle.
///
/// Four patterns of the rotations deform nothing: w = a + b x. The first three (equal rotations) meet a moment that is
/// elastic in the difference between the mean of the nodal spins and the element's own, stiffness 1e-5 G V; the fourth
/// a force against the divergence of the rotations, which is zero where they are those of a displacement field,
/// stiffness 1e-2 G V l^2. Both vanish in rigid motions and constant strain; their energy is the hourglass energy.
///
/// Stable step: no frequency exceeds omega^2 = 4 g (max(3 K, 2 G) + 2 G l^2 / l0^2) / rho, with g as in
/// tetrahedron_cycle and l^2 the mean square of the edges, l0^2 that of the start, for a quarter of the mass at each
/// node with l0^2 / 10 of rotary inertia (by eigenvalues of elements of all shapes; ours). Bulk viscosity, deletion
/// (all four points) and stable step otherwise as in tetrahedron_cycle.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw. Hourglass data of
/// `solid` are not used.
template <class R, class Law>
RotationalTetrahedronForces<R> rotational_tetrahedron_cycle(const HexahedronProperties& solid,
                                                            const LawKernel<Law>& law, const NodalMotion<R, 4>& nodes,
                                                            double dt, double* state);

/// Rotary inertia of each of four nodes.
double rotational_tetrahedron_inertia(const std::array<Vec3d, 4>& x, double density);

}  // namespace nugget::kernel
