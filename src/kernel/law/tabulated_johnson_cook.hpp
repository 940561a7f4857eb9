// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

#include "base/curve.hpp"
#include "kernel/law/heated_metal.hpp"

namespace nugget::kernel {

/// Yield stress by tables (MAT_224): k1(ep, rate) kt(ep, T) / kt(ep, TR), k1 the curves of PiecewiseLinear over the
/// rate of the plastic strain. A share BETA of the plastic work heats the point, and no heat leaves it. The factor of
/// the temperature is that of the plastic strain and the temperature at the start of a step.
struct TabulatedJohnsonCook : PiecewiseLinear {
  CurveTable softening{};  ///< LCKT: kt over the plastic strain at each temperature rise T - TR [stress]
  double heating = 0.0;    ///< rise of temperature a work, BETA / (RO CP) [temperature/stress]; 0: none
};

/// The unknown of a return whose yield stress is `factor` times that of a table.
template <class R>
class TimesUnknown {
 public:
  static constexpr bool is_increment = false;
  using Table = ByTable<R, CurveHardening::At<R>>;
  TimesUnknown(Table& table, const R& factor) : table_(table), factor_(factor) {}

  Range<R> range(const BeyondYield<R>& s) {
    const R over = 1.0 / factor_;
    return table_.range({over * s.trial, over * s.start, s.most, over * s.modulus, over * s.bend});
  }
  Trial<R> operator()(const R& x) {
    Trial<R> t = table_(x);
    t.yield *= factor_;
    t.yield_slope *= factor_;
    t.yield_bend *= factor_;
    return t;
  }
  MaskOf<R> smooth(const R& x, const R& next, const R& increment) const { return table_.smooth(x, next, increment); }

 private:
  Table& table_;
  R factor_;
};

/// Hardening of MAT_224: curves over the rate times a factor of the temperature.
class HeatedCurves : public CurveHardening {
 public:
  explicit HeatedCurves(const TabulatedJohnsonCook& law)
      : CurveHardening(law), softening_(law.softening), heats_(law.heating > 0.0 && law.softening.given()) {
    if (!heats_) return;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const Curve& curve : softening_.curve)
      for (const double y : curve.y) {
        least = std::min(least, y);
        most = std::max(most, y);
      }
    least_factor_ = least / most;
  }

  double lowest() const { return least_factor_ * CurveHardening::lowest(); }

  template <class R>
  class At {
   public:
    static constexpr bool limited = false;
    At(const HeatedCurves& hardening, const Number<R>* history) : curve_(hardening, history) {
      if (!hardening.heats_) return;
      factor_ = map([&](double strain, double rise) { return hardening.factor(strain, rise); }, curve_.plastic_strain(),
                    load_field<R>(history, temperature_rise_field));
    }
    YieldStress<R> operator()(const R& increment) {
      const YieldStress<R> y = curve_(increment);
      return {factor_ * y.value, factor_ * y.slope};
    }
    CurveHardening::At<R>& cold() { return curve_; }
    const R& factor() const { return factor_; }

   private:
    CurveHardening::At<R> curve_;
    R factor_ = R(1.0);
  };
  template <class R, class Function>
  [[gnu::always_inline]] inline auto with_unknown(At<R>& yield, double dt, Function&& f) const {
    if (!table().active()) {
      ByIncrement<R, At<R>> unknown(yield);
      return f(unknown);
    }
    ByTable<R, CurveHardening::At<R>> of_cold(yield.cold(), table(), dt);
    TimesUnknown<R> unknown(of_cold, yield.factor());
    return f(unknown);
  }

 private:
  /// kt(ep, T) / kt(ep, TR).
  double factor(double strain, double rise) const { return softening_.at(rise, strain) / softening_.at(0.0, strain); }

  CurveTable softening_;
  bool heats_;
  double least_factor_ = 1.0;
};

/// History of a point: as of HeatedMetal.
template <>
class LawKernel<TabulatedJohnsonCook> : public HeatedMetal<HeatedCurves> {
 public:
  explicit LawKernel(const TabulatedJohnsonCook& law)
      : HeatedMetal(law, law.heating, std::numeric_limits<double>::infinity()) {}
};

}  // namespace nugget::kernel
