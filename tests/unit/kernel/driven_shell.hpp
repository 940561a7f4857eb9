// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/full_shell.hpp"
#include "motion.hpp"

// A four-node shell alone, of either formulation, for the kernel tests.
namespace nugget::kernel {

using Motion = NodalMotion<double, 4>;

inline ShellProperties section(int layers = 3) {
  ShellProperties shell;
  shell.density = steel_density;
  shell.layers = gauss_layers(layers);
  return shell;
}

inline Motion square(double a = 5.0) {
  Motion m;
  m.x[0] = {0, 0, 0};
  m.x[1] = {a, 0, 0};
  m.x[2] = {a, a, 0};
  m.x[3] = {0, a, 0};
  return m;
}

inline Motion warped(Random& random) {
  Motion m = square();
  for (Vec3d& x : m.x) x += random.vector(0.6);
  return m;
}

inline std::array<Vec3d, 4> positions(const Motion& m) {
  return {m.x[0], m.x[1], m.x[2], m.x[3]};
}

/// The two four-node shells.
struct OnePoint {
  template <class Law>
  static ShellLayout layout(const ShellProperties& shell, const Prepared<Law>& law) {
    return shell_layout(shell, law);
  }
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const Prepared<Law>& law, const NodalMotion<R, 4>& nodes,
                                 double dt, double* state) {
    return shell_cycle<R>(shell, law, nodes, dt, state);
  }
};
struct Full {
  template <class Law>
  static ShellLayout layout(const ShellProperties& shell, const Prepared<Law>& law) {
    return full_shell_layout(shell, law);
  }
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const Prepared<Law>& law, const NodalMotion<R, 4>& nodes,
                                 double dt, double* state) {
    return full_shell_cycle<R>(shell, law, nodes, dt, state);
  }
};

/// A shell with its state, driven step by step.
template <class Law, class Kind = OnePoint>
struct Driven {
  ShellProperties shell;
  Prepared<Law> law;
  ShellLayout layout;
  std::vector<double> state;
  Motion nodes;
  NodalForces<double, 4> force{};

  Driven(const ShellProperties& s, const Law& parameters, const Motion& start, double thickness = 1.2)
      : shell(s),
        law(parameters),
        layout(Kind::layout(s, law)),
        state(static_cast<std::size_t>(layout.size())),
        nodes(start) {
    start_shell(layout, thickness, state.data(), 1, 0);
  }
  const NodalForces<double, 4>& step(double dt) {
    advance(nodes, dt);
    return cycle(dt);
  }
  /// A step to nodes that are already at its end.
  const NodalForces<double, 4>& cycle(double dt) {
    return force = Kind::template cycle<double>(shell, law, nodes, dt, state.data());
  }
  double at(int field) const { return state[static_cast<std::size_t>(field)]; }
};

inline void expect_same(const Vec3d& a, const Vec3d& b) {
  EXPECT_EQ(0, std::memcmp(&a, &b, sizeof a))
      << a.x << ' ' << b.x << ' ' << a.y << ' ' << b.y << ' ' << a.z << ' ' << b.z;
}

template <class Kind = OnePoint, class Law>
void batch_gives_the_bits_of_double(const ShellProperties& shell, const Law& parameters, double speed) {
  constexpr int W = native_width;
  const double dt = 1e-6;
  const Prepared<Law> law(parameters);
  const ShellLayout layout = Kind::layout(shell, law);
  const auto size = static_cast<std::size_t>(layout.size());
  std::vector<double> together(size * W), alone(size);
  Random random;
  std::vector<Driven<Law, Kind>> single;
  for (int l = 0; l < W; ++l) {
    single.emplace_back(shell, parameters, warped(random), 1.0 + 0.1 * l);
    start_shell(layout, 1.0 + 0.1 * l, together.data(), W, l);
  }
  if (W > 2) {  // one lane is deleted
    together[2] = 0.0;
    single[2].state[0] = 0.0;
  }
  int yielded = 0;
  for (int cycle = 0; cycle < 60; ++cycle) {
    NodalMotion<NativeBatch, 4> nodes;
    for (int l = 0; l < W; ++l) {
      Driven<Law, Kind>& one = single[static_cast<std::size_t>(l)];
      const double wild = speed * (l + 1);
      const Vec3d spin = random.vector(500.0);
      for (int i = 0; i < 4; ++i) {
        one.nodes.v[i] = cross(spin, one.nodes.x[i]) + random.vector(wild);
        one.nodes.w[i] = spin + random.vector(wild);
      }
      one.step(dt);
      put(nodes, l, one.nodes);
    }
    const auto force = Kind::template cycle<NativeBatch>(shell, law, nodes, dt, together.data());
    for (int l = 0; l < W; ++l) {
      const Driven<Law, Kind>& one = single[static_cast<std::size_t>(l)];
      for (int i = 0; i < 4; ++i) {
        expect_same(get(force.f[i], l), one.force.f[i]);
        expect_same(get(force.m[i], l), one.force.m[i]);
      }
      EXPECT_EQ(lane(force.stable_step, l), one.force.stable_step);
      for (int i = 0; i < layout.size(); ++i)
        ASSERT_EQ(together[static_cast<std::size_t>(i * W + l)], one.at(i)) << "field " << i << " cycle " << cycle;
      if constexpr (Prepared<Law>::has_plastic_strain) {
        yielded += one.at(layout.history_of(0)) > 0.0;
      }
    }
    if (testing::Test::HasFailure()) return;
  }
  if constexpr (Prepared<Law>::has_plastic_strain) {
    EXPECT_GT(yielded, 60);
  }
}

/// The elastic stiffness as the derivative of the forces.
template <class Kind = OnePoint>
std::vector<double> stiffness_by_dual(const ShellProperties& shell, const Motion& m) {
  NodalMotion<Dual<24>, 4> nodes;
  const Prepared<Elastic> law(steel);
  std::vector<double> state(static_cast<std::size_t>(Kind::layout(shell, law).size()));
  start_shell(Kind::layout(shell, law), 1.2, state.data(), 1, 0);
  for (int i = 0; i < 4; ++i) {
    nodes.x[i] = {m.x[i].x, m.x[i].y, m.x[i].z};
    nodes.v[i] = {Dual<24>::variable(0, 6 * i), Dual<24>::variable(0, 6 * i + 1), Dual<24>::variable(0, 6 * i + 2)};
    nodes.w[i] = {Dual<24>::variable(0, 6 * i + 3), Dual<24>::variable(0, 6 * i + 4), Dual<24>::variable(0, 6 * i + 5)};
  }
  const auto force = Kind::template cycle<Dual<24>>(shell, law, nodes, 1.0, state.data());
  std::vector<double> K;
  for (int i = 0; i < 4; ++i)
    for (const auto* row : {&force.f[i], &force.m[i]})
      for (const Dual<24>* f : {&row->x, &row->y, &row->z}) K.insert(K.end(), f->d.begin(), f->d.end());
  return K;
}

}  // namespace nugget::kernel
