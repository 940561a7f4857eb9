// SPDX-License-Identifier: Apache-2.0
#include "deck/tidied_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "deck/card_text.hpp"
#include "deck/cells.hpp"
#include "deck/impl.hpp"
#include "deck/numbers.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

constexpr std::string_view machine_comment = "$#", fault_comment = "$# error: ", warning_comment = "$# warning: ";

bool is_same_field(const Field& a, const Field& b) {
  return a.name == b.name && a.width == b.width && a.kind == b.kind;
}

bool begins_as(const Card& whole, const Card& start) {
  return start.fields.size() <= whole.fields.size() &&
         std::equal(start.fields.begin(), start.fields.end(), whole.fields.begin(), is_same_field);
}

/// A title or a heading, which may hold commas and ends where it ends.
bool has_heading(const Card& card) {
  return std::ranges::any_of(card.fields, [](const Field& f) { return f.kind == Kind::text && f.width > 20; });
}

std::string_view trimmed_end(std::string_view text) {
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// Field names above the columns that `comma_form` fills.
std::string names_of(const Card& card, Format format) {
  std::string out(machine_comment);
  std::size_t end = 0;
  for (const Field& field : card.fields) {
    end += width_of(field, format);
    const std::size_t room = end > out.size() + 1 ? end - out.size() - 1 : 0;
    out += has_heading(card) ? fmt::format(" {:<{}}", field.name, room) : fmt::format(" {:>{}}", field.name, room - 1);
    if (!has_heading(card)) out += ' ';
  }
  return std::string(trimmed_end(out));
}

/// Cells behind those of the table, of which only zeros are left without a word: they stay.
void add_surplus(const Card& card, Format format, std::string_view line, std::vector<std::string_view>& cells) {
  std::size_t from = 0;
  for (const Field& field : card.fields) from += width_of(field, format);
  const std::size_t width = card.fields.empty() ? 10 : width_of(card.fields.back(), format);
  for (const std::size_t end = format == Format::long_format ? 160 : 80; from < std::min(end, line.size());
       from += width)
    cells.push_back(trimmed(columns(line, from, std::min(width, end - from))));
}

/// The cells between commas, each below the end of its name; a lone first one in its columns, without a comma.
std::string comma_form(const Card& card, Format format, const std::vector<std::string_view>& cells) {
  std::size_t count = cells.size();
  while (count > 0 && cells[count - 1].empty()) --count;
  std::string out;
  std::size_t end = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Field& field = card.fields[std::min(i, card.fields.size() - 1)];
    const std::size_t width = width_of(field, format);
    end += width;
    const bool lone = count == 1 && cells[i].size() <= width;
    const std::size_t room = end > out.size() + 1 ? end - out.size() - (lone ? 0 : 1) : 0;
    out += field.kind == Kind::text && !field.name.empty() ? fmt::format("{:<{}}", cells[i], room)
                                                           : fmt::format("{:>{}}", cells[i], room);
    if (i + 1 < count || (count == 1 && !lone)) out += ',';
  }
  return std::string(trimmed_end(out));
}

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

}  // namespace

const Card* TidiedText::kept_card(const Card& card) {
  const auto known = std::ranges::find_if(
      cards_, [&](const Card& c) { return c.fields.size() == card.fields.size() && begins_as(c, card); });
  return known != cards_.end() ? &*known : &cards_.emplace_back(card);
}

void TidiedText::add(const Block& block, std::size_t line, const Card& card) {
  const Line& here = block.lines[line];
  const Card* const own = kept_card(card);
  const auto [at, is_new] = index_.try_emplace(here.text.data(), lines_.size());
  if (!is_new) {
    ReadLine& read = lines_[at->second];
    read.is_doubtful |= read.format != block.format || !(begins_as(*read.card, *own) || begins_as(*own, *read.card));
    if (own->fields.size() > read.card->fields.size()) read.card = own;
    return;
  }
  const std::pair keyword{block.file, block.place.line};
  if (keyword != last_keyword_) named_.clear();
  last_keyword_ = keyword;
  // Rows of a table are named once, above the first; in between of other cards each is.
  const bool names = std::ranges::find(named_, own) == named_.end();
  if (names) named_.push_back(own);
  lines_.push_back({here.text, block.file, block.scope, here.number, own, block.format, false, names});
}

