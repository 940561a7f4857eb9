// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/extruded_shell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "driven_solid.hpp"
#include "element_stiffness.hpp"
#include "kernel/element/belytschko_tsay.hpp"

namespace nugget::kernel {
namespace {

using L = ExtrudedShellLayout;
using Corners = std::array<Vec3d, 8>;

/// A quadrilateral of a x b x t, its nodes moved about by `rough`, the top by `slant` beyond the bottom.
Corners slab(double a, double b, double t, const Vec3d& slant = {}) {
  Corners x{Vec3d{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, t}, {a, 0, t}, {a, b, t}, {0, b, t}};
  for (std::size_t i = 4; i < 8; ++i) x[i] += slant;
  return x;
}
Corners distorted(Random& random, double t = 3.0, double rough = 0.4) {
  Corners x = slab(5, 4, t);
  for (Vec3d& p : x) p += Vec3d{rough * random(), rough * random(), 0.1 * t * random()};
  return x;
}

HexahedronProperties inviscid(int hourglass = 4) {
  HexahedronProperties b;
  b.density = steel_density;
  b.hourglass = hourglass;
  b.bulk_linear = b.bulk_quadratic = 0.0;
  return b;
}

/// See driven_solid.hpp.
template <bool full, int layers>
struct Extruded {
  static constexpr std::size_t corners = 8;
  using Layout = L;
  template <class R>
  using Motion = SolidMotion<R>;
  template <class R>
  using Forces = SolidForces<R>;
  static ExtrudedShellProperties properties(const HexahedronProperties& brick) {
    ExtrudedShellProperties p;
    p.full = full;
    p.bulk_quadratic = brick.bulk_quadratic;
    p.bulk_linear = brick.bulk_linear;
    p.shell.density = brick.density;
    p.shell.layers = gauss_layers(layers);
    p.shell.hourglass = brick.hourglass;
    p.shell.warping_stiffness = full;
    return p;
  }
  template <class Law>
  static L layout(const LawKernel<Law>& law) {
    return extruded_shell_layout(properties({}), law);
  }
  static void start(const L& layout, const Corners& x, double* state) { start_extruded_shell(layout, x, state, 1, 0); }
  template <class R, class Law>
  static Forces<R> cycle(const HexahedronProperties& brick, const LawKernel<Law>& law, const L&, const Motion<R>& nodes,
                         double dt, double* state) {
    return extruded_shell_cycle<R>(properties(brick), law, nodes, dt, state);
  }
  static int plastic_strain(const L& layout) { return layout.history_of(0); }
};
template <bool full, class Law, int layers = 3>
using Driven = DrivenSolid<Extruded<full, layers>, Law>;

template <bool full, class Law>
void batch_gives_the_bits(const HexahedronProperties& properties, const Law& parameters) {
  batch_gives_the_bits_of_each_alone<Extruded<full, 3>>(
      properties, parameters, [](Random& r) { return distorted(r); }, 1);
}
template <bool full>
void batches_give_the_bits() {
  HexahedronProperties viscous = inviscid(full ? 4 : 2);
  viscous.bulk_linear = 0.06;
  viscous.bulk_quadratic = 1.5;
  batch_gives_the_bits<full>(viscous, steel);
  batch_gives_the_bits<full>(viscous, mixed(0.3));
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits<full>(inviscid(), failing);
}
TEST(ExtrudedShell, BatchGivesTheBitsOfEachAlone) {
  batches_give_the_bits<false>();
  batches_give_the_bits<true>();
}

/// Constant strain of a slab whose sides are slanted: plane stress in the layers, and across Young's modulus alone.
template <bool full>
void constant_strain_is_exact() {
  Random random;
  Corners x = slab(5, 4, 1, {0.3, -0.2, 0.0});
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3d move{0.5 * random(), 0.5 * random(), 0.0};
    x[i] += move;
    x[i + 4] += move;
  }
  Driven<full, Elastic> d(inviscid(), steel, x);
  for (std::size_t i = 0; i < 8; ++i)
    d.nodes.v[i] = 1e-6 * Vec3d{x[i].x + 0.5 * x[i].y, x[i].y + 0.5 * x[i].x, 0.3 * x[i].z};
  d.step(1e-3);
  const double plane = steel_E / (1.0 - steel_nu * steel_nu), unit_strain = 1e-9;
  const Frame3d frame = shell_frame(midway_nodes(x));
  for (int column = 0; column < d.layout.shell.columns; ++column)
    for (int k = 0; k < 3; ++k) {
      const int s = d.layout.layer(k, column);
      // Both stretches are the same: this part of the stress is so in any axes; the shear is turned into them.
      EXPECT_NEAR(d.at(s) + d.at(s + 1), 2.0 * plane * (1.0 + steel_nu) * unit_strain, 1e-12);
      const double shear = steel_E / (2.0 * (1.0 + steel_nu)) * unit_strain;
      const Vec3d& e1 = frame.e1;
      EXPECT_NEAR(d.at(s) - d.at(s + 1), 4.0 * shear * e1.x * e1.y, 1e-9 * steel_E * unit_strain);
      EXPECT_NEAR(d.at(s + 3), 0.0, 1e-12);
      EXPECT_NEAR(d.at(s + 4), 0.0, 1e-12);
    }
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(d.at(L::across + i), 0.3 * steel_E * unit_strain, 1e-12);
}
TEST(ExtrudedShell, Patch) {
  constant_strain_is_exact<false>();
  constant_strain_is_exact<true>();
}

// Sabotage: spins of the pairs without that about their line (turns then bend what is not a prism).
template <bool full>
void turns_strain_nothing() {
  Random random;
  const double dt = 1e-7;
  Driven<full, PlasticKinematic> d(inviscid(), mixed(0.5), distorted(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (Vec3d& v : d.nodes.v) v = random.vector(40000.0);
    d.step(dt);
  }
  for (Vec3d& v : d.nodes.v) v = {};
  d.step(dt);
  ASSERT_GT(d.at(d.layout.history_of(0)), 0.0);
  expect_that_a_turn_strains_nothing(d, dt);
}
TEST(ExtrudedShell, RigidRotationStrainsNothing) {
  turns_strain_nothing<false>();
  turns_strain_nothing<true>();
}

template <bool full>
std::vector<double> stiffness(const Corners& x) {
  SolidMotion<double> rest;
  std::copy(x.begin(), x.end(), rest.x);
  return element_stiffness(rest, [&](const SolidMotion<double>& motion, double step) {
    Driven<full, Elastic> d(inviscid(), steel, x);
    return one_element(motion, d.state, [&](const auto& all, double* store) {
      return Extruded<full, 3>::cycle(d.properties, d.law, d.layout, all, step, store);
    });
  });
}

/// Of one point a seventh pattern is free, as in the shell of ELFORM 2: spins x about x and y about y, which neighbours
/// cannot share.
template <bool full>
void only_rigid_motion_is_free() {
  Random random;
  const Corners brick = distorted(random);
  const std::vector<double> K = stiffness<full>(brick);
  double most = 0.0;
  for (const double k : K) most = std::max(most, std::abs(k));
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) EXPECT_NEAR(K[i * 24 + j], K[j * 24 + i], 1e-10 * most);
  EXPECT_EQ(zero_modes(K, 24), full ? 6 : 7);
}
TEST(ExtrudedShell, OnlyRigidMotionIsFree) {
  only_rigid_motion_is_free<false>();
  only_rigid_motion_is_free<true>();

  Random random;
  Corners wedge = distorted(random);
  wedge[3] = wedge[2];
  wedge[7] = wedge[6];
  const std::vector<double> all = stiffness<true>(wedge);
  constexpr std::array<std::size_t, 8> own{0, 1, 2, 2, 3, 4, 5, 5};
  std::vector<double> six(18 * 18, 0.0);
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) six[(3 * own[i / 3] + i % 3) * 18 + 3 * own[j / 3] + j % 3] += all[i * 24 + j];
  EXPECT_EQ(zero_modes(six, 18), 6);
}

