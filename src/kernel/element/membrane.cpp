// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/membrane.hpp"

#include <limits>
#include <type_traits>

#include "kernel/element/full_shell.hpp"
#include "kernel/element/quadrilateral.hpp"
#include "kernel/element/shell_layers.hpp"
#include "kernel/element/triangle.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

template <class R, int N>
void put_in_the_middle(const NodalMotion<R, N>& nodes, double dt, Vec3<R> (&middle)[N]) {
  const R half = R(0.5 * dt);
  for (int i = 0; i < N; ++i) middle[i] = nodes.x[i] - half * nodes.v[i];
}

template <class R>
bool compresses_viscously(const ShellProperties& shell) {
  return shell.bulk_quadratic != 0.0 || shell.bulk_linear != 0.0;
}

/// What a viscous stress of the law leaves of the stable step.
template <class Law>
double step_share(const LawKernel<Law>& law) {
  if constexpr (requires { law.step_share(); }) return law.step_share();
  return 1.0;
}

/// The stable step; elements whose step is too short for their law are deleted.
template <class R, class Law, int N>
R step_and_deletion(const ShellProperties& shell, const LawKernel<Law>& law, const ShellLayout& layout,
                    const Vec3<R> (&x)[N], const R& area, MaskOf<R>& alive, double* state) {
  const R scale = load_field<R>(state, ShellLayout::density_scale) * (shell.density / law.elastic().plane) /
                  stiffening<R>(law, layout, state);
  const R step = step_share(law) * sqrt(length2(x, area, shell.length, law.elastic().nu) * scale);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0)
    store_field(state, ShellLayout::alive, select(alive, R(1.0), R(0.0)));
  return select(alive, step, R(std::numeric_limits<double>::infinity()));
}

/// Deleted elements have no forces.
template <class R, int N>
void take_out_deleted(const MaskOf<R>& alive, NodalForces<R, N>& out) {
  if (!any(!alive)) return;
  for (Vec3<R>& f : out.f) f = select(alive, f, Vec3<R>{});
}

/// Where the law wants to know how fast the material turns in its plane beside the element's axes: the field, else 0.
template <class Law>
int spin_field(const LawKernel<Law>& law) {
  if constexpr (requires { law.spin_field(); }) return law.spin_field();
  return 0;
}

/// How fast the frame of the diagonals turns, in its own axes: about its normal by the mean of what both do, about the
/// others so that the normal stays across both. `x`, `v`: places and velocities in the frame [1/time].
template <class R>
Vec3<R> spin_of_frame(const Differences<R>& x, const Differences<R>& v) {
  const Vec3<R>&a = x.d13, &b = x.d24, &va = v.d13, &vb = v.d24;
  const R about =
      0.5 * ((a.x * va.y - a.y * va.x) / (a.x * a.x + a.y * a.y) + (b.x * vb.y - b.y * vb.x) / (b.x * b.x + b.y * b.y));
  const R over = 1.0 / (a.x * b.y - a.y * b.x);
  // The normal's rate p, q: p a.x + q a.y = -va.z, and so for b.
  const R p = over * (a.y * vb.z - b.y * va.z), q = over * (b.x * va.z - a.x * vb.z);
  return {-q, p, about};
}

/// Hourglass patterns of a membrane of one point, in its frame: their rates, or forces on them.
template <class R>
struct MembranePatterns {
  R x{}, y{}, z{};
};

/// Hourglass forces at the end of the step; stored, and their work added up, in the state.
template <class R, class Law>
[[gnu::always_inline]] inline MembranePatterns<R> resist_patterns(const ShellProperties& shell,
                                                                  const LawKernel<Law>& law, const Quadrilateral<R>& g,
                                                                  const MembranePatterns<R>& rate, double dt,
                                                                  const R& tangent_share, double* state) {
  using L = ShellLayout;
  const ElasticConstants& e = law.elastic();
  const R t = load_field<R>(state, L::thickness);
  const MembranePatterns<R> old{load_field<R>(state, L::hourglass), load_field<R>(state, L::hourglass + 1),
                                load_field<R>(state, L::hourglass + 2)};
  const R density = shell.density * load_field<R>(state, L::density_scale);
  const R viscosity = 0.25 * t * sqrt(density * e.plane * g.area);  // rho c t sqrt(A) / 4
  MembranePatterns<R> now{R(0.0), R(0.0), shell.warping_hourglass * viscosity * rate.z};
  if (shell.hourglass >= 4) {
    const R bb = 2.0 * (g.bx13 * g.bx13 + g.bx24 * g.bx24 + g.by13 * g.by13 + g.by24 * g.by24);
    const R stiffness = shell.membrane_hourglass * (tangent_share * (0.125 * e.E) * (dt * t) * g.area * bb);
    now.x = old.x + stiffness * rate.x;
    now.y = old.y + stiffness * rate.y;
  } else {
    now.x = shell.membrane_hourglass * viscosity * rate.x;
    now.y = shell.membrane_hourglass * viscosity * rate.y;
  }
  store_field(state, L::hourglass, now.x);
  store_field(state, L::hourglass + 1, now.y);
  store_field(state, L::hourglass + 2, now.z);
  const R power = (old.x + now.x) * rate.x + (old.y + now.y) * rate.y + (old.z + now.z) * rate.z;
  store_field(state, L::hourglass_energy, load_field<R>(state, L::hourglass_energy) + (0.5 * dt) * power);
  return now;
}

