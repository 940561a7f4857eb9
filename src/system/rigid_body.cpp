// SPDX-License-Identifier: Apache-2.0
#include "system/rigid_body.hpp"

#include <algorithm>

#include "base/index.hpp"
#include "system/constraint_map.hpp"

namespace nugget::system {
namespace {

Vec3d times(const Inertia& a, const Vec3d& b) {
  return {a[0] * b.x + a[1] * b.y + a[2] * b.z, a[1] * b.x + a[3] * b.y + a[4] * b.z,
          a[2] * b.x + a[4] * b.y + a[5] * b.z};
}

Frame3d turned_axes(const Frame3d& axes, const Vec3d& phi) {
  return {turned(axes.e1, phi), turned(axes.e2, phi), turned(axes.e3, phi)};
}

void hold(Vec3d& a, unsigned fixed, const Frame3d& axes) {
  if (fixed & 1u) a -= dot(a, axes.e1) * axes.e1;
  if (fixed & 2u) a -= dot(a, axes.e2) * axes.e2;
  if (fixed & 4u) a -= dot(a, axes.e3) * axes.e3;
}

}  // namespace

Vec3d solve(const Inertia& a, const Vec3d& b) {
  const double c00 = a[3] * a[5] - a[4] * a[4], c01 = a[2] * a[4] - a[1] * a[5], c02 = a[1] * a[4] - a[2] * a[3];
  const double c11 = a[0] * a[5] - a[2] * a[2], c12 = a[1] * a[2] - a[0] * a[4], c22 = a[0] * a[3] - a[1] * a[1];
  const double det = a[0] * c00 + a[1] * c01 + a[2] * c02;
  const Inertia inverse{c00, c01, c02, c11, c12, c22};
  return (1.0 / det) * times(inverse, b);
}

void add_point(Inertia& inertia, double mass, double point_inertia, const Vec3d& r) {
  inertia[0] += mass * (r.y * r.y + r.z * r.z) + point_inertia;
  inertia[3] += mass * (r.x * r.x + r.z * r.z) + point_inertia;
  inertia[5] += mass * (r.x * r.x + r.y * r.y) + point_inertia;
  inertia[1] -= mass * r.x * r.y;
  inertia[2] -= mass * r.x * r.z;
  inertia[4] -= mass * r.y * r.z;
}

Vec3d RigidBody::spin(const Vec3d& momentum, const Frame3d& at) const {
  return at.global(solve(inertia, at.local(momentum)));
}

Vec3d RigidBody::spin_of(const Vec3d& momentum, const Frame3d& at, const Frame3d& basis, unsigned given,
                         const Vec3d& values) const {
  const std::array<Vec3d, 3> e{basis.e1, basis.e2, basis.e3};
  const std::array<double, 3> value{values.x, values.y, values.z};
  // I w = L about the axes that are free; moments about the others make w there what it is to be.
  constexpr int place[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  std::array<double, 3> b{};
  Inertia a{};
  const auto is_given = [given](int i) { return (given >> i & 1u) != 0; };
  for (int i = 0; i < 3; ++i) b[i] = is_given(i) ? 0.0 : dot(e[i], momentum);
  for (int i = 0; i < 3; ++i) {
    const Vec3d turning = RigidBody::momentum(e[i], at);
    for (int j = 0; j <= i; ++j) {
      const double coupling = dot(e[j], turning);
      if (i == j || (!is_given(i) && !is_given(j))) a[place[i][j]] = coupling;
      if (is_given(i) && (i == j || !is_given(j)) && value[i] != 0.0)
        b[j] += (i == j ? 1.0 : -1.0) * coupling * value[i];
      if (is_given(j) && !is_given(i) && value[j] != 0.0) b[i] -= coupling * value[j];
    }
  }
  return basis.global(solve(a, {b[0], b[1], b[2]}));
}

Vec3d RigidBody::constrained_spin(const Vec3d& momentum, const Frame3d& at) const {
  if (!(fixed >> 3)) return spin(momentum, at);
  return spin_of(momentum, at, fixed_axes, fixed >> 3, {});
}

Vec3d RigidBody::momentum(const Vec3d& spin, const Frame3d& at) const {
  return at.global(times(inertia, at.local(spin)));
}

double RigidBody::advance(double velocity_interval, double dt, State& state) {
  if (!(mass > 0.0)) return 0.0;  // all its nodes were released
  const auto k = at(node);
  const Vec3d force = vec(state.f[k]), moment = vec(state.m[k]), v_before = vec(state.v[k]), w_before = vec(state.w[k]);
  Vec3d velocity = v_before + (velocity_interval / mass) * force;
  hold(velocity, fixed & 7u, fixed_axes);
  set(state.v[k], velocity);

  angular_momentum += velocity_interval * moment;
  Vec3d w = w_before;
  for (int i = 0; i < 50; ++i) {
    const Vec3d next = constrained_spin(angular_momentum, turned_axes(axes, (0.5 * dt) * w));
    const Vec3d change = next - w;
    w = next;
    if (dot(change, change) <= 1e-30 * dot(w, w)) break;
  }
  if (fixed >> 3) angular_momentum = momentum(w, turned_axes(axes, (0.5 * dt) * w));
  set(state.w[k], w);
  return dot(force, velocity - v_before) + dot(moment, w - w_before);
}

void RigidBody::turn(double dt, const State& state) {
  axes = turned_axes(axes, dt * vec(state.w[node]));
  // Round-off would make the triad drift from orthogonality over very many steps.
  axes.e1 = unit(axes.e1);
  axes.e2 = unit(axes.e2 - dot(axes.e1, axes.e2) * axes.e1);
  axes.e3 = cross(axes.e1, axes.e2);
}

void RigidBody::drive_spin(const Frame3d& basis, unsigned given, const Vec3d& values, double dt, State& state) {
  Vec3d w = vec(state.w[node]);
  for (int i = 0; i < 50; ++i) {
    const Vec3d next = spin_of(angular_momentum, turned_axes(axes, (0.5 * dt) * w), basis, given, values);
    const Vec3d change = next - w;
    w = next;
    if (dot(change, change) <= 1e-30 * dot(w, w)) break;
  }
  angular_momentum = momentum(w, turned_axes(axes, (0.5 * dt) * w));
  set(state.w[node], w);
}

void RigidBody::archive(Archive& a) {
  a(mass, inertia, axes, center0, angular_momentum);
  a.built(source, id, title, node, fixed, fixed_axes);
}

}  // namespace nugget::system
