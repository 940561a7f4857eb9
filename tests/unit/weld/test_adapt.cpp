// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/adapt.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using testing::HasSubstr;

Adapted adapted(
    const Assembly& a, const std::function<bool(Index)>& can_move = [](Index) { return true; },
    const AdaptLimits& limits = {}) {
  Findings findings;
  return adapt(a.model, tie(a.model, findings), can_move, limits);
}

/// Two sheets of n x n shells of 5 mm, a weld of 6 mm over (x, y).
struct Pair : Assembly {
  Index low, high, welds;
  explicit Pair(double x, double y, int n = 12)
      : low(sheet(1.5, {0, 0, 0}, n, n, 5.0)), high(sheet(1.5, {0, 0, 1.5}, n, n, 5.0)), welds(beam_part(6.0)) {
    weld_at(x, y);
    tie({welds}, {low, high});
  }
  void weld_at(double x, double y) { beam(welds, Vec3d{x, y, 0}, Vec3d{x, y, 1.5}); }
  /// Node (i, j) of the low sheet.
  static Index at(int i, int j, int n = 12) { return j * (n + 1) + i; }
};

bool moved(const Assembly& a, const Adapted& now, Index node) {
  return norm(now.x[node] - a.model.nodes.x[node]) > 0.0;
}

std::array<Vec3d, 4> corners(const Assembly& a, const std::vector<Vec3d>& x, Index shell) {
  std::array<Vec3d, 4> c;
  for (std::size_t k = 0; k < 4; ++k) c[k] = x[a.model.shells.node[shell][k]];
  return c;
}

// ---- the square

TEST(Adapt, AWeldOverANodeGetsASquareOfItsDiameter) {
  const Pair a(30.0, 30.0);
  const Adapted now = adapted(a);
  ASSERT_EQ(now.ends.size(), 2u);
  for (const AdaptedEnd& end : now.ends) {
    EXPECT_EQ(end.left, "");
    EXPECT_NEAR(end.off_before, 1.0, 1e-9);
    EXPECT_NEAR(end.off_after, 0.0, 1e-9);
    const std::array<Vec3d, 4> c = corners(a, now.x, end.shell);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(norm(c[(k + 1) % 4] - c[k]), 6.0, 1e-9);
      EXPECT_NEAR(norm(c[(k + 2) % 4] - c[k]), 6.0 * std::numbers::sqrt2, 1e-9);
      EXPECT_NEAR(std::hypot(c[k].x - 30.0, c[k].y - 30.0), 3.0 * std::numbers::sqrt2, 1e-9);
    }
  }
}

TEST(Adapt, QualityLimitsHoldOverTheWholeSheet) {
  for (const auto& [x, y] : {std::pair{30.0, 30.0}, {30.0, 27.5}, {31.0, 28.0}}) {
    const Pair a(x, y);
    const Adapted now = adapted(a);
    for (Index e = 0; e < static_cast<Index>(a.model.shells.size()); ++e) {
      const ShellShape shape = shape_of(a.model.shells, e, now.x);
      EXPECT_GE(shape.jacobian, 0.6);
      EXPECT_LE(shape.aspect, 2.5);
      EXPECT_GE(shape.length, 0.7 * 5.0);
    }
  }
}

TEST(Adapt, NothingElseMoves) {
  const Pair a(30.0, 30.0);
  const Adapted now = adapted(a);
  std::set<Index> listed;
  for (const AdaptedEnd& end : now.ends) listed.insert(end.moved.begin(), end.moved.end());
  for (Index n = 0; n < static_cast<Index>(now.x.size()); ++n) {
    EXPECT_EQ(moved(a, now, n), listed.contains(n));
    EXPECT_EQ(now.x[n].z, a.model.nodes.x[n].z);
    const Vec3d d = a.model.nodes.x[n] - Vec3d{30, 30, 0};
    if (std::max(std::abs(d.x), std::abs(d.y)) > 22.0) {
      EXPECT_FALSE(moved(a, now, n)) << n;
    }
  }
}

