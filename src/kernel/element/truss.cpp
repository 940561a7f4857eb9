// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/truss.hpp"
#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/own_kernels.hpp"

#include <limits>

namespace nugget::kernel {

template <class R, class Law>
NodalForces<R, 2> truss_cycle(double area, double density, const LawKernel<Law>& law, const NodalMotion<R, 2>& nodes,
                              double dt, double* state) {
  using L = TrussLayout;
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const Vec3<R> chord = nodes.x[1] - nodes.x[0], stretch = nodes.v[1] - nodes.v[0];
  const Vec3<R> mid = chord - R(0.5 * dt) * stretch;
  const R length = norm(chord), none = R(0.0);
  store_field(state, L::length, select(alive, length, load_field<R>(state, L::length)));

  double* stress = state + L::stress * lanes<R>;
  double* history = state + L::history * lanes<R>;
  FibreTensor<R> a = load_fibre<R>(stress);
  const FibreTensor<R> rate{dot(stretch, mid) / dot(mid, mid), none, none};
  law.fibre(a, select(alive, rate, FibreTensor<R>{}), dt, history);
  store_fibre(stress, a);
  if (law.can_fail()) {
    alive = alive && !law.template failed<R>(history);
    store_field(state, L::alive, select(alive, R(1.0), none));
  }
  const R N = select(alive, area * a.rr, none);
  store_field(state, L::force, N);

  NodalForces<R, 2> out;
  out.f[1] = (N / length) * chord;
  out.f[0] = -out.f[1];
  const R heavy = density * load_field<R>(state, L::density_scale);
  out.stable_step =
      select(alive, length * sqrt(heavy * (1.0 / law.elastic().E)), R(std::numeric_limits<double>::infinity()));
  return out;
}

template NodalForces<NativeBatch, 2> truss_cycle(double, double, const LawKernel<Elastic>&,
                                                 const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> truss_cycle(double, double, const LawKernel<PlasticKinematic>&,
                                                 const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> truss_cycle(double, double, const LawKernel<PiecewiseLinear>&,
                                                 const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> truss_cycle(double, double, const LawKernel<ComposedLaw>&,
                                                 const NodalMotion<NativeBatch, 2>&, double, double*);

}  // namespace nugget::kernel
