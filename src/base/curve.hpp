// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace nugget {

/// A piecewise linear function y(x), abscissae ascending. Scale factors and offsets of the deck are already applied.
/// How it goes on outside its range depends on what it is used for, so the caller says it by the function it calls.
struct Curve {
  int id = 0;
  std::vector<double> x, y;
  bool in_run = true, in_relaxation = false;  ///< SIDR: the phases in which loads and motions follow the curve

  bool empty() const { return x.empty(); }

  /// End values hold outside the range (scale factors over rate, size, ...).
  double clamped(double at) const {
    if (at <= x.front()) return y.front();
    if (at >= x.back()) return y.back();
    return inside(at);
  }
  /// Zero outside the range (loads and motions over time).
  double zero_outside(double at) const { return at < x.front() || at > x.back() ? 0.0 : inside(at); }
  /// The last slope goes on beyond the end; the first ordinate holds before the start (stress over plastic strain).
  double extrapolated(double at) const {
    if (at <= x.front()) return y.front();
    return inside(at);
  }
  /// Slope of the segment that holds `at` (of the last one beyond the end, of the first before the start).
  double slope(double at) const {
    if (x.size() < 2) return 0.0;
    const std::size_t i = segment(at);
    return (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  }

 private:
  std::size_t segment(double at) const {
    const auto i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin());
    return std::clamp<std::size_t>(i, 1, x.size() - 1) - 1;
  }
  double inside(double at) const {
    if (x.size() < 2) return y.front();
    const std::size_t i = segment(at);
    return y[i] + (at - x[i]) * (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  }
};

/// A table with its curves, linear between its values; all ends hold.
struct CurveTable {
  int id = 0;
  std::vector<double> value;  ///< ascending, one per curve; of a single curve 0
  std::vector<Curve> curve;   ///< empty: not given

  bool given() const { return !curve.empty(); }
  double at(double v, double x) const {
    const auto upper = static_cast<std::size_t>(std::upper_bound(value.begin(), value.end(), v) - value.begin());
    if (upper == 0) return curve.front().clamped(x);
    const double below = curve[upper - 1].clamped(x);
    if (upper == value.size()) return below;
    const double share = (v - value[upper - 1]) / (value[upper] - value[upper - 1]);
    return below + share * (curve[upper].clamped(x) - below);
  }
};

}  // namespace nugget
