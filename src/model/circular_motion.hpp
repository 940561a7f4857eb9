// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "base/vec3.hpp"
#include "model/loads.hpp"

namespace nugget::model {

/// Where a node is on its way around an axis: distance from it, and unit vectors away from it and around it.
struct PlaceOnCircle {
  double radius = 0.0;
  Vec3d outwards, around;
};

/// Place of `x` around the axis of a circular motion. On the axis itself the radius is 0 and the two vectors are any
/// two across it.
inline PlaceOnCircle place_on_circle(const PrescribedMotion& motion, const Vec3d& x) {
  const Vec3d& axis = motion.direction;
  const Vec3d arm = x - motion.center, out = arm - dot(arm, axis) * axis;
  PlaceOnCircle place;
  place.radius = norm(out);
  // What is left of coordinates that cancel out has no direction.
  const bool on_axis = place.radius <= 1e-12 * (norm(x) + norm(motion.center));
  if (on_axis) place.radius = 0.0;
  const Vec3d least = std::abs(axis.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  place.outwards = on_axis ? unit(least - dot(least, axis) * axis) : (1.0 / place.radius) * out;
  place.around = cross(axis, place.outwards);
  return place;
}

}  // namespace nugget::model
