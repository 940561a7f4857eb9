// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "base/index.hpp"
#include "driven_solid.hpp"
#include "element_stiffness.hpp"
#include "kernel/element/hexahedron.hpp"

namespace nugget::kernel {
namespace {

using L = HexahedronLayout;
using Corners = std::array<Vec3d, 8>;

Corners box(double a, double b, double c) {
  return {Vec3d{0, 0, 0}, {a, 0, 0}, {a, b, 0}, {0, b, 0}, {0, 0, c}, {a, 0, c}, {a, b, c}, {0, b, c}};
}
Corners distorted(Random& random) {
  Corners x = box(5, 4, 3);
  for (Vec3d& p : x) p += random.vector(0.4);
  return x;
}

/// See driven_solid.hpp.
struct Brick {
  static constexpr std::size_t corners = 8;
  using Layout = L;
  template <class R>
  using Motion = SolidMotion<R>;
  template <class R>
  using Forces = SolidForces<R>;
  template <class Law>
  static L layout(const LawKernel<Law>& law) {
    return hexahedron_layout(law);
  }
  static void start(const L& layout, const Corners& x, double* state) { start_hexahedron(layout, x, state, 1, 0); }
  template <class R, class Law>
  static Forces<R> cycle(const HexahedronProperties& brick, const LawKernel<Law>& law, const L&, const Motion<R>& nodes,
                         double dt, double* state) {
    return hexahedron_cycle<R>(brick, law, nodes, dt, state);
  }
  static int plastic_strain(const L&) { return L::first_history; }
};
template <class Law>
using Driven = DrivenSolid<Brick, Law>;

template <class Law>
double power(const Driven<Law>& d, const SolidForces<double>& f) {
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) sum += dot(f.f[i], d.nodes.v[i]);
  return sum;
}

HexahedronProperties brick(int hourglass, double coefficient = 0.1) {
  HexahedronProperties b;
  b.density = steel_density;
  b.hourglass = hourglass;
  b.hourglass_coefficient = coefficient;
  return b;
}

Spotweld weld(double failure = 0.0) {
  Spotweld law;
  law.E = steel_E;
  law.nu = steel_nu;
  law.yield = 400.0;
  law.hardening = 1000.0;
  law.failure_strain = failure;
  return law;
}

Spotweld damaged_weld() {
  Spotweld law = weld(0.05);
  law.damage.growth = PointDamage::Growth::strain;
  law.damage.rupture = 0.15;
  return law;
}

Spotweld uniaxial_weld(Spotweld law) {
  law.uniaxial = true;
  return law;
}

template <class Law>
void batch_gives_the_bits_of_each_alone(const HexahedronProperties& properties, const Law& parameters) {
  batch_gives_the_bits_of_each_alone<Brick>(
      properties, parameters, [](Random& r) { return distorted(r); }, 2);
}

TEST(Hexahedron, BatchGivesTheBitsOfEachAlone) {
  for (const int hourglass : {1, 2, 4, 6}) batch_gives_the_bits_of_each_alone(brick(hourglass), steel);
  batch_gives_the_bits_of_each_alone(brick(5), mixed(0.3));
  batch_gives_the_bits_of_each_alone(brick(3), curved());
  batch_gives_the_bits_of_each_alone(brick(6), tabled());
  batch_gives_the_bits_of_each_alone(brick(6), weld(0.2));
  batch_gives_the_bits_of_each_alone(brick(6), damaged_weld());
  batch_gives_the_bits_of_each_alone(brick(6), uniaxial_weld(weld()));
  batch_gives_the_bits_of_each_alone(brick(2), uniaxial_weld(damaged_weld()));
}

TEST(Hexahedron, GradientIsTheDerivativeOfTheVolume) {
  // Forces of a unit mean stress are dV/dx.
  Random random;
  const Corners x = distorted(random);
  Driven<Elastic> d(brick(4), steel, x);
  d.state[L::stress] = d.state[L::stress + 1] = d.state[L::stress + 2] = 1.0;
  d.step(0.0);
  for (std::size_t i = 0; i < 8; ++i)
    for (double Vec3d::*c : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
      Corners up = x, down = x;
      up[i].*c += 1e-4;
      down[i].*c -= 1e-4;
      EXPECT_NEAR(d.force.f[i].*c, (hexahedron_volume(up) - hexahedron_volume(down)) / 2e-4, 1e-8);
    }
  EXPECT_NEAR(d.force.volume, hexahedron_volume(x), 1e-12);
  EXPECT_NEAR(hexahedron_volume(box(5, 4, 3)), 60.0, 1e-12);
}

TEST(Hexahedron, Patch) {
  // A linear velocity field on a distorted brick: exact strain, no hourglass force.
  Random random;
  for (const int hourglass : {2, 4, 6}) {
    Driven<Elastic> d(brick(hourglass, 1.0), steel, distorted(random));
    for (int i = 0; i < 8; ++i) {
      const Vec3d& x = d.nodes.x[i];
      d.nodes.v[i] = 1e-6 * Vec3d{x.x + 0.5 * x.y, x.y + 0.5 * x.x - 0.2 * x.z, 0.3 * x.z - 0.2 * x.y};
    }
    d.step(1e-3);
    const double lambda = steel_E * steel_nu / (1.3 * 0.4), G = steel_E / 2.6, unit_strain = 1e-9;
    EXPECT_NEAR(d.at(L::stress), (2.3 * lambda + 2 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(L::stress + 2), (2.3 * lambda + 0.6 * G) * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(L::stress + 3), G * unit_strain, 1e-12);
    EXPECT_NEAR(d.at(L::stress + 4), -0.4 * G * unit_strain, 1e-12);
    for (int i = 0; i < 12; ++i) EXPECT_NEAR(d.at(L::hourglass + i), 0.0, 1e-13);
  }
}

TEST(Hexahedron, RigidRotationStrainsNothing) {
  Random random;
  const double dt = 1e-7;
  for (const int hourglass : {2, 4, 6}) {
    Driven<PlasticKinematic> d(brick(hourglass), mixed(0.5), distorted(random));
    for (int cycle = 0; cycle < 20; ++cycle) {
      for (Vec3d& v : d.nodes.v) v = random.vector(40000.0);
      d.step(dt);
    }
    for (Vec3d& v : d.nodes.v) v = {};
    d.step(dt);  // at rest: no viscous forces
    ASSERT_GT(d.at(L::first_history), 0.0);
    const std::vector<double> before = d.state;
    const auto start = d.force;
    const Vec3d axis = unit(Vec3d{1, 2, 3});
    double work = 0.0;
    const int steps = 360;
    for (int cycle = 0; cycle < steps; ++cycle) {
      const auto last = d.force;
      for (int i = 0; i < 8; ++i)
        d.nodes.v[i] = (1.0 / dt) * (turned(axis, 2 * M_PI / steps, d.nodes.x[i]) - d.nodes.x[i]);
      d.step(dt);
      work += 0.5 * dt * (power(d, last) + power(d, d.force));
    }
    for (std::size_t i = 0; i < before.size(); ++i)
      EXPECT_NEAR(d.state[i], before[i], 1e-7 * (1 + std::abs(before[i]))) << i;
    for (int i = 0; i < 8; ++i) EXPECT_LT(norm(d.force.f[i] - start.f[i]), 1e-7 * largest(start));
    EXPECT_LT(std::abs(work), 1e-7 * largest(start));
  }
}

TEST(Hexahedron, ForcesDoTheWorkOfTheStresses) {
  Random random;
  const double dt = 1e-13;
  for (const int hourglass : {1, 3, 5, 6}) {
    Driven<Elastic> d(brick(hourglass), steel, distorted(random));
    for (int i = 0; i < 12; ++i) d.state[L::hourglass + i] = 100 * random();
    for (int i = 0; i < 6; ++i) d.state[L::stress + i] = 100 * random();
    for (int i = 0; i < 8; ++i)
      d.nodes.v[i] = random.vector(1000.0) + 3000.0 * d.nodes.x[i];  // it expands: no bulk viscosity
    d.step(dt);
    const double before = d.at(L::hourglass_energy);
    d.step(dt);
    Corners x;
    for (std::size_t i = 0; i < 8; ++i) x[i] = d.nodes.x[i];
    double l[3][3] = {};  // V times the velocity gradient
    double Vec3d::*axis[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};
    for (std::size_t n = 0; n < 8; ++n)
      for (int j = 0; j < 3; ++j) {
        Corners up = x, down = x;
        up[n].*axis[j] += 1e-4;
        down[n].*axis[j] -= 1e-4;
        const double b = (hexahedron_volume(up) - hexahedron_volume(down)) / 2e-4;
        for (int i = 0; i < 3; ++i) l[i][j] += d.nodes.v[n].*axis[i] * b;
      }
    const double* s = d.state.data() + L::stress;
    const double expected = s[0] * l[0][0] + s[1] * l[1][1] + s[2] * l[2][2] + s[3] * (l[0][1] + l[1][0]) +
                            s[4] * (l[1][2] + l[2][1]) + s[5] * (l[2][0] + l[0][2]);
    const double hourglass_power = (d.at(L::hourglass_energy) - before) / dt;
    EXPECT_GT(std::abs(hourglass_power), 1e-5 * std::abs(expected));
    EXPECT_NEAR(power(d, d.force), expected + hourglass_power, 1e-6 * std::abs(expected)) << hourglass;
    Vec3d force{}, moment{};
    for (int i = 0; i < 8; ++i) {
      force += d.force.f[i];
      moment += cross(d.nodes.x[i], d.force.f[i]);
    }
    EXPECT_LT(norm(force), 1e-10 * largest(d.force));
    if (hourglass > 1) {
      EXPECT_LT(norm(moment), 1e-9 * largest(d.force));
    }
  }
}

TEST(Hexahedron, StableStep) {
  const Corners x = box(5, 5, 1.5);
  EXPECT_NEAR(hexahedron_stable_step(x, steel_E, steel_nu, steel_density), 2.49959e-7, 2.5e-11);
  HexahedronProperties inviscid = brick(2);
  inviscid.bulk_linear = inviscid.bulk_quadratic = 0.0;
  Driven<Elastic> plain(inviscid, steel, x);
  EXPECT_NEAR(plain.step(0.0).stable_step, 2.49959e-7, 2.5e-11);
  plain.state[L::density_scale] = 4.0;
  EXPECT_NEAR(plain.step(0.0).stable_step, 2 * 2.49959e-7, 5e-11);
  // The linear bulk viscosity counts at rest too, as in LS-DYNA.
  Driven<Elastic> d(brick(2), steel, x);
  EXPECT_NEAR(d.step(0.0).stable_step, 2.49959e-7 / (0.06 + std::sqrt(1.0 + 0.06 * 0.06)), 2.5e-11);
  for (int i = 4; i < 8; ++i) d.nodes.v[i].z = -1.5;  // trace -1 at once
  const double c = 6.000980e6, Q = 0.06 * c + 1.5 * 1.5;
  EXPECT_NEAR(d.step(1e-12).stable_step, 1.5 / (Q + std::sqrt(Q * Q + c * c)), 1e-11);
}

TEST(Hexahedron, BulkViscosityPushesBackUnderCompression) {
  Driven<Elastic> d(brick(2), steel, box(5, 5, 5));
  const double rate = -1000.0, c = 6.000980e6;
  for (int i = 4; i < 8; ++i) d.nodes.v[i].z = 5 * rate;
  d.step(1e-15);
  const double q = steel_density * 5 * (1.5 * 5 * rate * rate - 0.06 * c * rate);
  EXPECT_NEAR(d.force.f[4].z, -q * 25 / 4, 1e-3 * q * 25 / 4);
  for (int i = 4; i < 8; ++i) d.nodes.v[i].z = -5 * rate;
  d.step(1e-15);
  EXPECT_NEAR(d.force.f[4].z, 0.0, 1e-2);
}

TEST(Hexahedron, DegenerateFormsAreFinite) {
  Corners wedge = box(5, 4, 3), tetrahedron = box(5, 4, 3);
  wedge[6] = wedge[5];
  wedge[7] = wedge[4];
  tetrahedron[3] = tetrahedron[2];
  for (std::size_t i = 5; i < 8; ++i) tetrahedron[i] = tetrahedron[4];
  for (const Corners& x : {wedge, tetrahedron})
    for (const int hourglass : {1, 2, 4, 6}) {
      Driven<Elastic> d(brick(hourglass), steel, x);
      for (int i = 0; i < 8; ++i) d.nodes.v[i] = {d.nodes.x[i].z, d.nodes.x[i].x, 0};
      d.step(1e-7);
      EXPECT_TRUE(std::isfinite(largest(d.force))) << hourglass;
      EXPECT_GT(d.force.stable_step, 0.0);
      EXPECT_GT(d.force.volume, 0.0);
    }
  EXPECT_NEAR(hexahedron_volume(wedge), 30.0, 1e-12);
  EXPECT_NEAR(hexahedron_volume(tetrahedron), 10.0, 1e-12);
}

TEST(Hexahedron, InvertedVolumeIsReported) {
  Driven<Elastic> d(brick(2), steel, box(5, 4, 3));
  for (int i = 4; i < 8; ++i) d.nodes.v[i].z = -4.0;
  EXPECT_LT(d.step(1.0).volume, 0.0);
}

TEST(Hexahedron, FailedBrickIsDeleted) {
  Driven<Spotweld> d(brick(2), weld(0.02), box(5, 5, 5));
  for (int cycle = 0; cycle < 5000 && d.at(L::alive) > 0.5; ++cycle) {
    for (int i = 4; i < 8; ++i) d.nodes.v[i].x = 1000.0;
    d.step(1e-7);
  }
  EXPECT_EQ(d.at(L::alive), 0.0);
  EXPECT_EQ(largest(d.force), 0.0);
  EXPECT_GE(d.at(L::first_history), 0.02);
  EXPECT_TRUE(std::isinf(d.force.stable_step));
}

const HexahedronProperties weld_brick = brick(6, 1.0);

/// A weld brick of height 2 on a 5 x 5 section, its upper face driven, the lower one held.
struct WeldBrick : Driven<Spotweld> {
  explicit WeldBrick(const Spotweld& material) : DrivenSolid(weld_brick, material, box(5, 5, 2)) {}
  void move(const Vec3d& by, double dt = 1.0) {
    for (int i = 4; i < 8; ++i) nodes.v[i] = (1.0 / dt) * by;
    step(dt);
  }
  Vec3d force_on_top() const { return force.f[4] + force.f[5] + force.f[6] + force.f[7]; }
  double plastic_strain() const { return at(L::first_history); }
};

// Sabotage to be caught: lambda + 2 G in place of E; transverse stresses; G / 2.
TEST(Hexahedron, UniaxialWeldHasOnlyTheStressesOfItsSection) {
  WeldBrick d(uniaxial_weld(weld()));
  d.move({1e-4, 2e-4, 3e-4}, 1e9);  // slow: no bulk viscosity
  const double E = steel_E, G = E / 2.6, axial = std::log(1.0 + 3e-4 / 2);
  EXPECT_NEAR(d.force_on_top().z, 25.0 * E * axial, 1e-6 * 25.0 * E * axial);
  EXPECT_NEAR(d.force_on_top().x, 25.0 * G * 0.5e-4, 2e-4 * 25.0 * G * 0.5e-4);
  EXPECT_NEAR(d.force_on_top().y, 25.0 * G * 1e-4, 2e-4 * 25.0 * G * 1e-4);
  for (const int side : {0, 1}) {  // nothing across the weld
    const double pull = side == 0 ? d.force.f[1].x + d.force.f[2].x + d.force.f[5].x + d.force.f[6].x
                                  : d.force.f[2].y + d.force.f[3].y + d.force.f[6].y + d.force.f[7].y;
    EXPECT_LT(std::abs(pull), 0.4 * norm(d.force_on_top()));
    EXPECT_LT(std::abs(d.at(L::stress + side)), 1e-9);
  }
  WeldBrick full(weld());
  full.move({0, 0, 3e-4}, 1e9);
  EXPECT_GT(std::abs(full.at(L::stress)), 0.4 * full.at(L::stress + 2));
}

TEST(Hexahedron, UniaxialWeldTurnsWithItsFaces) {
  WeldBrick d(uniaxial_weld(damaged_weld()));
  for (int i = 0; i < 100; ++i) d.move({2e-4, 0, 5e-4});
  const double axial = d.force_on_top().z, shear = d.force_on_top().x;
  ASSERT_GT(d.plastic_strain(), 0.0);
  const Vec3d axis = unit(Vec3d{1, 2, 3});
  const double angle = 0.05;
  for (int turn = 1; turn <= 126; ++turn) {
    for (int i = 0; i < 8; ++i) {
      const Vec3d x = turned(axis, angle, d.nodes.x[i]);
      d.nodes.v[i] = x - d.nodes.x[i];
    }
    d.step(1.0);
    const Vec3d back = turned(axis, -turn * angle, d.force_on_top());
    EXPECT_NEAR(back.z, axial, 1e-8 * axial);
    EXPECT_NEAR(back.x, shear, 1e-8 * axial);
  }
}

// Weld damage after EFAIL for a brick. Its transverse strain is free in the law only: with sides held, a uniaxial weld
// follows the closed form of the beam.
TEST(Hexahedron, WeldBrickDamagesOverPlasticStrain) {
  WeldBrick d(uniaxial_weld(damaged_weld()));
  double hourglass = 0.0;
  while (d.at(L::alive) > 0.5 && d.nodes.x[4].z < 2.6) {
    d.move({0, 0, 1e-4});
    const double e = d.plastic_strain(), left = std::min(1.0, (0.15 - e) / 0.1);
    if (e > 0.0 && d.at(L::alive) > 0.5) {
      EXPECT_NEAR(d.force_on_top().z, left * (400.0 + 1000.0 * e) * 25.0, 1e-6 * 11250.0);
    }
    hourglass = std::max(hourglass, d.at(L::hourglass_energy));
  }
  EXPECT_EQ(d.at(L::alive), 0.0);
  EXPECT_LT(hourglass, 1e-12);
}

TEST(Hexahedron, ForcesFollowTheIntegrityOfTheWeld) {
  WeldBrick weld_integrity(weld()), half(weld());
  half.state[L::integrity] = 0.5;
  Random random;
  for (int cycle = 0; cycle < 20; ++cycle) {
    for (int i = 0; i < 8; ++i) half.nodes.v[i] = weld_integrity.nodes.v[i] = random.vector(2000.0);
    weld_integrity.step(1e-6);
    half.step(1e-6);
    for (int i = 0; i < 8; ++i)
      EXPECT_LT(norm(half.force.f[i] - 0.5 * weld_integrity.force.f[i]), 1e-9 * largest(weld_integrity.force));
    EXPECT_NEAR(half.at(L::hourglass_energy), 0.5 * weld_integrity.at(L::hourglass_energy),
                1e-9 * std::abs(weld_integrity.at(L::hourglass_energy)));
  }
  EXPECT_NE(weld_integrity.at(L::hourglass_energy), 0.0);
}

TEST(Hexahedron, HeldYieldStressLetsNoForceGrow) {
  Spotweld law = uniaxial_weld(weld());
  law.yield_can_be_frozen = true;
  WeldBrick d(law);
  for (int i = 0; i < 20; ++i) d.move({0, 0, 1e-4});
  const double force = d.force_on_top().z;
  freeze_yield(d.law, d.state.data(), 1, 0);
  for (int i = 0; i < 50; ++i) d.move({0, 0, 1e-4});
  EXPECT_NEAR(d.force_on_top().z, force, 1e-9 * force);
}

TEST(Hexahedron, Mass) {
  EXPECT_DOUBLE_EQ(hexahedron_nodal_mass(box(5, 4, 3), steel_density), 60 * steel_density / 8);
}

using Dense = std::vector<std::vector<double>>;

/// Without bulk viscosity, which does not go with the step.
Dense stiffness(HexahedronProperties b, const Corners& x) {
  b.bulk_linear = b.bulk_quadratic = 0.0;
  SolidMotion<double> rest;
  std::copy(x.begin(), x.end(), rest.x);
  const std::vector<double> k = element_stiffness(rest, [&](const SolidMotion<double>& motion, double step) {
    Driven<Elastic> d(b, steel, x);
    return one_element(motion, d.state,
                       [&](const auto& all, double* store) { return hexahedron_cycle(b, d.law, all, step, store); });
  });
  Dense rows;
  for (std::size_t i = 0; i < 24; ++i) rows.emplace_back(&k[24 * i], &k[24 * i] + 24);
  return rows;
}

std::vector<double> solved(Dense a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double m = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= m * a[k][j];
      b[i] -= m * b[k];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = i + 1; j < n; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b;
}

/// Tip deflection of the brick cantilever with n bricks: end couple of 100000 N mm, or end shear of 1000 N.
double tip(int n, double coefficient, bool couple) {
  const std::size_t size = 12 * (at(n) + 1);
  Dense K(size, std::vector<double>(size));
  // Bricks along x; the element's nodes 1 4 8 5 lie on its left face, 2 3 7 6 on its right.
  const std::size_t left[4] = {0, 3, 7, 4}, right[4] = {1, 2, 6, 5};
  for (int e = 0; e < n; ++e) {
    const Dense k = stiffness(brick(6, coefficient), box(100.0 / n, 10, 10));
    std::size_t place[8];
    for (std::size_t i = 0; i < 4; ++i) {
      place[left[i]] = 4 * at(e) + i;
      place[right[i]] = 4 * at(e) + 4 + i;
    }
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t j = 0; j < 24; ++j) K[3 * place[i / 3] + i % 3][3 * place[j / 3] + j % 3] += k[i][j];
  }
  std::vector<double> f(size);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t node = size - 12 + 3 * i;
    if (couple)
      f[node] = i < 2 ? 5000.0 : -5000.0;  // bends towards +z: compression above
    else
      f[node + 2] = 250.0;
  }
  for (const std::size_t fixed : {0, 3, 6, 9, 2, 1}) K[fixed][fixed] += 1e14;  // root: all u_x, one u_z, one u_y
  K[5][5] += 1e14;  // u_z of the neighbour: no turning about x
  const std::vector<double> u = solved(K, f);
  return 0.25 * (u[size - 1] + u[size - 4] + u[size - 7] + u[size - 10]);
}

