// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_LINEAR_GLOBAL, _LOCAL, or what *CONSTRAINED_NODE_SET says of one node and direction: a linear equation
/// between displacements (or rotations) of nodes,
///     sum of factor times (direction . u) = 0.
struct LinearConstraint {
  struct Term {
    Index node = none;
    bool rotation = false;
    Vec3d direction;      ///< unit, at time 0
    double factor = 0.0;  ///< COEF [1]; of a rotation among displacements [length]
  };
  std::string keyword;  ///< with its star, for findings
  int id = 0;           ///< LCID, CNSID
  std::vector<Term> terms;
  Place place;
};

}  // namespace nugget::model
