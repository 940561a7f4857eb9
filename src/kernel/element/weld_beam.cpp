// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/weld_beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

#include "base/axis_across.hpp"
#include "base/index.hpp"
#include "kernel/element/gyration.hpp"
#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// Second moments about the nodes' line and area of the points, for masses.
struct Moments {
  double area = 0.0, ss = 0.0, tt = 0.0, st = 0.0;  ///< tt = sum of area t^2 (bending about s)
};
Moments moments(const FibreRule& rule) {
  Moments m;
  for (std::size_t k = 0; k < at(rule.count); ++k) {
    m.area += rule.area[k];
    m.ss += rule.area[k] * rule.s[k] * rule.s[k];
    m.tt += rule.area[k] * rule.t[k] * rule.t[k];
    m.st += rule.area[k] * rule.s[k] * rule.t[k];
  }
  return m;
}

/// The larger principal one of second moments. Where the product is no more than rounding, the larger of the two.
double principal(double ss, double tt, double st) {
  if (!(std::abs(st) > 1e-12 * std::max(ss, tt))) return std::max(ss, tt);
  return 0.5 * (ss + tt) + std::hypot(0.5 * (ss - tt), st);
}

/// What the section moves a unit of time and length: axial, shears at its middle, curvatures about s and t.
template <class R>
struct SectionRates {
  R axial, shear_s, shear_t, bend_s, bend_t;
};

/// How the section moves in a step.
template <class R>
struct SectionMotion {
  Vec3<R> turned_s;     ///< s at the start of the step, turned with the nodes
  Vec3<R> chord, slid;  ///< from node to node at the end of the step, and of it what a joint has slid before the step
  Frame<R> mid;         ///< axes in the middle of the step
  R mid_length;
  SectionRates<R> rates;
  R twist;  ///< of the nodes, a unit of time and length; whether the beam takes it or not
};
/// r, s and t of a beam of the chord given, and its length.
template <class R>
struct Axes {
  Frame<R> frame;
  R length;
};
template <class R>
Axes<R> axes_along(const Vec3<R>& chord, const Vec3<R>& towards) {
  const R length = norm(chord);
  const Vec3<R> r = (1.0 / length) * chord, s = unit(towards - dot(towards, r) * r);
  return {{r, s, cross(r, s)}, length};
}
/// `slid`: by a joint, at the start of the step; null where there is none.
template <class R>
SectionMotion<R> section_motion(const WeldBeamProperties& beam, const NodalMotion<R, 2>& nodes, double dt,
                                const Vec3<R>& old_s, const Vec3<R>* slid) {
  // s turns with the mean spin (Cayley's rotation, exact for a rigid body's chord velocities) and is put back across
  // the beam.
  SectionMotion<R> m;
  m.chord = nodes.x[1] - nodes.x[0];
  const Vec3<R> stretch = nodes.v[1] - nodes.v[0];
  const Vec3<R> turn = R(0.25 * dt) * (nodes.w[0] + nodes.w[1]);
  const auto turned = [&](const Vec3<R>& a) {
    const Vec3<R> lever = a + cross(turn, a);
    return a + (2.0 / (1.0 + dot(turn, turn))) * cross(turn, lever);
  };
  m.turned_s = turned(old_s);
  Vec3<R> own_chord = m.chord, mid_chord = m.chord - R(0.5 * dt) * stretch, mid_slid;
  if (slid != nullptr) {
    m.slid = turned(*slid);
    mid_slid = R(0.5) * (*slid + m.slid);
    own_chord = own_chord - m.slid;
    mid_chord = mid_chord - mid_slid;
  }
  const Vec3<R> s = axes_along(own_chord, m.turned_s).frame.e2;

  m.mid_length = norm(mid_chord);
  const R over_mid = 1.0 / m.mid_length;
  const Vec3<R> mid_r = over_mid * mid_chord, between = old_s + s;
  const Vec3<R> mid_s = unit(between - dot(between, mid_r) * mid_r);
  m.mid = {mid_r, mid_s, cross(mid_r, mid_s)};
  const Vec3<R> dv = over_mid * m.mid.local(stretch), dw = over_mid * m.mid.local(nodes.w[1] - nodes.w[0]);
  const Vec3<R> mean = m.mid.local(R(0.5) * (nodes.w[0] + nodes.w[1]));
  const double es = beam.offset_s, et = beam.offset_t;
  // Shear is that of the middle of the section, which moves with the nodes' spin where it is off their line.
  const R whole_twist = beam.no_torsion ? R(0.0) : dw.x;
  m.rates = {dv.x, dv.y - et * whole_twist - mean.z, dv.z + es * whole_twist + mean.y, dw.y, dw.z};
  m.twist = dw.x;
  if (slid != nullptr) {
    const Vec3<R> apart = over_mid * cross(mean, m.mid.local(mid_slid));
    m.rates.axial = m.rates.axial - apart.x;
    m.rates.shear_s = m.rates.shear_s - apart.y;
    m.rates.shear_t = m.rates.shear_t - apart.z;
  }
  return m;
}

