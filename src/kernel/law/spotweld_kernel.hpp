// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "kernel/law/j2.hpp"
#include "kernel/law/spotweld.hpp"

namespace nugget::kernel {

/// MAT_100. History of a point: plastic strain, yield stress at which it is frozen, time since its damage began, and
/// the stress of the undamaged point, which the J2 return works on while the element gets the damaged one.
template <>
class LawKernel<Spotweld> : public J2<WeldHardening, false> {
  using Base = J2<WeldHardening, false>;

 public:
  static constexpr int frozen_yield_field = WeldHardening::frozen_yield_field,
                       damage_time_field = frozen_yield_field + 1, undamaged_stress_field = damage_time_field + 1;
  static constexpr int solid_history() { return undamaged_stress_field + SolidTensor<double>::size; }
  static constexpr int fibre_history() { return undamaged_stress_field + FibreTensor<double>::size; }

  explicit LawKernel(const Spotweld& law)
      : Base(law.E, law.nu, WeldHardening(law),
             law.damage.growth == PointDamage::Growth::none ? law.failure_strain : 0.0),
        damage_(law.damage),
        onset_(law.failure_strain),
        uniaxial_(law.uniaxial) {}

  double deletion_step() const { return 0.0; }
  /// Whether bricks have no other stresses than those on the weld's cross-section: they call section(), not solid().
  bool uniaxial() const { return uniaxial_; }

  bool can_fail() const { return damages() || Base::can_fail(); }
  template <class R>
  MaskOf<R> failed(const double* history) const {
    if (!damages()) return Base::failed<R>(history);
    return load_field<R>(history, grows_in_time() ? damage_time_field : plastic_strain_field) >= R(damage_.rupture);
  }
  /// What is left of the stress of an undamaged point.
  template <class R>
  [[gnu::always_inline]] inline R integrity(const double* history) const {
    if (!damages()) return R(1.0);
    const R w = grows_in_time()
                    ? (1.0 / damage_.rupture) * load_field<R>(history, damage_time_field)
                    : (1.0 / (damage_.rupture - onset_)) * (load_field<R>(history, plastic_strain_field) - onset_);
    const R grown = max(w, R(0.0));
    const R left =
        damage_.beta == 0.0 ? R(1.0) - grown : map([&](double g) { return std::exp(-damage_.beta * g); }, grown);
    return select(failed<R>(history), R(0.0), left);
  }

  template <class R>
  [[gnu::always_inline]] inline void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt,
                                           double* history) const {
    if (!damages()) return Base::solid(s, rate, dt, history);
    SolidTensor<R> undamaged = load_solid<R>(history + undamaged_stress_field * lanes<R>);
    Base::solid(undamaged, rate, dt, history);
    store_solid(history + undamaged_stress_field * lanes<R>, undamaged);
    advance_damage_time<R>(dt, history);
    s = integrity<R>(history) * undamaged;
  }
  template <class R>
  [[gnu::always_inline]] inline void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt,
                                           double* history) const {
    if (!damages()) return Base::fibre(s, rate, dt, history);
    s = section(rate, dt, history);
  }
  /// The same for a point that keeps its stress in its history only.
  template <class R>
  [[gnu::always_inline]] inline FibreTensor<R> section(const FibreTensor<R>& rate, double dt, double* history) const {
    FibreTensor<R> undamaged = load_fibre<R>(history + undamaged_stress_field * lanes<R>);
    Base::fibre(undamaged, rate, dt, history);
    store_fibre(history + undamaged_stress_field * lanes<R>, undamaged);
    advance_damage_time<R>(dt, history);
    return integrity<R>(history) * undamaged;
  }
  /// Stress at which the yield stress of a point of the effective stress given is frozen: its own, but not so low that
  /// the return to the yield surface loses its digits (nor 0, which would say: not frozen).
  double frozen_stress(double effective) const { return std::max(effective, 1e-6 * elastic().E); }
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    double* undamaged = history + undamaged_stress_field * lanes<R>;
    if (damages() && !uniaxial_) store_solid(undamaged, rotated(q, load_solid<R>(undamaged)));
  }

 private:
  bool damages() const { return damage_.growth != PointDamage::Growth::none; }
  bool grows_in_time() const { return damage_.growth == PointDamage::Growth::time; }
  template <class R>
  void advance_damage_time(double dt, double* history) const {
    if (!grows_in_time()) return;
    const auto begun = load_field<R>(history, plastic_strain_field) > R(onset_);
    store_field(history, damage_time_field, load_field<R>(history, damage_time_field) + select(begun, R(dt), R(0.0)));
  }

  PointDamage damage_;
  double onset_;
  bool uniaxial_;
};

}  // namespace nugget::kernel
