// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/finding.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_INTERPOLATION: a node that moves with the rigid motion which fits the translations of others best,
/// each counted by its weight (RBE3). Loads on it go to them in the same proportion.
struct Interpolation {
  int id = 0;
  Index node = none;
  bool rotations = true;  ///< DDOF 123456; else 123, the node's spin is its own
  std::vector<Index> independent;
  std::vector<double> weight;  ///< adding up to 1
  Place place;
};

}  // namespace nugget::model
