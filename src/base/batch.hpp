// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__AVX__)
#include <immintrin.h>
#endif

#include <cstring>
#include <type_traits>
#include <utility>

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

/// The compilers' vectors of W numbers and of W truth values.
template <int W, class Number = double>
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
template <>
struct Register<16> {  // two registers: only to convert floats
  typedef double Lanes __attribute__((vector_size(128)));
  typedef long Bits __attribute__((vector_size(128)));
};
template <>
struct Register<4, float> {
  typedef float Lanes __attribute__((vector_size(16)));
  typedef int Bits __attribute__((vector_size(16)));
};
template <>
struct Register<8, float> {
  typedef float Lanes __attribute__((vector_size(32)));
  typedef int Bits __attribute__((vector_size(32)));
};
template <>
struct Register<16, float> {
  typedef float Lanes __attribute__((vector_size(64)));
  typedef int Bits __attribute__((vector_size(64)));
};

/// What a comparison of two batches gives: one truth value a lane (all bits set or none).
template <int W, class Number = double>
struct Mask {
  using Bits = typename Register<W, Number>::Bits;
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
template <class Mask, class Word>
struct OneBitALane {
  Word bits;

  OneBitALane() = default;
  explicit OneBitALane(int b) : bits(static_cast<Word>(b)) {}
  friend Mask operator&&(Mask a, Mask b) { return Mask(a.bits & b.bits); }
  friend Mask operator||(Mask a, Mask b) { return Mask(a.bits | b.bits); }
  friend Mask operator!(Mask a) { return Mask(~a.bits); }
  bool operator[](int l) const { return (bits >> l & 1) != 0; }
};
template <>
struct Mask<8> : OneBitALane<Mask<8>, __mmask8> {
  using OneBitALane::OneBitALane;
};
template <>
struct Mask<16, float> : OneBitALane<Mask<16, float>, __mmask16> {
  using OneBitALane::OneBitALane;
};
#endif

template <int W, class Number>
inline bool any(Mask<W, Number> m) {
  if constexpr (std::is_integral_v<decltype(m.bits)>) {
    return m.bits != 0;
  } else {
#if defined(__AVX__)
    if constexpr (W == 4 && sizeof(Number) == 8) return _mm256_movemask_pd(reinterpret_cast<__m256d>(m.bits)) != 0;
    if constexpr (W == 8 && sizeof(Number) == 4) return _mm256_movemask_ps(reinterpret_cast<__m256>(m.bits)) != 0;
#endif
    long r = 0;
    for (int l = 0; l < W; ++l) r |= m.bits[l];
    return r != 0;
  }
}

/// W real numbers side by side, one for each of W like elements. A thin wrapper over the compilers' vector extension:
/// every operation is lanewise and rounds as the same operation on doubles, or floats, does.
template <int W, class Number = double>
struct Batch {
  using Lanes = typename Register<W, Number>::Lanes;
  using Bits = typename Register<W, Number>::Bits;
  using Mask = nugget::Mask<W, Number>;
  Lanes v;

  Batch() : v{} {}
  Batch(double a) : v(static_cast<Number>(a) - Lanes{}) {}  // implicit: constants of a kernel are doubles
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
  static constexpr bool one_bit_a_lane = sizeof(Lanes) == 64;
#define NUGGET_COMPARE(sign, predicate)                     \
  friend Mask operator sign(Batch a, Batch b) {             \
    if constexpr (one_bit_a_lane && W == 8)                 \
      return Mask(_mm512_cmp_pd_mask(a.v, b.v, predicate)); \
    else if constexpr (one_bit_a_lane)                      \
      return Mask(_mm512_cmp_ps_mask(a.v, b.v, predicate)); \
    else                                                    \
      return Mask(a.v sign b.v);                            \
  }
  NUGGET_COMPARE(>, _CMP_GT_OQ)
  NUGGET_COMPARE(<, _CMP_LT_OQ)
  NUGGET_COMPARE(>=, _CMP_GE_OQ)
  NUGGET_COMPARE(<=, _CMP_LE_OQ)
  friend Batch select(Mask m, Batch yes, Batch no) {
    if constexpr (one_bit_a_lane && W == 8)
      return Batch(Lanes(_mm512_mask_blend_pd(m.bits, no.v, yes.v)));
    else if constexpr (one_bit_a_lane)
      return Batch(Lanes(_mm512_mask_blend_ps(m.bits, no.v, yes.v)));
    else
      return Batch(m.bits ? yes.v : no.v);
  }
#else
  friend Mask operator>(Batch a, Batch b) {
    return Mask(a.v > b.v);
  }
  friend Mask operator<(Batch a, Batch b) {
    return Mask(a.v < b.v);
  }
  friend Mask operator>=(Batch a, Batch b) {
    return Mask(a.v >= b.v);
  }
  friend Mask operator<=(Batch a, Batch b) {
    return Mask(a.v <= b.v);
  }

