// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "deck/cells.hpp"
#include "deck/impl.hpp"
#include "deck/text.hpp"

namespace nugget::deck {
namespace {

constexpr double largest_integer = std::numeric_limits<int>::max();

std::string number(double v) {
  return fmt::format("{}", v);
}

std::string expected(const Field& field) {
  const auto [low, high] = field.range;
  if (low == high) return fmt::format("only {} is supported", number(low));
  if (low == std::numeric_limits<double>::min()) {
    return std::isinf(high) ? "expected more than 0" : fmt::format("expected more than 0, at most {}", number(high));
  }
  if (std::isinf(high)) return fmt::format("expected {} or more", number(low));
  if (std::isinf(low)) return fmt::format("expected {} or less", number(high));
  return fmt::format("expected {} to {}", number(low), number(high));
}

/// `expected ... (meaning)`; or only the former, where the table does not say what the field means.
std::string with_meaning(const Field& field, std::string_view text) {
  return field.meaning.empty() ? std::string(text) : fmt::format("{} ({})", text, field.meaning);
}

/// What is wrong with a text that should be a number.
struct Fault {
  std::string text;
  std::string remedy;
};

Fault fault_of(const Field& field, std::string_view text, const Value& value) {
  const std::string_view kind = field.kind == Kind::integer ? "a whole number" : "a number";
  if (value.fault == Value::Fault::unknown_parameter) {
    return {fmt::format("the parameter '{}' is not defined before this line", value.parameter),
            "define it with *PARAMETER above this keyword, or correct the name"};
  }
  if (value.fault == Value::Fault::text_parameter) {
    return {with_meaning(field, fmt::format("the parameter '{}' is a text, expected {}", value.parameter, kind)),
            "define it with type R or I"};
  }
  const bool has_letter =
      std::any_of(text.begin(), text.end(), [](char c) { return is_name_character(c) && !is_digit(c); });
  const bool has_digit = std::any_of(text.begin(), text.end(), is_digit);
  if (field.id != IdSpace::none && has_letter && text.front() != '&') {
    return {with_meaning(field, "an alphanumeric id is not supported, expected a whole number"),
            "give it a number for an id"};
  }
  std::string remedy = has_digit ? "keep the number whole inside its columns, or separate the fields by commas"
                                 : "write a number there, or leave the field blank for its default";
  if (text.find('<') != std::string_view::npos || text.find('&') != std::string_view::npos) {
    remedy = "compute the value with *PARAMETER_EXPRESSION and write &name";
  }
  return {with_meaning(field, fmt::format("is not {}", kind)), std::move(remedy)};
}

/// Whether a field's default has a unit that the file of the block has changed; numbers that stand for infinity have
/// none.
bool default_changes_unit(const Field& field, const Block& block) {
  if (block.transform == nullptr || field.kind != Kind::real) return false;
  return field.fallback != 0.0 && std::abs(field.fallback) < 1e15 && block.transform->factor(field.dimension) != 1.0;
}

}  // namespace

// ---- Row

Entry Row::entry(std::string_view name) const {
  for (std::size_t i = 0; i < card_->fields.size(); ++i)
    if (card_->fields[i].name == name) return entry_at(i);
  throw std::logic_error(fmt::format("card of *{} has no field '{}'", keyword_, name));
}

Entry Row::entry_of(std::ptrdiff_t offset) const {
  for (std::size_t i = 0; i < card_->fields.size(); ++i)
    if (card_->fields[i].store != Store::nowhere && card_->fields[i].offset == offset) return entry_at(i);
  throw std::logic_error(fmt::format("card of *{} has no field for the member at {}", keyword_, offset));
}

bool Row::has_field_of(std::ptrdiff_t offset) const {
  return std::any_of(card_->fields.begin(), card_->fields.end(),
                     [&](const Field& f) { return f.store != Store::nowhere && f.offset == offset; });
}

Entry Row::entry_at(std::size_t field) const {
  const Cell& cell = cells_[field];
  Entry entry;
  entry.keyword = keyword();
  entry.field = card_->fields[field].name;
  entry.text = cell.text;
  entry.value = cell.value;
  entry.blank = cell.blank;
  entry.refused = cell.refused;
  entry.place = {place_.file, place_.line, cell.column};
  return entry;
}

void Row::store(std::byte* object) const {
  const auto put = [object](const Field& field, auto number) {
    std::memcpy(object + field.offset, &number, sizeof number);
  };
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Field& field = card_->fields[i];
    switch (field.store) {
      case Store::nowhere: break;
      case Store::real: put(field, cells_[i].value); break;
      case Store::integer: put(field, static_cast<int>(cells_[i].value)); break;
      case Store::flag: put(field, cells_[i].value != 0.0); break;
      case Store::text: *reinterpret_cast<std::string*>(object + field.offset) = cells_[i].text; break;
    }
  }
}

