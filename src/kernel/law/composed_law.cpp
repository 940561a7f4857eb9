// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/foam_points.hpp"
#include "kernel/law/honeycomb_point.hpp"
#include "kernel/law/law_components.hpp"
#include "kernel/law/orthotropic_point.hpp"
#include "kernel/law/point_failure.hpp"
#include "kernel/law/relaxation.hpp"
#include "kernel/law/rubber_points.hpp"
#include "kernel/law/smooth_hardening.hpp"

namespace nugget::kernel {

/// History of a point: plastic strain and, where plastic work heats it, its temperature rise.
template <>
class LawKernel<JohnsonCook> : public J2<SmoothHardening<JohnsonCookFormula>, false> {
  using Base = J2<SmoothHardening<JohnsonCookFormula>, false>;

 public:
  explicit LawKernel(const JohnsonCook& law)
      : J2(law.E, law.nu, SmoothHardening<JohnsonCookFormula>(law), 0.0),
        heating_(law.heating),
        melting_rise_(law.melting_rise) {}

  int layer_history() const { return heats() ? 2 : 1; }
  int solid_history() const { return heats() ? 2 : 1; }
  bool heats() const { return heating_ > 0.0; }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt, double* history) const {
    const R before = load_field<R>(history, 0);
    const ThicknessStrain<R> thickness = Base::layer(s, rate, dt, history);
    if (heats())
      heat(sqrt(s.xx * s.xx + s.yy * s.yy - s.xx * s.yy + 3.0 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz)), before,
           history);
    return thickness;
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const R before = load_field<R>(history, 0);
    Base::solid(s, rate, dt, history);
    if (!heats()) return;
    const R xy = s.xx - s.yy, yz = s.yy - s.zz, zx = s.zz - s.xx;
    heat(sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx)), before, history);
  }

 private:
  template <class R>
  void heat(const R& effective, const R& before, double* history) const {
    const R rise = load_field<R>(history, 1) + heating_ * effective * (load_field<R>(history, 0) - before);
    store_field(history, 1, min(rise, R(melting_rise_)));
  }

  double heating_, melting_rise_;
};

template <>
class LawKernel<PowerLaw> : public J2<SmoothHardening<PowerLawFormula>, false> {
 public:
  explicit LawKernel(const PowerLaw& law) : J2(law.E, law.nu, SmoothHardening<PowerLawFormula>(law), 0.0) {}
};

template <>
class LawKernel<MooneyRivlin> : public SolidPointLaw<MooneyRivlinPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<BlatzKo> : public SolidPointLaw<BlatzKoPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<Ogden> : public SolidPointLaw<OgdenPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<PolynomialRubber> : public SolidPointLaw<PolynomialPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<LowDensityFoam> : public SolidPointLaw<LowDensityFoamPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<CrushableFoam> : public SolidPointLaw<CrushableFoamPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<RateFoam> : public SolidPointLaw<RateFoamPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

template <>
class LawKernel<Viscoelastic> : public SolidPointLaw<ViscoelasticPoint> {
 public:
  using SolidPointLaw::SolidPointLaw;
};

/// History of a point: plastic strain, which stays 0, and the last step.
template <>
class LawKernel<Fluid> {
 public:
  explicit LawKernel(const Fluid& law) : viscosity_(law.viscosity) {}

  static constexpr int layer_history() { return 2; }
  static constexpr int solid_history() { return 2; }

  template <class R>
  ThicknessStrain<R> layer(LayerTensor<R>&, const LayerTensor<R>&, double, double*) const {
    return {};
  }
  template <class R>
  void solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
    const R mean = (1.0 / 3.0) * (rate.xx + rate.yy + rate.zz);
    const double twice = 2.0 * viscosity_;
    s = {twice * (rate.xx - mean), twice * (rate.yy - mean), twice * (rate.zz - mean),
         viscosity_ * rate.xy,     viscosity_ * rate.yz,     viscosity_ * rate.zx};
    store_field(history, 1, R(dt));
  }
  template <class R>
  void rotate(const Frame<R>&, double*) const {}
  /// The modulus of an elastic solid of the same stable step: with velocities of half a step before, a dashpot C is as
  /// stable as a spring 2 C/dt would be.
  template <class R>
  R wave_modulus(const double* history) const {
    const R dt = load_field<R>(history, 1);
    return select(dt > 0.0, (8.0 / 3.0) * viscosity_ / select(dt > 0.0, dt, R(1.0)), R(0.0));
  }

 private:
  double viscosity_;
};

