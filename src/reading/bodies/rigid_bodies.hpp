// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "reading/builder/builder.hpp"

// What moves as one: MAT_RIGID parts (merged by *CONSTRAINED_RIGID_BODIES, with their extra nodes), nodal rigid bodies,
// rigid welds.
namespace nugget::reading {

/// Makes Model::rigid_bodies, Part::rigid_body, Builder::bodies and Builder::body_of_node of the parts and of
/// Builder::body_cards. A node that two bodies hold, a body without nodes and a merger whose mass cannot be known are
/// findings.
void make_rigid_bodies(Builder& builder);

/// The body of a MAT_RIGID part (that of its lead part where merged) or of a nodal rigid body, by the id in a field;
/// none and a finding where there is no such body.
Index find_body(Builder& builder, const deck::Entry& field);

/// Local axes of a body by the deck: LCO of *MAT_RIGID or its two vectors, CID of *CONSTRAINED_NODAL_RIGID_BODY; null
/// where it names none.
const Frame3d* body_axes(Builder& builder, int id);

/// Centre of mass: as given, or of the lumped masses at the body's nodes [length]. From Phase::bodies on.
Vec3d center_of_mass(Builder& builder, const RigidBody& body);

/// Phase::conditions. Takes the nodes of rigid bodies out of the `nodes` of an SPC. Where the constraint of such a node
/// is exactly one of its body, the body is held instead: rotations at any node, translations at the centre of mass, or
/// at any node of a body that cannot turn. The others do nothing and are reported.
void constrain_bodies(Builder& builder, const deck::Entry& field, const SinglePointConstraint& spc,
                      std::vector<Index>& nodes);
/// Phase::checks, when all that holds the bodies is known: a body that can turn and whose given tensor of inertia is
/// not positive definite is refused; the mass of elements at the nodes of a body of given mass is reported.
void check_inertia(Builder& builder);

/// "nodal rigid body 7", for messages.
std::string name_of(const RigidBody& body);

/// Gives the nodes of a body the velocities of a rigid motion about `center`.
void set_motion(Model& model, const RigidBody& body, const Vec3d& center, const Vec3d& velocity, const Vec3d& spin);

}  // namespace nugget::reading
