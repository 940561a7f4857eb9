// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "kernel/law/axes_field.hpp"
#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/law_kernel.hpp"

namespace nugget::kernel {

/// Orthotropic linear elasticity in rate form (MAT_002): strain_a = stress_a/EA - PRBA stress_b/EB - PRCA stress_c/EC
/// and so on, shears by GAB, GBC, GCA.
struct Orthotropic {
  /// Of an isotropic material as stiff as the stiffest direction of a layer, E / (1 - nu^2) = EA or EB / (1 - PRBA
  /// PRAB): for contact, hourglass and drilling stiffness [stress], [1].
  double E = 0.0, nu = 0.0;
  double young_a = 0.0, young_b = 0.0, young_c = 0.0;           ///< EA, EB, EC [stress]
  double poisson_ba = 0.0, poisson_ca = 0.0, poisson_cb = 0.0;  ///< PRBA, PRCA, PRCB [1]
  double shear_ab = 0.0, shear_bc = 0.0, shear_ca = 0.0;        ///< GAB, GBC, GCA [stress]
  MaterialAxes axes;

  /// Determinant of the compliance of the normal stresses times EA EB EC: above 0 with those of its parts, or the
  /// material would give energy.
  double definiteness() const;
  /// Sets E and nu.
  void take_isotropic_constants();
};

/// Modulus of the fastest plane wave [stress] in a material whose normal stresses follow the normal strains by `normal`
/// and whose shears are uncoupled, sought over the directions.
double fastest_wave_modulus(const std::array<std::array<double, 3>, 3>& normal, double shear_ab, double shear_bc,
                            double shear_ca);

/// History of a point: the material axes: of a layer, cosine and sine of the angle from the
/// element's axis to a; of a solid, a and b in global axes.
template <>
class LawKernel<Orthotropic> {
 public:
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const Orthotropic& law);

  int layer_history() const { return first_axis_field + 2; }
  int solid_history() const { return first_axis_field + 6; }
  const MaterialAxes& axes() const { return axes_; }

  template <class R>
  R wave_modulus(const double*) const {
    return R(wave_modulus_);
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R c = load_field<R>(history, first_axis_field), t = load_field<R>(history, first_axis_field + 1);
    const R cc = c * c, tt = t * t, ct = c * t;
    const LayerTensor<R> e = R(dt) * rate;
    const R ea = cc * e.xx + tt * e.yy + ct * e.xy, eb = tt * e.xx + cc * e.yy - ct * e.xy;
    const R a = layer_aa_ * ea + layer_ab_ * eb, b = layer_ab_ * ea + layer_bb_ * eb;
    const R ab = shear_ab_ * (2.0 * ct * (e.yy - e.xx) + (cc - tt) * e.xy);
    const R az = shear_ca_ * (c * e.xz + t * e.yz), bz = shear_bc_ * (c * e.yz - t * e.xz);
    s.xx += cc * a + tt * b - 2.0 * ct * ab;
    s.yy += tt * a + cc * b + 2.0 * ct * ab;
    s.xy += ct * (a - b) + (cc - tt) * ab;
    s.xz += c * az - t * bz;
    s.yz += t * az + c * bz;
    return {thinning_a_ * a + thinning_b_ * b, R(0.0)};
  }

  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const Frame<R> axes = load_solid_axes<R>(history);
    const SolidTensor<R> e = strain_in_axes(axes, rate, dt);
    const auto normal = [&](int i) { return solid_[i][0] * e.xx + solid_[i][1] * e.yy + solid_[i][2] * e.zz; };
    const SolidTensor<R> change{
        normal(0), normal(1), normal(2), 2.0 * shear_ab_ * e.xy, 2.0 * shear_bc_ * e.yz, 2.0 * shear_ca_ * e.zx};
    s = s + out_of_axes(axes, change);
  }
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    turn_solid_axes(q, history);
  }

 private:
  MaterialAxes axes_;
  double layer_aa_, layer_ab_, layer_bb_;  // plane stress
  double thinning_a_, thinning_b_;         // strain through the thickness over the stresses
  std::array<std::array<double, 3>, 3> solid_;
  double shear_ab_, shear_bc_, shear_ca_;
  double wave_modulus_;  // of the fastest plane wave
};

}  // namespace nugget::kernel
