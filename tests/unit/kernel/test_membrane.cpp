// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/membrane.hpp"

#include "membrane_kinds.hpp"

namespace nugget::kernel {
namespace {

template <class Kind>
class Membranes : public testing::Test {};
using Kinds = testing::Types<OnePointMembrane, FullMembrane, TriangleMembrane>;
TYPED_TEST_SUITE(Membranes, Kinds);

TYPED_TEST(Membranes, BatchGivesTheBitsOfEachAlone) {
  batch_gives_the_bits_of_each_alone<TypeParam>(section(1), steel, 3000.0);
  ShellProperties viscous = section(1);
  viscous.thickness_update = ThicknessUpdate::all;
  viscous.hourglass = 1;
  viscous.bulk_linear = 0.06;
  viscous.bulk_quadratic = 1.5;
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone<TypeParam>(viscous, failing, 6000.0);
}

// The viscosity across the plane is off: its force does not outlive the motion that it meets.
TYPED_TEST(Membranes, RigidRotationStrainsNothing) {
  ShellProperties shell = section(1);
  shell.warping_hourglass = 0.0;
  rigid_rotation_strains_nothing<TypeParam>(shell, 360);
}

// Sabotage: a force along the plane that has no partner across it in a warped element.
TYPED_TEST(Membranes, ForcesAreInBalanceAndNoMoments) {
  Random random;
  Driven<PiecewiseLinear, TypeParam> d(section(1), curved(), TypeParam::some(random));
  for (int cycle = 0; cycle < 20; ++cycle) {
    d.shake(random, 5000.0, 3000.0);
    d.step(1e-6);
    expect_balance(d, 1e-12, 1e-10);
    for (const Vec3d& m : d.force.m) EXPECT_EQ(norm(m), 0.0);
  }
}

// Work of the nodal forces is that of the stresses, t A sigma : d for one motion of constant strain rate. The element
// is flat: a warped one has no such motion.
TYPED_TEST(Membranes, ForcesDoTheWorkOfTheStresses) {
  Random random;
  NodalMotion<double, TypeParam::corners> m = TypeParam::some(random);
  for (Vec3d& x : m.x) x.z = 0.0;
  const Elastic law{1e6, 0.25};
  Driven<Elastic, TypeParam> d(section(1), law, m, 0.7);
  double area = 0.0;
  for (int i = 0; i < TypeParam::corners; ++i) area += 0.5 * cross(m.x[i], m.x[(i + 1) % TypeParam::corners]).z;
  for (int i = 0; i < TypeParam::corners; ++i) {
    const double x = m.x[i].x, y = m.x[i].y;
    d.nodes.v[i] = {1e-9 * (x + 0.5 * y), 1e-9 * (y + 0.5 * x), 3e-9 * x - 2e-9 * y};
  }
  d.step(1.0);
  // Strains 1e-9 in both directions, shear 1e-9: stress E/(1 - nu) 1e-9 and G 1e-9 (MacNeal and Harder's patch).
  const double normal = 1e6 / 0.75 * 1e-9, shear = 1e6 / 2.5 * 1e-9;
  EXPECT_NEAR(power(d.force, d.nodes), 0.7 * area * (2.0 * normal + shear) * 1e-9, 1e-7 * area * normal * 1e-9);
}

TYPED_TEST(Membranes, ThicknessFollowsTheStrain) {
  Random random;
  ShellProperties shell = section(1);
  shell.thickness_update = ThicknessUpdate::all;
  NodalMotion<double, TypeParam::corners> m = TypeParam::some(random);
  for (Vec3d& x : m.x) x.z = 0.0;
  Driven<Elastic, TypeParam> d(shell, Elastic{1e3, 0.5}, m, 2.0);
  for (int cycle = 0; cycle < 1000; ++cycle) {
    for (int i = 0; i < TypeParam::corners; ++i) d.nodes.v[i] = 1e-3 * d.nodes.x[i];
    d.step(1.0);
  }
  // Incompressible: the thickness is over the area, which has grown by 1.001^2 a step.
  EXPECT_NEAR(d.at(ShellLayout::thickness), 2.0 * std::pow(1.001, -2000.0), 1e-3);
}

// Of the 12 motions of four nodes a membrane without tension lets go: rigid motion and what is across its plane. The
// spins of the nodes are free besides, 12 of four nodes and 9 of three.
TEST(Membrane, FreeMotions) {
  ShellProperties shell = section(1), soft = shell;
  soft.membrane_hourglass = soft.warping_hourglass = 0.0;
  expect_free_motions(shell_stiffness<FullMembrane>(shell, square()), 24, 24 - 5);
  expect_free_motions(shell_stiffness<OnePointMembrane>(soft, square()), 24, 24 - 3);
  soft = shell;
  soft.warping_hourglass = 0.0;
  expect_free_motions(shell_stiffness<OnePointMembrane>(soft, square()), 24, 24 - 5);
  Random random;
  expect_free_motions(shell_stiffness<TriangleMembrane>(shell, triangle(random)), 18, 18 - 3);
}

TEST(Membrane, DoesNotDependOnTheFirstNode) {
  does_not_depend_on_the_first_node<OnePointMembrane>(section(1));
  does_not_depend_on_the_first_node<FullMembrane>(section(1));
}

// The four corners of a stretched square drawn up and down by turns, by w: the tension N has the energy N/2 times the
// integral of the slope's square, 4/3 N w^2, so that each corner is drawn back by 2/3 N w. The one point sees nothing;
// there a velocity v of the pattern meets the viscosity QW rho c t sqrt(A) / 4 over 4 v.
TEST(Membrane, ThePatternAcrossThePlane) {
  const double N = 100.0 * 1.2, w = 1e-5;
  Motion m = square();
  for (int i = 0; i < 4; ++i) m.x[i].z = i % 2 ? -w : w;
  Driven<Elastic, FullMembrane> full(section(1), steel, m);
  for (int p = 0; p < 4; ++p)
    for (int c = 0; c < 2; ++c) full.state[static_cast<std::size_t>(full.layout.layer(0, p) + c)] = 100.0;
  full.cycle(0.0);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(full.force.f[i].z, (i % 2 ? -1.0 : 1.0) * 2.0 / 3.0 * N * w, 1e-8 * N * w);

  Driven<Elastic, OnePointMembrane> one(section(1), steel, square());
  const double v = 2.0, c = std::sqrt(steel_E / (steel_density * (1.0 - steel_nu * steel_nu)));
  for (int i = 0; i < 4; ++i) one.nodes.v[i] = {0, 0, i % 2 ? -v : v};
  one.step(1e-12);
  const double force = 0.1 * 0.25 * steel_density * c * 1.2 * 5.0 * 4.0 * v;
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(one.force.f[i].z, (i % 2 ? -1.0 : 1.0) * force, 1e-6 * force);
}

}  // namespace
}  // namespace nugget::kernel
