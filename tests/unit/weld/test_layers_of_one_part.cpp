// SPDX-License-Identifier: Apache-2.0
// Weld beams between two layers of one part, such as the flanges of a section that its own welds close.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/weld/assembly.hpp"
#include "weld/audit/audit.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
using testing::HasSubstr;
using testing::Not;

/// Two sheets of 1 mm that touch, both of them part 1, and a sheet of part 2 that does not take part.
struct OnePart : Assembly {
  Index both, welds;
  Findings findings;
  OnePart() : both(sheet(1.0, {0, 0, 0})), welds(none) {
    const Index upper = sheet(1.0, {0, 0, 1});
    std::ranges::replace(model.shells.part, upper, both);
    welds = beam_part(5.0);
    tie({welds}, {both});
  }
  Ties tied() { return weld::tie(model, findings); }
};

// Sabotage: two places of one part are never two sheets.
TEST(LayersOfOnePart, ABeamBetweenThemIsTiedAtBothEnds) {
  OnePart a;
  a.beam(a.welds, {15, 15, 0.1}, {15, 15, 0.8});
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  EXPECT_TRUE(weld.tied) << text(a.findings);
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.both, a.both}));
  EXPECT_NEAR(weld.length, 1.0, 1e-12);
  EXPECT_EQ(a.findings.warnings(), 0) << text(a.findings);
  Findings of_audit;
  const std::vector<Report> reports = audit(a.model, ties, of_audit);
  EXPECT_THAT(text(of_audit), Not(HasSubstr("both ends on")));
  EXPECT_EQ(reports.at(0).stack, (std::vector<Index>{a.both, a.both}));
}

// The same with its sheets named, and with the node of one end in a shell. Sabotage: an end that is held already says
// nothing of where it is.
TEST(LayersOfOnePart, AlsoWhereTheyAreNamedAndWhereOneEndIsANodeOfIts) {
  OnePart named;
  named.model.beams.tied_parts[named.beam(named.welds, {15, 15, 0}, {15, 15, 1})] = {named.both, named.both};
  EXPECT_TRUE(named.tied().welds.at(0).tied) << text(named.findings);
  OnePart shared;
  shared.beam(shared.welds, 5, shared.node({10, 10, 0.9}));  // node 6 is that of the lower layer at (10, 10)
  EXPECT_TRUE(shared.tied().welds.at(0).tied) << text(shared.findings);
}

// A stack of three layers, of which the outer one is another part that is in reach of all nodes. Sabotage: another part
// before another layer that is closer.
TEST(LayersOfOnePart, TheCloserLayerComesBeforeAnotherPart) {
  OnePart a;
  const Index top = a.sheet(1.0, {0, 0, 2});
  a.model.contacts[0].b.parts = {a.both, top};
  const Index n1 = a.node({15, 15, 0}), n2 = a.node({15, 15, 1}), n3 = a.node({15, 15, 2});
  a.beam(a.welds, n1, n2);
  a.beam(a.welds, n2, n3);
  const Ties ties = a.tied();
  EXPECT_EQ(ties.welds.at(0).sheets, (std::array<Index, 2>{a.both, a.both}));
  EXPECT_EQ(ties.welds.at(1).sheets, (std::array<Index, 2>{a.both, top}));
  EXPECT_NEAR(ties.welds[0].length, 1.0, 1e-12);
  EXPECT_NEAR(ties.welds[1].length, 1.0, 1e-12);
  // Its sheets. Sabotage: a part once; an end twice where two welds meet.
  const std::vector<Report> reports = audit(a.model, ties, a.findings);
  EXPECT_EQ(reports.at(0).stack, (std::vector<Index>{a.both, a.both, top}));
  EXPECT_EQ(reports.at(1).spot, 0u);
}

// Both ends over one layer, along it and over a wall beside it: no two sheets. Sabotage: any two places apart are.
TEST(LayersOfOnePart, OneLayerIsNotTwoSheets) {
  for (const Vec3d& end : {Vec3d{15, 15, 0.4}, Vec3d{17, 15, 0.4}, Vec3d{17, 15, 0.1}}) {
    Assembly a;
    Findings findings;
    const Index sheet = a.sheet(1.0, {0, 0, 0});
    const Index welds = a.beam_part(5.0);
    a.beam(welds, {15, 15, 0.1}, end);
    a.tie({welds}, {sheet});
    EXPECT_FALSE(weld::tie(a.model, findings).welds.at(0).tied);
    EXPECT_THAT(text(findings), HasSubstr("holds the weld's other end"));
  }
  Assembly a;
  Findings findings;
  const Index floor = a.sheet(1.0, {0, 0, 0});
  const Index wall = a.sheet(1.0, {15.5, 0, 0}, 3, 3, 10.0, {0, 1, 0}, {0, 0, 1});
  std::ranges::replace(a.model.shells.part, wall, floor);
  const Index welds = a.beam_part(5.0);
  a.beam(welds, {15, 15, 0}, {15, 15, 1});
  a.tie({welds}, {floor});
  EXPECT_FALSE(weld::tie(a.model, findings).welds.at(0).tied) << text(findings);
}

// Two layers of bricks, of two parts; both ends lie in the middle of a brick, and as far from the faces of the lower
// part. Sabotage: faces of bricks are layers.
TEST(LayersOfOnePart, OppositeFacesOfABrickAreNot) {
  Assembly a;
  Findings findings;
  std::array<Index, 2> parts{};
  for (const std::size_t k : {0u, 1u}) {
    parts[k] = a.part(model::ElementKind::solid, kernel::Elastic{210000.0, 0.3});
    const double z = k == 0 ? 0.0 : 1.5;
    a.brick(parts[k], 0, 0, z, z + 1.5, 10.0);
  }
  const Index welds = a.beam_part(5.0);
  a.beam(welds, {0, 0, 0.75}, {0, 0, 2.25});
  a.tie({welds}, {parts[0], parts[1]});
  EXPECT_EQ(weld::tie(a.model, findings).welds.at(0).sheets, parts) << text(findings);
}

}  // namespace
}  // namespace nugget::weld
