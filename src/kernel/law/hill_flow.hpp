// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "base/elementary.hpp"
#include "kernel/law/axes_field.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_return.hpp"

namespace nugget::kernel {

/// Anisotropic yield (R. Hill, Proc. R. Soc. A 193, 1948) in the material axes a, b, c,
///   Y^2 = F (sbb - scc)^2 + G (scc - saa)^2 + H (saa - sbb)^2 + 2 L sbc^2 + 2 M sca^2 + 2 N sab^2,
/// of s less the back stress: a sum of terms that each go by da = C (Q (s - a) / Y - a) de (F. Armstrong and C.
/// Frederick, CEGB report RD/B/N731, 1966, in the direction of H. Ziegler, Quart. Appl. Math. 17, 1959), so that in
/// every proportional loading the effective stress is that of the hardening and Q (1 - exp(-C e)).
struct HillAnisotropy {
  std::array<double, 3> ratios{1.0, 1.0, 1.0};  ///< of Lankford, of layers: R00 R45 R90; their 2 L and 2 M are 3 [1]
  std::array<double, 6> constants{0.5, 0.5, 0.5, 1.5, 1.5, 1.5};  ///< of solids: F G H L M N [1]
  std::array<double, 2> back_stress{};                            ///< Q of the terms [stress]
  std::array<double, 2> back_exponent{};                          ///< C of the terms [1]
  std::optional<PiecewiseLinear> curves{};  ///< in place of the law's formula: their yield and rates
  MaterialAxes axes{};

  /// F G H L M N of layers, by their ratios.
  std::array<double, 6> of_layers() const {
    const double G = 1.0 / (1.0 + ratios[0]), H = ratios[0] * G, F = H / ratios[2];
    return {F, G, H, 1.5, 1.5, (F + G) * (ratios[1] + 0.5)};
  }
  /// Whether every stress but a pressure has an effective stress above 0.
  static bool is_convex(const std::array<double, 6>& c) {
    const auto [F, G, H, L, M, N] = c;
    return F + G > 0.0 && G + H > 0.0 && H + F > 0.0 && F * G + G * H + H * F > 0.0 && L > 0.0 && M > 0.0 && N > 0.0;
  }
};

/// The quadratic surface in the five directions of stress in which the elastic answer to a plastic flow stays where it
/// is: with coordinates y the effective stress is |y|, and flow by an increment e takes (e / Y) modulus y of each.
class HillModes {
 public:
  static constexpr int count = 5;
  template <class R>
  using Modal = std::array<R, count>;

  /// Of plane stress.
  static HillModes of_layers(const std::array<double, 6>& constants, const ElasticConstants& elastic);
  static HillModes of_solids(const std::array<double, 6>& constants, const ElasticConstants& elastic);

  const Modal<double>& modulus() const { return modulus_; }
  double least_modulus() const { return least_; }

  /// Coordinates of a stress in material axes; `c`: 0 in layers.
  template <class R>
  Modal<R> of(const R& a, const R& b, const R& c, const R& ab, const R& bc, const R& ca) const {
    Modal<R> y;
    for (int i = 0; i < 2; ++i) y[i] = to_[i][0] * a + to_[i][1] * b + to_[i][2] * c;
    y[2] = shear_[0] * ab;
    y[3] = shear_[1] * bc;
    y[4] = shear_[2] * ca;
    return y;
  }
  /// Normal stress `axis` of coordinates, and shear `which` of ab, bc, ca.
  template <class R>
  R normal(const Modal<R>& y, int axis) const {
    return from_[0][axis] * y[0] + from_[1][axis] * y[1];
  }
  template <class R>
  R shear(const Modal<R>& y, int which) const {
    return (1.0 / shear_[which]) * y[2 + which];
  }
  /// Plastic strain in the plane of a layer, aa + bb, over e / Y.
  template <class R>
  R in_plane(const Modal<R>& y) const {
    return in_plane_[0] * y[0] + in_plane_[1] * y[1];
  }

 private:
  HillModes(const std::array<double, 6>& constants, double shear);

  double to_[2][3]{}, from_[2][3]{}, in_plane_[2]{};
  double shear_[3]{};
  Modal<double> modulus_{};  // [stress]
  double least_ = 0.0;       // of them
};

/// Where a return to the surface ends.
template <class R>
struct HillReturn {
  R increment{}, yield{};
  HillModes::Modal<R> relative{}, change{};  ///< stress less back stress; what the return changes of the stress
};

/// A point's flow to the surface. History of a point: effective plastic strain, material axes, then the coordinates of
/// the terms of the back stress.
class HillFlow {
 public:
  using Modes = HillModes;
  template <class R>
  using Modal = HillModes::Modal<R>;

  HillFlow(const HillAnisotropy& law, const ElasticConstants& elastic);

