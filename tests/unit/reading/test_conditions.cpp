// SPDX-License-Identifier: Apache-2.0
// Requests, boundary and initial conditions, loads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/index.hpp"
#include "model/history_files.hpp"
#include "small_model.hpp"

namespace nugget::reading {
namespace {

using testing::ElementsAre;

void expect_vector(const Vec3d& v, double x, double y, double z) {
  EXPECT_NEAR(v.x, x, 1e-12);
  EXPECT_NEAR(v.y, y, 1e-12);
  EXPECT_NEAR(v.z, z, 1e-12);
}

// ---- nodes held

TEST(Constraints, NodesInAPlane) {
  const std::string more = "*NODE\n801,5.0,7.0,0.0\n802,5.0,8.0,1.0\n803,5.001,8.0,1.0\n";
  const auto held = [](const Built& b) {
    std::vector<int> ids;
    for (const SinglePointConstraint& s : b.model.spcs)
      if (const int id = b.model.nodes.id[s.node]; id > 800) ids.push_back(id);
    return ids;
  };
  const Built exact(small_deck(more + "*CONSTRAINED_GLOBAL\n1,5,1,5.0,0.0,0.0\n"));
  ASSERT_EQ(exact.findings.errors(), 0) << exact.all_findings();
  EXPECT_THAT(held(exact), ElementsAre(801, 802));
  EXPECT_EQ(exact.model.spcs.back().fixed, 0b110001U);  // x; about y and z
  EXPECT_THAT(held(Built(small_deck(more + "*CONSTRAINED_GLOBAL\n1,5,1,5.0,0.0,0.0,0.01\n"))),
              ElementsAre(801, 802, 803));
  EXPECT_THAT(held(Built(small_deck(more + "*CONSTRAINED_GLOBAL\n1,5,2,0.0,7.0,0.0\n"))), ElementsAre(801));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_GLOBAL\n1,5,3,0.0,0.0,-777.0\n")).warning("no node lies in this plane"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_GLOBAL\n1,5\n")).warning("nothing is held", "dir"));
}

// ---- *DATABASE

TEST(Database, IntervalsAndFormats) {
  const Built built(small_deck(R"(*DATABASE_GLSTAT
    1.0E-3         2
*DATABASE_SWFORC
       0.0         0         7
*DATABASE_BINARY_D3PLOT
       0.0         0         0        20
*DATABASE_EXTENT_BINARY
         0         0         5         1
         0         1         4
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const Requests& requests = built.model.requests;
  EXPECT_EQ(requests["glstat"].interval, 1e-3);
  EXPECT_TRUE(requests["glstat"].binout());
  EXPECT_FALSE(requests["glstat"].ascii());
  EXPECT_FALSE(requests["matsum"].asked());
  EXPECT_NE(requests["swforc"].curve, none);
  EXPECT_EQ(requests["swforc"].interval, 2.0);
  EXPECT_DOUBLE_EQ(requests.d3plot.interval, 0.05);
  EXPECT_EQ(requests.layers, 5);
  EXPECT_TRUE(requests.strains);
  EXPECT_TRUE(requests.one_state_a_file);
  EXPECT_EQ(requests.beam_points, 4);
}

TEST(Database, HistoriesInLocalAxes) {
  const auto axes = [](int flag) { return "*DEFINE_COORDINATE_NODES\n3,1,2,4," + std::to_string(flag) + "\n"; };
  const Built built(small_deck("*DATABASE_HISTORY_NODE_LOCAL_ID\n4,3,1\nsensor\n4,0,1\nglobal\n" + axes(0)));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& nodes = built.model.requests.history_nodes;
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].heading, "sensor");
  EXPECT_EQ(nodes[0].system, 0);
  EXPECT_TRUE(nodes[0].turning) << "REF 1 turns them whatever FLAG says";
  EXPECT_EQ(nodes[1].system, none);
  EXPECT_TRUE(Built(small_deck("*DATABASE_HISTORY_NODE_LOCAL\n4,3,0\n" + axes(1))).error("need a system", "ref"));
  const std::string relative = "*DATABASE_HISTORY_NODE_LOCAL\n4,3,2\n" + axes(0);
  const Built seen_from_axes(small_deck(relative));
  ASSERT_EQ(seen_from_axes.findings.errors(), 0) << seen_from_axes.all_findings();
  EXPECT_TRUE(seen_from_axes.model.requests.history_nodes[0].relative);
  EXPECT_TRUE(Built(small_deck(relative + "*CONTROL_DYNAMIC_RELAXATION\n,,,,,,,1\n")).error("relaxation", "ref"));
  EXPECT_TRUE(Built(small_deck("*DATABASE_HISTORY_NODE_LOCAL\n4,3,1\n*DEFINE_COORDINATE_VECTOR\n3,0.0,2.0,0.0,1.0\n"))
                  .error("the nodes that they turn with", "ref"));
}

