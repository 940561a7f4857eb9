// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/coarsening.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using model::Coarsening;
using test::Assembly;

/// A sheet of n x n shells of 5 mm; node (i, j) has the id 1 + j (n + 1) + i.
struct Sheet : Assembly {
  int n;
  Index part;
  explicit Sheet(int shells) : n(shells), part(sheet(1.0, {0, 0, 0}, shells, shells, 5.0)) { model.coarsen.on = true; }
  Index at(int i, int j) const { return j * (n + 1) + i; }
  int id(int i, int j) const { return 1 + at(i, j); }
};

double area(const std::array<Vec3d, 4>& c) {
  return 0.5 * norm(cross(c[2] - c[0], c[3] - c[1]));
}

/// The plan, when it is sound: shells in one block each, the same area, no node of a shell gone, no hanging node at the
/// end of another one's side, none on a corner.
Coarsening plan(const Assembly& a) {
  Findings findings;
  const Coarsening c = coarsening_of(a.model, tie(a.model, findings));
  const model::Shells& shells = a.model.shells;
  const auto place = [&](int id) { return a.model.nodes.x[a.model.node_index(id)]; };
  std::set<int> merged, corners, hanging, ends;
  std::map<int, int> left;  // nodes of shells that stay as they are
  for (const Coarsening::Merged& m : c.merged) {
    double sum = 0.0;
    for (const int e : m.shells) {
      EXPECT_TRUE(merged.insert(e).second) << "shell " << e << " twice";
      std::array<Vec3d, 4> x;
      for (std::size_t k = 0; k < 4; ++k) x[k] = a.model.nodes.x[shells.node[e - 1][k]];
      sum += area(x);
    }
    EXPECT_NEAR(area({place(m.nodes[0]), place(m.nodes[1]), place(m.nodes[2]), place(m.nodes[3])}), sum, 1e-9 * sum);
    corners.insert(m.nodes.begin(), m.nodes.end());
  }
  for (std::size_t e = 0; e < shells.size(); ++e)
    if (!merged.contains(shells.id[e]))
      for (const Index n : shells.node[e]) ++left[a.model.nodes.id[n]];
  for (const Coarsening::Hanging& h : c.hanging) {
    hanging.insert(h.node);
    ends.insert(h.ends.begin(), h.ends.end());
    EXPECT_TRUE(left.contains(h.node));
    EXPECT_FALSE(corners.contains(h.node));
    EXPECT_NEAR(norm(place(h.node) - 0.5 * (place(h.ends[0]) + place(h.ends[1]))), 0.0, 1e-9);
  }
  for (const int n : hanging) EXPECT_FALSE(ends.contains(n));
  for (const int n : c.removed_nodes) EXPECT_FALSE(left.contains(n) || corners.contains(n) || hanging.contains(n)) << n;
  return c;
}

TEST(Coarsening, AnEvenSheetHasAQuarterOfItsShells) {
  const Coarsening c = plan(Sheet(8));
  EXPECT_EQ(c.merged.size(), 16u);
  EXPECT_EQ(c.removed_nodes.size(), 81u - 25u);
  EXPECT_TRUE(c.hanging.empty());
}

// The merged shell begins at the corner where its first shell does, so that its axes are the same.
TEST(Coarsening, TheFirstShellGivesSenseAndAxes) {
  for (int turn = 0; turn < 4; ++turn) {
    Sheet a(2);
    for (std::array<Index, 4>& n : a.model.shells.node) std::rotate(n.begin(), n.begin() + turn, n.end());
    const Coarsening c = plan(a);
    ASSERT_EQ(c.merged.size(), 1u);
    EXPECT_EQ(c.merged[0].shells[0], 1);
    const auto side = [&](const auto& n) { return a.model.nodes.x[n[1]] - a.model.nodes.x[n[0]]; };
    std::array<Index, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = a.model.node_index(c.merged[0].nodes[k]);
    EXPECT_NEAR(norm(side(corners) - 2.0 * side(a.model.shells.node[0])), 0.0, 1e-12) << turn;
  }
}

TEST(Coarsening, AnOddSheetKeepsARowThatHangs) {
  const Coarsening c = plan(Sheet(5));
  EXPECT_EQ(c.merged.size(), 4u);
  EXPECT_EQ(c.hanging.size(), 4u);
}

