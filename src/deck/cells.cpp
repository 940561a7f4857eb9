// SPDX-License-Identifier: Apache-2.0
#include "deck/cells.hpp"

#include <algorithm>

#include "deck/text.hpp"

namespace nugget::deck {
namespace {

bool is_heading(const Field& field) {
  return field.kind == Kind::text && field.width > 20;
}

CellText cell(std::string_view line, std::size_t from, std::size_t width) {
  const std::string_view whole = columns(line, from, width);
  const std::string_view text = trimmed(whole);
  const std::size_t start = text.empty() ? from : static_cast<std::size_t>(text.data() - line.data());
  return {text, static_cast<int>(start) + 1};
}

CellText split_free(const Card& card, std::string_view line, std::vector<CellText>& cells) {
  std::size_t from = 0;
  for (const Field& field : card.fields) {
    const std::size_t comma = is_heading(field) ? std::string_view::npos : columns(line, from, line.size()).find(',');
    const std::size_t width = comma == std::string_view::npos ? line.size() : comma;
    cells.push_back(cell(line, from, width));
    from = std::min(line.size(), from + width) + 1;
  }
  const CellText rest = cell(line, from, line.size());
  return rest.text.find_first_not_of(", \t") == std::string_view::npos ? CellText{} : rest;
}

}  // namespace

std::size_t width_of(const Field& field, Format format) {
  const auto width = static_cast<std::size_t>(field.width);
  switch (format) {
    case Format::standard: return width;
    case Format::i10: return std::max<std::size_t>(width, 10);
    case Format::long_format: return is_heading(field) ? 2 * width : std::max<std::size_t>(width, 20);
  }
  return width;
}

bool is_free(const Card& card, Format format, std::string_view line) {
  std::size_t before = 0;
  for (const Field& field : card.fields) {
    if (is_heading(field)) return line.substr(0, before).find(',') != std::string_view::npos;
    before += width_of(field, format);
  }
  return line.find(',') != std::string_view::npos;
}

CellText split(const Card& card, Format format, std::string_view line, std::vector<CellText>& cells) {
  cells.clear();
  if (is_free(card, format, line)) return split_free(card, line, cells);
  std::size_t from = 0;
  for (const Field& field : card.fields) {
    const std::size_t width = width_of(field, format);
    cells.push_back(cell(line, from, width));
    from += width;
  }
  const std::size_t end = format == Format::long_format ? 160 : 80;
  return from < end ? cell(line, from, end - from) : CellText{};
}

}  // namespace nugget::deck
