// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <variant>

#include "kernel/law/axes_field.hpp"
#include "kernel/law/barlat_lian.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/hardening.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/smooth_hardening.hpp"
#include "kernel/law/yld2000.hpp"

namespace nugget::kernel {

/// Yield stress of a sheet by a formula: A + K (E0 + ep)^N, or A - K exp(-C ep^N) where C is above 0, with
/// Cowper-Symonds rates.
struct SheetFormula {
  double offset = 0.0;        ///< A [stress]
  double factor = 0.0;        ///< K [stress]
  double exponent = 1.0;      ///< N [1]
  double start_strain = 0.0;  ///< E0 [1]
  double decay = 0.0;         ///< C [1]; 0: a power of the strain
  double rate_c = 0.0;        ///< Cowper-Symonds C [1/time]; 0: no rate effect
  double rate_p = 1.0;        ///< Cowper-Symonds P [1]
};

/// Rolled sheet in plane stress: elastic, with the yield surface of Barlat and Lian in material axes, the flow along
/// its normal and isotropic hardening (MAT_036, with the exponent 2 MAT_122, the same in all directions of the plane
/// MAT_037). The yield stress is that of tension along axis a; transverse shear is elastic.
struct AnisotropicSheet {
  double E = 0.0;   ///< Young's modulus [stress]
  double nu = 0.0;  ///< Poisson's ratio [1]
  BarlatLian surface{};
  std::variant<SheetFormula, PiecewiseLinear> hardening{};  ///< of curves their yield, rates, and Cowper-Symonds
  MaterialAxes axes{};
};

/// The same with the surface of Yld2000-2d (MAT_133). The yield stress is the effective one of the surface.
struct Yld2000Sheet {
  double E = 0.0;   ///< Young's modulus [stress]
  double nu = 0.0;  ///< Poisson's ratio [1]
  Yld2000 surface{};
  std::variant<SheetFormula, PiecewiseLinear> hardening{};
  MaterialAxes axes{};
};

/// The formula as smooth_hardening.hpp wants it.
class SheetYield {
 public:
  explicit SheetYield(const SheetFormula& f)
      : f_(f), power_(f.factor, f.exponent), strain_power_(1.0, f.exponent), rate_(f.rate_c, f.rate_p) {}

  double lowest() const { return std::min(at(0.0), at(1e3)); }
  static constexpr bool heats() { return false; }
  const CowperSymonds& rate() const { return rate_; }
  static double limit(double) { return std::numeric_limits<double>::infinity(); }
  double power(double strain) const {
    return f_.decay > 0.0 ? strain_power_(strain) : power_(f_.start_strain + strain);
  }
  YieldStress<double> yield(const YieldPoint& p) const {
    if (!(f_.decay > 0.0)) {
      YieldStress<double> y = power_.after(f_.start_strain + p.strain, p.power, p.increment);
      y.value += f_.offset;
      return y;
    }
    const YieldStress<double> x = strain_power_.after(p.strain, p.power, p.increment);
    const double left = f_.factor * std::exp(-f_.decay * x.value);
    return {f_.offset - left, f_.decay * x.slope * left};
  }

 private:
  double at(double strain) const { return yield({strain, 0.0, power(strain), 0.0}).value; }

  SheetFormula f_;
  PowerOfStrain power_, strain_power_;
  CowperSymonds rate_;
};

/// Both laws, with `Surface` made ready of their surface. History of a point: plastic strain; cosine and sine of the
/// angle from the element's axis to a.
template <class Surface>
class SheetKernel {
 public:
  static constexpr bool has_plastic_strain = true;

  template <class Sheet>
  explicit SheetKernel(const Sheet& law)
      : elastic_(law.E, law.nu),
        surface_(law.surface),
        hardening_(made_ready(law.hardening)),
        axes_(law.axes),
        lowest_(std::visit([](const auto& hardening) { return hardening.lowest(); }, hardening_)) {}