TEST(Adapt, AWeldThatStandsWellIsLeft) {
  Pair a(32.5, 32.5);
  for (Vec3d& x : a.model.nodes.x) x = {1.2 * x.x, 1.2 * x.y, x.z};  // elements of 6 mm
  const Adapted now = adapted(a);
  for (const AdaptedEnd& end : now.ends) EXPECT_THAT(end.left, HasSubstr("stands over the centre"));
  EXPECT_TRUE(std::equal(now.x.begin(), now.x.end(), a.model.nodes.x.begin(),
                         [](const Vec3d& p, const Vec3d& q) { return norm(p - q) == 0.0; }));
}

TEST(Adapt, TheMiddleSheetOfThreeIsMeshedOnce) {
  Assembly a;
  std::vector<Index> sheets;
  for (int s = 0; s < 3; ++s) sheets.push_back(a.sheet(1.5, {0, 0, 1.5 * s}, 10, 10, 5.0));
  const Index w = a.beam_part(6.0);
  const Index low = a.node({25, 25, 0}), middle = a.node({25, 25, 1.5});
  a.beam(w, low, middle);
  a.beam(w, middle, a.node({25, 25, 3}));
  a.tie({w}, sheets);
  const Adapted now = adapted(a);
  ASSERT_EQ(now.ends.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(now.ends[i].part, sheets[i]);
    EXPECT_NEAR(now.ends[i].off_after, 0.0, 1e-9) << now.ends[i].left;
  }
}

TEST(Adapt, BricksStandOverTheCentreWithTheirFace) {
  Assembly a;
  const Index low = a.sheet(1.5, {0, 0, 0}, 10, 10, 5.0), high = a.sheet(1.5, {0, 0, 1.5}, 10, 10, 5.0);
  const Index w = a.solid_part();
  a.brick(w, 25.0, 25.0, 0.0, 1.5, 4.0);
  a.tie({w}, {low, high});
  const Adapted now = adapted(a);
  ASSERT_EQ(now.ends.size(), 2u);
  for (const AdaptedEnd& end : now.ends) {
    EXPECT_NEAR(end.diameter, 4.0 * std::sqrt(4.0 / std::numbers::pi), 1e-9);
    EXPECT_NEAR(end.off_after, 0.0, 1e-9) << end.left;
    EXPECT_NEAR(end.edge_after, end.diameter, 1e-9);
  }
}

// ---- other meshes

TEST(Adapt, TrianglesGiveWay) {
  Assembly a;
  const Index low = a.sheet_part(), high = a.sheet(1.5, {0, 0, 1.5}, 12, 12, 5.0);
  const auto first = static_cast<Index>(a.model.nodes.size());
  for (int j = 0; j <= 12; ++j)
    for (int i = 0; i <= 12; ++i) a.node({5.0 * i, 5.0 * j, 0.0});
  for (int j = 0; j < 12; ++j)
    for (int i = 0; i < 12; ++i) {
      const Index n = first + 13 * j + i;
      if (i < 5) {
        a.shell(low, 1.5, {n, n + 1, n + 14, n + 14});
        a.shell(low, 1.5, {n, n + 14, n + 13, n + 13});
      } else {
        a.shell(low, 1.5, {n, n + 1, n + 14, n + 13});
      }
    }
  const Index w = a.beam_part(6.0);
  a.beam(w, Vec3d{30, 30, 0}, Vec3d{30, 30, 1.5});
  a.tie({w}, {low, high});
  const Adapted now = adapted(a);
  EXPECT_NEAR(now.ends[0].off_after, 0.0, 1e-9) << now.ends[0].left;
  EXPECT_FALSE(a.model.shells.triangle(static_cast<std::size_t>(now.ends[0].shell)));
  EXPECT_GE(now.ends[0].after.jacobian, 0.6);
}

