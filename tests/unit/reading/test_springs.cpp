// SPDX-License-Identifier: Apache-2.0
// Cards of springs, joints, beams and sensors.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

/// Two nodes, a spring of part 1, and what is given.
std::string spring_deck(const std::string& material, const std::string& section = "1\n\n",
                        const std::string& element = "1,1,1,2\n", const std::string& more = {}) {
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,1.0,0.0,0.0\n*PART\nspring\n1,1,"
         "1\n" +
         material + "*SECTION_DISCRETE\n" + section + "*ELEMENT_DISCRETE\n" + element + more +
         "*ELEMENT_MASS\n1,1,1.0\n2,2,1.0\n3,3,1.0\n*END\n";
}

TEST(Springs, ElementSectionAndOrientation) {
  const Built built(spring_deck("*MAT_SPRING_ELASTIC_TITLE\nk\n1,100.0\n", "1,1,2.0,4.0,0.5,-0.25\n\n",
                                "      11       1       1       2       7             2.5       1            0.25\n"
                                "12,1,2,0,8\n",
                                "*DEFINE_SD_ORIENTATION\n7,1,0.0,0.0,2.0\n8,2,,,,1,2\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const Model& m = built.model;
  ASSERT_EQ(m.discretes.size(), 2u);
  const Discrete& first = m.discretes[0];
  EXPECT_EQ(first.id, 11);
  EXPECT_EQ(first.scale, 2.5);
  EXPECT_EQ(first.offset, 0.25);
  EXPECT_FALSE(first.in_deforc);
  EXPECT_FALSE(first.grounded());
  EXPECT_TRUE(m.discretes[1].grounded());
  EXPECT_EQ(m.discretes[1].scale, 1.0);
  const SpringOrientation& plane = m.spring_orientations[first.orientation];
  EXPECT_TRUE(plane.in_plane);
  EXPECT_EQ(plane.direction.z, 1.0);
  EXPECT_EQ(m.spring_orientations[1].node[1], m.node_index(2));
  const SectionDiscrete& section = m.discrete_sections[0];
  EXPECT_TRUE(section.torsional);
  EXPECT_EQ(section.magnification, 0.5);
  EXPECT_EQ(section.clearance, 0.5);
  EXPECT_EQ(section.failure, -0.25);
  EXPECT_EQ(m.parts[0].kind, ElementKind::discrete);
  EXPECT_EQ(std::get<kernel::Spring>(m.materials[0].law).initial_stiffness(), 100.0);
}

TEST(Springs, FaultsAreNamed) {
  const std::string elastic = "*MAT_S01\n1,100.0\n";
  EXPECT_TRUE(Built(spring_deck(elastic, "1\n\n", "1,1,1,0\n")).error("has no line", "vid"));
  EXPECT_TRUE(Built(spring_deck(elastic, "1\n\n", "1,1,2,3\n")).error("at one place", "vid"));
  EXPECT_TRUE(Built(spring_deck(elastic, "1,0,1.0\n\n")).error("needs the velocity", "v0"));
  EXPECT_TRUE(Built(spring_deck(elastic, "1,1\n0.5\n")).error("stops of torsional springs", "cdl"));
  EXPECT_TRUE(Built(spring_deck(elastic, "1\n\n", "1,1,1,2,4\n")).error("orientation 4 is not defined", "vid"));
  EXPECT_TRUE(Built(spring_deck("*MAT_ELASTIC\n1,1e-9,1.0,0.3\n")).error("not a law of springs", "mid"));
  EXPECT_TRUE(Built(spring_deck("*MAT_S03\n1,10.0,20.0,5.0\n")).error("less than the elastic", "kt"));
  EXPECT_TRUE(Built(spring_deck("*MAT_S07\n1,10.0,2.0,5.0,1.0\n")).error("needs the force", "fc"));
  EXPECT_TRUE(Built(spring_deck("*MAT_SPRING_MUSCLE\n1\n"))
                  .error("this law of springs is not built; built are *MAT_SPRING_ELASTIC, _ELASTOPLASTIC"));
  const std::string curves = "*DEFINE_CURVE\n1\n-1.0,-5.0\n1.0,5.0\n*DEFINE_CURVE\n2\n-1.0,-5.0\n0.0,0.0\n1.0,0.0\n";
  EXPECT_TRUE(Built(spring_deck("*MAT_S06\n1,1,1,2.0,1.0,-1.0\n" + curves)).error("kinematic", "beta"));
  EXPECT_TRUE(Built(spring_deck("*MAT_S06\n1,1,2,0.0,1.0,-1.0\n" + curves)).error("must rise", "lcdu"));
  EXPECT_TRUE(Built(spring_deck("*MAT_S08\n1,1\n" + curves)).error("positive quadrant", "lcfd"));
}

/// A beam between nodes 1 and 2 with the section's cards and the third node.
Built beam(const std::string& section, const std::string& material, const std::string& third = "3") {
  return Built(
      "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*NODE\n1,0.0,0.0,0.0\n2,1.0,0.0,0.0\n3,0.0,1.0,0.0\n4,2.0,0.0,0.0\n"
      "*PART\nbeam\n1,1,1\n*SECTION_BEAM\n" +
      section + material + "*ELEMENT_BEAM\n1,1,1,2," + third + "\n*END\n");
}

TEST(Beams, SectionsOfTheStructure) {
  const std::string elastic = "*MAT_ELASTIC\n1,1.0,1.0,0.3\n", plastic = "*MAT_024\n1,1.0,1.0,0.3,0.1\n\n";
  const Built integrated = beam("1,1,,5\n0.2,,0.1,,1.0\n", plastic);
  ASSERT_EQ(integrated.findings.errors(), 0) << integrated.all_findings();
  EXPECT_EQ(integrated.model.beam_sections[0].outer[1], 0.2);
  EXPECT_EQ(integrated.model.beam_sections[0].inner[1], 0.1);
  EXPECT_EQ(integrated.model.beam_sections[0].location[0], 1.0);
  const Built resultant = beam("1,2\n0.5,0.1\n", elastic, "0");
  ASSERT_EQ(resultant.findings.errors(), 0) << resultant.all_findings();
  EXPECT_EQ(resultant.model.beam_sections[0].moment_t, 0.1);
  EXPECT_EQ(resultant.model.beam_sections[0].torsion_constant, 0.2);

  EXPECT_TRUE(beam("1,1\n0.2,,0.1\n", elastic, "0").error("no third node off its line"));
  EXPECT_TRUE(beam("1,1\n0.2,,0.1\n", elastic, "4").error("no third node off its line"));
  EXPECT_TRUE(beam("1,2\n0.5,0.1\n", plastic).error("elastic here", "mid"));
  EXPECT_TRUE(beam("1,3\n\n", elastic).error("must be given", "a"));
  EXPECT_TRUE(beam("1,4\n0.2\n", elastic).error("beam formulation 4 is not built", "elform"));
}

/// One beam with a _THICKNESS card of its own, in fields of 16.
Built single(const std::string& section, const std::string& material, std::initializer_list<double> values) {
  std::string card;
  for (const double v : values) card += fmt::format("{:16}", v);
  return beam(section, material + "*DEFINE_COORDINATE_VECTOR\n7,1.0,0.0,0.0,0.0,1.0,0.0\n" +
                           "*ELEMENT_BEAM_THICKNESS\n2,1,2,4,3\n" + card + "\n");
}

TEST(Beams, CrossSectionsOfSingleBeams) {
  const std::string elastic = "*MAT_ELASTIC\n1,1.0,1.0,0.3\n", square = "1,2\n0.5,0.1,0.2,0.3,0.4\n";
  const auto errors = [](const Built& b) { return b.findings.errors(); };
  EXPECT_EQ(errors(single(square, elastic, {0.5, 0.1, 0.2, 0.3, 0.4})), 0);
  EXPECT_EQ(errors(single(square, elastic, {0.5})), 0);
  const Built torsion = single(square, elastic, {0.5, 0.1, 0.2, 0.31, 0.4});
  EXPECT_TRUE(torsion.error("beam 2: parm4 = 0.31 differs from J = 0.3 of section 1")) << torsion.all_findings();
  EXPECT_TRUE(single(square, elastic, {0.5, 0.1, 0.2, 0.3, 0.5}).error("parm5 = 0.5 differs from SA = 0.4"));
  EXPECT_EQ(errors(single("1,3\n0.5\n", elastic, {0.5, 9.0})), 0);  // nothing else is used of a truss
  EXPECT_TRUE(single("1,3\n0.5\n", elastic, {0.6}).error("parm1 = 0.6 differs from A = 0.5"));
  EXPECT_TRUE(single("1,1\n0.2,,0.1\n", elastic, {0.2, 0.2, 0.15}).error("parm3 = 0.15 differs from TT1 = 0.1"));
  const std::string linear = "*MAT_LINEAR_ELASTIC_DISCRETE_BEAM\n1,1.0,1.0,1.0,1.0,1.0,1.0,1.0\n\n";
  EXPECT_EQ(errors(single("1,6\n0.5,0.1,7\n", linear, {0.5, 0.1, 7.0})), 0);
  EXPECT_TRUE(single("1,6\n0.5,0.1\n", linear, {0.5, 0.1, 7.0}).error("parm3 = 7 differs from CID = 0"));
}

}  // namespace
}  // namespace nugget::reading
