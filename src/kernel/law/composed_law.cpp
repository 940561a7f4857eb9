// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <utility>

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/law_components.hpp"
#include "kernel/law/point_failure.hpp"

namespace nugget::kernel {

namespace {

/// The flows made ready, in the order of Flow.
template <class Flows>
struct PreparedFlows;
template <class... Laws>
struct PreparedFlows<std::variant<Laws...>> {
  using Type = std::variant<LawKernel<Laws>...>;
};

/// Material axes of a flow; null: none.
template <class Law>
const MaterialAxes* axes_in(const LawKernel<Law>& flow) {
  if constexpr (requires(const MaterialAxes* axes) { axes = flow.axes(); })
    return flow.axes();
  else if constexpr (requires { flow.axes(); })
    return &flow.axes();
  else
    return nullptr;
}

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

bool for_shells(const LawComponents& law) {
  return !law.bond && std::visit([]<class Law>(const Law&) { return LawOfLayers<Law>; }, law.flow);
}

bool for_bricks(const LawComponents& law) {
  return !law.for_layers_only && std::visit([]<class Law>(const Law&) { return LawOfSolids<Law>; }, law.flow);
}

bool for_beams(const LawComponents& law) {
  const bool more = law.bond || law.damage || law.directional_damage || law.energy_damage || law.gissmo || law.state ||
                    law.spall || !law.rules.empty() || !law.failure_strain_over_rate.empty() ||
                    law.limits.plastic_thinning > 0.0 || law.limits.major > 0.0 ||
                    (law.erosion && law.erosion->thinning);
  return !more && std::visit([]<class Law>(const Law&) { return LawOfFibres<Law>; }, law.flow);
}

bool has_plastic_strain(const Flow& flow) {
  return std::visit([]<class Law>(const Law&) { return LawKernel<Law>::has_plastic_strain; }, flow);
}

struct LawKernel<ComposedLaw>::Parts {
  using Flows = PreparedFlows<Flow>::Type;

  explicit Parts(const LawComponents& c)
      : flow(std::visit([]<class Law>(const Law& law) -> Flows { return LawKernel<Law>(law); }, c.flow)),
        temperature_field(std::visit(
            [](const auto& law) {
              if constexpr (requires { law.temperature_field(); }) return law.temperature_field();
              return 0;
            },
            flow)),
        flow_can_fail(std::visit(
            [](const auto& law) {
              if constexpr (requires { law.can_fail(); }) return law.can_fail();
              return false;
            },
            flow)),
        has_stiffness_share(std::visit(
            [](const auto& law) {
              return requires {
                law.template stiffness_share<double>(nullptr);
              };
            },
            flow)),
        failure(c, flow_can_fail),
        spall(c.spall) {
    if (c.state) pressure.emplace(*c.state);
  }

  /// Numbers of history that the flow needs in any stress space, with the place of a plastic strain.
  int flow_history() const {
    return std::visit(
        [](const auto& law) {
          int size = first_own_field;
          if constexpr (requires { law.layer_history(); }) size = std::max(size, law.layer_history());
          if constexpr (requires { law.solid_history(); }) size = std::max(size, law.solid_history());
          if constexpr (requires { law.fibre_history(); }) size = std::max(size, law.fibre_history());
          return size;
        },
        flow);
  }
  template <class R>
  R heating(const double* history) const {
    return temperature_field > 0 ? load_field<R>(history, temperature_field) : R(0.0);
  }
  /// 1 where the flow itself says that the point has failed.
  template <class R>
  R flow_failed(const double* history) const {
    if (!flow_can_fail) return R(0.0);
    return std::visit(
        [&](const auto& law) {
          if constexpr (requires { law.template failed<R>(history); })
            return select(law.template failed<R>(history), R(1.0), R(0.0));
          else
            return R(0.0);
        },
        flow);
  }