// Sheets rolled about the y axis: their facets are the surface. Sabotage: nodes left where the springs put them.
TEST(Adapt, NodesStayOnTheFacetsOfACurvedSheet) {
  constexpr double step = 0.06;  // [rad] of one facet: 3.4 degrees
  Assembly a;
  const auto rolled = [&](double radius) {
    const Index p = a.sheet_part();
    const auto first = static_cast<Index>(a.model.nodes.size());
    for (int j = 0; j <= 12; ++j)
      for (int i = 0; i <= 12; ++i)
        a.node({radius * std::sin(step * (i - 6)), 5.0 * j, radius * std::cos(step * (i - 6))});
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i) {
        const Index n = first + 13 * j + i;
        a.shell(p, 1.0, {n, n + 1, n + 14, n + 13});
      }
    return p;
  };
  const Index low = rolled(90.0), high = rolled(91.0);
  const Index w = a.beam_part(6.0);
  a.beam(w, Vec3d{0, 30, 90}, Vec3d{0, 30, 91});
  a.tie({w}, {low, high});
  const Adapted now = adapted(a);
  ASSERT_FALSE(now.ends[0].moved.empty()) << now.ends[0].left;
  EXPECT_LT(now.ends[0].off_after, 0.1);
  for (const Index n : now.ends[0].moved) {
    const Vec3d& x = now.x[n];
    // A facet over the angles 0 to `step` lies at the distance r cos(step / 2) from the axis, along its middle.
    const double angle = std::atan2(x.x, x.z), within = angle - step * std::floor(angle / step);
    const double radius = 90.0 * std::cos(0.5 * step) / std::cos(within - 0.5 * step);
    EXPECT_NEAR(std::hypot(x.x, x.z), radius, 1e-9);
  }
}

// ---- what stays

TEST(Adapt, HeldNodesStay) {
  const Index beside = Pair::at(7, 6);  // 5 mm beside the weld
  const auto stays = [&](const Pair& a) {
    const Adapted now = adapted(a);
    EXPECT_FALSE(now.ends[0].moved.empty()) << now.ends[0].left;
    return !moved(a, now, beside);
  };
  EXPECT_FALSE(stays(Pair(30.0, 30.0)));
  Pair named(30.0, 30.0);
  named.model.named_nodes = {beside};
  EXPECT_TRUE(stays(named));
  Pair set(30.0, 30.0);
  set.model.sets.nodes.push_back({1, {beside, 0, 1}, {}});
  EXPECT_TRUE(stays(set));
  Pair whole(30.0, 30.0);
  model::Set<Index> of_part;
  for (Index n = 0; n < 13 * 13; ++n) of_part.members.push_back(n);
  whole.model.sets.nodes.push_back(of_part);
  EXPECT_FALSE(stays(whole)) << "a set of all nodes of a part is a set of parts";
  Pair body(30.0, 30.0);
  body.model.rigid_bodies.emplace_back().nodes = {beside};
  EXPECT_TRUE(stays(body));
  Pair history(30.0, 30.0);
  history.model.requests.history_nodes.push_back({beside, {}});
  EXPECT_TRUE(stays(history));
  Pair spc(30.0, 30.0);
  spc.model.spcs.push_back({.node = beside});
  EXPECT_TRUE(stays(spc));
  Pair mass(30.0, 30.0);
  mass.model.masses.push_back({1, beside, 1e-6});
  EXPECT_TRUE(stays(mass));
  Pair stress(30.0, 30.0);
  stress.model.initial_state.shells.push_back({12 * 6 + 7, {}, {}});  // of whose corners it is one
  EXPECT_TRUE(stays(stress));
  Pair thick(30.0, 30.0);
  thick.model.shells.thickness[12 * 6 + 7] = 2.0;
  EXPECT_TRUE(stays(thick));
  const Pair text(30.0, 30.0);
  EXPECT_FALSE(moved(text, adapted(text, [&](Index n) { return n != beside; }), beside));
}

