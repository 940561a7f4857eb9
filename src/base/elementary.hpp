// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>

#include "base/batch.hpp"

// Exponential, logarithm and power. Those of the C library take one number at a time, and vector libraries give other
// bits with other numbers of lanes: these are made of + - * / and of the numbers' own bits, the same in each lane.
namespace nugget {

/// How the bits of a number are read: mantissa bits, and 1.5 times two to their number, to which a whole number is
/// added to have it in the lowest bits.
template <class Number>
struct NumberFormat;
template <>
struct NumberFormat<double> {
  using Word = std::int64_t;
  static constexpr int mantissa = 52;
  static constexpr double magic = 6755399441055744.0;
  static constexpr double most = 708.0, least_normal = 2.3e-308;
};
template <>
struct NumberFormat<float> {
  using Word = std::int32_t;
  static constexpr int mantissa = 23;
  static constexpr double magic = 12582912.0;
  static constexpr double most = 87.0, least_normal = 1.2e-38;
};

/// The bits of an `R` as whole numbers, one a lane, and back.
inline std::int64_t bits_of(double a) {
  return std::bit_cast<std::int64_t>(a);
}
inline double of_bits(double, std::int64_t bits) {
  return std::bit_cast<double>(bits);
}
template <int W, class N>
auto bits_of(Batch<W, N> a) {
  return reinterpret_cast<typename Batch<W, N>::Bits>(a.v);
}
template <int W, class N>
Batch<W, N> of_bits(Batch<W, N>, typename Batch<W, N>::Bits bits) {
  return Batch<W, N>(reinterpret_cast<typename Batch<W, N>::Lanes>(bits));
}

/// e to the power of `a`, to 2 in the last place; of what lies beyond the range of numbers, the end of that range.
/// Exactly 1 of 0. Cody and Waite's reduction to |r| <= ln 2 / 2, Taylor's series there.
template <class R>
[[gnu::always_inline]] inline R exponential(const R& a) {
  using Format = NumberFormat<Number<R>>;
  const R within = max(min(a, R(Format::most)), R(-Format::most));
  const R shifted = within * 1.4426950408889634 + Format::magic, twos = shifted - Format::magic;
  // ln 2 in two parts, the first with so few bits that its product is exact.
  constexpr double high = is_single<R> ? 0.693359375 : 6.93147180369123816490e-01;
  constexpr double low = is_single<R> ? -2.12194440e-4 : 1.90821492927058770002e-10;
  const R r = (within - twos * high) - twos * low, r2 = r * r, r4 = r2 * r2;
  const R lowest = (1.0 + r) + r2 * (1.0 / 2 + r * (1.0 / 6)),
          middle = (1.0 / 24 + r * (1.0 / 120)) + r2 * (1.0 / 720 + r * (1.0 / 5040));
  R series;
  if constexpr (is_single<R>) {
    series = lowest + r4 * middle;
  } else {
    const R upper = (1.0 / 40320 + r * (1.0 / 362880)) + r2 * (1.0 / 3628800 + r * (1.0 / 39916800)),
            last = 1.0 / 479001600 + r * (1.0 / 6227020800.0);
    series = lowest + r4 * (middle + r4 * (upper + r4 * last));
  }
  return of_bits(series, bits_of(series) + (bits_of(shifted) << Format::mantissa));
}

/// The natural logarithm of `a` > 0, to 2 in the last place or 3e-16 (single precision: 1e-7) where it is near 0; of
/// what is less than any normal number, that of the least one. 2 artanh((m - 1) / (m + 1)) of the mantissa m, as a
/// series.
template <class R>
[[gnu::always_inline]] inline R logarithm(const R& a) {
  using Format = NumberFormat<Number<R>>;
  using Word = typename Format::Word;
  constexpr Word mantissa_bits = (Word(1) << Format::mantissa) - 1;
  const R normal = max(a, R(Format::least_normal));
  // The exponent is that of a sqrt(2), so that the mantissa lies between 0.7 and 1.4.
  constexpr Word half = std::bit_cast<Word>(static_cast<Number<R>>(0.70710678118654752));
  const auto above = bits_of(normal) - half;
  const auto exponent = above >> Format::mantissa;
  const R m = of_bits(normal, (above & mantissa_bits) + half);
  const R twos = of_bits(normal, exponent + bits_of(R(Format::magic))) - Format::magic;
  const R s = (m - 1.0) / (m + 1.0), z = s * s, z2 = z * z, z4 = z2 * z2;
  R series = (1.0 / 3 + z * (1.0 / 5)) + z2 * (1.0 / 7 + z * (1.0 / 9));
  if constexpr (!is_single<R>)
    series += z4 * ((1.0 / 11 + z * (1.0 / 13)) + z2 * (1.0 / 15 + z * (1.0 / 17)) + z4 * (1.0 / 19 + z * (1.0 / 21)));
  constexpr double high = is_single<R> ? 0.693359375 : 6.93147180369123816490e-01;
  constexpr double low = is_single<R> ? -2.12194440e-4 : 1.90821492927058770002e-10;
  return twos * high + (2.0 * s + (2.0 * s * (z * series) + twos * low));
}

/// `a` >= 0 to the power of `p` != 0: of whole numbers from 1 to 32 by products. 0 of 0 where p > 0.
template <class R>
[[gnu::always_inline]] inline R power(const R& a, double p) {
  const int whole = p >= 1.0 && p <= 32.0 ? static_cast<int>(p) : 0;
  if (whole != p) return select(a > 0.0, exponential(p * logarithm(a)), R(0.0));
  R square = a, product = R(1.0);
  for (int n = whole;; square = square * square) {
    if (n % 2 == 1) product = product * square;
    n /= 2;
    if (n == 0) return product;
  }
}

}  // namespace nugget
