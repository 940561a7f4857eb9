// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/hexahedron.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "kernel/element/physical_stabilisation.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

template <class R>
Hourglass<R> load_hourglass(const Number<R>* state) {
  Hourglass<R> r;
  for (int i = 0; i < 4; ++i) r.q[i] = load_vector<R>(state, HexahedronLayout::hourglass + 3 * i);
  return r;
}

/// Advances the hourglass forces by a step and adds up their work; returns them in global axes at the end of the step.
/// `share`: stiffness now over that of `e`.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> resist_hourglass(const HexahedronProperties& brick,
                                                            const HexahedronLayout& layout, const ElasticConstants& e,
                                                            const Gradient<R>& g, const Patterns<R>& v,
                                                            const Patterns<R>& mid, const Patterns<R>& end,
                                                            const Hourglass<R>& rate, const Frame<R>& turn,
                                                            const Vec3<R>& half, const R& side, const R& share,
                                                            const R& integrity, double dt, Number<R>* state) {
  using L = HexahedronLayout;
  Hourglass<R> old = load_hourglass<R>(state), now = old, q = rate;
  if (brick.hourglass == 6) {
    q = strains_of(mid, rate);
    const StabilizingStress<R> stress =
        stabilizing_stress(e, (dt * brick.hourglass_coefficient) * share, g.volume, side, mid, v, q);
    // A brick that is stretched keeps the forces along its sides.
    const auto shorter = [dt](const R& growth) { return 1.0 - (dt * growth) * (1.0 - (0.5 * dt) * growth); };
    const Vec3<R> f{shorter(stress.growth.x), shorter(stress.growth.y), shorter(stress.growth.z)};
    for (int i = 0; i < 4; ++i) {
      const Vec3<R>& was = old.q[i];
      now.q[i] = Vec3<R>{f.x * was.x, f.y * was.y, f.z * was.z} + stress.change.q[i];
    }
  } else if (brick.hourglass >= 4) {
    const R stiffness = (8.0 * brick.hourglass_coefficient * e.shear * dt) * share * g.squared() * g.over_volume;
    for (int i = 0; i < 4; ++i) {
      old.q[i] = turn.local(old.q[i]);
      q.q[i] += cross(half, q.q[i]);
      now.q[i] = old.q[i] + stiffness * q.q[i];
    }
  } else {
    // QM rho c V^(2/3) / 4 on patterns of entries +-1. The mode of the element alone then decays at 16 QM c / V^(1/3),
    // which near the stable step is fast: with the velocity before the step it would overshoot and, with bulk
    // viscosity, drive a single brick unstable. Taken at the mean of the velocities before and after, it cannot
    // (docs/decisions/0007).
    const R density = brick.density * load_field<R>(state, L::density_scale),
            impedance = sqrt(density * share * e.bulk_wave());
    const R centred = side + (8.0 * brick.hourglass_coefficient * dt) * (impedance / density);
    const R viscosity = (16.0 * brick.hourglass_coefficient) * impedance * side * side * side / centred;
    for (int i = 0; i < 4; ++i) now.q[i] = viscosity * q.q[i];
  }
  R power = R(0.0);
  for (int i = 0; i < 4; ++i) {
    power += dot(old.q[i] + now.q[i], q.q[i]);
    store_vector(state, L::hourglass + 3 * i, now.q[i]);
  }
  add_to_field(state, L::hourglass_energy, (0.5 * dt) * integrity * power, layout.rest_of_hourglass_energy());
  for (Vec3<R>& a : now.q) a = integrity * a;
  return brick.hourglass == 6 ? forces_on_patterns(end, now) : now;
}

}  // namespace

