// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
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

/// Sixteen columns of a bulk table: blanks, a minus or none, then digits with one point or none to the last column, no
/// exponent. Exactly the double that fast_float gives: a whole number below 2^53 over a power of ten below 10^22
/// (Clinger 1990). False for any other text, also for one that is a number.
inline bool parse_fixed_point16(const char* p, double& value) {
  static_assert(std::endian::native == std::endian::little);
  __extension__ using Bytes16 = unsigned __int128;
  constexpr std::uint64_t ones = 0x0101010101010101u;
  std::uint64_t low, high;
  std::memcpy(&low, p, 8);
  std::memcpy(&high, p + 8, 8);
  low ^= 0x20 * ones;  // a blank is 0, a digit 0x10 to 0x19, a point 0x0E, a minus 0x0D
  high ^= 0x20 * ones;
  if (high == 0) return false;
  const int blanks = low != 0 ? __builtin_ctzll(low) & ~7 : 64 + (__builtin_ctzll(high) & ~7);  // in bits
  Bytes16 v = Bytes16(high) << 64 | low;
  int first = blanks;
  const bool negative = static_cast<unsigned char>(v >> first) == 0x0D;
  if (negative) {
    v ^= Bytes16(0x0D) << first;
    first += 8;
  }
  // The lowest byte that is a point: subtracting 1 from every byte borrows into bit 7 of the first zero byte.
  const auto zero_bytes = [](std::uint64_t x) { return (x - ones) & ~x & (0x80 * ones); };
  const std::uint64_t point_low = zero_bytes(static_cast<std::uint64_t>(v) ^ 0x0E * ones);
  const std::uint64_t point_high = zero_bytes(static_cast<std::uint64_t>(v >> 64) ^ 0x0E * ones);
  int decimals = 0;
  if ((point_low | point_high) != 0) {
    const int point = point_low != 0 ? __builtin_ctzll(point_low) & ~7 : 64 + (__builtin_ctzll(point_high) & ~7);
    const Bytes16 before = v & ((Bytes16(1) << point) - 1);
    const Bytes16 behind = point == 120 ? 0 : v >> (point + 8) << (point + 8);
    v = before << 8 | behind;
    decimals = 15 - point / 8;
    first += 8;
  }
  if (first >= 128) return false;
  const Bytes16 digits = v >> first;
  const auto all_digits = [](std::uint64_t x, std::uint64_t wanted) {
    return (x & (0xF0 * ones)) == wanted && ((x + 0x06 * ones) & (0xF0 * ones)) == wanted;
  };
  const Bytes16 wanted = ((Bytes16(0x10 * ones) << 64) | (0x10 * ones)) >> first;
  if (!all_digits(static_cast<std::uint64_t>(digits), static_cast<std::uint64_t>(wanted)) ||
      !all_digits(static_cast<std::uint64_t>(digits >> 64), static_cast<std::uint64_t>(wanted >> 64))) {
    return false;
  }
  const auto eight = [](std::uint64_t x) {
    x &= 0x0F * ones;
    x = x * 10 + (x >> 8);
    return ((x & 0x000000FF000000FFu) * 0x000F424000000064u +
            ((x >> 16) & 0x000000FF000000FFu) * 0x0000271000000001u) >>
           32;
  };
  const std::uint64_t number =
      100000000u * eight(static_cast<std::uint64_t>(v)) + eight(static_cast<std::uint64_t>(v >> 64));
  if (number >> 53 != 0) return false;
  static constexpr double power[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                     1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  value = static_cast<double>(number) / power[decimals];
  if (negative) value = -value;
  return true;
}

}  // namespace nugget::deck
