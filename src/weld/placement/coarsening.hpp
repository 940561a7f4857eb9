// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Which shells *CONTROL_COARSEN merges: four quadrilaterals of one part, thickness and offset around a node that
/// nothing else needs, all within ANGLE of each other and of the shell that they become, whose mid-side nodes lie on
/// its sides (within a tenth of a side; a fiftieth on a free edge). Merging begins at the seeds, then at the first node
/// that allows it, and spreads from each merged shell to the next ones beyond its sides. Left alone: what welds and
/// other ties are made to, nodes that the list of held_nodes() or a list of a set names, loads, motions, shells with
/// initial stress, history or a name of their own in the deck, the parts of PSID, and what boxes protect. A mid-side
/// node that shells beyond the side still need is a hanging node between the side's ends; it is never a corner of a
/// merged shell. `ties`: of the model as the deck has it. Method: docs/theory/coarsening.md.
model::Coarsening coarsening_of(const model::Model& model, const Ties& ties);

}  // namespace nugget::weld
