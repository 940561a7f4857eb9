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
  R over_height[4], over_square[4];  ///< 1 / (line . n) and its square
  R least_length;                    ///< least of (line . n)^2 / |line|, over which the step across is taken

  [[gnu::always_inline]] Pairs(const Patterns<R>& x, const Vec3<R> (&lines)[4]) : g(x), n(unit(cross(x.a, x.b))) {
    for (int i = 0; i < 4; ++i) {
      line[i] = lines[i];
      const R height = dot(line[i], n);
      over_height[i] = 1.0 / height;
      over_square[i] = over_height[i] * over_height[i];
      const R length = height * height / norm(line[i]);
      least_length = i == 0 ? length : min(least_length, length);
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

/// Stresses across at the corners, with viscosity, and the step that they allow.
template <class R>
struct Across {
  R stress[4];
  R step;
};

/// `strain`: across, at the corners.
template <class R>
[[gnu::always_inline]] inline Across<R> resist_across(const ExtrudedShellProperties& extruded,
                                                      const ElasticConstants& e, const R (&strain)[4], const R& volume,
                                                      const R& length, double dt, double* state) {
  using L = ExtrudedShellLayout;
  const R quarter = R(0.25);
  Across<R> a;
  R trace = R(0.0);
  for (int i = 0; i < 4; ++i) {
    trace += quarter * strain[i];
    a.stress[i] = load_field<R>(state, L::across + i) + R(dt * e.E) * strain[i];
    store_field(state, L::across + i, a.stress[i]);
  }
  HexahedronProperties viscous;
  viscous.bulk_quadratic = extruded.bulk_quadratic;
  viscous.bulk_linear = extruded.bulk_linear;
  const R density = extruded.shell.density * load_field<R>(state, L::density_scale);
  const BulkViscosity<R> bulk(viscous, R(e.E), density, length, trace);
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
  // At a corner the fibre along the normal turns, and is stretched, as linear fields say, and beyond them as the pair
  // is.
  const Matrix<R> l = velocity_gradient(mid.g, motion.v);
  const Vec3<R> mean = l * mid.n, spin = cross(mid.n, mean) + dot(spin_of(l), mid.n) * mid.n;
  const R mean_strain = dot(mid.n, mean);
  R strain[4];
  for (int i = 0; i < 4; ++i) {
    const Vec3<R> beyond = rate[i] - l * mid.line[i];
    shell.w[i] = spin + mid.over_height[i] * cross(mid.n, beyond);
    strain[i] = mean_strain + mid.over_square[i] * dot(mid.line[i], beyond);
  }

  const R area = area_of(shell.x), thickness = end.g.volume / area;
  store_field(state, L::thickness, thickness);
  double* own = state + L::first_of_shell * lanes<R>;
  const NodalForces<R, 4> in_plane = extruded.full ? full_shell_cycle<R>(extruded.shell, law, shell, dt, own)
                                                   : shell_cycle<R>(extruded.shell, law, shell, dt, own);

  if (any(!alive_before))
    for (R& e : strain) e = select(alive_before, e, R(0.0));
  const Across<R> across = resist_across(extruded, law.elastic(), strain, end.g.volume, end.least_length, dt, state);
  const auto alive = load_field<R>(state, L::alive) > 0.5;

  // The forces that do their work: couples and pulls of the pairs, and on the uniform gradient a matrix (by rows).
  const R quarter = 0.25 * end.g.volume;
  Vec3<R> pair[4], whole_moment{};
  R whole_pull = R(0.0);
  Matrix<R> matrix{};
  for (int i = 0; i < 4; ++i) {
    const Vec3<R>&m = in_plane.m[i], &d = end.line[i];
    const R pull = select(alive, quarter * across.stress[i], R(0.0));
    pair[i] = end.over_height[i] * cross(m, end.n) + (end.over_square[i] * pull) * d;
    whole_moment += m;
    whole_pull += pull;
    matrix.x -= pair[i].x * d;
    matrix.y -= pair[i].y * d;
    matrix.z -= pair[i].z * d;
  }
  const Vec3<R> normal = cross(whole_moment, end.n) + whole_pull * end.n,
                half_turning = (0.5 * dot(end.n, whole_moment)) * end.n;
  matrix.x += normal.x * end.n;
  matrix.y += normal.y * end.n;
  matrix.z += normal.z * end.n;
  const auto on_gradient = [&](const Vec3<R>& b) { return end.g.over_volume * (matrix * b + cross(half_turning, b)); };
  SolidForces<R> out;
  nodes_of(Patterns<R>{on_gradient(end.g.a),
                       on_gradient(end.g.b),
                       on_gradient(end.g.c),
                       {on_gradient(end.g.h[0]), on_gradient(end.g.h[1]), on_gradient(end.g.h[2]), Vec3<R>{}}},
           out.f);
  for (int i = 0; i < 4; ++i) {
    const Vec3<R> middle = R(0.5) * in_plane.f[i];
    out.f[i] += middle - pair[i];
    out.f[i + 4] += middle + pair[i];
  }
  const R ratio = across.step / in_plane.stable_step;
  out.stable_step =
      select(alive, across.step / sqrt(R(1.0) + ratio * ratio), R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, end.g.volume, R(1.0));
  return out;
}

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
