// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <type_traits>

#include "base/batch.hpp"
#include "base/twin.hpp"

namespace nugget {

/// Four numbers of each lane, which stand side by side from `row(lane)` on: column c has number c of every lane.
template <class R>
using Columns = std::array<R, 4>;

template <class R, class RowOf>
requires(!is_twin<R>) [[gnu::always_inline]] inline Columns<R> columns(const RowOf& row) {
#if defined(__AVX512DQ__)
  if constexpr (std::is_same_v<R, Batch<8>>) {
    const Columns<Batch<4>> low = columns<Batch<4>>(row), high = columns<Batch<4>>([&](int l) { return row(l + 4); });
    const auto joined = [&](std::size_t c) {
      return R(__builtin_shufflevector(low[c].v, high[c].v, 0, 1, 2, 3, 4, 5, 6, 7));
    };
    return {joined(0), joined(1), joined(2), joined(3)};
  }
#endif
#if defined(__AVX__)
  if constexpr (std::is_same_v<R, Batch<4>>) {
    const __m256d r0 = _mm256_loadu_pd(row(0)), r1 = _mm256_loadu_pd(row(1)), r2 = _mm256_loadu_pd(row(2)),
                  r3 = _mm256_loadu_pd(row(3));
    const __m256d even01 = _mm256_unpacklo_pd(r0, r1), odd01 = _mm256_unpackhi_pd(r0, r1),
                  even23 = _mm256_unpacklo_pd(r2, r3), odd23 = _mm256_unpackhi_pd(r2, r3);
    const auto batch = [](const __m256d& v) { return R(reinterpret_cast<typename R::Lanes>(v)); };
    return {batch(_mm256_permute2f128_pd(even01, even23, 0x20)), batch(_mm256_permute2f128_pd(odd01, odd23, 0x20)),
            batch(_mm256_permute2f128_pd(even01, even23, 0x31)), batch(_mm256_permute2f128_pd(odd01, odd23, 0x31))};
  }
#endif
  const auto column = [&](int c) { return each_lane<R>([&](int l) { return row(l)[c]; }); };
  return {column(0), column(1), column(2), column(3)};
}

template <class T, class RowOf>
requires(is_twin<T>) [[gnu::always_inline]] inline Columns<T> columns(const RowOf& row) {
  using R = decltype(T::a);
  const Columns<R> a = columns<R>(row), b = columns<R>([&](int l) { return row(l + lanes<R>); });
  return {T(a[0], b[0]), T(a[1], b[1]), T(a[2], b[2]), T(a[3], b[3])};
}

}  // namespace nugget
