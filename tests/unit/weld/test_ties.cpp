// SPDX-License-Identifier: Apache-2.0
#include "weld/tie/ties.hpp"
#include "weld/tie/welds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "base/parallel.hpp"
#include "unit/weld/assembly.hpp"
#include "weld/tie/segment.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
using testing::HasSubstr;
using testing::Not;

/// Two sheets of 3 x 3 shells of 10 mm, 1 mm thick, touching (mid-surfaces at z = 0 and `height`); a part for weld
/// beams.
struct TwoSheets : Assembly {
  Index lower, upper, welds;
  Findings findings;
  explicit TwoSheets(double height = 1.0, double diameter = 5.0)
      : lower(sheet(1.0, {0, 0, 0})), upper(sheet(1.0, {0, 0, height})), welds(beam_part(diameter)) {
    tie({welds}, {lower, upper});
  }
  Ties tied() { return weld::tie(model, findings); }
};

void expect_weights(const Tie& tie, const std::array<double, 4>& expected) {
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(tie.weight[i], expected[i], 1e-12) << "corner " << i;
}

TEST(ProjectionCase1, OverTheCentroidAllFourNodesCarryAQuarter) {
  TwoSheets a;
  a.beam(a.welds, {15, 15, 0.2}, {15, 15, 0.9});
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  ASSERT_EQ(ties.ties.size(), 2u);
  EXPECT_TRUE(weld.tied);
  for (const Projection& p : weld.ends) {
    EXPECT_EQ(p.projection_case, 1);
    EXPECT_TRUE(p.tied);
    EXPECT_NEAR(p.tie.xi, 0.0, 1e-12);
    EXPECT_NEAR(p.tie.eta, 0.0, 1e-12);
    expect_weights(p.tie, {0.25, 0.25, 0.25, 0.25});
    EXPECT_TRUE(p.tie.rotations);
  }
  EXPECT_EQ(weld.sheets, (std::array<Index, 2>{a.lower, a.upper}));
  EXPECT_NEAR(weld.length_before, 0.7, 1e-12);
  EXPECT_NEAR(weld.length, 1.0, 1e-12);  // touching sheets: half the sum of the thicknesses
  EXPECT_NEAR(weld.ends[0].tie.moved, 0.2, 1e-12);
  EXPECT_NEAR(ties.x[weld.ends[0].node].z, 0.0, 1e-12);
  EXPECT_NEAR(ties.x[weld.ends[1].node].z, 1.0, 1e-12);
  EXPECT_EQ(a.findings.warnings(), 0) << text(a.findings);
  EXPECT_THAT(text(a.findings),
              HasSubstr("2 nodes tied, 2 of them moved onto the mid-surface, at most by 0.2 (node 33"));
}

TEST(ProjectionCase2, OnAnEdgeOnlyItsTwoNodesCarry) {
  TwoSheets a;
  a.beam(a.welds, {17, 10, 0}, {17, 10, 1});
  const Ties ties = a.tied();
  for (const Projection& p : ties.welds.at(0).ends) {
    EXPECT_EQ(p.projection_case, 2);
    EXPECT_NEAR(p.tie.eta, 1.0, 1e-12);       // of the two shells at the edge, the one with the lower index
    expect_weights(p.tie, {0, 0, 0.7, 0.3});  // (1 -+ xi)/2 with xi = 0.4
  }
  EXPECT_EQ(ties.welds[0].ends[0].tie.shell, 1);
}

TEST(ProjectionCase3, OnACornerItsNodeCarriesAll) {
  TwoSheets a;
  a.beam(a.welds, {10, 10, 0}, {10, 10, 1});
  const Ties ties = a.tied();
  for (const Projection& p : ties.welds.at(0).ends) {
    EXPECT_EQ(p.projection_case, 3);
    expect_weights(p.tie, {0, 0, 1, 0});
    EXPECT_EQ(a.model.nodes.x[p.tie.segment[2]].x, 10.0);
  }
}

