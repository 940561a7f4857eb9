// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "system/system.hpp"

namespace nugget::impact {

/// What the bricks of free rows allow.
struct FreeBricks {
  double step = 0.0;         ///< the longest stable one [time]
  model::Index element = 0;  ///< the brick with most of the energy of their fastest vibration
  model::Index part = 0;
};

/// The stable step of bricks that stand alone or in a row with free sides (each of their nodes has at most two bricks).
/// These breathe faster than V / A_max over the speed of a plane wave says, which bricks in a mesh do not
/// (docs/theory/time_step.md#free-bricks). Nothing where there are none that can move.
///
/// Their highest frequency at the start, by power iteration on M^-1 K: K of the uniform strains of these bricks alone,
/// M the masses of all that follows their nodes; nodes that are held, driven or follow others stand still. All that
/// leaves out stiffness and never mass, so the frequency is at most the true one. The linear bulk viscosity counts by
/// what it damps of that vibration while it compresses, which is more than in a plane wave.
std::optional<FreeBricks> free_brick_step(const system::System& system);

}  // namespace nugget::impact