TEST(Database, HistoriesOfNodesSetsAndHeadings) {
  const Built built(small_deck(R"(*DATABASE_HISTORY_NODE
         4         1         0        99
        20
*DATABASE_HISTORY_NODE_SET
         1
*DATABASE_HISTORY_SHELL_ID
         2the block
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  std::vector<int> ids;
  for (const auto& e : built.model.requests.history_nodes) ids.push_back(built.model.nodes.id[e.index]);
  EXPECT_THAT(ids, ElementsAre(4, 1, 20, 2, 3)) << "each node once, in the deck's order";
  ASSERT_EQ(built.model.requests.history_shells.size(), 1u);
  EXPECT_EQ(built.model.requests.history_shells[0].heading, "the block");
  EXPECT_TRUE(built.warning("is not in the model", "id4"));
}

TEST(Database, WhatIsNotWrittenIsSaid) {
  const Built built(small_deck(R"(*DATABASE_NCFORC
    1.0E-3
*DATABASE_BINARY_RUNRSF
    1000.0
*DATABASE_SOMETHING_NEW
    1.0E-3
*DATABASE_NODOUT
    1.0E-3         0         0         1    1.0E-5
*DATABASE_EXTENT_BINARY
         4         0        -3
)"));
  EXPECT_EQ(built.findings.errors(), 0) << built.all_findings();
  EXPECT_TRUE(built.warning("ncforc"));
  EXPECT_TRUE(built.find(Severity::note, "zeros follow", "neiph"));
  EXPECT_TRUE(built.warning("not written", "option1"));
  EXPECT_TRUE(built.warning("the mean over a shell's in-plane points", "maxint"));
  EXPECT_EQ(built.model.requests.layers, 3);
  const auto status = [&](std::string_view keyword) {
    const auto& uses = built.model.keyword_uses;
    return std::find_if(uses.begin(), uses.end(), [&](const KeywordUse& e) { return e.keyword == keyword; })->status;
  };
  EXPECT_EQ(status("DATABASE_BINARY_RUNRSF"), KeywordStatus::ignored);
  EXPECT_EQ(status("DATABASE_SOMETHING_NEW"), KeywordStatus::refused);
  EXPECT_TRUE(Built(small_deck("*DATABASE_BINARY_D3PLOT\n       0.1        77\n")).error("not defined", "lcdt"));
}

// ---- *BOUNDARY

TEST(Boundary, SinglePointConstraints) {
  const Built built(small_deck(R"(*BOUNDARY_SPC_NODE
         4         0         1         0         1         0         0         1
*BOUNDARY_SPC_SET_BIRTH_DEATH_ID
        17clamp
         1         5         0         1
       0.1       0.0
*DEFINE_COORDINATE_SYSTEM
         5       0.0       0.0       0.0       0.0       1.0       0.0
      -1.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& spcs = built.model.spcs;
  ASSERT_EQ(spcs.size(), 4u);
  EXPECT_EQ(spcs[0].node, built.model.node_index(4));
  EXPECT_EQ(spcs[0].fixed, 0b100101u);
  EXPECT_EQ(spcs[0].set_id, 0);
  EXPECT_EQ(spcs[0].death, forever);
  EXPECT_EQ(spcs[3].id, 17);
  EXPECT_EQ(spcs[3].set_id, 1);
  EXPECT_EQ(spcs[3].system, 0);
  EXPECT_EQ(spcs[3].fixed, 0b10u);
  EXPECT_EQ(spcs[3].birth, 0.1);
  EXPECT_EQ(spcs[3].death, forever);
}

TEST(Boundary, SinglePointConstraintFaults) {
  const Built built(small_deck(R"(*BOUNDARY_SPC_NODE
        99         0         1
*BOUNDARY_SPC_SET
         1         8         2
)"));
  EXPECT_TRUE(built.error("node 99 is not defined", "nid"));
  EXPECT_TRUE(built.error("coordinate system 8 is not defined", "cid"));
  EXPECT_TRUE(built.error("0 to 1", "dofx"));
}

TEST(Boundary, PrescribedMotions) {
  const Built built(small_deck(R"(*BOUNDARY_PRESCRIBED_MOTION_SET_ID
         3push
         1         3         2         7      -2.0
*BOUNDARY_PRESCRIBED_MOTION_NODE
         4        -4         0         7       0.0         6       0.5       0.1
*BOUNDARY_PRESCRIBED_MOTION_RIGID
         2         6         1         7
*DEFINE_VECTOR
         6       1.0       1.0       0.0       4.0       5.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& motions = built.model.motions;
  ASSERT_EQ(motions.size(), 3u);
  EXPECT_EQ(motions[0].id, 3);
  EXPECT_EQ(motions[0].nodes.size(), 3u);
  expect_vector(motions[0].direction, 0, 0, 1);
  EXPECT_EQ(motions[0].quantity, PrescribedMotion::Quantity::displacement);
  EXPECT_EQ(motions[0].scale, -2.0);
  EXPECT_EQ(motions[0].death, forever);
  EXPECT_TRUE(motions[0].only_direction);

  expect_vector(motions[1].direction, 0.6, 0.8, 0);
  EXPECT_FALSE(motions[1].only_direction);
  EXPECT_EQ(motions[1].scale, 1.0);
  EXPECT_EQ(motions[1].birth, 0.1);
  EXPECT_EQ(motions[1].death, 0.5);

  EXPECT_TRUE(motions[2].rotation);
  expect_vector(motions[2].direction, 0, 1, 0);
  EXPECT_EQ(motions[2].quantity, PrescribedMotion::Quantity::acceleration);
  EXPECT_EQ(motions[2].rigid_body, built.model.parts[1].rigid_body);
}

TEST(Boundary, PrescribedMotionFaults) {
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_SET\n         1        12         0         7\n"))
                  .error("1 to 8", "dof"));
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n         2        11         0         7\n\n"))
                  .error("not rigid bodies", "dof"));
  EXPECT_TRUE(
      Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_SET\n         1         9         0         7       1.0        "
                       "-5\n       1.0\n*DEFINE_COORDINATE_VECTOR\n5,1.0,0.0,0.0,0.0,1.0,0.0\n"))
          .error("axis by offsets", "vid"));
  EXPECT_TRUE(
      Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_SET\n         1         1         0         7       1.0        "
                       "-6\n"))
          .error("not defined", "vid"));
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_SET\n         1         1         4         7\n"))
                  .error("velocity", "vad"));
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_SET\n         1         4         0         7\n"))
                  .error("needs a vector", "vid"));
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_SET\n         1         1         0         8\n"))
                  .error("not defined", "lcid"));
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n         1         1         0         7\n"))
                  .error("not rigid", "pid"));
  EXPECT_TRUE(Built(small_deck("*BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL\n         2         1         0         7\n"))
                  .error("local axes", "pid"));
}

