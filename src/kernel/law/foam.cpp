// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/foam.hpp"

#include <algorithm>
#include <cmath>

#include "base/index.hpp"
#include "kernel/law/damped_step.hpp"
#include "kernel/law/relaxation.hpp"
#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {
using namespace tensor;

namespace {

/// Area under a curve from 0 to x; beyond its ends with its last slopes.
double area(const Curve& curve, double x) {
  double sum = 0.0, from = 0.0;
  for (const double end : curve.x) {
    if (end <= 0.0) continue;
    if (end >= x) break;
    sum += 0.5 * (end - from) * (curve.extrapolated(from) + curve.extrapolated(end));
    from = end;
  }
  return sum + 0.5 * (x - from) * (curve.extrapolated(from) + curve.extrapolated(x));
}

/// The viscous stress.
Tensor viscous(double modulus, double damping, const Tensor& d, double dt) {
  return (damping * modulus * dt) * tensorial(d);
}

/// Principal nominal stresses of a foam as true ones, and by how much a slope grows at most.
double make_true(std::array<double, 3>& stress, const Principal& b_less_one, double J) {
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double l = std::sqrt(1.0 + b_less_one.value[i]);
    most = std::max(most, l * l / J);
    stress[i] *= l / J;
  }
  return most;
}

/// l - 1 of b - 1.
double nominal_strain(double b_less_one) {
  return b_less_one / (1.0 + std::sqrt(1.0 + b_less_one));
}

/// Nominal stress of a foam that pulls, up to the cutoff; `failed` remembers that it was reached.
double tension(double pull, double cutoff, bool tension_failure, double& failed) {
  if (tension_failure && pull >= cutoff) failed = 1.0;
  return failed > 0.0 ? 0.0 : std::min(pull, cutoff);
}

}  // namespace

PointUpdate LowDensityFoamPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  const std::span<double> own = h.subspan(at(tensors() * Tensor::size));
  double& most_energy = own[0];
  double& failed = own[1];
  const Principal axes = principal_axes(e);
  const double J = std::sqrt(determinant(plus(e, 1.0)));
  std::array<double, 3> stress{};
  double energy = 0.0, slope = std::max(law_.E, law_.compression.slope(0.0));
  for (std::size_t i = 0; i < 3; ++i) {
    const double strain = nominal_strain(axes.value[i]);
    if (strain < 0.0) {
      stress[i] = -law_.compression.extrapolated(-strain);
      energy += area(law_.compression, -strain);
      slope = std::max(slope, law_.compression.slope(-strain));
    } else {
      stress[i] = tension(law_.E * strain, law_.cutoff, law_.tension_failure, failed);
    }
  }
  most_energy = std::max(energy, energy + (most_energy - energy) * std::exp(-law_.recovery * dt));
  const double left =
      most_energy > 0.0 ? law_.unloading + (1.0 - law_.unloading) * std::pow(energy / most_energy, law_.shape) : 1.0;
  for (double& s : stress)
    if (s < 0.0) s *= left;
  const double modulus = slope * make_true(stress, axes, J);
  Tensor sum = with_values(axes, stress) + viscous(modulus, law_.damping, d, dt);
  double stiffer = 0.0;
  for (std::size_t k = 0; k < relaxing_.size(); ++k) {
    const std::span<double> stress_of_term = h.subspan((k + 1) * Tensor::size, Tensor::size);
    store(stress_of_term, relaxed(load(stress_of_term), relaxing_[k].shear, relaxing_[k].decay, tensorial(d), dt));
    sum = sum + load(stress_of_term);
    stiffer += relaxing_[k].shear;
  }
  return {sum, with_damping(modulus, law_.damping) + stiffer};
}

PointUpdate CrushableFoamPoint::update(const Tensor& s, const Tensor& d, double dt, std::span<double> h) const {
  double& log_volume = h[tensors() * Tensor::size];
  const double half = 0.5 * dt * trace(d);
  log_volume += std::log((1.0 + half) / (1.0 - half));
  const double crushed = 1.0 - std::exp(log_volume), yield = law_.yield.extrapolated(std::max(crushed, 0.0));
  Tensor stress = s + (law_.E * dt) * tensorial(d);
  if (law_.damping > 0.0) stress = stress + (-1.0) * load(h);
  const Principal axes = principal_axes(stress);
  if (axes.value[0] < -yield || axes.value[2] > law_.cutoff) {
    std::array<double, 3> value = axes.value;
    for (double& v : value) v = std::clamp(v, -yield, law_.cutoff);
    stress = with_values(axes, value);
  }
  if (law_.damping > 0.0) {
    const Tensor damping = viscous(law_.E, law_.damping, d, dt);
    store(h, damping);
    stress = stress + damping;
  }
  return {stress, with_damping(law_.E, law_.damping)};
}

