// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/ties.hpp"
#include "weld/tie/welds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/parallel.hpp"
#include "unit/weld/assembly.hpp"
#include "unit/weld/two_sheets.hpp"
#include "weld/tie/segment.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::expect_weights;
using test::text;
using test::TwoSheets;
using testing::HasSubstr;

TEST(Ties, WeightsOfTheValidationExample) {
  Assembly a;
  Findings findings;
  const Index p = a.sheet_part();
  const Index n1 = a.node({0, 0, 0}), n2 = a.node({10, 0, 0}), n3 = a.node({10, 8, 0}), n4 = a.node({0, 8, 0});
  a.shell(p, 1.2, {n1, n2, n3, n4});
  const Index welds = a.beam_part(1.0);
  a.beam(welds, {7, 2, 0.5}, {7, 2, 20});
  a.tie({welds}, {p});
  const Ties ties = weld::tie(a.model, findings);
  ASSERT_EQ(ties.ties.size(), 1u);
  expect_weights(ties.ties[0], {0.225, 0.525, 0.175, 0.075});
  EXPECT_EQ(describe(a.model, ties.ties[0]),
            "node 5 on segment 1 2 3 4 (shell 1 of part 1), xi 0.400000 eta -0.500000, moved 0.5");
}

/// Tolerance of a tie: t_s = 1.0, t_m = 1.2 on a segment of 10 x 8.
bool tied_at(double gap, double sast, double sbst, double size = 10.0) {
  Assembly a;
  Findings findings;
  const Index p = a.sheet_part();
  const Index n1 = a.node({0, 0, 0}), n2 = a.node({size, 0, 0}), n3 = a.node({size, 0.8 * size, 0}),
              n4 = a.node({0, 0.8 * size, 0});
  a.shell(p, 1.2, {n1, n2, n3, n4});
  const Index welds = a.beam_part(1.0);
  a.beam(welds, {0.5 * size, 0.4 * size, gap}, {0.5 * size, 0.4 * size, 20 * size});
  model::Contact& contact = a.tie({welds}, {p});
  contact.thickness_a = sast;
  contact.thickness_b = sbst;
  return weld::tie(a.model, findings).ties.size() == 1;
}

TEST(Ties, ToleranceIsSixTenthsOfBothThicknesses) {
  EXPECT_TRUE(tied_at(1.31, 0, 0));
  EXPECT_FALSE(tied_at(1.33, 0, 0));
}

TEST(Ties, ToleranceIsAtLeastFivePercentOfTheShorterDiagonal) {
  EXPECT_TRUE(tied_at(3.2, 0, 0, 50.0));  // 0.05 * 64.03 = 3.2016
  EXPECT_FALSE(tied_at(3.21, 0, 0, 50.0));
}

TEST(Ties, NegativeThicknessesReplaceTheTolerance) {
  EXPECT_TRUE(tied_at(1.33, -1.2, -1.2));
  EXPECT_TRUE(tied_at(1.43, -1.2, -1.2));
  EXPECT_FALSE(tied_at(1.45, -1.2, -1.2));
  EXPECT_FALSE(tied_at(1.31, -1.0, 0));  // also downward
  EXPECT_TRUE(tied_at(0.59, -1.0, 0));
}

TEST(Ties, PositiveThicknessesReplaceThoseOfTheElements) {
  EXPECT_TRUE(tied_at(1.45, 1.3, 0));  // 0.6 (1.3 + 1.2) = 1.5
  EXPECT_FALSE(tied_at(1.31, 0, 1.0));
}

