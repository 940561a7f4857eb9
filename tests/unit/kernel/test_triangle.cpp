// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstring>

#include "kernel/element/c0_triangle.hpp"
#include "motion.hpp"

namespace nugget::kernel {
namespace {

using Motion = NodalMotion<double, 3>;

ShellProperties section(int layers = 3) {
  ShellProperties shell;
  shell.density = steel_density;
  shell.layers = gauss_layers(layers);
  return shell;
}

Motion triangle(Random& random) {
  Motion m;
  m.x[1] = {5, 0, 0};
  m.x[2] = {1, 4, 0};
  for (Vec3d& x : m.x) x += random.vector(0.5);
  return m;
}

template <class Law>
struct Driven {
  ShellProperties shell;
  Prepared<Law> law;
  ShellLayout layout;
  std::vector<double> state;
  Motion nodes;
  NodalForces<double, 3> force{};

  Driven(const ShellProperties& s, const Law& parameters, const Motion& start)
      : shell(s),
        law(parameters),
        layout(shell_layout(s, law)),
        state(static_cast<std::size_t>(layout.size())),
        nodes(start) {
    start_shell(layout, 1.2, state.data(), 1, 0);
  }
  const NodalForces<double, 3>& step(double dt) {
    advance(nodes, dt);
    return force = triangle_cycle<double>(shell, law, nodes, dt, state.data());
  }
  void shake(Random& random, double size) {
    for (int i = 0; i < 3; ++i) {
      nodes.v[i] = random.vector(size);
      nodes.w[i] = random.vector(size);
    }
  }
  double at(int field) const { return state[static_cast<std::size_t>(field)]; }
};

template <class Law>
void batch_gives_the_bits_of_double(const ShellProperties& shell, const Law& parameters) {
  constexpr int W = native_width;
  Random random;
  std::vector<Driven<Law>> single;
  for (int l = 0; l < W; ++l) single.emplace_back(shell, parameters, triangle(random));
  const ShellLayout layout = single[0].layout;
  std::vector<double> together(static_cast<std::size_t>(layout.size() * W));
  for (int l = 0; l < W; ++l) start_shell(layout, 1.2, together.data(), W, l);
  for (int cycle = 0; cycle < 60; ++cycle) {
    NodalMotion<NativeBatch, 3> nodes;
    for (int l = 0; l < W; ++l) {
      Driven<Law>& one = single[static_cast<std::size_t>(l)];
      one.shake(random, 4000.0 * (l + 1));
      one.step(1e-6);
      put(nodes, l, one.nodes);
    }
    const auto force = triangle_cycle<NativeBatch>(shell, single[0].law, nodes, 1e-6, together.data());
    for (int l = 0; l < W; ++l) {
      const Driven<Law>& one = single[static_cast<std::size_t>(l)];
      for (int i = 0; i < 3; ++i) {
        const Vec3d f = get(force.f[i], l), m = get(force.m[i], l);
        ASSERT_EQ(0, std::memcmp(&f, &one.force.f[i], sizeof f)) << cycle;
        ASSERT_EQ(0, std::memcmp(&m, &one.force.m[i], sizeof m)) << cycle;
      }
      ASSERT_EQ(lane(force.stable_step, l), one.force.stable_step);
      for (int i = 0; i < layout.size(); ++i) ASSERT_EQ(together[static_cast<std::size_t>(i * W + l)], one.at(i));
    }
  }
  if constexpr (Prepared<Law>::has_plastic_strain) {
    EXPECT_GT(single[0].at(layout.history_of(0)), 0.0);
  }
}

TEST(Triangle, BatchGivesTheBitsOfDouble) {
  batch_gives_the_bits_of_double(section(), steel);
  batch_gives_the_bits_of_double(section(2), mixed(0.4));
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_double(section(), failing);
}

TEST(Triangle, RigidRotationStrainsNothing) {
  Random random;
  Driven<PlasticKinematic> d(section(), mixed(0.5), triangle(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    d.shake(random, 9000.0);
    d.step(1e-6);
  }
  const std::vector<double> before = d.state;
  const auto start = d.force;
  ASSERT_GT(before[static_cast<std::size_t>(d.layout.history_of(0))], 0.0);
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  for (int cycle = 0; cycle < 36; ++cycle) {
    d.nodes = rotation_step(d.nodes, axis, 2 * M_PI / 36, 1e-6);
    d.force = triangle_cycle<double>(d.shell, d.law, d.nodes, 1e-6, d.state.data());
  }
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(d.state[i], before[i], 1e-9 * (1 + std::abs(before[i])));
  for (int i = 0; i < 3; ++i) EXPECT_LT(norm(d.force.f[i] - start.f[i]), 1e-9 * largest_force(start));
}

TEST(Triangle, ForcesDoTheWorkOfTheStresses) {
  Random random;
  const double dt = 1e-12;
  ShellProperties shell = section(2);
  shell.offset = -1.0;
  Driven<Elastic> d(shell, steel, triangle(random));
  for (std::size_t i = ShellLayout::first_layer; i < d.state.size(); ++i) d.state[i] = 300.0 * random();
  const std::vector<double> start = d.state;
  d.shake(random, 1000.0);
  d.step(dt);
  const double E = steel_E, nu = steel_nu, G = E / (2 * (1 + nu));
  const double volume = 1.2 * triangle_area({d.nodes.x[0], d.nodes.x[1], d.nodes.x[2]});
  double expected = 0.0;
  for (int k = 0; k < 2; ++k) {
    const auto s = [&](int c) { return d.at(d.layout.layer(k) + c); };
    const auto change = [&](int c) { return s(c) - start[static_cast<std::size_t>(d.layout.layer(k) + c)]; };
    expected += 0.5 * volume / dt *
                (s(0) * (change(0) - nu * change(1)) / E + s(1) * (change(1) - nu * change(0)) / E +
                 (s(2) * change(2) + shell.shear_factor * (s(3) * change(3) + s(4) * change(4))) / G);
  }
  EXPECT_NEAR(power(d.force, d.nodes), expected, 2e-4 * std::abs(expected));
  Vec3d force{}, moment{};
  for (int i = 0; i < 3; ++i) {
    force += d.force.f[i];
    moment += cross(d.nodes.x[i], d.force.f[i]) + d.force.m[i];
  }
  EXPECT_LT(norm(force), 1e-10 * largest_force(d.force));
  EXPECT_LT(norm(moment), 1e-9 * largest_force(d.force));
}

TEST(Triangle, MembraneAndBendingPatch) {
  Random random;
  Motion flat = triangle(random);
  for (Vec3d& x : flat.x) x.z = 0.0;
  Driven<Elastic> d(section(2), Elastic{1e6, 0.25}, flat);
  for (int i = 0; i < 3; ++i) {
    const Vec3d& x = d.nodes.x[i];
    d.nodes.v[i] = {1e-9 * (x.x + 0.5 * x.y), 1e-9 * (x.y + 0.5 * x.x), 0};
    d.nodes.w[i] = {-1e-9 * x.y, 1e-9 * x.x, 0};         // kxx = kyy = 1e-9
    d.nodes.v[i].z = -0.5e-9 * (x.x * x.x + x.y * x.y);  // no shear on any edge
  }
  d.step(1.0);
  for (int k = 0; k < 2; ++k) {
    const double z = 0.6 * d.shell.layers.zeta[static_cast<std::size_t>(k)];
    const double mean = 0.5 * (d.at(d.layout.layer(k)) + d.at(d.layout.layer(k) + 1));
    EXPECT_NEAR(mean, 1333.3333e-6 * (1 + z), 1e-9);
    EXPECT_NEAR(d.at(d.layout.layer(k) + 3), 0.0, 1e-10);
    EXPECT_NEAR(d.at(d.layout.layer(k) + 4), 0.0, 1e-10);
  }
}

std::vector<double> stiffness_by_dual(const ShellProperties& shell, const Motion& m) {
  NodalMotion<Dual<18>, 3> nodes;
  Driven<Elastic> d(shell, steel, m);
  for (int i = 0; i < 3; ++i) {
    nodes.x[i] = {m.x[i].x, m.x[i].y, m.x[i].z};
    nodes.v[i] = {Dual<18>::variable(0, 6 * i), Dual<18>::variable(0, 6 * i + 1), Dual<18>::variable(0, 6 * i + 2)};
    nodes.w[i] = {Dual<18>::variable(0, 6 * i + 3), Dual<18>::variable(0, 6 * i + 4), Dual<18>::variable(0, 6 * i + 5)};
  }
  const auto force = triangle_cycle<Dual<18>>(d.shell, d.law, nodes, 1.0, d.state.data());
  std::vector<double> K;
  for (int i = 0; i < 3; ++i)
    for (const auto* row : {&force.f[i], &force.m[i]})
      for (const Dual<18>* f : {&row->x, &row->y, &row->z}) K.insert(K.end(), f->d.begin(), f->d.end());
  return K;
}

TEST(Triangle, DualGivesTheStiffness) {
  Random random;
  const Motion m = triangle(random);
  ShellProperties complete = section();
  complete.drilling = usual_drilling;
  for (const ShellProperties& shell : {section(), complete}) {
    const std::vector<double> K = stiffness_by_dual(shell, m);
    double largest = 0.0;
    for (double k : K) largest = std::max(largest, std::abs(k));
    for (std::size_t i = 0; i < 18; ++i)
      for (std::size_t j = 0; j < 18; ++j) EXPECT_NEAR(K[i * 18 + j], K[j * 18 + i], 1e-10 * largest);
    // Without completion the drilling of three nodes is free, and a mode that bends and shears nothing at the point.
    EXPECT_EQ(zero_modes(K, 18), shell.drilling > 0.0 ? 6 : 10);
  }
}

TEST(Triangle, CompletionDoesNotDependOnTheFirstNode) {
  Random random;
  const Motion m = triangle(random);
  Motion shifted;
  for (int i = 0; i < 3; ++i) shifted.x[i] = m.x[(i + 1) % 3];
  ShellProperties complete = section();
  complete.drilling = usual_drilling;
  const std::vector<double> a = stiffness_by_dual(complete, m), b = stiffness_by_dual(complete, shifted);
  double largest = 0.0;
  for (double k : a) largest = std::max(largest, std::abs(k));
  for (std::size_t i = 0; i < 18; ++i)
    for (std::size_t j = 0; j < 18; ++j)
      EXPECT_NEAR(b[i * 18 + j], a[(i + 6) % 18 * 18 + (j + 6) % 18], 1e-11 * largest);
}

TEST(Triangle, StableStepAndMass) {
  const std::array<Vec3d, 3> x = {Vec3d{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  const double c = 5.421933e6;
  EXPECT_NEAR(triangle_stable_step(x, ShellLength::area_over_side, steel_E, steel_nu, steel_density), 12.0 / 5.0 / c,
              1e-12);
  const NodalMass m = triangle_nodal_mass(x, 1.2, steel_density);
  EXPECT_NEAR(m.mass, 6.0 * 1.2 * steel_density / 3, 1e-20);
  EXPECT_NEAR(m.inertia, m.mass * 0.75, 1e-20);
}

}  // namespace
}  // namespace nugget::kernel
