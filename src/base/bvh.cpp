// SPDX-License-Identifier: Apache-2.0
#include "base/bvh.hpp"

#include <utility>

namespace nugget {
namespace {

/// Twice the coordinate of the box's centre along axis 0, 1 or 2.
double centre(const Box& box, int axis) {
  if (axis == 0) return box.low.x + box.high.x;
  if (axis == 1) return box.low.y + box.high.y;
  return box.low.z + box.high.z;
}

int longest_side(const Box& box) {
  const Vec3d side = box.high - box.low;
  if (side.x >= side.y && side.x >= side.z) return 0;
  return side.y >= side.z ? 1 : 2;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) {
  entries_.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) entries_.push_back({boxes[i], static_cast<int>(i)});
  grow();
}

BoxTree::BoxTree(std::vector<Entry> entries) : entries_(std::move(entries)) {
  grow();
}

void BoxTree::grow() {
  if (entries_.empty()) return;
  nodes_.reserve(entries_.size());
  grow(0, static_cast<int>(entries_.size()));
}

int BoxTree::grow(int begin, int end) {
  const int at = static_cast<int>(nodes_.size());
  nodes_.emplace_back();
  Box box, centres;
  for (int i = begin; i < end; ++i) {
    const Box& b = entries_[i].box;
    box.add(b);
    centres.add(b.low + b.high);
  }
  nodes_[at].box = box;
  nodes_[at].first = begin;
  if (end - begin <= leaf_size) {
    nodes_[at].count = end - begin;
    return at;
  }
  const int axis = longest_side(centres);
  const int middle = begin + (end - begin) / 2;
  // Equal centres are ordered by item, so that the tree is the same with every standard library.
  std::nth_element(entries_.begin() + begin, entries_.begin() + middle, entries_.begin() + end,
                   [axis](const Entry& a, const Entry& b) {
                     return std::pair(centre(a.box, axis), a.item) < std::pair(centre(b.box, axis), b.item);
                   });
  grow(begin, middle);
  const int right = grow(middle, end);
  nodes_[at].right = right;
  return at;
}

}  // namespace nugget
