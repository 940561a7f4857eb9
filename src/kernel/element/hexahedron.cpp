// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/hexahedron.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "kernel/element/uniform_gradient.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

template <class R>
Hourglass<R> load_hourglass(const Number<R>* state) {
  Hourglass<R> r;
  for (int i = 0; i < 4; ++i) r.q[i] = load_vector<R>(state, HexahedronLayout::hourglass + 3 * i);
  return r;
}

/// Physical stabilisation (docs/theory/hourglass.md#physical-stabilisation): the strains of the hourglass rates by the
/// brick's own directions, those of xi, eta and zeta in its middle. Of q[k] the component d is the direct strain along
/// d that the pattern k makes, and of d = k the pattern's share of two shears; of q[3] those of xi eta zeta. Direct
/// strains are those of the edges.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> strains_of(const Patterns<R>& x, const Hourglass<R>& q) {
  const Vec3<R>&q1 = q.q[0], &q2 = q.q[1], &q3 = q.q[2], &q4 = q.q[3];
  const Vec3<R>&h1 = x.h[0], &h2 = x.h[1], &h3 = x.h[2], &h4 = x.h[3];
  const R s1 = dot(h4, q1) + dot(h1, q4), s2 = dot(h4, q2) + dot(h2, q4), s3 = dot(h4, q3) + dot(h3, q4);
  return {{{dot(x.a, q1), dot(x.b, q1) + s3, dot(x.c, q1) + s2},
           {dot(x.a, q2) + s3, dot(x.b, q2), dot(x.c, q2) + s1},
           {dot(x.a, q3) + s2, dot(x.b, q3) + s1, dot(x.c, q3)},
           {dot(x.a, q4) + dot(h3, q2) + dot(h2, q3), dot(x.b, q4) + dot(h1, q3) + dot(h3, q1),
            dot(x.c, q4) + dot(h2, q1) + dot(h1, q2)}}};
}

/// Forces on the hourglass patterns that do the work of stresses on strains_of.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> forces_on_patterns(const Patterns<R>& x, const Hourglass<R>& s) {
  const Vec3<R>&p1 = s.q[0], &p2 = s.q[1], &p3 = s.q[2], &p4 = s.q[3];
  const Vec3<R>&h1 = x.h[0], &h2 = x.h[1], &h3 = x.h[2], &h4 = x.h[3];
  const auto along = [&x](const Vec3<R>& p) { return p.x * x.a + p.y * x.b + p.z * x.c; };
  const R s1 = p2.z + p3.y, s2 = p1.z + p3.x, s3 = p1.y + p2.x;
  return {{along(p1) + s1 * h4 + p4.y * h3 + p4.z * h2, along(p2) + s2 * h4 + p4.x * h3 + p4.z * h1,
           along(p3) + s3 * h4 + p4.x * h2 + p4.y * h1, along(p4) + s1 * h1 + s2 * h2 + s3 * h3}};
}

/// Stress that varies along the third direction of a brick and lies in the plane of two others, of products `g`, `h`
/// and `gh`: plane stress, so that bending draws along the strains across it. Over twice the shear modulus, times the
/// square of g h - gh^2.
template <class R>
struct InPlane {
  R first, second, shear;

  [[gnu::always_inline]] InPlane(double nu, const R& g, const R& h, const R& gh, const R& along_first,
                                 const R& along_second, const R& both) {
    const R half = 0.5 * both, common = gh * half;
    const R a = h * along_first - common, c = g * along_second - common;
    const R b = h * half - gh * along_second, d = g * half - gh * along_first;
    const R lateral = (nu / (1.0 - nu)) * (a + c), one = lateral + a, two = lateral + c;
    first = one * h - b * gh;
    second = two * g - d * gh;
    shear = b * g - one * gh;
  }
};

/// Changes of the stresses of the hourglass patterns in a step, times the volume that they stand for, of strain rates
/// by strains_of; `share` of the elastic ones. And by how much each direction grows a time, as share of its length.
template <class R>
struct StabilizingStress {
  Hourglass<R> change;
  Vec3<R> growth;

