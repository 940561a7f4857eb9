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

std::string brick_cards(int section, int hourglass) {
  return fmt::format(
      "$ Bricks of one point, held against hourglassing by assumed strains (type 6, QM = 1).\n"
      "*SECTION_SOLID\n$#   secid    elform\n{:10d}{:10d}\n*HOURGLASS\n$#    hgid       ihq        qm\n"
      "{:10d}{:10d}{:10.1f}\n",
      section, 1, hourglass, 6, 1.0);
}

std::string brick_lines(const model::WeldSection& section, int first, int part, int below, int above) {
  std::string lines;
  for (const auto& quad : section.quad) {
    lines += fmt::format("{:8d}{:8d}", first++, part);
    for (const int node : {below, above})
      for (const int k : quad) lines += fmt::format("{:8d}", node + k);
    lines += '\n';
  }
  return lines;
}

}  // namespace nugget::weld
