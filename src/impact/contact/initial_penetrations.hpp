// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/finding.hpp"
#include "base/ranks.hpp"
#include "model/model.hpp"

namespace nugget::impact {

/// Where the nodes stand when ties are looked for, by node of the model [length]: in the deck's places, but for those
/// that sliding contacts with IGNORE = 0 move out of the sheets and bricks in which they stand. Contacts work in the
/// order of the deck, each on what those before it left. With IGNORE = 1 and 2 the overlap stays. Either way a finding
/// says how many nodes overlap, and of the deepest which node stands how deep in which element; 2 proposes coordinates
/// as well.
///
/// Ties come afterwards (S. Bala, "Deformable Spotwelds in LS-DYNA for Impact and NVH Applications": "Initialization is
/// performed after other penalty based contacts"), so that welds are as long as the sheets are apart.
///
/// `ranks`: all of them, which have read the same deck, look together, each at a part of the surface (docs/decisions/
/// 0140); places and findings are those of one process, on all of them. Null: this process alone.
std::vector<Vec3d> resolve_initial_penetrations(const model::Model& model, Findings& findings, Ranks* ranks = nullptr);

}  // namespace nugget::impact
