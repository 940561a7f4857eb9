// SPDX-License-Identifier: Apache-2.0
#include "deck/reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "deck/text.hpp"

namespace nugget::deck {
namespace {

namespace fs = std::filesystem;

/// Goes through a text line by line.
class Lines {
 public:
  explicit Lines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);  // a byte order mark
  }

  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    const auto* const end = static_cast<const char*>(std::memchr(rest_.data(), '\n', rest_.size()));
    const std::size_t length = end == nullptr ? rest_.size() : static_cast<std::size_t>(end - rest_.data());
    line = rest_.substr(0, length);
    rest_.remove_prefix(std::min(rest_.size(), length + 1));
    ++number_;
    return true;
  }

  /// The lines up to the next keyword, as one text.
  std::string_view up_to_keyword() {
    const char* const start = rest_.data();
    std::string_view line;
    while (!rest_.empty() && rest_.front() != '*') next(line);
    return {start, static_cast<std::size_t>(rest_.data() - start)};
  }

  int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;  ///< of the last line given out
};

std::string_view without_line_end(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

/// True for `base` alone and with options behind it.
bool is_family(std::string_view keyword, std::string_view base) {
  return keyword.starts_with(base) && (keyword.size() == base.size() || keyword[base.size()] == '_');
}

bool is_bulk(std::string_view keyword) {
  return keyword == "NODE" || is_family(keyword, "ELEMENT_SHELL") || is_family(keyword, "ELEMENT_SOLID") ||
         is_family(keyword, "ELEMENT_BEAM") || keyword == "ELEMENT_TSHELL";
}

/// The format that `%`, `+` or `-` at the end of a keyword line asks for.
bool format_of_suffix(char c, Format& format) {
  switch (c) {
    case '%': format = Format::i10; return true;
    case '+': format = Format::long_format; return true;
    case '-': format = Format::standard; return true;
    default: return false;
  }
}

}  // namespace

Reader::Reader(Deck& deck, Findings& findings, fs::path folder, int load_case)
    : deck_(deck), findings_(findings), folder_(std::move(folder)), load_case_(load_case) {}

void Reader::read_master(const fs::path& path) {
  deck_.path = path;
  deck_.files.push_back(path.string());
  const std::string fault = deck_.impl->texts.emplace_back().open(path);
  if (!fault.empty()) {
    findings_.error({path.string(), 0, 0}, {}, "cannot read the deck: " + fault, "check the name of the file");
    return;
  }
  std::error_code ignored;
  open_.push_back(fs::canonical(path, ignored));
  Visit visit;
  visit.path = path;
  run(std::move(visit));
}

void Reader::read_master_text(std::string text) {
  deck_.path = folder_ / "(text)";
  deck_.files.emplace_back("(text)");
  deck_.impl->texts.emplace_back(std::move(text));
  open_.emplace_back();
  Visit visit;
  visit.path = deck_.path;
  run(std::move(visit));
}

void Reader::run(Visit master) {
  const int errors = findings_.errors();
  choose_case();
  read_file(std::move(master));
  for (const auto& [subcase, place] : begun_subcases_)
    findings_.error(place, fmt::format("*CASE_BEGIN_{}", subcase), "its end is missing",
                    fmt::format("write *CASE_END_{} behind the last keyword of the subcase", subcase));
  define_transformations();
  resolve_transforms();
  if (deck_.blocks.empty() && deck_.consumed.empty() && findings_.errors() == errors) {
    findings_.error({deck_.files.front(), 0, 0}, {}, "the file has no keyword",
                    "an LS-DYNA keyword deck starts with *KEYWORD");
  }
}

void Reader::read_file(Visit visit) {
  const std::string_view text = deck_.impl->texts[visit.file].view();
  deck_.bytes += text.size();
  if (!is_text(visit)) return;
  warn_of_tabs(visit);

  Lines lines(text);
  Block block;
  bool in_block = false;
  bool stray_reported = false;
  std::string_view line;
  while (lines.next(line)) {
    if (!line.empty() && line.front() == '$') continue;
    if (!line.empty() && line.front() == '*') {
      if (in_block) finish(block, visit);
      begin(block, without_line_end(line), lines.number(), visit);
      in_block = true;
      if (block.keyword == "END") break;
      if (is_bulk(block.keyword)) {
        block.bulk_line = lines.number() + 1;
        block.bulk = lines.up_to_keyword();
      }
    } else if (in_block) {
      block.lines.push_back({without_line_end(line), lines.number()});
    } else if (!stray_reported && !trimmed(line).empty()) {
      stray_reported = true;
      report_stray_text(visit, lines.number());
    }
  }
  if (in_block) finish(block, visit);
  deck_.impl->parameters.leave_file(visit.depth);
}

