// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/full_hexahedron.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

#include "kernel/element/assumed_strain.hpp"
#include "kernel/element/enhanced_strain.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

constexpr int points = FullHexahedronLayout::points;

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

/// The cycle with the strains of `field_on(geometry)`: an Isoparametric, AssumedStrain or EnhancedStrain.
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
  constexpr bool one_pressure = decltype(field_on(mid))::one_pressure;
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
    [[maybe_unused]] const R extra = third * (trace - (l[p].x.x + l[p].y.y + l[p].z.z));
    SolidTensor<R> s = rotated(turn, load_solid<R>(at));
    law.rotate(turn, history);
    SolidTensor<R> d = rate_at_end(l[p], half);
    if constexpr (one_pressure) {
      d.xx += extra;
      d.yy += extra;
      d.zz += extra;
    }
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
    const R change = uniaxial || !one_pressure ? -pressure : mean - third * (s.xx + s.yy + s.zz);
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
  if constexpr (!LawOfWelds<Law>) {
    if (strains == BrickStrains::enhanced)
      return cycle_of(brick, law, nodes, dt, state,
                      [&law](const Patterns<R>& x) { return EnhancedStrain<R>(law.elastic(), x); });
    if (strains == BrickStrains::wedge)
      return cycle_of(brick, law, nodes, dt, state,
                      [](const Patterns<R>& x) { return Isoparametric<R, WedgeRule>{x}; });
  }
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
