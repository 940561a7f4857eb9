// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/full_shell.hpp"

#include "kernel/element/quadrilateral.hpp"
#include "kernel/element/shell_layers.hpp"
#include "kernel/law/laminate_kernel.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// The nodes, and the Gauss points at 1 / sqrt(3) of them, in natural coordinates.
constexpr double corner_xi[4] = {-1.0, 1.0, 1.0, -1.0}, corner_eta[4] = {-1.0, -1.0, 1.0, 1.0};
constexpr double gauss = 0.57735026918962576;

/// A quadrilateral with what the points in its plane need.
template <class R>
struct Surface : Quadrilateral<R> {
  R xi_x, xi_y, eta_x, eta_y;   ///< gradients of the natural coordinates at the centre
  Vec3<R> along_xi, along_eta;  ///< twice x,xi and x,eta at the centre: the mean sides

  [[gnu::always_inline]] explicit Surface(const Vec3<R> (&x)[4]) : Quadrilateral<R>(x) {
    xi_x = 2.0 * (this->bx24 - this->bx13);
    xi_y = 2.0 * (this->by24 - this->by13);
    eta_x = -2.0 * (this->bx13 + this->bx24);
    eta_y = -2.0 * (this->by13 + this->by24);
    const R half = 0.5 * this->area;
    along_xi = {half * eta_y, -half * eta_x, R(0.0)};
    along_eta = {-half * xi_y, half * xi_x, R(0.0)};
  }
  /// Gradient of xi eta, with the Jacobian at the centre.
  R hx(double xi, double eta) const { return eta * xi_x + xi * eta_x; }
  R hy(double xi, double eta) const { return eta * xi_y + xi * eta_y; }
  /// The sides 1-2, 4-3 (`xi`) and 1-4, 2-3 (`eta`); `upper`: the latter of each pair. In the plane of the frame.
  Vec3<R> side_xi(bool upper) const { return along_xi + R(upper ? 0.5 : -0.5) * this->h; }
  Vec3<R> side_eta(bool upper) const { return along_eta + R(upper ? 0.5 : -0.5) * this->h; }
};

/// x,xi and x,eta at a point, in the plane; the transverse shears are turned by it.
template <class R>
struct Tangents {
  R x_xi, y_xi, x_eta, y_eta;
  Tangents(const Surface<R>& s, double xi, double eta) {
    x_xi = 0.5 * s.along_xi.x + (0.25 * eta) * s.h.x;
    y_xi = 0.5 * s.along_xi.y + (0.25 * eta) * s.h.y;
    x_eta = 0.5 * s.along_eta.x + (0.25 * xi) * s.h.x;
    y_eta = 0.5 * s.along_eta.y + (0.25 * xi) * s.h.y;
  }
};

/// Rates of the patterns of the whole element: constant membrane strain and curvature; the hourglass patterns of
/// velocity (x, y) and spin (rx, ry); transverse shear on the sides.
template <class R>
struct PatternRates {
  ShellRates<R> constant;  ///< transverse shears unused
  R x{}, y{}, rx{}, ry{};
  R low_xi{}, high_xi{}, low_eta{}, high_eta{};
};

/// Forces that do work on them.
template <class R>
using PatternForces = PatternRates<R>;

/// Drilling of the four nodes: normals of the surface there in the element's frame, and the spins about them relative
/// to the element's.
template <class R>
struct Drilling {
  Vec3<R> normal[4];
  R spin[4];
};

/// Normals at the nodes, in the element's frame; without warping those of its plane.
template <class R>
void find_normals(const Surface<R>& s, bool warping, Drilling<R>& d) {
  for (int i = 0; i < 4; ++i) {
    if (!warping) {
      d.normal[i] = {R(0.0), R(0.0), R(1.0)};
      continue;
    }
    const R rise = -0.25 * s.h.z;
    d.normal[i] =
        unit(Vec3<R>{rise * s.hx(corner_xi[i], corner_eta[i]), rise * s.hy(corner_xi[i], corner_eta[i]), R(1.0)});
  }
}

/// Gradient of a nodal vector field in the element's frame.
template <class R>
struct GradientOf {
  R xx, xy, yx, yy, zx, zy;
  GradientOf(const Quadrilateral<R>& g, const Differences<R>& f)
      : xx(g.dx(f.d13.x, f.d24.x)),
        xy(g.dy(f.d13.x, f.d24.x)),
        yx(g.dx(f.d13.y, f.d24.y)),
        yy(g.dy(f.d13.y, f.d24.y)),
        zx(g.dx(f.d13.z, f.d24.z)),
        zy(g.dy(f.d13.z, f.d24.z)) {}
};

