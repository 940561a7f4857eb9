// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/loading_rates.hpp"

#include <algorithm>
#include <cmath>

#include "kernel/law/tensor_algebra.hpp"

namespace nugget::kernel {

LoadingRates loading_rates(const Principal& axes, const SolidTensor<double>& d, double dt, bool engineering) {
  const SolidTensor<double> rate = tensor::tensorial(d);
  LoadingRates now{{}, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const double true_rate = tensor::along(axes.direction[i], rate);
    const double stretch_then = std::sqrt(1.0 + axes.value[i]) / (1.0 + 0.5 * dt * true_rate);  // in mid-step
    now.of_each[i] = (axes.value[i] < 0.0 ? -1.0 : 1.0) * (engineering ? stretch_then : 1.0) * true_rate;
    if (std::abs(std::log1p(axes.value[i])) > std::abs(std::log1p(axes.value[now.most]))) now.most = i;
  }
  return now;
}

RatePlace rate_place(const std::vector<double>& rates, double rate) {
  const std::size_t last = rates.size() - 1;
  if (!(rate > rates.front())) return {};
  if (rate >= rates.back()) return {last, last, 0.0};
  const auto high = static_cast<std::size_t>(std::upper_bound(rates.begin(), rates.end(), rate) - rates.begin());
  return {high - 1, high, (rate - rates[high - 1]) / (rates[high] - rates[high - 1])};
}

}  // namespace nugget::kernel
