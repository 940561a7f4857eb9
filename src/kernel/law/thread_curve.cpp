// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/thread_curve.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace nugget::kernel {
namespace {

/// Area under a curve from 0 to `end`, at least 0.
double area_under(const Curve& curve, double end) {
  double sum = 0.0, from = 0.0, low = with_end_slopes(curve, 0.0);
  const auto add = [&](double to) {
    const double high = with_end_slopes(curve, to);
    sum += 0.5 * (low + high) * (to - from);
    from = to, low = high;
  };
  for (const double x : curve.x)
    if (x > 0.0 && x < end) add(x);
  add(end);
  return sum;
}

Curve turned_round(const Curve& curve) {
  Curve inverse;
  inverse.x = curve.y;
  inverse.y = curve.x;
  return inverse;
}

}  // namespace

double with_end_slopes(const Curve& curve, double at) {
  const double inside = std::clamp(at, curve.x.front(), curve.x.back());
  return curve.clamped(inside) + (at - inside) * std::max(0.0, curve.slope(at));
}

ThreadCurve::ThreadCurve(Curve loading, std::optional<Curve> unloading)
    : loading_(std::move(loading)), unloading_(std::move(unloading)) {
  if (unloading_) strain_of_ = turned_round(*unloading_);
  for (const Curve* curve : {&loading_, unloading_ ? &*unloading_ : nullptr})
    if (curve != nullptr)
      for (const double x : curve->x) steepest_ = std::max(steepest_, curve->slope(x));
}

double ThreadCurve::stress(double strain, double largest) const {
  if (!unloading_ || strain >= largest) return with_end_slopes(loading_, strain);
  const double end = with_end_slopes(*strain_of_, with_end_slopes(loading_, largest));
  const double on_the_way = end <= largest ? strain - (largest - end) : strain * (end / largest);
  return on_the_way >= 0.0 ? with_end_slopes(*unloading_, on_the_way)
                           : std::min(with_end_slopes(loading_, strain), 0.0);
}

double ThreadCurve::dissipated(double largest) const {
  const double end = with_end_slopes(*strain_of_, with_end_slopes(loading_, largest));
  const double given = area_under(*unloading_, end) * (end <= largest ? 1.0 : largest / end);
  return area_under(loading_, largest) - given;
}

std::optional<double> ThreadCurve::gives_energy() const {
  if (!unloading_) return {};
  // Between these what is dissipated is smooth; it is looked at there, in between, and once the ends' slopes go on.
  std::vector<double> strains{0.0};
  for (const double x : loading_.x)
    if (x > 0.0) strains.push_back(x);
  for (const double y : unloading_->y)
    for (std::size_t i = 0; i + 1 < loading_.x.size(); ++i)
      if (const double low = loading_.y[i], high = loading_.y[i + 1]; (y > low && y < high) || (y < low && y > high))
        strains.push_back(loading_.x[i] + (y - low) / (high - low) * (loading_.x[i + 1] - loading_.x[i]));
  std::sort(strains.begin(), strains.end());
  strains.push_back(2.0 * strains.back());
  constexpr int parts = 4;
  const double least = 1e-9 * area_under(loading_, strains.back());
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < strains.size(); ++i)
    for (int k = 1; k <= parts; ++k) {
      const double strain = strains[i] + (strains[i + 1] - strains[i]) * k / parts;
      const double now = dissipated(strain);
      if (now < before - least) return strain;
      before = std::max(before, now);
    }
  return {};
}

}  // namespace nugget::kernel
