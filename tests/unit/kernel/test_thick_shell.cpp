// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/thick_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "driven_solid.hpp"
#include "element_stiffness.hpp"
#include "kernel/law/law_components.hpp"

namespace nugget::kernel {
namespace {

using L = ThickShellLayout;
using Corners = std::array<Vec3d, 8>;

Corners block(double a, double b, double t) {
  return {Vec3d{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, t}, {a, 0, t}, {a, b, t}, {0, b, t}};
}
Corners distorted(Random& random, double size = 0.4) {
  Corners x = block(5, 4, 3);
  for (Vec3d& p : x) p += random.vector(size);
  return x;
}

HexahedronProperties inviscid() {
  HexahedronProperties b;
  b.density = steel_density;
  b.hourglass = 6;
  b.hourglass_coefficient = 1.0;
  b.bulk_linear = b.bulk_quadratic = 0.0;
  return b;
}

ThickShellProperties with_layers(const HexahedronProperties& brick, const LayerRule& layers, bool parabolic,
                                 bool full) {
  return {brick, layers, shear_by_layer(layers, parabolic, parabolic ? 5.0 / 6.0 : 1.0), full};
}

/// See driven_solid.hpp. `full`: ELFORM 3.
template <int layers, bool parabolic, bool full>
struct ThickShell {
  static constexpr std::size_t corners = 8;
  using Layout = L;
  template <class R>
  using Motion = SolidMotion<R>;
  template <class R>
  using Forces = SolidForces<R>;
  template <class Law>
  static L layout(const LawKernel<Law>& law) {
    return {layers, law.solid_history(), full ? 4 : 1};
  }
  static void start(const L& layout, const Corners&, double* state) { start_thick_shell(layout, state, 1, 0); }
  template <class R, class Law>
  static Forces<R> cycle(const HexahedronProperties& brick, const LawKernel<Law>& law, const L&, const Motion<R>& nodes,
                         double dt, double* state) {
    return thick_shell_cycle<R>(with_layers(brick, gauss_layers(layers), parabolic, full), law, nodes, dt, state);
  }
  static int plastic_strain(const L& layout) { return layout.history_of(0); }
};
template <class Law, int layers = 3, bool parabolic = false, bool full = false>
using Driven = DrivenSolid<ThickShell<layers, parabolic, full>, Law>;

template <class Law>
void batch_gives_the_bits(const HexahedronProperties& properties, const Law& parameters) {
  batch_gives_the_bits_of_each_alone<ThickShell<3, true, false>>(
      properties, parameters, [](Random& r) { return distorted(r); }, 1);
  batch_gives_the_bits_of_each_alone<ThickShell<3, true, true>>(
      properties, parameters, [](Random& r) { return distorted(r); }, 1);
}

TEST(ThickShell, BatchGivesTheBitsOfEachAlone) {
  HexahedronProperties viscous = inviscid();
  viscous.bulk_linear = 0.06;
  viscous.bulk_quadratic = 1.5;
  batch_gives_the_bits(viscous, steel);
  batch_gives_the_bits(viscous, mixed(0.3));
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits(inviscid(), failing);
}

TEST(ThickShell, ShearOfLayers) {
  for (const int count : {2, 3, 5, 10})
    for (const bool parabolic : {false, true}) {
      const LayerRule rule = gauss_layers(count);
      const auto shear = shear_by_layer(rule, parabolic, 5.0 / 6.0);
      double stiffness = 0.0, mean = 0.0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        stiffness += rule.weight[k] * shear[k] * shear[k];
        mean += rule.weight[k] * shear[k];
      }
      EXPECT_NEAR(stiffness, 5.0 / 6.0, 1e-14);
      // A parabola 5/4 (1 - zeta^2) has the mean 5/6, and its greatest value 3/2 of it.
      if (parabolic && count >= 3) {
        EXPECT_NEAR(mean, 5.0 / 6.0, 1e-14);
      }
    }
  // Two layers on the faces: the parabola is zero in both.
  const LayerRule faces = equally_spaced_layers(2);
  EXPECT_EQ(shear_by_layer(faces, true, 1.0)[0], 1.0);
}

template <bool full>
void patch() {
  Random random;
  Driven<Elastic, 3, false, full> d(inviscid(), steel, distorted(random));
  for (Vec3d& v : d.nodes.v) {
    const Vec3d& x = d.nodes.x[&v - d.nodes.v];
    v = 1e-6 * Vec3d{x.x + 0.5 * x.y, x.y + 0.5 * x.x - 0.2 * x.z, 0.3 * x.z - 0.2 * x.y};
  }
  d.step(1e-3);
  const double lambda = steel_E * steel_nu / (1.3 * 0.4), G = steel_E / 2.6, unit_strain = 1e-9;
  for (int k = 0; k < 3 * d.layout.columns; ++k) {
    const int s = d.layout.layer(k / d.layout.columns, k % d.layout.columns);
    EXPECT_NEAR(d.at(s), (2.3 * lambda + 2 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 2), (2.3 * lambda + 0.6 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 3), G * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(s + 4), -0.4 * G * unit_strain, 1e-12);
  }
}
TEST(ThickShell, Patch) {
  patch<false>();
  patch<true>();
}

template <bool full>
void constant_stress_is_passed_on() {
  Random random;
  const Corners x = distorted(random);
  Driven<Elastic, 3, false, full> d(inviscid(), steel, x);
  for (int k = 0; k < 3; ++k)
    for (int c = 0; c < d.layout.columns; ++c)
      for (int i = 0; i < 3; ++i) d.state[static_cast<std::size_t>(d.layout.layer(k, c) + i)] = 1.0;
  d.step(0.0);
  for (std::size_t i = 0; i < 8; ++i)
    for (double Vec3d::*c : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
      Corners up = x, down = x;
      up[i].*c += 1e-4;
      down[i].*c -= 1e-4;
      EXPECT_NEAR(d.force.f[i].*c, (hexahedron_volume(up) - hexahedron_volume(down)) / 2e-4, 1e-8);
    }
}
TEST(ThickShell, ConstantStressIsPassedOnExactly) {
  constant_stress_is_passed_on<false>();
  constant_stress_is_passed_on<true>();
}

template <bool parabolic, bool full>
std::vector<double> stiffness(const Corners& x) {
  SolidMotion<double> rest;
  std::copy(x.begin(), x.end(), rest.x);
  return element_stiffness(rest, [&](const SolidMotion<double>& motion, double step) {
    Driven<Elastic, 3, parabolic, full> d(inviscid(), steel, x);
    return one_element(motion, d.state, [&](const auto& all, double* store) {
      return ThickShell<3, parabolic, full>::cycle(d.properties, d.law, d.layout, all, step, store);
    });
  });
}

template <bool full>
void only_rigid_motion_is_free() {
  Random random;
  const Corners brick = distorted(random);
  Corners wedge = brick;
  wedge[3] = wedge[2];
  wedge[7] = wedge[6];
  const std::vector<double> K = stiffness<true, full>(brick);
  double most = 0.0;
  for (const double k : K) most = std::max(most, std::abs(k));
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) EXPECT_NEAR(K[i * 24 + j], K[j * 24 + i], 1e-12 * most);
  EXPECT_EQ(zero_modes(K, 24), 6);

