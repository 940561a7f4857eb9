// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "driven_shell.hpp"

namespace nugget::kernel {
namespace {

using Triangle = NodalMotion<double, 3>;
constexpr double thickness = 1.2;

TEST(KirchhoffTriangle, BatchGivesTheBitsOfEachAlone) {
  ShellProperties drilled = section(2);
  drilled.drilling = usual_drilling;
  batch_gives_the_bits_of_each_alone<Kirchhoff>(section(), steel, 4000.0);
  batch_gives_the_bits_of_each_alone<Kirchhoff>(drilled, mixed(0.4), 4000.0);
  PiecewiseLinear failing = curved();
  failing.failure_strain = 0.05;
  batch_gives_the_bits_of_each_alone<Kirchhoff>(section(), failing, 4000.0);
}

TEST(KirchhoffTriangle, RigidRotationStrainsNothing) {
  ShellProperties drilled = section();
  drilled.drilling = usual_drilling;
  rigid_rotation_strains_nothing<Kirchhoff>(drilled, 36, 1e-9);
}

// The nodes' forces do the work of the stresses at the three points, without any transverse shear.
TEST(KirchhoffTriangle, ForcesDoTheWorkOfTheStresses) {
  Random random;
  const double dt = 1e-12;
  ShellProperties shell = section(2);
  shell.offset = -1.0;
  Driven<Elastic, Kirchhoff> d(shell, steel, triangle(random));
  for (int column = 0; column < kirchhoff_columns; ++column)
    for (int k = 0; k < 2; ++k)
      for (int c = 0; c < 3; ++c) d.state[d.layout.layer(k, column) + c] = 300.0 * random();
  const std::vector<double> start = d.state;
  d.shake(random, 1000.0, 1000.0);
  d.step(dt);
  const double E = steel_E, nu = steel_nu, G = E / (2 * (1 + nu));
  const double area = triangle_area({d.nodes.x[0], d.nodes.x[1], d.nodes.x[2]});
  double expected = 0.0;
  for (int column = 0; column < kirchhoff_columns; ++column)
    for (int k = 0; k < 2; ++k) {
      const int layer = d.layout.layer(k, column);
      const auto s = [&](int c) { return d.at(layer + c); };
      const auto change = [&](int c) { return s(c) - start[layer + c]; };
      EXPECT_EQ(s(3), 0.0);
      EXPECT_EQ(s(4), 0.0);
      expected +=
          0.5 * thickness * area / 3.0 / dt *
          (s(0) * (change(0) - nu * change(1)) / E + s(1) * (change(1) - nu * change(0)) / E + s(2) * change(2) / G);
    }
  EXPECT_NEAR(power(d.force, d.nodes), expected, 2e-4 * std::abs(expected));
  expect_balance(d, 1e-10, 1e-9);
}

/// Stiffness of w and the rotations about x and y of the three nodes of a triangle in the plane of x and y.
std::array<std::array<double, 9>, 9> bending_stiffness(const Triangle& m) {
  const std::vector<double> K = shell_stiffness<Kirchhoff>(section(2), m);
  const std::size_t freedom[3] = {2, 3, 4};
  std::array<std::array<double, 9>, 9> k{};
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 9; ++j) k[i][j] = K[18 * (6 * (i / 3) + freedom[i % 3]) + 6 * (j / 3) + freedom[j % 3]];
  return k;
}

/// The bending stiffness as Batoz, Bathe and Ho print it: slopes beta_x = Hx . U, beta_y = Hy . U with
/// U = (w, w,y, -w,x) of the nodes, by the shape functions of six nodes and the middles of the sides as points.
std::array<std::array<double, 9>, 9> published_stiffness(const Triangle& m) {
  using Row = std::array<double, 9>;
  const auto x = [&](int i) { return m.x[i].x; };
  const auto y = [&](int i) { return m.x[i].y; };
  const double twice = (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
  const int ends[3][2] = {{1, 2}, {2, 0}, {0, 1}};  // sides 4, 5, 6
  double a[3], b[3], c[3], d[3], e[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const double xij = x(ends[k][0]) - x(ends[k][1]), yij = y(ends[k][0]) - y(ends[k][1]), l2 = xij * xij + yij * yij;
    a[k] = -xij / l2;
    b[k] = 0.75 * xij * yij / l2;
    c[k] = (0.25 * xij * xij - 0.5 * yij * yij) / l2;
    d[k] = -yij / l2;
    e[k] = (0.25 * yij * yij - 0.5 * xij * xij) / l2;
  }
  // Derivatives of N1 .. N6 by xi and eta at a point; L1 = 1 - xi - eta, L2 = xi, L3 = eta.
  const auto slopes = [&](double xi, double eta, bool by_xi, Row& hx, Row& hy) {
    const double l1 = 1.0 - xi - eta, z1 = -1.0, z2 = by_xi ? 1.0 : 0.0, z3 = by_xi ? 0.0 : 1.0;
    const double corner[3] = {(4.0 * l1 - 1.0) * z1, (4.0 * xi - 1.0) * z2, (4.0 * eta - 1.0) * z3};
    const double side[3] = {4.0 * (xi * z3 + eta * z2), 4.0 * (eta * z1 + l1 * z3), 4.0 * (l1 * z2 + xi * z1)};
    const std::size_t before[3] = {1, 2, 0}, after[3] = {2, 0, 1};  // sides 5 and 6 at node 1, and round
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = before[i], q = after[i];
      hx[3 * i] = 1.5 * (a[q] * side[q] - a[p] * side[p]);
      hx[3 * i + 1] = b[p] * side[p] + b[q] * side[q];
      hx[3 * i + 2] = corner[i] - c[p] * side[p] - c[q] * side[q];
      hy[3 * i] = 1.5 * (d[q] * side[q] - d[p] * side[p]);
      hy[3 * i + 1] = -corner[i] + e[p] * side[p] + e[q] * side[q];
      hy[3 * i + 2] = -hx[3 * i + 1];
    }
  };
  const double D = steel_E * thickness * thickness * thickness / (12.0 * (1.0 - steel_nu * steel_nu));
  std::array<std::array<double, 9>, 9> k{};
  for (const auto& point : {std::pair{0.5, 0.0}, std::pair{0.5, 0.5}, std::pair{0.0, 0.5}}) {
    Row hx_xi, hy_xi, hx_eta, hy_eta;
    slopes(point.first, point.second, true, hx_xi, hy_xi);
    slopes(point.first, point.second, false, hx_eta, hy_eta);
    Row xx, yy, xy;
    for (std::size_t i = 0; i < 9; ++i) {
      const double y31 = y(2) - y(0), y12 = y(0) - y(1), x31 = x(2) - x(0), x12 = x(0) - x(1);
      xx[i] = (y31 * hx_xi[i] + y12 * hx_eta[i]) / twice;
      yy[i] = (-x31 * hy_xi[i] - x12 * hy_eta[i]) / twice;
      xy[i] = (-x31 * hx_xi[i] - x12 * hx_eta[i] + y31 * hy_xi[i] + y12 * hy_eta[i]) / twice;
    }
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t j = 0; j < 9; ++j)
        k[i][j] += twice / 6.0 * D *
                   (xx[i] * (xx[j] + steel_nu * yy[j]) + yy[i] * (yy[j] + steel_nu * xx[j]) +
                    0.5 * (1.0 - steel_nu) * xy[i] * xy[j]);
  }
  return k;
}

