// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "system/state.hpp"

namespace nugget::system {

/// A group of elements that has to look at all of them before the blocks go their ways.
class BeforeCycle {
 public:
  /// `now` as in ElementGroup::cycle.
  virtual void before_cycle(const State& now) = 0;
  /// Whether it looks at more than its elements' own nodes.
  virtual bool looks_at_neighbours() const = 0;

 protected:
  ~BeforeCycle() = default;
};

}  // namespace nugget::system
