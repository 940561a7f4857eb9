// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

// Small views on card text. A tab, a carriage return and a form feed count as blanks everywhere.
namespace nugget::deck {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}
inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
inline bool is_name_character(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);
/// The columns `from` (counted from 0) to `from + width`, as far as the line has them.
std::string_view columns(std::string_view line, std::size_t from, std::size_t width);

/// ASCII only: deck text has no locale.
std::string upper(std::string_view text);
std::string lower(std::string_view text);

/// Text for people and for JSON: bytes that are not UTF-8 are taken as Latin-1, tabs become blanks.
std::string readable(std::string_view text);

/// A file name behind *INCLUDE in lines of 80 columns, continued by ` +`.
std::string name_lines(std::string name);

}  // namespace nugget::deck
