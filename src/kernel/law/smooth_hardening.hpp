// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "base/batch.hpp"
#include "kernel/law/hardening.hpp"
#include "kernel/law/rate_effects.hpp"

// Hardenings by formulas rather than curves; see hardening.hpp for what a hardening gives.
namespace nugget::kernel {

/// What a formula for the yield stress may depend on.
struct YieldPoint {
  double strain = 0.0;     ///< plastic strain at the start of the step
  double increment = 0.0;  ///< of it in the step
  double power = 0.0;      ///< the formula's power() of `strain`
  double heating = 0.0;    ///< temperature rise at the start of the step, where the formula keeps one
};

/// Field of a point's history, behind the plastic strain: its temperature rise, of formulas with heats().
inline constexpr int temperature_rise_field = 1;

/// Hardening by a formula. `Formula` has lowest(), yield(YieldPoint), at rest; rate(), the rate effect, and
/// limit(heating), which no rate exceeds; power(): what of it is dear and depends on the plastic strain at the start
/// only; heats(): whether the history has a temperature rise.
template <class Formula>
class SmoothHardening : public Formula {
 public:
  using Formula::Formula;

  double kinematic() const { return 0.0; }

  template <class R>
  class At {
   public:
    static constexpr bool limited = true;
    At(const SmoothHardening& hardening, const Number<R>* history)
        : hardening_(hardening), plastic_strain_(load_field<R>(history, plastic_strain_field)) {
      if (hardening.heats()) heating_ = load_field<R>(history, temperature_rise_field);
      power_ = map([&](double strain) { return hardening.power(strain); }, plastic_strain_);
      limit_ = map([&](double heating) { return hardening.limit(heating); }, heating_);
    }
    const R& limit() const { return limit_; }
    YieldStress<R> operator()(const R& increment) const {
      YieldStress<R> y;
      for (int l = 0; l < lanes<R>; ++l) {
        const YieldStress<double> one =
            hardening_.yield({lane(plastic_strain_, l), lane(increment, l), lane(power_, l), lane(heating_, l)});
        set_lane(y.value, l, one.value);
        set_lane(y.slope, l, one.slope);
      }
      const auto over = y.value > limit_;
      return {select(over, limit_, y.value), select(over, R(0.0), y.slope)};
    }

   private:
    const SmoothHardening& hardening_;
    R plastic_strain_, heating_{}, power_{}, limit_{};
  };
  template <class R, class Function>
  [[gnu::always_inline]] inline auto with_unknown(At<R>& yield, double dt, Function&& f) const {
    return kernel::with_unknown<R>(yield, this->rate(), dt, f);
  }
};

/// B e^N and its slope. Below a strain of 1e-9, where the slope would be without bound, a straight line.
class PowerOfStrain {
 public:
  PowerOfStrain(double factor, double exponent)
      : factor_(factor), exponent_(exponent), start_(factor * std::pow(tiny, exponent)) {
    for (int k = 0; k < terms; ++k) ratio_[k] = (exponent - k) / (k + 1);
  }
  double operator()(double strain) const {
    return strain < tiny ? start_ * (strain / tiny) : factor_ * std::pow(strain, exponent_);
  }
  /// After a further increment, with the value at `strain` known: small increments need no further power but the
  /// binomial series, exact to 1e-15.
  YieldStress<double> after(double strain, double value, double increment) const {
    const double end = strain + increment;
    if (end < tiny) return {(*this)(end), start_ / tiny};
    if (strain >= tiny && increment < 0.02 * strain) {
      const double x = increment / strain;
      double series = 1.0;
      for (int k = terms - 1; k >= 0; --k) series = 1.0 + series * (x * ratio_[k]);
      value *= series;
    } else {
      value = (*this)(end);
    }
    return {value, exponent_ * value / end};
  }

 private:
  static constexpr double tiny = 1e-9;
  static constexpr int terms = 8;
  double factor_, exponent_, start_;
  double ratio_[terms];
};

}  // namespace nugget::kernel