/// What a joint is asked in a step of its beam.
struct JointStep {
  WeldJoint::State joint;
  WeldJoint::Freedoms moved{}, stiffness{}, force{};
};
/// `field`: of the beam's state; `rate`: of its section, `length` of the mid-step geometry, to which these belong.
template <class Field>
JointStep joint_step(const WeldBeamProperties& beam, const WeldBeamLayout& layout, const ElasticConstants& elastic,
                     double length, double dt, const WeldJoint::Freedoms& rate, const Field& field) {
  using L = WeldBeamLayout;
  const Moments section = moments(beam.fibres);
  const double shear = beam.shear_factor * elastic.shear * section.area;
  const WeldJoint::Freedoms by_length{elastic.E * section.area, shear, shear, elastic.E * section.tt,
                                      elastic.E * section.ss};
  constexpr std::array<int, WeldJoint::size> force_of{0, 1, 2, 4, 5};
  const double integrity = field(L::integrity), over = 1.0 / length;
  JointStep step{.joint = {.work = field(layout.joint_work()), .rate = field(layout.joint_rate())}};
  for (int i = 0; i < WeldJoint::size; ++i) {
    const auto k = at(i);
    step.joint.elastic[k] = field(layout.joint_elastic() + i);
    step.joint.flow[k] = field(layout.joint_flow() + i);
    step.moved[k] = dt * length * rate[k];
    step.stiffness[k] = integrity * by_length[k] * over;
    step.force[k] = field(L::resultant + force_of[k]);
  }
  return step;
}

template <class Field>
bool holds(const Field& field) {
  return field(WeldBeamLayout::alive) > 0.5 && field(WeldBeamLayout::integrity) > 0.0;
}

/// Leaves of the rates what the beams get; the rest is that of their joints. Lane after lane: a joint that flows has no
/// form for batches.
template <class R>
void share_with_joints(const WeldBeamProperties& beam, const WeldBeamLayout& layout, const ElasticConstants& elastic,
                       double dt, double* state, SectionMotion<R>& motion) {
  if (dt == 0.0) return;
  SectionRates<R>& rates = motion.rates;
  const std::array<R*, WeldJoint::size> rate{&rates.axial, &rates.shear_s, &rates.shear_t, &rates.bend_s,
                                             &rates.bend_t};
  for (int l = 0; l < lanes<R>; ++l) {
    const auto field = [&](int i) -> double& { return state[i * lanes<R> + l]; };
    if (!holds(field)) continue;
    const double length = lane(motion.mid_length, l), over = 1.0 / length;
    WeldJoint::Freedoms rate_of_lane;
    for (std::size_t i = 0; i < WeldJoint::size; ++i) rate_of_lane[i] = lane(*rate[i], l);
    JointStep step = joint_step(beam, layout, elastic, length, dt, rate_of_lane, field);
    const WeldJoint& own = beam.joints[static_cast<std::size_t>(field(layout.joint_of()))];
    const WeldJoint::Freedoms left = own.advance(step.joint, step.moved, step.stiffness, step.force, dt);
    field(layout.joint_work()) = step.joint.work;
    field(layout.joint_rate()) = step.joint.rate;
    for (int i = 0; i < WeldJoint::size; ++i) {
      field(layout.joint_elastic() + i) = step.joint.elastic[at(i)];
      field(layout.joint_flow() + i) = 0.0;
      set_lane(*rate[at(i)], l, left[at(i)] * over / dt);
    }
    const auto in_lane = [l](const Vec3<R>& a) { return Vec3d{lane(a.x, l), lane(a.y, l), lane(a.z, l)}; };
    const Frame3d mid{in_lane(motion.mid.e1), in_lane(motion.mid.e2), in_lane(motion.mid.e3)};
    const Vec3d slid = mid.global({step.moved[0] - left[0], step.moved[1] - left[1], step.moved[2] - left[2]});
    set_lane(motion.slid.x, l, lane(motion.slid.x, l) + slid.x);
    set_lane(motion.slid.y, l, lane(motion.slid.y, l) + slid.y);
    set_lane(motion.slid.z, l, lane(motion.slid.z, l) + slid.z);
  }
}

}  // namespace

