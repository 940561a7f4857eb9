// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Which welds stand above each other: a spot through three sheets is two welds that meet in the middle one. Two welds
/// are of one stack if they share a node, or are attached to a common sheet no further apart than half the smaller
/// diameter.
class Stacks {
 public:
  Stacks(const Ties& ties, std::size_t nodes);
  /// The first weld of the stack that weld `w` belongs to.
  std::size_t of(std::size_t w) const { return root_[w]; }
  /// The parts that the stack of weld `w` joins, ascending.
  const std::vector<Index>& sheets(std::size_t w) const { return sheets_[root_[w]]; }

 private:
  std::size_t root(std::size_t w) const;
  void join(std::size_t a, std::size_t b);

  std::vector<std::size_t> root_;
  std::vector<std::vector<Index>> sheets_;  // at the first weld of each stack
};

}  // namespace nugget::weld
