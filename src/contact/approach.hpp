// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/archive.hpp"
#include "base/bvh.hpp"
#include "base/row.hpp"

namespace nugget::contact {

/// How far points of a surface can have come towards each other: judged by the box of all their displacements, so that
/// a motion of the surface as a whole does not count.
class Approach {
 public:
  /// From here on, with these nodes.
  void start(std::vector<int> nodes, std::span<const Row> x);
  /// The nodes moved to `x`.
  void update(std::span<const Row> x);

  /// No two points have approached each other by more since start() [length].
  double since_start() const { return since_start_; }
  /// The same since the beginning, step by step: never less than what any two have approached between two calls
  /// [length].
  double travelled() const { return travelled_; }

  void archive(Archive& a);

 private:
  std::vector<int> nodes_;
  std::vector<Row> start_, last_;
  double since_start_ = 0.0, travelled_ = 0.0;
};

}  // namespace nugget::contact
