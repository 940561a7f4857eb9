// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "base/real.hpp"

namespace nugget::kernel {

/// Yield stress and its slope over the plastic strain of this step, both [stress].
template <class R>
struct YieldStress {
  R value{}, slope{};
};

/// Plastic strain of the step and yield stress where the unknown of a return has some value, and their first and second
/// derivatives with respect to it.
template <class R>
struct Trial {
  R increment{}, yield{};
  R increment_slope{}, yield_slope{};
  R increment_bend{}, yield_bend{};
};

/// What a return begins with: the effective trial stress, which an increment e of plastic strain takes to
/// trial - modulus e + bend e^2 - ..., and what e lies below.
template <class R>
struct BeyondYield {
  R trial, start;   ///< start: the yield stress at e = 0 [stress]
  R most;           ///< e cannot be larger [1]
  R modulus, bend;  ///< [stress]
};

/// Where a return to the yield surface ends.
template <class R>
struct PlasticReturn {
  R increment;       ///< of the effective plastic strain [1]
  R yield;           ///< yield stress Y reached [stress]
  R over_a, over_b;  ///< 1 / (Y + ka increment), 1 / (Y + kb increment) [1/stress]
};
template <class R>
PlasticReturn<R> chosen(MaskOf<R> mask, const PlasticReturn<R>& yes, const PlasticReturn<R>& no) {
  return {select(mask, yes.increment, no.increment), select(mask, yes.yield, no.yield),
          select(mask, yes.over_a, no.over_a), select(mask, yes.over_b, no.over_b)};
}

/// Of a last step that is taken by series: share by which the stress, or the rate, changes. Its third power is an error
/// that does not matter.
template <class R>
inline constexpr double small_step = is_single<R> ? 5e-3 : 3e-4;

/// The unknown of a return where the yield stress does not depend on the rate: the increment itself. `Yield` gives the
/// yield stress after an increment.
template <class R, class Yield>
class ByIncrement {
 public:
  static constexpr bool is_increment = true;
  explicit ByIncrement(Yield& yield) : yield_(yield) {}
  Trial<R> operator()(const R& increment) {
    const YieldStress<R> y = yield_(increment);
    return {increment, y.value, R(1.0), y.slope, R(0.0), R(0.0)};
  }

