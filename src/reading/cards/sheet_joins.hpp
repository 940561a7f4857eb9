// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace nugget::reading {

/// A card that joins two sheets at the nodes of a set, as it stands in a deck, whether or not these are there.
struct SheetJoin {
  std::string keyword;  ///< with its star
  int first_part = 0, second_part = 0, node_set = 0;
  double diameter = 0.0;  ///< [length]
  Place place;            ///< of its first card
};

/// Those of *CONSTRAINED_INTERPOLATION_SPOTWELD and *CONSTRAINED_SPR2, in the order of the deck. What is wrong with a
/// field is said where the card itself is read; here it is 0.
std::vector<SheetJoin> sheet_joins(const deck::Deck& deck);

}  // namespace nugget::reading
