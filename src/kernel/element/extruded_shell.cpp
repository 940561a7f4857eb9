// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/extruded_shell.hpp"

#include <limits>

#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/uniform_gradient.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// The lines from the bottom nodes to the top ones, and the geometry that they stand on.
template <class R>
struct Pairs {
  Gradient<R> g;
  Vec3<R> n;  ///< of the midway surface
  Vec3<R> line[4];
  R over_square[4], over_height[4];  ///< 1 / line^2, 1 / (line . n)

  [[gnu::always_inline]] Pairs(const Patterns<R>& x, const Vec3<R> (&lines)[4]) : g(x), n(unit(cross(x.a, x.b))) {
    for (int i = 0; i < 4; ++i) {
      line[i] = lines[i];
      over_square[i] = 1.0 / dot(line[i], line[i]);
      over_height[i] = 1.0 / dot(line[i], n);
    }
  }
};

/// Area of a quadrilateral in the plane of its diagonals.
template <class R>
R area_of(const Vec3<R> (&x)[4]) {
  const Vec3<R> twice = cross(x[2] - x[0], x[3] - x[1]);
  return 0.5 * sqrt(dot(twice, twice));
}

/// Half the curl: the spin of the mean.
template <class R>
Vec3<R> spin_of(const Matrix<R>& l) {
  return {0.5 * (l.z.y - l.y.z), 0.5 * (l.x.z - l.z.x), 0.5 * (l.y.x - l.x.y)};
}

/// Nodal forces f_I = P b_I of a matrix P of the uniform gradient, given as the products P . (V b) by patterns.
template <class R, class Times>
[[gnu::always_inline]] inline void on_gradient(const Gradient<R>& g, const Times& times, Vec3<R> (&f)[8]) {
  nodes_of(
      Patterns<R>{times(g.a), times(g.b), times(g.c), {times(g.h[0]), times(g.h[1]), times(g.h[2]), Vec3<R>{}}}, f);
}

/// What resists across: the stresses at the corners and their sum with the viscous pressure.
template <class R>
struct Across {
  R stress[4];
  R step;
};

/// Strains along the normal at the corners: that of the mean, and what a pair stretches beyond what the mean says.
template <class R>
[[gnu::always_inline]] inline Across<R> resist_across(const ExtrudedShellProperties& extruded,
                                                      const ElasticConstants& e, const Pairs<R>& mid,
                                                      const Matrix<R>& l, const Vec3<R> (&rate)[4], const R& volume,
                                                      const R& thickness, double dt, double* state) {
  using L = ExtrudedShellLayout;
  const R mean = dot(mid.n, l * mid.n), quarter = R(0.25);
  Across<R> a;
  R trace = R(0.0);
  for (int i = 0; i < 4; ++i) {
    const R strain = mean + dot(mid.n, rate[i] - l * mid.line[i]) * mid.over_height[i];
    trace += quarter * strain;
    a.stress[i] = load_field<R>(state, L::across + i) + (R(dt * e.E) * strain);
    store_field(state, L::across + i, a.stress[i]);
  }
  HexahedronProperties viscous;
  viscous.bulk_quadratic = extruded.bulk_quadratic;
  viscous.bulk_linear = extruded.bulk_linear;
  const R density = extruded.shell.density * load_field<R>(state, L::density_scale);
  const BulkViscosity<R> bulk(viscous, R(e.E), density, thickness, trace);
  book_viscosity<L>(bulk.pressure, trace, volume, dt, state);
  for (R& stress : a.stress) stress -= bulk.pressure;
  a.step = bulk.step;
  return a;
}

}  // namespace

std::array<Vec3d, 4> midway_nodes(const std::array<Vec3d, 8>& x) {
  return {0.5 * (x[0] + x[4]), 0.5 * (x[1] + x[5]), 0.5 * (x[2] + x[6]), 0.5 * (x[3] + x[7])};
}

double extruded_shell_thickness(const std::array<Vec3d, 8>& x) {
  return hexahedron_volume(x) / shell_area(midway_nodes(x));
}

void start_extruded_shell(const ExtrudedShellLayout& layout, const std::array<Vec3d, 8>& x, double* state, int width,
                          int lane) {
  using L = ExtrudedShellLayout;
  for (int i = 0; i < L::first_of_shell; ++i) state[i * width + lane] = 0.0;
  start_shell(layout.shell, extruded_shell_thickness(x), state + L::first_of_shell * width, width, lane);
}

