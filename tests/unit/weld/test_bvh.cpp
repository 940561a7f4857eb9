// SPDX-License-Identifier: Apache-2.0
#include "base/bvh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace nugget {
namespace {

std::vector<Box> random_boxes(int count, double largest) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(0.0, 100.0), size(0.0, largest);
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    box.low = {place(random), place(random), place(random)};
    box.high = box.low + Vec3d{size(random), size(random), size(random)};
  }
  return boxes;
}

std::vector<int> overlapping(const BoxTree& tree, const Box& query) {
  std::vector<int> found;
  tree.overlapping(query, [&](int item) { found.push_back(item); });
  return found;
}

TEST(BoxTree, FindsEveryOverlapThatBruteForceFinds) {
  for (const int count : {1, 2, 4, 5, 17, 1000}) {
    const std::vector<Box> boxes = random_boxes(count, 12.0);
    const BoxTree tree(boxes);
    int hits = 0;
    for (const Box& query : random_boxes(200, 20.0)) {
      std::vector<int> expected;
      for (int i = 0; i < count; ++i)
        if (boxes[i].overlaps(query)) expected.push_back(i);
      hits += static_cast<int>(expected.size());
      EXPECT_THAT(overlapping(tree, query), testing::UnorderedElementsAreArray(expected));
    }
    EXPECT_GT(hits, 0);
  }
}

TEST(BoxTree, KeepsNumbersThatWereGiven) {
  const std::vector<Box> boxes = random_boxes(100, 12.0);
  std::vector<BoxTree::Entry> entries;
  for (int i = 0; i < 100; ++i) entries.push_back({boxes[i], 3 * i + 5});
  const BoxTree plain(boxes), numbered(std::move(entries));
  for (const Box& query : random_boxes(20, 20.0)) {
    std::vector<int> expected = overlapping(plain, query);
    for (int& item : expected) item = 3 * item + 5;
    EXPECT_EQ(overlapping(numbered, query), expected);
  }
  EXPECT_TRUE(BoxTree(std::vector<BoxTree::Entry>{}).empty());
}

TEST(BoxTree, FindsTheNearestThatBruteForceFinds) {
  const std::vector<Box> boxes = random_boxes(1000, 3.0);
  const BoxTree tree(boxes);
  for (const Box& query : random_boxes(200, 0.0)) {
    const auto distance = [&](int i) { return std::sqrt(boxes[i].distance_squared(query.low)); };
    int expected = 0;
    for (int i = 1; i < 1000; ++i)
      if (distance(i) < distance(expected)) expected = i;
    const auto found = tree.nearest(query.low, Box::infinity, distance);
    EXPECT_EQ(found.item, expected);
    EXPECT_EQ(found.distance, distance(expected));
    EXPECT_EQ(tree.nearest(query.low, 0.5 * distance(expected), distance).item,
              distance(expected) > 0.0 ? -1 : expected);
  }
}

TEST(BoxTree, TakesTheLowestOfEquallyNearItems) {
  const std::vector<Box> boxes(100, Box{{1, 1, 1}, {2, 2, 2}});
  const BoxTree tree(boxes);
  const auto all_equal = [](int) { return 1.0; };
  const auto odd_only = [](int i) { return i % 2 == 1 ? 1.0 : Box::infinity; };
  EXPECT_EQ(tree.nearest({1, 1, 0}, 5.0, all_equal).item, 0);
  EXPECT_EQ(tree.nearest({1, 1, 0}, 5.0, odd_only).item, 1);
  EXPECT_EQ(overlapping(tree, boxes[0]).size(), 100u);
}

TEST(BoxTree, TouchingBoxesOverlapAndAnEmptyTreeFindsNothing) {
  const BoxTree tree(std::vector<Box>{{{0, 0, 0}, {1, 1, 1}}});
  EXPECT_EQ(overlapping(tree, Box{{1, 1, 1}, {2, 2, 2}}).size(), 1u);
  EXPECT_TRUE(overlapping(tree, Box{{1.001, 1, 1}, {2, 2, 2}}).empty());
  EXPECT_TRUE(overlapping(BoxTree{}, Box{{0, 0, 0}, {9, 9, 9}}).empty());
  EXPECT_EQ(BoxTree{}.nearest({0, 0, 0}, 9.0, [](int) { return 0.0; }).item, -1);
}

}  // namespace
}  // namespace nugget
