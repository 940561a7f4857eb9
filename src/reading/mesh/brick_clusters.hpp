// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/model.hpp"

// RPBHX of *CONTROL_SPOTWELD_BEAM: clusters of bricks in place of weld beams.
namespace nugget::reading {

using namespace model;

/// The model with its weld beams replaced as Control::weld_beams asks, by the cross-sections of model/weld_section.hpp;
/// the same model where it asks for nothing. A cluster has the area of its beam and takes its id; nodes and bricks get
/// the next free ids. Parts whose beams are replaced become solid parts: ELFORM 1, and where they name no hourglass
/// control type 6 with QM = 1. Beams of them that stay get a part of their own. What names the beams' nodes or parts in
/// contacts and sets names the new ones too. Everything is said in findings; a beam of no length is an error.
Model with_brick_clusters(Model model, Findings& findings);

}  // namespace nugget::reading
