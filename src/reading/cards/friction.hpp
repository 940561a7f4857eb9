// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// The *DEFINE_FRICTION that FD of a contact with FS = -2 names; 0: the first; none and a finding where there is none.
/// FD is a number in the card's table, so its offset as an id is given here. From Phase::conditions on.
Index friction_table(Builder& builder, const deck::Entry& fs, const deck::Entry& fd, long offset);

}  // namespace nugget::reading
