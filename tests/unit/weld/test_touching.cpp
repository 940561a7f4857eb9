// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/touching.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
using testing::HasSubstr;

/// Everything in one contact of this CLOSE.
struct Touching : Assembly {
  explicit Touching(double close = 0.05) {
    model::Contact contact;
    contact.id = 7;
    contact.keyword = "CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED";
    contact.kind = model::Contact::Kind::tied_single_surface;
    contact.close = close;
    contact.a.everything = contact.b.everything = true;
    model.contacts.push_back(contact);
  }
  Findings findings;
  std::vector<Tie> ties() {
    findings = {};
    return weld::tie(model, findings).ties;
  }
  std::set<Index> tied_parts() {
    std::set<Index> parts;
    for (const Tie& t : ties()) parts.insert(t.own_part);
    return parts;
  }
  void hold(Index node, unsigned fixed) { model.spcs.push_back({.node = node, .fixed = fixed}); }
  Index brick_part() { return part(model::ElementKind::solid, kernel::Elastic{210000.0, 0.3}); }
};

void expect_sound(const Touching& a, const std::vector<Tie>& ties) {
  std::set<Index> tied;
  for (const Tie& t : ties) EXPECT_TRUE(tied.insert(t.node).second) << "node " << t.node << " is tied twice";
  EXPECT_TRUE(std::is_sorted(ties.begin(), ties.end(), [](const Tie& s, const Tie& t) { return s.node < t.node; }));
  for (const Tie& t : ties) {
    double sum = 0.0;
    for (const double w : t.weight) sum += w;
    EXPECT_NEAR(sum, 1.0, 1e-12);
    for (const Index n : carriers(t)) EXPECT_NE(n, t.node);
    EXPECT_NEAR(norm(a.model.nodes.x[t.node] - t.point), t.gap, 1e-12);
  }
}

TEST(TouchingSheets, OneSideFollowsTheCoarserOne) {
  Touching a;
  const Index fine = a.sheet(1.0, {0, 0, 0}, 6, 6, 5.0), coarse = a.sheet(1.5, {0, 0, 1.25}, 3, 3, 10.0);
  const std::vector<Tie> ties = a.ties();
  expect_sound(a, ties);
  EXPECT_EQ(ties.size(), 49u);
  for (const Tie& t : ties) {
    EXPECT_EQ(t.own_part, fine);
    EXPECT_EQ(t.part, coarse);
    EXPECT_EQ(t.between, 0.0);
    EXPECT_NEAR(t.gap, 1.25, 1e-12);
    EXPECT_TRUE(t.rotations && !t.couples && !t.spring);
  }
  EXPECT_THAT(text(a.findings),
              HasSubstr("49 nodes tied where parts touch (CLOSE 0.05); part 1 on part 2: 49 nodes from "
                        "(0, 0, 0) to (30, 30, 0), surfaces touching"));
}

TEST(TouchingSheets, SurfacesCountNotNodes) {
  for (const auto& [gap, tied] : {std::pair{0.049, true}, {0.051, false}, {-0.3, true}, {-0.9, true}}) {
    Touching a;
    a.sheet(1.0, {0, 0, 0}, 3, 3);
    a.sheet(1.5, {0, 0, 1.25 + gap}, 3, 3);
    EXPECT_EQ(!a.ties().empty(), tied) << gap;
    if (!tied) {
      EXPECT_THAT(text(a.findings), HasSubstr("warning: *CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED 7: no parts touch"));
    }
    if (gap == -0.3) {
      EXPECT_THAT(text(a.findings), HasSubstr("surfaces 0.3 in each other"));
    }
  }
}

TEST(TouchingSheets, ContactThicknessAndBox) {
  Touching a;
  a.sheet(1.0, {0, 0, 0}, 3, 3);
  a.sheet(1.0, {0, 0, 2.0}, 3, 3);
  EXPECT_TRUE(a.ties().empty());
  a.model.contacts[0].thickness_scale_a = a.model.contacts[0].thickness_scale_b = 2.0;  // SFSAT
  EXPECT_EQ(a.ties().size(), 16u);
  model::Surface& side = a.model.contacts[0].a;
  side.boxed = true;
  side.box_low = {-1, -1, -1};
  side.box_high = {21, 21, 3};
  EXPECT_EQ(a.ties().size(), 9u);
}

