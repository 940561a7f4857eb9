// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace nugget::reading {

/// True for keywords that may stand in a file that *INCLUDE_TRANSFORM mirrors: they mean the same in a mirror image, or
/// their readers turn them, or refuse the fields that they cannot turn. All others are refused there by name.
bool can_be_mirrored(std::string_view keyword);

}  // namespace nugget::reading
