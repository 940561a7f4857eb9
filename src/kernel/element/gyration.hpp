// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/laminate.hpp"

namespace nugget::kernel {

/// Courant number, the step over the length of an element by the speed of sound, for which rotary inertia is raised
/// (ours).
inline constexpr double stable_courant_number = 0.93;

/// Square of the radius of gyration that nodes need which stand at a distance `arm` from the middle of a section whose
/// own radius has the square `section`: not below the physical one [length^2]. Turning such a node stretches the
/// section, so that a wave along it and one that bends it are one vibration, of
///     w^2 = (2c/L)^2 q,   (q - 1) (q r^2 - arm^2 - section) = arm^2:
/// r is the one at which q is that of `stable_courant_number` (ours).
inline double eccentric_gyration2(double arm, double section) {
  if (arm == 0.0) return 0.0;
  const double q = 1.0 / (stable_courant_number * stable_courant_number);
  return arm * arm / (q - 1.0) + section / q;
}

/// The same for a shell whose nodes lie at offset * t / 2 from the mid-surface, also where they lie in the centre of
/// its stiffness. `section`: of one material.
inline double elastic_gyration2(const ThicknessProfile& profile, double offset, double thickness, double section) {
  const double arm = 0.5 * (profile.stiffness_centre - offset) * thickness, own = profile.stiffness_spread * section;
  return arm == 0.0 ? stable_courant_number * stable_courant_number * own : eccentric_gyration2(arm, own);
}

}  // namespace nugget::kernel
