// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "base/curve.hpp"

namespace nugget::kernel {

/// A cable between two points (*MAT_CABLE_DISCRETE_BEAM): it pulls and never pushes,
///   F = max(F0 + K (L - L0), 0),   K = E A / L0,
/// over its length L and its unstretched length L0; or F0 + A times a stress over the strain (L - L0) / L0. Unloading
/// follows loading. Source: LS-DYNA Keyword Manual.
struct Cable {
  double modulus = 0.0;      ///< E; of a curve its steepest slope [stress]
  double stiffness = 0.0;    ///< K where E is below 0 and stands for it [force/length]
  double preload = 0.0;      ///< F0 [force]
  Curve stress;              ///< LCID: nominal stress over strain, its ends go on straight; empty: E or K
  double most_strain = 0.0;  ///< MXEPS at which it breaks [1]; 0: none
  double most_force = 0.0;   ///< MXFRC [force]; 0: none

  bool needs_area() const { return !stress.empty() || modulus > 0.0; }
  void set_curve(const Curve& curve) {
    stress = curve;
    modulus = 0.0;
    for (std::size_t i = 1; i < curve.x.size(); ++i)
      modulus = std::max(modulus, (curve.y[i] - curve.y[i - 1]) / (curve.x[i] - curve.x[i - 1]));
  }
  double force(double length, double unstretched, double area) const {
    const double longer = length - unstretched;
    if (!stress.empty()) return std::max(preload + area * stress.extrapolated(longer / unstretched), 0.0);
    return std::max(preload + tangent(unstretched, area) * longer, 0.0);
  }
  /// The greatest slope of the force [force/length].
  double tangent(double unstretched, double area) const {
    return stiffness > 0.0 && stress.empty() ? stiffness : modulus * area / unstretched;
  }
  bool breaks(double length, double unstretched, double force) const {
    return (most_strain > 0.0 && length - unstretched > most_strain * unstretched) ||
           (most_force > 0.0 && force > most_force);
  }
};

}  // namespace nugget::kernel