/// Rates of the patterns at a geometry; `drilling` receives the nodes' drilling where it is wanted.
template <class R>
[[gnu::always_inline]] inline PatternRates<R> rates_on(const Surface<R>& s, const NodalMotion<R, 4>& nodes,
                                                       const ShellProperties& shell, Drilling<R>& drilling) {
  const Differences<R> v = Differences<R>(nodes.v).in(s.frame);
  const GradientOf<R> gv(s, v);
  PatternRates<R> r;
  // A warped element's in-plane patterns are freed from the turning of its plane, vz,x and vz,y.
  r.x = 0.25 * (s.gamma(v.dh.x, gv.xx, gv.xy) + s.h.z * gv.zx);
  r.y = 0.25 * (s.gamma(v.dh.y, gv.yx, gv.yy) + s.h.z * gv.zy);

  Vec3<R> w[4];
  for (int i = 0; i < 4; ++i) w[i] = s.frame.local(nodes.w[i]);
  if (shell.warping_stiffness || shell.drilling > 0.0) {
    find_normals(s, shell.warping_stiffness, drilling);
    const Vec3<R> turn{gv.zy, -gv.zx, 0.5 * (gv.yx - gv.xy)};
    for (int i = 0; i < 4; ++i) {
      const R bent = s.hx(corner_xi[i], corner_eta[i]) * r.y - s.hy(corner_xi[i], corner_eta[i]) * r.x;
      drilling.spin[i] = dot(w[i] - turn, drilling.normal[i]) - bent;
      if (shell.warping_stiffness) w[i] -= drilling.spin[i] * drilling.normal[i];
    }
  }
  const Differences<R> dw(w);
  const GradientOf<R> gw(s, dw);
  r.constant = {gv.xx, gv.yy, gv.xy + gv.yx, gw.yx, -gw.xy, gw.yy - gw.xx, R(0.0), R(0.0)};
  r.rx = 0.25 * s.gamma(dw.dh.x, gw.xx, gw.xy);
  r.ry = 0.25 * s.gamma(dw.dh.y, gw.yx, gw.yy);

  // Half the shear along a side times its length.
  const auto side = [](const R& dz, const Vec3<R>& along, const Vec3<R>& spin) {
    return 0.5 * dz + 0.25 * (along.x * spin.y - along.y * spin.x);
  };
  const R z_xi = 0.5 * (v.d24.z - v.d13.z), z_eta = -0.5 * (v.d13.z + v.d24.z), zh = 0.5 * v.dh.z;
  r.low_xi = side(z_xi - zh, s.side_xi(false), w[0] + w[1]);
  r.high_xi = side(z_xi + zh, s.side_xi(true), w[2] + w[3]);
  r.low_eta = side(z_eta - zh, s.side_eta(false), w[0] + w[3]);
  r.high_eta = side(z_eta + zh, s.side_eta(true), w[1] + w[2]);
  return r;
}

/// Strain rates at a point of the plane.
template <class R>
[[gnu::always_inline]] inline ShellRates<R> rates_at(const Surface<R>& s, const PatternRates<R>& r, double nu,
                                                     double xi, double eta) {
  const R hx = s.hx(xi, eta), hy = s.hy(xi, eta);
  ShellRates<R> d = r.constant;
  d.xx += hx * r.x - nu * (hy * r.y);
  d.yy += hy * r.y - nu * (hx * r.x);
  d.kxx += hx * r.ry;
  d.kyy -= hy * r.rx;
  d.kxy += hy * r.ry - hx * r.rx;
  const Tangents<R> t(s, xi, eta);
  const R over = 1.0 / (t.x_xi * t.y_eta - t.y_xi * t.x_eta);
  const R g_xi = (0.5 * (1.0 + eta)) * r.high_xi + (0.5 * (1.0 - eta)) * r.low_xi;
  const R g_eta = (0.5 * (1.0 + xi)) * r.high_eta + (0.5 * (1.0 - xi)) * r.low_eta;
  d.xz = over * (t.y_eta * g_xi - t.y_xi * g_eta);
  d.yz = over * (t.x_xi * g_eta - t.x_eta * g_xi);
  return d;
}

