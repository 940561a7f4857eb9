// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/real.hpp"

namespace nugget {

/// A value and its derivatives with respect to N variables (forward differentiation): K is the derivative of the force
/// kernel. State arrays hold values only: a load has zero derivatives, a store drops them.
template <int N>
struct Dual {
  double value = 0.0;
  std::array<double, N> d{};

  Dual() = default;
  Dual(double a) : value(a) {}  // implicit: constants of a kernel are doubles
  /// The i-th variable, with value `a`.
  static Dual variable(double a, int i) {
    Dual r(a);
    r.d[i] = 1.0;
    return r;
  }

  friend Dual operator+(const Dual& a, const Dual& b) { return chain(a.value + b.value, a, 1.0, b, 1.0); }
  friend Dual operator-(const Dual& a, const Dual& b) { return chain(a.value - b.value, a, 1.0, b, -1.0); }
  friend Dual operator*(const Dual& a, const Dual& b) { return chain(a.value * b.value, a, b.value, b, a.value); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double q = a.value / b.value;
    return chain(q, a, 1.0 / b.value, b, -q / b.value);
  }
  friend Dual operator-(const Dual& a) { return chain(-a.value, a, -1.0, a, 0.0); }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }

  friend Dual select(bool mask, const Dual& yes, const Dual& no) { return mask ? yes : no; }
  friend Dual min(const Dual& a, const Dual& b) { return b < a ? b : a; }
  friend Dual max(const Dual& a, const Dual& b) { return a < b ? b : a; }
  friend Dual abs(const Dual& a) { return a.value < 0.0 ? -a : a; }
  friend Dual sqrt(const Dual& a) {
    const double s = std::sqrt(a.value);
    return chain(s, a, s > 0.0 ? 0.5 / s : 0.0, a, 0.0);
  }

 private:
  static Dual chain(double value, const Dual& a, double da, const Dual& b, double db) {
    Dual r(value);
    for (std::size_t i = 0; i < N; ++i) r.d[i] = da * a.d[i] + db * b.d[i];
    return r;
  }
};

template <class R>
requires requires(R r) {
  r.d;
}
R real_load(const double* at) {
  return R(*at);
}
template <int N>
void real_store(double* at, const Dual<N>& value) {
  *at = value.value;
}

}  // namespace nugget