TEST(ProjectionCase4, PenetratingSheetsInOrderAreTiedWithTheDistanceMoved) {
  TwoSheets a(0.6);
  a.beam(a.welds, {15, 15, -0.125}, {15, 15, 0.725});
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  EXPECT_TRUE(weld.tied);
  for (const Projection& p : weld.ends) {
    EXPECT_EQ(p.projection_case, 4);
    EXPECT_NEAR(p.tie.moved, 0.125, 1e-12);
    expect_weights(p.tie, {0.25, 0.25, 0.25, 0.25});
  }
  EXPECT_NEAR(weld.length, 0.6, 1e-12);
  EXPECT_THAT(text(a.findings),
              HasSubstr("warning: *ELEMENT_BEAM: beam weld 1000: node 33 at (15, 15, -0.125): the sheets "
                        "penetrate each other by 0.4; over shell 5 of part 1, 0.125 away, moved 0.125"));
}

// Nodes of the sheets stand elsewhere than in the deck, as contact leaves them. Sabotage: feet on the deck's sheets;
// the depth of the sheets as they stand now.
TEST(ProjectionCase4, SheetsThatContactMovedAreTiedToWhereTheyStand) {
  for (const double left : {0.0, 0.1}) {
    TwoSheets a(0.6);
    a.beam(a.welds, {15, 15, 0}, {15, 15, 0.6});
    std::vector<Vec3d> x = a.model.nodes.x;
    for (Index n = 0; n < 16; ++n) x[n].z = -0.2;
    for (Index n = 16; n < 32; ++n) x[n].z = 0.8 - left;
    const Ties ties = weld::tie(a.model, x, a.findings);
    const Weld& weld = ties.welds.at(0);
    EXPECT_TRUE(weld.tied);
    EXPECT_NEAR(weld.length_before, 0.6, 1e-12);
    EXPECT_NEAR(weld.length, 1.0 - left, 1e-12);
    for (const Projection& p : weld.ends) EXPECT_EQ(p.projection_case, 4);
    EXPECT_NEAR(weld.ends[1].tie.moved, 0.2 - left, 1e-12);
    EXPECT_NEAR(ties.x[weld.ends[0].node].z, -0.2, 1e-12);
    EXPECT_EQ(ties.x[0].z, -0.2);  // where the run starts
    EXPECT_THAT(text(a.findings), HasSubstr("node 33 at (15, 15, 0): the sheets penetrated each other by 0.4; contact "
                                            "moved this one by 0.2" +
                                            std::string(left > 0.0 ? ", and 0.1 is left" : "") +
                                            "; over shell 5 of part 1, 0.2 away, moved 0.2"));
  }
}

TEST(ProjectionCase5, NoSegmentInReachIsNotTied) {
  TwoSheets a(10.0);
  a.beam(a.welds, {45, 15, 0}, {15, 15, 10});
  const Ties ties = a.tied();
  const Weld& weld = ties.welds.at(0);
  EXPECT_FALSE(weld.tied);
  EXPECT_FALSE(weld.ends[0].tied);
  EXPECT_EQ(weld.ends[0].projection_case, 5);
  EXPECT_NEAR(weld.ends[0].distance, 15.0, 1e-12);
  EXPECT_NEAR(weld.ends[0].tolerance, 3.6, 1e-12);
  EXPECT_EQ(weld.ends[1].projection_case, 1);
  EXPECT_EQ(ties.ties.size(), 1u);
  EXPECT_EQ(ties.x[weld.ends[0].node].x, 45.0);
  EXPECT_THAT(
      text(a.findings),
      HasSubstr("beam weld 1000: node 33 at (45, 15, 0): no segment in reach: the closest, shell 6 of "
                "part 1, is 15 away, tolerance 3.6, not tied [move the weld to its sheet, or put the sheet that is "
                "meant on the reference side (SURFB) of the contact]"));
}

TEST(ProjectionCase5, OnlyForASheetAcrossTheWeldAndNotFarOffALargerToleranceIsAdvised) {
  const auto advised = [](const Vec3d& from, const Vec3d& to) {
    TwoSheets a(20.0);
    a.beam(a.welds, from, to);
    a.tied();
    return text(a.findings);
  };
  EXPECT_THAT(advised({15, 15, 5}, {15, 15, 20}),
              HasSubstr("is 5 away, tolerance 3.6, not tied [move the weld to its sheet, or give "
                        "SAST = SBST = -4.38 in the contact (tolerance 5.25)]"));
  EXPECT_THAT(advised({15, 15, 7.5}, {15, 15, 20}), Not(HasSubstr("SAST")));  // twice as far as reach goes
  EXPECT_THAT(advised({35, 15, 0}, {15, 15, 20}), Not(HasSubstr("SAST")));    // beside its sheet
  EXPECT_THAT(advised({15, 15, 5}, {17, 15, 5}), Not(HasSubstr("SAST")));     // the sheet lies along the weld
}