/// The largest eigenvalue of K over one mass for all freedoms, by the power method.
double fastest(const std::vector<double>& k, double mass) {
  std::vector<double> v(24, 0.0);
  Random random;
  for (double& x : v) x = random();
  double value = 0.0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> w(24, 0.0);
    for (std::size_t r = 0; r < 24; ++r)
      for (std::size_t c = 0; c < 24; ++c) w[r] += k[r * 24 + c] * v[c];
    double square = 0.0;
    for (const double x : w) square += x * x;
    value = std::sqrt(square);
    for (std::size_t r = 0; r < 24; ++r) v[r] = w[r] / value;
  }
  return std::sqrt(value / mass);
}

// Lone elements from plates to pillars: the step is one that their fastest vibration allows, and of plates no more than
// a few per cent short. Sabotage: the step of the shell alone.
TEST(ExtrudedShell, StableStepOfLoneElements) {
  Random random;
  for (const double t : {0.2, 1.0, 3.0, 5.0, 8.0})
    for (int shape = 0; shape < 6; ++shape) {
      const Corners x = shape == 0 ? slab(5, 4, t) : distorted(random, t, 0.5);
      Driven<true, Elastic> full(inviscid(), steel, x);
      Driven<false, Elastic> one(inviscid(), steel, x);
      const double mass = hexahedron_nodal_mass(x, steel_density);
      const double limit_full = 2.0 / fastest(stiffness<true>(x), mass);
      const double limit_one = 2.0 / fastest(stiffness<false>(x), mass);
      EXPECT_LE(full.step(0.0).stable_step, 1.05 * limit_full) << t;
      EXPECT_LE(one.step(0.0).stable_step, 1.05 * limit_one) << t;
      if (shape == 0 && t < 0.5) {
        EXPECT_GE(full.force.stable_step, 0.98 * limit_full);
      }
    }
}

