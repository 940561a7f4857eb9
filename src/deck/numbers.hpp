// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

// Numbers as they stand in cards. A text is consumed whole or it is not a number.
namespace nugget::deck {

/// `1`, `1.`, `.5`, `1e-3`, `1.d-3`, `1-3` (= 1e-3, Fortran's short exponent), `+1`; no blanks, no inf, no nan, nothing
/// that overflows a double.
bool parse_real(std::string_view text, double& value);

enum class WholeNumber { good, not_a_number, not_whole, too_large };
/// An integer, also when written as a real with nothing behind the point (`1.0`); within +-(2^31 - 1).
WholeNumber parse_integer(std::string_view text, int& value);

/// Eight columns of a bulk table: blanks, then digits to the last column (all blank: 0). False for any other text,
/// which is then read by the careful path. All eight bytes at once (D. Lemire's SWAR conversion).
inline bool parse_plain_integer8(const char* p, int& value) {
  constexpr std::uint64_t ones = 0x0101010101010101u;
  std::uint64_t v;
  std::memcpy(&v, p, 8);
  const std::uint64_t offset = v ^ (0x20 * ones);  // a blank is 0, a digit 0x10 to 0x19
  if (offset == 0) {
    value = 0;
    return true;
  }
  const int blanks = __builtin_ctzll(offset) & ~7;  // in bits
  const std::uint64_t number = (0x10 * ones) << blanks;
  if ((offset & (0xF0 * ones)) != number || ((offset + 0x06 * ones) & (0xF0 * ones)) != number) return false;
  v = offset & (0x0F * ones);
  v = v * 10 + (v >> 8);
  v = ((v & 0x000000FF000000FFu) * 0x000F424000000064u + ((v >> 16) & 0x000000FF000000FFu) * 0x0000271000000001u) >> 32;
  value = static_cast<int>(v);
  return true;
}

/// The same for a cell of any width; a sign may stand before the digits.
bool parse_plain_integer(const char* p, std::size_t width, int& value);

/// A real in a cell: blanks before and behind are skipped; a blank cell is 0. False where the careful path has to look.
bool parse_plain_real(const char* p, std::size_t width, double& value);

}  // namespace nugget::deck
