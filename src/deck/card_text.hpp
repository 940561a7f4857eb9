// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "deck/deck.hpp"

// Values written into the cells of a deck's lines.
namespace nugget::deck {

/// A number with as many digits as `width` columns hold (0: all of them). Empty where less than five digits would be
/// left.
std::string fitted(double value, Kind kind, std::size_t width);

/// The line with another text in one of the card's cells, at its right end (texts at their left), every other byte as
/// it was; a line that ends before the cell becomes longer. Throws std::invalid_argument where the text is wider than
/// the cell, or has a comma in a line that is separated by commas.
std::string with_cell(const Card& card, Format format, std::string_view line, std::size_t field, std::string_view text);

/// A cell of so many columns (0: it ends with a comma) with that text, likewise.
std::string filled_cell(std::string_view text, std::size_t width, Kind kind);

}  // namespace nugget::deck
