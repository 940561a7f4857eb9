// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/brick_patterns.hpp"

// The uniform gradient of an eight-node brick and its hourglass patterns. Included by .cpp files only.
namespace nugget::kernel {

/// dV/dx_I by patterns, V times the uniform gradient b: the trilinear integral of Flanagan and Belytschko, written in
/// the patterns of the geometry. The coefficient of xi eta zeta is zero.
template <class R>
struct Gradient {
  Vec3<R> a, b, c, h[3];
  R volume, over_volume;

  [[gnu::always_inline]] explicit Gradient(const Patterns<R>& x) {
    const R third = R(1.0 / 3.0);
    a = cross(x.b, x.c) - third * cross(x.h[1], x.h[2]);
    b = cross(x.c, x.a) - third * cross(x.h[2], x.h[0]);
    c = cross(x.a, x.b) - third * cross(x.h[0], x.h[1]);
    h[0] = third * (cross(x.c, x.h[1]) - cross(x.b, x.h[2]));
    h[1] = third * (cross(x.a, x.h[2]) - cross(x.c, x.h[0]));
    h[2] = third * (cross(x.b, x.h[0]) - cross(x.a, x.h[1]));
    volume = (8.0 / 3.0) *
             (dot(x.a, a) + dot(x.b, b) + dot(x.c, c) + dot(x.h[0], h[0]) + dot(x.h[1], h[1]) + dot(x.h[2], h[2]));
    over_volume = 1.0 / volume;
  }
  /// Sum over nodes and directions of (V b)^2.
  R squared() const {
    return 8.0 * (dot(a, a) + dot(b, b) + dot(c, c) + dot(h[0], h[0]) + dot(h[1], h[1]) + dot(h[2], h[2]));
  }
};

/// Velocity gradient v_i,j.
template <class R>
[[gnu::always_inline]] inline Matrix<R> velocity_gradient(const Gradient<R>& g, const Patterns<R>& v) {
  const R scale = 8.0 * g.over_volume;
  const auto row = [&](R Vec3<R>::*i) {
    return scale *
           (v.a.*i * g.a + v.b.*i * g.b + v.c.*i * g.c + v.h[0].*i * g.h[0] + v.h[1].*i * g.h[1] + v.h[2].*i * g.h[2]);
  };
  return {row(&Vec3<R>::x), row(&Vec3<R>::y), row(&Vec3<R>::z)};
}

/// The stress on a plane of normal `n`.
template <class R>
[[gnu::always_inline]] inline Vec3<R> traction(const SolidTensor<R>& s, const Vec3<R>& n) {
  return {s.xx * n.x + s.xy * n.y + s.zx * n.z, s.xy * n.x + s.yy * n.y + s.yz * n.z,
          s.zx * n.x + s.yz * n.y + s.zz * n.z};
}

/// Rates of the four hourglass patterns eta zeta, zeta xi, xi eta, xi eta zeta, or the forces that do work on them.
template <class R>
struct Hourglass {
  Vec3<R> q[4];
};

/// Rates of the patterns less what the uniform gradient `l` makes of them: free of linear fields.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> hourglass_rates(const Patterns<R>& v, const Matrix<R>& l,
                                                           const Patterns<R>& x) {
  Hourglass<R> q;
  for (int i = 0; i < 4; ++i) q.q[i] = v.h[i] - l * x.h[i];
  return q;
}

/// Forces that do the work of stress and hourglass forces: V sigma_ij b_jI + sum_k Q_ik gamma_kI, gamma_k = h_k / 8 -
/// (x_k . b).
template <class R>
[[gnu::always_inline]] inline void forces_of(const Gradient<R>& g, const Patterns<R>& x, const SolidTensor<R>& s,
                                             const Hourglass<R>& q, bool orthogonal, Vec3<R> (&f)[8]) {
  Matrix<R> m{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  if (orthogonal)
    for (int i = 0; i < 4; ++i) {
      const Vec3<R> spread = g.over_volume * x.h[i];
      m.x -= q.q[i].x * spread;
      m.y -= q.q[i].y * spread;
      m.z -= q.q[i].z * spread;
    }
  const R eighth = R(0.125);
  Patterns<R> p{m * g.a, m * g.b, m * g.c, {m * g.h[0], m * g.h[1], m * g.h[2], {}}};
  for (int i = 0; i < 4; ++i) p.h[i] += eighth * q.q[i];
  nodes_of(p, f);
}

}  // namespace nugget::kernel
