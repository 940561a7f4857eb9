// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "base/index.hpp"
#include "element_stiffness.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "kernel/element/full_shell.hpp"
#include "kernel/element/kirchhoff_triangle.hpp"
#include "motion.hpp"
#include "one_element.hpp"

// One shell, of any formulation, driven by the velocities of its nodes, and what all of them must keep. A `Kind` has
//   corners, columns         nodes, and points of integration in the plane
//   some(random)             a shape of its own
//   layout(properties, law), cycle<R>(properties, law, nodes, dt, state)
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

inline NodalMotion<double, 3> triangle(Random& random) {
  NodalMotion<double, 3> m;
  m.x[1] = {5, 0, 0};
  m.x[2] = {1, 4, 0};
  for (Vec3d& x : m.x) x += random.vector(0.5);
  return m;
}

struct OnePoint {
  static constexpr int corners = 4, columns = 1;
  static Motion some(Random& random) { return warped(random); }
  template <class Law>
  static ShellLayout layout(const ShellProperties& shell, const LawKernel<Law>& law) {
    return shell_layout(shell, law);
  }
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state) {
    return shell_cycle<R>(shell, law, nodes, dt, state);
  }
};
struct Full {
  static constexpr int corners = 4, columns = 4;
  static Motion some(Random& random) { return warped(random); }
  template <class Law>
  static ShellLayout layout(const ShellProperties& shell, const LawKernel<Law>& law) {
    return full_shell_layout(shell, law);
  }
  template <class R, class Law>
  static NodalForces<R, 4> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 4>& nodes, double dt, double* state) {
    return full_shell_cycle<R>(shell, law, nodes, dt, state);
  }
};
struct C0 {
  static constexpr int corners = 3, columns = 1;
  static NodalMotion<double, 3> some(Random& random) { return triangle(random); }
  template <class Law>
  static ShellLayout layout(const ShellProperties& shell, const LawKernel<Law>& law) {
    return shell_layout(shell, law);
  }
  template <class R, class Law>
  static NodalForces<R, 3> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 3>& nodes, double dt, double* state) {
    return triangle_cycle<R>(shell, law, nodes, dt, state);
  }
};
struct Kirchhoff {
  static constexpr int corners = 3, columns = kirchhoff_columns;
  static NodalMotion<double, 3> some(Random& random) { return triangle(random); }
  template <class Law>
  static ShellLayout layout(const ShellProperties& shell, const LawKernel<Law>& law) {
    return kirchhoff_layout(shell, law);
  }
  template <class R, class Law>
  static NodalForces<R, 3> cycle(const ShellProperties& shell, const LawKernel<Law>& law,
                                 const NodalMotion<R, 3>& nodes, double dt, double* state) {
    return kirchhoff_triangle_cycle<R>(shell, law, nodes, dt, state);
  }
};

/// A shell with its state, driven step by step.
template <class Law, class Kind = OnePoint>
struct Driven {
  ShellProperties shell;
  LawKernel<Law> law;
  ShellLayout layout;
  std::vector<double> state;
  NodalMotion<double, Kind::corners> nodes;
  NodalForces<double, Kind::corners> force{};

  Driven(const ShellProperties& s, const Law& parameters, const NodalMotion<double, Kind::corners>& start,
         double thickness = 1.2)
      : shell(s),
        law(parameters),
        layout(Kind::layout(s, law)),
        state(static_cast<std::size_t>(layout.size())),
        nodes(start) {
    start_shell(layout, thickness, state.data(), 1, 0);
  }
  const NodalForces<double, Kind::corners>& step(double dt) {
    advance(nodes, dt);
    return cycle(dt);
  }
  /// A step to nodes that are already at its end.
  const NodalForces<double, Kind::corners>& cycle(double dt) {
    return force = one_element(nodes, state,
                               [&](const auto& all, double* store) { return Kind::cycle(shell, law, all, dt, store); });
  }
  void shake(Random& random, double speed, double turning) {
    for (int i = 0; i < Kind::corners; ++i) {
      nodes.v[i] = random.vector(speed);
      nodes.w[i] = random.vector(turning);
    }
  }
  double at(int field) const { return state[field]; }
};

inline void expect_same(const Vec3d& a, const Vec3d& b) {
  EXPECT_EQ(0, std::memcmp(&a, &b, sizeof a))
      << a.x << ' ' << b.x << ' ' << a.y << ' ' << b.y << ' ' << a.z << ' ' << b.z;
}

template <class Kind = OnePoint, class Law>
void batch_gives_the_bits_of_each_alone(const ShellProperties& shell, const Law& parameters, double speed) {
  constexpr int W = native_width;
  const double dt = 1e-6;
  const LawKernel<Law> law(parameters);
  const ShellLayout layout = Kind::layout(shell, law);
  const auto size = static_cast<std::size_t>(layout.size());
  std::vector<double> together(size * W), alone(size);
  Random random;
  std::vector<Driven<Law, Kind>> single;
  for (int l = 0; l < W; ++l) {
    single.emplace_back(shell, parameters, Kind::some(random), 1.0 + 0.1 * l);
    start_shell(layout, 1.0 + 0.1 * l, together.data(), W, l);
  }
  if (W > 2) {  // one lane is deleted
    together[2] = 0.0;
    single[2].state[0] = 0.0;
  }
  int yielded = 0;
  for (int cycle = 0; cycle < 60; ++cycle) {
    NodalMotion<NativeBatch, Kind::corners> nodes;
    for (int l = 0; l < W; ++l) {
      Driven<Law, Kind>& one = single[l];
      const double wild = speed * (l + 1);
      const Vec3d spin = random.vector(500.0);
      for (int i = 0; i < Kind::corners; ++i) {
        one.nodes.v[i] = cross(spin, one.nodes.x[i]) + random.vector(wild);
        one.nodes.w[i] = spin + random.vector(wild);
      }
      one.step(dt);
      put(nodes, l, one.nodes);
    }
    const auto force = Kind::cycle(shell, law, nodes, dt, together.data());
    for (int l = 0; l < W; ++l) {
      const Driven<Law, Kind>& one = single[l];
      for (int i = 0; i < Kind::corners; ++i) {
        expect_same(get(force.f[i], l), one.force.f[i]);
        expect_same(get(force.m[i], l), one.force.m[i]);
      }
      EXPECT_EQ(lane(force.stable_step, l), one.force.stable_step);
      for (int i = 0; i < layout.size(); ++i)
        ASSERT_EQ(together[i * W + l], one.at(i)) << "field " << i << " cycle " << cycle;
      if constexpr (LawKernel<Law>::has_plastic_strain) {
        yielded += one.at(layout.history_of(0)) > 0.0;
      }
    }
    if (testing::Test::HasFailure()) return;
  }
  if constexpr (LawKernel<Law>::has_plastic_strain) {
    EXPECT_GT(yielded, 60);
  }
}

