// SPDX-License-Identifier: Apache-2.0
#include "app/finding_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>
#include <unordered_map>

namespace nugget::app {
namespace {

constexpr std::size_t shown_alike = 3, places_of_many = 8;

/// Text with each number in it replaced by one sign.
std::string without_numbers(const std::string& text) {
  std::string out;
  const auto digit = [&](std::size_t i) {
    return i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool sign = (text[i] == '-' || text[i] == '+' || text[i] == '.') && digit(i + 1);
    if (!sign && !digit(i)) {
      out += text[i];
      continue;
    }
    while (digit(i + 1) || ((text[i + 1] == '.' || text[i + 1] == 'e' || text[i + 1] == '-') && digit(i + 2))) ++i;
    out += '#';
  }
  return out;
}

bool is_missing_file(const Finding& f) {
  return f.severity == Severity::error && f.keyword.starts_with("*INCLUDE") &&
         f.text.starts_with("cannot find the file");
}

/// What a file that is not there may define: of all such errors one is shown.
constexpr std::string_view undefined = "is not defined";

std::string kind_of(const Finding& f, bool file_missing) {
  if (file_missing && f.severity == Severity::error && f.text.find(undefined) != f.text.npos)
    return std::string(undefined);
  return fmt::format("{}|{}|{}|{}", to_string(f.severity), f.keyword, f.field, without_numbers(f.text));
}

/// Where the findings from `begin` on stand: line numbers, the file's name where it changes.
std::string places(const std::vector<const Finding*>& alike, std::size_t begin) {
  std::string text, file = alike[begin]->place.file;
  std::size_t named = 0, i = begin;
  for (int last = 0; i < alike.size() && named < places_of_many; ++i) {
    const Place& place = alike[i]->place;
    if (place.line == 0 || (place.line == last && place.file == file)) continue;
    last = place.line;
    const bool elsewhere = place.file != file;
    text += fmt::format("{}{}{}", named++ == 0 ? "" : ", ", elsewhere ? place.file + ':' : "", place.line);
    file = place.file;
  }
  if (named == 0) return {};
  return fmt::format(", at line{} {}{}", named == 1 ? "" : "s", text, i < alike.size() ? ", ..." : "");
}

/// The errors behind the first that name what is not defined.
std::string rest_undefined(const std::vector<const Finding*>& alike) {
  return fmt::format(
      "and {} more error{} that something is not defined{}: the missing file may hold it [put the file in place first; "
      "findings.json has each]",
      alike.size() - 1, alike.size() == 2 ? "" : "s", places(alike, 1));
}

std::string rest(const std::vector<const Finding*>& alike) {
  Finding line = *alike[shown_alike];
  line.value.clear();
  line.keyword += line.field.empty() ? "" : ' ' + line.field;
  line.field.clear();
  line.text = fmt::format("and {} more of this kind{}", alike.size() - shown_alike, places(alike, shown_alike));
  line.remedy = "findings.json has each";
  return to_string(line);
}

}  // namespace

std::vector<std::string> list_findings(const std::vector<Finding>& findings) {
  std::unordered_map<std::string, std::vector<const Finding*>> kinds;
  const bool file_missing = std::any_of(findings.begin(), findings.end(), is_missing_file);
  for (const Finding& f : findings) kinds[kind_of(f, file_missing)].push_back(&f);
  std::vector<std::string> lines;
  for (const Finding& f : findings) {
    const std::string kind = kind_of(f, file_missing);
    const std::vector<const Finding*>& alike = kinds.at(kind);
    if (kind == undefined && alike.size() > 2) {
      if (alike[0] == &f) lines.push_back(to_string(f));
      if (alike[1] == &f) lines.push_back(rest_undefined(alike));
      continue;
    }
    if (alike.size() <= most_alike) {
      lines.push_back(to_string(f));
      continue;
    }
    for (std::size_t i = 0; i <= shown_alike; ++i)
      if (alike[i] == &f) lines.push_back(i < shown_alike ? to_string(f) : rest(alike));
  }
  return lines;
}

}  // namespace nugget::app