TEST(Adapt, FreeEdgesFoldsAndOtherTiesStay) {
  const Pair near_edge(10.0, 30.0);
  const Adapted now = adapted(near_edge);
  EXPECT_NEAR(now.ends[0].off_after, 0.0, 1e-9) << now.ends[0].left;
  for (int j = 0; j <= 12; ++j) EXPECT_FALSE(moved(near_edge, now, Pair::at(0, j)));

  Pair folded(30.0, 30.0);  // both sheets rise by 12 degrees beyond x = 40
  for (Vec3d& x : folded.model.nodes.x) x.z += std::max(x.x - 40.0, 0.0) * std::tan(12.0 * std::numbers::pi / 180.0);
  const Adapted of_folded = adapted(folded);
  ASSERT_FALSE(of_folded.ends[0].moved.empty()) << of_folded.ends[0].left;
  for (int j = 0; j <= 12; ++j) EXPECT_FALSE(moved(folded, of_folded, Pair::at(8, j)));
  EXPECT_TRUE(moved(folded, of_folded, Pair::at(7, 6)));

  Pair glued(30.0, 30.0);  // a node of something else hangs on the shell beside the weld's
  const Index loose = glued.node({37.0, 32.0, 0.1});
  model::Contact& contact = glued.tie({}, {glued.low});
  contact.a.nodes = {loose};
  const Adapted of_glued = adapted(glued);
  for (const Index n : glued.model.shells.node[12 * 6 + 7]) EXPECT_FALSE(moved(glued, of_glued, n));
}

TEST(Adapt, TwoWeldsBesideEachOtherHaveAnElementEach) {
  Pair a(25.0, 30.0);
  a.weld_at(45.0, 30.0);
  const Adapted now = adapted(a);
  ASSERT_EQ(now.ends.size(), 4u);
  for (const AdaptedEnd& end : now.ends) {
    EXPECT_NEAR(end.off_after, 0.0, 0.1) << end.left;
    EXPECT_GE(end.after.jacobian, 0.6);
  }
  EXPECT_NE(now.ends[0].shell, now.ends[2].shell);
  Pair close(28.0, 30.0);
  close.weld_at(32.0, 30.0);
  const Adapted of_close = adapted(close);
  EXPECT_NEAR(of_close.ends[0].off_after, 0.0, 0.1);
  EXPECT_THAT(of_close.ends[2].left, HasSubstr("under another weld")) << "4 mm apart: no room for two of 6";
}

TEST(Adapt, WhereItCannotBeCentredItComesNear) {
  const Pair a(5.0, 30.0, 12);  // one element from the free edge
  const Adapted now = adapted(a);
  EXPECT_EQ(now.ends[0].left, "");
  EXPECT_NEAR(now.ends[0].off_before, 1.0, 1e-9);
  EXPECT_LT(now.ends[0].off_after, 0.7);
  EXPECT_GT(now.ends[0].off_after, 0.1);
  const Adapted all_held = adapted(a, [](Index) { return false; });
  EXPECT_THAT(all_held.ends[0].left, HasSubstr("all nodes of its element keep their place"));
  EXPECT_THAT(all_held.ends[0].left, HasSubstr("of a line that cannot be rewritten"));
}

// ---- quality, by closed forms

