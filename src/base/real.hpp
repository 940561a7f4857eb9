// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

// What a kernel may do with a real number. A kernel is a template over `R`, which is
//   double      one point or element alone (cycles of elements and composed laws are compiled for
//               batches only),
//   Batch<W>    W elements side by side in SIMD lanes (base/batch.hpp),
//   Batch<W, float>   the same in single precision,
//   Dual<N>     one element and N derivatives (base/dual.hpp).
// It uses + - * /, comparison, && || ! on what a comparison gives, and the functions named here; nothing else. So a
// batch does in every lane exactly what double does, and gives the same bits; one of floats has those of any other
// number of lanes.
namespace nugget {

using std::abs;
using std::max;
using std::min;
using std::sqrt;

/// Number of elements that one `R` holds.
template <class R>
inline constexpr int lanes = 1;

/// What one lane of an `R` is kept as in memory: double or float.
template <class R>
struct NumberOf {
  using Type = double;
};
template <class R>
using Number = typename NumberOf<R>::Type;
/// Whether `R` is of single precision: 24 bits, numbers from 1e-38 to 3e38.
template <class R>
inline constexpr bool is_single = std::is_same_v<Number<R>, float>;

/// The result of comparing two `R`.
template <class R>
using MaskOf = decltype(R() < R());

inline bool any(bool mask) {
  return mask;
}
inline double select(bool mask, double yes, double no) {
  return mask ? yes : no;
}

inline double lane(double a, int) {
  return a;
}
inline void set_lane(double& a, int, double value) {
  a = value;
}

/// The `R` of what a function gives for each lane's number: f(0), f(1), ... Put together in registers, which is faster
/// than set_lane() one after the other.
template <class R, class Function>
requires(std::is_same_v<R, double>) double each_lane(Function&& f) {
  return f(0);
}

/// Applies a function of doubles lane by lane: for curves, powers and all else that has no SIMD form.
template <class Function>
double map(Function&& f, double a) {
  return f(a);
}
template <class Function>
double map(Function&& f, double a, double b) {
  return f(a, b);
}

/// Loads and stores the `lanes<R>` numbers from `at` on.
template <class R>
requires(std::is_same_v<R, double>) R real_load(const double* at) {
  return *at;
}
inline void real_store(double* at, double value) {
  *at = value;
}

}  // namespace nugget