/// A stressed element that has yielded, turned once round an oblique axis as a rigid body: stresses and forces come
/// back with it and do no work.
template <class Kind = OnePoint>
void rigid_rotation_strains_nothing(const ShellProperties& shell, int steps = 720, double share = 1e-8) {
  const double dt = 1e-6;
  Random random;
  Driven<PlasticKinematic, Kind> d(shell, mixed(0.5), Kind::some(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    d.shake(random, 9000.0, 3000.0);
    d.step(dt);
  }
  const std::vector<double> before = d.state;
  const auto force = d.force;
  for (int column = 0; column < Kind::columns; ++column) ASSERT_GT(d.at(d.layout.history_of(0, column)), 0.0);
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  double work = 0.0, drift = 0.0;
  for (int cycle = 0; cycle < steps; ++cycle) {
    const auto last = d.force;
    d.nodes = rotation_step(d.nodes, axis, 2.0 * M_PI / steps, dt);
    d.cycle(dt);
    work += 0.5 * dt * (power(last, d.nodes) + power(d.force, d.nodes));
    for (std::size_t i = 0; i < before.size(); ++i)
      drift = std::max(drift, std::abs(d.state[i] - before[i]) / (1.0 + std::abs(before[i])));
  }
  EXPECT_LT(drift, 1e-9);
  for (int i = 0; i < Kind::corners; ++i) EXPECT_LT(norm(d.force.f[i] - force.f[i]), share * largest_force(force));
  const double coarse = 720.0 / steps;  // the chords of the way grow with the square of a step
  EXPECT_LT(std::abs(work), 1e-3 * coarse * coarse * largest_force(force));
}

/// A four-node shell numbered from its second node has the same forces.
template <class Kind = OnePoint>
void does_not_depend_on_the_first_node(const ShellProperties& shell) {
  Random random;
  Motion moving = warped(random);
  for (int i = 0; i < 4; ++i) {
    moving.v[i] = random.vector(5000.0);
    moving.w[i] = random.vector(1000.0);
  }
  Motion shifted;
  for (int i = 0; i < 4; ++i) {
    shifted.x[i] = moving.x[(i + 1) % 4];
    shifted.v[i] = moving.v[(i + 1) % 4];
    shifted.w[i] = moving.w[(i + 1) % 4];
  }
  Driven<PiecewiseLinear, Kind> a(shell, curved(), moving), b(shell, curved(), shifted);
  for (int cycle = 0; cycle < 10; ++cycle) {
    a.step(1e-6);
    b.step(1e-6);
  }
  EXPECT_GT(a.at(a.layout.history_of(0)), 0.0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_LT(norm(b.force.f[i] - a.force.f[(i + 1) % 4]), 1e-9 * largest_force(a.force));
    EXPECT_LT(norm(b.force.m[i] - a.force.m[(i + 1) % 4]), 1e-9 * largest_force(a.force));
  }
}

/// Forces and moments are in balance, to these shares of the largest force; moments over a length of 1.
template <class Kind, class Law>
void expect_balance(const Driven<Law, Kind>& d, double forces, double moments) {
  Vec3d force{}, moment{};
  for (int i = 0; i < Kind::corners; ++i) {
    force += d.force.f[i];
    moment += cross(d.nodes.x[i], d.force.f[i]) + d.force.m[i];
  }
  EXPECT_LT(norm(force), forces * largest_force(d.force));
  EXPECT_LT(norm(moment), moments * largest_force(d.force));
}

/// The elastic stiffness, row by row.
template <class Kind = OnePoint>
std::vector<double> shell_stiffness(const ShellProperties& shell, const NodalMotion<double, Kind::corners>& m) {
  const LawKernel<Elastic> law(steel);
  return element_stiffness(m, [&](const auto& motion, double step) {
    std::vector<double> state(static_cast<std::size_t>(Kind::layout(shell, law).size()));
    start_shell(Kind::layout(shell, law), 1.2, state.data(), 1, 0);
    return one_element(motion, state,
                       [&](const auto& all, double* store) { return Kind::cycle(shell, law, all, step, store); });
  });
}

/// The stiffness is symmetric and lets `free` motions go.
inline void expect_free_motions(const std::vector<double>& K, int size, int free) {
  const auto n = at(size);
  double largest = 0.0, skew = 0.0;
  for (const double k : K) largest = std::max(largest, std::abs(k));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) skew = std::max(skew, std::abs(K[i * n + j] - K[j * n + i]));
  EXPECT_LT(skew, 1e-12 * largest);
  EXPECT_EQ(zero_modes(K, size), free);
}

}  // namespace nugget::kernel
