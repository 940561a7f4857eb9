// SPDX-License-Identifier: Apache-2.0
#include "output/ascii.hpp"

namespace nugget::output {

std::string fixed_width(const std::string& text, std::size_t width) {
  std::string fixed = text.substr(0, width);
  fixed.resize(width, ' ');
  return fixed;
}

std::string title_lines(const Header& header) {
  return fmt::format(" {}\n                    ls-dyna {:<22} date {}\n", fixed_width(header.title, 72), header.version,
                     header.date);
}

std::string legend_lines(std::span<const LegendEntry> legend) {
  if (legend.empty()) return "\n\n";
  std::string lines = "\n{BEGIN LEGEND}\n Entity #        Title\n";
  for (const LegendEntry& entry : legend)
    lines += fmt::format("{:9}     {}\n", entry.id, fixed_width(entry.heading, 70));
  return lines + "\n{END LEGEND}\n";
}

}  // namespace nugget::output