/// Adds the work of a point's resultants to the forces on the patterns: the transpose of rates_at, times the point's
/// area, A / 4; for the transverse shears times its own Jacobian.
template <class R>
[[gnu::always_inline]] inline void collect(const Surface<R>& s, const ShellResultants<R>& n, double nu, double xi,
                                           double eta, PatternForces<R>& f) {
  const R quarter = 0.25 * s.area, hx = quarter * s.hx(xi, eta), hy = quarter * s.hy(xi, eta);
  f.constant.xx += quarter * n.nxx;
  f.constant.yy += quarter * n.nyy;
  f.constant.xy += quarter * n.nxy;
  f.constant.kxx += quarter * n.mxx;
  f.constant.kyy += quarter * n.myy;
  f.constant.kxy += quarter * n.mxy;
  f.x += hx * (n.nxx - nu * n.nyy);
  f.y += hy * (n.nyy - nu * n.nxx);
  f.rx -= hy * n.myy + hx * n.mxy;
  f.ry += hx * n.mxx + hy * n.mxy;
  const Tangents<R> t(s, xi, eta);
  const R q_xi = t.y_eta * n.qx - t.x_eta * n.qy, q_eta = t.x_xi * n.qy - t.y_xi * n.qx;
  f.high_xi += (0.5 * (1.0 + eta)) * q_xi;
  f.low_xi += (0.5 * (1.0 - eta)) * q_xi;
  f.high_eta += (0.5 * (1.0 + xi)) * q_eta;
  f.low_eta += (0.5 * (1.0 - xi)) * q_eta;
}

/// Drilling moments at the end of the step; stored, and their work added up, in the state.
template <class R>
[[gnu::always_inline]] inline void resist_drilling(const ShellProperties& shell, const ShellLayout& layout,
                                                   const ElasticConstants& e, const R& area, const R (&spin)[4],
                                                   double dt, Number<R>* state, R (&moment)[4]) {
  using L = ShellLayout;
  const R t = load_field<R>(state, L::thickness),
          stiffness = (0.25 * shell.drilling * e.shear * dt) * (drilling_length2(t, area) * t);
  R power = R(0.0);
  for (int i = 0; i < 4; ++i) {
    const R old = load_field<R>(state, L::hourglass + i);
    moment[i] = old + stiffness * spin[i];
    store_field(state, L::hourglass + i, moment[i]);
    power += (old + moment[i]) * spin[i];
  }
  add_to_field(state, L::hourglass_energy, (0.5 * dt) * power, layout.rest_of_hourglass_energy());
}

/// Nodal forces and moments that do the work of the forces on the patterns and of the drilling moments on the rates of
/// rates_on.
template <class R>
[[gnu::always_inline]] inline NodalForces<R, 4> forces_on(const Surface<R>& s, const ShellProperties& shell,
                                                          PatternForces<R>& f, const R (&drilling)[4],
                                                          const MaskOf<R>& alive) {
  const auto gradient = [&s](const R& fx, const R& fy) {
    return std::pair<R, R>{s.bx13 * fx + s.by13 * fy, s.bx24 * fx + s.by24 * fy};
  };
  const R h13 = s.h.x * s.bx13 + s.h.y * s.by13, h24 = s.h.x * s.bx24 + s.h.y * s.by24;

  // Moments on the spins that bend.
  const ShellRates<R>& c = f.constant;
  const auto [mx13, mx24] = gradient(-c.kxy, -c.kyy);
  const auto [my13, my24] = gradient(c.kxx, c.kxy);
  const R rx = 0.25 * f.rx, ry = 0.25 * f.ry;
  const R none = R(0.0);
  Vec3<R> m[4];
  spread(Vec3<R>{mx13 - h13 * rx, my13 - h13 * ry, none}, Vec3<R>{mx24 - h24 * rx, my24 - h24 * ry, none},
         Vec3<R>{rx, ry, none}, Vec3<R>{}, m);
  const auto arm = [](const Vec3<R>& along, const R& force) {
    return Vec3<R>{-0.25 * along.y * force, 0.25 * along.x * force, R(0.0)};
  };
  const Vec3<R> low_xi = arm(s.side_xi(false), f.low_xi), high_xi = arm(s.side_xi(true), f.high_xi);
  const Vec3<R> low_eta = arm(s.side_eta(false), f.low_eta), high_eta = arm(s.side_eta(true), f.high_eta);
  m[0] += low_xi + low_eta;
  m[1] += low_xi + high_eta;
  m[2] += high_xi + high_eta;
  m[3] += high_xi + low_eta;

  // Drilling hands the moments about the normals over to the turning of the element.
  Vec3<R> turning{};
  if (shell.warping_stiffness || shell.drilling > 0.0) {
    Drilling<R> d;
    find_normals(s, shell.warping_stiffness, d);
    for (int i = 0; i < 4; ++i) {
      R about = drilling[i];
      if (shell.warping_stiffness) about -= dot(m[i], d.normal[i]);
      m[i] += about * d.normal[i];
      turning += about * d.normal[i];
      f.x += about * s.hy(corner_xi[i], corner_eta[i]);
      f.y -= about * s.hx(corner_xi[i], corner_eta[i]);
    }
  }

  const R px = 0.25 * f.x, py = 0.25 * f.y, twist = 0.5 * turning.z;
  const auto [fx13, fx24] = gradient(c.xx, c.xy + twist);
  const auto [fy13, fy24] = gradient(c.xy - twist, c.yy);
  const auto [fz13, fz24] = gradient(s.h.z * px + turning.y, s.h.z * py - turning.x);
  // The sides' shears pull on vz: 1/4 (d24 - d13 -+ dh) along xi, -1/4 (d13 + d24 +- dh) along eta.
  const R sum_xi = 0.25 * (f.low_xi + f.high_xi), sum_eta = 0.25 * (f.low_eta + f.high_eta);
  const R pz = 0.25 * (f.high_xi - f.low_xi + (f.high_eta - f.low_eta));
  const Vec3<R> a13{fx13 - h13 * px, fy13 - h13 * py, fz13 - sum_xi - sum_eta};
  const Vec3<R> a24{fx24 - h24 * px, fy24 - h24 * py, fz24 + sum_xi - sum_eta};
  NodalForces<R, 4> out;
  Vec3<R> force[4];
  spread(a13, a24, Vec3<R>{px, py, pz}, Vec3<R>{}, force);
  for (int i = 0; i < 4; ++i) {
    out.f[i] = s.frame.global(force[i]);
    out.m[i] = s.frame.global(m[i]);
  }
  if (any(!alive))
    for (int i = 0; i < 4; ++i) {
      out.f[i] = select(alive, out.f[i], Vec3<R>{});
      out.m[i] = select(alive, out.m[i], Vec3<R>{});
    }
  return out;
}

}  // namespace