FibreRule disc_fibres(double outer_diameter, double inner_diameter, int quadrature) {
  const double outer = 0.25 * outer_diameter * outer_diameter, inner = 0.25 * inner_diameter * inner_diameter;
  const double area = std::numbers::pi * (outer - inner);
  FibreRule rule;
  const auto add = [&](double radius, double angle, double weight) {
    const auto k = at(rule.count++);
    rule.s[k] = radius * std::cos(angle);
    rule.t[k] = radius * std::sin(angle);
    rule.area[k] = weight;
  };
  // Gauss points in the square of the radius make the second moments exact.
  const int rings = quadrature <= 2   ? 1
                    : quadrature == 3 ? 2
                                      : 3,
            angles = quadrature <= 2   ? 4
                     : quadrature == 3 ? 8
                                       : 16;
  const LayerRule gauss = gauss_layers(rings);
  for (int i = 0; i < rings; ++i) {
    const auto ring = at(i);
    const double square = 0.5 * (outer + inner) + 0.5 * (outer - inner) * gauss.zeta[ring];
    for (int j = 0; j < angles; ++j)
      add(std::sqrt(square), std::numbers::pi * (2.0 * j + 1.0) / angles, area * gauss.weight[ring] / angles);
  }
  return rule;
}

FibreRule rectangle_fibres(double side_s, double side_t, int quadrature) {
  std::array<double, 4> place{}, weight{};
  std::size_t count = 1;
  const auto set = [&](std::initializer_list<double> places, std::initializer_list<double> weights) {
    count = places.size();
    std::copy(places.begin(), places.end(), place.begin());
    std::copy(weights.begin(), weights.end(), weight.begin());
  };
  const double outer = std::sqrt((3.0 + 2.0 * std::sqrt(1.2)) / 7.0),
               inner = std::sqrt((3.0 - 2.0 * std::sqrt(1.2)) / 7.0);
  const double light = (18.0 - std::sqrt(30.0)) / 36.0, heavy = (18.0 + std::sqrt(30.0)) / 36.0;
  switch (quadrature) {
    case 1: set({0.0}, {2.0}); break;
    case 3: set({-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}); break;
    case 4: set({-1.0, 0.0, 1.0}, {1.0 / 3.0, 4.0 / 3.0, 1.0 / 3.0}); break;
    case 5: set({-outer, -inner, inner, outer}, {light, heavy, heavy, light}); break;
    default: set({-std::sqrt(1.0 / 3.0), std::sqrt(1.0 / 3.0)}, {1.0, 1.0});
  }
  FibreRule rule;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j) {
      const auto k = at(rule.count++);
      rule.s[k] = 0.5 * side_s * place[i];
      rule.t[k] = 0.5 * side_t * place[j];
      rule.area[k] = 0.25 * side_s * side_t * weight[i] * weight[j];
    }
  return rule;
}

double rectangle_torsion_share(double side_s, double side_t) {
  const double a = std::max(side_s, side_t), b = std::min(side_s, side_t), q = b / a;
  const double torsion = a * b * b * b * (1.0 / 3.0 - 0.21 * q * (1.0 - q * q * q * q / 12.0));
  return torsion / (a * b * (a * a + b * b) / 12.0);
}

void start_weld_beam(const WeldBeamLayout& layout, const Vec3d& x1, const Vec3d& x2, const Vec3d& towards,
                     double* state, int width, int lane) {
  using L = WeldBeamLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  const Vec3d along = x2 - x1, r = unit(along);
  const Vec3d s = beam_side(r, towards);
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
  state[L::integrity * width + lane] = 1.0;
  state[L::axis_s * width + lane] = s.x;
  state[(L::axis_s + 1) * width + lane] = s.y;
  state[(L::axis_s + 2) * width + lane] = s.z;
  state[L::length * width + lane] = norm(along);
}

