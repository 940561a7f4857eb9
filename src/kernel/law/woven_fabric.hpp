// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "kernel/law/fabric.hpp"
#include "kernel/law/thread_curve.hpp"

namespace nugget::kernel {

/// Woven fabric of membranes by Green's strain (MAT_034, FORM 12 and 14): the second Piola-Kirchhoff stress S along the
/// two threads and between them by the strain E of these, whatever angle they come to have. Without curves it is
/// linear as that of Fabric, wrinkles as that does, and has its liner; with curves (FORM 14) the threads are not
/// coupled: S_a by E_a, S_b by E_b, S_ab by 2 E_ab, each by its curve, or by its modulus where it has none, and
/// without compression (CSE 1) a thread that is shorter than at the start has no stress. The thickness stays as it is.
/// Source: LS-DYNA Keyword Manual, material 34; docs/theory/membrane.md#greens-strain.
struct WovenFabric : Fabric {
  bool by_curves = false;
  /// With `by_curves`: along a, along b, of the shear; nothing: by its modulus.
  std::array<std::optional<ThreadCurve>, 3> curves;

  double wave_modulus() const;  ///< as that of Fabric, by the steepest slopes [stress]
};

/// History of a point: the material axes at the start, in axes that turn with the element; what the gradient of
/// deformation has more than 1, in these; by how fast the material turns beside these; the largest strains so far; S
/// without damping; Cauchy's stress. The stress of the point is changed by what the last changes by, so that a stress
/// it begins with stays beside it. Damping as that of Fabric.
template <>
class LawKernel<WovenFabric> {
 public:
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const WovenFabric& law);

  int layer_history() const { return stress_field + 3; }
  const MaterialAxes& axes() const { return axes_; }
  double step_share() const { return step_share_; }
  /// Where the element writes by how fast the material turns in its plane beside the element's axes, from x to y
  /// [1/time].
  int spin_field() const { return own_spin_field; }

