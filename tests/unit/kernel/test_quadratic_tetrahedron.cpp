// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "kernel/element/quadratic_tetrahedron.hpp"
#include "kernel/element/tetrahedron.hpp"
#include "motion.hpp"
#include "one_element.hpp"

namespace nugget::kernel {
namespace {

using Motion = QuadraticTetrahedronMotion<double>;
using Places = std::array<Vec3d, 10>;
using L = QuadraticTetrahedronLayout;

HexahedronProperties inviscid() {
  HexahedronProperties b;
  b.density = steel_density;
  b.bulk_linear = b.bulk_quadratic = 0.0;
  return b;
}

Places places(const Motion& m) {
  Places x;
  std::copy_n(m.x, 10, x.begin());
  return x;
}

void put_nodes_amid_edges(Motion& m) {
  for (int i = 0; i < 6; ++i)
    m.x[4 + i] = 0.5 * (m.x[quadratic_tetrahedron_edge[i][0]] + m.x[quadratic_tetrahedron_edge[i][1]]);
}

/// A distorted tetrahedron; `bent`: by how far the nodes amid its edges stand off.
Motion tetrahedron(Random& random, double size = 0.4, double bent = 0.0) {
  Motion m;
  m.x[1] = {5, 0, 0};
  m.x[2] = {0, 4, 0};
  m.x[3] = {1, 1, 3};
  for (int i = 0; i < 4; ++i) m.x[i] += random.vector(size);
  put_nodes_amid_edges(m);
  for (int i = 4; i < 10; ++i) m.x[i] += random.vector(bent);
  return m;
}

template <class Law>
struct Driven {
  HexahedronProperties solid = inviscid();
  LawKernel<Law> law;
  L layout;
  std::vector<double> state;
  Motion nodes;
  QuadraticTetrahedronForces<double> force{};

