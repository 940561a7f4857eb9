// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/finding.hpp"
#include "nvh/matrices/matrices.hpp"

namespace nugget::nvh {

/// What is joined by stiffness and can move as a rigid body without straining anything.
struct LooseBody {
  std::size_t unknowns = 0;
  int ways = 0;   ///< how many such motions there are, 1 to 6
  int node = 0;   ///< of the system, that moves most in one of them,
  Vec3d along{};  ///< and in which direction
};

/// All of them, by the first of their unknowns. A motion counts where K moves no unknown by more than round-off; so
/// none is found where something resists it, however soft that is. Mechanisms inside of a body are not looked for.
std::vector<LooseBody> find_loose_bodies(const Matrices& matrices);

/// An error for them: linear statics has no answer.
void check_support(const Matrices& matrices, Findings& findings);

}  // namespace nugget::nvh
