// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// Cuts the model's cross sections by planes with all nodes where they stand at the start of the run: initial
/// penetrations resolved, and the ends of welds where these are held, on the surfaces of their sheets, moved there or
/// not. So a section between two sheets has what the welds there carry. The bricks of *INITIAL_STRESS_SECTION follow.
/// Warns of planes that cut nothing.
void cut_sections(model::Model& model, const Ties& ties, Findings& findings);

}  // namespace nugget::weld
