// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/quadratic_tetrahedron.hpp"

#include <algorithm>
#include <limits>

#include "kernel/element/tetrahedron_gradients.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

constexpr int points = QuadraticTetrahedronLayout::points;
constexpr double near = 0.58541019662496845446, far = 0.13819660112501051518;  // (5 + 3 sqrt 5) / 20, (5 - sqrt 5) / 20
constexpr double most = 25.7507;                                               // c of the stable step

/// Place of the node between corners i and j; the corner where they are one.
constexpr int between[4][4] = {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}};

/// Derivatives of a nodal field by the four area coordinates at each point. By L_k it is (4 L_k - 1) f_k + sum over the
/// other corners j of 4 L_j f_kj; at point p only L_p is `near`.
template <class R>
struct Slopes {
  Vec3<R> at[points][4];
  [[gnu::always_inline]] explicit Slopes(const Vec3<R> (&f)[10]) {
    for (int k = 0; k < 4; ++k) {
      Vec3<R> all = R(4.0 * far - 1.0) * f[k];
      for (int j = 0; j < 4; ++j)
        if (j != k) all += R(4.0 * far) * f[between[k][j]];
      for (int p = 0; p < points; ++p) at[p][k] = all + R(4.0 * (near - far)) * f[between[k][p]];
    }
  }
};

/// Adds the forces that do work on the derivatives at point p: (4 L_k - 1) t_k to corner k, 4 L_j t_i + 4 L_i t_j to
/// the node between i and j.
template <class R>
[[gnu::always_inline]] inline void collect(int p, const Vec3<R> (&t)[4], Vec3<R> (&f)[10]) {
  const auto four_l = [p](int k) { return 4.0 * (k == p ? near : far); };
  for (int k = 0; k < 4; ++k) f[k] += R(four_l(k) - 1.0) * t[k];
  for (int e = 0; e < 6; ++e) {
    const auto [i, j] = quadratic_tetrahedron_edge[e];
    f[4 + e] += R(four_l(j)) * t[i] + R(four_l(i)) * t[j];
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
QuadraticTetrahedronForces<R> quadratic_tetrahedron_cycle(const HexahedronProperties& solid, const LawKernel<Law>& law,
                                                          const QuadraticTetrahedronMotion<R>& nodes, double dt,
                                                          double* state) {
  using L = QuadraticTetrahedronLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = quadratic_tetrahedron_layout(law);
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const R none = R(0.0);

  Vec3<R> v[10], mid[10];
  for (int i = 0; i < 10; ++i) {
    v[i] = any(!alive) ? select(alive, nodes.v[i], Vec3<R>{}) : nodes.v[i];
    mid[i] = nodes.x[i] - R(0.5 * dt) * v[i];
  }
  const Slopes<R> rates(v), middle(mid), end(nodes.x);

  SolidTensor<R> stress[points];
  R failed = none, wave = none, dilation = none, mid_volume = none, stiffest = none, least = none;
  for (int p = 0; p < points; ++p) {
    const TetrahedronGradients<R> at_mid(middle.at[p]);
    const Matrix<R> l = velocity_gradient(at_mid, rates.at[p]);
    dilation += at_mid.volume * (l.x.x + l.y.y + l.z.z);
    mid_volume += at_mid.volume;
    double* history = state + layout.history_of(p) * lanes<R>;
    const Vec3<R> half = half_turn(l, dt);
    const Frame<R> turn = rotation_of(half);
    SolidTensor<R>& s = stress[p];
    s = rotated(turn, load_solid<R>(state + layout.point(p) * lanes<R>));
    law.rotate(turn, history);
    law.solid(s, rate_at_end(l, half), dt, history);
    store_solid(state + layout.point(p) * lanes<R>, s);
    wave = max(wave, law.template wave_modulus<R>(history));
    if (law.can_fail()) failed += select(law.template failed<R>(history), R(1.0), none);
  }
  const R trace = dilation / mid_volume;

  const R density = solid.density * load_field<R>(state, L::density_scale);
  R volume[points];
  Vec3<R> gradient[points][3];
  for (int p = 0; p < points; ++p) {
    const TetrahedronGradients<R> at_end(end.at[p]);
    volume[p] = R(1.0 / points) * at_end.volume;
    for (int k = 0; k < 3; ++k) gradient[p][k] = at_end.b[k];
    stiffest = max(stiffest, volume[p] * at_end.largest());
    least = p == 0 ? at_end.volume : min(least, at_end.volume);
  }
  const double modulus = std::max(e.E / (1.0 - 2.0 * e.nu), 2.0 * e.shear);  // 3 K, 2 G
  const R length = sqrt(load_field<R>(state, L::volume) * R(e.bulk_wave() / (modulus * most)) / stiffest);
  const BulkViscosity<R> bulk(solid, wave, density, length, trace);
  R all = R(0.0);
  for (const R& share : volume) all += share;
  book_viscosity<L>(bulk.pressure, trace, all, dt, state);

  if (law.can_fail()) alive = alive && failed < R(points_to_delete(law));
  if (law.deletion_step() > 0.0) alive = alive && bulk.step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), none));

  QuadraticTetrahedronForces<R> out;
  for (int p = 0; p < points; ++p) {
    heat_by_viscosity(law, bulk.pressure, trace, dt, state + layout.history_of(p) * lanes<R>);
    const SolidTensor<R>& s = stress[p];
    const R q = bulk.pressure;
    const Matrix<R> total{{s.xx - q, s.xy, s.zx}, {s.xy, s.yy - q, s.yz}, {s.zx, s.yz, s.zz - q}};
    Vec3<R> t[4];
    for (int k = 0; k < 3; ++k) t[k] = volume[p] * (total * gradient[p][k]);
    t[3] = -(t[0] + t[1] + t[2]);
    collect(p, t, out.f);
  }
  if (any(!alive))
    for (Vec3<R>& f : out.f) f = select(alive, f, Vec3<R>{});
  out.stable_step = select(alive, bulk.step, R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, least, R(1.0));
  return out;
}

