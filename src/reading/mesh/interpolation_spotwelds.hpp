// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/model.hpp"

// The beams of *CONSTRAINED_INTERPOLATION_SPOTWELD.
namespace nugget::reading {

using namespace model;

/// The model with a discrete beam (kernel::DiscreteBeam::joint) for each weld of its `interpolation_spotwelds`, a part
/// of them a card, and a tie that holds the beam's two nodes, both at the location node, one to each sheet. Of sheets
/// of several parts the one whose shells are closest to the location node counts. A weld has the id of its location
/// node where beams of the deck have smaller ids and no other weld has it, else the next free one; nodes, parts,
/// sections and materials have the next free ids. A note says which.
Model with_interpolation_spotwelds(Model model, Findings& findings);

}  // namespace nugget::reading
