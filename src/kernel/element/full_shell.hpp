// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/element/shell.hpp"

namespace nugget::kernel {

/// Columns of layers of the fully integrated shell: the Gauss points (-,-) (+,-) (+,+) (-,+) of its plane.
inline constexpr int full_shell_columns = 4;

template <class Law>
ShellLayout full_shell_layout(const ShellProperties& shell, const LawKernel<Law>& law) {
  return {shell.layers.count, law.layer_history(), full_shell_columns};
}

/// One cycle of the four-node fully integrated shell (ELFORM 16): 2 x 2 points in the plane, layers through the
/// thickness at each.
///
/// Membrane: constant strain and the two bending patterns of Belytschko and Bachrach's QBI, free of shear and with the
/// material's Poisson ratio across, so that one element through the depth bends exactly. Curvature: the same patterns
/// of the nodal spins. Transverse shear: taken on the four sides and interpolated (Dvorkin and Bathe, MITC4). Patterns
/// take the Jacobian at the centre, transverse shear that of each point; patch tests of membrane and bending are exact
/// on any flat mesh. There are no hourglass modes and no hourglass forces.
///
/// `shell.drilling` > 0 resists, at each node, the spin about the normal that differs from the in-plane rotation of the
/// element there (Hughes and Brezzi 1989, with the rotation of the bending patterns included, so that in-plane bending
/// meets no resistance); it vanishes in any rigid rotation and in any state of constant strain. Its moments are kept in
/// the state (ShellLayout::hourglass), its energy as hourglass energy. `shell.warping_stiffness` (IHQ 8): in a warped
/// element the part of a nodal spin about the normal of the surface at that node bends nothing; only what is relative
/// to the spin of the element is taken out, so that rigid rotations of warped elements strain nothing (full
/// projection). Without it a node's drilling spin bends a warped element.
///
/// Frame, mid-step rates, forces at the end, thickness update, stable step, bulk viscosity and mass are those of
/// shell_cycle. An element is deleted when all layers of all four columns have failed, or its stable step falls below
/// the law's deletion step. Sources: Engelmann, Whirley, Goudreau 1989; Dvorkin, Bathe, Eng. Comput. 1 (1984);
/// Belytschko, Bachrach, CMAME 54 (1986); Hughes, Brezzi, CMAME 72 (1989); docs/theory/shell.md#fully-integrated-shell.
///
/// Instantiated for R = NativeBatch with Elastic, PlasticKinematic, PiecewiseLinear, ComposedLaw, Laminate; SingleBatch
/// with the first three.
template <class R, class Law>
NodalForces<R, 4> full_shell_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                   const NodalMotion<R, 4>& nodes, double dt, Number<R>* state);

}  // namespace nugget::kernel
