// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/card.hpp"
#include "model/model.hpp"

// Texts out of the list of keywords: what `nugget keywords` prints, and the table of keywords of a run.
namespace nugget::reading {

/// `M L^-1 T^-2`, or `-` for a pure number.
std::string text_of(const Dimension& dimension);

/// All keywords as a table: name, status, options, and why a keyword is ignored or refused.
std::string describe_keywords();

/// One keyword (with or without its star, any case, options included) with its cards field by field: columns, kind,
/// default, allowed values, dimension, meaning. Says so where the name is unknown, and which name is near.
std::string describe_keyword(std::string_view name);

/// What of a family of keywords is built, `SECTION_` or the like: "built are *SECTION_BEAM, _SHELL and _SOLID", or, of
/// many, how to list them; empty where nothing is.
std::string built_of_family(std::string_view beginning);

/// What became of each keyword of a deck, for run.log.
std::string keyword_use_table(const model::Model& model);

/// A known keyword that `written` is probably meant to be, with its _ID, _TITLE or _MPP but without its star; empty
/// where none is near.
std::string similar_keyword(std::string_view written);

}  // namespace nugget::reading
