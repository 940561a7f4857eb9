// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/batch.hpp"
#include "kernel/law/hardening.hpp"
#include "kernel/law/johnson_cook.hpp"
#include "kernel/law/power_law.hpp"
#include "kernel/law/rate_dependent_yield.hpp"

// Hardenings by formulas rather than curves; see hardening.hpp for what a hardening gives.
namespace nugget::kernel {

/// What a formula for the yield stress may depend on.
struct YieldPoint {
  double strain = 0.0;     ///< plastic strain at the start of the step
  double increment = 0.0;  ///< of it in the step
  double power = 0.0;      ///< the formula's power() of `strain`
  double heating = 0.0;    ///< temperature rise at the start of the step, where the formula keeps one
  double dt = 0.0;
  double rate() const { return increment / dt; }
};

/// Hardening by a formula. `Formula` has lowest(), yield(YieldPoint); power(): what of it is dear and depends on the
/// plastic strain at the start only; heats(): whether the second number of the history is a temperature rise.
template <class Formula>
class SmoothHardening : public Formula {
 public:
  using Formula::Formula;

  double kinematic() const { return 0.0; }

  template <class R>
  class At {
   public:
    At(const SmoothHardening& hardening, const double* history, double dt)
        : hardening_(hardening), plastic_strain_(load_field<R>(history, 0)), dt_(dt) {
      if (hardening.heats()) heating_ = load_field<R>(history, 1);
      power_ = map([&](double strain) { return hardening.power(strain); }, plastic_strain_);
    }
    YieldStress<R> operator()(const R& increment) const {
      YieldStress<R> y;
      for (int l = 0; l < lanes<R>; ++l) {
        const YieldStress<double> one =
            hardening_.yield({lane(plastic_strain_, l), lane(increment, l), lane(power_, l), lane(heating_, l), dt_});
        set_lane(y.value, l, one.value);
        set_lane(y.slope, l, one.slope);
      }
      return y;
    }

   private:
    const SmoothHardening& hardening_;
    R plastic_strain_, heating_{}, power_{};
    double dt_;
  };
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
  explicit JohnsonCookFormula(const JohnsonCook& law) : law_(law), power_(law.hardening, law.exponent) {}

  double lowest() const { return heats() ? 0.0 : std::min({law_.yield, law_.most_hardened, law_.saturation}); }
  bool heats() const { return law_.heating > 0.0; }
  double power(double strain) const { return power_(strain); }
  YieldStress<double> yield(const YieldPoint& p) const {
    YieldStress<double> y = power_.after(p.strain, p.power, p.increment);
    y.value += law_.yield;
    if (y.value > law_.most_hardened) y = {law_.most_hardened, 0.0};
    const double over = p.rate() / law_.rest_rate;
    if (law_.rate_factor != 0.0 && over > 1.0) {
      const double factor = 1.0 + law_.rate_factor * std::log(over);
      y.slope = y.slope * factor + y.value * law_.rate_factor / p.increment;
      y.value *= factor;
    }
    if (y.value > law_.saturation) y = {law_.saturation, 0.0};
    if (!heats()) return y;
    const double cold = std::max(1.0 - std::pow(p.heating / law_.melting_rise, law_.softening), 1e-6);
    return {y.value * cold, y.slope * cold};
  }

 private:
  JohnsonCook law_;
  PowerOfStrain power_;
};

/// Power law of the elastic and plastic strain.
class PowerLawFormula {
 public:
  explicit PowerLawFormula(const PowerLaw& law)
      : law_(law), power_(law.strength, law.exponent), rate_{law.rate_c, law.rate_p} {}

  double lowest() const { return power(0.0); }
  double power(double strain) const { return power_(law_.yield_strain + strain); }
  static constexpr bool heats() { return false; }
  YieldStress<double> yield(const YieldPoint& p) const {
    const YieldStress<double> y = power_.after(law_.yield_strain + p.strain, p.power, p.increment);
    if (!rate_.active()) return y;
    const double factor = rate_.factor(p.rate());
    const double steeper = p.increment > 0.0 ? (factor - 1.0) / (law_.rate_p * p.increment) : 0.0;
    return {y.value * factor, y.slope * factor + y.value * steeper};
  }

 private:
  PowerLaw law_;
  PowerOfStrain power_;
  CowperSymonds rate_;
};

/// Yield stress and plastic modulus by curves over the rate.
class RateDependentFormula {
 public:
  explicit RateDependentFormula(const RateDependentYield& law) : law_(law) {}

  double lowest() const { return *std::min_element(law_.yield.y.begin(), law_.yield.y.end()); }
  static constexpr double power(double) { return 0.0; }
  static constexpr bool heats() { return false; }
  YieldStress<double> yield(const YieldPoint& p) const {
    const double rate = p.rate(), strain = p.strain + p.increment;
    const double modulus = law_.plastic_modulus.clamped(rate);
    YieldStress<double> y{law_.yield.clamped(rate) + modulus * strain, modulus};
    const bool inside = rate > law_.yield.x.front() && rate < law_.yield.x.back();
    if (inside) y.slope += law_.yield.slope(rate) / p.dt;
    return y;
  }

 private:
  RateDependentYield law_;
};

}  // namespace nugget::kernel
