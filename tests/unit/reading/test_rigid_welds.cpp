// SPDX-License-Identifier: Apache-2.0
// Nodal rigid bodies that are welds, and rivets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace nugget::reading
