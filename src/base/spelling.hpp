// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace nugget {

/// Number of letters to change, add, take away or swap with their neighbour to make one word of the other (optimal
/// string alignment).
std::size_t letters_apart(std::string_view a, std::string_view b);

}  // namespace nugget