TEST(Ties, TrianglesTakeBarycentricWeights) {
  Assembly a;
  Findings findings;
  const Index p = a.sheet_part();
  const Index n1 = a.node({0, 0, 0}), n2 = a.node({10, 0, 0}), n3 = a.node({0, 10, 0});
  a.shell(p, 1.0, {n1, n2, n3, n3});
  const Index welds = a.beam_part(2.0);
  a.beam(welds, {2, 3, 0}, {2, 0, 50});
  a.beam(welds, {2, 0, 0}, {2, 0, 50});
  a.beam(welds, {0, 10, 0}, {2, 0, 50});
  a.tie({welds}, {p});
  const Ties ties = weld::tie(a.model, findings);
  ASSERT_EQ(ties.ties.size(), 3u);
  expect_weights(ties.ties[0], {0.5, 0.2, 0.3, 0.0});
  EXPECT_EQ(ties.welds[0].ends[0].projection_case, 1);
  expect_weights(ties.ties[1], {0.8, 0.2, 0.0, 0.0});
  EXPECT_EQ(ties.welds[1].ends[0].projection_case, 2);
  expect_weights(ties.ties[2], {0.0, 0.0, 1.0, 0.0});
  EXPECT_EQ(ties.welds[2].ends[0].projection_case, 3);
}

TEST(Ties, BothEndsOfABeamGoToDifferentSheets) {
  TwoSheets a;
  a.beam(a.welds, {15, 15, 0.1}, {15, 15, 0.4});  // both closer to the lower sheet
  const Ties ties = a.tied();
  EXPECT_TRUE(ties.welds.at(0).tied);
  EXPECT_EQ(ties.welds[0].sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_NEAR(ties.welds[0].length, 1.0, 1e-12);
}

TEST(Ties, AWeldThatFloatsAboveItsSheetsIsNotTurnedOver) {
  TwoSheets a;
  a.beam(a.welds, {15, 15, 1.4}, {15, 15, 2.4});  // both closer to the upper sheet, end 1 the nearer one
  const Weld weld = a.tied().welds.at(0);
  EXPECT_TRUE(weld.tied);
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.lower, a.upper}));
}

TEST(Ties, WithoutASecondSheetTheFartherEndStaysFree) {
  TwoSheets a;
  a.model.contacts[0].b.parts = {a.lower};
  a.beam(a.welds, {15, 15, 0.4}, {15, 15, 0.1});
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  EXPECT_FALSE(weld.ends[0].tied);
  EXPECT_EQ(weld.ends[0].projection_case, 5);
  EXPECT_TRUE(weld.ends[1].tied);
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{none, a.lower}));
  EXPECT_THAT(
      text(a.findings),
      HasSubstr("the only sheet in reach, with shell 5 of part 1, holds the weld's other end, not tied [put the "
                "other sheet's part on the reference side (SURFB) of the contact]"));
}

TEST(Ties, WhereOnlyOneSheetIsInReachTheClosestOtherOneIsNamed) {
  TwoSheets a(5.0);
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.tied();
  EXPECT_THAT(
      text(a.findings),
      HasSubstr("the only sheet in reach, with shell 5 of part 1, holds the weld's other end; the closest other, "
                "shell 14 of part 2, is 4 away, tolerance 3.6, not tied [move the weld to its sheet, or give "
                "SAST = SBST = -3.5 in the contact (tolerance 4.2)]"));
}

TEST(Ties, ElementBeamPidRestrictsTheParts) {
  TwoSheets a(0.2);
  const Index third = a.sheet(1.0, {0, 0, 1.5});
  a.model.contacts[0].b.parts = {a.lower, a.upper, third};
  const Index beam = a.beam(a.welds, {15, 15, 0.1}, {15, 15, 0.5});
  a.model.beams.tied_parts[beam] = {none, third};
  EXPECT_EQ(a.tied().welds.at(0).sheets, (std::array<Index, 2>{a.lower, third}));
  a.model.beams.tied_parts[beam] = {a.upper, third};
  EXPECT_EQ(a.tied().welds.at(0).sheets, (std::array<Index, 2>{a.upper, third}));
}

TEST(Ties, APartOutOfReachIsNotReplacedByAnother) {
  TwoSheets a;
  const Index far = a.sheet(1.0, {0, 0, 9});
  a.model.contacts[0].b.parts = {a.lower, a.upper, far};
  const Index beam = a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.model.beams.tied_parts[beam] = {a.lower, far};
  const Ties ties = a.tied();
  EXPECT_EQ(ties.welds.at(0).ends[1].projection_case, 5);
  EXPECT_NEAR(ties.welds[0].ends[1].distance, 8.0, 1e-12);
}

