// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "base/vec3.hpp"

// Local axes out of points and vectors, and tensors seen in them.
namespace nugget::model {

/// Local x along `x`, local z along x cross `in_plane`; false where the two are parallel or zero.
inline bool frame_from(const Vec3d& x, const Vec3d& in_plane, Frame3d& frame) {
  const Vec3d z = cross(x, in_plane);
  const double size = norm(x) * norm(in_plane);
  if (!(norm(z) > 1e-10 * size)) return false;
  frame.e1 = unit(x);
  frame.e3 = unit(z);
  frame.e2 = cross(frame.e3, frame.e1);
  return true;
}

/// The axes of three points: `on_axis` lies on the axis number `axis` (0 x, 1 y, 2 z) through `origin`, `in_plane` in
/// its plane with the next one (*DEFINE_COORDINATE_NODES). False where the points lie on a line.
inline bool frame_of_points(const Vec3d& origin, const Vec3d& on_axis, const Vec3d& in_plane, int axis,
                            Frame3d& frame) {
  Frame3d f;
  if (!frame_from(on_axis - origin, in_plane - origin, f)) return false;
  frame = axis == 0 ? f : axis == 1 ? Frame3d{f.e3, f.e1, f.e2} : Frame3d{f.e2, f.e3, f.e1};
  return true;
}

/// A symmetric tensor (xx xy xz yy yz zz) given in the axes of `frame`, in global axes.
inline std::array<double, 6> to_global(const std::array<double, 6>& t, const Frame3d& frame) {
  const auto times = [&](const Vec3d& a) {
    return Vec3d{t[0] * a.x + t[1] * a.y + t[2] * a.z, t[1] * a.x + t[3] * a.y + t[4] * a.z,
                 t[2] * a.x + t[4] * a.y + t[5] * a.z};
  };
  const Vec3d x{frame.e1.x, frame.e2.x, frame.e3.x}, y{frame.e1.y, frame.e2.y, frame.e3.y},
      z{frame.e1.z, frame.e2.z, frame.e3.z};
  return {dot(x, times(x)), dot(x, times(y)), dot(x, times(z)), dot(y, times(y)), dot(y, times(z)), dot(z, times(z))};
}

}  // namespace nugget::model
