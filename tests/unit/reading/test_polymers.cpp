// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "law_decks.hpp"

// Cards of plastics, windscreens and viscoelastic series: MAT_032, 076, 089, 124.
namespace nugget::reading {
namespace {

std::string curve(int id, const std::string& points) {
  return "*DEFINE_CURVE\n" + std::to_string(id) + "\n" + points;
}

// E = 2000: 20 at a strain of 0.01 is the end of the elastic line, 30 at 0.065 has a plastic strain of 0.05.
TEST(Polymers, TotalStrainsBecomePlasticOnes) {
  const auto of = [](const std::string& points, const std::string& third = "\n") {
    return built("*MAT_PLASTICITY_POLYMER\n4,1.1e-9,2000.0,0.4\n,,5\n" + third + curve(5, points));
  };
  const auto b = of("0,0\n0.01,20\n0.065,30\n0.52,40\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::PiecewiseLinear>(b);
  ASSERT_EQ(law.yield.size(), 1u);
  ASSERT_EQ(law.yield[0].x.size(), 3u);
  EXPECT_DOUBLE_EQ(law.yield[0].x[0], 0.0);
  EXPECT_DOUBLE_EQ(law.yield[0].y[0], 20.0);
  EXPECT_DOUBLE_EQ(law.yield[0].x[1], 0.05);
  EXPECT_DOUBLE_EQ(law.yield[0].x[2], 0.5);
  // A curve that bends from the start yields at once.
  const auto bent = of("0,0\n0.02,20\n0.065,30\n");
  EXPECT_DOUBLE_EQ(flow<kernel::PiecewiseLinear>(bent).yield[0].y[0], 0.03);
  EXPECT_DOUBLE_EQ(flow<kernel::PiecewiseLinear>(bent).yield[0].x[1], 0.01);
  EXPECT_TRUE(of("0,0\n0.01,20\n0.02,45\n").error("steeper than Young's modulus 2000 before the strain 0.02", "lcss"));
  EXPECT_TRUE(of("0,0\n0.005,20\n0.065,30\n").error("steeper than Young's modulus", "lcss"));

  const auto rates =
      built("*MAT_089\n4,1.1e-9,2000.0,0.4\n,,9\n0,0,0,6,-60\n" + curve(5, "0,0\n0.01,20\n0.065,30\n") +
            curve(7, "0,0\n0.02,40\n0.08,60\n") + "*DEFINE_TABLE_2D\n9\n-7.0,5\n0.0,7\n" + curve(6, "-7,0.5\n0,0.2\n"));
  EXPECT_EQ(rates.findings.errors(), 0) << rates.all_findings();
  EXPECT_EQ(flow<kernel::PiecewiseLinear>(rates).yield.size(), 2u);
  EXPECT_TRUE(flow<kernel::PiecewiseLinear>(rates).log_rates);
  EXPECT_DOUBLE_EQ(composition(rates).points_to_delete, -60.0);
  EXPECT_DOUBLE_EQ(composition(rates).erosion->most_strain_over_log_rate.y[1], 0.2);
  EXPECT_TRUE(of("0,0\n0.01,20\n0.065,30\n", "1\n").error("only 0 is supported", "eftx"));
  EXPECT_TRUE(of("0,0\n0.01,20\n0.065,30\n", "0,1e-3\n").error("only 0 is supported", "damp"));
}

TEST(Polymers, CompressionAndTension) {
  const std::string curves = curve(5, "0,60\n0.5,90\n") + curve(6, "0,40\n0.5,50\n");
  const std::string scales = curve(7, "0,1\n10,2\n") + curve(8, "0,1\n10,1.5\n");
  const auto of = [&](const std::string& first, const std::string& rest) {
    return built("*MAT_PLASTICITY_COMPRESSION_TENSION\n4,1.1e-9,2000.0,0.4" + first + "\n" + rest + curves + scales);
  };
  const auto b = of(",,,0.3,1e-7", "5,6,7,8,1,8\n30.0,10.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::CompressionTension>(b);
  EXPECT_DOUBLE_EQ(law.compression.y[0], 60.0);
  EXPECT_DOUBLE_EQ(law.tension.y[0], 40.0);
  EXPECT_DOUBLE_EQ(law.compression_scale.y[1], 2.0);
  EXPECT_DOUBLE_EQ(law.tension_scale.y[1], 1.5);
  EXPECT_DOUBLE_EQ(law.full_compression, 30.0);
  EXPECT_DOUBLE_EQ(law.full_tension, 10.0);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain, 0.3);
  EXPECT_DOUBLE_EQ(composition(b).deletion_step, 1e-7);
  EXPECT_DOUBLE_EQ(composition(b).failure_strain_over_rate.y[0], 1.0);
  EXPECT_DOUBLE_EQ(flow<kernel::CompressionTension>(of(",40.4,5", "5,6\n")).rate_c, 40.4);
  EXPECT_TRUE(of(",40.4,5", "5,6,7\n").warning("C and P are not obeyed", "c"));
  EXPECT_TRUE(of(",40.4", "5,6\n").warning("needs both constants", "p"));
  EXPECT_EQ(of("", "5,6,0,0,0,0,2000.0\n").findings.errors(), 0);
  EXPECT_TRUE(of("", "5,6,0,0,0,0,-1000.0\n").error("expected 0 or more", "ec"));
  // The larger modulus is that of the step, contact has E; bounds of the change are shares of PC and PT.
  const auto two = of("", "5,6,0,0,0,0,3000.0,0.5\n30.0,10.0\n");
  EXPECT_EQ(two.findings.errors(), 0) << two.all_findings();
  EXPECT_DOUBLE_EQ(flow<kernel::CompressionTension>(two).E, 3000.0);
  EXPECT_DOUBLE_EQ(flow<kernel::CompressionTension>(two).tension_share, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(flow<kernel::CompressionTension>(two).compression_share, 1.0);
  EXPECT_DOUBLE_EQ(flow<kernel::CompressionTension>(two).soft_compression, 15.0);
  EXPECT_DOUBLE_EQ(flow<kernel::CompressionTension>(two).soft_tension, 5.0);
  EXPECT_DOUBLE_EQ(composition(two).contact_modulus, 2000.0);
  EXPECT_TRUE(of("", "5,6\n,,1.0,1.0,1.0\n").error("only 0 is supported", "pcutf"));
  EXPECT_TRUE(of("", "5,6\n\n100.0\n").error("only 0 is supported", "k"));
  EXPECT_TRUE(of("", "5,6\n\n\n1.0,2.0\n").error("only 0 is supported", "gi"));
  EXPECT_TRUE(of("", "5,77\n").error("77 is not defined", "lcidt"));
}

TEST(Polymers, ASeriesThatRelaxes) {
  const auto of = [](const std::string& rest) { return built("*MAT_GENERAL_VISCOELASTIC\n4,1.1e-9,2000.0" + rest); };
  const auto b = of("\n\n10.0,0.0\n30.0,100.0\n20.0,5.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = flow<kernel::GeneralViscoelastic>(b);
  ASSERT_EQ(law.overstress.maxwell_branches.size(), 3u);
  EXPECT_DOUBLE_EQ(law.overstress.maxwell_branches[1].decay, 100.0);
  EXPECT_NEAR(law.E, 9.0 * 2000.0 * 60.0 / 6060.0, 1e-10);
  EXPECT_TRUE(of("\n5,6\n10.0,0.0\n").error("a series is not fitted", "lcid"));
  EXPECT_TRUE(of("\n\n10.0,0.0,5.0\n").error("only 0 is supported", "ki"));
  EXPECT_TRUE(of("\n\n").error("there is no shear modulus", "bulk"));
  EXPECT_TRUE(of("\n\n9000.0,1.0\n").error("negative Poisson's ratio", "bulk"));
  EXPECT_TRUE(of(",1.0\n\n10.0,0.0\n").error("only 0 is supported", "pcf"));
}

TEST(Polymers, LaminatedGlass) {
  const std::string glass = "*MAT_LAMINATED_GLASS\n4,2.5e-9,70000.0,0.23,50.0,10.0,1e-3,500.0\n0.4,20.0,5.0\n0,1,0\n";
  const std::string mesh = "*PART\np\n1,1,4\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n";
  const std::string rule = "*INTEGRATION_SHELL\n7,3\n-0.6,0.4\n0,0.2\n0.6,0.4\n";
  const auto b = built(glass + mesh + rule + "*SECTION_SHELL\n1,2,1.0,3,0,-7\n5,5,5,5\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& made = std::get<kernel::Laminate>(b.model.materials[b.model.parts[0].material].law);
  ASSERT_EQ(made.layers->size(), 3u);
  const auto young = [&](std::size_t k) { return (*made.layers)[k].law.E; };
  EXPECT_DOUBLE_EQ(young(0), 70000.0);
  EXPECT_DOUBLE_EQ(young(1), 500.0);
  EXPECT_DOUBLE_EQ(young(2), 70000.0);
  EXPECT_DOUBLE_EQ((*made.layers)[2].share, 0.4);
  EXPECT_TRUE(made.kept_by_unfailing_layers);
  EXPECT_DOUBLE_EQ(made.density, 2.5e-9);
  EXPECT_TRUE(built(glass + mesh + "*SECTION_SHELL\n1,2,1.0,3\n5,5,5,5\n").error("needs the thickness of each layer"));
  EXPECT_TRUE(built(glass + "*PART\np\n1,1,4\n*SECTION_SOLID\n1,1\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n"
                            "6,1,0,1\n7,1,1,1\n8,0,1,1\n*ELEMENT_SOLID\n1,1\n1,2,3,4,5,6,7,8\n")
                  .error("is a law of shells", "mid"));
}

}  // namespace
}  // namespace nugget::reading
