// SPDX-License-Identifier: Apache-2.0
#include "driven_shell.hpp"

namespace nugget::kernel {
namespace {

using Triangle = NodalMotion<double, 3>;

TEST(Triangle, BatchGivesTheBitsOfEachAlone) {
  batch_gives_the_bits_of_each_alone<C0>(section(), steel, 4000.0);
  batch_gives_the_bits_of_each_alone<C0>(section(2), mixed(0.4), 4000.0);
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone<C0>(section(), failing, 4000.0);
}

TEST(Triangle, RigidRotationStrainsNothing) {
  rigid_rotation_strains_nothing<C0>(section(), 36, 1e-9);
}

TEST(Triangle, ForcesDoTheWorkOfTheStresses) {
  Random random;
  const double dt = 1e-12;
  ShellProperties shell = section(2);
  shell.offset = -1.0;
  Driven<Elastic, C0> d(shell, steel, triangle(random));
  for (std::size_t i = ShellLayout::first_layer; i < d.state.size(); ++i) d.state[i] = 300.0 * random();
  const std::vector<double> start = d.state;
  d.shake(random, 1000.0, 1000.0);
  d.step(dt);
  const double E = steel_E, nu = steel_nu, G = E / (2 * (1 + nu));
  const double volume = 1.2 * triangle_area({d.nodes.x[0], d.nodes.x[1], d.nodes.x[2]});
  double expected = 0.0;
  for (int k = 0; k < 2; ++k) {
    const auto s = [&](int c) { return d.at(d.layout.layer(k) + c); };
    const auto change = [&](int c) { return s(c) - start[d.layout.layer(k) + c]; };
    expected += 0.5 * volume / dt *
                (s(0) * (change(0) - nu * change(1)) / E + s(1) * (change(1) - nu * change(0)) / E +
                 (s(2) * change(2) + shell.shear_factor * (s(3) * change(3) + s(4) * change(4))) / G);
  }
  EXPECT_NEAR(power(d.force, d.nodes), expected, 2e-4 * std::abs(expected));
  expect_balance(d, 1e-10, 1e-9);
}

TEST(Triangle, MembraneAndBendingPatch) {
  Random random;
  Triangle flat = triangle(random);
  for (Vec3d& x : flat.x) x.z = 0.0;
  Driven<Elastic, C0> d(section(2), Elastic{1e6, 0.25}, flat);
  for (int i = 0; i < 3; ++i) {
    const Vec3d& x = d.nodes.x[i];
    d.nodes.v[i] = {1e-9 * (x.x + 0.5 * x.y), 1e-9 * (x.y + 0.5 * x.x), 0};
    d.nodes.w[i] = {-1e-9 * x.y, 1e-9 * x.x, 0};         // kxx = kyy = 1e-9
    d.nodes.v[i].z = -0.5e-9 * (x.x * x.x + x.y * x.y);  // no shear on any edge
  }
  d.step(1.0);
  for (int k = 0; k < 2; ++k) {
    const double z = 0.6 * d.shell.layers.zeta[k];
    const double mean = 0.5 * (d.at(d.layout.layer(k)) + d.at(d.layout.layer(k) + 1));
    EXPECT_NEAR(mean, 1333.3333e-6 * (1 + z), 1e-9);
    EXPECT_NEAR(d.at(d.layout.layer(k) + 3), 0.0, 1e-10);
    EXPECT_NEAR(d.at(d.layout.layer(k) + 4), 0.0, 1e-10);
  }
}

TEST(Triangle, StepsThatMoveNothingGiveTheStiffness) {
  Random random;
  const Triangle m = triangle(random);
  ShellProperties complete = section();
  complete.drilling = usual_drilling;
  expect_free_motions(shell_stiffness<C0>(complete, m), 18, 6);
  // Without completion the drilling of three nodes is free, and a mode that bends and shears nothing at the point.
  expect_free_motions(shell_stiffness<C0>(section(), m), 18, 10);
}

TEST(Triangle, CompletionDoesNotDependOnTheFirstNode) {
  Random random;
  const Triangle m = triangle(random);
  Triangle shifted;
  for (int i = 0; i < 3; ++i) shifted.x[i] = m.x[(i + 1) % 3];
  ShellProperties complete = section();
  complete.drilling = usual_drilling;
  const std::vector<double> a = shell_stiffness<C0>(complete, m), b = shell_stiffness<C0>(complete, shifted);
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
