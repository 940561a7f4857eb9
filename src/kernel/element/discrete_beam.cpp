// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/discrete_beam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.hpp"

namespace nugget::kernel {
namespace {

/// `a` turned by the rotation vector `phi` of a step: Rodrigues' formula with sine and cosine as series, exact to
/// round-off up to a tenth of a radian.
template <class R>
Vec3<R> turned(const Vec3<R>& a, const Vec3<R>& phi) {
  const R q = dot(phi, phi);
  const R s = 1.0 - q * (1.0 / 6.0) * (1.0 - q * (1.0 / 20.0) * (1.0 - q * (1.0 / 42.0)));
  const R c = 0.5 - q * (1.0 / 24.0) * (1.0 - q * (1.0 / 30.0) * (1.0 - q * (1.0 / 56.0)));
  const Vec3<R> across = cross(phi, a);
  return a + s * across + c * cross(phi, across);
}

template <class R>
struct Triad {
  Vec3<R> r, s;
  Frame<R> frame() const { return {r, s, cross(r, s)}; }
};

/// The triad turned by the shortest way until r lies along `line`; left as it is where the line has no length.
template <class R>
Triad<R> along(const Triad<R>& t, const Vec3<R>& line) {
  const R square = dot(line, line);
  const auto has_length = square > 0.0;
  const R length = sqrt(select(has_length, square, R(1.0)));
  const Vec3<R> r = select(has_length, (1.0 / length) * line, t.r);
  const Vec3<R> s = t.s - (dot(r, t.s) / (1.0 + dot(t.r, r))) * (t.r + r);
  return {r, unit(s - dot(s, r) * r)};
}

}  // namespace

void start_discrete_beam(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                         const Vec3d& x1, const Vec3d& x2, double* state, int width, int lane) {
  using L = DiscreteBeamLayout;
  const auto put = [&](int i, double value) { state[i * width + lane] = value; };
  for (int i = 0; i < L::count; ++i) put(i, 0.0);
  Triad<double> t{axes.e1, axes.e2};
  const Vec3d line = x2 - x1;
  const bool on_line = beam.follows_line() || (beam.between_points && norm(line) > 0.0);
  // Opposite directions have no shortest way between them: half a turn about s.
  if (on_line) {
    if (dot(t.r, line) < -(1.0 - 1e-12) * norm(line)) t.r = -t.r;
    t = along(t, line);
  }
  put(L::alive, 1.0);
  put(L::density_scale, 1.0);
  put(L::axis_r, t.r.x), put(L::axis_r + 1, t.r.y), put(L::axis_r + 2, t.r.z);
  put(L::axis_s, t.s.x), put(L::axis_s + 1, t.s.y), put(L::axis_s + 2, t.s.z);
  for (int i = 0; i < 6; ++i) {
    const DiscreteSpring& spring = law.dof[i];
    put(L::displacement + i, spring.start);
    // What unloads from there has been loaded up to there.
    if (spring.kind == DiscreteSpring::Kind::hysteresis) put(L::spring + i, spring.load(spring.start));
  }
  put(L::length, norm(line));
  put(L::unstretched, norm(line) - beam.cable_offset);
  put(L::on_line, on_line ? 1.0 : 0.0);
}

double discrete_beam_stable_step(const DiscreteBeamProperties& beam, const DiscreteBeam& law, double length,
                                 double scale, const std::array<double, 6>& force) {
  if (law.cable) {
    const double k = law.cable->tangent(length - beam.cable_offset, beam.cable_area);
    return k > 0.0 ? std::sqrt(scale * beam.mass / k) : std::numeric_limits<double>::infinity();
  }
  double fastest = 0.0;
  for (std::size_t i = 0; i < 6; ++i) {
    const DiscreteSpring& spring = law.dof[i];
    const double k = spring.greatest_stiffness(), c = spring.greatest_viscosity(force[i]);
    if (!(k > 0.0 || c > 0.0)) continue;
    // 1/m of the mode: two free halves; across a long beam the couples turn the nodes as well.
    double over_mass = 4.0 / (scale * (i < 3 ? beam.mass : beam.inertia));
    if (beam.long_beam() && (i == 1 || i == 2)) over_mass += length * length / (scale * beam.inertia);
    const double a = 0.5 * c * over_mass;
    fastest = std::max(fastest, a + std::sqrt(a * a + k * over_mass));
  }
  return fastest > 0.0 ? 2.0 / fastest : std::numeric_limits<double>::infinity();
}

namespace {

/// The displacement of spring i along or about its axis for a unit motion of each freedom:
/// e . (v2 - v1 - (w1 + w2)/2 x line).
std::array<double, 12> displacement_row(const DiscreteBeamProperties& beam, std::size_t i, const Frame3d& axes,
                                        const Vec3d& line) {
  const Vec3d axis = i % 3 == 0 ? axes.e1 : i % 3 == 1 ? axes.e2 : axes.e3;
  const Vec3d spin = i < 3 && beam.long_beam() ? -0.5 * cross(line, axis) : Vec3d{};
  const Vec3d move = i < 3 ? axis : Vec3d{}, turn = i < 3 ? Vec3d{} : axis;
  const std::array<Vec3d, 4> part{-1.0 * move, spin - turn, move, spin + turn};
  std::array<double, 12> b{};
  for (std::size_t p = 0; p < 4; ++p) {
    b[3 * p] = part[p].x;
    b[3 * p + 1] = part[p].y;
    b[3 * p + 2] = part[p].z;
  }
  return b;
}

/// Six moduli, along and about the axes, as a matrix of the freedoms of both nodes.
void spread(const DiscreteBeamProperties& beam, const std::array<double, 6>& modulus, const Frame3d& axes,
            const Vec3d& line, std::span<double> k) {
  std::fill(k.begin(), k.end(), 0.0);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::array<double, 12> b = displacement_row(beam, i, axes, line);
    for (std::size_t row = 0; row < 12; ++row)
      for (std::size_t column = 0; column < 12; ++column) k[12 * row + column] += modulus[i] * b[row] * b[column];
  }
}

}  // namespace

