// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/tetrahedron.hpp"

#include <algorithm>
#include <limits>

#include "kernel/element/tetrahedron_gradients.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {

template <class R, class Law>
TetrahedronForces<R> tetrahedron_cycle(const HexahedronProperties& solid, const LawKernel<Law>& law,
                                       const TetrahedronLayout& layout, const TetrahedronMotion<R>& nodes, double dt,
                                       double* state) {
  using L = TetrahedronLayout;
  const ElasticConstants& e = law.elastic();
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const R none = R(0.0);

  Vec3<R> v[4], mid[4];
  for (int i = 0; i < 4; ++i) {
    v[i] = any(!alive) ? select(alive, nodes.v[i], Vec3<R>{}) : nodes.v[i];
    mid[i] = nodes.x[i] - R(0.5 * dt) * v[i];
  }
  const Matrix<R> l = velocity_gradient(TetrahedronGradients<R>(mid), v);
  const R trace = l.x.x + l.y.y + l.z.z;

  double* history = state + L::first_history * lanes<R>;
  const Vec3<R> half = half_turn(l, dt);
  const Frame<R> turn = rotation_of(half);
  SolidTensor<R> s = rotated(turn, load_solid<R>(state + L::stress * lanes<R>));
  law.rotate(turn, history);
  law.solid(s, rate_at_end(l, half), dt, history);
  if (layout.nodal_pressure) {
    R change = load_field<R>(state, layout.mean_stress()) - (1.0 / 3.0) * (s.xx + s.yy + s.zz);
    if (law.can_fail()) change = select(law.template failed<R>(history), none, change);
    s.xx += change;
    s.yy += change;
    s.zz += change;
  }
  store_solid(state + L::stress * lanes<R>, s);

  const TetrahedronGradients<R> end(nodes.x);
  const R density = solid.density * load_field<R>(state, L::density_scale);
  const double stiffest = std::max(e.E / (1.0 - 2.0 * e.nu), 2.0 * e.shear);  // 3 K, 2 G
  const R length = sqrt(R(e.bulk_wave() / stiffest) / end.largest());
  const BulkViscosity<R> bulk(solid, law.template wave_modulus<R>(history), density, length, trace);
  heat_by_viscosity(law, bulk.pressure, trace, dt, history);
  book_viscosity<L>(bulk.pressure, trace, end.volume, dt, state);
  s.xx -= bulk.pressure;
  s.yy -= bulk.pressure;
  s.zz -= bulk.pressure;

  if (law.can_fail()) alive = alive && !law.template failed<R>(history);
  if (law.deletion_step() > 0.0) alive = alive && bulk.step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), none));

  const Matrix<R> stress{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  TetrahedronForces<R> out;
  for (int i = 0; i < 3; ++i) {
    const Vec3<R> f = end.volume * (stress * end.b[i]);
    out.f[i] = any(!alive) ? select(alive, f, Vec3<R>{}) : f;
  }
  out.f[3] = -(out.f[0] + out.f[1] + out.f[2]);
  out.stable_step = select(alive, bulk.step, R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, end.volume, R(1.0));
  return out;
}

void start_tetrahedron(const TetrahedronLayout& layout, double* state, int width, int lane) {
  using L = TetrahedronLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
}

double tetrahedron_volume(const std::array<Vec3d, 4>& x) {
  return dot(x[1] - x[0], cross(x[2] - x[0], x[3] - x[0])) / 6.0;
}

template TetrahedronForces<NativeBatch> tetrahedron_cycle(const HexahedronProperties&, const LawKernel<Elastic>&,
                                                          const TetrahedronLayout&,
                                                          const TetrahedronMotion<NativeBatch>&, double, double*);
template TetrahedronForces<NativeBatch> tetrahedron_cycle(const HexahedronProperties&,
                                                          const LawKernel<PlasticKinematic>&, const TetrahedronLayout&,
                                                          const TetrahedronMotion<NativeBatch>&, double, double*);
template TetrahedronForces<NativeBatch> tetrahedron_cycle(const HexahedronProperties&,
                                                          const LawKernel<PiecewiseLinear>&, const TetrahedronLayout&,
                                                          const TetrahedronMotion<NativeBatch>&, double, double*);
template TetrahedronForces<NativeBatch> tetrahedron_cycle(const HexahedronProperties&, const LawKernel<ComposedLaw>&,
                                                          const TetrahedronLayout&,
                                                          const TetrahedronMotion<NativeBatch>&, double, double*);

}  // namespace nugget::kernel
