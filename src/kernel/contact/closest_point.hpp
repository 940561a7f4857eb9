// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "base/batch.hpp"
#include "base/real.hpp"
#include "base/vec3.hpp"

// The geometry of one contact pair: a node and a segment.
namespace nugget::kernel {

/// Corners of a contact segment, or of `lanes<R>` segments side by side. A triangle repeats its third corner.
template <class R>
using CornersOf = std::array<Vec3<R>, 4>;
using Corners = CornersOf<double>;

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

/// Lane l of an `R` that stands in memory: no more than that lane is read.
template <class R>
double stored_lane(const R& a, int l) {
  static_assert(sizeof a == static_cast<std::size_t>(lanes<R>) * sizeof(double));
  double value;
  std::memcpy(&value, reinterpret_cast<const char*>(&a) + static_cast<std::size_t>(l) * sizeof value, sizeof value);
  return value;
}

/// Feet of `lanes<R>` points, each on a segment of its own.
template <class R>
struct Feet {
  R xi{}, eta{};
  std::array<R, 4> weight{};
  Vec3<R> point, normal;
  R distance{};
  R boundary{};  ///< the bits as a number

  Foot at(int l) const {
    Foot foot;
    put(l, foot);
    return foot;
  }
  void put(int l, Foot& foot) const {
    const auto number = [l](const R& a) { return stored_lane(a, l); };
    const auto vector = [&](const Vec3<R>& a) { return Vec3d{number(a.x), number(a.y), number(a.z)}; };
    foot.xi = number(xi);
    foot.eta = number(eta);
    for (std::size_t c = 0; c < 4; ++c) foot.weight[c] = number(weight[c]);
    foot.point = vector(point);
    foot.normal = vector(normal);
    foot.distance = number(distance);
    foot.boundary = static_cast<unsigned>(number(boundary));
  }
  void set(int l, const Foot& foot) {
    const auto vector = [l](Vec3<R>& a, const Vec3d& b) {
      set_lane(a.x, l, b.x);
      set_lane(a.y, l, b.y);
      set_lane(a.z, l, b.z);
    };
    set_lane(xi, l, foot.xi);
    set_lane(eta, l, foot.eta);
    for (std::size_t c = 0; c < 4; ++c) set_lane(weight[c], l, foot.weight[c]);
    vector(point, foot.point);
    vector(normal, foot.normal);
    set_lane(distance, l, foot.distance);
    set_lane(boundary, l, foot.boundary);
  }
};

/// Shape functions of a segment at natural coordinates of Foot.
template <class R>
std::array<R, 4> shape_functions(bool triangle, const R& xi, const R& eta) {
  if (triangle) return {1.0 - xi - eta, xi, eta, R(0.0)};
  return {0.25 * (1.0 - xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 - eta), 0.25 * (1.0 + xi) * (1.0 + eta),
          0.25 * (1.0 - xi) * (1.0 + eta)};
}

namespace detail {

template <class R>
R clamped(const R& a, double low, double high) {
  return min(max(a, R(low)), R(high));
}

/// Position along the edge from `a` to `b`, 0 to 1, that is closest to `x`.
template <class R>
R along_edge(const Vec3<R>& a, const Vec3<R>& b, const Vec3<R>& x) {
  const Vec3<R> e = b - a;
  const R length2 = dot(e, e);
  return select(length2 > 0.0, clamped(R(dot(x - a, e) / length2), 0.0, 1.0), R(0.0));
}

/// Moves the foot to the closest point of those of the segment's edges that are in `edges` (from corner i to the
/// next), and of their neighbours if it comes to lie on a corner.
template <int corners, class R>
void to_edges(const CornersOf<R>& c, std::array<MaskOf<R>, 4> edges, const Vec3<R>& x, Feet<R>& foot) {
  const auto next = [](int i) { return i + 1 < corners ? i + 1 : 0; };
  // All edges at once: the lanes want different ones, and the divisions need not wait for each other.
  std::array<R, 4> s, d2;
  for (int i = 0; i < corners; ++i) {
    const int j = next(i);
    s[i] = along_edge(c[i], c[j], x);
    const Vec3<R> r = x - (c[i] + s[i] * (c[j] - c[i]));
    d2[i] = dot(r, r);
  }
  R best(std::numeric_limits<double>::infinity()), edge(-1.0), along(0.0);
  const MaskOf<R> none = R(1.0) < R(0.0);
  std::array<MaskOf<R>, 4> done{none, none, none, none};
  for (MaskOf<R> left = !none; any(left);) {
    for (int i = 0; i < corners; ++i) {
      const int before = i > 0 ? i - 1 : corners - 1;
      const MaskOf<R> better = edges[i] && !done[i] && !(d2[i] >= best);
      done[i] = edges[i];
      best = select(better, d2[i], best);
      edge = select(better, R(i), edge);
      along = select(better, s[i], along);
      edges[next(i)] = edges[next(i)] || (better && s[i] >= 1.0);
      edges[before] = edges[before] || (better && s[i] <= 0.0);
    }
    left = none;
    for (int i = 0; i < corners; ++i) left = left || (edges[i] && !done[i]);
  }
  for (int i = 0; i < corners; ++i) {
    const int j = next(i);
    const MaskOf<R> here = edge >= i && edge <= i;
    foot.weight[i] = select(here, 1.0 - along, foot.weight[i]);
    foot.weight[j] = select(here, along, foot.weight[j]);
    const R boundary = select(along < 1.0, R(1u << i), R(0.0)) + select(along > 0.0, R(1u << j), R(0.0));
    foot.boundary = select(here, boundary, foot.boundary);
  }
}

template <class R>
Vec3<R> unit_or_zero(const Vec3<R>& a) {
  const R length = norm(a), scale = R(1.0) / length;
  const MaskOf<R> some = length > 0.0;
  const R zero(0.0);
  return {select(some, scale * a.x, zero), select(some, scale * a.y, zero), select(some, scale * a.z, zero)};
}

inline void on_triangle(const Corners& c, const Vec3d& x, Feet<double>& foot) {
  const Vec3d u = c[1] - c[0], v = c[2] - c[0], r = x - c[0];
  const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), ru = dot(r, u), rv = dot(r, v);
  const double det = uu * vv - uv * uv;
  foot.xi = det > 0.0 ? (vv * ru - uv * rv) / det : -1.0;
  foot.eta = det > 0.0 ? (uu * rv - uv * ru) / det : -1.0;
  if (foot.xi >= 0.0 && foot.eta >= 0.0 && foot.xi + foot.eta <= 1.0) {
    foot.weight = shape_functions(true, foot.xi, foot.eta);
  } else {
    to_edges<3>(c, {true, true, true, false}, x, foot);
    foot.xi = foot.weight[1];
    foot.eta = foot.weight[2];
  }
  foot.normal = unit_or_zero(cross(u, v));
}

template <class R>
void on_quadrilateral(const CornersOf<R>& c, const Vec3<R>& x, Feet<R>& foot) {
  // p(xi, eta) = m + xi a + eta b + xi eta t; stationary distance by Newton's method. It is quadratic, so what is left
  // after a step is far smaller than the step: a foot 1e-6 away is found, one that cannot come back inside belongs to
  // an edge.
  const Vec3<R> m = 0.25 * (c[0] + c[1] + c[2] + c[3]), a = 0.25 * (c[1] + c[2] - c[0] - c[3]);
  const Vec3<R> b = 0.25 * (c[2] + c[3] - c[0] - c[1]), t = 0.25 * (c[0] + c[2] - c[1] - c[3]);
  R xi = foot.xi, eta = foot.eta;
  MaskOf<R> inside = R(1.0) < R(0.0), moves = !inside;
  for (int step = 0; step < 8; ++step) {
    const Vec3<R> g = a + eta * t, h = b + xi * t;
    const Vec3<R> r = x - (m + xi * a + eta * h);
    const R gg = dot(g, g), hh = dot(h, h), gh = dot(g, h) - dot(r, t), rg = dot(r, g), rh = dot(r, h);
    const R det = gg * hh - gh * gh;
    moves = moves && det > 0.0;
    if (!any(moves)) break;
    const R scale = 1.0 / det, dxi = scale * (hh * rg - gh * rh), deta = scale * (gg * rh - gh * rg);
    xi = select(moves, clamped(R(xi + dxi), -3.0, 3.0), xi);
    eta = select(moves, clamped(R(eta + deta), -3.0, 3.0), eta);
    const R outside = max(abs(xi), abs(eta)) - 1.0, change = abs(dxi) + abs(deta);
    inside = (moves && outside <= 0.0) || (!moves && inside);
    moves = moves && !(change < 1e-6 || outside > change);
  }
  if (any(!inside)) {
    // The distance being convex, the edges beyond which the foot lies hold the closest point, or lead to it over a
    // corner.
    const MaskOf<R> out = !inside;
    std::array<MaskOf<R>, 4> edges{out && eta < -1.0, out && xi > 1.0, out && eta > 1.0, out && xi < -1.0};
    const MaskOf<R> all = out && !(edges[0] || edges[1] || edges[2] || edges[3]);
    for (MaskOf<R>& edge : edges) edge = edge || all;
    to_edges<4>(c, edges, x, foot);
  }
  const std::array<R, 4>& w = foot.weight;  // of the edges
  foot.xi = select(inside, xi, w[1] + w[2] - w[0] - w[3]);
  foot.eta = select(inside, eta, w[2] + w[3] - w[0] - w[1]);
  const std::array<R, 4> shape = shape_functions(false, xi, eta);
  for (int i = 0; i < 4; ++i) foot.weight[i] = select(inside, shape[i], foot.weight[i]);
  foot.normal = unit_or_zero(cross(a + foot.eta * t, b + foot.xi * t));
}

template <class R>
void place(const CornersOf<R>& corners, const Vec3<R>& x, Feet<R>& foot) {
  foot.point = {};
  for (int i = 0; i < 4; ++i) foot.point += foot.weight[i] * corners[i];
  foot.distance = norm(x - foot.point);
}

}  // namespace detail

