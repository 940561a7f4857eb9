// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "element_stiffness.hpp"
#include "kernel/element/rotational_tetrahedron.hpp"
#include "kernel/element/tetrahedron.hpp"
#include "motion.hpp"
#include "one_element.hpp"

namespace nugget::kernel {
namespace {

using Motion = NodalMotion<double, 4>;
using L = RotationalTetrahedronLayout;

HexahedronProperties inviscid() {
  HexahedronProperties b;
  b.density = steel_density;
  b.bulk_linear = b.bulk_quadratic = 0.0;
  return b;
}

std::array<Vec3d, 4> places(const Motion& m) {
  return {m.x[0], m.x[1], m.x[2], m.x[3]};
}

Motion tetrahedron(Random& random, double size = 0.4) {
  Motion m;
  m.x[1] = {5, 0, 0};
  m.x[2] = {0, 4, 0};
  m.x[3] = {1, 1, 3};
  for (Vec3d& x : m.x) x += random.vector(size);
  return m;
}

template <class Law>
struct Driven {
  HexahedronProperties solid = inviscid();
  LawKernel<Law> law;
  L layout;
  std::vector<double> state;
  Motion nodes;
  RotationalTetrahedronForces<double> force{};

  Driven(const Law& parameters, const Motion& start)
      : law(parameters),
        layout(rotational_tetrahedron_layout(law)),
        state(static_cast<std::size_t>(layout.size())),
        nodes(start) {
    start_rotational_tetrahedron(layout, places(start), state.data(), 1, 0);
  }
  void step(double dt) {
    advance(nodes, dt);
    cycle(dt);
  }
  void cycle(double dt) {
    force = one_element(nodes, state, [&](const auto& all, double* store) {
      return rotational_tetrahedron_cycle(solid, law, all, dt, store);
    });
  }
  void shake(Random& random, double size) {
    for (int i = 0; i < 4; ++i) {
      nodes.v[i] = random.vector(size);
      nodes.w[i] = random.vector(size);
    }
  }
  double at(int field) const { return state[field]; }
  double power() const {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += dot(force.f[i], nodes.v[i]) + dot(force.m[i], nodes.w[i]);
    return sum;
  }
};

template <class Law>
void batch_gives_the_bits_of_each_alone(const Law& parameters) {
  constexpr int W = native_width;
  Random random;
  std::vector<Driven<Law>> single;
  for (int l = 0; l < W; ++l) single.emplace_back(parameters, tetrahedron(random));
  const L layout = single[0].layout;
  std::vector<double> together(static_cast<std::size_t>(layout.size() * W));
  for (int l = 0; l < W; ++l) start_rotational_tetrahedron(layout, places(single[l].nodes), together.data(), W, l);
  for (int cycle = 0; cycle < 60; ++cycle) {
    NodalMotion<NativeBatch, 4> nodes;
    for (int l = 0; l < W; ++l) {
      Driven<Law>& one = single[l];
      one.shake(random, 2000.0 * (l + 1));
      one.step(1e-6);
      put(nodes, l, one.nodes);
    }
    const auto force = rotational_tetrahedron_cycle(single[0].solid, single[0].law, nodes, 1e-6, together.data());
    for (int l = 0; l < W; ++l) {
      const Driven<Law>& one = single[l];
      for (int i = 0; i < 4; ++i) {
        const Vec3d f = get(force.f[i], l), m = get(force.m[i], l);
        ASSERT_EQ(0, std::memcmp(&f, &one.force.f[i], sizeof f)) << cycle;
        ASSERT_EQ(0, std::memcmp(&m, &one.force.m[i], sizeof m)) << cycle;
      }
      ASSERT_EQ(lane(force.stable_step, l), one.force.stable_step);
      for (int i = 0; i < layout.size(); ++i) ASSERT_EQ(together[i * W + l], one.at(i));
    }
  }
}

TEST(RotationalTetrahedron, BatchGivesTheBitsOfEachAlone) {
  batch_gives_the_bits_of_each_alone(steel);
  batch_gives_the_bits_of_each_alone(mixed(0.4));
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone(failing);
}

// A turn in 36 steps: the stress and the forces come back, and no energy is stored.
TEST(RotationalTetrahedron, RigidRotationStrainsNothing) {
  Random random;
  Driven<PlasticKinematic> d(mixed(0.5), tetrahedron(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    d.shake(random, 9000.0);
    d.step(1e-6);
  }
  const std::vector<double> before = d.state;
  const auto start = d.force;
  ASSERT_GT(before[d.layout.history_of(0)], 0.0);
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  for (int cycle = 0; cycle < 36; ++cycle) {
    d.nodes = rotation_step(d.nodes, axis, 2 * M_PI / 36, 1e-6);
    d.cycle(1e-6);
  }
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(d.state[i], before[i], 1e-8 * (1 + std::abs(before[i])));
  for (int i = 0; i < 4; ++i) {
    EXPECT_LT(norm(d.force.f[i] - start.f[i]), 1e-8 * norm(start.f[0]));
    EXPECT_LT(norm(d.force.m[i] - start.m[i]), 1e-8 * norm(start.f[0]));
  }
}

TEST(RotationalTetrahedron, ForcesAreInBalance) {
  Random random;
  Driven<Elastic> d(steel, tetrahedron(random));
  for (std::size_t i = L::moment; i < d.state.size(); ++i)
    if (i != L::edge2) d.state[i] = 300.0 * random();
  d.shake(random, 1000.0);
  d.step(1e-7);
  Vec3d force{}, moment{};
  for (int i = 0; i < 4; ++i) {
    force += d.force.f[i];
    moment += cross(d.nodes.x[i], d.force.f[i]) + d.force.m[i];
  }
  EXPECT_LT(norm(force), 1e-10 * norm(d.force.f[0]));
  EXPECT_LT(norm(moment), 1e-9 * norm(d.force.f[0]));
}

/// Strain energy rate of the ten-node tetrahedron, by its textbook shape functions N_i = L_i (2 L_i - 1), N_ij = 4 L_i
/// L_j with nodes on straight edges, four points, dilatation by its mean; and of the stabilisation, by its definition.
double energy_of_ten_nodes(const Motion& m) {
  const double E = steel_E, nu = steel_nu, G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
  const double volume = tetrahedron_volume(places(m));
  Vec3d b[4];
  for (int i = 0; i < 4; ++i) {
    const Vec3d p = m.x[(i + 1) % 4], q = m.x[(i + 2) % 4], r = m.x[(i + 3) % 4];
    const Vec3d area = cross(q - p, r - p);
    b[i] = (1.0 / dot(m.x[i] - p, area)) * area;
  }
  std::array<std::array<std::array<double, 3>, 3>, 4> gradient{};
  const auto add = [&](int p, const Vec3d& v, const Vec3d& n) {
    const double vs[3] = {v.x, v.y, v.z}, ns[3] = {n.x, n.y, n.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) gradient[p][i][j] += vs[i] * ns[j];
  };
  double divergence = 0.0, edge2 = 0.0;
  Vec3d spin{};
  for (int p = 0; p < 4; ++p) {
    double l[4];
    for (int i = 0; i < 4; ++i) l[i] = i == p ? 0.58541020 : 0.13819660;
    for (int i = 0; i < 4; ++i) {
      add(p, m.v[i], (4.0 * l[i] - 1.0) * b[i]);
      for (int j = i + 1; j < 4; ++j) {
        const Vec3d side = m.x[j] - m.x[i];
        const Vec3d middle = 0.5 * (m.v[i] + m.v[j]) + 0.125 * cross(m.w[i] - m.w[j], side);
        add(p, middle, 4.0 * (l[j] * b[i] + l[i] * b[j]));
        if (p == 0) edge2 += dot(side, side) / 6.0;
      }
    }
  }
  for (int i = 0; i < 4; ++i) {
    divergence += dot(b[i], m.w[i]);
    spin += 0.25 * m.w[i];
  }
  double mean = 0.0, energy = 0.0;
  for (const auto& g : gradient) mean += 0.25 * (g[0][0] + g[1][1] + g[2][2]);
  for (const auto& g : gradient) {
    const double own = g[0][0] + g[1][1] + g[2][2];
    double squares = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const double e = 0.5 * (g[i][j] + g[j][i]) - (i == j ? own / 3.0 : 0.0);
        squares += e * e;
      }
    energy += 0.25 * volume * (G * squares + 0.5 * K * mean * mean);
    spin -= 0.125 * Vec3d{g[2][1] - g[1][2], g[0][2] - g[2][0], g[1][0] - g[0][1]};
  }
  return energy + 0.5 * G * volume * (1e-5 * dot(spin, spin) + 1e-2 * edge2 * divergence * divergence);
}

// Sabotage: the middle of an edge on the other side (w_j - w_i); an eighth as a quarter; no mean of the dilatation.
TEST(RotationalTetrahedron, IsTheOneOfTenNodes) {
  Random random;
  const double dt = 1e-13;
  for (int trial = 0; trial < 10; ++trial) {
    Driven<Elastic> d(steel, tetrahedron(random));
    d.shake(random, 1000.0);
    d.step(dt);
    EXPECT_NEAR(0.5 * d.power() / dt, energy_of_ten_nodes(d.nodes), 1e-6 * energy_of_ten_nodes(d.nodes));
    EXPECT_GT(d.at(L::hourglass_energy), 0.0);
  }
}

std::vector<double> stiffness(const Motion& m) {
  return element_stiffness(m, [&](const Motion& motion, double step) {
    Driven<Elastic> d(steel, m);
    return one_element(motion, d.state, [&](const auto& all, double* store) {
      return rotational_tetrahedron_cycle(d.solid, d.law, all, step, store);
    });
  });
}

TEST(RotationalTetrahedron, OnlyRigidMotionsAreFree) {
  Random random;
  const std::vector<double> k = stiffness(tetrahedron(random));
  double largest = 0.0;
  for (const double v : k) largest = std::max(largest, std::abs(v));
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) EXPECT_NEAR(k[24 * i + j], k[24 * j + i], 1e-10 * largest);
  EXPECT_EQ(zero_modes(k, 24), 6);
}

// No element of any shape vibrates faster than its step allows; a regular one comes close.
TEST(RotationalTetrahedron, StepIsStable) {
  Random random;
  double least = 1e9;
  for (int trial = 0; trial < 200; ++trial) {
    Motion m = tetrahedron(random, 1.5);
    if (trial == 0) {
      const Vec3d regular[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
      for (int i = 0; i < 4; ++i) m.x[i] = regular[i];
    }
    if (!(tetrahedron_volume(places(m)) > 0.1)) continue;
    const double mass = 0.25 * steel_density * tetrahedron_volume(places(m));
    const double inertia = rotational_tetrahedron_inertia(places(m), steel_density);
    std::vector<double> k = stiffness(m);
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t j = 0; j < 24; ++j)
        k[24 * i + j] /= std::sqrt((i % 6 < 3 ? mass : inertia) * (j % 6 < 3 ? mass : inertia));
    double fastest = 0.0;
    for (const double v : eigenvalues(k, 24)) fastest = std::max(fastest, v);
    Driven<Elastic> d(steel, m);
    d.cycle(1e-9);
    least = std::min(least, 2.0 / std::sqrt(fastest) / d.force.stable_step);
  }
  EXPECT_GE(least, 1.0);
  EXPECT_LT(least, 1.25);
}

}  // namespace
}  // namespace nugget::kernel