Row::Row() = default;
Row::Row(const Row&) = default;
Row::Row(Row&&) noexcept = default;
Row& Row::operator=(const Row&) = default;
Row& Row::operator=(Row&&) noexcept = default;
Row::~Row() = default;

// ---- Entry

Entry::Entry() = default;
Entry::Entry(const Entry&) = default;
Entry::Entry(Entry&&) noexcept = default;
Entry& Entry::operator=(const Entry&) = default;
Entry& Entry::operator=(Entry&&) noexcept = default;
Entry::~Entry() = default;

void Entry::report(Findings& findings, Severity severity, std::string_view what, std::string_view remedy) const {
  if (!refused)
    findings.add({severity, place, keyword, std::string(field), text, std::string(what), std::string(remedy)});
}

// ---- Cursor

Cursor::Cursor(const Deck& deck, const Block& block, Findings& findings)
    : deck_(deck), block_(block), findings_(findings) {}

bool Cursor::more() const {
  return left() > 0;
}

std::size_t Cursor::left() const {
  std::size_t end = block_.lines.size();
  while (end > next_ && trimmed(block_.lines[end - 1].text).empty()) --end;
  return end - next_;
}

Place Cursor::place() const {
  if (next_ >= block_.lines.size()) return block_.place;
  return {block_.place.file, block_.lines[next_].number, 0};
}

void Cursor::skip() {
  if (next_ < block_.lines.size()) ++next_;
}

std::string Cursor::peek() const {
  if (next_ >= block_.lines.size()) return {};
  return readable(substituted(block_.lines[next_].text, deck_.impl->parameters, block_.scope));
}

std::string Cursor::read_text(std::vector<std::string>* unknown) {
  if (next_ >= block_.lines.size()) return {};
  const std::string_view line = trimmed(block_.lines[next_++].text);
  return readable(substituted(line, deck_.impl->parameters, block_.scope, unknown));
}

double Cursor::peek_number(std::size_t index) const {
  if (next_ >= block_.lines.size()) return 0.0;
  const Card plain{std::vector<Field>(index + 1, Field{})};
  std::vector<CellText> cells;
  split(plain, block_.format, block_.lines[next_].text, cells);
  if (cells[index].text.empty()) return 0.0;
  const Value value = evaluate(cells[index].text, deck_.impl->parameters, block_.scope);
  return value.fault == Value::Fault::none ? value.number : 0.0;
}

Row Cursor::read(const Card& card) {
  Row row;
  read_cells(row, card);
  return row;
}

void Cursor::read_members(Row& row, const Card& card, std::byte* object) {
  read_cells(row, card);
  row.store(object);
}

void Cursor::read_cells(Row& row, const Card& card) {
  row.card_ = &card;
  row.keyword_ = block_.keyword;
  row.place_ = place();
  row.cells_.resize(card.fields.size());
  if (next_ >= block_.lines.size()) {
    fill_missing(row);
    return;
  }
  std::vector<CellText> cells;
  const CellText surplus = split(card, block_.format, block_.lines[next_].text, cells);
  if (deck_.card_read) deck_.card_read(block_, next_, card);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    Row::Cell& cell = row.cells_[i];
    cell.blank = cells[i].text.empty();
    cell.column = cells[i].column;
    cell.text = readable(cells[i].text);
    fill(row, i, cells[i].text);
  }
  // Zeros ask for nothing: decks fill fields with them that other releases have, or none.
  if (surplus.text.find_first_not_of("0., \t") != std::string_view::npos) report_surplus(surplus.text, surplus.column);
  ++next_;
}

void Cursor::fill_missing(Row& row) {
  bool reported = false;
  for (std::size_t i = 0; i < row.cells_.size(); ++i) {
    const Field& field = row.card_->fields[i];
    row.cells_[i].value = std::isnan(field.fallback) ? 0.0 : field.fallback;
    row.cells_[i].refused = std::isnan(field.fallback);
    if (!std::isnan(field.fallback) || reported) continue;
    reported = true;
    findings_.add({Severity::error,
                   block_.place,
                   block_.starred(),
                   std::string(field.name),
                   {},
                   with_meaning(field, fmt::format("must be given, but the keyword ends after {} data line(s)",
                                                   block_.lines.size())),
                   "add the missing card"});
  }
}

