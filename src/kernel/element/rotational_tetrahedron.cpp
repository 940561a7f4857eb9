// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/rotational_tetrahedron.hpp"

#include <algorithm>
#include <limits>

#include "kernel/element/tetrahedron.hpp"
#include "kernel/element/tetrahedron_gradients.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

constexpr int points = RotationalTetrahedronLayout::points;
/// Area coordinates of a point: of the node it is next to, of the others.
constexpr double near = 0.58541019662496845, far = 0.13819660112501052;
/// Shares of G V and of G V l^2 that hold the patterns which deform nothing.
constexpr double mean_stiffness = 1e-5, divergence_stiffness = 1e-2;

constexpr int edges = 6;
constexpr int edge_end[edges][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

/// a b^T.
template <class R>
[[gnu::always_inline]] inline void add_dyad(const Vec3<R>& a, const Vec3<R>& b, Matrix<R>& to) {
  to.x += a.x * b;
  to.y += a.y * b;
  to.z += a.z * b;
}
template <class R>
[[gnu::always_inline]] inline Matrix<R> sum(const Matrix<R>& a, const R& share, const Matrix<R>& b) {
  return {a.x + share * b.x, a.y + share * b.y, a.z + share * b.z};
}

template <class R>
struct Geometry : TetrahedronGradients<R> {
  Vec3<R> all[4];  ///< gradients of the four shape functions
  Vec3<R> along[edges];

  [[gnu::always_inline]] explicit Geometry(const Vec3<R> (&x)[4]) : TetrahedronGradients<R>(x) {
    for (int i = 0; i < 3; ++i) all[i] = this->b[i];
    all[3] = -(all[0] + all[1] + all[2]);
    for (int e = 0; e < edges; ++e) along[e] = x[edge_end[e][1]] - x[edge_end[e][0]];
  }
  /// Mean square of the edges.
  R edge2() const {
    R total = R(0.0);
    for (const Vec3<R>& d : along) total += dot(d, d);
    return (1.0 / edges) * total;
  }
};

/// Velocity gradients of the points, v_i,j.
template <class R>
struct Rates {
  Matrix<R> at[points], mean;

  [[gnu::always_inline]] Rates(const Geometry<R>& g, const Vec3<R> (&v)[4], const Vec3<R> (&w)[4])
      : mean(velocity_gradient(g, v)) {
    // What the middle of an edge moves beside the mean of its ends is spread by 4 L_i L_j.
    Matrix<R> bubbles{}, own[points]{};
    for (int e = 0; e < edges; ++e) {
      const int i = edge_end[e][0], j = edge_end[e][1];
      const Vec3<R> beside = 0.125 * cross(w[i] - w[j], g.along[e]);
      add_dyad(beside, g.all[i] + g.all[j], bubbles);
      add_dyad(beside, g.all[j], own[i]);
      add_dyad(beside, g.all[i], own[j]);
    }
    const Matrix<R> shared = sum(mean, R(4.0 * far), bubbles);
    for (int p = 0; p < points; ++p) at[p] = sum(shared, R(4.0 * (near - far)), own[p]);
    mean = sum(mean, R(1.0), bubbles);
  }
};

template <class R>
R trace_of(const Matrix<R>& l) {
  return l.x.x + l.y.y + l.z.z;
}

template <class R>
Matrix<R> matrix_of(const SolidTensor<R>& s) {
  return {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
}

/// What holds the patterns of the rotations that deform nothing, at the end of the step.
template <class R>
struct Stabilisation {
  Vec3<R> moment;  ///< on the mean of the spins less that of the element
  R dilation;      ///< on the divergence of the spins

  [[gnu::always_inline]] Stabilisation(const ElasticConstants& e, const Geometry<R>& g, const Matrix<R>& l,
                                       const Vec3<R> (&w)[4], double dt, double* state) {
    using L = RotationalTetrahedronLayout;
    const Vec3<R> element = 0.5 * Vec3<R>{l.z.y - l.y.z, l.x.z - l.z.x, l.y.x - l.x.y};
    const Vec3<R> q = 0.25 * ((w[0] + w[1]) + (w[2] + w[3])) - element;
    R s = R(0.0);
    for (int i = 0; i < 4; ++i) s += dot(g.all[i], w[i]);
    const R gv = (e.shear * dt) * g.volume, edge2 = load_field<R>(state, L::edge2);
    const Vec3<R> stored{load_field<R>(state, L::moment), load_field<R>(state, L::moment + 1),
                         load_field<R>(state, L::moment + 2)};
    const Frame<R> turn = rotation_of(half_turn(l, dt));
    const Vec3<R> old{dot(turn.e1, stored), dot(turn.e2, stored), dot(turn.e3, stored)};
    const R old_dilation = load_field<R>(state, L::dilation);
    moment = old + mean_stiffness * gv * q;
    dilation = old_dilation + divergence_stiffness * gv * edge2 * s;
    store_field(state, L::moment, moment.x);
    store_field(state, L::moment + 1, moment.y);
    store_field(state, L::moment + 2, moment.z);
    store_field(state, L::dilation, dilation);
    const R power = dot(old + moment, q) + (old_dilation + dilation) * s;
    store_field(state, L::hourglass_energy, load_field<R>(state, L::hourglass_energy) + (0.5 * dt) * power);
  }
};

/// Nodal forces and moments that do the work of the points' stresses and of the stabilisation.
template <class R>
[[gnu::always_inline]] inline void collect(const Geometry<R>& g, const SolidTensor<R> (&stress)[points],
                                           const Stabilisation<R>& hold, RotationalTetrahedronForces<R>& out) {
  SolidTensor<R> total{};
  for (const SolidTensor<R>& s : stress) {
    total.xx += s.xx;
    total.yy += s.yy;
    total.zz += s.zz;
    total.xy += s.xy;
    total.yz += s.yz;
    total.zx += s.zx;
  }
  const R quarter = 0.25 * g.volume;
  const Matrix<R> all = matrix_of(total);
  Vec3<R> pull[4], twist[4];  // of the sum of the stresses; of the moment on the element's spin
  for (int i = 0; i < 4; ++i) {
    pull[i] = quarter * (all * g.all[i]);
    twist[i] = -0.5 * cross(hold.moment, g.all[i]);
    out.f[i] = pull[i] + twist[i];
    out.m[i] = 0.25 * hold.moment + hold.dilation * g.all[i];
  }
  const R own = (4.0 * (near - far)) * quarter;
  for (int e = 0; e < edges; ++e) {
    const int i = edge_end[e][0], j = edge_end[e][1];
    const Vec3<R> beside = R(4.0 * far) * (pull[i] + pull[j]) + (twist[i] + twist[j]) +
                           own * (matrix_of(stress[i]) * g.all[j] + matrix_of(stress[j]) * g.all[i]);
    const Vec3<R> m = 0.125 * cross(g.along[e], beside);
    out.m[i] += m;
    out.m[j] -= m;
  }
}

/// Failed points that delete an element.
template <class Law>
double points_to_delete(const LawKernel<Law>& law) {
  const double limit = law.points_to_delete();
  if (limit < 0.0) return -limit * points / 100.0;
  return limit > 0.0 && limit < points ? limit : points;
}

}  // namespace

template <class R, class Law>
RotationalTetrahedronForces<R> rotational_tetrahedron_cycle(const HexahedronProperties& solid,
                                                            const LawKernel<Law>& law, const NodalMotion<R, 4>& nodes,
                                                            double dt, double* state) {
  using L = RotationalTetrahedronLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = rotational_tetrahedron_layout(law);
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const R none = R(0.0), third = R(1.0 / 3.0);

  Vec3<R> v[4], w[4], middle[4];
  for (int i = 0; i < 4; ++i) {
    v[i] = any(!alive) ? select(alive, nodes.v[i], Vec3<R>{}) : nodes.v[i];
    w[i] = any(!alive) ? select(alive, nodes.w[i], Vec3<R>{}) : nodes.w[i];
    middle[i] = nodes.x[i] - R(0.5 * dt) * v[i];
  }
  const Geometry<R> mid(middle), end(nodes.x);
  const Rates<R> rates(mid, v, w);
  const R trace = trace_of(rates.mean);

  SolidTensor<R> stress[points];
  R failed = none, wave = none, mean = none;
  for (int p = 0; p < points; ++p) {
    const Matrix<R>& l = rates.at[p];
    double* at = state + layout.point(p) * lanes<R>;
    double* history = state + layout.history_of(p) * lanes<R>;
    const Vec3<R> half = half_turn(l, dt);
    const Frame<R> turn = rotation_of(half);
    const R extra = third * (trace - trace_of(l));
    SolidTensor<R> s = rotated(turn, load_solid<R>(at));
    law.rotate(turn, history);
    SolidTensor<R> d = rate_at_end(l, half);
    d.xx += extra;
    d.yy += extra;
    d.zz += extra;
    law.solid(s, d, dt, history);
    store_solid(at, s);
    stress[p] = s;
    mean += R(1.0 / points) * (third * (s.xx + s.yy + s.zz));
    wave = max(wave, law.template wave_modulus<R>(history));
    if (law.can_fail()) failed += select(law.template failed<R>(history), R(1.0), none);
  }
  const Stabilisation<R> hold(e, mid, rates.mean, w, dt, state);

  const R density = solid.density * load_field<R>(state, L::density_scale);
  const double stiffest = std::max(e.E / (1.0 - 2.0 * e.nu), 2.0 * e.shear);  // 3 K, 2 G
  const R stiffness = stiffest + (2.0 * e.shear) * (end.edge2() / load_field<R>(state, L::edge2));
  const R length = sqrt(R(e.bulk_wave()) / (stiffness * end.largest()));
  const BulkViscosity<R> bulk(solid, wave, density, length, trace);
  for (int p = 0; p < points; ++p)
    heat_by_viscosity(law, bulk.pressure, trace, dt, state + layout.history_of(p) * lanes<R>);
  book_viscosity<L>(bulk.pressure, trace, end.volume, dt, state);
  mean -= bulk.pressure;
  for (SolidTensor<R>& s : stress) {
    const R change = mean - third * (s.xx + s.yy + s.zz);
    s.xx += change;
    s.yy += change;
    s.zz += change;
  }

  if (law.can_fail()) alive = alive && failed < R(points_to_delete(law));
  if (law.deletion_step() > 0.0) alive = alive && bulk.step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), none));

  RotationalTetrahedronForces<R> out;
  collect(end, stress, hold, out);
  if (any(!alive))
    for (int i = 0; i < 4; ++i) {
      out.f[i] = select(alive, out.f[i], Vec3<R>{});
      out.m[i] = select(alive, out.m[i], Vec3<R>{});
    }
  out.stable_step = select(alive, bulk.step, R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, end.volume, R(1.0));
  return out;
}

