// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/point_failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nugget::kernel {
namespace {

template <class R>
SolidTensor<double> lane_of(const SolidTensor<R>& a, int l) {
  return {lane(a.xx, l), lane(a.yy, l), lane(a.zz, l), lane(a.xy, l), lane(a.yz, l), lane(a.zx, l)};
}

template <class R>
LayerTensor<double> layer_lane(const LayerTensor<R>& s, int l) {
  return {lane(s.xx, l), lane(s.yy, l), lane(s.xy, l), lane(s.xz, l), lane(s.yz, l)};
}
template <class R>
void set_layer_lane(LayerTensor<R>& s, int l, const LayerTensor<double>& one) {
  set_lane(s.xx, l, one.xx);
  set_lane(s.yy, l, one.yy);
  set_lane(s.xy, l, one.xy);
  set_lane(s.xz, l, one.xz);
  set_lane(s.yz, l, one.yz);
}

/// Bounds of the principal values, cheaper than they.
template <class R>
struct PrincipalRange {
  R low, high;
  explicit PrincipalRange(const SolidTensor<R>& a) {
    const R mean = mean_of(a), radius = sqrt(radius2(a));
    low = mean - radius;
    high = mean + radius;
  }
  static R mean_of(const SolidTensor<R>& a) { return (1.0 / 3.0) * (a.xx + a.yy + a.zz); }
  /// The square of how far from the mean they can lie, and a little more.
  static R radius2(const SolidTensor<R>& a) { return (1.0 + 2e-12) * (2.0 / 3.0) * deviator2(a); }
};

/// Whether mean + sqrt(radius2) reaches a limit.
template <class R>
MaskOf<R> reaches(const R& mean, const R& radius2, double limit) {
  const R left = limit - mean;
  return left <= 0.0 || radius2 >= left * left;
}

/// Larger principal value in the plane.
double major_in_plane(const SolidTensor<double>& a) {
  return 0.5 * (a.xx + a.yy) + std::hypot(0.5 * (a.xx - a.yy), a.xy);
}

/// sqrt(2/3 d:d) of a rate with engineering shears.
double effective_rate(const SolidTensor<double>& d) {
  return std::sqrt((2.0 / 3.0) * (d.xx * d.xx + d.yy * d.yy + d.zz * d.zz) +
                   (1.0 / 3.0) * (d.xy * d.xy + d.yz * d.yz + d.zx * d.zx));
}

int history_of(const std::vector<FailureRule>& rules) {
  int size = 0;
  for (const FailureRule& rule : rules) size += std::visit([]<class Rule>(const Rule&) { return Rule::history; }, rule);
  return size;
}

bool need_plastic_flow(const std::vector<FailureRule>& rules) {
  return std::all_of(rules.begin(), rules.end(), [](const FailureRule& rule) {
    return std::visit([]<class Rule>(const Rule&) { return Rule::needs_plastic_flow; }, rule);
  });
}

}  // namespace

std::array<double, 3> principal_values(const SolidTensor<double>& a) {
  const double mean = (a.xx + a.yy + a.zz) / 3.0, j2 = 0.5 * deviator2(a);
  if (!(j2 > 0.0)) return {mean, mean, mean};
  const double x = a.xx - mean, y = a.yy - mean, z = a.zz - mean;
  const double j3 = x * (y * z - a.yz * a.yz) - a.xy * (a.xy * z - a.yz * a.zx) + a.zx * (a.xy * a.yz - y * a.zx);
  const double radius = 2.0 * std::sqrt(j2 / 3.0);
  const double cosine = std::clamp(4.0 * j3 / (radius * radius * radius), -1.0, 1.0);
  const double angle = std::acos(cosine) / 3.0, third = 2.0 * std::numbers::pi / 3.0;
  return {mean + radius * std::cos(angle + third), mean + radius * std::cos(angle - third),
          mean + radius * std::cos(angle)};
}

bool PointFailure::advance_rules(const PointNow& now, double* h, int stride) const {
  bool used_up = false;
  for (const FailureRule& rule : rules_)
    std::visit(
        [&]<class Rule>(const Rule& r) {
          r.advance(now, h, stride);
          used_up = used_up || r.used(h, stride) >= 1.0;
          h += Rule::history * stride;
        },
        rule);
  return used_up;
}

int PointFailure::add(bool needed, int numbers) {
  if (!needed) return 0;
  size_ += numbers;
  return size_ - numbers;
}

