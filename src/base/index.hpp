// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace nugget {

/// An index of a model or system (int, -1 for none) where a size is meant: compared with one, counted on, passed as
/// one. A subscript takes the index as it is. The caller knows that it is not none.
constexpr std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

}  // namespace nugget
