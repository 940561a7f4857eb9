// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "base/curve.hpp"

namespace nugget::kernel {

/// Stress over strain along a thread, or under shear [stress], [1]: up to the largest strain so far a way back, behind
/// it the curve of loading. The way back is the curve of unloading, shifted along the strain until it meets the point
/// that was reached; where that would be a shift to strains below 0, it is stretched along the strain instead, from 0
/// to that point (ours; the keyword manual names the curves and no more). Without one the way back is the way there.
/// Curves begin at 0, 0, and go on at both ends with their last slopes.
class ThreadCurve {
 public:
  explicit ThreadCurve(Curve loading, std::optional<Curve> unloading = {});

  /// Stress at `strain` where the largest so far was `largest`, at least 0.
  double stress(double strain, double largest) const;
  double steepest() const { return steepest_; }  ///< of the slopes of both [stress]
  /// The largest strain of loading at which it would take less energy than its way back gives, or at which going on
  /// gives energy; nothing where none does.
  std::optional<double> gives_energy() const;

 private:
  double dissipated(double largest) const;

  Curve loading_;
  std::optional<Curve> unloading_, strain_of_;  ///< the latter: the former's strain over its stress
  double steepest_ = 0.0;
};

/// Value of a curve that goes on with its last slopes at both ends.
double with_end_slopes(const Curve& curve, double at);

}  // namespace nugget::kernel
