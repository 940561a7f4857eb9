// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// *CONTACT_INTERIOR: bricks that press back when they are crushed.
Keyword interior_keyword();

}  // namespace nugget::reading