// Sabotage: -6 of a bubble as -4; the points at the corners' thirds; one side left out.
TEST(KirchhoffTriangle, BendsAsPublished) {
  Random random;
  Triangle flat = triangle(random);
  for (Vec3d& x : flat.x) x.z = 0.0;
  const auto k = bending_stiffness(flat);
  const auto expected = published_stiffness(flat);
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t j = 0; j < 9; ++j)
      EXPECT_NEAR(k[i][j], expected[i][j], 1e-10 * std::abs(expected[2][2])) << i << ' ' << j;
}

// The mean bending that the strains of the output need: what the layers of the three points got, less what those of
// the C0 triangle, which has the spins' gradient alone, get.
TEST(KirchhoffTriangle, MeanBendingIsThatOfThePoints) {
  Random random;
  const double dt = 1e-12;
  Driven<Elastic, Kirchhoff> d(section(2), steel, triangle(random));
  d.shake(random, 1000.0, 1000.0);
  const Triangle before = d.nodes;
  d.step(dt);
  const ShellLayout one = shell_layout(d.shell, d.law);
  std::vector<double> state(static_cast<std::size_t>(one.size()));
  start_shell(one, thickness, state.data(), 1, 0);
  one_element(d.nodes, state,
              [&](const auto& all, double* store) { return triangle_cycle(d.shell, d.law, all, dt, store); });
  const auto moment = [&](int c) {  // stress of the upper layer less that of the lower one, of the bubbles alone
    double sum = 0.0;
    for (int p = 0; p < kirchhoff_columns; ++p)
      sum += (d.at(d.layout.layer(1, p) + c) - d.at(d.layout.layer(0, p) + c)) / 3.0;
    return sum - (state[one.layer(1) + c] - state[one.layer(0) + c]);
  };
  const double between = thickness / std::sqrt(3.0) * dt, E = steel_E, nu = steel_nu;
  const auto array = [](const Vec3d(&a)[3]) { return std::array<Vec3d, 3>{a[0], a[1], a[2]}; };
  const auto more = kirchhoff_mean_bending(array(before.x), array(before.v), array(before.w));
  const double largest = std::abs(more[0]) + std::abs(more[1]) + std::abs(more[2]);
  EXPECT_NEAR((moment(0) - nu * moment(1)) / E / between, more[0], 1e-6 * largest);
  EXPECT_NEAR((moment(1) - nu * moment(0)) / E / between, more[1], 1e-6 * largest);
  EXPECT_NEAR(moment(2) * 2 * (1 + nu) / E / between, more[2], 1e-6 * largest);
}

