// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/law_kernel.hpp"

namespace nugget::kernel {

/// A viscous fluid (MAT_009 in solids), whose pressure is that of an equation of state: deviators are 2 MU times those
/// of the strain rate, and nothing resists a change of shape at rest.
struct Fluid {
  // Elastic constants of the fluid's bulk modulus, for contact and for the first guess of a stable step; its stress is
  // not made of them.
  double E = 0.0;          ///< [stress]
  double nu = 0.49;        ///< as near to a fluid's as contact takes it [1]
  double viscosity = 0.0;  ///< MU [stress time]

  void set_bulk_modulus(double K) { E = 3.0 * K * (1.0 - 2.0 * nu); }
};

/// History of a point: the last step.
template <>
class LawKernel<Fluid> {
 public:
  explicit LawKernel(const Fluid& law) : viscosity_(law.viscosity) {}

  static constexpr bool has_plastic_strain = false;
  static constexpr int solid_history() { return step_field + 1; }

  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const R mean = (1.0 / 3.0) * (rate.xx + rate.yy + rate.zz);
    const double twice = 2.0 * viscosity_;
    s = {twice * (rate.xx - mean), twice * (rate.yy - mean), twice * (rate.zz - mean),
         viscosity_ * rate.xy,     viscosity_ * rate.yz,     viscosity_ * rate.zx};
    store_field(history, step_field, R(dt));
  }
  /// The modulus of an elastic solid of the same stable step: with velocities of half a step before, a dashpot C is as
  /// stable as a spring 2 C/dt would be.
  template <class R>
  R shear_wave_modulus(const double* history) const {
    const R dt = load_field<R>(history, step_field);
    return select(dt > 0.0, (8.0 / 3.0) * viscosity_ / select(dt > 0.0, dt, R(1.0)), R(0.0));
  }

  template <class R>
  R wave_modulus(const double* history) const {
    return shear_wave_modulus<R>(history);
  }

 private:
  static constexpr int step_field = first_own_field;
  double viscosity_;
};

}  // namespace nugget::kernel