namespace {

double mean_edge2(const std::array<Vec3d, 4>& x) {
  const Vec3d nodes[4] = {x[0], x[1], x[2], x[3]};
  return Geometry<double>(nodes).edge2();
}

}  // namespace

void start_rotational_tetrahedron(const RotationalTetrahedronLayout& layout, const std::array<Vec3d, 4>& x,
                                  double* state, int width, int lane) {
  using L = RotationalTetrahedronLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
  state[L::edge2 * width + lane] = mean_edge2(x);
}

double rotational_tetrahedron_inertia(const std::array<Vec3d, 4>& x, double density) {
  return 0.25 * density * tetrahedron_volume(x) * mean_edge2(x) / 10.0;
}

template RotationalTetrahedronForces<NativeBatch> rotational_tetrahedron_cycle(const HexahedronProperties&,
                                                                               const LawKernel<Elastic>&,
                                                                               const NodalMotion<NativeBatch, 4>&,
                                                                               double, double*);
template RotationalTetrahedronForces<NativeBatch> rotational_tetrahedron_cycle(const HexahedronProperties&,
                                                                               const LawKernel<PlasticKinematic>&,
                                                                               const NodalMotion<NativeBatch, 4>&,
                                                                               double, double*);
template RotationalTetrahedronForces<NativeBatch> rotational_tetrahedron_cycle(const HexahedronProperties&,
                                                                               const LawKernel<PiecewiseLinear>&,
                                                                               const NodalMotion<NativeBatch, 4>&,
                                                                               double, double*);
template RotationalTetrahedronForces<NativeBatch> rotational_tetrahedron_cycle(const HexahedronProperties&,
                                                                               const LawKernel<ComposedLaw>&,
                                                                               const NodalMotion<NativeBatch, 4>&,
                                                                               double, double*);

}  // namespace nugget::kernel
