// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "deck/deck.hpp"

// A data line cut into the cells of a card.
namespace nugget::deck {

struct CellText {
  std::string_view text;  ///< trimmed
  int column = 1;         ///< where the text starts (the cell, where it is blank)
};

/// Columns of a field: as in the table; I10: 10 at least; long: 20 at least, headings twice their width.
std::size_t width_of(const Field& field, Format format);

/// True if the line separates its fields by commas. A heading (a text wider than 20 columns) may hold commas of its
/// own, so only what stands before it counts.
bool is_free(const Card& card, Format format, std::string_view line);

/// The cells of the card, one a field; returns what is left over on the line between its last field and column 80.
CellText split(const Card& card, Format format, std::string_view line, std::vector<CellText>& cells);

}  // namespace nugget::deck
