// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace nugget::app {

/// Wall time of one piece of work after the other.
class Clock {
 public:
  /// Since the last call, or since the clock was made.
  double seconds() {
    const auto now = std::chrono::steady_clock::now();
    const double s = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return s;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace nugget::app