  int layer_history() const { return first_axis_field + 2; }
  const MaterialAxes& axes() const { return axes_; }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const LayerTensor<R> strain = R(dt) * rate;
    elastic_.add(s, strain);
    ThicknessStrain<R> thickness{-elastic_.thinning * (strain.xx + strain.yy), R(0.0)};
    const R c = load_field<R>(history, first_axis_field), t = load_field<R>(history, first_axis_field + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const PlaneStress<R> trial{cc * s.xx + tt * s.yy + 2.0 * ct * s.xy, tt * s.xx + cc * s.yy - 2.0 * ct * s.xy,
                               ct * (s.yy - s.xx) + (cc - tt) * s.xy};
    const R tiny = R(1e-12 * lowest_);
    const auto stressed = abs(trial.aa) + abs(trial.bb) + abs(trial.ab) > tiny;
    if (!any(stressed)) return thickness;
    // Lanes without stress get one that does not yield: the surface has no gradient at zero.
    const PlaneStress<R> safe{select(stressed, trial.aa, tiny), select(stressed, trial.bb, R(0.0)),
                              select(stressed, trial.ab, R(0.0))};
    const SurfaceAt<R> at = surface_(safe);
    if (!any(at.effective > R(lowest_))) return thickness;
    std::visit([&](const auto& hardening) { flow(hardening, safe, at, dt, history, c, t, s, thickness); }, hardening_);
    return thickness;
  }

 private:
  using Hardening = std::variant<SmoothHardening<SheetYield>, CurveHardening>;
  static Hardening made_ready(const std::variant<SheetFormula, PiecewiseLinear>& given) {
    if (const auto* formula = std::get_if<SheetFormula>(&given)) return SmoothHardening<SheetYield>(*formula);
    return CurveHardening(std::get<PiecewiseLinear>(given));
  }

  /// Elastic stress of a strain with engineering shear.
  template <class R>
  PlaneStress<R> elastic_stress(const PlaneStress<R>& strain) const {
    return {elastic_.plane * (strain.aa + elastic_.nu * strain.bb),
            elastic_.plane * (strain.bb + elastic_.nu * strain.aa), elastic_.shear * strain.ab};
  }

  /// Where a return ends: the stress on the surface, its flow, the increment of plastic strain, and the unknown by
  /// which the hardening gives it.
  template <class R>
  struct Returned {
    PlaneStress<R> stress{}, flow{};
    R increment{}, unknown{};
  };

  /// Returns yielding lanes to the surface and adds what that does to stress, history and thickness.
  template <class R, class Yield>
  [[gnu::noinline]] void flow(const Yield& hardening, const PlaneStress<R>& trial, const SurfaceAt<R>& at, double dt,
                              double* history, const R& c, const R& t, LayerTensor<R>& s,
                              ThicknessStrain<R>& thickness) const {
    const R plastic_strain = load_field<R>(history, plastic_strain_field);
    typename Yield::template At<R> yield(hardening, history);
    const YieldStress<R> start = yield(R(0.0));
    const auto plastic = at.effective > start.value;
    if (!any(plastic)) return;
    auto open = plastic;
    Returned<R> r = hardening.template with_unknown<R>(yield, dt, [&](auto& unknown) {
      return newton(unknown, trial, trial, at, range_of(unknown, at.effective, start.value), open);
    });
    for (int l = 0; l < lanes<R>; ++l)
      if (open[l]) set_lane_of(r, l, by_continuation(hardening, lane_of(trial, l), lane(plastic_strain, l), dt));

    // What the return takes from the stress, in the element's axes.
    const R cc = c * c, tt = t * t, ct = c * t;
    const R aa = r.stress.aa - trial.aa, bb = r.stress.bb - trial.bb, ab = r.stress.ab - trial.ab;
    LayerTensor<R> returned = s;
    returned.xx += cc * aa + tt * bb - 2.0 * ct * ab;
    returned.yy += tt * aa + cc * bb + 2.0 * ct * ab;
    returned.xy += ct * (aa - bb) + (cc - tt) * ab;
    s = select(plastic, returned, s);
    const R increment = select(plastic, r.increment, R(0.0));
    store_field(history, plastic_strain_field, plastic_strain + increment);
    const R in_plane = increment * (r.flow.aa + r.flow.bb);
    thickness.total += (elastic_.thinning - 1.0) * in_plane;
    thickness.plastic -= in_plane;
  }

