// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <type_traits>

#include "kernel/element/hexahedron.hpp"
#include "kernel/law/composed_law_kernel.hpp"

// Geometry of an eight-node brick, common to its formulations. Included by their .cpp files only.
namespace nugget::kernel {

/// A nodal field as a sum of the patterns xi, eta, zeta, eta zeta, zeta xi, xi eta, xi eta zeta (the constant is left
/// out). The patterns are orthogonal, so that gradient, hourglass rates and forces are sums over seven coefficients
/// instead of eight nodes.
template <class R>
struct Patterns {
  Vec3<R> a, b, c, h[4];
};

template <class R>
[[gnu::always_inline]] inline Patterns<R> patterns_of(const Vec3<R> (&f)[8]) {
  struct Face {
    Vec3<R> one, a, b, ab;
  };
  const auto face = [&](int i) {
    const Vec3<R> s12 = f[i] + f[i + 1], d12 = f[i + 1] - f[i], s34 = f[i + 2] + f[i + 3], d34 = f[i + 2] - f[i + 3];
    return Face{s12 + s34, d12 + d34, s34 - s12, d34 - d12};
  };
  const Face low = face(0), up = face(4);
  const R eighth = R(0.125);
  return {eighth * (up.a + low.a),
          eighth * (up.b + low.b),
          eighth * (up.one - low.one),
          {eighth * (up.b - low.b), eighth * (up.a - low.a), eighth * (up.ab + low.ab), eighth * (up.ab - low.ab)}};
}

template <class R>
[[gnu::always_inline]] inline void nodes_of(const Patterns<R>& p, Vec3<R> (&f)[8]) {
  const auto face = [&](int i, const Vec3<R>& one, const Vec3<R>& a, const Vec3<R>& b, const Vec3<R>& ab) {
    const Vec3<R> minus = one - b, plus = one + b, near = a - ab, far = a + ab;
    f[i] = minus - near;
    f[i + 1] = minus + near;
    f[i + 2] = plus + far;
    f[i + 3] = plus - far;
  };
  face(0, -p.c, p.a - p.h[1], p.b - p.h[0], p.h[2] - p.h[3]);
  face(4, p.c, p.a + p.h[1], p.b + p.h[0], p.h[2] + p.h[3]);
}

/// A 3 x 3 matrix by rows.
template <class R>
struct Matrix {
  Vec3<R> x, y, z;
  Vec3<R> operator*(const Vec3<R>& u) const { return {dot(x, u), dot(y, u), dot(z, u)}; }
};

/// Half the angle of a step [rad], about its axis, as Hughes and Winget take it: tan of it to second order.
template <class R>
[[gnu::always_inline]] inline Vec3<R> half_turn(const Matrix<R>& l, double dt) {
  const double q = 0.25 * dt;
  return {q * (l.z.y - l.y.z), q * (l.x.z - l.z.x), q * (l.y.x - l.x.y)};
}

/// Hughes and Winget's rotation (I - W dt/2)^-1 (I + W dt/2), by rows; `a` is its half turn.
template <class R>
[[gnu::always_inline]] inline Frame<R> rotation_of(const Vec3<R>& a) {
  const R a2 = dot(a, a), s = 2.0 / (1.0 + a2), d = 1.0 - s * a2;
  return {{d + s * (a.x * a.x), s * (a.x * a.y - a.z), s * (a.x * a.z + a.y)},
          {s * (a.x * a.y + a.z), d + s * (a.y * a.y), s * (a.y * a.z - a.x)},
          {s * (a.x * a.z - a.y), s * (a.y * a.z + a.x), d + s * (a.z * a.z)}};
}

/// The rate of deformation (engineering shears) of the velocity gradient `l` in the middle of the step, in the axes of
/// the step's end: D + A D - D A, A v = a x v with the half turn `a`, exact to third order in it. Increments of stress
/// that lag behind by half a turn would make vibrations grow (docs/decisions/0028).
template <class R>
[[gnu::always_inline]] inline SolidTensor<R> rate_at_end(const Matrix<R>& l, const Vec3<R>& a) {
  const R xx = l.x.x, yy = l.y.y, zz = l.z.z, xy = l.x.y + l.y.x, yz = l.y.z + l.z.y, zx = l.x.z + l.z.x;
  return {xx + a.y * zx - a.z * xy,
          yy + a.z * xy - a.x * yz,
          zz + a.x * yz - a.y * zx,
          xy + 2.0 * a.z * (xx - yy) + a.y * yz - a.x * zx,
          yz + 2.0 * a.x * (yy - zz) + a.z * zx - a.y * xy,
          zx + 2.0 * a.y * (zz - xx) + a.x * xy - a.z * yz};
}

/// Square of the largest face's area.
template <class R>
[[gnu::always_inline]] inline R largest_face2(const Patterns<R>& x) {
  R most = R(0.0);
  const auto pair = [&](const Vec3<R>& a, const Vec3<R>& ha, const Vec3<R>& b, const Vec3<R>& hb) {
    const Vec3<R> up = cross(a + ha, b + hb), down = cross(a - ha, b - hb);
    most = max(most, max(dot(up, up), dot(down, down)));
  };
  pair(x.a, x.h[1], x.b, x.h[0]);
  pair(x.b, x.h[2], x.c, x.h[1]);
  pair(x.c, x.h[0], x.a, x.h[2]);
  return 16.0 * most;
}

/// Bulk viscosity, and the stable step with it, over the length that the step is made of. With V^(1/3) a flat brick is
/// damped beyond the stability of its step: at TSSFAC 0.9 and Q2 0.06 from sides of 5:1 on, and the run diverges
/// (docs/decisions/0008).
template <class R>
struct BulkViscosity {
  R pressure, step;

