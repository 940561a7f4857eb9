// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// One cycle of the three-node C0 triangle (ELFORM 4): one point in the plane, constant membrane strain and curvature,
/// transverse shear from the edges; no hourglass modes. Mid-step rates, forces at the end, layers, thickness update and
/// deletion as in shell_cycle; state as ShellLayout says. With `shell.drilling` > 0 no motion but the rigid ones is
/// free: drilling is resisted as in full_shell_cycle, and so is the part of the transverse shear that the point does
/// not see (Lee, Bathe, Computers and Structures 82 (2004), integrated exactly; elastic). Sources:
/// docs/theory/shell.md#c0-triangle.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw, Laminate.
template <class R, class Law>
NodalForces<R, 3> triangle_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 3>& nodes, double dt, double* state);

/// Frame of the element at nodal positions x1 .. x3, in which its stresses are given.
Frame3d triangle_frame(const std::array<Vec3d, 3>& x);

/// Area [length^2].
double triangle_area(const std::array<Vec3d, 3>& x);

/// Stable time step before TSSFAC, L / c, L the shortest altitude (ISDO 0, 1) [time].
double triangle_stable_step(const std::array<Vec3d, 3>& x, ShellLength length, double E, double nu, double density);

/// Mass of each of three nodes and its inertia m r^2, r^2 = max(t^2/12, A/8) + offset, raised as that of
/// shell_nodal_mass where `shear_share` is given: shear that bends and spins the section, and nodes off the
/// mid-surface.
NodalMass triangle_nodal_mass(const std::array<Vec3d, 3>& x, double thickness, double density, double offset = 0.0,
                              double mass_per_area = 0.0, double shear_share = 0.0,
                              const ThicknessProfile& profile = {});

}  // namespace nugget::kernel
