// SPDX-License-Identifier: Apache-2.0
#include "base/sae_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace nugget {
namespace {

/// Corner of the filter run both ways, over the class (SAE J211-1, appendix C).
constexpr double corner_of_class = 2.0775;

/// The signal at as many times, evenly spaced, on straight lines between its samples.
TimeHistory evenly_spaced(std::span<const double> times, std::span<const double> values) {
  const std::size_t count = times.size();
  if (count < 3) throw std::runtime_error("fewer than three samples cannot be filtered");
  for (std::size_t i = 1; i < count; ++i)
    if (!(times[i] > times[i - 1]))
      throw std::runtime_error(fmt::format(
          "times must ascend to be filtered; {:g} follows {:g} (too few digits: take binout)", times[i], times[i - 1]));
  const double step = (times[count - 1] - times[0]) / static_cast<double>(count - 1);
  TimeHistory even;
  std::size_t k = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = times[0] + static_cast<double>(i) * step, inside = std::min(t, times[count - 1]);
    while (k < count - 2 && times[k + 1] < inside) ++k;
    const double share = (inside - times[k]) / (times[k + 1] - times[k]);
    even.times.push_back(t);
    even.values.push_back(values[k] + share * (values[k + 1] - values[k]));
  }
  return even;
}

/// y(n) = a0 x(n) + a1 x(n-1) + a2 x(n-2) + b1 y(n-1) + b2 y(n-2)
struct Recursion {
  double a0, a1, a2, b1, b2;

  /// In place; the signal was `before` until its first value.
  template <class Iterator>
  void run(Iterator begin, Iterator end, double before) const {
    double x1 = before, x2 = before, y1 = before, y2 = before;
    for (; begin != end; ++begin) {
      const double x = *begin, y = a0 * x + a1 * x1 + a2 * x2 + b1 * y1 + b2 * y2;
      x2 = x1, x1 = x, y2 = y1, y1 = y;
      *begin = y;
    }
  }
};

}  // namespace

TimeHistory sae_filtered(std::span<const double> times, std::span<const double> values, int channel_class,
                         double second, double before) {
  TimeHistory signal = evenly_spaced(times, values);
  const double step = (signal.times[1] - signal.times[0]) / second, corner = corner_of_class * channel_class;
  if (corner * step >= 0.5)
    throw std::runtime_error(fmt::format("CFC {} needs samples closer than {:.3g} s; these are {:.3g} s apart",
                                         channel_class, 0.5 / corner, step));
  const double w = std::tan(std::numbers::pi * corner * step), c = 1.0 + std::numbers::sqrt2 * w + w * w;
  const Recursion filter{w * w / c, 2.0 * w * w / c, w * w / c, -2.0 * (w * w - 1.0) / c,
                         (-1.0 + std::numbers::sqrt2 * w - w * w) / c};
  filter.run(signal.values.begin(), signal.values.end(), before);
  filter.run(signal.values.rbegin(), signal.values.rend(), signal.values.back());
  return signal;
}

}  // namespace nugget
