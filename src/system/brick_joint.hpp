// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "base/vec3.hpp"
#include "kernel/element/weld_joint.hpp"
#include "weld/tie/joints.hpp"

namespace nugget::system {

/// The freedoms of a joint, as motions of one body: along r, s and t, about s and t through the weld's middle.
struct JointMotions {
  Frame3d axes;  ///< r, s, t
  Vec3d middle;

  bool turns(std::size_t i) const { return i >= 3; }
  Vec3d axis(std::size_t i) const {
    switch (turns(i) ? i - 2 : i) {
      case 0: return axes.e1;
      case 1: return axes.e2;
      default: return axes.e3;
    }
  }
  /// Velocity of the place `x` at a unit velocity in freedom i.
  Vec3d velocity(std::size_t i, const Vec3d& x) const { return turns(i) ? cross(axis(i), x - middle) : axis(i); }
};

/// The joint of a weld of one layer of bricks, in series with it (docs/theory/ties.md#joints-of-bricks): the bricks'
/// end faces move against the discs on the sheets that they follow by the motion of the joint.
struct BrickJoint {
  std::size_t weld = 0;  ///< in Ties::welds
  weld::Joint joint;
  /// Elastic stiffness of the bricks between rigid end faces, in each freedom on its own: forces and moments at the
  /// middle over what the second end moves there against the first.
  kernel::WeldJoint::Freedoms stiffness{};
  JointMotions motions;  ///< at the start
  /// Elastic motion of the joint in each freedom for the motion of the discs: for either end the translation at the
  /// middle and the rotation, global components.
  std::array<std::array<double, 12>, kernel::WeldJoint::size> elastic{};
};

/// Velocity of a point of a face and its spin: the rigid motion that fits those of its nodes best.
struct FaceMotion {
  Vec3d velocity, spin;
};
FaceMotion face_motion(std::span<const Vec3d> x, std::span<const Vec3d> v, const Vec3d& point);

}  // namespace nugget::system
