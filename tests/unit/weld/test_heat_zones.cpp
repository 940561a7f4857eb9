// SPDX-License-Identifier: Apache-2.0
#include "weld/failure/heat_zones.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "unit/weld/assembly.hpp"

namespace nugget::weld {
namespace {

using model::HeatZone;
using test::Assembly;
using test::text;
using testing::HasSubstr;

Curve line(double x1, double y1) {
  Curve curve;
  curve.x = {0.0, x1};
  curve.y = {0.5, y1};
  return curve;
}

/// Two sheets of 5 x 5 shells of 10 mm, 1 mm apart, a weld beam of 5 mm over the middle of shell 13 of each.
struct Welded : Assembly {
  Index lower = sheet(1.0, {0, 0, 0}, 5, 5), upper = sheet(1.0, {0, 0, 1}, 5, 5), welds = beam_part(5.0);
  Welded() {
    beam(welds, {25, 25, 0}, {25, 25, 1});
    tie({welds}, {lower, upper});
  }
  HeatZone& zone() {
    model.heat_zones.emplace_back().parts = {lower};
    return model.heat_zones.back();
  }
  std::vector<Softening> factors() const {
    Findings findings;
    return softening(model, weld::tie(model, findings));
  }
};

double rounded(double value) {
  return std::round(256.0 * value) / 256.0;
}

// Sabotage to be caught: the distance to the weld's other end or to its middle; diameters for lengths; a part that is
// not in the zone softened.
TEST(HeatZones, FactorsGoByTheDistanceFromTheWeld) {
  Welded a;
  a.zone().yield[HeatZone::beams] = {line(20.0, 1.0), false};
  a.model.heat_zones[0].strain[HeatZone::beams] = {line(4.0, 0.9), true};
  const std::vector<Softening> all = a.factors();
  ASSERT_EQ(all.size(), 50u);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) {
      const double d = std::hypot(10.0 * i + 5.0 - 25.0, 10.0 * j + 5.0 - 25.0);
      EXPECT_EQ(all[5 * j + i].yield, rounded(0.5 + 0.5 * std::min(d / 20.0, 1.0)));
      EXPECT_EQ(all[5 * j + i].strain, rounded(0.5 + 0.4 * std::min(d / 5.0 / 4.0, 1.0)));
      EXPECT_EQ(all[25 + 5 * j + i], Softening{});
    }
  EXPECT_EQ(all[12].yield, 0.5);
}

TEST(HeatZones, CurvesOfOtherWeldsDoNotCount) {
  Welded a;
  a.zone().yield[HeatZone::bricks] = {line(20.0, 1.0), false};
  EXPECT_THAT(a.factors(), testing::Each(Softening{}));
  Findings findings, of_ties;
  const Ties ties = tie(a.model, of_ties);
  note_heat_zones(a.model, ties, findings);
  EXPECT_THAT(text(findings), HasSubstr("warning: *DEFINE_HAZ_PROPERTIES: zone 0 changes no shell"));
  a.model.heat_zones[0].yield[HeatZone::beams] = {line(20.0, 1.0), false};
  Findings told;
  note_heat_zones(a.model, ties, told);
  EXPECT_THAT(text(told), HasSubstr("changes 9 shells; least factor 0.5 on the yield stress, 1 on the strain"));
}

// A line from (20, 0) to (20, 50), of two nodes far apart: distances are from the line, not from its nodes; the nearer
// of weld and seam counts by the smaller factor. Sabotage: the nearest node's distance; the larger factor.
TEST(HeatZones, SeamsAreLines) {
  Welded a;
  a.zone().yield[HeatZone::seam] = {line(20.0, 1.0), false};
  a.model.heat_zones[0].yield[HeatZone::beams] = {line(10.0, 1.0), false};
  a.model.weld_seams.push_back({1, {a.node({20, 0, 0}), a.node({20, 50, 0})}, {}});
  const std::vector<Softening> all = a.factors();
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) {
      const double from_seam = std::abs(10.0 * i + 5.0 - 20.0);
      const double from_weld = std::hypot(10.0 * i + 5.0 - 25.0, 10.0 * j + 5.0 - 25.0);
      const double expected =
          std::min(0.5 + 0.5 * std::min(from_seam / 20.0, 1.0), 0.5 + 0.5 * std::min(from_weld / 10.0, 1.0));
      EXPECT_EQ(all[5 * j + i].yield, rounded(expected));
    }
  a.model.weld_seams[0].parts = {a.upper};
  EXPECT_EQ(a.factors()[11].yield, 1.0);  // 10 from the weld
}

// Node (20, 20) of each of three sheets. Sabotage: the first two sheets of a rigid weld only.
TEST(HeatZones, ARigidWeldHeatsAllItsSheets) {
  Welded a;
  const Index top = a.sheet(1.0, {0, 0, 2}, 5, 5);
  model::RigidWeld weld;
  weld.kind = model::RigidWeld::Kind::generalized;
  weld.nodes = {14, 36 + 14, 72 + 2 + 14};  // the weld beam has nodes of its own before the third sheet
  weld.body = 0;
  a.model.rigid_bodies.emplace_back().nodes = weld.nodes;
  a.model.rigid_welds.push_back(weld);
  ASSERT_EQ(a.model.nodes.x[weld.nodes[2]].z, 2.0);
  ASSERT_EQ(a.model.nodes.x[weld.nodes[2]].x, 20.0);
  a.zone().parts = {a.lower, a.upper, top};
  a.model.heat_zones[0].yield[HeatZone::constrained] = {line(20.0, 1.0), false};
  const std::vector<Softening> all = a.factors();
  for (const std::size_t sheet : {0u, 1u, 2u})
    for (const std::size_t shell : {6u, 7u, 11u, 12u})
      EXPECT_EQ(all[25 * sheet + shell].yield, rounded(0.5 + 0.5 * std::hypot(5.0, 5.0) / 20.0)) << sheet;
}

// Sabotage: the later zone holds in silence.
TEST(HeatZones, APartInTwoZonesIsSaid) {
  Welded a;
  for (const int id : {7, 8}) {
    a.zone().id = id;
    a.model.heat_zones.back().yield[HeatZone::beams] = {line(20.0, 1.0), false};
  }
  Findings findings, of_ties;
  const Ties ties = tie(a.model, of_ties);
  note_heat_zones(a.model, ties, findings);
  EXPECT_THAT(text(findings), HasSubstr("part 1 is of zone 7 already: this one holds for it"));
}

TEST(HeatZones, TheWholeYieldCurveIsScaled) {
  kernel::PiecewiseLinear curves;
  curves.yield.emplace_back();
  curves.yield[0].x = {0.0, 0.1};
  curves.yield[0].y = {300.0, 500.0};
  curves.failure_strain = 0.4;
  const auto soft = std::get<kernel::PiecewiseLinear>(softened(curves, {0.5, 0.25}));
  EXPECT_EQ(soft.yield[0].y, (std::vector{150.0, 250.0}));
  EXPECT_EQ(soft.failure_strain, 0.1);
  // H' = E Et / (E - Et) = 2333.3 halves.
  const kernel::PlasticKinematic bilinear{
      .E = 210000.0, .nu = 0.3, .yield = 300.0, .tangent_modulus = 2307.692307692308};
  const auto half = std::get<kernel::PlasticKinematic>(softened(bilinear, {0.5, 1.0}));
  EXPECT_EQ(half.yield, 150.0);
  EXPECT_NEAR(half.E * half.tangent_modulus / (half.E - half.tangent_modulus), 0.5 * 2333.3333333, 1e-4);
}

}  // namespace
}  // namespace nugget::weld
