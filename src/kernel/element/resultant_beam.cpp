// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/resultant_beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/axis_across.hpp"

namespace nugget::kernel {
namespace {

/// `a` turned by the rotation vector `phi` of a step (Cayley's rotation).
template <class R>
Vec3<R> turned(const Vec3<R>& a, const Vec3<R>& phi) {
  const Vec3<R> half = R(0.5) * phi, lever = a + cross(half, a);
  return a + (2.0 / (1.0 + dot(half, half))) * cross(half, lever);
}

/// Moments at both ends for their rotations about one axis.
template <class R>
struct Bending {
  R first, second;
  Bending(double EI, double GA, const R& length, const R& angle1, const R& angle2) {
    const R phi = GA > 0.0 ? (12.0 * EI / GA) / (length * length) : R(0.0);
    const R k = EI / (length * (1.0 + phi));
    first = k * ((4.0 + phi) * angle1 + (2.0 - phi) * angle2);
    second = k * ((2.0 - phi) * angle1 + (4.0 + phi) * angle2);
  }
};

}  // namespace

void start_resultant_beam(const Vec3d& x1, const Vec3d& x2, const Vec3d& towards, double* state, int width, int lane) {
  using L = ResultantBeamLayout;
  const auto put = [&](int i, double value) { state[i * width + lane] = value; };
  const auto put_vector = [&](int i, const Vec3d& v) { put(i, v.x), put(i + 1, v.y), put(i + 2, v.z); };
  for (int i = 0; i < L::count; ++i) put(i, 0.0);
  const Vec3d along = x2 - x1, r = unit(along), side = beam_side(r, towards);
  put(L::alive, 1.0);
  put(L::density_scale, 1.0);
  put(L::length, norm(along));
  put(L::first_length, norm(along));
  for (int node = 0; node < 2; ++node) {
    put_vector(L::axes + 6 * node, r);
    put_vector(L::axes + 6 * node + 3, side);
  }
}

template <class R>
NodalForces<R, 2> resultant_beam_cycle(const ResultantBeamProperties& beam, double E, double shear,
                                       const NodalMotion<R, 2>& nodes, double dt, double* state) {
  using L = ResultantBeamLayout;
  const auto alive = load_field<R>(state, L::alive) > 0.5;
  Vec3<R> r[2], s[2];
  for (int node = 0; node < 2; ++node) {
    const Vec3<R> turn = R(dt) * nodes.w[node];
    r[node] = turned(load_vector<R>(state, L::axes + 6 * node), turn);
    s[node] = turned(load_vector<R>(state, L::axes + 6 * node + 3), turn);
    store_vector(state, L::axes + 6 * node, r[node]);
    store_vector(state, L::axes + 6 * node + 3, s[node]);
  }
  const Vec3<R> chord = nodes.x[1] - nodes.x[0];
  const R length = norm(chord), first = load_field<R>(state, L::first_length);
  store_field(state, L::length, length);
  const Vec3<R> e1 = (1.0 / length) * chord, between = s[0] + s[1], e2 = unit(between - dot(between, e1) * e1);
  const Frame<R> axes{e1, e2, cross(e1, e2)};

  const auto about_s = [&](int node) { return -dot(axes.e3, r[node]); };
  const auto about_t = [&](int node) { return dot(axes.e2, r[node]); };
  const Vec3<R> t0 = cross(r[0], s[0]), t1 = cross(r[1], s[1]);
  const R twist = 0.5 * dot(e1, cross(s[0], s[1]) + cross(t0, t1));

  const double GA = shear * beam.shear_area;
  const Bending<R> in_s(E * beam.moment_s, GA, length, about_s(0), about_s(1)),
      in_t(E * beam.moment_t, GA, length, about_t(0), about_t(1));
  const R over = 1.0 / length;
  const R N = (E * beam.area) * (length - first) / first, torsion = (shear * beam.torsion) * twist / first;
  const R Qs = -over * (in_t.first + in_t.second), Qt = over * (in_s.first + in_s.second);
  const R n[6] = {N, Qs, Qt, torsion, 0.5 * (in_s.second - in_s.first), 0.5 * (in_t.second - in_t.first)};
  const R none = R(0.0);
  for (int i = 0; i < 6; ++i) store_field(state, L::resultant + i, select(alive, n[i], none));

  NodalForces<R, 2> out;
  out.f[1] = select(alive, axes.global({N, Qs, Qt}), Vec3<R>{});
  out.f[0] = -out.f[1];
  out.m[0] = select(alive, axes.global({-torsion, in_s.first, in_t.first}), Vec3<R>{});
  out.m[1] = select(alive, axes.global({torsion, in_s.second, in_t.second}), Vec3<R>{});

  // Axial: 4 E / (rho l^2); antisymmetric bending: (12 E I / l) (1 / 2J + 2 / (m l^2)).
  const double I = std::max(beam.moment_s, beam.moment_t);
  const R density = load_field<R>(state, L::density_scale);
  const NodalMass one{0.5 * (beam.density * beam.area + beam.mass_per_length), 0.0};
  const R mass = density * (one.mass * first);
  const R physical = (0.5 * beam.density * I) * first + (beam.density * beam.area / 24.0) * (first * first * first);
  const R least = (3.0 * beam.density * I) * first, J = density * select(physical > least, physical, least);
  const R axial = (2.0 * E * beam.area) * over / mass;
  const R bending = (12.0 * E * I) * over * (0.5 / J + 2.0 / (mass * length * length));
  const R fastest = select(axial > bending, axial, bending);
  out.stable_step = select(alive, 2.0 / sqrt(fastest), R(std::numeric_limits<double>::infinity()));
  return out;
}

NodalMass resultant_beam_nodal_mass(const ResultantBeamProperties& beam, double length) {
  const double I = std::max(beam.moment_s, beam.moment_t);
  const double physical = 0.5 * beam.density * I * length + beam.density * beam.area / 24.0 * length * length * length;
  return {0.5 * (beam.density * beam.area + beam.mass_per_length) * length,
          std::max(physical, 3.0 * beam.density * I * length)};
}

template NodalForces<NativeBatch, 2> resultant_beam_cycle(const ResultantBeamProperties&, double, double,
                                                          const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<Dual<12>, 2> resultant_beam_cycle(const ResultantBeamProperties&, double, double,
                                                       const NodalMotion<Dual<12>, 2>&, double, double*);

}  // namespace nugget::kernel
