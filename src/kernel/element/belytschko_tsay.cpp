// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/belytschko_tsay.hpp"

#include "kernel/element/gyration.hpp"
#include "kernel/element/quadrilateral.hpp"
#include "kernel/element/shell_layers.hpp"
#include "kernel/law/laminate_kernel.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// Generalised hourglass forces: in-plane x, y, out of plane, rotations x, y.
template <class R>
struct Hourglass {
  R x{}, y{}, z{}, rx{}, ry{};
};

template <class R>
struct Rates {
  ShellRates<R> d;
  Hourglass<R> q;
};

/// Unit normals at the nodes.
template <class R>
struct NodalNormals {
  Vec3<R> n[4];
  explicit NodalNormals(const Vec3<R> (&x)[4]) {
    for (int i = 0; i < 4; ++i) n[i] = unit(cross(x[(i + 1) % 4] - x[i], x[(i + 3) % 4] - x[i]));
  }
  void remove_drilling(Vec3<R> (&a)[4]) const {
    for (int i = 0; i < 4; ++i) a[i] -= dot(a[i], n[i]) * n[i];
  }
};

/// Warping coupling (docs/theory/shell.md#warping-stiffness): curvature += c (x13 f13 + x42 f24) for x, likewise for y;
/// x13 = -2 A by24 and so on.
template <class R>
struct Warping {
  R x13, x24, y13, y24;
  explicit Warping(const Quadrilateral<R>& g) {
    const R c = g.h.z / g.area;  // 2 z_gamma / A^2 times 2 A, with z_gamma = h_z / 4
    x13 = c * g.by24;
    x24 = c * g.by13;
    y13 = -c * g.bx24;
    y24 = -c * g.bx13;
  }
};

template <class R>
[[gnu::always_inline]] inline Rates<R> rates_on(const Quadrilateral<R>& g, const Vec3<R> (&x)[4],
                                                const NodalMotion<R, 4>& nodes, bool warping) {
  const Differences<R> v = Differences<R>(nodes.v).in(g.frame);
  Vec3<R> spin[4] = {nodes.w[0], nodes.w[1], nodes.w[2], nodes.w[3]};
  if (warping) NodalNormals<R>(x).remove_drilling(spin);
  const Differences<R> w = Differences<R>(spin).in(g.frame);
  const Vec3<R> sum = (spin[0] + spin[2]) + (spin[1] + spin[3]);
  const R mean_x = 0.25 * dot(g.frame.e1, sum), mean_y = 0.25 * dot(g.frame.e2, sum);

  const R vxx = g.dx(v.d13.x, v.d24.x), vxy = g.dy(v.d13.x, v.d24.x);
  const R vyx = g.dx(v.d13.y, v.d24.y), vyy = g.dy(v.d13.y, v.d24.y);
  const R vzx = g.dx(v.d13.z, v.d24.z), vzy = g.dy(v.d13.z, v.d24.z);
  const R wxx = g.dx(w.d13.x, w.d24.x), wxy = g.dy(w.d13.x, w.d24.x);
  const R wyx = g.dx(w.d13.y, w.d24.y), wyy = g.dy(w.d13.y, w.d24.y);
  Rates<R> r;
  r.d = {vxx, vyy, vxy + vyx, wyx, -wxy, wyy - wxx, vzx + mean_y, vzy - mean_x};
  // A warped element's in-plane patterns are freed from the turning of its plane, vz,x and vz,y.
  r.q = {g.gamma(v.dh.x, vxx, vxy) + g.h.z * vzx, g.gamma(v.dh.y, vyx, vyy) + g.h.z * vzy, g.gamma(v.dh.z, vzx, vzy),
         g.gamma(w.dh.x, wxx, wxy), g.gamma(w.dh.y, wyx, wyy)};
  if (warping) {
    const Warping<R> c(g);
    r.d.kxx += c.x13 * v.d13.x + c.x24 * v.d24.x;
    r.d.kyy += c.y13 * v.d13.y + c.y24 * v.d24.y;
    r.d.kxy += c.x13 * v.d13.y + c.x24 * v.d24.y + c.y13 * v.d13.x + c.y24 * v.d24.x;
  }
  return r;
}

