// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "assembly.hpp"
#include "base/index.hpp"
#include "weld/failure/brick_section.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Sheets at the heights `z` and n x n bricks of 2 x 2 between each pair of neighbours, on shared nodes.
struct Stack : Assembly {
  std::vector<Index> sheets;
  Index bricks;
  Findings findings;

  Stack(const std::vector<double>& z, int n, bool tied = true) {
    for (double height : z) sheets.push_back(sheet(1.0, {0, 0, height}));
    bricks = solid_part();
    std::vector<Index> grid;
    for (double height : z)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) grid.push_back(node({13.0 + 2 * i, 13.0 + 2 * j, height}));
    const auto corner = [&](std::size_t k, int i, int j) {
      return grid[k * at((n + 1) * (n + 1)) + at(j * (n + 1) + i)];
    };
    for (std::size_t k = 0; k + 1 < z.size(); ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          solid({corner(k, i, j), corner(k, i + 1, j), corner(k, i + 1, j + 1), corner(k, i, j + 1),
                 corner(k + 1, i, j), corner(k + 1, i + 1, j), corner(k + 1, i + 1, j + 1), corner(k + 1, i, j + 1)});
    if (tied) tie({bricks}, sheets);
  }
  void solid(const std::array<Index, 8>& nodes) {
    model.solids.id.push_back(2000 + static_cast<int>(model.solids.size()));
    model.solids.part.push_back(bricks);
    model.solids.node.push_back(nodes);
    model.solids.place.push_back(0, 0);
  }
  Ties tied() { return weld::tie(model, findings); }
};

TEST(BrickWelds, BricksBetweenTwoSheetsThatShareNodesAreOneWeld) {
  Stack a({0.0, 1.0}, 2);
  const Ties ties = a.tied();
  ASSERT_EQ(ties.welds.size(), 1u);
  const Weld& w = ties.welds[0];
  EXPECT_EQ(w.kind, Weld::Kind::assembly);
  EXPECT_EQ(w.id, 2000);
  EXPECT_THAT(w.elements, ElementsAre(0, 1, 2, 3));
  EXPECT_EQ(w.facets[0].size(), 4u);
  EXPECT_EQ(w.face[1].size(), 9u);
  EXPECT_EQ(w.ends.size(), 18u);
  EXPECT_TRUE(w.tied);
  EXPECT_NEAR(w.diameter, std::sqrt(4 * 16.0 / 3.14159265358979), 1e-9);
  EXPECT_NEAR(w.length, 1.0, 1e-12);
  EXPECT_THAT(text(a.findings), HasSubstr("1 weld recognised as assemblies"));
}

TEST(BrickWelds, BricksStackedThroughAMiddleSheetAreTwoWelds) {
  Stack a({0.0, 1.0, 2.0}, 2);
  const Ties ties = a.tied();
  ASSERT_EQ(ties.welds.size(), 2u);
  EXPECT_EQ(ties.welds[0].sheets, (std::array<Index, 2>{a.sheets[0], a.sheets[1]}));
  EXPECT_EQ(ties.welds[1].sheets, (std::array<Index, 2>{a.sheets[1], a.sheets[2]}));
  EXPECT_EQ(ties.welds[1].elements.size(), 4u);
}

TEST(BrickWelds, TwoLayersBetweenTwoSheetsAreOneWeld) {
  Stack a({0.0, 1.0}, 1);
  auto& n = a.model.solids.node[0];
  std::array<Index, 4> middle{};
  for (std::size_t i = 0; i < 4; ++i) {
    Vec3d x = a.model.nodes.x[n[i]];
    x.z = 0.5;
    middle[i] = a.node(x);
  }
  const std::array<Index, 8> upper{middle[0], middle[1], middle[2], middle[3], n[4], n[5], n[6], n[7]};
  for (std::size_t i = 0; i < 4; ++i) n[4 + i] = middle[i];
  a.solid(upper);
  a.model.contacts[0].thickness_a = a.model.contacts[0].thickness_b = -0.1;  // the middle reaches no sheet
  const Ties ties = a.tied();
  ASSERT_EQ(ties.welds.size(), 1u);
  const Weld& w = ties.welds[0];
  EXPECT_EQ(w.face[0].size(), 4u);
  EXPECT_EQ(w.ends.size(), 8u);
  EXPECT_TRUE(w.tied);  // by its ends
  EXPECT_NEAR(w.length, 1.0, 1e-12);
}

