// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/rate_table.hpp"

#include <utility>

namespace nugget::kernel {

RateTable::RateTable(std::vector<YieldCurve> curves, std::vector<double> rates, bool log_rates)
    : curves_(std::move(curves)) {
  if (rates.front() > 0.0) stretches_.push_back({-1.0, 0.0, rates.front(), 0.0, 0, 0});
  const std::size_t last = rates.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const double low = rates[i], high = rates[i + 1];
    Stretch stretch{static_cast<double>(i), low, high - low, 0.0, i, i + 1};
    if (log_rates && low > 0.0) stretch.span = 0.0, stretch.log_span = std::log(high / low);
    stretches_.push_back(stretch);
  }
  stretches_.push_back({static_cast<double>(last), rates.back(), 0.0, 0.0, last, last});
}

double RateTable::place(double plastic_strain, double stress) const {
  double low = curves_.front()(plastic_strain);
  if (stress <= low) return first();
  for (std::size_t i = 1; i < curves_.size(); ++i) {
    const double high = curves_[i](plastic_strain);
    if (stress < high) return static_cast<double>(i - 1) + (stress - low) / (high - low);
    low = high;
  }
  return last();
}

}  // namespace nugget::kernel
