// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec3.hpp"

namespace nugget {

/// The global axis most across a unit vector: s of a beam begins in its direction where the deck says nothing else. Of
/// axes that are as far across, but for a thousandth, the first: a weld along z has x, whatever digits its ends have
/// lost in other units or where they were moved onto sheets.
inline Vec3d global_axis_across(const Vec3d& r) {
  constexpr double alike = 1e-3;
  const double x = std::abs(r.x), y = std::abs(r.y), z = std::abs(r.z);
  if (x <= std::min(y, z) + alike) return {1.0, 0.0, 0.0};
  return y <= z + alike ? Vec3d{0.0, 1.0, 0.0} : Vec3d{0.0, 0.0, 1.0};
}

/// The unit vector s with which a beam along the unit vector r begins: across it in the direction of `towards` (its
/// third node), or where that gives none, of the global axis.
inline Vec3d beam_side(const Vec3d& r, const Vec3d& towards) {
  const auto across = [&r](const Vec3d& a) { return a - dot(a, r) * r; };
  const Vec3d side = across(towards);
  return unit(dot(side, side) <= 1e-12 * dot(towards, towards) ? across(global_axis_across(r)) : side);
}

}  // namespace nugget
