// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <utility>

#include "kernel/law/elastic_constants.hpp"
#include "kernel/law/hardening.hpp"
#include "kernel/law/law_kernel.hpp"
#include "kernel/law/plastic_return.hpp"
#include "kernel/law/twin_place.hpp"

namespace nugget::kernel {

/// J2 plasticity with a hardening of law/hardening.hpp in all three stress spaces. History of a point: effective
/// plastic strain, then with `back_stress` the back stress (a layer's in the plane-stress form of Simo and Taylor: its
/// deviator is the back stress). A point whose plastic strain has reached the failure strain has no stress.
template <class Hardening, bool back_stress>
class J2 {
 public:
  static constexpr int layer_history() { return history_with(LayerTensor<double>::size); }
  static constexpr int solid_history() { return history_with(SolidTensor<double>::size); }
  static constexpr int fibre_history() { return history_with(FibreTensor<double>::size); }
  static constexpr bool has_plastic_strain = true;

  J2(double E, double nu, Hardening hardening, double failure_strain)
      : elastic_(E, nu),
        hardening_(std::move(hardening)),
        lowest2_(hardening_.lowest() * hardening_.lowest()),
        failure_strain_(failure_strain > 0.0 ? failure_strain : std::numeric_limits<double>::infinity()) {}

  const ElasticConstants& elastic() const { return elastic_; }
  bool can_fail() const { return failure_strain_ < std::numeric_limits<double>::infinity(); }
  static constexpr double points_to_delete() { return 0.0; }

  template <class R>
  R wave_modulus(const Number<R>*) const {
    return R(elastic_.bulk_wave());
  }

  /// Which points have failed.
  template <class R, class History>
  MaskOf<R> failed(const History& history) const {
    return load_field<R>(history, plastic_strain_field) >= R(failure_strain_);
  }

  /// Adds a step of strain rate to a layer's stress (docs/theory/laws.md#j2-in-a-layer).
  template <class R>
  [[gnu::always_inline]] inline ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt,
                                                         Number<R>* history) const {
    const bool yields = strain_layer(s, rate, dt, history);
    ThicknessStrain<R> thickness = elastic_thickness(rate, dt);
    if (yields) flow(s, dt, history, thickness);
    return thickness;
  }