// Whatever the order of sizes, all three hold together: one follows the next.
TEST(TouchingSheets, StacksAreChains) {
  const std::array<std::pair<int, double>, 3> meshes{{{3, 10.0}, {5, 6.0}, {6, 5.0}}};
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    Touching a;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [n, size] = meshes[order[k]];
      a.sheet(1.0, {0, 0, 1.0 * static_cast<double>(k)}, n, n, size);
    }
    const std::vector<Tie> ties = a.ties();
    expect_sound(a, ties);
    std::set<std::pair<Index, Index>> pairs;
    for (const Tie& t : ties) pairs.emplace(std::min(t.own_part, t.part), std::max(t.own_part, t.part));
    EXPECT_EQ(pairs, (std::set<std::pair<Index, Index>>{{0, 1}, {1, 2}}));
    EXPECT_EQ(a.findings.errors(), 0u) << text(a.findings);
  } while (std::next_permutation(order.begin(), order.end()));
}

// A node between two that come before it follows one; the other part's nodes follow it.
TEST(TouchingSheets, WhatOneSideCannotTieTheOtherDoes) {
  Touching a;
  a.sheet(1.0, {0, 0, 0}, 3, 3);
  const Index middle = a.sheet(1.0, {0, 0, 1.0}, 3, 3);
  for (Index n = 16; n < 32; ++n) a.hold(n, 7u);  // the sheet that would follow is held by its translations
  const std::vector<Tie> ties = a.ties();
  EXPECT_EQ(ties.size(), 16u);
  for (const Tie& t : ties) EXPECT_EQ(t.part, middle);
  EXPECT_THAT(text(a.findings), HasSubstr("left alone: 16 held by SPCs that the other part has not"));
}

TEST(TouchingSheets, SupportsThatBothHaveStay) {
  const auto tied_at_edge = [](unsigned low, unsigned high) {
    Touching a;
    a.sheet(1.0, {0, 0, 0}, 3, 3);
    a.sheet(1.0, {0, 0, 1.0}, 3, 3);
    for (const Index n : {0, 4, 8, 12}) a.hold(n, low);
    for (const Index n : {16, 20, 24, 28}) a.hold(n, high);
    int tied = 0;
    for (const Tie& t : a.ties()) {
      tied += t.node % 4 == 0;
      EXPECT_EQ(t.held_alike, t.node % 4 == 0);
    }
    return tied;
  };
  EXPECT_EQ(tied_at_edge(63u, 63u), 4);              // clamped
  EXPECT_EQ(tied_at_edge(0b110001u, 0b110001u), 4);  // symmetric about x: ux, ry, rz
  EXPECT_EQ(tied_at_edge(63u, 7u), 4);
  // ux alone: the upper one would slide by the lever.
  Touching a;
  a.sheet(1.0, {0, 0, 0}, 3, 3);
  a.sheet(1.0, {0, 0, 1.0}, 3, 3);
  for (const Index n : {0, 16}) a.hold(n, 1u);
  for (const Tie& t : a.ties()) EXPECT_NE(t.node, 16);
}

TEST(TouchingSheets, WhatIsHeldOtherwiseIsLeftAlone) {
  Touching a;
  a.sheet(1.0, {0, 0, 0}, 3, 3);
  a.sheet(1.0, {0, 0, 1.0}, 3, 3);
  model::RigidBody body;
  body.id = 5;
  body.nodes = {16, 17};
  a.model.rigid_bodies.push_back(body);
  model::Interpolation interpolation;
  interpolation.node = 18;
  interpolation.independent = {22, 23};
  interpolation.weight = {0.5, 0.5};
  a.model.interpolations.push_back(interpolation);
  model::PrescribedMotion motion;
  motion.nodes = {19};
  a.model.motions.push_back(motion);
  const std::vector<Tie> ties = a.ties();
  expect_sound(a, ties);
  for (const Tie& t : ties) EXPECT_TRUE(t.node > 19 || t.node < 16);
  EXPECT_THAT(text(a.findings), HasSubstr("left alone: 2 of rigid bodies, 2 that another constraint moves"));
}

