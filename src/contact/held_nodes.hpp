// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/vec3.hpp"

namespace nugget::contact {

/// What holds and drives nodes beside a wall, as supports and prescribed motions do.
class HeldNodes {
 public:
  /// Along these unit vectors, which are at right angles, the node keeps the velocity that it has been given.
  struct Held {
    std::array<Vec3d, 3> axes;
    int count = 0;

    /// What of a vector is free: across all axes.
    Vec3d free_part(Vec3d a) const {
      for (int k = 0; k < count; ++k) a -= dot(axes[k], a) * axes[k];
      return a;
    }
  };
  virtual ~HeldNodes() = default;
  virtual Held held(int node) const = 0;
  /// The node got this impulse, along its axes, from what holds it, while the wall pushed it [force*time]. Called for
  /// different nodes at one time.
  virtual void take_up(int node, const Vec3d& impulse) = 0;
};

}  // namespace nugget::contact
