// SPDX-License-Identifier: Apache-2.0
#include "weld/audit/audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Audited {
  std::vector<Report> reports;
  Findings findings;
  Ties ties;
  explicit Audited(const Assembly& a) {
    Findings of_ties;
    ties = tie(a.model, of_ties);
    reports = audit(a.model, ties, findings);
  }
  /// Names of the checks that warn of a weld.
  std::vector<std::string> names(std::size_t weld) const {
    std::vector<std::string> all;
    for (const Remark& r : reports.at(weld).remarks)
      if (r.check->severity == Severity::warning) all.emplace_back(r.check->name);
    return all;
  }
  const Remark* remark(std::size_t weld, std::string_view check) const {
    for (const Remark& r : reports.at(weld).remarks)
      if (r.check->name == check) return &r;
    return nullptr;
  }
  double value(std::size_t weld, std::string_view check) const {
    for (std::size_t c = 0; c < checks().size(); ++c)
      if (checks()[c].name == check) return reports.at(weld).values.at(c);
    return std::numeric_limits<double>::quiet_NaN();
  }
};

/// Two touching sheets of 1 mm, 4 x 4 shells; a sound weld has d = 5 in the middle.
struct Flange : Assembly {
  Index lower, upper, welds;
  explicit Flange(double diameter = 5.0, double size = 8.0, double thickness = 1.0)
      : lower(sheet(thickness, {0, 0, 0}, 4, 4, size)),
        upper(sheet(thickness, {0, 0, 1}, 4, 4, size)),
        welds(beam_part(diameter)) {
    tie({welds}, {lower, upper});
  }
};

TEST(Audit, ASoundWeldHasNoRemarks) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  const Audited audited(a);
  EXPECT_THAT(audited.names(0), IsEmpty()) << text(audited.findings);
  EXPECT_EQ(audited.findings.warnings(), 0);
}

TEST(Audit, DiameterAgainstTheThinnerSheet) {
  Flange a(3.0);  // 0.6 of the usual 5
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  EXPECT_THAT(Audited(a).names(0), ElementsAre("diameter", "mesh"));
  EXPECT_THAT(text(Audited(a).findings),
              HasSubstr("beam weld 1000: diameter 3, usual for sheets of 1 and 1 is 5 (expected"));
}

TEST(Audit, DiameterIsNotJudgedInOtherUnits) {
  Flange a(3.0);
  for (auto& material : a.model.materials) material.density = 7850.0;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  EXPECT_THAT(Audited(a).names(0), ElementsAre("mesh"));
}

TEST(Audit, OneSheetOnly) {
  Flange a;
  a.model.contacts[0].b.parts = {a.lower};
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  EXPECT_THAT(Audited(a).names(0), ElementsAre("sheets"));
}

TEST(Audit, TwinsWithinATenthOfTheDiameter) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  a.beam(a.welds, {16.4, 16, 0}, {16.4, 16, 1});
  a.beam(a.welds, {16, 16.6, 0}, {16, 16.6, 1});
  const Audited audited(a);
  EXPECT_THAT(audited.names(0), IsEmpty());
  EXPECT_THAT(audited.names(1), ElementsAre("twin"));
  EXPECT_EQ(audited.reports[1].remarks[0].text, "at the same place as beam weld 1000");
  EXPECT_THAT(audited.names(2), IsEmpty());
}

TEST(Audit, CoarseElements) {
  Flange a(5.0, 11.0);
  a.beam(a.welds, {22, 22, 0}, {22, 22, 1});
  EXPECT_THAT(Audited(a).names(0), ElementsAre("mesh"));
}

TEST(Audit, AxisOffTheNormal) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16.17, 16, 1});  // 9.6 degrees
  a.beam(a.welds, {14, 14, 0}, {14.20, 14, 1});  // 11.3 degrees
  const Audited audited(a);
  EXPECT_THAT(audited.names(0), IsEmpty());
  EXPECT_THAT(audited.names(1), ElementsAre("angle"));
}

TEST(Audit, CloseToTheFreeEdge) {
  Flange a;
  a.beam(a.welds, {4.9, 16, 0}, {4.9, 16, 1});
  a.beam(a.welds, {5.1, 20, 0}, {5.1, 20, 1});
  const Audited audited(a);
  EXPECT_THAT(audited.names(0), ElementsAre("edge"));
  EXPECT_THAT(audited.names(1), IsEmpty());
}

