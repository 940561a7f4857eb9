// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

Built built(const std::string& more) {
  return Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + more);
}

template <class L>
const L& law(const Built& b) {
  return std::get<L>(b.model.materials.at(0).law);
}

TEST(Materials, Elastic) {
  const auto b = built("*MAT_ELASTIC_TITLE\nsteel\n4,7.85e-9,210000.0,0.3\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Material& m = b.model.materials.at(0);
  EXPECT_EQ(m.id, 4);
  EXPECT_EQ(m.title, "steel");
  EXPECT_DOUBLE_EQ(m.density, 7.85e-9);
  EXPECT_DOUBLE_EQ(m.young(), 210000.0);
  EXPECT_DOUBLE_EQ(m.poisson(), 0.3);
}

TEST(Materials, ValuesOutOfRange) {
  EXPECT_TRUE(built("*MAT_001\n1,-1.0,210000.0,0.3\n").error("expected more than 0", "ro"));
  EXPECT_TRUE(built("*MAT_001\n1,7.85e-9,-2.0,0.3\n").error("expected more than 0", "e"));
  EXPECT_TRUE(built("*MAT_001\n1,7.85e-9,210000.0,0.7\n").error("expected 0 to 0.5", "pr"));
  EXPECT_TRUE(built("*MAT_001\n1,7.85e-9\n").error("must be given", "e"));
  EXPECT_TRUE(built("*MAT_001\n1,7.85e-9,210000.0,0.3\n2,7.85e-9,210000.0,0.3\n")
                  .error("more data lines than this keyword has cards"));
  EXPECT_TRUE(
      built("*MAT_003\n1,7.85e-9,210000.0,0.3,300.0,210000.0\n").error("must be below Young's modulus", "etan"));
}

TEST(Materials, PlasticKinematic) {
  const auto b = built("*MAT_003\n1,7.85e-9,210000.0,0.3,300.0,1000.0,0.5\n40.0,5.0,0.2,1.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& l = law<kernel::PlasticKinematic>(b);
  EXPECT_DOUBLE_EQ(l.yield, 300.0);
  EXPECT_DOUBLE_EQ(l.tangent_modulus, 1000.0);
  EXPECT_DOUBLE_EQ(l.beta, 0.5);
  EXPECT_DOUBLE_EQ(l.rate_c, 40.0);
  EXPECT_DOUBLE_EQ(l.rate_p, 5.0);
  EXPECT_DOUBLE_EQ(l.failure_strain, 0.2);
}

TEST(Materials, HalfARateLawIsWarnedOf) {
  const auto b = built("*MAT_003\n1,7.85e-9,210000.0,0.3,300.0\n40.0\n");
  EXPECT_TRUE(b.warning("needs both constants", "srp")) << b.all_findings();
  EXPECT_DOUBLE_EQ(law<kernel::PlasticKinematic>(b).rate_c, 0.0);
}

TEST(Materials, BilinearHardeningHasThePlasticModulus) {
  const auto b = built("*MAT_024\n1,7.85e-9,210000.0,0.3,300.0,1000.0,0.4,1.0e-8\n40.0,5.0,,,1.0\n\n\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& l = law<kernel::PiecewiseLinear>(b);
  ASSERT_EQ(l.yield.size(), 1u);
  EXPECT_DOUBLE_EQ(l.yield[0].extrapolated(0.0), 300.0);
  EXPECT_NEAR(l.yield[0].slope(5.0), 210000.0 * 1000.0 / 209000.0, 1e-9);
  EXPECT_DOUBLE_EQ(l.failure_strain, 0.4);
  EXPECT_DOUBLE_EQ(l.deletion_step, 1e-8);
  EXPECT_DOUBLE_EQ(l.rate_c, 40.0);
  EXPECT_TRUE(l.rates.empty());
}

TEST(Materials, PointsAndCurvesTakeThePlaceOfSigy) {
  const auto points = built("*MAT_024\n1,7.85e-9,210000.0,0.3,300.0\n\n0.0,0.1,0.3\n310.0,400.0,450.0\n");
  EXPECT_EQ(points.findings.errors(), 0) << points.all_findings();
  EXPECT_THAT(law<kernel::PiecewiseLinear>(points).yield[0].x, ElementsAre(0.0, 0.1, 0.3));
  EXPECT_THAT(law<kernel::PiecewiseLinear>(points).yield[0].y, ElementsAre(310.0, 400.0, 450.0));
  const auto curve = built(
      "*MAT_024\n1,7.85e-9,210000.0,0.3\n,,10,11\n\n\n*DEFINE_CURVE\n10\n0.0,500.0\n1.0,600.0\n"
      "*DEFINE_CURVE\n11\n0.0,1.0\n100.0,1.5\n");
  EXPECT_EQ(curve.findings.errors(), 0) << curve.all_findings();
  EXPECT_THAT(law<kernel::PiecewiseLinear>(curve).yield[0].y, ElementsAre(500.0, 600.0));
  EXPECT_THAT(law<kernel::PiecewiseLinear>(curve).rate_scale.y, ElementsAre(1.0, 1.5));
}

TEST(Materials, TablesOverTheRateAndItsLogarithm) {
  const std::string material = "*MAT_024\n1,7.85e-9,210000.0,0.3\n,,7\n\n\n";
  const std::string curves = "*DEFINE_CURVE\n10\n0.0,300.0\n1.0,400.0\n*DEFINE_CURVE\n11\n0.0,330.0\n1.0,440.0\n";
  const auto plain = built(material + "*DEFINE_TABLE\n7\n0.001\n100.0\n" + curves);
  EXPECT_THAT(law<kernel::PiecewiseLinear>(plain).rates, ElementsAre(0.001, 100.0)) << plain.all_findings();
  EXPECT_FALSE(law<kernel::PiecewiseLinear>(plain).log_rates);
  EXPECT_DOUBLE_EQ(law<kernel::PiecewiseLinear>(plain).yield.at(1).y[1], 440.0);
  const auto logs = built(material + "*DEFINE_TABLE\n7\n-6.9\n4.6\n" + curves);
  EXPECT_TRUE(law<kernel::PiecewiseLinear>(logs).log_rates);
  EXPECT_DOUBLE_EQ(law<kernel::PiecewiseLinear>(logs).rates.at(0), std::exp(-6.9));
}

TEST(Materials, OneRateEffectCounts) {
  const std::string curves = "*DEFINE_CURVE\n5\n0.0,1.0\n100.0,1.5\n*DEFINE_CURVE\n6\n0.0,300.0\n1.0,400.0\n";
  const std::string steel = "*MAT_024\n1,7.85e-9,210000.0,0.3,300.0\n";
  const auto factor = built(steel + "40.0,5.0,,5\n\n\n" + curves);
  EXPECT_TRUE(factor.warning("not obeyed with LCSR", "c")) << factor.all_findings();
  EXPECT_DOUBLE_EQ(law<kernel::PiecewiseLinear>(factor).rate_c, 0.0);
  EXPECT_FALSE(law<kernel::PiecewiseLinear>(factor).rate_scale.empty());
  const auto table = built(steel + "40.0,5.0,9,5\n\n\n" + curves + "*DEFINE_TABLE_2D\n9\n0.0,6\n10.0,6\n");
  EXPECT_TRUE(table.warning("those of the table", "c")) << table.all_findings();
  EXPECT_TRUE(table.warning("those of the table", "lcsr"));
  EXPECT_DOUBLE_EQ(law<kernel::PiecewiseLinear>(table).rate_c, 0.0);
  EXPECT_TRUE(law<kernel::PiecewiseLinear>(table).rate_scale.empty());
}

TEST(Materials, WhateverVpSaysThePlasticRateCounts) {
  const std::string steel = "*MAT_024\n1,7.85e-9,210000.0,0.3,300.0,1000.0\n";
  const auto filtered = built(steel + "40.0,5.0,,,3\n\n\n");
  EXPECT_EQ(filtered.findings.errors(), 0) << filtered.all_findings();
  EXPECT_TRUE(filtered.warning("computed as 0", "vp"));
  EXPECT_DOUBLE_EQ(law<kernel::PiecewiseLinear>(filtered).rate_yield, 0.0);
  EXPECT_DOUBLE_EQ(law<kernel::PiecewiseLinear>(built(steel + "40.0,5.0,,,1\n\n\n")).rate_yield, 300.0);
}

TEST(Materials, FirstYieldOfPointsThatBeginLate) {
  const auto b = built("*MAT_024\n1,7.85e-9,210000.0,0.3\n\n0.01,0.02\n310.0,330.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_NEAR(law<kernel::PiecewiseLinear>(b).yield[0].extrapolated(0.0), 290.0, 1e-9);
}

TEST(Materials, PiecewiseLinearFaults) {
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3\n").error("the yield stress must be given", "sigy"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3\n,,10\n").error("curve or table 10 is not defined", "lcss"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3,300.0\n,,,10\n").error("curve 10 is not defined", "lcsr"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3,300.0\n,,,,2.0\n").error("expected -1, 0, 1, 3 or 4", "vp"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3\n\n0.0,0.1\n300.0,0.0\n").error("not above 0", "es1"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3,300.0,,-1.0\n").error("expected 0 or more", "fail"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3\n\n0.0,0.2,0.1\n310.0,400.0,450.0\n")
                  .error("plastic strains must ascend"));
  EXPECT_TRUE(built("*MAT_024\n1,7.85e-9,210000.0,0.3\n,,10\n\n\n*DEFINE_CURVE\n10\n0.0,0.0\n1.0,600.0\n")
                  .error("not above 0", "lcss"));
  EXPECT_TRUE(built("*MAT_024_STOCHASTIC\n1,7.85e-9,210000.0,0.3,300.0\n")
                  .error("this form of *MAT_PIECEWISE_LINEAR_PLASTICITY"));
}

TEST(Materials, RefusedLawsNameTheNearestOne) {
  EXPECT_TRUE(built("*MAT_HILL_90\n1\n").error("*MAT_3-PARAMETER_BARLAT comes nearest"));
  EXPECT_TRUE(
      built("*MAT_ELASTIC_PLASTIC_HYDRO\n1\n").error("this material, or this form of *MAT_ELASTIC, is not built"));
  const auto skipped = Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_243\n1\n", true);
  EXPECT_TRUE(skipped.warning("the cards are left out")) << skipped.all_findings();
}

// ---- sections and hourglass

TEST(Sections, LayersOfTheUser) {
  const auto b = built(
      "*SECTION_SHELL\n3,2,0.833,5,,-7\n1.0\n4,2,0.833,2,,-8\n1.0\n*INTEGRATION_SHELL\n7,3\n0.8,0.3\n-0.8,0.3\n0.0,0."
      "4\n"
      "8,2,1\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  using Layer = std::array<double, 2>;
  EXPECT_THAT(b.model.shell_sections[0].rule, testing::ElementsAre(Layer{-0.8, 0.3}, Layer{0.0, 0.4}, Layer{0.8, 0.3}));
  EXPECT_EQ(b.model.shell_sections[0].layers, 3);
  EXPECT_TRUE(b.warning("there are 3 layers, as rule 7", "nip"));
  EXPECT_THAT(b.model.shell_sections[1].rule, testing::ElementsAre(Layer{-0.5, 0.5}, Layer{0.5, 0.5}));
  EXPECT_TRUE(built("*SECTION_SHELL\n3,2,,2,,-7\n1.0\n").error("rule 7 is not defined", "qr_irid"));
  EXPECT_TRUE(built("*INTEGRATION_SHELL\n7,2\n0.0,0.6\n1.0,0.6\n").warning("shares sum up to 1.2", "irid"));
  EXPECT_TRUE(built("*INTEGRATION_SHELL\n7,1\n1.5,1.0\n").error("expected -1 to 1", "s"));
}

TEST(Sections, Shell) {
  const auto b = built("*SECTION_SHELL_TITLE\ns\n3,2,0.833,5,,1\n1.0,3.0,,,-1.0,2.0e-9\nt\n4,2\n2.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(b.model.shell_sections.size(), 2u);
  const SectionShell& s = b.model.shell_sections[0];
  EXPECT_DOUBLE_EQ(s.shear_factor, 0.833);
  EXPECT_EQ(s.layers, 5);
  EXPECT_TRUE(s.trapezoidal);
  EXPECT_DOUBLE_EQ(s.thickness, 1.5);
  EXPECT_DOUBLE_EQ(s.nloc, -1.0);
  EXPECT_DOUBLE_EQ(s.extra_mass, 2e-9);
  EXPECT_EQ(b.model.shell_sections[1].layers, 2);
  EXPECT_DOUBLE_EQ(b.model.shell_sections[1].shear_factor, 1.0);
  EXPECT_TRUE(built("*SECTION_SHELL\n3,2,,11\n1.0\n").error("expected 1 to 10", "nip"));
  EXPECT_TRUE(built("*SECTION_SHELL\n3,9,,4,,,1\n1.0\n0,0,45\n").error("a membrane has one layer", "b3"));
}

TEST(Sections, WeldBeam) {
  const auto b = built("*SECTION_BEAM\n3,9,,,1\n6.0,,1.0,,1,,1\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const SectionBeam& s = b.model.beam_sections.at(0);
  EXPECT_THAT(s.outer, ElementsAre(6.0, 6.0));
  EXPECT_THAT(s.inner, ElementsAre(1.0, 1.0));
  EXPECT_FALSE(s.in_swforc);
  EXPECT_FALSE(s.torsion);
  EXPECT_TRUE(built("*SECTION_BEAM\n3,9,,,1\n\n").error("a spot weld needs its diameter", "ts1"));
  EXPECT_TRUE(built("*SECTION_BEAM\n3,9,,,1\n6.0,6.0,7.0\n").error("the inner diameter must be smaller", "tt1"));
  EXPECT_TRUE(built("*SECTION_BEAM\n3,9\n6.0\n").warning("TS and TT are taken as diameters", "cst"));
  EXPECT_TRUE(built("*SECTION_BEAM\n3,9,,-7,1\n6.0\n").error("integration rules of the user", "qr_irid"));
  EXPECT_TRUE(built("*SECTION_BEAM\n3,9,,1,1\n6.0\n").warning("a weld gets four", "qr_irid"));
}

TEST(Sections, Hourglass) {
  const auto b = built("*HOURGLASS\n3,5,0.05,,1.2,0.07,0.08\n");
  const Hourglass& h = b.model.hourglass.at(0);
  EXPECT_EQ(h.type, 5);
  EXPECT_DOUBLE_EQ(h.membrane, 0.05);
  EXPECT_DOUBLE_EQ(h.bending, 0.08);
  EXPECT_DOUBLE_EQ(h.warping, 0.05);
  EXPECT_DOUBLE_EQ(h.bulk_quadratic, 1.2);
  EXPECT_DOUBLE_EQ(h.bulk_linear, 0.07);
}

// ---- control cards

TEST(Controls, WhatIsObeyed) {
  const auto b = built(
      "*CONTROL_TERMINATION\n0.12,500,0.01,5.0,3.0\n*CONTROL_TIMESTEP\n1.0e-7,0.67,2,,-1.0e-6,4,,1\n"
      "*DEFINE_CURVE\n4\n0.0,1.0\n1.0,1.0\n*CONTROL_SHELL\n25.0,1,,1,2,1\n1.0,1\n*CONTROL_BULK_VISCOSITY\n1.4,0.05,-2\n"
      "*CONTROL_HOURGLASS\n4,0.03\n*CONTROL_ENERGY\n2,1,2,2\n*CONTROL_OUTPUT\n1,,,0\n*CONTROL_CONTACT\n0.2\n,,,,,,,"
      "1\n\n"
      "2,,,1,2\n*TITLE\na car\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  // BWC = 1 is obeyed in part; the first lines of the deck have an end time, too.
  EXPECT_EQ(b.findings.warnings(), 2) << b.all_findings();
  EXPECT_NE(b.find(Severity::warning, "stands a second time"), nullptr);
  EXPECT_NE(b.find(Severity::warning, "the transverse shear stays the one-point form", "bwc"), nullptr);
  const Control& c = b.model.control;
  EXPECT_DOUBLE_EQ(c.end_time, 0.12);
  EXPECT_EQ(c.end_cycle, 500);
  EXPECT_DOUBLE_EQ(c.smallest_step, 0.01);
  EXPECT_DOUBLE_EQ(c.energy_limit, 5.0);
  EXPECT_DOUBLE_EQ(c.added_mass_limit, 3.0);
  EXPECT_DOUBLE_EQ(c.first_step, 1e-7);
  EXPECT_DOUBLE_EQ(c.step_scale, 0.67);
  EXPECT_EQ(c.length_basis, 2);
  EXPECT_DOUBLE_EQ(c.mass_step, -1e-6);
  EXPECT_EQ(c.step_curve, 0);
  EXPECT_TRUE(c.mass_scaling_at_start_only);
  EXPECT_DOUBLE_EQ(c.warp_warning, 25.0);
  EXPECT_EQ(c.sort_triangles, SortTriangles::c0);
  EXPECT_EQ(c.thickness_update, 1);
  EXPECT_TRUE(c.warping_stiffness);
  EXPECT_TRUE(c.lobatto);
  EXPECT_EQ(c.bulk_viscosity_type, -2);
  EXPECT_EQ(c.hourglass.type, 4);
  EXPECT_DOUBLE_EQ(c.hourglass.bending, 0.03);
  EXPECT_DOUBLE_EQ(c.hourglass.bulk_quadratic, 1.4);
  EXPECT_TRUE(c.hourglass_energy);
  EXPECT_DOUBLE_EQ(c.penalty_scale, 0.2);
  EXPECT_TRUE(c.keep_tied_gap);
  EXPECT_EQ(c.ignore_penetration, 2);
  EXPECT_TRUE(c.list_ties);
  EXPECT_EQ(c.untied_weld, 2);
  EXPECT_EQ(b.model.title, "a car");
}

TEST(Controls, DefaultsOfLsDyna) {
  const auto b = built("*CONTROL_TIMESTEP\n\n*CONTROL_SHELL\n\n*CONTROL_CONTACT\n\n*CONTROL_ENERGY\n\n");
  EXPECT_EQ(b.findings.errors() + b.findings.warnings(), 0) << b.all_findings();
  const Control& c = b.model.control;
  EXPECT_DOUBLE_EQ(c.step_scale, 0.9);
  EXPECT_DOUBLE_EQ(c.warp_warning, 20.0);
  EXPECT_FALSE(c.warping_stiffness);
  EXPECT_EQ(c.thickness_update, 0);
  EXPECT_DOUBLE_EQ(c.penalty_scale, 0.1);
  EXPECT_FALSE(c.hourglass_energy);
  EXPECT_DOUBLE_EQ(c.added_mass_limit, 1e8);
}

TEST(Controls, WhatCannotBeObeyed) {
  const auto b = built(
      "*CONTROL_TIMESTEP\n\n,,1\n0.5\n*CONTROL_SHELL\n,3,,5\n0.5\n*CONTROL_CONTACT\n0.1,,,,2\n\n\n,,,,,1,0.5\n\n,,,,,,"
      "0.5\n*"
      "CONTROL_OUTPUT\n1,,,1\n*CONTROL_SHELL\n\n\n\n,,,1\n");
  EXPECT_TRUE(b.error("only 0 is supported (selective mass scaling)", "imscl")) << b.all_findings();
  EXPECT_TRUE(b.error("expected 0 to 2", "esort"));
  EXPECT_TRUE(b.error("expected 0 to 4", "istupd"));
  EXPECT_TRUE(b.error("only 1 is supported", "rotascl"));
  for (const auto* field : {"rmavg", "penopt", "shltrw", "keepcs"})
    EXPECT_TRUE(b.warning("not obeyed", field)) << field << '\n' << b.all_findings();
}

TEST(Controls, SecondOrderStress) {
  EXPECT_FALSE(built("*CONTROL_ACCURACY\n0,1\n").model.control.second_order_stress);
  const auto b = built("*CONTROL_ACCURACY\n1,2\n");
  EXPECT_TRUE(b.model.control.second_order_stress);
  EXPECT_TRUE(b.model.control.invariant_shell_axes);
}

TEST(Controls, UnitsRemarkIsIgnored) {
  const auto b = built("*CONTROL_UNITS\nmm,s,ton\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.keyword_uses.back().status, KeywordStatus::ignored);
}

}  // namespace
}  // namespace nugget::reading