PointFailure::Bounds::Bounds(const Erosion& erosion, const StrainLimits& limits) {
  static constexpr double none = std::numeric_limits<double>::infinity();
  const auto above = [](const std::optional<double>& limit) { return limit.value_or(none); };
  const auto below = [](const std::optional<double>& limit) { return limit ? -*limit : none; };
  pressure = above(erosion.most_pressure);
  tension = below(erosion.least_pressure);
  principal_stress = above(erosion.most_stress);
  effective_stress = above(erosion.effective_stress);
  high = std::min(above(erosion.most_strain), limits.major > 0.0 ? limits.major : none);
  low = below(erosion.least_strain);
  effective_strain = above(erosion.effective_strain);
  growth = above(erosion.most_volume_strain);
  shrinkage = below(erosion.least_volume_strain);
  shear = above(erosion.shear_strain);
  thinning = above(erosion.thinning);
  age = above(erosion.time);
  of_stress = std::min({pressure, tension, principal_stress, effective_stress}) < none;
  of_strain = std::min({high, low, effective_strain, growth, shrinkage, shear, thinning}) < none;
}

PointFailure::PointFailure(const LawComponents& law, bool flow_can_fail)
    : failure_strain_(law.failure_strain),
      failure_strain_over_rate_(law.failure_strain_over_rate),
      damage_(law.damage),
      cracks_(law.directional_damage),
      rules_(law.rules),
      gissmo_(law.gissmo),
      energy_damage_(law.energy_damage),
      erosion_(law.erosion),
      limits_(law.limits),
      bounds_(law.erosion.value_or(Erosion{}), law.limits),
      cracked_(add(cracks_.has_value(), Cracks::history)),
      ruled_(add(!rules_.empty(), history_of(rules_))),
      damaged_(add(gissmo_.has_value(), Gissmo::history)),
      weakened_(add(energy_damage_.has_value(), 1)),
      thinned_(add(limits_.plastic_thinning > 0.0, 1)),
      strain_(add(erosion_.has_value() || limits_.major > 0.0, SolidTensor<double>::size)),
      impulse_(add(erosion_ && erosion_->impulse, 1)),
      age_(add(erosion_ && erosion_->time, 1)),
      flow_can_fail_(flow_can_fail),
      active_(flow_can_fail_ || failure_strain_ > 0.0 || !failure_strain_over_rate_.empty() || damage_ || size_ > 1),
      by_plastic_strain_only_(!flow_can_fail_ && failure_strain_ > 0.0 && failure_strain_over_rate_.empty() &&
                              !damage_ && size_ == 1),
      bounded_(failure_strain_over_rate_.empty() && !damage_ && !cracks_ && rules_.empty() && !gissmo_ &&
               !energy_damage_ &&
               !(erosion_ && (erosion_->impulse || !erosion_->effective_stress_over_rate.empty() ||
                              !erosion_->most_strain_over_log_rate.empty()))),
      gissmo_only_(gissmo_ && !energy_damage_ && !(failure_strain_ > 0.0) && failure_strain_over_rate_.empty() &&
                   !damage_ && !cracks_ && rules_.empty() && !erosion_ && !(limits_.plastic_thinning > 0.0) &&
                   !(limits_.major > 0.0)),
      needs_plastic_flow_(!flow_can_fail_ && !(failure_strain_ > 0.0) && failure_strain_over_rate_.empty() &&
                          !damage_ && !(limits_.major > 0.0) && !erosion_ && need_plastic_flow(rules_)) {}

bool PointFailure::eroded(const PointNow& now) const {
  const Erosion& e = *erosion_;
  const double pressure = -(now.stress.xx + now.stress.yy + now.stress.zz) / 3.0;
  const double volume = now.strain.xx + now.strain.yy + now.strain.zz;
  const PrincipalRange<double> strain(now.strain);
  int met = 0;
  // A limit of 0 must be passed: at rest it is reached already.
  const auto reaches = [&met](const std::optional<double>& limit, double value) {
    met += limit && (*limit != 0.0 ? value >= *limit : value > 0.0);
  };
  const auto falls_to = [&met](const std::optional<double>& limit, double value) {
    met += limit && (*limit != 0.0 ? value <= *limit : value < 0.0);
  };
  reaches(e.most_pressure, pressure);
  falls_to(e.least_pressure, pressure);
  if (e.least_strain && strain.low <= *e.least_strain) falls_to(e.least_strain, principal_values(now.strain)[0]);
  if (e.most_strain && strain.high >= *e.most_strain) reaches(e.most_strain, principal_values(now.strain)[2]);
  if (!e.most_strain_over_log_rate.empty())
    reaches(e.most_strain_over_log_rate.clamped(std::log(std::max(now.rate, 1e-300))), principal_values(now.strain)[2]);
  reaches(e.effective_strain, std::sqrt(2.0 / 3.0 * deviator2(now.strain)));
  reaches(e.most_volume_strain, volume);
  falls_to(e.least_volume_strain, volume);
  if (e.most_stress && PrincipalRange<double>(now.stress).high >= *e.most_stress)
    reaches(e.most_stress, principal_values(now.stress)[2]);
  const double effective = std::sqrt(1.5 * deviator2(now.stress));
  reaches(e.effective_stress, effective);
  if (!e.effective_stress_over_rate.empty()) reaches(e.effective_stress_over_rate.clamped(now.rate), effective);
  if (e.shear_strain && 0.5 * (strain.high - strain.low) >= *e.shear_strain) {
    const std::array<double, 3> principal = principal_values(now.strain);
    reaches(e.shear_strain, 0.5 * (principal[2] - principal[0]));
  }
  reaches(e.impulse, now.impulse);
  reaches(e.time, now.age);
  if (now.layer) reaches(e.thinning, -now.strain.zz);
  return met >= e.needed;
}