TEST(KirchhoffTriangle, OnlyRigidMotionsAreFree) {
  Random random;
  const Triangle m = triangle(random);
  ShellProperties drilled = section();
  drilled.drilling = usual_drilling;
  expect_free_motions(shell_stiffness<Kirchhoff>(drilled, m), 18, 6);
  expect_free_motions(shell_stiffness<Kirchhoff>(section(), m), 18, 9);
}

// No element, however thick or flat, vibrates faster than its step allows: the lowest limit 2 / omega of elements
// of all shapes, by their own masses.
TEST(KirchhoffTriangle, BendingIsNeverFasterThanTheStep) {
  Random random;
  double least = 1e9;
  for (int trial = 0; trial < 300; ++trial) {
    Triangle m = triangle(random);
    for (Vec3d& x : m.x) x.z = 0.0;
    m.x[2].y *= 0.55 + 0.5 * random();
    const double scale = std::exp2(2.0 * random());  // thickness 1.2 against sides of about 1 to 20
    for (Vec3d& x : m.x) x = scale * x;
    const std::array<Vec3d, 3> place{m.x[0], m.x[1], m.x[2]};
    const NodalMass mass = kirchhoff_nodal_mass(place, thickness, steel_density);
    const auto k = bending_stiffness(m);
    std::vector<double> bending(81);
    for (std::size_t i = 0; i < 9; ++i)
      for (std::size_t j = 0; j < 9; ++j)
        bending[9 * i + j] =
            k[i][j] / std::sqrt((i % 3 == 0 ? mass.mass : mass.inertia) * (j % 3 == 0 ? mass.mass : mass.inertia));
    double fastest = 0.0;
    for (const double v : eigenvalues(bending, 9)) fastest = std::max(fastest, v);
    Driven<Elastic, Kirchhoff> still(section(2), steel, m);
    const double step = still.step(1e-9).stable_step;
    EXPECT_LE(step,
              triangle_stable_step(place, ShellLength::area_over_side, steel_E, steel_nu, steel_density) * (1 + 1e-12));
    least = std::min(least, 2.0 / std::sqrt(fastest) / step);
  }
  EXPECT_GE(least, 1.0);
  EXPECT_LT(least, 1.2);
}

}  // namespace
}  // namespace nugget::kernel
