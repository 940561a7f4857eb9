// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/j2.hpp"
#include "kernel/law/smooth_hardening.hpp"

namespace nugget::kernel {

/// A metal with isotropic hardening that plastic work may heat. History of a point: plastic strain and, where work
/// heats it, its temperature rise, which ends at `melting_rise`.
template <class Hardening>
class HeatedMetal : public J2<Hardening, false> {
  using Base = J2<Hardening, false>;

 public:
  /// `heating`: rise of temperature a work [temperature/stress]; 0: none.
  template <class Law>
  HeatedMetal(const Law& law, double heating, double melting_rise)
      : Base(law.E, law.nu, Hardening(law), 0.0), heating_(heating), melting_rise_(melting_rise) {}

  int layer_history() const { return heats() ? temperature_rise_field + 1 : Base::layer_history(); }
  int solid_history() const { return layer_history(); }
  int fibre_history() const { return layer_history(); }
  bool heats() const { return heating_ > 0.0; }
  int temperature_field() const { return heats() ? temperature_rise_field : 0; }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R before = load_field<R>(history, plastic_strain_field);
    ThicknessStrain<R> thickness = Base::layer(s, rate, dt, history);
    if (heats())
      heat(sqrt(s.xx * s.xx + s.yy * s.yy - s.xx * s.yy + 3.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz)), before,
           history);
    return thickness;
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const R before = load_field<R>(history, plastic_strain_field);
    Base::solid(s, rate, dt, history);
    if (!heats()) return;
    const R xy = s.xx - s.yy, yz = s.yy - s.zz, zx = s.zz - s.xx;
    heat(sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx)), before, history);
  }
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double* history) const {
    const R before = load_field<R>(history, plastic_strain_field);
    Base::fibre(s, rate, dt, history);
    if (heats()) heat(sqrt(s.rr * s.rr + 3.0 * (s.rs * s.rs + s.rt * s.rt)), before, history);
  }

 private:
  template <class R>
  void heat(const R& effective, const R& before, double* history) const {
    const R rise = load_field<R>(history, temperature_rise_field) +
                   heating_ * effective * (load_field<R>(history, plastic_strain_field) - before);
    store_field(history, temperature_rise_field, min(rise, R(melting_rise_)));
  }

  double heating_, melting_rise_;
};

}  // namespace nugget::kernel
