// SPDX-License-Identifier: Apache-2.0
#include "contact/surface_part.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <tuple>
#include <vector>

#include "base/index.hpp"
#include "thread_ranks.hpp"

namespace nugget::contact {
namespace {

struct Overlapping {
  SurfaceContactSetup setup;
  std::vector<Row> x;

  int add_node(const Vec3d& p) {
    x.push_back({p.x, p.y, p.z, 0.0});
    return static_cast<int>(x.size()) - 1;
  }
  void add_segment(const std::array<int, 4>& node, double thickness, double volume) {
    Segment s;
    s.node = node;
    s.thickness = thickness;
    s.volume = volume;
    s.bulk_modulus = 175000.0;
    s.element = static_cast<int>(setup.segments.size());
    setup.segments.push_back(s);
  }
};

/// Two wavy sheets that overlap here and there, and three bricks in a row that stand in the upper one.
Overlapping sheets_in_each_other() {
  constexpr int along = 30, across = 12;
  Overlapping s;
  std::mt19937 draw(11);
  std::uniform_real_distribution<double> off(-0.25, 0.25);
  const auto sheet = [&](double z, double thickness) {
    const int first = static_cast<int>(s.x.size());
    for (int j = 0; j <= across; ++j)
      for (int i = 0; i <= along; ++i) s.add_node({5.0 * i, 5.0 * j, z + off(draw)});
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < along; ++i) {
        const int a = first + j * (along + 1) + i;
        s.add_segment({a, a + 1, a + along + 2, a + along + 1}, thickness, 0.0);
      }
  };
  sheet(0.0, 1.0);
  sheet(1.0, 1.2);
  for (int brick = 0; brick < 3; ++brick) {
    const int first = static_cast<int>(s.x.size());
    const double x = 30.0 + 40.0 * brick, low = 1.5 - 0.3 * brick;
    for (const double z : {low, low + 8.0})
      for (const Vec3d& p : {Vec3d{x, 21, z}, Vec3d{x + 9, 21, z}, Vec3d{x + 9, 31, z}, Vec3d{x, 31, z}}) s.add_node(p);
    for (const std::array<int, 4>& face : {std::array{0, 3, 2, 1}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                                           std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}}) {
      std::array<int, 4> node = face;
      for (int& n : node) n += first;
      s.add_segment(node, 0.0, 720.0);
    }
  }
  s.setup.nodes = nodes_of(s.setup.segments);
  return s;
}

/// By node, and in this order; segments by their `element`.
using Found = std::vector<std::tuple<int, int, double, double, double, double>>;
Found in_order(const SurfaceContactSetup& setup, const std::vector<Penetration>& penetrations) {
  Found found;
  for (const Penetration& p : penetrations)
    found.emplace_back(p.node, setup.segments[p.segment].element, p.depth, p.direction.x, p.direction.y, p.direction.z);
  return found;
}
void sort_by_node(Found& found) {
  std::ranges::stable_sort(found, {}, [](const auto& one) { return std::get<0>(one); });
}

// Overlaps of the parts of a surface are those of the whole, bit for bit. Sabotage: a region smaller than that of its
// nodes.
TEST(SurfacePart, HasTheOverlapsOfTheWhole) {
  const Overlapping s = sheets_in_each_other();
  const Found all = in_order(s.setup, find_penetrations(s.setup, s.x));
  Found deep = in_order(s.setup, find_nodes_out_of_reach(s.setup, s.x));
  sort_by_node(deep);
  EXPECT_GT(all.size(), 100u);
  EXPECT_GT(deep.size(), 0u);
  for (const int parts : {1, 2, 3, 7, 8}) {
    Found found, found_deep;
    std::size_t most = 0, tracked = 0;
    for (int part = 0; part < parts; ++part) {
      const SurfaceContactSetup own = part_of(s.setup, s.x, part, parts, 0.0);
      most = std::max(most, own.segments.size());
      tracked += own.nodes.size();
      const Found here = in_order(own, find_penetrations(own, s.x));
      found.insert(found.end(), here.begin(), here.end());
      const Found deep_here = in_order(own, find_nodes_out_of_reach(own, s.x));
      found_deep.insert(found_deep.end(), deep_here.begin(), deep_here.end());
    }
    sort_by_node(found);
    sort_by_node(found_deep);
    EXPECT_EQ(tracked, s.setup.nodes.size());
    EXPECT_EQ(found, all) << parts;
    EXPECT_EQ(found_deep, deep) << parts;
    if (parts > 1) {
      EXPECT_LT(most, s.setup.segments.size() * 3 / 4) << parts;
    }
  }
}

