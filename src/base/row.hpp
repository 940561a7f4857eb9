// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "base/vec3.hpp"

namespace nugget {

/// A nodal vector in memory: one aligned load, half a cache line.
struct alignas(32) Row {
  double x = 0.0, y = 0.0, z = 0.0, pad = 0.0;
};

inline Vec3d vec(const Row& r) {
  return {r.x, r.y, r.z};
}
inline void set(Row& r, const Vec3d& a) {
  r = {a.x, a.y, a.z, 0.0};
}
inline void add(Row& r, const Vec3d& a) {
  r = {r.x + a.x, r.y + a.y, r.z + a.z, 0.0};
}

/// Rows `id[0]`, ..., `id[lanes<R> - 1]` of `base`, one a lane.
template <class R>
Vec3<R> gather(const Row* base, const int* id) {
  Vec3<R> r;
  for (int l = 0; l < lanes<R>; ++l) {
    const Row& row = base[id[l]];
    set_lane(r.x, l, row.x);
    set_lane(r.y, l, row.y);
    set_lane(r.z, l, row.z);
  }
  return r;
}

/// Writes the lanes of `v` to the consecutive rows from `first` on; the pad becomes 0.
template <class R>
void store_rows(Row* first, const Vec3<R>& v) {
  for (int l = 0; l < lanes<R>; ++l) first[l] = {lane(v.x, l), lane(v.y, l), lane(v.z, l), 0.0};
}

/// Writes lane l of `v` to row `id[l]` of `base`; the pad becomes 0.
template <class R>
void scatter(Row* base, const int* id, const Vec3<R>& v) {
  for (int l = 0; l < lanes<R>; ++l) base[id[l]] = {lane(v.x, l), lane(v.y, l), lane(v.z, l), 0.0};
}

#if defined(__AVX__)
namespace detail {
struct FourRows {
  __m256d row[4];
};
inline FourRows transposed(const Vec3<Batch<4>>& v) {
  const auto x = reinterpret_cast<__m256d>(v.x.v), y = reinterpret_cast<__m256d>(v.y.v);
  const auto z = reinterpret_cast<__m256d>(v.z.v), zero = _mm256_setzero_pd();
  const __m256d xy02 = _mm256_unpacklo_pd(x, y), xy13 = _mm256_unpackhi_pd(x, y);
  const __m256d z02 = _mm256_unpacklo_pd(z, zero), z13 = _mm256_unpackhi_pd(z, zero);
  return {{_mm256_permute2f128_pd(xy02, z02, 0x20), _mm256_permute2f128_pd(xy13, z13, 0x20),
           _mm256_permute2f128_pd(xy02, z02, 0x31), _mm256_permute2f128_pd(xy13, z13, 0x31)}};
}
}  // namespace detail

template <>
inline Vec3<Batch<4>> gather<Batch<4>>(const Row* base, const int* id) {
  const auto load = [&](int l) { return _mm256_load_pd(&base[id[l]].x); };
  const __m256d r0 = load(0), r1 = load(1), r2 = load(2), r3 = load(3);
  const __m256d xz01 = _mm256_unpacklo_pd(r0, r1), y01 = _mm256_unpackhi_pd(r0, r1);
  const __m256d xz23 = _mm256_unpacklo_pd(r2, r3), y23 = _mm256_unpackhi_pd(r2, r3);
  using Lanes = Batch<4>::Lanes;
  return {Batch<4>(reinterpret_cast<Lanes>(_mm256_permute2f128_pd(xz01, xz23, 0x20))),
          Batch<4>(reinterpret_cast<Lanes>(_mm256_permute2f128_pd(y01, y23, 0x20))),
          Batch<4>(reinterpret_cast<Lanes>(_mm256_permute2f128_pd(xz01, xz23, 0x31)))};
}

template <>
inline void store_rows<Batch<4>>(Row* first, const Vec3<Batch<4>>& v) {
  const detail::FourRows rows = detail::transposed(v);
  for (int l = 0; l < 4; ++l) _mm256_store_pd(&first[l].x, rows.row[l]);
}

template <>
inline void scatter<Batch<4>>(Row* base, const int* id, const Vec3<Batch<4>>& v) {
  const detail::FourRows rows = detail::transposed(v);
  for (int l = 0; l < 4; ++l) _mm256_store_pd(&base[id[l]].x, rows.row[l]);
}
#endif

#if defined(__AVX512DQ__)
namespace detail {
inline Batch<8> joined(Batch<4> low, Batch<4> high) {
  return Batch<8>(__builtin_shufflevector(low.v, high.v, 0, 1, 2, 3, 4, 5, 6, 7));
}
inline Vec3<Batch<4>> low(const Vec3<Batch<8>>& v) {
  const auto half = [](Batch<8> a) { return Batch<4>(__builtin_shufflevector(a.v, a.v, 0, 1, 2, 3)); };
  return {half(v.x), half(v.y), half(v.z)};
}
inline Vec3<Batch<4>> high(const Vec3<Batch<8>>& v) {
  const auto half = [](Batch<8> a) { return Batch<4>(__builtin_shufflevector(a.v, a.v, 4, 5, 6, 7)); };
  return {half(v.x), half(v.y), half(v.z)};
}
}  // namespace detail

template <>
[[gnu::always_inline]] inline Vec3<Batch<8>> gather<Batch<8>>(const Row* base, const int* id) {
  const Vec3<Batch<4>> a = gather<Batch<4>>(base, id), b = gather<Batch<4>>(base, id + 4);
  return {detail::joined(a.x, b.x), detail::joined(a.y, b.y), detail::joined(a.z, b.z)};
}
template <>
[[gnu::always_inline]] inline void store_rows<Batch<8>>(Row* first, const Vec3<Batch<8>>& v) {
  store_rows(first, detail::low(v));
  store_rows(first + 4, detail::high(v));
}
template <>
[[gnu::always_inline]] inline void scatter<Batch<8>>(Row* base, const int* id, const Vec3<Batch<8>>& v) {
  scatter(base, id, detail::low(v));
  scatter(base, id + 4, detail::high(v));
}
#endif

}  // namespace nugget