namespace {

/// The flows made ready, in the order of Flow.
template <class Flows>
struct PreparedFlows;
template <class... Laws>
struct PreparedFlows<std::variant<Laws...>> {
  using Type = std::variant<LawKernel<Laws>...>;
};

template <class R>
SolidTensor<R> as_solid(const LayerTensor<R>& a, const R& zz) {
  return {a.xx, a.yy, zz, a.xy, a.yz, a.xz};
}

template <class R>
R mean_of(const SolidTensor<R>& s) {
  return (1.0 / 3.0) * (s.xx + s.yy + s.zz);
}

/// The stress with another mean.
template <class R>
SolidTensor<R> with_mean(SolidTensor<R> s, const R& mean) {
  const R change = mean - mean_of(s);
  s.xx += change;
  s.yy += change;
  s.zz += change;
  return s;
}

template <class R>
R largest_principal(const SolidTensor<R>& s) {
  R most;
  for (int l = 0; l < lanes<R>; ++l)
    set_lane(most, l,
             principal_axes({lane(s.xx, l), lane(s.yy, l), lane(s.zz, l), lane(s.xy, l), lane(s.yz, l), lane(s.zx, l)})
                 .value[2]);
  return most;
}

}  // namespace

struct LawKernel<ComposedLaw>::Parts {
  using Flows = PreparedFlows<Flow>::Type;

  explicit Parts(const LawComponents& c)
      : flow(std::visit([]<class Law>(const Law& law) -> Flows { return LawKernel<Law>(law); }, c.flow)),
        failure(c),
        spall(c.spall),
        heats(std::holds_alternative<LawKernel<JohnsonCook>>(flow) && std::get<LawKernel<JohnsonCook>>(flow).heats()) {
    if (c.state) pressure.emplace(*c.state);
  }

  Flows flow;
  PointFailure failure;
  std::optional<EquationOfStateKernel> pressure;
  std::optional<Spall> spall;
  bool heats;  ///< the second number of the history is a temperature rise
};

LawKernel<ComposedLaw>::LawKernel(const ComposedLaw& law)
    : elastic_(law.E, law.nu),
      parts_(std::make_shared<const Parts>(*law.components)),
      lost_(std::visit([](const auto& flow) { return std::max(flow.solid_history(), 1); }, parts_->flow)),
      pressure_(lost_ + parts_->failure.history()),
      history_(pressure_ + (parts_->pressure ? EquationOfStateKernel::size + 1 : 0)),
      points_to_delete_(law.components->points_to_delete),
      deletion_step_(law.components->deletion_step),
      can_fail_(parts_->failure.active()) {}

template <class R>
ThicknessStrain<R> LawKernel<ComposedLaw>::layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt,
                                                 double* history) const {
  const auto flow = [&] {
    return std::visit([&](const auto& law) { return law.layer(s, rate, dt, history); }, parts_->flow);
  };
  if (!can_fail_) return flow();
  double* failure = history + lost_ * lanes<R>;
  if (parts_->failure.softens()) parts_->failure.restore_undamaged(s, failure);
  const R before = load_field<R>(history, 0);
  const ThicknessStrain<R> thickness = flow();
  const R strain = load_field<R>(history, 0);
  const double over_dt = dt > 0.0 ? 1.0 / dt : 0.0;  // the first forces of a run are those of no step
  parts_->failure.advance(
      PointStep<R>{as_solid(s, R(0.0)), as_solid(rate, over_dt * thickness.total), strain, strain - before,
                   -thickness.plastic, parts_->heats ? load_field<R>(history, 1) : R(0.0), dt, true},
      failure);
  parts_->failure.weaken(s, failure);
  return thickness;
}

template <class R>
void LawKernel<ComposedLaw>::solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
  const auto flow = [&] {
    const SolidTensor<R> start = s;
    std::visit([&](const auto& law) { law.solid(s, rate, dt, history); }, parts_->flow);
    if (parts_->pressure) set_pressure(s, start, rate, dt, history);
  };
  if (!can_fail_) return flow();
  double* failure = history + lost_ * lanes<R>;
  if (parts_->failure.softens()) parts_->failure.restore_undamaged(s, failure);
  const R before = load_field<R>(history, 0);
  flow();
  const R strain = load_field<R>(history, 0);
  PointStep<R> step{s, rate, strain, strain - before, R(0.0), parts_->heats ? load_field<R>(history, 1) : R(0.0), dt};
  if (const auto* honeycomb = std::get_if<LawKernel<Honeycomb>>(&parts_->flow))
    step.flow_failed = select(honeycomb->beyond_strain_limits<R>(history), R(1.0), R(0.0));
  parts_->failure.advance(step, failure);
  parts_->failure.weaken(s, failure);
}