  // Of a wedge the freedoms of two pairs of nodes are one.
  const std::vector<double> all = stiffness<true, full>(wedge);
  constexpr std::array<std::size_t, 8> own{0, 1, 2, 2, 3, 4, 5, 5};
  std::vector<double> six(18 * 18, 0.0);
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) six[(3 * own[i / 3] + i % 3) * 18 + 3 * own[j / 3] + j % 3] += all[i * 24 + j];
  EXPECT_EQ(zero_modes(six, 18), 6);
}
TEST(ThickShell, OnlyRigidMotionIsFree) {
  only_rigid_motion_is_free<false>();
  only_rigid_motion_is_free<true>();
}

/// Two steps of random velocities: the thick shell of layers without a shear of their own is the brick of physical
/// stabilisation, whose bending through the thickness is that of a plate.
template <bool full>
void elastic_layers_are_the_stabilised_brick() {
  Random random;
  Corners x = block(5, 4, 0.5);
  for (Vec3d& p : x) p += 0.3 * Vec3d{random(), random(), 0.0};  // a skew plate of one thickness
  Driven<Elastic, 3, false, full> d(inviscid(), steel, x);
  const LawKernel<Elastic> law(steel);
  const HexahedronLayout layout = hexahedron_layout(law);
  std::vector<double> state(static_cast<std::size_t>(layout.size()));
  start_hexahedron(layout, x, state.data(), 1, 0);
  for (int cycle = 0; cycle < 2; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(1e-3);
    d.step(1e-7);
    const auto brick = one_element(d.nodes, state, [&](const auto& all, double* store) {
      return hexahedron_cycle(inviscid(), law, all, 1e-7, store);
    });
    EXPECT_EQ(brick.stable_step, d.force.stable_step);
    for (std::size_t i = 0; i < 8; ++i) EXPECT_LT(norm(brick.f[i] - d.force.f[i]), 1e-9 * largest(brick));
  }
}
TEST(ThickShell, ElasticLayersAreTheStabilisedBrick) {
  elastic_layers_are_the_stabilised_brick<false>();
  elastic_layers_are_the_stabilised_brick<true>();
}

