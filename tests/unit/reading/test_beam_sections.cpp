// SPDX-License-Identifier: Apache-2.0
// *INTEGRATION_BEAM, STYPE of *SECTION_BEAM, and what of them is refused.
#include <gmock/gmock.h>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

/// A beam between nodes 1 and 2 with a section's cards and more.
std::string deck(const std::string& section, const std::string& more = {}) {
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n1,0.0,0.0,0.0\n2,100.0,0.0,0.0\n3,0.0,1.0,0.0\n"
         "*PART\nbeam\n1,1,1\n*SECTION_BEAM\n" +
         section + "*MAT_ELASTIC\n1,7.85e-9,2.1e5,0.3\n*ELEMENT_BEAM\n1,1,1,2,3\n" + more + "*END\n";
}
const std::string by_rule = "1,1,,-7\n0.0\n", box = "1,1,,-7,2\n20.0,,10.0\n";
std::string rule(const std::string& cards) {
  return "*INTEGRATION_BEAM\n" + cards;
}

TEST(BeamSectionCards, StandardCrossSections) {
  // W 173.2 x 15.7, depth 363.4, web 9.1, as a public deck of a column has it, in mm.
  const Built built(deck(by_rule, rule("7,0,0.0,1,0\n173.2,15.7,363.4,9.1\n")));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const SectionBeam& section = built.model.beam_sections[0];
  ASSERT_TRUE(section.points);
  EXPECT_EQ(section.points->fibres.count, 24);
  EXPECT_NEAR(section.area, 8459.68, 0.01);
  EXPECT_EQ(section.points->offset_s, 0.0);

  const Built refined(deck(by_rule, rule("7,0,0.0,1,2\n173.2,15.7,363.4,9.1,1.0,-1.0\n")));
  ASSERT_EQ(refined.findings.errors(), 0) << refined.all_findings();
  EXPECT_EQ(refined.model.beam_sections[0].points->fibres.count, 72);
  EXPECT_NEAR(refined.model.beam_sections[0].points->offset_s, -86.6, 1e-9);  // nodes at the upper side
  EXPECT_NEAR(refined.model.beam_sections[0].points->offset_t, 181.7, 1e-9);

  // D5 and D6 stand behind SREF and TREF. Two rules under one keyword.
  const Built two(deck(by_rule, rule("6,0,,8\n5.0\n7,0,0.0,10\n100.0,60.0,40.0,5.0,0.0,0.0,9.0,7.0\n")));
  ASSERT_EQ(two.findings.errors(), 0) << two.all_findings();
  EXPECT_NEAR(two.model.beam_sections[0].area, 60 * 9 + 40 * 7 + 5 * 84, 1e-9);
  EXPECT_TRUE(two.find(Severity::note, "centroid lies 0 along s")) << two.all_findings();
}

TEST(BeamSectionCards, PointsOfTheUser) {
  const Built built(deck(box, rule("7,2,0.5\n-0.5,1.0,0.25\n0.5,-1.0,0.75\n")));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& points = *built.model.beam_sections[0].points;
  ASSERT_EQ(points.fibres.count, 2);
  EXPECT_DOUBLE_EQ(points.fibres.s[0], -5.0);
  EXPECT_DOUBLE_EQ(points.fibres.t[0], 5.0);
  EXPECT_DOUBLE_EQ(points.fibres.area[1], 75.0);
  EXPECT_DOUBLE_EQ(points.offset_s, 2.5);
  const Built moved(deck("1,1,,-7,2\n20.0,,10.0,,1.0\n", rule("7,2,0.5\n-0.5,1.0,0.25\n0.5,-1.0,0.75\n")));
  EXPECT_DOUBLE_EQ(moved.model.beam_sections[0].points->fibres.s[0], -15.0);
  EXPECT_TRUE(Built(deck(box, rule("7,2,0.5\n-0.5,1.0,0.25\n0.5,-1.0,0.25\n"))).warning("shares sum up to 0.5"));
}

