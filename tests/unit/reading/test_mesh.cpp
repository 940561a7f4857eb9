// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/lumped_mass.hpp"
#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

/// Comma format. Nodes 1..8 are the corners of a unit cube, 9 lies 2 above node 5; parts and sections of all kinds.
std::string cube_deck(const std::string& more) {
  return R"(*KEYWORD
*CONTROL_TERMINATION
1.0
*NODE
5,0.0,0.0,1.0
1,0.0,0.0,0.0
2,1.0,0.0,0.0,1,7
3,1.0,1.0,0.0
4,0.0,1.0,0.0
6,1.0,0.0,1.0
7,1.0,1.0,1.0
8,0.0,1.0,1.0
9,0.0,0.0,3.0
*PART
sheet
1,1,1
brick
2,2,1
weld
3,3,2
*SECTION_SHELL
1,2,,3
1.0,2.0
*SECTION_SOLID
2,1
*SECTION_BEAM
3,9,,,1
6.0
*MAT_ELASTIC
1,7.85e-9,210000.0,0.3
*MAT_SPOTWELD
2,7.85e-9,210000.0,0.3,400.0
)" + more;
}

TEST(Mesh, SortsNodesAndElementsById) {
  const Built b(
      cube_deck("*ELEMENT_SHELL\n20,1,5,6,7,8\n10,1,1,2,3,4\n*ELEMENT_SOLID\n7,2,1,2,3,4,5,6,7,8\n"
                "*ELEMENT_BEAM\n4,3,5,9\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_THAT(b.model.nodes.id, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_DOUBLE_EQ(b.model.nodes.x[8].z, 3.0);
  EXPECT_EQ(b.model.node_index(9), 8);
  EXPECT_EQ(b.model.node_index(10), none);
  EXPECT_THAT(b.model.shells.id, ElementsAre(10, 20));
  EXPECT_THAT(b.model.shells.node[1], ElementsAre(4, 5, 6, 7));
  EXPECT_DOUBLE_EQ(b.model.shells.thickness[0], 1.25);  // T1 = 1, T2 = 2, T3 and T4 as T1
  EXPECT_EQ(b.model.shells.place[0].line, 35);
  EXPECT_EQ(b.model.parts[0].kind, ElementKind::shell);
  EXPECT_EQ(b.model.parts[1].kind, ElementKind::solid);
  EXPECT_EQ(b.model.parts[2].kind, ElementKind::beam);
  EXPECT_EQ(b.model.parts[2].section, 0);
  EXPECT_EQ(b.model.parts[2].material, 1);
  EXPECT_EQ(b.model.beams.orientation[0], none);
}

TEST(Mesh, NodesOwnConstraintCodes) {
  const Built b(cube_deck("*ELEMENT_SHELL\n10,1,1,2,3,4\n"));
  ASSERT_EQ(b.model.spcs.size(), 1u);
  EXPECT_EQ(b.model.spcs[0].node, 1);
  EXPECT_EQ(b.model.spcs[0].fixed, 0b111001u);
  EXPECT_EQ(b.model.spcs[0].id, 0);
}

TEST(Mesh, TrianglesRepeatTheirThirdNodeAndKeepTheirSense) {
  const Built b(cube_deck("*ELEMENT_SHELL\n1,1,1,2,3\n2,1,1,2,3,3\n3,1,1,1,2,3\n4,1,1,2,3,1\n5,1,1,2,2,3\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& n = b.model.shells.node;
  EXPECT_THAT(n[0], ElementsAre(0, 1, 2, 2));
  EXPECT_THAT(n[1], ElementsAre(0, 1, 2, 2));
  EXPECT_THAT(n[2], ElementsAre(1, 2, 0, 0));
  EXPECT_THAT(n[3], ElementsAre(1, 2, 0, 0));
  EXPECT_THAT(n[4], ElementsAre(2, 0, 1, 1));
  for (std::size_t e = 0; e < 5; ++e) EXPECT_TRUE(b.model.shells.triangle(e));
}

TEST(Mesh, TetrahedraOfFourNodesAreCompleted) {
  const Built b(cube_deck("*ELEMENT_SOLID\n7,2\n1,2,4,5\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  // The part has ELFORM 1: a brick folded so that it has the tetrahedron's volume.
  EXPECT_THAT(b.model.solids.node[0], ElementsAre(0, 1, 3, 3, 4, 4, 4, 4));
  EXPECT_NEAR(solid_volume(b.model, 0), 1.0 / 6.0, 1e-15);
  const Built as_written(cube_deck("*ELEMENT_SOLID\n7,2,1,2,4,5,5,5,5,5\n"));
  EXPECT_THAT(as_written.model.solids.node[0], ElementsAre(0, 1, 3, 3, 4, 4, 4, 4));
}

TEST(Mesh, NodalThicknessesAndOffsets) {
  const Built b(
      cube_deck("*ELEMENT_SHELL_THICKNESS\n1,1,1,2,3,4\n2.0,2.0,4.0,0.0\n*ELEMENT_SHELL\n2,1,5,6,7,8\n"
                "*SECTION_SHELL\n9,2,,3\n2.0,,,,1.0\n*PART\ntop\n9,9,1\n*ELEMENT_SHELL\n3,9,1,2,6,5\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_DOUBLE_EQ(b.model.shells.thickness[0], (2.0 + 2.0 + 4.0 + 1.25) / 4.0);
  EXPECT_DOUBLE_EQ(b.model.shells.thickness[1], 1.25);
  EXPECT_DOUBLE_EQ(b.model.shells.offset(1), 0.0);
  EXPECT_DOUBLE_EQ(b.model.shells.offset(2), -1.0);  // nodes on the top surface
  const Built own(cube_deck("*ELEMENT_SHELL_OFFSET\n1,1,1,2,3,4\n0.0\n2,1,5,6,7,8\n0.75\n"));
  EXPECT_TRUE(own.error("shell 2: offsets of single shells are not supported")) << own.all_findings();
  EXPECT_EQ(own.findings.errors(), 1);
}

TEST(Mesh, DuplicateIdsNameBothPlaces) {
  const Built b(cube_deck("*NODE\n9,1.0,1.0,1.0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n1,1,5,6,7,8\n*PART\nagain\n1,1,1\n"));
  const Finding* node = b.find(Severity::error, "node 9 is defined twice; first at");
  ASSERT_NE(node, nullptr) << b.all_findings();
  EXPECT_EQ(node->place.line, 34);
  EXPECT_NE(node->text.find(":13"), std::string::npos) << node->text;
  EXPECT_TRUE(b.error("shell 1 is defined twice"));
  EXPECT_TRUE(b.error("part 1 is defined twice"));
  EXPECT_EQ(b.model.nodes.size(), 9u);
  EXPECT_EQ(b.model.shells.size(), 1u);
}

TEST(Mesh, DanglingReferencesAllAtOnce) {
  const Built b(cube_deck(
      "*ELEMENT_SHELL\n1,1,1,2,3,44\n2,77,1,2,3,4\n3,77,1,2,3,4\n4,2,1,2,3,4\n*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n"
      "*PART\nodd\n8,88,99,,66\n*ELEMENT_SHELL\n5,8,1,2,3,4\n*PART\nwrong kind\n9,2,1\n*ELEMENT_SHELL\n6,9,1,2,3,4\n"));
  EXPECT_TRUE(b.error("shell 1: node 44 is not defined")) << b.all_findings();
  EXPECT_TRUE(b.error("part 77 is not defined; 2 of its elements, from shell 2 on"));
  EXPECT_TRUE(b.error("section 88 is not defined", "secid"));
  EXPECT_TRUE(b.error("material 99 is not defined", "mid"));
  EXPECT_TRUE(b.error("hourglass control 66 is not defined", "hgid"));
  EXPECT_TRUE(b.error("section 2 is of another kind; the part has shell elements", "secid"));
  EXPECT_TRUE(b.error("part 2 already has elements of another kind"));
}

TEST(Mesh, ElementsThatAreNotBuiltAreRefused) {
  const Built b(
      cube_deck("*ELEMENT_BEAM_OFFSET\n1,3,5,9\n0.0,1.0,0.0,0.0,1.0,0.0\n*ELEMENT_BEAM_THICKNESS\n2,3,1,5\n7.0\n"
                "*ELEMENT_SHELL_COMPOSITE\n1,1,1,2,3,4\n"));
  EXPECT_TRUE(b.error("only 0 is supported", "wy1")) << b.all_findings();
  EXPECT_TRUE(b.error("parm1 = 7 differs from TS1"));
  EXPECT_TRUE(b.error("this form of *ELEMENT_SHELL is not supported") || b.error("not built")) << b.all_findings();
}

TEST(Mesh, SidesOfBeams) {
  const Built b(cube_deck(
      "*ELEMENT_BEAM\n1,3,5,9\n2,3,5,9,2\n*ELEMENT_BEAM_ORIENTATION\n3,3,5,9\n0.0,1.0,0.5\n4,3,5,9,2\n0.0,1.0,0.5\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Beams& beams = b.model.beams;
  const auto side = [&](std::size_t e) { return beams.side(e, b.model.nodes.x); };
  const Vec3d third = b.model.nodes.x[b.model.node_index(2)] - b.model.nodes.x[b.model.node_index(5)];
  EXPECT_EQ(norm(side(0)), 0.0);
  EXPECT_EQ(norm(side(1) - third), 0.0);
  EXPECT_EQ(norm(side(2) - Vec3d{0.0, 1.0, 0.5}), 0.0);
  EXPECT_EQ(norm(side(3) - third), 0.0);  // a node comes before the vector
}

TEST(Mesh, TiedPartsOfWeldBeams) {
  const Built b(cube_deck("*ELEMENT_BEAM_PID\n4,3,5,9\n1,2\n5,3,1,9\n1,55\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"));
  EXPECT_THAT(b.model.beams.tied_parts[0], ElementsAre(0, 1)) << b.all_findings();
  EXPECT_TRUE(b.error("part 55 of end 2 is not defined"));
}

TEST(Mesh, PointMassesOfNodesSetsAndParts) {
  const Built b(cube_deck(
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_MASS\n1,9,2.5\n*SET_NODE\n1\n5,6\n*ELEMENT_MASS_NODE_SET\n2,1,0.5\n"
      "*ELEMENT_MASS_PART\n1,4.0\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  double on_sheet = 0.0, on_set = 0.0, on_nine = 0.0;
  for (const PointMass& m : b.model.masses) (m.node < 4 ? on_sheet : m.node < 8 ? on_set : on_nine) += m.mass;
  EXPECT_DOUBLE_EQ(on_nine, 2.5);
  EXPECT_DOUBLE_EQ(on_set, 0.5);  // 0.25 on each of the two
  EXPECT_DOUBLE_EQ(on_sheet, 4.0);
}

TEST(Mesh, PartMassUpToAFinalMass) {
  const Built b(cube_deck("*ELEMENT_SOLID\n1,2,1,2,3,4,5,6,7,8\n*ELEMENT_MASS_PART\n2,,8.85e-9\n"));
  double added = 0.0;
  for (const PointMass& m : b.model.masses) added += m.mass;
  EXPECT_NEAR(added, 1e-9, 1e-15) << b.all_findings();
}

TEST(Mesh, InertiaElementInLocalAxes) {
  const Built b(
      cube_deck("*ELEMENT_SHELL\n1,1,1,2,3,4\n*DEFINE_COORDINATE_VECTOR\n3,0.0,1.0,0.0,-1.0,0.0,0.0\n"
                "*ELEMENT_INERTIA\n1,5,3\n1.0,0.0,0.0,2.0,0.0,3.0,9.0\n"));
  ASSERT_EQ(b.model.inertias.size(), 1u) << b.all_findings();
  EXPECT_DOUBLE_EQ(b.model.inertias[0].mass, 9.0);
  EXPECT_THAT(b.model.inertias[0].inertia, ElementsAre(2.0, 0.0, 0.0, 1.0, 0.0, 3.0));  // local x is global y
}

TEST(Mesh, LumpedMassesAddUpToThePart) {
  const Built b(cube_deck("*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7\n*ELEMENT_BEAM\n4,3,5,9\n"));
  double sheet = 0.0, weld = 0.0;
  const auto by_part = lumped_masses(b.model);
  for (const NodeMass& n : by_part[0]) sheet += n.mass;
  for (const NodeMass& n : by_part[2]) weld += n.mass;
  EXPECT_NEAR(sheet, 7.85e-9 * 1.25 * 1.5, 1e-20);
  EXPECT_NEAR(weld, 7.85e-9 * 3.14159265358979 * 9.0 * 2.0, 1e-18);
}

TEST(Mesh, PartForms) {
  const Built b(cube_deck(
      "*PART_CONTACT\nbumper\n5,1,1\n0.1,0.1,0.0,0.0,1.5,0.8,2.0\n*ELEMENT_SHELL\n1,5,1,2,3,4\n*PART\nnothing\n6\n"));
  EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Part& p = b.model.parts[b.model.part_index(5)];
  EXPECT_EQ(p.title, "bumper");
  EXPECT_DOUBLE_EQ(p.contact_thickness, 1.5);
  EXPECT_DOUBLE_EQ(p.contact_scale, 0.8);
  EXPECT_DOUBLE_EQ(p.stiffness_scale, 2.0);
  EXPECT_TRUE(b.warning("part 6 has no elements"));
  const Built refused(cube_deck("*PART_REPOSITION\nx\n5,1,1\n"));
  EXPECT_TRUE(refused.error("option REPOSITION is not supported"));
}

}  // namespace
}  // namespace nugget::reading