/// Hourglass forces at the end of the step (docs/theory/hourglass.md#shells); stored, and their work added up, in the
/// state.
///
/// The stiffness form is a share of the element's own elastic resistance to the pattern: 3 QM in its plane and 3/2 QB
/// in bending, both less once the element has yielded (see tangent_share), QW SHRF / 2 in twist.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> resist_hourglass(const ShellProperties& shell, const ShellLayout& layout,
                                                            const ElasticConstants& e, const Quadrilateral<R>& g,
                                                            const Hourglass<R>& rate, double dt, const R& tangent_share,
                                                            const R& living, Number<R>* state) {
  using L = ShellLayout;
  const R t = load_field<R>(state, L::thickness), t2 = t * t;
  const Hourglass<R> old{load_field<R>(state, L::hourglass), load_field<R>(state, L::hourglass + 1),
                         load_field<R>(state, L::hourglass + 2), load_field<R>(state, L::hourglass + 3),
                         load_field<R>(state, L::hourglass + 4)};
  Hourglass<R> now;
  if (shell.hourglass >= 4) {
    const R bb = 2.0 * (g.bx13 * g.bx13 + g.bx24 * g.bx24 + g.by13 * g.by13 + g.by24 * g.by24);
    const R step = dt * t, in_plane = tangent_share * (0.125 * e.E) * step * g.area * bb;
    const R membrane = shell.membrane_hourglass * in_plane;
    const R bending = (shell.bending_hourglass / 24.0) * t2 * in_plane;
    const R warping = living * ((shell.warping_hourglass * shell.shear_factor * e.shear / 12.0) * step * t2 * bb);
    now = {old.x + membrane * rate.x, old.y + membrane * rate.y, old.z + warping * rate.z, old.rx + bending * rate.rx,
           old.ry + bending * rate.ry};
  } else {
    const R density = shell.density * load_field<R>(state, L::density_scale);
    const R viscosity = 0.25 * t * sqrt(density * e.plane * g.area);  // rho c t sqrt(A) / 4
    const R membrane = shell.membrane_hourglass * viscosity, warping = shell.warping_hourglass * viscosity;
    const R bending = (shell.bending_hourglass / 12.0) * t2 * viscosity;
    now = {membrane * rate.x, membrane * rate.y, warping * rate.z, bending * rate.rx, bending * rate.ry};
  }
  store_field(state, L::hourglass, now.x);
  store_field(state, L::hourglass + 1, now.y);
  store_field(state, L::hourglass + 2, now.z);
  store_field(state, L::hourglass + 3, now.rx);
  store_field(state, L::hourglass + 4, now.ry);
  const R power = (old.x + now.x) * rate.x + (old.y + now.y) * rate.y + (old.z + now.z) * rate.z +
                  (old.rx + now.rx) * rate.rx + (old.ry + now.ry) * rate.ry;
  add_to_field(state, L::hourglass_energy, (0.5 * dt) * power, layout.rest_of_hourglass_energy());
  return now;
}

/// A shell that yields for the first time, and one of whose layers fail, loses the hourglass forces that its stiffness
/// no longer carries. `twist`: what is left of those in twist.
template <class R>
void soften(const R& share_before, const R& share_now, const R& twist, Hourglass<R>& q, Number<R>* state) {
  const auto softens = share_now < share_before;
  if (!any(softens)) return;
  const R left = select(softens, share_now / share_before, R(1.0));
  q.x = left * q.x;
  q.y = left * q.y;
  q.z = select(softens, twist, R(1.0)) * q.z;
  q.rx = left * q.rx;
  q.ry = left * q.ry;
  store_field(state, ShellLayout::hourglass, q.x);
  store_field(state, ShellLayout::hourglass + 1, q.y);
  store_field(state, ShellLayout::hourglass + 2, q.z);
  store_field(state, ShellLayout::hourglass + 3, q.rx);
  store_field(state, ShellLayout::hourglass + 4, q.ry);
}

