// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "base/elementary.hpp"
#include "kernel/law/plastic_return.hpp"

// Rate effects that scale a yield stress, as functions of x, the share by which they raise it (or what that share goes
// with): the return of a point finds x rather than its plastic strain, since over the strain their slope at small rates
// is without bound, and hardly any step of Newton's would help.
namespace nugget::kernel {

/// Where the unknown of a return lies, and a first guess.
template <class R>
struct Range {
  R low, high, first;
};

/// Rate of the plastic strain and its derivatives at x, and the share by which the rate raises the yield stress.
template <class R>
struct RateAt {
  R rate, slope, bend;
  R raise, raise_slope;
};

/// 1 + (rate / C)^(1/P) (Cowper and Symonds); x = (rate / C)^(1/P).
class CowperSymonds {
 public:
  CowperSymonds() = default;
  /// `raised`: the yield stress that rises, whatever the hardening adds to it [stress]; 0: all of it.
  CowperSymonds(double c, double p, double raised = 0.0) : c_(c), p_(p), raised_(raised) {}

  bool active() const { return c_ > 0.0; }
  double raised() const { return raised_; }

  /// `raise`: by what share the trial stress is above the yield stress at rest.
  template <class R>
  Range<R> range(const R& raise, const R& most_rate) const {
    const R most = (1.0 / c_) * most_rate;
    // The rate is so high a power of x that the return would not come back from farther off.
    if (p_ > 8.0) return {R(0.0), (1.0 + 1e-9) * power(most, 1.0 / p_), raise};
    if (p_ >= 1.0) return {R(0.0), max(most, R(1.0)), raise};
    return {R(0.0), power(most, 1.0 / p_), raise};
  }
  template <class R>
  [[gnu::always_inline]] inline RateAt<R> operator()(const R& x) const {
    const R rate = c_ * power(x, p_), over = 1.0 / x, slope = p_ * rate * over;
    return {rate, slope, (p_ - 1.0) * slope * over, x, R(1.0)};
  }

 private:
  double c_ = 0.0;  // [1/time]; 0: no rate effect
  double p_ = 1.0;  // [1]
  double raised_ = 0.0;
};

/// 1 + C ln(rate / rest) above the rate `rest`, 1 below (Johnson and Cook); x = ln(rate / rest), or rate / rest - 1.
class LogarithmicRate {
 public:
  LogarithmicRate() = default;
  LogarithmicRate(double factor, double rest) : factor_(factor), rest_(rest) {}

  bool active() const { return factor_ != 0.0; }
  static constexpr double raised() { return 0.0; }

  template <class R>
  Range<R> range(const R& raise, const R& most_rate) const {
    const R most = logarithm(max((1.0 / rest_) * most_rate, R(1.0)));
    return {R(-1.0), most + 1e-9, (1.0 / factor_) * raise};
  }
  template <class R>
  [[gnu::always_inline]] inline RateAt<R> operator()(const R& x) const {
    const auto above = x > 0.0;
    const R grown = rest_ * exponential(max(x, R(0.0)));
    return {select(above, grown, rest_ * (1.0 + x)), grown, select(above, grown, R(0.0)), factor_ * max(x, R(0.0)),
            select(above, R(factor_), R(0.0))};
  }

 private:
  double factor_ = 0.0;  // [1]; 0: no rate effect
  double rest_ = 1.0;    // [1/time]
};

/// (1 + rate / E0)^C; x = ln(1 + rate / E0).
class PowerOfRate {
 public:
  PowerOfRate() = default;
  PowerOfRate(double exponent, double reference) : exponent_(exponent), reference_(reference) {}

  bool active() const { return exponent_ > 0.0; }
  static constexpr double raised() { return 0.0; }

  template <class R>
  Range<R> range(const R& raise, const R& most_rate) const {
    const R most = logarithm((1.0 / reference_) * most_rate + 1.0);
    return {R(0.0), most + 1e-9, (1.0 / exponent_) * logarithm(max(raise, R(0.0)) + 1.0)};
  }
  template <class R>
  [[gnu::always_inline]] inline RateAt<R> operator()(const R& x) const {
    const R grown = reference_ * exponential(x), factor = exponential(exponent_ * x);
    return {grown - reference_, grown, grown, factor - 1.0, exponent_ * factor};
  }

 private:
  double exponent_ = 0.0;   // [1]; 0: no rate effect
  double reference_ = 1.0;  // [1/time]
};

/// A trial whose yield stress is held at `limit`.
template <class R>
Trial<R> limited(Trial<R> t, const R& limit) {
  const auto over = t.yield > limit;
  t.yield = select(over, limit, t.yield);
  t.yield_slope = select(over, R(0.0), t.yield_slope);
  t.yield_bend = select(over, R(0.0), t.yield_bend);
  return t;
}

/// The unknown of a return where `Rate` raises the yield stress that `Yield` gives at rest. `Yield` may have a limit()
/// that no rate exceeds.
template <class R, class Yield, class Rate>
class ByRate {
 public:
  static constexpr bool is_increment = false;
  ByRate(Yield& yield, const Rate& rate, double dt) : yield_(yield), rate_(rate), dt_(dt) {}

  Range<R> range(const BeyondYield<R>& s) const {
    const R raised = rate_.raised() > 0.0 ? R(rate_.raised()) : s.start;
    return rate_.range(R((s.trial - s.start) / raised), R((1.0 / dt_) * s.most));
  }
  [[gnu::always_inline]] inline Trial<R> operator()(const R& x) {
    const RateAt<R> at = rate_(x);
    const R e = dt_ * at.rate, e1 = dt_ * at.slope, e2 = dt_ * at.bend;
    const YieldStress<R> still = yield_(e);
    Trial<R> t{e, still.value, e1, still.slope * e1, e2, still.slope * e2};
    if (rate_.raised() > 0.0) {
      t.yield += rate_.raised() * at.raise;
      t.yield_slope += rate_.raised() * at.raise_slope;
    } else {
      t.yield += still.value * at.raise;
      t.yield_slope += t.yield_slope * at.raise + still.value * at.raise_slope;
      t.yield_bend += t.yield_bend * at.raise + 2.0 * still.slope * e1 * at.raise_slope;
    }
    if constexpr (Yield::limited) t = limited(t, yield_.limit());
    return t;
  }

 private:
  Yield& yield_;
  const Rate& rate_;
  double dt_;
};

/// Calls `f` with the unknown in which the return of a point with this yield stress at rest and this rate effect is
/// to be found.
template <class R, class Yield, class Rate, class Function>
[[gnu::always_inline]] inline auto with_unknown(Yield& yield, const Rate& rate, double dt, Function&& f) {
  if (!rate.active()) {
    ByIncrement<R, Yield> unknown(yield);
    return f(unknown);
  }
  ByRate<R, Yield, Rate> unknown(yield, rate, dt);
  return f(unknown);
}

}  // namespace nugget::kernel
