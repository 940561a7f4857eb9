// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/tabulated_rubber.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/law/damped_step.hpp"
#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {
using namespace tensor;

namespace {

constexpr double table_step = 1e-3;  // of ln l

/// The curve at `at`, its end slopes going on beyond its ends.
double continued(const Curve& curve, double at) {
  if (at < curve.x.front()) return curve.y.front() + (at - curve.x.front()) * curve.slope(at);
  return curve.extrapolated(at);
}

/// f of a test at ln l, by its series: up to a term whose strain is so small that all that follow are linear in it.
double f_of_test(const Curve& test, double contraction, double log_stretch) {
  double sum = 0.0;
  while (std::abs(log_stretch) > 1e-7) {
    const double strain = std::expm1(log_stretch);
    sum += (1.0 + strain) * continued(test, strain);
    log_stretch *= -contraction;
  }
  return sum + test.slope(0.0) * log_stretch / (1.0 + contraction);
}

/// The share of the stress of `loading` that `unloading` keeps over the share of the energy, from 0 to the strain
/// `end`.
Curve share_by_energy(const Curve& loading, const Curve& unloading, double end) {
  constexpr int parts = 500;
  Curve share;
  double energy = 0.0, before = 0.0;
  for (int i = 1; i <= parts; ++i) {
    const double strain = end * i / parts, stress = continued(loading, strain);
    energy += 0.5 * (before + stress) * end / parts;
    before = stress;
    share.x.push_back(energy);
    share.y.push_back(std::clamp(continued(unloading, strain) / stress, 0.0, 1.0));
  }
  for (double& x : share.x) x /= energy;
  return share;
}

}  // namespace

TestFunction::TestFunction(const Curve& test, double contraction) {
  // As far as the test, and as its lateral stretches.
  constexpr double least = -2.5, most = 2.5;
  const double low = std::max(std::log1p(std::max(test.x.front(), -0.95)), least),
               high = std::min(std::log1p(test.x.back()), most);
  const double from = std::min(low, -contraction * high), to = std::max(high, -contraction * low);
  zero_ = std::max(1.0, std::ceil(-from / table_step));
  const double above = std::max(1.0, std::ceil(to / table_step));
  const auto count = static_cast<int>(zero_ + above) + 1;
  for (int i = 0; i < count; ++i) f_.push_back(f_of_test(test, contraction, (i - zero_) * table_step));
  energy_.assign(f_.size(), 0.0);
  const auto zero = static_cast<std::size_t>(zero_);
  const auto area = [&](std::size_t i) { return 0.5 * table_step * (f_[i] + f_[i + 1]); };
  for (std::size_t i = zero; i + 1 < f_.size(); ++i) energy_[i + 1] = energy_[i] + area(i);
  for (std::size_t i = zero; i > 0; --i) energy_[i - 1] = energy_[i] - area(i - 1);
}

TestFunction::Place TestFunction::place(double log_stretch) const {
  // From the interval's own start, so that the smallest strains keep their digits.
  const double steps = log_stretch / table_step,
               interval = std::clamp(std::floor(steps) + zero_, 0.0, static_cast<double>(f_.size()) - 2.0);
  return {static_cast<std::size_t>(interval), steps - (interval - zero_)};
}

TestFunction::Value TestFunction::at(double log_stretch) const {
  const auto [i, part] = place(log_stretch);
  const double rise = f_[i + 1] - f_[i];
  return {f_[i] + part * rise, rise / table_step};
}

double TestFunction::integral(double log_stretch) const {
  const auto [i, part] = place(log_stretch);
  return energy_[i] + table_step * part * (f_[i] + 0.5 * part * (f_[i + 1] - f_[i]));
}

TabulatedRubberPoint::TabulatedRubberPoint(const TabulatedRubber& law)
    : law_(law), overstress_(law.overstress), damped_modulus_(law.damping * law.E / (1.0 + law.nu)) {
  for (const Curve& test : law.tests) {
    f_.emplace_back(test, law.contraction);
    steepest_ = std::max(steepest_, f_.back().at(0.0).slope);
  }
  if (law.is_foam()) volume_power_ = law.contraction / (1.0 - 2.0 * law.contraction);
  if (!law.unloading.empty()) {
    const Curve& loading = law.tests.front();
    for (const auto& [side, end] : {std::pair{0, loading.x.front()}, std::pair{1, loading.x.back()}})
      if (end != 0.0) unloading_[side] = share_by_energy(loading, law.unloading, end);
  }
}

double TabulatedRubberPoint::log_volume(const Principal& e) const {
  return 0.5 * (std::log1p(e.value[0]) + std::log1p(e.value[1]) + std::log1p(e.value[2]));
}

TabulatedRubberPoint::Arguments TabulatedRubberPoint::arguments(const Principal& e) const {
  const double volume = log_volume(e), taken_off = law_.is_foam() ? 0.0 : volume / 3.0;
  Arguments log_stretch;
  for (std::size_t i = 0; i < 3; ++i) log_stretch[i] = 0.5 * std::log1p(e.value[i]) - taken_off;
  log_stretch[3] = -volume_power_ * volume;
  return log_stretch;
}

double TabulatedRubberPoint::energy(const Arguments& log_stretch) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i) sum += f_.front().integral(log_stretch[i]);
  return volume_power_ > 0.0 ? sum + f_.front().integral(log_stretch[3]) / volume_power_ : sum;
}

double TabulatedRubberPoint::share_kept(const Arguments& log_stretch, double& most_energy) const {
  const double now = std::max(energy(log_stretch), 0.0);
  most_energy = std::max(most_energy, now);
  if (!(now < most_energy)) return 1.0;
  const double share = now / most_energy;
  const auto [least, greatest] = std::minmax({log_stretch[0], log_stretch[1], log_stretch[2]});
  const Curve& unloading = unloading_[-least > greatest ? 0 : 1];
  if (!unloading.empty()) return unloading.clamped(share);
  return law_.kept + (1.0 - law_.kept) * std::pow(share, law_.shape);
}