TEST(Audit, NoLength) {
  Flange a;
  a.model.contacts.clear();
  a.beam(a.welds, {16, 16, 0}, {16, 16, 0});
  EXPECT_THAT(Audited(a).names(0), ElementsAre("length"));
}

TEST(Audit, DeletedWeldsAreLeftOut) {
  Flange a;
  a.model.control.untied_weld = 2;
  a.model.contacts[0].b.parts = {a.lower};
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  const Audited audited(a);
  EXPECT_TRUE(audited.ties.welds[0].deleted);
  EXPECT_THAT(audited.names(0), IsEmpty());
}

TEST(Audit, TheWorstOfEachCheckAreFindingsAndTheRestIsCounted) {
  Flange a;
  for (int i = 0; i < 30; ++i) {
    const double tilt = 0.18 + 0.01 * i, y = 8.0 + 0.6 * i;
    a.beam(a.welds, {16, y, 0}, {16 + tilt, y, 1});
  }
  const Audited audited(a);
  std::vector<std::string> angles;
  for (const Finding& f : audited.findings.all())
    if (f.text.find("degrees off") != std::string::npos) angles.push_back(f.text.substr(0, 14));
  EXPECT_THAT(angles,
              ElementsAre("beam weld 1029", "beam weld 1028", "beam weld 1027", "beam weld 1026", "beam weld 1025"));
  EXPECT_THAT(text(audited.findings), HasSubstr("25 more welds with a remark on 'angle'; the worst are named"));
  EXPECT_THAT(audited.names(0), ElementsAre("angle"));
}

TEST(Audit, ASummaryCountsRemarksAndSpansTheValues) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  a.beam(a.welds, {8, 16, 0}, {8.6, 16, 1});
  for (const CheckSummary& found : summarise(Audited(a).reports)) {
    if (found.check->name != "angle") continue;
    EXPECT_EQ(found.remarks, 1u);
    EXPECT_EQ(found.least, 0.0);
    EXPECT_NEAR(found.most, 30.96, 0.01);
    EXPECT_THAT(found.worst, ElementsAre(1u));
  }
}

// Three sheets, welds 1-2 and 2-3 above each other, with nodes of their own or a common one; a third weld beside them.
TEST(Audit, WeldsAboveEachOtherAreOneSpot) {
  for (const bool common_node : {false, true}) {
    Flange a;
    const Index third = a.sheet(1.0, {0, 0, 2}, 4, 4, 8.0);
    a.model.contacts[0].b.parts.push_back(third);
    const Index bottom = a.node({12, 12, 0}), middle = a.node({12, 12, 1}), top = a.node({12, 12, 2});
    a.beam(a.welds, bottom, middle);
    a.beam(a.welds, common_node ? middle : a.node({12.5, 12, 1}), common_node ? top : a.node({12.5, 12, 2}));
    a.beam(a.welds, {25, 25, 0}, {25, 25, 1});
    const Audited audited(a);
    EXPECT_EQ(audited.reports[0].stack, (std::vector<Index>{a.lower, a.upper, third})) << common_node;
    EXPECT_EQ(audited.reports[1].spot, 0u);
    EXPECT_EQ(audited.value(1, "stack"), 3.0);
    EXPECT_EQ(audited.reports[2].spot, 2u);
    EXPECT_EQ(audited.value(2, "stack"), 2.0);
    EXPECT_THAT(audited.names(0), IsEmpty()) << text(audited.findings);
    EXPECT_NEAR(audited.value(0, "pitch"), std::hypot(13.0, 13.0), 0.6) << "not to the other weld of its own spot";
  }
}

TEST(Audit, FiveSheetsAreTooMany) {
  Flange a;
  for (int i = 2; i < 5; ++i) a.model.contacts[0].b.parts.push_back(a.sheet(1.0, {0, 0, 1.0 * i}, 4, 4, 8.0));
  for (int i = 0; i < 4; ++i) a.beam(a.welds, {12, 12, 1.0 * i}, {12, 12, 1.0 + i});
  const Audited audited(a);
  EXPECT_THAT(audited.names(0), ElementsAre("stack"));
  EXPECT_EQ(audited.remark(3, "stack")->text, "one of a stack of 5 sheets");
}

