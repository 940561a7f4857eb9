// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nvh/eigen/modes.hpp"

namespace nugget::nvh {

/// What becomes of the modes of a structure when welds are taken out of it, without solving it anew; one entry a mode.
struct WeldDrop {
  /// omega^2 by first-order perturbation, omega^2 (1 + phi^t M_w phi) - phi^t K_w phi: twice the weld's own strain
  /// energy. Right for a weld that is made a little softer; a stiff weld stores next to nothing, so that this says next
  /// to nothing about its absence.
  std::vector<double> first_order;
  /// omega^2 without the welds, of the mode that is most alike: Rayleigh and Ritz on all modes that are known, the
  /// static answers to the loads that the welds can transmit, and the answers to the inertia of those.
  std::vector<double> eigenvalue;
  std::vector<double> mac;  ///< MAC of that mode with the one of the whole structure, in the inner product of M
  /// omega^2 of modes that are like none of the whole structure, such as a flange that flaps when its weld is gone;
  /// those below the last mode that is known.
  std::vector<double> new_modes;
};

/// Below this likeness a mode is not the one of before.
inline constexpr double same_mode_mac = 0.5;

/// Which welds go together, by their place in Ties::welds.
using WeldGroup = std::vector<std::size_t>;

/// Whether a weld is made of elements, so that it has a stiffness that can be taken out.
bool can_drop(const system::System& system, std::size_t weld);

/// One entry for each group. `modes` must be the lowest ones. Costs one factorization and twelve solutions for each
/// weld beam (bricks: two for each way in which they can deform). Throws Factorization::SolverError.
std::vector<WeldDrop> drop_welds(const Matrices& matrices, const Modes& modes, const std::vector<WeldGroup>& groups,
                                 const ProgressCallback& progress = {});

}  // namespace nugget::nvh
