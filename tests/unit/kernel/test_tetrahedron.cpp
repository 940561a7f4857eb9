// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "driven_solid.hpp"
#include "kernel/element/tetrahedron.hpp"

namespace nugget::kernel {
namespace {

using L = TetrahedronLayout;
using Corners = std::array<Vec3d, 4>;

Corners distorted(Random& random, double size = 0.4) {
  Corners x{Vec3d{0, 0, 0}, {5, 0, 0}, {0, 4, 0}, {1, 1, 3}};
  for (Vec3d& p : x) p += random.vector(size);
  return x;
}

const Corners regular{Vec3d{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

/// See driven_solid.hpp.
struct Tetrahedron {
  static constexpr std::size_t corners = 4;
  using Layout = L;
  template <class R>
  using Motion = TetrahedronMotion<R>;
  template <class R>
  using Forces = TetrahedronForces<R>;
  template <class Law>
  static L layout(const LawKernel<Law>& law) {
    return tetrahedron_layout(law);
  }
  static void start(const L& layout, const Corners&, double* state) { start_tetrahedron(layout, state, 1, 0); }
  template <class R, class Law>
  static Forces<R> cycle(const HexahedronProperties& solid, const LawKernel<Law>& law, const L& layout,
                         const Motion<R>& nodes, double dt, double* state) {
    return tetrahedron_cycle<R>(solid, law, layout, nodes, dt, state);
  }
  static int plastic_strain(const L&) { return L::first_history; }
};
template <class Law>
using Driven = DrivenSolid<Tetrahedron, Law>;

TEST(Tetrahedron, BatchGivesTheBitsOfEachAlone) {
  HexahedronProperties viscous = inviscid_solid();
  viscous.bulk_linear = 0.06;
  viscous.bulk_quadratic = 1.5;
  PiecewiseLinear law = curved();
  law.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone<Tetrahedron>(
      viscous, law, [](Random& r) { return distorted(r); }, 1);
}

// The mean stress is what the state says (ELFORM 13), the deviator the law's. Sabotage: the mean added to the law's
// own.
TEST(Tetrahedron, MeanStressFromOutside) {
  Random random;
  const Corners x = distorted(random);
  Driven<PiecewiseLinear> own(inviscid_solid(), bilinear(250, 0), x), given(own);
  given.layout.nodal_pressure = true;
  given.state.push_back(0.0);
  for (int cycle = 0; cycle < 100; ++cycle) {
    given.state.back() = 10.0 * cycle;
    for (std::size_t i = 0; i < 4; ++i) own.nodes.v[i] = given.nodes.v[i] = random.vector(40000.0);
    own.step(1e-7);
    given.step(1e-7);
  }
  const double mean = (own.at(L::stress) + own.at(L::stress + 1) + own.at(L::stress + 2)) / 3.0;
  ASSERT_GT(own.at(L::first_history), 0.0);
  EXPECT_NEAR(given.at(L::first_history), own.at(L::first_history), 1e-12);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(given.at(L::stress + i), own.at(L::stress + i) + (i < 3 ? 990.0 - mean : 0.0), 1e-8);
}

TEST(Tetrahedron, LinearFieldGivesItsStress) {
  Random random;
  Driven<Elastic> d(inviscid_solid(), steel, distorted(random));
  for (Vec3d& v : d.nodes.v) {
    const Vec3d& x = d.nodes.x[&v - d.nodes.v];
    v = 1e-6 * Vec3d{x.x + 0.5 * x.y, x.y + 0.5 * x.x - 0.2 * x.z, 0.3 * x.z - 0.2 * x.y};
  }
  d.step(1e-3);
  const double lambda = steel_E * steel_nu / (1.3 * 0.4), G = steel_E / 2.6, unit_strain = 1e-9;
  EXPECT_NEAR(d.at(L::stress), (2.3 * lambda + 2 * G) * unit_strain, 1e-12);
  EXPECT_NEAR(d.at(L::stress + 2), (2.3 * lambda + 0.6 * G) * unit_strain, 1e-12);
  EXPECT_NEAR(d.at(L::stress + 3), G * unit_strain, 1e-12);
  EXPECT_NEAR(d.at(L::stress + 4), -0.4 * G * unit_strain, 1e-12);
}

TEST(Tetrahedron, UnitPressureGivesTheGradientOfTheVolume) {
  Random random;
  const Corners x = distorted(random);
  Driven<Elastic> d(inviscid_solid(), steel, x);
  for (std::size_t i = 0; i < 3; ++i) d.state[L::stress + i] = 1.0;
  d.step(0.0);
  for (std::size_t i = 0; i < 4; ++i)
    for (double Vec3d::*c : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
      Corners up = x, down = x;
      up[i].*c += 1e-4;
      down[i].*c -= 1e-4;
      EXPECT_NEAR(d.force.f[i].*c, (tetrahedron_volume(up) - tetrahedron_volume(down)) / 2e-4, 1e-8);
    }
  EXPECT_NEAR(d.force.volume, tetrahedron_volume(x), 1e-12);
}

TEST(Tetrahedron, RigidRotationStrainsNothing) {
  Random random;
  const double dt = 1e-7;
  Driven<PlasticKinematic> d(inviscid_solid(), mixed(0.5), distorted(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(40000.0);
    d.step(dt);
  }
  ASSERT_GT(d.at(L::first_history), 0.0);
  expect_that_a_turn_strains_nothing(d, dt);
}

/// Highest frequency of a tetrahedron alone, a quarter of its mass at each node, by power iteration on its forces.
double highest_frequency(const Corners& x) {
  const double dt = 0x1p-100, node_mass = 0.25 * steel_density * tetrahedron_volume(x);
  std::array<Vec3d, 4> u{Vec3d{1, 2, 3}, {-2, 1, 0.5}, {0.3, -1, 2}, {1, 1, -4}};
  double omega2 = 0.0;
  for (int k = 0; k < 3000; ++k) {
    Driven<Elastic> d(inviscid_solid(), steel, x);
    for (std::size_t i = 0; i < 4; ++i) d.nodes.v[i] = u[i];
    d.step(dt);
    double length = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      u[i] = (1.0 / (dt * node_mass)) * d.force.f[i];
      length += dot(u[i], u[i]);
    }
    omega2 = std::sqrt(length);
    for (Vec3d& a : u) a = (1.0 / omega2) * a;
  }
  return std::sqrt(omega2);
}

TEST(Tetrahedron, StableStepIsOnTheSafeSideAndNear) {
  Random random;
  const auto ratio = [](const Corners& x) {
    Driven<Elastic> d(inviscid_solid(), steel, x);
    return d.step(0.0).stable_step * highest_frequency(x) / 2.0;
  };
  // The bound is exact for the regular one but for the norm that stands in for the eigenvalue, 3^(1/16).
  EXPECT_NEAR(ratio(regular), std::pow(3.0, -1.0 / 32.0), 1e-6);
  for (int k = 0; k < 10; ++k) {
    const double share = ratio(distorted(random, 1.0));
    EXPECT_LE(share, 1.0 + 1e-9);
    EXPECT_GE(share, 0.6);
  }
}

TEST(Tetrahedron, FailedOneIsDeleted) {
  PiecewiseLinear law = bilinear(250, 0);
  law.failure_strain = 0.02;
  Driven<PiecewiseLinear> d(inviscid_solid(), law, regular);
  int cycle = 0;
  for (; cycle < 5000 && d.at(L::alive) > 0.5; ++cycle) {
    d.nodes.v[3].z = 1000.0;
    d.step(1e-7);
  }
  EXPECT_GT(cycle, 10);
  EXPECT_LT(cycle, 5000);
  EXPECT_EQ(largest(d.force), 0.0);
  EXPECT_TRUE(std::isinf(d.force.stable_step));
}

}  // namespace
}  // namespace nugget::kernel