/// In an include file such text may be meant to go on with the block before the *INCLUDE.
void Reader::report_stray_text(const Visit& visit, int line) {
  const Place place{deck_.files[visit.file], line, 1};
  const std::string text = "text before the first keyword is not read", remedy = "start it with $ if it is a comment";
  if (visit.depth == 1) {
    findings_.warning(place, {}, text, remedy);
  } else {
    findings_.error(place, {}, text, "repeat the keyword at the top of the include file, or " + remedy);
  }
}

bool Reader::is_text(const Visit& visit) {
  const std::string_view start = deck_.impl->texts[visit.file].view().substr(0, 4096);
  if (start.find('\0') == std::string_view::npos) return true;
  findings_.error({deck_.files[visit.file], 0, 0}, {}, "this is not a text file",
                  "give the keyword deck as plain text (unpacked, not encrypted)");
  return false;
}

void Reader::warn_of_tabs(const Visit& visit) {
  const std::string_view text = deck_.impl->texts[visit.file].view();
  for (std::size_t at = text.find('\t'); at != std::string_view::npos; at = text.find('\t', at)) {
    const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t start = before == std::string_view::npos ? 0 : before + 1;
    if (text[start] != '$') {
      const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(start), '\n');
      findings_.warning({deck_.files[visit.file], static_cast<int>(line), static_cast<int>(at - start) + 1}, {},
                        "the file has tabs; each is read as one blank",
                        "replace tabs by blanks, or separate fields by commas");
      return;
    }
    at = std::min(text.find('\n', at), text.size());
  }
}

void Reader::begin(Block& block, std::string_view line, int number, const Visit& visit) const {
  block = {};
  block.place = {deck_.files[visit.file], number, 1};
  block.file = visit.file;
  block.format = visit.format;
  block.transform = visit.transform;
  block.scope = deck_.impl->parameters.now();

  line.remove_prefix(1);
  const auto end = static_cast<std::size_t>(std::find_if(line.begin(), line.end(), is_blank) - line.begin());
  std::string_view word = line.substr(0, end);
  const std::string_view rest = trimmed(line.substr(end));
  if (!word.empty() && format_of_suffix(word.back(), block.format)) {
    word.remove_suffix(1);
  } else if (rest.size() == 1) {
    format_of_suffix(rest.front(), block.format);
  }
  block.keyword = readable(upper(word));
  if (block.keyword == "KEYWORD") block.lines.push_back({rest, number});
}

void Reader::finish(Block& block, Visit& visit) {
  const auto consume = [&] { deck_.consumed.emplace_back(block.keyword, block.place); };
  if (block.keyword.empty()) {
    findings_.error(block.place, {}, "a star without the name of a keyword",
                    "start the line with $ if it is a comment");
  } else if (is_family(block.keyword, "KEYWORD")) {
    consume();
    take_keyword_options(block, visit);
  } else if (block.keyword == "END") {
    consume();
  } else if (is_family(block.keyword, "CASE")) {
    const bool begins = subcase_begun(block.keyword) > 0, ends = subcase_ended(block.keyword) > 0;
    deck_.consumed.emplace_back(begins ? "CASE_BEGIN" : ends ? "CASE_END" : block.keyword, block.place);
    if (block.keyword != "CASE") enter_or_leave_subcase(block, visit);
  } else if (!is_of_chosen_case()) {
    return;
  } else if (is_family(block.keyword, "PARAMETER")) {
    consume();
    parameters(block, visit);
  } else if (is_family(block.keyword, "INCLUDE")) {
    consume();
    include(block, visit);
  } else if (is_family(block.keyword, "DEFINE_TRANSFORMATION")) {
    consume();
    transformations_.push_back(std::move(block));
  } else {
    deck_.blocks.push_back(std::move(block));
  }
}