 private:
  Yield& yield_;
};

/// Finds the increment e of plastic strain with
///   A / (Y + ka e)^2 + B / (Y + kb e)^2 = 1,   Y the yield stress,
/// to which the J2 return comes in every stress space: A and B are the squares of the parts of the effective trial
/// stress that shrink with the moduli ka and kb. Solid: A = 0, kb = 3G. Plane stress (Simo and Taylor 1986, with
/// transverse shear): A = (sxx + syy)^2 / 4, ka = E / (2 (1 - nu)), kb = 3G. Beam fibre: A = s^2, ka = E, B = 3 tau^2,
/// kb = 3G. Kinematic hardening adds its modulus to both. `start` is the yield stress at e = 0, `trial2` is A + B, the
/// square of the effective trial stress.
///
/// e and Y are functions of an unknown x in which both are smooth (ByIncrement; hardening.hpp has those of rate
/// effects, which would need dozens of steps in e). Unless x is e itself, `Unknown` has range(BeyondYield), which says
/// where x lies, and a first guess. Chebyshev's third-order step on (A/.. + B/..)^(-1/2) = 1, kept inside a bracket;
/// relative residual 2e-12, in single precision, which rounds the sum of squares to some 5e-7, 2e-6. Where `Unknown`
/// has smooth(x, next, increment), whether all is smooth from x to next, where the increment is that, a last step that
/// is small is taken by the series of e and Y, without asking for them there once more. A lane that has converged is
/// frozen, so that a batch gives bit for bit what its elements give alone.
template <bool both, class R, class Unknown>
[[gnu::always_inline]] inline PlasticReturn<R> plastic_return(const R& A, const R& B, const R& trial2, double ka,
                                                              double kb, Unknown& unknown, const YieldStress<R>& start,
                                                              MaskOf<R> active) {
  constexpr double tolerance = is_single<R> ? 2e-6 : 2e-12;
  constexpr int limit = 100;
  constexpr bool ends_by_series = requires {
    unknown.smooth(R(), R(), R());
  };
  const R trial = sqrt(trial2), most = trial * (1.0 / (both ? std::min(ka, kb) : kb));
  R low, high, next;
  if constexpr (Unknown::is_increment) {
    low = R(0.0);
    high = most;
    const R over_by = trial - start.value;
    if constexpr (both) {
      const R ga = start.slope + ka, gb = start.slope + kb;
      const R sum = A * ga + B * gb;
      if constexpr (is_single<R>) {
        // The same with no product that leaves the range: stresses in Pa to the seventh power do.
        const R over_sum = 1.0 / sum;
        const R bend = 1.5 * ((A * (ka - kb)) * over_sum) * ((B * (ka - kb)) * over_sum) * (over_by / start.value);
        next = (trial2 * over_sum) * over_by * (1.0 + bend);
      } else {
        const R over = 1.0 / (sum * start.value), over_sum = over * start.value;
        const R bend = 1.5 * A * B * ((ka - kb) * (ka - kb)) * over_by * over_sum * (over * sum) * over_sum;
        next = trial2 * over_by * over_sum * (1.0 + bend);
      }
    } else {
      next = over_by / (start.slope + kb);
    }
  } else {
    R modulus = R(kb), bend = R(0.0);
    if constexpr (both) {
      const R over = 1.0 / trial, a = A * (over * over), b = B * (over * over);
      modulus = a * ka + b * kb;
      bend = 1.5 * ((ka - kb) * (ka - kb)) * (a * b) * over;
    }
    const auto range = unknown.range(BeyondYield<R>{trial, start.value, most, modulus, bend});
    low = range.low;
    high = range.high;
    next = range.first;
  }
  next = select(next > low && next < high, next, 0.5 * (low + high));
  // Lanes that do not yield stay where range() puts them: elsewhere they would be looked up for nothing.
  R x = Unknown::is_increment ? select(active, next, low) : next;
  PlasticReturn<R> r;
  for (int i = 0;; ++i) {
    const Trial<R> y = unknown(x);
    const R a = y.yield + ka * y.increment, b = y.yield + kb * y.increment;
    PlasticReturn<R> at{y.increment, y.yield, R(0.0), R(0.0)};
    R a2 = R(0.0);
    if constexpr (both) {
      const R over = 1.0 / (a * b);
      at.over_a = over * b;
      at.over_b = over * a;
      a2 = A * (at.over_a * at.over_a);
    } else {
      at.over_b = 1.0 / b;
    }
    r = ends_by_series ? chosen<R>(active, at, r) : at;
    const R b2 = B * (at.over_b * at.over_b), s = both ? a2 + b2 : b2;
    R excess = s - 1.0;
    if constexpr (is_single<R>) excess = select(b < 1e18, excess, R(-1.0));  // a rate so far off that a b is infinite
    active = active && abs(excess) > tolerance;
    if (!any(active) || i == limit) return r;

    const auto short_of = excess > 0.0;
    low = select(short_of, x, low);
    high = select(short_of, high, x);
    const R gb = at.over_b * (y.yield_slope + kb * y.increment_slope);
    R first = b2 * gb, second = first * gb;  // -1/2 of the slope of s, 1/6 of its curvature
    if constexpr (!Unknown::is_increment)
      second -= (1.0 / 3.0) * b2 * at.over_b * (y.yield_bend + kb * y.increment_bend);
    if constexpr (both) {
      const R ga = at.over_a * (y.yield_slope + ka * y.increment_slope), part = a2 * ga;
      first += part;
      second += part * ga;
      if constexpr (!Unknown::is_increment)
        second -= (1.0 / 3.0) * a2 * at.over_a * (y.yield_bend + ka * y.increment_bend);
    }
    // Chebyshev's step. sqrt(s) - 1 by its series: exact enough near the end; farther off the bracket holds.
    const R root = excess * (0.5 - excess * (0.125 - 0.0625 * excess)), over = 1.0 / first;
    const R newton = s * root * over, bend = 1.5 * newton * over * (s * second - first * first);
    // Far off, where the function bends much, Chebyshev's factor could vanish: Halley's there, as exact.
    if constexpr (Unknown::is_increment)
      next = x + newton * (1.0 + bend);
    else
      next = x + newton * select(bend < 0.0, 1.0 / (1.0 - bend), 1.0 + bend);
    if constexpr (ends_by_series) {
      const R step = next - x;
      const R increment = step * (y.increment_slope + 0.5 * step * y.increment_bend);
      const R yield = step * (y.yield_slope + 0.5 * step * y.yield_bend);
      const auto ends = active && abs(step * first) < small_step<R> && unknown.smooth(x, next, y.increment + increment);
      const auto after = [](const R& of, const R& change) {
        const R share = of * change;
        return of * (1.0 - share * (1.0 - share * (1.0 - share)));
      };
      const PlasticReturn<R> end{y.increment + increment, y.yield + yield,
                                 both ? after(at.over_a, yield + ka * increment) : R(0.0),
                                 after(at.over_b, yield + kb * increment)};
      r = chosen<R>(ends, end, r);
      active = active && !ends;
      if (!any(active)) return r;
    }
    next = select(next > low && next < high, next, 0.5 * (low + high));
    if constexpr (is_single<R>) active = active && (next > x || next < x);  // no number is closer
    x = select(active, next, x);
  }
}

}  // namespace nugget::kernel
