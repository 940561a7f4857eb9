// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "kernel/law/law_components.hpp"
#include "small_model.hpp"

// Cards of layers of fibres.
namespace nugget::reading {
namespace {

using Rule = kernel::CompositeLayer::Rule;

Built built(const std::string& more) {
  return Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + more);
}
const std::string moduli = "1,1.6e-9,130e3,9e3,,0.02,,0.3\n4.8e3,3.1e3,4.2e3,,2.0\n";
/// *MAT_054 with fields of the cards named; the rest as of a good one.
Built enhanced(const std::string& failure = "0.0,1e-9,,0.5,1.5,0.017,-0.012,0.3", const std::string& strengths = "",
               const std::string& more = "", const std::string& second = "4.8e3,3.1e3,4.2e3,,2.0") {
  return built("*MAT_ENHANCED_COMPOSITE_DAMAGE\n1,1.6e-9,130e3,9e3,,0.02,,0.3\n" + second +
               "\n,,,1.0,0.0,0.0,20.0\n0,0,0,0,1,0,0.02,0.03\n" + failure + "\n" +
               (strengths.empty() ? "1200.0,2000.0,180.0,50.0,80.0,54.0,0.4" : strengths) + "\n" + more);
}
const kernel::LawComponents& components(const Built& b) {
  return *std::get<kernel::ComposedLaw>(b.model.materials.at(0).law).components;
}
const kernel::CompositeLayer& law(const Built& b) {
  return std::get<kernel::CompositeLayer>(components(b).flow);
}

TEST(CompositeMaterials, Mat22) {
  const auto b =
      built("*MAT_022\n" + moduli + ",,,0.0,1.0,0.0\n0,0,0,1,0,0,30.0\n80.0,2000.0,50.0,180.0,1e-9,30,20,20\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(law(b).rule, Rule::stresses_vanish);
  EXPECT_DOUBLE_EQ(law(b).shear_strength, 80.0);
  EXPECT_DOUBLE_EQ(law(b).tension_a, 2000.0);
  EXPECT_DOUBLE_EQ(law(b).tension_b, 50.0);
  EXPECT_DOUBLE_EQ(law(b).compression_b, 180.0);
  EXPECT_DOUBLE_EQ(law(b).shear_cube, 1e-9);
  EXPECT_DOUBLE_EQ(law(b).young_c, 9e3);
  EXPECT_DOUBLE_EQ(law(b).axes.a.y, 1.0);
  EXPECT_NEAR(law(b).axes.angle, std::numbers::pi / 6.0, 1e-15);
  EXPECT_NEAR(law(b).E / (1.0 - law(b).nu * law(b).nu), 130e3 / (1.0 - 0.02 * 0.02 * 130.0 / 9.0), 1e-6);
}

TEST(CompositeMaterials, Mat54) {
  const auto b = enhanced("0.05,1e-9,0.7,0.5,1.5,0.017,-0.012,0.3", "", "80.0,,,0.9,1.0\n0.1,0.2,0.3,0.4,0.5,20\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(law(b).soft, 0.7);
  const auto alone = enhanced("0.0,1e-9,0.7,0.5,1.5,0.017,-0.012,0.3");
  EXPECT_TRUE(alone.warning("has no effect without TFAIL", "soft"));
  EXPECT_DOUBLE_EQ(law(alone).soft, 1.0);
  const auto good = enhanced("0.05,1e-9,1.0,0.5,1.5,0.017,-0.012,0.3", "", "80.0,,,0.9,1.0\n0.1,0.2,0.3,0.4,0.5,20\n");
  EXPECT_EQ(good.findings.errors(), 0) << good.all_findings();
  const kernel::CompositeLayer& l = law(good);
  EXPECT_EQ(l.rule, Rule::stresses_stay);
  EXPECT_DOUBLE_EQ(components(good).deletion_step, 0.05);
  EXPECT_TRUE(components(good).for_layers_only);
  EXPECT_DOUBLE_EQ(l.failure_strain_t, 0.017);
  EXPECT_DOUBLE_EQ(l.failure_strain_c, 0.012);
  EXPECT_DOUBLE_EQ(l.failure_strain_m, 0.02);
  EXPECT_DOUBLE_EQ(l.failure_strain_s, 0.03);
  EXPECT_DOUBLE_EQ(l.effective_failure_strain, 0.3);
  EXPECT_DOUBLE_EQ(l.crushed_tension, 0.5);
  EXPECT_DOUBLE_EQ(l.crushed_compression, 1.5);
  EXPECT_DOUBLE_EQ(l.shear_weight, 0.4);
  EXPECT_EQ(l.left, (std::array{0.1, 0.2, 0.3, 0.4, 0.5}));
  EXPECT_DOUBLE_EQ(l.cycles_of_loss, 20.0);
  EXPECT_NEAR(l.axes.angle, std::numbers::pi / 9.0, 1e-15);
  // 0 is all of the stress, SOFT without TFAIL nothing.
  const auto plain = enhanced("0.0,,0.6");
  EXPECT_EQ(plain.findings.errors(), 0) << plain.all_findings();
  EXPECT_EQ(law(plain).left, (std::array{1.0, 1.0, 1.0, 1.0, 1.0}));
  EXPECT_DOUBLE_EQ(law(plain).crushed_compression, 2.0);
}

TEST(CompositeMaterials, Mat55) {
  const auto b = enhanced("0.0,0,,,,0.017,-0.012", "1200.0,2000.0,180.0,50.0,80.0,55.0,0.4");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(law(b).rule, Rule::tsai_wu);
  EXPECT_DOUBLE_EQ(law(b).failure_strain_t, 0.0);
  EXPECT_NE(b.all_findings().find("no effect with CRIT 55"), std::string::npos);
}

TEST(CompositeMaterials, WhatIsNotBuiltIsRefusedByField) {
  EXPECT_TRUE(enhanced("0.5,0").error("share of the element's first time step", "tfail"));
  EXPECT_TRUE(enhanced("0,0,,,,0.017").error("compressive strain", "dfailc"));
  EXPECT_TRUE(enhanced("0,0,,,,0.017,0.012").error("-1 to 0", "dfailc"));
  EXPECT_TRUE(enhanced("0", "1200.0,2000.0,180.0,50.0,80.0,54.5").error("54 or 55", "crit"));
  EXPECT_TRUE(enhanced("0", "-1200.0,2000.0,180.0,50.0,80.0").error("", "xc"));
  EXPECT_TRUE(enhanced("0", "1200.0,2000.0,180.0,50.0").error("", "sc"));
  EXPECT_TRUE(enhanced("0", "", "0,0.01,0.02\n").error("", "epsf"));
  EXPECT_TRUE(enhanced("0", "", "\n\n7\n").error("", "lcxc"));
  EXPECT_TRUE(enhanced("0", "", "", "4.8e3,3.1e3,4.2e3,,2.0,1.0").error("", "2way"));
  EXPECT_TRUE(built("*MAT_022\n1,1.6e-9,130e3,9e3,,0.3\n4.8e3,3.1e3,4.2e3\n\n\n80.0,2000.0,50.0,180.0\n")
                  .error("would give energy", "prba"));
}

}  // namespace
}  // namespace nugget::reading
