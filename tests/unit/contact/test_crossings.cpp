// SPDX-License-Identifier: Apache-2.0
#include "contact/crossings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

namespace nugget::contact {
namespace {

/// Sheets of square segments of side 1 and thickness 0.1.
struct Sheets {
  SurfaceContactSetup setup;
  std::vector<Row> x;

  /// An n by m sheet; `at(i, j)` gives the places.
  void add(int n, int m, const std::function<Vec3d(double, double)>& at, unsigned side = 1) {
    const int first = static_cast<int>(x.size());
    for (int j = 0; j <= m; ++j)
      for (int i = 0; i <= n; ++i) {
        const Vec3d p = at(i, j);
        x.push_back({p.x, p.y, p.z, 0.0});
      }
    for (int j = 0; j < m; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = first + j * (n + 1) + i;
        Segment s;
        s.node = {a, a + 1, a + n + 2, a + n + 1};
        s.thickness = 0.1;
        s.side = static_cast<int>(side);
        setup.segments.push_back(s);
      }
  }
  std::size_t edges() const {
    std::set<std::array<int, 2>> all;
    for (const Crossing& c : find_crossings(setup, x, 0, setup.segments.size())) all.insert(c.edge);
    return all.size();
  }
};

Vec3d flat(double i, double j) {
  return {i, j, 0.0};
}
/// Turned by an odd rotation: nothing is along the axes.
Vec3d turned(const Vec3d& a) {
  const Vec3d axis = (1.0 / std::sqrt(14.0)) * Vec3d{1.0, 2.0, 3.0};
  return std::cos(0.7) * a + std::sin(0.7) * cross(axis, a) + (1.0 - std::cos(0.7)) * dot(axis, a) * axis;
}

// A sheet of 4 x 4 stands across one that is 6 long; five of its edges that run up go through, and none that runs
// along. Sabotage caught: edges taken twice, those of one sheet alone.
TEST(Crossings, OfASheetThatStandsAcrossAnotherOne) {
  for (const bool turn : {false, true}) {
    Sheets s;
    const auto place = [turn](const Vec3d& a) { return turn ? turned(a) : a; };
    s.add(6, 6, [&](double i, double j) { return place(flat(i, j)); });
    s.add(4, 4, [&](double i, double j) { return place({0.7 + i, 2.3, j - 1.4}); });
    // Edges of the flat sheet that go through the other one: those at i = 1 to 4 that pass j = 2.3.
    EXPECT_EQ(s.edges(), 5u + 4u) << turn;
    const std::vector<Crossing> all = find_crossings(s.setup, s.x, 0, s.setup.segments.size());
    EXPECT_EQ(all.front().edge, (std::array<int, 2>{15, 22})) << turn;  // from (1, 2) to (1, 3)
  }
}

TEST(Crossings, SheetsThatTouchOrLieOnEachOtherHaveNone) {
  Sheets on;
  on.add(6, 6, flat);
  on.add(6, 6, [](double i, double j) { return Vec3d{i + 0.3, j - 0.4, 0.02}; });
  EXPECT_EQ(on.edges(), 0u);

  for (const double deeper : {0.0, 5e-4}) {
    Sheets tee;  // one ends on the mid-surface of the other
    tee.add(6, 6, flat);
    tee.add(4, 4, [=](double i, double j) { return Vec3d{0.7 + i, 2.3, j - deeper}; });
    EXPECT_EQ(tee.edges(), 0u) << deeper;
  }

  Sheets folded;  // one sheet, folded to a right angle along a line of nodes
  folded.add(6, 2, [](double i, double j) { return Vec3d{std::min(i, 3.0), j, std::max(0.0, i - 3.0)}; });
  EXPECT_EQ(folded.edges(), 0u);
}

TEST(Crossings, OfTwoSurfacesAreThoseWithTheOtherOne) {
  const auto across = [](double i, double j) { return Vec3d{0.7 + i, 2.3, j - 1.4}; };
  Sheets both;
  both.add(6, 6, flat, 1);
  both.add(4, 4, across, 2);
  EXPECT_EQ(both.edges(), 9u);
  Sheets one;  // both in the first surface, which nothing presses apart; the second is far away
  one.add(6, 6, flat, 1);
  one.add(4, 4, across, 1);
  one.add(
      1, 1,
      [](double i, double j) {
        return Vec3d{i, j, 50.0};
      },
      2);
  EXPECT_EQ(one.edges(), 0u);
}

}  // namespace
}  // namespace nugget::contact