TEST(BeamSectionCards, WhatIsWrongIsRefusedByField) {
  EXPECT_TRUE(Built(deck(by_rule)).error("rule 7 is not defined", "qr_irid"));
  EXPECT_TRUE(Built(deck("1,1,,9\n2.0,,2.0\n")).error("no rule of this number", "qr_irid"));
  EXPECT_TRUE(Built(deck("1,1,,2,2\n2.0,,2.0\n")).error("needs the id of its rule", "qr_irid"));
  EXPECT_TRUE(Built(deck("1,1,,2,3\n2.0,,2.0\n")).error("not known", "cst"));
  EXPECT_TRUE(Built(deck("1,1\n0.0,,2.0\n")).error("must be given", "ts1"));
  EXPECT_TRUE(Built(deck("1,9,,-7,1\n2.0\n", rule("7,0,,8\n5.0\n"))).error("welds with integration rules", "qr_irid"));
  const auto wrong = [](const std::string& cards, const std::string& section = by_rule) {
    return Built(deck(section, rule(cards)));
  };
  EXPECT_TRUE(wrong("7,0,,23\n5.0\n").error("", "icst"));
  EXPECT_TRUE(wrong("7,4,,1\n173.2,15.7,363.4,9.1\n").error("points of its own", "nip"));
  EXPECT_TRUE(wrong("7,0,0.4,1\n173.2,15.7,363.4,9.1\n").error("area of its own", "ra"));
  EXPECT_TRUE(wrong("7,0,,1\n173.2,15.7,363.4\n").error("needs D1 to D4", "d4"));
  EXPECT_TRUE(wrong("7,0,,8\n5.0,2.0\n").error("a full circle has 1 dimension", "d2"));
  EXPECT_TRUE(wrong("7,0,,9\n5.0,5.0\n").error("inner radius", "d2"));
  EXPECT_TRUE(wrong("7,0,,1\n173.2,15.7,30.0,9.1\n").error("its web would be 9.1 wide and -1.4 high", "d1"));
  EXPECT_TRUE(wrong("7,0,,1,6\n173.2,15.7,363.4,9.1\n").error("more than 144 points", "k"));
  EXPECT_TRUE(wrong("7,0,,8\n5.0\n7,0,,8\n5.0\n").error("defined twice", "irid"));
  EXPECT_TRUE(wrong("7,0,1.0\n").error("neither a standard", "nip"));
  EXPECT_TRUE(wrong("7,1\n0.0,0.0,1.0\n", box).error("need the area", "ra"));
  EXPECT_TRUE(wrong("7,1,1.0\n0.0,0.0,1.0,4\n", box).error("", "pid"));
  EXPECT_TRUE(wrong("7,1,1.0\n0.0,0.0\n", box).error("must be given", "wf"));
  EXPECT_TRUE(wrong("7,1,1.0\n1.5,0.0,1.0\n", box).error("", "s"));
  EXPECT_TRUE(wrong("7,1,1.0\n0.0,0.0,1.0\n").error("need the rectangle", "ts1"));
  EXPECT_TRUE(wrong("7,1,1.0\n0.0,0.0,1.0\n", "1,1,,-7,1\n20.0,,10.0\n").error("CST 1", "ts1"));
  EXPECT_TRUE(wrong("7,0,,8\n5.0\n", "1,1,,-7\n0.0,,,,1.0\n").warning("not by NSLOC"));
}

TEST(BeamSectionCards, ShapesByTheirName) {
  const Built built(deck("1,2\nSECTION_11,20.0,10.0\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const SectionBeam& s = built.model.beam_sections[0];
  EXPECT_NEAR(s.area, 200.0, 1e-9);
  EXPECT_NEAR(s.moment_s, 20.0 * 1000.0 / 12.0, 1e-9);
  EXPECT_NEAR(s.moment_t, 10.0 * 8000.0 / 12.0, 1e-9);
  EXPECT_NEAR(s.torsion_constant, 0.229 * 20.0 * 1000.0, 0.002 * 4580.0);  // Timoshenko's table
  const Built bar(deck("1,3\nsection_08       5.0\n"));
  ASSERT_EQ(bar.findings.errors(), 0) << bar.all_findings();
  EXPECT_NEAR(bar.model.beam_sections[0].area, 78.5398, 1e-4);

  EXPECT_TRUE(Built(deck("1,2\nSECTION_23,5.0\n")).error("no cross-section of this name", "stype"));
  EXPECT_TRUE(Built(deck("1,2\nSECTION_X,5.0\n")).error("no cross-section of this name", "stype"));
  EXPECT_TRUE(Built(deck("1,2\nSECTION_11,5.0\n")).error("a full rectangle needs D1 to D2", "d2"));
  EXPECT_TRUE(Built(deck("1,2\nSECTION_03,50.0,5.0,50.0,5.0\n")).error("principal axes of an angle", "stype"));
  EXPECT_EQ(Built(deck("1,3\nSECTION_03,50.0,5.0,50.0,5.0\n")).findings.errors(), 0);
}

}  // namespace
}  // namespace nugget::reading