// A sheet in the middle of a brick of 40: of many parts some have none of the brick's corners, and all its faces are
// far from their nodes. Sabotage: a face reaches no farther than its thickness.
TEST(SurfacePart, ABrickReachesAsFarAsItIsDeep) {
  constexpr int side = 15;
  Overlapping s;
  for (const double z : {0.0, 40.0})
    for (const Vec3d& p : {Vec3d{0, 0, z}, Vec3d{40, 0, z}, Vec3d{40, 40, z}, Vec3d{0, 40, z}}) s.add_node(p);
  for (const std::array<int, 4>& face : {std::array{0, 3, 2, 1}, std::array{4, 5, 6, 7}, std::array{0, 1, 5, 4},
                                         std::array{1, 2, 6, 5}, std::array{2, 3, 7, 6}, std::array{3, 0, 4, 7}})
    s.add_segment(face, 0.0, 64000.0);
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) s.add_node({12.5 + i, 12.5 + j, 20.5});
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int a = 8 + j * (side + 1) + i;
      s.add_segment({a, a + 1, a + side + 2, a + side + 1}, 0.1, 0.0);
    }
  s.setup.nodes = nodes_of(s.setup.segments);
  Found deep = in_order(s.setup, find_nodes_out_of_reach(s.setup, s.x));
  sort_by_node(deep);
  EXPECT_GT(deep.size(), 100u);
  for (const int parts : {4, 16}) {
    Found found;
    for (int part = 0; part < parts; ++part) {
      const SurfaceContactSetup own = part_of(s.setup, s.x, part, parts, 0.0);
      const Found here = in_order(own, find_nodes_out_of_reach(own, s.x));
      found.insert(found.end(), here.begin(), here.end());
    }
    sort_by_node(found);
    EXPECT_EQ(found, deep) << parts;
  }
}

// Ranks move the same nodes to the same places as one process, also where these go so far that the surface is divided
// anew. Sabotage: nodes that other ranks move stay.
TEST(SurfacePart, RanksRemoveOverlapsTogether) {
  for (const double room : {1.0, 1e-3}) {
    Overlapping alone = sheets_in_each_other();
    const Overlapping before = alone;
    const Found found = in_order(alone.setup, remove_penetrations(alone.setup, alone.x));
    EXPECT_GT(found.size(), 100u);
    for (const int count : {2, 3}) {
      std::vector<std::vector<Row>> x(at(count), before.x);
      std::vector<Found> of_rank(at(count));
      on_thread_ranks(count, [&](Ranks& ranks) {
        const int r = ranks.rank();
        const auto part = [&](std::span<const Row> now) { return part_of(before.setup, now, r, count, room); };
        const DividedSurface divided{ranks, room, part};
        const SurfaceContactSetup own = part(x[r]);
        of_rank[r] = in_order(own, remove_penetrations(own, x[r], 20, &divided));
      });
      Found all;
      for (const Found& one : of_rank) all.insert(all.end(), one.begin(), one.end());
      sort_by_node(all);
      EXPECT_EQ(all, found);
      for (int r = 0; r < count; ++r)
        EXPECT_EQ(std::memcmp(x[r].data(), alone.x.data(), alone.x.size() * sizeof(Row)), 0) << r << " of " << count;
    }
  }
}

}  // namespace
}  // namespace nugget::contact
