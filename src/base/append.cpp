// SPDX-License-Identifier: Apache-2.0
#include "base/append.hpp"

#include <iterator>

namespace nugget {

void append_formatted(std::string& text, fmt::string_view format, fmt::format_args values) {
  fmt::vformat_to(std::back_inserter(text), format, values);
}

}  // namespace nugget
