// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"

// Membranes: sheets that carry forces in their plane and none by bending, such as fabric. Their nodes have no spins and
// get no moments. Layers, thickness update, deletion and stable step are those of the shells (shell_cycle); with the
// one layer that membranes have, the stress is constant through the thickness. Instantiated for R = NativeBatch with
// Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw.
namespace nugget::kernel {

/// One cycle of the four-node Belytschko-Tsay membrane (ELFORM 5): the membrane part of shell_cycle, with its frame and
/// its one point in the plane. Hourglass patterns in the plane are resisted as those of shell_cycle, by viscosity (IHQ
/// 1 to 3) or stiffness (4, 5). The pattern across the plane, which a membrane does not resist at all, meets the
/// viscosity QW rho c t sqrt(A) / 4 whatever the type (ours: a stiffness would be one of bending). Sources: LS-DYNA
/// Theory Manual, chapter on the membrane element; Belytschko, Lin, Tsay, CMAME 42 (1984); docs/theory/membrane.md.
template <class R, class Law>
NodalForces<R, 4> membrane_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state);

/// One cycle of the four-node membrane of 2 x 2 points (ELFORM 9), columns as of full_shell_cycle: the bilinear
/// surface, its strain rates and forces in its tangent plane at each point (docs/theory/membrane.md#two-by-two-points).
/// Where it is under tension no pattern is free, across its plane either; there is no hourglass control.
template <class R, class Law>
NodalForces<R, 4> full_membrane_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                      const NodalMotion<R, 4>& nodes, double dt, double* state);

/// One cycle of the three-node membrane: constant strain. Frame as of triangle_cycle.
template <class R, class Law>
NodalForces<R, 3> membrane_triangle_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                          const NodalMotion<R, 3>& nodes, double dt, double* state);

}  // namespace nugget::kernel
