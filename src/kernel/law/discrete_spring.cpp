// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/discrete_spring.hpp"

#include <algorithm>
#include <cmath>

namespace nugget::kernel {

DiscreteSpring::DiscreteSpring() = default;
DiscreteSpring::DiscreteSpring(const DiscreteSpring&) = default;
DiscreteSpring::DiscreteSpring(DiscreteSpring&&) noexcept = default;
DiscreteSpring& DiscreteSpring::operator=(const DiscreteSpring&) = default;
DiscreteSpring& DiscreteSpring::operator=(DiscreteSpring&&) noexcept = default;
DiscreteSpring::~DiscreteSpring() = default;

ForceCurve::ForceCurve(const Curve& curve) : x_(curve.x), y_(curve.y) {
  for (std::size_t i = 0; i + 1 < x_.size(); ++i) slope_.push_back((y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]));
  if (x_.size() == 1) slope_.push_back(0.0);
  mirrored_ = !x_.empty() && x_.front() >= 0.0;
}

double ForceCurve::piece(double d) const {
  std::size_t i = 0;
  while (i + 1 < slope_.size() && d > x_[i + 1]) ++i;
  return y_[i] + slope_[i] * (d - x_[i]);
}

double ForceCurve::operator()(double d) const {
  if (empty()) return 0.0;
  return mirrored_ && d < 0.0 ? -piece(-d) : piece(d);
}

double ForceCurve::factor(double d) const {
  const double at = mirrored_ ? std::abs(d) : d;
  return piece(std::clamp(at, x_.front(), x_.back()));
}

double ForceCurve::slope(double d) const {
  if (empty()) return 0.0;
  if (mirrored_ && d < 0.0) return slope(-d);
  std::size_t i = 0;
  while (i + 1 < slope_.size() && d > x_[i + 1]) ++i;
  const bool at_point = i + 1 < slope_.size() && d == x_[i + 1];
  return at_point ? 0.5 * (slope_[i] + slope_[i + 1]) : slope_[i];
}

double ForceCurve::steepest() const {
  double s = 0.0;
  for (const double slope : slope_) s = std::max(s, std::abs(slope));
  return s;
}

double ForceCurve::steepest_rise() const {
  double s = 0.0;
  for (const double slope : slope_) s = std::max(s, slope);
  return s;
}

double ForceCurve::steepest_fall() const {
  double s = 0.0;
  for (const double slope : slope_) s = std::max(s, -slope);
  return s;
}

double ForceCurve::lowest() const {
  return y_.empty() ? 0.0 : *std::min_element(y_.begin(), y_.end());
}

double ForceCurve::largest() const {
  double s = 0.0;
  for (const double y : y_) s = std::max(s, std::abs(y));
  return s;
}

ForceCurve ForceCurve::tension_side() const {
  Curve side;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    if (x_[i] < 0.0 || (x_[i] == 0.0 && y_[i] < 0.0)) continue;
    side.x.push_back(x_[i]);
    side.y.push_back(y_[i]);
  }
  return ForceCurve(side);
}

ForceCurve ForceCurve::compression_side() const {
  if (mirrored_) return *this;
  Curve side;
  for (std::size_t i = x_.size(); i-- > 0;) {
    if (x_[i] > 0.0 || (x_[i] == 0.0 && y_[i] > 0.0)) continue;
    side.x.push_back(-x_[i]);
    side.y.push_back(-y_[i]);
  }
  return ForceCurve(side);
}

double ForceCurve::yield(double q) const {
  return std::max(piece(q), 0.0);
}

double ForceCurve::plastic_displacement(double q, double trial, double k) const {
  // g(z) = yield(z) + k z grows with z; on each piece it is straight, so the piece that reaches the target gives z.
  const double target = trial + k * q;
  double from = q;
  for (const double to : x_) {
    if (to <= from) continue;
    const double begin = yield(from) + k * from, end = yield(to) + k * to;
    if (end >= target) return from + (to - from) * (target - begin) / (end - begin);
    from = to;
  }
  // Behind the last point its slope goes on until the yield force is used up.
  const double reach = from + (target - yield(from) - k * from) / (slope_.back() + k);
  return yield(reach) > 0.0 ? reach : std::max(from, target / k);
}

double DiscreteSpring::advance(State& s, double increment, double velocity) const {
  s.displacement += increment;
  const double d = s.displacement;
  switch (kind) {
    case Kind::none: break;
    case Kind::linear: s.force = stiffness * d; break;
    case Kind::elastic: s.force = load(d); break;
    case Kind::two_curves:
      // What stands still stays on the curve that it came along; `plastic` is 1 while it unloads.
      if (increment * d != 0.0) s.plastic = increment * d < 0.0 ? 1.0 : 0.0;
      s.force = s.plastic > 0.0 ? unload(d) : load(d);
      break;
    case Kind::hysteresis: {
      const double trial = s.force + stiffness * increment, outer = load(d), inner = unload(d);
      s.force = d >= 0.0 ? std::min(outer, std::max(inner, trial)) : std::max(outer, std::min(inner, trial));
      break;
    }
    case Kind::elastoplastic: {
      const double trial = s.force + stiffness * increment;
      const ForceCurve& limit = trial >= 0.0 ? load : unload;
      s.force = trial;
      if (std::abs(trial) <= limit.yield(s.plastic)) break;
      s.plastic = limit.plastic_displacement(s.plastic, std::abs(trial), stiffness);
      s.force = std::copysign(limit.yield(s.plastic), trial);
      break;
    }
  }
  const double log_term = log_rate == 0.0 ? 0.0 : log_rate * std::log(std::max(1.0, std::abs(velocity) / rate));
  const double factor = 1.0 + linear_rate * velocity + (velocity < 0.0 ? -log_term : log_term);
  const double scale = damper_scale.empty() ? 1.0 : damper_scale.factor(d);
  const double by_rate = rate_scale.empty() ? 1.0 : rate_scale.factor(velocity);
  return preload + factor * by_rate * s.force + damping * velocity + scale * damper(velocity);
}

double DiscreteSpring::stiffness_at(double displacement) const {
  switch (kind) {
    case Kind::none: return 0.0;
    case Kind::linear:
    case Kind::elastoplastic: return stiffness;
    case Kind::elastic:
    case Kind::two_curves:
    case Kind::hysteresis: return load.slope(displacement);
  }
  return 0.0;
}

double DiscreteSpring::force_at_start() const {
  State state{start, kind == Kind::hysteresis ? load(start) : 0.0, 0.0};
  return advance(state, 0.0, 0.0);
}

double DiscreteSpring::initial_viscosity() const {
  if (damper.empty()) return damping;
  return damping + (damper_scale.empty() ? 1.0 : damper_scale.factor(start)) * damper.slope(0.0);
}

double DiscreteSpring::greatest_stiffness() const {
  switch (kind) {
    case Kind::none: return 0.0;
    case Kind::linear:
    case Kind::elastoplastic: return stiffness;
    case Kind::elastic: return load.steepest();
    case Kind::two_curves: return std::max(load.steepest(), unload.steepest());
    case Kind::hysteresis: return std::max({stiffness, load.steepest(), unload.steepest()});
  }
  return 0.0;
}

double DiscreteSpring::greatest_viscosity(double f) const {
  const double scale = damper_scale.empty() ? 1.0 : damper_scale.largest();
  const double rates = std::abs(f) * (std::abs(linear_rate) + std::abs(log_rate) / rate);
  return damping + scale * damper.steepest() + rates + std::abs(f) * rate_scale.steepest();
}

}  // namespace nugget::kernel
