// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/elastic.hpp"
#include "kernel/law/j2.hpp"
#include "kernel/law/piecewise_linear.hpp"
#include "kernel/law/plastic_kinematic.hpp"
#include "kernel/law/spotweld.hpp"

namespace nugget::kernel {

/// A law made ready for the kernels: moduli, look-up tables. Made once from the parameters, then only read (by any
/// number of threads).
///   elastic()                               elastic constants
///   layer_history(), solid_history(), fibre_history()   numbers of history a point needs in each stress space, beside
///                                           its stress
///   has_plastic_strain                      the first number of the history is the effective plastic strain
///   layer(), solid(), fibre()               add a step of strain rate to a stress
///   wave_modulus()                          of a solid point as it is, for the stable step [stress]
///   rotate()                                turns a solid point's history with the material
///   can_fail(), failed()                    whether, and which, points have failed (their stress is 0)
///   points_to_delete()                      failed points that delete an element, as in ComposedLaw; 0: all
///   deletion_step()                         an element whose stable time step falls below is deleted; 0: never
template <class Law>
class LawKernel;

template <>
class LawKernel<Elastic> {
 public:
  static constexpr int layer_history() { return 0; }
  static constexpr int solid_history() { return 0; }
  static constexpr int fibre_history() { return 0; }
  static constexpr bool has_plastic_strain = false;

  explicit LawKernel(const Elastic& law) : elastic_(law.E, law.nu) {}

  const ElasticConstants& elastic() const { return elastic_; }
  double deletion_step() const { return 0.0; }
  bool can_fail() const { return false; }
  static constexpr double points_to_delete() { return 0.0; }
  template <class R>
  MaskOf<R> failed(const double*) const {
    return R(1.0) < R(0.0);
  }
  template <class R>
  R wave_modulus(const double*) const {
    return R(elastic_.bulk_wave());
  }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double*) const {
    const LayerTensor<R> strain = R(dt) * rate;
    elastic_.add(s, strain);
    return {-elastic_.thinning * (strain.xx + strain.yy), R(0.0)};
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double*) const {
    elastic_.add(s, R(dt) * rate);
  }
  template <class R>
  void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double*) const {
    elastic_.add(s, R(dt) * rate);
  }
  template <class R>
  void rotate(const Frame<R>&, double*) const {}

 private:
  ElasticConstants elastic_;
};

template <>
class LawKernel<PlasticKinematic> : public J2<BilinearHardening, true> {
 public:
  explicit LawKernel(const PlasticKinematic& law) : J2(law.E, law.nu, BilinearHardening(law), law.failure_strain) {}
  double deletion_step() const { return 0.0; }
};

template <>
class LawKernel<PiecewiseLinear> : public J2<CurveHardening, false> {
 public:
  explicit LawKernel(const PiecewiseLinear& law)
      : J2(law.E, law.nu, CurveHardening(law), law.failure_strain), deletion_step_(law.tdel) {}
  double deletion_step() const { return deletion_step_; }

 private:
  double deletion_step_;
};

/// MAT_100. History of a point: plastic strain, yield stress at which it is frozen, time since its damage began, and
/// the stress of the undamaged point, which the J2 return works on while the element gets the damaged one.
template <>
class LawKernel<Spotweld> : public J2<WeldHardening, false> {
  using Base = J2<WeldHardening, false>;

 public:
  static constexpr int frozen_yield = WeldHardening::frozen_yield, damage_time = 2, undamaged_stress = 3;
  static constexpr int solid_history() { return undamaged_stress + SolidTensor<double>::size; }
  static constexpr int fibre_history() { return undamaged_stress + FibreTensor<double>::size; }

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
    return load_field<R>(history, grows_in_time() ? damage_time : 0) >= R(damage_.rupture);
  }
  /// What is left of the stress of an undamaged point.
  template <class R>
  [[gnu::always_inline]] inline R integrity(const double* history) const {
    if (!damages()) return R(1.0);
    const R w = grows_in_time() ? (1.0 / damage_.rupture) * load_field<R>(history, damage_time)
                                : (1.0 / (damage_.rupture - onset_)) * (load_field<R>(history, 0) - onset_);
    const R grown = max(w, R(0.0));
    const R left =
        damage_.beta == 0.0 ? R(1.0) - grown : map([&](double g) { return std::exp(-damage_.beta * g); }, grown);
    return select(failed<R>(history), R(0.0), left);
  }

  template <class R>
  [[gnu::always_inline]] inline void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt,
                                           double* history) const {
    if (!damages()) return Base::solid(s, rate, dt, history);
    SolidTensor<R> undamaged = load_solid<R>(history + undamaged_stress * lanes<R>);
    Base::solid(undamaged, rate, dt, history);
    store_solid(history + undamaged_stress * lanes<R>, undamaged);
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
    FibreTensor<R> undamaged = load_fibre<R>(history + undamaged_stress * lanes<R>);
    Base::fibre(undamaged, rate, dt, history);
    store_fibre(history + undamaged_stress * lanes<R>, undamaged);
    advance_damage_time<R>(dt, history);
    return integrity<R>(history) * undamaged;
  }
  /// Stress at which the yield stress of a point of the effective stress given is frozen: its own, but not so low that
  /// the return to the yield surface loses its digits (nor 0, which would say: not frozen).
  double frozen_stress(double effective) const { return std::max(effective, 1e-6 * elastic().E); }
  template <class R>
  void rotate(const Frame<R>& q, double* history) const {
    double* undamaged = history + undamaged_stress * lanes<R>;
    if (damages() && !uniaxial_) store_solid(undamaged, rotated(q, load_solid<R>(undamaged)));
  }

 private:
  bool damages() const { return damage_.growth != PointDamage::Growth::none; }
  bool grows_in_time() const { return damage_.growth == PointDamage::Growth::time; }
  template <class R>
  void advance_damage_time(double dt, double* history) const {
    if (!grows_in_time()) return;
    const auto begun = load_field<R>(history, 0) > R(onset_);
    store_field(history, damage_time, load_field<R>(history, damage_time) + select(begun, R(dt), R(0.0)));
  }

  PointDamage damage_;
  double onset_;
  bool uniaxial_;
};

}  // namespace nugget::kernel
