// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "kernel/law/stress_space.hpp"

// Symmetric tensors with tensorial shears, one at a time, for the laws that are computed point by point.
namespace nugget::kernel::tensor {

using Tensor = SolidTensor<double>;

/// Tensorial shears from engineering shears.
inline Tensor tensorial(const Tensor& d) {
  return {d.xx, d.yy, d.zz, 0.5 * d.xy, 0.5 * d.yz, 0.5 * d.zx};
}
inline Tensor plus(Tensor a, double x) {
  a.xx += x;
  a.yy += x;
  a.zz += x;
  return a;
}
inline double trace(const Tensor& a) {
  return a.xx + a.yy + a.zz;
}
inline Tensor deviator(const Tensor& a) {
  return plus(a, -trace(a) / 3.0);
}
/// a:a.
inline double square(const Tensor& a) {
  return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz + 2.0 * (a.xy * a.xy + a.yz * a.yz + a.zx * a.zx);
}
inline double determinant(const Tensor& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.zx) + a.zx * (a.xy * a.yz - a.yy * a.zx);
}
inline Tensor inverse(const Tensor& a) {
  const double over = 1.0 / determinant(a);
  return {over * (a.yy * a.zz - a.yz * a.yz), over * (a.xx * a.zz - a.zx * a.zx), over * (a.xx * a.yy - a.xy * a.xy),
          over * (a.zx * a.yz - a.xy * a.zz), over * (a.xy * a.zx - a.xx * a.yz), over * (a.xy * a.yz - a.zx * a.yy)};
}
/// a b of symmetric tensors that commute.
inline Tensor times(const Tensor& a, const Tensor& b) {
  return {a.xx * b.xx + a.xy * b.xy + a.zx * b.zx, a.xy * b.xy + a.yy * b.yy + a.yz * b.yz,
          a.zx * b.zx + a.yz * b.yz + a.zz * b.zz, a.xx * b.xy + a.xy * b.yy + a.zx * b.yz,
          a.xy * b.zx + a.yy * b.yz + a.yz * b.zz, a.xx * b.zx + a.xy * b.yz + a.zx * b.zz};
}
/// n a n.
inline double along(const Vec3d& n, const Tensor& a) {
  return n.x * n.x * a.xx + n.y * n.y * a.yy + n.z * n.z * a.zz +
         2.0 * (n.x * n.y * a.xy + n.y * n.z * a.yz + n.z * n.x * a.zx);
}

/// Six numbers of a history.
inline Tensor load(std::span<const double> h) {
  return {h[0], h[1], h[2], h[3], h[4], h[5]};
}
inline void store(std::span<double> h, const Tensor& a) {
  h[0] = a.xx, h[1] = a.yy, h[2] = a.zz, h[3] = a.xy, h[4] = a.yz, h[5] = a.zx;
}

}  // namespace nugget::kernel::tensor
