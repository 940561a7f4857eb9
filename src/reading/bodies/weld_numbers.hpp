// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

// Numbers of rigid welds and rivets. Tables, pictures, swforc and options call any weld by its number alone, so that
// those that the deck does not number get numbers that no other weld has.
namespace nugget::reading {

/// Phase::bodies, before the welds of Builder::body_cards are made: one without a number gets its place among them, or
/// the next number that no beam or brick of a weld, no assembly, no nodal rigid body and no weld of the deck has.
void number_rigid_welds(Builder& builder);

/// Phase::checks: the same for rivets, by their place among rivets. Numbers of the deck that two welds have, one of
/// them a rigid weld or a rivet, are a warning.
void number_rivets(Builder& builder);

}  // namespace nugget::reading
