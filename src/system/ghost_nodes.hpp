// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/row.hpp"

namespace nugget::system {

class Share;

/// Nodes at which a rank looks without following them: their rows come from the ranks that answer for
/// them. All ranks call these functions together.
class GhostNodes {
 public:
  /// `nodes`: at which this rank looks, in any order; those that it follows are left out.
  void ask_for(const Share& share, std::vector<int> nodes);
  /// Rows of the nodes asked for, as the ranks that follow them have them.
  void fetch(const Share& share, std::span<Row> x, std::span<Row> v);
  std::size_t size() const;  ///< nodes of others that this rank asked for

 private:
  struct Three {
    double x, y, z;
  };
  std::vector<std::vector<int>> wanted_, given_;       ///< nodes, by rank: from it, to it
  std::vector<std::vector<Three>> arrived_, leaving_;  ///< of these a place and a velocity each
};

}  // namespace nugget::system
