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

std::string name_lines(std::string name) {
  constexpr std::size_t width = 78;
  std::string lines;
  while (name.size() > 80) {
    lines += name.substr(0, width) + " +\n";
    name.erase(0, width);
  }
  return lines + name + '\n';
}

}  // namespace nugget::weld