/// f . u of the forces on a brick whose nodes move by `field`, twice its energy.
template <class Field>
double twice_the_energy(const HexahedronProperties& b, const Corners& x, const Field& field) {
  const Dense K = stiffness(b, x);
  double u[24], sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3d at = field(x[i]);
    u[3 * i] = at.x, u[3 * i + 1] = at.y, u[3 * i + 2] = at.z;
  }
  for (std::size_t i = 0; i < 24; ++i)
    for (std::size_t j = 0; j < 24; ++j) sum += u[i] * K[i][j] * u[j];
  return sum;
}

/// Moves a brick of sides 2 along xi, eta, zeta to the directions g1, g2, g3 in its middle.
Corners parallelepiped(const Vec3d& g1, const Vec3d& g2, const Vec3d& g3) {
  Corners x;
  const Corners cube = box(2, 2, 2);
  for (std::size_t i = 0; i < 8; ++i) x[i] = (cube[i].x - 1.0) * g1 + (cube[i].y - 1.0) * g2 + (cube[i].z - 1.0) * g3;
  return x;
}

// Pure bending of a block: stress E kappa s along any direction r of a face, s the distance from the face through the
// middle. The parallelepiped's nodes move as the block's points, and its energy is the block's: E kappa^2 V h^2 / 3, h
// half its height. Sabotage: axes at right angles (the form of 1993); shear of the wrong pair; edges without nu.
TEST(Hexahedron, ParallelepipedsBendExactly) {
  Random random;
  for (int trial = 0; trial < 30; ++trial) {
    const Vec3d g[3] = {Vec3d{4, 0, 0} + random.vector(1.2), Vec3d{0, 2, 0} + random.vector(0.6),
                        Vec3d{0, 0, 0.7} + random.vector(0.2)};
    const Corners x = parallelepiped(g[0], g[1], g[2]);
    const int face = trial % 3;
    const Vec3d &a = g[(face + 1) % 3], &b = g[(face + 2) % 3], n = unit(cross(a, b)), r = unit(a + random() * b),
                t = cross(n, r);
    const double half = dot(g[face], n), kappa = 1e-3;
    const auto bent = [&](const Vec3d& p) {
      const double s = dot(p, n), along = dot(p, r), across = dot(p, t);
      return kappa * (s * along * r - steel_nu * s * across * t -
                      0.5 * (along * along + steel_nu * (s * s - across * across)) * n);
    };
    const double exact = steel_E * kappa * kappa * hexahedron_volume(x) * half * half / 3.0;
    EXPECT_NEAR(twice_the_energy(brick(6, 1.0), x, bent), exact, 1e-9 * exact) << trial;
  }
}