double TabulatedRubberPoint::counting(double loading, bool compressed) const {
  switch (law_.rate_counts) {
    case TabulatedRubber::RateCounts::always: return std::abs(loading);
    case TabulatedRubber::RateCounts::compressive_loading: return compressed ? loading : 0.0;
    case TabulatedRubber::RateCounts::loading: break;
  }
  return loading;
}

double TabulatedRubberPoint::add_rate(const Principal& e, const Arguments& log_stretch, const Tensor& d, double dt,
                                      std::span<double> own) const {
  double& rate = own[rate_field];
  const LoadingRates now = loading_rates(e, d, dt, law_.engineering_rate);
  if (dt > 0.0) {
    rate += (law_.window > 0.0 ? std::min(2.0 * dt / (law_.window + dt), 1.0) : weight_of_a_step) *
            (counting(now.of_each[now.most], e.value[now.most] < 0.0) - rate);
  }
  const RatePlace place = rate_place(law_.rates, rate);
  const Tensor strain_rate = tensorial(d);
  double growth = steepest_;
  for (std::size_t i = 0; i < 4; ++i) {
    const TestFunction::Value slow = f_.front().at(log_stretch[i]), low = f_[place.low].at(log_stretch[i]),
                              high = f_[place.high].at(log_stretch[i]);
    const double wanted = low.f + place.share * (high.f - low.f) - slow.f;
    const double steepest = std::max({steepest_, std::abs(low.slope), std::abs(high.slope)});
    // What the rate adds grows as a spring would: a stress that leapt with the rate would have no stable step.
    const double strained = std::abs(i < 3 ? along(e.direction[i], strain_rate) : volume_power_ * trace(d)) * dt;
    double& more = own[by_rate_field + i];
    const double held = more * wanted > 0.0 ? std::abs(more) : 0.0;
    more = std::copysign(std::min(std::abs(wanted), held + steepest * strained), wanted);
    growth = std::max(growth, steepest);
  }
  return growth * (1.0 + volume_power_);
}

PointUpdate TabulatedRubberPoint::stress(const Principal& e, const Arguments& log_stretch,
                                         const Arguments& by_rate) const {
  const double J = std::exp(log_volume(e));
  std::array<double, 3> stress;
  double steepest = f_.front().at(0.0).slope, greatest = 0.0, mean = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const TestFunction::Value now = f_.front().at(log_stretch[i]);
    stress[i] = now.f + by_rate[i];
    mean += stress[i] / 3.0;
    steepest = std::max(steepest, std::abs(now.slope));
  }
  if (!law_.is_foam()) {
    for (double& s : stress) s = (s - mean) / J + law_.bulk * (J - 1.0) / J;
    // Of the shear between two directions: (f_i - f_k) / (l_i^2 - l_k^2) (l_i^2 + l_k^2) is no more than twice the
    // greatest slope between them, which for a curve that rises ever faster is at its ends.
    return {with_values(e, stress), law_.bulk / J + 2.0 * steepest / J, 2.0 * steepest / J};
  }
  const TestFunction::Value volume = f_.front().at(log_stretch[3]);
  for (double& s : stress) {
    s = (s - volume.f - by_rate[3]) / J;
    greatest = std::max(greatest, std::abs(s));
  }
  // Along a direction: slope + n slope of the volume - stress. Of the shear between two, with the ratio r of their
  // stretches, (f_i - f_k) l_i^2 / (l_i^2 - l_k^2) is at most the steepest slope times ln r / (1 - 1 / r^2).
  const auto [least, most] = std::minmax({log_stretch[0], log_stretch[1], log_stretch[2]});
  const double log_ratio = most - least,
               apart = log_ratio > 1e-6 ? std::max(1.0, 2.0 * log_ratio / -std::expm1(-2.0 * log_ratio)) : 1.0;
  const double modulus = (steepest * apart + volume_power_ * std::abs(volume.slope)) / J + greatest;
  return {with_values(e, stress), modulus, modulus};
}

PointUpdate TabulatedRubberPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  const std::span<double> own = h.subspan(static_cast<std::size_t>(Tensor::size + overstress_.history()));
  const Principal axes = principal_axes(e);
  const Arguments log_stretch = arguments(axes);
  Arguments more{};
  double growth = 0.0;
  if (by_rate()) {
    growth = add_rate(axes, log_stretch, d, dt, own) / std::exp(log_volume(axes));
    std::copy_n(own.begin() + by_rate_field, more.size(), more.begin());
  }
  PointUpdate now = is_linear(e) ? linear_point(law_.E, law_.nu, e) : stress(axes, log_stretch, more);
  now.wave_modulus += growth;
  now.plane_modulus += 2.0 * growth;
  if (unloads()) {
    const double lost = 1.0 - share_kept(log_stretch, own[most_energy_field]);
    now.stress = now.stress + (-lost) * (law_.is_foam() ? now.stress : deviator(now.stress));
  }
  now.stress = now.stress + overstress_.advance(d, dt, h.subspan(Tensor::size));
  now.wave_modulus += overstress_.wave_modulus();
  now.plane_modulus += overstress_.wave_modulus();
  if (law_.damping > 0.0) {
    now.stress = now.stress + (damped_modulus_ * dt) * deviator(tensorial(d));
    now.wave_modulus = with_damping(now.wave_modulus, law_.damping);
    now.plane_modulus = with_damping(now.plane_modulus, law_.damping);
  }
  return now;
}

}  // namespace nugget::kernel
