// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/rate_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace nugget::kernel {

RateTable::RateTable(const std::vector<YieldCurve>& curves, const std::vector<double>& rates, bool log_rates) {
  if (rates.front() > 0.0) stretches_.push_back({-1.0, 0.0, rates.front(), 0.0});
  const std::size_t last = rates.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const double low = rates[i], high = rates[i + 1];
    Stretch stretch{static_cast<double>(i), low, high - low, 0.0};
    if (log_rates && low > 0.0) stretch = {static_cast<double>(i), low, 0.0, std::log(high / low)};
    stretches_.push_back(stretch);
  }
  stretches_.push_back({static_cast<double>(last), rates.back(), 0.0, 0.0});

  std::set<double> corners{0.0};
  for (const YieldCurve& curve : curves)
    for (const YieldCurve::Piece& piece : curve.pieces()) corners.insert(piece.x);
  const std::vector<double> begins(corners.begin(), corners.end());
  corners_ = Intervals(begins);
  for (const double strain : begins)
    for (const Stretch& stretch : stretches_) {
      const auto curve = static_cast<std::size_t>(std::max(stretch.place, 0.0));
      const YieldCurve::Piece low = curves[curve].at(strain);
      const bool between = stretch.place >= 0.0 && curve < last;
      const YieldCurve::Piece high = between ? curves[curve + 1].at(strain) : low;
      const auto at = [&](const YieldCurve::Piece& piece) { return piece.y + piece.slope * (strain - piece.x); };
      cells_.push_back({at(low), at(high) - at(low), low.slope, high.slope - low.slope});
    }
  for (std::size_t i = 0; i < begins.size(); ++i) {
    const Cell& first_curve = cells(i)[at_first_curve()];
    const double end = i + 1 < begins.size() ? begins[i + 1] : std::numeric_limits<double>::infinity();
    rows_.push_back({begins[i], end, first_curve.y, first_curve.slope});
  }
}

}  // namespace nugget::kernel