// Sheets on a block: faces of bricks have no rotations, so moments go there by forces.
TEST(TouchingSheets, FacesOfBricks) {
  Touching a;
  const Index block = a.brick_part();
  a.brick(block, 5.0, 5.0, 0.0, 10.0, 10.0);
  const Index sheet = a.sheet(1.0, {1.0, 1.0, 10.5}, 2, 2, 4.0);
  const std::vector<Tie> ties = a.ties();
  EXPECT_EQ(ties.size(), 9u);
  for (const Tie& t : ties) {
    EXPECT_EQ(t.own_part, sheet);
    EXPECT_EQ(t.shell, none);
    EXPECT_TRUE(t.couples && t.rotations);
  }
  Touching blocks;
  const Index low = blocks.brick_part(), high = blocks.brick_part();
  blocks.brick(low, 5.0, 5.0, 0.0, 10.0, 10.0);
  blocks.brick(high, 5.0, 5.0, 10.0, 14.0, 4.0);
  EXPECT_EQ(blocks.ties().size(), 4u);
  for (const Tie& t : blocks.ties()) EXPECT_FALSE(t.rotations);
}

// An edge that stands on a sheet touches it; what grows out of it does not.
TEST(TouchingSheets, Webs) {
  Touching standing;
  standing.sheet(1.0, {0, 0, 0}, 4, 4, 5.0);
  standing.sheet(1.0, {0.0, 9.0, 0.5}, 4, 3, 5.0, {1, 0, 0}, {0, 0, 1});
  EXPECT_EQ(standing.ties().size(), 5u);

  Touching grown;  // the web shares its nodes with the sheet; its second row is 0.8 above, within the reach of 2.05
  const Index base = grown.sheet(2.0, {0, 0, 0}, 4, 4, 5.0), web = grown.sheet_part();
  (void)base;
  std::vector<Index> row{10, 11, 12, 13, 14};
  for (int k = 1; k <= 4; ++k) {
    std::vector<Index> next;
    for (int i = 0; i < 5; ++i) next.push_back(grown.node({5.0 * i, 10.0, 0.8 * k}));
    for (std::size_t i = 0; i < 4; ++i) grown.shell(web, 2.0, {row[i], row[i + 1], next[i + 1], next[i]});
    row = next;
  }
  EXPECT_TRUE(grown.ties().empty()) << text(grown.findings);
}

// A weld's own tie comes first, and its flanges are tied as they touch.
TEST(TouchingSheets, WeldsKeepTheirTies) {
  Touching a;
  const Index low = a.sheet(1.0, {0, 0, 0}, 4, 4, 5.0), high = a.sheet(1.0, {0, 0, 1.0}, 4, 4, 5.0),
              welds = a.beam_part(5.0);
  a.beam(welds, Vec3d{8, 8, 0}, Vec3d{8, 8, 1.0});
  a.tie({welds}, {low, high});
  Findings found;
  const Ties ties = tie(a.model, found);
  expect_sound(a, ties.ties);
  EXPECT_EQ(ties.ties.size(), 25u + 2u);
  ASSERT_EQ(ties.welds.size(), 1u);
  EXPECT_TRUE(ties.welds[0].tied);
  for (const Projection& p : ties.welds[0].ends) EXPECT_EQ(p.tie.contact, 1);
  EXPECT_EQ(found.errors(), 0u);
}

// Sheets of a tube in a tube: over a ridge between two shells a node is over neither.
TEST(TouchingSheets, RoundSheets) {
  Touching a;
  constexpr int n = 24;
  std::array<Index, 2> parts{a.sheet_part(), a.sheet_part()};
  for (std::size_t tube = 0; tube < 2; ++tube) {
    const double r = 20.0 + 1.0 * static_cast<double>(tube);
    const Index first = static_cast<Index>(a.model.nodes.size());
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * M_PI * i / n;
        a.node({r * std::cos(angle), r * std::sin(angle), 5.0 * j});
      }
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < n; ++i) {
        const Index here = first + j * n + i, beside = first + j * n + (i + 1) % n;
        a.shell(parts[tube], 1.0, {here, beside, beside + n, here + n});
      }
  }
  const std::vector<Tie> ties = a.ties();
  expect_sound(a, ties);
  EXPECT_EQ(ties.size(), 3u * n);
}

}  // namespace
}  // namespace nugget::weld