void Cursor::fill(Row& row, std::size_t i, std::string_view text) {
  const Field& field = row.card_->fields[i];
  Row::Cell& cell = row.cells_[i];
  if (field.name.empty()) return;
  if (field.kind == Kind::text) {
    fill_text(row, i, text);
    return;
  }
  const bool needed = std::isnan(field.fallback);
  cell.value = needed ? 0.0 : field.fallback;
  const auto report = [&](Fault fault) {
    row.entry_at(i).report(findings_, Severity::error, fault.text, fault.remedy);
    cell.refused = true;
  };
  const auto default_counts = [&] {
    if (needed || !default_changes_unit(field, block_)) return;
    row.entry_at(i).report(findings_, Severity::warning,
                           fmt::format("the default, {:g}, is in the units of the whole deck, not in those of this "
                                       "file ({})",
                                       field.fallback, field.meaning),
                           "write the value in the units of the file");
  };
  if (cell.blank) {
    if (needed) report({with_meaning(field, "must be given"), "write its value there"});
    default_counts();
    return;
  }
  const Value value = evaluate(text, deck_.impl->parameters, block_.scope);
  if (value.fault != Value::Fault::none) {
    report(fault_of(field, text, value));
  } else if (value.number != 0.0 && std::abs(value.number) < std::numeric_limits<double>::min()) {
    report(
        {with_meaning(field, "is closer to 0 than a number of full precision can be"), "write 0, or a larger number"});
  } else if (field.kind == Kind::integer && value.number != std::trunc(value.number)) {
    report({with_meaning(field, "expected a whole number"), {}});
  } else if (field.kind == Kind::integer && std::abs(value.number) > largest_integer) {
    report({with_meaning(field, "expected at most 2147483647"), {}});
  } else if (value.number == 0.0 && field.zero_is_default) {
    if (needed) report({with_meaning(field, "must be given, and 0 is not a value here"), "write its value there"});
    default_counts();
  } else if (!field.range.holds(value.number)) {
    report({with_meaning(field, expected(field)), {}});
  } else if (value.number < 0.0 && field.id != IdSpace::none && field.negative == IdSpace::none &&
             field.range.low == any_value.low) {  // a range of its own says which signs it has
    report({with_meaning(field, "expected an id, which is above 0: a sign means nothing here"), {}});
  } else if (const bool names = value.number < 0.0 && field.negative != IdSpace::none;
             names && value.number != std::trunc(value.number)) {
    report({with_meaning(field, "expected a whole number: below 0 it stands for an id"), {}});
  } else if (names || field.kind == Kind::integer) {
    cell.value = transformed_id(value.number, names ? field.negative : field.id);
    if (std::abs(cell.value) > largest_integer) {
      report({with_meaning(field, "the id with the offset of *INCLUDE_TRANSFORM is more than 2147483647"), {}});
      cell.value = 0.0;
    }
  } else {
    cell.value = block_.transform == nullptr ? value.number : value.number * block_.transform->factor(field.dimension);
  }
}

void Cursor::fill_text(Row& row, std::size_t i, std::string_view text) {
  if (text.find('&') == std::string_view::npos) return;
  Row::Cell& cell = row.cells_[i];
  std::vector<std::string> unknown;
  cell.text = readable(substituted(text, deck_.impl->parameters, block_.scope, &unknown));
  // In a heading an ampersand may be just that ("R&D"); a field that is nothing but `&name` means a parameter.
  if (text.front() == '&' && unknown.size() == 1 && unknown.front().size() + 1 == text.size()) {
    row.entry_at(i).report(findings_, Severity::error,
                           fmt::format("the parameter '{}' is not defined before this line", unknown.front()),
                           "define it with *PARAMETER above this keyword, or correct the name");
  }
}

double Cursor::transformed_id(double id, IdSpace space) const {
  if (block_.transform == nullptr || space == IdSpace::none || id == 0.0) return id;
  const auto offset = static_cast<double>(block_.transform->id_offset[static_cast<std::size_t>(space)]);
  return id > 0.0 ? id + offset : id - offset;
}

void Cursor::report_surplus(std::string_view text, int column) {
  if (surplus_reported_) return;
  surplus_reported_ = true;
  Place p = place();
  p.column = column;
  findings_.warning(std::move(p), block_.starred(),
                    fmt::format("'{}' stands behind the last field of this card and is not read", readable(text)),
                    "remove it; check that the card has its right form");
}

std::vector<int> Cursor::read_ids(IdSpace space, int per_line) {
  Field each = id("id", space, 0.0, "id");
  const Card card{std::vector<Field>(static_cast<std::size_t>(std::max(per_line, 1)), each)};
  std::vector<int> ids;
  while (next_ < block_.lines.size()) {
    const Row row = read(card);
    for (const Row::Cell& cell : row.cells_) {
      if (cell.value != 0.0) ids.push_back(static_cast<int>(cell.value));
    }
  }
  return ids;
}

}  // namespace nugget::deck
