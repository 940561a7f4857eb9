// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/thick_shell.hpp"

#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "kernel/element/assumed_strain.hpp"
#include "kernel/element/physical_stabilisation.hpp"
#include "kernel/law/own_kernels.hpp"

namespace nugget::kernel {
namespace {

/// The midway surface in the middle of the element: its unit normal, and in its plane the vectors that take the
/// derivatives along xi and eta to gradients.
template <class R>
struct MidwaySurface {
  Vec3<R> n, xi, eta;

  [[gnu::always_inline]] explicit MidwaySurface(const Patterns<R>& x) {
    const Vec3<R> across = cross(x.a, x.b);
    const R over = 1.0 / dot(across, across);
    n = unit(across);
    xi = over * cross(x.b, across);
    eta = over * cross(across, x.a);
  }
};

/// The rows of a velocity gradient with u v^T + v u^T added.
template <class R>
[[gnu::always_inline]] inline void add_both(Matrix<R>& l, const Vec3<R>& u, const Vec3<R>& v) {
  l.x += u.x * v + v.x * u;
  l.y += u.y * v + v.y * u;
  l.z += u.z * v + v.z * u;
}

/// What the layers leave for the nodes: the stress that does work on the uniform gradient, and the means of zeta times
/// the stress along the midway surface, by xi and eta, and across it.
template <class R>
struct LayerSums {
  SolidTensor<R> stress{};
  Vec3<R> shear{};
  R moment_xi{}, moment_eta{}, moment_both{}, pinch{};
};

/// Whether enough of a thick shell has failed; `points`: failed ones, of `all`; `layers`: layers with one.
template <class R, class Law>
MaskOf<R> gone(const LawKernel<Law>& law, const R& points, int all, const R& layers, int all_layers) {
  const double limit = law.points_to_delete();
  if (limit < 0.0) return layers >= R(-limit * all_layers / 100.0);
  return points >= R(limit > 0.0 && limit < all ? limit : all);
}

/// Strains of a brick whose stress across varies, linear in each natural coordinate and in their products, from those
/// of its patterns, and the forces on the patterns that do the work of stresses on them; see AssumedStrain. What the
/// strains draw along across themselves does no work, as it has no stress there.
template <class R>
class VaryingStrain {
 public:
  [[gnu::always_inline]] explicit VaryingStrain(const Patterns<R>& x)
      : x_(x), plane_{{x.b, x.c}, {x.c, x.a}, {x.a, x.b}} {}

  /// Of xi, eta, zeta; of eta zeta, zeta xi, xi eta.
  struct Fields {
    SolidTensor<R> linear[3], product[3];
  };
  [[gnu::always_inline]] Fields strains(double nu, const Hourglass<R>& e) const {
    const Vec3<R>&e1 = e.q[0], &e2 = e.q[1], &e3 = e.q[2], &e4 = e.q[3];
    BendingStrains draws;
    draws.thinning = nu / (1.0 - nu);
    return {{plane_[0].strain(draws, e3.y, e2.z, e2.y + e3.z), plane_[1].strain(draws, e1.z, e3.x, e1.x + e3.z),
             plane_[2].strain(draws, e2.x, e1.y, e1.x + e2.y)},
            {along_edge(nu, x_.a, e4.x), along_edge(nu, x_.b, e4.y), along_edge(nu, x_.c, e4.z)}};
  }
  /// Unit vector across the plane of the two other directions.
  [[gnu::always_inline]] Vec3<R> across(int i) const { return unit(plane_[i].across); }

  /// Of means of the coordinates times the stress.
  [[gnu::always_inline]] Hourglass<R> forces(const R& volume, const Fields& s) const {
    const BendingStrains none;
    const Vec3<R> s1 = volume * plane_[0].stress(none, s.linear[0]), s2 = volume * plane_[1].stress(none, s.linear[1]),
                  s3 = volume * plane_[2].stress(none, s.linear[2]);
    const auto on_edge = [&](const Vec3<R>& g, const SolidTensor<R>& t) {
      const R over = 1.0 / dot(g, g);
      return volume * (over * over) * dot(g, traction(t, g));
    };
    return {{{s2.z + s3.z, s3.y, s2.x},
             {s3.x, s3.z + s1.z, s1.y},
             {s2.y, s1.x, s1.z + s2.z},
             {on_edge(x_.a, s.product[0]), on_edge(x_.b, s.product[1]), on_edge(x_.c, s.product[2])}}};
  }