TEST(BrickWelds, MoreThanSixteenBricksAreNoWeld) {
  Stack a({0.0, 1.0}, 5);
  EXPECT_EQ(a.tied().welds.size(), 25u);
  EXPECT_THAT(text(a.findings), HasSubstr("25 bricks of part 3 share nodes, from brick 2000 on: more than the 16"));
}

TEST(BrickWelds, ADefinedAssemblyHasItsOwnId) {
  Stack a({0.0, 1.0}, 2);
  a.model.hex_assemblies.push_back({77, {3, 2, 1, 0}, {}, {none, none}, {}});
  const Ties ties = a.tied();
  ASSERT_EQ(ties.welds.size(), 1u);
  EXPECT_EQ(ties.welds[0].id, 77);
  EXPECT_THAT(ties.welds[0].elements, ElementsAre(3, 2, 1, 0));
  EXPECT_EQ(a.findings.all().size(), 1u) << text(a.findings);  // nodes tied; nothing recognised
}

TEST(BrickWelds, AClusterThatIsTiedToNothingHasItsOuterFacesAsEnds) {
  Stack a({0.0, 5.0}, 2, false);  // longer than wide
  const Ties ties = a.tied();
  ASSERT_EQ(ties.welds.size(), 1u);
  EXPECT_NEAR(ties.welds[0].length, 5.0, 1e-12);
  EXPECT_FALSE(ties.welds[0].tied);
}

/// Forces on the section's nodes, by a function of their place.
template <class Force>
BrickSection::Load loaded(const BrickSection& section, const std::vector<Vec3d>& x, const Force& force) {
  std::vector<Vec3d> place, f;
  for (Index n : section.nodes()) {
    place.push_back(x[n]);
    f.push_back(force(place.back()));
  }
  return section.load(section.shape(place), place, f);
}

TEST(BrickSection, AxesLengthAndArea) {
  Stack a({0.0, 1.0}, 2);
  const Ties ties = a.tied();
  const BrickSection section(ties.welds[0], ties.x);
  std::vector<Vec3d> x;
  for (Index n : section.nodes()) {
    x.push_back(ties.x[n]);
    x.back() += 0.2 * x.back().z * Vec3d{1, 0, 0};  // sheared: r stays, the line of centres does not
  }
  const BrickSection::Shape shape = section.shape(x);
  EXPECT_NEAR(shape.axes.e1.z, 1.0, 1e-12);
  EXPECT_NEAR(shape.axes.e2.x, 1.0, 1e-12);
  EXPECT_NEAR(shape.length, 1.0, 1e-12);
  EXPECT_NEAR(shape.area, 16.0, 1e-12);
  EXPECT_NEAR(shape.centre[1].x - shape.centre[0].x, 0.2, 1e-12);
}

TEST(BrickSection, AShearForceHasItsMomentAtTheEnds) {
  Stack a({0.0, 2.0}, 1);
  const Ties ties = a.tied();
  const BrickSection section(ties.welds[0], ties.x);
  // 100 along x on each of the four nodes above, back below; and what holds the couple: 100 up and down on the sides.
  const auto load = loaded(section, ties.x, [](const Vec3d& x) {
    const double up = x.z > 1.0 ? 1.0 : -1.0, right = x.x > 14.0 ? 1.0 : -1.0;
    return Vec3d{100.0 * up, 0.0, -100.0 * right};
  });
  EXPECT_NEAR(load.middle.shear_s, 400.0, 1e-9);
  EXPECT_NEAR(load.middle.axial, 0.0, 1e-9);
  EXPECT_NEAR(load.middle.moment_t, 0.0, 1e-9);
  // M = L/2 r x N about t, one way at the first end, the other way at the second.
  EXPECT_NEAR(load.moment_at_end[0].z, 400.0, 1e-9);
  EXPECT_NEAR(load.moment_at_end[1].z, -400.0, 1e-9);
}

}  // namespace
}  // namespace nugget::weld