TEST(Coarsening, WhatIsNeededStays) {
  const auto keeps = [](const Sheet& a) {
    std::set<int> merged;
    for (const Coarsening::Merged& m : plan(a).merged) merged.insert(m.shells.begin(), m.shells.end());
    return !merged.contains(1 + 8 * 3 + 3);  // of whose corners node (3, 3) is one
  };
  EXPECT_FALSE(keeps(Sheet(8)));
  const auto with = [&](const auto& change) {
    Sheet a(8);
    change(a);
    return keeps(a);
  };
  EXPECT_TRUE(with([](Sheet& a) { a.model.named_nodes = {a.at(3, 3)}; }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.listed_nodes = {a.at(3, 3)}; }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.named_shells = {8 * 3 + 3}; }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.listed_shells = {8 * 2 + 2}; })) << "a neighbour in its block";
  EXPECT_TRUE(with([](Sheet& a) { a.model.requests.history_shells.push_back({8 * 3 + 3, {}}); }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.initial_state.shells.push_back({8 * 3 + 3, {}, {}}); }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.shells.thickness[8 * 3 + 3] = 1.5; }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.coarsen.kept_parts = {a.part}; }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.coarsen.largest = 9.0; }));
  EXPECT_FALSE(with([](Sheet& a) { a.model.coarsen.largest = 10.0; }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.coarsen.boxes.push_back({{14, 14, -1}, {21, 21, 1}, false}); }));
  EXPECT_TRUE(with([](Sheet& a) { a.model.coarsen.boxes.push_back({{25, 25, -1}, {41, 41, 1}, true}); }));
  EXPECT_FALSE(with([](Sheet& a) { a.model.coarsen.boxes.push_back({{25, 25, -1}, {41, 41, 1}, false}); }));
  EXPECT_TRUE(with([](Sheet& a) {
    model::NodalLoad load;
    load.nodes = {a.at(3, 3)};
    a.model.nodal_loads.push_back(load);
  }));
}

// Two blocks stay fine; the four shells between their middles must not become one beside them: its corners would hang.
// Sabotage: what a node is to the merged shells around it not looked at.
TEST(Coarsening, NoCornerOfAMergedShellHangs) {
  Sheet a(8);
  a.model.named_shells = {8 * 2 + 2, 8 * 3 + 5};
  const Coarsening c = plan(a);
  EXPECT_EQ(c.merged.size(), 14u);
  EXPECT_EQ(c.hanging.size(), 6u);
}

TEST(Coarsening, ShellsUnderWeldsStayAndTheRestDoesNot) {
  Sheet a(12);
  const Index high = a.sheet(1.0, {0, 0, 1}, 12, 12, 5.0), w = a.beam_part(5.0);
  a.beam(w, Vec3d{32.5, 32.5, 0}, Vec3d{32.5, 32.5, 1});
  a.tie({w}, {a.part, high});
  const Coarsening c = plan(a);
  // The four shells of its block, and the two blocks that would have a node of the weld's shell amid a side.
  EXPECT_EQ(c.merged.size(), 2u * (36u - 3u));
  EXPECT_EQ(c.hanging.size(), 16u);
  for (const Coarsening::Merged& m : c.merged)
    for (const int e : m.shells) EXPECT_NE(e, 1 + 12 * 6 + 6);
}

TEST(Coarsening, FoldsBeyondTheAngleStay) {
  const auto merged = [](double degrees, double limit) {
    Sheet a(8);
    a.model.coarsen.angle = limit;
    // Along x the sheet turns by so much from one shell to the next.
    const double step = degrees * std::numbers::pi / 180.0;
    for (Vec3d& x : a.model.nodes.x) {
      const int i = static_cast<int>(std::lround(x.x / 5.0));
      Vec3d at{0, x.y, 0};
      for (int k = 0; k < i; ++k) at += Vec3d{5.0 * std::cos(k * step), 0, 5.0 * std::sin(k * step)};
      x = at;
    }
    Findings findings;
    return coarsening_of(a.model, tie(a.model, findings)).merged.size();
  };
  EXPECT_EQ(merged(6.0, 8.0), 12u) << "on curved free edges the middle node lies beside the side";
  EXPECT_EQ(merged(1.5, 8.0), 16u);
  EXPECT_EQ(merged(1.5, 1.0), 0u);
}

TEST(Coarsening, SeedsChooseWhichFour) {
  Sheet a(4);
  a.model.coarsen.seeds = {a.at(2, 2)};
  const Coarsening c = plan(a);
  ASSERT_FALSE(c.merged.empty());
  EXPECT_THAT(c.merged[0].nodes, testing::UnorderedElementsAre(a.id(1, 1), a.id(3, 1), a.id(3, 3), a.id(1, 3)));
  EXPECT_EQ(c.merged.size(), 1u) << "around it there is a row of one shell";
  EXPECT_EQ(c.hanging.size(), 4u);
}

}  // namespace
}  // namespace nugget::weld
