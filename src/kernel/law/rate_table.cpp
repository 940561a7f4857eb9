// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/rate_table.hpp"

#include <cmath>
#include <limits>
#include <set>

namespace nugget::kernel {

RateTable::RateTable(const std::vector<YieldCurve>& curves, const std::vector<double>& rates, bool log_rates)
    : curves_(static_cast<int>(curves.size())) {
  if (rates.front() > 0.0) stretches_.push_back({-1.0, 0.0, rates.front(), 0.0});
  const std::size_t last = rates.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const double low = rates[i], high = rates[i + 1];
    Stretch stretch{static_cast<double>(i), low, high - low, 0.0};
    if (log_rates && low > 0.0) stretch = {static_cast<double>(i), low, 0.0, std::log(high / low), std::log(low)};
    stretches_.push_back(stretch);
  }
  stretches_.push_back({static_cast<double>(last), rates.back(), 0.0, 0.0});

  std::set<double> corners{0.0};
  for (const YieldCurve& curve : curves)
    for (const YieldCurve::Piece& piece : curve.pieces()) corners.insert(piece.x);
  begins_.assign(corners.begin(), corners.end());
  corners_ = Intervals(begins_);
  for (const double strain : begins_)
    for (const YieldCurve& curve : curves) lines_.push_back(curve.at(strain));
  begins_.push_back(std::numeric_limits<double>::infinity());
}

}  // namespace nugget::kernel
