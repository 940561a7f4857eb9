// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "base/vec3.hpp"

// The geometry of a pair of straight edges.
namespace nugget::kernel {

/// The two points, one on each edge, that are closest to each other.
struct EdgeFeet {
  double s = 0.0, t = 0.0;  ///< their places along the first and the second edge, 0 to 1
  Vec3d a, b;               ///< the points [length]
  double distance = 0.0;    ///< between them [length]
};

namespace detail {

/// Where on an edge of direction `e` (length squared `ee`) the point stands that is closest to one at `r` from its
/// start.
inline double foot_on_edge(const Vec3d& e, double ee, const Vec3d& r) {
  return ee > 0.0 ? std::clamp(dot(r, e) / ee, 0.0, 1.0) : 0.0;
}

/// Of parallel edges all points side by side are equally close; the middle of that stretch gives no couple.
inline double middle_of_overlap(const Vec3d& e, double ee, const Vec3d& to_b0, const Vec3d& to_b1) {
  const double first = dot(to_b0, e) / ee, last = dot(to_b1, e) / ee;
  const double low = std::clamp(std::min(first, last), 0.0, 1.0), high = std::clamp(std::max(first, last), 0.0, 1.0);
  return 0.5 * (low + high);
}

}  // namespace detail

/// Closest points of the edges from `a0` to `a1` and from `b0` to `b1`; one of them may be a mere point. After Ericson,
/// Real-Time Collision Detection (2005), 5.1.9; parallel edges (to 1e-10 in the square of the sine) as above.
inline EdgeFeet closest_points(const Vec3d& a0, const Vec3d& a1, const Vec3d& b0, const Vec3d& b1) {
  const Vec3d p = a1 - a0, q = b1 - b0, r = b0 - a0;
  const double pp = dot(p, p), qq = dot(q, q), pq = dot(p, q), pr = dot(p, r), qr = dot(q, r);
  const double det = pp * qq - pq * pq;
  EdgeFeet feet;
  if (det > 1e-10 * pp * qq)
    feet.s = std::clamp((pr * qq - qr * pq) / det, 0.0, 1.0);
  else if (pp > 0.0)
    feet.s = detail::middle_of_overlap(p, pp, r, r + q);
  // The best place on the second edge for this one on the first, and back again where it had to be moved to an end.
  feet.t = detail::foot_on_edge(q, qq, feet.s * p - r);
  if (feet.t <= 0.0 || feet.t >= 1.0) feet.s = detail::foot_on_edge(p, pp, r + feet.t * q);
  feet.a = a0 + feet.s * p;
  feet.b = b0 + feet.t * q;
  feet.distance = norm(feet.a - feet.b);
  return feet;
}

}  // namespace nugget::kernel