/// A membrane that yields for the first time loses the hourglass forces that its stiffness no longer carries.
template <class R>
void soften_patterns(const R& share_before, const R& share_now, MembranePatterns<R>& q, double* state) {
  const auto softens = share_now < share_before;
  if (!any(softens)) return;
  const R left = select(softens, share_now / share_before, R(1.0));
  q.x = left * q.x;
  q.y = left * q.y;
  store_field(state, ShellLayout::hourglass, q.x);
  store_field(state, ShellLayout::hourglass + 1, q.y);
}

}  // namespace

template <class R, class Law>
NodalForces<R, 4> membrane_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state) {
  using L = ShellLayout;
  auto alive = load_field<R>(state, L::alive) > 0.5;
  Vec3<R> middle[4];
  put_in_the_middle(nodes, dt, middle);
  const Quadrilateral<R> mid(middle), end(nodes.x);

  const Differences<R> v = Differences<R>(nodes.v).in(mid.frame);
  const R vxx = mid.dx(v.d13.x, v.d24.x), vxy = mid.dy(v.d13.x, v.d24.x);
  const R vyx = mid.dx(v.d13.y, v.d24.y), vyy = mid.dy(v.d13.y, v.d24.y);
  const R vzx = mid.dx(v.d13.z, v.d24.z), vzy = mid.dy(v.d13.z, v.d24.z);
  ShellRates<R> d;
  d.xx = vxx;
  d.yy = vyy;
  d.xy = vxy + vyx;
  // A warped element's in-plane patterns are freed from the turning of its plane, as those of shell_cycle.
  MembranePatterns<R> rate{mid.gamma(v.dh.x, vxx, vxy) + mid.h.z * vzx, mid.gamma(v.dh.y, vyx, vyy) + mid.h.z * vzy,
                           mid.gamma(v.dh.z, vzx, vzy)};
  if (any(!alive)) {
    d = select(alive, d, ShellRates<R>{});
    for (R* r : {&rate.x, &rate.y, &rate.z}) *r = select(alive, *r, R(0.0));
  }

  const ShellLayout layout = shell_layout(shell, law);
  if (const int field = spin_field(law); field > 0) {
    const Differences<R> x = Differences<R>(middle).in(mid.frame);
    store_field(state + layout.history_of(0) * lanes<R>, field, 0.5 * (vyx - vxy) - spin_of_frame(x, v).z);
  }
  const R share = tangent_share<R>(law, layout, state);
  MembranePatterns<R> q = resist_patterns(shell, law, mid, rate, dt, share, state);
  ShellResultants<R> n = advance_layers(shell, law, layout, d, dt, state, alive);
  if (shell.hourglass >= 4) soften_patterns(share, tangent_share<R>(law, layout, state), q, state);
  if (compresses_viscously<R>(shell)) {
    const R viscous = viscous_membrane(shell, law, d.xx + d.yy, end.area, state);
    n.nxx -= viscous;
    n.nyy -= viscous;
  }
  const R step = step_and_deletion(shell, law, layout, nodes.x, end.area, alive, state);

  const R h13 = end.h.x * end.bx13 + end.h.y * end.by13, h24 = end.h.x * end.bx24 + end.h.y * end.by24;
  const R turn_x = end.h.z * q.x, turn_y = end.h.z * q.y;
  const auto force = [&](const R& bx, const R& by, const R& h) {
    return end.frame.global({end.area * (bx * n.nxx + by * n.nxy) - h * q.x,
                             end.area * (by * n.nyy + bx * n.nxy) - h * q.y, bx * turn_x + by * turn_y - h * q.z});
  };
  NodalForces<R, 4> out;
  spread(force(end.bx13, end.by13, h13), force(end.bx24, end.by24, h24), end.frame.global({q.x, q.y, q.z}), Vec3<R>{},
         out.f);
  take_out_deleted(alive, out);
  out.stable_step = step;
  return out;
}