TEST(Ties, TwoWeldsThatWantOneNodeOnDifferentPartsAreTold) {
  TwoSheets a;
  const Index n1 = a.node({15, 15, 0}), n2 = a.node({15, 15, 1}), n3 = a.node({15, 15, 2});
  a.model.beams.tied_parts[a.beam(a.welds, n1, n2)] = {a.lower, a.upper};
  a.model.beams.tied_parts[a.beam(a.welds, n2, n3)] = {a.lower, none};
  EXPECT_EQ(a.tied().welds.at(0).sheets[1], a.upper);
  EXPECT_THAT(text(a.findings), HasSubstr("weld 1001 wants node 34 tied to part 1, but a weld before it wants part 2"));
}

TEST(Ties, AStackOfThreeSheetsWithASharedMiddleNode) {
  TwoSheets a;
  const Index top = a.sheet(1.0, {0, 0, 2});
  a.model.contacts[0].b.parts = {a.lower, a.upper, top};
  const Index n1 = a.node({15, 15, 0.1}), n2 = a.node({15, 15, 1.1}), n3 = a.node({15, 15, 1.8});
  a.beam(a.welds, n1, n2);
  a.beam(a.welds, n2, n3);
  const Ties ties = a.tied();
  EXPECT_EQ(ties.welds.at(0).sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_EQ(ties.welds.at(1).sheets, (std::array<Index, 2>{a.upper, top}));
  EXPECT_EQ(ties.ties.size(), 3u);
  EXPECT_EQ(a.findings.warnings(), 0) << text(a.findings);
}

TEST(Ties, EqualGapsGoToTheLowerSegment) {
  TwoSheets a;
  a.model.contacts[0].b.parts = {a.upper, a.lower};  // order of the cards does not matter, order of the shells does
  a.beam(a.welds, {15, 15, 0.5 + 1e-8}, {15, 15, 30});
  EXPECT_EQ(a.tied().welds.at(0).sheets[0], a.lower);
}

TEST(Ties, TiedprjKeepsTheGap) {
  TwoSheets a;
  a.model.control.keep_tied_gap = true;
  a.beam(a.welds, {15, 15, 0.25}, {15, 15, 0.75});
  const Ties ties = a.tied();
  const Tie& tie = ties.welds.at(0).ends[0].tie;
  EXPECT_TRUE(ties.welds[0].tied);
  EXPECT_NEAR(tie.gap, 0.25, 1e-12);
  EXPECT_EQ(tie.moved, 0.0);
  EXPECT_NEAR(tie.point.z, 0.0, 1e-12);
  EXPECT_EQ(ties.x[tie.node].z, 0.25);
  EXPECT_EQ(ties.welds[0].length, 0.5);
}

TEST(Ties, OfTwoContactsTheFirstTies) {
  TwoSheets a;
  a.model.contacts[0].b.parts = {a.lower};
  a.tie({a.welds}, {a.upper});
  a.beam(a.welds, {15, 15, 0.1}, {15, 15, 0.9});
  const Ties ties = a.tied();
  EXPECT_EQ(ties.welds.at(0).sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_EQ(ties.ties[0].contact, 0);
  EXPECT_EQ(ties.ties[1].contact, 1);
  EXPECT_THAT(text(a.findings),
              HasSubstr("*CONTACT_SPOTWELD 2: node 33 at (15, 15, 0.1) is in reach, but *CONTACT_SPOTWELD 1 "
                        "has tied it already"));
}

TEST(Ties, EachPenetrationIsToldOfEachWeld) {
  TwoSheets a(0.6);
  for (int i = 0; i < 30; ++i) a.beam(a.welds, {15, 15, 0}, {15, 15, 0.6});
  a.tied();
  EXPECT_EQ(a.findings.warnings(), 60) << "lists of findings sum up what is alike";
}

TEST(Ties, ASheetOfARigidPartIsNotedOnceAndItsBodyNamed) {
  TwoSheets a;
  model::RigidBody body;
  body.id = 2;
  body.parts = {a.upper};
  for (Index n = 16; n < 32; ++n) body.nodes.push_back(n);
  a.model.rigid_bodies.push_back(body);
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.beam(a.welds, {5, 5, 0}, {5, 5, 1});
  const Ties ties = a.tied();
  EXPECT_EQ(ties.ties[0].rigid_body, none);
  EXPECT_EQ(ties.ties[1].rigid_body, 0);
  EXPECT_EQ(ties.ties[3].rigid_body, 0);
  const std::string all = text(a.findings);
  const auto first = all.find("part 2 belongs to rigid part 2");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(all.find("part 2 belongs to", first + 1), std::string::npos);
  EXPECT_EQ(a.findings.warnings(), 0);
}

TEST(Ties, ASegmentWithSomeNodesInARigidBodyIsWarnedOf) {
  TwoSheets a;
  model::RigidBody body;
  body.origin = model::RigidBody::Origin::nodal;
  body.id = 77;
  body.nodes = {5, 6};
  a.model.rigid_bodies.push_back(body);
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  EXPECT_EQ(a.tied().ties[0].rigid_body, none);
  EXPECT_THAT(text(a.findings), HasSubstr("its segment's node 6 belongs to nodal rigid body 77"));
}

/// A vertical sheet whose lower edge stands 0.3 above the upper of two sheets.
struct EdgeOnSheet : TwoSheets {
  Index web;
  EdgeOnSheet() : web(sheet(1.0, {5, 15, 1.3}, 2, 2, 10.0, {1, 0, 0}, {0, 0, 1})) {
    model::Contact& edge = tie({}, {upper});
    edge.kind = model::Contact::Kind::tied_shell_edge;
    edge.keyword = "CONTACT_TIED_SHELL_EDGE_TO_SURFACE";
    edge.a.nodes = {32, 33, 34};
  }
};

TEST(Ties, ShellEdgesAreTiedWithoutAWeld) {
  EdgeOnSheet a;
  const Ties ties = a.tied();
  EXPECT_TRUE(ties.welds.empty());
  ASSERT_EQ(ties.ties.size(), 3u);
  EXPECT_NEAR(ties.x[32].z, 1.0, 1e-12);
  EXPECT_TRUE(ties.ties[0].rotations);
  EXPECT_NEAR(ties.ties[0].moved, 0.3, 1e-12);
}

TEST(Ties, UntiedEdgeNodesAreSummedUp) {
  EdgeOnSheet a;
  a.model.contacts[1].a.nodes = {};
  a.model.contacts[1].a.parts = {a.web};
  EXPECT_EQ(a.tied().ties.size(), 3u);
  EXPECT_THAT(text(a.findings),
              HasSubstr("6 tracked nodes without a weld found no segment in reach, first node 36 at (5, 15, "
                        "11.3): the closest is 10.3 away, tolerance 1.2"));
}

TEST(Ties, AWeldOnATiedEdgeIsAChainAndNamesBothTies) {
  EdgeOnSheet a;
  const Index bracket = a.sheet(1.0, {5, 16, 1.3}, 2, 2, 10.0, {1, 0, 0}, {0, 0, 1});
  a.model.contacts[0].b.parts = {a.web, bracket};
  a.beam(a.welds, {12, 15, 4.3}, {12, 16, 4.3});
  a.tied();
  EXPECT_THAT(text(a.findings),
              HasSubstr("its segment's node 33 is itself tied by *CONTACT_TIED_SHELL_EDGE_TO_SURFACE 2 to"));
  EXPECT_EQ(a.findings.errors(), 0);
}

TEST(Ties, ANodeIsNotTiedToItsOwnShells) {
  TwoSheets a;
  a.model.contacts.clear();
  a.tie({a.upper}, {a.lower, a.upper});
  const Ties ties = a.tied();
  ASSERT_EQ(ties.ties.size(), 16u);
  for (const Tie& tie : ties.ties) EXPECT_EQ(a.model.shells.part[tie.shell], a.lower);
}

TEST(Ties, TiesInACircleAreRefused) {
  TwoSheets a;
  a.model.contacts.clear();
  a.tie({a.lower}, {a.upper});
  a.tie({a.upper}, {a.lower});
  a.tied();
  EXPECT_EQ(a.findings.errors(), 1);
  EXPECT_THAT(text(a.findings), HasSubstr("depend on each other in a circle"));
}

TEST(Ties, ATrackedNodeOfARigidBodyStaysWithIt) {
  TwoSheets a;
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  model::RigidBody body;
  body.origin = model::RigidBody::Origin::nodal;
  body.id = 9;
  body.nodes = {33};
  a.model.rigid_bodies.push_back(body);
  const Ties ties = a.tied();
  EXPECT_EQ(ties.ties.size(), 1u);
  EXPECT_TRUE(ties.welds[0].tied);
  EXPECT_EQ(ties.welds[0].ends[1].projection_case, 0);
  EXPECT_EQ(ties.welds[0].ends[1].reason, "belongs to rigid body 9");
  EXPECT_THAT(text(a.findings), HasSubstr("1 tracked nodes belong to rigid bodies and stay with them"));
}

TEST(Ties, AWeldThatEndsInASheetsOwnNodesNeedsNoTie) {
  TwoSheets a;
  a.beam(a.welds, 5, 21);  // node above node
  const Ties ties = a.tied();
  EXPECT_TRUE(ties.ties.empty());
  EXPECT_TRUE(ties.welds[0].tied);
  EXPECT_EQ(ties.welds[0].sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_EQ(ties.welds[0].ends[0].reason, "is a node of shell 1");
}

TEST(Ties, AnEdgeNodeThatCarriesAWeldIsTiedByItsEdgesContact) {
  EdgeOnSheet a;
  a.beam(a.welds, 33, a.node({15, 15, 9}));
  const Ties ties = a.tied();
  EXPECT_EQ(ties.ties.size(), 3u);
  EXPECT_TRUE(ties.welds[0].ends[0].tied);
  EXPECT_EQ(ties.welds[0].ends[0].tie.contact, 1);
}

TEST(Ties, SheetsOffTheirNodesAreWarnedOfOnceAPart) {
  TwoSheets a;
  a.model.shells.offsets.assign(a.model.shells.size(), -0.5);
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.tied();
  EXPECT_EQ(a.findings.warnings(), 2);
  EXPECT_THAT(text(a.findings), HasSubstr("the mid-surface of part 2 lies 0.5 off its nodes"));
}

/// Two sheets with a block of brick 5 mm wide on the upper one's place; a beam that ends on its face.
struct OnABlock : TwoSheets {
  Index block;
  OnABlock() : block(part(model::ElementKind::solid, kernel::Elastic{210000.0, 0.3})) {
    brick(block, 15, 15, 2, 10, 5.0);
    const Index weld_bricks = solid_part();  // these are not meant as sheets
    model.contacts[0].b.parts = {lower, block, weld_bricks};
    beam(welds, {15, 15, 0}, {15.5, 15, 2.2});
  }
};

TEST(Ties, TheOuterFacesOfBricksAreSegmentsToo) {
  OnABlock a;
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  ASSERT_EQ(ties.ties.size(), 2u);
  const Tie& tie = ties.ties[1];
  EXPECT_EQ(tie.shell, none);
  EXPECT_EQ(tie.part, a.block);
  EXPECT_FALSE(tie.rotations);
  EXPECT_FALSE(tie.couples);
  EXPECT_NEAR(ties.x[tie.node].z, 2.0, 1e-12);
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.lower, a.block}));
  EXPECT_THAT(text(a.findings), HasSubstr("tied to a face of part 4"));
  EXPECT_THAT(text(a.findings), HasSubstr("1 nodes with rotations are tied by translations only, as by hinges"));
  EXPECT_EQ(a.findings.warnings(), 1) << text(a.findings);
}

