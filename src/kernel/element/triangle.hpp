// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "kernel/element/shell_layers.hpp"

// Geometry of a three-node shell, and what its formulations have in common. Included by their .cpp files only.
namespace nugget::kernel {

/// Frame and gradients of a triangle: f,x = f21 / x21, f,y = (f31 - x31 f,x) / y31 (y21 = 0).
template <class R>
struct Triangle {
  Frame<R> frame;
  R area, x21, x31, y31, over_x, over_y;

  explicit Triangle(const Vec3<R> (&x)[3]) {
    const Vec3<R> a = x[1] - x[0], b = x[2] - x[0], n = cross(a, b);
    const R twice = norm(n);
    x21 = norm(a);
    over_x = 1.0 / x21;
    frame.e3 = (1.0 / twice) * n;
    frame.e1 = over_x * a;
    frame.e2 = cross(frame.e3, frame.e1);
    x31 = dot(b, frame.e1);
    y31 = twice * over_x;
    over_y = 1.0 / y31;
    area = 0.5 * twice;
  }
  R dx(const R& f21) const { return f21 * over_x; }
  R dy(const R& f31, const R& fx) const { return (f31 - x31 * fx) * over_y; }
};

/// Transverse shears along the sides 1-2, 1-3 and 2-3, times their lengths.
template <class R>
struct SideShears {
  R s12{}, s13{}, s23{};
};

/// Strain rates of linear fields of velocity and spin, without transverse shears; shears of the sides; and the spins of
/// the nodes about the normal relative to the element's own.
template <class R>
struct TriangleRates {
  ShellRates<R> constant;
  SideShears<R> side;
  R spin[3]{};
};

/// None of elements that are not alive.
template <class R>
[[gnu::always_inline]] inline TriangleRates<R> rates_on(const Triangle<R>& g, const NodalMotion<R, 3>& nodes,
                                                        const MaskOf<R>& alive) {
  const Vec3<R> v21 = g.frame.local(nodes.v[1] - nodes.v[0]), v31 = g.frame.local(nodes.v[2] - nodes.v[0]);
  const Vec3<R> w21 = g.frame.local(nodes.w[1] - nodes.w[0]), w31 = g.frame.local(nodes.w[2] - nodes.w[0]);
  const Vec3<R> w1 = g.frame.local(nodes.w[0]);
  const R vxx = g.dx(v21.x), vyx = g.dx(v21.y), wxx = g.dx(w21.x), wyx = g.dx(w21.y);
  const R wxy = g.dy(w31.x, wxx), wyy = g.dy(w31.y, wyx);

  const auto edge = [](const R& w, const R& x, const R& y, const R& ty, const R& tx) {
    return w + 0.5 * (x * ty - y * tx);
  };
  TriangleRates<R> r;
  r.side.s12 = edge(v21.z, g.x21, R(0.0), 2.0 * w1.y + w21.y, R(0.0));
  r.side.s13 = edge(v31.z, g.x31, g.y31, 2.0 * w1.y + w31.y, 2.0 * w1.x + w31.x);
  r.side.s23 = edge(v31.z - v21.z, g.x31 - g.x21, g.y31, 2.0 * w1.y + w21.y + w31.y, 2.0 * w1.x + w21.x + w31.x);

  const R vxy = g.dy(v31.x, vxx), turn = 0.5 * (vyx - vxy);
  r.spin[0] = w1.z - turn;
  r.spin[1] = w1.z + w21.z - turn;
  r.spin[2] = w1.z + w31.z - turn;
  r.constant = {vxx, g.dy(v31.y, vyx), vxy + vyx, wyx, -wxy, wyy - wxx, R(0.0), R(0.0)};
  if (any(!alive)) {
    r.constant = select(alive, r.constant, ShellRates<R>{});
    for (R* q : {&r.side.s12, &r.side.s13, &r.side.s23, &r.spin[0], &r.spin[1], &r.spin[2]})
      *q = select(alive, *q, R(0.0));
  }
  return r;
}

/// Adds stiffness times rate to force i of those stored in the state (ShellLayout::hourglass), and twice its power to
/// `power`.
template <class R>
[[gnu::always_inline]] inline R resist(int i, const R& stiffness, const R& rate, double* state, R& power) {
  const R old = load_field<R>(state, ShellLayout::hourglass + i), force = old + stiffness * rate;
  store_field(state, ShellLayout::hourglass + i, force);
  power += (old + force) * rate;
  return force;
}

/// Moments against drilling at the end of the step; twice their power is added to `power`.
template <class R>
[[gnu::always_inline]] inline void resist_drilling(const ShellProperties& shell, const ElasticConstants& e,
                                                   const R& area, const R (&spin)[3], double dt, double* state,
                                                   R (&moment)[3], R& power) {
  const R t = load_field<R>(state, ShellLayout::thickness), gt = e.shear * dt * t;
  const R stiffness = (shell.drilling / 3.0) * gt * drilling_length2(t, area);
  for (int i = 0; i < 3; ++i) moment[i] = resist(i, stiffness, spin[i], state, power);
}

/// Nodal forces and moments that do the work of constant resultants, of forces on the shears of the sides and of
/// drilling moments on the rates of rates_on.
template <class R>
[[gnu::always_inline]] inline NodalForces<R, 3> forces_on(const Triangle<R>& g, const ShellResultants<R>& n,
                                                          const SideShears<R>& side, const R (&drilling)[3],
                                                          const MaskOf<R>& alive) {
  const R bx = g.area * g.over_x, by3 = g.area * g.over_y, by2 = -by3 * g.x31 * g.over_x;
  const auto& [s12, s13, s23] = side;
  const R x32 = g.x31 - g.x21;
  // Drilling pulls on the rotation in the plane: by -1/2 of its sum on vy,x, by 1/2 on vx,y.
  const R twist = 0.5 * (drilling[0] + drilling[1] + drilling[2]);
  const R twist_x = twist * g.over_x, twist_y = twist * g.over_y;
  Vec3<R> f2{bx * n.nxx + by2 * n.nxy - twist_y * g.x31 * g.over_x, by2 * n.nyy + bx * n.nxy - twist_x, s12 - s23};
  Vec3<R> f3{by3 * n.nxy + twist_y, by3 * n.nyy, s13 + s23};
  const R mx2 = by2 * n.myy + bx * n.mxy, my2 = bx * n.mxx + by2 * n.mxy, mx3 = by3 * n.myy, my3 = by3 * n.mxy;
  Vec3<R> m1{mx2 + mx3 - 0.5 * g.y31 * s13, 0.5 * (g.x21 * s12 + g.x31 * s13) - my2 - my3, drilling[0]};
  Vec3<R> m2{-mx2 - 0.5 * g.y31 * s23, my2 + 0.5 * (g.x21 * s12 + x32 * s23), drilling[1]};
  Vec3<R> m3{-mx3 - 0.5 * g.y31 * (s13 + s23), my3 + 0.5 * (g.x31 * s13 + x32 * s23), drilling[2]};

  const auto out_of = [&](const Vec3<R>& a) { return select(alive, g.frame.global(a), Vec3<R>{}); };
  NodalForces<R, 3> out;
  out.f[1] = out_of(f2);
  out.f[2] = out_of(f3);
  out.f[0] = -(out.f[1] + out.f[2]);
  out.m[0] = out_of(m1);
  out.m[1] = out_of(m2);
  out.m[2] = out_of(m3);
  return out;
}

template <class R>
R length2(const Vec3<R> (&x)[3], const R& area, ShellLength length, double nu) {
  R longest = R(0.0), shortest = R(std::numeric_limits<double>::infinity());
  for (int i = 0; i < 3; ++i) {
    const Vec3<R> side = x[(i + 1) % 3] - x[i];
    const R l2 = dot(side, side);
    longest = max(longest, l2);
    shortest = min(shortest, l2);
  }
  const R l2 = 4.0 * area * area / longest;
  return length == ShellLength::bar ? max(l2, shortest) * (1.0 / (1.0 - nu * nu)) : l2;
}

}  // namespace nugget::kernel