template <class R, class Law>
NodalForces<R, 2> weld_beam_cycle(const WeldBeamProperties& beam, const LawKernel<Law>& law,
                                  const NodalMotion<R, 2>& nodes, double dt, double* state) {
  using L = WeldBeamLayout;
  const WeldBeamLayout layout = weld_beam_layout(beam, law);
  auto alive = load_field<R>(state, L::alive) > 0.5;

  const Vec3<R> old_s = load_vector<R>(state, L::axis_s);
  const bool joined = std::is_same_v<Law, Spotweld> && layout.joined;
  Vec3<R> slid;
  if (joined) slid = load_vector<R>(state, layout.joint_slid());
  SectionMotion<R> motion = section_motion(beam, nodes, dt, old_s, joined ? &slid : nullptr);
  Vec3<R> own_chord = motion.chord;
  if constexpr (std::is_same_v<Law, Spotweld>) {
    if (joined) {
      share_with_joints(beam, layout, law.elastic(), dt, state, motion);
      slid = select(alive, motion.slid, slid);
      store_vector(state, layout.joint_slid(), slid);
      own_chord = own_chord - slid;
    }
  }
  const auto [end, length] = axes_along(own_chord, motion.turned_s);
  const SectionRates<R>& rates = motion.rates;
  store_vector(state, L::axis_s, select(alive, end.e2, old_s));
  store_field(state, L::length, select(alive, length, load_field<R>(state, L::length)));
  // Both in the strain and in the moment, so that they belong together.
  const double torsion = beam.no_torsion ? 0.0 : std::sqrt(beam.torsion_share), es = beam.offset_s, et = beam.offset_t;
  const R twist = torsion * motion.twist;
  const R rs = beam.shear_factor * rates.shear_s, rt = beam.shear_factor * rates.shear_t;

  R n[6]{}, strain_rate = 0.0;
  double whole = 0.0;
  const R none = R(0.0), one = R(1.0);
  R failed = none;
  for (int k = 0; k < layout.fibres; ++k) {
    const auto point = at(k);
    const double ps = beam.fibres.s[point], pt = beam.fibres.t[point], area = beam.fibres.area[point];
    double* stress = state + layout.fibre(k) * lanes<R>;
    double* history = state + layout.history_of(k) * lanes<R>;
    FibreTensor<R> a = load_fibre<R>(stress);
    const FibreTensor<R> rate{rates.axial + pt * rates.bend_s - ps * rates.bend_t, rs - (pt - et) * twist,
                              rt + (ps - es) * twist};
    // von Mises' equivalent of the rate, so that it is the plastic strain's rate when all of it is plastic.
    strain_rate += area * sqrt(rate.rr * rate.rr + (1.0 / 3.0) * (rate.rs * rate.rs + rate.rt * rate.rt));
    whole += area;
    law.fibre(a, select(alive, rate, FibreTensor<R>{}), dt, history);
    store_fibre(stress, a);
    if (law.can_fail()) failed += select(law.template failed<R>(history), one, none);
    n[0] += area * a.rr;
    n[1] += area * a.rs;
    n[2] += area * a.rt;
    n[3] += (torsion * area) * ((ps - es) * a.rt - (pt - et) * a.rs);
    n[4] += (area * pt) * a.rr;
    n[5] -= (area * ps) * a.rr;
  }
  if (!beam.no_torsion) n[3] += es * n[2] - et * n[1];
  if (law.can_fail()) {
    const double limit = law.points_to_delete();
    alive = alive && failed < R(limit > 0.0 && limit < layout.fibres ? limit : layout.fibres);
    store_field(state, L::alive, select(alive, one, none));
  }
  const R integrity = load_field<R>(state, L::integrity);
  for (int i = 0; i < 6; ++i) {
    n[i] = select(alive, integrity * n[i], none);
    store_field(state, L::resultant + i, n[i]);
  }

  store_field(state, L::strain_rate, select(alive, (1.0 / whole) * strain_rate, none));

  const R half = 0.5 * length;
  NodalForces<R, 2> out;
  out.f[1] = select(alive, end.global({n[0], n[1], n[2]}), Vec3<R>{});
  out.f[0] = -out.f[1];
  out.m[0] = select(alive, end.global({-n[3], half * n[2] - n[4], -n[5] - half * n[1]}), Vec3<R>{});
  out.m[1] = select(alive, end.global({n[3], half * n[2] + n[4], n[5] - half * n[1]}), Vec3<R>{});
  if (joined) {
    const Vec3<R> beside = R(0.5) * cross(slid, out.f[1]);
    out.m[0] = out.m[0] - beside;
    out.m[1] = out.m[1] - beside;
  }
  const R density = beam.density * load_field<R>(state, L::density_scale);
  out.stable_step =
      select(alive, length * sqrt(density * (1.0 / law.elastic().E)), R(std::numeric_limits<double>::infinity()));
  return out;
}