  [[gnu::always_inline]] StabilizingStress(const ElasticConstants& e, const R& share, const R& volume,
                                           const Patterns<R>& x, const Patterns<R>& v, const Hourglass<R>& strain) {
    const R g1 = dot(x.a, x.a), g2 = dot(x.b, x.b), g3 = dot(x.c, x.c);
    const R g23 = dot(x.b, x.c), g31 = dot(x.c, x.a), g12 = dot(x.a, x.b);
    const R gg1 = g2 * g3, gg2 = g3 * g1, gg3 = g1 * g2;
    const R over = 1.0 / (gg3 * g3), over1 = over * gg1, over2 = over * gg2, over3 = over * gg3;
    growth = {over1 * dot(x.a, v.a), over2 * dot(x.b, v.b), over3 * dot(x.c, v.c)};

    const Vec3<R>&e1 = strain.q[0], &e2 = strain.q[1], &e3 = strain.q[2], &e4 = strain.q[3];
    const InPlane<R> p1(e.nu, g2, g3, g23, e3.y, e2.z, e2.y + e3.z), p2(e.nu, g3, g1, g31, e1.z, e3.x, e1.x + e3.z),
        p3(e.nu, g1, g2, g12, e2.x, e1.y, e1.x + e2.y);
    const auto squared = [](const R& d) { return d * d; };
    const R d1 = squared(gg1 - g23 * g23), d2 = squared(gg2 - g31 * g31), d3 = squared(gg3 - g12 * g12), d12 = d1 * d2;
    const R modulus = (2.0 / 3.0 * e.shear) * share * volume, all = modulus / (d12 * d3);
    const R w1 = all * (d2 * d3), w2 = all * (d3 * d1), w3 = all * d12, last = ((1.0 + e.nu) / 3.0) * modulus;
    const R t1 = w1 * p1.shear, t2 = w2 * p2.shear, t3 = w3 * p3.shear;
    change = {{{t2 + t3, w3 * p3.second, w2 * p2.first},
               {w3 * p3.first, t3 + t1, w1 * p1.second},
               {w2 * p2.second, w1 * p1.first, t1 + t2},
               {last * squared(over1) * e4.x, last * squared(over2) * e4.y, last * squared(over3) * e4.z}}};
  }
};

/// The same; in single precision of the shape in units of V^(1/3), as it takes lengths to the power of 24.
template <class R>
[[gnu::always_inline]] inline StabilizingStress<R> stabilizing_stress(const ElasticConstants& e, const R& share,
                                                                      const R& volume, const R& side,
                                                                      const Patterns<R>& x, const Patterns<R>& v,
                                                                      const Hourglass<R>& strain) {
  if constexpr (is_single<R>) {
    const R over = 1.0 / side, over2 = over * over;
    Patterns<R> shape{over * x.a, over * x.b, over * x.c, {}};
    Hourglass<R> scaled;
    for (int i = 0; i < 4; ++i) scaled.q[i] = over2 * strain.q[i];
    StabilizingStress<R> stress(e, share, volume, shape, v, scaled);
    for (Vec3<R>& change : stress.change.q) change = over2 * change;
    stress.growth = over * stress.growth;
    return stress;
  } else {
    return {e, share, volume, x, v, strain};
  }
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
template SolidForces<double> hexahedron_cycle(const HexahedronProperties&, const LawKernel<Elastic>&,
                                              const SolidMotion<double>&, double, double*);
template SolidForces<double> hexahedron_cycle(const HexahedronProperties&, const LawKernel<PlasticKinematic>&,
                                              const SolidMotion<double>&, double, double*);
template SolidForces<double> hexahedron_cycle(const HexahedronProperties&, const LawKernel<PiecewiseLinear>&,
                                              const SolidMotion<double>&, double, double*);
template SolidForces<double> hexahedron_cycle(const HexahedronProperties&, const LawKernel<Spotweld>&,
                                              const SolidMotion<double>&, double, double*);
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
