// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/finding.hpp"
#include "base/vec3.hpp"
#include "model/parts.hpp"

namespace nugget::model {

/// *CONSTRAINED_RIGID_BODY_STOPPERS: bounds of the place and speed of a body's centre along a direction, or of its
/// angle [rad] and spin about one.
struct BodyStopper {
  /// A bound over time; none where there is no curve.
  struct Bound {
    Index curve = none;
    bool of_displacement = false;  ///< else of the place
  };
  Index body = none;
  Vec3d direction;  ///< unit vector
  bool rotation = false;
  Bound most, least;
  Index fastest = none;  ///< curve: the greatest speed, without its sign
  double birth = 0.0, death = 1e20;
  Place place;
};

}  // namespace nugget::model
