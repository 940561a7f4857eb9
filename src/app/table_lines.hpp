// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

// Tables that users write: values between commas, semicolons or tabs; `#` and `$` begin remarks.
namespace nugget::app {

/// The cells of a line without blanks and quotes around them.
std::vector<std::string> cells_of(const std::string& line);
/// A remark, or nothing but blanks.
bool is_remark(const std::string& line);

}  // namespace nugget::app
