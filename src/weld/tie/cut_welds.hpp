// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Warns of cross sections by a plane that runs between the ends of a weld only once these stand on their sheets: which
/// elements a plane cuts is found where the deck has their nodes, so that the force of such a weld is not in the
/// section.
void report_cut_welds(const model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
