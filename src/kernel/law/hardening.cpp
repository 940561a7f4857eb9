// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/hardening.hpp"

#include <algorithm>
#include <utility>

namespace nugget::kernel {
namespace {

/// The curve up to `strain`, then level.
Curve levelled(const Curve& curve, double strain) {
  Curve level;
  level.id = curve.id;
  for (std::size_t i = 0; i < curve.x.size() && curve.x[i] < strain; ++i) {
    level.x.push_back(curve.x[i]);
    level.y.push_back(curve.y[i]);
  }
  for (const double x : {strain, strain + 1.0}) {
    level.x.push_back(x);
    level.y.push_back(curve.extrapolated(strain));
  }
  return level;
}

PiecewiseLinear curves_of(const Spotweld& law) {
  PiecewiseLinear curves;
  curves.yield = law.yield_curves;
  curves.rates = law.rates;
  curves.log_rates = law.log_rates;
  if (curves.yield.empty()) curves.yield = {{0, {0.0, 1.0}, {law.yield, law.yield + law.hardening}}};
  if (law.damage.freezes_yield)
    for (Curve& curve : curves.yield) curve = levelled(curve, law.failure_strain);
  return curves;
}

/// Those of the table, or the one curve times LCSR at each of its rates.
CurveHardening::Rates rates_of(const PiecewiseLinear& law) {
  CurveHardening::Rates rates{law.rates, law.yield};
  if (law.rate_scale.empty()) return rates;
  rates = {};
  const auto add = [&](double rate) {
    rates.values.push_back(rate);
    Curve& curve = rates.curves.emplace_back(law.yield.front());
    for (double& y : curve.y) y *= law.rate_scale.clamped(rate);
  };
  add(0.0);
  for (const double rate : law.rate_scale.x)
    if (rate > 0.0) add(rate);
  return rates;
}

}  // namespace

WeldHardening::WeldHardening(const Spotweld& law)
    : CurveHardening(curves_of(law)), can_be_frozen_(law.yield_can_be_frozen) {}

CurveHardening::CurveHardening(const PiecewiseLinear& law) : CurveHardening(law, rates_of(law)) {}

CurveHardening::CurveHardening(const PiecewiseLinear& law, const Rates& rates)
    : curve_(rates.curves.front()),
      rate_(law.rate_c, law.rate_p, law.rate_yield),
      straight_(curve_.straight()),
      lowest_(curve_.lowest()) {
  if (rates.curves.size() < 2) return;
  std::vector<YieldCurve> curves;
  for (const Curve& curve : rates.curves) {
    curves.emplace_back(curve);
    lowest_ = std::min(lowest_, curves.back().lowest());
  }
  table_ = {curves, rates.values, law.log_rates};
}

}  // namespace nugget::kernel