/// The points of `lanes<R>` quadrilaterals that are closest to `x`, edges and corners included. A quadrilateral is the
/// bilinear surface through its corners. `xi`, `eta`: where to start looking, e.g. the feet of the cycle before.
template <class R>
void closest_points(const CornersOf<R>& corners, const Vec3<R>& x, const R& xi, const R& eta, Feet<R>& feet) {
  feet.xi = xi;
  feet.eta = eta;
  feet.weight = {};
  feet.boundary = R(0.0);
  detail::on_quadrilateral(corners, x, feet);
  detail::place(corners, x, feet);
}
template <class R>
Feet<R> closest_points(const CornersOf<R>& corners, const Vec3<R>& x, const R& xi, const R& eta) {
  Feet<R> feet;
  closest_points(corners, x, xi, eta, feet);
  return feet;
}

/// The same of one segment, which may be a triangle.
inline Foot closest_point(const Corners& corners, bool triangle, const Vec3d& x, double xi = 0.0, double eta = 0.0) {
  if (!triangle) return closest_points(corners, x, xi, eta).at(0);
  Feet<double> foot;
  detail::on_triangle(corners, x, foot);
  detail::place(corners, x, foot);
  return foot.at(0);
}

/// Whether the point of a segment that is closest to `x` is that of its edge from corner 0 to corner 1 (`edge` 1) or
/// its corner 0 (`edge` 0): by how much points may come closer to each other before it need not be so any more
/// [length]; 0 or less where it need not be now. It is so while no way from there to another corner leads towards `x`
/// by more than the angle whose sine is `tilt`. Of a warped segment that is asked of the hull of its corners.
template <class R>
R room_at_first(const CornersOf<R>& c, const R& edge, const Vec3<R>& x, const R& tilt) {
  const Vec3<R> there = c[0] + edge * detail::along_edge(c[0], c[1], x) * (c[1] - c[0]), r = x - there;
  const R distance = norm(r);
  // What a motion changes of the product that says how much a way leads towards `x`, for each length of the motion.
  const auto room = [&](const Vec3<R>& corner) {
    const Vec3<R> way = corner - there;
    const R length = norm(way), sum = length + distance;
    return select(sum > 0.0, (tilt * distance * length - dot(r, way)) / sum, R(0.0));
  };
  const R others = min(room(c[2]), room(c[3]));
  return select(edge > 0.0, others, min(room(c[1]), others));
}

/// A distance that `x` surely has from the segment, cheap to find: that from the mean plane of the corners less their
/// warp (a bilinear surface stays between its corners), or that from the sphere around them.
template <class R>
R least_distance(const CornersOf<R>& c, const Vec3<R>& x) {
  const Vec3<R> to_middle = x - 0.25 * ((c[0] + c[1]) + (c[2] + c[3]));
  const Vec3<R> p = c[2] - c[0], q = c[3] - c[1], n = cross(p, q), warp = 0.25 * ((c[0] + c[2]) - (c[1] + c[3]));
  const R nn = dot(n, n);
  const R above = abs(dot(to_middle, n)) - abs(dot(warp, n));
  // A corner is half its diagonal and the warp away from the middle, at most.
  const R beyond = norm(to_middle) - (0.5 * sqrt(max(dot(p, p), dot(q, q))) + norm(warp));
  return max(beyond, select(above > 0.0, above / sqrt(nn), R(0.0)));
}

}  // namespace nugget::kernel
