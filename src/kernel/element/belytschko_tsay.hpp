// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// One cycle of the four-node Belytschko-Lin-Tsay shell (ELFORM 2): one point in the plane, layers through the
/// thickness.
///
/// Strain rates and hourglass rates are formed on the mid-step geometry x(t + dt/2) = x - dt/2 v, or with
/// `rates_at_end` on that of the end (docs/decisions/0183), stresses live in the element's frame, and nodal forces use
/// the geometry at the end of the step: with the former a rigid rotation x(t) -> x(t + dt) strains nothing, whatever
/// its angle, if the spins are those of the chord, (2/dt) tan(angle/2); with the true angular
/// velocity up to angle^3/12 in transverse shear. The frame bisects the diagonals, so that results do not depend on
/// which node comes first. Hourglass forces: stiffness form or viscous form of docs/theory/hourglass.md#shells, kept in
/// the frame; their work is added up in the state by the trapezoidal rule. Warping stiffness (BWC 1): coupling of
/// curvature and in-plane velocity (Belytschko, Wong, Chiang 1992), with the nodes' drilling rotation projected out
/// along the nodal normals; the transverse shear stays the one-point form. Elements of which every layer has failed, or
/// whose stable step falls below the law's deletion step, are deleted: alive 0, no force, infinite stable step.
/// Internal energy is not computed here: it is the work of the nodal forces. Sources: Belytschko, Lin, Tsay, CMAME 42
/// (1984); LS-DYNA Theory Manual; docs/theory/shell.md.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw, Laminate; SingleBatch
/// with the first three.
template <class R, class Law>
NodalForces<R, 4> shell_cycle(const ShellProperties& shell, const LawKernel<Law>& law, const NodalMotion<R, 4>& nodes,
                              double dt, Number<R>* state);

/// Frame of the element at nodal positions x1 .. x4, in which its stresses are given.
Frame3d shell_frame(const std::array<Vec3d, 4>& x);

/// Area projected on the plane of the diagonals [length^2].
double shell_area(const std::array<Vec3d, 4>& x);

/// Stable time step before TSSFAC, L / c with c = sqrt(E / (rho (1 - nu^2))) and L by `length` (ISDO) [time].
double shell_stable_step(const std::array<Vec3d, 4>& x, ShellLength length, double E, double nu, double density);

/// Mass of each of four nodes, rho t A / 4, and inertia m r^2, r^2 = max(t^2/12, A/8) (Hughes, Cohen, Haroun, Nucl.
/// Eng. Des. 46 (1978); what LS-DYNA's shells turn with: docs/decisions/0182), and offset
/// (docs/theory/shell.md#offset-from-the-mid-surface). `shear_share`: stiffness in transverse shear over that in the
/// plane, kappa G (1 - nu^2) / E. Shear that bends and spins the section vibrates with w^2 = shear_share (c/L)^2 (4 +
/// L^2/r^2), which is faster than a wave where Poisson's ratio is small: r is raised until a step of 0.93 L/c is stable
/// (ours), and likewise where the nodes are off the mid-surface. Without a share (bodies, masses) it is not raised.
NodalMass shell_nodal_mass(const std::array<Vec3d, 4>& x, double thickness, double density, double offset = 0.0,
                           double mass_per_area = 0.0, double shear_share = 0.0, const ThicknessProfile& profile = {});

}  // namespace nugget::kernel