namespace {

/// The bilinear surface of four nodes, in the frame of the diagonals.
template <class R>
struct MembraneSurface {
  Quadrilateral<R> g;
  Differences<R> x;
  explicit MembraneSurface(const Vec3<R> (&nodes)[4]) : g(nodes), x(Differences<R>(nodes).in(g.frame)) {}
};

/// Derivatives along xi and eta of a field, from its differences.
template <class R>
Vec3<R> along_xi(const Differences<R>& f, double eta) {
  return 0.25 * (f.d24 - f.d13 + R(eta) * f.dh);
}
template <class R>
Vec3<R> along_eta(const Differences<R>& f, double xi) {
  return 0.25 * (R(xi) * f.dh - f.d13 - f.d24);
}

/// The tangent plane at a point: e1 and e2 are those of the frame, turned with its normal by the shortest way; j11 to
/// j22, the components along them of the tangents along xi and eta.
template <class R>
struct TangentPlane {
  Vec3<R> e1, e2;
  R j11, j12, j21, j22;
  R area;  ///< of the surface over that of xi, eta

  [[gnu::always_inline]] TangentPlane(const MembraneSurface<R>& s, double xi, double eta) {
    const Vec3<R> a = along_xi(s.x, eta), b = along_eta(s.x, xi), n = cross(a, b);
    const R size = norm(n);
    const R over = 1.0 / size;
    const Vec3<R> e3 = over * n;
    const R share = 1.0 / (1.0 + e3.z), mixed = -share * e3.x * e3.y;
    e1 = {1.0 - share * e3.x * e3.x, mixed, -e3.x};
    e2 = {mixed, 1.0 - share * e3.y * e3.y, -e3.y};
    j11 = dot(a, e1), j12 = dot(a, e2), j21 = dot(b, e1), j22 = dot(b, e2);
    area = size;
  }
};

}  // namespace

template <class R, class Law>
NodalForces<R, 4> full_membrane_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                      const NodalMotion<R, 4>& nodes, double dt, double* state) {
  using L = ShellLayout;
  constexpr double gauss_place = 0.57735026918962576451;
  constexpr double place_xi[] = {-gauss_place, gauss_place, gauss_place, -gauss_place},
                   place_eta[] = {-gauss_place, -gauss_place, gauss_place, gauss_place};
  const L layout = full_shell_layout(shell, law);
  auto alive = load_field<R>(state, L::alive) > 0.5;
  Vec3<R> middle[4];
  put_in_the_middle(nodes, dt, middle);
  const MembraneSurface<R> mid(middle), end(nodes.x);
  const Differences<R> v = Differences<R>(nodes.v).in(mid.g.frame);

  const R t = load_field<R>(state, L::thickness);
  ShellResultants<R> n[full_shell_columns];
  ThicknessStrain<R> thinning;
  R trace = R(0.0);
  const int field = spin_field(law);
  const Vec3<R> frame_spin = field > 0 ? spin_of_frame(mid.x, v) : Vec3<R>{};
  for (int p = 0; p < full_shell_columns; ++p) {
    const TangentPlane<R> plane(mid, place_xi[p], place_eta[p]);
    const Vec3<R> v_xi = along_xi(v, place_eta[p]), v_eta = along_eta(v, place_xi[p]);
    const R over = 1.0 / plane.area;
    const Vec3<R> v1 = over * (plane.j22 * v_xi - plane.j12 * v_eta),
                  v2 = over * (plane.j11 * v_eta - plane.j21 * v_xi);
    ShellRates<R> d;
    d.xx = dot(v1, plane.e1);
    d.yy = dot(v2, plane.e2);
    d.xy = dot(v1, plane.e2) + dot(v2, plane.e1);
    if (field > 0) {
      const Vec3<R> normal = cross(plane.e1, plane.e2);
      // What is left of its rate beside the frame turns e1 and e2 as well, as these go with it by the shortest way.
      const Vec3<R> rate = -(dot(v1, normal) * plane.e1 + dot(v2, normal) * plane.e2) - cross(frame_spin, normal);
      const R turned = (normal.y * rate.x - normal.x * rate.y) / (1.0 + normal.z);
      store_field(state + layout.history_of(0, p) * lanes<R>, field,
                  0.5 * (dot(v1, plane.e2) - dot(v2, plane.e1)) - dot(frame_spin, normal) - turned);
    }
    if (any(!alive)) d = select(alive, d, ShellRates<R>{});
    trace += 0.25 * (d.xx + d.yy);
    const Column<R> column = advance_column(shell, law, d, t, dt, state + layout.layer(0, p) * lanes<R>);
    n[p] = column.n;
    thinning.total += 0.25 * column.thinning.total;
    thinning.plastic += 0.25 * column.thinning.plastic;
  }
  if (law.can_fail()) alive = alive && !enough_points_failed<R>(law, layout, state);
  const R now = thinned(shell, layout, thinning, t, state);
  R viscous = R(0.0);
  if (compresses_viscously<R>(shell)) viscous = viscous_membrane(shell, law, trace, end.g.area, state);
  const R step = step_and_deletion(shell, law, layout, nodes.x, end.g.area, alive, state);

  Vec3<R> f13{}, f24{}, pattern{};
  for (int p = 0; p < full_shell_columns; ++p) {
    const TangentPlane<R> plane(end, place_xi[p], place_eta[p]);
    const R xx = now * n[p].nxx - viscous, yy = now * n[p].nyy - viscous, xy = now * n[p].nxy;
    const Vec3<R> on_1 = xx * plane.e1 + xy * plane.e2, on_2 = xy * plane.e1 + yy * plane.e2;
    // Forces on the derivatives along xi and eta.
    const Vec3<R> xi = 0.25 * (plane.j22 * on_1 - plane.j21 * on_2), eta = 0.25 * (plane.j11 * on_2 - plane.j12 * on_1);
    f13 -= xi + eta;
    f24 += xi - eta;
    pattern += R(place_eta[p]) * xi + R(place_xi[p]) * eta;
  }
  NodalForces<R, 4> out;
  spread(end.g.frame.global(f13), end.g.frame.global(f24), end.g.frame.global(pattern), Vec3<R>{}, out.f);
  take_out_deleted(alive, out);
  out.stable_step = step;
  return out;
}

