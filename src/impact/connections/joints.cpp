// SPDX-License-Identifier: Apache-2.0
#include "impact/connections/joints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/index.hpp"
#include "impact/conditions/axes_now.hpp"
#include "impact/connections/body_points.hpp"

namespace nugget::impact {
namespace {

constexpr double stiffness_share = 0.25, largest_share = 0.5, damping_ratio = 0.1;
constexpr double stable_growth = 2.0;   // of the inverse mass that a joint meets, before it softens
constexpr double bearable_gain = 0.01;  // of the most that a joint ever took, made while it becomes stiffer

using Kind = model::Joint::Kind;

/// Bound of the inverse mass that the rate of a ratio meets in one of its bodies. `point`, `turning`: traces of the
/// inverse mass at the body's point and of its inverse inertia. A force and a moment on one body meet at most twice the
/// sum of what each meets.
double transmitted(const model::Joint& joint, std::size_t side, double point, double turning) {
  const double squared = joint.ratio * joint.ratio;
  if (joint.kind == Kind::screw) return 2.0 * (point + squared * turning);
  if (joint.kind == Kind::rack_and_pinion) return side == 0 ? 2.0 * (point + squared * turning) : point;
  return side == 0 ? turning / squared : turning;
}

}  // namespace

Joints::Joints(const system::System& system) : system_(system), springs_(system) {
  for (const model::Joint& source : system.model.joints) {
    Joint j;
    j.source = &source;
    const auto place = [&](std::size_t i) { return source.point[i]; };
    // The pairs stand at one place but for the last digits of their coordinates: A's place counts.
    for (std::size_t side = 0; side < 2; ++side) {
      j.body[side] = &system.bodies[system.body_of[source.body[side]]];
      j.arm[side] = place(0) - j.body[side]->center0;
    }
    if (source.kind != Kind::spherical) j.axis = unit(place(2) - place(0));
    if (source.transmits()) {
      j.arm[1] = place(1) - j.body[1]->center0;
      j.other = unit(place(3) - place(1));
      joints_.push_back(std::move(j));
      continue;
    }
    std::array<double, 2> size{};
    for (std::size_t side = 0; side < 2; ++side) {
      const system::RigidBody& body = *j.body[side];
      const double trace = body.inertia[0] + body.inertia[3] + body.inertia[5];
      size[side] = std::max(norm(j.arm[side]), body.mass > 0.0 ? std::sqrt(0.5 * trace / body.mass) : 0.0);
    }
    // What cannot move, or is no more than a point, stands for the ground.
    for (std::size_t side = 0; side < 2; ++side)
      if ((j.body[side]->fixed & 7u) == 7u) size[side] = 0.0;
    const double small = std::min(size[0], size[1]), large = std::max(size[0], size[1]);
    j.size = small > 0.01 * large ? small : large;
    if (source.kind == Kind::universal)
      j.directions.push_back({j.axis, unit(place(3) - place(1)), true});
    else if (source.kind != Kind::spherical)
      j.directions.push_back({j.axis, j.axis});
    if (source.kind == Kind::translational || source.kind == Kind::locking) {
      const Vec3d off = place(4) - place(0), across = unit(off - dot(off, j.axis) * j.axis);
      j.directions.push_back({across, across});
    }
    if (source.kind == Kind::cylindrical || source.kind == Kind::translational)
      j.constrained = ConstrainedDirections::across;
    if (source.kind == Kind::planar) j.constrained = ConstrainedDirections::along;
    joints_.push_back(std::move(j));
  }
  find_bounds();
}

Vec3d Joints::met_at(const Joint& j, std::size_t side) {
  return side == 0 && j.source->kind == Kind::screw ? j.source->point[1] - j.body[0]->center0 : j.arm[side];
}

void Joints::find_bounds() {
  std::vector<int> pieces(system_.bodies.size(), 0);
  const auto count = [&](const system::RigidBody* body) -> int& { return pieces[at(body->node) - system_.nodes]; };
  for (const Joint& j : joints_)
    for (const system::RigidBody* body : j.body) count(body) += 1 + static_cast<int>(j.directions.size());
  for (Joint& j : joints_) {
    for (const std::size_t side : {0u, 1u}) j.pieces[side] = count(j.body[side]);
    j.give = trace(inverse_mass_at(*j.body[0], system::inverse_inertia(*j.body[0]), met_at(j, 0)));
    set_bounds(j);
  }
}

void Joints::set_bounds(Joint& j) {
  const auto over = [](double a, double sum) { return sum > 0.0 ? a / sum : 0.0; };
  // Traces: row sums in body axes would change as bodies turn. They bound the largest eigenvalue.
  double shared = 0.0, rotary_shared = 0.0, own = 0.0, rotary_own = 0.0;
  for (const std::size_t side : {0u, 1u}) {
    const system::RigidBody& body = *j.body[side];
    const system::Mobility::Matrix inverse = system::inverse_inertia(body);
    const double point = side == 0 ? j.give : trace(inverse_mass_at(body, inverse, met_at(j, 1)));
    const double turning = trace(inverse);
    if (j.source->transmits()) {
      const double met = transmitted(*j.source, side, point, turning);
      own += met;
      shared += j.pieces[side] * met;
      continue;
    }
    own += point;
    rotary_own += turning;
    shared += j.pieces[side] * point;
    rotary_shared += j.pieces[side] * turning;
  }
  const double share = std::min(stiffness_share * j.source->stiffness_scale, largest_share);
  j.bound = over(share, shared);
  j.rotary_bound = over(share, rotary_shared);
  // c = 2 xi sqrt(k m) with the mean mass of the relative motion.
  const double ratio = 2.0 * damping_ratio * j.source->damping;
  j.damping = ratio * std::sqrt(j.bound * over(j.source->transmits() ? 1.0 : 3.0, own));
  j.rotary_damping = ratio * std::sqrt(j.rotary_bound * over(3.0, rotary_own));
}

void Joints::follow_slide(Joint& j, const Motion& m) {
  if (j.constrained == ConstrainedDirections::all || j.source->kind == Kind::screw) return;
  const system::RigidBody& body = *j.body[0];
  const Vec3d lever = body.axes.local(m.arm[0] + m.gap);
  const double give = trace(inverse_mass_at(body, system::inverse_inertia(body), lever)) / stable_growth;
  // It never becomes stiffer again: an open joint would give energy.
  if (!(give > j.give)) return;
  j.give = give;
  set_bounds(j);
}

void Joints::apply(system::State& state) {
  longest_step_ = std::max(longest_step_, state.dt);
  springs_.apply(state);
  if (!(longest_step_ > 0.0)) return;
  for (Joint& j : joints_)
    if (!j.failed) apply(j, state);
}

bool Joints::fails(const Joint& j, const system::State& state) const {
  if (!state.acts(j.source->control)) return true;
  if (!j.source->failure) return false;
  const model::Joint::Failure& failure = *j.source->failure;
  if (failure.time > 0.0 && state.time >= failure.time) return true;
  const auto share = [&](const Vec3d& load, const std::array<double, 3>& limit) {
    const Vec3d l = failure.system == model::none ? load : axes_now(system_, state, failure.system).local(load);
    const std::array<double, 3> part{l.x, l.y, l.z};
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      if (limit[i] > 0.0) sum += part[i] / limit[i] * (part[i] / limit[i]);
    return sum;
  };
  const double of_force = share(j.force, failure.force), of_moment = share(j.moment, failure.moment);
  return failure.together ? of_force + of_moment >= 1.0 : of_force >= 1.0 || of_moment >= 1.0;
}

void Joints::take_step(Joint& j, double squared, double step, double giving) {
  if (step < j.step) j.stiffening = true;
  j.step = step;
  j.most_energy = std::max(j.most_energy, j.energy);
  j.share = 1.0;
  if (!j.stiffening) return;
  // What it has taken by half of this step; the other half takes - share giving / 2, and share^2 `all` / 2 is held.
  const double taken = std::max(0.0, j.energy + bearable_gain * j.most_energy), all = squared / (step * step);
  const double half = 0.5 * giving, root = std::sqrt(half * half + 2.0 * all * taken);
  const double holds = half > 0.0 ? 2.0 * taken : root - half, of = half > 0.0 ? root + half : all;
  if (holds >= of) {
    j.stiffening = false;
    return;
  }
  j.share = holds / of;
  // The last step of the way out leads beyond its end somewhere.
  if (j.share * giving > taken) j.share = taken / giving;
}

std::array<Joints::Load, 2> Joints::constraint_load(Joint& j, const Motion& m, double longest_step, double dt) {
  const double k = j.bound / (longest_step * longest_step), rotary = j.rotary_bound / (longest_step * longest_step);
  const double c = j.damping / longest_step, rotary_c = j.rotary_damping / longest_step;
  const auto constrained = [&](const Vec3d& v) {
    const Vec3d along = dot(v, m.axis) * m.axis;
    return j.constrained == ConstrainedDirections::all     ? v
           : j.constrained == ConstrainedDirections::along ? along
                                                           : v - along;
  };
  const Vec3d open = constrained(m.gap), spring = -k * open;
  Vec3d spring_moment, damping_moment;
  double squared = j.bound * dot(open, open);
  for (const Directions& d : j.directions) {
    const Vec3d a = j.body[0]->axes.global(d.a), b = j.body[1]->axes.global(d.b), normal = cross(a, b);
    const double cosine = dot(a, b);
    squared += j.rotary_bound * (d.perpendicular ? cosine * cosine : dot(normal, normal));
    spring_moment += (d.perpendicular ? rotary * cosine : -rotary * cosine) * normal;
    // What turns the directions against each other: about their normal where they are to be perpendicular, across
    // them where they are to be parallel.
    const Vec3d rate = d.perpendicular ? dot(m.turning, normal) * normal : m.turning - dot(m.turning, a) * a;
    damping_moment -= rotary_c * rate;
  }
  take_step(j, squared, longest_step, dt * (dot(spring, m.sliding) + dot(spring_moment, m.turning)));
  j.opening = norm(open);
  j.force = j.share * spring - c * constrained(m.sliding);
  j.moment = j.share * spring_moment + damping_moment;
  return {Load{-j.force, -j.moment - cross(m.arm[0] + m.gap, j.force)},
          Load{j.force, j.moment + cross(m.arm[1], j.force)}};
}

std::array<Joints::Load, 2> Joints::transmit(Joint& j, const Motion& m, double longest_step, double dt) {
  const double ratio = j.source->ratio;
  const Vec3d &a = m.axis, b = j.body[1]->axes.global(j.other);
  // g = way . (motion of B's point against A's) + turn[0] . w_A + turn[1] . w_B
  Vec3d way, moving, lever = m.arm[0];
  std::array<Vec3d, 2> turn{};
  if (j.source->kind == Kind::screw) {
    way = a;
    moving = m.sliding;
    lever += m.gap;
    turn = {-ratio * a, ratio * a};
  } else if (j.source->kind == Kind::rack_and_pinion) {
    way = b;
    moving = m.velocity[1] - m.velocity[0];
    turn[0] = -ratio * a;
  } else {
    const double sign = (j.source->kind == Kind::gears ? 1.0 : -1.0) * (dot(a, b) < 0.0 ? -1.0 : 1.0);
    turn = {sign / ratio * a, b};
  }
  const double rate = dot(way, moving) + dot(turn[0], m.spin[0]) + dot(turn[1], m.spin[1]);
  j.slip += dt * rate;
  j.opening = std::abs(j.slip);
  const double spring = j.bound / (longest_step * longest_step) * j.slip;
  take_step(j, j.bound * j.slip * j.slip, longest_step, -dt * spring * rate);
  const double load = j.share * spring + j.damping / longest_step * rate;
  const Vec3d force = -load * way;
  j.moment = -load * turn[1];
  j.force = force;
  if (j.source->radius > 0.0) {
    // The force of the teeth, or in the belt, that goes with the moment; bearings are no part of the joint.
    const Vec3d between = m.point[0] - m.point[1], across = between - dot(between, b) * b;
    if (norm(across) > 0.0) j.force = -load / (ratio * j.source->radius) * cross(b, unit(across));
  }
  return {Load{-force, -load * turn[0] - cross(lever, force)}, Load{force, j.moment + cross(m.arm[1], force)}};
}

void Joints::apply(Joint& j, system::State& state) {
  Motion m;
  for (std::size_t side = 0; side < 2; ++side) {
    const system::RigidBody& body = *j.body[side];
    const std::size_t n = at(body.node);
    m.arm[side] = body.axes.global(j.arm[side]);
    m.point[side] = vec(state.x[n]) + m.arm[side];
    m.spin[side] = vec(state.w[n]);
    m.velocity[side] = vec(state.v[n]) + cross(m.spin[side], m.arm[side]);
  }
  m.axis = j.body[0]->axes.global(j.axis);
  m.gap = m.point[1] - m.point[0];
  // B's point meets that point of A which is where it is.
  m.sliding = m.velocity[1] - m.velocity[0] - cross(m.spin[0], m.gap);
  m.turning = m.spin[1] - m.spin[0];

  follow_slide(j, m);

  // Half of the work of the step: of the loads before it, and of those after it.
  const auto book = [&] {
    for (std::size_t side = 0; side < 2; ++side)
      j.energy -=
          0.5 * state.dt *
          (dot(j.load[side].force, vec(state.v[at(j.body[side]->node)])) + dot(j.load[side].moment, m.spin[side]));
  };
  book();
  j.load =
      j.source->transmits() ? transmit(j, m, longest_step_, state.dt) : constraint_load(j, m, longest_step_, state.dt);
  if (fails(j, state)) {
    j.failed = true;
    j.failure_time = state.time;
    j.force = j.moment = {};
    j.load = {};
  }
  j.largest_opening = std::max(j.largest_opening, j.opening);
  for (std::size_t side = 0; side < 2; ++side) {
    const std::size_t n = at(j.body[side]->node);
    add(state.f[n], j.load[side].force);
    add(state.m[n], j.load[side].moment);
  }
  book();
}

double Joints::step_for(double opening, const system::State& state) const {
  // The way that a load opens a joint is load over stiffness, some tens of acceleration times dt^2 with the traces that
  // find_bounds takes.
  constexpr double ways = 100.0;
  double step = std::numeric_limits<double>::infinity();
  for (const Joint& j : joints_)
    for (std::size_t side = 0; side < 2; ++side) {
      const system::RigidBody& body = *j.body[side];
      if (!(j.size > 0.0) || !(body.mass > 0.0) || (body.fixed & 7u) == 7u) continue;
      const std::size_t n = at(body.node);
      const Vec3d arm = body.axes.global(j.arm[side]), spin = vec(state.w[n]);
      const Vec3d apart = (1.0 / body.mass) * vec(state.f[n]) + cross(body.spin(vec(state.m[n]), body.axes), arm);
      const double acceleration = norm(apart) + dot(spin, spin) * norm(arm);
      if (acceleration > 0.0) step = std::min(step, std::sqrt(opening * j.size / (ways * acceleration)));
    }
  return step;
}

double Joints::relative_opening() const {
  double most = 0.0;
  for (const Joint& j : joints_)
    if (!j.failed && j.size > 0.0) most = std::max(most, j.share * j.opening / j.size);
  return most;
}

double Joints::largest_relative_opening(std::size_t joint) const {
  const Joint& j = joints_[joint];
  return j.size > 0.0 ? j.largest_opening / j.size : 0.0;
}

double Joints::energy() const {
  double sum = springs_.energy();
  for (const Joint& j : joints_) sum += j.energy;
  return sum;
}

void Joints::Joint::archive(Archive& a) {
  a(give, bound, damping, force, moment, load, slip, step, stiffening, share, most_energy, energy, opening,
    largest_opening, failed, failure_time);
  a.built(source, body, arm, axis, other, constrained, directions, pieces, rotary_bound, rotary_damping, size);
}

void Joints::archive(Archive& a) {
  a(joints_, springs_, longest_step_);
  a.built(system_);
}

}  // namespace nugget::impact