void discrete_beam_stiffness(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                             const Vec3d& line, std::span<double> k) {
  std::array<double, 6> stiffness;
  for (std::size_t i = 0; i < 6; ++i) stiffness[i] = law.dof[i].initial_stiffness();
  if (law.cable) {
    const double unstretched = norm(line) - beam.cable_offset;
    const bool slack = beam.cable_offset < 0.0 && !(law.cable->force(norm(line), unstretched, beam.cable_area) > 0.0);
    if (!slack) stiffness[0] = law.cable->tangent(unstretched, beam.cable_area);
  }
  spread(beam, stiffness, axes, line, k);
}

bool discrete_beam_force_at_start(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                                  const Vec3d& line, std::span<double> f) {
  std::array<double, 6> force{};
  for (std::size_t i = 0; i < 6; ++i) force[i] = law.dof[i].force_at_start();
  if (law.cable) force[0] = law.cable->force(norm(line), norm(line) - beam.cable_offset, beam.cable_area);
  if (std::all_of(force.begin(), force.end(), [](double component) { return component == 0.0; })) return false;
  std::fill(f.begin(), f.end(), 0.0);
  for (std::size_t i = 0; i < 6; ++i) {
    const std::array<double, 12> b = displacement_row(beam, i, axes, line);
    for (std::size_t row = 0; row < 12; ++row) f[row] += force[i] * b[row];
  }
  return true;
}

bool discrete_beam_viscosity(const DiscreteBeamProperties& beam, const DiscreteBeam& law, const Frame3d& axes,
                             const Vec3d& line, std::span<double> c) {
  std::array<double, 6> viscosity;
  for (std::size_t i = 0; i < 6; ++i) viscosity[i] = law.dof[i].initial_viscosity();
  if (std::all_of(viscosity.begin(), viscosity.end(), [](double d) { return d == 0.0; })) return false;
  spread(beam, viscosity, axes, line, c);
  return true;
}

