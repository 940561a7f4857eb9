// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// What the tie search has to know about each node, one entry a node.
struct Surroundings {
  explicit Surroundings(const model::Model& model);

  std::vector<double>
      thickness;              ///< t_s: diameter of beams, thickness of shells at the node, the largest; 0 else [length]
  std::vector<char> rotates;  ///< belongs to a beam, a shell that bends, or an adhesive brick between shells
  std::vector<char> of_weld;  ///< belongs to a beam or brick of spot-weld material
  std::vector<Index> shell;   ///< the first shell at the node, or none
  std::vector<Index> rigid_body;  ///< that carries it, or none
};

}  // namespace nugget::weld
