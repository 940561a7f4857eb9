// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "base/curve.hpp"

namespace nugget::kernel {

/// A yield curve made ready for fast look-up. Before the first point its ordinate holds; beyond the last the last slope
/// goes on if it hardens, otherwise the last ordinate holds (a yield stress does not become negative).
class YieldCurve {
 public:
  /// One straight piece: value `y` + `slope` (e - `x`) for `x` <= e < `end`.
  struct Piece {
    double x, end, y, slope;
  };

  explicit YieldCurve(const Curve& curve);
  const Piece& at(double plastic_strain) const {
    if (plastic_strain >= pieces_.back().x || pieces_.size() == 1) return pieces_.back();
    if (!(plastic_strain >= pieces_.front().end)) return pieces_.front();
    const auto bucket = std::min(static_cast<std::size_t>(plastic_strain * buckets_per_strain_), first_.size() - 1);
    auto i = static_cast<std::size_t>(first_[bucket]);
    while (plastic_strain >= pieces_[i].end) ++i;
    return pieces_[i];
  }
  double operator()(double plastic_strain) const {
    const Piece& p = at(plastic_strain);
    return p.y + p.slope * (plastic_strain - p.x);
  }
  const Piece& last() const { return pieces_.back(); }
  double lowest() const;
  bool straight() const { return pieces_.size() == 1; }

 private:
  std::vector<Piece> pieces_;
  std::vector<int> first_;  // the piece in which, or before which, each of equal buckets begins
  double buckets_per_strain_ = 0.0;
};

}  // namespace nugget::kernel
