// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "assembly.hpp"
#include "weld/failure/function.hpp"

// What stands around a failure function: the worse end of bricks (TRUE_T), factors by the size of shells (LCT, LCS).
namespace nugget::weld::failure {
namespace {

model::WeldLaw surface() {
  model::WeldLaw law;
  law.strength = {model::RateValue{8000.0, {}}, {6000.0, {}}, {6000.0, {}}, {9000.0, {}}, {7000.0, {}}, {7000.0, {}}};
  return law;
}

TEST(WorseEnd, ShearMakesMomentsAtTheEnds) {
  const auto f = worse_end(resultant_surface(surface()), 2.0, false);
  Load load;
  load.resultants.shear_s = 3000.0;
  EXPECT_NEAR((*f)(load).value, 0.25 + std::pow(3000.0 / 7000.0, 2), 1e-12);
  // A moment at mid-length takes away at one end and adds at the other, whatever its sign.
  for (const double moment : {1000.0, -1000.0}) {
    load.resultants.moment_t = moment;
    EXPECT_NEAR((*f)(load).value, 0.25 + std::pow(4000.0 / 7000.0, 2), 1e-12);
  }
  // By the larger moment only: the same where both strengths are.
  EXPECT_NEAR((*worse_end(resultant_surface(surface()), 2.0, true))(load).value, 0.25 + std::pow(4000.0 / 7000.0, 2),
              1e-12);
}

TEST(WorseEnd, MomentAboutSComesFromTheShearAlongT) {
  const auto f = worse_end(resultant_surface(surface()), 2.0, false);
  Load load;
  load.resultants.shear_t = 3000.0;
  load.resultants.moment_s = 500.0;
  EXPECT_NEAR((*f)(load).value, 0.25 + std::pow(3500.0 / 7000.0, 2), 1e-12);
}

TEST(ShellSize, TheWorseEndOfFactorsCounts) {
  const std::array<Geometry::ShellFactor, 2> ends{{{5.0, 2.0, 1.0}, {10.0, 1.0, 4.0}}};
  const auto f = by_shell_size(resultant_surface(surface()), ends);
  Load load;
  load.resultants = {4000.0, 0.0, 0.0, 0.0, 0.0, 3500.0};  // tension and bending: 1/4 each
  EXPECT_NEAR((*f)(load).value, 0.5, 1e-12);
  load.resultants = {0.0, 3000.0, 0.0, 4500.0, 0.0, 0.0};  // shear and torsion
  EXPECT_NEAR((*f)(load).value, 0.5, 1e-12);
  load.resultants = {4000.0, 3000.0, 0.0, 0.0, 0.0, 0.0};
  EXPECT_NEAR((*f)(load).value, std::max(0.125 + 0.25, 0.25 + 0.0625), 1e-12);
}

TEST(ShellSize, FactorsComeFromTheCurvesAtTheShells) {
  test::Assembly a;
  const model::Index fine = a.sheet(1.0, {0, 0, 0}, 6, 6, 5.0), coarse = a.sheet(1.0, {0, 0, 1});
  const model::Index welds = a.beam_part(5.0);
  a.tie({welds}, {fine, coarse});
  a.beam(welds, {14, 14, 0}, {14, 14, 1});
  a.model.curves.push_back({1, {5.0, 10.0}, {1.0, 2.0}});
  a.model.control.weld_beams.tension_curve = 0;
  Findings findings;
  const Ties ties = weld::tie(a.model, findings);
  const auto ends = shell_factors(a.model, ties.welds.at(0));
  EXPECT_NEAR(ends[0].size, 5.0, 1e-12);
  EXPECT_NEAR(ends[1].size, 10.0, 1e-12);
  EXPECT_NEAR(ends[0].tension, 1.0, 1e-12);
  EXPECT_NEAR(ends[1].tension, 2.0, 1e-12);
  EXPECT_EQ(ends[1].shear, 1.0);
}

// A weld that shares a node with the thin sheet and is tied to the thick one: the thin one counts. Sabotage:
// thicknesses of sheets that it is tied to only.
TEST(GeometryOfWelds, AnEndThatIsANodeOfItsSheetHasItsThickness) {
  test::Assembly a;
  const model::Index thin = a.sheet(0.8, {0, 0, 0}), thick = a.sheet(2.0, {0, 0, 1.4});
  const model::Index welds = a.beam_part(5.0);
  a.tie({welds}, {thin, thick});
  a.beam(welds, 5, a.node({10, 10, 1.4}));  // node 6 of the thin sheet, at (10, 10, 0)
  Findings findings;
  const Ties ties = weld::tie(a.model, findings);
  const Geometry g = geometry_of(a.model, ties.welds.at(0));
  EXPECT_EQ(g.sheet[0], thin);
  EXPECT_EQ(g.sheet[1], thick);
  EXPECT_EQ(g.thickness[0], 0.8);
  EXPECT_EQ(g.thickness[1], 2.0);
  EXPECT_EQ(g.thinner(), 0.8);
}

// docs/theory/failure.md#size-of-the-shell. Sabotage to be caught: the angle in radians; the smaller of the coordinates
// for the place.
TEST(ShellSize, FactorsComeFromTheTablesAtThePlaceOnTheShell) {
  test::Assembly a;
  const model::Index fine = a.sheet(1.0, {0, 0, 0}, 6, 6, 5.0), coarse = a.sheet(1.0, {0, 0, 1});
  const model::Index welds = a.beam_part(5.0);
  a.tie({welds}, {fine, coarse});
  a.beam(welds, {14, 13, 0}, {14, 13, 1});  // 1.5 and 0.5 off the centre (12.5, 12.5) of a shell of 5; of one of 10
  model::WeldBeamControl& c = a.model.control.weld_beams;
  c.tension_place = {{7, {0.0, 1.0}, {{1, {0.0, 45.0}, {1.0, 1.0}}, {2, {0.0, 45.0}, {2.0, 3.0}}}}, true};
  Findings findings;
  const Ties ties = weld::tie(a.model, findings);
  const auto ends = shell_factors(a.model, ties.welds.at(0));
  EXPECT_NEAR(ends[0].place, 0.6, 1e-12);
  EXPECT_NEAR(ends[0].angle, std::atan(1.0 / 3.0) * 180.0 / std::numbers::pi, 1e-12);
  EXPECT_NEAR(ends[0].tension, 1.0 + 0.6 * (1.0 + ends[0].angle / 45.0), 1e-12);
  EXPECT_EQ(ends[0].shear, 1.0);
  EXPECT_NEAR(ends[1].place, 0.4, 1e-12);  // (14, 13) is 1 and 2 off (15, 15)
  EXPECT_NEAR(ends[1].angle, std::atan(0.5) * 180.0 / std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace nugget::weld::failure
