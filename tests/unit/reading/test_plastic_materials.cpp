// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "deck/deck.hpp"
#include "law_decks.hpp"

namespace nugget::reading {
namespace {

TEST(PlasticMaterials, SimplifiedJohnsonCook) {
  const auto b = built("*MAT_098_TITLE\nsteel\n4,7.85e-9,210000.0,0.3,1.0\n300.0,500.0,0.3,0.05,0.4,700.0,900.0,0.1\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.materials.at(0).title, "steel");
  EXPECT_DOUBLE_EQ(b.model.materials.at(0).young(), 210000.0);
  EXPECT_DOUBLE_EQ(b.model.materials.at(0).poisson(), 0.3);
  const auto& law = flow<kernel::JohnsonCook>(b);
  EXPECT_DOUBLE_EQ(law.yield, 300.0);
  EXPECT_DOUBLE_EQ(law.hardening, 500.0);
  EXPECT_DOUBLE_EQ(law.exponent, 0.3);
  EXPECT_DOUBLE_EQ(law.rate_factor, 0.05);
  EXPECT_DOUBLE_EQ(law.static_stress_limit, 700.0);
  EXPECT_DOUBLE_EQ(law.saturation, 900.0);
  EXPECT_DOUBLE_EQ(law.reference_rate, 0.1);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain, 0.4);
}

TEST(PlasticMaterials, SimplifiedJohnsonCookZerosAreDefaults) {
  const auto b = built("*MAT_SIMPLIFIED_JOHNSON_COOK\n4,7.85e-9,210000.0,0.3\n300.0,500.0,0.3,0.0,0.0,0.0,0.0,0.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_GT(flow<kernel::JohnsonCook>(b).static_stress_limit, 1e20);
  EXPECT_GT(flow<kernel::JohnsonCook>(b).saturation, 1e20);
  EXPECT_DOUBLE_EQ(flow<kernel::JohnsonCook>(b).reference_rate, 1.0);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain, 0.0);
  EXPECT_TRUE(built("*MAT_098\n4,7.85e-9,210000.0,0.3\n,500.0\n").error("must be given", "a"));
  EXPECT_TRUE(built("*MAT_098\n4,7.85e-9,210000.0,0.3,2.0\n300.0\n").error("expected 0 to 1", "vp"));
}

constexpr const char* johnson_cook_yield = "792.0,510.0,0.26,0.014,1.03,1793.0,293.0,1.0\n";

/// Bricks of material 4.
const std::string brick =
    "*SECTION_SOLID\n1,1\n*PART\np\n1,1,4\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n"
    "8,0,1,1\n*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n";

TEST(PlasticMaterials, JohnsonCook) {
  const auto b = built(std::string("*MAT_015\n4,7.85e-9,80000.0,210000.0,0.3,1e-7\n") + johnson_cook_yield +
                       "4.77e8,-1e9,2.0,0.0,0.05,3.44,-2.12,0.002\n0.61,,,1e-4,2\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::JohnsonCook>(b);
  EXPECT_DOUBLE_EQ(law.yield, 792.0);
  EXPECT_DOUBLE_EQ(law.heating, 1.0 / (7.85e-9 * 4.77e8));
  EXPECT_DOUBLE_EQ(law.melting_rise, 1500.0);
  EXPECT_DOUBLE_EQ(law.softening, 1.03);
  EXPECT_DOUBLE_EQ(std::get<kernel::JohnsonCookFracture>(composition(b).rules.at(0)).d3, -2.12);
  EXPECT_DOUBLE_EQ(std::get<kernel::JohnsonCookFracture>(composition(b).rules.at(0)).d5, 0.61);
  EXPECT_DOUBLE_EQ(std::get<kernel::JohnsonCookFracture>(composition(b).rules.at(0)).least, 1e-4);
  EXPECT_DOUBLE_EQ(composition(b).points_to_delete, 2.0);
  EXPECT_DOUBLE_EQ(composition(b).deletion_step, 1e-7);
  const auto cold = built(std::string("*MAT_JOHNSON_COOK\n4,7.85e-9,80000.0,210000.0,0.3\n") + johnson_cook_yield);
  EXPECT_EQ(cold.findings.errors(), 0) << cold.all_findings();
  EXPECT_TRUE(composition(cold).rules.empty());
  EXPECT_DOUBLE_EQ(flow<kernel::JohnsonCook>(cold).heating, 0.0);
}

TEST(PlasticMaterials, JohnsonCookFaults) {
  const std::string main = "*MAT_015\n4,7.85e-9,80000.0,210000.0,0.3\n";
  EXPECT_TRUE(built(main + "792.0,510.0,0.26,0.014,1.03,,,1.0\n4.77e8\n").error("melting must lie above", "tm"));
  EXPECT_TRUE(built(main + "792.0,510.0,0.26,0.014,,1793.0,293.0,1.0\n4.77e8\n").error("exponent M", "m"));
  EXPECT_TRUE(built(main + johnson_cook_yield + "\n,,1.0\n").error("only 0 is supported", "erod"));
  EXPECT_TRUE(built(main + johnson_cook_yield + ",,,,0.05,3.44,2.12\n").warning("grows with tension", "d3"));
  EXPECT_TRUE(built("*MAT_015\n4,7.85e-9,80000.0,210000.0,0.3,,,1.0\n792.0\n").error("only 0 is supported", "rateop"));
  EXPECT_TRUE(built(main + johnson_cook_yield + brick).warning("which LS-DYNA demands", "eosid"));
  EXPECT_TRUE(
      built(std::string("*MAT_015\n4,7.85e-9,80000.0\n") + johnson_cook_yield + brick).error("needs E and PR", "mid"));
}

/// A brick of *MAT_015 without E, with the equation of state of an id.
std::string block(int eosid) {
  std::string text = brick;
  text.replace(text.find("1,1,4"), 5, "1,1,4," + std::to_string(eosid));
  return std::string("*MAT_015\n4,8.93e-9,43333.3333333333\n") + johnson_cook_yield + ",-300.0,3.0\n\n" + text;
}

TEST(PlasticMaterials, EquationOfState) {
  const auto b = built(block(7) + "*EOS_LINEAR_POLYNOMIAL_TITLE\ncopper\n7,,130000.0,2.0,3.0,0.4,0.5,0.6\n8.0,\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_TRUE(composition(b).state);
  EXPECT_DOUBLE_EQ(composition(b).state->start_energy, 8.0);
  EXPECT_DOUBLE_EQ(composition(b).state->start_volume, 1.0);
  const auto& p = std::get<kernel::LinearPolynomial>(composition(b).state->pressure);
  EXPECT_DOUBLE_EQ(p.c1, 130000.0);
  EXPECT_DOUBLE_EQ(p.c6, 0.6);
  EXPECT_EQ(composition(b).spall->form, kernel::Spall::Form::mean_stress);
  EXPECT_DOUBLE_EQ(composition(b).spall->limit, 300.0);
  const auto g = built(block(7) + "*EOS_GRUNEISEN\n7,3.94e6,1.49,0.0,0.0,1.96\n");
  EXPECT_EQ(g.findings.errors(), 0) << g.all_findings();
  EXPECT_DOUBLE_EQ(std::get<kernel::Gruneisen>(composition(g).state->pressure).stiffness, 8.93e-9 * 3.94e6 * 3.94e6);
  // K = 130000 and G = 43333 are E = 117000 and nu = 0.35.
  const auto exact = built(block(7) + "*EOS_LINEAR_POLYNOMIAL\n7,,130000.0\n");
  EXPECT_NEAR(exact.model.materials.at(0).young(), 117000.0, 1e-6);
  EXPECT_NEAR(exact.model.materials.at(0).poisson(), 0.35, 1e-12);
}

TEST(PlasticMaterials, EquationOfStateFaults) {
  const std::string polynomial = "*EOS_LINEAR_POLYNOMIAL\n7,,130000.0\n";
  EXPECT_TRUE(built(block(8) + polynomial).error("is not defined", "eosid"));
  EXPECT_TRUE(built(block(7) + "*EOS_LINEAR_POLYNOMIAL\n7,1.0\n").error("no bulk modulus", "eosid"));
  EXPECT_TRUE(built(block(7) + "*EOS_GRUNEISEN\n7,-1.0\n").error("", "c"));
  EXPECT_TRUE(built(block(7) + "*EOS_GRUNEISEN\n7,3.94e6\n1.0,,3\n").error("", "lcid"));
  EXPECT_TRUE(built(block(7) + "*EOS_JWL\n7\n").error("is not built"));
  std::string no_shear = block(7) + polynomial;
  no_shear.replace(no_shear.find("43333.3333333333"), 16, "0.0");
  EXPECT_TRUE(built(no_shear).error("has no shear modulus", "mid"));
  std::string other = block(7) + polynomial;
  other.replace(other.find("*MAT_015\n4,8.93e-9,"), 20, "*MAT_098\n4,8.93e-9,");
  EXPECT_TRUE(built(other).warning("ignored", "eosid")) << built(other).all_findings();
}

TEST(PlasticMaterials, IsotropicElasticPlastic) {
  const auto b = built("*MAT_012\n4,7.85e-9,80000.0,300.0,1000.0,175000.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = std::get<kernel::PiecewiseLinear>(b.model.materials.at(0).law);
  EXPECT_NEAR(law.E / (2.0 * (1.0 + law.nu)), 80000.0, 1e-6);
  EXPECT_NEAR(law.E / (3.0 * (1.0 - 2.0 * law.nu)), 175000.0, 1e-6);
  EXPECT_DOUBLE_EQ(law.yield.at(0).extrapolated(0.5), 800.0);
  EXPECT_TRUE(built("*MAT_012\n4,7.85e-9,80000.0,300.0,,10000.0\n").error("negative Poisson", "bulk"));
}

TEST(SoftMaterials, DecayInTheUnitsOfTheModel) {
  for (const std::string fo : {"0", "1"}) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "kelvin_units";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "foam.k") << "*KEYWORD\n*MAT_061\n4,1.2e-9,2000.0,50.0,10.0,8.0," << fo << "\n*END\n";
    std::ofstream(folder / "model.k")
        << "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*INCLUDE_TRANSFORM\nfoam.k\n\n\n1.0,1000.0,1.0\n\n*END\n";
    Findings findings;
    const deck::Deck deck = deck::read(folder / "model.k", findings);
    const model::Model model = reading::build(deck, findings, false);
    ASSERT_EQ(findings.errors(), 0);
    const auto& law = std::get<kernel::ComposedLaw>(model.materials.at(0).law);
    EXPECT_NEAR(std::get<kernel::Viscoelastic>(law.components->flow).decay, fo == "0" ? 8.0e-3 : 1.0 / 8.0e3, 1e-15);
  }
}

TEST(PlasticMaterials, PowerLaw) {
  const std::string main = "*MAT_018\n4,7.85e-9,210000.0,0.3,600.0,0.2,40.4,5.0\n";
  const auto b = built(main + ",1.0,0.3\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::PowerLaw>(b);
  EXPECT_NEAR(210000.0 * law.yield_strain, 600.0 * std::pow(law.yield_strain, 0.2), 1e-6);
  EXPECT_DOUBLE_EQ(law.rate_c, 40.4);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain, 0.3);
  const double at_stress = flow<kernel::PowerLaw>(built(main + "250.0\n")).yield_strain;
  EXPECT_NEAR(600.0 * std::pow(at_stress, 0.2), 250.0, 1e-6);
  EXPECT_DOUBLE_EQ(flow<kernel::PowerLaw>(built(main + "0.002\n")).yield_strain, 0.002);
  EXPECT_TRUE(built("*MAT_018\n4,7.85e-9,210000.0,0.3,600.0,1.0\n").error("does not meet", "n"));
}

TEST(PlasticMaterials, Viscoplastic) {
  const std::string main = "*MAT_103_TITLE\nalloy\n4,2.7e-9,70000.0,0.33,200.0\n", hardening = "120.,40.,80.,3.\n";
  const auto b = built(main + hardening + "15.,.2\n0.,.3,2\n\n\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.materials.at(0).title, "alloy");
  const auto& law = flow<kernel::Viscoplastic>(b);
  EXPECT_DOUBLE_EQ(law.yield, 200.0);
  EXPECT_DOUBLE_EQ(law.hardening_1, 120.0);
  EXPECT_DOUBLE_EQ(law.exponent_1, 40.0);
  EXPECT_DOUBLE_EQ(law.hardening_2, 80.0);
  EXPECT_DOUBLE_EQ(law.exponent_2, 3.0);
  EXPECT_DOUBLE_EQ(law.viscosity, 15.0);
  EXPECT_DOUBLE_EQ(law.rate_exponent, 0.2);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain, 0.3);
  EXPECT_DOUBLE_EQ(composition(b).points_to_delete, 2.0);
}

const std::string viscoplastic_shell =
    "*SECTION_SHELL\n1,2\n1.\n*PART\np\n1,1,4\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n"
    "*ELEMENT_SHELL\n1,1,1,2,3,4\n";

TEST(PlasticMaterials, ViscoplasticThatIsNotBuilt) {
  const std::string main = "*MAT_103\n4,2.7e-9,70000.0,0.33,200.0\n", hardening = "120.,40.,80.,3.\n";
  EXPECT_TRUE(built("*MAT_103\n4,2.7e-9,70000.0,0.33,200.0,3,5\n\n\n\n\n\n").error("no FLAG 3", "flag"));
  EXPECT_TRUE(built("*MAT_103\n4,2.7e-9,70000.0,0.33,200.0,1\n\n\n\n\n\n").error("FLAG 1 needs a curve", "lcss"));
  EXPECT_TRUE(built("*MAT_103\n4,2.7e-9,70000.0,0.33\n\n\n\n\n\n").error("must be above 0", "sigy"));
  EXPECT_TRUE(built(main + hardening + "15.\n\n\n\n").error("VM must be above 0", "vm"));
  EXPECT_TRUE(built(main + "-150.,40.,-80.,3.\n\n\n\n\n").error("take all of it away", "sigy"));
  // Ratios of a shell are no constants of a brick.
  EXPECT_EQ(built(main + hardening + ",,.5,.5,.5,1.5,1.5,1.5\n\n\n\n" + brick).findings.errors(), 0);
  EXPECT_TRUE(built(main + hardening + ",,1.,1.,1.\n\n\n\n" + brick).error("ratios of shells", "r00_f"));
  EXPECT_EQ(built(main + hardening + ",,1.,1.,1.\n\n\n\n" + viscoplastic_shell).findings.errors(), 0);
  EXPECT_TRUE(built(main + hardening + ",,-.2,.3,-.3,1.,1.,1.\n\n\n\n" + brick).error("no effective stress", "r00_f"));
  EXPECT_TRUE(built(main + hardening + ",,-.2,.3,1.\n\n\n\n" + viscoplastic_shell).error("are above 0", "r00_f"));
  EXPECT_TRUE(built(main + hardening + ",,.8,.9,1.1\n0.,,,3\n\n\n" + viscoplastic_shell).error("exchange", "macf"));
  const std::string table =
      "*DEFINE_TABLE\n5\n1.\n100.\n*DEFINE_CURVE\n6\n0.,200.\n.1,300.\n1.,350.\n*DEFINE_CURVE\n7\n0.,250.\n.1,340.\n1.,"
      "400.\n";
  const auto flagged = [&](const std::string& flag, const std::string& elements) {
    return built("*MAT_103\n4,2.7e-9,70000.0,0.33,," + flag + "\n\n\n\n\n\n" + table + elements);
  };
  EXPECT_TRUE(flagged("4,5", viscoplastic_shell).error("made for bricks", "flag"));
  EXPECT_TRUE(flagged("2,5", brick).error("with a table is not built", "lcss"));
  const auto by_table = flagged("4,5", brick);
  EXPECT_EQ(by_table.findings.errors(), 0) << by_table.all_findings();
  EXPECT_EQ(flow<kernel::PiecewiseLinear>(by_table).rates, (std::vector<double>{1.0, 100.0}));
}

TEST(PlasticMaterials, ViscoplasticThatIsAnisotropic) {
  const std::string main = "*MAT_103\n4,2.7e-9,70000.0,0.33,200.0\n", hardening = "120.,40.,80.,3.,50.,30.,20.,5.\n";
  const auto b = built(main + hardening + "15.,.2,.8,.9,1.1\n2.,.3\n,,,0.,1.,0.\n\n" + viscoplastic_shell);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& hill = flow<kernel::Viscoplastic>(b).anisotropy.value();
  EXPECT_EQ(hill.ratios, (std::array<double, 3>{.8, .9, 1.1}));
  EXPECT_EQ(hill.back_stress, (std::array<double, 2>{50.0, 20.0}));
  EXPECT_EQ(hill.back_exponent, (std::array<double, 2>{30.0, 5.0}));
  EXPECT_EQ(hill.axes.by, kernel::MaterialAxes::By::vectors);
  EXPECT_DOUBLE_EQ(hill.axes.a.y, 1.0);
  // A blank constant is that of the isotropic brick.
  const auto solid = built(main + hardening + ",,.3,,.7\n\n\n\n" + brick);
  EXPECT_EQ(solid.findings.errors(), 0) << solid.all_findings();
  EXPECT_EQ(flow<kernel::Viscoplastic>(solid).anisotropy.value().constants,
            (std::array<double, 6>{.3, .5, .7, 1.5, 1.5, 1.5}));
  EXPECT_FALSE(flow<kernel::Viscoplastic>(built(main + "120.,40.\n\n\n\n\n" + brick)).anisotropy.has_value());
  // Of a curve its own values, with VK; fitted, a share of both terms.
  std::string curve = "*DEFINE_CURVE\n6\n";
  for (int i = 0; i <= 20; ++i)
    curve += fmt::format("{},{}\n", 0.04 * i, 310.0 - 80.0 * std::exp(-25.0 * 0.04 * i) - 30.0 * std::exp(-0.08 * i));
  const auto flagged = [&](const std::string& flag, const std::string& shape) {
    return built("*MAT_103\n4,2.7e-9,70000.0,0.33,," + flag + "\n\n15.,.2" + shape + "\n\n\n\n" + curve + brick);
  };
  const auto direct = flagged("2,6", ",.3,.5,.7");
  EXPECT_EQ(direct.findings.errors(), 0) << direct.all_findings();
  const auto& curves = flow<kernel::Viscoplastic>(direct).anisotropy.value().curves.value();
  EXPECT_DOUBLE_EQ(curves.rate_yield, 15.0);
  EXPECT_DOUBLE_EQ(curves.rate_p, 5.0);
  EXPECT_EQ(curves.yield.at(0).id, 6);
  EXPECT_DOUBLE_EQ(flow<kernel::PiecewiseLinear>(flagged("2,6", "")).rate_yield, 15.0);
  const auto fitted = flagged("1,6,.25", "");
  EXPECT_EQ(fitted.findings.errors(), 0) << fitted.all_findings();
  const auto& law = flow<kernel::Viscoplastic>(fitted);
  EXPECT_NEAR(law.yield, 200.0, 1e-9);
  EXPECT_NEAR(law.hardening_1, 0.25 * 30.0, 1e-3);
  EXPECT_NEAR(law.exponent_1, 2.0, 1e-3);
  EXPECT_NEAR(law.hardening_2, 0.25 * 80.0, 1e-3);
  EXPECT_NEAR(law.exponent_2, 25.0, 1e-3);
  EXPECT_NEAR(law.anisotropy.value().back_stress[1], 0.75 * 80.0, 1e-3);
  EXPECT_NEAR(law.anisotropy.value().back_exponent[0], 2.0, 1e-3);
}

TEST(PlasticMaterials, RateDependent) {
  const std::string curves =
      "*DEFINE_CURVE\n1\n0.0,250.0\n100.0,400.0\n*DEFINE_CURVE\n2\n0.0,1000.0\n100.0,2000.0\n"
      "*DEFINE_CURVE\n3\n0.0,0.2\n100.0,0.1\n";
  const auto b = built("*MAT_019\n4,7.85e-9,210000.0,0.3,1.0\n1,,,2,3,1e-8\n" + curves);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::PiecewiseLinear>(b);
  EXPECT_EQ(law.rates, (std::vector<double>{0.0, 100.0}));
  EXPECT_DOUBLE_EQ(law.yield[0].y[0], 250.0);
  EXPECT_DOUBLE_EQ(law.yield[1].y[0], 400.0);
  EXPECT_DOUBLE_EQ(law.yield[1].y[1] - law.yield[1].y[0], 210000.0 * 2000.0 / 208000.0);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain_over_rate.y[1], 0.1);
  EXPECT_DOUBLE_EQ(composition(b).deletion_step, 1e-8);
  EXPECT_TRUE(built("*MAT_019\n4,7.85e-9,210000.0,0.3\n7\n").error("curve 7 is not defined", "lc1"));
  EXPECT_TRUE(built("*MAT_019\n4,7.85e-9,210000.0,0.3\n1,,2\n" + curves).error("only 0 is supported", "lc2"));
  EXPECT_TRUE(built("*MAT_019\n4,7.85e-9,210000.0,0.3\n1,,,,,,2.0\n" + curves).error("only 1 is supported", "rdef"));
}

TEST(PlasticMaterials, Damage) {
  const std::string main = "*MAT_081\n4,7.85e-9,210000.0,0.3,300.0,1000.0,0.1,1e-8\n";
  const auto b = built(main + "40.0,5.0,,,0.3,,,2\n\n\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(composition(b).damage->onset, 0.1);
  EXPECT_DOUBLE_EQ(composition(b).damage->rupture, 0.3);
  EXPECT_DOUBLE_EQ(composition(b).points_to_delete, 2.0);
  EXPECT_DOUBLE_EQ(composition(b).deletion_step, 1e-8);
  EXPECT_DOUBLE_EQ(flow<kernel::PiecewiseLinear>(b).rate_c, 40.0);
  const auto curve = built(main + ",,,,,,5\n\n\n*DEFINE_CURVE\n5\n0.0,0.0\n0.1,1.0\n");
  EXPECT_EQ(curve.findings.errors(), 0) << curve.all_findings();
  EXPECT_DOUBLE_EQ(composition(curve).damage->growth.y[1], 1.0);
  EXPECT_TRUE(built(main + ",,,,0.3,,5\n\n\n*DEFINE_CURVE\n5\n0.0,0.0\n0.1,1.0\n").error("together with EPPFR"));
  EXPECT_TRUE(built(main + ",,,,0.05\n\n\n").error("after the onset", "eppfr"));
  EXPECT_TRUE(built(main + "\n\n\n").warning("nothing is damaged", "eppf"));
}

TEST(PlasticMaterials, DamageByDirection) {
  const std::string main = "*MAT_082\n4,7.85e-9,210000.0,0.3,300.0,1000.0,0.1\n,,,,0.3,,,2\n\n\n";
  const auto b = built(main);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_FALSE(composition(b).damage);
  EXPECT_DOUBLE_EQ(composition(b).directional_damage->onset, 0.1);
  EXPECT_DOUBLE_EQ(composition(b).directional_damage->rupture, 0.3);
  EXPECT_TRUE(built(main + brick).error("layers of shells", "mid"));
  const auto c = built("*MAT_099\n4,7.85e-9,210000.0,0.3,1.0,0.4,,3\n300.0,500.0,0.3,0.01,0.1,,,2.0\n");
  EXPECT_EQ(c.findings.errors(), 0) << c.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::JohnsonCook>(c).reference_rate, 2.0);
  EXPECT_DOUBLE_EQ(composition(c).failure_strain, 0.0);
  EXPECT_DOUBLE_EQ(composition(c).directional_damage->onset, 0.1);
  EXPECT_DOUBLE_EQ(composition(c).directional_damage->rupture, 0.4);
  EXPECT_DOUBLE_EQ(composition(c).points_to_delete, 3.0);
  EXPECT_TRUE(built("*MAT_PLASTICITY_WITH_DAMAGE_ORTHO_RCDC\n4\n").error("Wilkins"));
}

TEST(PlasticMaterials, StrainLimits) {
  const auto b = built("*MAT_123\n4,7.85e-9,210000.0,0.3,300.0,1000.0,0.4,1e-8\n,,,,,0.2,0.35,-50.0\n\n\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(composition(b).failure_strain, 0.4);
  EXPECT_DOUBLE_EQ(composition(b).limits.plastic_thinning, 0.2);
  EXPECT_DOUBLE_EQ(composition(b).limits.major, 0.35);
  EXPECT_DOUBLE_EQ(composition(b).points_to_delete, -50.0);
  EXPECT_TRUE(built("*MAT_123\n4,7.85e-9,210000.0,0.3,300.0\n,,,,,,-0.35\n").error("expected 0 or more", "epsmaj"));
}

TEST(PlasticMaterials, ErosionIsAddedToALaw) {
  const std::string material = "*MAT_024\n4,7.85e-9,210000.0,0.3,300.0,,0.5,1e-8\n\n\n\n";
  const auto b =
      built("*MAT_ADD_EROSION\n4,,1000.0,-0.3,-0.2,0.1,-50.0\n-500.0,800.0,,0.25,0.3,700.0,0.01,2.0\n" + material);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const kernel::LawComponents& law = composition(b);
  EXPECT_DOUBLE_EQ(std::get<kernel::PiecewiseLinear>(law.flow).yield.at(0).y[0], 300.0);
  EXPECT_DOUBLE_EQ(law.failure_strain, 0.2);  // EFFEPS below 0, less than FAIL
  EXPECT_DOUBLE_EQ(law.deletion_step, 1e-8);
  EXPECT_DOUBLE_EQ(law.points_to_delete, -50.0);
  const kernel::Erosion& e = *law.erosion;
  EXPECT_DOUBLE_EQ(*e.most_pressure, 1000.0);
  EXPECT_DOUBLE_EQ(*e.least_strain, -0.3);
  EXPECT_DOUBLE_EQ(*e.most_volume_strain, 0.1);
  EXPECT_DOUBLE_EQ(*e.least_pressure, -500.0);
  EXPECT_DOUBLE_EQ(*e.most_stress, 800.0);
  EXPECT_FALSE(e.effective_stress);
  EXPECT_FALSE(e.effective_strain);
  EXPECT_DOUBLE_EQ(*e.most_strain, 0.25);
  EXPECT_DOUBLE_EQ(*e.shear_strain, 0.3);
  EXPECT_DOUBLE_EQ(e.threshold, 700.0);
  EXPECT_DOUBLE_EQ(*e.impulse, 0.01);
  EXPECT_DOUBLE_EQ(*e.time, 2.0);
}

TEST(PlasticMaterials, ErosionExcludesAValue) {
  const std::string material = "*MAT_001\n4,7.85e-9,210000.0,0.3\n";
  const auto b = built(material +
                       "*MAT_ADD_EROSION\n4,1234.0,1234.0,1234.0,1234.0,1234.0\n0.0,1234.0,1234.0,1234.0,"
                       "1234.0,1234.0,1234.0,1234.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const kernel::Erosion& e = *composition(b).erosion;
  EXPECT_DOUBLE_EQ(*e.least_pressure, 0.0);  // no tension
  EXPECT_FALSE(e.most_pressure || e.most_stress || e.most_strain || e.time || e.impulse);
  const auto curve = built(material + "*MAT_ADD_EROSION\n4\n,,-7.0\n*DEFINE_CURVE\n7\n0.0,300.0\n1.0,400.0\n");
  EXPECT_DOUBLE_EQ(composition(curve).erosion->effective_stress_over_rate.y[1], 400.0) << curve.all_findings();
}

TEST(PlasticMaterials, ErosionFaults) {
  const std::string material = "*MAT_001\n4,7.85e-9,210000.0,0.3\n", erosion = "*MAT_ADD_EROSION\n4,,,,0.3\n\n";
  EXPECT_TRUE(built(erosion).error("material 4 is not defined", "mid"));
  EXPECT_TRUE(built(material + erosion + erosion).error("already", "mid"));
  EXPECT_TRUE(built(material + erosion + "-1\n").error("DIEM", "idam"));
  EXPECT_TRUE(built(material + erosion + "\n3\n").error("only 0 is supported", "lcfld"));
  EXPECT_TRUE(built(material + "*MAT_ADD_EROSION\n4\n,,,-3.0\n").error("curve over the strain rate", "mxeps"));
  EXPECT_TRUE(built("*MAT_020\n4,7.85e-9,210000.0,0.3\n" + erosion).error("cannot be added", "mid"));
}

TEST(SoftMaterials, Rubbers) {
  const auto blatz_ko = built("*MAT_BLATZ-KO_RUBBER\n4,1.2e-9,2.0\n");
  EXPECT_EQ(blatz_ko.findings.errors(), 0) << blatz_ko.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::BlatzKo>(blatz_ko).shear, 2.0);
  EXPECT_DOUBLE_EQ(blatz_ko.model.materials.at(0).young(), 2.0 * 2.0 * 1.463);
  EXPECT_TRUE(for_shells(composition(blatz_ko)));
  const auto mooney = built("*MAT_027\n4,1.2e-9,0.49,0.8,0.2\n");
  EXPECT_EQ(mooney.findings.errors(), 0) << mooney.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::MooneyRivlin>(mooney).a, 0.8);
  EXPECT_DOUBLE_EQ(mooney.model.materials.at(0).young(), 4.0 * 1.0 * 1.49);
  EXPECT_TRUE(for_shells(composition(mooney)));
  EXPECT_TRUE(built("*MAT_027\n4,1.2e-9,0.5,0.8,0.2\n").error("expected 0 to", "pr"));
  EXPECT_TRUE(built("*MAT_027\n4,1.2e-9,0.49,0.8,0.2\n,,,5\n").error("only 0 is supported", "lcid"));
  const auto ogden = built("*MAT_077_O\n4,1.2e-9,0.49\n0.63,0.0012,-0.01\n1.3,5.0,-2.0\n");
  EXPECT_EQ(ogden.findings.errors(), 0) << ogden.all_findings();
  EXPECT_EQ(flow<kernel::Ogden>(ogden).terms.size(), 3u);
  EXPECT_NEAR(ogden.model.materials.at(0).young(), (0.63 * 1.3 + 0.0012 * 5.0 + 0.02) * 1.49, 1e-12);
  EXPECT_TRUE(built("*MAT_077_O\n4,1.2e-9,0.49\n-1.0\n2.0\n").error("shear modulus", "mu1"));
  const auto polynomial =
      built("*MAT_077_H\n4,1.2e-9,0.49,,,40.0,0.1\n0.3,0.1,0.02,-0.03,0.01,0.05\n3.0,100.0\n5.0,700.0\n");
  EXPECT_EQ(polynomial.findings.errors(), 0) << polynomial.all_findings();
  const auto& rubber = flow<kernel::PolynomialRubber>(polynomial);
  EXPECT_DOUBLE_EQ(rubber.c30, 0.05);
  EXPECT_DOUBLE_EQ(rubber.overstress.friction_limit, 0.1);
  ASSERT_EQ(rubber.overstress.maxwell_branches.size(), 2u);
  EXPECT_DOUBLE_EQ(rubber.overstress.maxwell_branches[1].decay, 700.0);
  EXPECT_NEAR(polynomial.model.materials.at(0).young(), 2.0 * 0.8 * 1.49, 1e-12);
  const std::string tail = "\n0.3,0.1\n";
  EXPECT_TRUE(built("*MAT_077_H\n4,1.2e-9,0.49,2" + tail).error("only 0 is supported", "n"));
  EXPECT_TRUE(built("*MAT_077_H\n4,1.2e-9,-0.49" + tail).error("expected 0 to", "pr"));
  EXPECT_TRUE(built("*MAT_077_H\n4,1.2e-9,0.49,,,40.0" + tail).warning("both G and SIGF", "sigf"));
  EXPECT_TRUE(built("*MAT_077_H\n4,1.2e-9,0.49\n-0.3,0.1\n").error("shear modulus", "c10"));
  const std::string shell =
      "*SECTION_SHELL\n1,2\n1.0\n*PART\np\n1,1,4\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n"
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n";
  const std::string mooney_card = "*MAT_027\n4,1.2e-9,0.49,0.8,0.2\n";
  EXPECT_TRUE(built(mooney_card + shell).warning("the shells keep their thickness while *MAT_MOONEY", "mid"));
  EXPECT_FALSE(built(mooney_card + shell + "*CONTROL_SHELL\n,,,1\n").warning("the shells keep their thickness"));
  EXPECT_TRUE(built("*MAT_006\n4,1.2e-9,20.0,1.0,0.5,10.0\n" + shell).error("is a law of solids", "mid"));
}

TEST(SoftMaterials, RubberByATest) {
  const std::string test = "*DEFINE_CURVE\n5\n-10.0,-30.0\n0.0,0.0\n10.0,12.0\n30.0,20.0\n";
  const auto rubber = built("*MAT_SIMPLIFIED_RUBBER/FOAM\n4,1.2e-9,200.0,0.2,3.0,0.1\n20.0,5.0,2.0,5\n" + test);
  EXPECT_EQ(rubber.findings.errors(), 0) << rubber.all_findings();
  const auto& law = flow<kernel::TabulatedRubber>(rubber);
  // 12 / 10 of force over length: nominal stress 1.2 at the nominal strain 0.5, so 3 G = 2.4
  EXPECT_DOUBLE_EQ(law.tests.at(0).x[2], 0.5);
  EXPECT_DOUBLE_EQ(law.tests.at(0).y[2], 1.2);
  EXPECT_NEAR(law.E / (1.0 + law.nu), 1.6, 1e-12);
  EXPECT_NEAR(law.E / (3.0 * (1.0 - 2.0 * law.nu)), 200.0, 1e-9);
  EXPECT_DOUBLE_EQ(law.damping, 0.2);
  EXPECT_DOUBLE_EQ(law.overstress.friction_limit, 0.1);
  const auto of = [&](const std::string& cards, const std::string& curve) {
    return built("*MAT_181\n4,1.2e-9,200.0\n" + cards + curve);
  };
  const std::string card = "1.0,1.0,1.0,5\n";
  EXPECT_DOUBLE_EQ(flow<kernel::TabulatedRubber>(of("20,5,2,5\n", test)).damping, 0.1);
  EXPECT_DOUBLE_EQ(flow<kernel::TabulatedRubber>(of("20,5,2,5\n0,0.5,2\n", test)).kept, 0.5);
  EXPECT_DOUBLE_EQ(flow<kernel::TabulatedRubber>(of("20,5,2,5\n0,0.5,2\n", test)).shape, 2.0);
  EXPECT_DOUBLE_EQ(flow<kernel::TabulatedRubber>(of("20,5,2,5\n0,0.5\n", test)).shape, 1.0);
  EXPECT_EQ(of("20,5,2,5\n0,1.5\n", test).findings.errors(), 1);
  const auto viscous = of("20,5,2,5\n0,1.0,0,0,1\n3.0,100.0\n5.0,700.0\n", test + brick);
  EXPECT_EQ(viscous.findings.errors(), 0) << viscous.all_findings();
  const auto& terms = flow<kernel::TabulatedRubber>(viscous).overstress.maxwell_branches;
  ASSERT_EQ(terms.size(), 2u);
  EXPECT_DOUBLE_EQ(terms[1].shear, 5.0);
  EXPECT_DOUBLE_EQ(terms[1].decay, 700.0);
  const auto in_shells = of("20,5,2,5\n0,1.0,0,0,1\n3.0,100.0\n", test + viscoplastic_shell);
  EXPECT_TRUE(in_shells.warning("no effect in shells", "visco"));
  EXPECT_TRUE(flow<kernel::TabulatedRubber>(in_shells).overstress.maxwell_branches.empty());
  EXPECT_TRUE(of("20,5,2,5\n0,1.0\n3.0,100.0\n", test).warning("not obeyed", "visco"));
  EXPECT_TRUE(of("20,5,2,5\n0,1.0,0,0,1\n", test).warning("no term that relaxes", "visco"));
  EXPECT_TRUE(of("20,5,2,5\n0,1.0,0,0,1\n3.,1.,1\n", test).error("only 0 is supported", "vflag"));
  EXPECT_TRUE(of("20,5,2,5,,,,0.3\n0,1.0,0,0,1\n3.,1.\n", test).error("built for rubber", "visco"));
  EXPECT_TRUE(of("20,5,2,-5\n", test).error("a table of damage is not built", "lc/tbid"));
  EXPECT_TRUE(of(card, "*DEFINE_CURVE\n5\n0,0\n1,2\n").warning("has no compression", "lc/tbid"));
  EXPECT_TRUE(of(card, "*DEFINE_CURVE\n5\n-0.5,-1\n0,0\n1,2\n2,1\n").error("the true stress falls after", "lc/tbid"));
  EXPECT_TRUE(of(card, "*DEFINE_CURVE\n5\n-0.5,-1\n0,0.5\n1,2\n").error("does not go through 0, 0", "lc/tbid"));
  EXPECT_TRUE(of(card, "*DEFINE_CURVE\n5\n-1.5,-1\n0,0\n1,2\n").error("leaves no length", "lc/tbid"));
  EXPECT_TRUE(of(card, "*DEFINE_CURVE\n5\n-0.5,-300\n0,0\n1,1000\n").error("below two thirds", "km"));
}

TEST(SoftMaterials, RubberAndFoamByTestsOverTheRate) {
  const std::string test = "*DEFINE_CURVE\n5\n-10.0,-30.0\n0.0,0.0\n10.0,12.0\n30.0,20.0\n";
  const std::string fast = "*DEFINE_CURVE\n6\n-10.0,-60.0\n0.0,0.0\n10.0,24.0\n30.0,40.0\n";
  const std::string table = test + fast + "*DEFINE_TABLE_2D\n9\n0.001,5\n10.0,6\n";
  const auto of = [&](const std::string& cards, const std::string& curves) {
    return built("*MAT_181\n4,1.2e-9,200.0\n" + cards + curves);
  };
  using Rubber = kernel::TabulatedRubber;
  const auto rubber = of("20,5,2,9,1,1,-0.5\n", table);
  EXPECT_EQ(rubber.findings.errors(), 0) << rubber.all_findings();
  const auto& law = flow<Rubber>(rubber);
  ASSERT_EQ(law.tests.size(), 2u);
  EXPECT_DOUBLE_EQ(law.tests[1].y[2], 2.4);
  EXPECT_EQ(law.rates, (std::vector<double>{0.001, 10.0}));
  EXPECT_EQ(law.rate_counts, Rubber::RateCounts::always);
  EXPECT_TRUE(law.engineering_rate);
  EXPECT_DOUBLE_EQ(law.window, 0.5);
  EXPECT_FALSE(law.is_foam());
  EXPECT_NEAR(law.E / (1.0 + law.nu), 1.6, 1e-12);  // by the lowest rate
  EXPECT_EQ(flow<Rubber>(of("20,5,2,9\n", table)).rate_counts, Rubber::RateCounts::loading);
  EXPECT_EQ(flow<Rubber>(of("20,5,2,9,0\n", table)).rate_counts, Rubber::RateCounts::compressive_loading);
  EXPECT_TRUE(of("20,5,2,9\n", test + fast + "*DEFINE_TABLE_2D\n9\n-5.0,5\n1.0,6\n").error("below 0", "lc/tbid"));
  EXPECT_TRUE(of("20,5,2,9\n", test + "*DEFINE_CURVE\n6\n-1,-1\n0,0\n1,2\n2,1\n*DEFINE_TABLE_2D\n9\n0,5\n1,6\n")
                  .error("curve 6: the true stress falls after", "lc/tbid"));

  const auto foam = of("20,5,2,5,,,,0.3\n", test);
  EXPECT_EQ(foam.findings.errors(), 0) << foam.all_findings();
  EXPECT_DOUBLE_EQ(flow<Rubber>(foam).contraction, 0.3);
  EXPECT_DOUBLE_EQ(flow<Rubber>(foam).nu, 0.3);
  EXPECT_NEAR(flow<Rubber>(foam).E, 2.4, 1e-12);
  EXPECT_TRUE(of("20,5,2,5,,,,0.5\n", test).error("expected 0 to 0.49", "pr/beta"));
  // A plateau of the true stress is a foam's, not a rubber's.
  const std::string plateau = "*DEFINE_CURVE\n5\n-16.0,-13.0\n-2.0,-10.0\n0.0,0.0\n10.0,12.0\n";
  EXPECT_EQ(of("20,5,2,5,,,,0.1\n", plateau).findings.errors(), 0);
  EXPECT_TRUE(of("20,5,2,5\n", plateau).error("the true stress falls after", "lc/tbid"));
  EXPECT_TRUE(of("20,5,2,5,,,,0.1\n", "*DEFINE_CURVE\n5\n-16,-13\n-2,-13\n0,0\n10,12\n")
                  .error("the force does not rise after", "lc/tbid"));
}

TEST(SoftMaterials, RubberThatUnloadsByACurve) {
  const std::string test = "*DEFINE_CURVE\n5\n-10.0,-30.0\n0.0,0.0\n10.0,12.0\n30.0,20.0\n";
  const auto of = [&](const std::string& points) {
    return built("*MAT_181\n4,1.2e-9,200.0\n20,5,2,5\n7,0.5\n" + test + "*DEFINE_CURVE\n7\n" + points);
  };
  const auto rubber = of("-10.0,-30.0\n0.0,0.0\n20.0,5.0\n30.0,20.0\n");
  EXPECT_EQ(rubber.findings.errors(), 0) << rubber.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::TabulatedRubber>(rubber).unloading.y[2], 0.5);
  EXPECT_TRUE(of("-10.0,-30.0\n0.0,0.0\n30.0,18.0\n").error("its ends are not those of curve 5", "lcunld"));
  EXPECT_TRUE(of("0.0,0.0\n30.0,20.0\n").error("its ends are not those of curve 5", "lcunld"));
  EXPECT_TRUE(of("-10.0,-30.0\n0.0,0.0\n10.0,13.0\n30.0,20.0\n").error("not between 0 and curve 5", "lcunld"));
  EXPECT_TRUE(of("-10.0,-30.0\n0.0,0.0\n10.0,-1.0\n30.0,20.0\n").error("not between 0 and curve 5", "lcunld"));
}

TEST(SoftMaterials, Foams) {
  const std::string curve = "*DEFINE_CURVE\n5\n0.0,0.0\n0.5,0.2\n0.8,1.4\n";
  const auto low = built("*MAT_057\n4,5e-11,2.0,5,0.3,0.1\n2.0,1.0,1.0\n" + curve);
  EXPECT_EQ(low.findings.errors(), 0) << low.all_findings();
  const auto& foam = flow<kernel::LowDensityFoam>(low);
  EXPECT_DOUBLE_EQ(foam.compression.y[1], 0.2);
  EXPECT_DOUBLE_EQ(foam.cutoff, 0.3);
  EXPECT_DOUBLE_EQ(foam.unloading, 0.1);
  EXPECT_DOUBLE_EQ(foam.shape, 2.0);
  EXPECT_TRUE(foam.tension_failure);
  EXPECT_TRUE(composition(low).bulk_viscosity);
  EXPECT_FALSE(composition(built("*MAT_057\n4,5e-11,2.0,5\n" + curve)).bulk_viscosity);
  const auto kcon = built("*MAT_057\n4,5e-11,2.0,5\n,,,,,7.0\n" + curve);
  EXPECT_EQ(kcon.findings.errors(), 0) << kcon.all_findings();
  EXPECT_DOUBLE_EQ(composition(kcon).contact_modulus, 7.0);
  const auto slow = built("*MAT_057\n4,5e-11,2.0,5,,,20.0,0.1\n,,,3.0,50.0\n" + curve);
  EXPECT_EQ(slow.findings.errors(), 0) << slow.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::LowDensityFoam>(slow).recovery, 20.0);
  EXPECT_DOUBLE_EQ(flow<kernel::LowDensityFoam>(slow).damping, 0.1);
  EXPECT_DOUBLE_EQ(flow<kernel::LowDensityFoam>(slow).decay, 50.0);
  EXPECT_TRUE(built("*MAT_057\n4,5e-11,2.0,5,,,,1.1\n" + curve).error("expected 0 to 1", "damp"));
  EXPECT_TRUE(built("*MAT_057\n4,5e-11,2.0,5\n\n*DEFINE_CURVE\n5\n-0.5,-0.2\n0.0,0.0\n").error("begin at", "lcid"));
  const auto crushable = built("*MAT_063\n4,5e-11,2.0,0.1,5,0.05\n" + curve);
  EXPECT_EQ(crushable.findings.errors(), 0) << crushable.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::CrushableFoam>(crushable).E, 1.2 / 0.3);
  EXPECT_DOUBLE_EQ(flow<kernel::CrushableFoam>(crushable).cutoff, 0.05);
  EXPECT_TRUE(
      built("*MAT_063\n4,5e-11,2.0,0.1,5,0.05\n*DEFINE_CURVE\n5\n0.0,0.2\n1.0,0.2\n").error("last slope", "lcid"));
}

