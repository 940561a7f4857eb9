// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/full_hexahedron.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "kernel/element/assumed_strain.hpp"
#include "kernel/element/brick_patterns.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

constexpr int points = FullHexahedronLayout::points;

/// Derivatives of a nodal field by xi, eta and zeta at a point.
template <class R>
struct Slopes {
  Vec3<R> xi, eta, zeta;
  [[gnu::always_inline]] Slopes(const Patterns<R>& f, const GaussPoint& at)
      : xi(f.a + R(at.eta) * f.h[2] + R(at.zeta) * f.h[1] + R(at.eta * at.zeta) * f.h[3]),
        eta(f.b + R(at.xi) * f.h[2] + R(at.zeta) * f.h[0] + R(at.xi * at.zeta) * f.h[3]),
        zeta(f.c + R(at.xi) * f.h[1] + R(at.eta) * f.h[0] + R(at.xi * at.eta) * f.h[3]) {}
};

/// The gradients of xi, eta and zeta at a point, times its Jacobian.
template <class R>
struct Cofactors {
  Vec3<R> xi, eta, zeta;
  R jacobian;
  [[gnu::always_inline]] explicit Cofactors(const Slopes<R>& x)
      : xi(cross(x.eta, x.zeta)), eta(cross(x.zeta, x.xi)), zeta(cross(x.xi, x.eta)), jacobian(dot(x.xi, xi)) {}
};

/// Velocity gradient v_i,j at a point.
template <class R>
[[gnu::always_inline]] inline Matrix<R> velocity_gradient(const Slopes<R>& v, const Cofactors<R>& c) {
  const R over = 1.0 / c.jacobian;
  const auto row = [&](R Vec3<R>::*i) { return over * (v.xi.*i * c.xi + v.eta.*i * c.eta + v.zeta.*i * c.zeta); };
  return {row(&Vec3<R>::x), row(&Vec3<R>::y), row(&Vec3<R>::z)};
}

