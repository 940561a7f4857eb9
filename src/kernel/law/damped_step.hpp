// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

// What foams and rubber by a test have in common from step to step.
namespace nugget::kernel {

/// Rates count as their mean over some steps, or the stress would follow each vibration: one step by this share, which
/// reaches as far back as a mean over twelve.
inline constexpr double weight_of_a_step = 2.0 / 13.0;

/// Modulus of a step that is stable with a damping stress too, a share `damping` of critical: 1 / (sqrt(1 + D^2) - D)^2
/// of the elastic one.
inline double with_damping(double modulus, double damping) {
  const double longer = std::sqrt(1.0 + damping * damping) + damping;
  return modulus * longer * longer;
}

}  // namespace nugget::kernel
