// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "output/history.hpp"

namespace nugget::output {

/// What a prescribed motion does to one node.
struct BndoutNode {
  int node = 0;         ///< user id
  Vec3d force;          ///< global axes [force]
  double energy = 0.0;  ///< work done so far [force length]
  int set = 0;          ///< node set of the card, 0 without one
};

/// What a prescribed motion does to one rigid part.
struct BndoutBody {
  int part = 0;  ///< user id
  Vec3d force, moment;
  double energy = 0.0;
};

struct BndoutState {
  double time = 0.0;
  std::vector<BndoutNode> nodes;   ///< the same in every state
  std::vector<BndoutBody> bodies;  ///< the same in every state
};

/// Sum of forces and energies of a table of bndout.
struct BndoutTotal {
  Vec3d force;
  double energy = 0.0;
};
BndoutTotal total(std::span<const BndoutNode> nodes);
BndoutTotal total(std::span<const BndoutBody> bodies);

/// The file `bndout`, section of the prescribed motions.
const HistoryFormat<BndoutState>& bndout();

}  // namespace nugget::output