TEST(Audit, ThicknessFromHalfToFourMillimetres) {
  for (const auto& [thickness, sound] : {std::pair{0.45, false}, {0.55, true}, {3.9, true}, {4.1, false}}) {
    Flange a(5.0 * std::sqrt(thickness), 10.0, thickness);
    for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = thickness;
    a.beam(a.welds, {15, 15, 0}, {15, 15, thickness});
    EXPECT_EQ(Audited(a).remark(0, "thickness") == nullptr, sound) << thickness;
  }
}

TEST(Audit, LimitsInMillimetresHoldInMetres) {
  Flange a(0.003, 0.008, 0.001);
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 0.001;
  for (auto& material : a.model.materials) {
    material.density = 7850.0;
    material.law = kernel::Elastic{2.1e11, 0.3};
  }
  a.model.materials.back().law = Assembly::weld_law();
  a.beam(a.welds, {0.012, 0.012, 0}, {0.012, 0.012, 0.001});
  EXPECT_NEAR(Audited(a).value(0, "diameter"), 0.6, 1e-9);
}

// A strip of three elements with a wall folded up at right angles behind it.
TEST(Audit, AFlangeIsAsWideAsItsElementsUpToTheFold) {
  for (const int across : {2, 3}) {
    Assembly a;
    const Index lower = a.sheet(1.0, {0, 0, 0}, 12, 4, 6.0);
    const Index upper = a.sheet(1.0, {0, 0, 1}, 20, across, 6.0);
    const auto edge = static_cast<Index>(a.model.nodes.size()) - 21;
    std::vector<Index> below(21);
    for (int i = 0; i <= 20; ++i) below[i] = edge + i;
    for (int row = 1; row <= 3; ++row) {
      std::vector<Index> above(21);
      for (int i = 0; i <= 20; ++i) above[i] = a.node({6.0 * i, 6.0 * across, 1.0 + 6.0 * row});
      for (int i = 0; i < 20; ++i) a.shell(upper, 1.0, {below[i], below[i + 1], above[i + 1], above[i]});
      below = above;
    }
    const Index welds = a.beam_part(5.0);
    a.tie({welds}, {lower, upper});
    a.beam(welds, {33, 6, 0}, {33, 6, 1});
    const Audited audited(a);
    EXPECT_EQ(audited.value(0, "flange"), across);
    EXPECT_EQ(audited.remark(0, "flange") == nullptr, across == 3) << text(audited.findings);
  }
}

TEST(Audit, NoFlangeInTheMiddleOfAPanel) {
  Assembly a;
  const Index lower = a.sheet(1.0, {0, 0, 0}, 14, 14, 5.0), upper = a.sheet(1.0, {0, 0, 1}, 14, 14, 5.0);
  const Index welds = a.beam_part(5.0);
  a.tie({welds}, {lower, upper});
  a.beam(welds, {36, 36, 0}, {36, 36, 1});
  EXPECT_TRUE(std::isnan(Audited(a).value(0, "flange")));
}

TEST(Audit, PitchInThicknesses) {
  Flange a;
  a.beam(a.welds, {11, 16, 0}, {11, 16, 1});
  a.beam(a.welds, {20.5, 16, 0}, {20.5, 16, 1});
  const Audited audited(a);
  EXPECT_NEAR(audited.value(0, "pitch"), 9.5, 1e-9);
  ASSERT_NE(audited.remark(0, "pitch"), nullptr);
  EXPECT_EQ(audited.remark(0, "pitch")->text, "9.5 from beam weld 1001, 9.5 thicknesses of 1");
  EXPECT_THAT(audited.names(0), IsEmpty()) << "a note is no warning";
}

TEST(Audit, LengthAgainstTheSheetsAfterProjection) {
  Flange a;
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 3.5;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 3.5});
  const Audited audited(a);
  EXPECT_THAT(audited.names(0), ElementsAre("length"));
  EXPECT_NEAR(audited.value(0, "length"), 3.5, 1e-9);
}