TEST(Ties, ShellEdgeToSolidHandsMomentsOverAsCouples) {
  OnABlock a;
  a.model.contacts[0].kind = model::Contact::Kind::tied_shell_edge_to_solid;
  const Ties ties = a.tied();
  EXPECT_FALSE(ties.ties[0].couples);
  EXPECT_TRUE(ties.ties[1].couples);
  EXPECT_TRUE(ties.ties[1].rotations);
  EXPECT_EQ(a.findings.warnings(), 0) << text(a.findings);
}

/// What the forms of a tie do with a gap of 0.25. Springs hold where SFSA below 1 asks for them; else the constraint
/// that they stand for.
TEST(Ties, FormsOfATie) {
  using Kind = model::Contact::Kind;
  using Offset = model::Contact::Offset;
  struct Form {
    Kind kind;
    Offset offset;
    bool torsion;
    bool moves, rotations, twist, spring, lever;
  };
  for (const Form& f : {Form{Kind::spotweld, Offset::projected, false, true, true, false, false, true},
                        Form{Kind::spotweld, Offset::projected, true, true, true, true, false, true},
                        Form{Kind::spotweld, Offset::constrained, false, false, true, false, false, true},
                        Form{Kind::spotweld, Offset::beam, true, false, true, true, true, true},
                        Form{Kind::tied_nodes, Offset::projected, false, true, false, false, false, true},
                        Form{Kind::tied_surface, Offset::penalty, false, false, false, false, true, false},
                        Form{Kind::tied_shell_edge, Offset::penalty, false, false, true, false, true, false},
                        Form{Kind::tied_shell_edge, Offset::beam, false, false, true, false, true, true}}) {
    TwoSheets stiff;
    stiff.model.contacts[0].kind = f.kind;
    stiff.model.contacts[0].offset = f.offset;
    stiff.beam(stiff.welds, {15, 15, 0.25}, {15, 15, 0.75});
    EXPECT_FALSE(stiff.tied().ties.at(0).spring);

    TwoSheets a;
    a.model.contacts[0].stiffness_scale_a = 0.9;
    a.model.contacts[0].kind = f.kind;
    a.model.contacts[0].offset = f.offset;
    a.model.contacts[0].torsion = f.torsion;
    a.beam(a.welds, {15, 15, 0.25}, {15, 15, 0.75});
    const Ties ties = a.tied();
    const Tie& tie = ties.welds.at(0).ends[0].tie;
    EXPECT_TRUE(ties.welds[0].tied);
    EXPECT_EQ(ties.x[tie.node].z, f.moves ? 0.0 : 0.25);
    EXPECT_EQ(tie.moved, f.moves ? 0.25 : 0.0);
    EXPECT_EQ(ties.welds[0].length, f.moves ? 1.0 : 0.5);
    EXPECT_EQ(tie.rotations, f.rotations);
    EXPECT_EQ(tie.twist, f.twist);
    EXPECT_EQ(tie.spring, f.spring);
    EXPECT_EQ(tie.lever, f.lever);
    EXPECT_EQ(a.findings.warnings(), f.rotations ? 0 : 1) << text(a.findings);
  }
}

