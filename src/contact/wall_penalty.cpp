// SPDX-License-Identifier: Apache-2.0
#include "contact/wall_penalty.hpp"

#include <algorithm>
#include <variant>

#include "base/parallel.hpp"
#include "system/mobility.hpp"

namespace nugget::contact {
namespace {

constexpr std::size_t touches_per_group = 1024;

/// Inverse mass that a body shows along unit vector `n` at `arm` from its centre [1/mass].
double inverse_mass_along(const system::RigidBody& body, const Vec3d& arm, const Vec3d& n) {
  const Vec3d turn = cross(arm, n);
  return 1.0 / body.mass + dot(turn, body.spin(turn, body.axes));
}

}  // namespace

WallPenalty::WallPenalty(const system::System& system, const model::RigidWall& wall, const std::vector<int>& nodes,
                         double scale)
    : system_(system),
      scale_(std::min(0.1 * scale, 0.5)),
      friction_(wall.friction == 2.0 ? 0.0 : wall.friction),
      inverse_wall_mass_(wall.mass > 0.0 ? 1.0 / wall.mass : 0.0) {
  for (const int node : nodes)
    if (const int body = system.rigid_body_of_node(node); body >= 0) {
      Touch touch;
      touch.node = node;
      touch.body = body;
      touches_.push_back(touch);
    }
  touching_of_.resize(system.bodies.size());
  share_out(wall.mass);
}

void WallPenalty::share_out(double wall_mass) {
  std::vector<std::vector<Touch*>> of_body(system_.bodies.size());
  for (Touch& t : touches_) of_body[t.body].push_back(&t);
  double against_wall = 0.0;
  if (wall_mass > 0.0)
    for (std::size_t b = 0; b < of_body.size(); ++b)
      if (!of_body[b].empty()) against_wall += system_.bodies[b].mass / wall_mass;
  for (std::size_t b = 0; b < of_body.size(); ++b) {
    if (of_body[b].empty()) continue;
    const system::RigidBody& body = system_.bodies[b];
    double mean = 0.0, sum = 0.0;
    for (const Touch* t : of_body[b]) mean += system_.own_mass[t->node];
    mean /= static_cast<double>(of_body[b].size());
    for (Touch* t : of_body[b]) {
      t->share = mean > 0.0 ? std::clamp(system_.own_mass[t->node], 0.1 * mean, mean) : 1.0;
      sum += t->share;
    }
    system::Inertia spread{};
    for (Touch* t : of_body[b]) {
      t->share /= sum;
      const model::Index n = system_.model_node[t->node];
      system::add_point(spread, t->share, 0.0, system_.ties.x[n] - body.center0);
    }
    const Vec3d columns[3] = {
        {spread[0], spread[1], spread[2]}, {spread[1], spread[3], spread[4]}, {spread[2], spread[4], spread[5]}};
    system::Mobility::Matrix turning{};
    for (std::size_t j = 0; j < 3; ++j) {
      const Vec3d column = body.mass * system::solve(body.inertia, columns[j]);
      turning[0][j] = column.x, turning[1][j] = column.y, turning[2][j] = column.z;
    }
    const double all = 1.0 + system::Mobility::largest(turning) + against_wall;
    for (Touch* t : of_body[b]) t->share /= all;
  }
}

/// Which nodes are behind the face, and how deep.
template <class Shape>
void WallPenalty::find(const Step& step, const Shape& shape, const Vec3d& origin, const Vec3d& velocity) {
  parallel_for(touches_.size(), touches_per_group, [&](std::size_t begin, std::size_t end) {
    for (Touch& t : std::span(touches_).subspan(begin, end - begin)) {
      const Vec3d to = vec(step.x[t.node]) - origin;
      const Vec3d from = t.touching ? t.place : to - step.dt * (vec(step.v[t.node]) - velocity);
      kernel::WallPush p;
      if (system_.map.dependent(t.node)) {
        p = push(shape, from, to, t.touching ? kernel::WallAttachment::touching : kernel::WallAttachment::none);
      } else {  // its rigid weld has released it: it is stopped like any other
        t.memory = {};
        t.stiffness = 0.0;
      }
      t.touching = p.touching;
      t.depth = p.touching ? p.distance : 0.0;
      if (!p.touching) continue;
      t.place = to + p.distance * p.normal;
      t.normal = p.normal;
    }
  });
}

void WallPenalty::press(Touch& t, const Step& step, const Vec3d& velocity) const {
  const system::RigidBody& body = system_.bodies[t.body];
  const Vec3d arm = vec(step.x[t.node]) - vec(step.x[body.node]);
  const Vec3d relative = vec(step.v[t.node]) - velocity;
  const double approach = -dot(relative, t.normal);
  if (t.stiffness == 0.0) t.stiffness = scale_ * body.mass / (step.longest * step.longest) * t.share;
  const double inverse_mass = inverse_mass_along(body, arm, t.normal) + inverse_wall_mass_;
  const double pressed = kernel::spring_force(t.memory, t.stiffness, inverse_mass, t.depth, approach, step.dt);
  t.memory.pressed = pressed;
  t.force = pressed * t.normal;
  if (!t.touching) {
    t.stiffness = 0.0;
    return;
  }
  const Vec3d slip = relative + approach * t.normal;
  const double speed = norm(slip);
  if (!(friction_ > 0.0) || !(speed > 0.0) || !(pressed > 0.0)) return;
  const Vec3d along = (1.0 / speed) * slip;
  const double stops = speed / (inverse_mass_along(body, arm, along) * touching_of_[t.body] * step.dt);
  const bool sticks = friction_ == 1.0 || friction_ == 3.0;
  t.force -= (sticks ? stops : std::min(friction_ * pressed, stops)) * along;
}

void WallPenalty::apply(const Step& step, const kernel::WallShape& shape, const Vec3d& origin, const Vec3d& velocity,
                        std::span<Row> f) {
  // Before the first step nothing has moved yet.
  if (!(step.dt > 0.0) || !(step.longest > 0.0)) return;
  std::visit([&](const auto& form) { find(step, form, origin, velocity); }, shape);
  std::fill(touching_of_.begin(), touching_of_.end(), 0);
  touching_ = 0;
  for (const Touch& t : touches_) touching_of_[t.body] += t.touching, touching_ += t.touching;
  force_ = {};
  normal_force_ = 0.0;
  for (Touch& t : touches_) {
    const Vec3d before = t.force;
    const bool was_pressed = t.stiffness > 0.0;
    if (!t.touching && !was_pressed && dot(before, before) == 0.0) continue;
    t.force = {};
    if (t.touching || was_pressed) press(t, step, velocity);
    add(f[t.node], t.force);
    force_ += t.force;
    normal_force_ += dot(t.force, t.normal);
    energy_ -= 0.5 * step.dt * dot(before + t.force, vec(step.v[t.node]));
  }
}

void WallPenalty::release() {
  if (touching_ == 0 && dot(force_, force_) == 0.0) return;
  for (Touch& t : touches_) {
    t.touching = false;
    t.stiffness = 0.0;
    t.force = {};
    t.memory = {};
  }
  force_ = {};
  normal_force_ = 0.0;
  touching_ = 0;
}

void WallPenalty::archive(Archive& a) {
  a(touches_, force_, normal_force_, energy_, touching_);
  a.built(system_, scale_, friction_, inverse_wall_mass_, touching_of_);
}

}  // namespace nugget::contact