void Reader::take_keyword_options(const Block& block, Visit& visit) {
  if (block.keyword != "KEYWORD") return;  // *KEYWORD_ID and the like name the job only
  std::string options = upper(block.lines.front().text);
  std::erase_if(options, is_blank);
  Format format = visit.format;
  if (options.find("LONG=Y") != std::string::npos) {
    format = Format::long_format;
  } else if (options.find("I10=Y") != std::string::npos) {
    format = Format::i10;
  }
  if (visit.depth > 1 && format != visit.format) {
    findings_.warning(block.place, block.starred(),
                      "the format of this include file is set here; LS-DYNA takes it from the master file",
                      "mark the file's own *INCLUDE line with % (I10) or + (long)");
  }
  visit.format = format;
  for (std::size_t i = 1; i < block.lines.size(); ++i) {
    if (trimmed(block.lines[i].text).empty()) continue;
    findings_.warning({block.place.file, block.lines[i].number, 1}, block.starred(),
                      "this line belongs to no keyword and is not read", "start it with $ if it is a comment");
    return;
  }
}

// ---- *CASE

namespace {

std::string list_of_cases(const std::vector<Case>& cases) {
  std::string s;
  for (const Case& c : cases)
    s += fmt::format("{}{}{}", s.empty() ? "" : ", ", c.id, c.job.empty() ? "" : " (" + c.job + ")");
  return s;
}

}  // namespace

void Reader::choose_case() {
  std::vector<Case>& cases = deck_.cases;
  const int errors = findings_.errors();
  cases = cases_of(deck_.impl->texts.front().view(), deck_.files.front(), findings_);
  if (load_case_ == 0 && findings_.errors() > errors) return;
  const Place nowhere{deck_.files.front(), 0, 0};
  if (cases.empty()) {
    if (load_case_ != 0) findings_.error(nowhere, "--case", "the deck has no *CASE", "leave the option out");
    return;
  }
  const auto chosen = std::ranges::find(cases, load_case_, &Case::id);
  if (load_case_ == 0) {
    findings_.error(cases.front().place, "*CASE", "the deck has the cases " + list_of_cases(cases),
                    "take one with --case N; nugget run and nugget check without it take one after the other");
  } else if (chosen == cases.end()) {
    findings_.error(cases.front().place, "--case", fmt::format("there is no case {}", load_case_),
                    "the deck has " + list_of_cases(cases));
  } else {
    subcases_ = chosen->subcases;
    if (!chosen->commands.empty())
      findings_.warning(chosen->place, "*CASE", "'" + chosen->commands + "' of its command line is not obeyed",
                        "give options to nugget run");
  }
}

/// Subcases may overlap and be nested.
void Reader::enter_or_leave_subcase(const Block& block, const Visit& visit) {
  if (visit.depth > 1) {
    findings_.error(block.place, block.starred(), "cases stand in the master file only, as in LS-DYNA",
                    "put it around the *INCLUDE");
    return;
  }
  if (const int begun = subcase_begun(block.keyword); begun > 0) {
    begun_subcases_.emplace_back(begun, block.place);
  } else if (const int ended = subcase_ended(block.keyword); ended > 0) {
    const auto open = std::ranges::find(begun_subcases_, ended, &std::pair<int, Place>::first);
    if (open != begun_subcases_.end()) {
      begun_subcases_.erase(open);
    } else {
      findings_.error(block.place, block.starred(), "nothing begins that could end here",
                      fmt::format("write *CASE_BEGIN_{} before the first keyword of the subcase", ended));
    }
  } else {
    findings_.error(block.place, block.starred(), "this form of *CASE is not known",
                    "*CASE_BEGIN_n and *CASE_END_n with n above 0");
  }
}

/// What stands in several subcases at once belongs to each of them.
bool Reader::is_of_chosen_case() const {
  return begun_subcases_.empty() || std::ranges::any_of(begun_subcases_, [this](const auto& begun) {
           return std::ranges::find(subcases_, begun.first) != subcases_.end();
         });
}

// ---- Deck

Deck::Deck() : impl(std::make_unique<Impl>()) {}
Deck::~Deck() = default;
Deck::Deck(Deck&&) noexcept = default;
Deck& Deck::operator=(Deck&&) noexcept = default;

const Transform* Deck::transformation(int id) const {
  const auto entry = impl->transformations.find(id);
  return entry == impl->transformations.end() ? nullptr : &entry->second;
}

Deck read(const fs::path& master, Findings& findings, int load_case) {
  Deck deck;
  Reader(deck, findings, {}, load_case).read_master(master);
  return deck;
}

Deck read_text(std::string text, Findings& findings, const fs::path& directory, int load_case) {
  Deck deck;
  Reader(deck, findings, directory, load_case).read_master_text(std::move(text));
  return deck;
}

std::vector<Case> cases(const fs::path& master) {
  Findings said_when_it_is_read;
  FileText text;
  if (!text.open(master).empty()) return {};
  return cases_of(text.view(), master.string(), said_when_it_is_read);
}

}  // namespace nugget::deck
