// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/deck_text.hpp"

#include <fmt/format.h>

namespace nugget::weld {

namespace {

/// Without what a reader of numbers does not need: 2.017e9 for 2.017e+09, .25 for 0.25.
std::string shortest(std::string text) {
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    const bool small = text[e + 1] == '-';
    text = text.substr(0, e) + (small ? "e-" : "e") + text.substr(text.find_first_not_of("+-0", e + 1));
  }
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  if (text.compare(first, 2, "0.") == 0) text.erase(first, 1);
  return text;
}

}  // namespace

std::string real_field(double value) {
  std::string text;
  for (int digits = 8; digits > 1; --digits) {
    if (text = fmt::format("{:.{}g}", value, digits); text.size() < 10) break;
    if (text = shortest(text); text.size() < 10) break;
  }
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
