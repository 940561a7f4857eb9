// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace nugget::app {

/// The columns of the history file that a keyword asks for (*DATABASE_SWFORC), with dimension and meaning; nothing for
/// another keyword.
std::string describe_history(const std::string& keyword);

}  // namespace nugget::app