  /// Modulus of the fastest wave, at most: with the largest stretch l, l^2 (S + l^2 C) [stress].
  template <class R>
  R layer_modulus(const double* history) const {
    const R xx = R(1.0) + load_field<R>(history, gradient_field), xy = load_field<R>(history, gradient_field + 1),
            yx = load_field<R>(history, gradient_field + 2), yy = R(1.0) + load_field<R>(history, gradient_field + 3);
    const R half = 0.5 * (xx * xx + xy * xy + yx * yx + yy * yy), area = xx * yy - xy * yx;
    const R square = max(half + sqrt(max(half * half - area * area, R(0.0))), R(1.0));
    const R s = max(max(load_field<R>(history, elastic_field), load_field<R>(history, elastic_field + 1)), R(0.0)) +
                abs(load_field<R>(history, elastic_field + 2));
    return square * (s + square * wave_modulus_);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const auto get = [&](int field) { return load_field<R>(history, field); };
    // The gradient by the rule of the midpoint: (1 - dt/2 L) dF = dt L F.
    const R spin = get(own_spin_field);
    const R lxx = R(dt) * rate.xx, lyy = R(dt) * rate.yy, lxy = R(dt) * (0.5 * rate.xy - spin),
            lyx = R(dt) * (0.5 * rate.xy + spin);
    R gxx = get(gradient_field), gxy = get(gradient_field + 1), gyx = get(gradient_field + 2),
      gyy = get(gradient_field + 3);
    const R mxx = R(1.0) - 0.5 * lxx, myy = R(1.0) - 0.5 * lyy, mxy = -0.5 * lxy, myx = -0.5 * lyx;
    const R over = 1.0 / (mxx * myy - mxy * myx);
    const R fxx = R(1.0) + gxx, fyy = R(1.0) + gyy;
    const auto advance = [&](R& first, R& second, const R& x, const R& y) {  // a column of F
      const R p = lxx * x + lxy * y, q = lyx * x + lyy * y;
      first += over * (myy * p - mxy * q);
      second += over * (mxx * q - myx * p);
    };
    advance(gxx, gyx, fxx, gyx);
    advance(gxy, gyy, gxy, fyy);
    store_field(history, gradient_field, gxx);
    store_field(history, gradient_field + 1, gxy);
    store_field(history, gradient_field + 2, gyx);
    store_field(history, gradient_field + 3, gyy);

    const R c = get(first_axis_field), t = get(first_axis_field + 1);
    const R ga_x = gxx * c + gxy * t, ga_y = gyx * c + gyy * t, gb_x = gxy * c - gxx * t, gb_y = gyy * c - gyx * t;
    const R ax = c + ga_x, ay = t + ga_y, bx = gb_x - t, by = c + gb_y;  // the threads
    const R ea = c * ga_x + t * ga_y + 0.5 * (ga_x * ga_x + ga_y * ga_y),
            eb = c * gb_y - t * gb_x + 0.5 * (gb_x * gb_x + gb_y * gb_y), eab = ax * bx + ay * by;
    std::array<R, 3> now = by_curves_ ? by_curves(ea, eb, eab, history) : linear(ea, eb, eab);
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const R change = now[k] - get(elastic_field + i);
      store_field(history, elastic_field + i, now[k]);
      now[k] += damping_ * change;
    }
    const R over_area = 1.0 / ((R(1.0) + gxx) * (R(1.0) + gyy) - gxy * gyx);
    const auto& [sa, sb, sab] = now;
    const R shear = sab * over_area, along_a = sa * over_area, along_b = sb * over_area;
    const auto change_to = [&](int field, R& stress, const R& value) {
      stress += value - get(field);
      store_field(history, field, value);
    };
    change_to(stress_field, s.xx, along_a * (ax * ax) + along_b * (bx * bx) + shear * (2.0 * (ax * bx)));
    change_to(stress_field + 1, s.yy, along_a * (ay * ay) + along_b * (by * by) + shear * (2.0 * (ay * by)));
    change_to(stress_field + 2, s.xy, along_a * (ax * ay) + along_b * (bx * by) + shear * (ax * by + ay * bx));
    return {R(0.0), R(0.0)};
  }

 private:
  static constexpr int gradient_field = first_axis_field + 2, own_spin_field = gradient_field + 4,
                       largest_field = own_spin_field + 1, elastic_field = largest_field + 3,
                       stress_field = elastic_field + 3;

  template <class R>
  std::array<R, 3> linear(const R& ea, const R& eb, const R& eab) const {
    std::array<R, 3> s{fabric_.aa * ea + fabric_.ab * eb, fabric_.ab * ea + fabric_.bb * eb, fabric_.shear * eab};
    if (no_compression_)
      for (int l = 0; l < lanes<R>; ++l) {
        const AxesTensor left = wrinkling_.stress({lane(ea, l), lane(eb, l), lane(eab, l)});
        set_lane(s[0], l, left.a);
        set_lane(s[1], l, left.b);
        set_lane(s[2], l, left.ab);
      }
    add_liner(ea, eb, eab, s);
    return s;
  }
  template <class R>
  std::array<R, 3> by_curves(const R& ea, const R& eb, const R& eab, double* history) const {
    std::array<R, 3> s;
    const std::array<R, 3> strain{ea, eb, abs(eab)};
    for (std::size_t k = 0; k < 3; ++k) {
      const int field = largest_field + static_cast<int>(k);
      const R largest = max(load_field<R>(history, field), strain[k]);
      store_field(history, field, largest);
      for (int l = 0; l < lanes<R>; ++l) {
        const double e = lane(strain[k], l);
        const double stress = share_ * (curves_[k] ? curves_[k]->stress(e, lane(largest, l)) : moduli_[k] * e);
        set_lane(s[k], l, k < 2 && no_compression_ && stress < 0.0 ? 0.0 : stress);
      }
    }
    s[2] = select(eab < R(0.0), -s[2], s[2]);
    add_liner(ea, eb, eab, s);
    return s;
  }
  template <class R>
  void add_liner(const R& ea, const R& eb, const R& eab, std::array<R, 3>& s) const {
    if (!has_liner_) return;
    s[0] += liner_.aa * ea + liner_.ab * eb;
    s[1] += liner_.ab * ea + liner_.bb * eb;
    s[2] += liner_.shear * eab;
  }

  MaterialAxes axes_;
  SheetModuli fabric_, liner_;  ///< times their shares of the thickness
  Wrinkling wrinkling_;
  std::array<std::optional<ThreadCurve>, 3> curves_;
  std::array<double, 3> moduli_;  ///< EA, EB, GAB
  double share_;                  ///< of the fabric in the thickness
  bool no_compression_, has_liner_, by_curves_;
  double damping_, step_share_, wave_modulus_;
};

}  // namespace nugget::kernel
