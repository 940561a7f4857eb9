// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/yield_curve.hpp"

#include <limits>

namespace nugget::kernel {

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
    while (strain >= pieces_[i].end) ++i;
    first_.push_back(std::max(i - 1, 0));
  }
}

double YieldCurve::lowest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) least = std::min(least, piece.y);
  return least;
}

}  // namespace nugget::kernel
