// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

namespace nugget {

/// Appends what fmt::vformat gives. Compiled once: the same by fmt::format_to is compiled in each source that uses it,
/// 2 s each.
void append_formatted(std::string& text, fmt::string_view format, fmt::format_args values);

/// Appends what fmt::format gives, without a string in between.
template <class... Args>
void append(std::string& text, fmt::format_string<Args...> format, Args&&... args) {
  append_formatted(text, format, fmt::make_format_args(args...));
}

}  // namespace nugget