TEST(SoftMaterials, FoamByATableOverTheRate) {
  const std::string curves =
      "*DEFINE_CURVE\n5\n0.0,0.0\n0.5,0.2\n0.8,1.4\n*DEFINE_CURVE\n6\n0.0,0.0\n0.5,0.4\n0.8,2.4\n";
  const std::string table = curves + "*DEFINE_TABLE_2D\n7\n0.001,5\n100.0,6\n";
  const auto b = built("*MAT_083\n4,5e-11,2.0,,0.3,1.0,0.2,7\n1.0,1.0,2.0,,,,,0.1\n\n,,,,,,,2.0\n3.0,1.0\n" + table);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& foam = flow<kernel::RateFoam>(b);
  EXPECT_DOUBLE_EQ(foam.rates.at(1), 100.0);
  EXPECT_DOUBLE_EQ(foam.curves.at(1).y[1], 0.4);
  EXPECT_DOUBLE_EQ(foam.cutoff, 0.3);
  EXPECT_TRUE(foam.tension_failure);
  EXPECT_DOUBLE_EQ(foam.damping, 0.2);
  EXPECT_TRUE(foam.engineering_rate);
  EXPECT_EQ(foam.rate_of, kernel::RateFoam::RateOf::volume);
  EXPECT_DOUBLE_EQ(foam.unloading, 0.1);
  EXPECT_DOUBLE_EQ(foam.shape, 2.0);
  EXPECT_DOUBLE_EQ(foam.exponent, 3.0);
  EXPECT_TRUE(composition(b).bulk_viscosity);
  const auto plain = built("*MAT_FU_CHANG_FOAM\n4,5e-11,2.0,,0.3,2.0,,7\n\n\n\n" + table);
  EXPECT_EQ(plain.findings.errors(), 0) << plain.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::RateFoam>(plain).damping, 0.05);
  EXPECT_DOUBLE_EQ(*composition(plain).erosion->most_stress, 0.3);
  EXPECT_DOUBLE_EQ(composition(plain).points_to_delete, 1.0);
  EXPECT_FALSE(composition(plain).bulk_viscosity);
  const std::string main = "*MAT_083\n4,5e-11,2.0,,,,,7\n";
  for (const char* name : {"*MAT_FU_CHANG_FOAM_LOG_LOG_INTERPOLATION\n", "*MAT_083_2\n"}) {
    const std::string logarithms = std::string(name) + "4,5e-11,2.0,,,,,7\n";
    EXPECT_TRUE(flow<kernel::RateFoam>(built(logarithms + "\n\n\n\n" + table)).log_log);
    EXPECT_TRUE(built(logarithms + "\n\n\n\n" + curves + "*DEFINE_TABLE_2D\n7\n0.0,5\n4.6,6\n")
                    .error("a rate of 0 has no logarithm", "tbid"));
  }
  EXPECT_FALSE(foam.log_log);
  // KCON: the larger of E and KCON for step and contacts, and E for the stress.
  const auto contact_modulus = [](const Built& of) { return of.model.materials.back().contact_young(); };
  const auto stiff = built("*MAT_083\n4,5e-11,2.0,9.0,,,,7\n\n\n\n\n" + table),
             soft = built("*MAT_083\n4,5e-11,2.0,1.0,,,,7\n\n\n\n\n" + table);
  EXPECT_EQ(stiff.findings.errors(), 0) << stiff.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::RateFoam>(stiff).E, 2.0);
  EXPECT_DOUBLE_EQ(flow<kernel::RateFoam>(stiff).step_modulus, 9.0);
  EXPECT_DOUBLE_EQ(contact_modulus(stiff), 9.0);
  EXPECT_DOUBLE_EQ(contact_modulus(soft), 2.0);
  EXPECT_TRUE(built("*MAT_083\n4,5e-11,2.0\n").error("", "tbid"));
  EXPECT_TRUE(built(main).error("table 7 is not defined", "tbid"));
  EXPECT_TRUE(built(main + ",,,,3\n" + table).error("only 0 is supported", "pvid"));
  EXPECT_TRUE(built(main + ",,,,,1.0\n" + table).error("only 0 is supported", "sraf"));
  EXPECT_TRUE(built(main + "\n" + curves + "*DEFINE_TABLE_2D\n7\n-6.9,5\n4.6,6\n").error("not their log", "tbid"));
}