/// Adds a point's share to the forces that do work on the patterns of velocity.
template <class R>
[[gnu::always_inline]] inline void collect(const SolidTensor<R>& s, const Cofactors<R>& c, const GaussPoint& at,
                                           Patterns<R>& f) {
  const Matrix<R> stress{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  const Vec3<R> xi = stress * c.xi, eta = stress * c.eta, zeta = stress * c.zeta;
  f.a += xi;
  f.b += eta;
  f.c += zeta;
  f.h[0] += R(at.zeta) * eta + R(at.eta) * zeta;
  f.h[1] += R(at.zeta) * xi + R(at.xi) * zeta;
  f.h[2] += R(at.eta) * xi + R(at.xi) * eta;
  f.h[3] += R(at.eta * at.zeta) * xi + R(at.xi * at.zeta) * eta + R(at.xi * at.eta) * zeta;
}

/// The brick as its shape functions have it.
template <class R>
struct Isoparametric {
  const Patterns<R>& x;

  /// Velocity gradients of the points and the volumes that go with them.
  [[gnu::always_inline]] void rates(const Patterns<R>& v, Matrix<R> (&l)[points], R (&volume)[points]) const {
    for (int p = 0; p < points; ++p) {
      const Cofactors<R> c(Slopes<R>(x, gauss_point(p)));
      l[p] = velocity_gradient(Slopes<R>(v, gauss_point(p)), c);
      volume[p] = c.jacobian;
    }
  }
  [[gnu::always_inline]] void volumes(R (&volume)[points]) const {
    for (int p = 0; p < points; ++p) volume[p] = Cofactors<R>(Slopes<R>(x, gauss_point(p))).jacobian;
  }
  /// Nodal forces that do the work of the stresses.
  [[gnu::always_inline]] void forces(const SolidTensor<R> (&stress)[points], Vec3<R> (&f)[8]) const {
    Patterns<R> sum;
    for (int p = 0; p < points; ++p)
      collect(stress[p], Cofactors<R>(Slopes<R>(x, gauss_point(p))), gauss_point(p), sum);
    const R eighth = R(0.125);
    nodes_of(Patterns<R>{eighth * sum.a,
                         eighth * sum.b,
                         eighth * sum.c,
                         {eighth * sum.h[0], eighth * sum.h[1], eighth * sum.h[2], eighth * sum.h[3]}},
             f);
  }
};

/// Failed points that delete an element.
template <class Law>
double points_to_delete(const LawKernel<Law>& law) {
  const double limit = law.points_to_delete();
  if (limit < 0.0) return -limit * points / 100.0;
  return limit > 0.0 && limit < points ? limit : points;
}

/// Whether the law has the stresses on a weld's cross-section only.
template <class Law>
bool is_uniaxial(const LawKernel<Law>& law) {
  if constexpr (LawOfWelds<Law>)
    return law.uniaxial();
  else
    return false;
}

/// The cycle with the strains of `field_on(geometry)`: an Isoparametric or an AssumedStrain.
template <class R, class Law, class FieldOn>
[[gnu::always_inline]] inline SolidForces<R> cycle_of(const HexahedronProperties& brick, const LawKernel<Law>& law,
                                                      const SolidMotion<R>& nodes, double dt, double* state,
                                                      const FieldOn& field_on) {
  using L = FullHexahedronLayout;
  const L layout = full_hexahedron_layout(law);
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const R none = R(0.0), third = R(1.0 / 3.0);

  const BrickStep<R> motion(nodes, dt, alive);
  const Patterns<R>&v = motion.v, &mid = motion.mid, &end = motion.end;

  Matrix<R> l[points];
  R part[points];
  field_on(mid).rates(v, l, part);
  R volume = none, growth = none;
  for (int p = 0; p < points; ++p) {
    volume += part[p];
    growth += part[p] * (l[p].x.x + l[p].y.y + l[p].z.z);
  }
  const R trace = growth / volume;

  constexpr bool weld = LawOfWelds<Law>;
  const bool uniaxial = is_uniaxial(law);
  const R share = R(1.0 / points), weld_integrity = load_field<R>(state, L::integrity);
  R rate = none, left = none;  // means over the points: effective strain rate, what damage has left
  SolidTensor<R> stress[points];
  R failed = none, wave = none;  // points that have failed; greatest wave modulus
  for (int p = 0; p < points; ++p) {
    double* at = state + layout.point(p) * lanes<R>;
    double* history = state + layout.history_of(p) * lanes<R>;
    const Vec3<R> half = half_turn(l[p], dt);
    const Frame<R> turn = rotation_of(half);
    const R extra = third * (trace - (l[p].x.x + l[p].y.y + l[p].z.z));
    SolidTensor<R> s = rotated(turn, load_solid<R>(at));
    law.rotate(turn, history);
    SolidTensor<R> d = rate_at_end(l[p], half);
    d.xx += extra;
    d.yy += extra;
    d.zz += extra;
    if constexpr (weld) {
      rate += share * effective_rate(d);
      if (uniaxial)
        s = section_stress(law, l[p], mid, end, dt, history);
      else
        law.solid(s, d, dt, history);
      left += share * law.template integrity<R>(history);
    } else {
      law.solid(s, d, dt, history);
    }
    store_solid(at, s);
    stress[p] = weld ? weld_integrity * s : s;
    wave = max(wave, law.template wave_modulus<R>(history));
    if (law.can_fail()) failed += select(law.template failed<R>(history), R(1.0), none);
  }

  if constexpr (weld) store_field(state, L::strain_rate, rate);

  // Mean pressure at the end; the points keep their deviators.
  const auto field = field_on(end);
  field.volumes(part);
  R end_volume = none, mean = none, least = part[0];
  for (int p = 0; p < points; ++p) {
    end_volume += part[p];
    least = select(part[p] < least, part[p], least);
    mean += part[p] * (third * (stress[p].xx + stress[p].yy + stress[p].zz));
  }
  mean = mean / end_volume;

  const R density = brick.density * load_field<R>(state, L::density_scale);
  const BulkViscosity<R> bulk(brick, wave, density, end_volume / sqrt(largest_face2(end)), trace);
  const R pressure = weld ? weld_integrity * left * bulk.pressure : bulk.pressure;
  mean -= pressure;
  for (int p = 0; p < points; ++p) heat_by_viscosity(law, pressure, trace, dt, state + layout.history_of(p) * lanes<R>);
  book_viscosity<L>(pressure, trace, end_volume, dt, state);

  if (law.can_fail()) alive = alive && failed < R(points_to_delete(law));
  if (law.deletion_step() > 0.0) alive = alive && bulk.step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0) store_field(state, L::alive, select(alive, R(1.0), none));

  for (SolidTensor<R>& s : stress) {
    // A uniaxial stress state has no pressure of its own that could be shared.
    const R change = uniaxial ? -pressure : mean - third * (s.xx + s.yy + s.zz);
    s.xx += change;
    s.yy += change;
    s.zz += change;
  }
  SolidForces<R> out;
  field.forces(stress, out.f);
  if (any(!alive))
    for (Vec3<R>& a : out.f) a = select(alive, a, Vec3<R>{});
  out.stable_step = select(alive, bulk.step, R(std::numeric_limits<double>::infinity()));
  // A point is inside out long before the volume of the whole is negative. With assumed strains each stands for an
  // eighth of the whole.
  out.volume = select(alive, least, R(1.0));
  return out;
}

}  // namespace

