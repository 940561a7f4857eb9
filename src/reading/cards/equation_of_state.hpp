// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// Whether solids of the material get their pressure from an equation of state: *MAT_JOHNSON_COOK, *MAT_NULL.
bool takes_equation_of_state(const Material& material);

/// Refuses a part whose card names an equation of state that is not there.
void refuse_unknown_state(Builder& builder, const deck::RowOf<PartCard>& part_row);

std::vector<Keyword> equation_of_state_keywords();  ///< *EOS_...

}  // namespace nugget::reading
