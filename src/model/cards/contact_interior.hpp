// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/builder.hpp"

namespace nugget::model {

/// *CONTACT_INTERIOR: bricks that press back when they are crushed.
Keyword interior_keyword();

}  // namespace nugget::model