TEST(Ties, IpbackPutsSpringsWhereConstraintsMeet) {
  TwoSheets a;
  model::RigidBody body;
  body.id = 2;
  body.parts = {a.upper};
  for (Index n = 16; n < 32; ++n) body.nodes.push_back(n);
  a.model.rigid_bodies.push_back(body);
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.model.contacts[0].penalty_fallback = true;
  const Ties ties = a.tied();
  EXPECT_FALSE(ties.ties[0].spring);
  EXPECT_TRUE(ties.ties[1].spring);
  EXPECT_EQ(ties.ties[1].rigid_body, 0);
  EXPECT_THAT(text(a.findings),
              HasSubstr("1 nodes or their segments are constrained already; springs hold them (IPBACK)"));
}

// Whatever else holds the node or its segment, a constraint must not. Sabotage: one of the reasons left out.
TEST(Ties, SpringsStayWhereAConstraintCannotBe) {
  const auto spring = [](auto change) {
    TwoSheets a;
    a.model.contacts[0].offset = model::Contact::Offset::beam;
    a.beam(a.welds, {15, 15, 0.25}, {15, 15, 0.75});
    change(a.model);
    return a.tied().ties.at(0).spring;
  };
  EXPECT_FALSE(spring([](model::Model&) {}));
  EXPECT_TRUE(spring([](model::Model& m) {
    m.spcs.emplace_back();
    m.spcs[0].node = 32;
    m.spcs[0].fixed = 7;
  }));
  EXPECT_TRUE(spring([](model::Model& m) { m.motions.emplace_back().nodes = {32}; }));
  EXPECT_TRUE(spring([](model::Model& m) { m.interpolations.emplace_back().node = 32; }));
  EXPECT_TRUE(spring([](model::Model& m) {
    m.rigid_bodies.emplace_back().nodes = {5, 6};
    m.rigid_bodies[0].id = 2;
  }));
  EXPECT_FALSE(spring([](model::Model& m) {
    m.rigid_bodies.emplace_back().nodes = {0, 1};  // another element's
    m.rigid_bodies[0].id = 2;
  }));
}