bool PointFailure::beyond_strain_limits(const PointNow& now, double thinning) const {
  if (limits_.plastic_thinning > 0.0 && thinning >= limits_.plastic_thinning) return true;
  if (!(limits_.major > 0.0)) return false;
  return (now.layer ? major_in_plane(now.strain) : principal_values(now.strain)[2]) >= limits_.major;
}

DamageNumbers PointFailure::damage(const std::function<double(int)>& history) const {
  DamageNumbers d{history(lost_field)};
  if (gissmo_) {
    d[1] = gissmo_->grown(history(damaged_ + Gissmo::damage_field));
    d[2] = gissmo_->grown(history(damaged_ + Gissmo::instability_field));
  } else {
    int field = ruled_;
    for (const FailureRule& rule : rules_)
      std::visit(
          [&]<class Rule>(const Rule& r) {
            std::array<double, Rule::history> own;
            for (double& number : own) number = history(field++);
            d[1] = std::max(d[1], std::min(r.used(own.data(), 1), 1.0));
          },
          rule);
  }
  return d;
}

template <class R>
MaskOf<R> PointFailure::may_fail(const PointStep<R>& step, const double* history) const {
  const auto squared = [](double limit) { return limit > 0.0 ? limit * limit : 0.0; };
  const auto limited = [](double limit) { return limit < std::numeric_limits<double>::infinity(); };
  auto may = R(0.0) > R(1.0);
  if (failure_strain_ > 0.0) may = may || step.plastic_strain >= R(failure_strain_);
  if (thinned_ > 0) may = may || load_field<R>(history, thinned_) >= R(limits_.plastic_thinning);
  if (age_ > 0) may = may || load_field<R>(history, age_) >= R(bounds_.age);
  if (bounds_.of_stress) {
    const R mean = PrincipalRange<R>::mean_of(step.stress), radius2 = PrincipalRange<R>::radius2(step.stress);
    may = may || -mean >= R(bounds_.pressure) || mean >= R(bounds_.tension) ||
          (9.0 / 4.0) * radius2 >= R(squared(bounds_.effective_stress));
    if (limited(bounds_.principal_stress)) may = may || reaches(mean, radius2, bounds_.principal_stress);
  }
  if (bounds_.of_strain) {
    const SolidTensor<R> strain = load_solid<R>(history + strain_ * lanes<R>);
    const R mean = PrincipalRange<R>::mean_of(strain), radius2 = PrincipalRange<R>::radius2(strain);
    const R volume = strain.xx + strain.yy + strain.zz;
    if (limited(bounds_.high)) may = may || reaches(mean, radius2, bounds_.high);
    if (limited(bounds_.low)) may = may || reaches(R(-mean), radius2, bounds_.low);
    may = may || radius2 >= R(squared(std::min(bounds_.effective_strain, bounds_.shear))) ||
          volume >= R(bounds_.growth) || -volume >= R(bounds_.shrinkage) || -strain.zz >= R(bounds_.thinning);
  }
  return may;
}

