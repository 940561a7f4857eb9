// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/c0_triangle.hpp"

#include "kernel/element/shell_layers.hpp"
#include "kernel/law/prepared_compound.hpp"

namespace nugget::kernel {
namespace {

/// Frame and gradients of a triangle: f,x = f21 / x21, f,y = (f31 - x31 f,x) / y31 (y21 = 0).
template <class R>
struct Geometry {
  Frame<R> frame;
  R area, x21, x31, y31, over_x, over_y;

  explicit Geometry(const Vec3<R> (&x)[3]) {
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

/// What a triangle without free modes resists beside the rates at its point: the sum of the transverse shears around
/// its sides, which leaves the shear at the point alone, and the spins of its nodes about the normal relative to its
/// own.
template <class R>
struct Completion {
  R around{}, spin[3]{};
};

template <class R>
[[gnu::always_inline]] inline ShellRates<R> rates_on(const Geometry<R>& g, const NodalMotion<R, 3>& nodes,
                                                     Completion<R>& more) {
  const Vec3<R> v21 = g.frame.local(nodes.v[1] - nodes.v[0]), v31 = g.frame.local(nodes.v[2] - nodes.v[0]);
  const Vec3<R> w21 = g.frame.local(nodes.w[1] - nodes.w[0]), w31 = g.frame.local(nodes.w[2] - nodes.w[0]);
  const Vec3<R> w1 = g.frame.local(nodes.w[0]);
  const R vxx = g.dx(v21.x), vyx = g.dx(v21.y), wxx = g.dx(w21.x), wyx = g.dx(w21.y);
  const R wxy = g.dy(w31.x, wxx), wyy = g.dy(w31.y, wyx);

  // Shear along the edges times their lengths.
  const auto edge = [](const R& w, const R& x, const R& y, const R& ty, const R& tx) {
    return w + 0.5 * (x * ty - y * tx);
  };
  const R s12 = edge(v21.z, g.x21, R(0.0), 2.0 * w1.y + w21.y, R(0.0));
  const R s13 = edge(v31.z, g.x31, g.y31, 2.0 * w1.y + w31.y, 2.0 * w1.x + w31.x);
  const R s23 = edge(v31.z - v21.z, g.x31 - g.x21, g.y31, 2.0 * w1.y + w21.y + w31.y, 2.0 * w1.x + w21.x + w31.x);
  const R third = (1.0 / 3.0) * (s13 - s12 - s23);
  const R xz = g.dx(s12 + third), yz = g.dy(s13 - third, xz);

  const R vxy = g.dy(v31.x, vxx), turn = 0.5 * (vyx - vxy);
  more.around = s12 + s23 - s13;
  more.spin[0] = w1.z - turn;
  more.spin[1] = w1.z + w21.z - turn;
  more.spin[2] = w1.z + w31.z - turn;
  return {vxx, g.dy(v31.y, vyx), vxy + vyx, wyx, -wxy, wyy - wxx, xz, yz};
}

/// Forces against them at the end of the step, stored, and their work added up, in the state. The shear that varies
/// over the element is that of Lee and Bathe's MITC3, integrated: kappa G t (sum of sides^2) / (144 A).
template <class R>
[[gnu::always_inline]] inline Completion<R> complete(const ShellProperties& shell, const ElasticConstants& e,
                                                     const Geometry<R>& g, const Completion<R>& rate, double dt,
                                                     double* state) {
  using L = ShellLayout;
  const R t = load_field<R>(state, L::thickness), gt = e.shear * dt * t;
  const R sides2 = 2.0 * (g.x21 * g.x21 + g.x31 * g.x31 + g.y31 * g.y31 - g.x31 * g.x21);
  const R along = (shell.shear_factor / 144.0) * gt * sides2 / g.area, about = (shell.drilling / 3.0) * gt * (t * t);
  Completion<R> now;
  R power = R(0.0);
  const auto resist = [&](int i, const R& stiffness, const R& q, R& force) {
    const R old = load_field<R>(state, L::hourglass + i);
    force = old + stiffness * q;
    store_field(state, L::hourglass + i, force);
    power += (old + force) * q;
  };
  for (int i = 0; i < 3; ++i) resist(i, about, rate.spin[i], now.spin[i]);
  resist(3, along, rate.around, now.around);
  store_field(state, L::hourglass_energy, load_field<R>(state, L::hourglass_energy) + (0.5 * dt) * power);
  return now;
}

template <class R>
[[gnu::always_inline]] inline NodalForces<R, 3> forces_on(const Geometry<R>& g, const ShellResultants<R>& n,
                                                          const Completion<R>& more, const MaskOf<R>& alive) {
  const R bx = g.area * g.over_x, by3 = g.area * g.over_y, by2 = -by3 * g.x31 * g.over_x;
  const R along = bx * n.qx + by2 * n.qy, across = by3 * n.qy, third = (1.0 / 3.0) * (across - along);
  const R s12 = along + third + more.around, s13 = across - third - more.around, s23 = third + more.around;
  const R x32 = g.x31 - g.x21;
  // Drilling pulls on the rotation in the plane: by -1/2 of its sum on vy,x, by 1/2 on vx,y.
  const R twist = 0.5 * (more.spin[0] + more.spin[1] + more.spin[2]);
  const R twist_x = twist * g.over_x, twist_y = twist * g.over_y;
  Vec3<R> f2{bx * n.nxx + by2 * n.nxy - twist_y * g.x31 * g.over_x, by2 * n.nyy + bx * n.nxy - twist_x, s12 - s23};
  Vec3<R> f3{by3 * n.nxy + twist_y, by3 * n.nyy, s13 + s23};
  const R mx2 = by2 * n.myy + bx * n.mxy, my2 = bx * n.mxx + by2 * n.mxy, mx3 = by3 * n.myy, my3 = by3 * n.mxy;
  Vec3<R> m1{mx2 + mx3 - 0.5 * g.y31 * s13, 0.5 * (g.x21 * s12 + g.x31 * s13) - my2 - my3, more.spin[0]};
  Vec3<R> m2{-mx2 - 0.5 * g.y31 * s23, my2 + 0.5 * (g.x21 * s12 + x32 * s23), more.spin[1]};
  Vec3<R> m3{-mx3 - 0.5 * g.y31 * (s13 + s23), my3 + 0.5 * (g.x31 * s13 + x32 * s23), more.spin[2]};

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

}  // namespace

template <class R, class Law>
NodalForces<R, 3> triangle_cycle(const ShellProperties& shell, const Prepared<Law>& law, const NodalMotion<R, 3>& nodes,
                                 double dt, double* state) {
  using L = ShellLayout;
  const ElasticConstants& e = law.elastic();
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const R half = R(0.5 * dt);
  Vec3<R> middle[3];
  for (int i = 0; i < 3; ++i) middle[i] = nodes.x[i] - half * nodes.v[i];
  const Geometry<R> mid(middle), end(nodes.x);

  Completion<R> more;
  const ShellRates<R> rates = select(alive, rates_on(mid, nodes, more), ShellRates<R>{});
  if (shell.drilling > 0.0) {
    for (R* q : {&more.around, &more.spin[0], &more.spin[1], &more.spin[2]}) *q = select(alive, *q, R(0.0));
    more = complete(shell, e, mid, more, dt, state);
  } else {
    more = Completion<R>();
  }
  ShellResultants<R> n = advance_layers(shell, law, rates, dt, state, alive);
  if (shell.bulk_quadratic != 0.0 || shell.bulk_linear != 0.0) {
    const R viscous = viscous_membrane(shell, law, rates.xx + rates.yy, end.area, state);
    n.nxx -= viscous;
    n.nyy -= viscous;
  }

  const R scale = load_field<R>(state, L::density_scale) * (shell.density / e.plane);
  const R step = sqrt(length2(nodes.x, end.area, shell.length, e.nu) * scale);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), R(0.0)));