TEST(Ties, SpringsMayGoRoundInACircle) {
  TwoSheets a;
  a.model.contacts.clear();
  a.tie({a.lower}, {a.upper}).offset = model::Contact::Offset::beam;
  a.tie({a.upper}, {a.lower}).offset = model::Contact::Offset::beam;
  EXPECT_EQ(a.tied().ties.size(), 32u);
  EXPECT_EQ(a.findings.errors(), 0) << text(a.findings);
}

TEST(Ties, AWeldThatNoContactTracksIsWarnedOf) {
  TwoSheets a;
  a.model.contacts.clear();
  a.model.control.untied_weld = 1;
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  EXPECT_FALSE(a.tied().welds[0].tied);
  EXPECT_EQ(a.findings.errors(), 0);  // SPOTSTP is about what a contact tracks in vain
  EXPECT_THAT(text(a.findings), HasSubstr("beam weld 1000: node 33 at (15, 15, 0): no contact tracks it"));
}

TEST(Ties, ATieThatComesLaterIsRefusedOneThatEndsIsNot) {
  TwoSheets a;
  a.model.contacts[0].death = 0.01;
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.tied();
  EXPECT_EQ(a.findings.errors(), 0);
  a.model.contacts[0].birth = 0.001;
  a.tied();
  EXPECT_EQ(a.findings.errors(), 1);
  EXPECT_THAT(text(a.findings), HasSubstr("a tie of rotations that begins later is not built"));
}