std::vector<std::string> TidiedText::parameters_in(const ReadLine& read) const {
  std::vector<CellText> cells;
  split(*read.card, read.format, read.text, cells);
  std::vector<std::string> out;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Field& field = read.card->fields[i];
    if (field.kind == Kind::text || cells[i].text.find_first_of("&<") == std::string_view::npos) continue;
    const Value value = evaluate(cells[i].text, deck_.impl->parameters, read.scope);
    if (value.fault == Value::Fault::none)
      out.push_back(fmt::format("{} {}: {} = {}", machine_comment, field.name, cells[i].text, value.number));
  }
  return out;
}

std::string_view TidiedText::with_comments_above(std::string_view text, std::size_t file,
                                                 std::string_view beginning) const {
  const std::string_view whole = edited_.text_of(file);
  auto begin = static_cast<std::size_t>(text.data() - whole.data());
  const std::size_t end = begin + text.size();
  while (begin > 1) {
    const std::size_t before = whole.rfind('\n', begin - 2) + 1;  // npos + 1 is 0
    const std::string_view line = whole.substr(before, begin - before);
    const bool is_machine = beginning.empty() ? line.starts_with(fault_comment) || line.starts_with(warning_comment)
                                              : line.starts_with(beginning);
    if (!is_machine) break;
    begin = before;
  }
  return whole.substr(begin, end - begin);
}

void TidiedText::write_line(const ReadLine& read, const std::vector<std::string>& faults) {
  std::vector<CellText> cells;
  const CellText surplus = split(*read.card, read.format, read.text, cells);
  const bool is_free_form = is_free(*read.card, read.format, read.text);
  const bool is_surplus = surplus.text.find_first_not_of("0., \t") != std::string_view::npos;
  const std::size_t end = read.format == Format::long_format ? 200 : 80;
  const bool is_long = !is_free_form && !trimmed(columns(read.text, end, read.text.size())).empty();
  const bool keep = read.is_doubtful || !faults.empty() || is_surplus || is_long || has_heading(*read.card);
  std::string out;
  if (read.names_fields) out += names_of(*read.card, read.format) + '\n';
  for (const std::string& parameter : parameters_in(read)) out += parameter + '\n';
  for (const std::string& fault : faults) out += fault + '\n';
  if (is_long) out += fmt::format("{} column {} on is not read: the line stays as it is\n", machine_comment, end + 1);
  if (keep) {
    ++kept_;
    out += read.text;
  } else {
    ++tidied_;
    std::vector<std::string_view> texts;
    for (const CellText& c : cells) texts.push_back(c.text);
    if (!is_free_form) add_surplus(*read.card, read.format, read.text, texts);
    out += comma_form(*read.card, read.format, texts);
  }
  edited_.replace(with_comments_above(read.text, read.file, machine_comment), std::move(out));
}

void TidiedText::write(const Findings& findings) {
  std::map<std::pair<std::string, int>, std::vector<std::string>> faults;
  for (const Finding& f : findings.all()) {
    if (f.severity == Severity::note || f.place.line == 0) continue;
    const std::string_view kind = f.severity == Severity::error ? fault_comment : warning_comment;
    std::string text = fmt::format("{}{}{}{}: {}", kind, f.field, f.field.empty() || f.value.empty() ? "" : " = ",
                                   f.field.empty() ? f.keyword : f.value, f.text);
    if (!f.remedy.empty()) text += " [" + f.remedy + "]";
    faults[{f.place.file, f.place.line}].push_back(one_line(std::move(text)));
  }
  for (const ReadLine& read : lines_) {
    const auto found = faults.find({deck_.files[read.file], read.number});
    write_line(read, found == faults.end() ? std::vector<std::string>{} : found->second);
    if (found != faults.end()) faults.erase(found);
  }
  for (const auto& [place, texts] : faults) {
    const auto file = std::ranges::find(deck_.files, place.first);
    if (file == deck_.files.end()) continue;
    const auto f = static_cast<std::size_t>(file - deck_.files.begin());
    const std::string_view line = edited_.line(f, place.second);
    std::string out;
    for (const std::string& text : texts) out += text + '\n';
    edited_.replace(with_comments_above(line, f, {}), out.append(line));
  }
}

}  // namespace nugget::deck
