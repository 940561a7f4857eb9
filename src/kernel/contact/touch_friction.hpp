// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/vec3.hpp"
#include "kernel/contact/friction.hpp"

namespace nugget::kernel {

/// What has come to touch within a step: how the one side moves over the other, and what presses them apart.
struct Touch {
  Vec3d velocity;      ///< of the one side over the other [length/time]
  Vec3d direction;     ///< unit vector along which the one side is pressed away
  double depth = 0.0;  ///< by how much the surfaces overlap at the end of the step, all of it made in the step [length]
  double stiffness = 0.0;
  double normal_force = 0.0;
  double area = 0.0;
};

/// Friction on the one side in the cycle of the touch: the spring of sliding_spring() is drawn out by the way that the
/// sides make over each other in what is left of the step, depth / approach. Ours: without it friction would be late by
/// a cycle, and a bounce lasts but four or so (a fifth of its impulse).
inline Vec3d touch_friction(const Friction& law, const Touch& touch) {
  const double approach = -dot(touch.velocity, touch.direction);
  const Vec3d along = touch.velocity + approach * touch.direction;
  const double bound = law.bound(touch.normal_force, norm(along), touch.area);
  return sliding_spring({}, touch.stiffness, (touch.depth / approach) * along, bound);
}

}  // namespace nugget::kernel