template <class R>
void LawKernel<ComposedLaw>::set_pressure(SolidTensor<R>& s, const SolidTensor<R>& start, const SolidTensor<R>& rate,
                                          double dt, double* history) const {
  double* own = history + pressure_ * lanes<R>;
  const R mean = mean_of(start);
  const SolidTensor<R> sheared = R(0.5) * (with_mean(s, R(0.0)) + with_mean(start, R(0.0)));
  const R work = dt * (sheared.xx * rate.xx + sheared.yy * rate.yy + sheared.zz * rate.zz + sheared.xy * rate.xy +
                       sheared.yz * rate.yz + sheared.zx * rate.zx);
  const R infinity = R(std::numeric_limits<double>::infinity());
  const auto pressure_above = [&](const R& least) {
    return parts_->pressure->template advance<R>(rate.xx + rate.yy + rate.zz, work, -mean, least, dt, own);
  };
  if (!parts_->spall) {
    s = with_mean(s, -pressure_above(-infinity));
    return;
  }
  const Spall& spall = *parts_->spall;
  if (spall.form == Spall::Form::limited_tension) {
    s = with_mean(s, -pressure_above(R(-spall.limit)));
    return;
  }
  const R before = load_field<R>(own, EquationOfStateKernel::size), none = R(0.0);
  const R pressure = pressure_above(select(before > 0.5, none, -infinity));
  s = with_mean(s, -pressure);
  const R tension = spall.form == Spall::Form::mean_stress ? -pressure : largest_principal(s);
  const R broken = select(tension > R(spall.limit), R(1.0), before);
  store_field(own, EquationOfStateKernel::size, broken);
  const R left = max(pressure, none);
  s = select(broken > 0.5, SolidTensor<R>{-left, -left, -left, none, none, none}, s);
}

template <class R>
void LawKernel<ComposedLaw>::add_viscous_work(const R& work, double* history) const {
  if (parts_->pressure) parts_->pressure->add_viscous_work(work, history + pressure_ * lanes<R>);
}

const MaterialAxes* LawKernel<ComposedLaw>::axes() const {
  return std::visit(
      [](const auto& flow) -> const MaterialAxes* {
        if constexpr (requires { flow.axes(); })
          return &flow.axes();
        else
          return nullptr;
      },
      parts_->flow);
}

int LawKernel<ComposedLaw>::size_field() const {
  const int field = parts_->failure.size_field();
  return field > 0 ? lost_ + field : 0;
}

DamageNumbers LawKernel<ComposedLaw>::damage(const std::function<double(int)>& history) const {
  if (!can_fail_) return {};
  return parts_->failure.damage([&](int i) { return history(lost_ + i); });
}

template <class R>
R LawKernel<ComposedLaw>::stiffness_share(const double* history) const {
  const auto* honeycomb = std::get_if<LawKernel<Honeycomb>>(&parts_->flow);
  return honeycomb ? honeycomb->stiffness_share<R>(history) : R(1.0);
}

template <class R>
void LawKernel<ComposedLaw>::rotate(const Frame<R>& q, double* history) const {
  std::visit([&](const auto& flow) { flow.rotate(q, history); }, parts_->flow);
  parts_->failure.rotate(q, history + lost_ * lanes<R>);
}

template <class R>
R LawKernel<ComposedLaw>::wave_modulus(const double* history) const {
  if (parts_->pressure) {
    const R bulk = parts_->pressure->template modulus<R>(history + pressure_ * lanes<R>);
    if (const auto* fluid = std::get_if<LawKernel<Fluid>>(&parts_->flow))
      return max(bulk, R(0.0)) + fluid->wave_modulus<R>(history);
    return max(bulk, R(0.0)) + (4.0 / 3.0) * elastic_.shear;
  }
  return std::visit([&](const auto& flow) { return flow.template wave_modulus<R>(history); }, parts_->flow);
}

template ThicknessStrain<double> LawKernel<ComposedLaw>::layer(LayerTensor<double>&, const LayerTensor<double>&, double,
                                                               double*) const;
template ThicknessStrain<NativeBatch> LawKernel<ComposedLaw>::layer(LayerTensor<NativeBatch>&,
                                                                    const LayerTensor<NativeBatch>&, double,
                                                                    double*) const;
template void LawKernel<ComposedLaw>::solid(SolidTensor<double>&, const SolidTensor<double>&, double, double*) const;
template void LawKernel<ComposedLaw>::solid(SolidTensor<NativeBatch>&, const SolidTensor<NativeBatch>&, double,
                                            double*) const;
template void LawKernel<ComposedLaw>::rotate(const Frame<double>&, double*) const;
template void LawKernel<ComposedLaw>::rotate(const Frame<NativeBatch>&, double*) const;
template void LawKernel<ComposedLaw>::add_viscous_work(const double&, double*) const;
template void LawKernel<ComposedLaw>::add_viscous_work(const NativeBatch&, double*) const;
template double LawKernel<ComposedLaw>::wave_modulus(const double*) const;
template NativeBatch LawKernel<ComposedLaw>::wave_modulus(const double*) const;
template double LawKernel<ComposedLaw>::stiffness_share(const double*) const;
template NativeBatch LawKernel<ComposedLaw>::stiffness_share(const double*) const;

}  // namespace nugget::kernel
