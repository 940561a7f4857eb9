// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reading/mesh/brick_clusters.hpp"
#include "small_model.hpp"

// *DEFINE_HEX_SPOTWELD_ASSEMBLY, and RPBHX of *CONTROL_SPOTWELD_BEAM.
namespace nugget::reading {
namespace {

using ::testing::ElementsAre;

constexpr double pi = std::numbers::pi;

const std::string weld_part =
    "*PART\nwelds\n9,9,9\n*SECTION_BEAM\n9,9,1.0,,1\n6.0,6.0\n*MAT_SPOTWELD\n9,7.85e-9,210000.0,0.3,400.0\n\n";
const std::string two_beams =
    "*NODE\n31,0.5,0.5,0.0\n32,0.5,0.5,2.0\n33,2.5,0.5,0.0\n34,2.5,0.5,2.0\n"
    "*ELEMENT_BEAM\n71,9,31,32\n72,9,33,34\n";
const std::string contact = "*CONTACT_SPOTWELD\n9,1,3,3\n\n\n";

TEST(BrickClusters, ReplaceWeldBeams) {
  const Built b(small_deck(weld_part + two_beams + contact + "*CONTROL_SPOTWELD_BEAM\n,,,,,4\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  EXPECT_EQ(m.beams.size(), 0u);
  EXPECT_EQ(m.solids.size(), 8u);
  EXPECT_EQ(m.nodes.size(), 17u + 2 * 18);
  EXPECT_EQ(m.nodes.id[17], 35);  // the next free one
  ASSERT_EQ(m.hex_assemblies.size(), 2u);
  EXPECT_EQ(m.hex_assemblies[1].id, 72);
  EXPECT_THAT(m.hex_assemblies[1].solids, ElementsAre(4, 5, 6, 7));
  EXPECT_EQ(m.hex_assemblies[0].orientation.x, 1.0);
  const Part& part = m.parts[m.part_index(9)];
  EXPECT_EQ(part.kind, ElementKind::solid);
  EXPECT_EQ(m.solid_sections[part.section].elform, 1);
  const Hourglass& h = m.hourglass[part.hourglass];
  EXPECT_EQ(h.type, 6);
  EXPECT_EQ(h.membrane, 1.0);
  EXPECT_NE(
      b.find(Severity::note, "replaced by 4 bricks each: 2, of parts 9; nodes 35 to 70 and bricks 1 to 8 are new"),
      nullptr)
      << b.all_findings();
  // The first brick: centre of the octagon below, above in the same order.
  const auto& n = m.solids.node[0];
  EXPECT_EQ(m.nodes.x[n[0]].z, 0.0);
  EXPECT_EQ(m.nodes.x[n[4]].z, 2.0);
  EXPECT_EQ(m.nodes.x[n[4]].x, 0.5);
}

TEST(BrickClusters, BeamsThatAreNotInTheSetStayInAPartOfTheirOwn) {
  const Built b(
      small_deck(weld_part + two_beams + contact + "*SET_BEAM\n5\n72\n*CONTROL_SPOTWELD_BEAM\n,,,,,1,5,1000\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  ASSERT_EQ(m.beams.size(), 1u);
  EXPECT_EQ(m.beams.id[0], 71);
  EXPECT_EQ(m.beams.place[0].line, m.hex_assemblies.at(0).place.line - 1);
  const Index own = m.part_index(1009);
  ASSERT_NE(own, none);
  EXPECT_EQ(m.beams.part[0], own);
  EXPECT_EQ(m.parts[own].kind, ElementKind::beam);
  EXPECT_THAT(m.contacts.at(0).a.parts, ElementsAre(m.part_index(9), own));
  EXPECT_EQ(m.solids.size(), 1u);
  EXPECT_TRUE(m.sets.beams.at(0).members.empty());
}

const std::string only_first = contact + "*SET_BEAM\n5\n71\n*CONTROL_SPOTWELD_BEAM\n,,,,,4,5\n";

// Sabotage of each of these four: the index that the card had before the beams went.
TEST(BrickClusters, DeathOfABeamIsThatOfItsBricks) {
  const Built b(small_deck(weld_part + two_beams + only_first +
                           "*DEFINE_ELEMENT_DEATH_BEAM\n71,0.1\n*DEFINE_ELEMENT_DEATH_BEAM\n72,0.2\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& deaths = b.model.element_deaths;
  ASSERT_EQ(deaths.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(deaths[i].kind, ElementKind::solid);
    EXPECT_EQ(deaths[i].element, static_cast<Index>(i));
    EXPECT_EQ(deaths[i].time, 0.1);
  }
  EXPECT_EQ(deaths[4].kind, ElementKind::beam);
  EXPECT_EQ(b.model.beams.id.at(static_cast<std::size_t>(deaths[4].element)), 72);
}

TEST(BrickClusters, AxialForceOfABeamThatStaysIsKept) {
  const std::string curve = "*DEFINE_CURVE\n1\n0.0,0.0\n1.0,1.0\n*SET_BEAM\n6\n",
                    card = "*INITIAL_AXIAL_FORCE_BEAM\n6,1\n";
  const Built b(small_deck(weld_part + two_beams + only_first + curve + "72\n" + card));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const auto& beams = b.model.initial_state.axial_forces.at(0).beams;
  ASSERT_EQ(beams.size(), 1u);
  EXPECT_EQ(b.model.beams.id.at(static_cast<std::size_t>(beams[0])), 72);
  EXPECT_TRUE(Built(small_deck(weld_part + two_beams + only_first + curve + "71\n" + card))
                  .error("weld beam 71 is replaced by bricks (RPBHX of *CONTROL_SPOTWELD_BEAM), which take no axial"));
}

TEST(BrickClusters, SensorOfABeamThatStaysIsKept) {
  const auto with = [](const std::string& beam) {
    return Built(small_deck(weld_part + two_beams + only_first + "*SENSOR_DEFINE_ELEMENT\n8,BEAM," + beam +
                            ",AXIAL,FORCE\n*SENSOR_SWITCH\n1,SENSOR,8,GT,1.0\n*TERMINATION_SENSOR\n1\n"));
  };
  const Built b = with("72");
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.beams.id.at(static_cast<std::size_t>(b.model.sensors.at(0).element)), 72);
  EXPECT_TRUE(with("71").error("and sensor 8 measures that beam")) << with("71").all_findings();
}

TEST(BrickClusters, ACrossSectionThroughABeamGoesThroughItsBricks) {
  const Built b(small_deck(weld_part + two_beams + only_first +
                           "*SET_BEAM\n6\n71,72\n*SET_NODE\n7\n32,34\n*DATABASE_CROSS_SECTION_SET\n7,,6\n"
                           "*DATABASE_CROSS_SECTION_PLANE\n,0.0,0.0,0.5,0.0,0.0,1.5\n\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  for (const CrossSection& section : m.requests.cross_sections) {
    ASSERT_EQ(section.facets.size(), 5u);
    EXPECT_EQ(section.nodes.size(), 2u + 9u);  // nine in the upper ends of four bricks
    for (const Index n : section.nodes) EXPECT_EQ(m.nodes.x[n].z, 2.0);
    double area = 0.0;
    for (const CrossSection::Facet& facet : section.facets) {
      if (facet.kind == ElementKind::beam) {
        EXPECT_EQ(facet.element, 0);
        continue;
      }
      ASSERT_EQ(facet.corners.size(), 4u);
      std::array<Vec3d, 4> x;
      for (std::size_t i = 0; i < 4; ++i) {
        const CrossSection::Corner& c = facet.corners[i];
        x[i] = m.nodes.x[c.from] + c.share * (m.nodes.x[c.to] - m.nodes.x[c.from]);
      }
      area += 0.5 * norm(cross(x[2] - x[0], x[3] - x[1]));
    }
    EXPECT_NEAR(area, 9.0 * pi, 1e-9);
  }
}

TEST(BrickClusters, DampingOfAPartIsThatOfItsBeamsThatStay) {
  const Built b(
      small_deck(weld_part + two_beams + only_first +
                 "*DAMPING_PART_MASS\n9,1\n*DAMPING_PART_STIFFNESS\n9,0.1\n*DEFINE_CURVE\n1\n0.0,5.0\n1.0,5.0\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  ASSERT_EQ(m.damping.mass.size(), 2u);
  ASSERT_EQ(m.damping.stiffness.size(), 2u);
  EXPECT_EQ(m.damping.mass[0].part, m.solids.part[0]);
  EXPECT_EQ(m.damping.mass[1].part, m.beams.part[0]);
  EXPECT_EQ(m.damping.stiffness[1].part, m.beams.part[0]);
  EXPECT_EQ(m.damping.stiffness[1].share, 0.1);
}

TEST(BrickClusters, NodesOfABodyStayWithIt) {
  const Built b(small_deck(weld_part + two_beams + contact + "*CONTROL_SPOTWELD_BEAM\n,,,,,1\n" +
                           "*CONSTRAINED_EXTRA_NODES_NODE\n2,34\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  const Model& m = b.model;
  const std::vector<Index>& nodes =
      m.rigid_bodies.at(static_cast<std::size_t>(m.parts[m.part_index(2)].rigid_body)).nodes;
  for (std::size_t i = 4; i < 8; ++i) EXPECT_TRUE(std::ranges::count(nodes, m.solids.node.at(1)[i])) << i;
  EXPECT_TRUE(std::ranges::is_sorted(nodes));
}

TEST(BrickClusters, AnImpossibleReplacementIsAnError) {
  EXPECT_TRUE(Built(small_deck(weld_part + two_beams + contact + "*CONTROL_SPOTWELD_BEAM\n,,,,,16\n"))
                  .error("expected 0, 1, 4 or 8", "rpbhx"));
  const std::string flat = "*NODE\n31,0.5,0.5,0.0\n32,0.5,0.5,0.0\n*ELEMENT_BEAM\n71,9,31,32\n";
  EXPECT_TRUE(Built(small_deck(weld_part + flat + contact + "*CONTROL_SPOTWELD_BEAM\n,,,,,4\n"))
                  .error("weld beam 71 has no length"));
  EXPECT_TRUE(Built(small_deck(weld_part + two_beams + contact + "*CONTROL_SPOTWELD_BEAM\n,,7,,,4\n"))
                  .error("stand on more than one place of a shell", "t_ort"));
}

/// T_ORT 7 with two curves, each from `first` to `last`, at the table's values 0 and `value`.
std::string place_table(double value, double last) {
  return weld_part + two_beams + contact + "*CONTROL_SPOTWELD_BEAM\n,,7\n*DEFINE_TABLE_2D\n7\n" +
         fmt::format("0.0,11\n{},12\n", value) + "*DEFINE_CURVE\n11\n0.0,1.0\n" + fmt::format("{},1.0\n", last) +
         "*DEFINE_CURVE\n12\n0.0,1.0\n" + fmt::format("{},3.0\n", last);
}

TEST(WeldPlace, TheAxisBeyondOneIsTheAngle) {
  const Built angles_on_curves(small_deck(place_table(1.0, 45.0))), angles_in_table(small_deck(place_table(45.0, 1.0)));
  for (const Built* b : {&angles_on_curves, &angles_in_table}) {
    const WeldBeamControl& c = b->model.control.weld_beams;
    EXPECT_NEAR(c.tension_place.at(0.5, 22.5), 1.5, 1e-12);  // half of half of the way from 1 to 3
    EXPECT_NEAR(c.tension_place.at(1.0, 45.0), 3.0, 1e-12);
    EXPECT_NEAR(c.shear_place.at(0.5, 22.5), 1.5, 1e-12);  // T_ORS 0
  }
  EXPECT_EQ(angles_on_curves.model.control.weld_beams.tension_place.at(0.0, 45.0), 1.0);
}

TEST(WeldPlace, AnAxisThatCannotBeToldIsRefused) {
  EXPECT_TRUE(Built(small_deck(place_table(1.0, 1.0))).error("do not reach beyond 1", "t_ort"));
  EXPECT_TRUE(Built(small_deck(place_table(45.0, 45.0))).error("both reach beyond 1", "t_ort"));
}

const std::string bricks =
    "*PART\nwelds\n9,9,9,,9\n*SECTION_SOLID\n9\n*HOURGLASS\n9,6,1.0\n*MAT_SPOTWELD\n9,7.85e-9,210000.0,0.3,400.0\n\n"
    "*NODE\n31,0.0,0.0,1.0\n32,1.0,0.0,1.0\n33,1.0,1.0,1.0\n34,0.0,1.0,1.0\n"
    "*NODE\n35,0.0,0.0,2.0\n36,1.0,0.0,2.0\n37,1.0,1.0,2.0\n38,0.0,1.0,2.0\n"
    "*ELEMENT_SOLID\n1,9,1,2,3,4,31,32,33,34\n2,9,31,32,33,34,35,36,37,38\n";

TEST(HexAssembly, NamesItsBricks) {
  const Built b(small_deck(bricks + "*DEFINE_HEX_SPOTWELD_ASSEMBLY\n500\n2,1\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  EXPECT_EQ(b.model.hex_assemblies.at(0).id, 500);
  EXPECT_THAT(b.model.hex_assemblies.at(0).solids, ElementsAre(1, 0));
}

TEST(HexAssembly, FaultsAreToldAtTheirFields) {
  const auto with = [](const std::string& cards) { return Built(small_deck(bricks + cards)); };
  EXPECT_TRUE(with("*DEFINE_HEX_SPOTWELD_ASSEMBLY_4\n500\n1,2\n").error("2 bricks are named, expected 4", "eid1"));
  EXPECT_TRUE(with("*DEFINE_HEX_SPOTWELD_ASSEMBLY\n500\n1,7\n").error("solid 7 is not defined", "eid2"));
  EXPECT_TRUE(with("*DEFINE_HEX_SPOTWELD_ASSEMBLY\n500\n1,1\n").error("belongs to an assembly already", "eid2"));
  EXPECT_TRUE(with("*DEFINE_HEX_SPOTWELD_ASSEMBLY\n500\n\n").error("no brick is named", "eid1"));
}

TEST(Checks, BrickWeldsWithoutTheirHourglassControlAreWarnedOf) {
  EXPECT_FALSE(Built(small_deck(bricks)).warning("hourglass control type"));
  std::string other = bricks;
  other.replace(other.find("9,6,1.0"), 7, "9,2,0.1");
  EXPECT_TRUE(Built(small_deck(other)).warning("have hourglass control type 2 with QM = 0.1"));
}

}  // namespace
}  // namespace nugget::reading
