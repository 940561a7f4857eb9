// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/elementary.hpp"
#include "base/intervals.hpp"
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
  RateTable(const std::vector<YieldCurve>& curves, const std::vector<double>& rates, bool log_rates);

  bool active() const { return !lines_.empty(); }
  /// The least place: that of rate 0.
  double first() const { return stretches_.front().place; }
  double last() const { return stretches_.back().place; }

  /// The rates of a stretch of the table and its curves: rate = start exp(log_span w) + span w at place + w, 0 <= w
  /// <= 1.
  struct Stretch {
    double place;
    double start, span, log_span;
    double log_start = 0.0;  ///< where log_span is not 0
  };
  const std::vector<Stretch>& stretches() const { return stretches_; }

  /// Plastic strains between which no curve has a corner, and the piece of each curve there.
  struct Row {
    double begin, end;
    const YieldCurve::Piece* lines;
  };
  Row row(double plastic_strain) const {
    const std::size_t i = corners_.at(plastic_strain);
    return {begins_[i], begins_[i + 1], &lines_[i * static_cast<std::size_t>(curves_)]};
  }
  int curves() const { return curves_; }

 private:
  Intervals corners_;           // those of all curves
  std::vector<double> begins_;  // and infinity
  std::vector<YieldCurve::Piece> lines_;
  std::vector<Stretch> stretches_;  // the last, beyond the rates, has span 0
  int curves_ = 0;
};

/// The unknown of a return by a table over the rate: the place in it. `Yield` has plastic_strain() at the start of the
/// step, and may have a limit() that no rate exceeds.
template <class R, class Yield>
class ByTable {
 public:
  static constexpr bool is_increment = false;
  ByTable(Yield& yield, const RateTable& table, double dt) : yield_(yield), table_(table), dt_(dt) {}

  /// The first guess is the lesser of two places that are too high: where the yield stress is that of the trial, and
  /// the rate of what plastic strain there were without a rate effect.
  Range<R> range(const R& trial, const R& start, const R& most) {
    most_ = most;
    find_rows(yield_.plastic_strain());
    const R of_stress = place_of_stress(trial), of_increment = place_of_increment(most * (1.0 - start / trial));
    return {R(table_.first()), R(table_.last() + 1.0), min(of_stress, of_increment)};
  }

  Trial<R> operator()(const R& x) {
    const auto elsewhere = x < place_ || x > place_ + 1.0;
    const bool other_stretch = any(elsewhere);
    if (other_stretch) step_to(x, elsewhere);
    const R w = x - place_, grown = start_ * exponential_of(log_span_ * w);
    const R e = grown + span_ * w, e1 = log_span_ * grown + span_, e2 = log_span_ * log_span_ * grown;
    const R strain = yield_.plastic_strain() + e;
    const bool other_row = any(strain < begin_ || strain >= end_);
    if (other_row) find_rows(strain);
    if (other_stretch || other_row) fetch();
    const R low = low_y_ + low_slope_ * (strain - low_x_), high = high_y_ + high_slope_ * (strain - high_x_);
    const R slope = low_slope_ + w * (high_slope_ - low_slope_);
    Trial<R> t{e,  low + w * (high - low),
               e1, (high - low) + slope * e1,
               e2, 2.0 * (high_slope_ - low_slope_) * e1 + slope * e2};
    if constexpr (Yield::limited) t = limited(t, yield_.limit());
    return t;
  }

 private:
  R exponential_of(const R& a) const { return any(a > 0.0 || a < 0.0) ? exponential(a) : R(1.0); }

  /// Where the yield stress is `stress` after the plastic strain of the rows; first() or last() where it lies outside.
  R place_of_stress(const R& stress) const {
    R low = stress_of(0), place = R(table_.last()), above = R(0.0), span = R(1.0);
    auto found = stress <= low;
    place = select(found, R(table_.first()), place);
    for (int i = 1; i < table_.curves(); ++i) {
      const R high = stress_of(i);
      const auto here = stress < high && !found;
      place = select(here, R(i - 1.0), place);
      above = select(here, stress - low, above);
      span = select(here, high - low, span);
      found = found || here;
      low = high;
    }
    return place + above / span;
  }
  R stress_of(int curve) const {
    const R x = each_lane<R>([&](int l) { return lines_[l][curve].x; });
    const R y = each_lane<R>([&](int l) { return lines_[l][curve].y; });
    const R slope = each_lane<R>([&](int l) { return lines_[l][curve].slope; });
    return y + slope * (yield_.plastic_strain() - x);
  }
  /// The place of the rate at which the plastic strain grows by `increment` > 0.
  R place_of_increment(const R& increment) const {
    const R rate = (1.0 / dt_) * increment, log_rate = logarithm(rate);
    R place = R(table_.first());
    for (const RateTable::Stretch& s : table_.stretches()) {
      const auto here = rate >= s.start;
      if (!any(here)) break;
      R w;
      if (s.log_span > 0.0)
        w = (1.0 / s.log_span) * (log_rate - s.log_start);
      else
        w = s.place < table_.last() ? R((1.0 / s.span) * (rate - s.start)) : R((increment - dt_ * s.start) / most_);
      place = select(here, s.place + w, place);
    }
    return place;
  }

  void step_to(const R& x, MaskOf<R> elsewhere) {
    R place = place_;
    for (const RateTable::Stretch& s : table_.stretches()) {
      const auto here = elsewhere && x >= s.place;
      place = select(here, R(s.place), place);
      start_ = select(here, R(dt_ * s.start), start_);
      span_ = select(here, s.place < table_.last() ? R(dt_ * s.span) : most_, span_);
      log_span_ = select(here, R(s.log_span), log_span_);
    }
    place_ = place;
  }
  void find_rows(const R& strain) {
    RateTable::Row rows[lanes<R>];
    for (int l = 0; l < lanes<R>; ++l) {
      rows[l] = table_.row(lane(strain, l));
      lines_[l] = rows[l].lines;
    }
    begin_ = each_lane<R>([&](int l) { return rows[l].begin; });
    end_ = each_lane<R>([&](int l) { return rows[l].end; });
  }
  void fetch() {
    const YieldCurve::Piece *low[lanes<R>], *high[lanes<R>];
    const int last = table_.curves() - 1;
    for (int l = 0; l < lanes<R>; ++l) {
      const int place = static_cast<int>(lane(place_, l));
      low[l] = lines_[l] + std::max(place, 0);
      high[l] = lines_[l] + std::clamp(place + 1, 0, last);
    }
    low_x_ = each_lane<R>([&](int l) { return low[l]->x; });
    low_y_ = each_lane<R>([&](int l) { return low[l]->y; });
    low_slope_ = each_lane<R>([&](int l) { return low[l]->slope; });
    high_x_ = each_lane<R>([&](int l) { return high[l]->x; });
    high_y_ = each_lane<R>([&](int l) { return high[l]->y; });
    high_slope_ = each_lane<R>([&](int l) { return high[l]->slope; });
  }

  Yield& yield_;
  const RateTable& table_;
  double dt_;
  R most_{};
  R place_{R(-3.0)}, start_{}, span_{}, log_span_{};
  R begin_{}, end_{R(-1.0)}, low_x_{}, low_y_{}, low_slope_{}, high_x_{}, high_y_{}, high_slope_{};
  const YieldCurve::Piece* lines_[lanes<R>]{};
};

}  // namespace nugget::kernel
