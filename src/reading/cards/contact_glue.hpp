// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "reading/builder/builder.hpp"

// The cards of glue: *CONTACT_..._TIEBREAK and *CONTACT_TIEBREAK_....
namespace nugget::reading {

/// The card of one mode of a layer that yields and softens, with these names for its fields: energies, yield stress,
/// rates and plateau, and a curve of the energy, as *MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE has them.
Card elastoplastic_mode_card(std::string_view energy, std::string_view fast_energy, std::string_view energy_rate,
                             std::string_view yield, std::string_view growth, std::string_view yield_rate,
                             std::string_view plateau, std::string_view curve);
/// What stands there; the names of the fields again. Findings where something is missing.
kernel::ElastoplasticMode elastoplastic_mode(Builder& builder, const deck::Row& row,
                                             const std::array<std::string_view, 8>& field);

/// The card of glue, if the keyword has one.
std::optional<deck::Row> read_glue(Builder& builder, deck::Cursor& cursor, const Options& options, Contact& contact);

/// What of the glue needs the curves.
void finish_glue(Builder& builder, const deck::Row& row, Contact& contact);

/// These cards for `nugget keywords`. `option`: _TIEBREAK is one of the options of the keyword `name`.
std::vector<LayoutCard> glue_layout(std::string_view name, bool option);

}  // namespace nugget::reading
