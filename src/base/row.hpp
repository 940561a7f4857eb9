// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstring>
#include <new>
#include <vector>

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

/// Memory aligned for vector registers and lines of the cache.
template <class T>
struct Aligned {
  using value_type = T;
  Aligned() = default;
  template <class U>
  Aligned(const Aligned<U>&) {}
  T* allocate(std::size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
  void deallocate(T* p, std::size_t) { ::operator delete (p, std::align_val_t{64}); }
  friend bool operator==(const Aligned&, const Aligned&) { return true; }
};

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

#if defined(__AVX__)
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

#endif

#if defined(__AVX512DQ__)
namespace detail {
inline Batch<8> joined(Batch<4> low, Batch<4> high) {
  return Batch<8>(__builtin_shufflevector(low.v, high.v, 0, 1, 2, 3, 4, 5, 6, 7));
}
}  // namespace detail

template <>
[[gnu::always_inline]] inline Vec3<Batch<8>> gather<Batch<8>>(const Row* base, const int* id) {
  const Vec3<Batch<4>> a = gather<Batch<4>>(base, id), b = gather<Batch<4>>(base, id + 4);
  return {detail::joined(a.x, b.x), detail::joined(a.y, b.y), detail::joined(a.z, b.z)};
}
#endif

/// A row as one register of four doubles.
using FourReals = Register<4>::Lanes;
inline FourReals four(const Row& r) {
  FourReals v;
  std::memcpy(&v, &r, sizeof v);
  return v;
}
inline void set(Row& r, const FourReals& v) {
  std::memcpy(static_cast<void*>(&r), &v, sizeof v);
}

// ---- single precision

/// Rows `id[0]`, ... of `base` less rows `from[0]`, ..., one a lane; of floats the differences of doubles are rounded.
template <class R>
[[gnu::always_inline]] inline Vec3<R> gather_differences(const Row* base, const int* id, const int* from) {
  Vec3<R> r;
  for (int l = 0; l < lanes<R>; ++l) {
    const Vec3d d = vec(base[id[l]]) - vec(base[from[l]]);
    set_lane(r.x, l, d.x);
    set_lane(r.y, l, d.y);
    set_lane(r.z, l, d.z);
  }
  return r;
}

#if defined(__AVX__)
namespace detail {
/// Four rows of four numbers become four columns.
[[gnu::always_inline]] inline void transpose(__m128& a, __m128& b, __m128& c, __m128& d) {
  const __m128 ab = _mm_unpacklo_ps(a, b), cd = _mm_unpacklo_ps(c, d), ab_high = _mm_unpackhi_ps(a, b),
               cd_high = _mm_unpackhi_ps(c, d);
  a = _mm_movelh_ps(ab, cd);
  b = _mm_movehl_ps(cd, ab);
  c = _mm_movelh_ps(ab_high, cd_high);
  d = _mm_movehl_ps(cd_high, ab_high);
}
template <int W>
struct Quads {
  __m128 of[W / 4];
};
[[gnu::always_inline]] inline Batch<8, float> joined(const Quads<8>& q) {
  return Batch<8, float>(reinterpret_cast<Batch<8, float>::Lanes>(_mm256_set_m128(q.of[1], q.of[0])));
}
#if defined(__AVX512DQ__)
[[gnu::always_inline]] inline Batch<16, float> joined(const Quads<16>& q) {
  const Batch<8, float> low = joined(Quads<8>{q.of[0], q.of[1]}), high = joined(Quads<8>{q.of[2], q.of[3]});
  return Batch<16, float>(__builtin_shufflevector(low.v, high.v, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
}
#endif
/// `row(l)` gives what stands in lane l: x y z and one more.
template <int W, class RowOf>
[[gnu::always_inline]] inline Vec3<Batch<W, float>> columns_of(const RowOf& row) {
  Quads<W> x, y, z;
  for (int i = 0; i < W / 4; ++i) {
    __m128 a = row(4 * i), b = row(4 * i + 1), c = row(4 * i + 2), d = row(4 * i + 3);
    transpose(a, b, c, d);
    x.of[i] = a;
    y.of[i] = b;
    z.of[i] = c;
  }
  return {joined(x), joined(y), joined(z)};
}
}  // namespace detail
#endif

/// Rows `id[0]`, ... of `base`, one a lane, rounded.
template <int W>
[[gnu::always_inline]] inline Vec3<Batch<W, float>> gather_single(const Row* base, const int* id) {
#if defined(__AVX__)
  return detail::columns_of<W>([&](int l) { return _mm256_cvtpd_ps(_mm256_load_pd(&base[id[l]].x)); });
#else
  return gather<Batch<W, float>>(base, id);
#endif
}
#if defined(__AVX__)
template <>
[[gnu::always_inline]] inline Vec3<SingleBatch> gather_differences<SingleBatch>(const Row* base, const int* id,
                                                                                const int* from) {
  return detail::columns_of<lanes<SingleBatch>>([&](int l) {
    return _mm256_cvtpd_ps(_mm256_sub_pd(_mm256_load_pd(&base[id[l]].x), _mm256_load_pd(&base[from[l]].x)));
  });
}
#endif

}  // namespace nugget
