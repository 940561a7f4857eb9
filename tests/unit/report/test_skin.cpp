// SPDX-License-Identifier: Apache-2.0
#include "report/skin.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace nugget::report {
namespace {

/// Two cubes, one on the other: nodes 0 to 3, 4 to 7, 8 to 11.
output::D3plotGeometry two_cubes() {
  output::D3plotGeometry g;
  g.solids = {{1, {0, 1, 2, 3, 4, 5, 6, 7}, 0}, {2, {4, 5, 6, 7, 8, 9, 10, 11}, 1}};
  return g;
}

std::set<int> corners(const Facet& facet) {
  return {facet.nodes.begin(), facet.nodes.end()};
}

TEST(Skin, FacesBetweenBricksAreNotSeen) {
  const std::vector<Facet> seen = facets(two_cubes(), {}, {3, 3}, 3);
  EXPECT_EQ(seen.size(), 10u);
  for (const Facet& facet : seen) {
    EXPECT_NE(corners(facet), (std::set<int>{4, 5, 6, 7}));
    EXPECT_EQ(facet.from, 0);
    EXPECT_EQ(facet.until, 3);
    EXPECT_FALSE(facet.of_shell);
  }
}

TEST(Skin, AFaceIsSeenWhenTheBrickBehindItIsDeleted) {
  const std::vector<Facet> seen = facets(two_cubes(), {}, {3, 1}, 3);
  EXPECT_EQ(seen.size(), 11u);
  const auto between = std::find_if(seen.begin(), seen.end(), [](const Facet& facet) {
    return corners(facet) == std::set<int>{4, 5, 6, 7};
  });
  ASSERT_NE(between, seen.end());
  EXPECT_EQ(between->element, 0);
  EXPECT_EQ(between->from, 1);
  EXPECT_EQ(between->until, 3);
  for (const Facet& facet : seen)
    if (facet.element == 1) {
      EXPECT_EQ(facet.until, 1);
    }
}

/// A wedge has two triangles and three quadrilaterals, a tetrahedron four triangles; triangles repeat their third node.
TEST(Skin, DegenerateBricksHaveTheFacesThatTheyShow) {
  output::D3plotGeometry g;
  g.solids = {{1, {0, 1, 2, 3, 4, 4, 5, 5}, 0}, {2, {10, 11, 12, 13, 13, 13, 13, 13}, 0}};
  std::size_t triangles = 0, quadrilaterals = 0, of_tetrahedron = 0;
  for (const Facet& facet : facets(g, {}, {1, 1}, 1)) {
    if (corners(facet).size() == 3) {
      EXPECT_EQ(facet.nodes[2], facet.nodes[3]);
    }
    of_tetrahedron += facet.element == 1;
    if (facet.element == 0) ++(corners(facet).size() == 3 ? triangles : quadrilaterals);
  }
  EXPECT_EQ(triangles, 2u);
  EXPECT_EQ(quadrilaterals, 3u);
  EXPECT_EQ(of_tetrahedron, 4u);
}

TEST(Skin, ShellsAreSeenFromBothSidesUntilTheyAreDeleted) {
  output::D3plotGeometry g;
  g.shells = {{7, {0, 1, 2, 3}, 0}, {8, {1, 4, 2, 2}, 0}};
  const std::vector<Facet> seen = facets(g, {2, 1}, {}, 2);
  ASSERT_EQ(seen.size(), 2u);
  EXPECT_TRUE(seen[0].of_shell);
  EXPECT_EQ(seen[1].until, 1);
}

}  // namespace
}  // namespace nugget::report
