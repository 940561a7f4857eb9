// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// The optional cards A to G as `nugget keywords` shows them.
std::vector<LayoutCard> optional_contact_layout();

/// Reads them, as many as there are, and expects nothing behind them.
void read_optional_contact_cards(Builder& builder, deck::Cursor& cursor, Contact& contact);

/// CPARM8, of card E and of the cards of _MPP.
void take_cparm8(Builder& builder, const deck::Entry& field, Contact& contact);

}  // namespace nugget::reading