/// Advances the joint whose fields stand `width` apart from `state` on; the forces that act.
template <int width>
static Spr3::Freedoms advance_joint(const Spr3& joint, const Spr3::Freedoms& increment, double* state) {
  using L = DiscreteBeamLayout;
  const auto field = [state](int i) -> double& { return state[i * width]; };
  Spr3::State now{{}, field(L::joint_plastic), field(L::joint_damage)};
  for (int i = 0; i < 6; ++i) now.force[i] = field(L::spring + i);
  const Spr3::Freedoms acting = joint.advance(now, increment);
  for (int i = 0; i < 6; ++i) {
    field(L::displacement + i) += increment[i];
    field(L::spring + i) = now.force[i];
  }
  field(L::joint_plastic) = now.plastic;
  field(L::joint_damage) = now.damage;
  return acting;
}

template <int width>
static Spr2::Freedoms advance_joint(const Spr2& rivet, const Spr2::Freedoms& increment, double* state) {
  using L = DiscreteBeamLayout;
  Spr2::Freedoms displacement;
  for (int i = 0; i < 6; ++i) displacement[i] = state[(L::displacement + i) * width] += increment[i];
  double& damage = state[L::joint_damage * width];
  damage = std::max(damage, rivet.effective_displacement(displacement, damage));
  return rivet.forces(displacement, damage);
}

