// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "kernel/law/plastic_return.hpp"
#include "kernel/law/rate_effects.hpp"
#include "kernel/law/yield_curve.hpp"

namespace nugget::kernel {

/// Yield curves over plastic strain at ascending rates, to be interpolated over the rate or its logarithm. The first
/// and last curve hold outside the rates.
///
/// Place x in the table: j at the rate of curve j, straight between j and j + 1 in the stress of a given strain. Below
/// 0 the rate runs in a straight line to 0 at x = -1 (first()), beyond the last curve in a straight line, by `most`
/// in 1.
class RateTable {
 public:
  RateTable() = default;
  /// One curve a rate, at least two of them.
  RateTable(std::vector<YieldCurve> curves, std::vector<double> rates, bool log_rates);

  bool active() const { return !curves_.empty(); }
  /// The least place: that of rate 0.
  double first() const { return stretches_.front().place; }
  double last() const { return stretches_.back().place; }

  /// The rates of a stretch of the table and its curves: rate = start exp(log_span w) + span w at place + w, 0 <= w
  /// <= 1.
  struct Stretch {
    double place;
    double start, span, log_span;
    std::size_t low, high;
  };
  const YieldCurve& curve(std::size_t i) const { return curves_[i]; }
  const Stretch& at(double place) const {
    const double steps = place - first();
    const std::size_t i = steps > 0.0 ? static_cast<std::size_t>(steps) : 0;
    return stretches_[std::min(i, stretches_.size() - 1)];
  }
  /// Where the yield stress after `plastic_strain` is `stress`; first() or last() where it lies outside.
  double place(double plastic_strain, double stress) const;

 private:
  std::vector<YieldCurve> curves_;
  std::vector<Stretch> stretches_;  // the last, beyond the rates, has span 0
};

/// The unknown of a return by a table over the rate: the place in it. `Yield` has plastic_strain() at the start of the
/// step, and may have a limit() that no rate exceeds.
template <class R, class Yield>
class ByTable {
 public:
  static constexpr bool is_increment = false;
  ByTable(Yield& yield, const RateTable& table, double dt) : yield_(yield), table_(table), dt_(dt) {}

  Range<R> range(const R& trial, const R&, const R& most) {
    most_ = most;
    Range<R> r{R(table_.first()), R(table_.last() + 1.0), R(0.0)};
    for (int l = 0; l < lanes<R>; ++l)
      set_lane(r.first, l, table_.place(lane(yield_.plastic_strain(), l), lane(trial, l)));
    return r;
  }

  Trial<R> operator()(const R& x) {
    if (any(x < place_ || x > place_ + 1.0)) step_to(x);
    const R w = x - place_, grown = start_ * exponential(log_span_ * w);
    const R e = grown + span_ * w, e1 = log_span_ * grown + span_, e2 = log_span_ * log_span_ * grown;
    const R strain = yield_.plastic_strain() + e;
    if (any(strain < begin_ || strain >= end_)) fetch(strain);
    const R low = low_y_ + low_slope_ * (strain - low_x_), high = high_y_ + high_slope_ * (strain - high_x_);
    const R slope = low_slope_ + w * (high_slope_ - low_slope_);
    Trial<R> t{e,  low + w * (high - low),
               e1, (high - low) + slope * e1,
               e2, 2.0 * (high_slope_ - low_slope_) * e1 + slope * e2};
    if constexpr (Yield::limited) t = limited(t, yield_.limit());
    return t;
  }

 private:
  R exponential(const R& a) const {
    return any(a > 0.0 || a < 0.0) ? map([](double one) { return std::exp(one); }, a) : R(1.0);
  }
  void step_to(const R& x) {
    for (int l = 0; l < lanes<R>; ++l) {
      const double at = lane(x, l), from = lane(place_, l);
      if (at >= from && at <= from + 1.0) continue;
      const RateTable::Stretch& s = table_.at(at);
      low_[l] = &table_.curve(s.low);
      high_[l] = &table_.curve(s.high);
      set_lane(place_, l, s.place);
      set_lane(start_, l, dt_ * s.start);
      set_lane(span_, l, s.place < table_.last() ? dt_ * s.span : lane(most_, l));
      set_lane(log_span_, l, s.log_span);
      set_lane(end_, l, -1.0);  // has the curves looked up
    }
  }
  void fetch(const R& strain) {
    for (int l = 0; l < lanes<R>; ++l) {
      const double at = lane(strain, l);
      if (at >= lane(begin_, l) && at < lane(end_, l)) continue;
      const YieldCurve::Piece &low = low_[l]->at(at), &high = high_[l]->at(at);
      set_lane(low_x_, l, low.x);
      set_lane(low_y_, l, low.y);
      set_lane(low_slope_, l, low.slope);
      set_lane(high_x_, l, high.x);
      set_lane(high_y_, l, high.y);
      set_lane(high_slope_, l, high.slope);
      set_lane(begin_, l, std::max(low.x, high.x));
      set_lane(end_, l, std::min(low.end, high.end));
    }
  }

  Yield& yield_;
  const RateTable& table_;
  double dt_;
  R most_{};
  R place_{R(-3.0)}, start_{}, span_{}, log_span_{};
  R begin_{}, end_{R(-1.0)}, low_x_{}, low_y_{}, low_slope_{}, high_x_{}, high_y_{}, high_slope_{};
  const YieldCurve *low_[lanes<R>]{}, *high_[lanes<R>]{};
};

}  // namespace nugget::kernel
