// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/finding.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_TIED_NODES_FAILURE: nodes at one place that move as one until the mesh tears there. While they do, the
/// failure variable of the elements around them is averaged by volume; where that mean reaches `failure`, the nodes of
/// the elements whose own value has reached it are free.
struct TiedNodes {
  int set = 0;                            ///< NSID
  std::vector<Index> nodes;               ///< of the set; once the model is checked those of one place, two at least
  double failure = 0.0;                   ///< EPPF: plastic strain, of GISSMO its damage [1]
  ElementKind kind = ElementKind::shell;  ///< ETYPE: elements that count
  Place place;
};

}  // namespace nugget::model
