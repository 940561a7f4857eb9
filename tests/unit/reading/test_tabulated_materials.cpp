// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "law_decks.hpp"

// Cards of MAT_224, MAT_058, MAT_133 and MAT_073.
namespace nugget::reading {
namespace {

const std::string metal_tables =
    "*DEFINE_TABLE\n10\n0.001\n1000.0\n*DEFINE_CURVE\n11\n0,400\n1,900\n*DEFINE_CURVE\n12\n0,500\n1,1000\n"
    "*DEFINE_TABLE\n20\n293.0\n493.0\n*DEFINE_CURVE\n21\n0,300\n1,800\n*DEFINE_CURVE\n22\n0,200\n1,500\n"
    "*DEFINE_CURVE\n30\n-0.6667,0.2\n-0.3333,0.4\n0.3333,0.9\n*DEFINE_CURVE\n31\n-7.0,1.0\n7.0,1.5\n"
    "*DEFINE_CURVE\n32\n293,1\n593,2\n*DEFINE_TABLE\n40\n-0.3333\n0.3333\n*DEFINE_CURVE\n41\n1,1.0\n5,0.6\n"
    "*DEFINE_CURVE\n42\n1,1.0\n5,0.9\n";
Built tabulated(const std::string& first = "1,7.85e-9,2.1e5,0.3,4.52e8,293.0,0.9,2",
                const std::string& second = "10,20,30,31,32,40", const std::string& third = "") {
  return built("*MAT_TABULATED_JOHNSON_COOK\n" + first + "\n" + second + "\n" + third + metal_tables);
}

TEST(TabulatedMaterials, Mat224) {
  const auto b = tabulated();
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::TabulatedJohnsonCook>(b);
  EXPECT_EQ(law.rates, (std::vector<double>{0.001, 1000.0}));
  EXPECT_DOUBLE_EQ(law.yield.at(1).y.front(), 500.0);
  EXPECT_FALSE(law.log_rates);
  EXPECT_DOUBLE_EQ(law.heating, 0.9 / (7.85e-9 * 4.52e8));
  EXPECT_EQ(law.softening.value, (std::vector<double>{0.0, 200.0}));
  EXPECT_DOUBLE_EQ(composition(b).points_to_delete, 2.0);
  ASSERT_TRUE(composition(b).gissmo);
  const kernel::Gissmo& g = *composition(b).gissmo;
  // Tension is positive there, pressure on the cards.
  EXPECT_NEAR(g.fracture.at(0.0, 0.3333), 0.4, 1e-12);
  EXPECT_NEAR(g.fracture.at(0.0, 0.6667), 0.2, 1e-12);
  EXPECT_NEAR(g.fracture.at(0.0, -0.3333), 0.9, 1e-12);
  EXPECT_NEAR(g.mesh.at(0.3333, 5.0), 0.6, 1e-12);
  EXPECT_NEAR(g.mesh.at(-0.3333, 5.0), 0.9, 1e-12);
  EXPECT_TRUE(g.log_rates);
  EXPECT_DOUBLE_EQ(g.heat.clamped(150.0), 1.5);
  EXPECT_DOUBLE_EQ(g.threshold, 1.0);
  EXPECT_DOUBLE_EQ(g.growth, 1.0);
  EXPECT_TRUE(built("*MAT_224_LOG_INTERPOLATION\n1,7.85e-9,2.1e5,0.3\n10\n" + metal_tables).findings.errors() == 0);
}

// Sabotage: each refusal taken away.
TEST(TabulatedMaterials, WhatOf224IsNotObeyedIsSaid) {
  EXPECT_TRUE(tabulated("1,7.85e-9,-2.1e5,0.3").error("", "e"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0,-7").error("", "beta"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0,0.9,-200").error("", "numint"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10,21").error("one temperature", "lckt"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10,0,99").error("not defined", "lcf"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10,0,30,40").error("a table is not built", "lcg"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "0").error("", "lck1"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10", "1.0\n").error("", "failopt"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10", ",,,1\n").error("", "erode"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10", ",,,,5\n").error("", "lcps"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3", "10,20").warning("without CP", "lckt"));
  EXPECT_TRUE(tabulated("1,7.85e-9,2.1e5,0.3,4.52e8,293.0", "10,20,0,31").warning("without LCF", "lcg"));
}

Built laminate(const std::string& failure = "2,0,0.5,1,-1", const std::string& first = "30.0,0.01",
               const std::string& strains = "0.014,0.018,0.02,0.008,0.1", const std::string& more = "",
               const std::string& limits = "0.1,1.0,0.2,0.9,0.8") {
  return built("*MAT_LAMINATED_COMPOSITE_FABRIC\n1,1.6e-9,60e3,20e3,,0.05," + first + "\n4e3,3e3,3.5e3," + limits +
               "\n" + failure + "\n,,,1,0,0\n0,0,0,0,1,0,30\n" + strains + "\n600,900,180,100,60\n" + more);
}

TEST(TabulatedMaterials, Mat58) {
  const auto b = laminate();
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::LaminatedFabric>(b);
  EXPECT_EQ(law.surface, kernel::LaminatedFabric::Surface::faceted);
  EXPECT_DOUBLE_EQ(law.tension_a.strength, 900.0);
  EXPECT_DOUBLE_EQ(law.tension_a.strain, 0.018);
  EXPECT_DOUBLE_EQ(law.tension_a.left, 0.1);
  EXPECT_DOUBLE_EQ(law.compression_a.strength, 600.0);
  EXPECT_DOUBLE_EQ(law.compression_a.strain, 0.014);
  EXPECT_DOUBLE_EQ(law.compression_a.left, 1.0);
  EXPECT_DOUBLE_EQ(law.tension_b.strength, 100.0);
  EXPECT_DOUBLE_EQ(law.tension_b.strain, 0.008);
  EXPECT_DOUBLE_EQ(law.compression_b.left, 0.9);
  EXPECT_DOUBLE_EQ(law.shear.left, 0.8);
  EXPECT_DOUBLE_EQ(law.first_shear_stress, 30.0);
  EXPECT_DOUBLE_EQ(law.failure_strain, 0.5);
  EXPECT_DOUBLE_EQ(law.poisson_ca, 0.05);
  EXPECT_NEAR(law.axes.angle, std::numbers::pi / 6.0, 1e-15);
  EXPECT_DOUBLE_EQ(
      flow<kernel::LaminatedFabric>(laminate("2,0,0.5,1,-1", "30.0,0.01", "0.014,0.018,0.02,0.008,0.1", "", ""))
          .shear.left,
      1e-8);
  const auto soft = laminate("2,1e-8,-0.5,0.7,1", "0,0");
  ASSERT_EQ(soft.findings.errors(), 0) << soft.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::LaminatedFabric>(soft).soft, 0.7);
  EXPECT_EQ(flow<kernel::LaminatedFabric>(soft).surface, kernel::LaminatedFabric::Surface::quadratic);
  EXPECT_DOUBLE_EQ(composition(soft).deletion_step, 1e-8);
  EXPECT_FALSE(kernel::for_bricks(composition(soft)));
}

TEST(TabulatedMaterials, WhatOf58IsNotObeyedIsSaid) {
  EXPECT_TRUE(laminate("2,0,0.5,1,0.5").error("-1, 0 or 1", "fs"));
  EXPECT_TRUE(laminate("2,0,0.5,1,-1,0.1").error("", "epsf"));
  EXPECT_TRUE(laminate("2,0,0.5,0.7,0", "0,0").warning("without TSIZE", "soft"));
  EXPECT_TRUE(laminate("2,0,0.5,1,0").warning("but with FS -1", "tau1"));
  EXPECT_TRUE(laminate("2,0,0.5,1,-1", "30.0,0").error("both TAU1 and GAMMA1", "gamma1"));
  EXPECT_TRUE(laminate("2,0,0.5,1,-1", "50.0,0.01").error("above the elastic stress", "tau1"));
  EXPECT_TRUE(laminate("2,0,0.5,1,-1", "30.0,0.2").error("below GMS", "gamma1"));
  EXPECT_TRUE(laminate("2,0,0.5,1,-1", "5.0,0.05").error("stiffer than", "tau1"));
  EXPECT_TRUE(laminate("2,0,0.5,1,0", "0,0", "0.002,0.018,0.02,0.008,0.1").warning("below the elastic strain", "e11c"));
  EXPECT_TRUE(laminate("2,0,0.5,1,0", "0,0", "0,0.018,0.02,0.008,0.1").error("", "e11c"));
  EXPECT_TRUE(laminate("2,0,0.5,1,0", "0,0", "0.014,0.018,0.02,0.008,0.1", "0,7\n").error("", "lcxt"));
  EXPECT_TRUE(laminate("2,0,0.5,1,0", "0,0", "0.014,0.018,0.02,0.008,0.1", "\n,,,,9\n").error("", "lcgms"));
}

Built yld(const std::string& hardening = "500,0.01,0.25,,,1,8",
          const std::string& shape = "0.4865,1.3783,0.7536,1.0246,1.0363,0.9036,1.2321,1.4858",
          const std::string& first = "0,0,0,1", const std::string& option = "2,15") {
  return built("*MAT_BARLAT_YLD2000\n1,2.7e-9,70e3,0.33," + first + "\n" + hardening + "\n" + shape + "\n" + option +
               "\n,,,1,0,0\n0,0,0,0,1,0\n*DEFINE_CURVE\n7\n0,200\n1,400\n");
}

TEST(TabulatedMaterials, Mat133) {
  const auto b = yld();
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::Yld2000Sheet>(b);
  EXPECT_DOUBLE_EQ(law.surface.alpha[1], 1.3783);
  EXPECT_DOUBLE_EQ(law.surface.alpha[7], 1.4858);
  EXPECT_DOUBLE_EQ(law.surface.m, 8.0);
  EXPECT_NEAR(law.axes.angle, 15.0 * std::numbers::pi / 180.0, 1e-15);
  EXPECT_DOUBLE_EQ(std::get<kernel::SheetFormula>(law.hardening).start_strain, 0.01);
  // Scaled: tension along a has the yield stress.
  const auto scaled = yld("500,0.01,0.25,,,1,8", "2,2,2,2,2,2,2,2", "0,0,0,0");
  EXPECT_NEAR(flow<kernel::Yld2000Sheet>(scaled).surface.alpha[4], 1.0, 1e-14);
  const auto fitted = yld("500,300,0.25,,,2,8", "100,81.14,91.02,0.2115,1.5769,0.6923\n103.5,103.5,0,-0.67,1,0", "1");
  ASSERT_EQ(fitted.findings.errors(), 0) << fitted.all_findings();
  EXPECT_NEAR(flow<kernel::Yld2000Sheet>(fitted).surface.alpha[0], 0.4865, 5e-3);
  const auto& voce = std::get<kernel::SheetFormula>(flow<kernel::Yld2000Sheet>(fitted).hardening);
  EXPECT_DOUBLE_EQ(voce.offset - voce.factor, 200.0);
  EXPECT_DOUBLE_EQ(voce.decay, 0.25);
  const auto curve = yld("0,0,0,,,-7,8");
  ASSERT_EQ(curve.findings.errors(), 0) << curve.all_findings();
  EXPECT_EQ(std::get<kernel::PiecewiseLinear>(flow<kernel::Yld2000Sheet>(curve).hardening).yield.at(0).y.at(1), 400.0);
}

TEST(TabulatedMaterials, WhatOf133IsNotObeyedIsSaid) {
  EXPECT_TRUE(yld("500,0.01,0.25,,,3,8").error("built are 1, 2, 4, 5", "hard"));
  EXPECT_TRUE(yld("500,0.01,0.25,10,0.1,1,8").error("", "c"));
  EXPECT_TRUE(yld("500,0.01,0.25,,,1,1.5").error("2 or more", "a"));
  EXPECT_TRUE(yld("500,0.01,0.25,,,1,-8\n1,2").error("kinematic", "a"));
  EXPECT_TRUE(yld("500,0,0.25,,,1,8").error("first yield stress", "e0"));
  EXPECT_TRUE(yld("500,600,2,,,2,8").error("a - b", "k"));
  EXPECT_TRUE(yld("500,300,2,,,5,8").error("HARD 5", "p4"));
  EXPECT_TRUE(yld("500,0.01,0.25,,,1,8", "1,1,1,1,1,1,1,1", "0,0.5").error("", "beta"));
  EXPECT_TRUE(yld("500,0.01,0.25,,,1,8", "0,0,0,0,0,0,0,0", "0").error("", "alpha1"));
  EXPECT_TRUE(
      yld("500,0.01,0.25,,,1,2", "100,81,91,0.2,1.5,0.7\n103,103,0,-0.7,1,0", "1").error("no surface", "sig00"));
  EXPECT_TRUE(yld("500,0.01,0.25,,,1,8", "100,81,91,0.2,1.5,0.7\n0,0,0,-0.7,1,0", "1").error("further", "sigxx"));
  EXPECT_TRUE(yld("500,0.01,0.25,,,1,8", "100,81,91,0.2,1.5,0.7\n103,103,0", "1").error("tangent", "dxx"));
}

TEST(TabulatedMaterials, Mat73) {
  const std::string card = "*MAT_LOW_DENSITY_VISCOUS_FOAM\n1,5e-11,2.0,7,0.5,0.4,3.0,0.1\n2,1,1,5.0",
                    curve = "*DEFINE_CURVE\n7\n0,0\n0.9,2\n";
  const auto b = built(card + "\n0.3,100\n0.2,5000\n" + curve);
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::LowDensityFoam>(b);
  ASSERT_EQ(law.terms.size(), 2U);
  EXPECT_DOUBLE_EQ(law.terms[1].shear, 0.2);
  EXPECT_DOUBLE_EQ(law.terms[1].decay, 5000.0);
  EXPECT_DOUBLE_EQ(law.unloading, 0.4);
  EXPECT_DOUBLE_EQ(law.shape, 2.0);
  EXPECT_TRUE(law.tension_failure);
  EXPECT_DOUBLE_EQ(composition(b).contact_modulus, 5.0);
  EXPECT_TRUE(built(card + ",8\n0.3,100\n" + curve).error("", "lcid2"));
  std::string many = card;
  for (int k = 0; k < 7; ++k) many += "\n0.1,10";
  EXPECT_TRUE(built(many + "\n" + curve).error("six terms", "gi"));
}

}  // namespace
}  // namespace nugget::reading
