// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "base/vec3.hpp"

namespace nugget::kernel {

/// The heights of an eight-node brick across its three pairs of faces, its volume over the area of the surface midway
/// between the two: the distance of the faces of any parallelepiped, however sheared. Below zero where the brick is
/// turned inside out.
class BrickHeights {
 public:
  /// `x`: corners in the order of LS-DYNA [length]; wedges and tetrahedra repeat theirs.
  explicit BrickHeights(const Vec3d (&x)[8]);

  double height(int pair) const { return height_[pair]; }  ///< [length]; infinite across a pair without area
  double least() const { return std::min({height_[0], height_[1], height_[2]}); }
  double volume() const { return volume_; }  ///< [length^3]
  /// Derivatives of the height across pair `pair` by the eight corners. As volumes and areas do not depend on where
  /// the brick is, they sum to nothing, and so do their moments.
  std::array<Vec3d, 8> gradient(int pair) const;

 private:
  std::array<Vec3d, 3> side_;          // xi, eta, zeta patterns of the geometry: half the mean edges
  std::array<Vec3d, 3> volume_side_;   // of the derivative of the volume
  std::array<Vec3d, 3> volume_twist_;  // the same, hourglass patterns
  std::array<Vec3d, 3> area_;          // of the surface midway
  std::array<double, 3> height_;
  double volume_;
};

}  // namespace nugget::kernel
