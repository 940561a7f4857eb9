// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/weld_section.hpp"

// Pieces of the decks that are written here.
namespace nugget::weld {

/// A number in a field of ten columns, with as many digits as they hold beside a blank.
std::string real_field(double value);

/// Section and hourglass control of weld bricks, with these ids.
std::string brick_cards(int section, int hourglass);
inline constexpr const char* brick_header =
    "*ELEMENT_SOLID\n$#   eid     pid      n1      n2      n3      n4      n5      n6      n7      n8\n";
/// A line for each brick of a weld between two planes, with ids from `first` on; `below`, `above`: of the first node in
/// each plane, where nodes stand in the order of the section's points.
std::string brick_lines(const model::WeldSection& section, int first, int part, int below, int above);

}  // namespace nugget::weld
