// SPDX-License-Identifier: Apache-2.0
// The eight cases of how the end of a weld is projected onto its sheets, and what SPOTSTP does where it is not.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/weld/assembly.hpp"
#include "unit/weld/two_sheets.hpp"
#include "weld/tie/ties.hpp"
#include "weld/tie/welds.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::expect_weights;
using test::text;
using test::TwoSheets;
using testing::HasSubstr;
using testing::Not;

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

}  // namespace
}  // namespace nugget::weld
