// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "base/archive.hpp"
#include "system/system.hpp"

namespace nugget::impact {

/// Elements that become weaker beside deleted ones (SOFT of *MAT_ENHANCED_COMPOSITE_DAMAGE): what shares a node with a
/// deleted element of such a law learns of it. A crushed tube of fibres fails so layer by layer from its end.
class CrashFronts {
 public:
  explicit CrashFronts(const system::System& system);

  /// Call when elements have been deleted; the same on all ranks, each of which has the states of its own elements.
  void update(const system::System& system);

  void archive(Archive& a);

 private:
  struct Element {
    std::size_t group, element;
  };
  std::vector<std::size_t> groups_;              // of such laws
  std::map<int, std::vector<Element>> at_node_;  // their elements, by node
  std::vector<std::vector<char>> known_;         // by group and element: it was deleted already
};

}  // namespace nugget::impact
