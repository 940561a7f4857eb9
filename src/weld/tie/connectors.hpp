// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// The discrete beams (ELFORM 6) that look like connections between sheets: no shell, brick, spring, cable or other
/// beam has one of their nodes, and not both nodes belong to rigid bodies. So they are tied, as spot-weld beams are.
std::vector<Index> find_connectors(const model::Model& model);

/// Whether the beams of `part` are the welds of a *CONSTRAINED_INTERPOLATION_SPOTWELD or the rivets of a _SPR2.
bool joins_sheets(const model::Model& model, Index part);
/// And the latter.
bool has_rivets(const model::Model& model, Index part);

}  // namespace nugget::weld
