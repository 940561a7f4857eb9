// SPDX-License-Identifier: Apache-2.0
#include "deck/card_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "deck/cells.hpp"

namespace nugget::deck {
namespace {

constexpr double bearable_loss = 1e-5, hardly_a_loss = 1e-6;

/// `1.5e-05` as `1.5e-5`.
std::string shortened(std::string text) {
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const std::size_t digits = text.find_first_of("123456789", e);
  const std::string sign = text[e + 1] == '-' ? "-" : "";
  return text.substr(0, e + 1) + sign + text.substr(digits);
}

/// Where the cell of a field begins in a line that is separated by commas, and how long it is; behind the line's end
/// where it has fewer.
std::pair<std::size_t, std::size_t> separated_cell(std::string_view line, std::size_t field) {
  std::size_t from = 0;
  for (std::size_t i = 0; i < field; ++i) {
    const std::size_t comma = line.find(',', from);
    if (comma == std::string_view::npos) return {line.size() + field - i, 0};
    from = comma + 1;
  }
  return {from, std::min(line.find(',', from), line.size()) - from};
}

/// A real with as many digits as `width` columns hold; empty where it loses more than a share `loss`.
std::string fitted_real(double value, std::size_t width, double loss) {
  std::string text = shortened(fmt::format("{}", value));
  if (text.find_first_of(".e") == std::string::npos && (width == 0 || text.size() + 2 <= width)) text += ".0";
  for (int digits = 17; width > 0 && text.size() > width && digits > 0; --digits)
    text = shortened(fmt::format("{:.{}g}", value, digits));
  const bool fits = width == 0 || text.size() <= width;
  return fits && std::abs(std::strtod(text.c_str(), nullptr) - value) <= loss * std::abs(value) ? text : std::string();
}

}  // namespace

std::string fitted(double value, Kind kind, std::size_t width) {
  if (!std::isfinite(value)) return {};
  if (kind == Kind::integer) {
    const std::string text = value == std::trunc(value) ? fmt::format("{:.0f}", value) : std::string();
    return width > 0 && text.size() > width ? std::string() : text;
  }
  // A blank before it keeps it apart from its neighbour, where that costs nothing that matters.
  std::string text = width > 1 ? fitted_real(value, width - 1, hardly_a_loss) : std::string();
  return text.empty() ? fitted_real(value, width, bearable_loss) : text;
}

std::string filled_cell(std::string_view text, std::size_t width, Kind kind) {
  if (width == 0 && text.find(',') != std::string_view::npos)
    throw std::invalid_argument(fmt::format("'{}' has a comma, which separates the fields of this line", text));
  if (width == 0) return std::string(text);
  if (text.size() > width)
    throw std::invalid_argument(
        fmt::format("'{}' has {} characters, and the field {} columns", text, text.size(), width));
  return kind == Kind::text ? fmt::format("{:<{}}", text, width) : fmt::format("{:>{}}", text, width);
}

std::string with_cell(const Card& card, Format format, std::string_view line, std::size_t field,
                      std::string_view text) {
  const Kind kind = card.fields[field].kind;
  if (is_free(card, format, line)) {
    const auto [from, size] = separated_cell(line, field);
    std::string out(line);
    if (from > out.size()) out.append(from - out.size(), ',');
    return out.replace(from, size, filled_cell(text, 0, kind));
  }
  std::size_t from = 0;
  for (std::size_t i = 0; i < field; ++i) from += width_of(card.fields[i], format);
  const std::size_t width = width_of(card.fields[field], format);
  std::string out(line);
  if (out.size() < from) out.resize(from, ' ');
  return out.replace(from, std::min(width, out.size() - from), filled_cell(text, width, kind));
}

}  // namespace nugget::deck