  [[gnu::always_inline]] BulkViscosity(const HexahedronProperties& brick, const R& wave_modulus, const R& density,
                                       const R& length, const R& trace) {
    const R c2 = wave_modulus / density, c = sqrt(c2), none = R(0.0);
    const auto compressed = trace < 0.0;
    const R viscous =
        density * length * (brick.bulk_quadratic * length * trace * trace - brick.bulk_linear * c * trace);
    pressure = select(compressed, viscous, none);
    // The linear viscosity counts in expansion too: a brick that breathes is compressed half a period later, and
    // LS-DYNA's first step of a brick at rest contains it (1.40796e-4 in the public example single_hex,
    // docs/evidence/single_hex.md).
    const R slow = brick.bulk_linear * c - select(compressed, brick.bulk_quadratic * length * trace, none);
    step = length / (slow + sqrt(slow * slow + c2));
  }
};

/// Hands the work of bulk viscosity to a law that it heats.
template <class R, class Law>
[[gnu::always_inline]] inline void heat_by_viscosity(const LawKernel<Law>& law, const R& pressure, const R& trace,
                                                     double dt, Number<R>* history) {
  const R work = R(-dt) * pressure * trace;
  if constexpr (requires { law.add_viscous_work(work, history); }) law.add_viscous_work(work, history);
}

/// Books what bulk viscosity takes from a volume that changes at the rate `trace`, as the work of nodal forces is
/// booked: by the mean of its pressures before and after the step. `rest`: see add_to_field.
template <class Layout, class R>
[[gnu::always_inline]] inline void book_viscosity(const R& pressure, const R& trace, const R& volume, double dt,
                                                  Number<R>* state, int rest = 0) {
  const R both = load_field<R>(state, Layout::bulk_pressure) + pressure;
  store_field(state, Layout::bulk_pressure, pressure);
  add_to_field<R>(state, Layout::bulk_viscosity_work, -((0.5 * dt) * (both * trace * volume)), rest);
}

/// A step of a brick in patterns: velocities, and the geometry in its middle and at its end. A deleted brick stands
/// still.
template <class R>
struct BrickStep {
  Patterns<R> v, mid, end;

  [[gnu::always_inline]] BrickStep(const SolidMotion<R>& nodes, double dt, const MaskOf<R>& alive)
      : v(patterns_of(nodes.v)), end(patterns_of(nodes.x)) {
    if (any(!alive))
      for (Vec3<R>* a : {&v.a, &v.b, &v.c, &v.h[0], &v.h[1], &v.h[2], &v.h[3]}) *a = select(alive, *a, Vec3<R>{});
    const R half = R(0.5 * dt);
    mid = {end.a - half * v.a,
           end.b - half * v.b,
           end.c - half * v.c,
           {end.h[0] - half * v.h[0], end.h[1] - half * v.h[1], end.h[2] - half * v.h[2], end.h[3] - half * v.h[3]}};
  }
};

/// Axes of a weld: r along the mean of the normals of the faces 1-2-3-4 and 5-6-7-8, so that shear does not tilt it, s
/// along xi (docs/theory/weld.md#axes-of-a-weld-of-bricks).
template <class R>
Frame<R> weld_axes(const Patterns<R>& x) {
  const Vec3<R> r = unit(cross(x.a, x.b) + cross(x.h[1], x.h[0])), s = unit(x.a - dot(x.a, r) * r);
  return {r, s, cross(r, s)};
}

/// Stress of a weld of uniaxial stress state, in global axes: rr, rs and rt only.
template <class R, class Law>
SolidTensor<R> section_stress(const LawKernel<Law>& law, const Matrix<R>& l, const Patterns<R>& mid,
                              const Patterns<R>& end, double dt, Number<R>* history) {
  const Frame<R> m = weld_axes(mid);
  const Vec3<R> along = l * m.e1;
  const FibreTensor<R> rate{dot(m.e1, along), dot(m.e2, along) + dot(m.e1, l * m.e2),
                            dot(m.e3, along) + dot(m.e1, l * m.e3)};
  const FibreTensor<R> f = law.section(rate, dt, history);
  const Frame<R> e = weld_axes(end);
  const Vec3<R>& r = e.e1;
  const Vec3<R> t = R(0.5) * f.rr * r + f.rs * e.e2 + f.rt * e.e3;  // sigma = r t + t r
  return {2.0 * (r.x * t.x),     2.0 * (r.y * t.y),     2.0 * (r.z * t.z),
          r.x * t.y + t.x * r.y, r.y * t.z + t.y * r.z, r.z * t.x + t.z * r.x};
}

/// sqrt(2/3 e:e) of the deviator; the shears of `d` are engineering shears.
template <class R>
R effective_rate(const SolidTensor<R>& d) {
  const R mean = (1.0 / 3.0) * (d.xx + d.yy + d.zz), x = d.xx - mean, y = d.yy - mean, z = d.zz - mean;
  return sqrt((2.0 / 3.0) * (x * x + y * y + z * z) + (1.0 / 3.0) * (d.xy * d.xy + d.yz * d.yz + d.zx * d.zx));
}

/// Von Mises' stress.
inline double effective_stress(const SolidTensor<double>& s) {
  const double xy = s.xx - s.yy, yz = s.yy - s.zz, zx = s.zz - s.xx;
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * (s.xy * s.xy + s.yz * s.yz + s.zx * s.zx));
}

inline Patterns<double> patterns_of(const std::array<Vec3d, 8>& x) {
  const Vec3d nodes[8] = {x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
  return patterns_of<double>(nodes);
}

}  // namespace nugget::kernel
