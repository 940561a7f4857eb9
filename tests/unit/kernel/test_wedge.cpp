// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "driven_solid.hpp"
#include "element_stiffness.hpp"
#include "kernel/element/full_hexahedron.hpp"

namespace nugget::kernel {
namespace {

using L = FullHexahedronLayout;
using Corners = std::array<Vec3d, 6>;  // 1 2 3 4 around, the edge 5-6 opposite

Corners distorted(Random& random) {
  Corners x{Vec3d{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {0, 4, 0}, {2, 0, 3}, {2, 4, 3}};
  for (Vec3d& p : x) p += random.vector(0.4);
  return x;
}

/// See driven_solid.hpp.
struct Wedge {
  static constexpr std::size_t corners = 6;
  using Layout = L;
  template <class R>
  using Motion = WedgeMotion<R>;
  template <class R>
  using Forces = WedgeForces<R>;
  template <class Law>
  static L layout(const LawKernel<Law>& law) {
    return full_hexahedron_layout(law);
  }
  static void start(const L& layout, const Corners&, double* state) { start_full_hexahedron(layout, state, 1, 0); }
  template <class R, class Law>
  static Forces<R> cycle(const HexahedronProperties& brick, const LawKernel<Law>& law, const L&, const Motion<R>& nodes,
                         double dt, double* state) {
    return wedge_cycle<R>(brick, law, nodes, dt, state);
  }
  static int plastic_strain(const L& layout) { return layout.history_of(0); }
};
template <class Law>
using Driven = DrivenSolid<Wedge, Law>;

double volume(const Corners& x) {
  return hexahedron_volume(brick_of_wedge(x.data()));
}

TEST(Wedge, BatchGivesTheBitsOfEachAlone) {
  batch_gives_the_bits_of_each_alone<Wedge>(
      inviscid_solid(), mixed(0.3), [](Random& r) { return distorted(r); }, 1);
}

TEST(Wedge, Patch) {
  Random random;
  Driven<Elastic> d(inviscid_solid(), steel, distorted(random));
  for (Vec3d& v : d.nodes.v) {
    const Vec3d& x = d.nodes.x[&v - d.nodes.v];
    v = 1e-6 * Vec3d{x.x + 0.5 * x.y, x.y + 0.5 * x.x - 0.2 * x.z, 0.3 * x.z - 0.2 * x.y};
  }
  d.step(1e-3);
  const double lambda = steel_E * steel_nu / (1.3 * 0.4), G = steel_E / 2.6, unit_strain = 1e-9;
  for (int p = 0; p < L::points; ++p) {
    const int s = d.layout.point(p);
    EXPECT_NEAR(d.at(s), (2.3 * lambda + 2 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 3), G * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 4), -0.4 * G * unit_strain, 1e-12);
  }
}

// Sabotage to be caught: weights that do not add up to the volume.
TEST(Wedge, ConstantStressIsPassedOnExactly) {
  Random random;
  const Corners x = distorted(random);
  Driven<Elastic> d(inviscid_solid(), steel, x);
  for (int p = 0; p < L::points; ++p)
    for (int i = 0; i < 3; ++i) d.state[d.layout.point(p) + i] = 1.0;
  d.step(0.0);
  for (std::size_t i = 0; i < 6; ++i)
    for (double Vec3d::*c : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
      Corners up = x, down = x;
      up[i].*c += 1e-4;
      down[i].*c -= 1e-4;
      EXPECT_NEAR(d.force.f[i].*c, (volume(up) - volume(down)) / 2e-4, 1e-8);
    }
}

TEST(Wedge, RigidRotationStrainsNothing) {
  Random random;
  Driven<PlasticKinematic> d(inviscid_solid(), mixed(0.5), distorted(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(40000.0);
    d.step(1e-7);
  }
  ASSERT_GT(d.at(d.layout.history_of(0)), 0.0);
  expect_that_a_turn_strains_nothing(d, 1e-7);
}

// Sabotage to be caught: the middle of the triangles as the only point on each level, which leaves torsion free.
TEST(Wedge, OnlyRigidMotionIsFree) {
  Random random;
  const Corners x = distorted(random);
  WedgeMotion<double> rest;
  std::copy(x.begin(), x.end(), rest.x);
  const std::vector<double> K = element_stiffness(rest, [&](const WedgeMotion<double>& motion, double step) {
    Driven<Elastic> d(inviscid_solid(), steel, x);
    return one_element(motion, d.state, [&](const auto& all, double* store) {
      return wedge_cycle(d.properties, d.law, all, step, store);
    });
  });
  EXPECT_EQ(zero_modes(K, 18), 6);
}

/// Forces, by the corners of the first numbering, of a wedge that flows. `number`: which corner has the number i;
/// `mirrored`: the wedge behind a mirror.
Corners forces_by(const std::array<std::size_t, 6>& number, bool mirrored) {
  Random random;
  const Corners x = distorted(random);
  const auto place = [&](const Vec3d& v) { return mirrored ? Vec3d{-v.x, v.y, v.z} : v; };
  Corners numbered;
  for (std::size_t i = 0; i < 6; ++i) numbered[i] = place(x[number[i]]);
  Driven<PlasticKinematic> d(inviscid_solid(), mixed(0.3), numbered);
  for (int cycle = 0; cycle < 20; ++cycle) {
    Corners v;
    for (Vec3d& a : v) a = random.vector(40000.0);
    for (std::size_t i = 0; i < 6; ++i) d.nodes.v[i] = place(v[number[i]]);
    d.step(1e-7);
  }
  EXPECT_GT(d.at(d.layout.history_of(0)), 0.0);
  Corners f;
  for (std::size_t i = 0; i < 6; ++i) f[number[i]] = place(d.force.f[i]);
  return f;
}

// Triangles 1 2 5 and 4 3 6. Sabotage to be caught: the points of a brick that is collapsed.
TEST(Wedge, NoCornerDiffersFromTheOthers) {
  const Corners first = forces_by({0, 1, 2, 3, 4, 5}, false);
  double most = 0.0;
  for (const Vec3d& a : first) most = std::max(most, norm(a));
  const auto expect_same = [&](const std::array<std::size_t, 6>& number, bool mirrored) {
    const Corners f = forces_by(number, mirrored);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(norm(f[i] - first[i]), 0.0, 1e-10 * most);
  };
  expect_same({1, 4, 5, 2, 0, 3}, false);
  expect_same({4, 0, 3, 5, 1, 2}, false);
  expect_same({2, 3, 0, 1, 5, 4}, false);  // upside down
  expect_same({1, 0, 3, 2, 4, 5}, true);
  expect_same({3, 2, 1, 0, 5, 4}, true);
}

}  // namespace
}  // namespace nugget::kernel
