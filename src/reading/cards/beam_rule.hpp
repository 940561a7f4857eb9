// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "reading/builder/common_cards.hpp"

// Cross-sections of beams that are not made of the numbers of *SECTION_BEAM alone.
namespace nugget::reading {

extern const Card beam_rule_card, beam_shape_card, beam_point_card, named_shape_card;

/// *INTEGRATION_BEAM.
void read_beam_rule(Builder& builder, const deck::Block& block, const Options& options);

/// True where the next card names a shape (STYPE, SECTION_01 to SECTION_22) in place of an area.
bool names_a_shape(const deck::Cursor& cursor);
/// Reads that card: area, second moments and torsion constant of the section come from the shape; the area is no number
/// where the card was refused.
void read_named_shape(Builder& builder, deck::Cursor& cursor, SectionBeam& section);

/// The section that comes next has the points of rule `id`; `given`: QR/IRID. `location` and `extent`: NSLOC and TS1.
void take_beam_rule(Builder& builder, int id, const deck::Entry& given, const deck::Entry& location,
                    const deck::Entry& extent);

}  // namespace nugget::reading