// The generalised forces that Belytschko and Bindeman (1993) give, of rectangular bricks however they lie. Sabotage: nu
// / (1 - nu) for nu; a third for a ninth of the last pattern.
TEST(Hexahedron, RectangularBricksHaveTheStiffnessOfBelytschkoAndBindeman) {
  const double mu = steel_E / (2.0 * (1.0 + steel_nu)), nu = steel_nu;
  const double sides[3] = {4 * 5.0, 4 * 3.0, 4 * 1.5};
  const auto H = [&](int i, int j) {
    const int k = (i + 1) % 3, l = (i + 2) % 3;
    return i == j ? sides[k] * sides[l] / (3.0 * sides[i]) : sides[3 - i - j] / 3.0;
  };
  // Forces Q_i,pattern of a rate of the pattern `p` along j.
  const auto expected = [&](int i, int k, int j, int p) {
    if (p == 3 || k == 3) return p == k && i == j ? 2.0 * mu * (1.0 + nu) / 3.0 * H(i, i) : 0.0;
    if (i == k)
      return j != p ? 0.0 : i == j ? mu * (H((i + 1) % 3, (i + 1) % 3) + H((i + 2) % 3, (i + 2) % 3)) : mu * H(i, j);
    if (i == j && k == p) return 2.0 * mu / (1.0 - nu) * H(i, i);
    return i == p && k == j ? 2.0 * mu * nu / (1.0 - nu) * H(i, k) : 0.0;
  };
  const Vec3d axis = unit(Vec3d{1, -2, 3});
  Corners x = box(5.0, 3.0, 1.5);
  Vec3d e[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (Vec3d& a : x) a = turned(axis, 0.7, a);
  for (Vec3d& a : e) a = turned(axis, 0.7, a);
  const double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                             {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
  const auto pattern = [&](std::size_t n, int k) {
    const double *s = sign[n], all = s[0] * s[1] * s[2];
    return k == 3 ? all : all * s[k];
  };
  const Dense K = stiffness(brick(6, 1.0), x);
  for (int p = 0; p < 4; ++p)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 4; ++k)
        for (int i = 0; i < 3; ++i) {
          double force = 0.0;
          for (std::size_t n = 0; n < 8; ++n)
            for (std::size_t m = 0; m < 8; ++m) {
              const double ei[3] = {e[i].x, e[i].y, e[i].z}, ej[3] = {e[j].x, e[j].y, e[j].z};
              for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t d = 0; d < 3; ++d)
                  force += ei[c] * pattern(n, k) * K[3 * n + c][3 * m + d] * ej[d] * pattern(m, p);
            }
          EXPECT_NEAR(force, expected(i, k, j, p), 1e-9 * mu * sides[0]) << i << k << j << p;
        }
}

