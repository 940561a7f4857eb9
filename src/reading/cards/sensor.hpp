// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reading/builder/builder.hpp"

namespace nugget::reading {

/// Refuses what the sensors of a switch that `field` asks for do not measure, and those that ask for themselves. To be
/// called in Phase::checks; finds what the sensors look at.
void check_asked_switch(Builder& b, const deck::Entry& field, Index of_switch);

}  // namespace nugget::reading
