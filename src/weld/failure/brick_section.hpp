// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "weld/failure/failure.hpp"
#include "weld/tie/ties.hpp"

namespace nugget::weld {

/// The cross-section of a weld of bricks while it moves: its own axes, its size, and what the nodal forces of its
/// bricks add up to on it (docs/theory/weld.md#axes-of-a-weld-of-bricks and
/// docs/theory/weld.md#resultants-of-a-weld-of-bricks).
///
/// r is the mean of the area-weighted normals of both end faces, from the first to the second. It does not follow the
/// line of their centres, which shear tilts. s is, for a single brick, the mean of the edges 1-2 and 4-3 of both end
/// faces, seen along r; t = r x s. An assembly's s starts in the direction of the global axis that is farthest from r,
/// as that of a weld beam, or of Weld::orientation, and is carried along by its first brick.
class BrickSection {
 public:
  /// `x`: positions at the start, by model node.
  BrickSection(const Weld& weld, const std::vector<Vec3d>& x);

  /// The nodes of both end faces, each once: the order in which positions and forces are given below.
  const std::vector<Index>& nodes() const { return nodes_; }

  struct Shape {
    Frame3d axes;                 ///< r, s, t
    std::array<Vec3d, 2> centre;  ///< of area, of both end faces
    double length = 0.0;          ///< between the centres, along r
    double area = 0.0;            ///< mean of both end faces, seen along r
  };
  Shape shape(std::span<const Vec3d> x) const;

  /// Resultants at mid-length, and the moments (M_rr M_ss M_tt) on the section at both end faces.
  struct Load {
    Resultants middle;
    std::array<Vec3d, 2> moment_at_end;
  };
  /// From the internal forces of the weld's bricks at its nodes. Exact by equilibrium, hourglass forces and bulk
  /// viscosity included; a moment at an end is that in the middle and the couple of the shear force: M -/+ L/2 r x N at
  /// the second and the first end.
  Load load(const Shape& shape, std::span<const Vec3d> x, std::span<const Vec3d> force) const;

 private:
  Frame3d frame(const Vec3d& r, std::span<const Vec3d> x) const;

  std::vector<Index> nodes_;  ///< those of the first face come first
  std::size_t of_first_face_ = 0;
  std::array<std::vector<std::array<std::size_t, 4>>, 2> facets_;  ///< positions in nodes_
  double cosine_ = 1.0, sine_ = 0.0;  ///< of the angle about r from the edges of the first brick to s
};

}  // namespace nugget::weld