RateFoamPoint::RateFoamPoint(const RateFoam& law) : law_(law), growth_(law.E) {
  for (const Curve& curve : law.curves) growth_ = std::max(growth_, curve.slope(0.0));
}

double RateFoamPoint::look_up(double strain, double rate) const {
  const RatePlace place = rate_place(law_.rates, rate);
  const double low = law_.curves[place.low].extrapolated(strain);
  if (!(place.share > 0.0)) return low;
  const double high = law_.curves[place.high].extrapolated(strain);
  if (!law_.log_log) return low + place.share * (high - low);
  const double share =
      std::log(rate / law_.rates[place.low]) / std::log(law_.rates[place.high] / law_.rates[place.low]);
  return low * high > 0.0 ? low * std::pow(high / low, share) : low + share * (high - low);
}

std::array<double, 3> RateFoamPoint::rates_now(const Principal& axes, const Tensor& d, double J, double dt) const {
  if (law_.rate_of == RateFoam::RateOf::volume) {
    const double rate = (J < 1.0 ? -1.0 : 1.0) * (law_.engineering_rate ? J : 1.0) * trace(d);
    return {rate, rate, rate};
  }
  const LoadingRates now = loading_rates(axes, d, dt, law_.engineering_rate);
  if (law_.rate_of == RateFoam::RateOf::each_direction) return now.of_each;
  const double most = now.of_each[now.most];
  return {most, most, most};
}

PointUpdate RateFoamPoint::update(const Tensor&, const Tensor& d, double dt, std::span<double> h) const {
  Tensor e = load(h);
  stretch(e, d, dt);
  store(h, e);
  double& most_energy = h[6];
  double& failed = h[7];
  const Principal axes = principal_axes(e);
  const double J = std::sqrt(determinant(plus(e, 1.0)));
  const std::array<double, 3> now = rates_now(axes, d, J, dt);
  const Curve& lowest = law_.curves.front();
  std::array<double, 3> stress{};
  double energy = 0.0, slope = std::max(law_.E, law_.step_modulus);
  for (std::size_t i = 0; i < 3; ++i) {
    double &rate = h[8 + i], &more = h[11 + i];
    if (dt > 0.0) rate += weight_of_a_step * (now[i] - rate);
    const double strain = nominal_strain(axes.value[i]);
    if (strain >= 0.0 && !law_.tension_by_curves) {
      more = 0.0;
      stress[i] = tension(law_.E * strain, law_.cutoff, law_.tension_failure, failed);
      continue;
    }
    // What the rate adds grows as a spring would: a stress that leapt with the rate would have no stable step.
    const double side = strain < 0.0 ? 1.0 : -1.0, at_rest = side * lowest.extrapolated(-strain);
    more = std::min(side * look_up(-strain, rate) - at_rest, more + growth_ * dt * std::abs(now[i]));
    slope = std::max(slope, lowest.slope(-strain));
    if (strain >= 0.0) {
      stress[i] = tension(at_rest + more, law_.cutoff, law_.tension_failure, failed);
    } else {
      stress[i] = -(at_rest + more);
      energy += area(lowest, -strain);
    }
  }
  most_energy = std::max(most_energy, energy);
  if (law_.unloading > 0.0 && most_energy > 0.0) {
    const double lost = std::pow(1.0 - std::pow(energy / most_energy, law_.shape), law_.exponent);
    for (double& s : stress)
      if (s < 0.0) s *= 1.0 - (1.0 - law_.unloading) * lost;
  }
  if (law_.rates.size() > 1) slope += growth_;
  const double modulus = slope * make_true(stress, axes, J);
  return {with_values(axes, stress) + viscous(modulus, law_.damping, d, dt), with_damping(modulus, law_.damping)};
}

}  // namespace nugget::kernel
