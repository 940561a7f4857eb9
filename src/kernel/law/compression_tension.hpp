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
///
/// The modulus of a stress increment may be another in compression, too (EC, RPCT): by p at the start of the step,
///   v Ec + (1 - v) Et,  v = (p + RPCT PT) / (RPCT (PC + PT)) within 0 and 1,
/// and by the sign of the trial stress's p where RPCT (PC + PT) is 0. Poisson's ratio is the same.
struct CompressionTension {
  double E = 0.0;                              ///< Young's modulus, the larger one of two [stress]
  double nu = 0.0;                             ///< Poisson's ratio [1]
  Curve compression, tension;                  ///< Yc, Yt at rest: yield stress over plastic strain
  Curve compression_scale{}, tension_scale{};  ///< factor on it over the rate of the plastic strain; empty: none
  double rate_c = 0.0, rate_p = 0.0;           ///< Cowper-Symonds C [1/time] and P [1], of both; 0: no rate effect
  double full_compression = 0.0, full_tension = 0.0;  ///< PC, PT [stress]
  double failure_strain = 0.0;  ///< FAIL, effective plastic strain at which a point fails [1]; 0: none
  double deletion_step = 0.0;   ///< TDEL [time]; 0: never
  double tension_share = 1.0, compression_share = 1.0;  ///< Et / E, Ec / E [1]; the larger one is 1
  double soft_compression = 0.0, soft_tension = 0.0;    ///< RPCT PC, RPCT PT [stress]

  bool has_two_moduli() const { return tension_share != compression_share; }
};

/// Field of a point's history, behind the plastic strain: w.
inline constexpr int compression_share_field = first_own_field;
/// And, of two moduli, E over that of the step: stresses times this flow as a material of E does whose yield stress is
/// as many times higher.
inline constexpr int softness_field = compression_share_field + 1;

/// The unknown of a return by two tables over the same rates, of which the first has a share. `softness`: of stresses
/// outside over those of the tables.
template <class R, class Table>
class ByTwoTables {
 public:
  static constexpr bool is_increment = false;
  ByTwoTables(Table& one, Table& other, const R& share, const R& softness)
      : one_(one), other_(other), share_(share), softness_(softness), stiffness_(1.0 / softness) {}

  Range<R> range(const BeyondYield<R>& s) {
    const BeyondYield<R> own{stiffness_ * s.trial, stiffness_ * s.start, s.most, stiffness_ * s.modulus,
                             stiffness_ * s.bend};
    const Range<R> a = one_.range(own), b = other_.range(own);
    return {a.low, a.high, blend(a.first, b.first)};
  }
  Trial<R> operator()(const R& x) {
    const Trial<R> a = one_(x), b = other_(x);
    return {a.increment,       softness_ * blend(a.yield, b.yield),
            a.increment_slope, softness_ * blend(a.yield_slope, b.yield_slope),
            a.increment_bend,  softness_ * blend(a.yield_bend, b.yield_bend)};
  }

 private:
  R blend(const R& a, const R& b) const { return b + share_ * (a - b); }
  Table &one_, &other_;
  R share_, softness_, stiffness_;
};

class CompressionTensionHardening {
 public:
  explicit CompressionTensionHardening(const CompressionTension& law)
      : compression_(at_rates(law, law.compression, law.compression_scale)),
        tension_(at_rates(law, law.tension, law.tension_scale)),
        rate_(law.rate_c, law.rate_p),
        has_two_moduli_(law.has_two_moduli()) {}

  double lowest() const { return std::min(compression_.lowest(), tension_.lowest()); }
  static double kinematic() { return 0.0; }

  template <class R>
  class At {
   public:
    static constexpr bool limited = false;
    At(const CompressionTensionHardening& hardening, const Number<R>* history)
        : compression(hardening.compression_, history),
          tension(hardening.tension_, history),
          share(load_field<R>(history, compression_share_field)),
          softness(hardening.has_two_moduli_ ? load_field<R>(history, softness_field) : R(1.0)) {}
    YieldStress<R> operator()(const R& increment) {
      const YieldStress<R> c = compression(increment), t = tension(increment);
      return {softness * (t.value + share * (c.value - t.value)), softness * (t.slope + share * (c.slope - t.slope))};
    }

