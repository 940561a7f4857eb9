// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "base/bvh.hpp"
#include "weld/tie/surroundings.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Adds to `ties` those of *CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED: nodes of parts that touch other parts, or
/// themselves, follow the segment that they touch, with their gap as a lever. A node touches a segment if it lies over
/// it and the two surfaces, half a contact thickness off the nodes, are at most CLOSE apart or overlap. Which side
/// follows goes by part: parts are put in an order in which, but for the first, each touches one before it, the coarser
/// ones as early as that allows, and a node follows the part that comes first. Where that leaves a place without a tie
/// since its nodes are held or follow another part, the other side follows. `ties` stays ascending by node, each once;
/// nodes that are tied, held or driven otherwise are left alone, but for SPCs that hold nothing that those of the
/// segment do not. `x`: places of the nodes [length]. Theory: docs/theory/ties.md#parts-that-touch.
void tie_touching(const model::Model& model, const Surroundings& around, const std::vector<Vec3d>& x,
                  std::vector<Tie>& ties, Findings& findings);

/// Two parts that such a contact ties to each other, and where.
struct TouchingParts {
  Index contact = none;
  Index part = none,
        on = none;  ///< whose nodes follow, and what they follow; none: a segment of neither shell nor brick
  int nodes = 0;
  Box box;                               ///< of these nodes [length]
  double closest = 0.0, farthest = 0.0;  ///< from surface to surface; negative: they overlap [length]
};
/// By contact, `part` and `on`.
std::vector<TouchingParts> touching_parts(const model::Model& model, const std::vector<Tie>& ties,
                                          const std::vector<Vec3d>& x);
/// `part 2 on part 1: 40 nodes from (...) to (...), surfaces 0.02 apart`.
std::string describe(const model::Model& model, const TouchingParts& pair);

}  // namespace nugget::weld
