// SPDX-License-Identifier: Apache-2.0
#include "app/history_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "impact/recording/histories.hpp"
#include "reading/describe.hpp"

namespace nugget::app {
namespace {

/// swforc of *DATABASE_SWFORC; nothing where the keyword begins otherwise.
std::string file_of(std::string keyword) {
  std::ranges::transform(keyword, keyword.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string_view name = keyword;
  if (name.starts_with('*')) name.remove_prefix(1);
  constexpr std::string_view family = "database_";
  return name.starts_with(family) ? std::string(name.substr(family.size())) : std::string();
}

}  // namespace

std::string describe_history(const std::string& keyword) {
  const std::vector<impact::HistoryFile> files = impact::histories();
  const auto file = std::ranges::find(files, file_of(keyword), [](const auto& f) { return f.name.text(); });
  if (file == files.end()) return {};
  std::vector<std::array<std::string, 4>> rows{{"branch", "column", "dimension", "meaning"}};
  const output::ColumnMeaning* before = nullptr;
  for (const output::ColumnMeaning& c : file->columns) {
    // Components of a vector share a row.
    if (before && c.branch == before->branch && c.meaning == before->meaning && c.dimension == before->dimension)
      rows.back()[1] += ", " + c.name;
    else
      rows.push_back({c.branch, c.name, reading::text_of(c.dimension), std::string(c.meaning)});
    before = &c;
  }
  std::array<std::size_t, 3> width{};
  for (const auto& row : rows)
    for (std::size_t i = 0; i < width.size(); ++i) width[i] = std::max(width[i], row[i].size());
  std::string text = fmt::format("\n{} in binout0000\n", file->name.text());
  for (const auto& row : rows)
    text += fmt::format("  {:<{}}  {:<{}}  {:<{}}  {}\n", row[0], width[0], row[1], width[1], row[2], width[2], row[3]);
  return text;
}

}  // namespace nugget::app