// Sheets that have passed through each other by 0.6 beyond their places: a plain beam's ends go to the closest ones.
// Stubs, and beams that name their sheets, are not judged.
TEST(Audit, PlainBeamsPulledOut) {
  Flange a;
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 2.2;
  a.beam(a.welds, {16, 16, 0.6}, {16, 16, 1.6});
  a.beam(a.welds, {24, 16, 1.0}, {24, 16, 1.2});
  const Index named = a.beam(a.welds, {16, 24, 0.6}, {16, 24, 1.6});
  a.model.beams.tied_parts[named] = {a.lower, a.upper};
  const Audited audited(a);
  ASSERT_NE(audited.remark(0, "stretch"), nullptr);
  EXPECT_EQ(audited.remark(0, "stretch")->text,
            "projection moves its ends by 0.6 and 0.6 and makes it 2.2 long, drawn 1");
  EXPECT_NEAR(audited.value(0, "stretch"), 2.2, 1e-9);
  EXPECT_EQ(audited.remark(1, "stretch"), nullptr);
  EXPECT_EQ(audited.remark(2, "stretch"), nullptr);
}

TEST(Audit, AspectRatioOfABrickByItsElementForm) {
  for (const auto& [elform, height, sound] :
       {std::tuple{1, 0.6, true}, {1, 0.4, false}, {2, 2.2, true}, {2, 1.5, false}}) {
    Flange a;
    const Index bricks = a.solid_part();
    model::SectionSolid section;
    section.elform = elform;
    a.model.solid_sections.push_back(section);
    a.model.parts[bricks].section = 0;
    for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = height;
    a.model.contacts[0].a.parts = {bricks};
    a.brick(bricks, 16, 16, 0, height, 5.0);
    const Audited audited(a);
    EXPECT_NEAR(audited.value(0, "aspect"), 5.0 / height, 1e-9);
    EXPECT_EQ(audited.remark(0, "aspect") == nullptr, sound) << elform << ' ' << height;
  }
}

TEST(Audit, AWeldThatLimitsTheStepUntilItIsScaled) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  EXPECT_NE(Audited(a).remark(0, "step"), nullptr);
  EXPECT_EQ(Audited(a).remark(0, "mass"), nullptr);
  std::get<kernel::Spotweld>(a.model.materials.back().law).mass_step = 2e-6;
  EXPECT_EQ(Audited(a).remark(0, "step"), nullptr);
  // 106 times the weld's mass on two shells of 8 x 8 x 1: 0.98 of their mass; the step of 2e-6 takes four times that.
  ASSERT_NE(Audited(a).remark(0, "mass"), nullptr);
  EXPECT_NEAR(Audited(a).value(0, "mass"), 19.635 * (std::pow(2e-6 * std::sqrt(210000.0 / 7.85e-9), 2) - 1.0) / 128.0,
              1e-3);
}

TEST(Audit, WeldsInASlidingContact) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  model::Contact sliding;
  sliding.keyword = "CONTACT_AUTOMATIC_SINGLE_SURFACE";
  sliding.a.parts = {a.lower, a.upper};
  a.model.contacts.push_back(sliding);
  EXPECT_EQ(Audited(a).findings.warnings(), 0);
  a.model.contacts.back().a.parts.push_back(a.welds);
  EXPECT_THAT(text(Audited(a).findings),
              HasSubstr("warning: *CONTACT_AUTOMATIC_SINGLE_SURFACE: the weld part 3 is in this"));
  a.model.contacts.back().a = {};
  a.model.contacts.back().a.everything = true;
  EXPECT_THAT(text(Audited(a).findings),
              HasSubstr("note: *CONTACT_AUTOMATIC_SINGLE_SURFACE: the weld part 3 is in this"));
}

TEST(Audit, SeveralSpotweldContactsWhereOneWouldDo) {
  Flange a;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  EXPECT_THAT(text(Audited(a).findings), testing::Not(HasSubstr("one is enough")));
  a.tie({a.beam_part(5.0)}, {a.lower, a.upper});
  EXPECT_THAT(text(Audited(a).findings),
              HasSubstr("2 *CONTACT_SPOTWELD contacts, first *CONTACT_SPOTWELD 1; one is enough"));
}