  int layer_history() const { return first_axis_field + 2 + terms_ * Modes::count; }
  int solid_history() const { return first_axis_field + 6 + terms_ * Modes::count; }
  const MaterialAxes& axes() const { return axes_; }

  /// Adds a step of strain rate to a layer's stress.
  template <class R, class Hardening>
  ThicknessStrain<R> layer(const Hardening& hardening, LayerTensor<R>& s, const LayerTensor<R>& rate, double dt,
                           double* history) const {
    const LayerTensor<R> strain = R(dt) * rate;
    elastic_.add(s, strain);
    ThicknessStrain<R> thickness{-elastic_.thinning * (strain.xx + strain.yy), R(0.0)};
    const R c = load_field<R>(history, first_axis_field), t = load_field<R>(history, first_axis_field + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const Modal<R> trial =
        layers_.of(R(cc * s.xx + tt * s.yy + 2.0 * ct * s.xy), R(tt * s.xx + cc * s.yy - 2.0 * ct * s.xy), R(0.0),
                   R(ct * (s.yy - s.xx) + (cc - tt) * s.xy), R(c * s.yz - t * s.xz), R(c * s.xz + t * s.yz));
    double* back = history + (first_axis_field + 2) * lanes<R>;
    if (!may_flow(hardening, trial, back)) return thickness;
    const HillReturn<R> r = flow(hardening, layers_, trial, history, back, dt);
    const R aa = layers_.normal(r.change, 0), bb = layers_.normal(r.change, 1), ab = layers_.shear(r.change, 0),
            bz = layers_.shear(r.change, 1), az = layers_.shear(r.change, 2);
    s.xx += cc * aa + tt * bb - 2.0 * ct * ab;
    s.yy += tt * aa + cc * bb + 2.0 * ct * ab;
    s.xy += ct * (aa - bb) + (cc - tt) * ab;
    s.xz += c * az - t * bz;
    s.yz += t * az + c * bz;
    const R in_plane = (r.increment / r.yield) * layers_.in_plane(r.relative);
    thickness.total += (elastic_.thinning - 1.0) * in_plane;
    thickness.plastic -= in_plane;
    return thickness;
  }

  template <class R, class Hardening>
  void solid(const Hardening& hardening, SolidTensor<R>& s, const SolidTensor<R>& rate, double dt,
             double* history) const {
    elastic_.add(s, R(dt) * rate);
    const Frame<R> axes = load_solid_axes<R>(history);
    const SolidTensor<R> m = rotated(axes, s);
    const Modal<R> trial = solids_.of(m.xx, m.yy, m.zz, m.xy, m.yz, m.zx);
    double* back = history + (first_axis_field + 6) * lanes<R>;
    if (!may_flow(hardening, trial, back)) return;
    const HillReturn<R> r = flow(hardening, solids_, trial, history, back, dt);
    s = s + out_of_axes(axes, SolidTensor<R>{solids_.normal(r.change, 0), solids_.normal(r.change, 1),
                                             solids_.normal(r.change, 2), solids_.shear(r.change, 0),
                                             solids_.shear(r.change, 1), solids_.shear(r.change, 2)});
  }

 private:
  /// Effective trial stress, squared.
  template <class R>
  R square(const Modal<R>& trial, const double* back) const {
    R sum = R(0.0);
    for (int i = 0; i < Modes::count; ++i) {
      R y = trial[i];
      for (int k = 0; k < terms_; ++k) y -= load_field<R>(back, k * Modes::count + i);
      sum += y * y;
    }
    return sum;
  }
  template <class R, class Hardening>
  bool may_flow(const Hardening& hardening, const Modal<R>& trial, const double* back) const {
    const double lowest = hardening.lowest();
    return any(square(trial, back) > R(lowest * lowest));
  }

  template <class R, class Hardening>
  [[gnu::noinline]] HillReturn<R> flow(const Hardening& hardening, const Modes& modes, const Modal<R>& trial,
                                       double* history, double* back, double dt) const {
    const R plastic_strain = load_field<R>(history, plastic_strain_field), trial2 = square(trial, back);
    typename Hardening::template At<R> yield(hardening, history);
    const YieldStress<R> start = yield(R(0.0));
    const auto plastic = trial2 > start.value * start.value;
    HillReturn<R> r;
    r.yield = R(1.0);
    if (!any(plastic)) return r;
    r = hardening.template with_unknown<R>(
        yield, dt, [&](auto& unknown) { return solved(unknown, modes, trial, trial2, start, back, plastic); });
    r.increment = select(plastic, r.increment, R(0.0));
    Modal<R> stress = r.relative;
    for (int k = 0; k < terms_; ++k) {
      const R left = exponential(-exponent_[k] * r.increment), grown = (stress_[k] * (1.0 - left)) / r.yield;
      for (int i = 0; i < Modes::count; ++i) {
        const R old = load_field<R>(back, k * Modes::count + i), now = left * old + grown * r.relative[i];
        store_field(back, k * Modes::count + i, select(plastic, now, old));
        stress[i] += now;
      }
    }
    for (int i = 0; i < Modes::count; ++i) {
      r.change[i] = select(plastic, stress[i] - trial[i], R(0.0));
      r.relative[i] = select(plastic, r.relative[i], R(0.0));
    }
    r.yield = select(plastic, r.yield, R(1.0));
    store_field(history, plastic_strain_field, plastic_strain + r.increment);
    return r;
  }

  /// The increment e with sum_i (trial_i - back_i(e))^2 / (Y + g(e) + modulus_i e)^2 = 1, where back(e) is what is left
  /// of the back stress, and g(e) what it gains over the direction: by Newton's method on the root of the sum, kept
  /// inside a bracket. A lane that has converged is frozen, so that a batch gives bit for bit what its lanes give
  /// alone.
  template <class R, class Unknown>
  [[gnu::always_inline]] inline HillReturn<R> solved(Unknown& unknown, const Modes& modes, const Modal<R>& trial,
                                                     const R& trial2, const YieldStress<R>& start, const double* back,
                                                     MaskOf<R> active) const {
    constexpr double tolerance = 4e-12;
    constexpr int limit = 100;
    Modal<R> old[2];
    R farthest = R(0.0), gain = R(0.0);
    for (int i = 0; i < Modes::count; ++i) {
      R most = abs(trial[i]);
      for (int k = 0; k < terms_; ++k) {
        old[k][i] = load_field<R>(back, k * Modes::count + i);
        most += abs(old[k][i]);
      }
      farthest += most * most;
    }
    for (int k = 0; k < terms_; ++k) gain += R(stress_[k] * exponent_[k]);
    const R effective = sqrt(trial2), most = (1.0 / modes.least_modulus()) * sqrt(farthest);
    R middle = R(0.0);
    for (int i = 0; i < Modes::count; ++i) {
      R y = trial[i];
      for (int k = 0; k < terms_; ++k) y -= old[k][i];
      middle += modes.modulus()[i] * (y * y);
    }
    middle = middle / trial2;
    R low, high, next;
    if constexpr (Unknown::is_increment) {
      low = R(0.0);
      high = most;
      next = (effective - start.value) / (start.slope + middle + gain);
    } else {
      const auto range = unknown.range(BeyondYield<R>{effective, start.value, most, middle + gain, R(0.0)});
      low = range.low;
      high = range.high;
      next = range.first;
    }
    next = select(next > low && next < high, next, 0.5 * (low + high));
    R x = Unknown::is_increment ? select(active, next, low) : next, last = high - low;
    HillReturn<R> r;
    for (int n = 0;; ++n) {
      const Trial<R> y = unknown(x);
      R gained = y.yield, slope = y.yield_slope;
      R left[2], lost[2];
      for (int k = 0; k < terms_; ++k) {
        left[k] = exponential(-exponent_[k] * y.increment);
        lost[k] = (exponent_[k] * left[k]) * y.increment_slope;
        gained += stress_[k] * (1.0 - left[k]);
        slope += stress_[k] * lost[k];
      }
      R sum = R(0.0), half_slope = R(0.0);
      Modal<R> share;
      for (int i = 0; i < Modes::count; ++i) {
        R part = trial[i], part_slope = R(0.0);
        for (int k = 0; k < terms_; ++k) {
          part -= left[k] * old[k][i];
          part_slope += lost[k] * old[k][i];
        }
        const double m = modes.modulus()[i];
        const R over = 1.0 / (gained + m * y.increment);
        share[i] = over * part;
        sum += share[i] * share[i];
        half_slope += share[i] * over * (part_slope - share[i] * (slope + m * y.increment_slope));
      }
      r.increment = select(active, y.increment, r.increment);
      r.yield = select(active, y.yield, r.yield);
      for (int i = 0; i < Modes::count; ++i) r.relative[i] = select(active, y.yield * share[i], r.relative[i]);
      active = active && abs(sum - 1.0) > tolerance;
      if (!any(active) || n == limit) return r;
      const auto short_of = sum > 1.0;
      low = select(short_of, x, low);
      high = select(short_of, high, x);
      next = x + sum * (1.0 - sqrt(sum)) / half_slope;
      // Where the rate is a high power of x, Newton's steps from far off hardly get smaller.
      const auto gets_on = next > low && next < high && abs(next - x) < 0.5 * last;
      next = select(gets_on, next, 0.5 * (low + high));
      last = abs(next - x);
      x = select(active, next, x);
    }
  }

  ElasticConstants elastic_;
  Modes layers_, solids_;
  std::array<double, 2> stress_{}, exponent_{};  // of the back stress
  int terms_ = 0;
  MaterialAxes axes_;
};

}  // namespace nugget::kernel
