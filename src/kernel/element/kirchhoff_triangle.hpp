// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// Columns of layers of the discrete Kirchhoff triangle, at the area coordinates (2/3, 1/6, 1/6) of its corners in
/// turn: exact for its bending energy.
inline constexpr int kirchhoff_columns = 3;

template <class Law>
ShellLayout kirchhoff_layout(const ShellProperties& shell, const LawKernel<Law>& law) {
  return {shell.layers.count, law.layer_history(), kirchhoff_columns};
}

/// One cycle of the discrete Kirchhoff triangle (ELFORM 17).
///
/// The slopes beta = (w_y, -w_x) of the section are quadratic over the element: linear in the spins of the nodes, plus
/// a bubble along each side that makes the transverse shear vanish in the middle of the side, where the deflection is
/// that of a beam,
///     beta = sum L_i beta_i - 6 sum L_i L_j (S_ij / l_ij^2) x_ij,
/// with S_ij the shear along the side i-j times its length, as the C0 triangle has it. So there are no transverse shear
/// strains or forces, and nothing but a rigid motion bends nothing. Curvature is linear over the element; the membrane
/// strain is constant. Frame, mid-step rates, forces at the end, thickness update, drilling (`shell.drilling`) and
/// deletion are those of triangle_cycle and full_shell_cycle; an element is deleted when all layers of its three
/// columns have failed. The stable step is that of triangle_cycle, and no longer than the stable one of its bending:
/// with the shortest altitude h and a node's inertia m r^2, h^2 / (c t sqrt(1 + 0.4 A / r^2)), which is the shorter one
/// where t > h/2 (by eigenvalues of elements of all shapes; ours). Source: J.-L. Batoz, K.-J. Bathe, L.-W. Ho, Int. J.
/// Numer. Meth. Eng. 15 (1980).
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw, Laminate.
template <class R, class Law>
NodalForces<R, 3> kirchhoff_triangle_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                           const NodalMotion<R, 3>& nodes, double dt, double* state);

/// What the bubbles add to the mean curvature rates xx, yy, xy of the spins' gradient, in the element's frame
/// [1/(length time)].
std::array<double, 3> kirchhoff_mean_bending(const std::array<Vec3d, 3>& x, const std::array<Vec3d, 3>& v,
                                             const std::array<Vec3d, 3>& w);

/// Mass of each of three nodes and its inertia m max(t^2/12, A/8, A t^2 / (2 h^2)) with the shortest altitude h, plus
/// that of the offset. The last is more than the others where t > h/2 and spares such an element the larger part of
/// what its bending would take off its step (ours).
NodalMass kirchhoff_nodal_mass(const std::array<Vec3d, 3>& x, double thickness, double density, double offset = 0.0,
                               double mass_per_area = 0.0, const ThicknessProfile& profile = {});

}  // namespace nugget::kernel