// Step and mass scaling of a weld: d = 6, L = 1.5, rho = 7.8e-9, DT = 1e-6.
TEST(Audit, TimeStepAndPriceOfABeam) {
  Flange a(6.0, 8.0, 1.5);
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 1.5;
  for (auto& material : a.model.materials) material.density = 7.8e-9;
  std::get<kernel::Spotweld>(a.model.materials.back().law).mass_step = 1e-6;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1.5});
  MassScalingCost report = Audited(a).reports[0].cost;
  EXPECT_NEAR(report.time_step, 2.89087e-7, 1e-12);
  EXPECT_NEAR(report.mass, 3.308097e-7, 1e-13);
  EXPECT_NEAR(report.mass_by_dt, 3.627597e-6, 1e-11);
  EXPECT_EQ(report.mass_by_dt2ms, 0.0);

  std::get<kernel::Spotweld>(a.model.materials.back().law).mass_step = 0.0;
  a.model.control.mass_step = -1e-6;
  report = Audited(a).reports[0].cost;
  EXPECT_EQ(report.mass_by_dt, 0.0);
  EXPECT_NEAR(report.mass_by_dt2ms, 3.308097e-7 * (std::pow(9e-7 / 2.89087e-7, 2) - 1.0), 1e-11);
}

// Mass scaling of a weld, docs/theory/time_step.md#step-of-a-weld: E = 210000, rho = 7.89e-9, d = 5, L = 0.5 takes
// 106.46 times the mass, or a modulus of 1972 MPa, for a microsecond.
TEST(Audit, TwoWaysToATargetStep) {
  MassScalingCost weld;
  weld.young = 210000.0;
  weld.time_step = 0.5 / std::sqrt(210000.0 / 7.89e-9);
  weld.mass = 7.89e-9 * 0.25 * std::numbers::pi * 25.0 * 0.5;
  const StepCost target = cost_of_step(weld, 1e-6);
  EXPECT_NEAR(target.young, 0.5 * 0.5 * 7.89e-9 / 1e-12, 1e-6);
  EXPECT_NEAR(target.mass, 8.169e-6, 1e-9);
  EXPECT_NEAR((weld.mass + target.mass) / weld.mass, 106.46, 0.01);
  EXPECT_EQ(cost_of_step(weld, 5e-8).mass, 0.0);
  EXPECT_EQ(cost_of_step(weld, 5e-8).young, 210000.0);
}

// Step of a brick: 5 x 5 x 1.5, steel.
TEST(Audit, TimeStepOfABrick) {
  Flange a;
  const Index bricks = a.solid_part();
  a.model.materials.back().density = 7.85e-9;
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 1.5;
  a.model.contacts[0].a.parts = {bricks};
  a.brick(bricks, 16, 16, 0, 1.5, 5.0);
  a.model.control.hourglass.bulk_linear = 0.0;
  const MassScalingCost report = Audited(a).reports[0].cost;
  const double c = std::sqrt(210000.0 * 0.7 / (1.3 * 0.4 * 7.85e-9));
  EXPECT_NEAR(report.time_step, 1.5 / c, 1e-12);
  EXPECT_NEAR(report.mass, 7.85e-9 * 37.5, 1e-15);
  a.model.control.hourglass.bulk_linear = 0.06;  // as a brick at rest runs
  EXPECT_NEAR(Audited(a).reports[0].cost.time_step, 1.5 / c / (0.06 + std::sqrt(1.0036)), 1e-12);
}

void weld_rigidly(Flange& a, Index first, Index second) {
  model::RigidBody held;
  held.origin = model::RigidBody::Origin::weld;
  held.nodes = {first, second};
  model::RigidWeld spot;
  spot.body = static_cast<Index>(a.model.rigid_bodies.size());
  spot.nodes = held.nodes;
  a.model.rigid_bodies.push_back(held);
  a.model.rigid_welds.push_back(spot);
}

TEST(Audit, ARigidWeldLimitsNoStep) {
  Flange a;
  weld_rigidly(a, 12, 37);
  const Audited audited(a);
  EXPECT_TRUE(std::isinf(audited.reports.at(0).cost.time_step));
  EXPECT_THAT(audited.names(0), IsEmpty());
}

TEST(Audit, ARigidWeldAcrossTheSheetsNormalIsTold) {
  Flange a;
  weld_rigidly(a, 12, 38);  // one node aside
  EXPECT_THAT(Audited(a).names(0), Contains("angle"));
}

TEST(Audit, EveryCheckHasANameOfItsOwnARuleAndARemedy) {
  std::set<std::string_view> names;
  for (const Check& check : checks()) {
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
    EXPECT_FALSE(check.rule.empty());
    EXPECT_FALSE(check.remedy.empty());
  }
  EXPECT_EQ(names.size(), 15u);
}

}  // namespace
}  // namespace nugget::weld