template <class R>
NodalForces<R, 2> discrete_beam_cycle(const DiscreteBeamProperties& beam, const DiscreteBeam& law,
                                      const NodalMotion<R, 2>& nodes, double dt, double* state) {
  using L = DiscreteBeamLayout;
  auto alive = load_field<R>(state, L::alive) > 0.5;
  const Vec3<R> d = nodes.x[1] - nodes.x[0], stretch = nodes.v[1] - nodes.v[0], d_mid = d - R(0.5 * dt) * stretch;
  const Vec3<R> mean = R(0.5) * (nodes.w[0] + nodes.w[1]);
  const Vec3<R> spin = beam.scoor < 0 ? nodes.w[0] : beam.scoor > 0 ? nodes.w[1] : mean;

  const Triad<R> old{load_vector<R>(state, L::axis_r), load_vector<R>(state, L::axis_s)};
  const Vec3<R> half = R(0.5 * dt) * spin, whole = R(dt) * spin;
  Triad<R> mid{turned(old.r, half), turned(old.s, half)}, end{turned(old.r, whole), turned(old.s, whole)};
  const auto on_line = load_field<R>(state, L::on_line) > 0.5;
  if (any(on_line)) {
    const Triad<R> mid_line = along(mid, d_mid), end_line = along(end, d);
    mid = {select(on_line, mid_line.r, mid.r), select(on_line, mid_line.s, mid.s)};
    end = {select(on_line, end_line.r, end.r), select(on_line, end_line.s, end.s)};
  }
  store_vector(state, L::axis_r, select(alive, end.r, old.r));
  store_vector(state, L::axis_s, select(alive, end.s, old.s));

  // The nodes' velocities are chords of their arcs; the factor tan(phi/2)/(phi/2) makes the spin one as well.
  const Vec3<R> w = beam.long_beam() ? mean : select(on_line, mean, spin);
  const R q = R(dt * dt) * dot(w, w), chord = 1.0 + q * (1.0 / 12.0) * (1.0 + 0.1 * q);
  const Vec3<R> translation = mid.frame().local(stretch - chord * cross(w, d_mid));
  const Vec3<R> rotation = mid.frame().local(nodes.w[1] - nodes.w[0]);
  const R velocity[6]{translation.x, translation.y, translation.z, rotation.x, rotation.y, rotation.z};

  const R square = dot(d, d), length = sqrt(select(square > 0.0, square, R(std::numeric_limits<double>::min())));
  store_field(state, L::length, select(alive, length, load_field<R>(state, L::length)));
  const R scale = load_field<R>(state, L::density_scale);

  NodalForces<R, 2> out;
  out.stable_step = R(std::numeric_limits<double>::infinity());
  R force[6], survives(1.0);
  for (int l = 0; l < lanes<R>; ++l) {
    if (!(lane(load_field<R>(state, L::alive), l) > 0.5)) {
      for (R& f : force) set_lane(f, l, 0.0);
      continue;
    }
    if (law.cable) {
      const double unstretched = state[L::unstretched * lanes<R> + l], of_now = lane(length, l);
      const double pull = law.cable->force(of_now, unstretched, beam.cable_area);
      for (R& f : force) set_lane(f, l, 0.0);
      set_lane(force[0], l, pull);
      state[L::displacement * lanes<R> + l] += dt * lane(velocity[0], l);
      if (law.cable->breaks(of_now, unstretched, pull)) set_lane(survives, l, 0.0);
      set_lane(out.stable_step, l,
               discrete_beam_stable_step(beam, law, unstretched + beam.cable_offset, lane(scale, l)));
      continue;
    }
    std::array<double, 6> f{}, u{}, sprung{};
    if (law.joint) {
      std::array<double, 6> increment;
      for (std::size_t i = 0; i < 6; ++i) increment[i] = dt * lane(velocity[i], l);
      double* const own = state + l;
      f = std::visit([&](const auto& joint) { return advance_joint<lanes<R>>(joint, increment, own); }, *law.joint);
      for (std::size_t i = 0; i < 6; ++i) set_lane(force[i], l, f[i]);
      if (own[L::joint_damage * lanes<R>] >= 1.0)
        set_lane(survives, l, 0.0);
      else
        set_lane(out.stable_step, l, discrete_beam_stable_step(beam, law, lane(length, l), lane(scale, l), sprung));
      continue;
    }
    for (int i = 0; i < 6; ++i) {
      const auto k = at(i);
      const DiscreteSpring& spring = law.dof[k];
      const auto at = [&](int first) -> double& { return state[(first + i) * lanes<R> + l]; };
      DiscreteSpring::State now{at(L::displacement), at(L::spring), at(L::plastic)};
      const double v = lane(velocity[i], l);
      f[k] = spring.advance(now, dt * v, v);
      u[k] = now.displacement;
      sprung[k] = now.force;
      at(L::displacement) = now.displacement;
      at(L::spring) = now.force;
      at(L::plastic) = now.plastic;
      set_lane(force[i], l, f[k]);
    }
    if (law.fails(f, u))
      set_lane(survives, l, 0.0);
    else
      set_lane(out.stable_step, l, discrete_beam_stable_step(beam, law, lane(length, l), lane(scale, l), sprung));
  }
  alive = alive && survives > 0.5;
  store_field(state, L::alive, select(alive, R(1.0), R(0.0)));
  for (int i = 0; i < 6; ++i) {
    force[i] = select(alive, force[i], R(0.0));
    store_field(state, L::resultant + i, force[i]);
  }

  out.f[1] = end.frame().global({force[0], force[1], force[2]});
  out.f[0] = -out.f[1];
  out.m[1] = end.frame().global({force[3], force[4], force[5]});
  out.m[0] = -out.m[1];
  if (beam.long_beam()) {
    const Vec3<R> couple = R(0.5) * cross(d, out.f[1]);
    out.m[0] -= couple;
    out.m[1] -= couple;
  }
  return out;
}

template NodalForces<NativeBatch, 2> discrete_beam_cycle(const DiscreteBeamProperties&, const DiscreteBeam&,
                                                         const NodalMotion<NativeBatch, 2>&, double, double*);

}  // namespace nugget::kernel
