// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include <cstring>

#include "base/real.hpp"

namespace nugget {

/// Lanes of one register of the machine that is built for (NUGGET_ARCH).
#if defined(__AVX512DQ__)
inline constexpr int native_width = 8;
#elif defined(__AVX__)
inline constexpr int native_width = 4;
#else
inline constexpr int native_width = 2;
#endif

/// The compilers' vectors of W doubles and of W truth values.
template <int W>
struct Register;
template <>
struct Register<2> {
  typedef double Lanes __attribute__((vector_size(16)));
  typedef long Bits __attribute__((vector_size(16)));
};
template <>
struct Register<4> {
  typedef double Lanes __attribute__((vector_size(32)));
  typedef long Bits __attribute__((vector_size(32)));
};
template <>
struct Register<8> {
  typedef double Lanes __attribute__((vector_size(64)));
  typedef long Bits __attribute__((vector_size(64)));
};

/// What a comparison of two batches gives: one truth value a lane (all bits set or none).
template <int W>
struct Mask {
  using Bits = typename Register<W>::Bits;
  Bits bits;

  Mask() = default;
  explicit Mask(Bits b) : bits(b) {}
  friend Mask operator&&(Mask a, Mask b) { return Mask(a.bits & b.bits); }
  friend Mask operator||(Mask a, Mask b) { return Mask(a.bits | b.bits); }
  friend Mask operator!(Mask a) { return Mask(~a.bits); }
  bool operator[](int l) const { return bits[l] != 0; }
};

#if defined(__AVX512DQ__)
/// One bit a lane: AVX-512 compares into registers of their own.
template <>
struct Mask<8> {
  __mmask8 bits;

  Mask() = default;
  explicit Mask(int b) : bits(static_cast<__mmask8>(b)) {}
  friend Mask operator&&(Mask a, Mask b) { return Mask(a.bits & b.bits); }
  friend Mask operator||(Mask a, Mask b) { return Mask(a.bits | b.bits); }
  friend Mask operator!(Mask a) { return Mask(~a.bits); }
  bool operator[](int l) const { return (bits >> l & 1) != 0; }
};
inline bool any(Mask<8> m) {
  return m.bits != 0;
}
#endif

template <int W>
inline bool any(Mask<W> m) {
#if defined(__AVX__)
  if constexpr (W == 4) return _mm256_movemask_pd(reinterpret_cast<__m256d>(m.bits)) != 0;
#endif
  long r = 0;
  for (int l = 0; l < W; ++l) r |= m.bits[l];
  return r != 0;
}

/// W real numbers side by side, one for each of W like elements. A thin wrapper over the compilers' vector extension:
/// every operation is lanewise and rounds as the same operation on doubles does.
template <int W>
struct Batch {
  using Lanes = typename Register<W>::Lanes;
  Lanes v;

  Batch() : v{} {}
  Batch(double a) : v(a - Lanes{}) {}  // implicit: constants of a kernel are doubles
  explicit Batch(Lanes a) : v(a) {}
  // Written out so that structs of batches are copied register by register. GCC copies trivial ones in halves, on which
  // the next full load stalls: a quarter of a shell's time.
  Batch(const Batch& a) : v(a.v) {}
  Batch& operator=(const Batch& a) {
    v = a.v;
    return *this;
  }

  friend Batch operator+(Batch a, Batch b) { return Batch(a.v + b.v); }
  friend Batch operator-(Batch a, Batch b) { return Batch(a.v - b.v); }
  friend Batch operator*(Batch a, Batch b) { return Batch(a.v * b.v); }
  friend Batch operator/(Batch a, Batch b) { return Batch(a.v / b.v); }
  friend Batch operator-(Batch a) { return Batch(-a.v); }
  Batch& operator+=(Batch b) { return *this = *this + b; }
  Batch& operator-=(Batch b) { return *this = *this - b; }
  Batch& operator*=(Batch b) { return *this = *this * b; }
#if defined(__AVX512DQ__)
#define NUGGET_COMPARE(sign, predicate)                        \
  friend Mask<W> operator sign(Batch a, Batch b) {             \
    if constexpr (W == 8)                                      \
      return Mask<W>(_mm512_cmp_pd_mask(a.v, b.v, predicate)); \
    else                                                       \
      return Mask<W>(a.v sign b.v);                            \
  }
  NUGGET_COMPARE(>, _CMP_GT_OQ)
  NUGGET_COMPARE(<, _CMP_LT_OQ)
  NUGGET_COMPARE(>=, _CMP_GE_OQ)
  NUGGET_COMPARE(<=, _CMP_LE_OQ)
  friend Batch select(Mask<W> m, Batch yes, Batch no) {
    if constexpr (W == 8)
      return Batch(Lanes(_mm512_mask_blend_pd(m.bits, no.v, yes.v)));
    else
      return Batch(m.bits ? yes.v : no.v);
  }
#else
  friend Mask<W> operator>(Batch a, Batch b) {
    return Mask<W>(a.v > b.v);
  }
  friend Mask<W> operator<(Batch a, Batch b) {
    return Mask<W>(a.v < b.v);
  }
  friend Mask<W> operator>=(Batch a, Batch b) {
    return Mask<W>(a.v >= b.v);
  }
  friend Mask<W> operator<=(Batch a, Batch b) {
    return Mask<W>(a.v <= b.v);
  }

  friend Batch select(Mask<W> m, Batch yes, Batch no) {
    return Batch(m.bits ? yes.v : no.v);
  }
#endif
  friend Batch min(Batch a, Batch b) {
    return select(b < a, b, a);
  }
  friend Batch max(Batch a, Batch b) {
    return select(a < b, b, a);
  }
  friend Batch abs(Batch a) {
    using Bits = typename Register<W>::Bits;
    const Bits sign = reinterpret_cast<Bits>(Batch(-0.0).v);
    return Batch(reinterpret_cast<Lanes>(reinterpret_cast<Bits>(a.v) & ~sign));
  }
  friend Batch sqrt(Batch a) {
#if defined(__AVX__)
    if constexpr (W == 4) return Batch(reinterpret_cast<Lanes>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.v))));
#endif
#if defined(__AVX512DQ__)
    if constexpr (W == 8) return Batch(Lanes(_mm512_maskz_sqrt_pd(0xff, a.v)));  // GCC 12 warns of the plain one
#endif
    Batch r;
    for (int l = 0; l < W; ++l) r.v[l] = std::sqrt(a.v[l]);
    return r;
  }
};

template <int W>
inline constexpr int lanes<Batch<W>> = W;

template <int W>
double lane(Batch<W> a, int l) {
  return a.v[l];
}
template <int W>
void set_lane(Batch<W>& a, int l, double value) {
  a.v[l] = value;
}

template <int W, class Function>
Batch<W> map(Function&& f, Batch<W> a) {
  Batch<W> r;
  for (int l = 0; l < W; ++l) r.v[l] = f(a.v[l]);
  return r;
}
template <int W, class Function>
Batch<W> map(Function&& f, Batch<W> a, Batch<W> b) {
  Batch<W> r;
  for (int l = 0; l < W; ++l) r.v[l] = f(a.v[l], b.v[l]);
  return r;
}

template <class R>
requires(lanes<R> > 1) R real_load(const double* at) {
  R r;
  std::memcpy(&r.v, at, sizeof r.v);
  return r;
}
template <int W>
void real_store(double* at, Batch<W> value) {
  std::memcpy(at, &value.v, sizeof value.v);
}

/// The batch of this machine.
using NativeBatch = Batch<native_width>;

}  // namespace nugget
