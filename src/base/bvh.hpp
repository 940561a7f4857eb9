// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "base/vec3.hpp"

namespace nugget {

/// A box with sides along the global axes. Made empty; `add` makes it hold something.
struct Box {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3d low{infinity, infinity, infinity};
  Vec3d high{-infinity, -infinity, -infinity};

  void add(const Vec3d& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  void add(const Box& b) {
    add(b.low);
    add(b.high);
  }
  /// The box moved outward by `margin` on every side [length].
  Box grown(double margin) const {
    const Vec3d m{margin, margin, margin};
    return {low - m, high + m};
  }
  /// Touching counts.
  bool overlaps(const Box& b) const {
    return low.x <= b.high.x && b.low.x <= high.x && low.y <= b.high.y && b.low.y <= high.y && low.z <= b.high.z &&
           b.low.z <= high.z;
  }
  /// Square of the distance from `p` to the box; 0 inside [length^2].
  double distance_squared(const Vec3d& p) const {
    const Vec3d d{std::max({low.x - p.x, 0.0, p.x - high.x}), std::max({low.y - p.y, 0.0, p.y - high.y}),
                  std::max({low.z - p.z, 0.0, p.z - high.z})};
    return dot(d, d);
  }
};

/// A bounding-volume tree over boxes ("items", numbered as given): finds the boxes that a box overlaps and the item
/// that is nearest to a point. Built once by halving at the median centre along the longest side, so its depth is
/// logarithmic and its shape depends on the boxes alone. Queries may run side by side.
class BoxTree {
 public:
  struct Entry {
    Box box;
    int item = 0;
  };

  BoxTree() = default;
  explicit BoxTree(std::span<const Box> boxes);
  /// Of boxes whose items have numbers of their own, rising; keeps the list, in another order.
  explicit BoxTree(std::vector<Entry> entries);

  bool empty() const { return nodes_.empty(); }

  /// Calls `visit(item)` for each item whose box overlaps `query`, in an order that is fixed by the tree.
  template <class Visit>
  void overlapping(const Box& query, Visit&& visit) const;

  struct Nearest {
    int item = -1;  ///< -1: nothing within the bound
    double distance = std::numeric_limits<double>::infinity();
  };
  /// The item with the smallest `distance(item)` that does not exceed `bound`; of equal ones the lowest. `distance` may
  /// return infinity to leave an item out, and must not return less than the distance from `point` to the item's box.
  template <class Distance>
  Nearest nearest(const Vec3d& point, double bound, Distance&& distance) const;

 private:
  /// A leaf holds `count` items from `first`; an inner node (count 0) has its children right behind it and at `right`.
  struct Node {
    Box box;
    int first = 0, count = 0, right = 0;
  };
  static constexpr int leaf_size = 4;
  static constexpr std::size_t deepest = 64;  // halving at the median: depth <= log2(2^31) + 1

  void grow();
  int grow(int begin, int end);

  std::vector<Node> nodes_;
  std::vector<Entry> entries_;  // in the order of the leaves
};

template <class Visit>
void BoxTree::overlapping(const Box& query, Visit&& visit) const {
  if (empty()) return;
  std::array<int, deepest> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const int at = stack[--waiting];
    const Node& node = nodes_[at];
    if (!node.box.overlaps(query)) continue;
    for (int i = node.first; i < node.first + node.count; ++i)
      if (entries_[i].box.overlaps(query)) visit(entries_[i].item);
    if (node.count > 0) continue;
    stack[waiting++] = node.right;
    stack[waiting++] = at + 1;
  }
}

template <class Distance>
BoxTree::Nearest BoxTree::nearest(const Vec3d& point, double bound, Distance&& distance) const {
  Nearest best;
  if (empty()) return best;
  const auto within_bound = [&](const Box& box) {
    const double limit = std::min(bound, best.distance);
    return box.distance_squared(point) <= limit * limit;
  };
  std::array<int, deepest> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const int at = stack[--waiting];
    const Node& node = nodes_[at];
    if (!within_bound(node.box)) continue;
    for (int i = node.first; i < node.first + node.count; ++i) {
      if (!within_bound(entries_[i].box)) continue;
      const double d = distance(entries_[i].item);
      if (d > bound || d > best.distance || (d == best.distance && best.item >= 0 && entries_[i].item > best.item))
        continue;
      if (d < std::numeric_limits<double>::infinity()) best = {entries_[i].item, d};
    }
    if (node.count > 0) continue;
    // The nearer child first: it shortens the bound for the other.
    const int left = at + 1;
    const bool left_first = nodes_[left].box.distance_squared(point) <= nodes_[node.right].box.distance_squared(point);
    stack[waiting++] = left_first ? node.right : left;
    stack[waiting++] = left_first ? left : node.right;
  }
  return best;
}

}  // namespace nugget