TEST(Ties, AnEmptySideIsWarnedOf) {
  TwoSheets a;
  a.model.contacts[0].b.parts = {};
  a.beam(a.welds, {15, 15, 0}, {15, 15, 1});
  a.tied();
  EXPECT_THAT(text(a.findings), HasSubstr("the reference side (SURFB) has no shells or bricks: nothing is tied"));
}

TEST(Ties, ABrickWeldIsTiedByItsEightNodes) {
  TwoSheets a(1.0);
  const Index bricks = a.solid_part();
  a.model.contacts[0].a.parts = {bricks};
  a.brick(bricks, 15, 15, 0.1, 1.2, 4.0);
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  EXPECT_EQ(weld.kind, Weld::Kind::solid);
  EXPECT_TRUE(weld.tied);
  EXPECT_EQ(ties.ties.size(), 8u);
  EXPECT_FALSE(ties.ties[0].rotations);  // brick nodes have none: the face carries moments by couples
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_NEAR(weld.length_before, 1.1, 1e-12);
  EXPECT_NEAR(weld.length, 1.0, 1e-12);
  EXPECT_NEAR(weld.diameter, std::sqrt(4 * 16.0 / 3.14159265358979), 1e-9);  // sqrt(A/pi) would be the radius
}

TEST(Ties, TheFacesOfABrickAreThoseOnItsSheets) {
  TwoSheets a(4.0);
  const Index bricks = a.solid_part();
  a.model.contacts[0].a.parts = {bricks};
  a.brick(bricks, 15, 15, 0, 4, 3.0);
  auto& n = a.model.solids.node[0];
  n = {n[0], n[3], n[7], n[4], n[1], n[2], n[6], n[5]};  // numbered along x
  const Weld weld = a.tied().welds.at(0);
  EXPECT_NEAR(weld.length, 4.0, 1e-12);  // not the shortest distance, 3
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.lower, a.upper}));
}

