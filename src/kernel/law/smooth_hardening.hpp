// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "base/batch.hpp"
#include "kernel/law/hardening.hpp"
#include "kernel/law/johnson_cook.hpp"
#include "kernel/law/power_law.hpp"
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

/// Hardening by a formula. `Formula` has lowest(), yield(YieldPoint), at rest; rate(), the rate effect, and
/// limit(heating), which no rate exceeds; power(): what of it is dear and depends on the plastic strain at the start
/// only; heats(): whether the second number of the history is a temperature rise.
template <class Formula>
class SmoothHardening : public Formula {
 public:
  using Formula::Formula;

  double kinematic() const { return 0.0; }

  template <class R>
  class At {
   public:
    static constexpr bool limited = true;
    At(const SmoothHardening& hardening, const double* history)
        : hardening_(hardening), plastic_strain_(load_field<R>(history, 0)) {
      if (hardening.heats()) heating_ = load_field<R>(history, 1);
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

/// Johnson and Cook's yield stress.
class JohnsonCookFormula {
 public:
  explicit JohnsonCookFormula(const JohnsonCook& law)
      : law_(law), power_(law.hardening, law.exponent), rate_(law.rate_factor, law.reference_rate) {}

  double lowest() const { return heats() ? 0.0 : std::min({law_.yield, law_.static_stress_limit, law_.saturation}); }
  bool heats() const { return law_.heating > 0.0; }
  double power(double strain) const { return power_(strain); }
  const LogarithmicRate& rate() const { return rate_; }
  double limit(double heating) const { return law_.saturation * cold(heating); }
  YieldStress<double> yield(const YieldPoint& p) const {
    YieldStress<double> y = power_.after(p.strain, p.power, p.increment);
    y.value += law_.yield;
    if (y.value > law_.static_stress_limit) y = {law_.static_stress_limit, 0.0};
    const double left = cold(p.heating);
    return {y.value * left, y.slope * left};
  }

 private:
  /// Share of the yield stress that the heat leaves.
  double cold(double heating) const {
    return heats() ? std::max(1.0 - std::pow(heating / law_.melting_rise, law_.softening), 1e-6) : 1.0;
  }

  JohnsonCook law_;
  PowerOfStrain power_;
  LogarithmicRate rate_;
};

/// Power law of the elastic and plastic strain.
class PowerLawFormula {
 public:
  explicit PowerLawFormula(const PowerLaw& law)
      : law_(law), power_(law.strength, law.exponent), rate_(law.rate_c, law.rate_p) {}

  double lowest() const { return power(0.0); }
  double power(double strain) const { return power_(law_.yield_strain + strain); }
  static constexpr bool heats() { return false; }
  const CowperSymonds& rate() const { return rate_; }
  static double limit(double) { return std::numeric_limits<double>::infinity(); }
  YieldStress<double> yield(const YieldPoint& p) const {
    return power_.after(law_.yield_strain + p.strain, p.power, p.increment);
  }

 private:
  PowerLaw law_;
  PowerOfStrain power_;
  CowperSymonds rate_;
};

}  // namespace nugget::kernel