template <class R, class Law>
NodalForces<R, 4> full_shell_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                   const NodalMotion<R, 4>& nodes, double dt, Number<R>* state) {
  using L = ShellLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = full_shell_layout(shell, law);
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const R half = R(0.5 * dt);
  Vec3<R> middle[4];
  for (int i = 0; i < 4; ++i) middle[i] = nodes.x[i] - half * nodes.v[i];
  const Surface<R> mid(middle), end(nodes.x);

  Drilling<R> drilling;
  const PatternRates<R> rates = rates_on(mid, nodes, shell, drilling);
  R moment[4]{};
  if (shell.drilling > 0.0) {
    if (any(!alive))
      for (R& spin : drilling.spin) spin = select(alive, spin, R(0.0));
    resist_drilling(shell, layout, e, mid.area, drilling.spin, dt, state, moment);
  }

  const R t = load_field<R>(state, L::thickness);
  ShellResultants<R> n[4];
  ThicknessStrain<R> thinning;
  for (int p = 0; p < full_shell_columns; ++p) {
    ShellRates<R> d = rates_at(mid, rates, e.nu, gauss * corner_xi[p], gauss * corner_eta[p]);
    if (any(!alive)) d = select(alive, d, ShellRates<R>{});
    const Column<R> column = advance_column(shell, law, d, t, dt, state + layout.layer(0, p) * lanes<R>);
    n[p] = column.n;
    thinning.total += 0.25 * column.thinning.total;
    thinning.plastic += 0.25 * column.thinning.plastic;
  }
  if (law.can_fail()) alive = alive && !enough_points_failed<R>(law, layout, state);
  const R now = thinned(shell, layout, thinning, t, state);
  PatternForces<R> f;
  for (int p = 0; p < full_shell_columns; ++p)
    collect(end, on_thickness(shell, n[p], now), e.nu, gauss * corner_xi[p], gauss * corner_eta[p], f);
  if (shell.bulk_quadratic != 0.0 || shell.bulk_linear != 0.0) {
    const R viscous = end.area * viscous_membrane(shell, law, rates.constant.xx + rates.constant.yy, end.area, state);
    f.constant.xx -= viscous;
    f.constant.yy -= viscous;
  }

  const R scale =
      load_field<R>(state, L::density_scale) * (shell.density / e.plane) / stiffening<R>(law, layout, state);
  const R step = sqrt(length2(nodes.x, end.area, shell.length, e.nu) * scale);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), R(0.0)));

  NodalForces<R, 4> out = forces_on(end, shell, f, moment, alive);
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  return out;
}

template NodalForces<NativeBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<Elastic>&,
                                                      const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<PlasticKinematic>&,
                                                      const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                      const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<ComposedLaw>&,
                                                      const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<NativeBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<Laminate>&,
                                                      const NodalMotion<NativeBatch, 4>&, double, double*);
template NodalForces<SingleBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<Elastic>&,
                                                      const NodalMotion<SingleBatch, 4>&, double, float*);
template NodalForces<SingleBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<PlasticKinematic>&,
                                                      const NodalMotion<SingleBatch, 4>&, double, float*);
template NodalForces<SingleBatch, 4> full_shell_cycle(const ShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                      const NodalMotion<SingleBatch, 4>&, double, float*);

}  // namespace nugget::kernel