  template <class R>
  static PlaneStress<double> lane_of(const PlaneStress<R>& s, int l) {
    return {lane(s.aa, l), lane(s.bb, l), lane(s.ab, l)};
  }
  template <class R>
  static void set_lane_of(PlaneStress<R>& s, int l, const PlaneStress<double>& one) {
    set_lane(s.aa, l, one.aa);
    set_lane(s.bb, l, one.bb);
    set_lane(s.ab, l, one.ab);
  }
  template <class R>
  static void set_lane_of(Returned<R>& r, int l, const Returned<double>& one) {
    set_lane(r.increment, l, one.increment);
    set_lane_of(r.stress, l, one.stress);
    set_lane_of(r.flow, l, one.flow);
  }

  /// Where the unknown x of a hardening lies, and a first value.
  template <class R, class Unknown>
  Range<R> range_of(Unknown& unknown, const R& trial_stress, const R& start) const {
    const R most = trial_stress * (16.0 / elastic_.E);
    if constexpr (Unknown::is_increment) {
      return {R(0.0), most, R(0.0)};
    } else {
      Range<R> range = unknown.range(BeyondYield<R>{trial_stress, start, most, R(elastic_.E), R(0.0)});
      range.first =
          select(range.first > range.low && range.first < range.high, range.first, 0.5 * (range.low + range.high));
      return range;
    }
  }

  /// Newton's method for stress + e C n(stress) = trial and effective stress = Y, in the stress and the unknown x of
  /// the hardening, by which e and Y go, from `s` and range.first. `open`: lanes that yield; in the end those that did
  /// not converge. A lane that has converged is frozen, so that a batch gives bit for bit what its elements give alone.
  template <class R, class Unknown>
  [[gnu::always_inline]] inline Returned<R> newton(Unknown& unknown, const PlaneStress<R>& trial, PlaneStress<R> s,
                                                   SurfaceAt<R> at, const Range<R>& range, MaskOf<R>& open) const {
    constexpr double tolerance = 1e-11;
    constexpr int limit = 20;
    R x = range.first;
    Returned<R> r;
    for (int i = 0;; ++i) {
      const Trial<R> y = unknown(x);
      const PlaneStress<R> cn = elastic_stress(at.flow);
      const PlaneStress<R> off{s.aa - trial.aa + y.increment * cn.aa, s.bb - trial.bb + y.increment * cn.bb,
                               s.ab - trial.ab + y.increment * cn.ab};
      const R excess = at.effective - y.yield;
      // What is not a number stays open, too.
      const auto there = abs(excess) + abs(off.aa) + abs(off.bb) + abs(off.ab) <= tolerance * y.yield;
      r.increment = select(open, y.increment, r.increment);
      r.unknown = select(open, x, r.unknown);
      r.stress = {select(open, s.aa, r.stress.aa), select(open, s.bb, r.stress.bb), select(open, s.ab, r.stress.ab)};
      r.flow = {select(open, at.flow.aa, r.flow.aa), select(open, at.flow.bb, r.flow.bb),
                select(open, at.flow.ab, r.flow.ab)};
      open = open && !there;
      if (!any(open) || i == limit) return r;

      const InverseOf<R> inverse(*this, at, y.increment);
      const PlaneStress<R> by_off = inverse(off), by_flow = inverse(cn);
      const auto along = [&](const PlaneStress<R>& a) {
        return at.flow.aa * a.aa + at.flow.bb * a.bb + at.flow.ab * a.ab;
      };
      const R next = x + (excess - along(by_off)) / (along(by_flow) * y.increment_slope + y.yield_slope);
      const R held = min(max(next, range.low), range.high), step = (held - x) * y.increment_slope;
      x = select(open, held, x);
      s.aa = select(open, s.aa - by_off.aa - step * by_flow.aa, s.aa);
      s.bb = select(open, s.bb - by_off.bb - step * by_flow.bb, s.bb);
      s.ab = select(open, s.ab - by_off.ab - step * by_flow.ab, s.ab);
      at = surface_(s);
    }
  }