TEST(ShellShape, KnownShapes) {
  Assembly a;
  const Index p = a.sheet_part();
  const auto quad = [&](std::array<Vec3d, 4> c) {
    const Index n = a.node(c[0]);
    for (std::size_t k = 1; k < 4; ++k) a.node(c[k]);
    return shape_of(a.model.shells, a.shell(p, 1.0, {n, n + 1, n + 2, n + 3}), a.model.nodes.x);
  };
  const ShellShape rectangle = quad({Vec3d{0, 0, 0}, {4, 0, 0}, {4, 2, 0}, {0, 2, 0}});
  EXPECT_NEAR(rectangle.jacobian, 1.0, 1e-14);
  EXPECT_NEAR(rectangle.aspect, 2.0, 1e-14);
  EXPECT_NEAR(rectangle.length, 2.0, 1e-14);
  EXPECT_NEAR(rectangle.warp, 0.0, 1e-12);
  const double s = std::sqrt(3.0) / 2.0;
  const ShellShape rhombus = quad({Vec3d{0, 0, 0}, {1, 0, 0}, {1.5, s, 0}, {0.5, s, 0}});
  EXPECT_NEAR(rhombus.jacobian, s, 1e-14);
  EXPECT_NEAR(rhombus.length, s, 1e-14);
  EXPECT_LE(quad({Vec3d{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}).jacobian, 0.0) << "an arrow head";
  // One corner of a unit square lifted by h: the diagonal through it folds by an angle with tan = h sqrt(2 + h^2), the
  // other one by less.
  EXPECT_NEAR(quad({Vec3d{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}).warp,
              std::atan(0.1 * std::sqrt(2.01)) * 180.0 / std::numbers::pi, 1e-10);
  const Index n = a.node({0, 0, 0});
  a.node({1, 0, 0});
  a.node({0.5, s, 0});
  const ShellShape triangle = shape_of(a.model.shells, a.shell(p, 1.0, {n, n + 1, n + 2, n + 2}), a.model.nodes.x);
  EXPECT_NEAR(triangle.jacobian, 1.0, 1e-14);
  EXPECT_NEAR(triangle.length, s, 1e-14);
}

// ---- large elements

constexpr AdaptLimits dividing{.divides = true};

Adapted divided(const Assembly& a, const WhyWhole& why = {}) {
  Findings findings;
  return adapt(
      a.model, tie(a.model, findings), [](Index) { return true; }, dividing, why);
}

/// As Pair, shells of `size`.
struct CoarsePair : Assembly {
  Index low, high, welds;
  CoarsePair(double x, double y, double size, int n = 9)
      : low(sheet(1.5, {0, 0, 0}, n, n, size)), high(sheet(1.5, {0, 0, 1.5}, n, n, size)), welds(beam_part(6.0)) {
    beam(welds, Vec3d{x, y, 0}, Vec3d{x, y, 1.5});
    tie({welds}, {low, high});
  }
};

std::array<Vec3d, 4> piece_of(const Assembly& a, const Adapted& now, const DividedShell& d, std::size_t k) {
  std::array<Vec3d, 4> c;
  for (std::size_t i = 0; i < 4; ++i)
    c[i] = pieces[k][i] < 4 ? now.x[a.model.shells.node[d.shell][static_cast<std::size_t>(pieces[k][i])]]
                            : d.square[static_cast<std::size_t>(pieces[k][i]) - 4];
  return c;
}

double area(const std::array<Vec3d, 4>& c) {
  return 0.5 * cross(c[2] - c[0], c[3] - c[1]).z;
}

// Wherever the weld stands in elements of 10 to 20 mm: a square of 6 mm under it, five pieces that fill the element.
TEST(Divide, ASquareOfTheDiameterInALargeElement) {
  for (const double size : {10.0, 14.0, 20.0})
    for (const auto& [u, v] : {std::pair{4.5, 4.5}, {4.7, 4.4}, {4.0, 4.5}, {4.0, 4.0}}) {
      const CoarsePair a(u * size, v * size, size);
      const Adapted now = divided(a);
      ASSERT_EQ(now.divided.size(), 2u) << size << ' ' << u << ' ' << v << now.ends[0].whole;
      for (std::size_t e = 0; e < 2; ++e) {
        EXPECT_TRUE(now.ends[e].divided);
        EXPECT_NEAR(now.ends[e].off_after, 0.0, 1e-9);
        EXPECT_NEAR(now.ends[e].edge_after, 6.0, 1e-9);
        const DividedShell& d = now.divided[e];
        Vec3d centre;
        for (const Vec3d& x : d.square) centre += 0.25 * x;
        EXPECT_NEAR(std::hypot(centre.x - u * size, centre.y - v * size), 0.0, 1e-9);
        double sum = 0.0;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
          const std::array<Vec3d, 4> c = piece_of(a, now, d, k);
          const ShellShape shape = shape_of(c, false);
          EXPECT_GT(area(c), 0.0);  // in the sense of the element
          EXPECT_GE(shape.jacobian, 0.6);
          EXPECT_LE(shape.aspect, 3.5);
          EXPECT_GE(shape.length, 0.4 * 6.0);
          sum += area(c);
        }
        EXPECT_NEAR(sum, area(corners(a, now.x, d.shell)), 1e-9 * sum);
      }
    }
}

// What can be moved to its size is; what is whole, too small or has no room is moved as without dividing.
TEST(Divide, OnlyWhereMovingDoesNotReach) {
  const Pair fine(30.0, 30.0);
  const Adapted moved_only = adapted(fine), same = divided(fine);
  EXPECT_TRUE(same.divided.empty());
  for (std::size_t n = 0; n < same.x.size(); ++n) EXPECT_EQ(norm(same.x[n] - moved_only.x[n]), 0.0);

  const CoarsePair coarse(45.0, 45.0, 10.0);
  const Adapted whole = divided(coarse, [](Index) { return std::string("a card names it"); }), moved = adapted(coarse);
  EXPECT_TRUE(whole.divided.empty());
  EXPECT_EQ(whole.ends[0].whole, "a card names it");
  for (std::size_t n = 0; n < whole.x.size(); ++n) EXPECT_EQ(norm(whole.x[n] - moved.x[n]), 0.0);
}

// Two welds on one element: the first one has it.
TEST(Divide, OneWeldAnElement) {
  CoarsePair a(90.0, 90.0, 20.0);
  a.beam(a.welds, Vec3d{96.0, 91.0, 0}, Vec3d{96.0, 91.0, 1.5});
  const Adapted now = divided(a);
  EXPECT_EQ(now.divided.size(), 2u);
  ASSERT_EQ(now.ends.size(), 4u);
  EXPECT_THAT(now.ends[2].whole, HasSubstr("another weld has divided its element"));
}

// 25 mm are more than 3.5 diameters: the pieces would be too long.
TEST(Divide, ThereIsALargestElement) {
  const CoarsePair a(112.5, 112.5, 25.0);
  const Adapted now = divided(a);
  EXPECT_TRUE(now.divided.empty());
  EXPECT_THAT(now.ends[0].whole, HasSubstr("a piece of its element would have an aspect ratio of 4.17, past 3.5"));
}

TEST(Divide, WhatNamesAnElementKeepsItWhole) {
  CoarsePair a(45.0, 45.0, 10.0);
  a.model.named_shells = {0};
  a.model.listed_shells = {1};
  a.model.initial_state.shells.emplace_back().element = 2;
  for (const Index n : {0, 1, 10}) a.model.listed_nodes.push_back(n + 40);
  a.model.sets.segments.emplace_back().members = {
      {a.model.shells.node[5][2], a.model.shells.node[5][3], a.model.shells.node[5][0], a.model.shells.node[5][1]}};
  Findings findings;
  const std::vector<std::string> why = whole_shells(a.model, tie(a.model, findings));
  EXPECT_EQ(why[0], "a card names it");
  EXPECT_EQ(why[1], "a list of shells names it");
  EXPECT_EQ(why[2], "it has initial stress");
  EXPECT_EQ(why[3], "");
  EXPECT_EQ(why[5], "a segment names it");
  EXPECT_EQ(why[36], "lists name its nodes");
}

}  // namespace
}  // namespace nugget::weld