  Flows flow;
  int temperature_field;  ///< in the history; 0: there is none
  bool flow_can_fail, has_stiffness_share;
  PointFailure failure;
  std::optional<EquationOfStateKernel> pressure;
  std::optional<Spall> spall;
};

LawKernel<ComposedLaw>::LawKernel(const ComposedLaw& law)
    : elastic_(law.E, law.nu),
      parts_(std::make_shared<const Parts>(*law.components)),
      lost_(parts_->flow_history()),
      pressure_(lost_ + parts_->failure.history()),
      history_(pressure_ + (parts_->pressure ? EquationOfStateKernel::size + 1 : 0)),
      spin_field_(std::visit(
          [](const auto& flow) {
            if constexpr (requires { flow.spin_field(); }) return flow.spin_field();
            return 0;
          },
          parts_->flow)),
      points_to_delete_(law.components->points_to_delete),
      deletion_step_(law.components->deletion_step),
      step_share_(std::visit(
          [](const auto& flow) {
            if constexpr (requires { flow.step_share(); }) return flow.step_share();
            return 1.0;
          },
          parts_->flow)),
      can_fail_(parts_->failure.active()),
      layers_stiffen_(std::visit(
          [](const auto& flow) {
            return requires {
              flow.template layer_modulus<double>(nullptr);
            };
          },
          parts_->flow)) {}

template <class R>
ThicknessStrain<R> LawKernel<ComposedLaw>::layer(LayerTensor<R>& s, const LayerTensor<R>& rate, double dt,
                                                 double* history) const {
  const auto flow = [&] {
    return std::visit(
        [&]<class Law>(const LawKernel<Law>& law) {
          if constexpr (LawOfLayers<Law>)
            return law.layer(s, rate, dt, history);
          else
            return ThicknessStrain<R>{};  // refused by the model
        },
        parts_->flow);
  };
  if (!can_fail_) return flow();
  double* failure = history + lost_ * lanes<R>;
  if (parts_->failure.softens()) parts_->failure.restore_undamaged(s, failure);
  const R before = load_field<R>(history, plastic_strain_field);
  ThicknessStrain<R> thickness = flow();
  const R strain = load_field<R>(history, plastic_strain_field);
  const double over_dt = dt > 0.0 ? 1.0 / dt : 0.0;  // the first forces of a run are those of no step
  parts_->failure.advance(
      PointStep<R>{as_solid(s, R(0.0)), as_solid(rate, over_dt * thickness.total), strain, strain - before,
                   -thickness.plastic, parts_->heating<R>(history), dt, true, parts_->flow_failed<R>(history)},
      failure);
  parts_->failure.weaken(s, failure);
  return thickness;
}

template <class R>
void LawKernel<ComposedLaw>::solid(SolidTensor<R>& s, const SolidTensor<R>& rate, double dt, double* history) const {
  const auto flow = [&] {
    const SolidTensor<R> start = s;
    std::visit(
        [&]<class Law>(const LawKernel<Law>& law) {
          if constexpr (LawOfSolids<Law>) law.solid(s, rate, dt, history);
        },
        parts_->flow);
    if (parts_->pressure) set_pressure(s, start, rate, dt, history);
  };
  if (!can_fail_) return flow();
  double* failure = history + lost_ * lanes<R>;
  if (parts_->failure.softens()) parts_->failure.restore_undamaged(s, failure);
  const R before = load_field<R>(history, plastic_strain_field);
  flow();
  const R strain = load_field<R>(history, plastic_strain_field);
  parts_->failure.advance(PointStep<R>{s, rate, strain, strain - before, R(0.0), parts_->heating<R>(history), dt, false,
                                       parts_->flow_failed<R>(history)},
                          failure);
  parts_->failure.weaken(s, failure);
}

template <class R>
void LawKernel<ComposedLaw>::fibre(FibreTensor<R>& s, const FibreTensor<R>& rate, double dt, double* history) const {
  const R start = s.rr;
  std::visit(
      [&](const auto& law) {
        if constexpr (requires { law.fibre(s, rate, dt, history); }) law.fibre(s, rate, dt, history);
      },
      parts_->flow);
  if (!can_fail_) return;
  double* failure = history + lost_ * lanes<R>;
  const double over_dt = dt > 0.0 ? 1.0 / dt : 0.0;
  const R elastic = (over_dt / elastic_.E) * (s.rr - start), across = -0.5 * rate.rr + (0.5 - elastic_.nu) * elastic;
  const R none = R(0.0), strain = load_field<R>(history, plastic_strain_field);
  parts_->failure.advance(PointStep<R>{{s.rr, none, none, s.rs, none, s.rt},
                                       {rate.rr, across, across, rate.rs, none, rate.rt},
                                       strain,
                                       none,
                                       none,
                                       none,
                                       dt,
                                       false,
                                       none},
                          failure);
  const R left = PointFailure::left<R>(failure);
  s = left * s;
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

LawKernel<ComposedLaw> LawKernel<ComposedLaw>::linear_at_start() const {
  LawKernel linear = *this;
  auto parts = std::make_shared<Parts>(*parts_);
  if (parts_->pressure) parts->pressure = parts_->pressure->linear_at_start();
  std::visit(
      [](auto& flow) {
        if constexpr (requires { flow.make_linear_at_start(); }) flow.make_linear_at_start();
      },
      parts->flow);
  linear.parts_ = std::move(parts);
  return linear;
}

template <class R>
void LawKernel<ComposedLaw>::add_viscous_work(const R& work, double* history) const {
  if (parts_->pressure) parts_->pressure->add_viscous_work(work, history + pressure_ * lanes<R>);
}

const MaterialAxes* LawKernel<ComposedLaw>::axes() const {
  return std::visit([](const auto& flow) { return axes_in(flow); }, parts_->flow);
}

int LawKernel<ComposedLaw>::size_field() const {
  const int field = parts_->failure.size_field();
  return field > 0 ? lost_ + field : 0;
}

int LawKernel<ComposedLaw>::crash_front_field() const {
  return std::visit(
      [](const auto& flow) {
        if constexpr (requires { flow.crash_front_field(); })
          return flow.crash_front_field();
        else
          return 0;
      },
      parts_->flow);
}

DamageNumbers LawKernel<ComposedLaw>::damage(const std::function<double(int)>& history) const {
  if (!can_fail_) return {};
  return parts_->failure.damage([&](int i) { return history(lost_ + i); });
}

template <class R>
R LawKernel<ComposedLaw>::layer_stiffening(const double* history) const {
  return std::visit(
      [&](const auto& flow) {
        if constexpr (requires { flow.template layer_modulus<R>(history); })
          return max(flow.template layer_modulus<R>(history) * (1.0 / elastic_.plane), R(1.0));
        else
          return R(1.0);
      },
      parts_->flow);
}

template <class R>
R LawKernel<ComposedLaw>::stiffness_share(const double* history) const {
  if (!parts_->has_stiffness_share) return R(1.0);
  return std::visit(
      [&](const auto& flow) {
        if constexpr (requires { flow.template stiffness_share<R>(history); })
          return flow.template stiffness_share<R>(history);
        else
          return R(1.0);
      },
      parts_->flow);
}

template <class R>
void LawKernel<ComposedLaw>::rotate(const Frame<R>& q, double* history) const {
  std::visit(
      [&](const auto& flow) {
        if constexpr (requires { flow.rotate(q, history); }) flow.rotate(q, history);
      },
      parts_->flow);
  parts_->failure.rotate(q, history + lost_ * lanes<R>);
}

template <class R>
R LawKernel<ComposedLaw>::wave_modulus(const double* history) const {
  if (!parts_->pressure)
    return std::visit(
        [&](const auto& flow) {
          if constexpr (requires { flow.template wave_modulus<R>(history); })
            return flow.template wave_modulus<R>(history);
          else
            return R(elastic_.bulk_wave());  // of layers, which have no such step
        },
        parts_->flow);
  const R bulk = max(parts_->pressure->template modulus<R>(history + pressure_ * lanes<R>), R(0.0));
  return std::visit(
      [&](const auto& flow) {
        if constexpr (requires { flow.template shear_wave_modulus<R>(history); })
          return bulk + flow.template shear_wave_modulus<R>(history);
        else
          return bulk + (4.0 / 3.0) * elastic_.shear;
      },
      parts_->flow);
}

template ThicknessStrain<NativeBatch> LawKernel<ComposedLaw>::layer(LayerTensor<NativeBatch>&,
                                                                    const LayerTensor<NativeBatch>&, double,
                                                                    double*) const;
template void LawKernel<ComposedLaw>::solid(SolidTensor<NativeBatch>&, const SolidTensor<NativeBatch>&, double,
                                            double*) const;
template void LawKernel<ComposedLaw>::fibre(FibreTensor<NativeBatch>&, const FibreTensor<NativeBatch>&, double,
                                            double*) const;
template void LawKernel<ComposedLaw>::rotate(const Frame<NativeBatch>&, double*) const;
template void LawKernel<ComposedLaw>::add_viscous_work(const NativeBatch&, double*) const;
template NativeBatch LawKernel<ComposedLaw>::wave_modulus(const double*) const;
template NativeBatch LawKernel<ComposedLaw>::layer_stiffening(const double*) const;
template NativeBatch LawKernel<ComposedLaw>::stiffness_share(const double*) const;

}  // namespace nugget::kernel
