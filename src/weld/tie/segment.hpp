// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>

#include "base/vec3.hpp"

namespace nugget::weld {

/// How far beyond its border a segment still counts as lying under a node, in the parametric coordinate (MAXPAR).
inline constexpr double parametric_extension = 1.025;

/// The distance of what is nowhere near.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Corners of a segment in order; a triangle repeats its third.
using Corners = std::array<Vec3d, 4>;

/// Where a node meets a segment.
struct Foot {
  /// Bilinear coordinates in [-1, 1]; on a triangle the area coordinates of its corners 2 and 3.
  double xi = 0.0, eta = 0.0;
  std::array<double, 4> weight{};  ///< shape functions; on a triangle the fourth is 0
  Vec3d point;                     ///< sum of weight times corner [length]
  double gap = 0.0;                ///< from the node to `point` [length]
  double distance = 0.0;  ///< from the node to the closest point of the segment proper, borders included [length]
  bool over = false;      ///< the node's foot lies within the (extended) segment; false: `point` is on the border
};

/// Standard shape functions of the bilinear segment: N1 (-,-), N2 (+,-), N3 (+,+), N4 (-,+).
std::array<double, 4> shape_functions(double xi, double eta);

/// Closest-point projection of `x` onto the bilinear patch or triangle. Where the foot of the perpendicular lies beyond
/// the extended border, the closest point of the border is taken.
Foot project(const Corners& corner, bool triangle, const Vec3d& x);

/// Unit normal at the centre, by the right-hand rule; zero for a segment without area.
Vec3d normal(const Corners& corner);

/// The shorter diagonal (of a triangle: the shorter of the two sides at its third corner) [length].
double shorter_diagonal(const Corners& corner);

}  // namespace nugget::weld
