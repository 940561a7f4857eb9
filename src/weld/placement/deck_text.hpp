// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

// Pieces of the decks that are written here.
namespace nugget::weld {

/// A number in a field of ten columns, with as many digits as they hold beside a blank.
std::string real_field(double value);

}  // namespace nugget::weld