/// Forces that do the work of the resultants and hourglass forces on the rates above.
template <class R>
[[gnu::always_inline]] inline NodalForces<R, 4> forces_on(const Quadrilateral<R>& g, const Vec3<R> (&x)[4],
                                                          const ShellResultants<R>& n, const Hourglass<R>& q,
                                                          bool warping, const MaskOf<R>& alive) {
  const R x13 = g.area * g.bx13, x24 = g.area * g.bx24, y13 = g.area * g.by13, y24 = g.area * g.by24;
  const R qx = n.qx * g.area + g.h.z * q.x, qy = n.qy * g.area + g.h.z * q.y;
  const R h13 = g.h.x * g.bx13 + g.h.y * g.by13, h24 = g.h.x * g.bx24 + g.h.y * g.by24;
  Vec3<R> f13{x13 * n.nxx + y13 * n.nxy - h13 * q.x, y13 * n.nyy + x13 * n.nxy - h13 * q.y,
              g.bx13 * qx + g.by13 * qy - h13 * q.z};
  Vec3<R> f24{x24 * n.nxx + y24 * n.nxy - h24 * q.x, y24 * n.nyy + x24 * n.nxy - h24 * q.y,
              g.bx24 * qx + g.by24 * qy - h24 * q.z};
  if (warping) {
    const Warping<R> c(g);
    f13 += g.area * Vec3<R>{c.x13 * n.mxx + c.y13 * n.mxy, c.y13 * n.myy + c.x13 * n.mxy, R(0.0)};
    f24 += g.area * Vec3<R>{c.x24 * n.mxx + c.y24 * n.mxy, c.y24 * n.myy + c.x24 * n.mxy, R(0.0)};
  }
  const auto bending = [&](const R& bx, const R& by, const R& h) {
    const R mx = -(by * n.myy + bx * n.mxy) - h * q.rx, my = bx * n.mxx + by * n.mxy - h * q.ry;
    return mx * g.frame.e1 + my * g.frame.e2;
  };
  const R quarter = 0.25 * g.area;
  Vec3<R> parts[7] = {g.frame.global(f13),
                      g.frame.global(f24),
                      g.frame.global({q.x, q.y, q.z}),
                      bending(x13, y13, h13),
                      bending(x24, y24, h24),
                      q.rx * g.frame.e1 + q.ry * g.frame.e2,
                      quarter * (n.qx * g.frame.e2 - n.qy * g.frame.e1)};
  if (any(!alive))
    for (Vec3<R>& part : parts) part = select(alive, part, Vec3<R>{});

  NodalForces<R, 4> out;
  const Vec3<R> none{};
  spread(parts[0], parts[1], parts[2], none, out.f);
  spread(parts[3], parts[4], parts[5], parts[6], out.m);
  if (warping) NodalNormals<R>(x).remove_drilling(out.m);
  return out;
}

}  // namespace

