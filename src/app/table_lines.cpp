// SPDX-License-Identifier: Apache-2.0
#include "app/table_lines.hpp"

namespace nugget::app {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \r\"");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \r\"") + 1 - begin);
}

}  // namespace

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (;;) {
    const std::size_t end = line.find_first_of(",;\t", begin);
    cells.push_back(trimmed(line.substr(begin, end - begin)));
    if (end == std::string::npos) return cells;
    begin = end + 1;
  }
}

bool is_remark(const std::string& line) {
  return trimmed(line).empty() || line.front() == '#' || line.front() == '$';
}

}  // namespace nugget::app