TEST(ProjectionCase5, FarFromAnySheetNoToleranceIsAdvised) {
  TwoSheets a(10.0);
  a.beam(a.welds, {75, 15, 0}, {15, 15, 10});
  a.tied();
  EXPECT_THAT(text(a.findings), HasSubstr("is 45 away, tolerance 3.6, not tied [move the weld to its sheet, or put the "
                                          "sheet that is meant on the reference side (SURFB) of the contact]"));
}

TEST(ProjectionCase6, BesideItsOwnSheetTheClosestOtherSegmentIsTaken) {
  // The node lies in the plane of `lower`, 3 mm (in reach of its border) or 6 mm (not) beyond it; a third sheet runs 1
  // mm below.
  for (const double beyond : {3.0, 6.0}) {
    TwoSheets a(2.0);
    const Index wide_top = a.sheet(1.0, {30, 0, 2});
    const Index below = a.sheet(1.0, {20, 0, -1});
    a.model.contacts[0].b.parts = {a.lower, a.upper, wide_top, below};
    a.beam(a.welds, {30 + beyond, 15, 0}, {30 + beyond, 15, 2});
    const Ties ties = a.tied();
    const Weld& weld = ties.welds.at(0);
    EXPECT_EQ(weld.ends[0].projection_case, 6);
    EXPECT_TRUE(weld.ends[0].tied);
    EXPECT_EQ(weld.sheets[0], below);
    EXPECT_NEAR(weld.ends[0].tie.moved, 1.0, 1e-12);
    EXPECT_EQ(weld.ends[1].projection_case, 1);
    EXPECT_THAT(text(a.findings), HasSubstr("over no segment of its own sheet; the closest is"));
    EXPECT_THAT(text(a.findings), HasSubstr("1 away, moved 1"));
  }
}

TEST(ProjectionCase6, BesideAllSheetsTheClosestBorderIsTaken) {
  TwoSheets a;
  a.beam(a.welds, {32, 15, 0}, {32, 15, 1});
  const Ties ties = a.tied();
  for (const Projection& p : ties.welds.at(0).ends) {
    EXPECT_EQ(p.projection_case, 6);
    EXPECT_NEAR(p.tie.xi, 1.0, 1e-12);
    EXPECT_NEAR(p.tie.moved, 2.0, 1e-12);
  }
  EXPECT_NEAR(ties.x[ties.welds[0].ends[0].node].x, 30.0, 1e-12);
}

/// Sheets that have passed through each other: end 1 wants the one that now lies above. The weld would be turned over.
void expect_crossing_sheets_refused(const Vec3d& e1, const Vec3d& e2, const Vec3d& corner_1, int expected_case) {
  Assembly a;
  Findings findings;
  const Index first = a.sheet(1.0, corner_1 + Vec3d{0, 0, 0.6}, 3, 3, 10.0, e1, e2);
  const Index second = a.sheet(1.0, {0, 0, 0.4});
  const Index welds = a.beam_part(5.0);
  const Index beam = a.beam(welds, {15, 15, 0}, {15, 15, 1});
  a.model.beams.tied_parts[beam] = {first, second};
  a.tie({welds}, {first, second});
  const Ties ties = weld::tie(a.model, findings);
  const Weld& weld = ties.welds.at(0);
  EXPECT_FALSE(weld.tied);
  EXPECT_TRUE(ties.ties.empty());
  for (const Projection& p : weld.ends) {
    EXPECT_FALSE(p.tied);
    EXPECT_EQ(p.projection_case, expected_case);
  }
  EXPECT_EQ(ties.x[weld.ends[0].node].z, 0.0);  // not projected
  EXPECT_NEAR(weld.length, 1.0, 1e-12);
  EXPECT_THAT(text(findings), HasSubstr("would turn the weld over or crush it (case " + std::to_string(expected_case)));
}

