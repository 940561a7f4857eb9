// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/curve.hpp"
#include "base/intervals.hpp"

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
  const Piece& at(double plastic_strain) const { return pieces_[intervals_.at(plastic_strain)]; }
  double operator()(double plastic_strain) const {
    const Piece& p = at(plastic_strain);
    return p.y + p.slope * (plastic_strain - p.x);
  }
  const Piece& last() const { return pieces_.back(); }
  double lowest() const;
  bool straight() const { return pieces_.size() == 1; }
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  std::vector<Piece> pieces_;
  Intervals intervals_;
};

}  // namespace nugget::kernel
