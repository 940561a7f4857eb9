// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/finding.hpp"
#include "deck/deck.hpp"
#include "model/model.hpp"

namespace nugget::reading {

/// Turns a deck into a model. Unknown and refused keywords are errors (with `skip_unsupported`: warnings, their cards
/// left out); unknown *DATABASE_ requests are warnings. All findings come at once; the model is usable only if there
/// are no errors. `weld_library`: the user's own failure function of welds, or null. `coarsening`: shells that are
/// merged while the mesh is made, or null; *CONTROL_COARSEN asks for it, weld::coarsening_of() says which.
model::Model build(const deck::Deck& deck, Findings& findings, bool skip_unsupported = false,
                   std::shared_ptr<const model::WeldLibrary> weld_library = nullptr,
                   const model::Coarsening* coarsening = nullptr);

}  // namespace nugget::reading