  /// The first, elastic part of layer(); true where any of the points may have to flow.
  template <class R>
  [[gnu::always_inline]] inline bool strain_layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt,
                                                  const Number<R>* history) const {
    elastic_.add(s, R(dt) * rate);
    if (can_fail()) s = select(failed<R>(history), LayerTensor<R>{}, s);
    const Parts<LayerTensor<R>, R> trial = parts(s, history);
    return any(trial.A + trial.B > lowest2_);
  }
  /// What layer() gives where nothing flows.
  template <class R>
  [[gnu::always_inline]] inline ThicknessStrain<R> elastic_thickness(const LayerTensor<R>& rate, double dt) const {
    const LayerTensor<R> strain = R(dt) * rate;
    return {-elastic_.thinning * (strain.xx + strain.yy), R(0.0)};
  }
  /// The second, of a layer that has been strained.
  template <class R>
  void flow_layer(const LayerPlace<R>& at, double dt) const {
    LayerTensor<R> s = load_layer<R>(at.stress);
    flow(s, dt, at.history, *at.thickness);
    store_layer(at.stress, s);
  }
  /// The same of two layers together.
  template <class R>
  [[gnu::noinline]] void flow_layers(const LayerPlace<R>& a, const LayerPlace<R>& b, double dt) const {
    using T = Twin<R>;
    const TwinPlace<Number<R>> stress{a.stress, b.stress}, history{a.history, b.history};
    LayerTensor<T> s = load_layer<T>(stress);
    ThicknessStrain<T> thickness{{a.thickness->total, b.thickness->total}, T(0.0)};
    return_to_yield(s, dt, history, thickness);
    store_layer(stress, s);
    *a.thickness = {thickness.total.a, thickness.plastic.a};
    *b.thickness = {thickness.total.b, thickness.plastic.b};
  }

  /// Adds a step of strain rate to a solid's stress: radial return.
  template <class R>
  [[gnu::always_inline]] inline void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt,
                                           Number<R>* history) const {
    elastic_.add(s, R(dt) * rate);
    if (can_fail()) s = select(failed<R>(history), SolidTensor<R>{}, s);
    if (any(parts(s, history).B > lowest2_)) flow(s, dt, history);
  }

  /// Turns the history of a solid point with the material.
  template <class R>
  void rotate(const Frame<R>& q, Number<R>* history) const {
    if constexpr (back_stress)
      store_solid(history + back_stress_field * lanes<R>,
                  rotated(q, load_solid<R>(history + back_stress_field * lanes<R>)));
  }

  /// Adds a step of strain rate to a beam fibre's stress (docs/theory/laws.md#j2-in-a-fibre).
  template <class R>
  [[gnu::always_inline]] inline void fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt,
                                           Number<R>* history) const {
    elastic_.add(s, R(dt) * rate);
    if (can_fail()) s = select(failed<R>(history), FibreTensor<R>{}, s);
    const Parts<FibreTensor<R>, R> trial = parts(s, history);
    if (any(trial.A + trial.B > lowest2_)) flow(s, dt, history);
  }

 private:
  static constexpr int back_stress_field = plastic_strain_field + 1;
  static constexpr int history_with(int tensor) { return back_stress_field + (back_stress ? tensor : 0); }

  /// A trial stress less the back stress, and the squares of the parts of its effective value.
  template <class Tensor, class R>
  struct Parts {
    Tensor relative, back;
    R mean{};  ///< of a solid
    R A{}, B{};
  };

  template <class R, class History>
  [[gnu::always_inline]] inline Parts<LayerTensor<R>, R> parts(const LayerTensor<R>& s,
                                                               [[maybe_unused]] const History& history) const {
    Parts<LayerTensor<R>, R> p;
    p.relative = s;
    if constexpr (back_stress) {
      p.back = load_layer<R>(from_field<R>(history, back_stress_field));
      p.relative = {s.xx - p.back.xx, s.yy - p.back.yy, s.xy - p.back.xy, s.xz - p.back.xz, s.yz - p.back.yz};
    }
    const LayerTensor<R>& d = p.relative;
    const R sum = d.xx + d.yy, difference = d.xx - d.yy;
    p.A = 0.25 * (sum * sum);
    p.B = 0.75 * (difference * difference) + 3.0 * (d.xy * d.xy + d.xz * d.xz + d.yz * d.yz);
    return p;
  }
  template <class R>
  [[gnu::always_inline]] inline Parts<SolidTensor<R>, R> parts(const SolidTensor<R>& s,
                                                               const Number<R>* history) const {
    Parts<SolidTensor<R>, R> p;
    p.mean = (1.0 / 3.0) * (s.xx + s.yy + s.zz);
    p.relative = {s.xx - p.mean, s.yy - p.mean, s.zz - p.mean, s.xy, s.yz, s.zx};
    if constexpr (back_stress) {
      p.back = load_solid<R>(history + back_stress_field * lanes<R>);
      p.relative = p.relative + R(-1.0) * p.back;
    }
    const SolidTensor<R>& d = p.relative;
    p.B = 1.5 * (d.xx * d.xx + d.yy * d.yy + d.zz * d.zz) + 3.0 * (d.xy * d.xy + d.yz * d.yz + d.zx * d.zx);
    return p;
  }

  /// A fibre's back stress is its effective part: that of the axial stress alone is 3/2 of its deviator's.
  template <class R>
  [[gnu::always_inline]] inline Parts<FibreTensor<R>, R> parts(const FibreTensor<R>& s,
                                                               const Number<R>* history) const {
    Parts<FibreTensor<R>, R> p;
    p.relative = s;
    if constexpr (back_stress) {
      p.back = load_fibre<R>(history + back_stress_field * lanes<R>);
      p.relative = {s.rr - p.back.rr, s.rs - p.back.rs, s.rt - p.back.rt};
    }
    const FibreTensor<R>& d = p.relative;
    p.A = d.rr * d.rr;
    p.B = 3.0 * (d.rs * d.rs + d.rt * d.rt);
    return p;
  }

  /// Returns yielding layers to the yield surface. Kept out of line: most points of most cycles are elastic.
  template <class R>
  [[gnu::noinline]] void flow(LayerTensor<R>& s, double dt, Number<R>* history, ThicknessStrain<R>& thickness) const {
    return_to_yield(s, dt, history, thickness);
  }
  template <class R, class History>
  [[gnu::always_inline]] inline void return_to_yield(LayerTensor<R>& s, double dt, const History& history,
                                                     ThicknessStrain<R>& thickness) const {
    const Parts<LayerTensor<R>, R> trial = parts(s, history);
    const R plastic_strain = load_field<R>(history, plastic_strain_field), trial2 = trial.A + trial.B;
    typename Hardening::template At<R> yield(hardening_, history);
    const YieldStress<R> start = yield(R(0.0));
    const auto plastic = trial2 > start.value * start.value;
    if (!any(plastic)) return;

    const double shift = hardening_.kinematic();
    const double ka = 0.5 * elastic_.E / (1.0 - elastic_.nu) + shift, kb = 3.0 * elastic_.shear + shift;
    const PlasticReturn<R> r = hardening_.template with_unknown<R>(yield, dt, [&](auto& unknown) {
      return plastic_return<true>(trial.A, trial.B, trial2, ka, kb, unknown, start, plastic);
    });
    const LayerTensor<R>& d = trial.relative;
    const R sum = d.xx + d.yy;
    // The mean of xx and yy shrinks by one factor, all else by another.
    const auto shrunk = [&](const R& a, const R& b) {
      const R mean = 0.5 * a * sum, half = 0.5 * b * (d.xx - d.yy);
      return LayerTensor<R>{mean + half, mean - half, b * d.xy, b * d.xz, b * d.yz};
    };
    LayerTensor<R> returned = shrunk(r.yield * r.over_a, r.yield * r.over_b);
    if constexpr (back_stress) {
      const R grow = shift * r.increment;
      const LayerTensor<R> back = trial.back + shrunk(grow * r.over_a, grow * r.over_b);
      store_layer(from_field<R>(history, back_stress_field), select(plastic, back, trial.back));
      returned = returned + back;
    }
    s = select(plastic, returned, s);
    store_field(history, plastic_strain_field, plastic_strain + select(plastic, r.increment, R(0.0)));
    if (can_fail()) s = select(failed<R>(history), LayerTensor<R>{}, s);

    const R flow_sum = select(plastic, 0.5 * r.increment * r.over_a * sum, R(0.0));  // plastic strain xx + yy
    thickness.total += (elastic_.thinning - 1.0) * flow_sum;
    thickness.plastic -= flow_sum;
  }

  template <class R>
  [[gnu::noinline]] void flow(SolidTensor<R>& s, double dt, Number<R>* history) const {
    const Parts<SolidTensor<R>, R> trial = parts(s, history);
    const R plastic_strain = load_field<R>(history, plastic_strain_field);
    typename Hardening::template At<R> yield(hardening_, history);
    const YieldStress<R> start = yield(R(0.0));
    const auto plastic = trial.B > start.value * start.value;
    if (!any(plastic)) return;

    const double shift = hardening_.kinematic(), kb = 3.0 * elastic_.shear + shift;
    const PlasticReturn<R> r = hardening_.template with_unknown<R>(yield, dt, [&](auto& unknown) {
      return plastic_return<false>(R(0.0), trial.B, trial.B, 0.0, kb, unknown, start, plastic);
    });
    SolidTensor<R> returned = (r.yield * r.over_b) * trial.relative;
    if constexpr (back_stress) {
      const SolidTensor<R> back = trial.back + (shift * r.increment * r.over_b) * trial.relative;
      store_solid(history + back_stress_field * lanes<R>, select(plastic, back, trial.back));
      returned = returned + back;
    }
    returned.xx += trial.mean;
    returned.yy += trial.mean;
    returned.zz += trial.mean;
    s = select(plastic, returned, s);
    store_field(history, plastic_strain_field, plastic_strain + select(plastic, r.increment, R(0.0)));
    if (can_fail()) s = select(failed<R>(history), SolidTensor<R>{}, s);
  }

  template <class R>
  [[gnu::noinline]] void flow(FibreTensor<R>& s, double dt, Number<R>* history) const {
    const Parts<FibreTensor<R>, R> trial = parts(s, history);
    const R A = trial.A, B = trial.B, trial2 = A + B;
    const R plastic_strain = load_field<R>(history, plastic_strain_field);
    typename Hardening::template At<R> yield(hardening_, history);
    const YieldStress<R> start = yield(R(0.0));
    const auto plastic = trial2 > start.value * start.value;
    if (!any(plastic)) return;

    double shift = 0.0;
    if constexpr (back_stress) shift = hardening_.kinematic();
    const double ka = elastic_.E + shift, kb = 3.0 * elastic_.shear + shift;
    const PlasticReturn<R> r = hardening_.template with_unknown<R>(
        yield, dt, [&](auto& unknown) { return plastic_return<true>(A, B, trial2, ka, kb, unknown, start, plastic); });
    const FibreTensor<R>& d = trial.relative;
    const auto shrunk = [&](const R& a, const R& b) { return FibreTensor<R>{a * d.rr, b * d.rs, b * d.rt}; };
    FibreTensor<R> returned = shrunk(r.yield * r.over_a, r.yield * r.over_b);
    if constexpr (back_stress) {
      const R grow = shift * r.increment;
      const FibreTensor<R> more = shrunk(grow * r.over_a, grow * r.over_b);
      const FibreTensor<R> back{trial.back.rr + more.rr, trial.back.rs + more.rs, trial.back.rt + more.rt};
      store_fibre(history + back_stress_field * lanes<R>, select(plastic, back, trial.back));
      returned = {returned.rr + back.rr, returned.rs + back.rs, returned.rt + back.rt};
    }
    s = select(plastic, returned, s);
    store_field(history, plastic_strain_field, plastic_strain + select(plastic, r.increment, R(0.0)));
    if (can_fail()) s = select(failed<R>(history), FibreTensor<R>{}, s);
  }

  ElasticConstants elastic_;
  Hardening hardening_;
  double lowest2_;
  double failure_strain_;
};

}  // namespace nugget::kernel
