// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/hardening.hpp"

#include <algorithm>

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
  if (law.damage.holds_yield)
    for (Curve& curve : curves.yield) curve = levelled(curve, law.failure_strain);
  return curves;
}

}  // namespace

WeldHardening::WeldHardening(const Spotweld& law)
    : CurveHardening(curves_of(law)), can_be_held_(law.yield_can_be_held) {}

YieldCurve::YieldCurve(const Curve& curve) {
  const double forever = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < curve.x.size(); ++i) {
    const double slope = (curve.y[i + 1] - curve.y[i]) / (curve.x[i + 1] - curve.x[i]);
    pieces_.push_back({curve.x[i], curve.x[i + 1], curve.y[i], slope});
  }
  if (pieces_.empty()) pieces_.push_back({curve.x.front(), forever, curve.y.front(), 0.0});
  if (pieces_.front().x > 0.0) pieces_.insert(pieces_.begin(), {0.0, pieces_.front().x, pieces_.front().y, 0.0});
  if (pieces_.back().slope < 0.0) pieces_.push_back({curve.x.back(), forever, curve.y.back(), 0.0});
  pieces_.front().y -= pieces_.front().slope * pieces_.front().x;
  pieces_.front().x = 0.0;
  pieces_.back().end = forever;
  if (pieces_.size() == 1) return;

  const std::size_t buckets = 4 * pieces_.size();
  buckets_per_strain_ = static_cast<double>(buckets) / pieces_.back().x;
  for (std::size_t b = 0; b < buckets; ++b) {
    const double strain = static_cast<double>(b) / buckets_per_strain_;
    int i = 0;
    while (strain >= pieces_[static_cast<std::size_t>(i)].end) ++i;
    first_.push_back(std::max(i - 1, 0));
  }
}

double YieldCurve::lowest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) least = std::min(least, piece.y);
  return least;
}

CurveHardening::CurveHardening(const PiecewiseLinear& law)
    : rates_(law.rates), log_rates_(law.log_rates), rate_{law.rate_c, law.rate_p}, rate_scale_(law.rate_scale) {
  for (const Curve& curve : law.yield) curves_.emplace_back(curve);
  rate_dependent_ = curves_.size() > 1 || rate_.active() || !rate_scale_.empty();
  straight_ = curves_.size() == 1 && curves_.front().straight();
  lowest_ = std::numeric_limits<double>::infinity();
  for (const YieldCurve& curve : curves_) lowest_ = std::min(lowest_, curve.lowest());
  if (!rate_scale_.empty()) lowest_ *= *std::min_element(rate_scale_.y.begin(), rate_scale_.y.end());
}

CurveHardening::Between CurveHardening::between(double rate) const {
  const std::size_t last = rates_.size() - 1;
  if (!(rate > rates_.front())) return {0, 0, 0.0, 0.0};
  if (rate >= rates_.back()) return {last, last, 0.0, 0.0};
  const auto high = static_cast<std::size_t>(std::upper_bound(rates_.begin(), rates_.end(), rate) - rates_.begin());
  const double a = rates_[high - 1], b = rates_[high];
  if (!log_rates_ || a <= 0.0) return {high - 1, high, (rate - a) / (b - a), 1.0 / (b - a)};
  const double span = std::log(b / a);
  return {high - 1, high, std::log(rate / a) / span, 1.0 / (rate * span)};
}

YieldCurve::Piece CurveHardening::between_curves(double plastic_strain, double rate) const {
  const Between table = between(rate);
  const YieldCurve::Piece low = curves_[table.low].at(plastic_strain), high = curves_[table.high].at(plastic_strain);
  const double x = std::max(low.x, high.x), w = table.weight;
  const double y_low = low.y + low.slope * (x - low.x), y_high = high.y + high.slope * (x - high.x);
  return {x, std::min(low.end, high.end), y_low + w * (y_high - y_low), low.slope + w * (high.slope - low.slope)};
}

double CurveHardening::rate_factor(double rate) const {
  double factor = rate_.active() ? rate_.factor(rate) : 1.0;
  if (!rate_scale_.empty()) factor *= rate_scale_.clamped(rate);
  return factor;
}

double CurveHardening::rate_factor_slope(double rate) const {
  const double scale = rate_scale_.empty() ? 1.0 : rate_scale_.clamped(rate);
  const bool inside = !rate_scale_.empty() && rate > rate_scale_.x.front() && rate < rate_scale_.x.back();
  const double viscous = rate_.active() ? rate_.factor(rate) : 1.0;
  const double viscous_slope = rate_.active() ? (viscous - 1.0) / (rate_.p * rate) : 0.0;
  return viscous_slope * scale + (inside ? viscous * rate_scale_.slope(rate) : 0.0);
}

YieldStress<double> CurveHardening::viscous(double plastic_strain, double increment, double dt) const {
  const double strain = plastic_strain + increment, rate = increment / dt;
  const YieldCurve::Piece p = curves_.size() > 1 ? between_curves(strain, rate) : curves_.front().at(strain);
  const double value = p.y + p.slope * (strain - p.x);
  double over_rate = 0.0;
  if (curves_.size() > 1) {
    const Between table = between(rate);
    const YieldCurve::Piece low = curves_[table.low].at(strain), high = curves_[table.high].at(strain);
    const double y_low = low.y + low.slope * (strain - low.x), y_high = high.y + high.slope * (strain - high.x);
    over_rate = table.weight_slope * (y_high - y_low);
  }
  const double factor = rate_factor(rate);
  return {value * factor, factor * (p.slope + over_rate / dt) + value * rate_factor_slope(rate) / dt};
}

}  // namespace nugget::kernel