template <class R, class Law>
SolidForces<R> full_hexahedron_cycle(const HexahedronProperties& brick, BrickStrains strains, const LawKernel<Law>& law,
                                     const SolidMotion<R>& nodes, double dt, double* state) {
  if (strains == BrickStrains::shape_functions)
    return cycle_of(brick, law, nodes, dt, state, [](const Patterns<R>& x) { return Isoparametric<R>{x}; });
  const BendingStrains across = is_uniaxial(law) ? BendingStrains{} : BendingStrains(law.elastic().nu);
  return cycle_of(brick, law, nodes, dt, state,
                  [&across](const Patterns<R>& x) { return AssumedStrain<R>(across, x); });
}

void start_full_hexahedron(const FullHexahedronLayout& layout, double* state, int width, int lane) {
  using L = FullHexahedronLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
  state[L::integrity * width + lane] = 1.0;
}

template <LawOfWelds Law>
void freeze_yield(const FullHexahedronLayout& layout, const LawKernel<Law>& law, double* state, int width, int lane) {
  for (int p = 0; p < points; ++p) {
    const auto at = [&](int i) { return state[(layout.point(p) + i) * width + lane]; };
    state[(layout.history_of(p) + LawKernel<Law>::frozen_yield_field) * width + lane] =
        law.frozen_stress(effective_stress({at(0), at(1), at(2), at(3), at(4), at(5)}));
  }
}

template void freeze_yield(const FullHexahedronLayout&, const LawKernel<Spotweld>&, double*, int, int);
template SolidForces<NativeBatch> full_hexahedron_cycle(const HexahedronProperties&, BrickStrains,
                                                        const LawKernel<Elastic>&, const SolidMotion<NativeBatch>&,
                                                        double, double*);
template SolidForces<NativeBatch> full_hexahedron_cycle(const HexahedronProperties&, BrickStrains,
                                                        const LawKernel<PlasticKinematic>&,
                                                        const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> full_hexahedron_cycle(const HexahedronProperties&, BrickStrains,
                                                        const LawKernel<PiecewiseLinear>&,
                                                        const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> full_hexahedron_cycle(const HexahedronProperties&, BrickStrains,
                                                        const LawKernel<Spotweld>&, const SolidMotion<NativeBatch>&,
                                                        double, double*);
template SolidForces<NativeBatch> full_hexahedron_cycle(const HexahedronProperties&, BrickStrains,
                                                        const LawKernel<ComposedLaw>&, const SolidMotion<NativeBatch>&,
                                                        double, double*);

}  // namespace nugget::kernel
