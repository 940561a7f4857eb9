// SPDX-License-Identifier: Apache-2.0
#include "deck/cases.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "deck/numbers.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

constexpr std::size_t case_number_width = 10;

int number_behind(std::string_view keyword, std::string_view start) {
  int number = 0;
  if (!keyword.starts_with(start)) return 0;
  return parse_integer(keyword.substr(start.size()), number) == WholeNumber::good && number > 0 ? number : 0;
}

/// The numbers of a line of subcases, in columns of ten or between commas; nothing where it is another text.
std::vector<int> subcases_of(std::string_view line) {
  std::vector<int> numbers;
  const bool free = line.find(',') != std::string_view::npos;
  while (!line.empty()) {
    const std::size_t width = std::min(free ? line.find(',') : case_number_width, line.size());
    const std::string_view cell = trimmed(line.substr(0, width));
    int number = 0;
    if (!cell.empty() && (parse_integer(cell, number) != WholeNumber::good || number <= 0)) return {};
    if (number > 0) numbers.push_back(number);
    line.remove_prefix(std::min(line.size(), width + (free ? 1 : 0)));
  }
  return numbers;
}

/// Goes through the lines of a text and keeps what belongs to cases.
class CaseReader {
 public:
  CaseReader(const std::string& file, Findings& findings) : file_(file), findings_(findings) {}

  void read(std::string_view line, int number) {
    if (ended_ || line.starts_with('$')) return;
    if (line.starts_with('*')) {
      in_card_ = false;
      // The end of the keyword is found as the reader of blocks does: at the first blank.
      const std::string_view word = line.substr(1, std::min(line.size(), line.find_first_of(" \t\r")) - 1);
      if (word.size() >= 3 && word.size() < 32) begin(upper(word), number);
    } else if (in_card_) {
      take(line);
    }
  }

  std::vector<Case> finish() {
    for (const Case& c : explicit_) check(c);
    return explicit_.empty() ? std::move(implicit_) : std::move(explicit_);
  }

 private:
  void begin(const std::string& keyword, int number) {
    const Place place{file_, number, 1};
    if (keyword == "END") {
      ended_ = true;
    } else if (keyword == "CASE") {
      in_card_ = true;
      lines_ = 0;
      explicit_.push_back({.id = 0, .job = {}, .subcases = {}, .commands = {}, .place = place});
    } else if (const int n = subcase_begun(keyword); n > 0) {
      if (std::ranges::none_of(implicit_, [n](const Case& c) { return c.id == n; }))
        implicit_.push_back({.id = n, .job = {}, .subcases = {n}, .commands = {}, .place = place});
    }
  }

  void check(const Case& c) {
    if (c.id <= 0)
      findings_.error(c.place, "*CASE", "CASEID must be a whole number above 0", "number the cases from 1");
    else if (std::ranges::find(explicit_, c.id, &Case::id)->place.line != c.place.line)
      findings_.error(c.place, "*CASE", fmt::format("there is a case {} before", c.id),
                      "give each a number of its own");
    for (const int n : c.subcases)
      if (std::ranges::find(implicit_, n, &Case::id) == implicit_.end())
        findings_.error(c.place, "*CASE", fmt::format("there is no *CASE_BEGIN_{}", n),
                        "name subcases that stand in the master file");
  }

  /// CASEID and JOBID; then command lines and lines of subcases, told apart by what they hold.
  void take(std::string_view line) {
    Case& c = explicit_.back();
    if (lines_++ == 0) {
      const std::size_t comma = line.find(',');
      const bool free = comma != std::string_view::npos;
      const std::size_t width = free ? comma : std::min(case_number_width, line.size());
      int id = 0;
      if (parse_integer(trimmed(line.substr(0, width)), id) == WholeNumber::good) c.id = id;
      c.job = trimmed(line.substr(std::min(line.size(), width + (free ? 1 : 0))));
    } else if (const std::vector<int> numbers = subcases_of(line); !numbers.empty()) {
      c.subcases.insert(c.subcases.end(), numbers.begin(), numbers.end());
    } else if (const std::string_view words = trimmed(line); !words.empty()) {
      if (!c.commands.empty()) c.commands += ' ';
      c.commands += words;
    }
  }

  const std::string& file_;
  Findings& findings_;
  std::vector<Case> explicit_, implicit_;
  bool in_card_ = false, ended_ = false;
  int lines_ = 0;  ///< of the *CASE that is being read
};

}  // namespace

int subcase_begun(std::string_view keyword) {
  return number_behind(keyword, "CASE_BEGIN_");
}
int subcase_ended(std::string_view keyword) {
  return number_behind(keyword, "CASE_END_");
}

std::vector<Case> cases_of(std::string_view text, const std::string& file, Findings& findings) {
  CaseReader reader(file, findings);
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read(text.substr(0, end), number);
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return reader.finish();
}

}  // namespace nugget::deck
