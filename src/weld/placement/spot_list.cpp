// SPDX-License-Identifier: Apache-2.0
#include "weld/placement/spot_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <optional>
#include <string_view>

#include "deck/numbers.hpp"

namespace nugget::weld {
namespace {

constexpr std::array<std::string_view, 6> known{"x", "y", "z", "diameter", "parts", "class"};

std::string trimmed(std::string_view text) {
  const auto space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  while (!text.empty() && space(text.front())) text.remove_prefix(1);
  while (!text.empty() && space(text.back())) text.remove_suffix(1);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

std::vector<std::string> split(std::string_view line, std::string_view separators) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t end = line.find_first_of(separators);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) return cells;
    line.remove_prefix(end + 1);
  }
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Reads the lines of one table.
class Table {
 public:
  Table(std::string file, Findings& findings) : file_(std::move(file)), findings_(findings) {}

  void line(const std::string& text, int number) {
    number_ = number;
    const std::string content = trimmed(text);
    if (content.empty() || content.front() == '#' || content.front() == '$' || rejected_) return;
    if (separators_.empty()) separators_ = content.find_first_of(",;\t") == std::string::npos ? " " : ",;\t";
    std::vector<std::string> cells = split(content, separators_);
    if (separators_ == " ") std::erase(cells, "");
    double first = 0.0;
    if (columns_.empty()) {
      if (!deck::parse_real(cells.front(), first)) return head(cells);
      columns_.assign(known.begin(), known.end());
    }
    row(cells);
  }
  std::vector<SpotPoint> points() && { return std::move(points_); }

 private:
  void error(std::string text, std::string remedy, std::string field = {}, std::string value = {}) {
    Finding finding;
    finding.place = {file_, number_, 0};
    finding.field = std::move(field);
    finding.value = std::move(value);
    finding.text = std::move(text);
    finding.remedy = std::move(remedy);
    findings_.add(std::move(finding));
  }

  void head(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      columns_.push_back(lower(name));
      if (std::find(known.begin(), known.end(), columns_.back()) != known.end()) continue;
      error(fmt::format("the column '{}' is not known", name),
            fmt::format("columns are {}; remove it, or put a # before the line", fmt::join(known, ", ")));
      rejected_ = true;
    }
    for (const std::string_view name : {"x", "y", "z"})
      if (std::count(columns_.begin(), columns_.end(), name) != 1 && !rejected_) {
        error(fmt::format("the column '{}' stands {} times in the head", name,
                          std::count(columns_.begin(), columns_.end(), name)),
              "name each of x, y and z once");
        rejected_ = true;
      }
  }

  void row(const std::vector<std::string>& cells) {
    if (cells.size() > columns_.size())
      return error(
          fmt::format("{} cells, expected at most {} ({})", cells.size(), columns_.size(), fmt::join(columns_, ", ")),
          "a point a line; part ids in one cell are separated by + or blanks");
    SpotPoint point;
    point.place = {file_, number_, 0};
    bool good = true;
    for (std::size_t c = 0; c < columns_.size(); ++c)
      good = cell(columns_[c], c < cells.size() ? cells[c] : std::string(), point) && good;
    if (good) points_.push_back(std::move(point));
  }

  bool cell(const std::string& name, const std::string& text, SpotPoint& point) {
    if (name == "class") {
      point.spot_class = text;
      return true;
    }
    if (name == "parts") return parts(text, point);
    if (name == "diameter") return text.empty() || real(name, text, point.diameter, true);
    return real(name, text, name == "x" ? point.x.x : name == "y" ? point.x.y : point.x.z, false);
  }

  bool real(const std::string& name, const std::string& text, double& value, bool positive) {
    if (deck::parse_real(text, value) && (!positive || value > 0.0)) return true;
    error(positive ? "expected a number above 0" : "expected a number", "correct the cell", name,
          text.empty() ? "(blank)" : text);
    return false;
  }

  bool parts(const std::string& text, SpotPoint& point) {
    for (const std::string& piece : split(text, " +/|")) {
      if (piece.empty()) continue;
      int id = 0;
      if (deck::parse_integer(piece, id) != deck::WholeNumber::good || id <= 0) {
        error("expected part ids above 0, separated by + or blanks", "correct the cell", "parts", text);
        return false;
      }
      point.parts.push_back(id);
    }
    return true;
  }

  std::string file_;
  Findings& findings_;
  std::string separators_;
  std::vector<std::string> columns_;
  std::vector<SpotPoint> points_;
  int number_ = 0;
  bool rejected_ = false;
};

std::optional<std::string> whole_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path)) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

std::vector<SpotPoint> read_spots(const std::filesystem::path& path, const model::Model& model, Findings& findings) {
  std::optional<std::string> text = whole_text(path);
  if (!text) {
    findings.error({path.string(), 0, 0}, {}, "the list of points cannot be read", "check the name of the file");
    return {};
  }
  if (text->starts_with("\xEF\xBB\xBF")) text->erase(0, 3);
  if (trimmed(text->substr(0, 200)).starts_with('<')) return read_xmcf(*text, path.string(), model, findings);
  Table table(path.string(), findings);
  const int errors = findings.errors();
  int number = 0;
  for (std::size_t begin = 0; begin < text->size();) {
    const std::size_t end = std::min(text->find('\n', begin), text->size());
    table.line(text->substr(begin, end - begin), ++number);
    begin = end + 1;
  }
  std::vector<SpotPoint> points = std::move(table).points();
  if (points.empty() && findings.errors() == errors)
    findings.error({path.string(), 0, 0}, {}, "the list has no points",
                   "a point a line: x, y, z, diameter, parts, class");
  return points;
}

}  // namespace nugget::weld
