// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "base/columns.hpp"
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

  bool active() const { return !cells_.empty(); }
  /// The least place: that of rate 0.
  double first() const { return stretches_.front().place; }
  double last() const { return stretches_.back().place; }

  /// The rates of a stretch of the table: start exp(log_span w) + span w at place + w, 0 <= w <= 1.
  struct Stretch {
    double place;
    double start, span, log_span;
  };
  const std::vector<Stretch>& stretches() const { return stretches_; }
  /// The number of the stretch that begins at place 0.
  int at_first_curve() const { return first() < 0.0 ? 1 : 0; }

  /// Yield stress in one stretch, at plastic strains between which no curve has a corner:
  /// y + rise w + (slope + bend w) (strain - begin).
  struct Cell {
    double y, rise, slope, bend;
  };
  /// Those plastic strains, and the first curve there: y + slope (strain - begin).
  struct Row {
    double begin, end, y, slope;
  };
  std::size_t row_at(double plastic_strain) const { return corners_.at(plastic_strain); }
  const Row& row(std::size_t number) const { return rows_[number]; }
  /// Of a row, one a stretch.
  const Cell* cells(std::size_t row) const { return &cells_[row * stretches_.size()]; }

 private:
  Intervals corners_;  // those of all curves
  std::vector<Row> rows_;
  std::vector<Cell> cells_;
  std::vector<Stretch> stretches_;  // the last, beyond the rates, has span 0
};

/// The rows in which the plastic strains of a batch lie. Nothing before find().
template <class R>
class RateRows {
 public:
  struct Row {
    R begin, end, y, slope;
  };
  Row find(const RateTable& table, const R& strain) {
    std::size_t rows[lanes<R>];
    for (int l = 0; l < lanes<R>; ++l) {
      rows[l] = table.row_at(lane(strain, l));
      cells_[l] = table.cells(rows[l]);
    }
    const Columns<R> c = columns<R>([&](int l) { return &table.row(rows[l]).begin; });
    return {c[0], c[1], c[2], c[3]};
  }
  struct Cells {
    R y, rise, slope, bend;
  };
  /// In the stretches that `stretch` gives for each lane.
  template <class Stretch>
  [[gnu::always_inline]] inline Cells cells(Stretch&& stretch) const {
    const Columns<R> c = columns<R>([&](int l) { return &cells_[l][stretch(l)].y; });
    return {c[0], c[1], c[2], c[3]};
  }

 private:
  const RateTable::Cell* cells_[lanes<R>];
};

/// The unknown of a return by a table over the rate: the place in it. `Yield` has plastic_strain() at the start of the
/// step, the rows() in which that lies and their begin() and end(), and may have a limit() that no rate exceeds.
template <class R, class Yield>
class ByTable {
 public:
  static constexpr bool is_increment = false;
  ByTable(const Yield& yield, const RateTable& table, double dt) : yield_(yield), table_(table), dt_(dt) {}

  /// The first guess solves, with the slopes at the strain p of the start,
  ///   Y(p) + rise w + (modulus + slope) e(w) + (bend w - s.bend e) e = trial
  /// in the stretch where the yield stress is that of the trial: without the products by Wright's function, or where e
  /// is straight by a division, then by one step of Newton's with them; where the place lies in another stretch, by
  /// steps of Halley's from the end of this one.
  Range<R> range(const BeyondYield<R>& s) {
    most_ = s.most;
    rows_ = yield_.rows();
    begin_ = yield_.begin();
    end_ = yield_.end();
    const R p = yield_.plastic_strain();
    find_stretch(s.trial, p - begin_);
    const R above = s.trial - low_at(p), rise = rise_at(p), modulus = s.modulus + slope_;
    const auto curved = log_span_ > 0.0 && rise > 0.0;
    R w, e, fall;  // fall: slope of the left side over w
    if (any(curved)) {
      const R steep = modulus * log_span_, over = 1.0 / (steep * rise), over_rise = over * steep;
      const R at = above * over_rise;  // where the yield stress is that of the trial
      const R t = omega(log_span_ * at + logarithm(start_ * (steep * over_rise)));
      e = over * (rise * rise) * t;
      w = at - over_rise * modulus * e;
      fall = rise * (1.0 + t);
    }
    if (any(!curved)) {
      const R straight = rise + modulus * span_, there = (above - modulus * start_) / straight;
      w = select(curved, w, there);
      e = select(curved, e, start_ + span_ * there);
      fall = select(curved, fall, straight);
    }
    w -= e * (bend_ * w - s.bend * e) / fall;
    R x = place_ + max(min(w, R(1.0)), R(0.0));
    auto elsewhere = (w < 0.0 || w > 1.0) && s.trial > s.start;
    for (int i = 0; i < 4 && any(elsewhere); ++i) {
      x = select(elsewhere, closer(x, s), x);
      elsewhere = elsewhere && outside(x);
    }
    // Lanes that do not yield stay in their stretch.
    return {R(table_.first()), R(table_.last() + 1.0), select(s.trial > s.start, x, place_ + 0.5)};
  }