    CurveHardening::At<R> compression, tension;
    R share, softness;
  };
  template <class R, class Function>
  [[gnu::always_inline]] inline auto with_unknown(At<R>& yield, double dt, Function&& f) const {
    if (!compression_.table().active()) return kernel::with_unknown<R>(yield, rate_, dt, f);
    using Table = ByTable<R, CurveHardening::At<R>>;
    Table compression(yield.compression, compression_.table(), dt), tension(yield.tension, tension_.table(), dt);
    ByTwoTables<R, Table> unknown(compression, tension, yield.share, yield.softness);
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
  bool has_two_moduli_;
};

template <>
class LawKernel<CompressionTension> : public J2<CompressionTensionHardening, false> {
  using Base = J2<CompressionTensionHardening, false>;

 public:
  explicit LawKernel(const CompressionTension& law)
      : Base(law.E, law.nu, CompressionTensionHardening(law), law.failure_strain),
        full_compression_(law.full_compression),
        full_tension_(law.full_tension),
        has_two_moduli_(law.has_two_moduli()),
        tension_share_(law.tension_share),
        compression_share_(law.compression_share),
        soft_compression_(law.soft_compression),
        soft_tension_(law.soft_tension) {}

  static constexpr int layer_history() { return softness_field + 1; }
  static constexpr int solid_history() { return layer_history(); }
  static constexpr int fibre_history() { return layer_history(); }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R modulus = begin<R>(s, R(dt) * rate, history);
    const ThicknessStrain<R> thickness = Base::layer(s, rate, dt, history);
    if (has_two_moduli_) s = modulus * s;
    return thickness;
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const R modulus = begin<R>(s, R(dt) * rate, history);
    Base::solid(s, rate, dt, history);
    if (has_two_moduli_) s = modulus * s;
  }
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double* history) const {
    const R modulus = begin<R>(s, R(dt) * rate, history);
    Base::fibre(s, rate, dt, history);
    if (has_two_moduli_) s = {modulus * s.rr, modulus * s.rs, modulus * s.rt};
  }
  /// For motions so small that no pressure changes: the modulus is that without pressure.
  void make_linear_at_start() {
    const double width = soft_compression_ + soft_tension_, v = width > 0.0 ? soft_tension_ / width : 0.5;
    tension_share_ = compression_share_ = tension_share_ + v * (compression_share_ - tension_share_);
  }

 private:
  /// Three times the mean stress.
  template <class R>
  static R trace(const LayerTensor<R>& s) {
    return s.xx + s.yy;
  }
  template <class R>
  static R trace(const SolidTensor<R>& s) {
    return s.xx + s.yy + s.zz;
  }
  template <class R>
  static R trace(const FibreTensor<R>& s) {
    return s.rr;
  }

  /// Writes down the share of compression and, of two moduli, the softness, with which the stress is multiplied.
  /// Returns the modulus of the step over E.
  template <class R, class Tensor>
  R begin(Tensor& s, const Tensor& strain, double* history) const {
    Tensor trial = s;
    elastic().add(trial, strain);
    if (!has_two_moduli_) {
      set_share<R>(trace<R>(trial), history);
      return R(1.0);
    }
    const R now = trace<R>(s), step = trace<R>(trial) - now;
    const R v = share_of((-1.0 / 3.0) * (soft_compression_ + soft_tension_ > 0.0 ? now : now + step), soft_compression_,
                         soft_tension_);
    const R modulus = tension_share_ + v * (compression_share_ - tension_share_), softness = 1.0 / modulus;
    set_share<R>(now + modulus * step, history);
    store_field(history, softness_field, softness);
    if constexpr (requires { s.rr; })
      s = {softness * s.rr, softness * s.rs, softness * s.rt};
    else
      s = softness * s;
    return modulus;
  }

  /// How far a pressure is on its way from the tension at which one curve counts alone to the pressure at which the
  /// other one does.
  template <class R>
  static R share_of(const R& pressure, double compression, double tension) {
    const double width = compression + tension;
    const R share = width > 0.0 ? R((1.0 / width) * (pressure + tension))
                                : select(pressure > 0.0, R(1.0), select(pressure < 0.0, R(0.0), R(0.5)));
    return min(max(share, R(0.0)), R(1.0));
  }
  /// `trace`: three times the mean stress.
  template <class R>
  void set_share(const R& trace, double* history) const {
    store_field(history, compression_share_field, share_of<R>((-1.0 / 3.0) * trace, full_compression_, full_tension_));
  }

  double full_compression_, full_tension_;
  bool has_two_moduli_;
  double tension_share_, compression_share_, soft_compression_, soft_tension_;
};

}  // namespace nugget::kernel
