// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/index.hpp"
#include "kernel/law/law_components.hpp"
#include "small_model.hpp"

// Layers of shells: *PART_COMPOSITE, *INTEGRATION_SHELL with parts, ICOMP of *SECTION_SHELL.
namespace nugget::reading {
namespace {

const std::string mesh =
    "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
    "*MAT_ELASTIC\n1,2.5e-9,70000.0,0.2\n*MAT_ELASTIC\n2,1.1e-9,500.0,0.4\n*MAT_RIGID\n3,7.85e-9,210000.0,0.3\n\n\n"
    "*MAT_ORTHOTROPIC_ELASTIC\n4,1.5e-9,150000.,9000.,9000.,0.02,0.02,0.3\n5000.,3000.,5000.,0\n\n\n";

Built built(const std::string& more) {
  return Built("*KEYWORD\n*CONTROL_TERMINATION\n1.0\n" + mesh + more);
}
Built composite(const std::string& layers, const std::string& more = {}) {
  return built("*PART_COMPOSITE\npane\n1,2,,,4e-9\n" + layers + more);
}

TEST(Layers, OfAComposite) {
  const auto b = composite("1,2.1,,,2,0.8\n1,2.1\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Part& part = b.model.parts.at(0);
  const SectionShell& section = b.model.shell_sections.at(at(part.section));
  EXPECT_DOUBLE_EQ(section.thickness, 5.0);
  EXPECT_DOUBLE_EQ(section.extra_mass, 4e-9);
  ASSERT_EQ(section.rule.size(), 3u);
  EXPECT_NEAR(section.rule[0][0], -0.58, 1e-15);
  EXPECT_NEAR(section.rule[1][0], 0.0, 1e-15);
  EXPECT_NEAR(section.rule[1][1], 0.16, 1e-15);
  EXPECT_DOUBLE_EQ(b.model.shells.thickness.at(0), 5.0);
  const Material& m = b.model.materials.at(at(part.material));
  EXPECT_NEAR(m.density, 0.84 * 2.5e-9 + 0.16 * 1.1e-9, 1e-21);
  const double glass = 0.84 * 70000.0 / 0.96, interlayer = 0.16 * 500.0 / 0.84;
  EXPECT_NEAR(m.poisson(), (0.2 * glass + 0.4 * interlayer) / (glass + interlayer), 1e-14);
  EXPECT_NEAR(m.young() / (1.0 - m.poisson() * m.poisson()), glass + interlayer, 1e-9);
  EXPECT_TRUE(b.find(Severity::note, "85 % of the bending stiffness")) << b.all_findings();
}

// A sheet of 1 x 1 weighs (2.1 x 2.5 + 0.8 x 1.1 + 2.1 x 2.5 + 4) 1e-9.
TEST(Layers, MassOfAPartOfLayers) {
  const auto b = composite("1,2.1,,,2,0.8\n1,2.1\n", "*ELEMENT_MASS_PART\n1,,20e-9\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(b.model.masses.size(), 4u);
  for (const PointMass& m : b.model.masses) EXPECT_NEAR(m.mass, 0.25 * (20.0 - 15.38) * 1e-9, 1e-21);
}

TEST(Layers, OneALineWithContact) {
  const auto b = built("*PART_COMPOSITE_LONG_CONTACT\npane\n1,16\n0.2,0.2,,,1.5\n4,1.0,30.0,,7,0.9\n4,1.0\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Part& part = b.model.parts.at(0);
  EXPECT_DOUBLE_EQ(part.contact_thickness, 1.5);
  const auto& layers = *std::get<kernel::Laminate>(b.model.materials.at(at(part.material)).law).layers;
  ASSERT_EQ(layers.size(), 2u);
  EXPECT_DOUBLE_EQ(layers[0].angle, std::numbers::pi / 6.0);
  EXPECT_DOUBLE_EQ(layers[0].shear_scale, 0.9);
  EXPECT_DOUBLE_EQ(layers[1].shear_scale, 1.0);
}

TEST(Layers, FaultsOfAComposite) {
  EXPECT_TRUE(composite("1,2.1,,,2\n").error("a layer without a thickness", "thick2"));
  EXPECT_TRUE(composite("1,2.1,,,,0.5\n").error("a layer without a material", "mid2"));
  EXPECT_TRUE(composite("1,2.1\n2,1.0\n").error("a layer above a blank one", "mid1"));
  EXPECT_TRUE(composite("").error("no layers"));
  EXPECT_TRUE(composite("9,1.0\n").error("material 9 is not defined", "mid1"));
  EXPECT_TRUE(composite("1,1.0,,,3,1.0\n").error("*MAT_RIGID is not a law of a shell's layers", "mid2"));
  EXPECT_TRUE(composite("1,1.0,45.0\n").find(Severity::note, "has no axes", "mid1"));
  std::string many;
  for (int k = 0; k < 17; ++k) many += "1,1.0,,,1,1.0\n";
  EXPECT_TRUE(composite(many).error("34 layers; up to 32 are built"));
  EXPECT_TRUE(built("*PART_COMPOSITE\npane\n1,5\n1,1.0\n")
                  .error("membranes (ELFORM 5) with layers of different materials", "elform"));
  EXPECT_TRUE(built("*PART_COMPOSITE_TSHELL\npane\n1,1\n1,1.0\n").error("this form of *PART_COMPOSITE"));
  EXPECT_TRUE(composite("4,1.0\n", "*CONTROL_SHELL\n\n,,1\n").error("laminated shell theory", "mid1"));
  EXPECT_TRUE(composite("1,1.0\n", "*CONTROL_SHELL\n\n,,2\n").error("not a documented value", "lamsht"));
  EXPECT_TRUE(composite("1,1.0,,,2,1.0\n", "*MAT_ADD_EROSION\n1\n,50.\n\n\n").warning("the 1 whose material knows no"));
  EXPECT_TRUE(composite("1,1.0\n", "*MAT_ADD_EROSION\n1\n,50.\n\n\n")
                  .find(Severity::note, "deletes the shell with all its layers", "mid1"));
}

// Formulation 17 has no transverse shear for LAMSHT to act on: a sandwich in it has 5.4 times the frequency.
TEST(Layers, LaminatedShearInTriangles) {
  const std::string soft = "*MAT_ELASTIC\n5,5e-11,50.0,0.1\n", third = "*ELEMENT_SHELL\n2,1,1,2,3,3\n",
                    shear = "*CONTROL_SHELL\n\n,,1\n", sorted = "*CONTROL_SHELL\n,2\n,,1\n";
  const auto reported = [&](const std::string& layers, const std::string& control, const std::string& more) {
    return composite(layers, soft + control + more).warning("no effect in its 1 triangles of formulation 17");
  };
  const std::string core = "1,0.8,,,5,10.0\n5,10.0,,,1,0.8\n";
  EXPECT_TRUE(reported(core, sorted, third));
  EXPECT_FALSE(reported(core, shear, third));                   // formulation 4, or a collapsed quad
  EXPECT_FALSE(reported(core, sorted, ""));                     // no triangles
  EXPECT_FALSE(reported(core, "*CONTROL_SHELL\n,2\n", third));  // not asked for
  EXPECT_FALSE(reported("1,0.8,,,1,10.0\n", sorted, third));    // one material
}

TEST(Layers, OfParts) {
  const std::string section = "*SECTION_SHELL\n1,2,,3,,-7\n5.0\n*PART\npane\n1,1,1\n*PART\nfilm\n8,1,2\n";
  const auto b = built(section + "*INTEGRATION_SHELL\n7,3,0,1\n-0.6,0.4\n0.0,0.2,8\n0.6,0.4\n");
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& law = std::get<kernel::Laminate>(b.model.materials.at(at(b.model.parts.at(0).material)).law);
  EXPECT_TRUE(law.kept_by_unfailing_layers);
  ASSERT_EQ(law.layers->size(), 3u);
  EXPECT_DOUBLE_EQ((*law.layers)[1].law.E, 500.0);
  EXPECT_TRUE(built(section + "*INTEGRATION_SHELL\n7,1\n0.0,1.0,9\n").error("part 9 is not defined", "pid"));
  EXPECT_FALSE(b.warning("has no elements")) << b.all_findings();
  // Without parts the shell keeps its own law; with LAMSHT it has layers.
  const std::string plain = section + "*INTEGRATION_SHELL\n7,3,1\n";
  const auto own = [](const Built& of) {
    return std::holds_alternative<kernel::Elastic>(of.model.materials.at(at(of.model.parts.at(0).material)).law);
  };
  EXPECT_TRUE(own(built(plain)));
  EXPECT_FALSE(own(built(plain + "*CONTROL_SHELL\n\n,,1\n")));
}

// "... constants with local material axes and orientation angles taken from the PID referenced on the element card"
// (*INTEGRATION_SHELL, PID): material 6 has its axis a along y, material 5 of the shells' own part along x.
TEST(Layers, AxesAreThoseOfTheShellsOwnPart) {
  const auto fibres = [](int mid, const char* modulus, const char* along) {
    return "*MAT_ORTHOTROPIC_ELASTIC\n" + std::to_string(mid) + ",1.5e-9," + modulus +
           ",9000.,9000.,0.02,0.02,0.3\n5000.,3000.,5000.,2\n,,," + along + "\n,,,0,0,1\n";
  };
  const auto stacked = [&](const char* along, int own) {
    return built(fibres(5, "150000.", "1,0,0") + fibres(6, "90000.", along) +
                 "*SECTION_SHELL\n1,2,,2,,-7\n5.0\n*PART\npane\n1,1," + std::to_string(own) +
                 "\n*PART\nply\n8,1,6\n*INTEGRATION_SHELL\n7,2\n-0.5,0.5\n0.5,0.5,8\n");
  };
  const auto layer = [](const Built& b) {
    const auto& law = std::get<kernel::Laminate>(b.model.materials.at(at(b.model.parts.at(0).material)).law);
    return std::get<kernel::Orthotropic>((*law.layers)[1].law.components->flow);
  };
  const auto crossed = stacked("0,1,0", 5);
  EXPECT_EQ(crossed.findings.errors(), 0) << crossed.all_findings();
  EXPECT_TRUE(crossed.warning("material 6 are not looked at", "pid")) << crossed.all_findings();
  EXPECT_DOUBLE_EQ(layer(crossed).axes.a.x, 1.0);
  EXPECT_DOUBLE_EQ(layer(crossed).axes.a.y, 0.0);
  EXPECT_NEAR(layer(crossed).E, 90000.0, 0.1 * 90000.0);  // its constants are its own
  const auto alike = stacked("1,0,0", 5);
  EXPECT_FALSE(alike.warning("not looked at")) << alike.all_findings();
  const auto isotropic = stacked("0,1,0", 1);  // glass has no axes to give
  EXPECT_FALSE(isotropic.warning("not looked at")) << isotropic.all_findings();
  EXPECT_DOUBLE_EQ(layer(isotropic).axes.a.y, 1.0);
}

// ICOMP 1: B1, B2, ... turn the layers of one material. Sabotage: angles read and left out; places of another rule; the
// angle of a point that *INTEGRATION_SHELL lists out of order given to its place in the list.
TEST(Layers, AnglesOfASection) {
  const auto section = [](const std::string& first, const std::string& angles, int mid, const std::string& more = {}) {
    return built("*SECTION_SHELL\n" + first + "\n5.0\n" + angles + "\n*PART\npane\n1,1," + std::to_string(mid) + "\n" +
                 more);
  };
  const auto law = [](const Built& b) -> const Law& {
    return b.model.materials.at(at(b.model.parts.at(0).material)).law;
  };
  const auto b = section("1,2,,2,,,1", "30.0,-45.0", 4);
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.materials.at(at(b.model.parts.at(0).material)).keyword, "SECTION_SHELL");
  const auto& two = *std::get<kernel::Laminate>(law(b)).layers;
  ASSERT_EQ(two.size(), 2u);
  EXPECT_DOUBLE_EQ(two[0].angle, std::numbers::pi / 6.0);
  EXPECT_DOUBLE_EQ(two[1].angle, -std::numbers::pi / 4.0);
  EXPECT_NEAR(two[0].place, -1.0 / std::sqrt(3.0), 1e-15);
  EXPECT_DOUBLE_EQ(two[1].share, 0.5);
  const auto lobatto = section("1,2,,3,,,1", "0,90.0", 4, "*CONTROL_SHELL\n\n,1\n");
  EXPECT_EQ(lobatto.findings.errors(), 0) << lobatto.all_findings();
  EXPECT_DOUBLE_EQ((*std::get<kernel::Laminate>(law(lobatto)).layers)[0].place, -1.0);
  const auto rule = section("1,2,,2,,-7,1", "30.0,60.0", 4, "*INTEGRATION_SHELL\n7,2\n0.5,0.5\n-0.5,0.5\n");
  EXPECT_EQ(rule.findings.errors(), 0) << rule.all_findings();
  const auto& turned = *std::get<kernel::Laminate>(law(rule)).layers;
  EXPECT_DOUBLE_EQ(turned[0].angle, std::numbers::pi / 3.0);  // the lower one is the second of the cards
  EXPECT_DOUBLE_EQ(turned[1].angle, std::numbers::pi / 6.0);
  EXPECT_TRUE(section("1,2,,2,,,1", "0,90.0,45.0", 4).warning("the section has 2 layers", "b3"));
  // Nothing to turn: the shell keeps its own law.
  const auto isotropic = section("1,2,,2,,,1", "0,90.0", 1);
  EXPECT_TRUE(isotropic.find(Severity::note, "*MAT_ELASTIC has no axes", "b2")) << isotropic.all_findings();
  EXPECT_TRUE(std::holds_alternative<kernel::Elastic>(law(isotropic)));
  EXPECT_FALSE(std::holds_alternative<kernel::Laminate>(law(section("1,2,,2,,,1", "0,0", 4))));
}

// A membrane has one layer, and its fabric has B1 and B2 for its threads.
TEST(Layers, AnglesOfAMembrane) {
  const auto membrane = [](const std::string& angles) {
    return built("*MAT_FABRIC\n7,1e-9,100.0,100.0,,0.3\n38.0\n\n\n\n*SECTION_SHELL\n1,9,,1,,,1\n0.5\n" + angles +
                 "\n*PART\nbag\n1,1,7\n");
  };
  EXPECT_EQ(membrane("0,90.0").findings.errors(), 0) << membrane("0,90.0").all_findings();
  EXPECT_TRUE(membrane("0,60.0").error("not at right angles", "b2"));
  EXPECT_TRUE(membrane("30.0,90.0").error("by the section is not built", "b1"));
  EXPECT_TRUE(membrane("0,90.0,45.0").error("a membrane has one layer", "b3"));
}

}  // namespace
}  // namespace nugget::reading
