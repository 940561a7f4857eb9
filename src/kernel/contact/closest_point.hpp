// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/vec3.hpp"

// The geometry of one contact pair: a node and a segment.
namespace nugget::kernel {

/// Corners of a contact segment. A triangle repeats its third corner.
using Corners = std::array<Vec3d, 4>;

/// The point of a segment that is closest to a point in space.
struct Foot {
  double xi = 0.0, eta = 0.0;      ///< natural coordinates, -1 to 1 (quadrilateral) or 0 to 1 (triangle)
  std::array<double, 4> weight{};  ///< shape functions there; their sum is 1
  Vec3d point;                     ///< the foot itself [length]
  Vec3d normal;                    ///< unit normal of the segment at the foot, right-handed by the order of its corners
  double distance = 0.0;           ///< from the point to the foot [length]
  unsigned boundary = 0;           ///< 0: inside the segment; else bit i is set for each corner that bounds the edge
                                   ///< (two bits) or is the corner (one bit) on which the foot lies
};

/// Shape functions of a segment at natural coordinates of Foot.
inline std::array<double, 4> shape_functions(bool triangle, double xi, double eta) {
  if (triangle) return {1.0 - xi - eta, xi, eta, 0.0};
  return {0.25 * (1.0 - xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 + eta),
          0.25 * (1.0 - xi) * (1.0 + eta)};
}

namespace detail {

/// Position along the edge from `a` to `b`, 0 to 1, that is closest to `x`.
inline double along_edge(const Vec3d& a, const Vec3d& b, const Vec3d& x) {
  const Vec3d e = b - a;
  const double length2 = dot(e, e);
  return length2 > 0.0 ? std::clamp(dot(x - a, e) / length2, 0.0, 1.0) : 0.0;
}

/// Moves the foot to the closest point of those of the segment's edges that are in `edges` (bit i: from corner i to the
/// next), and of their neighbours if it comes to lie on a corner.
inline void to_edges(const Corners& c, int corners, unsigned edges, const Vec3d& x, Foot& foot) {
  double best = std::numeric_limits<double>::infinity();
  unsigned done = 0;
  while (edges != done) {
    for (int i = 0; i < corners; ++i) {
      if (!((edges & ~done) >> i & 1u)) continue;
      done |= 1u << i;
      const int j = i + 1 < corners ? i + 1 : 0;
      const double s = along_edge(c[i], c[j], x);
      const Vec3d r = x - (c[i] + s * (c[j] - c[i]));
      const double d2 = dot(r, r);
      if (d2 >= best) continue;
      best = d2;
      foot.weight = {};
      foot.weight[i] = 1.0 - s;
      foot.weight[j] = s;
      foot.boundary = (s < 1.0 ? 1u << i : 0u) | (s > 0.0 ? 1u << j : 0u);
      if (s >= 1.0) edges |= 1u << j;
      if (s <= 0.0) edges |= 1u << (i > 0 ? i - 1 : corners - 1);
    }
  }
}

inline void set_natural_from_weights(const std::array<double, 4>& w, Foot& foot) {
  foot.xi = w[1] + w[2] - w[0] - w[3];
  foot.eta = w[2] + w[3] - w[0] - w[1];
}

inline Vec3d unit_or_zero(const Vec3d& a) {
  const double length = norm(a);
  return length > 0.0 ? (1.0 / length) * a : Vec3d{};
}

inline void on_triangle(const Corners& c, const Vec3d& x, Foot& foot) {
  const Vec3d u = c[1] - c[0], v = c[2] - c[0], r = x - c[0];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ru = dot(r, u), rv = dot(r, v);
  const double det = uu * vv - uv * uv;
  foot.xi = det > 0.0 ? (vv * ru - uv * rv) / det : -1.0;
  foot.eta = det > 0.0 ? (uu * rv - uv * ru) / det : -1.0;
  if (foot.xi >= 0.0 && foot.eta >= 0.0 && foot.xi + foot.eta <= 1.0) {
    foot.weight = shape_functions(true, foot.xi, foot.eta);
  } else {
    to_edges(c, 3, 0b111u, x, foot);
    foot.xi = foot.weight[1];
    foot.eta = foot.weight[2];
  }
  foot.normal = unit_or_zero(cross(u, v));
}

inline void on_quadrilateral(const Corners& c, const Vec3d& x, Foot& foot) {
  // p(xi, eta) = m + xi a + eta b + xi eta t; stationary distance by Newton's method. It is quadratic, so what is left
  // after a step is far smaller than the step: a foot 1e-6 away is found, one that cannot come back inside belongs to
  // an edge.
  const Vec3d m = 0.25 * (c[0] + c[1] + c[2] + c[3]), a = 0.25 * (c[1] + c[2] - c[0] - c[3]);
  const Vec3d b = 0.25 * (c[2] + c[3] - c[0] - c[1]), t = 0.25 * (c[0] + c[2] - c[1] - c[3]);
  double xi = foot.xi, eta = foot.eta;
  bool inside = false;
  for (int step = 0; step < 8; ++step) {
    const Vec3d g = a + eta * t, h = b + xi * t;
    const Vec3d r = x - (m + xi * a + eta * h);
    const double gg = dot(g, g), hh = dot(h, h), gh = dot(g, h) - dot(r, t), rg = dot(r, g), rh = dot(r, h);
    const double det = gg * hh - gh * gh;
    if (!(det > 0.0)) break;
    const double scale = 1.0 / det, dxi = scale * (hh * rg - gh * rh), deta = scale * (gg * rh - gh * rg);
    xi = std::clamp(xi + dxi, -3.0, 3.0);
    eta = std::clamp(eta + deta, -3.0, 3.0);
    const double outside = std::max(std::abs(xi), std::abs(eta)) - 1.0, change = std::abs(dxi) + std::abs(deta);
    inside = outside <= 0.0;
    if (change < 1e-6 || outside > change) break;
  }
  if (inside) {
    foot.xi = xi;
    foot.eta = eta;
    foot.weight = shape_functions(false, xi, eta);
  } else {
    // The distance being convex, the edges beyond which the foot lies hold the closest point, or lead to it over a
    // corner.
    const unsigned beyond =
        (eta < -1.0 ? 1u : 0u) | (xi > 1.0 ? 2u : 0u) | (eta > 1.0 ? 4u : 0u) | (xi < -1.0 ? 8u : 0u);
    to_edges(c, 4, beyond != 0 ? beyond : 0b1111u, x, foot);
    set_natural_from_weights(foot.weight, foot);
  }
  foot.normal = unit_or_zero(cross(a + foot.eta * t, b + foot.xi * t));
}

}  // namespace detail

/// The point of the segment that is closest to `x`, edges and corners included. A quadrilateral is the bilinear surface
/// through its corners. `xi`, `eta`: where to start looking, e.g. the foot of the cycle before.
inline Foot closest_point(const Corners& corners, bool triangle, const Vec3d& x, double xi = 0.0, double eta = 0.0) {
  Foot foot;
  foot.xi = xi;
  foot.eta = eta;
  if (triangle)
    detail::on_triangle(corners, x, foot);
  else
    detail::on_quadrilateral(corners, x, foot);
  for (int i = 0; i < 4; ++i) foot.point += foot.weight[i] * corners[i];
  foot.distance = norm(x - foot.point);
  return foot;
}

/// A distance that `x` surely has from the segment, cheap to find: that from the mean plane of the corners less their
/// warp (a bilinear surface stays between its corners), or that from the sphere around them.
inline double least_distance(const Corners& c, const Vec3d& x) {
  const Vec3d to_middle = x - 0.25 * ((c[0] + c[1]) + (c[2] + c[3]));
  const Vec3d p = c[2] - c[0], q = c[3] - c[1], n = cross(p, q), warp = 0.25 * ((c[0] + c[2]) - (c[1] + c[3]));
  const double nn = dot(n, n);
  const double above = std::abs(dot(to_middle, n)) - std::abs(dot(warp, n));
  // A corner is half its diagonal and the warp away from the middle, at most.
  const double beyond = norm(to_middle) - (0.5 * std::sqrt(std::max(dot(p, p), dot(q, q))) + norm(warp));
  return std::max(beyond, above > 0.0 ? above / std::sqrt(nn) : 0.0);
}

}  // namespace nugget::kernel
