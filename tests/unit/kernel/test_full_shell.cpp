// SPDX-License-Identifier: Apache-2.0
#include "driven_shell.hpp"

namespace nugget::kernel {
namespace {

ShellProperties drilled(int layers = 2) {
  ShellProperties shell = section(layers);
  shell.drilling = usual_drilling;
  shell.warping_stiffness = true;
  return shell;
}

TEST(FullShell, BatchGivesTheBitsOfEachAlone) {
  batch_gives_the_bits_of_each_alone<Full>(section(), steel, 3000.0);
  batch_gives_the_bits_of_each_alone<Full>(drilled(5), mixed(0.4), 6000.0);
  ShellProperties viscous = drilled(1);
  viscous.thickness_update = ThicknessUpdate::all;
  viscous.bulk_linear = 0.06;
  viscous.bulk_quadratic = 1.5;
  viscous.offset = 1.0;
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone<Full>(viscous, failing, 6000.0);
}

TEST(FullShell, RigidRotationStrainsNothing) {
  rigid_rotation_strains_nothing<Full>(drilled());
}

TEST(FullShell, ForcesAreInEquilibriumAndDoTheWorkOfTheStresses) {
  Random random;
  const double dt = 1e-12;
  for (const bool warping : {false, true}) {
    ShellProperties shell = drilled();
    shell.warping_stiffness = warping;
    shell.offset = 0.7;
    // A parallelogram, warped: all points have the same share of its area.
    Motion m = square();
    for (int i = 0; i < 4; ++i) m.x[i] += Vec3d{0.3 * m.x[i].y, 0.0, i % 2 ? -0.4 : 0.4};
    Driven<Elastic, Full> d(shell, steel, m);
    for (std::size_t i = ShellLayout::first_layer; i < d.state.size(); ++i) d.state[i] = 300.0 * random();
    for (std::size_t i = 0; i < 4; ++i) d.state[ShellLayout::hourglass + i] = 100.0 * random();
    const std::vector<double> start = d.state;
    d.shake(random, 1000.0, 1000.0);
    d.step(dt);
    const double E = steel_E, nu = steel_nu, G = E / (2 * (1 + nu)), volume = 1.2 * shell_area(positions(d.nodes));
    double expected = d.at(ShellLayout::hourglass_energy) / dt;
    for (int column = 0; column < 4; ++column)
      for (int k = 0; k < 2; ++k) {
        const int first = d.layout.layer(k, column);
        const auto change = [&](int c) { return d.at(first + c) - start[first + c]; };
        const auto mean = [&](int c) { return d.at(first + c) - 0.5 * change(c); };
        const double xx = (change(0) - nu * change(1)) / E, yy = (change(1) - nu * change(0)) / E;
        expected += 0.125 * volume / dt *
                    (mean(0) * xx + mean(1) * yy +
                     (mean(2) * change(2) + shell.shear_factor * (mean(3) * change(3) + mean(4) * change(4))) / G);
      }
    EXPECT_NEAR(power(d.force, d.nodes), expected, 2e-4 * std::abs(expected));
    expect_balance(d, 1e-9, 5e-9);
  }
}

TEST(FullShell, DoesNotDependOnTheFirstNode) {
  does_not_depend_on_the_first_node<Full>(drilled());
}

TEST(FullShell, ConstantStrainAndCurvatureOnADistortedElement) {
  Motion m;
  m.x[0] = {0.04, 0.02, 0};
  m.x[1] = {0.18, 0.03, 0};
  m.x[2] = {0.16, 0.08, 0};
  m.x[3] = {0.08, 0.08, 0};
  Driven<Elastic, Full> d(drilled(), Elastic{1e6, 0.25}, m, 0.001);
  // In its plane the linear field of MacNeal and Harder with its rotation 0; across, w = (x^2 + x y + y^2) / 2.
  for (int i = 0; i < 4; ++i) {
    const double x = m.x[i].x, y = m.x[i].y;
    d.nodes.v[i] = {1e-9 * (x + 0.5 * y), 1e-9 * (y + 0.5 * x), 0.5e-9 * (x * x + x * y + y * y)};
    d.nodes.w[i] = {1e-9 * (y + 0.5 * x), -1e-9 * (x + 0.5 * y), 0};
  }
  d.step(1.0);
  const Frame3d f = shell_frame(positions(d.nodes));
  // Equal in all directions but for the shear: components in the element's frame.
  const double turn = f.e1.x * f.e1.y, shear = 400.0e-6, c2 = f.e1.x * f.e1.x - f.e1.y * f.e1.y;
  for (int column = 0; column < 4; ++column)
    for (int k = 0; k < 2; ++k) {
      const double bent = (k == 0 ? 1.0 : -1.0) * 0.0005 / std::sqrt(3.0);  // of curvature -1e-9 a unit of strain
      const int at = d.layout.layer(k, column);
      EXPECT_NEAR(d.at(at), (1333.3333333e-6 + 2 * shear * turn) * (1.0 + bent), 1e-12);
      EXPECT_NEAR(d.at(at + 1), (1333.3333333e-6 - 2 * shear * turn) * (1.0 + bent), 1e-12);
      EXPECT_NEAR(d.at(at + 2), shear * c2 * (1.0 + bent), 1e-12);
    }
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(d.at(ShellLayout::hourglass + i), 0.0, 1e-16);
}

TEST(FullShell, OnlyRigidMotionIsFree) {
  Random random;
  for (const double warp : {0.0, 0.2, 1.0}) {
    Motion m = square();
    for (Vec3d& x : m.x) x += Vec3d{random(), random(), warp * random()};
    expect_free_motions(shell_stiffness<Full>(drilled(), m), 24, 6);
  }
  ShellProperties free = section();
  EXPECT_EQ(zero_modes(shell_stiffness<Full>(free, square()), 24), 10);  // and the drilling of four nodes
}

// 0.1 G t min(t^2, A) / 4 a node. Sabotage: t^2 alone.
TEST(FullShell, DrillingGoesByThicknessOrArea) {
  for (const double t : {1.2, 5.0, 20.0}) {
    Driven<Elastic, Full> d(drilled(), steel, square(), t);
    const double area = shell_area(positions(d.nodes));
    for (int i = 0; i < 4; ++i) d.nodes.w[i] = {0, 0, 1e-9};
    d.step(1.0);
    const double expected = 0.1 * steel_E / (2.0 * (1.0 + steel_nu)) * t * std::min(t * t, area) / 4.0 * 1e-9;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(d.at(ShellLayout::hourglass + i), expected, 1e-12 * expected) << t;
  }
}

TEST(FullShell, NoModeIsFasterThanTheStableStep) {
  // omega = 2 / dt of the lumped element bounds every mesh of it (Irons).
  Random random;
  for (int trial = 0; trial < 20; ++trial) {
    Motion m = square();
    for (Vec3d& x : m.x) x += Vec3d{0.8 * random(), 0.8 * random(), 0.3 * random()};
    if (trial % 2 == 0)
      for (Vec3d& x : m.x) x.y *= 0.4;
    std::vector<double> K = shell_stiffness<Full>(drilled(), m);
    const NodalMass mass = shell_nodal_mass(positions(m), 1.2, steel_density);
    for (std::size_t i = 0; i < 24; ++i)
      for (std::size_t j = 0; j < 24; ++j)
        K[i * 24 + j] /= std::sqrt((i % 6 < 3 ? mass.mass : mass.inertia) * (j % 6 < 3 ? mass.mass : mass.inertia));
    double fastest = 0.0;
    for (double v : eigenvalues(K, 24)) fastest = std::max(fastest, v);
    const double limit = 2.0 / std::sqrt(fastest);
    const double step = shell_stable_step(positions(m), ShellLength::area_over_side, steel_E, steel_nu, steel_density);
    EXPECT_LT(0.9 * step, limit) << "trial " << trial;
  }
}

TEST(FullShell, DiesWhenAllColumnsHaveFailed) {
  PiecewiseLinear law = bilinear(250, 0);
  law.failure_strain = 0.01;
  Driven<PiecewiseLinear, Full> d(section(2), law, square());
  bool partly = false;
  int cycle = 0;
  for (; cycle < 4000 && d.at(ShellLayout::alive) > 0.5; ++cycle) {
    // Stretched more at its upper edge: the upper columns fail first.
    for (int i = 0; i < 4; ++i) d.nodes.v[i] = {(60.0 + 10.0 * d.nodes.x[i].y) * (d.nodes.x[i].x - 2.5), 0, 0};
    d.step(1e-6);
    const bool upper = d.at(d.layout.history_of(0, 2)) >= 0.01, lower = d.at(d.layout.history_of(0, 1)) >= 0.01;
    partly = partly || (upper && !lower && d.at(ShellLayout::alive) > 0.5);
    if (upper && !lower) {
      EXPECT_EQ(d.at(d.layout.layer(0, 2)), 0.0);
    }
  }
  EXPECT_TRUE(partly);
  EXPECT_LT(cycle, 4000);
  EXPECT_EQ(largest_force(d.force), 0.0);
  EXPECT_TRUE(std::isinf(d.force.stable_step));
}

}  // namespace
}  // namespace nugget::kernel
