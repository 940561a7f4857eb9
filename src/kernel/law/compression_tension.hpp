// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <set>
#include <vector>

#include "kernel/law/hardening.hpp"
#include "kernel/law/j2.hpp"

namespace nugget::kernel {

/// A metal or plastic that yields otherwise in compression than in tension (MAT_124): J2 flow with the yield stress
///   w Yc + (1 - w) Yt,  w = (p + PT) / (PC + PT) within 0 and 1,
/// p the mean pressure of the trial stress. With PC and PT of 0 the sign of p decides; without pressure w is 1/2.
struct CompressionTension {
  double E = 0.0;                              ///< Young's modulus [stress]
  double nu = 0.0;                             ///< Poisson's ratio [1]
  Curve compression, tension;                  ///< Yc, Yt at rest: yield stress over plastic strain
  Curve compression_scale{}, tension_scale{};  ///< factor on it over the rate of the plastic strain; empty: none
  double rate_c = 0.0, rate_p = 0.0;           ///< Cowper-Symonds C [1/time] and P [1], of both; 0: no rate effect
  double full_compression = 0.0, full_tension = 0.0;  ///< PC, PT [stress]
  double failure_strain = 0.0;  ///< FAIL, effective plastic strain at which a point fails [1]; 0: none
  double deletion_step = 0.0;   ///< TDEL [time]; 0: never
};

/// Field of a point's history, behind the plastic strain: w.
inline constexpr int compression_share_field = first_own_field;

/// The unknown of a return by two tables over the same rates, of which the first has a share.
template <class R, class Table>
class ByTwoTables {
 public:
  static constexpr bool is_increment = false;
  ByTwoTables(Table& one, Table& other, const R& share) : one_(one), other_(other), share_(share) {}

  Range<R> range(const BeyondYield<R>& s) {
    const Range<R> a = one_.range(s), b = other_.range(s);
    return {a.low, a.high, blend(a.first, b.first)};
  }
  Trial<R> operator()(const R& x) {
    const Trial<R> a = one_(x), b = other_(x);
    return {a.increment,      blend(a.yield, b.yield),          a.increment_slope, blend(a.yield_slope, b.yield_slope),
            a.increment_bend, blend(a.yield_bend, b.yield_bend)};
  }

 private:
  R blend(const R& a, const R& b) const { return b + share_ * (a - b); }
  Table &one_, &other_;
  R share_;
};

class CompressionTensionHardening {
 public:
  explicit CompressionTensionHardening(const CompressionTension& law)
      : compression_(at_rates(law, law.compression, law.compression_scale)),
        tension_(at_rates(law, law.tension, law.tension_scale)),
        rate_(law.rate_c, law.rate_p) {}

  double lowest() const { return std::min(compression_.lowest(), tension_.lowest()); }
  static double kinematic() { return 0.0; }

  template <class R>
  class At {
   public:
    static constexpr bool limited = false;
    At(const CompressionTensionHardening& hardening, const Number<R>* history)
        : compression(hardening.compression_, history),
          tension(hardening.tension_, history),
          share(load_field<R>(history, compression_share_field)) {}
    YieldStress<R> operator()(const R& increment) {
      const YieldStress<R> c = compression(increment), t = tension(increment);
      return {t.value + share * (c.value - t.value), t.slope + share * (c.slope - t.slope)};
    }

    CurveHardening::At<R> compression, tension;
    R share;
  };
  template <class R, class Function>
  [[gnu::always_inline]] inline auto with_unknown(At<R>& yield, double dt, Function&& f) const {
    if (!compression_.table().active()) return kernel::with_unknown<R>(yield, rate_, dt, f);
    using Table = ByTable<R, CurveHardening::At<R>>;
    Table compression(yield.compression, compression_.table(), dt), tension(yield.tension, tension_.table(), dt);
    ByTwoTables<R, Table> unknown(compression, tension, yield.share);
    return f(unknown);
  }

 private:
  /// A curve times its scale, at the rates of both scales.
  static PiecewiseLinear at_rates(const CompressionTension& law, const Curve& curve, const Curve& scale) {
    PiecewiseLinear one;
    one.yield = {curve};
    std::set<double> rates;
    for (const Curve* over_rate : {&law.compression_scale, &law.tension_scale})
      for (const double rate : over_rate->x)
        if (rate > 0.0) rates.insert(rate);
    if (rates.empty()) return one;
    rates.insert(0.0);
    one.yield.clear();
    for (const double rate : rates) {
      one.rates.push_back(rate);
      Curve& scaled = one.yield.emplace_back(curve);
      for (double& y : scaled.y) y *= scale.empty() ? 1.0 : scale.clamped(rate);
    }
    return one;
  }

  CurveHardening compression_, tension_;
  CowperSymonds rate_;
};

template <>
class LawKernel<CompressionTension> : public J2<CompressionTensionHardening, false> {
  using Base = J2<CompressionTensionHardening, false>;

 public:
  explicit LawKernel(const CompressionTension& law)
      : Base(law.E, law.nu, CompressionTensionHardening(law), law.failure_strain),
        full_compression_(law.full_compression),
        full_tension_(law.full_tension) {}

  static constexpr int layer_history() { return compression_share_field + 1; }
  static constexpr int solid_history() { return layer_history(); }
  static constexpr int fibre_history() { return layer_history(); }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    LayerTensor<R> trial = s;
    elastic().add(trial, R(dt) * rate);
    set_share<R>(trial.xx + trial.yy, history);
    return Base::layer(s, rate, dt, history);
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    SolidTensor<R> trial = s;
    elastic().add(trial, R(dt) * rate);
    set_share<R>(trial.xx + trial.yy + trial.zz, history);
    Base::solid(s, rate, dt, history);
  }
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double* history) const {
    FibreTensor<R> trial = s;
    elastic().add(trial, R(dt) * rate);
    set_share<R>(trial.rr, history);
    Base::fibre(s, rate, dt, history);
  }

 private:
  /// `trace`: three times the mean stress.
  template <class R>
  void set_share(const R& trace, double* history) const {
    const R pressure = (-1.0 / 3.0) * trace;
    const double width = full_compression_ + full_tension_;
    const R share = width > 0.0 ? R((1.0 / width) * (pressure + full_tension_))
                                : select(pressure > 0.0, R(1.0), select(pressure < 0.0, R(0.0), R(0.5)));
    store_field(history, compression_share_field, min(max(share, R(0.0)), R(1.0)));
  }

  double full_compression_, full_tension_;
};

}  // namespace nugget::kernel
