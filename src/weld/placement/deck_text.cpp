// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/deck_text.hpp"

#include <fmt/format.h>

namespace nugget::weld {

std::string real_field(double value) {
  std::string text;
  for (int digits = 8; digits > 1; --digits)
    if (text = fmt::format("{:.{}g}", value, digits); text.size() < 10) break;
  return fmt::format("{:>10}", text);
}

}  // namespace nugget::weld
