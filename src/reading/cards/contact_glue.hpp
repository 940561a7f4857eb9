// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "reading/builder/builder.hpp"

// The cards of glue: *CONTACT_..._TIEBREAK and *CONTACT_TIEBREAK_....
namespace nugget::reading {

/// One mode of a layer that yields and softens, as *MAT_COHESIVE_MIXED_MODE_ELASTOPLASTIC_RATE has it.
struct ElastoplasticModeCard {
  double energy = 0, fast_energy = 0, energy_rate = 0;
  double yield = 0, growth = 0, yield_rate = 0, plateau = 0;
  int curve = 0;
};
/// Its card; `names`: of the fields, in this order.
CardOf<ElastoplasticModeCard> elastoplastic_mode_card(const std::array<std::string_view, 8>& names);
/// What stands there. Findings where something is missing.
kernel::ElastoplasticMode elastoplastic_mode(Builder& builder, const deck::RowOf<ElastoplasticModeCard>& row);

/// All cards of glue but those of modes.
struct GlueCards {
  int option = 0;
  double nfls = 0, sfls = 0, param = 0, eraten = 0, erates = 0, ct2cn = 0, cn = 0;
  int curve = 0;                                ///< SFLS of OPTION 5, TBLCID
  double nflf = 0, sflf = 0, nen = 0, mes = 0;  ///< of *CONTACT_TIEBREAK_NODES_...
  int thkoff = 0;
};

/// The card of glue, if the keyword has one.
std::optional<deck::RowOf<GlueCards>> read_glue(Builder& builder, deck::Cursor& cursor, const Options& options,
                                                Contact& contact);

/// What of the glue needs the curves.
void finish_glue(Builder& builder, const deck::RowOf<GlueCards>& row, Contact& contact);

/// These cards for `nugget keywords`. `option`: _TIEBREAK is one of the options of the keyword `name`.
std::vector<LayoutCard> glue_layout(std::string_view name, bool option);

}  // namespace nugget::reading
