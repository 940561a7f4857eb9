// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/elementary.hpp"

namespace nugget {

/// What the comparison of two twins gives.
template <class M>
struct TwinMask {
  M a, b;

  [[gnu::always_inline]] friend inline TwinMask operator&&(const TwinMask& x, const TwinMask& y) {
    return {x.a && y.a, x.b && y.b};
  }
  [[gnu::always_inline]] friend inline TwinMask operator||(const TwinMask& x, const TwinMask& y) {
    return {x.a || y.a, x.b || y.b};
  }
  [[gnu::always_inline]] friend inline TwinMask operator!(const TwinMask& x) { return {!x.a, !x.b}; }
  [[gnu::always_inline]] friend inline bool any(const TwinMask& x) { return any(x.a || x.b); }
};

/// Two batches as one real number of a kernel (base/real.hpp), its lanes those of `a` and then those of `b`: a long
/// chain of operations that wait for each other takes hardly more time for two than for one.
template <class R>
struct Twin {
  R a, b;
  using Mask = TwinMask<MaskOf<R>>;

  Twin() = default;
  [[gnu::always_inline]] inline Twin(double number) : a(number), b(number) {}  // implicit, as of a batch
  [[gnu::always_inline]] inline Twin(const R& first, const R& second) : a(first), b(second) {}

#define NUGGET_TWIN(type, sign)                                                           \
  [[gnu::always_inline]] friend inline type operator sign(const Twin& x, const Twin& y) { \
    return {x.a sign y.a, x.b sign y.b};                                                  \
  }
  NUGGET_TWIN(Twin, +)
  NUGGET_TWIN(Twin, -)
  NUGGET_TWIN(Twin, *)
  NUGGET_TWIN(Twin, /)
  NUGGET_TWIN(Mask, >)
  NUGGET_TWIN(Mask, <)
  NUGGET_TWIN(Mask, >=)
  NUGGET_TWIN(Mask, <=)
#undef NUGGET_TWIN
  [[gnu::always_inline]] friend inline Twin operator-(const Twin& x) {
    return {-x.a, -x.b};
  }
  [[gnu::always_inline]] inline Twin& operator+=(const Twin& y) {
    return *this = *this + y;
  }
  [[gnu::always_inline]] inline Twin& operator-=(const Twin& y) {
    return *this = *this - y;
  }
  [[gnu::always_inline]] inline Twin& operator*=(const Twin& y) {
    return *this = *this * y;
  }

  [[gnu::always_inline]] friend inline Twin select(const Mask& m, const Twin& yes, const Twin& no) {
    return {select(m.a, yes.a, no.a), select(m.b, yes.b, no.b)};
  }
  [[gnu::always_inline]] friend inline Twin min(const Twin& x, const Twin& y) {
    return {min(x.a, y.a), min(x.b, y.b)};
  }
  [[gnu::always_inline]] friend inline Twin max(const Twin& x, const Twin& y) {
    return {max(x.a, y.a), max(x.b, y.b)};
  }
  [[gnu::always_inline]] friend inline Twin abs(const Twin& x) {
    return {abs(x.a), abs(x.b)};
  }
  [[gnu::always_inline]] friend inline Twin sqrt(const Twin& x) {
    return {sqrt(x.a), sqrt(x.b)};
  }
  [[gnu::always_inline]] friend inline Twin exponential(const Twin& x) {
    return {exponential(x.a), exponential(x.b)};
  }
  [[gnu::always_inline]] friend inline Twin logarithm(const Twin& x) {
    return {logarithm(x.a), logarithm(x.b)};
  }

  [[gnu::always_inline]] friend inline double lane(const Twin& x, int l) {
    return l < lanes<R> ? lane(x.a, l) : lane(x.b, l - lanes<R>);
  }
};

template <class R>
inline constexpr int lanes<Twin<R>> = 2 * lanes<R>;
template <class R>
struct NumberOf<Twin<R>> {
  using Type = Number<R>;
};
template <class R>
inline constexpr bool is_twin = false;
template <class R>
inline constexpr bool is_twin<Twin<R>> = true;

}  // namespace nugget