void start_quadratic_tetrahedron(const QuadraticTetrahedronLayout& layout, const std::array<Vec3d, 10>& x,
                                 double* state, int width, int lane) {
  using L = QuadraticTetrahedronLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
  state[L::volume * width + lane] = quadratic_tetrahedron_volume(x);
}

namespace {

Slopes<double> slopes_of(const std::array<Vec3d, 10>& f) {
  Vec3d nodes[10];
  std::copy(f.begin(), f.end(), nodes);
  return Slopes<double>(nodes);
}

}  // namespace

double quadratic_tetrahedron_volume(const std::array<Vec3d, 10>& x) {
  const Slopes<double> places = slopes_of(x);
  double volume = 0.0;
  for (const auto& corners : places.at) volume += TetrahedronGradients<double>(corners).volume / points;
  return volume;
}

double quadratic_tetrahedron_least_volume(const std::array<Vec3d, 10>& x) {
  const Slopes<double> places = slopes_of(x);
  double least = std::numeric_limits<double>::infinity();
  for (const auto& corners : places.at) least = std::min(least, TetrahedronGradients<double>(corners).volume);
  return least;
}

std::array<Vec3d, 3> quadratic_tetrahedron_gradient(const std::array<Vec3d, 10>& x, const std::array<Vec3d, 10>& v) {
  const Slopes<double> places = slopes_of(x), rates = slopes_of(v);
  std::array<Vec3d, 3> mean{};
  double volume = 0.0;
  for (int p = 0; p < points; ++p) {
    const TetrahedronGradients<double> at(places.at[p]);
    const Matrix<double> l = velocity_gradient(at, rates.at[p]);
    mean[0] += at.volume * l.x;
    mean[1] += at.volume * l.y;
    mean[2] += at.volume * l.z;
    volume += at.volume;
  }
  for (Vec3d& row : mean) row = (1.0 / volume) * row;
  return mean;
}

template QuadraticTetrahedronForces<NativeBatch> quadratic_tetrahedron_cycle(
    const HexahedronProperties&, const LawKernel<Elastic>&, const QuadraticTetrahedronMotion<NativeBatch>&, double,
    double*);
template QuadraticTetrahedronForces<NativeBatch> quadratic_tetrahedron_cycle(
    const HexahedronProperties&, const LawKernel<PlasticKinematic>&, const QuadraticTetrahedronMotion<NativeBatch>&,
    double, double*);
template QuadraticTetrahedronForces<NativeBatch> quadratic_tetrahedron_cycle(
    const HexahedronProperties&, const LawKernel<PiecewiseLinear>&, const QuadraticTetrahedronMotion<NativeBatch>&,
    double, double*);
template QuadraticTetrahedronForces<NativeBatch> quadratic_tetrahedron_cycle(
    const HexahedronProperties&, const LawKernel<ComposedLaw>&, const QuadraticTetrahedronMotion<NativeBatch>&, double,
    double*);

}  // namespace nugget::kernel
