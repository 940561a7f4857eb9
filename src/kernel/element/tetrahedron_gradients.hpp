// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kernel/element/brick_patterns.hpp"

// Geometry of a four-node tetrahedron, common to its formulations. Included by their .cpp files only.
namespace nugget::kernel {

/// Gradients of the shape functions of nodes 1 to 3; that of node 4 balances them.
template <class R>
struct TetrahedronGradients {
  Vec3<R> b[3];
  R volume;

  [[gnu::always_inline]] explicit TetrahedronGradients(const Vec3<R> (&x)[4]) {
    const Vec3<R> p = x[0] - x[3], q = x[1] - x[3], r = x[2] - x[3];
    b[0] = cross(q, r);
    b[1] = cross(r, p);
    b[2] = cross(p, q);
    // Right-handed 1-2-3 with 4 above: the triple product is negative.
    const R triple = dot(p, b[0]), over = 1.0 / triple;
    for (Vec3<R>& g : b) g = over * g;
    volume = R(-1.0 / 6.0) * triple;
  }

  /// A bound from above of the largest eigenvalue of the sum of b b^T over the four nodes.
  R largest() const {
    const Vec3<R> last = b[0] + b[1] + b[2];
    SolidTensor<R> g{};
    for (const Vec3<R>& a : {b[0], b[1], b[2], last}) {
      g.xx += a.x * a.x;
      g.yy += a.y * a.y;
      g.zz += a.z * a.z;
      g.xy += a.x * a.y;
      g.yz += a.y * a.z;
      g.zx += a.z * a.x;
    }
    const R trace = g.xx + g.yy + g.zz;
    g = (1.0 / trace) * g;
    g = squared(squared(squared(g)));
    const R norm2 = g.xx * g.xx + g.yy * g.yy + g.zz * g.zz + 2.0 * (g.xy * g.xy + g.yz * g.yz + g.zx * g.zx);
    return trace * sqrt(sqrt(sqrt(sqrt(norm2))));
  }

 private:
  static SolidTensor<R> squared(const SolidTensor<R>& g) {
    return {g.xx * g.xx + g.xy * g.xy + g.zx * g.zx, g.xy * g.xy + g.yy * g.yy + g.yz * g.yz,
            g.zx * g.zx + g.yz * g.yz + g.zz * g.zz, g.xx * g.xy + g.xy * g.yy + g.zx * g.yz,
            g.xy * g.zx + g.yy * g.yz + g.yz * g.zz, g.xx * g.zx + g.xy * g.yz + g.zx * g.zz};
  }
};

template <class R>
[[gnu::always_inline]] inline Matrix<R> velocity_gradient(const TetrahedronGradients<R>& g, const Vec3<R> (&v)[4]) {
  const Vec3<R> v1 = v[0] - v[3], v2 = v[1] - v[3], v3 = v[2] - v[3];
  const auto row = [&](R Vec3<R>::*i) { return v1.*i * g.b[0] + v2.*i * g.b[1] + v3.*i * g.b[2]; };
  return {row(&Vec3<R>::x), row(&Vec3<R>::y), row(&Vec3<R>::z)};
}

}  // namespace nugget::kernel
