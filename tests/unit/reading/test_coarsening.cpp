// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/reading/small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

/// A sheet of 4 x 2 shells of 1 mm; node (i, j) has the id 1 + 5 j + i.
std::string sheet(const std::string& more) {
  std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 5; ++i)
      nodes += std::to_string(1 + 5 * j + i) + "," + std::to_string(i) + "," + std::to_string(j) + ",0\n";
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 4; ++i) {
      const int n = 1 + 5 * j + i;
      shells += std::to_string(11 + 4 * j + i) + ",1," + std::to_string(n) + "," + std::to_string(n + 1) + "," +
                std::to_string(n + 6) + "," + std::to_string(n + 5) + "\n";
    }
  return "*KEYWORD\n*CONTROL_TERMINATION\n1.0\n*PART\nsheet\n1,1,1\n*SECTION_SHELL\n1,2\n1.0,1.0,1.0,1.0\n"
         "*MAT_ELASTIC\n1,7.85e-9,210000.0,0.3\n" +
         nodes + shells + more + "*END\n";
}

TEST(Coarsening, TheCardIsRead) {
  const Built b(
      sheet("*SET_PART_LIST\n3\n1\n*CONTROL_COARSEN\n1,6.0,2,3,4.5\n7,9\n*DEFINE_BOX_COARSEN\n1,0,1,2,3,4,5,1\n"));
  EXPECT_EQ(b.all_findings(), "");
  const CoarsenControl& c = b.model.coarsen;
  EXPECT_TRUE(c.on);
  EXPECT_EQ(c.angle, 6.0);
  EXPECT_EQ(c.largest, 4.5);
  EXPECT_THAT(c.kept_parts, ElementsAre(0));
  EXPECT_THAT(c.seeds, ElementsAre(6, 8));
  ASSERT_EQ(c.boxes.size(), 1u);
  EXPECT_EQ(c.boxes[0].high.z, 5.0);
  EXPECT_TRUE(c.boxes[0].outside);
  const Built blank(sheet("*CONTROL_COARSEN\n1\n"));
  EXPECT_EQ(blank.model.coarsen.angle, 8.0);
  EXPECT_FALSE(Built(sheet("*CONTROL_COARSEN\n0,6.0\n")).model.coarsen.on);
}

TEST(Coarsening, WhatIsWrongIsTold) {
  EXPECT_TRUE(Built(sheet("*CONTROL_COARSEN\n3\n")).error("", "icoarse"));
  EXPECT_TRUE(Built(sheet("*CONTROL_COARSEN\n1,8.0,1\n99\n")).error("node 99 is not defined", "n1"));
  EXPECT_TRUE(Built(sheet("*CONTROL_COARSEN\n1,8.0,0,5\n")).error("part set 5 is not defined", "psid"));
  EXPECT_TRUE(Built(sheet("*CONSTRAINED_ADAPTIVITY\n2,1,1\n")).error("are not three places", "mn1"));
  EXPECT_TRUE(Built(sheet("*CONSTRAINED_ADAPTIVITY\n2,1,99\n")).error("node 99 is not defined", "mn2"));
}

TEST(Coarsening, HangingNodesOfTheDeck) {
  const Built b(sheet("*CONSTRAINED_ADAPTIVITY\n2,1,3\n12,11,13\n"));
  EXPECT_EQ(b.all_findings(), "");
  ASSERT_EQ(b.model.hanging_nodes.size(), 2u);
  EXPECT_EQ(b.model.hanging_nodes[1].node, 11);
  EXPECT_THAT(b.model.hanging_nodes[1].ends, ElementsAre(10, 12));
}

// What a deck is read with for the second time: the mesh, and sets that choose by part, are those of merged shells.
TEST(Coarsening, MergedShellsTakeTheirPlaceInTheMesh) {
  Findings findings;
  const deck::Deck deck = deck::read_text(
      sheet("*CONTROL_COARSEN\n1,8.0,1\n7\n*SET_SHELL_GENERAL\n1\nPART,1\n*SET_NODE_GENERAL\n1\nPART,1\n"), findings);
  Coarsening merged;
  merged.merged.push_back({{11, 12, 15, 16}, {1, 3, 13, 11}});
  merged.hanging.push_back({8, {3, 13}});
  merged.removed_nodes = {2, 6, 7, 12};
  const Model model = build(deck, findings, false, nullptr, &merged);
  EXPECT_EQ(findings.all().size(), 0u);
  EXPECT_THAT(model.nodes.id, ElementsAre(1, 3, 4, 5, 8, 9, 10, 11, 13, 14, 15));
  EXPECT_THAT(model.shells.id, ElementsAre(11, 13, 14, 17, 18));
  EXPECT_THAT(model.shells.node[0], ElementsAre(0, 1, 8, 7));
  EXPECT_EQ(model.shells.thickness[0], 1.0);
  EXPECT_EQ(model.sets.shells[0].members.size(), 5u);
  EXPECT_EQ(model.sets.nodes[0].members.size(), 11u);
  ASSERT_EQ(model.hanging_nodes.size(), 1u);
  EXPECT_EQ(model.hanging_nodes[0].node, 4);
  EXPECT_THAT(model.hanging_nodes[0].ends, ElementsAre(1, 8));
}

// Names one by one and in lists, which merging must leave alone; what sets choose by part is not named.
TEST(Coarsening, WhatCardsNameIsKept) {
  const Built b(
      sheet("*SET_NODE_LIST\n1\n7,8\n*SET_NODE_GENERAL\n2\nPART,1\n*SET_SHELL_LIST\n1\n12\n*ELEMENT_MASS\n1,3,1e-6\n"));
  EXPECT_THAT(b.model.listed_nodes, ElementsAre(6, 7));
  EXPECT_THAT(b.model.named_nodes, ElementsAre(2));
  EXPECT_THAT(b.model.listed_shells, ElementsAre(1));
}

}  // namespace
}  // namespace nugget::reading
