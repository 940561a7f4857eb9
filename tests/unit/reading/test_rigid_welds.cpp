// SPDX-License-Identifier: Apache-2.0
// Nodal rigid bodies that are welds, and rivets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

std::vector<int> user_ids(const Model& model, const std::vector<Index>& nodes) {
  std::vector<int> ids;
  for (const Index n : nodes) ids.push_back(model.nodes.id[n]);
  return ids;
}

/// Sheet 1 below, sheet 4 (nodes 31 to 34) above it by 1.2, and sheet 5 (41 to 44) by 2.4.
std::string stacked_deck(const std::string& more) {
  return small_deck(R"(*PART
above
         4         1         1
*PART
top
         5         1         1
*NODE
      31             0.0             0.0             1.2
      32             1.0             0.0             1.2
      33             1.0             1.0             1.2
      34             0.0             1.0             1.2
      41             0.0             0.0             2.4
      42             1.0             0.0             2.4
      43             1.0             1.0             2.4
      44             0.0             1.0             2.4
*ELEMENT_SHELL
       4       4      31      32      33      34
       5       5      41      42      43      44
)" + more);
}

TEST(RigidWelds, NodalBodiesOfANodeASheetAreWelds) {
  const auto welds = [](const std::string& set, const std::string& form = "") {
    const Built b(stacked_deck("*CONSTRAINED_NODAL_RIGID_BODY" + form + "\n        40         0        90\n" +
                               (form.empty() ? "" : "       1.0         7         7\n") +
                               "*SET_NODE_LIST\n        90\n" + set + "\n"));
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    return b.model.rigid_welds;
  };
  const auto two = welds("         3        33");
  ASSERT_EQ(two.size(), 1u);
  EXPECT_EQ(two[0].kind, RigidWeld::Kind::nodal_body);
  EXPECT_EQ(two[0].id, 40);
  EXPECT_FALSE(two[0].can_fail());
  const auto three = welds("        33         3        43");
  ASSERT_EQ(three.size(), 1u);
  EXPECT_THAT(user_ids(Built(stacked_deck("")).model, three[0].nodes), ElementsAre(3, 33, 43)) << "along the line";
  EXPECT_TRUE(welds("         1         3").empty()) << "one sheet";
  EXPECT_TRUE(welds("         1         3        33").empty()) << "two nodes of one sheet";
  EXPECT_TRUE(welds("         3        20").empty()) << "a node of no sheet";
  EXPECT_TRUE(welds("         3        33", "_SPC").empty()) << "held: a support";
}

