// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "model/lumped_mass.hpp"
#include "small_model.hpp"

namespace nugget::reading {
namespace {

/// Comma format; a sheet of part 1 (nodes 1..4), `more` behind it.
std::string sheet_deck(const std::string& more) {
  return R"(*KEYWORD
*CONTROL_TERMINATION
1.0
*NODE
1,0.0,0.0,0.0
2,1.0,0.0,0.0
3,1.0,1.0,0.0
4,0.0,1.0,0.0
5,0.0,0.0,1.0
6,1.0,0.0,1.0
7,1.0,1.0,1.0
8,0.0,1.0,1.0
*PART
sheet
1,1,1
*SECTION_SHELL
1,2
1.0
*MAT_ELASTIC
1,7.85e-9,210000.0,0.3
*ELEMENT_SHELL
1,1,1,2,3,4
)" + more;
}

const char* const brick_part = "*PART\nblock\n2,2,1\n*SECTION_SOLID\n2,1\n";

TEST(Checks, ShapesOfShells) {
  const Built b(
      sheet_deck("*ELEMENT_SHELL\n2,1,1,2,11,3\n3,1,1,2,7,4\n*NODE\n9,2.0,0.0,0.0\n10,3.0,0.0,0.0\n11,-1.0,1.0,0.0\n"
                 "*ELEMENT_SHELL\n4,1,1,2,9,10\n5,1,1,3,1,2\n"));
  EXPECT_TRUE(b.error("the sides of shell 2 cross each other")) << b.all_findings();
  EXPECT_TRUE(b.warning("shell 3 is warped by"));
  EXPECT_TRUE(b.error("shell 4 has no area"));
  EXPECT_TRUE(b.error("three or four different ones in sequence"));
  EXPECT_FALSE(b.error("shell 1 ")) << b.all_findings();
}

TEST(Checks, WarpageLimitIsThatOfTheDeck) {
  EXPECT_FALSE(Built(sheet_deck("*ELEMENT_SHELL\n3,1,1,2,7,4\n*CONTROL_SHELL\n179.0\n")).warning("is warped"));
}

TEST(Checks, ThicknessMustBePositive) {
  const Built none_given(sheet_deck("*PART\nthin\n2,2,1\n*SECTION_SHELL\n2,2\n\n*ELEMENT_SHELL\n2,2,5,6,7,8\n"));
  EXPECT_TRUE(
      none_given.error("section 2: thickness 0, expected more than 0: 1 shells take theirs from it, the first is 2"))
      << none_given.all_findings();
  const Built negative(sheet_deck("*SECTION_SHELL\n2,2\n-1.0\n"));
  EXPECT_TRUE(negative.error("expected 0 or more", "t1")) << negative.all_findings();
}

TEST(Checks, JacobiansOfBricks) {
  const Built b(sheet_deck(std::string(brick_part) + "*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n2,2,5,6,7,8,1,2,3,4\n"
                                                     "*NODE\n9,0.9,0.9,0.2\n*ELEMENT_SOLID\n3,2,1,2,3,4,5,6,9,8\n"
                                                     "*NODE\n10,0.1,0.1,0.9\n*ELEMENT_SOLID\n4,2,1,2,3,4,5,6,10,8\n"));
  EXPECT_FALSE(b.error("solid 1 ")) << b.all_findings();
  EXPECT_TRUE(b.error("solid 2 has the volume -1, expected more than 0 (negative Jacobian)"));
  EXPECT_TRUE(b.warning("solid 4 is turned inside out at a corner")) << b.all_findings();
}

// A mirrored mesh: all solids of a part are inside out, which has one remedy. A part that has others is refused, and so
// is a single brick. Sabotage: bricks turned one by one.
TEST(Checks, PartsInsideOutAreTurned) {
  const std::string part = std::string(brick_part);
  const Built brick(sheet_deck(part + "*ELEMENT_SOLID\n1,2,5,6,7,8,1,2,3,4\n"));
  EXPECT_TRUE(brick.error("negative Jacobian")) << brick.all_findings();
  const Built two(sheet_deck(part + "*NODE\n11,0,0,2\n12,1,0,2\n13,1,1,2\n14,0,1,2\n"
                                    "*ELEMENT_SOLID\n1,2,5,6,7,8,1,2,3,4\n2,2,11,12,13,14,5,6,7,8\n"));
  EXPECT_EQ(two.findings.errors(), 0) << two.all_findings();
  EXPECT_TRUE(two.warning("part 2: all of its 2 solids are numbered inside out")) << two.all_findings();
  for (const std::size_t e : {0u, 1u}) EXPECT_NEAR(model::solid_volume(two.model, e), 1.0, 1e-12);
  const auto volumes = [](const Built& b, double expected) {
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    EXPECT_TRUE(b.warning("all of its 2 solids are numbered inside out")) << b.all_findings();
    for (const std::size_t e : {0u, 1u}) EXPECT_NEAR(model::solid_volume(b.model, e), expected, 1e-12);
  };
  volumes(Built(sheet_deck(part + "*ELEMENT_SOLID\n1,2,2,1,4,3,5,5,8,8\n2,2,2,1,4,3,6,6,7,7\n")), 0.5);
  volumes(Built(sheet_deck("*PART\nblock\n2,2,1\n*SECTION_SOLID\n2,10\n*ELEMENT_SOLID\n1,2,2,1,4,5,5,5,5,5\n"
                           "2,2,2,4,3,7,7,7,7,7\n")),
          1.0 / 6.0);
}

// Fields that public models of human bodies give: each where it has no effect here, or is what is done in any case, and
// where it is not.
TEST(Checks, FieldsOfHumanBodyModels) {
  const auto has = [](const std::string& more, std::string_view text, std::string_view field) {
    return Built(sheet_deck(more)).error(std::string(text), std::string(field));
  };
  const std::string brick = "*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n";
  const Built ambient(sheet_deck("*PART\nblock\n2,2,1\n*SECTION_SOLID\n2,1,1\n*CONTROL_SOLID\n4\n" + brick));
  EXPECT_EQ(ambient.findings.errors(), 0) << ambient.all_findings();
  EXPECT_TRUE(ambient.model.control.sort_solids);
  EXPECT_TRUE(has("*CONTROL_SOLID\n11\n", "expected 0 to 4", "esort"));

  const std::string interpolation = "*CONSTRAINED_INTERPOLATION\n1,5,123\n2\n3\n1,";
  EXPECT_FALSE(has(interpolation + "123,1.0,1.0,1.0,1.0,1.0,1.0\n", "", "rwghtx"));
  EXPECT_TRUE(has(interpolation + ",1.0,1.0,1.0,1.0\n", "rotations of the independent nodes", "rwghtx"));

  const std::string tie = "*SET_NODE_LIST\n9\n5,6,7\n*CONTACT_TIED_NODES_TO_SURFACE_OFFSET\n9,1,4,3\n\n\n\n\n\n,,,,,,";
  EXPECT_FALSE(has(tie + "1\n", "", "tiedid"));
  EXPECT_TRUE(has(tie + "2\n", "expected 0 to 1", "tiedid"));

  // The title is a line of its own: what follows is the card.
  EXPECT_TRUE(has("*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED_TITLE\nwrist\n3,8,9,1,1\n\n\n\n", "8", "pida"));

  const auto rubber = [](const char* poisson) {
    return std::string("*MAT_OGDEN_RUBBER\n7,1e-9,") + poisson + "\n1.0\n2.0\n";
  };
  EXPECT_FALSE(has(rubber("0.4999983"), "", "pr"));
  EXPECT_TRUE(has(rubber("0.5"), "expected 0 to 0.499999", "pr"));
}

TEST(Checks, ManyFaultsOfOneKindAreCounted) {
  std::string rows = "*ELEMENT_SHELL\n";
  for (int id = 100; id < 10130; ++id) rows += std::to_string(id) + ",1,1,2,4,3\n";
  const Built b(sheet_deck(rows));
  EXPECT_EQ(b.findings.errors(), 10001);
  EXPECT_TRUE(b.error("and 30 more of this kind"));
}

TEST(Checks, FormulationsAreRefusedByName) {
  const Built b(
      sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12,3\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n"
                 "*PART\nb\n3,13,1\n*SECTION_SOLID\n13,5\n*ELEMENT_SOLID\n1,3,1,2,3,4,5,6,7,8\n"
                 "*PART\nc\n4,14,2\n*SECTION_BEAM\n14,6\n1.0,1.0\n*MAT_SPOTWELD\n2,7.85e-9,210000.0,0.3,400.0\n"
                 "*ELEMENT_BEAM\n1,4,1,5\n"));
  const Finding* shell = b.find(Severity::error, "shell formulation 3 is not built", "elform");
  ASSERT_NE(shell, nullptr) << b.all_findings();
  EXPECT_EQ(shell->value, "3");
  EXPECT_TRUE(b.error("solid formulation 5 is not built", "elform"));
  const Built plane(sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12,15\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n"));
  EXPECT_TRUE(plane.error("formulation 15 is an axisymmetric solid; models in two dimensions", "elform"));
  EXPECT_TRUE(b.error("not a law of discrete beams (ELFORM 6)", "mid"));
}

// One layer, whatever NIP; nodes without rotations but where other shells have them.
TEST(Checks, MembranesHaveOneLayer) {
  for (const char* const elform : {"5", "9"}) {
    const Built b(sheet_deck(std::string("*PART\na\n2,12,1\n*SECTION_SHELL\n12,") + elform +
                             ",,4\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n"));
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    const Index part = b.model.part_index(2);
    EXPECT_EQ(b.model.shell_sections[b.model.parts[part].section].layers, 1);
    EXPECT_TRUE(b.model.has_membranes(part));
    EXPECT_FALSE(b.model.has_membranes(b.model.part_index(1)));
  }
}

TEST(Checks, SolidsWithNodalRotationsAreComputedWithAWarning) {
  const auto deck = [](const std::string& elform, const std::string& nodes) {
    return Built(
        sheet_deck("*PART\nb\n3,13,1\n*SECTION_SOLID\n13," + elform + "\n*ELEMENT_SOLID\n1,3," + nodes + "\n"));
  };
  const Built brick = deck("3", "1,2,3,4,5,6,7,8");
  EXPECT_EQ(brick.findings.errors(), 0) << brick.all_findings();
  EXPECT_TRUE(brick.warning("solid formulation 3 is computed as a brick of eight points", "elform"));
  const Built tetrahedron = deck("4", "1,2,3,5,5,5,5,5");
  EXPECT_EQ(tetrahedron.findings.errors(), 0) << tetrahedron.all_findings();
  EXPECT_TRUE(tetrahedron.warning("solid formulation 4 is computed as the tetrahedron of ten nodes", "elform"));
  EXPECT_TRUE(deck("4", "1,2,3,4,5,6,7,8").error("expected the four of a tetrahedron"));
}

TEST(Checks, DiscreteBeams) {
  const auto part = [](const std::string& section, const std::string& law) {
    return Built(sheet_deck("*PART\nc\n4,14,2\n*SECTION_BEAM\n" + section + law + "*ELEMENT_BEAM\n1,4,1,5\n"));
  };
  const std::string linear = "*MAT_066\n2,1.0,100.0,0,0,0,0,5.0\n\n\n";
  const Built good = part("14,6,1,2,0,2\n0.1,0.2\n", linear);
  ASSERT_EQ(good.findings.errors(), 0) << good.all_findings();
  const SectionBeam& section = good.model.beam_sections[0];
  EXPECT_EQ(section.scoor, 2);
  EXPECT_EQ(section.volume, 0.1);
  EXPECT_EQ(section.inertia, 0.2);
  const auto& law = std::get<kernel::DiscreteBeam>(good.model.materials[1].law);
  EXPECT_EQ(law.dof[0].stiffness, 100.0);
  EXPECT_EQ(law.dof[5].stiffness, 5.0);

  EXPECT_TRUE(part("14,6\n0.0,0.2\n", linear).error("no mass", "elform"));
  EXPECT_TRUE(part("14,6\n0.1\n", linear).error("rotary inertia", "elform"));
  EXPECT_TRUE(part("14,6,1,2,0,12\n0.1,0.2\n", linear).error("triad", "scoor"));
  EXPECT_TRUE(part("14,9\n5.0,5.0\n", linear).error("need *MAT_SPOTWELD", "mid"));
}

TEST(Checks, LawsOfDiscreteBeams) {
  const auto law = [](const std::string& material) {
    return Built(sheet_deck("*PART\nc\n4,14,2\n*SECTION_BEAM\n14,6\n0.1,0.2\n" + material +
                            "*ELEMENT_BEAM\n1,4,1,5\n*DEFINE_CURVE\n7\n0.0,0.0\n1.0,50.0\n2.0,60.0\n"
                            "*DEFINE_CURVE\n8\n0.0,50.0\n1.0,70.0\n*DEFINE_CURVE\n9\n0.0,50.0\n0.01,0.0\n"));
  };
  using Kind = kernel::DiscreteSpring::Kind;
  const auto spring = [](const Built& b, std::size_t i) {
    return std::get<kernel::DiscreteBeam>(b.model.materials[1].law).dof[i];
  };
  const Built general = law("*MAT_GENERAL_SPRING_DISCRETE_BEAM\n2,1.0\n1,1,100.0,0,0,0.5\n8\n4,0,30.0\n\n");
  ASSERT_EQ(general.findings.errors(), 0) << general.all_findings();
  EXPECT_EQ(spring(general, 0).kind, Kind::elastoplastic);
  EXPECT_EQ(spring(general, 3).kind, Kind::linear);
  EXPECT_EQ(spring(general, 1).kind, Kind::none);
  EXPECT_EQ(std::get<kernel::DiscreteBeam>(general.model.materials[1].law).tension_limit[0], 0.5);
  EXPECT_TRUE(law("*MAT_196\n2,1.0\n1,1,100.0\n9\n").error("falls faster", "flcid"));

  const Built six = law("*MAT_119\n2,1.0,200.0,0,2\n7\n7\n\n\n0.3,0,0,0,0,0,1\n\n\n");
  ASSERT_EQ(six.findings.errors(), 0) << six.all_findings();
  EXPECT_EQ(spring(six, 0).kind, Kind::hysteresis);
  EXPECT_EQ(std::get<kernel::DiscreteBeam>(six.model.materials[1].law).rule, kernel::DiscreteBeam::Rule::together);
  EXPECT_TRUE(law("*MAT_119\n2,1.0,0,0,2\n7\n7\n\n\n\n\n\n").error("needs this stiffness", "kt"));
  // DAMPF acts only where KT or KR is given.
  EXPECT_EQ(law("*MAT_119\n2,1.0,0,0,0,,0.9\n7\n\n\n\n\n\n\n").findings.errors(), 0);
  EXPECT_TRUE(law("*MAT_119\n2,1.0,200.0,0,2,,0.9\n7\n7\n\n\n\n\n\n").error("damping of the local stiffness", "dampf"));
  EXPECT_TRUE(law("*MAT_119\n2,1.0,9.0,0,2\n7\n\n\n\n\n\n\n").error("needs an unloading curve", "lcidtur"));
  EXPECT_TRUE(law("*MAT_119\n2,1.0,9.0,0,3\n7\n\n\n\n\n\n\n").error("0 to 2", "iunld"));

  const Built one = law("*MAT_121\n2,1.0\n7\n0.4,0.3,0.1\n");
  ASSERT_EQ(one.findings.errors(), 0) << one.all_findings();
  EXPECT_EQ(spring(one, 0).kind, Kind::elastic);
  EXPECT_EQ(spring(one, 0).start, 0.1);
  const Built plastic = law("*MAT_068\n2,1.0,100.0\n\n8\n30.0\n\n\n");
  ASSERT_EQ(plastic.findings.errors(), 0) << plastic.all_findings();
  EXPECT_EQ(spring(plastic, 0).kind, Kind::elastoplastic);
  EXPECT_EQ(std::get<kernel::DiscreteBeam>(plastic.model.materials[1].law).force_limit[0], 30.0);
  const Built pull = law("*MAT_074\n2,1.0,100.0,5.0,2.0,0.2,0.3\n\n");
  ASSERT_EQ(pull.findings.errors(), 0) << pull.all_findings();
  EXPECT_EQ(spring(pull, 0).preload, 5.0);
}

TEST(Checks, FormulationsOfWeldsOfBricks) {
  const auto deck = [](const char* elform) {
    return sheet_deck("*MAT_SPOTWELD\n2,7.85e-9,210000.0,0.3,400.0\n*PART\nb\n2,12,2\n*SECTION_SOLID\n12," +
                      std::string(elform) + "\n*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n");
  };
  for (const char* built : {"1", "2"})
    EXPECT_EQ(Built(deck(built)).find(Severity::error, "formulation", "elform"), nullptr);
  const Built zero(deck("0")), blank(deck(""));
  EXPECT_TRUE(zero.warning("honeycombs", "elform"));
  EXPECT_EQ(zero.model.solid_sections.at(0).elform, 1);
  EXPECT_FALSE(blank.warning("honeycombs", "elform"));
  for (const char* scaled : {"-1", "-2"}) {
    const Built b(deck(scaled));
    EXPECT_EQ(b.find(Severity::error, "formulation", "elform"), nullptr);
    EXPECT_TRUE(b.warning("with assumed strains", "elform"));
  }
}

TEST(Checks, OptionsOfOtherKindsOfWelds) {
  const auto with_option = [](const char* option, const char* part) {
    return Built(sheet_deck("*MAT_SPOTWELD_DAMAGE-FAILURE\n2,7.85e-9,210000.0,0.3,400.0\n0,7,7\n0," +
                            std::string(option) + "\n*DEFINE_CURVE\n7\n0,1\n90,2\n" + part));
  };
  const char* bricks = "*PART\nb\n2,12,2\n*SECTION_SOLID\n12,1\n*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n";
  EXPECT_NE(with_option("11", bricks).find(Severity::warning, "documented for beams"), nullptr);
  EXPECT_EQ(with_option("0", bricks).find(Severity::warning, "documented for"), nullptr);
}

TEST(Checks, RigidPartsMayHaveAnyFormulation) {
  const Built b(
      sheet_deck("*PART\na\n2,12,2\n*SECTION_SHELL\n12,6\n1.0\n*MAT_RIGID\n2,7.85e-9,210000.0,0.3\n\n\n"
                 "*ELEMENT_SHELL\n2,2,5,6,7,8\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
}

TEST(Checks, TheoryStandsInForABlankFormulation) {
  const Built b(
      sheet_deck("*CONTROL_SHELL\n,,,,3\n*PART\na\n2,12,1\n*SECTION_SHELL\n12\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n"));
  EXPECT_TRUE(b.error("shell formulation 3 is not built", "elform")) << b.all_findings();
}

TEST(Checks, FullyIntegratedShells) {
  const auto deck = [](const std::string& elform, const std::string& more) {
    return sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12," + elform + "\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n" + more);
  };
  const Built plain(deck("16", ""));
  EXPECT_EQ(plain.findings.errors(), 0) << plain.all_findings();
  EXPECT_FALSE(plain.warning("is computed as 16"));
  for (const char* linear : {"-16", "6", "7", "18", "20", "21"}) {
    const Built b(deck(linear, ""));
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    EXPECT_TRUE(b.warning("is computed as 16, fully integrated")) << b.all_findings();
    EXPECT_EQ(b.model.shell_sections.back().elform, 16);
  }
  // Type 8 is for formulation 16 only: part 1 has formulation 2.
  EXPECT_TRUE(Built(deck("16", "*CONTROL_HOURGLASS\n8\n")).warning("part 1 has shells, for which types 1 to 5"));
}

TEST(Checks, OtherOnePointShells) {
  const auto deck = [](const std::string& elform, const char* more) {
    return sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12," + elform + "\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n" + more);
  };
  const Built chiang(deck("10", ""));
  EXPECT_EQ(chiang.findings.errors(), 0) << chiang.all_findings();
  EXPECT_TRUE(chiang.warning("computed as 2 with its warping coupling", "elform"));
  EXPECT_EQ(chiang.model.shell_sections.back().elform, 2);
  EXPECT_TRUE(chiang.model.shell_sections.back().warping_stiffness);
  EXPECT_FALSE(chiang.model.shell_sections.front().warping_stiffness);
  for (const auto& [other, name] :
       {std::pair{"1", "Hughes-Liu"}, {"8", "Belytschko-Leviathan"}, {"11", "Hughes-Liu"}}) {
    const Built b(deck(other, ""));
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    EXPECT_TRUE(b.warning(name, "elform")) << b.all_findings();
    EXPECT_EQ(b.model.shell_sections.back().elform, 2);
    EXPECT_TRUE(b.model.shell_sections.back().warping_stiffness);
    const Built linear(deck(other, "*CONTROL_IMPLICIT_GENERAL\n1\n*CONTROL_IMPLICIT_EIGENVALUE\n10\n"));
    EXPECT_EQ(linear.findings.errors(), 0) << linear.all_findings();
  }
}

TEST(Checks, KirchhoffTrianglesAreBuilt) {
  const Built b(sheet_deck(
      "*PART\na\n2,12,1\n*SECTION_SHELL\n12,17\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,7\n*CONTROL_SHELL\n20.0,2\n"));
  EXPECT_EQ(b.findings.errors() + b.findings.warnings(), 0) << b.all_findings();
  EXPECT_EQ(b.model.shell_sections.back().elform, 17);
  EXPECT_EQ(b.model.control.sort_triangles, SortTriangles::kirchhoff);
  EXPECT_TRUE(Built(sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12,17\n1.0\n*ELEMENT_SHELL\n3,2,5,6,7,8\n"))
                  .error("shell 3 has four corners, but its formulation 17 is a triangle"));
}

TEST(Checks, DrillingOfThePartsOfASet) {
  const auto deck = [](const std::string& elform) {
    return sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12," + elform +
                      "\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7,8\n*SET_PART\n7\n2\n"
                      "*CONTROL_SHELL\n20.0\n1.0\n0\n0,0,0,0,0,7,2.5\n");
  };
  const Built b(deck("16"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.parts[0].drilling, 0.0);
  EXPECT_EQ(b.model.parts[1].drilling, 2.5);
  EXPECT_TRUE(Built(deck("2")).error("part 2 has shells of formulation 2, which cannot resist drilling", "drcpsid"));
}

TEST(Checks, LawsAndElementsMustGoTogether) {
  const Built b(
      sheet_deck("*MAT_SPOTWELD\n2,7.85e-9,210000.0,0.3,400.0\n*MAT_NULL\n3,7.85e-9\n"
                 "*PART\nbrick weld\n2,2,2\n*SECTION_SOLID\n2\n*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n"
                 "*PART\nsheet of weld\n3,1,2\n*ELEMENT_SHELL\n3,3,5,6,7,8\n"
                 "*PART\nnull brick\n4,2,3\n*ELEMENT_SOLID\n2,4,1,2,3,4,5,6,7,8\n"
                 "*PART\nelastic beam\n5,5,1\n*SECTION_BEAM\n5,9,,,1\n6.0\n*ELEMENT_BEAM\n1,5,1,5\n"
                 "*PART\nnull sheet\n6,1,3\n*ELEMENT_SHELL\n6,6,1,2,6,5\n"));
  EXPECT_TRUE(b.error("*MAT_SPOTWELD is a law of weld beams", "mid")) << b.all_findings();
  EXPECT_TRUE(b.error("*MAT_NULL in solids is a fluid", "eosid"));
  EXPECT_TRUE(b.error("spot-weld beams (ELFORM 9) need *MAT_SPOTWELD, not *MAT_ELASTIC", "mid"));
  EXPECT_EQ(b.findings.errors(), 3) << b.all_findings();
}

/// The hourglass type that a part is computed with.
int type_of_part(const Built& b, int id) {
  const Part& part = b.model.parts[b.model.part_index(id)];
  return part.hourglass == none ? b.model.control.hourglass.type : b.model.hourglass[part.hourglass].type;
}

TEST(Checks, HourglassTypesByElement) {
  const std::string brick = std::string(brick_part) + "*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n";
  const Built b(sheet_deck(brick + "*CONTROL_HOURGLASS\n6\n"));
  const Finding* f = b.find(Severity::warning,
                            "part 1 has shells, for which types 1 to 5 are built: they get type 1, viscosity", "ihq");
  ASSERT_NE(f, nullptr) << b.all_findings();
  EXPECT_EQ(b.findings.errors(), 0);  // the bricks of part 2 have type 6
  EXPECT_EQ(type_of_part(b, 1), 1);
  EXPECT_EQ(type_of_part(b, 2), 6);
  EXPECT_NE(Built(sheet_deck(brick + "*CONTROL_HOURGLASS\n10\n"))
                .find(Severity::error, "part 2 has solids, for which types 1 to 6 are built", "ihq"),
            nullptr);
  // Types of the same stiffness as 6, with a warning.
  for (const char* type : {"7", "9"})
    for (const std::string& as_six : {brick + "*CONTROL_HOURGLASS\n" + type + "\n",
                                      std::string("*HOURGLASS\n5,") + type +
                                          "\n*PART\nblock\n2,2,1,,5\n*SECTION_SOLID\n2,1\n*ELEMENT_SOLID\n"
                                          "1,2,1,2,3,4,5,6,7,8\n"}) {
      const Built stiff(sheet_deck(as_six));
      EXPECT_EQ(stiff.findings.errors(), 0) << stiff.all_findings();
      EXPECT_TRUE(stiff.warning("part 2 has solids, for which types 1 to 6 are built: they get type 6", "ihq"));
      EXPECT_EQ(type_of_part(stiff, 2), 6);
    }
  EXPECT_EQ(Built(sheet_deck(brick + "*CONTROL_HOURGLASS\n2\n")).findings.errors(), 0);
  // A brick of eight points has no modes, so types of shells mean nothing to it.
  const std::string full = "*PART\nblock\n2,2,1\n*SECTION_SOLID\n2,2\n*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n";
  const Built mixed(sheet_deck(brick + "*CONTROL_HOURGLASS\n8\n"));
  EXPECT_TRUE(mixed.warning("part 2 has solids", "ihq"));
  EXPECT_EQ(type_of_part(mixed, 2), 1);
  EXPECT_FALSE(Built(sheet_deck(full + "*CONTROL_HOURGLASS\n8\n")).warning("part 2 has solids", "ihq"));
  // A card of the part's own says what the part is to have.
  const std::string own = "*HOURGLASS\n5,8\n*PART\nblock\n2,2,1,,5\n*SECTION_SOLID\n2,1\n";
  EXPECT_TRUE(Built(sheet_deck(own + "*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n")).error("part 2 has solids", "ihq"));
}

TEST(Checks, TriangleFormulationNeedsTriangles) {
  const Built b(sheet_deck("*PART\na\n2,12,1\n*SECTION_SHELL\n12,4\n1.0\n*ELEMENT_SHELL\n2,2,5,6,7\n3,2,5,6,7,8\n"));
  EXPECT_TRUE(b.error("shell 3 has four corners, but its formulation 4 is a triangle")) << b.all_findings();
  EXPECT_EQ(b.findings.errors(), 1);
}

TEST(Checks, FreeNodesAreCounted) {
  const Built b(sheet_deck(""));
  EXPECT_TRUE(b.find(Severity::note, "4 nodes belong to no element, mass or rigid body; the first is node 5"))
      << b.all_findings();
  EXPECT_EQ(b.findings.errors() + b.findings.warnings(), 0) << b.all_findings();
}

TEST(Checks, ZeroLengthWeldsAreNoted) {
  const Built b(
      sheet_deck("*NODE\n9,0.0,0.0,0.0\n*PART\nw\n4,14,2\n*SECTION_BEAM\n14,9,,,1\n6.0\n*MAT_SPOTWELD\n2,7.85e-9,"
                 "210000.0,0.3,400.0\n"
                 "*ELEMENT_BEAM\n1,4,1,9\n"));
  EXPECT_TRUE(b.find(Severity::note, "beam 1 has no length")) << b.all_findings();
}

TEST(Checks, AnEndTimeIsNeededByRunsOnly) {  // they ask for it themselves: tests/decks/test_broken_decks.py
  const Built b("*KEYWORD\n*CONTROL_TERMINATION\n0.0\n");
  EXPECT_FALSE(b.error("no end time is given")) << b.all_findings();
}

struct Units {
  const char* density;
  const char* modulus;
  bool usual;
};
class UnitsOf : public testing::TestWithParam<Units> {};

TEST_P(UnitsOf, Steel) {
  const auto [density, modulus, usual] = GetParam();
  const Built b("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*MAT_ELASTIC\n1," + std::string(density) + ',' + modulus +
                ",0.3\n");
  EXPECT_EQ(b.warning("fits no usual system of units"), !usual) << b.all_findings();
}

INSTANTIATE_TEST_SUITE_P(Checks, UnitsOf,
                         testing::Values(Units{"7.85e-9", "210000", true}, Units{"7850", "2.1e11", true},
                                         Units{"7.85e-6", "210", true}, Units{"7.85e-3", "210000", true},
                                         Units{"7.85", "2.1", true}, Units{"7.35e-4", "3.0e7", true},
                                         Units{"1.2e-9", "2200", true},        // a plastic
                                         Units{"7.85e-6", "210000", false},    // kg with MPa
                                         Units{"7850", "210000", false},       // kg/m3 with MPa
                                         Units{"7.85e-9", "2.1e11", false}));  // t/mm3 with Pa

TEST(Checks, OneMaterialInOtherUnitsThanTheRest) {
  const Built b(sheet_deck("*MAT_ELASTIC\n2,7.85e-9,70000.0,0.3\n*MAT_ELASTIC\n3,7850.0,2.1e11,0.3\n"));
  EXPECT_TRUE(b.warning("material 3")) << b.all_findings();
  EXPECT_TRUE(b.warning("does not fit mm t s"));
  EXPECT_EQ(b.findings.warnings(), 1);
}

TEST(Checks, ElementsBetweenMovingAndStandingNodes) {
  const std::string two_move = "*INITIAL_VELOCITY_NODE\n1,5.0\n2,5.0\n";
  const Built torn(sheet_deck(two_move));
  EXPECT_TRUE(
      torn.warning("1 elements (the first is shell 1) of parts 1 join nodes that start moving with nodes that "
                   "start at rest; 2 of the 8 nodes have an initial velocity"))
      << torn.all_findings();
  const Built whole(sheet_deck(two_move + "3,5.0\n4,-5.0\n"));
  EXPECT_FALSE(whole.warning("start at rest")) << whole.all_findings();
  const Built held(sheet_deck(two_move + "*BOUNDARY_SPC_NODE\n3,0,1,1,1\n4,0,1,1,1\n"));
  EXPECT_FALSE(held.warning("start at rest")) << held.all_findings();
}

}  // namespace
}  // namespace nugget::reading
