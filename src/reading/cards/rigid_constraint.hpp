// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"
#include "reading/builder/common_cards.hpp"

namespace nugget::reading {

/// The card that holds a rigid body (CMO, CON1, CON2), the second of *MAT_RIGID and that of _SPC of nodal rigid bodies:
/// by codes in global axes, or in local ones, where CON1 is a coordinate system.
extern const CardOf<RigidConstraintCard> rigid_constraint_card, rigid_constraint_local_card;
deck::RowOf<RigidConstraintCard> read_rigid_constraint(Builder& builder, deck::Cursor& cursor);

}  // namespace nugget::reading
