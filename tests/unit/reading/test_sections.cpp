// SPDX-License-Identifier: Apache-2.0
// Cross sections, groups of nodes, damping and initial states as cards.
#include <gmock/gmock.h>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

constexpr const char* shells_one = "*SET_SHELL_LIST\n         4\n         1\n";

TEST(CrossSection, BySetsTakesTheElementsAndTheSideBetweenTheNodes) {
  const Built built(small_deck(std::string(shells_one) + R"(*SET_NODE_LIST
         9
         2         3
*DATABASE_CROSS_SECTION_SET_ID
        12front rail
         9                             4
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& sections = built.model.requests.cross_sections;
  ASSERT_EQ(sections.size(), 1u);
  EXPECT_EQ(sections[0].id, 12);
  EXPECT_EQ(sections[0].title, "front rail");
  EXPECT_THAT(sections[0].nodes, ElementsAre(1, 2));
  ASSERT_EQ(sections[0].facets.size(), 1u);
  EXPECT_EQ(sections[0].facets[0].kind, ElementKind::shell);
  ASSERT_EQ(sections[0].facets[0].corners.size(), 2u);
  EXPECT_EQ(sections[0].system, none);
}

TEST(CrossSection, ByAPlaneCutsDeformableElementsAndTakesTheNodesBeyond) {
  const Built built(small_deck(R"(*DATABASE_CROSS_SECTION_PLANE
         0      0.25       0.0       0.0       1.0       0.0       0.0
*DATABASE_CROSS_SECTION_PLANE
         0       2.5       0.0       0.0       3.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& sections = built.model.requests.cross_sections;
  ASSERT_EQ(sections.size(), 2u);
  EXPECT_EQ(sections[0].id, 1) << "without _ID sections are numbered";
  EXPECT_TRUE(sections[1].facets.empty()) << "the second plane cuts a rigid part only";
  EXPECT_THAT(sections[1].parts, ElementsAre(0));
  EXPECT_THAT(sections[0].nodes, ElementsAre(1, 2));
  ASSERT_EQ(sections[0].facets[0].corners.size(), 2u);
  EXPECT_DOUBLE_EQ(sections[0].facets[0].corners[0].share, 0.25);
}

TEST(CrossSection, WhatIsNotThereIsRefused) {
  const auto with = [](std::string_view fields) {
    return Built(small_deck(std::string(shells_one) + "*DATABASE_CROSS_SECTION_SET\n" + std::string(fields) + '\n'));
  };
  EXPECT_TRUE(with("         1                             4         7").error("thick shells", "tsid"));
  EXPECT_TRUE(with("         1                             4                   0         1         1")
                  .error("accelerometer 1 is not defined", "id"));
  EXPECT_TRUE(with("         1                             4                             2").error("principal", "id"));
  EXPECT_TRUE(with("        77                             4").error("not defined", "nsid"));
  const Built flat(small_deck("*DATABASE_CROSS_SECTION_PLANE\n         0       1.0       0.0       0.0       1.0\n\n"));
  EXPECT_TRUE(flat.error("no normal", "xch"));
}

TEST(NodalForceGroup, NamesASet) {
  const Built built(small_deck("*DATABASE_NODAL_FORCE_GROUP\n         1\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.requests.nodal_force_groups.size(), 1u);
  EXPECT_EQ(built.model.requests.nodal_force_groups[0].set_id, 1);
  EXPECT_THAT(built.model.requests.nodal_force_groups[0].nodes, ElementsAre(0, 1, 2));
}

TEST(Damping, CardsSayWhatIsDamped) {
  const Built built(small_deck(R"(*DAMPING_GLOBAL
         0      12.0       1.0
*DAMPING_PART_MASS
         1         7       2.0         1
       0.0       0.0       3.0
*DAMPING_PART_STIFFNESS
         1       0.1
         1     -1e-6
         2       0.1
*DAMPING_FREQUENCY_RANGE
      0.01      10.0     300.0         1
*DAMPING_RELATIVE
      0.05      20.0         2         1       0.5         7
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const Damping& damping = built.model.damping;
  ASSERT_EQ(damping.mass.size(), 2u);
  EXPECT_TRUE(damping.mass[0].everything);
  EXPECT_EQ(damping.mass[0].factor, 12.0);
  EXPECT_EQ(damping.mass[0].scale.x, 1.0);
  EXPECT_EQ(damping.mass[0].scale.y, 0.0) << "one scale given: the others are what they say";
  EXPECT_EQ(damping.mass[1].part, 0);
  EXPECT_EQ(damping.mass[1].factor, 2.0);
  EXPECT_EQ(damping.mass[1].scale.z, 3.0);
  ASSERT_EQ(damping.stiffness.size(), 1u) << "the last of a part holds; a rigid part has no stiffness";
  EXPECT_EQ(damping.stiffness[0].time, 1e-6);
  EXPECT_EQ(damping.stiffness[0].share, 0.0);
  ASSERT_EQ(damping.range.size(), 1u);
  EXPECT_EQ(damping.range[0].high, 300.0);
  ASSERT_EQ(damping.relative.size(), 1u);
  EXPECT_EQ(damping.relative[0].quadratic, 0.5);
}

TEST(Damping, OfDeformationKnowsItsParts) {
  const Built built(
      small_deck("*DAMPING_FREQUENCY_RANGE_DEFORM\n      0.01      10.0     300.0         0                   2\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  EXPECT_TRUE(built.warning("does nothing", "pidrel"));
  ASSERT_EQ(built.model.damping.range.size(), 1u);
  EXPECT_TRUE(built.model.damping.range[0].deform);
  EXPECT_EQ(built.model.damping.range[0].parts.size(), built.model.parts.size());
}

TEST(Damping, WhatIsNotBuiltIsRefused) {
  EXPECT_TRUE(Built(small_deck("*DAMPING_FREQUENCY_RANGE\n      0.01     300.0      10.0\n")).error("swap", "fhigh"));
  EXPECT_TRUE(Built(small_deck("*DAMPING_PART_STIFFNESS\n         1       3.0\n")).error("critical", "coef"));
  EXPECT_TRUE(Built(small_deck("*DAMPING_MODAL\n")).error("not built"));
}

TEST(InitialStress, OfShellsInBothFormats) {
  const Built built(small_deck(R"(*INITIAL_STRESS_SHELL
         1         1         2         9         0         0
      -0.5      10.0      20.0       0.0       1.0       2.0       3.0       0.1
       1.0
       2.0
       0.5      30.0      40.0
       1.0
       2.0
*INITIAL_STRESS_SHELL
         1         1         1         0         0         1
             0.0            11.0            12.0            13.0            14.0
            15.0            16.0            0.25
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& shells = built.model.initial_state.shells;
  ASSERT_EQ(shells.size(), 2u);
  ASSERT_EQ(shells[0].points.size(), 2u);
  EXPECT_EQ(shells[0].points[0].zeta, -0.5);
  EXPECT_THAT(shells[0].points[0].stress, ElementsAre(10, 20, 0, 1, 2, 3));
  EXPECT_EQ(shells[0].points[0].plastic_strain, 0.1);
  EXPECT_EQ(shells[0].points[1].stress[1], 40.0);
  EXPECT_TRUE(built.warning("not taken over", "nhisv"));
  EXPECT_THAT(shells[1].points[0].stress, ElementsAre(11, 12, 13, 14, 15, 16));
  EXPECT_EQ(shells[1].points[0].plastic_strain, 0.25);
}

// With LARGE the history of a brick begins behind its plastic strain. Sabotage: on a line of its own, as that of
// shells, which loses every second brick (as it was).
TEST(InitialStress, OfBricksWithHistory) {
  std::string text = R"(*PART
block
        90        90         1
*SECTION_SOLID
        90         1
*NODE
     101             0.0             0.0             0.0
     102             1.0             0.0             0.0
     103             1.0             1.0             0.0
     104             0.0             1.0             0.0
     105             0.0             0.0             1.0
     106             1.0             0.0             1.0
     107             1.0             1.0             1.0
     108             0.0             1.0             1.0
*ELEMENT_SOLID
      91      90     101     102     103     104     105     106     107     108
*INITIAL_STRESS_SOLID
)";
  for (const int history : {2, 3, 8}) {
    text += "        91         1" + std::string(9, ' ') + std::to_string(history) + "         1\n";
    for (int value = 1; value <= 7 + history; ++value) {
      text += std::string(15, ' ') + std::to_string(value % 10);
      if (value % 5 == 0 || value == 7 + history) text += '\n';
    }
  }
  const Built built(small_deck(text));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  EXPECT_FALSE(built.warning("stands behind")) << built.all_findings();
  EXPECT_TRUE(built.warning("not taken over", "nhisv"));
  ASSERT_EQ(built.model.initial_state.solids.size(), 3u);
  for (const InitialStress& stress : built.model.initial_state.solids) {
    EXPECT_THAT(stress.points.at(0).stress, ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_EQ(stress.points[0].plastic_strain, 7.0);
  }
}

// Sabotage: points that are not there as zeros, places that are not given without a word (both as it was).
TEST(InitialStress, PointsAndPlacesThatAreMissing) {
  const std::string card = "*INITIAL_STRESS_SHELL\n         1         1         2\n";
  EXPECT_TRUE(Built(small_deck(card + "      -0.5      10.0\n")).error("the keyword ends after 1", "nthick"));
  EXPECT_TRUE(Built(small_deck(card + "                10.0\n                20.0\n"))
                  .warning("at 1 different place T", "nthick"));
  const std::string strain = "*INITIAL_STRAIN_SHELL\n";
  EXPECT_TRUE(Built(small_deck(strain + "         1         1         3\n       0.1\n       0.2\n"))
                  .error("the keyword ends after 2", "nthick"));
  EXPECT_TRUE(Built(small_deck(strain + "         1" + std::string(68, ' ') + "1\n       0.1\n"))
                  .error("strains in the axes of the element", "ilocal"));
}

// The card without counts, and without places: the lower and the upper point. Sabotage: the second as another shell,
// the first as both (as it was).
TEST(InitialStrain, OfTheLowerAndTheUpperPoint) {
  for (const char* counts : {"         1", "         1         1         2"}) {
    const Built built(
        small_deck(std::string("*INITIAL_STRAIN_SHELL\n") + counts + "\n       0.1\n       0.2       0.3\n"));
    ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
    ASSERT_EQ(built.model.initial_state.shell_strains.size(), 1u);
    const InitialStrain& strain = built.model.initial_state.shell_strains[0];
    EXPECT_THAT(strain.lower, ElementsAre(0.1, 0, 0, 0, 0, 0));
    EXPECT_THAT(strain.upper, ElementsAre(0.2, 0.3, 0, 0, 0, 0));
  }
}

TEST(InitialStress, OfASectionNeedsTheSection) {
  EXPECT_TRUE(Built(small_deck("*INITIAL_STRESS_SECTION\n         1        12         7\n"))
                  .error("cross section 12 is not defined", "csid"));
}

TEST(Erosion, FieldsAreRead) {
  const Built built(small_deck(R"(*CONTROL_TIMESTEP
       0.0       0.9         0       0.0       0.0         0        11
*CONTROL_SOLID
                                                 1
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  EXPECT_EQ(built.model.control.erode_small_steps, 11);
  EXPECT_THAT(built.model.control.eroding_parts, ElementsAre(0));
}

}  // namespace
}  // namespace nugget::reading
