// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include "base/archive.hpp"

namespace nugget::weld {

/// The failure value of a weld over time: the largest one in each of at most 32 equal intervals from the start of the
/// run on. Intervals are as long as the first step at the beginning; when there is no room for another one, each two
/// become one, so that no peak is lost and no end time has to be known.
class FailureCourse {
 public:
  static constexpr int most = 32;

  void add(double time, double value) {
    if (!(time > 0.0)) return;
    if (interval_ == 0.0) interval_ = time;
    while (time >= most * interval_) merge();
    const int now = std::min(static_cast<int>(time / interval_), most - 1);
    filled_ = std::max(filled_, now + 1);
    largest_[now] = std::max(largest_[now], value);
  }
  void restart() { *this = {}; }

  double interval() const { return interval_; }  ///< [time]
  std::span<const double> largest() const { return {largest_.data(), static_cast<std::size_t>(filled_)}; }

  void archive(Archive& a) { a(interval_, filled_, largest_); }

 private:
  void merge() {
    for (int i = 0; i < most / 2; ++i) largest_[i] = std::max(largest_[2 * i], largest_[2 * i + 1]);
    std::fill(largest_.begin() + most / 2, largest_.end(), 0.0);
    filled_ = (filled_ + 1) / 2;
    interval_ *= 2.0;
  }

  double interval_ = 0.0;
  int filled_ = 0;
  std::array<double, most> largest_{};
};

}  // namespace nugget::weld
