// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/archive.hpp"
#include "base/vec3.hpp"

namespace nugget {

/// Mean of a force over a period of sub-cycling, in which elements act by impulses: a result that shows it.
class PeriodMean {
 public:
  /// The mean of what was added since the period began, with `force`, which acts for `time`. `begins`: with this one.
  Vec3d add(const Vec3d& force, double time, bool begins) {
    if (begins) *this = {};
    impulse_ += time * force;
    time_ += time;
    return time_ > 0.0 ? (1.0 / time_) * impulse_ : force;
  }
  void archive(Archive& a) { a(impulse_, time_); }

 private:
  Vec3d impulse_;
  double time_ = 0.0;
};

}  // namespace nugget
