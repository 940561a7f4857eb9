// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/yield_curve.hpp"

#include <algorithm>
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

  std::vector<double> starts;
  for (const Piece& piece : pieces_) starts.push_back(piece.x);
  intervals_ = Intervals(starts);
}

double YieldCurve::lowest() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) least = std::min(least, piece.y);
  return least;
}

}  // namespace nugget::kernel
