// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/law/law_kernel.hpp"
#include "kernel/law/material_axes.hpp"

// Material axes in the history of a point.
namespace nugget::kernel {

/// Where in the history of a point its material axes begin.
inline constexpr int first_axis_field = 1;

/// Material axes a, b, c of a solid's point, in its history.
template <class R>
Frame<R> load_solid_axes(const double* history) {
  const Vec3<R> a = load_vector<R>(history, first_axis_field), b = load_vector<R>(history, first_axis_field + 3);
  return {a, b, cross(a, b)};
}
template <class R>
void turn_solid_axes(const Frame<R>& q, double* history) {
  for (const int axis : {first_axis_field, first_axis_field + 3}) {
    const Vec3<R> v = load_vector<R>(history, axis);
    store_vector(history, axis, Vec3<R>{dot(q.e1, v), dot(q.e2, v), dot(q.e3, v)});
  }
}
/// A tensor with tensorial shears given in axes `a`, back in global ones.
template <class R>
SolidTensor<R> out_of_axes(const Frame<R>& a, const SolidTensor<R>& t) {
  return rotated(Frame<R>{{a.e1.x, a.e2.x, a.e3.x}, {a.e1.y, a.e2.y, a.e3.y}, {a.e1.z, a.e2.z, a.e3.z}}, t);
}
/// Increments of strain [1] in axes `a` from rates with engineering shears; tensorial shears.
template <class R>
SolidTensor<R> strain_in_axes(const Frame<R>& a, const SolidTensor<R>& rate, double dt) {
  SolidTensor<R> strain = R(dt) * rate;
  strain.xy *= R(0.5);
  strain.yz *= R(0.5);
  strain.zx *= R(0.5);
  return rotated(a, strain);
}

}  // namespace nugget::kernel