template <class R, class Law>
SolidForces<R> hexahedron_cycle(const HexahedronProperties& brick, const LawKernel<Law>& law,
                                const SolidMotion<R>& nodes, double dt, Number<R>* state) {
  using L = HexahedronLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = hexahedron_layout(law);
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const BrickStep<R> motion(nodes, dt, alive);
  const Patterns<R>&v = motion.v, &mid = motion.mid, &end = motion.end;
  const Gradient<R> g(mid), g_end(end);
  const Matrix<R> l = velocity_gradient(g, v);
  const Vec3<R> half = half_turn(l, dt);
  const Frame<R> turn = rotation_of(half);

  // V^(1/3) follows V by Halley's rule, cubic in the change of a step.
  const R old_side = load_field<R>(state, L::side), cube = old_side * old_side * old_side;
  const R side = old_side * (cube + 2.0 * g_end.volume) / (2.0 * cube + g_end.volume);
  store_field(state, L::side, select(alive && g_end.volume > 0.0, side, old_side));

  Number<R>* history = state + L::first_history * lanes<R>;
  const SolidTensor<R> d = rate_at_end(l, half);
  SolidTensor<R> s = rotated(turn, load_solid<R>(state + L::stress * lanes<R>));
  law.rotate(turn, history);
  R integrity(1.0), weld_integrity(1.0);  // of hourglass forces and bulk viscosity; of the weld as a whole
  if constexpr (LawOfWelds<Law>) {
    store_field(state, L::strain_rate, effective_rate(d));
    if (law.uniaxial())
      s = section_stress(law, l, mid, end, dt, history);
    else
      law.solid(s, d, dt, history);
    weld_integrity = load_field<R>(state, L::integrity);
    integrity = weld_integrity * law.template integrity<R>(history);
  } else {
    law.solid(s, d, dt, history);
  }
  store_solid(state + L::stress * lanes<R>, s);

  const bool orthogonal = brick.hourglass != 1;
  const Hourglass<R> rate = orthogonal ? hourglass_rates(v, l, mid) : Hourglass<R>{{v.h[0], v.h[1], v.h[2], v.h[3]}};
  R share(1.0);
  if constexpr (requires { law.template stiffness_share<R>(history); })
    share = law.template stiffness_share<R>(history);
  const Hourglass<R> q =
      resist_hourglass(brick, layout, e, g, v, mid, end, rate, turn, half, side, share, integrity, dt, state);

  const R density = brick.density * load_field<R>(state, L::density_scale), none = R(0.0);
  const R length = g_end.volume / sqrt(largest_face2(end));
  const BulkViscosity<R> bulk(brick, law.template wave_modulus<R>(history), density, length, l.x.x + l.y.y + l.z.z);
  const R pressure = integrity * bulk.pressure;
  heat_by_viscosity(law, pressure, l.x.x + l.y.y + l.z.z, dt, history);
  book_viscosity<L>(pressure, l.x.x + l.y.y + l.z.z, g_end.volume, dt, state, layout.rest_of_bulk_viscosity_work());
  if constexpr (LawOfWelds<Law>) s = weld_integrity * s;
  s.xx -= pressure;
  s.yy -= pressure;
  s.zz -= pressure;
  const R step = bulk.step;

  if (law.can_fail()) alive = alive && !law.template failed<R>(history);
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), none));

  SolidForces<R> out;
  forces_of(g_end, end, s, q, orthogonal, out.f);
  if (any(!alive))
    for (Vec3<R>& f : out.f) f = select(alive, f, Vec3<R>{});
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, g_end.volume, cube);
  return out;
}

void start_hexahedron(const HexahedronLayout& layout, const std::array<Vec3d, 8>& x, double* state, int width,
                      int lane) {
  using L = HexahedronLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
  state[L::integrity * width + lane] = 1.0;
  state[L::side * width + lane] = std::cbrt(hexahedron_volume(x));
}

template <LawOfWelds Law>
void freeze_yield(const LawKernel<Law>& law, double* state, int width, int lane) {
  using L = HexahedronLayout;
  const auto at = [&](int i) { return state[(L::stress + i) * width + lane]; };
  state[(L::first_history + LawKernel<Law>::frozen_yield_field) * width + lane] =
      law.frozen_stress(effective_stress({at(0), at(1), at(2), at(3), at(4), at(5)}));
}

double hexahedron_volume(const std::array<Vec3d, 8>& x) {
  return Gradient<double>(patterns_of(x)).volume;
}

double hexahedron_stable_step(const std::array<Vec3d, 8>& x, double E, double nu, double density) {
  const double c = std::sqrt(ElasticConstants(E, nu).bulk_wave() / density);
  return hexahedron_volume(x) / std::sqrt(largest_face2(patterns_of(x))) / c;
}

double hexahedron_nodal_mass(const std::array<Vec3d, 8>& x, double density) {
  return 0.125 * density * hexahedron_volume(x);
}

template void freeze_yield(const LawKernel<Spotweld>&, double*, int, int);
template SolidForces<NativeBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<Elastic>&,
                                                   const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<PlasticKinematic>&,
                                                   const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<PiecewiseLinear>&,
                                                   const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<Spotweld>&,
                                                   const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<ComposedLaw>&,
                                                   const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<SingleBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<Elastic>&,
                                                   const SolidMotion<SingleBatch>&, double, float*);
template SolidForces<SingleBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<PlasticKinematic>&,
                                                   const SolidMotion<SingleBatch>&, double, float*);
template SolidForces<SingleBatch> hexahedron_cycle(const HexahedronProperties&, const LawKernel<PiecewiseLinear>&,
                                                   const SolidMotion<SingleBatch>&, double, float*);

}  // namespace nugget::kernel
