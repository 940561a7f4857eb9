// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// Nodes that can turn: of shells, beams but trusses, torsional springs, rigid bodies, bricks with rotations, and those
/// with an inertia. From Phase::checks on.
std::vector<char> nodes_that_turn(const Builder& builder);

/// A warning at the field that asks for a moment or a rotation of nodes of which some cannot turn.
void warn_of_no_rotation(Builder& builder, const deck::Entry& field, const std::vector<Index>& nodes,
                         const std::vector<char>& turns, const char* what, const char* remedy);

}  // namespace nugget::reading
