// SPDX-License-Identifier: Apache-2.0
// Rigid bodies, rigid walls, contacts.
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

void expect_vector(const Vec3d& v, double x, double y, double z) {
  EXPECT_NEAR(v.x, x, 1e-12);
  EXPECT_NEAR(v.y, y, 1e-12);
  EXPECT_NEAR(v.z, z, 1e-12);
}

// ---- rigid bodies

TEST(RigidBodies, PartsWithRigidMaterial) {
  const Built built(small_deck("", "       1.0         4         7"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& bodies = built.model.rigid_bodies;
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[0].id, 2);
  EXPECT_EQ(bodies[0].title, "block");
  EXPECT_THAT(user_ids(built.model, bodies[0].nodes), ElementsAre(5, 6, 7, 8));
  EXPECT_EQ(bodies[0].fixed, 0b111011u) << "CON1 4 holds x and y";
  EXPECT_EQ(built.model.parts[0].rigid_body, none);
  EXPECT_EQ(built.model.parts[2].rigid_body, 1);
  EXPECT_TRUE(Built(small_deck("", "      -1.0         5    110111")).error("is not defined", "con1"));
}

TEST(RigidBodies, MergersAndExtraNodes) {
  const Built built(small_deck(R"(*CONSTRAINED_RIGID_BODIES
         3         2
*CONSTRAINED_EXTRA_NODES_NODE
         2         4
*CONSTRAINED_EXTRA_NODES_SET
         3         1
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.rigid_bodies.size(), 1u);
  const RigidBody& body = built.model.rigid_bodies[0];
  EXPECT_EQ(body.id, 3);
  EXPECT_THAT(body.parts, ElementsAre(2, 1));
  EXPECT_THAT(user_ids(built.model, body.nodes), ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
  EXPECT_EQ(built.model.parts[1].rigid_body, 0);
  EXPECT_EQ(built.model.parts[2].rigid_body, 0);
}

TEST(RigidBodies, MergersOfASet) {
  // The set holds the lead body too.
  const Built built(small_deck("*CONSTRAINED_RIGID_BODIES_SET\n         3         7\n*SET_PART_LIST\n7\n2,3\n"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.rigid_bodies.size(), 1u);
  EXPECT_EQ(built.model.rigid_bodies[0].id, 3);
  EXPECT_THAT(built.model.rigid_bodies[0].parts, ElementsAre(2, 1));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_RIGID_BODIES_SET\n3,7\n*SET_PART_LIST\n7\n1,2\n"))
                  .error("part 1 of the set is no rigid body", "pidc"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_RIGID_BODIES_SET\n3,8\n")).error("part set 8 is not defined", "pidc"));
}

TEST(RigidBodies, NodalBodiesWithInertiaInLocalAxes) {
  const Built built(small_deck(R"(*CONSTRAINED_NODAL_RIGID_BODY_SPC_INERTIA_TITLE
bracket
         1
       1.0         3         1
       0.0       0.0       0.0       2.0         1        20
       1.0       0.0       0.0       2.0       0.0       3.0
       0.0       0.0       8.0
       0.0       1.0       0.0      -1.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const RigidBody& body = built.model.rigid_bodies.back();
  EXPECT_EQ(body.origin, RigidBody::Origin::nodal);
  EXPECT_EQ(body.title, "bracket");
  EXPECT_THAT(user_ids(built.model, body.nodes), ElementsAre(1, 2, 3)) << "NSID 0: the set numbered as the body";
  EXPECT_EQ(body.fixed, 0b001100u);
  ASSERT_TRUE(body.given);
  expect_vector(body.inertia.center, 0, 0, 5);
  EXPECT_NEAR(body.inertia.inertia[0], 2.0, 1e-12) << "local y is global -x";
  EXPECT_NEAR(body.inertia.inertia[3], 1.0, 1e-12);
  EXPECT_NEAR(body.inertia.inertia[5], 3.0, 1e-12);
}

/// A nodal rigid body of nodes 1 2 3 with mass 5 at `center` and this tensor of inertia.
std::string body_with_inertia(const std::string& tensor, const std::string& center = "       0.0       0.0       0.0") {
  return "*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n        40         0         1        21\n" + center + "       5.0\n" +
         tensor + "\n\n*NODE\n      21             7.0             0.0             0.0\n";
}
const std::string singular = "      50.0      50.0      50.0      50.0      50.0      50.0";
const std::string round_body = "      50.0       0.0       0.0      50.0       0.0      50.0";

TEST(RigidBodies, TensorOfNoBodyIsRefusedWhereItCanTurn) {
  EXPECT_TRUE(Built(small_deck(body_with_inertia(singular))).error("not positive definite"));
  EXPECT_FALSE(Built(small_deck(body_with_inertia(round_body))).error("not positive definite"));
  const Built held(
      small_deck(body_with_inertia(singular) +
                 "*BOUNDARY_SPC_NODE\n        21         0         0         0         1         1         1  "
                 "       1\n"));
  EXPECT_EQ(held.findings.errors(), 0) << held.all_findings();
  EXPECT_TRUE(held.find(Severity::note, "cannot turn, so it does not matter"));
}

// Three quarters of a square millimetre of sheet, 1 mm of steel.
TEST(RigidBodies, MassOfElementsBesideAGivenMassIsReported) {
  const auto built = [](const std::string& mass) {
    std::string body = body_with_inertia(round_body);
    body.replace(body.find("       5.0\n"), 10, mass);
    return Built(small_deck(body));
  };
  EXPECT_TRUE(built("       5.0").find(Severity::note, "the mass 5.8875e-09 of the elements of part 1 at its nodes"));
  EXPECT_TRUE(built("   5.89E-7").find(Severity::note, "takes no part"));
  EXPECT_TRUE(built("   5.88E-7").find(Severity::warning, "the mass 5.8875e-09")) << built("   5.88E-7").all_findings();
  EXPECT_FALSE(Built(small_deck("")).find(Severity::note, "takes no part"));
}

TEST(RigidBodies, ReferenceNodeStandsAtTheCentre) {
  const Built built(small_deck(body_with_inertia(round_body, "       0.5       0.5       2.0")));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const Model& m = built.model;
  EXPECT_THAT(user_ids(m, m.rigid_bodies.back().nodes), ElementsAre(1, 2, 3, 21));
  expect_vector(m.nodes.x[m.node_index(21)], 0.5, 0.5, 2.0);
  EXPECT_TRUE(built.find(Severity::note, "is moved by 6.8", "pnode"));
}

TEST(RigidBodies, PointConstraintsHoldTheBody) {
  const auto spc = [](int node, const char* codes) {
    return "*BOUNDARY_SPC_NODE\n" + std::to_string(node) + ",0," + codes + "\n";
  };
  const auto built = [&](const std::string& spcs) { return Built(small_deck(body_with_inertia(round_body) + spcs)); };
  const auto fixed = [](const Built& b) { return b.model.rigid_bodies.back().fixed; };

  const Built at_center = built(spc(21, "0,0,1,1,0,0"));
  EXPECT_EQ(fixed(at_center), 0b001100u);
  EXPECT_TRUE(at_center.model.spcs.empty());
  // Elsewhere a translation is no constraint of the centre, unless the body cannot turn; a rotation always is.
  const Built off_center = built(spc(2, "0,0,1,1,0,0"));
  EXPECT_EQ(fixed(off_center), 0b001000u);
  EXPECT_TRUE(off_center.warning("node 2 belongs to rigid body 40, which moves as one: its translation is not held"));
  const Built without_rotation = built(spc(2, "1,0,1,0,0,0") + spc(3, "0,0,0,1,1,1"));
  EXPECT_EQ(fixed(without_rotation), 0b111101u);
  EXPECT_TRUE(without_rotation.model.spcs.empty());
}

TEST(RigidBodies, Faults) {
  const Built twice(
      small_deck("*CONSTRAINED_NODAL_RIGID_BODY\n        40         0         1\n*CONSTRAINED_NODAL_RIGID_BODY\n       "
                 " 41         0         1\n"));
  EXPECT_TRUE(twice.error("node 1 belongs to two rigid bodies: nodal rigid body 40 and nodal rigid body 41"));
  EXPECT_TRUE(
      Built(small_deck("*CONSTRAINED_EXTRA_NODES_NODE\n         1         4\n")).error("part 1 is not rigid", "pid"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_RIGID_BODIES\n         2         1\n"))
                  .error("rigid body 1 is not defined", "pidc"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_NODAL_RIGID_BODY\n         2         0         1\n")).findings.errors() >
              0)
      << "2 is a rigid part already";
  EXPECT_TRUE(
      Built(small_deck("*CONSTRAINED_NODAL_RIGID_BODY\n        40         0         1         0         0         7\n"))
          .error("only 0", "drflag"));
}

TEST(RigidBodies, WeldSpotsWithoutFailure) {
  const Built free(small_deck("*CONSTRAINED_GENERALIZED_WELD_SPOT\n         1\n1.00000E20\n"));
  ASSERT_EQ(free.findings.errors(), 0) << free.all_findings();
  ASSERT_EQ(free.model.rigid_bodies.size(), 3u);
  EXPECT_EQ(free.model.rigid_bodies[2].origin, RigidBody::Origin::weld);
  EXPECT_THAT(user_ids(free.model, free.model.rigid_bodies[2].nodes), ElementsAre(1, 2, 3));

  const Built on_part(
      small_deck("*CONSTRAINED_GENERALIZED_WELD_SPOT_ID\n        11\n         2\n\n*SET_NODE_LIST\n         2\n        "
                 " 4         5\n"));
  ASSERT_EQ(on_part.findings.errors(), 0) << on_part.all_findings();
  ASSERT_EQ(on_part.model.rigid_bodies.size(), 2u);
  EXPECT_THAT(user_ids(on_part.model, on_part.model.rigid_bodies[0].nodes), ElementsAre(4, 5, 6, 7, 8));
  EXPECT_TRUE(on_part.find(Severity::note, "extra nodes", "nsid"));
}

TEST(RigidBodies, WeldsThatFail) {
  const Built spot(
      small_deck("*CONSTRAINED_GENERALIZED_WELD_SPOT_ID\n        11\n         1         0         5       0.2\n"
                 "       0.1      0.25    5000.0    3000.0       1.5       2.0\n"));
  ASSERT_EQ(spot.findings.errors(), 0) << spot.all_findings();
  ASSERT_EQ(spot.model.rigid_welds.size(), 1u);
  const RigidWeld& weld = spot.model.rigid_welds[0];
  EXPECT_EQ(weld.kind, RigidWeld::Kind::generalized);
  EXPECT_EQ(weld.id, 11);
  EXPECT_EQ(spot.model.rigid_bodies[weld.body].origin, RigidBody::Origin::weld);
  EXPECT_EQ(weld.filter, 5);
  EXPECT_EQ(weld.window, 0.2);
  EXPECT_EQ(weld.failure_time, 0.1);
  EXPECT_EQ(weld.failure_strain, 0.25);
  EXPECT_EQ(weld.normal_strength, 5000.0);
  EXPECT_EQ(weld.shear_strength, 3000.0);
  EXPECT_EQ(weld.normal_exponent, 1.5);
  EXPECT_EQ(weld.shear_exponent, 2.0);

  const Built link(
      small_deck("*CONSTRAINED_SPOTWELD_FILTERED_FORCE_ID\n         7\n         1         2    5000.0       0.0       "
                 "2.0       0.0       0.3\n         4       0.1\n"));
  ASSERT_EQ(link.findings.errors(), 0) << link.all_findings();
  ASSERT_EQ(link.model.rigid_welds.size(), 1u);
  const RigidWeld& pair = link.model.rigid_welds[0];
  EXPECT_EQ(pair.kind, RigidWeld::Kind::spotweld);
  EXPECT_THAT(user_ids(link.model, pair.nodes), ElementsAre(1, 2));
  EXPECT_EQ(pair.shear_strength, 0.0);
  EXPECT_EQ(pair.failure_strain, 0.0) << "1e20 means none";
  EXPECT_EQ(pair.failure_time, 0.3);
  EXPECT_EQ(pair.filter, 4);
}

TEST(RigidBodies, FaultsOfRigidWelds) {
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_SPOTWELD\n         1         2    5000.0\n")).error("exponent", "n"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_SPOTWELD\n         1         1\n")).error("two nodes or more", "n1"));
  EXPECT_TRUE(Built(small_deck("*NODE\n91,3.0,0.0,0.0\n92,3.0,0.0,0.0\n*CONSTRAINED_SPOTWELD\n        91        92\n"))
                  .error("one place", "n2"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_SPOTWELD\n         1        99\n")).error("not defined", "n2"));
  EXPECT_TRUE(Built(small_deck("*CONSTRAINED_SPOTWELD\n         1         5    5000.0       0.0       1.0\n"))
                  .error("cannot fail", "n1"))
      << "node 5 belongs to a rigid part";
  EXPECT_TRUE(
      Built(small_deck("*CONSTRAINED_SPOTWELD\n         1         2\n*CONSTRAINED_SPOTWELD\n         2         3\n"))
          .error("node 2 belongs to two rigid bodies"));
}

// ---- rigid walls

// RWPNAL: nodes of rigid parts are the wall's too.
TEST(RigidWalls, TakeRigidPartsByPenalty) {
  const auto nodes_with = [](const std::string& contact) {
    return Built(small_deck(contact + "*RIGIDWALL_PLANAR\n         0\n" +
                            "       0.0       0.0      -1.0       0.0       0.0       1.0\n"));
  };
  const Built without = nodes_with(""), with = nodes_with("*CONTROL_CONTACT\n       0.1       1.0\n"),
              negative = nodes_with("*CONTROL_CONTACT\n       0.1      -2.0\n");
  EXPECT_TRUE(without.warning("rigid parts pass through", "nsid"));
  EXPECT_FALSE(with.warning("rigid parts pass through", "nsid"));
  EXPECT_GT(with.model.walls.at(0).nodes.size(), without.model.walls.at(0).nodes.size());
  EXPECT_EQ(with.model.control.wall_penalty, 1.0);
  EXPECT_FALSE(with.warning("not obeyed", "rwpnal"));
  EXPECT_TRUE(negative.warning("not obeyed", "rwpnal"));
  EXPECT_EQ(negative.model.control.wall_penalty, 2.0);
}

TEST(RigidWalls, PlanarWithAllItsCards) {
  const Built built(small_deck(R"(*RIGIDWALL_PLANAR_FINITE_MOVING_FORCES_ID
         8barrier
         0         1         2       0.0       0.1       0.0
       0.0       0.0      -1.0       0.0       0.0       1.0       0.2
       2.0       0.0       3.0       4.0       0.0
       9.0     -50.0
         5         0
*DEFINE_BOX
         2      -9.0       9.0      -9.0       9.0      -1.0       1.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.walls.size(), 1u);
  const RigidWall& wall = built.model.walls[0];
  EXPECT_EQ(wall.id, 8);
  EXPECT_EQ(wall.title, "barrier");
  EXPECT_THAT(user_ids(built.model, wall.nodes), ElementsAre(4)) << "all but the set, the far node and the rigid parts";
  EXPECT_TRUE(built.warning("rigid parts", "nsid"));
  expect_vector(wall.origin, 0, 0, -1);
  expect_vector(wall.normal, 0, 0, 1);
  EXPECT_TRUE(wall.finite);
  expect_vector(wall.edge_l, 1, 0, 0);
  expect_vector(wall.edge_m, 0, 1, 0);
  EXPECT_EQ(wall.length_l, 4.0);
  EXPECT_EQ(wall.length_m, 0.0);
  EXPECT_EQ(wall.mass, 9.0);
  EXPECT_EQ(wall.velocity, -50.0);
  EXPECT_EQ(wall.soft, 5);
  EXPECT_EQ(wall.friction, 0.2);
  EXPECT_EQ(wall.birth, 0.1);
  EXPECT_EQ(wall.death, forever);
}

TEST(RigidWalls, GeometricWithAndWithoutTheirDisplayCard) {
  const Built built(small_deck(R"(*RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY_ID
         2post
         1
       5.0       0.0       0.0       5.0       0.0     100.0
     177.0       0.0         0
*RIGIDWALL_GEOMETRIC_SPHERE_MOTION_DISPLAY
         1
       1.0       2.0       3.0
       4.0
         7         1       0.0       0.0      -2.0
        99    1.0E-9
*RIGIDWALL_GEOMETRIC_FLAT
         1
       0.0       0.0      -1.0       0.0       0.0       0.0       1.0
       0.0       0.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  const auto& walls = built.model.walls;
  ASSERT_EQ(walls.size(), 3u);
  EXPECT_EQ(walls[0].shape, RigidWall::Shape::cylinder);
  EXPECT_EQ(walls[0].id, 2);
  EXPECT_EQ(walls[0].radius, 177.0);
  expect_vector(walls[0].normal, 0, 0, 1);
  EXPECT_EQ(walls[0].motion_curve, none);
  EXPECT_EQ(walls[1].shape, RigidWall::Shape::sphere);
  EXPECT_EQ(walls[1].radius, 4.0);
  EXPECT_NE(walls[1].motion_curve, none);
  EXPECT_TRUE(walls[1].motion_is_displacement);
  expect_vector(walls[1].motion_direction, 0, 0, -1);
  EXPECT_EQ(walls[2].shape, RigidWall::Shape::plane);
  EXPECT_FALSE(walls[2].finite);
  EXPECT_EQ(walls[2].friction, 1.0);
  EXPECT_EQ(walls[1].id, 3) << "its place is the number of the first";
  EXPECT_EQ(walls[2].id, 4) << "by position, if that were free";
}

// NSEGS cards of sections stand before that of the motion. Sabotage: they are not read.
TEST(RigidWalls, CylinderWithSections) {
  const Built built(small_deck(R"(*RIGIDWALL_GEOMETRIC_CYLINDER_MOTION
         1
       5.0       0.0       0.0       5.0       0.0     100.0
     177.0     100.0         2
       0.0      50.0
      50.0      50.0
         7         0       0.0       1.0       0.0
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.walls.size(), 1u);
  expect_vector(built.model.walls[0].motion_direction, 0, 1, 0);
  EXPECT_TRUE(built.warning("forces by section", "nsegs"));
}

TEST(RigidWalls, TellsWhatItDoesNotDo) {
  EXPECT_TRUE(Built(small_deck("*RIGIDWALL_PLANAR_FORCES\n         0\n       0.0       0.0      -9.0       0.0       "
                               "0.0       1.0\n        20\n"))
                  .warning("in one cycle", "soft"));
  const Built displaced(small_deck(R"(*RIGIDWALL_GEOMETRIC_SPHERE_MOTION
         0
       0.0       0.0      -9.0
       1.0
         7         1       0.0       0.0       1.0
)"));
  EXPECT_TRUE(displaced.warning("displaced by 2 at its start", "lcid")) << displaced.all_findings();
}

// Nodes of the small deck stand at the corners of a unit square at z = 0, one far off.
TEST(RigidWalls, TellsOfNodesThatStartBehind) {
  const auto behind = [](const std::string& wall) {
    return Built(small_deck(wall)).warning("behind the wall", "nsid");
  };
  const std::string plane = "*RIGIDWALL_PLANAR\n         0\n";
  EXPECT_TRUE(behind(plane + "       0.0       0.0       0.5       0.0       0.0       1.0\n"));
  EXPECT_FALSE(behind(plane + "       0.0       0.0      -0.5       0.0       0.0       1.0\n"));
  EXPECT_FALSE(behind(plane + "       0.0       0.0       0.0       0.0       0.0       1.0\n")) << "on it";
  const std::string ball = "*RIGIDWALL_GEOMETRIC_SPHERE\n         0\n       0.0       0.0       0.0\n";
  EXPECT_TRUE(behind(ball + "       0.5\n"));
  EXPECT_FALSE(behind("*RIGIDWALL_GEOMETRIC_SPHERE\n         0\n       0.0       0.0      -9.0\n       8.9\n"));
}

TEST(RigidWalls, Faults) {
  EXPECT_TRUE(Built(small_deck("*RIGIDWALL_PLANAR\n         1\n       1.0       0.0       0.0       1.0\n"))
                  .error("same point", "xh"));
  EXPECT_TRUE(Built(small_deck("*RIGIDWALL_PLANAR\n         1\n       1.0       0.0       0.0       2.0       0.0      "
                               " 0.0       1.5\n"))
                  .error("2 or 3", "fric"));
  EXPECT_TRUE(
      Built(small_deck("*RIGIDWALL_PLANAR_FINITE\n         1\n       1.0       0.0       0.0       2.0\n       5.0\n"))
          .error("lie in the wall", "xhev"));
  EXPECT_TRUE(Built(small_deck("*RIGIDWALL_PLANAR_ORTHO_ID\n         1\n")).error("orthotropic"));
  EXPECT_TRUE(Built(small_deck("*RIGIDWALL_GEOMETRIC_CYLINDER\n         1\n       0.0       0.0       0.0       0.0    "
                               "   0.0       1.0\n       0.0\n"))
                  .findings.errors() > 0);
}

// ---- contacts

TEST(Contacts, SingleSurfaceOverAllParts) {
  const Built built(small_deck(R"(*CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP_ID
         4whole model
         1       200
&                  1
         0         0         0
       0.2       0.1       0.0       0.0      20.0         0       0.5       0.0
       0.0       0.0       1.5
         1       0.2         0       0.0       0.0         0        33
       0.0
         1         2
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  ASSERT_EQ(built.model.contacts.size(), 1u);
  const Contact& contact = built.model.contacts[0];
  EXPECT_EQ(contact.id, 4);
  EXPECT_EQ(contact.title, "whole model");
  EXPECT_EQ(contact.kind, Contact::Kind::single_surface);
  EXPECT_TRUE(contact.a.everything);
  EXPECT_TRUE(contact.b.empty());
  EXPECT_EQ(contact.friction.static_coefficient, 0.2);
  EXPECT_EQ(contact.friction.dynamic_coefficient, 0.1);
  EXPECT_EQ(contact.damping, 20.0);
  EXPECT_EQ(contact.birth, 0.5);
  EXPECT_EQ(contact.death, forever);
  EXPECT_EQ(contact.stiffness_scale_a, 1.0) << "a written 0 is the default";
  EXPECT_EQ(contact.thickness_a, 1.5);
  EXPECT_EQ(contact.soft, 1);
  EXPECT_EQ(contact.soft_scale, 0.2);
  EXPECT_EQ(contact.search_interval, 33);
  EXPECT_EQ(contact.ignore, 2);
}

TEST(Contacts, TiesAndTheirSides) {
  const Built built(small_deck(R"(*CONTACT_SPOTWELD
         1         3         4         3
*CONTACT_TIED_SHELL_EDGE_TO_SURFACE_TITLE
         8edge
         1         6         4         6
       0.3
       1.0       1.0      -2.0      -2.0
*CONTACT_AUTOMATIC_SINGLE_SURFACE
         9         0         1
*SET_SHELL_LIST
         9
         1         3
*SET_PART_LIST
         6
         2
)"));
  ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
  EXPECT_EQ(built.findings.warnings(), 0) << built.all_findings() << "FS means nothing in a tie";
  const auto& contacts = built.model.contacts;
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[0].kind, Contact::Kind::spotweld);
  EXPECT_THAT(user_ids(built.model, contacts[0].a.nodes), ElementsAre(1, 2, 3));
  EXPECT_THAT(contacts[0].b.parts, ElementsAre(2));
  EXPECT_EQ(contacts[1].kind, Contact::Kind::tied_shell_edge);
  EXPECT_THAT(contacts[1].b.parts, ElementsAre(0, 2)) << "all but part 2";
  EXPECT_EQ(contacts[1].thickness_a, -2.0);
  EXPECT_EQ(contacts[2].a.segments.size(), 2u);
}

TEST(Contacts, FormsOfTies) {
  using Kind = Contact::Kind;
  using Offset = Contact::Offset;
  struct Form {
    const char* keyword;
    Kind kind;
    Offset offset;
    bool torsion;
  };
  for (const Form& f :
       {Form{"CONTACT_SPOTWELD_WITH_TORSION", Kind::spotweld, Offset::projected, true},
        Form{"CONTACT_SPOTWELD_WITH_TORSION_PENALTY", Kind::spotweld, Offset::beam, true},
        Form{"CONTACT_SPOTWELD_PENALTY_MPP", Kind::spotweld, Offset::beam, false},
        Form{"CONTACT_SPOTWELD_BEAM_OFFSET_TITLE", Kind::spotweld, Offset::beam, false},
        Form{"CONTACT_SPOTWELD_CONSTRAINED_OFFSET", Kind::spotweld, Offset::constrained, false},
        Form{"CONTACT_TIED_NODES_TO_SURFACE", Kind::tied_nodes, Offset::projected, false},
        Form{"CONTACT_TIED_NODES_TO_SURFACE_OFFSET_ID", Kind::tied_nodes, Offset::penalty, false},
        Form{"CONTACT_TIED_SURFACE_TO_SURFACE_CONSTRAINED_OFFSET", Kind::tied_surface, Offset::constrained, false},
        Form{"CONTACT_TIED_SHELL_EDGE_TO_SURFACE_BEAM_OFFSET_ID", Kind::tied_shell_edge, Offset::beam, false},
        Form{"CONTACT_TIED_SHELL_EDGE_TO_SOLID", Kind::tied_shell_edge_to_solid, Offset::projected, false}}) {
    const std::string keyword = f.keyword;
    const bool heading = keyword.ends_with("ID") || keyword.ends_with("TITLE");
    const std::string first = keyword.ends_with("SOLID") || !heading ? "" : "         7name\n";
    const std::string mpp = keyword.ends_with("MPP") ? "         0\n" : "";
    const Built built(
        small_deck('*' + keyword + '\n' + first + mpp + "         1         3         4         3\n\n\n\n\n\n\n,,1\n"));
    ASSERT_EQ(built.findings.errors(), 0) << built.all_findings();
    const Contact& contact = built.model.contacts.at(0);
    EXPECT_EQ(contact.kind, f.kind) << keyword;
    EXPECT_EQ(contact.offset, f.offset) << keyword;
    EXPECT_EQ(contact.torsion, f.torsion) << keyword;
    EXPECT_TRUE(contact.penalty_fallback) << keyword;
  }
  EXPECT_TRUE(
      Built(small_deck("*CONTACT_SPOTWELD_PENALTY_CONSTRAINED_OFFSET\n         1         3         4         3\n"))
          .error("says twice"));
}

TEST(Contacts, ASingleSurfaceIsTiedToItself) {
  const auto tied = [](const char* rest) {
    return Built(small_deck(std::string("*CONTACT_AUTOMATIC_SINGLE_SURFACE_TIED\n") + rest));
  };
  const Built all = tied("\n\n                       0.4                 2.0\n       0.3\n");
  ASSERT_EQ(all.model.contacts.size(), 1u);
  const Contact& contact = all.model.contacts[0];
  EXPECT_TRUE(contact.ties_what_touches() && contact.tie() && !contact.slides() && contact.ties_rotations());
  EXPECT_TRUE(contact.a.everything && contact.b.everything);
  EXPECT_DOUBLE_EQ(contact.close, 0.3);
  EXPECT_DOUBLE_EQ(contact.thickness_b, contact.thickness_a);
  EXPECT_DOUBLE_EQ(contact.thickness_scale_b, contact.thickness_scale_a);
  EXPECT_TRUE(tied("\n\n\n      -1.0\n").error("0 or more", "close"));
  EXPECT_TRUE(tied("\n\n                      -0.4\n       0.1\n").error("for ties alone", "sast"));
  EXPECT_TRUE(tied("         1         0         4\n\n\n       0.1\n").error("node set", "surfatyp"));
  EXPECT_TRUE(tied("\n                                                                   1.0\n\n       0.1\n")
                  .error("begins later", "bt"));
}

TEST(Contacts, WhatCannotBeObeyedIsRefused) {
  const auto single = [](const char* rest) {
    return Built(small_deck(std::string("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n") + rest));
  };
  const std::string nodes = "*CONTACT_AUTOMATIC_NODES_TO_SURFACE\n         1         3         3         3\n\n\n";
  EXPECT_TRUE(Built(small_deck(nodes + "         2\n")).warning("as with soft = 1", "soft"));
  EXPECT_TRUE(single("         0         0         0         0\n\n\n         3\n").error("0, 1 or 2", "soft"));
  EXPECT_TRUE(single("         0         0         0         0\n      -3.0\n").error("by a curve", "fs"));
  EXPECT_TRUE(single("         0         0         0         0\n       2.0\n").error("by a table", "fs"));
  EXPECT_TRUE(single("         1         0         4         0\n").error("node set", "surfatyp"));
  EXPECT_TRUE(single("         0         0         0         0         5\n").error("box", "saboxid"));
  EXPECT_TRUE(single("        77         0         2         0\n").error("part set 77 is not defined", "surfa"));
  EXPECT_TRUE(single("\n\n\n\n\n\n\n\n\n\n         1\n").error("more data lines"));
  EXPECT_TRUE(Built(small_deck("*CONTACT_SPOTWELD\n         1         0         4         3\n"))
                  .error("must be given", "surfb"));
  EXPECT_TRUE(
      Built(small_deck("*CONTACT_SPOTWELD\n         1         1         4         4\n")).error("segments", "surfbtyp"));
  for (const char* name : {"CONTACT_SPOTWELD_THERMAL", "CONTACT_TIED_NODES_TO_SURFACE_BEAM_OFFSET",
                           "CONTACT_AUTOMATIC_SINGLE_SURFACE_SMOOTH", "CONTACT_ENTITY"})
    EXPECT_TRUE(Built(small_deck('*' + std::string(name) + "\n         1\n")).error("not built")) << name;
}

}  // namespace
}  // namespace nugget::reading
