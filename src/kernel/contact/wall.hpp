// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "base/vec3.hpp"

// One node and a rigid wall. Positions are relative to the wall's reference point, which may move: `from` at the start
// of a step, `to` where the node would stand at its end.
namespace nugget::kernel {

/// How a node must be pushed to stand on the wall at the end of the step: by `distance` along `normal`. A node that
/// starts behind the wall is only kept from going deeper.
struct WallPush {
  bool touching = false;
  Vec3d normal;           ///< outward unit normal of the wall where the node starts
  double distance = 0.0;  ///< [length]; negative only for a node that is welded to the wall
};

/// How a node is attached to the wall at the start of the step.
enum class WallAttachment : unsigned char { none, touching, welded };

/// Flat wall through the reference point; with edges, a rectangle from the reference point along `l` and `m`.
struct PlaneWall {
  Vec3d normal, l, m;
  double length_l = 0.0, length_m = 0.0;  ///< 0: without end in that direction [length]

  bool bounded() const { return length_l > 0.0 || length_m > 0.0; }
  bool within_edges(const Vec3d& p) const {
    const double a = dot(p, l), b = dot(p, m);
    return (length_l <= 0.0 || (a >= 0.0 && a <= length_l)) && (length_m <= 0.0 || (b >= 0.0 && b <= length_m));
  }
};

inline WallPush push(const PlaneWall& wall, const Vec3d& from, const Vec3d& to, WallAttachment attachment) {
  const double start = dot(from, wall.normal), end = dot(to, wall.normal);
  if (attachment == WallAttachment::welded) return {true, wall.normal, start - end};
  const double level = std::min(start, 0.0);
  if (end >= level) return {};
  if (wall.bounded()) {
    // A bounded wall stops only what comes through its face: a node behind it came around an edge.
    const double slack = 1e-9 * std::max(wall.length_l, wall.length_m);
    if (attachment == WallAttachment::none && start < -slack) return {};
    const double until_face = std::clamp(start / (start - end), 0.0, 1.0);
    if (!wall.within_edges(from + until_face * (to - from))) return {};
  }
  return {true, wall.normal, level - end};
}

/// Push along the outward normal at `from` that brings `to` to the round surface of `radius`; `from` and `to` measured
/// from the centre, or at right angles from the axis.
inline WallPush push_round(double radius, const Vec3d& from, const Vec3d& to, WallAttachment attachment) {
  if (attachment != WallAttachment::welded && dot(to, to) >= radius * radius) return {};
  const double start = norm(from);
  const double level = attachment == WallAttachment::welded ? start : std::min(start, radius);
  if (attachment != WallAttachment::welded && norm(to) >= level) return {};
  if (!(start > 0.0)) return {};  // on the axis: no direction is outward
  const Vec3d n = (1.0 / start) * from;
  const double b = dot(to, n);
  return {true, n, std::sqrt(std::max(0.0, b * b + level * level - dot(to, to))) - b};
}

/// Round bar around `axis` through the reference point, its length from there on along the axis, with flat ends.
struct CylinderWall {
  Vec3d axis;
  double radius = 0.0;
  double length = 0.0;  ///< 0: without end on both sides [length]
};

inline WallPush push(const CylinderWall& wall, const Vec3d& from, const Vec3d& to, WallAttachment attachment) {
  const double start = dot(from, wall.axis), end = dot(to, wall.axis);
  const Vec3d out = from - start * wall.axis;
  if (wall.length > 0.0 && attachment != WallAttachment::welded) {
    if (end < 0.0 || end > wall.length) return {};
    const double slack = 1e-9 * wall.length;
    const bool before = start<slack, behind = start> wall.length - slack;
    if ((before || behind) && norm(out) < wall.radius) {
      const PlaneWall face{before ? -wall.axis : wall.axis, {}, {}};
      const Vec3d origin = before ? Vec3d{} : wall.length * wall.axis;
      return push(face, from - origin, to - origin, attachment);
    }
  }
  return push_round(wall.radius, out, to - end * wall.axis, attachment);
}

struct SphereWall {
  double radius = 0.0;
};

inline WallPush push(const SphereWall& wall, const Vec3d& from, const Vec3d& to, WallAttachment attachment) {
  return push_round(wall.radius, from, to, attachment);
}

/// Block behind a face through the reference point: from there along `l` and `m`, and against `normal` to its depth.
/// Each length may be without end (0), then on both sides; a depth of 0 behind the face only.
struct PrismWall {
  Vec3d normal, l, m;
  double length_l = 0.0, length_m = 0.0, depth = 0.0;
};

inline WallPush push(const PrismWall& wall, const Vec3d& from, const Vec3d& to, WallAttachment attachment) {
  // Its faces: outward normal and distance from the reference point.
  struct Face {
    Vec3d normal;
    double at;
    bool there;
  };
  const Face faces[6] = {{wall.normal, 0.0, true},
                         {-wall.normal, wall.depth, wall.depth > 0.0},
                         {-wall.l, 0.0, wall.length_l > 0.0},
                         {wall.l, wall.length_l, wall.length_l > 0.0},
                         {-wall.m, 0.0, wall.length_m > 0.0},
                         {wall.m, wall.length_m, wall.length_m > 0.0}};
  const double slack = 1e-9 * (wall.length_l + wall.length_m + wall.depth);
  // The way of the node enters through the last face that it passes inwards, if it has not left by another before. A
  // node that is inside already is held where it is least deep.
  const Face *through = nullptr, *shallow = nullptr;
  double entry = -1.0, exit = 2.0, least = 0.0;
  for (const Face& f : faces) {
    if (!f.there) continue;
    const double start = dot(from, f.normal) - f.at, end = dot(to, f.normal) - f.at;
    if (start >= -slack) {
      if (end >= std::min(start, 0.0) && attachment != WallAttachment::welded) return {};
      const double when = std::max(0.0, start) / std::max(start - end, 1e-300);
      if (when > entry) entry = when, through = &f;
    } else {
      if (end > 0.0) exit = std::min(exit, start / (start - end));
      if (shallow == nullptr || start > least) least = start, shallow = &f;
    }
  }
  if (through == nullptr) through = shallow;
  if (attachment != WallAttachment::welded && entry > exit) return {};
  const double start = dot(from, through->normal) - through->at, end = dot(to, through->normal) - through->at;
  const double level = attachment == WallAttachment::welded ? start : std::min(start, 0.0);
  if (attachment != WallAttachment::welded && end >= level) return {};
  return {true, through->normal, level - end};
}

/// How far a node at `from`, which is not attached, has to travel at least until it can be pushed [length]; not above 0
/// where that is not known.
inline double clearance(const PlaneWall& wall, const Vec3d& from) {
  return dot(from, wall.normal);
}
inline double clearance(const CylinderWall& wall, const Vec3d& from) {
  return norm(from - dot(from, wall.axis) * wall.axis) - wall.radius;
}
inline double clearance(const SphereWall& wall, const Vec3d& from) {
  return norm(from) - wall.radius;
}
inline double clearance(const PrismWall& wall, const Vec3d& from) {
  return dot(from, wall.normal);
}

using WallShape = std::variant<PlaneWall, CylinderWall, SphereWall, PrismWall>;

/// Change of the sliding velocity `slip` that friction makes in a step in which the wall changes the normal velocity by
/// `normal_change` >= 0: against the slip, at most `coefficient` times that (Coulomb), never more than the slip itself.
inline Vec3d friction_change(const Vec3d& slip, double coefficient, double normal_change) {
  const double speed = norm(slip), limit = coefficient * normal_change;
  if (speed <= limit) return -slip;
  return (-limit / speed) * slip;
}

}  // namespace nugget::kernel