template <class R, class Law>
NodalForces<R, 3> membrane_triangle_cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                          const NodalMotion<R, 3>& nodes, double dt, double* state) {
  auto alive = load_field<R>(state, ShellLayout::alive) > 0.5;
  Vec3<R> middle[3];
  put_in_the_middle(nodes, dt, middle);
  const Triangle<R> mid(middle), end(nodes.x);

  const Vec3<R> v21 = mid.frame.local(nodes.v[1] - nodes.v[0]), v31 = mid.frame.local(nodes.v[2] - nodes.v[0]);
  ShellRates<R> d;
  const R vyx = mid.dx(v21.y, v31.y), vxy = mid.dy(v21.x, v31.x);
  d.xx = mid.dx(v21.x, v31.x);
  d.yy = mid.dy(v21.y, v31.y);
  d.xy = vxy + vyx;
  if (const int field = spin_field(law); field > 0)  // what turns beside the frame
    store_field(state + shell_layout(shell, law).history_of(0) * lanes<R>, field,
                0.5 * (vyx - vxy) - mid.spin(v21, v31));
  if (any(!alive)) d = select(alive, d, ShellRates<R>{});
  ShellResultants<R> n = advance_layers(shell, law, shell_layout(shell, law), d, dt, state, alive);
  if (compresses_viscously<R>(shell)) {
    const R viscous = viscous_membrane(shell, law, d.xx + d.yy, end.area, state);
    n.nxx -= viscous;
    n.nyy -= viscous;
  }
  const R step = step_and_deletion(shell, law, shell_layout(shell, law), nodes.x, end.area, alive, state);

  const auto force = [&](const R& bx, const R& by) {
    return end.frame.global({end.area * (bx * n.nxx + by * n.nxy), end.area * (by * n.nyy + bx * n.nxy), R(0.0)});
  };
  NodalForces<R, 3> out;
  out.f[1] = force(end.x2, end.y2);
  out.f[2] = force(end.x3, end.y3);
  out.f[0] = -(out.f[1] + out.f[2]);
  take_out_deleted(alive, out);
  out.stable_step = step;
  return out;
}

#define NUGGET_MEMBRANE(Law)                                                                                     \
  template NodalForces<NativeBatch, 4> membrane_cycle(const ShellProperties&, const LawKernel<Law>&,             \
                                                      const NodalMotion<NativeBatch, 4>&, double, double*);      \
  template NodalForces<NativeBatch, 4> full_membrane_cycle(const ShellProperties&, const LawKernel<Law>&,        \
                                                           const NodalMotion<NativeBatch, 4>&, double, double*); \
  template NodalForces<NativeBatch, 3> membrane_triangle_cycle(const ShellProperties&, const LawKernel<Law>&,    \
                                                               const NodalMotion<NativeBatch, 3>&, double, double*);
NUGGET_MEMBRANE(Elastic)
NUGGET_MEMBRANE(PlasticKinematic)
NUGGET_MEMBRANE(PiecewiseLinear)
NUGGET_MEMBRANE(ComposedLaw)
#undef NUGGET_MEMBRANE

}  // namespace nugget::kernel