/// Moment of a strip 2a x 2a x 2h whose faces are stretched and shortened by `last` along x, the other way held.
template <bool full>
double moment(const PlasticKinematic& law, double last) {
  const double a = 10.0, h = 1.0, dt = 1e-7;
  const Corners x{Vec3d{-a, -a, -h}, {a, -a, -h}, {a, a, -h}, {-a, a, -h},
                  {-a, -a, h},       {a, -a, h},  {a, a, h},  {-a, a, h}};
  Driven<PlasticKinematic, 10, false, full> d(inviscid(), law, x);
  const int cycles = 2000;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (std::size_t i = 0; i < 8; ++i) d.nodes.v[i] = {last / (cycles * dt) * x[i].x * x[i].z / h, 0.0, 0.0};
    d.step(dt);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i)
    if (x[i].x > 0.0) sum += d.force.f[i].x * x[i].z;
  return sum;
}

// Sabotage to be caught: no relief of the stress across (the thickness then locks in flow: 3.3 times the hinge), no
// thinning.
template <bool full>
void bends_as_a_plate() {
  const double b = 20.0, t = 2.0, yield = 250.0;
  const PlasticKinematic law{steel_E, steel_nu, yield, 0.0, 1.0, 0.0, 0.0, 0.0};
  const double small = 0.1 * yield / steel_E;  // strain of the faces, curvature times t / 2
  EXPECT_NEAR(moment<full>(law, small),
              steel_E / (1.0 - steel_nu * steel_nu) * b * t * t * t / 12.0 * small / (t / 2.0),
              1e-4 * moment<full>(law, small));
  // A hinge in plane strain: 2/sqrt(3) SIGY b t^2/4, less a core that is elastic; ten Gauss layers.
  EXPECT_NEAR(moment<full>(law, 10.0 * yield / steel_E) / (2.0 / std::sqrt(3.0) * yield * b * t * t / 4.0), 1.0, 0.015);
}
TEST(ThickShell, BendsAsAPlate) {
  bends_as_a_plate<false>();
  bends_as_a_plate<true>();
}