  Driven(const Law& parameters, const Motion& start)
      : law(parameters),
        layout(quadratic_tetrahedron_layout(law)),
        state(static_cast<std::size_t>(layout.size())),
        nodes(start) {
    start_quadratic_tetrahedron(layout, places(start), state.data(), 1, 0);
  }
  void step(double dt) {
    for (int i = 0; i < 10; ++i) nodes.x[i] += dt * nodes.v[i];
    cycle(dt);
  }
  void cycle(double dt) {
    force = one_element(nodes, state, [&](const auto& all, double* store) {
      return quadratic_tetrahedron_cycle(solid, law, all, dt, store);
    });
  }
  void shake(Random& random, double size) {
    for (Vec3d& v : nodes.v) v = random.vector(size);
  }
  double at(int field) const { return state[field]; }
};

template <class Law>
void batch_gives_the_bits_of_each_alone(const Law& parameters) {
  constexpr int W = native_width;
  Random random;
  std::vector<Driven<Law>> single;
  for (int l = 0; l < W; ++l) single.emplace_back(parameters, tetrahedron(random, 0.4, 0.2));
  const L layout = single[0].layout;
  std::vector<double> together(static_cast<std::size_t>(layout.size() * W));
  for (int l = 0; l < W; ++l) start_quadratic_tetrahedron(layout, places(single[l].nodes), together.data(), W, l);
  const auto put = [](Vec3<NativeBatch>& to, int l, const Vec3d& from) {
    set_lane(to.x, l, from.x);
    set_lane(to.y, l, from.y);
    set_lane(to.z, l, from.z);
  };
  for (int cycle = 0; cycle < 60; ++cycle) {
    QuadraticTetrahedronMotion<NativeBatch> nodes;
    for (int l = 0; l < W; ++l) {
      Driven<Law>& one = single[l];
      one.shake(random, 1000.0 * (l + 1));
      one.step(1e-6);
      for (int i = 0; i < 10; ++i) {
        put(nodes.x[i], l, one.nodes.x[i]);
        put(nodes.v[i], l, one.nodes.v[i]);
      }
    }
    const auto force = quadratic_tetrahedron_cycle(single[0].solid, single[0].law, nodes, 1e-6, together.data());
    for (int l = 0; l < W; ++l) {
      const Driven<Law>& one = single[l];
      for (int i = 0; i < 10; ++i) {
        const Vec3d f{lane(force.f[i].x, l), lane(force.f[i].y, l), lane(force.f[i].z, l)};
        ASSERT_EQ(0, std::memcmp(&f, &one.force.f[i], sizeof f)) << cycle;
      }
      ASSERT_EQ(lane(force.stable_step, l), one.force.stable_step);
      ASSERT_EQ(lane(force.volume, l), one.force.volume);
      for (int i = 0; i < layout.size(); ++i) ASSERT_EQ(together[i * W + l], one.at(i));
    }
  }
}

TEST(QuadraticTetrahedron, BatchGivesTheBitsOfEachAlone) {
  batch_gives_the_bits_of_each_alone(steel);
  batch_gives_the_bits_of_each_alone(mixed(0.4));
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone(failing);
}

// A turn in 36 steps: the stress and the forces come back, and no energy is stored.
TEST(QuadraticTetrahedron, RigidRotationStrainsNothing) {
  Random random;
  Driven<PlasticKinematic> d(mixed(0.5), tetrahedron(random, 0.4, 0.2));
  for (int cycle = 0; cycle < 20; ++cycle) {
    d.shake(random, 5000.0);
    d.step(1e-6);
  }
  const std::vector<double> before = d.state;
  const auto start = d.force;
  ASSERT_GT(before[d.layout.history_of(0)], 0.0);
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  const double dt = 1e-6, angle = 2 * M_PI / 36;
  for (int cycle = 0; cycle < 36; ++cycle) {
    for (int i = 0; i < 10; ++i) {
      const Vec3d to = turned(axis, angle, d.nodes.x[i]);
      d.nodes.v[i] = (1.0 / dt) * (to - d.nodes.x[i]);
      d.nodes.x[i] = to;
    }
    d.cycle(dt);
  }
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(d.state[i], before[i], 1e-8 * (1 + std::abs(before[i])));
  for (int i = 0; i < 10; ++i) EXPECT_LT(norm(d.force.f[i] - start.f[i]), 1e-8 * norm(start.f[4]));
}

TEST(QuadraticTetrahedron, ForcesAreInBalance) {
  Random random;
  Driven<Elastic> d(steel, tetrahedron(random, 0.4, 0.3));
  for (std::size_t i = L::first_point; i < d.state.size(); ++i) d.state[i] = 300.0 * random();
  d.shake(random, 1000.0);
  d.step(1e-7);
  Vec3d force{}, moment{};
  for (int i = 0; i < 10; ++i) {
    force += d.force.f[i];
    moment += cross(d.nodes.x[i], d.force.f[i]);
  }
  EXPECT_LT(norm(force), 1e-10 * norm(d.force.f[4]));
  EXPECT_LT(norm(moment), 1e-9 * norm(d.force.f[4]));
}

/// Strain energy of a field of displacement u = (x y, y z + x^2, x z - y^2) in a straight-sided tetrahedron: its
/// density is a quadratic polynomial, integrated exactly by the monomials' formula over a simplex, integral of (a .
/// x)(b . x) = V / 20 (sum_i (a . x_i)(b . x_i) + (sum_i a . x_i)(sum_i b . x_i)).
double quadratic_energy(const Motion& m) {
  const double G = steel_E / (2 * (1 + steel_nu)), lambda = 2 * G * steel_nu / (1 - 2 * steel_nu);
  const auto strain = [](const Vec3d& p) {  // linear in p
    return std::array<double, 6>{p.y, p.z, p.x, 0.5 * (p.x + 2 * p.x), 0.5 * (p.y - 2 * p.y), 0.5 * p.z};
  };
  const auto product = [&](const std::array<double, 6>& a, const std::array<double, 6>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < 6; ++i) sum += 2 * G * (i < 3 ? 1 : 2) * a[i] * b[i];
    return sum + lambda * (a[0] + a[1] + a[2]) * (b[0] + b[1] + b[2]);
  };
  double sum = 0.0;
  Vec3d all{};
  for (int i = 0; i < 4; ++i) {
    sum += product(strain(m.x[i]), strain(m.x[i]));
    all += m.x[i];
  }
  return 0.5 * tetrahedron_volume({m.x[0], m.x[1], m.x[2], m.x[3]}) / 20 * (sum + product(strain(all), strain(all)));
}

// Sabotage: 4 L_j - 1 as 4 L_j; the nodes 9 and 10 swapped; another weight of a point.
TEST(QuadraticTetrahedron, QuadraticFieldsAreExact) {
  Random random;
  const double dt = 0x1p-60;
  for (int trial = 0; trial < 10; ++trial) {
    Motion m = tetrahedron(random, 1.0);
    for (int i = 0; i < 10; ++i) {
      const Vec3d& p = m.x[i];
      m.v[i] = {p.x * p.y, p.y * p.z + p.x * p.x, p.x * p.z - p.y * p.y};
    }
    Driven<Elastic> d(steel, m);
    d.cycle(dt);
    double power = 0.0;
    for (int i = 0; i < 10; ++i) power += dot(d.force.f[i], m.v[i]);
    EXPECT_NEAR(0.5 * power / dt, quadratic_energy(m), 1e-10 * quadratic_energy(m));
  }
}

// Any linear field on curved edges: constant stress, and forces that do its work.
TEST(QuadraticTetrahedron, LinearFieldsOnCurvedEdges) {
  Random random;
  const double dt = 0x1p-60, K = steel_E / (3 * (1 - 2 * steel_nu));
  Motion m = tetrahedron(random, 0.5, 0.3);
  for (int i = 0; i < 10; ++i) m.v[i] = 0.001 * m.x[i];
  Driven<Elastic> d(steel, m);
  d.cycle(dt);
  double power = 0.0;
  for (int i = 0; i < 10; ++i) power += dot(d.force.f[i], m.v[i]);
  for (int p = 0; p < L::points; ++p) {
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(d.at(d.layout.point(p) + c) / dt, 3 * K * 0.001, 1e-9 * K);
    for (int c = 3; c < 6; ++c) EXPECT_NEAR(d.at(d.layout.point(p) + c) / dt, 0.0, 1e-9 * K);
  }
  const double volume = quadratic_tetrahedron_volume(places(m));
  EXPECT_NEAR(power / dt, 9 * K * 1e-6 * volume, 1e-8 * K * 1e-6 * volume);
}

// A corner of a sphere's ball by its curved faces has no closed form here; a straight element moved by a quadratic map
// with a unit Jacobian, (x, y + x^2 / 10, z), keeps its volume, and the Jacobian is linear there, so exact.
TEST(QuadraticTetrahedron, Volume) {
  Random random;
  Motion m = tetrahedron(random);
  const double straight = tetrahedron_volume({m.x[0], m.x[1], m.x[2], m.x[3]});
  EXPECT_NEAR(quadratic_tetrahedron_volume(places(m)), straight, 1e-12 * straight);
  EXPECT_NEAR(quadratic_tetrahedron_least_volume(places(m)), straight, 1e-12 * straight);
  for (Vec3d& x : m.x) x.y += 0.1 * x.x * x.x;
  EXPECT_NEAR(quadratic_tetrahedron_volume(places(m)), straight, 1e-12 * straight);
  std::swap(m.x[1], m.x[2]);
  put_nodes_amid_edges(m);
  EXPECT_LT(quadratic_tetrahedron_least_volume(places(m)), 0.0);
}

TEST(QuadraticTetrahedron, MeanGradient) {
  Random random;
  const Motion m = tetrahedron(random, 0.5, 0.3);
  Places v;
  for (std::size_t i = 0; i < 10; ++i) v[i] = {2 * m.x[i].y, 3 * m.x[i].z, m.x[i].x - m.x[i].z};
  const auto g = quadratic_tetrahedron_gradient(places(m), v);
  EXPECT_LT(norm(g[0] - Vec3d{0, 2, 0}) + norm(g[1] - Vec3d{0, 0, 3}) + norm(g[2] - Vec3d{1, 0, -1}), 1e-12);
}

std::vector<double> stiffness(const Motion& m) {
  const double dt = 0x1p-100;
  std::vector<double> k(900);
  for (std::size_t j = 0; j < 30; ++j) {
    Motion moved = m;
    for (Vec3d& v : moved.v) v = {};
    (j % 3 == 0 ? moved.v[j / 3].x : j % 3 == 1 ? moved.v[j / 3].y : moved.v[j / 3].z) = 1.0;
    Driven<Elastic> d(steel, moved);
    d.cycle(dt);
    for (std::size_t i = 0; i < 10; ++i) {
      k[(3 * i) * 30 + j] = d.force.f[i].x / dt;
      k[(3 * i + 1) * 30 + j] = d.force.f[i].y / dt;
      k[(3 * i + 2) * 30 + j] = d.force.f[i].z / dt;
    }
  }
  return k;
}

TEST(QuadraticTetrahedron, OnlyRigidMotionsAreFree) {
  Random random;
  const std::vector<double> k = stiffness(tetrahedron(random, 0.4, 0.2));
  double largest = 0.0;
  for (const double v : k) largest = std::max(largest, std::abs(v));
  for (std::size_t i = 0; i < 30; ++i)
    for (std::size_t j = 0; j < 30; ++j) EXPECT_NEAR(k[30 * i + j], k[30 * j + i], 1e-10 * largest);
  EXPECT_EQ(zero_modes(k, 30), 6);
}

/// Diagonal of the consistent mass by L_1^a L_2^b ... over a unit volume: 6 a! b! c! d! / (a + b + c + d + 3)!.
TEST(QuadraticTetrahedron, MassesAreTheScaledDiagonal) {
  const double corner = 6.0 * (4 * 24.0 / 5040 - 4 * 6.0 / 720 + 2.0 / 120);  // of (L (2 L - 1))^2
  const double edge = 6.0 * 16 * 4.0 / 5040;                                  // of (4 L_i L_j)^2
  const double sum = 4 * corner + 6 * edge;
  EXPECT_NEAR(quadratic_tetrahedron_corner_mass, corner / sum, 1e-15);
  EXPECT_NEAR(quadratic_tetrahedron_edge_mass, edge / sum, 1e-15);
}

// No element of any shape vibrates faster than its step allows. Sabotage: `most` of the kernel a fifth of itself.
TEST(QuadraticTetrahedron, StepIsStable) {
  Random random;
  double least = 1e9, most = 0.0;
  for (int trial = 0; trial < 150; ++trial) {
    Motion m = tetrahedron(random, 1.5, trial % 3 == 2 ? 0.25 : 0.0);
    if (trial == 0) {
      const Vec3d regular[4] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
      std::copy_n(regular, 4, m.x);
      put_nodes_amid_edges(m);
    }
    if (!(quadratic_tetrahedron_least_volume(places(m)) > 0.2)) continue;
    const double mass = steel_density * quadratic_tetrahedron_volume(places(m));
    std::vector<double> k = stiffness(m);
    for (std::size_t i = 0; i < 30; ++i)
      for (std::size_t j = 0; j < 30; ++j)
        k[30 * i + j] /= mass * std::sqrt(quadratic_tetrahedron_mass_share(static_cast<int>(i / 3)) *
                                          quadratic_tetrahedron_mass_share(static_cast<int>(j / 3)));
    double fastest = 0.0;
    for (const double v : eigenvalues(k, 30)) fastest = std::max(fastest, v);
    Driven<Elastic> d(steel, m);
    d.cycle(1e-12);
    const double ratio = 2.0 / std::sqrt(fastest) / d.force.stable_step;
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  EXPECT_GE(least, 1.0);
  EXPECT_LT(least, 1.4);
  EXPECT_LT(most, 2.0);
}

TEST(QuadraticTetrahedron, DiesWhenAllItsPointsHaveFailed) {
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.02;
  Random random;
  Motion m = tetrahedron(random);
  for (int i = 0; i < 10; ++i) m.v[i] = {0.0, 0.0, 10.0 * m.x[i].z};
  Driven<PiecewiseLinear> d(failing, m);
  int cycles = 0;
  while (d.at(L::alive) > 0.5 && ++cycles < 1000) d.step(1e-4);
  EXPECT_GT(cycles, 10);
  EXPECT_LT(cycles, 60);
  for (const Vec3d& f : d.force.f) EXPECT_EQ(norm(f), 0.0);
  EXPECT_EQ(d.force.volume, 1.0);
}

}  // namespace
}  // namespace nugget::kernel
