// SPDX-License-Identifier: Apache-2.0
// *ELEMENT_TSHELL, *SECTION_TSHELL and what of them is refused.
#include <gmock/gmock.h>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

/// A thick shell 7 of part 10, and a wedge 8 beside it.
std::string deck(const std::string& section, const std::string& more = {}, const std::string& elements = {}) {
  std::string text = "*PART\nplate\n        10         7         8\n*SECTION_TSHELL\n" + section +
                     "*MAT_ELASTIC\n         8  7.85E-09  210000.0       0.3\n*NODE\n";
  const double place[][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}, {15, 5}};
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < 5; ++i) {
      char line[80];
      std::snprintf(line, sizeof line, "%8d%16.1f%16.1f%16.1f\n", 101 + i + 10 * k, place[i][0], place[i][1],
                    20.0 + 2 * k);
      text += line;
    }
  text += elements.empty() ? "*ELEMENT_TSHELL\n"
                             "       7      10     101     102     103     104     111     112     113     114\n"
                             "       8      10     102     105     103     103     112     115     113     113\n"
                           : elements;
  return small_deck(text + more);
}

const std::string usual = "         7         5                   5\n";

TEST(ThickShellCards, AreRead) {
  const Built built(deck(usual));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const Model& m = built.model;
  ASSERT_EQ(m.solids.size(), 2u);
  EXPECT_TRUE(m.has_thick_shells(m.part_index(10)));
  EXPECT_FALSE(m.has_thick_shells(m.part_index(1)));
  EXPECT_EQ(m.solids.corners(1).size(), 6u);
  const auto& thickness = m.solid_sections[m.parts[m.part_index(10)].section].thickness;
  ASSERT_TRUE(thickness);
  EXPECT_EQ(thickness->layers, 5);
  EXPECT_FALSE(thickness->trapezoidal);
  EXPECT_TRUE(thickness->parabolic_shear);

  const Built other(deck("         7         5     0.833         4                   1                   1\n"));
  ASSERT_EQ(other.findings.errors(), 0) << other.all_findings();
  const auto& made = other.model.solid_sections[0].thickness;
  EXPECT_EQ(made->layers, 4);
  EXPECT_TRUE(made->trapezoidal);
  EXPECT_FALSE(made->parabolic_shear);
  EXPECT_DOUBLE_EQ(made->shear_factor, 0.833);
}

TEST(ThickShellCards, WhatIsNotBuiltIsRefusedByField) {
  EXPECT_EQ(Built(deck("         7         3                   5\n")).findings.errors(), 0);
  EXPECT_TRUE(Built(deck("         7         6                   5\n")).error("ELFORM 6 are not built", "elform"));
  EXPECT_TRUE(Built(deck("         7         7                   5\n")).error("ELFORM 7 are not built", "elform"));
  EXPECT_TRUE(Built(deck("         7         5                   1\n")).error("", "nip"));
  EXPECT_TRUE(Built(deck("         7         5                   5                  -3\n")).error("", "qr"));
  EXPECT_TRUE(
      Built(deck("         7         5                   5                             1\n")).error("", "icomp"));
  EXPECT_TRUE(Built(deck("         7         5       0.5         5\n")).error("5/6 of its own", "shrf"));
  EXPECT_FALSE(Built(deck("         7         5    0.8333         5\n")).error("", "shrf"));
  EXPECT_TRUE(Built(deck(usual, "*ELEMENT_TSHELL_BETA\n")).error("angles or layers of their own"));
}

TEST(ThickShellCards, LawsOfShells) {
  const Built of_default(deck("         7                             5\n"));
  ASSERT_EQ(of_default.findings.errors(), 0) << of_default.all_findings();
  const Model& m = of_default.model;
  const SectionSolid& one = m.solid_sections[m.parts[m.part_index(10)].section];
  EXPECT_EQ(one.elform, 1);
  EXPECT_TRUE(one.has_laws_of_shells());
  EXPECT_EQ(one.thickness->shear_factor, 1.0);  // a blank SHRF
  // LS-DYNA gives ELFORM 1 odd numbers of layers.
  for (const auto& [written, layers] : {std::pair{"2", 3}, {"3", 3}, {"4", 5}, {"6", 6}}) {
    const Built built(deck(std::string("         7         1     .8333         ") + written + "\n"));
    EXPECT_EQ(built.findings.errors(), 0) << built.all_findings();
    EXPECT_EQ(built.model.solid_sections[0].thickness->layers, layers);
    EXPECT_NEAR(built.model.solid_sections[0].thickness->shear_factor, 5.0 / 6.0, 1e-3);
  }
  EXPECT_EQ(Built(deck("         7         2                   2\n")).model.solid_sections[0].thickness->layers, 2);
  EXPECT_FALSE(Built(deck("         7         5                   2\n")).model.solid_sections[0].has_laws_of_shells());
}

