// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "deck/deck.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/build.hpp"
#include "small_model.hpp"

// Cards of rolled sheets.
namespace nugget::reading {
namespace {

Built built(const std::string& more) {
  return Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + more);
}
/// *MAT_036 with what follows E and PR on its first card, and its second from LCID on.
Built barlat(const std::string& hardening, const std::string& more = "", const std::string& third = "") {
  return built("*MAT_036\n1,7.85e-9,210000.0,0.3," + hardening + "\n8.0,0.7,0.5,0.8," + more + "\n" + third + "\n\n\n");
}
const kernel::AnisotropicSheet& sheet(const Built& b) {
  const auto& law = std::get<kernel::ComposedLaw>(b.model.materials.at(0).law);
  return std::get<kernel::AnisotropicSheet>(law.components->flow);
}
/// Yield stress of its formula at a plastic strain.
double yield(const Built& b, double strain) {
  const kernel::SheetYield formula(std::get<kernel::SheetFormula>(sheet(b).hardening));
  return formula.yield({strain, 0.0, formula.power(strain), 0.0}).value;
}

TEST(SheetMaterials, HardenByTheirRule) {
  const auto linear = barlat("1,1000.0,250.0");
  EXPECT_EQ(linear.findings.errors(), 0) << linear.all_findings();
  EXPECT_NEAR(yield(linear, 0.1), 250.0 + 0.1 * 210000.0 * 1000.0 / 209000.0, 1e-9);
  const auto swift = barlat("2,550.0,0.2", ",0.004");
  EXPECT_NEAR(yield(swift, 0.1), 550.0 * std::pow(0.104, 0.2), 1e-9);
  const auto by_stress = barlat("2,550.0,0.2", ",,250.0");
  EXPECT_NEAR(yield(by_stress, 0.0), 250.0, 1e-9);
  const auto by_modulus = barlat("2,550.0,0.2");
  EXPECT_NEAR(yield(by_modulus, 0.0), 210000.0 * std::pow(210000.0 / 550.0, 1.0 / (0.2 - 1.0)), 1e-6);
  const auto voce = barlat("4,400.0,12.0", ",150.0");
  EXPECT_NEAR(yield(voce, 0.1), 400.0 - 150.0 * std::exp(-1.2), 1e-9);
  const auto gosh = barlat("5,700.0,0.3", ",0.01,,100.0");
  EXPECT_NEAR(yield(gosh, 0.1), 700.0 * std::pow(0.11, 0.3) - 100.0, 1e-9);
  const auto sherby = barlat("6,400.0,12.0", ",150.0,,0.8");
  EXPECT_NEAR(yield(sherby, 0.1), 400.0 - 150.0 * std::exp(-12.0 * std::pow(0.1, 0.8)), 1e-9);
}

TEST(SheetMaterials, TakeACurveOrATable) {
  const auto curve = barlat("3", "10", ",40.0,5.0");
  EXPECT_TRUE(curve.error("not defined", "lcid")) << curve.all_findings();
  const std::string curves = "*DEFINE_CURVE\n11\n0.0,250.0\n1.0,600.0\n*DEFINE_CURVE\n12\n0.0,300.0\n1.0,700.0\n";
  const auto given = built("*MAT_036\n1,7.85e-9,210000.0,0.3,3\n8.0,0.7,0.5,0.8,11\n,40.0,5.0\n\n\n" + curves);
  EXPECT_EQ(given.findings.errors(), 0) << given.all_findings();
  const auto& hardening = std::get<kernel::PiecewiseLinear>(sheet(given).hardening);
  EXPECT_EQ(hardening.yield.at(0).id, 11);
  EXPECT_DOUBLE_EQ(hardening.rate_c, 40.0);
  const auto table = built("*MAT_036\n1,7.85e-9,210000.0,0.3,3\n8.0,0.7,0.5,0.8,20\n,40.0,5.0\n\n\n" + curves +
                           "*DEFINE_TABLE_2D\n20\n0.0,11\n100.0,12\n");
  EXPECT_EQ(table.findings.errors(), 0) << table.all_findings();
  EXPECT_TRUE(table.warning("the rates are those of the table", "c")) << table.all_findings();
  EXPECT_EQ(std::get<kernel::PiecewiseLinear>(sheet(table).hardening).rates.size(), 2U);
}

TEST(SheetMaterials, AxesAndSurface) {
  const auto b =
      built("*MAT_036\n1,7.85e-9,210000.0,0.3,1,0.0,250.0\n6.0,1.1,0.9,1.05\n3,,,,,1.2\n\n0.0,1.0,0.0,,,,30.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(sheet(b).surface.A, 1.1);
  EXPECT_DOUBLE_EQ(sheet(b).surface.C, 0.9);
  EXPECT_DOUBLE_EQ(sheet(b).surface.H, 1.05);
  EXPECT_DOUBLE_EQ(sheet(b).surface.P, 1.2);
  EXPECT_EQ(sheet(b).axes.by, kernel::MaterialAxes::By::cross);
  EXPECT_DOUBLE_EQ(sheet(b).axes.a.y, 1.0);
  EXPECT_NEAR(sheet(b).axes.angle, std::acos(-1.0) / 6.0, 1e-12);
}

// P2, E0, SPI, P3 of a deck in t, mm, s that is included into one in kg, mm, ms: stresses in GPa where HR says
// stresses.
TEST(SheetMaterials, BringStressesIntoTheUnitsOfTheModel) {
  struct Case {
    const char *hardening, *more;
  };
  for (const Case& c : {Case{"1,1000.0,250.0", ""}, Case{"2,550.0,0.2", ",0.004"}, Case{"2,550.0,0.2", ",,250.0"},
                        Case{"2,550.0,0.2", ",,0.01"}, Case{"4,400.0,12.0", ",150.0"},
                        Case{"5,700.0,0.3", ",0.01,,100.0"}, Case{"6,400.0,12.0", ",150.0,,0.8"}}) {
    const std::string cards =
        std::string("*MAT_036\n1,7.85e-9,210000.0,0.3,") + c.hardening + "\n8.0,0.7,0.5,0.8," + c.more + "\n\n\n\n";
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "sheet_units";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "sheet.k") << "*KEYWORD\n" << cards << "*END\n";
    std::ofstream(folder / "model.k")
        << "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*INCLUDE_TRANSFORM\nsheet.k\n\n\n1000.0,1000.0,1.0\n\n*END\n";
    Findings findings;
    const deck::Deck deck = deck::read(folder / "model.k", findings);
    const model::Model model = reading::build(deck, findings, false);
    ASSERT_EQ(findings.errors(), 0) << c.hardening;
    const auto& law = std::get<kernel::ComposedLaw>(model.materials.at(0).law);
    const kernel::SheetYield formula(
        std::get<kernel::SheetFormula>(std::get<kernel::AnisotropicSheet>(law.components->flow).hardening));
    const double in_gpa = formula.yield({0.1, 0.0, formula.power(0.1), 0.0}).value;
    EXPECT_NEAR(in_gpa, 1e-3 * yield(built(cards), 0.1), 1e-9 * in_gpa) << c.hardening << c.more;
  }
}

TEST(SheetMaterials, RefuseWhatIsNotBuiltOrWrong) {
  EXPECT_TRUE(barlat("7").error("expected 1 to 6", "hr"));
  EXPECT_TRUE(barlat("1.5").error("whole number", "hr"));
  EXPECT_TRUE(barlat("1,210000.0,250.0").error("below E", "p1"));
  EXPECT_TRUE(barlat("1,0.0,-1.0").error("yield stress above 0", "p2"));
  EXPECT_TRUE(barlat("2,550.0,1.2").error("between 0 and 1", "p2"));
  EXPECT_TRUE(barlat("3").error("needs a curve", "lcid"));
  EXPECT_TRUE(barlat("4,100.0,12.0", ",150.0").error("a - b is not above 0", "p1"));
  EXPECT_TRUE(barlat("5,700.0,0.3").error("needs e0", "e0"));
  EXPECT_TRUE(barlat("6,400.0,12.0", ",150.0").error("exponent n", "p3"));
  EXPECT_TRUE(built("*MAT_036\n1,7.85e-9,210000.0,0.3,1,0.0,250.0\n1.5,0.7,0.5,0.8\n\n\n\n\n")
                  .error("expected 2 or more", "m"));
  const auto kinematic =
      built("*MAT_036\n1,7.85e-9,210000.0,0.3,1,0.0,250.0\n-8.0,0.7,0.5,0.8\n1.0,40.0\n3\n\n0.0,1.0,0.0\n");
  EXPECT_TRUE(kinematic.error("kinematic hardening (CRC, CRA) is not built", "m")) << kinematic.all_findings();
  EXPECT_EQ(kinematic.findings.errors(), 1) << kinematic.all_findings();
  EXPECT_TRUE(built("*MAT_122\n1,7.85e-9,210000.0,0.3,1,0.0,250.0\n-1.0,0.5,0.8\n\n\n\n").error("more than 0", "r00"));
  EXPECT_TRUE(built("*MAT_037\n1,7.85e-9,210000.0,0.3,,,1.4\n").error("must be given", "sigy"));
  EXPECT_TRUE(built("*MAT_037\n1,7.85e-9,210000.0,0.3,250.0,-100.0,1.4\n").error("expected 0 or more", "etan"));
}

}  // namespace
}  // namespace nugget::reading