WeldTrial weld_beam_trial(const WeldBeamProperties& beam, const LawKernel<Spotweld>& law,
                          const NodalMotion<double, 2>& nodes, double dt, const double* state) {
  const auto field = [state](int i) { return state[i]; };
  if (!holds(field)) return {};
  const WeldBeamLayout layout = weld_beam_layout(beam, law);
  const Vec3d slid = load_vector<double>(state, layout.joint_slid());
  const SectionMotion<double> motion =
      section_motion(beam, nodes, dt, load_vector<double>(state, WeldBeamLayout::axis_s), &slid);
  const SectionRates<double>& r = motion.rates;
  const JointStep step = joint_step(beam, layout, law.elastic(), motion.mid_length, dt,
                                    {r.axial, r.shear_s, r.shear_t, r.bend_s, r.bend_t}, field);
  const WeldJoint& joint = beam.joints[static_cast<std::size_t>(field(layout.joint_of()))];
  return {joint.trial(step.joint, step.moved, step.stiffness, step.force), motion.mid, true};
}

template <LawOfWelds Law>
void freeze_yield(const WeldBeamLayout& layout, const LawKernel<Law>& law, double* state, int width, int lane) {
  for (int k = 0; k < layout.fibres; ++k) {
    const auto stress = [&](int i) { return state[(layout.fibre(k) + i) * width + lane]; };
    const double shear2 = stress(1) * stress(1) + stress(2) * stress(2);
    state[(layout.history_of(k) + LawKernel<Law>::frozen_yield_field) * width + lane] =
        law.frozen_stress(std::sqrt(stress(0) * stress(0) + 3.0 * shear2));
  }
}

double weld_beam_stable_step(double length, double E, double density) {
  return length * std::sqrt(density / E);
}

NodalMass weld_beam_nodal_mass(const WeldBeamProperties& beam, double length, double density, double nu) {
  const Moments section = moments(beam.fibres);
  const double mass = 0.5 * (density * section.area + beam.mass_per_length) * length,
               bend = principal(section.ss, section.tt, section.st);
  const double shear_over_E = 0.5 / (1.0 + nu), k = beam.shear_factor * shear_over_E;
  const double cube = density * section.area * length * length * length;
  const double bending = 0.5 * density * bend * length + cube / 24.0;
  const double torsion = 0.5 * density * (section.ss + section.tt) * length;
  const double shear_mode = cube * k / (8.0 * (1.0 - k));
  const double arm2 = beam.offset_s * beam.offset_s + beam.offset_t * beam.offset_t;
  const double about_middle = principal(section.ss / section.area - beam.offset_s * beam.offset_s,
                                        section.tt / section.area - beam.offset_t * beam.offset_t,
                                        section.st / section.area - beam.offset_s * beam.offset_t);
  const double eccentric = mass * eccentric_gyration2(std::sqrt(arm2), about_middle);
  return {mass, std::max({bending, torsion, shear_mode, eccentric})};
}

template void freeze_yield(const WeldBeamLayout&, const LawKernel<Spotweld>&, double*, int, int);
template NodalForces<NativeBatch, 2> weld_beam_cycle(const WeldBeamProperties&, const LawKernel<Elastic>&,
                                                     const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> weld_beam_cycle(const WeldBeamProperties&, const LawKernel<Spotweld>&,
                                                     const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> weld_beam_cycle(const WeldBeamProperties&, const LawKernel<PlasticKinematic>&,
                                                     const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> weld_beam_cycle(const WeldBeamProperties&, const LawKernel<PiecewiseLinear>&,
                                                     const NodalMotion<NativeBatch, 2>&, double, double*);
template NodalForces<NativeBatch, 2> weld_beam_cycle(const WeldBeamProperties&, const LawKernel<ComposedLaw>&,
                                                     const NodalMotion<NativeBatch, 2>&, double, double*);

}  // namespace nugget::kernel
