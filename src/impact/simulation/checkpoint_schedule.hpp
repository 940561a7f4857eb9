// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "impact/simulation/options.hpp"

namespace nugget::impact {

/// When a run last wrote a restart file, and whether another one is due between two cycles.
class CheckpointSchedule {
 public:
  /// One was written, or the run begins, at this cycle, model time and second of the clock.
  void written(long cycle, double time, double seconds) {
    asked_ = false;
    cycle_ = cycle;
    time_ = time;
    seconds_ = seconds;
  }
  /// Somebody wants one that is not due.
  void ask() { asked_ = true; }
  bool due(const Checkpoints& every, long cycle, double time, double seconds) const {
    return asked_ || (every.cycles > 0 && cycle / every.cycles > cycle_ / every.cycles) ||
           passed(time_, time, every.time) || passed(seconds_, seconds, 60.0 * every.minutes);
  }

 private:
  static bool passed(double before, double now, double interval) {
    return interval > 0.0 && std::floor(now / interval) > std::floor(before / interval);
  }

  bool asked_ = false;
  long cycle_ = 0;
  double time_ = 0.0, seconds_ = 0.0;
};

}  // namespace nugget::impact