template <class R>
void PointFailure::advance(const PointStep<R>& step, double* history) const {
  if (by_plastic_strain_only_) {
    const auto has_failed = load_field<R>(history, lost_field) >= R(1.0) || step.plastic_strain >= R(failure_strain_);
    return store_field(history, lost_field, select(has_failed, R(1.0), R(0.0)));
  }
  if (flow_can_fail_)
    store_field(history, lost_field, select(step.flow_failed > 0.5, R(1.0), load_field<R>(history, lost_field)));
  const auto carries = load_field<R>(history, lost_field) < R(1.0);
  const auto grow = [&](int field, const R& by) {
    store_field(history, field, load_field<R>(history, field) + select(carries, by, R(0.0)));
  };
  if (strain_ > 0) {
    const SolidTensor<R>& rate = step.rate;
    const R change[] = {rate.xx, rate.yy, rate.zz, 0.5 * rate.xy, 0.5 * rate.yz, 0.5 * rate.zx};
    for (int i = 0; i < SolidTensor<double>::size; ++i) grow(strain_ + i, step.dt * change[i]);
  }
  if (age_ > 0) grow(age_, R(step.dt));
  if (thinned_ > 0) grow(thinned_, step.plastic_thinning);
  if (bounded_ && !any(carries && may_fail(step, history))) return;
  if (needs_plastic_flow_ && !any(carries && step.plastic_increment > 0.0)) return;

  if (gissmo_) {
    const R lost = load_field<R>(history, lost_field);
    double* damage = history + damaged_ * lanes<R>;
    const R by_damage = gissmo_->advance(step.stress, step.plastic_increment, step.heating, carries, step.dt, damage);
    store_field(history, lost_field, select(carries, max(lost, by_damage), lost));
    if (gissmo_only_) return;
  }
  const auto at = [&](int field, int l) -> double& { return history[field * lanes<R> + l]; };
  for (int l = 0; l < lanes<R>; ++l) {
    double& lost = at(lost_field, l);
    if (lost >= 1.0) continue;
    const double strain = lane(step.plastic_strain, l), increment = lane(step.plastic_increment, l);
    if (damage_) lost = std::max(lost, damage_->at(strain));
    const SolidTensor<double> rate = lane_of(step.rate, l);
    const SolidTensor<double> undamaged = lane_of(step.stress, l);
    PointNow now{(1.0 - lost) * undamaged,
                 {},
                 effective_rate(rate),
                 increment,
                 step.dt,
                 lane(step.heating, l),
                 0.0,
                 0.0,
                 step.layer};
    bool ruptured = false;
    if (energy_damage_) {
      double& damage = at(weakened_, l);
      const EnergyDamage& law = *energy_damage_;
      if (increment > 0.0 && strain > law.onset) {
        const double mean = (undamaged.xx + undamaged.yy + undamaged.zz) / 3.0, effective2 = 1.5 * deviator2(undamaged);
        // A pressed bar has stresses of round-off across.
        if (principal_values(undamaged)[2] > 1e-6 * std::sqrt(effective2))
          damage += std::min(increment, strain - law.onset) * law.growth(effective2, mean);
      }
      lost = std::max(lost, std::min(damage, 1.0));
      now.stress = (1.0 - lost) * undamaged;
      ruptured = damage >= law.critical;
    }
    if (cracks_) {
      double* cracks = &at(cracked_, l);
      ruptured = ruptured || cracks_->advance(undamaged, increment, cracks, lanes<R>);
      const LayerTensor<double> left =
          Cracks::weakened({undamaged.xx, undamaged.yy, undamaged.xy, undamaged.zx, undamaged.yz}, cracks, lanes<R>);
      now.stress = {left.xx, left.yy, 0.0, left.xy, left.yz, left.xz};
    }
    if (strain_ > 0)
      now.strain = {at(strain_, l),     at(strain_ + 1, l), at(strain_ + 2, l),
                    at(strain_ + 3, l), at(strain_ + 4, l), at(strain_ + 5, l)};
    if (impulse_ > 0) {
      const double over = std::max(principal_values(now.stress)[2] - erosion_->threshold, 0.0);
      now.impulse = at(impulse_, l) += over * over * step.dt;
    }
    if (age_ > 0) now.age = at(age_, l);

    const bool used_up = !rules_.empty() && advance_rules(now, &at(ruled_, l), lanes<R>);
    const bool has_failed =
        ruptured || (failure_strain_ > 0.0 && strain >= failure_strain_) ||
        (!failure_strain_over_rate_.empty() && strain > 0.0 && strain >= failure_strain_over_rate_.clamped(now.rate)) ||
        used_up || beyond_strain_limits(now, thinned_ > 0 ? at(thinned_, l) : 0.0) || (erosion_ && eroded(now));
    if (has_failed) lost = 1.0;
  }
}

template <class R>
void PointFailure::restore_undamaged(LayerTensor<R>& s, const double* history) const {
  if (has_lost<R>(history)) s = (1.0 / max(left<R>(history), R(1e-30))) * s;
  if (!cracks_) return;
  for (int l = 0; l < lanes<R>; ++l)
    set_layer_lane(s, l, Cracks::undamaged(layer_lane(s, l), history + cracked_ * lanes<R> + l, lanes<R>));
}

template <class R>
void PointFailure::weaken(LayerTensor<R>& s, const double* history) const {
  if (has_lost<R>(history)) s = left<R>(history) * s;
  if (!cracks_) return;
  for (int l = 0; l < lanes<R>; ++l)
    set_layer_lane(s, l, Cracks::weakened(layer_lane(s, l), history + cracked_ * lanes<R> + l, lanes<R>));
}

template void PointFailure::advance(const PointStep<NativeBatch>&, double*) const;
template void PointFailure::restore_undamaged(LayerTensor<NativeBatch>&, const double*) const;
template void PointFailure::weaken(LayerTensor<NativeBatch>&, const double*) const;

}  // namespace nugget::kernel