TEST(PlasticMaterials, Damage2) {
  const auto b = built("*MAT_DAMAGE_2\n4,7.85e-9,210000.0,0.3,300.0,1000.0,0.8\n40.0,5.0\n0.02,1.2,0.3\n\n\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const kernel::LawComponents& law = composition(b);
  EXPECT_DOUBLE_EQ(law.failure_strain, 0.8);
  EXPECT_DOUBLE_EQ(law.energy_damage->onset, 0.02);
  EXPECT_DOUBLE_EQ(law.energy_damage->resistance, 1.2);
  EXPECT_DOUBLE_EQ(law.energy_damage->critical, 0.3);
  EXPECT_DOUBLE_EQ(law.energy_damage->young, 210000.0);
  EXPECT_DOUBLE_EQ(flow<kernel::PiecewiseLinear>(b).rate_c, 40.0);
  const auto plain = built("*MAT_105\n4,7.85e-9,210000.0,0.3\n\n\n0,0.5\n250.0,400.0\n");
  EXPECT_EQ(plain.findings.errors(), 0) << plain.all_findings();
  EXPECT_DOUBLE_EQ(composition(plain).energy_damage->resistance, 250.0 / 200.0);
  EXPECT_DOUBLE_EQ(composition(plain).energy_damage->critical, 0.5);
  EXPECT_TRUE(built("*MAT_105\n4,7.85e-9,210000.0,0.3,300.0\n\n0,0,1.5\n\n\n").error("0 to 1", "dc"));
}

TEST(PlasticMaterials, ModifiedJohnsonCook) {
  const std::string first = "*MAT_107\n4,7.85e-9,210000.0,0.3,0.0,0.9,4.52e8\n5e-4,293.0,1800.0,393.0,0,";
  const std::string yield = "\n490.0,383.0,0.45,0.0114,0.94\n80.0,30.0,40.0,4.0\n";
  const auto b = built(first + "0" + yield + "0.3,0.05,0.07,1.73,-0.54,-0.0123,0.1\n1600.0,900.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::ModifiedJohnsonCook>(b);
  EXPECT_DOUBLE_EQ(law.yield, 490.0);
  EXPECT_DOUBLE_EQ(law.saturating_2, 40.0);
  EXPECT_DOUBLE_EQ(law.rate_exponent, 0.0114);
  EXPECT_DOUBLE_EQ(law.reference_rate, 5e-4);
  EXPECT_DOUBLE_EQ(law.softening, 0.94);
  EXPECT_NEAR(law.warmth, 100.0 / 1507.0, 1e-15);
  EXPECT_DOUBLE_EQ(law.melting_rise, 1407.0);
  EXPECT_NEAR(law.heating, 0.9 / (7.85e-9 * 4.52e8), 1e-12);
  const auto& rule = std::get<kernel::DuctileFracture>(composition(b).rules.at(0));
  EXPECT_TRUE(rule.grows && !rule.by_work);
  EXPECT_DOUBLE_EQ(rule.threshold, 0.05);
  EXPECT_DOUBLE_EQ(rule.d4, -0.0123);
  EXPECT_DOUBLE_EQ(rule.last_rise, 1600.0 - 393.0);
  EXPECT_DOUBLE_EQ(rule.shear_strength, 900.0);
  const auto work = built(first + "1" + yield + "1.0,1000.0\n\n");
  EXPECT_EQ(work.findings.errors(), 0) << work.all_findings();
  EXPECT_DOUBLE_EQ(std::get<kernel::DuctileFracture>(composition(work).rules.at(0)).work, 1000.0);
  const auto plain = built(first + "0" + yield + "\n\n");
  EXPECT_EQ(plain.findings.errors(), 0) << plain.all_findings();
  EXPECT_TRUE(composition(plain).rules.empty());
  EXPECT_TRUE(built(first + "1" + yield + "0.0,1000.0\n\n").error("critical damage", "dc"));
  EXPECT_TRUE(built("*MAT_107\n4,7.85e-9,210000.0,0.3,1.0\n5e-4\n490.0\n\n\n\n").error("", "beta"));
  EXPECT_TRUE(built("*MAT_107\n4,7.85e-9,210000.0,0.3\n5e-4,,,,1.0\n490.0\n\n\n\n").error("", "flag1"));
  EXPECT_TRUE(built("*MAT_107\n4,7.85e-9,210000.0,0.3,,0.9,4e8\n5e-4\n490.0\n\n\n\n").error("melting", "tm"));
}

TEST(SoftMaterials, Viscoelastic) {
  const auto b = built("*MAT_006\n4,1.2e-9,2000.0,50.0,10.0,100.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::Viscoelastic>(b).long_term_shear, 10.0);
  EXPECT_NEAR(b.model.materials.at(0).young() / (2.0 * (1.0 + b.model.materials.at(0).poisson())), 50.0, 1e-9);
}

TEST(SoftMaterials, KelvinAndMaxwell) {
  const auto maxwell = built("*MAT_KELVIN-MAXWELL_VISCOELASTIC\n4,1.2e-9,2000.0,50.0,10.0,100.0\n");
  EXPECT_EQ(maxwell.findings.errors(), 0) << maxwell.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::Viscoelastic>(maxwell).decay, 100.0);
  EXPECT_NEAR(maxwell.model.materials.at(0).young() / (2.0 * (1.0 + maxwell.model.materials.at(0).poisson())), 50.0,
              1e-9);
  const auto kelvin = built("*MAT_061\n4,1.2e-9,2000.0,50.0,10.0,0.02,1.0,2.0\n");
  EXPECT_EQ(kelvin.findings.errors(), 0) << kelvin.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::Viscoelastic>(kelvin).decay, 50.0);
  EXPECT_NE(kelvin.all_findings().find("no strain in the place"), std::string::npos);
  EXPECT_TRUE(built("*MAT_061\n4,1.2e-9,2000.0,50.0,10.0,0.0,1.0\n").error("relaxation time", "dc"));
  EXPECT_TRUE(built("*MAT_061\n4,1.2e-9,2000.0,50.0,10.0,0.1,0.5\n").error("0 or 1", "fo"));
  EXPECT_TRUE(built("*MAT_061\n4,1.2e-9,20.0,50.0,10.0,0.1\n").error("negative Poisson", "bulk"));
}

}  // namespace
}  // namespace nugget::reading