 private:
  /// Direct strain along an edge, of which `e` is the component by it, without stress across.
  [[gnu::always_inline]] static SolidTensor<R> along_edge(double nu, const Vec3<R>& g, const R& e) {
    const R over = 1.0 / dot(g, g), stretch = e * over, share = nu * stretch;
    const Vec3<R> u = ((1.0 + nu) * stretch * over) * g;
    return {u.x * g.x - share, u.y * g.y - share, u.z * g.z - share, u.x * g.y, u.y * g.z, u.z * g.x};
  }

  const Patterns<R>& x_;
  BentPlane<R> plane_[3];
};

/// What is left of a law's elastic stiffness while its point flows: the share of the strain that is not plastic, from
/// the plastic strain before and after a step. Never less than a twentieth, or a plastic hinge could fold in the
/// patterns that have no strain in its layers.
template <class R>
[[gnu::always_inline]] inline R elastic_share(const R& before, const R& after, const SolidTensor<R>& rate, double dt) {
  const R flow = after - before, whole = R(dt) * effective_rate(rate), least = R(0.05);
  const R share = select(flow > 0.0, 1.0 - flow / max(whole, flow), R(1.0));
  return max(share, least);
}

/// Advances the hourglass forces by a step and adds up their work. Bending through the thickness is not among them.
/// `share`: stiffness now over that of `e`.
template <class R>
[[gnu::always_inline]] inline Hourglass<R> stabilise(const ThickShellProperties& shell, const ElasticConstants& e,
                                                     const R& share, const R& volume, const Patterns<R>& mid,
                                                     const Patterns<R>& v, const Hourglass<R>& strain, double dt,
                                                     double* state) {
  using L = ThickShellLayout;
  const StabilizingStress<R> stress(e, (dt * shell.brick.hourglass_coefficient) * share, volume, mid, v, strain);
  const auto shorter = [dt](const R& growth) { return 1.0 - (dt * growth) * (1.0 - (0.5 * dt) * growth); };
  const Vec3<R> f{shorter(stress.growth.x), shorter(stress.growth.y), shorter(stress.growth.z)};
  Hourglass<R> change = stress.change;
  change.q[0].x = stress.shear.y;
  change.q[0].y = R(0.0);
  change.q[1].x = R(0.0);
  change.q[1].y = stress.shear.x;
  Hourglass<R> now;
  R power = R(0.0);
  for (int i = 0; i < 4; ++i) {
    const Vec3<R> was = load_vector<R>(state, L::hourglass + 3 * i);
    now.q[i] = Vec3<R>{f.x * was.x, f.y * was.y, f.z * was.z} + change.q[i];
    power += dot(was + now.q[i], strain.q[i]);
    store_vector(state, L::hourglass + 3 * i, now.q[i]);
  }
  add_to_field<R>(state, L::hourglass_energy, (0.5 * dt) * power, 0);
  return now;
}

/// Adds the stress t n + n t of the transverse shears t.
template <class R>
[[gnu::always_inline]] inline void add_sheared(SolidTensor<R>& s, const Vec3<R>& t, const Vec3<R>& n) {
  s.xx += 2.0 * (t.x * n.x);
  s.yy += 2.0 * (t.y * n.y);
  s.zz += 2.0 * (t.z * n.z);
  s.xy += t.x * n.y + t.y * n.x;
  s.yz += t.y * n.z + t.z * n.y;
  s.zx += t.z * n.x + t.x * n.z;
}

/// The forces of the mean stress and of those on the patterns, and whether the element is there after the step.
template <class R, class Law>
[[gnu::always_inline]] inline SolidForces<R> forces_of_thick_shell(const LawKernel<Law>& law, const Gradient<R>& g,
                                                                   const Patterns<R>& end, const SolidTensor<R>& s,
                                                                   const Hourglass<R>& q, const R& step,
                                                                   MaskOf<R> alive, double* state) {
  if (law.deletion_step() > 0.0) alive = alive && step >= law.deletion_step();
  if (law.can_fail() || law.deletion_step() > 0.0)
    store_field(state, ThickShellLayout::alive, select(alive, R(1.0), R(0.0)));
  SolidForces<R> out;
  forces_of(g, end, s, forces_on_patterns(end, q), true, out.f);
  if (any(!alive))
    for (Vec3<R>& f : out.f) f = select(alive, f, Vec3<R>{});
  out.stable_step = select(alive, step, R(std::numeric_limits<double>::infinity()));
  out.volume = select(alive, g.volume, R(1.0));
  return out;
}

/// ELFORM 3.
template <class R, class Law>
SolidForces<R> full_thick_shell_cycle(const ThickShellProperties& shell, const LawKernel<Law>& law,
                                      const SolidMotion<R>& nodes, double dt, double* state) {
  using L = ThickShellLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = thick_shell_layout(shell, law);
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const R none = R(0.0);

  const BrickStep<R> motion(nodes, dt, alive);
  const Patterns<R>&v = motion.v, &mid = motion.mid, &end = motion.end;
  const Gradient<R> g(mid), g_end(end);
  const Matrix<R> l = velocity_gradient(g, v);
  const Vec3<R> half = half_turn(l, dt);
  const Frame<R> turn = rotation_of(half);
  const VaryingStrain<R> at_mid(mid), at_end(end);
  auto fields = at_mid.strains(e.nu, strains_of(mid, hourglass_rates(v, l, mid)));

  // Transverse shear of the mean; what flow left of the first moments of the stresses across the planes.
  const Vec3<R> m = at_mid.across(2), m_end = at_end.across(2);
  const Vec3<R> across{dot(l.x, m), dot(l.y, m), dot(l.z, m)}, along = m.x * l.x + m.y * l.y + m.z * l.z;
  const Vec3<R> both = R(0.5) * (across + along), shear = both - dot(both, m) * m;
  double square = 0.0;
  for (std::size_t k = 0; k < at(shell.layers.count); ++k)
    square += shell.layers.weight[k] * shell.layers.zeta[k] * shell.layers.zeta[k];
  constexpr int pinches[] = {L::pinch_xi, L::pinch_eta, L::pinch};
  const double squares[] = {1.0 / 3.0, 1.0 / 3.0, square};
  for (int i = 0; i < 3; ++i) {
    const double relief = dt > 0.0 && squares[i] > 0.0 ? 1.0 / (squares[i] * e.bulk_wave() * dt) : 0.0;
    const Vec3<R> n = at_mid.across(i), u = (R(-relief) * load_field<R>(state, pinches[i])) * n;
    fields.linear[i] =
        fields.linear[i] + SolidTensor<R>{u.x * n.x, u.y * n.y, u.z * n.z, u.x * n.y, u.y * n.z, u.z * n.x};
  }

  SolidTensor<R> mean{};
  typename VaryingStrain<R>::Fields moments{};
  Vec3<R> sheared{};
  R wave = none, failed = none, failed_layers = none;
  for (int k = 0; k < shell.layers.count; ++k) {
    const R zeta = R(shell.layers.zeta[at(k)]), weight = R(0.25 * shell.layers.weight[at(k)]),
            more = R(shell.shear[at(k)] - 1.0);
    R failed_here = none;
    SolidTensor<R> sum{};  // of the layer
    for (int c = 0; c < 4; ++c) {
      const R xi = R(c & 1 ? GaussPoint::place : -GaussPoint::place),
              eta = R(c & 2 ? GaussPoint::place : -GaussPoint::place);
      const SolidTensor<R> rate_more = xi * fields.linear[0] + eta * fields.linear[1] + zeta * fields.linear[2] +
                                       (eta * zeta) * fields.product[0] + (zeta * xi) * fields.product[1] +
                                       (xi * eta) * fields.product[2];
      Matrix<R> own = l;
      add_both(own, more * shear, m);
      own.x += {rate_more.xx, rate_more.xy, rate_more.zx};
      own.y += {rate_more.xy, rate_more.yy, rate_more.yz};
      own.z += {rate_more.zx, rate_more.yz, rate_more.zz};

      double* place = state + layout.layer(k, c) * lanes<R>;
      double* history = state + layout.history_of(k, c) * lanes<R>;
      SolidTensor<R> s = rotated(turn, load_solid<R>(place));
      law.rotate(turn, history);
      law.solid(s, rate_at_end(own, half), dt, history);
      store_solid(place, s);
      wave = max(wave, law.template wave_modulus<R>(history));
      if (law.can_fail()) failed_here += select(law.template failed<R>(history), R(1.0), none);

      sum = sum + s;
      moments.linear[0] = moments.linear[0] + (weight * xi) * s;
      moments.linear[1] = moments.linear[1] + (weight * eta) * s;
      moments.linear[2] = moments.linear[2] + (weight * zeta) * s;
      moments.product[0] = moments.product[0] + (weight * eta * zeta) * s;
      moments.product[1] = moments.product[1] + (weight * zeta * xi) * s;
      moments.product[2] = moments.product[2] + (weight * xi * eta) * s;
    }
    mean = mean + weight * sum;
    const Vec3<R> on_top = traction(sum, m_end);
    sheared += (weight * more) * (on_top - dot(m_end, on_top) * m_end);
    failed += failed_here;
    failed_layers += select(failed_here > 0.0, R(1.0), none);
  }
  for (int i = 0; i < 3; ++i) {
    const Vec3<R> n = at_end.across(i);
    store_field(state, pinches[i], dot(n, traction(moments.linear[i], n)));
  }

  const Hourglass<R> q = at_end.forces(g_end.volume, moments);
  SolidTensor<R> s = mean;
  add_sheared(s, sheared, m_end);
  const R density = shell.brick.density * load_field<R>(state, L::density_scale), trace = l.x.x + l.y.y + l.z.z;
  const BulkViscosity<R> bulk(shell.brick, wave, density, g_end.volume / sqrt(largest_face2(end)), trace);
  for (int k = 0; k < shell.layers.count; ++k)
    for (int c = 0; c < 4; ++c)
      heat_by_viscosity(law, bulk.pressure, trace, dt, state + layout.history_of(k, c) * lanes<R>);
  book_viscosity<L>(bulk.pressure, trace, g_end.volume, dt, state);
  s.xx -= bulk.pressure;
  s.yy -= bulk.pressure;
  s.zz -= bulk.pressure;

  const int layers = shell.layers.count;
  if (law.can_fail()) alive = alive && !gone(law, failed, 4 * layers, failed_layers, layers);
  return forces_of_thick_shell(law, g_end, end, s, q, bulk.step, alive, state);
}

}  // namespace

std::array<double, most_layers> shear_by_layer(const LayerRule& layers, bool parabolic, double factor) {
  std::array<double, most_layers> shape{};
  double mean = 0.0;
  for (std::size_t k = 0; k < at(layers.count); ++k) {
    shape[k] = parabolic ? 1.0 - layers.zeta[k] * layers.zeta[k] : 1.0;
    mean += layers.weight[k] * shape[k] * shape[k];
  }
  if (!(mean > 1e-12)) return shear_by_layer(layers, false, factor);
  for (double& s : shape) s *= std::sqrt(factor / mean);
  return shape;
}

template <class R, class Law>
SolidForces<R> thick_shell_cycle(const ThickShellProperties& shell, const LawKernel<Law>& law,
                                 const SolidMotion<R>& nodes, double dt, double* state) {
  if (shell.full) return full_thick_shell_cycle(shell, law, nodes, dt, state);
  using L = ThickShellLayout;
  const ElasticConstants& e = law.elastic();
  const L layout = thick_shell_layout(shell, law);
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const R none = R(0.0);

  const BrickStep<R> motion(nodes, dt, alive);
  const Patterns<R>&v = motion.v, &mid = motion.mid, &end = motion.end;
  const Gradient<R> g(mid), g_end(end);
  const Matrix<R> l = velocity_gradient(g, v);
  const Vec3<R> half = half_turn(l, dt);
  const Frame<R> turn = rotation_of(half);
  const Hourglass<R> strain = strains_of(mid, hourglass_rates(v, l, mid));
  const MidwaySurface<R> m(mid), m_end(end);

  // Transverse shear of the mean; strains that grow with zeta.
  const Vec3<R> across{dot(l.x, m.n), dot(l.y, m.n), dot(l.z, m.n)}, along = m.n.x * l.x + m.n.y * l.y + m.n.z * l.z;
  const Vec3<R> both = R(0.5) * (across + along), shear = both - dot(both, m.n) * m.n;
  const R bend_xi = strain.q[1].x, bend_eta = strain.q[0].y, twist = R(0.5) * (strain.q[0].x + strain.q[1].y);
  const R spread = bend_xi * dot(m.xi, m.xi) + bend_eta * dot(m.eta, m.eta) + 2.0 * twist * dot(m.xi, m.eta);
  double square = 0.0;
  for (std::size_t k = 0; k < at(shell.layers.count); ++k)
    square += shell.layers.weight[k] * shell.layers.zeta[k] * shell.layers.zeta[k];
  const double relief = dt > 0.0 && square > 0.0 ? 1.0 / (square * e.bulk_wave() * dt) : 0.0;
  const R thinning = R(-e.nu / (1.0 - e.nu)) * spread - R(relief) * load_field<R>(state, L::pinch);

  LayerSums<R> sum;
  R wave = none, failed = none, elastic = none;
  for (int k = 0; k < shell.layers.count; ++k) {
    const R zeta = R(shell.layers.zeta[at(k)]), weight = R(shell.layers.weight[at(k)]),
            more = R(shell.shear[at(k)] - 1.0), half_of = R(0.5) * zeta;
    Matrix<R> own = l;
    add_both(own, more * shear, m.n);
    add_both(own, (half_of * bend_xi) * m.xi, m.xi);
    add_both(own, (half_of * bend_eta) * m.eta, m.eta);
    add_both(own, (zeta * twist) * m.xi, m.eta);
    add_both(own, (half_of * thinning) * m.n, m.n);

    double* place = state + layout.layer(k) * lanes<R>;
    double* history = state + layout.history_of(k) * lanes<R>;
    SolidTensor<R> s = rotated(turn, load_solid<R>(place));
    law.rotate(turn, history);
    const SolidTensor<R> rate = rate_at_end(own, half);
    if constexpr (LawKernel<Law>::has_plastic_strain) {
      const R before = load_field<R>(history, 0);
      law.solid(s, rate, dt, history);
      elastic += weight * elastic_share(before, load_field<R>(history, 0), rate, dt);
    } else {
      law.solid(s, rate, dt, history);
      elastic += weight;
    }
    store_solid(place, s);
    wave = max(wave, law.template wave_modulus<R>(history));
    if (law.can_fail()) failed += select(law.template failed<R>(history), R(1.0), none);

    const Vec3<R> on_top = traction(s, m_end.n), on_xi = traction(s, m_end.xi), on_eta = traction(s, m_end.eta);
    const R normal = dot(m_end.n, on_top), lever = weight * zeta;
    sum.stress = sum.stress + weight * s;
    sum.shear += (weight * more) * (on_top - normal * m_end.n);
    sum.moment_xi += lever * dot(m_end.xi, on_xi);
    sum.moment_eta += lever * dot(m_end.eta, on_eta);
    sum.moment_both += lever * dot(m_end.xi, on_eta);
    sum.pinch += lever * normal;
  }
  store_field(state, L::pinch, sum.pinch);

  Hourglass<R> q = stabilise(shell, e, elastic, g.volume, mid, v, strain, dt, state);
  q.q[1].x += g_end.volume * sum.moment_xi;
  q.q[0].y += g_end.volume * sum.moment_eta;
  q.q[0].x += g_end.volume * sum.moment_both;
  q.q[1].y += g_end.volume * sum.moment_both;

  SolidTensor<R> s = sum.stress;
  add_sheared(s, sum.shear, m_end.n);

  const R density = shell.brick.density * load_field<R>(state, L::density_scale), trace = l.x.x + l.y.y + l.z.z;
  const BulkViscosity<R> bulk(shell.brick, wave, density, g_end.volume / sqrt(largest_face2(end)), trace);
  for (int k = 0; k < shell.layers.count; ++k)
    heat_by_viscosity(law, bulk.pressure, trace, dt, state + layout.history_of(k) * lanes<R>);
  book_viscosity<L>(bulk.pressure, trace, g_end.volume, dt, state);
  s.xx -= bulk.pressure;
  s.yy -= bulk.pressure;
  s.zz -= bulk.pressure;

  if (law.can_fail()) alive = alive && !gone(law, failed, shell.layers.count, failed, shell.layers.count);
  return forces_of_thick_shell(law, g_end, end, s, q, bulk.step, alive, state);
}

void start_thick_shell(const ThickShellLayout& layout, double* state, int width, int lane) {
  using L = ThickShellLayout;
  for (int i = 0; i < layout.size(); ++i) state[i * width + lane] = 0.0;
  state[L::alive * width + lane] = 1.0;
  state[L::density_scale * width + lane] = 1.0;
}

Vec3d thick_shell_normal(const std::array<Vec3d, 8>& x) {
  return MidwaySurface<double>(patterns_of(x)).n;
}

template SolidForces<NativeBatch> thick_shell_cycle(const ThickShellProperties&, const LawKernel<Elastic>&,
                                                    const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> thick_shell_cycle(const ThickShellProperties&, const LawKernel<PlasticKinematic>&,
                                                    const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> thick_shell_cycle(const ThickShellProperties&, const LawKernel<PiecewiseLinear>&,
                                                    const SolidMotion<NativeBatch>&, double, double*);
template SolidForces<NativeBatch> thick_shell_cycle(const ThickShellProperties&, const LawKernel<ComposedLaw>&,
                                                    const SolidMotion<NativeBatch>&, double, double*);

}  // namespace nugget::kernel
