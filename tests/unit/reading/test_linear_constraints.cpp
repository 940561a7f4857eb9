// SPDX-License-Identifier: Apache-2.0
// *CONSTRAINED_LINEAR_GLOBAL, _LOCAL and what of them is refused.
#include <gmock/gmock.h>

#include "small_model.hpp"

namespace nugget::reading {
namespace {

TEST(LinearConstraintCards, AreRead) {
  const Built built(
      small_deck("*CONSTRAINED_LINEAR_GLOBAL\n7\n1,1,1.0\n2,2,-0.5\n3,6,2.0\n"
                 "*DEFINE_COORDINATE_VECTOR\n5,0.0,1.0,0.0,-1.0,0.0,0.0\n"
                 "*CONSTRAINED_LINEAR_LOCAL\n8\n1,1,5,1.0\n4,3,0,-1.0\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& all = built.model.linear_constraints;
  ASSERT_EQ(all.size(), 2u);
  ASSERT_EQ(all[0].terms.size(), 3u);
  EXPECT_EQ(all[0].id, 7);
  EXPECT_EQ(built.model.nodes.id[all[0].terms[1].node], 2);
  EXPECT_EQ(all[0].terms[1].direction.y, 1.0);
  EXPECT_EQ(all[0].terms[1].factor, -0.5);
  EXPECT_FALSE(all[0].terms[1].rotation);
  EXPECT_TRUE(all[0].terms[2].rotation);
  EXPECT_NEAR(all[1].terms[0].direction.y, 1.0, 1e-15);  // x of system 5
  EXPECT_EQ(all[1].terms[1].direction.z, 1.0);
}

TEST(LinearConstraintCards, WhatIsWrongIsRefusedByField) {
  const auto wrong = [](const std::string& cards) { return Built(small_deck("*CONSTRAINED_LINEAR_GLOBAL\n" + cards)); };
  EXPECT_TRUE(wrong("7\n1,7,1.0\n").error("", "dof"));
  EXPECT_TRUE(wrong("7\n1,1,0.0\n").error("factor of 0", "coef"));
  EXPECT_TRUE(wrong("7\n1,1,1.0\n999,1,1.0\n").error("999", "nid"));
  EXPECT_TRUE(wrong("7\n").error("without nodes", "lcid"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_LINEAR_LOCAL\n8\n1,1,5,1.0\n")).error("5", "cid"));
}

TEST(LinearConstraintCards, NodesThatMoveAlike) {
  const Built built(small_deck("*SET_NODE_LIST\n3\n1,2,4\n*CONSTRAINED_NODE_SET\n3,6\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& all = built.model.linear_constraints;
  ASSERT_EQ(all.size(), 4u);  // z and x of two nodes
  EXPECT_EQ(all[0].terms[0].direction.x, 1.0);
  EXPECT_EQ(all[1].terms[0].direction.z, 1.0);
  EXPECT_EQ(all[3].terms[1].factor, -1.0);
  EXPECT_TRUE(Built(small_deck("*SET_NODE_LIST\n3\n1,2,4\n*CONSTRAINED_NODE_SET\n3,8\n")).error("", "dof"));
  EXPECT_TRUE(
      Built(small_deck("*SET_NODE_LIST\n3\n1,2,4\n*CONSTRAINED_NODE_SET\n3,1,0.5\n")).error("part at a time", "tf"));
}

}  // namespace
}  // namespace nugget::reading
