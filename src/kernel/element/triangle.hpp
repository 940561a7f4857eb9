// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "kernel/element/shell_layers.hpp"

// Geometry of a three-node shell, and what its formulations have in common. Included by their .cpp files only.
namespace nugget::kernel {

/// Frame and gradients of a triangle. e1 is the mean of its sides, the second and the third turned back by 120 and 240
/// degrees: along side 1-2 of an equilateral one, and on any other it turns alike whichever node is the first, by what
/// the triangle turns in the mean (docs/theory/shell.md#frame). Gradients of the area coordinates of nodes 2 and 3 are
/// x2, y2 and x3, y3.
template <class R>
struct Triangle {
  Frame<R> frame;
  R area, x21, y21, x31, y31, x2, y2, x3, y3;

  explicit Triangle(const Vec3<R> (&x)[3]) {
    const Vec3<R> a = x[1] - x[0], b = x[2] - x[0], n = cross(a, b);
    const R twice = norm(n), over = 1.0 / twice;
    frame.e3 = over * n;
    frame.e1 = unit(a - R(third_root) * cross(frame.e3, b + (b - a)));
    frame.e2 = cross(frame.e3, frame.e1);
    x21 = dot(a, frame.e1);
    y21 = dot(a, frame.e2);
    x31 = dot(b, frame.e1);
    y31 = dot(b, frame.e2);
    x2 = over * y31;
    y2 = -(over * x31);
    x3 = -(over * y21);
    y3 = over * x21;
    area = 0.5 * twice;
  }
  R dx(const R& f21, const R& f31) const { return x2 * f21 + x3 * f31; }
  R dy(const R& f21, const R& f31) const { return y2 * f21 + y3 * f31; }
  /// How fast the frame turns about its normal at such velocities, which stand in the frame.
  R spin(const Vec3<R>& v21, const Vec3<R>& v31) const {
    const R length = x21 + R(third_root) * (y31 + (y31 - y21));
    return (v21.y - R(third_root) * (v31.x + (v31.x - v21.x))) / length;
  }

 private:
  static constexpr double third_root = 0.57735026918962576451;  // of 1/3
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
  const R vxx = g.dx(v21.x, v31.x), vyx = g.dx(v21.y, v31.y), wxx = g.dx(w21.x, w31.x), wyx = g.dx(w21.y, w31.y);
  const R wxy = g.dy(w21.x, w31.x), wyy = g.dy(w21.y, w31.y);

  const auto edge = [](const R& w, const R& x, const R& y, const R& ty, const R& tx) {
    return w + 0.5 * (x * ty - y * tx);
  };
  TriangleRates<R> r;
  r.side.s12 = edge(v21.z, g.x21, g.y21, 2.0 * w1.y + w21.y, 2.0 * w1.x + w21.x);
  r.side.s13 = edge(v31.z, g.x31, g.y31, 2.0 * w1.y + w31.y, 2.0 * w1.x + w31.x);
  r.side.s23 =
      edge(v31.z - v21.z, g.x31 - g.x21, g.y31 - g.y21, 2.0 * w1.y + w21.y + w31.y, 2.0 * w1.x + w21.x + w31.x);

  const R vxy = g.dy(v21.x, v31.x), turn = 0.5 * (vyx - vxy);
  r.spin[0] = w1.z - turn;
  r.spin[1] = w1.z + w21.z - turn;
  r.spin[2] = w1.z + w31.z - turn;
  r.constant = {vxx, g.dy(v21.y, v31.y), vxy + vyx, wyx, -wxy, wyy - wxx, R(0.0), R(0.0)};
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
  const R bx2 = g.area * g.x2, by2 = g.area * g.y2, bx3 = g.area * g.x3, by3 = g.area * g.y3;
  const auto& [s12, s13, s23] = side;
  const R x32 = g.x31 - g.x21, y32 = g.y31 - g.y21;
  // Drilling pulls on the rotation in the plane: by -1/2 of its sum on vy,x, by 1/2 on vx,y.
  const R twist = 0.5 * (drilling[0] + drilling[1] + drilling[2]);
  Vec3<R> f2{bx2 * n.nxx + by2 * n.nxy + twist * g.y2, by2 * n.nyy + bx2 * n.nxy - twist * g.x2, s12 - s23};
  Vec3<R> f3{bx3 * n.nxx + by3 * n.nxy + twist * g.y3, by3 * n.nyy + bx3 * n.nxy - twist * g.x3, s13 + s23};
  const R mx2 = by2 * n.myy + bx2 * n.mxy, my2 = bx2 * n.mxx + by2 * n.mxy;
  const R mx3 = by3 * n.myy + bx3 * n.mxy, my3 = bx3 * n.mxx + by3 * n.mxy;
  Vec3<R> m1{mx2 + mx3 - 0.5 * (g.y21 * s12 + g.y31 * s13), 0.5 * (g.x21 * s12 + g.x31 * s13) - my2 - my3, drilling[0]};
  Vec3<R> m2{-mx2 - 0.5 * (g.y21 * s12 + y32 * s23), my2 + 0.5 * (g.x21 * s12 + x32 * s23), drilling[1]};
  Vec3<R> m3{-mx3 - 0.5 * (g.y31 * s13 + y32 * s23), my3 + 0.5 * (g.x31 * s13 + x32 * s23), drilling[2]};

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