template <class R, class Law>
NodalForces<R, 4> shell_cycle(const ShellProperties& shell, const LawKernel<Law>& law, const NodalMotion<R, 4>& nodes,
                              double dt, Number<R>* state) {
  using L = ShellLayout;
  const ElasticConstants& e = law.elastic();
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const R half = R(shell.rates_at_end ? 0.0 : 0.5 * dt);
  Vec3<R> middle[4];
  for (int i = 0; i < 4; ++i) middle[i] = nodes.x[i] - half * nodes.v[i];
  const Quadrilateral<R> mid(middle), end(nodes.x);

  Rates<R> rates = rates_on(mid, middle, nodes, shell.warping_stiffness);
  if (any(!alive)) {
    rates.d = select(alive, rates.d, ShellRates<R>{});
    rates.q = {select(alive, rates.q.x, R(0.0)), select(alive, rates.q.y, R(0.0)), select(alive, rates.q.z, R(0.0)),
               select(alive, rates.q.rx, R(0.0)), select(alive, rates.q.ry, R(0.0))};
  }
  const ShellLayout layout = shell_layout(shell, law);
  const R share = tangent_share<R>(law, layout, state), living = intact_fraction<R>(law, layout, state);
  Hourglass<R> q = resist_hourglass(shell, layout, e, mid, rates.q, dt, share, living, state);
  ShellResultants<R> n = advance_layers(shell, law, layout, rates.d, dt, state, alive);
  if (shell.hourglass >= 4)
    soften(share, tangent_share<R>(law, layout, state), intact_fraction<R>(law, layout, state) / living, q, state);
  if (shell.bulk_quadratic != 0.0 || shell.bulk_linear != 0.0) {
    const R viscous = viscous_membrane(shell, law, rates.d.xx + rates.d.yy, end.area, state);
    n.nxx -= viscous;
    n.nyy -= viscous;
  }

  const R scale =
      load_field<R>(state, L::density_scale) * (shell.density / e.plane) / stiffening<R>(law, layout, state);
  const R step = sqrt(length2(nodes.x, end.area, shell.length, e.nu) * scale);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), R(0.0)));

  NodalForces<R, 4> out = forces_on(end, nodes.x, n, q, shell.warping_stiffness, alive);
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  return out;
}

namespace {

Quadrilateral<double> geometry_of(const std::array<Vec3d, 4>& x) {
  const Vec3d nodes[4] = {x[0], x[1], x[2], x[3]};
  return Quadrilateral<double>(nodes);
}

}  // namespace

Frame3d shell_frame(const std::array<Vec3d, 4>& x) {
  return geometry_of(x).frame;
}

double shell_area(const std::array<Vec3d, 4>& x) {
  return geometry_of(x).area;
}

double shell_stable_step(const std::array<Vec3d, 4>& x, ShellLength length, double E, double nu, double density) {
  const Vec3d nodes[4] = {x[0], x[1], x[2], x[3]};
  return std::sqrt(length2(nodes, shell_area(x), length, nu) * density * (1.0 - nu * nu) / E);
}

NodalMass shell_nodal_mass(const std::array<Vec3d, 4>& x, double thickness, double density, double offset,
                           double mass_per_area, double shear_share, const ThicknessProfile& profile) {
  const double area = shell_area(x), arm = 0.5 * (profile.mass_centre - offset) * thickness;
  const double mass = 0.25 * area * (density * thickness + mass_per_area);
  const double section2 = thickness * thickness / 12.0;
  double gyration2 = std::max(profile.mass_spread * section2, area / 8.0) + arm * arm;
  if (shear_share > 0.0) {
    gyration2 = std::max(gyration2, elastic_gyration2(profile, offset, thickness, section2));
    if (const double spin = 4.0 / (stable_courant_number * stable_courant_number) - 4.0 * shear_share; spin > 0.0) {
      const Vec3d nodes[4] = {x[0], x[1], x[2], x[3]};
      const double side2 = length2(nodes, area, ShellLength::area_over_side, 0.0);
      gyration2 = std::max(gyration2, shear_share * side2 / spin);
    }
  }
  return {mass, mass * gyration2};
}

template NodalForces<NativeBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<Elastic>&,
                                                 const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<PlasticKinematic>&,
                                                 const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                 const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<ComposedLaw>&,
                                                 const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<Laminate>&,
                                                 const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<SingleBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<Elastic>&,
                                                 const NodalMotion<SingleBatch, 4>&, double, float*);
template NodalForces<SingleBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<PlasticKinematic>&,
                                                 const NodalMotion<SingleBatch, 4>&, double, float*);
template NodalForces<SingleBatch, 4> shell_cycle(const ShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                 const NodalMotion<SingleBatch, 4>&, double, float*);

}  // namespace nugget::kernel
