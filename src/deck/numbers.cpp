// SPDX-License-Identifier: Apache-2.0
#include "deck/numbers.hpp"

#include <fast_float/fast_float.h>

#include <array>
#include <cmath>
#include <limits>

#include "deck/text.hpp"

namespace nugget::deck {
namespace {

/// fast_float knows `inf` and `nan`; a deck does not.
bool starts_as_number(const char* first, const char* last) {
  if (first < last && *first == '-') ++first;
  return first < last && (is_digit(*first) || *first == '.');
}

bool parse_whole(const char* first, const char* last, double& value) {
  if (!starts_as_number(first, last)) return false;
  const auto [end, error] = fast_float::from_chars(first, last, value);
  return error == std::errc() && end == last && std::isfinite(value);
}

}  // namespace

bool parse_real(std::string_view text, double& value) {
  if (parse_whole(text.data(), text.data() + text.size(), value)) return true;
  // Fortran's spellings: a leading plus, d for e, an exponent without its letter.
  std::array<char, 72> plain;
  if (text.empty() || text.size() > plain.size() - 1) return false;
  if (text.front() == '+') {
    text.remove_prefix(1);
    if (text.empty() || text.front() == '-') return false;
  }
  std::size_t n = 0;
  bool exponent = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == 'd' || c == 'D') c = 'e';
    if (c == 'e' || c == 'E') exponent = true;
    if ((c == '+' || c == '-') && i > 0 && !exponent) {
      plain[n++] = 'e';
      exponent = true;
    }
    plain[n++] = c;
  }
  return parse_whole(plain.data(), plain.data() + n, value);
}

WholeNumber parse_integer(std::string_view text, int& value) {
  double real = 0.0;
  if (!parse_real(text, real)) return WholeNumber::not_a_number;
  if (std::abs(real) > std::numeric_limits<int>::max()) return WholeNumber::too_large;
  if (real != std::trunc(real)) return WholeNumber::not_whole;
  value = static_cast<int>(real);
  return WholeNumber::good;
}

bool parse_plain_integer(const char* p, std::size_t width, int& value) {
  const char* const end = p + width;
  value = 0;
  while (p < end && *p == ' ') ++p;
  if (p == end) return true;
  const bool negative = *p == '-';
  if (negative) ++p;
  if (p == end || end - p > 10) return false;
  std::int64_t number = 0;
  for (; p < end; ++p) {
    if (!is_digit(*p)) return false;
    number = 10 * number + (*p - '0');
  }
  if (number > std::numeric_limits<int>::max()) return false;
  value = static_cast<int>(negative ? -number : number);
  return true;
}

bool parse_plain_real(const char* p, std::size_t width, double& value) {
  const char* end = p + width;
  while (p < end && *p == ' ') ++p;
  value = 0.0;
  if (p == end) return true;
  if (!starts_as_number(p, end)) return false;
  const auto [last, error] = fast_float::from_chars(p, end, value);
  if (error != std::errc() || !std::isfinite(value)) return false;
  for (p = last; p < end; ++p) {
    if (*p != ' ') return false;
  }
  return true;
}

}  // namespace nugget::deck
