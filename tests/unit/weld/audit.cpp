// SPDX-License-Identifier: Apache-2.0
#include "weld/audit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using test::Assembly;
using test::text;
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
  std::vector<std::string> names(std::size_t weld) const {
    std::vector<std::string> all;
    for (const Remark& r : reports.at(weld).remarks) all.emplace_back(r.check);
    return all;
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

TEST(Audit, ManyRemarksOfAKindAreCutAtTwenty) {
  Flange a;
  for (int i = 0; i < 30; ++i) a.beam(a.welds, {16, 16, 0}, {16, 16, 1});
  const Audited audited(a);
  EXPECT_EQ(audited.findings.warnings(), 21);
  EXPECT_THAT(text(audited.findings), HasSubstr("9 more: welds with a remark on 'twin'"));
  EXPECT_THAT(audited.names(29), ElementsAre("twin"));
}

// Validation: d = 6, L = 1.5, rho = 7.8e-9, DT = 1e-6.
TEST(Audit, TimeStepAndPriceOfABeam) {
  Flange a(6.0, 8.0, 1.5);
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 1.5;
  for (auto& material : a.model.materials) material.density = 7.8e-9;
  std::get<kernel::Spotweld>(a.model.materials.back().law).mass_step = 1e-6;
  a.beam(a.welds, {16, 16, 0}, {16, 16, 1.5});
  Report report = Audited(a).reports[0];
  EXPECT_NEAR(report.time_step, 2.89087e-7, 1e-12);
  EXPECT_NEAR(report.mass, 3.308097e-7, 1e-13);
  EXPECT_NEAR(report.mass_by_dt, 3.627597e-6, 1e-11);
  EXPECT_EQ(report.mass_by_dt2ms, 0.0);

  std::get<kernel::Spotweld>(a.model.materials.back().law).mass_step = 0.0;
  a.model.control.mass_step = -1e-6;
  report = Audited(a).reports[0];
  EXPECT_EQ(report.mass_by_dt, 0.0);
  EXPECT_NEAR(report.mass_by_dt2ms, 3.308097e-7 * (std::pow(9e-7 / 2.89087e-7, 2) - 1.0), 1e-11);
}

// Validation A-03: 5 x 5 x 1.5, steel.
TEST(Audit, TimeStepOfABrick) {
  Flange a;
  const Index bricks = a.solid_part();
  a.model.materials.back().density = 7.85e-9;
  for (Index n = 25; n < 50; ++n) a.model.nodes.x[n].z = 1.5;
  a.model.contacts[0].a.parts = {bricks};
  a.brick(bricks, 16, 16, 0, 1.5, 5.0);
  const Report report = Audited(a).reports[0];
  const double c = std::sqrt(210000.0 * 0.7 / (1.3 * 0.4 * 7.85e-9));
  EXPECT_NEAR(report.time_step, 1.5 / c, 1e-12);
  EXPECT_NEAR(report.mass, 7.85e-9 * 37.5, 1e-15);
}

TEST(Audit, ARigidWeldLimitsNoStep) {
  Flange a;
  model::RigidBody spot;
  spot.origin = model::RigidBody::Origin::weld;
  spot.nodes = {12, 37};
  a.model.rigid_bodies.push_back(spot);
  const Audited audited(a);
  EXPECT_TRUE(std::isinf(audited.reports.at(0).time_step));
  EXPECT_THAT(audited.names(0), IsEmpty());
}

TEST(Audit, EveryCheckHasANameOfItsOwnARuleAndARemedy) {
  std::set<std::string_view> names;
  for (const Check& check : checks()) {
    EXPECT_TRUE(names.insert(check.name).second) << check.name;
    EXPECT_FALSE(check.rule.empty());
    EXPECT_FALSE(check.remedy.empty());
  }
  EXPECT_EQ(names.size(), 7u);
}

}  // namespace
}  // namespace nugget::weld