TEST(ProjectionCase7, CrossingSheetsWouldTurnTheWeldOver) {
  expect_crossing_sheets_refused({1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 7);
}

TEST(ProjectionCase8, CrossingSheetsWithNormalsOutward) {
  expect_crossing_sheets_refused({0, 1, 0}, {1, 0, 0}, {0, 0, 0}, 8);
}

TEST(ProjectionCase7, WhereSheetsCutEachOtherTheWeldWouldBeCrushed) {
  Assembly a;
  Findings findings;
  const double c = std::cos(0.3), s = std::sin(0.3);
  const Index flat = a.sheet(1.0, {0, 0, 0});
  const Index inclined = a.sheet(1.0, {0, 15 - 15 * c, -15 * s}, 3, 3, 10.0, {1, 0, 0}, {0, c, s});
  const Index welds = a.beam_part(5.0);
  a.beam(welds, {15, 15, -0.1}, {15, 15, 0.1});
  a.tie({welds}, {flat, inclined});
  const Ties ties = weld::tie(a.model, findings);
  EXPECT_EQ(ties.welds.at(0).ends[0].projection_case, 7);
  EXPECT_EQ(ties.welds.at(0).ends[1].projection_case, 7);
  EXPECT_TRUE(ties.ties.empty());
}

// Shares of a tie's force and mass, through the whole tie. Sabotage: exchange N2 and N3.
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

struct Spotstp : TwoSheets {
  Ties ties;
  explicit Spotstp(int value) : TwoSheets(10.0) {
    model.control.untied_weld = value;
    beam(welds, {15, 15, 0}, {15, 15, 10});  // sound
    beam(welds, {5, 5, 0.5}, {45, 5, 10});   // end 2 is beside the sheet
    beam(welds, {45, 5, 0}, {55, 5, 10});    // both are
    ties = tied();
  }
};

TEST(Spotstp, ZeroAndThreeWarnAndKeepTheWeld) {
  for (const int value : {0, 3}) {
    const Spotstp s(value);
    EXPECT_EQ(s.findings.errors(), 0);
    EXPECT_FALSE(s.ties.welds[1].deleted);
    EXPECT_EQ(s.ties.ties.size(), 3u);
    EXPECT_THAT(text(s.findings), HasSubstr("spotstp = " + std::to_string(value) +
                                            ": 2 welds are not tied, first beam weld 1001; they are kept"));
  }
}

TEST(Spotstp, OneIsAnErrorAfterAllAreListed) {
  const Spotstp s(1);
  EXPECT_EQ(s.findings.errors(), 1);
  const std::string all = text(s.findings);
  const auto error = all.find("error: *CONTROL_CONTACT spotstp = 1: 2 welds are not tied");
  ASSERT_NE(error, std::string::npos);
  for (const char* node : {"node 36 at", "node 37 at", "node 38 at"}) EXPECT_LT(all.find(node), error) << node;
}

TEST(Spotstp, TwoDeletesTheWeldAndLetsItsNodesGo) {
  const Spotstp s(2);
  EXPECT_EQ(s.findings.errors(), 0);
  EXPECT_FALSE(s.ties.welds[0].deleted);
  EXPECT_TRUE(s.ties.welds[1].deleted);
  EXPECT_TRUE(s.ties.welds[2].deleted);
  EXPECT_EQ(s.ties.ties.size(), 2u);
  EXPECT_FALSE(s.ties.welds[1].ends[0].tied);
  EXPECT_THAT(s.ties.welds[1].ends[0].reason, HasSubstr("released with the weld"));
  EXPECT_EQ(s.ties.x[s.ties.welds[1].ends[0].node].z, 0.5);
  EXPECT_THAT(text(s.findings), HasSubstr("they are deleted"));
}

TEST(Spotstp, ANodeSharedWithASoundWeldStaysTied) {
  TwoSheets a;
  a.model.control.untied_weld = 2;
  const Index n1 = a.node({15, 15, 0}), n2 = a.node({15, 15, 1}), n3 = a.node({15, 15, 30});
  a.beam(a.welds, n1, n2);
  a.beam(a.welds, n2, n3);
  const Ties ties = a.tied();
  EXPECT_TRUE(ties.welds[0].tied);
  EXPECT_TRUE(ties.welds[1].deleted);
  EXPECT_EQ(ties.ties.size(), 2u);
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