// A rectangular brick with hourglass forces keeps them in axes that turn with it, however it is stretched: the frame of
// the form of 1993. Sabotage: without the shortening by the growth of the sides.
TEST(Hexahedron, StretchKeepsHourglassForces) {
  Driven<Elastic> d(brick(6, 1.0), steel, box(5, 4, 3));
  Random random;
  const double dt = 1e-6;
  for (int i = 0; i < 12; ++i) d.state[L::hourglass + i] = random();
  d.step(0.0);
  const auto hourglass = [&] {
    std::vector<double> q;
    const double sign[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                               {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
    for (int k = 0; k < 4; ++k) {
      Vec3d sum{};
      for (int n = 0; n < 8; ++n) {
        const double *s = sign[n], all = s[0] * s[1] * s[2];
        sum += (k == 3 ? all : all * s[k]) * d.force.f[n];
      }
      q.insert(q.end(), {sum.x, sum.y, sum.z});
    }
    return q;
  };
  const std::vector<double> before = hourglass();
  const double most = *std::max_element(before.begin(), before.end());
  const Vec3d rate{200.0, -100.0, 50.0};
  for (int cycle = 0; cycle < 1000; ++cycle) {
    for (int i = 0; i < 8; ++i) {
      const Vec3d& x = d.nodes.x[i];
      d.nodes.v[i] = {rate.x * x.x, rate.y * x.y, rate.z * x.z};
    }
    d.step(dt);
  }
  const std::vector<double> after = hourglass();
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(after[i], before[i], 1e-8 * most) << i;  // a quarter of the third power of a step's growth
}

// Sabotage: the forces of the edges doubled.
TEST(Hexahedron, PhysicalHourglassControlMakesNoModeFaster) {
  Random random;
  const auto fastest = [](const HexahedronProperties& b, const Corners& x) {
    const Dense K = stiffness(b, x);
    std::vector<double> u(24);
    for (std::size_t i = 0; i < 24; ++i) u[i] = std::sin(1.0 + 3.7 * static_cast<double>(i));
    double size = 0.0;
    for (int turn = 0; turn < 3000; ++turn) {
      std::vector<double> next(24);
      size = 0.0;
      for (std::size_t i = 0; i < 24; ++i) {
        for (std::size_t j = 0; j < 24; ++j) next[i] += K[i][j] * u[j];
        size += next[i] * next[i];
      }
      size = std::sqrt(size);
      for (std::size_t i = 0; i < 24; ++i) u[i] = next[i] / size;
    }
    return size;
  };
  for (int trial = 0; trial < 20; ++trial) {
    Corners x = parallelepiped(Vec3d{2, 0, 0} + random.vector(0.8), Vec3d{0, 1.5, 0} + random.vector(0.6),
                               Vec3d{0, 0, 0.8} + random.vector(0.3));
    for (Vec3d& p : x) p += random.vector(0.15);
    EXPECT_LT(fastest(brick(6, 1.0), x), 1.01 * fastest(brick(6, 1e-6), x)) << trial;
  }
}

TEST(Hexahedron, PhysicalHourglassControlBendsABeam) {
  const double G = steel_E / 2.6;
  for (const int n : {1, 2, 5}) {
    EXPECT_NEAR(std::abs(tip(n, 1.0, true)), 2.857143, 0.002 * 2.857) << n;
    const double exact = 1000.0 * 1e6 / (3 * steel_E * 1e4 / 12) * (1 - 1.0 / (4.0 * n * n)) + 1000.0 * 100 / (G * 100);
    EXPECT_NEAR(tip(n, 1.0, false), exact, 0.01 * exact) << n;
  }
  EXPECT_NEAR(std::abs(tip(1, 0.1, true)), 28.57, 1.5);
}

}  // namespace
}  // namespace nugget::kernel
