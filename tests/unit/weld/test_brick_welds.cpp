// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "assembly.hpp"
#include "base/index.hpp"
#include "weld/audit/audit.hpp"
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

/// Two sheets of 1.5, `height` apart, and n x n columns of `layers` bricks of 2 x 2 between them; `turned`: the bricks'
/// own third direction lies in the sheets.
struct Layered : Stack {
  std::vector<std::vector<Index>> grid;  ///< nodes by layer

  Layered(int layers, int n, double height = 1.5, bool turned = false) : Stack({0.0, height}, 0, false) {
    for (double& t : model.shells.thickness) t = 1.5;
    for (int k = 0; k <= layers; ++k) {
      grid.emplace_back();
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) grid.back().push_back(node({11.0 + 2 * i, 11.0 + 2 * j, height * k / layers}));
    }
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const int a = j * (n + 1) + i, b = a + n + 1;
          const auto &low = grid[k], &up = grid[k + 1];
          if (turned)
            solid({low[a], up[a], up[a + 1], low[a + 1], low[b], up[b], up[b + 1], low[b + 1]});
          else
            solid({low[a], low[a + 1], low[b + 1], low[b], up[a], up[a + 1], up[b + 1], up[b]});
        }
    tie({bricks}, sheets);
  }
  /// The nodes of all layers but the outer ones stand where they stood and are tied to nothing; the outer ones are
  /// tied.
  void expect_outer_nodes_tied(const Ties& ties) const {
    std::vector<Index> outer = grid.front(), tied;
    outer.insert(outer.end(), grid.back().begin(), grid.back().end());
    for (const Tie& t : ties.ties) {
      tied.push_back(t.node);
      EXPECT_EQ(t.part, sheets[t.node < grid.back().front() ? 0 : 1]) << t.node;
    }
    EXPECT_THAT(tied, ::testing::UnorderedElementsAreArray(outer));
    for (std::size_t n = 0; n < ties.x.size(); ++n)
      EXPECT_LT(norm(ties.x[n] - model.nodes.x[n]), 1e-12) << model.nodes.id[n];
  }
};

// Nodes in the middle are in reach of a sheet here (0.6 x 1.5), and belong to none. Sabotage: they are tied, as all in
// reach.
TEST(BrickWelds, NodesBetweenLayersBelongToNoSheet) {
  for (const int layers : {1, 2, 3})
    for (const int n : {1, 2})
      for (const bool turned : {false, true}) {
        if (layers * n * n > 16) continue;
        SCOPED_TRACE(::testing::Message() << layers << " layers of " << n << " x " << n << (turned ? ", turned" : ""));
        Layered a(layers, n, 1.5, turned);
        const Ties ties = a.tied();
        a.expect_outer_nodes_tied(ties);
        ASSERT_EQ(ties.welds.size(), 1u);
        const Weld& w = ties.welds[0];
        EXPECT_TRUE(w.tied);
        EXPECT_EQ(w.ends.size(), 2 * a.grid[0].size());
        EXPECT_NEAR(w.length, 1.5, 1e-12);
        EXPECT_EQ(w.sheets, (std::array<Index, 2>{a.sheets[0], a.sheets[1]}));
        EXPECT_EQ(text(a.findings).find("warning"), std::string::npos) << text(a.findings);
      }
}

// Two contacts, one a sheet: the middle is in reach in both.
TEST(BrickWelds, NodesBetweenLayersBelongToNoSheetInAnyContact) {
  Layered a(3, 1);
  a.model.contacts.clear();
  for (const Index sheet : a.sheets) a.tie({a.bricks}, {sheet});
  const Ties ties = a.tied();
  a.expect_outer_nodes_tied(ties);
  EXPECT_TRUE(ties.welds[0].tied);
}

// 32 and 48 bricks are more than one weld has: each is one, and holds on by its face on a sheet and by its neighbours.
TEST(BrickWelds, BricksInsideALargeNuggetAreHeldByTheirNeighbours) {
  for (const int layers : {2, 3}) {
    Layered a(layers, 4);
    const Ties ties = a.tied();
    a.expect_outer_nodes_tied(ties);
    ASSERT_EQ(ties.welds.size(), at(16 * layers));
    for (const Weld& w : ties.welds) {
      EXPECT_TRUE(w.tied) << w.id;
      EXPECT_EQ(w.ends.size(), 8u);
      for (const Projection& p : w.ends) EXPECT_TRUE(p.tied) << w.id << ": " << p.reason;
    }
    EXPECT_THAT(text(a.findings), HasSubstr("more than the 16"));
    EXPECT_EQ(text(a.findings).find("not tied"), std::string::npos) << text(a.findings);
    const auto inner = [](const Projection& p) { return p.reason.starts_with("inside the nugget"); };
    const Weld& first = ties.welds.front();
    EXPECT_EQ(std::count_if(first.ends.begin(), first.ends.end(), inner), 4);
    EXPECT_EQ(first.sheets, (std::array<Index, 2>{a.sheets[0], none}));
    for (const Report& report : audit(a.model, ties, a.findings))
      for (const Remark& remark : report.remarks) EXPECT_NE(remark.check->name, "sheets") << remark.text;
  }
}

// Sabotage: neighbours that are held by nothing hold.
TEST(BrickWelds, BricksThatNoContactTracksHoldNoNeighbours) {
  Layered a(3, 4);
  a.model.contacts.clear();
  for (const Weld& w : a.tied().welds) EXPECT_FALSE(w.tied) << w.id;
}

// Sheets 1 apart, a flat brick near the lower one: both faces are nearest to that, the upper one goes to the other.
TEST(BrickWelds, FacesOfAFlatBrickGoToTwoSheets) {
  Layered a(1, 1, 1.0);
  for (const Index n : a.grid[0]) a.model.nodes.x[n].z = 0.05;
  for (const Index n : a.grid[1]) a.model.nodes.x[n].z = 0.45;
  const Ties ties = a.tied();
  EXPECT_TRUE(ties.welds[0].tied) << text(a.findings);
  EXPECT_EQ(ties.welds[0].sheets, (std::array<Index, 2>{a.sheets[0], a.sheets[1]}));
  EXPECT_NEAR(ties.welds[0].length, 1.0, 1e-12);
}

// One sheet only: the farther face stays free, and the weld is reported.
TEST(BrickWelds, ABrickOverOneSheetIsNotTied) {
  Layered a(1, 1, 0.5);
  a.model.contacts[0].b.parts = {a.sheets[0]};
  const Ties ties = a.tied();
  EXPECT_FALSE(ties.welds[0].tied);
  EXPECT_EQ(ties.ties.size(), 4u);
  EXPECT_THAT(text(a.findings), HasSubstr("holds the weld's other end"));
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

// Sabotage: the axes most across r are compared to the last digit.
TEST(BrickSection, AxesOfAClusterHaveNothingToDoWithRoundOff) {
  for (const double lost : {1e-15, -1e-12}) {
    Stack a({0.0, 1.0}, 2);
    const Ties ties = a.tied();
    std::vector<Vec3d> start = ties.x, x;
    for (Vec3d& p : start) p.z += lost * p.x;
    const BrickSection section(ties.welds[0], start);
    for (Index n : section.nodes()) x.push_back(start[n]);
    EXPECT_NEAR(section.shape(x).axes.e2.x, 1.0, 1e-9);
  }
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
