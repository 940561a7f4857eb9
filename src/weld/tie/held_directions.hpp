// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Directions in which SPCs hold nodes from the start on.
class HeldDirections {
 public:
  explicit HeldDirections(const model::Model& model);

  bool any(Index node) const { return of_.contains(node); }
  /// Whether all that the SPCs of the tied node hold is held by those of the nodes that it follows, so that it stays
  /// held when it does. `x`: places of all nodes [length].
  bool hold_alike(const Tie& tie, const std::vector<Vec3d>& x) const;

 private:
  struct Node {
    std::vector<Vec3d> translation, rotation;  ///< orthonormal each
  };
  bool holds(Index node, bool rotation, const Vec3d& direction) const;

  std::map<Index, Node> of_;
};

}  // namespace nugget::weld