template <class R, class Law>
SolidForces<R> extruded_shell_cycle(const ExtrudedShellProperties& extruded, const LawKernel<Law>& law,
                                    const SolidMotion<R>& nodes, double dt, double* state) {
  using L = ExtrudedShellLayout;
  const auto alive_before = load_field<R>(state, L::alive) > 0.5;
  const BrickStep<R> motion(nodes, dt, alive_before);
  const R half = R(0.5 * dt);

  NodalMotion<R, 4> shell;
  Vec3<R> rate[4], line_end[4], line_mid[4];
  for (int i = 0; i < 4; ++i) {
    shell.x[i] = R(0.5) * (nodes.x[i] + nodes.x[i + 4]);
    shell.v[i] = R(0.5) * (nodes.v[i] + nodes.v[i + 4]);
    rate[i] = nodes.v[i + 4] - nodes.v[i];
    line_end[i] = nodes.x[i + 4] - nodes.x[i];
    line_mid[i] = line_end[i] - half * rate[i];
  }
  const Pairs<R> mid(motion.mid, line_mid), end(motion.end, line_end);
  const Matrix<R> l = velocity_gradient(mid.g, motion.v);
  const Vec3<R> spin = spin_of(l);
  for (int i = 0; i < 4; ++i) {
    const Vec3<R>& d = mid.line[i];
    shell.w[i] = mid.over_square[i] * (cross(d, rate[i]) + dot(d, spin) * d);
  }

  const R area = area_of(shell.x), thickness = end.g.volume / area;
  store_field(state, L::thickness, thickness);
  double* own = state + L::first_of_shell * lanes<R>;
  const NodalForces<R, 4> in_plane = extruded.full ? full_shell_cycle<R>(extruded.shell, law, shell, dt, own)
                                                   : shell_cycle<R>(extruded.shell, law, shell, dt, own);

  // A moment along a pair's line turns the element; across it, it is a couple of forces on the pair.
  Vec3<R> turning{}, couple[4];
  for (int i = 0; i < 4; ++i) {
    const Vec3<R>&d = end.line[i], &m = in_plane.m[i];
    couple[i] = end.over_square[i] * cross(m, d);
    turning += (end.over_square[i] * dot(d, m)) * d;
  }

  if (any(!alive_before))
    for (Vec3<R>& r : rate) r = select(alive_before, r, Vec3<R>{});
  const Across<R> across =
      resist_across(extruded, law.elastic(), mid, l, rate, end.g.volume, thickness, dt, state);
  const auto alive = load_field<R>(state, L::alive) > 0.5;
  const R quarter = 0.25 * end.g.volume;
  R whole = R(0.0), on_pair[4];
  Vec3<R> levers{};
  for (int i = 0; i < 4; ++i) {
    const R force = select(alive, quarter * across.stress[i], R(0.0));
    whole += force;
    on_pair[i] = force * end.over_height[i];
    levers += on_pair[i] * end.line[i];
  }
  const Vec3<R> along = end.g.over_volume * (whole * end.n - levers), twist = (0.5 * end.g.over_volume) * turning;

  SolidForces<R> out;
  on_gradient(
      end.g, [&](const Vec3<R>& b) { return dot(along, b) * end.n + cross(twist, b); }, out.f);
  for (int i = 0; i < 4; ++i) {
    const Vec3<R> middle = R(0.5) * in_plane.f[i], apart = on_pair[i] * end.n + couple[i];
    out.f[i] += middle - apart;
    out.f[i + 4] += middle + apart;
  }
  const R ratio = across.step / in_plane.stable_step;
  out.stable_step =
      select(alive, across.step / sqrt(R(1.0) + ratio * ratio), R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, end.g.volume, R(1.0));
  return out;
}

template SolidForces<double> extruded_shell_cycle(const ExtrudedShellProperties&, const LawKernel<Elastic>&,
                                                  const SolidMotion<double>&, double, double*);
template SolidForces<double> extruded_shell_cycle(const ExtrudedShellProperties&, const LawKernel<PlasticKinematic>&,
                                                  const SolidMotion<double>&, double, double*);
template SolidForces<double> extruded_shell_cycle(const ExtrudedShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                  const SolidMotion<double>&, double, double*);
template SolidForces<NativeBatch> extruded_shell_cycle(const ExtrudedShellProperties&, const LawKernel<Elastic>&,
                                                       const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> extruded_shell_cycle(const ExtrudedShellProperties&,
                                                       const LawKernel<PlasticKinematic>&,
                                                       const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> extruded_shell_cycle(const ExtrudedShellProperties&,
                                                       const LawKernel<PiecewiseLinear>&,
                                                       const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> extruded_shell_cycle(const ExtrudedShellProperties&, const LawKernel<ComposedLaw>&,
                                                       const SolidMotion<NativeBatch>&, double, double*);

}  // namespace nugget::kernel
