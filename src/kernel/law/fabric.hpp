// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/axes_field.hpp"
#include "kernel/law/law_kernel.hpp"

namespace nugget::kernel {

/// Normal and shear components along the axes a, b of a layer: stress [stress], or strain with engineering shear [1].
struct AxesTensor {
  double a = 0.0, b = 0.0, ab = 0.0;
};

/// Moduli of orthotropic plane stress [stress]: stress_a = aa strain_a + ab strain_b, ..., stress_ab = shear strain_ab.
struct SheetModuli {
  double aa = 0.0, bb = 0.0, ab = 0.0, shear = 0.0;

  AxesTensor times(const AxesTensor& strain) const {
    return {aa * strain.a + ab * strain.b, ab * strain.a + bb * strain.b, shear * strain.ab};
  }
};

/// Woven fabric of membranes (MAT_034, FORM 0 and 1): orthotropic elasticity from the total strain, which is the sum of
/// the strain increments in axes that turn with the element: strain_a = stress_a/EA - PRBA stress_b/EB and so on, shear
/// by GAB. Without compression (CSE 1) it wrinkles: see Wrinkling. A liner (LRATIO) is isotropic and carries
/// compression. The thickness stays as it is. Sources: LS-DYNA Keyword Manual and Theory Manual, material 34.
struct Fabric {
  /// Of an isotropic material as stiff as the fastest wave in the plane: for contact, step and hourglass stiffness
  /// [stress], [1].
  double E = 0.0, nu = 0.0;
  double young_a = 0.0, young_b = 0.0;            ///< EA, EB [stress]
  double poisson_ba = 0.0;                        ///< PRBA [1]
  double shear_ab = 0.0;                          ///< GAB [stress]
  bool no_compression = false;                    ///< CSE 1
  double liner_young = 0.0, liner_poisson = 0.0;  ///< EL [stress], PRL [1]
  double liner_share = 0.0;                       ///< LRATIO: of the thickness [1]
  double damping = 0.0;                           ///< DAMP, share of critical damping [1]
  MaterialAxes axes;

  /// Modulus of the fastest wave in the plane of fabric and liner [stress].
  double wave_modulus() const;
  SheetModuli fabric_moduli() const, liner_moduli() const;  ///< times their shares of the thickness
};

/// A sheet that carries no compression: taut, its stress is elastic where that has no principal value below 0; slack,
/// it is 0 where no direction is stretched; else wrinkled, a uniaxial tension along t with the strain that the waves
/// take up, beta n n, across it: of all n and beta >= 0 those of the least elastic energy (A.C. Pipkin, IMA J. Appl.
/// Math. 36, 1986: the relaxed energy of a membrane). What is left of the shear between t and n at the end is below
/// 1e-12 of the stress.
class Wrinkling {
 public:
  explicit Wrinkling(const SheetModuli& moduli);
  /// Stress [stress] for the strain of its plane [1].
  AxesTensor stress(const AxesTensor& strain) const;

  /// A direction in the plane, a unit vector.
  struct Direction {
    double a, b;
  };

 private:
  static constexpr std::size_t tried = 12;  ///< directions over half a turn
  struct Tried {
    double a, b, aa, bb, ab2, over_stiffness;  ///< n, n n, and 1 / C_nnnn
  };
  /// The best direction, where that is less than half a turn / tried from `near`, the best so far: by the secant, and
  /// by halves where that keeps one end.
  Direction within_a_step(const AxesTensor& stress, const Direction& near, double enough) const;

  SheetModuli moduli_;
  std::array<Tried, tried> tried_;
};

/// History of a point: the material axes as of Orthotropic, strain, stress without and with damping, all in these axes.
/// The stress of the point is changed by what these change by, so that a stress it begins with stays beside them.
///
/// The stress of damping is DAMP times the change of the stress in the step (ours; the manuals give no formula): beside
/// the longest stable step it is the share DAMP of critical damping, and it resists nothing that the fabric does not.
template <>
class LawKernel<Fabric> {
 public:
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const Fabric& law);

  int layer_history() const { return damped_field + 3; }
  const MaterialAxes& axes() const { return axes_; }
  /// What damping leaves of the stable step, 4 = (w dt)^2 (1 + 2 DAMP) [1].
  double step_share() const { return step_share_; }

  /// Modulus of the fastest wave where the fabric is stretched: what its tension adds, and, as it keeps its thickness
  /// while its mass is spread out, times its area over that at the start, the exponential of the sum of its strains
  /// [stress].
  template <class R>
  R layer_modulus(const double* history) const {
    constexpr double longest = 8.0;  // beyond which no fabric is
    const R half =
        min(load_field<R>(history, strain_field) + load_field<R>(history, strain_field + 1), R(longest)) * (1.0 / 16.0);
    const R root = (1.0 + half) / (1.0 - half), square = root * root, fourth = square * square;
    const R tension = max(load_field<R>(history, stress_field), load_field<R>(history, stress_field + 1));
    return (wave_modulus_ + max(tension, R(0.0))) * (fourth * fourth);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R c = load_field<R>(history, first_axis_field), t = load_field<R>(history, first_axis_field + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const LayerTensor<R> e = R(dt) * rate;
    const auto advance = [&](int field, const R& change) {
      const R now = load_field<R>(history, field) + change;
      store_field(history, field, now);
      return now;
    };
    const R ea = advance(strain_field, cc * e.xx + tt * e.yy + ct * e.xy),
            eb = advance(strain_field + 1, tt * e.xx + cc * e.yy - ct * e.xy),
            eab = advance(strain_field + 2, 2.0 * ct * (e.yy - e.xx) + (cc - tt) * e.xy);
    std::array<R, 3> now{fabric_.aa * ea + fabric_.ab * eb, fabric_.ab * ea + fabric_.bb * eb, fabric_.shear * eab};
    if (no_compression_) take_compression_out(ea, eb, eab, now);
    if (has_liner_) {
      now[0] += liner_.aa * ea + liner_.ab * eb;
      now[1] += liner_.ab * ea + liner_.bb * eb;
      now[2] += liner_.shear * eab;
    }
    std::array<R, 3> change;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const R elastic_change = now[k] - load_field<R>(history, stress_field + i);
      store_field(history, stress_field + i, now[k]);
      const R damped = now[k] + damping_ * elastic_change;
      change[k] = damped - load_field<R>(history, damped_field + i);
      store_field(history, damped_field + i, damped);
    }
    const auto& [a, b, ab] = change;
    s.xx += cc * a + tt * b - 2.0 * ct * ab;
    s.yy += tt * a + cc * b + 2.0 * ct * ab;
    s.xy += ct * (a - b) + (cc - tt) * ab;
    return {R(0.0), R(0.0)};
  }

 private:
  static constexpr int strain_field = first_axis_field + 2, stress_field = strain_field + 3,
                       damped_field = stress_field + 3;
  /// The stress of the fabric instead of the elastic one, lane by lane.
  template <class R>
  void take_compression_out(const R& ea, const R& eb, const R& eab, std::array<R, 3>& stress) const {
    for (int l = 0; l < lanes<R>; ++l) {
      const AxesTensor left = wrinkling_.stress({lane(ea, l), lane(eb, l), lane(eab, l)});
      set_lane(stress[0], l, left.a);
      set_lane(stress[1], l, left.b);
      set_lane(stress[2], l, left.ab);
    }
  }

  MaterialAxes axes_;
  SheetModuli fabric_, liner_;  ///< times their shares of the thickness
  Wrinkling wrinkling_;
  bool no_compression_, has_liner_;
  double damping_, step_share_, wave_modulus_;
};

}  // namespace nugget::kernel