  NodalForces<R, 3> out = forces_on(end, n, more, alive);
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  return out;
}

namespace {

Geometry<double> geometry_of(const std::array<Vec3d, 3>& x) {
  const Vec3d nodes[3] = {x[0], x[1], x[2]};
  return Geometry<double>(nodes);
}

}  // namespace

Frame3d triangle_frame(const std::array<Vec3d, 3>& x) {
  return geometry_of(x).frame;
}

double triangle_area(const std::array<Vec3d, 3>& x) {
  return geometry_of(x).area;
}

double triangle_stable_step(const std::array<Vec3d, 3>& x, ShellLength length, double E, double nu, double density) {
  const Vec3d nodes[3] = {x[0], x[1], x[2]};
  return std::sqrt(length2(nodes, triangle_area(x), length, nu) * density * (1.0 - nu * nu) / E);
}

NodalMass triangle_nodal_mass(const std::array<Vec3d, 3>& x, double thickness, double density, double offset,
                              double mass_per_area) {
  const double area = triangle_area(x), arm = 0.5 * offset * thickness;
  const double mass = area * (density * thickness + mass_per_area) / 3.0;
  return {mass, mass * (std::max(thickness * thickness / 12.0, area / 8.0) + arm * arm)};
}

template NodalForces<double, 3> triangle_cycle(const ShellProperties&, const Prepared<Elastic>&,
                                               const NodalMotion<double, 3>&, double, double*);
template NodalForces<double, 3> triangle_cycle(const ShellProperties&, const Prepared<PlasticKinematic>&,
                                               const NodalMotion<double, 3>&, double, double*);
template NodalForces<double, 3> triangle_cycle(const ShellProperties&, const Prepared<PiecewiseLinear>&,
                                               const NodalMotion<double, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const Prepared<Elastic>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const Prepared<PlasticKinematic>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const Prepared<PiecewiseLinear>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<NativeBatch, 3> triangle_cycle(const ShellProperties&, const Prepared<Compound>&,
                                                    const NodalMotion<NativeBatch, 3>&, double, double*);
template NodalForces<Dual<18>, 3> triangle_cycle(const ShellProperties&, const Prepared<Elastic>&,
                                                 const NodalMotion<Dual<18>, 3>&, double, double*);

}  // namespace nugget::kernel
