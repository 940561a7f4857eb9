// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "output/d3plot.hpp"
#include "system/system.hpp"

namespace nugget::output {

/// Stress and plastic strain of a brick, forces and moments of a beam and of a shell, as their kernels hold them;
/// `points` (BEAMIP) and `layers` (MAXINT, see output::shell_layers) are filled. All 0 where the element has no kernel.
/// Of the shell's record the forces and moments only.
StressRecord solid_stress(const system::System& system, const system::State& state,
                          const system::System::ElementLocation& location);
BeamRecord beam_forces(const system::System& system, const system::State& state,
                       const system::System::ElementLocation& location, std::span<BeamPointRecord> points);
ShellRecord shell_forces(const system::System& system, const system::State& state,
                         const system::System::ElementLocation& location, std::span<StressRecord> layers);
/// The layers of a thick shell, as MAXINT wants them.
void thick_shell_stresses(const system::System& system, const system::State& state,
                          const system::System::ElementLocation& location, std::span<StressRecord> layers);

/// These of all elements. Sizes the records.
void fill_stresses(const system::System& system, const system::State& state, D3plotState& into);

/// A layer as results show it. A shell's kernel has the stress G gamma across it and its force SHRF times the integral
/// of that; results have the stress SHRF G gamma, whose integral is the force, as LS-DYNA's have
/// (docs/evidence/decks.md).
system::ElementGroup::Layer shown_layer(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                        int layer, const system::State& state);

/// The stress that a layer has when it is given one as results show it (*INITIAL_STRESS_SHELL).
std::array<double, 6> stress_of_kernel(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                       const system::State& state, const std::array<double, 6>& shown);

/// Components of a symmetric tensor xx yy zz xy yz zx along other axes.
std::array<double, 6> along(const Frame3d& axes, const std::array<double, 6>& tensor);

/// Local axes of a shell in results: in its plane, x from its first node to the second; with INN 2 and 4 of
/// *CONTROL_ACCURACY those that do not depend on which node is the first. Nothing for other elements.
std::optional<Frame3d> shell_axes(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                  const system::State& state);

/// Axes in which elout has a layer of a shell, as EOCS and CMPFLG want them; nothing: the global ones.
std::optional<Frame3d> axes_in_elout(const system::System& system, const system::ElementGroup& group, std::size_t e,
                                     int layer, const system::State& state);
/// The layers of a shell as LS-DYNA lists them in elout: of Gauss's rule with an odd number of points the middle one
/// first, then from the bottom up.
std::vector<int> layers_in_elout(const model::Model& model, const system::ElementGroup& group);

/// A tensor as CMPFLG of *DATABASE_EXTENT_BINARY wants it: along the material's axes where it has some.
std::array<double, 6> by_cmpflg(const model::Model& model, const system::ElementGroup& group, std::size_t e, int layer,
                                const system::State& state, const std::array<double, 6>& tensor);

}  // namespace nugget::output