TEST(ThickShellCards, ElementsAndSectionsGoTogether) {
  const std::string line = "       7      10     101     102     103     104     111     112     113     114\n";
  EXPECT_TRUE(Built(deck(usual, {}, "*ELEMENT_SOLID\n" + line)).error("part 10 has bricks, as solid 7, but section 7"));
  EXPECT_TRUE(Built(deck(usual, {}, "*ELEMENT_TSHELL\n" + line + "*ELEMENT_SOLID\n" + line))
                  .error("of bricks and of thick shells, which share their ids here"));
  std::string of_bricks = deck(usual);
  of_bricks.replace(of_bricks.find("*SECTION_TSHELL"), 15, "*SECTION_SOLID");
  of_bricks.replace(of_bricks.find(usual), usual.size(), "         7         1\n");
  EXPECT_TRUE(Built(of_bricks).error("part 10 has thick shells, as solid 7, but section 7 is of bricks"));
  EXPECT_TRUE(
      Built(deck(usual, {},
                 "*ELEMENT_TSHELL\n       7      10     101     102     103     104       0       0       0       0\n"))
          .error("expected eight nodes of a thick shell"));
}

TEST(ThickShellCards, LawsAndHourglassControl) {
  std::string foam = deck(usual);
  const std::string elastic = "*MAT_ELASTIC\n         8  7.85E-09  210000.0       0.3\n";
  foam.replace(
      foam.find(elastic), elastic.size(),
      "*MAT_ORTHOTROPIC_ELASTIC\n         8   7.8E-09  200000.0   10000.0   10000.0      0.01      0.01      0.01\n"
      "    5000.0    5000.0    5000.0       2.0\n\n       0.0       0.0       0.0       1.0\n       0.0       0.0      "
      " 0.0       0.0       1.0\n");
  EXPECT_TRUE(Built(foam).error("not built for thick shells", "mid")) << Built(foam).all_findings();

  const auto with_control = [](int type, const std::string& section = usual) {
    std::string text = deck(section, "*HOURGLASS\n         3         " + std::to_string(type) + "      0.05\n");
    const std::string part = "        10         7         8\n";
    return text.replace(text.find(part), part.size(), "        10         7         8         0         3\n");
  };
  EXPECT_TRUE(Built(with_control(4)).error("whose stabilisation is that of their assumed strains", "ihq"));
  EXPECT_EQ(Built(with_control(6)).findings.errors(), 0);
  const std::string one = "         7         1                   5\n",
                    full = "         7         2                   5\n";
  for (const int type : {1, 2, 3, 4, 5}) EXPECT_EQ(Built(with_control(type, one)).findings.errors(), 0) << type;
  EXPECT_TRUE(Built(with_control(6, one)).error("hourglass control as shells have it", "ihq"));
  EXPECT_EQ(Built(with_control(4, full)).findings.errors(), 0);
  EXPECT_TRUE(Built(deck(one, "*CONTROL_HOURGLASS\n         6      0.05\n")).warning("they get type 1"));
  EXPECT_TRUE(Built(deck(usual, "*CONTROL_HOURGLASS\n         5      0.05\n")).find(Severity::note, "not type 5"));
}

TEST(ThickShellCards, HistoriesAreOfThickShellsOnly) {
  const Built built(deck(usual, "*DATABASE_HISTORY_TSHELL\n         7\n*DATABASE_HISTORY_SOLID\n         8\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.requests.history_thick_shells.size(), 1u);
  EXPECT_TRUE(built.model.requests.history_solids.empty());
  EXPECT_TRUE(built.warning("solid is not in the model"));
}

}  // namespace
}  // namespace nugget::reading