  Trial<R> operator()(const R& x) {
    move_to(x);
    const R w = x - place_;
    const Increment at = increment(w);
    const R strain = yield_.plastic_strain() + at.value;
    if (any(left_rows(strain))) {
      const typename RateRows<R>::Row row = rows_.find(table_, strain);
      begin_ = row.begin;
      end_ = row.end;
      take(place_);
    }
    const R rise = rise_at(strain), slope = slope_ + w * bend_;
    Trial<R> t{at.value, low_at(strain) + w * rise,
               at.slope, rise + slope * at.slope,
               at.bend,  2.0 * bend_ * at.slope + slope * at.bend};
    if constexpr (Yield::limited) t = limited(t, yield_.limit());
    return t;
  }
  /// Whether the table has no corner between places x and next, at whose end the increment is that.
  MaskOf<R> smooth(const R& x, const R& next, const R& increment) const requires(!Yield::limited) {
    const auto corner = outside(next) || left_rows(yield_.plastic_strain() + increment);
    return abs(log_span_ * (next - x)) < small_step<R> && !corner;
  }

 private:
  /// Plastic strain of the step and its derivatives over w.
  struct Increment {
    R value, slope, bend;
  };
  Increment increment(const R& w) const {
    const R exponent = log_span_ * w;
    const R grown = start_ * (any(exponent > 0.0 || exponent < 0.0) ? exponential(exponent) : R(1.0));
    return {grown + span_ * w, log_span_ * grown + span_, log_span_ * log_span_ * grown};
  }
  R low_at(const R& strain) const { return y_ + slope_ * (strain - begin_); }
  R rise_at(const R& strain) const { return rise_ + bend_ * (strain - begin_); }
  MaskOf<R> outside(const R& x) const { return x < place_ || x > place_ + 1.0; }
  MaskOf<R> left_rows(const R& strain) const { return strain < begin_ || strain >= end_; }

  /// Wright's function: the t of t + ln t = l, to 1.2e-4 in -10 <= l <= 31, by a quotient of polynomials fitted to it.
  /// Below that of -10, above straight on.
  static R omega(const R& l) {
    const R x = max(min(0.1 * l, R(3.1)), R(-1.0)), x2 = x * x, x4 = x2 * x2;
    const R t =
        (((0.5672435 + 5.201755 * x) + x2 * (22.30573 + 56.26242 * x)) +
         x4 * ((87.8526 + 83.29546 * x) + x2 * (43.82447 + 9.790592 * x))) /
        (((1.0 + 2.792157 * x) + x2 * (8.55912 + 10.63032 * x)) + x4 * ((10.24261 + 4.760522 * x) + x2 * 0.9966119));
    return t + 0.97 * max(l - 31.0, R(0.0));
  }

  /// A step of Halley's from x, in the stretch where that lies.
  R closer(const R& x, const BeyondYield<R>& s) {
    move_to(x);
    const R w = x - place_, p = yield_.plastic_strain(), rise = rise_at(p);
    const Increment e = increment(w);
    const R modulus = s.modulus + slope_ + bend_ * w - s.bend * e.value, steep = modulus - s.bend * e.value;
    const R excess = low_at(p) + rise * w + modulus * e.value - s.trial;
    const R first = rise + steep * e.slope, second = steep * e.bend;
    return x - 2.0 * excess * first / (2.0 * first * first - excess * second);
  }

  /// Takes the stretch between two curves in which the yield stress is `stress` at the strain `from` the rows' begin,
  /// the first or the last of them where it is outside.
  void find_stretch(const R& stress, const R& from) {
    const int end = static_cast<int>(table_.stretches().size()) - 1;
    R place = R(0.0), more = R(1.0);
    for (int i = table_.at_first_curve() + 1; i < end; ++i) {
      const typename RateRows<R>::Cells curve = rows_.cells([i](int) { return i; });
      more = select(stress >= curve.y + curve.slope * from, more, R(0.0));
      if (!any(more > 0.0)) break;
      place += more;
    }
    take(place);
  }
  void move_to(const R& x) {
    const auto elsewhere = outside(x);
    if (!any(elsewhere)) return;
    R place = place_;
    for (const RateTable::Stretch& s : table_.stretches()) place = select(elsewhere && x >= s.place, R(s.place), place);
    take(place);
  }
  void take(const R& place) {
    place_ = place;
    int numbers[lanes<R>];
    const RateTable::Stretch* stretches[lanes<R>];
    for (int l = 0; l < lanes<R>; ++l) {
      numbers[l] = static_cast<int>(lane(place, l)) + table_.at_first_curve();
      stretches[l] = &table_.stretches()[static_cast<std::size_t>(numbers[l])];
    }
    const Columns<R> stretch = columns<R>([&](int l) { return &stretches[l]->place; });
    start_ = dt_ * stretch[1];
    span_ = select(place < table_.last(), dt_ * stretch[2], most_);
    log_span_ = stretch[3];
    const typename RateRows<R>::Cells cells = rows_.cells([&](int l) { return numbers[l]; });
    y_ = cells.y;
    rise_ = cells.rise;
    slope_ = cells.slope;
    bend_ = cells.bend;
  }

  const Yield& yield_;
  const RateTable& table_;
  double dt_;
  RateRows<R> rows_;
  R most_{};
  R begin_{}, end_{};
  R place_{}, start_{}, span_{}, log_span_{};  // start, span: of the plastic strain of the step
  R y_{}, rise_{}, slope_{}, bend_{};
};

}  // namespace nugget::kernel
