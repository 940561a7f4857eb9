// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

// What a kernel may do with a real number. A kernel is a template over `R`, which is
//   double      one element (the reference),
//   Batch<W>    W elements side by side in SIMD lanes (base/batch.hpp),
//   Dual<N>     one element and N derivatives (base/dual.hpp).
// It uses + - * /, comparison, && || ! on what a comparison gives, and the functions named here; nothing else. So a
// batch does in every lane exactly what double does, and gives the same bits.
namespace nugget {

using std::abs;
using std::max;
using std::min;
using std::sqrt;

/// Number of elements that one `R` holds.
template <class R>
inline constexpr int lanes = 1;

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

/// Applies a function of doubles lane by lane: for curves, powers and all else that has no SIMD form.
template <class Function>
double map(Function&& f, double a) {
  return f(a);
}
template <class Function>
double map(Function&& f, double a, double b) {
  return f(a, b);
}

/// Loads and stores the `lanes<R>` doubles from `at` on.
template <class R>
R real_load(const double* at);
template <>
inline double real_load<double>(const double* at) {
  return *at;
}
inline void real_store(double* at, double value) {
  *at = value;
}

}  // namespace nugget
