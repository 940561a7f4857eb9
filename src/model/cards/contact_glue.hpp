// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/builder.hpp"

// The cards of glue: *CONTACT_..._TIEBREAK and *CONTACT_TIEBREAK_....
namespace nugget::model {

/// The card of glue, if the keyword has one.
std::optional<deck::Row> read_glue(Builder& builder, deck::Cursor& cursor, const Options& options, Contact& contact);

/// What of the glue needs the curves.
void finish_glue(Builder& builder, const deck::Row& row, Contact& contact);

/// These cards for `nugget keywords`. `option`: _TIEBREAK is one of the options of the keyword `name`.
std::vector<LayoutCard> glue_layout(std::string_view name, bool option);

}  // namespace nugget::model
