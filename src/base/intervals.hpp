// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace nugget {

/// Finds in which of neighbouring intervals a number lies, in a few steps without a branch: equal buckets over all of
/// them say where to begin.
class Intervals {
 public:
  Intervals() = default;
  /// `starts`: where each interval begins, ascending; the first goes down to minus infinity, the last up to infinity.
  explicit Intervals(const std::vector<double>& starts) : ends_(starts.begin() + 1, starts.end()) {
    ends_.push_back(std::numeric_limits<double>::infinity());
    const double low = starts.front(), high = starts.back();
    if (!(high > low)) return;
    low_ = low;
    for (std::size_t buckets = 4 * starts.size();; buckets *= 2) {
      divide(buckets, low, high);
      if (steps_ <= 1 || buckets >= most_buckets) return;
    }
  }

  /// The number of the interval that begins at or below `value`; 0 where that is no number.
  std::size_t at(double value) const {
    const double bucket = (value - low_) * buckets_per_unit_;
    auto i = static_cast<std::size_t>(first_[static_cast<std::size_t>(std::min(bucket > 0.0 ? bucket : 0.0, top_))]);
    for (int step = 0; step < steps_; ++step) i += value >= ends_[i] ? 1 : 0;
    return i;
  }

 private:
  static constexpr std::size_t most_buckets = 1024;

  /// A value is put into a bucket with the error of a rounding: each begins, and ends, a little farther out.
  void divide(std::size_t buckets, double low, double high) {
    const double size = (high - low) / static_cast<double>(buckets), blur = 1e-6 * size;
    first_.clear();
    steps_ = 0;
    int last = 0;
    const auto advance = [&](int from, double value) {
      while (value >= ends_[static_cast<std::size_t>(from)]) ++from;
      return from;
    };
    for (std::size_t b = 0; b < buckets; ++b) {
      const double begin = low + static_cast<double>(b) * size;
      last = advance(last, begin - blur);
      first_.push_back(last);
      steps_ = std::max(steps_, advance(last, begin + size + blur) - last);
    }
    buckets_per_unit_ = 1.0 / size;
    top_ = static_cast<double>(buckets - 1);
  }

  std::vector<double> ends_;
  std::vector<int> first_{0};  // of each bucket, the interval in which it begins
  int steps_ = 0;              // at most to the interval that is sought
  double low_ = 0.0, buckets_per_unit_ = 0.0, top_ = 0.0;
};

}  // namespace nugget