TEST(Ties, AGeneralizedWeldSpotIsAWeldToo) {
  TwoSheets a;
  model::RigidBody spot;
  spot.origin = model::RigidBody::Origin::weld;
  spot.id = 41;
  spot.nodes = {5, 21};
  a.model.rigid_bodies.push_back(spot);
  model::RigidWeld rigid;
  rigid.kind = model::RigidWeld::Kind::generalized;
  rigid.id = 41;
  rigid.body = 0;
  rigid.nodes = {5, 21};
  a.model.rigid_welds.push_back(rigid);
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  EXPECT_EQ(weld.kind, Weld::Kind::rigid);
  EXPECT_EQ(weld.id, 41);
  EXPECT_EQ(keyword_of(weld), "*CONSTRAINED_GENERALIZED_WELD_SPOT");
  EXPECT_TRUE(weld.tied);
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_NEAR(weld.length, 1.0, 1e-12);
}

TEST(Ties, ReferenceSegmentsTakeThicknessAndPartFromTheirShells) {
  TwoSheets a;
  a.model.contacts[0].b.parts = {};
  for (const auto& nodes : a.model.shells.node) a.model.contacts[0].b.segments.push_back(nodes);
  a.beam(a.welds, {15, 15, 0.1}, {15, 15, 0.3});
  EXPECT_EQ(a.tied().welds.at(0).sheets, (std::array<Index, 2>{a.lower, a.upper}));
}

bool same(const Tie& a, const Tie& b) {
  return a.node == b.node && a.contact == b.contact && a.shell == b.shell && a.segment == b.segment && a.xi == b.xi &&
         a.eta == b.eta && a.weight == b.weight && a.gap == b.gap && a.moved == b.moved;
}

TEST(Ties, AreTheSameWithAnyNumberOfThreads) {
  Assembly a;
  const Index lower = a.sheet(1.0, {0, 0, 0}, 40, 40, 5.0), upper = a.sheet(1.2, {1, 2, 1.1}, 30, 30, 6.5);
  const Index welds = a.beam_part(5.0);
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-10.0, 210.0), height(-1.0, 2.0);
  for (int i = 0; i < 500; ++i) {
    const double x = place(random), y = place(random), z = height(random);
    a.beam(welds, {x, y, z}, {x, y, z + 1});
  }
  a.tie({welds}, {lower, upper});
  const int before = threads();
  Findings first_findings;
  set_threads(1);
  const Ties first = weld::tie(a.model, first_findings);
  EXPECT_GT(first.ties.size(), 500u);
  EXPECT_LT(first.ties.size(), 1000u);
  for (const int count : {2, 3}) {
    set_threads(count);
    Findings findings;
    const Ties ties = weld::tie(a.model, findings);
    EXPECT_EQ(text(findings), text(first_findings));
    ASSERT_EQ(ties.ties.size(), first.ties.size());
    for (std::size_t t = 0; t < ties.ties.size(); ++t) EXPECT_TRUE(same(ties.ties[t], first.ties[t])) << t;
  }
  set_threads(before);
}

// All segments looked at, one by one, must not find a closer one than the tree.
TEST(Ties, SearchAgreesWithBruteForce) {
  Assembly a;
  const Index sheet = a.sheet(1.0, {0, 0, 0}, 20, 20, 5.0);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> bump(-1.0, 1.0), place(0.0, 100.0), height(-2.0, 2.0);
  for (Vec3d& x : a.model.nodes.x) x.z = bump(random);
  const Index welds = a.beam_part(2.0);
  for (int i = 0; i < 300; ++i) a.beam(welds, {place(random), place(random), height(random)}, {0, 0, 500});
  a.tie({welds}, {sheet});
  Findings findings;
  const Ties ties = weld::tie(a.model, findings);
  int tied = 0;
  for (const Weld& weld : ties.welds) {
    const Projection& p = weld.ends[0];
    double least = 1e30;
    for (const auto& n : a.model.shells.node) {
      const auto& x = a.model.nodes.x;
      least = std::min(least, project({x[n[0]], x[n[1]], x[n[2]], x[n[3]]}, false, x[p.node]).distance);
    }
    if (p.tied) ++tied;
    EXPECT_EQ(p.tied, least <= 1.8);
    EXPECT_LE(p.distance, least + 1e-5);
    EXPECT_GE(p.distance, least - 0.05);  // the foot may lie in the extension of the segment
  }
  EXPECT_GT(tied, 200);
}

}  // namespace
}  // namespace nugget::weld