TEST(Boundary, MotionsAroundAnAxis) {
  const Built built(small_deck(R"(*BOUNDARY_PRESCRIBED_MOTION_SET
         1       -10         2         7       0.5
       3.0       4.0         2
         1         9         0         7
       3.0       4.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  EXPECT_TRUE(built.warning("VAD 4", "lrb"));
  const auto& motions = built.model.motions;
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_TRUE(motions[0].circular && !motions[0].rotation && !motions[0].radius_fixed);
  expect_vector(motions[0].direction, 0, 1, 0);
  expect_vector(motions[0].center, 4, 0, 3);
  EXPECT_TRUE(motions[1].circular && motions[1].radius_fixed);
  expect_vector(motions[1].direction, 1, 0, 0);
  expect_vector(motions[1].center, 0, 3, 4);
}

TEST(Boundary, NodesOfRigidBodiesAreNotMovedOneByOne) {
  const Built built(small_deck(R"(*BOUNDARY_SPC_NODE
         5         0         1
*BOUNDARY_PRESCRIBED_MOTION_NODE
         6         1         0         7
)"));
  EXPECT_TRUE(built.model.spcs.empty());
  EXPECT_TRUE(built.warning("node 5 belongs to rigid body 2", "nid"));
  EXPECT_TRUE(built.error("node 6 belongs to rigid body 2", "nid"));
}

TEST(Boundary, LocalMotionFollowsTheAxesOfItsBody) {
  const Built built(small_deck(R"(*BOUNDARY_PRESCRIBED_MOTION_RIGID_LOCAL
        40         1         0         7
*CONSTRAINED_NODAL_RIGID_BODY
        40         5         1
*DEFINE_COORDINATE_SYSTEM
         5       0.0       0.0       0.0       0.0       1.0       0.0
      -1.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  expect_vector(built.model.motions.at(0).direction, 0, 1, 0);
  EXPECT_EQ(built.model.motions[0].target, PrescribedMotion::Target::rigid_body_local);
}

// ---- *INITIAL_VELOCITY

Vec3d velocity(const Built& built, int node) {
  return built.model.initial_velocity.at(at(built.model.node_index(node)));
}
Vec3d spin(const Built& built, int node) {
  return built.model.initial_spin.at(at(built.model.node_index(node)));
}

TEST(InitialVelocity, LastDefinitionWinsAndExemptNodesGetTheirOwn) {
  const Built built(small_deck(R"(*INITIAL_VELOCITY
         0         1
       1.0       2.0       3.0       4.0
       7.0
*INITIAL_VELOCITY_NODE
         4      -5.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  expect_vector(velocity(built, 20), 1, 2, 3);
  expect_vector(spin(built, 20), 4, 0, 0);
  expect_vector(velocity(built, 1), 7, 0, 0);
  expect_vector(spin(built, 1), 0, 0, 0);
  expect_vector(velocity(built, 4), -5, 0, 0);
}

TEST(InitialVelocity, BoxAndLocalAxes) {
  const Built built(small_deck(R"(*INITIAL_VELOCITY
         0         0         2         0         5
       1.0
*DEFINE_BOX
         2      -0.5       0.5      -9.0       9.0      -9.0       9.0
*DEFINE_COORDINATE_SYSTEM
         5       0.0       0.0       0.0       0.0       1.0       0.0
      -1.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  expect_vector(velocity(built, 1), 0, 1, 0);
  expect_vector(velocity(built, 20), 0, 1, 0);
  expect_vector(velocity(built, 2), 0, 0, 0);
}

TEST(InitialVelocity, GenerationTurnsAboutItsAxis) {
  const std::string axis =
      "*INITIAL_VELOCITY_GENERATION\n         1         2       2.0       0.0       0.0       9.0\n";
  const Built built(small_deck(axis + "       1.0       0.0       0.0       0.0       0.0       3.0\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  expect_vector(velocity(built, 1), 0, -2, 9);
  expect_vector(velocity(built, 3), -2, 0, 9);
  expect_vector(spin(built, 3), 0, 0, 2);
  expect_vector(velocity(built, 5), 0, 0, 0);

  const Built nodes(small_deck(axis + "       0.0       0.0       0.0    -999.0         1        20\n"));
  ASSERT_EQ(nodes.findings.errors(), 0) << nodes.all_findings();
  expect_vector(velocity(nodes, 2), 0, 2, 9);

  EXPECT_TRUE(Built(small_deck(axis)).error("no length", "nx"));
}

TEST(InitialVelocity, RigidBodyComesLastAndTurnsAboutItsCentre) {
  const Built built(small_deck(R"(*INITIAL_VELOCITY_RIGID_BODY
         2       1.0       0.0       0.0       0.0       0.0       2.0
*INITIAL_VELOCITY
         0
       5.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  expect_vector(velocity(built, 5), 1 + 1, -1, 0);  // centre (2.5, 0.5)
  expect_vector(velocity(built, 7), 1 - 1, 1, 0);
  expect_vector(spin(built, 7), 0, 0, 2);
  expect_vector(velocity(built, 9), 5, 0, 0);
}

TEST(InitialVelocity, GivenInertiaKeepsItsOwnUnlessAskedOtherwise) {
  const std::string body = R"(*CONSTRAINED_NODAL_RIGID_BODY_INERTIA
        40         0         1
       0.0       0.0       0.0       2.0
       1.0       0.0       0.0       1.0       0.0       1.0
       0.0       0.0       8.0
*INITIAL_VELOCITY
)";
  const Built kept(small_deck(body + "         0\n       5.0\n"));
  ASSERT_EQ(kept.findings.errors(), 0) << kept.all_findings();
  expect_vector(velocity(kept, 1), 0, 0, 8);
  expect_vector(velocity(kept, 4), 5, 0, 0);
  EXPECT_TRUE(kept.warning("keeps the initial velocity", "nsid"));

  const Built overwritten(small_deck(body + "         0         0         0        -1\n       5.0\n"));
  expect_vector(velocity(overwritten, 1), 5, 0, 0);
  expect_vector(overwritten.model.rigid_bodies.back().inertia.velocity, 5, 0, 0);
  EXPECT_FALSE(overwritten.warning("keeps the initial velocity"));
}

TEST(InitialVelocity, MixtureOfKindsIsSaid) {
  const Built built(
      small_deck("*INITIAL_VELOCITY_GENERATION\n         1         2       0.0       1.0\n\n*INITIAL_VELOCITY_NODE\n   "
                 "      1       1.0\n"));
  EXPECT_TRUE(built.warning("forbids it"));
}

// ---- *LOAD

TEST(Load, ForcesAndMoments) {
  const Built built(small_deck(R"(*LOAD_NODE_POINT
         4         3         7    0.0025         0
         4         8         7       1.0         0         1         2         3
*LOAD_NODE_SET
         1         5         7       0.0         5
*LOAD_RIGID_BODY
         3         2         7
*DEFINE_COORDINATE_SYSTEM
         5       0.0       0.0       0.0       0.0       1.0       0.0
      -1.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& loads = built.model.nodal_loads;
  ASSERT_EQ(loads.size(), 4u);
  EXPECT_FALSE(loads[0].moment);
  expect_vector(loads[0].direction, 0, 0, 1);
  EXPECT_EQ(loads[0].scale, 0.0025);
  EXPECT_TRUE(loads[1].moment);
  EXPECT_EQ(loads[1].follower_nodes[2], built.model.node_index(3));
  EXPECT_TRUE(loads[2].moment);
  EXPECT_EQ(loads[2].nodes.size(), 3u);
  EXPECT_EQ(loads[2].scale, 1.0);
  expect_vector(loads[2].direction, 0, 1, 0);
  EXPECT_EQ(loads[3].rigid_body, built.model.parts[2].rigid_body);
  expect_vector(loads[3].direction, 0, 1, 0);
  EXPECT_TRUE(Built(small_deck("*LOAD_NODE_POINT\n         4         4         7\n")).error("missing", "m1"));
}

TEST(Load, BaseAccelerationOfSomeParts) {
  const Built built(small_deck(R"(*LOAD_BODY_PARTS
         1
*LOAD_BODY_Z
         7    9810.0
*LOAD_BODY_VECTOR
         7
       0.0       3.0       4.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.body_loads.size(), 2u);
  expect_vector(built.model.body_loads[0].direction, 0, 0, 1);
  EXPECT_EQ(built.model.body_loads[0].scale, 9810.0);
  expect_vector(built.model.body_loads[1].direction, 0, 0.6, 0.8);
  for (const BodyLoad& load : built.model.body_loads) EXPECT_THAT(load.parts, ElementsAre(0));
  const Built others(small_deck(R"(*LOAD_BODY_RZ
         7       2.0         0       1.0       2.0       3.0
*LOAD_GRAVITY_PART
         1         3         0    9810.0
*LOAD_BODY_PARTS
         1
)"));
  ASSERT_EQ(others.findings.errors(), 0) << others.all_findings();
  ASSERT_EQ(others.model.body_loads.size(), 2u);
  const BodyLoad &spin = others.model.body_loads[0], &gravity = others.model.body_loads[1];
  EXPECT_TRUE(spin.centrifugal);
  expect_vector(spin.center, 1, 2, 3);
  expect_vector(gravity.direction, 0, 0, 1);
  EXPECT_EQ(gravity.curve, none);
  EXPECT_THAT(gravity.parts, ElementsAre(0));
  EXPECT_TRUE(gravity.own_parts);
}

TEST(Load, BaseAccelerationOfARegion) {
  const Built built(small_deck(R"(*LOAD_BODY_GENERALIZED_SET_NODE
         1         0         7
       0.0       3.0       4.0
*LOAD_BODY_GENERALIZED
         2         8         7
       1.0       0.0       0.0
*LOAD_BODY_GENERALIZED_SET_PART
         1         0         7
       0.0       0.0       2.0
*SET_PART_LIST
         9
         2
*LOAD_BODY_PARTS
         9
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& loads = built.model.body_loads;
  ASSERT_EQ(loads.size(), 3u);
  EXPECT_THAT(loads[0].nodes, ElementsAre(0, 1, 2));
  expect_vector(loads[0].direction, 0, 0.6, 0.8);
  EXPECT_EQ(loads[0].scale, 5.0);
  EXPECT_THAT(loads[1].nodes, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_THAT(loads[2].parts, ElementsAre(0)) << "*LOAD_BODY_PARTS is no business of these";
  EXPECT_TRUE(Built(small_deck("*LOAD_BODY_GENERALIZED\n1,2,7\n,,,1.0\n")).error("", "omx"));
  EXPECT_TRUE(Built(small_deck("*LOAD_BODY_GENERALIZED\n1,2,7\n,,,\n")).error("no direction", "ax"));
}

TEST(Load, Pressures) {
  const Built built(small_deck(R"(*LOAD_SEGMENT
         7       2.0       0.1         1         2         3
*LOAD_SHELL_ELEMENT
         1         7
*LOAD_SEGMENT_SET_ID
         5lid
         4         7
*SET_SEGMENT
         4
         9        10        11        12
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& loads = built.model.pressure_loads;
  ASSERT_EQ(loads.size(), 3u);
  const auto index = [&](int id) { return built.model.node_index(id); };
  EXPECT_THAT(loads[0].segments, ElementsAre(Segment{index(1), index(2), index(3), index(3)}));
  EXPECT_EQ(loads[0].arrival, 0.1);
  EXPECT_EQ(loads[0].scale, 2.0);
  EXPECT_THAT(loads[1].segments, ElementsAre(Segment{index(1), index(2), index(3), index(4)}));
  EXPECT_THAT(loads[2].segments, ElementsAre(Segment{index(9), index(10), index(11), index(12)}));
  EXPECT_TRUE(Built(small_deck("*LOAD_SEGMENT\n        -2       1.0       0.0         1         2         3\n"))
                  .error("blast", "lcid"));
}

TEST(Load, Traction) {
  const std::string system = "*DEFINE_COORDINATE_VECTOR\n3,0.,1.,0.,-1.,0.,0.\n", card = "*LOAD_SEGMENT_NONUNIFORM\n";
  const Built built(small_deck(system + card + "7,2.0,0.1,0.4,3,5.0\n1,2,3,4\n1.,2.,3.,4.\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.traction_loads.size(), 1u);
  const auto& load = built.model.traction_loads[0];
  const auto index = [&](int id) { return built.model.node_index(id); };
  EXPECT_THAT(load.segments, ElementsAre(Segment{index(1), index(2), index(3), index(4)}));
  EXPECT_THAT(load.factor, ElementsAre(std::array<double, 4>{1, 2, 3, 4}));
  expect_vector(load.direction, 0, 1, 0);
  EXPECT_EQ(load.scale, 2.0);
  EXPECT_EQ(load.birth, 0.1);
  EXPECT_EQ(load.death, 0.4);
  const Built never_ends(small_deck(card + "7,1.0,0.0,0.0,,5.0\n1,2,3,4\n1.,2.,3.,4.\n"));  // DT 0: no death time
  ASSERT_EQ(never_ends.model.traction_loads.size(), 1u) << never_ends.all_findings();
  EXPECT_GT(never_ends.model.traction_loads[0].death, 1e20);
  EXPECT_TRUE(Built(small_deck(card + "7\n1,2,3\n1.,1.,1.\n")).error("no length", "v1"));
  EXPECT_TRUE(Built(small_deck(card + "7,,,,,1.\n1,2,3\n1.,1.\n")).error("for each corner", "p3"));
  EXPECT_TRUE(Built(small_deck(card + "7,,,,,1.\n1,2,3,4,5\n1.,1.,1.,1.\n")).error("quadratic", "n5"));
  EXPECT_TRUE(Built(small_deck(card + "7,,,,9,1.\n1,2,3\n1.,1.,1.\n")).error("system 9 is not defined", "cid"));
}

}  // namespace
}  // namespace nugget::reading