/// Moment of a strip 2a x 2a x 2h whose ends are turned, so that its faces are stretched and shortened by `last` along
/// x; the other way it is held.
template <bool full>
double moment(const PlasticKinematic& law, double last) {
  const double a = 10.0, h = 1.0, dt = 1e-7;
  const Corners x{Vec3d{-a, -a, -h}, {a, -a, -h}, {a, a, -h}, {-a, a, -h},
                  {-a, -a, h},       {a, -a, h},  {a, a, h},  {-a, a, h}};
  Driven<full, PlasticKinematic, 10> d(inviscid(), law, x);
  const int cycles = 2000;
  for (int cycle = 1; cycle <= cycles; ++cycle) {
    for (std::size_t i = 0; i < 8; ++i) {
      const double turn = last * cycle / cycles * x[i].x / h;
      const Vec3d now{x[i].x + x[i].z * std::sin(turn), x[i].y, x[i].z * std::cos(turn)};
      d.nodes.v[i] = (1.0 / dt) * (now - d.nodes.x[i]);
    }
    d.step(dt);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i)
    if (x[i].x > 0.0) sum += d.force.f[i].x * d.nodes.x[i].z;
  return sum;
}

template <bool full>
void bends_as_a_plate() {
  const double b = 20.0, t = 2.0, yield = 250.0;
  const PlasticKinematic law{steel_E, steel_nu, yield, 0.0, 1.0, 0.0, 0.0, 0.0};
  const double small = 0.1 * yield / steel_E;
  EXPECT_NEAR(moment<full>(law, small),
              steel_E / (1.0 - steel_nu * steel_nu) * b * t * t * t / 12.0 * small / (t / 2.0),
              1e-4 * moment<full>(law, small));
  // A hinge in plane strain: 2/sqrt(3) SIGY b t^2/4, less a core that is elastic; ten Gauss layers.
  EXPECT_NEAR(moment<full>(law, 10.0 * yield / steel_E) / (2.0 / std::sqrt(3.0) * yield * b * t * t / 4.0), 1.0, 0.015);
}
TEST(ExtrudedShell, BendsAsAPlate) {
  bends_as_a_plate<false>();
  bends_as_a_plate<true>();
}

// What happens in the plane is no matter across, and the other way round: squeezed by 1 % while the plane is held, then
// stretched in the plane until it flows.
TEST(ExtrudedShell, NothingCouplesAcrossAndInThePlane) {
  const double a = 10.0, t = 2.0, dt = 1e-7;
  Driven<true, PlasticKinematic> d(inviscid(), mixed(0.5), slab(a, a, t));
  for (std::size_t i = 4; i < 8; ++i) d.nodes.v[i] = {0, 0, -0.01 * t / (100 * dt)};
  for (int cycle = 0; cycle < 100; ++cycle) d.step(dt);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(d.at(d.layout.layer(k)), 0.0, 1e-6);
  const double squeezed = 4.0 * d.force.f[6].z;
  EXPECT_NEAR(squeezed, steel_E * std::log(0.99) * a * a, 1e-3 * std::abs(squeezed));
  for (std::size_t i = 0; i < 8; ++i) d.nodes.v[i] = {i % 4 == 1 || i % 4 == 2 ? 0.02 * a / (100 * dt) : 0.0, 0, 0};
  for (int cycle = 0; cycle < 100; ++cycle) d.step(dt);
  EXPECT_GT(d.at(d.layout.history_of(0)), 0.01);
  EXPECT_NEAR(4.0 * d.force.f[6].z, squeezed * 1.02, 1e-6 * std::abs(squeezed));  // a larger area
}

TEST(ExtrudedShell, GoesWithItsLastLayer) {
  PiecewiseLinear law = bilinear(250, 0);
  law.failure_strain = 0.02;
  Driven<false, PiecewiseLinear, 4> d(inviscid(), law, slab(10, 10, 2));
  expect_that_it_goes_with_its_last_layer(d, law.failure_strain);
}

}  // namespace
}  // namespace nugget::kernel