// ELFORM 3 in its plane, the thickness held: a hinge in plane strain, by two points over the height, of which the
// stress across the bar is none. Sabotage: no relief along xi and eta.
TEST(ThickShell, BendsInItsPlane) {
  const double a = 10.0, b = 6.0, h = 1.0, dt = 1e-7, yield = 250.0, last = 10.0 * yield / steel_E;
  const PlasticKinematic law{steel_E, steel_nu, yield, 0.0, 1.0, 0.0, 0.0, 0.0};
  const Corners x{Vec3d{-a, -b, -h}, {a, -b, -h}, {a, b, -h}, {-a, b, -h},
                  {-a, -b, h},       {a, -b, h},  {a, b, h},  {-a, b, h}};
  for (const bool along_x : {true, false}) {
    Driven<PlasticKinematic, 3, false, true> d(inviscid(), law, x);
    const int cycles = 4000;
    for (int cycle = 0; cycle < cycles; ++cycle) {
      for (std::size_t i = 0; i < 8; ++i) {
        const double speed = last / (cycles * dt) * x[i].x * x[i].y;
        d.nodes.v[i] = along_x ? Vec3d{speed / b, 0.0, 0.0} : Vec3d{0.0, speed / a, 0.0};
      }
      d.step(dt);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < 8; ++i) {
      if (along_x && x[i].x > 0.0) sum += d.force.f[i].x * x[i].y;
      if (!along_x && x[i].y > 0.0) sum += d.force.f[i].y * x[i].x;
    }
    const double half = along_x ? b : a, points = half / std::sqrt(3.0);
    EXPECT_NEAR(sum / (2.0 / std::sqrt(3.0) * yield * 2.0 * h * 2.0 * half * points), 1.0, 0.01) << along_x;
  }
}

template <bool full>
void rigid_rotation_strains_nothing() {
  Random random;
  const double dt = 1e-7;
  Driven<PlasticKinematic, 3, false, full> d(inviscid(), mixed(0.5), distorted(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(40000.0);
    d.step(dt);
  }
  for (int cycle = 0; cycle < 200; ++cycle) {  // until no stress across is left to be taken back
    for (Vec3d& v : d.nodes.v) v = {};
    d.step(dt);
  }
  ASSERT_GT(d.at(d.layout.history_of(0)), 0.0);
  expect_that_a_turn_strains_nothing(d, dt);
}
TEST(ThickShell, RigidRotationStrainsNothing) {
  rigid_rotation_strains_nothing<false>();
  rigid_rotation_strains_nothing<true>();
}

TEST(ThickShell, GoesWithItsLastLayer) {
  PiecewiseLinear law = bilinear(250, 0);
  law.failure_strain = 0.02;
  Driven<PiecewiseLinear, 4> d(inviscid(), law, block(10, 10, 2));
  expect_that_it_goes_with_its_last_layer(d, law.failure_strain);
}

// ELFORM 3 goes with its last point, with as many as NUMINT says, or with as many layers of which one point has failed.
// Sabotage: layers that are counted by their points.
TEST(ThickShell, FourPointsALayerGoByTheirNumber) {
  struct Case {
    double points_to_delete;
    int points, layers;  // the least, failed, at which it is gone
  };
  for (const Case& c : {Case{0.0, 16, 4}, Case{6.0, 6, 0}, Case{-50.0, 2, 2}}) {
    LawComponents law{bilinear(250, 0)};
    law.failure_strain = 0.02;
    law.points_to_delete = c.points_to_delete;
    Driven<ComposedLaw, 4, false, true> d(inviscid(), composed_law(law), block(10, 10, 2));
    int points = 0, layers = 0;
    for (int cycle = 0; cycle < 8000 && d.at(L::alive) > 0.5; ++cycle) {
      EXPECT_TRUE(points < c.points || layers < c.layers) << c.points_to_delete;
      // Bent in its plane and across it: no two points alike.
      for (std::size_t i = 0; i < 8; ++i) {
        const bool far = i == 1 || i == 2 || i == 5 || i == 6, back = i == 2 || i == 6;
        d.nodes.v[i] = {far ? 1000.0 + (i > 3 ? 700.0 : 0.0) + (back ? 400.0 : 0.0) : 0.0, 0.0, 0.0};
      }
      d.step(1e-7);
      points = layers = 0;
      for (int k = 0; k < 4; ++k) {
        int here = 0;
        for (int column = 0; column < 4; ++column) here += d.at(d.layout.history_of(k, column)) >= 0.02;
        points += here;
        layers += here > 0;
      }
    }
    EXPECT_TRUE(points >= c.points && layers >= c.layers) << c.points_to_delete << ": " << points << " " << layers;
    EXPECT_EQ(d.at(L::alive), 0.0);
    EXPECT_EQ(largest(d.force), 0.0);
  }
}

}  // namespace
}  // namespace nugget::kernel
