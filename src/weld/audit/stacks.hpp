// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Which of a number of things belong together.
class Joined {
 public:
  explicit Joined(std::size_t count);
  void join(std::size_t a, std::size_t b);
  /// The first of those that `a` belongs to.
  std::size_t first(std::size_t a) const;

 private:
  std::vector<std::size_t> root_;
};

/// Which welds stand above each other: a spot through three sheets is two welds that meet in the middle one. Two welds
/// are of one stack if they share a node, or are attached to a common sheet no further apart than half the smaller
/// diameter.
class Stacks {
 public:
  Stacks(const Ties& ties, std::size_t nodes);
  /// The first weld of the stack that weld `w` belongs to.
  std::size_t of(std::size_t w) const { return root_[w]; }
  /// The parts of the sheets that the stack of weld `w` joins, ascending; a part stands there once for each of its
  /// layers that welds of the stack join.
  const std::vector<Index>& sheets(std::size_t w) const { return sheets_[root_[w]]; }

 private:
  std::vector<std::size_t> root_;
  std::vector<std::vector<Index>> sheets_;  // at the first weld of each stack
};

}  // namespace nugget::weld