TEST(RigidWelds, Rivets) {
  const Built b(
      stacked_deck("*CONSTRAINED_RIVET\n         3        33\n         4        34       0.5\n"
                   "*CONSTRAINED_RIVET_ID\n        77\n         1        31   1.0E+20\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(b.model.rigid_welds.size(), 3u);
  const RigidWeld& second = b.model.rigid_welds[1];
  EXPECT_EQ(second.kind, RigidWeld::Kind::rivet);
  EXPECT_EQ(second.id, 2);
  EXPECT_EQ(second.body, none);
  EXPECT_THAT(user_ids(b.model, second.nodes), ElementsAre(4, 34));
  EXPECT_EQ(second.failure_time, 0.5);
  EXPECT_EQ(b.model.rigid_welds[2].id, 77);
  EXPECT_EQ(b.model.rigid_welds[2].failure_time, 0.0) << "1e20 is never";
  EXPECT_TRUE(Built(stacked_deck("*CONSTRAINED_RIVET\n         3         3\n")).error("at one place", "n2"));
  EXPECT_TRUE(Built(stacked_deck("*CONSTRAINED_RIVET\n         3       999\n")).error("node 999 is not defined", "n2"));
}

// ---- fillets and butt welds

const std::string along_x = "*DEFINE_COORDINATE_SYSTEM\n5,0.0,0.0,0.0,1.0,0.0,0.0\n0.0,1.0,0.0\n";
std::string set_of(const std::string& nodes) {
  return "*SET_NODE_LIST\n90\n" + nodes + "\n";
}
std::vector<int> ends(const Model& model, std::size_t seam) {
  const RigidWeld& weld = model.rigid_welds.at(0);
  return {model.nodes.id[weld.nodes[weld.seams.at(seam).nodes[0]]],
          model.nodes.id[weld.nodes[weld.seams.at(seam).nodes[1]]]};
}

TEST(RigidWelds, AFilletWeld) {
  const Built b(stacked_deck(along_x + set_of("43,33,3") +
                             "*CONSTRAINED_GENERALIZED_WELD_FILLET_ID\n12\n90,5,4,0.2\n"
                             "0.5,0.3,250.0,0.8,10.0,,4.0,30.0\n"));
  ASSERT_EQ(b.findings.errors(), 0) << b.all_findings();
  ASSERT_EQ(b.model.rigid_welds.size(), 1u);
  const RigidWeld& weld = b.model.rigid_welds[0];
  EXPECT_EQ(weld.kind, RigidWeld::Kind::fillet);
  EXPECT_EQ(weld.id, 12);
  EXPECT_EQ(weld.filter, 4);
  EXPECT_EQ(weld.window, 0.2);
  EXPECT_TRUE(weld.can_fail());
  ASSERT_EQ(weld.seams.size(), 2u);
  EXPECT_THAT(ends(b.model, 0), ElementsAre(33, 43)) << "the upper sheet is pulled off the lower one";
  EXPECT_THAT(ends(b.model, 1), ElementsAre(3, 33));
  EXPECT_DOUBLE_EQ(weld.seams[0].strength, 250.0 * 10.0 * 4.0 / 0.8);
  EXPECT_EQ(weld.seams[0].failure_time, 0.5);
  EXPECT_EQ(weld.seams[0].failure_strain, 0.3);
  EXPECT_NEAR(weld.seams[0].tension.z, 1.0, 1e-15);
  EXPECT_NEAR(weld.seams[0].normal.x, -0.5, 1e-15);
  EXPECT_NEAR(weld.seams[0].normal.z, std::sqrt(0.75), 1e-15);
}

// Squares 1 and 4 stand on each other; two nodes at one place get their sides from the sheets they belong to.
TEST(RigidWelds, SeamsAtOnePlaceKnowTheirSheets) {
  const auto butt = [](const std::string& nodes) {
    const Built b(
        small_deck("*PART\nbeside\n4,1,1\n*NODE\n31,1.0,0.0,0.0\n32,2.0,0.0,0.0\n33,2.0,1.0,0.0\n34,1.0,1.0,0.0\n"
                   "*ELEMENT_SHELL\n4,4,31,32,33,34\n" +
                   along_x + set_of(nodes) + "*CONSTRAINED_GENERALIZED_WELD_BUTT\n90,5\n,,250.0,,10.0,4.0\n"));
    EXPECT_EQ(b.findings.errors(), 0) << b.all_findings();
    return ends(b.model, 0);
  };
  EXPECT_THAT(butt("2,31"), ElementsAre(2, 31));
  EXPECT_THAT(butt("31,2"), ElementsAre(2, 31)) << "x points from the sheet of node 2 to that of node 31";
}

TEST(RigidWelds, CrossFilletsAndCombinedWelds) {
  const Built cross(stacked_deck(along_x + set_of("3,33,43") +
                                 "*CONSTRAINED_GENERALIZED_WELD_CROSS_FILLET\n90,5,,,2\n,,250.0,,10.0,,4.0\n"
                                 "33,3\n43,33,5\n"));
  ASSERT_EQ(cross.findings.errors(), 0) << cross.all_findings();
  ASSERT_EQ(cross.model.rigid_welds.at(0).seams.size(), 2u);
  EXPECT_THAT(ends(cross.model, 0), ElementsAre(3, 33));
  EXPECT_EQ(cross.model.rigid_welds[0].seams[1].strength, 10000.0);

  const Built combined(stacked_deck(along_x + set_of("3,33,43") +
                                    "*CONSTRAINED_GENERALIZED_WELD_COMBINED\n90,5,,,2\n,,250.0,,10.0,,4.0\n3,33\n"
                                    ",0.1,100.0,,10.0,,4.0\n33,43,5,1\n"));
  ASSERT_EQ(combined.findings.errors(), 0) << combined.all_findings();
  const auto& seams = combined.model.rigid_welds.at(0).seams;
  ASSERT_EQ(seams.size(), 2u);
  EXPECT_NEAR(seams[0].tension.z, 1.0, 1e-15);
  EXPECT_NEAR(seams[1].tension.x, 1.0, 1e-15) << "WTYP 1: butt";
  EXPECT_EQ(seams[1].strength, 4000.0);
  EXPECT_EQ(seams[1].failure_strain, 0.1);
  EXPECT_EQ(seams[0].failure_strain, 0.0);
}

TEST(RigidWelds, FaultsOfSeams) {
  const auto built = [](const std::string& nodes, const std::string& cards) {
    return Built(stacked_deck(along_x + set_of(nodes) + "*CONSTRAINED_GENERALIZED_WELD_" + cards));
  };
  EXPECT_TRUE(built("3,33,43", "BUTT\n90,5\n").error("joins two nodes, the set has 3", "nsid"));
  EXPECT_TRUE(built("3,33,43,4", "FILLET\n90,5\n").error("two or three nodes, the set has 4", "nsid"));
  EXPECT_TRUE(built("3,33", "FILLET\n90\n,,250.0,,10.0,,4.0\n").error("directions of the weld", "cid"));
  EXPECT_TRUE(built("3,33", "FILLET\n90,5\n,,250.0,,10.0\n").error("length times thickness", "a"));
  EXPECT_TRUE(built("3,33", "BUTT\n90,5\n,,250.0,,,2.0\n").error("length times thickness", "l"));
  EXPECT_TRUE(built("3,33", "BUTT\n90,5\n,,250.0,,10.0,2.0,5.0\n").warning("not public", "lt"));
  EXPECT_TRUE(built("3,33", "CROSS_FILLET\n90,5,,,1\n\n3,43\n").error("not in the set", "nodeb"));
  EXPECT_TRUE(built("3,33,43", "CROSS_FILLET\n90,5,,,1\n\n3,33\n").error("node 43 of the set is in no pair", "nsid"));
  EXPECT_TRUE(built("3,33,4,34", "CROSS_FILLET\n90,5,,,2\n\n3,33\n4,34\n").error("no node in common", "nsid"));
  EXPECT_TRUE(built("3,33", "COMBINED\n90,5\n").error("", "npr"));
  EXPECT_TRUE(built("3,33", "COMBINED\n90,5,,,1\n,,,,,,,100.0\n3,33\n").error("", "alpha"));
}

}  // namespace
}  // namespace nugget::reading