  friend Batch select(Mask m, Batch yes, Batch no) {
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
    const Bits sign = reinterpret_cast<Bits>(Batch(-0.0).v);
    return Batch(reinterpret_cast<Lanes>(reinterpret_cast<Bits>(a.v) & ~sign));
  }
  friend Batch sqrt(Batch a) {
    [[maybe_unused]] constexpr bool doubles = sizeof(Number) == 8;
#if defined(__AVX__)
    if constexpr (doubles && W == 4)
      return Batch(reinterpret_cast<Lanes>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(a.v))));
    if constexpr (!doubles && W == 8)
      return Batch(reinterpret_cast<Lanes>(_mm256_sqrt_ps(reinterpret_cast<__m256>(a.v))));
#endif
#if defined(__AVX512DQ__)
    // GCC 12 warns of the plain ones.
    if constexpr (doubles && W == 8) return Batch(Lanes(_mm512_maskz_sqrt_pd(0xff, a.v)));
    if constexpr (!doubles && W == 16) return Batch(Lanes(_mm512_maskz_sqrt_ps(0xffff, a.v)));
#endif
    Batch r;
    for (int l = 0; l < W; ++l) r.v[l] = std::sqrt(a.v[l]);
    return r;
  }
};

template <int W, class Number>
inline constexpr int lanes<Batch<W, Number>> = W;
template <int W, class N>
struct NumberOf<Batch<W, N>> {
  using Type = N;
};

template <int W, class Number>
double lane(Batch<W, Number> a, int l) {
  return a.v[l];
}
template <int W, class Number>
void set_lane(Batch<W, Number>& a, int l, double value) {
  a.v[l] = static_cast<Number>(value);
}

template <class R, class Function>
requires(lanes<R> > 1) [[gnu::always_inline]] inline R each_lane(Function&& f) {
  return [&]<int... l>(std::integer_sequence<int, l...>) {
    return R(typename R::Lanes{static_cast<Number<R>>(f(l))...});
  }
  (std::make_integer_sequence<int, lanes<R>>{});
}

template <int W, class Number, class Function>
Batch<W, Number> map(Function&& f, Batch<W, Number> a) {
  Batch<W, Number> r;
  for (int l = 0; l < W; ++l) set_lane(r, l, f(lane(a, l)));
  return r;
}
template <int W, class Number, class Function>
Batch<W, Number> map(Function&& f, Batch<W, Number> a, Batch<W, Number> b) {
  Batch<W, Number> r;
  for (int l = 0; l < W; ++l) set_lane(r, l, f(lane(a, l), lane(b, l)));
  return r;
}

template <class R>
requires(lanes<R> > 1) R real_load(const Number<R>* at) {
  R r;
  std::memcpy(&r.v, at, sizeof r.v);
  return r;
}
template <int W, class Number>
void real_store(Number* at, Batch<W, Number> value) {
  std::memcpy(at, &value.v, sizeof value.v);
}

/// The batch of this machine, of doubles or, with twice as many lanes, of floats.
using NativeBatch = Batch<native_width>;
using SingleBatch = Batch<2 * native_width, float>;
template <class Number>
using NativeBatchOf = std::conditional_t<std::is_same_v<Number, float>, SingleBatch, NativeBatch>;

/// The lanes of a batch of floats as doubles, and back.
template <int W>
void store_as_doubles(double* at, Batch<W, float> value) {
  const auto wide = __builtin_convertvector(value.v, typename Register<W>::Lanes);
  std::memcpy(at, &wide, sizeof wide);
}
/// Adds the lanes of a batch of floats to sums that are doubles.
template <int W>
void add_as_doubles(double* sums, Batch<W, float> more) {
  typename Register<W>::Lanes wide;
  std::memcpy(&wide, sums, sizeof wide);
  wide += __builtin_convertvector(more.v, typename Register<W>::Lanes);
  std::memcpy(sums, &wide, sizeof wide);
}
template <int W>
void add_as_doubles(double* sums, Batch<W> more) {
  real_store(sums, real_load<Batch<W>>(sums) + more);
}
template <int W>
void store_as_doubles(double* at, Batch<W> value) {
  real_store(at, value);
}

}  // namespace nugget
