// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/weld_function.hpp"
#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// Ids of functions stand in fields of numbers, which know no offset of ids and have unit factors: refused where
/// *INCLUDE_TRANSFORM gives either.
void refuse_transformed_functions(Builder& b, const deck::Block& block, const deck::Entry& field);

/// The *DEFINE_FUNCTION of both sheets of a weld that a field names, in Model::functions; none where it is refused.
Index weld_function(Builder& b, const deck::Entry& field);

}  // namespace nugget::reading
