// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "driven_solid.hpp"
#include "element_stiffness.hpp"
#include "kernel/element/full_hexahedron.hpp"

namespace nugget::kernel {
namespace {

using L = FullHexahedronLayout;
using Corners = std::array<Vec3d, 8>;

Corners distorted(Random& random, double size = 0.4) {
  Corners x{Vec3d{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {0, 4, 0}, {0, 0, 3}, {5, 0, 3}, {5, 4, 3}, {0, 4, 3}};
  for (Vec3d& p : x) p += random.vector(size);
  return x;
}

constexpr BrickStrains own = BrickStrains::shape_functions, assumed = BrickStrains::assumed,
                       enhanced = BrickStrains::enhanced;

/// See driven_solid.hpp.
template <BrickStrains strains>
struct FullBrick {
  static constexpr std::size_t corners = 8;
  using Layout = L;
  template <class R>
  using Motion = SolidMotion<R>;
  template <class R>
  using Forces = SolidForces<R>;
  template <class Law>
  static L layout(const LawKernel<Law>& law) {
    return full_hexahedron_layout(law);
  }
  static void start(const L& layout, const Corners&, double* state) { start_full_hexahedron(layout, state, 1, 0); }
  template <class R, class Law>
  static Forces<R> cycle(const HexahedronProperties& brick, const LawKernel<Law>& law, const L&, const Motion<R>& nodes,
                         double dt, double* state) {
    return full_hexahedron_cycle<R>(brick, strains, law, nodes, dt, state);
  }
  static int plastic_strain(const L& layout) { return layout.history_of(0); }
};
template <class Law, BrickStrains strains = own>
using Driven = DrivenSolid<FullBrick<strains>, Law>;

template <class Solid>
double pressure(const Solid& d, int p) {
  const int s = d.layout.point(p);
  return (d.at(s) + d.at(s + 1) + d.at(s + 2)) / 3.0;
}

template <BrickStrains strains = own, class Law>
void batch_gives_the_bits_of_each_alone(const HexahedronProperties& properties, const Law& parameters) {
  batch_gives_the_bits_of_each_alone<FullBrick<strains>>(
      properties, parameters, [](Random& r) { return distorted(r); }, 1);
}

TEST(FullHexahedron, BatchGivesTheBitsOfEachAlone) {
  HexahedronProperties viscous = inviscid_solid();
  viscous.bulk_linear = 0.06;
  viscous.bulk_quadratic = 1.5;
  batch_gives_the_bits_of_each_alone(viscous, steel);
  batch_gives_the_bits_of_each_alone(viscous, mixed(0.3));
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone(inviscid_solid(), failing);
  batch_gives_the_bits_of_each_alone<assumed>(inviscid_solid(), mixed(0.3));
  batch_gives_the_bits_of_each_alone<enhanced>(inviscid_solid(), mixed(0.3));
}

template <BrickStrains strains>
void patch() {
  Random random;
  Driven<Elastic, strains> d(inviscid_solid(), steel, distorted(random));
  for (Vec3d& v : d.nodes.v) {
    const Vec3d& x = d.nodes.x[&v - d.nodes.v];
    v = 1e-6 * Vec3d{x.x + 0.5 * x.y, x.y + 0.5 * x.x - 0.2 * x.z, 0.3 * x.z - 0.2 * x.y};
  }
  d.step(1e-3);
  const double lambda = steel_E * steel_nu / (1.3 * 0.4), G = steel_E / 2.6, unit_strain = 1e-9;
  for (int p = 0; p < L::points; ++p) {
    const int s = d.layout.point(p);
    EXPECT_NEAR(d.at(s), (2.3 * lambda + 2 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 2), (2.3 * lambda + 0.6 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 3), G * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 4), -0.4 * G * unit_strain, 1e-12);
  }
}

TEST(FullHexahedron, Patch) {
  patch<own>();
  patch<assumed>();
  patch<enhanced>();
}

/// Of the points of 2 x 2 x 2 Gauss integration, each of weight 1.
double least_jacobian(const Corners& x) {
  constexpr std::array<std::array<double, 3>, 8> corner{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
  double least = std::numeric_limits<double>::infinity();
  for (const auto& point : corner) {
    std::array<Vec3d, 3> side;  // dx/dxi, dx/deta, dx/dzeta
    for (std::size_t a = 0; a < 8; ++a)
      for (std::size_t i = 0; i < 3; ++i) {
        double slope = 0.125 * corner[a][i];
        for (std::size_t j = 0; j < 3; ++j)
          if (j != i) slope *= 1.0 + corner[a][j] * point[j] / std::sqrt(3.0);
        side[i] += slope * x[a];
      }
    least = std::min(least, dot(side[0], cross(side[1], side[2])));
  }
  return least;
}

template <BrickStrains strains>
void constant_stress_is_passed_on_exactly() {
  // A unit mean stress gives dV/dx, as in every brick; so neighbours of any shape balance.
  Random random;
  const Corners x = distorted(random);
  Driven<Elastic, strains> d(inviscid_solid(), steel, x);
  for (int p = 0; p < L::points; ++p)
    for (int i = 0; i < 3; ++i) d.state[d.layout.point(p) + i] = 1.0;
  d.step(0.0);
  for (std::size_t i = 0; i < 8; ++i)
    for (double Vec3d::*c : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
      Corners up = x, down = x;
      up[i].*c += 1e-4;
      down[i].*c -= 1e-4;
      EXPECT_NEAR(d.force.f[i].*c, (hexahedron_volume(up) - hexahedron_volume(down)) / 2e-4, 1e-8);
    }
  EXPECT_NEAR(d.force.volume, strains == assumed ? hexahedron_volume(x) / 8.0 : least_jacobian(x), 1e-12);
}

TEST(FullHexahedron, ConstantStressIsPassedOnExactly) {
  constant_stress_is_passed_on_exactly<own>();
  constant_stress_is_passed_on_exactly<assumed>();
  constant_stress_is_passed_on_exactly<enhanced>();
}

template <BrickStrains strains>
void one_pressure() {
  Random random;
  Driven<PiecewiseLinear, strains> d(inviscid_solid(), curved(), distorted(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(20000.0);
    d.step(1e-7);
  }
  EXPECT_GT(std::abs(pressure(d, 0)), 10.0);
  for (int p = 1; p < L::points; ++p) EXPECT_NEAR(pressure(d, p), pressure(d, 0), 1e-9 * std::abs(pressure(d, 0)));
}

TEST(FullHexahedron, OnePressure) {
  one_pressure<own>();
  one_pressure<assumed>();
}

template <BrickStrains strains>
void rigid_rotation_strains_nothing() {
  Random random;
  const double dt = 1e-7;
  Driven<PlasticKinematic, strains> d(inviscid_solid(), mixed(0.5), distorted(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(40000.0);
    d.step(dt);
  }
  ASSERT_GT(d.at(d.layout.history_of(0)), 0.0);
  expect_that_a_turn_strains_nothing(d, dt);
}

TEST(FullHexahedron, RigidRotationStrainsNothing) {
  rigid_rotation_strains_nothing<own>();
  rigid_rotation_strains_nothing<assumed>();
  rigid_rotation_strains_nothing<enhanced>();
}

template <BrickStrains strains>
std::vector<double> stiffness(const Corners& x) {
  SolidMotion<double> rest;
  std::copy(x.begin(), x.end(), rest.x);
  return element_stiffness(rest, [&](const SolidMotion<double>& motion, double step) {
    Driven<Elastic, strains> d(inviscid_solid(), steel, x);
    return one_element(motion, d.state, [&](const auto& all, double* store) {
      return full_hexahedron_cycle(d.properties, strains, d.law, all, step, store);
    });
  });
}

template <BrickStrains strains>
void only_rigid_motion_is_free() {
  Random random;
  const std::vector<double> K = stiffness<strains>(distorted(random));
  double most = 0.0;
  for (double k : K) most = std::max(most, std::abs(k));
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) EXPECT_NEAR(K[i * 24 + j], K[j * 24 + i], 1e-12 * most);
  EXPECT_EQ(zero_modes(K, 24), 6);
}

TEST(FullHexahedron, OnlyRigidMotionIsFree) {
  only_rigid_motion_is_free<own>();
  only_rigid_motion_is_free<assumed>();
  only_rigid_motion_is_free<enhanced>();
}

/// A numbering of a brick's corners: its first, second and third directions are those of `axis`, the first along the
/// way of `sign`. In one of two the directions are left-handed.
struct Numbering {
  std::array<std::size_t, 3> axis{0, 1, 2};
  std::array<int, 3> sign{1, 1, 1};

  bool left_handed() const {
    const bool swapped = (axis[1] + 3 - axis[0]) % 3 != 1;
    return swapped != (sign[0] * sign[1] * sign[2] < 0);
  }
  /// The corner that has the number i.
  std::size_t operator()(std::size_t i) const {
    constexpr std::array<std::array<int, 3>, 8> corner{
        {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}};
    std::array<int, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) at[axis[k]] = sign[k] * corner[i][k];
    return static_cast<std::size_t>(std::find(corner.begin(), corner.end(), at) - corner.begin());
  }
};

std::vector<Numbering> numberings() {
  std::vector<Numbering> all;
  Numbering n;
  do
    for (int k = 0; k < 8; ++k) {
      n.sign = {k & 1 ? -1 : 1, k & 2 ? -1 : 1, k & 4 ? -1 : 1};
      all.push_back(n);
    }
  while (std::next_permutation(n.axis.begin(), n.axis.end()));
  return all;
}

/// Forces of a skewed, warped brick that flows, by the corners of the first numbering. A left-handed numbering is that
/// of the brick behind a mirror.
template <BrickStrains strains>
std::array<Vec3d, 8> forces_by(const Numbering& number) {
  Random random;
  Corners x = distorted(random);
  for (Vec3d& p : x) p += Vec3d{0.3 * p.y - 0.2 * p.z, 0.25 * p.z, 0.0};
  const auto place = [&](Vec3d v) { return number.left_handed() ? Vec3d{-v.x, v.y, v.z} : v; };
  Corners numbered;
  for (std::size_t i = 0; i < 8; ++i) numbered[i] = place(x[number(i)]);
  Driven<PlasticKinematic, strains> d(inviscid_solid(), mixed(0.3), numbered);
  for (int cycle = 0; cycle < 20; ++cycle) {
    std::array<Vec3d, 8> v;
    for (Vec3d& a : v) a = random.vector(40000.0);
    for (std::size_t i = 0; i < 8; ++i) d.nodes.v[i] = place(v[number(i)]);
    d.step(1e-7);
  }
  EXPECT_GT(d.at(d.layout.history_of(0)), 0.0);
  std::array<Vec3d, 8> f;
  for (std::size_t i = 0; i < 8; ++i) f[number(i)] = place(d.force.f[i]);
  return f;
}

template <BrickStrains strains>
void the_numbering_does_not_matter() {
  const std::array<Vec3d, 8> first = forces_by<strains>({});
  double most = 0.0;
  for (const Vec3d& a : first) most = std::max(most, norm(a));
  const std::vector<Numbering> all = numberings();
  ASSERT_EQ(all.size(), 48U);
  for (const Numbering& number : all) {
    const std::array<Vec3d, 8> f = forces_by<strains>(number);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(norm(f[i] - first[i]), 0.0, 1e-10 * most);
  }
}

// Sabotage to be caught: strains by axes at right angles that begin with the first direction (decision 0169).
TEST(FullHexahedron, TheNumberingDoesNotMatter) {
  the_numbering_does_not_matter<own>();
  the_numbering_does_not_matter<assumed>();
  the_numbering_does_not_matter<enhanced>();
}

/// Moment over that of a plastic hinge of a wide plate, 2/sqrt(3) SIGY b h^2/4, when one brick through the thickness is
/// bent in its plane to ten times the curvature at yield; 20 x 20 x 2.
template <BrickStrains strains>
double plate_moment() {
  const double a = 10.0, h = 1.0, dt = 1e-7, yield = 250.0;
  Corners x{Vec3d{-a, -a, -h}, {a, -a, -h}, {a, a, -h}, {-a, a, -h}, {-a, -a, h}, {a, -a, h}, {a, a, h}, {-a, a, h}};
  Driven<PlasticKinematic, strains> d(inviscid_solid(),
                                      PlasticKinematic{steel_E, steel_nu, yield, 0.0, 1.0, 0.0, 0.0, 0.0}, x);
  const double last = 10.0 * yield / steel_E;  // strain of the faces
  const int cycles = 2000;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (std::size_t i = 0; i < 8; ++i) d.nodes.v[i] = {last / (cycles * dt) * x[i].x * x[i].z / h, 0.0, 0.0};
    d.step(dt);
  }
  double moment = 0.0;
  for (std::size_t i = 0; i < 8; ++i)
    if (x[i].x > 0.0) moment += d.force.f[i].x * x[i].z;
  return moment / (2.0 / std::sqrt(3.0) * yield * (2.0 * a) * h * h);
}

// Sabotage to be caught: the dilatation of the assumed strains kept, or no thinning.
TEST(FullHexahedron, AssumedStrainsLockNeitherInShearNorInFlow) {
  EXPECT_NEAR(plate_moment<assumed>(), 1.0, 0.05);
  EXPECT_GT(plate_moment<own>(), 5.0);  // the parasitic shear of a side of 10:1
}

TEST(FullHexahedron, FailedBrickIsDeleted) {
  PiecewiseLinear law = bilinear(250, 0);
  law.failure_strain = 0.02;
  Random random;
  Driven<PiecewiseLinear> d(inviscid_solid(), law, distorted(random, 0.1));
  int cycle = 0;
  bool partly = false;
  for (; cycle < 5000 && d.at(L::alive) > 0.5; ++cycle) {
    for (int i = 4; i < 8; ++i) d.nodes.v[i].x = 1000.0 + 100.0 * d.nodes.x[i].y;
    d.step(1e-7);
    for (int p = 0; p < L::points; ++p) partly = partly || d.at(d.layout.history_of(p)) >= 0.02;
    if (cycle == 10) {
      EXPECT_GT(largest(d.force), 0.0);
    }
  }
  EXPECT_TRUE(partly);
  EXPECT_LT(cycle, 5000);
  EXPECT_EQ(largest(d.force), 0.0);
  EXPECT_TRUE(std::isinf(d.force.stable_step));
}

}  // namespace
}  // namespace nugget::kernel