  /// (1 + e C N)^-1, N the curvature of the surface.
  template <class R>
  class InverseOf {
   public:
    InverseOf(const SheetKernel& law, const SurfaceAt<R>& at, const R& e) {
      const PlaneStress<R> a = law.elastic_stress(PlaneStress<R>{e * at.aa_aa, e * at.aa_bb, e * at.aa_ab}),
                           b = law.elastic_stress(PlaneStress<R>{e * at.aa_bb, e * at.bb_bb, e * at.bb_ab}),
                           c = law.elastic_stress(PlaneStress<R>{e * at.aa_ab, e * at.bb_ab, e * at.ab_ab});
      const R aa = 1.0 + a.aa, bb = 1.0 + b.bb, cc = 1.0 + c.ab;
      m_[0] = {bb * cc - c.bb * b.ab, c.aa * b.ab - b.aa * cc, b.aa * c.bb - c.aa * bb};
      m_[1] = {c.bb * a.ab - a.bb * cc, aa * cc - c.aa * a.ab, c.aa * a.bb - aa * c.bb};
      m_[2] = {a.bb * b.ab - bb * a.ab, b.aa * a.ab - aa * b.ab, aa * bb - b.aa * a.bb};
      over_ = 1.0 / (aa * m_[0].aa + b.aa * m_[1].aa + c.aa * m_[2].aa);
    }
    PlaneStress<R> operator()(const PlaneStress<R>& v) const {
      const auto row = [&](int i) { return over_ * (m_[i].aa * v.aa + m_[i].bb * v.bb + m_[i].ab * v.ab); };
      return {row(0), row(1), row(2)};
    }

   private:
    PlaneStress<R> m_[3];
    R over_;
  };

  /// One lane from which Newton's method ran away: the return of trial stresses on the way from the surface at rest to
  /// this one, each from the return of the one before.
  template <class Yield>
  Returned<double> by_continuation(const Yield& hardening, const PlaneStress<double>& trial, double plastic_strain,
                                   double dt) const {
    typename Yield::template At<double> yield(hardening, &plastic_strain);
    const double trial_stress = surface_(trial).effective, start = yield(0.0).value, share = start / trial_stress;
    return hardening.template with_unknown<double>(yield, dt, [&](auto& unknown) {
      Range<double> range = range_of(unknown, trial_stress, start);
      const auto on_the_way = [&](double t) {
        const double part = share + t * (1.0 - share);
        return PlaneStress<double>{part * trial.aa, part * trial.bb, part * trial.ab};
      };
      Returned<double> found{.stress = on_the_way(0.0)};
      range.first = std::max(range.low, std::min(1e-9, range.high));
      double t = 0.0;
      for (double step = 0.125; t < 1.0 && step > 1e-6;) {
        const double next = std::min(1.0, t + step);
        bool open = true;
        const Returned<double> tried =
            newton(unknown, on_the_way(next), found.stress, surface_(found.stress), range, open);
        if (open) {
          step *= 0.25;
          continue;
        }
        found = tried;
        range.first = tried.unknown;
        t = next;
        step *= 2.0;
      }
      return found;
    });
  }

  ElasticConstants elastic_;
  Surface surface_;
  Hardening hardening_;
  MaterialAxes axes_;
  double lowest_;  ///< yield stress below which no point yields [stress]
};

template <>
class LawKernel<AnisotropicSheet> : public SheetKernel<BarlatLianSurface> {
 public:
  explicit LawKernel(const AnisotropicSheet& law) : SheetKernel(law) {}
};
template <>
class LawKernel<Yld2000Sheet> : public SheetKernel<Yld2000Surface> {
 public:
  explicit LawKernel(const Yld2000Sheet& law) : SheetKernel(law) {}
};

}  // namespace nugget::kernel
