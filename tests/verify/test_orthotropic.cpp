// SPDX-License-Identifier: Apache-2.0
// *MAT_ORTHOTROPIC_ELASTIC: stresses of homogeneous strains against the rotated compliance, axes that turn with the
// element, and modes of a plate.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "linear.hpp"
#include "specimen.hpp"

namespace nugget::verify {
namespace {

// A lamina, MPa.
constexpr double Ea = 130e3, Eb = 9e3, Ec = 8e3, ba = 0.02, ca = 0.018, cb = 0.35, Gab = 4.8e3, Gbc = 3.1e3,
                 Gca = 4.2e3;
constexpr double density = 1.6e-9;
using Matrix3 = Eigen::Matrix3d;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Compliance in a, b, c: xx yy zz xy yz zx, engineering shears.
Matrix6 compliance() {
  Matrix6 s = Matrix6::Zero();
  s.topLeftCorner<3, 3>() << 1 / Ea, -ba / Eb, -ca / Ec, -ba / Eb, 1 / Eb, -cb / Ec, -ca / Ec, -cb / Ec, 1 / Ec;
  s(3, 3) = 1 / Gab, s(4, 4) = 1 / Gbc, s(5, 5) = 1 / Gca;
  return s;
}

/// Stress of a strain tensor; rows of `axes` are a, b, c. `plane`: none along c.
Matrix3 stress(const Matrix3& strain, const Matrix3& axes, bool plane) {
  const Matrix3 e = axes * strain * axes.transpose();
  Eigen::Matrix<double, 6, 1> v;
  v << e(0, 0), e(1, 1), e(2, 2), 2 * e(0, 1), 2 * e(1, 2), 2 * e(2, 0);
  Matrix6 s = compliance();
  if (plane) s(2, 2) = 1e30, s(0, 2) = s(2, 0) = s(1, 2) = s(2, 1) = 0.0;
  const Eigen::Matrix<double, 6, 1> t = s.inverse() * v;
  Matrix3 local;
  local << t(0), t(3), t(5), t(3), t(1), t(4), t(5), t(4), t(2);
  return axes.transpose() * local * axes;
}

/// Axes with the third along `normal` and the first along `a`, seen along the normal.
Matrix3 axes_of(const Eigen::Vector3d& a, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d e3 = normal.normalized(), e1 = (a - a.dot(e3) * e3).normalized();
  Matrix3 m;
  m << e1.transpose(), e3.cross(e1).transpose(), e3.transpose();
  return m;
}

/// The cards of the material; `second` and `third` are those of the axes.
std::string material(double aopt, std::initializer_list<double> second, std::initializer_list<double> third) {
  return "*MAT_ORTHOTROPIC_ELASTIC\n" + fields({1, density, Ea, Eb, Ec, ba, ca, cb}) + fields({Gab, Gbc, Gca, aopt}) +
         fields(second) + fields(third);
}

using Deformation = std::function<Matrix3(double s)>;  ///< gradient over s = 0..1

/// Stress of an element whose nodes are all driven by a homogeneous deformation in `points` straight pieces.
Matrix3 driven(Specimen& s, const std::vector<std::pair<int, Vec3d>>& nodes, const Deformation& f, int points,
               bool is_shell, double duration, bool holds_spins = false) {
  int curve = 10;
  for (const auto& [id, x] : nodes) {
    for (int c = 0; c < 3; ++c) {
      std::string text = "*DEFINE_CURVE\n" + fields({1.0 * ++curve});
      for (int k = 0; k <= points; ++k) {
        const Eigen::Vector3d place(x.x, x.y, x.z), u = f(1.0 * k / points) * place - place;
        text += fmt::format("{:20.12e}{:20.12e}\n", duration * k / points, u(c));
      }
      s.text(text);
      s.card("BOUNDARY_PRESCRIBED_MOTION_NODE", {1.0 * id, c + 1.0, 2, 1.0 * curve});
    }
    if ((is_shell || holds_spins) && points == 1) s.card("BOUNDARY_SPC_NODE", {1.0 * id, 0, 0, 0, 0, 1, 1, 1});
  }
  s.card("CONTROL_TERMINATION", {duration});
  Experiment run(s.deck());
  std::array<double, 6> t{};
  run_to_end(run, [&](const impact::Snapshot& now) {
    t = (is_shell ? shell_layer(run, now, 1, 0) : brick_layer(run, now, 1)).stress;
  });
  Matrix3 m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  return m;
}

Matrix3 rotation(double angle, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// Small strains of all kinds; in the plane z = 0 and across it for shells, whose nodes do not turn.
Matrix3 gradient(bool is_shell) {
  Matrix3 g;
  if (is_shell)
    g << 3e-6, 2e-6, 0, 1e-6, -2e-6, 0, 4e-6, -3e-6, 0;
  else
    g << 3e-6, 2e-6, 1e-6, -1e-6, -2e-6, 2e-6, 4e-6, -3e-6, 1e-6;
  return g;
}

void expect_stress(const std::string& what, const Matrix3& value, const Matrix3& reference) {
  expect_reference("MAT_002", what + ": stress", (value - reference).norm() / reference.norm(), 0.0, 1e-4, 1.0);
}

TEST(Orthotropic, StressOfBricks) {
  const Eigen::Vector3d a(1, 2, -1), d(0, 1, 1);
  const std::string by_vectors = material(2, {0, 0, 0, a(0), a(1), a(2)}, {0, 0, 0, d(0), d(1), d(2)}),
                    by_system = "*DEFINE_COORDINATE_VECTOR\n" + fields({7, a(0), a(1), a(2), d(0), d(1), d(2)}) +
                                material(-7, {0}, {0});
  struct Case {
    double elform;
    std::string name, material;
  };
  for (const auto& [elform, name, cards] :
       {Case{1, "AOPT 2", by_vectors}, Case{2, "AOPT 2", by_vectors}, Case{10, "AOPT 2", by_vectors},
        Case{4, "AOPT 2", by_vectors}, Case{1, "AOPT -7", by_system}, Case{10, "AOPT -7", by_system}}) {
    Specimen s;
    s.text(cards);
    s.card("SECTION_SOLID", {1, elform}).part(1, 1, 1);
    std::vector<std::pair<int, Vec3d>> nodes;
    if (elform == 10.0 || elform == 4.0) {
      for (const Vec3d& x : {Vec3d{0, 0, 0}, Vec3d{2, 0, 0}, Vec3d{0, 2, 0}, Vec3d{0, 0, 2}})
        nodes.push_back({s.node(x), x});
      s.brick(1, {1, 2, 3, 4, 4, 4, 4, 4});
    } else {
      const Grid grid = s.bricks(1, {}, {2, 2, 2}, {1, 1, 1});
      for (int k = 0; k < 8; ++k)
        nodes.push_back({grid(k & 1, k >> 1 & 1, k >> 2), {2.0 * (k & 1), 2.0 * (k >> 1 & 1), 2.0 * (k >> 2)}});
    }
    const Matrix3 g = gradient(false), strain = 0.5 * (g + g.transpose());
    const Matrix3 axes = axes_of(a, a.cross(d));
    expect_stress(
        fmt::format("solid {:.0f}, {}", elform, name),
        driven(
            s, nodes, [&](double t) { return Matrix3(Matrix3::Identity() + t * g); }, 1, false, 2e-4, elform == 4.0),
        stress(strain, axes, false));
  }
}

TEST(Orthotropic, StressOfShells) {
  struct Case {
    std::string name, material;
    Eigen::Vector3d a;  // where it should lie
    double own = 0.0;   // BETA of the element
  };
  const auto degrees = [](double x) {
    return Eigen::Vector3d(std::cos(x * std::numbers::pi / 180), std::sin(x * std::numbers::pi / 180), 0);
  };
  // The side from node 1 to node 2 lies at 20 degrees.
  const std::vector<Case> cases{
      {"AOPT 0, BETA", material(0, {0}, {0, 0, 0, 0, 0, 0, 35}), degrees(55)},
      {"AOPT 0, BETA of the shell", material(0, {0}, {0, 0, 0, 0, 0, 0, 35}), degrees(70), 50},
      {"AOPT 2", material(2, {0, 0, 0, 1, 2, 3}, {0}), {1, 2, 0}},
      {"AOPT -7", "*DEFINE_COORDINATE_VECTOR\n" + fields({7, 1, 2, 3, 0, 0, 1}) + material(-7, {0}, {0}), {1, 2, 0}},
      {"AOPT 3, BETA", material(3, {0}, {1, 0, 0, 0, 0, 0, 10}), degrees(-80)}};
  for (const Case& c : cases)
    for (const double elform : {2.0, 16.0, 4.0, 17.0}) {
      Specimen s;
      s.text(c.material + "*SECTION_SHELL\n" + fields({1, elform, 1, 2}) + fields({.5, .5, .5, .5})).part(1, 1, 1);
      std::vector<std::pair<int, Vec3d>> nodes;
      const Vec3d corner[] = {{0, 0, 0}, {4 * degrees(20)(0), 4 * degrees(20)(1), 0}, {3, 6, 0}, {-1, 4, 0}};
      const int count = elform == 4.0 || elform == 17.0 ? 3 : 4;
      for (int k = 0; k < count; ++k) nodes.push_back({s.node(corner[k]), corner[k]});
      const int last = nodes.back().first;
      s.text((c.own != 0.0 ? "*ELEMENT_SHELL_BETA\n" : "*ELEMENT_SHELL\n") + element_line(1, 1, {1, 2, 3, last}));
      if (c.own != 0.0) s.text(fmt::format("{:64}{:16}\n", "", c.own));
      Matrix3 g = gradient(true);
      if (elform == 17.0) g.row(2).setZero();  // it has no transverse shear
      const Matrix3 strain = 0.5 * (g + g.transpose());
      expect_stress(fmt::format("shell {:.0f}, {}", elform, c.name),
                    driven(
                        s, nodes, [&](double t) { return Matrix3(Matrix3::Identity() + t * g); }, 1, true, 2e-4),
                    stress(strain, axes_of(c.a, {0, 0, 1}), true));
    }
}

// A quarter of a turn, then a stretch: the axes must have come along. Sabotage: axes that stay.
TEST(Orthotropic, AxesTurnWithTheElement) {
  const Eigen::Vector3d a(1, 0.5, 0), d(-0.5, 1, 0);
  for (const bool is_shell : {false, true}) {
    Specimen s;
    s.text(material(2, {0, 0, 0, a(0), a(1), a(2)}, {0, 0, 0, d(0), d(1), d(2)})).card("CONTROL_ACCURACY", {1});
    std::vector<std::pair<int, Vec3d>> nodes;
    Grid grid;
    if (is_shell) {
      s.text("*SECTION_SHELL\n" + fields({1, 2, 1, 2}) + fields({.5, .5, .5, .5})).part(1, 1, 1);
      grid = s.shells(1, {}, {2, 2, 0}, 1, 1);
    } else {
      s.card("SECTION_SOLID", {1, 1}).part(1, 1, 1);
      grid = s.bricks(1, {}, {2, 2, 2}, {1, 1, 1});
    }
    for (int k = 0; k < (is_shell ? 4 : 8); ++k)
      nodes.push_back({grid(k & 1, k >> 1 & 1, k >> 2), {2.0 * (k & 1), 2.0 * (k >> 1 & 1), 2.0 * (k >> 2)}});
    const Eigen::Vector3d z(0, 0, 1);
    Matrix3 stretch = Matrix3::Zero();
    stretch(0, 0) = 2e-3;
    const auto motion = [&](double t) {
      return Matrix3((Matrix3::Identity() + std::max(0.0, 2 * t - 1) * stretch) *
                     rotation(std::min(1.0, 2 * t) * std::numbers::pi / 2, z));
    };
    const Matrix3 turned = axes_of(rotation(std::numbers::pi / 2, z) * a, z);
    const Matrix3 value = driven(s, nodes, motion, 200, is_shell, 4e-3), reference = stress(stretch, turned, is_shell);
    // Straight pieces of a circle, steps of the rate form, and strains of second order.
    expect_reference("MAT_002",
                     is_shell ? "shell, after a quarter of a turn: stress" : "solid, after a quarter of a turn: stress",
                     (value - reference).norm() / reference.norm(), 0.0, 1e-2, 1.0);
  }
}

// w_mn = pi^2 / sqrt(rho t) sqrt(D1 (m/l)^4 + 2 D3 (m n/(l b))^2 + D2 (n/b)^4), D3 = D1 nu_ba' + 2 Gab t^3/12 (Leissa,
// Vibration of Plates, 9.1). Sabotage: a and b exchanged.
TEST(Orthotropic, ModesOfASimplySupportedPlate) {
  constexpr double l = 300.0, b = 200.0, t = 2.0;
  constexpr int nx = 36, ny = 24;
  Specimen s;
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1}).card("CONTROL_IMPLICIT_EIGENVALUE", {6});
  s.text(material(2, {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}));
  s.text("*SECTION_SHELL\n" + fields({1, 16, 5.0 / 6.0, 2}) + fields({t, t, t, t})).part(1, 1, 1);
  const Grid grid = s.shells(1, {}, {l, b, 0.0}, nx, ny);
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const bool ends = i == 0 || i == nx, sides = j == 0 || j == ny;
      s.card("BOUNDARY_SPC_NODE",
             {1.0 * grid(i, j), 0, 1, 1, ends || sides ? 1.0 : 0.0, ends ? 1.0 : 0.0, sides ? 1.0 : 0.0, 0});
    }
  const nvh::Modes modes = LinearExperiment(s.deck()).modes(6);
  const double share = 1.0 - ba * ba * Ea / Eb, d = t * t * t / 12.0;
  const double D1 = Ea * d / share, D2 = Eb * d / share, D3 = ba * D1 + 2.0 * Gab * d;
  std::vector<double> closed;
  for (int m = 1; m <= 6; ++m)
    for (int n = 1; n <= 6; ++n) {
      const double x = m * m / (l * l), y = n * n / (b * b);
      closed.push_back(0.5 * std::numbers::pi / std::sqrt(density * t) *
                       std::sqrt(D1 * x * x + 2.0 * D3 * x * y + D2 * y * y));
    }
  std::sort(closed.begin(), closed.end());
  for (std::size_t k = 0; k < 4; ++k)
    expect_reference("MAT_002", fmt::format("simply supported plate, 36 x 24 shells, mode {} [Hz]", k + 1),
                     modes.frequency(k), closed[k], 1e-2);
}

TEST(Orthotropic, WhatGivesEnergyIsRefused) {
  Specimen s;
  s.text("*MAT_ORTHOTROPIC_ELASTIC\n" + fields({1, density, Ea, Eb, Ec, 0.3, ca, cb}) + fields({Gab, Gbc, Gca}) +
         fields({0}) + fields({0}));
  s.text("*SECTION_SHELL\n" + fields({1, 2}) + fields({1, 1, 1, 1})).part(1, 1, 1);
  s.shells(1, {}, {1, 1, 0}, 1, 1);
  s.card("CONTROL_TERMINATION", {1.0});
  try {
    Experiment refused(s.deck());
    ADD_FAILURE() << "taken";
  } catch (const std::runtime_error& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("would give energy"));
  }
}

}  // namespace
}  // namespace nugget::verify
